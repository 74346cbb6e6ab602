//! The README and the documents promise nothing that does not work.

use crate::output;

const README: &str = include_str!("../../README.md");

/// Every `$ … mdr …` command of the README, and the output printed below it.
fn transcripts() -> Vec<(String, String)> {
    let mut found = Vec::new();
    for block in README.split("```console\n").skip(1) {
        let block = block.split("```").next().unwrap();
        for part in block.split("$ ").skip(1) {
            let (command, shown) = part.split_once('\n').unwrap();
            let arguments = command.strip_prefix("mdr ").or_else(|| command.split_once(" -- ").map(|(_, rest)| rest));
            if let Some(arguments) = arguments {
                found.push((arguments.to_owned(), shown.trim_end().to_owned()));
            }
        }
    }
    found
}

#[test]
fn transcripts_are_what_the_program_says() {
    let transcripts = transcripts();
    assert!(transcripts.len() >= 2);
    for (arguments, shown) in transcripts {
        assert_eq!(output(&arguments).trim_end(), shown, "{arguments}");
    }
}

/// Relative links lead to files.
#[test]
fn links_lead_somewhere() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for link in README.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
        assert!(link.starts_with("http") || root.join(link).exists(), "{link}");
    }
}

const CONFORMANCE: &str = include_str!("../../docs/conformance.md");

/// Every check and every test file that the table of conformance names is there.
#[test]
fn the_table_of_conformance_names_what_exists() {
    let csv = output("verify --quick --shard 64/64 --format csv");
    let checks: Vec<_> = csv.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let rows = CONFORMANCE.lines().filter(|line| line.starts_with("| ") && line.contains('`'));
    for row in rows {
        let columns: Vec<_> = row.trim_matches('|').split('|').collect();
        let [.., named, files] = columns[..] else { panic!("{row}") };
        for check in named.split('`').skip(1).step_by(2) {
            assert!(checks.contains(&check), "no check {check}; there are {checks:?}");
        }
        for file in files.split('`').skip(1).step_by(2) {
            assert!(root.join(file).is_file(), "{file}");
        }
    }
}
