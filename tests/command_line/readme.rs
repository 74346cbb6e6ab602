//! The README and the documents promise nothing that does not work.

use std::path::PathBuf;

use crate::{output, root};

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

/// All Markdown of the repository: name from its folder, and text.
fn documents() -> Vec<(PathBuf, String)> {
    let root = root();
    let folders = ["", "docs", "docs/reference"].map(|folder| root.join(folder));
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
    let pages = files.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let documents: Vec<_> = pages.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect();
    assert!(documents.len() >= 10);
    documents
}

/// Relative links lead to files, and to headings of documents.
#[test]
fn links_lead_somewhere() {
    for (path, text) in documents() {
        for link in outside_of_code(&text).split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
            if link.starts_with("http") {
                continue;
            }
            let (file, heading) = link.split_once('#').map_or((link, None), |(file, heading)| (file, Some(heading)));
            let target = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            assert!(target.exists(), "{}: {link}", path.display());
            if let Some(heading) = heading {
                let page = std::fs::read_to_string(&target).unwrap();
                let headings = page.lines().filter(|line| line.starts_with('#')).map(anchor);
                assert!(headings.into_iter().any(|found| found == heading), "{}: {link}", path.display());
            }
        }
    }
}

/// The anchor that GitHub gives a heading.
fn anchor(heading: &str) -> String {
    let kept = |letter: &char| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_');
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    text.chars().filter(kept).map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

/// The text without its fenced blocks.
fn outside_of_code(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// Formulas are written so that GitHub takes nothing in them for markup: $`…`$ in a line, blocks of the language `math`.
#[test]
fn formulas_are_safe_from_markdown() {
    let mut formulas = 0;
    for (path, text) in documents() {
        let place = path.display();
        let mut check = |formula: &str| {
            formulas += 1;
            let count = |part: &str| formula.matches(part).count();
            assert_eq!(count("{") - count("\\{"), count("}") - count("\\}"), "{place}: braces of {formula}");
            assert_eq!(count("\\left"), count("\\right"), "{place}: brackets of {formula}");
            assert!(
                !formula.trim().is_empty() && !formula.contains('$') && !formula.contains("\n\n"),
                "{place}: {formula}"
            );
        };
        for block in text.split("```math\n").skip(1) {
            check(block.split("```").next().unwrap());
        }
        for line in outside_of_code(&text).lines() {
            let mut parts = line.split('$');
            let mut outside = parts.next().unwrap_or_default();
            assert!(line.matches('$').count() % 2 == 0, "{place}: a lonely $ in {line}");
            while let (Some(formula), Some(rest)) = (parts.next(), parts.next()) {
                let inner = formula.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
                check(inner.unwrap_or_else(|| panic!("{place}: ${formula}$ is not safe")));
                assert!(!outside.ends_with(char::is_alphanumeric), "{place}: {outside}$");
                outside = rest;
            }
        }
    }
    assert!(formulas > 300, "{formulas}");
}

const CONFORMANCE: &str = include_str!("../../docs/conformance.md");

/// Seconds, and half a unit of the last digit, of a cell such as "1.5 ms"; `None` if no method arrives.
fn time(cell: &str) -> Option<(f64, f64)> {
    let (number, unit) = cell.split_once(' ')?;
    let unit = match unit {
        "ns" => 1e-9,
        "µs" => 1e-6,
        "ms" => 1e-3,
        "s" => 1.0,
        other => panic!("{other} in {cell}"),
    };
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Some((unit * number.parse::<f64>().unwrap(), 0.5 * unit * 10f64.powi(-(decimals as i32))))
}

/// Every cell of the table of the README is the cheapest answer of its method with so many digits in the data of the report.
#[test]
fn times_are_those_of_the_report() {
    let data = include_str!("../../docs/report/work-precision.csv");
    let rows: Vec<_> = csv::Reader::from_reader(data.as_bytes()).into_records().map(Result::unwrap).collect();
    let cheapest = |question: &str, method: &str, least: f64| {
        let of = rows.iter().filter(|row| &row[0] == question && &row[1] == method);
        let right = of.filter(|row| row[5].parse::<f64>().is_ok_and(|digits| digits >= least));
        right.map(|row| row[7].parse::<f64>().unwrap()).min_by(f64::total_cmp)
    };
    let (_, text) = README.split_once("MDR transform of\nr^(1/4) at one radius:").unwrap();
    let table = text.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let table: Vec<Vec<&str>> = table.map(|row| row.trim_matches('|').split('|').map(str::trim).collect()).collect();
    assert_eq!((table.len(), table[0][1..].join(" ")), (7, "6 12 15 50 100".to_owned()));
    for row in &table[2..] {
        for (cell, digits) in row[1..].iter().zip(&table[0][1..]) {
            let digits: f64 = digits.parse().unwrap();
            let question = if digits > 15.0 { "digits-transform" } else { "transform-power-0.25" };
            match (time(cell), cheapest(question, row[0], digits)) {
                (Some((shown, rounding)), Some(measured)) => {
                    assert!((shown - measured).abs() <= 1.001 * rounding, "{row:?}: {cell} is {measured}");
                }
                (shown, measured) => assert_eq!((shown, measured), (None, None), "{row:?}: {cell}"),
            }
        }
    }
}

/// Every check and every test file that the table of conformance names is there.
#[test]
fn the_table_of_conformance_names_what_exists() {
    let csv = output("verify --quick --shard 64/64 --format csv");
    let checks: Vec<_> = csv.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    let root = root();
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
