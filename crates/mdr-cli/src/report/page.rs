//! The page of a task: all of its diagrams with their tables, what failed, what was left out, and how it was made.

use mdr_crosscheck::contest::{Diagram, Outcome, View};

use super::store::Section;
use super::{speed, summary, table};

/// What all pages say about their diagrams.
const LEGEND: &str = "\
Both axes are logarithmic. A time is the median of repeated runs, with a bar from the fastest to the slowest. Contestants of
other projects are dashed. The thin line is what the question leaves to any method in double precision: u·max(1, condition),
u = 2⁻⁵³. What fails, or is stopped because it takes too long, is drawn as a cross at the upper edge.
";

/// The text of the page.
pub(super) fn page(section: &Section) -> String {
    let mut page = format!("# {}\n\n{}. [All tasks](README.md)\n", section.name, capitalised(&section.claim));
    page.push_str(&diagrams(section));
    page.push_str(&speed::section(&section.races));
    page.push_str(&failures(section));
    page.push_str(&omissions(section));
    page.push_str(&made(section));
    page
}

fn diagrams(section: &Section) -> String {
    if section.diagrams.is_empty() {
        return String::new();
    }
    let mut text = String::new();
    let mut truths: Vec<&str> = section.diagrams.iter().map(|diagram| diagram.truth.as_str()).collect();
    truths.dedup();
    // What all diagrams share is told once.
    if let [truth] = truths[..] {
        text.push_str(&format!("\nTruth: {truth}.\n"));
    }
    if section.diagrams.len() > 2 {
        text.push_str(&pictures(section));
    }
    let fastest = table::fastest(&section.diagrams);
    if !fastest.is_empty() {
        text.push_str(&format!("\n## Time to so many digits\n\n{}\n{fastest}", capitalised(FASTEST)));
    }
    text.push_str(&format!("\n## Diagrams\n\n{LEGEND}"));
    for diagram in &section.diagrams {
        let Diagram { id, title, truth, .. } = diagram;
        let truth = if truths.len() > 1 { format!("Truth: {truth}. ") } else { String::new() };
        text.push_str(&format!("\n### {title}\n\n![{title}]({id}.svg)\n\n{truth}[Data]({id}.csv)\n"));
        if diagram.view == View::Size {
            text.push_str(&format!("\n{}", table::sizes(diagram)));
        }
        let times = table::times(diagram);
        if !times.is_empty() {
            let what = format!("All contestants; in brackets, times that of {}", diagram.shipped);
            text.push_str(&details(&what, &times));
        }
    }
    text
}

/// What the tables of the fastest mean.
pub(super) const FASTEST: &str = "\
the cheapest answer measured that has so many digits; nothing is interpolated, and — where nobody arrives. Bold: this
workspace and the crates that it uses; below: other projects.
";

/// The pictures that stand for the task.
pub(super) fn pictures(section: &Section) -> String {
    let picture = |(id, title): (String, String)| format!("\n![{}: {title}]({id}.svg)\n", section.name);
    summary::files(section).into_iter().map(picture).collect()
}

/// What is unfolded by those who want it.
pub(super) fn details(summary: &str, text: &str) -> String {
    format!("\n<details><summary>{summary}</summary>\n\n{text}\n</details>\n")
}

fn failures(section: &Section) -> String {
    let mut rows = String::new();
    for diagram in &section.diagrams {
        for curve in &diagram.curves {
            let reasons = curve.points.iter().filter_map(|point| match &point.outcome {
                Outcome::Failed(reason) | Outcome::Stopped(reason) => Some((point.setting.as_str(), reason.as_str())),
                _ => None,
            });
            // One row for all settings that fail alike.
            let mut alike: Vec<(&str, Vec<&str>)> = Vec::new();
            for (setting, reason) in reasons {
                match alike.iter_mut().find(|(known, _)| *known == reason) {
                    Some((_, settings)) => settings.push(setting),
                    None => alike.push((reason, vec![setting])),
                }
            }
            for (reason, settings) in alike {
                let (id, name) = (&diagram.id, table::name(curve));
                rows.push_str(&format!("| {id} | {name} | {} | {} |\n", settings.join(", "), in_cell(reason)));
            }
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let count = rows.lines().count();
    let table = format!("| question | contestant | setting | what happened |\n|---|---|---|---|\n{rows}");
    format!("\n## What failed or was stopped\n{}", details(&format!("{count} of the contestants"), &table))
}

fn omissions(section: &Section) -> String {
    let mut sentences: Vec<&str> = Vec::new();
    for sentence in section.diagrams.iter().flat_map(|diagram| &diagram.omissions).chain(&section.absent) {
        if !sentences.contains(&sentence.as_str()) {
            sentences.push(sentence);
        }
    }
    let list: String = sentences.iter().map(|sentence| format!("* {sentence}\n")).collect();
    format!("\n## What was left out\n\n{OMITTED}{list}")
}

const OMITTED: &str = "\
* Memory, and the time to the first answer where nothing else is said: what is computed once and kept is warm.
* Other processors and compilers.
";

/// The last lines of a page.
pub(super) fn made(section: &Section) -> String {
    let made = &section.made;
    let timed = if section.ladders.is_some() {
        String::new()
    } else {
        format!(
            " Each answer was timed {} times, fewer where it is slow; an answer shorter than 2 ms is repeated within a run.",
            made.runs
        )
    };
    format!("\n## How this was made\n\n    {}\n\n{}{timed}\n", made.command, made.machine.told())
}

/// With a capital letter at the beginning.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// A text within a cell of a table.
pub(super) fn in_cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::super::store::tests::section;
    use super::*;

    #[test]
    fn the_page_tells_everything() {
        let page = page(&section("test"));
        for part in [
            "# test\n\nWhat is tested.",
            "![x at y < 1](test-contest.svg)",
            "[Data](test-contest.csv)",
            "| contestant | arithmetic | 6 | 12 | 15 |",
            "| test-contest | broken | 7 nodes | no convergence |",
            "* nobody else came\n",
            "    mdr report --quick\n",
        ] {
            assert!(page.contains(part), "{part} in\n{page}");
        }
        assert_eq!(page.matches("nobody else came").count(), 1);
        // GitHub renders a table within an element only after an empty line.
        assert_eq!(page.matches("<details>").count(), page.matches("</summary>\n\n|").count());
        assert_eq!(page.matches("<details>").count(), page.matches("|\n\n</details>\n").count());
    }
}
