//! README.md of a report: every task with a picture, its fastest answers, and the way to its page.

use super::page::{self, FASTEST, capitalised, pictures};
use super::store::{Findings, Section};
use super::{speed, table};

const HEAD: &str = "\
# Error against run time

Several methods answer the same question with growing effort. Every answer is compared with an enclosure of the truth in
which no contestant had a part. Times belong to the machine that is named at the end: compare them within one task.

Errors and times of every question are diagrams on the pages of the tasks; their points are in the CSV files and in
[report.json](report.json).
";

/// The text of the page. `all` are the names of the tasks that there are.
pub(super) fn page(findings: &Findings, all: &[&str]) -> String {
    let mut text = format!("{HEAD}\nIn the tables of times: {FASTEST}");
    text.push_str(&warning(&findings.unfinished));
    text.push_str("\n| task | what is asked |\n|---|---|\n");
    for Section { name, claim, .. } in &findings.tasks {
        text.push_str(&format!("| [{name}](#{name}) | {} |\n", page::in_cell(claim)));
    }
    for section in &findings.tasks {
        text.push_str(&of(section));
    }
    let absent: Vec<_> = all.iter().filter(|name| findings.tasks.iter().all(|task| task.name != **name)).collect();
    if !absent.is_empty() {
        let names: Vec<_> = absent.iter().map(|name| format!("`mdr report --only {name}`")).collect();
        text.push_str(&format!("\n## Not in this directory\n\n{}\n", names.join(", ")));
    }
    text.push_str("\n## How this was made\n");
    text + &made(&findings.tasks)
}

/// What a reader of an interrupted report must know.
fn warning(unfinished: &[String]) -> String {
    if unfinished.is_empty() {
        return String::new();
    }
    format!(
        "\n> **This report is under way, or was interrupted.** Not done: {}. What stands here of these tasks is from an \
         earlier report.\n",
        unfinished.join(", ")
    )
}

fn of(section: &Section) -> String {
    let Section { name, claim, .. } = section;
    let mut text = format!("\n## {name}\n\n{}.\n{}", capitalised(claim), pictures(section));
    let fastest = table::fastest(&section.diagrams);
    if !fastest.is_empty() {
        text.push_str(&format!("\n{fastest}"));
    }
    text.push_str(&speed::overview(&section.races));
    if let Some(ladders) = &section.ladders {
        text.push_str(&ladders.told());
    }
    text + &format!("\n[All of {name}: diagrams, tables, data]({name}.md)\n")
}

/// The commands and machines, each with its tasks.
fn made(sections: &[Section]) -> String {
    let mut told: Vec<(String, Vec<&str>)> = Vec::new();
    for section in sections {
        let how = format!("    {}\n\n{}", section.made.command, section.made.machine.told());
        match told.iter_mut().find(|(known, _)| *known == how) {
            Some((_, names)) => names.push(&section.name),
            None => told.push((how, vec![&section.name])),
        }
    }
    told.into_iter().map(|(how, names)| format!("\n{}:\n\n{how}\n", capitalised(&names.join(", ")))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::store::tests::section;
    use super::*;

    #[test]
    fn every_task_has_its_place() {
        let findings = Findings { tasks: vec![section("one"), section("two")], ..Findings::default() };
        let text = page(&findings, &["one", "two", "three"]);
        for part in [
            "| [one](#one) | what is tested |\n",
            "## two\n\nWhat is tested.\n\n![two: time to 12 digits](two-summary.svg)\n",
            "| question | 6 | 12 | 15 |\n",
            "[All of two: diagrams, tables, data](two.md)",
            "`mdr report --only three`",
            "\nOne, two:\n\n    mdr report --quick\n",
        ] {
            assert!(text.contains(part), "{part} in\n{text}");
        }
        assert!(!text.contains("under way"));
    }

    #[test]
    fn an_interrupted_report_says_so() {
        let findings = Findings { unfinished: vec!["fold".to_owned()], ..Findings::default() };
        assert!(page(&findings, &[]).contains("interrupted.** Not done: fold."));
    }
}
