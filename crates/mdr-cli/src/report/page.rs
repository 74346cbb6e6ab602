//! The page: all diagrams with their tables, what failed, what was left out, and how it was made.

use mdr_crosscheck::contest::{Diagram, Outcome, View};

use super::{Findings, Section, ladders, speed, table};

const HEAD: &str = "\
# Error against run time

Several methods answer the same question with growing effort. Every answer is compared with an enclosure of the truth in
which no contestant had a part; a time is the median of repeated runs, with a bar from the fastest to the slowest. The two
axes are logarithmic. What fails is drawn at the upper edge, and the thin line is what the question leaves to any method in
double precision: u·max(1, condition), u = 2⁻⁵³. Contestants of other projects are dashed. Times belong to the machine named
at the end; compare them within this page.
";

/// The text of the page.
pub(super) fn page(findings: &Findings) -> String {
    let mut page = HEAD.to_owned();
    for section in &findings.tasks {
        page.push_str(&task(section));
    }
    page.push_str(&speed::section(&findings.races));
    page.push_str(&ladders::section(&findings.ladders, findings.effort));
    page.push_str(&failures(findings));
    page.push_str(&omissions(findings));
    page.push_str(&format!(
        "\n## How this was made\n\n    {}\n\n{} Each answer was timed {} times, fewer where it is slow; an answer \
         shorter than 2 ms is repeated within a run. All points of the diagrams are in report.json.\n",
        findings.command,
        findings.machine.told(),
        findings.runs
    ));
    page
}

fn task(section: &Section) -> String {
    let mut text = format!("\n## {}\n\n{}.\n", section.name, capitalised(section.claim));
    let mut truths: Vec<&str> = section.diagrams.iter().map(|diagram| diagram.truth.as_str()).collect();
    truths.dedup();
    // What all diagrams share is told once.
    if let [truth] = truths[..] {
        text.push_str(&format!("Truth: {truth}.\n"));
    }
    for Diagram { id, title, truth, .. } in &section.diagrams {
        let truth = if truths.len() > 1 { format!("Truth: {truth}. ") } else { String::new() };
        text.push_str(&format!("\n### {title}\n\n![{title}]({id}.svg)\n\n{truth}[Data]({id}.csv)\n"));
    }
    let times = table::times(&section.diagrams);
    if !times.is_empty() {
        text.push_str(&format!(
            "\n### Time to so many digits\n\nThe cheapest answer measured; nothing is interpolated, and — where nobody \
             arrives.\n\n{times}"
        ));
    }
    for diagram in section.diagrams.iter().filter(|diagram| diagram.view == View::Size) {
        text.push_str(&format!("\n### Time by size\n\n{}", table::sizes(diagram)));
    }
    text
}

fn failures(findings: &Findings) -> String {
    let mut text = "\n## Failures\n\n".to_owned();
    let mut rows = String::new();
    for diagram in findings.diagrams() {
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
        text.push_str("None.\n");
    } else {
        text.push_str(&format!("| question | contestant | setting | what it says |\n|---|---|---|---|\n{rows}"));
    }
    text
}

fn omissions(findings: &Findings) -> String {
    let mut sentences: Vec<&str> = Vec::new();
    for sentence in findings.diagrams().flat_map(|diagram| &diagram.omissions).chain(&findings.absent) {
        if !sentences.contains(&sentence.as_str()) {
            sentences.push(sentence);
        }
    }
    let list: String = sentences.iter().map(|sentence| format!("* {sentence}\n")).collect();
    format!("\n## What was left out\n\n{OMITTED}{list}")
}

const OMITTED: &str = "\
* Memory, and the time to the first answer: tables and nodes that are computed once and kept are warm.
* Other processors and compilers.
";

/// With a capital letter at the beginning.
fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// A text within a cell of a table.
pub(super) fn in_cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use mdr_crosscheck::contest::Effort;

    use super::super::diagram::tests::contest;
    use super::super::footer::Machine;
    use super::*;

    fn findings() -> Findings {
        let diagrams = vec![contest(View::Error), contest(View::Size)];
        let section = Section { name: "test", claim: "what is tested", diagrams };
        let (command, machine) = ("mdr report --quick".to_owned(), Machine::here());
        Findings {
            schema: "mdr.report/1",
            command,
            machine,
            effort: Effort::Quick,
            runs: 3,
            tasks: vec![section],
            races: Vec::new(),
            absent: Vec::new(),
            ladders: Vec::new(),
        }
    }

    #[test]
    fn the_page_tells_everything() {
        let page = page(&findings());
        for part in [
            "## test\n\nWhat is tested.\n",
            "![x at y < 1](test-contest.svg)",
            "[Data](test-contest.csv)",
            "| question | contestant | arithmetic | 6 | 12 | 15 |",
            "| test-contest | broken | 7 nodes | no convergence |",
            "* nobody else came\n",
            "    mdr report --quick\n",
        ] {
            assert!(page.contains(part), "{part} in\n{page}");
        }
        assert_eq!(page.matches("nobody else came").count(), 1);
    }
}
