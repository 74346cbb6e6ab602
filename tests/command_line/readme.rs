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

/// Seconds, and half a unit of the last digit, of a cell such as "1.5 ms"; none where no method arrives.
fn time(cell: &str) -> Option<(f64, f64)> {
    let mut words = cell.split_whitespace();
    let number = words.next()?;
    let unit = match words.next()? {
        "ns" => 1e-9,
        "µs" => 1e-6,
        "ms" => 1e-3,
        "s" => 1.0,
        other => panic!("{other} in {cell}"),
    };
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Some((unit * number.parse::<f64>().unwrap(), 0.5 * unit * 10f64.powi(-(decimals as i32))))
}

/// The table that follows `heading`: the digits of each column, and the times that stand in it.
fn times(text: &str, heading: &str) -> Vec<(String, Vec<(f64, f64)>)> {
    let (_, text) = text.split_once(heading).unwrap_or_else(|| panic!("no {heading}"));
    let table = text.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let rows: Vec<Vec<&str>> = table.map(|row| row.trim_matches('|').split('|').map(str::trim).collect()).collect();
    let column = |at: usize| rows[2..].iter().filter_map(|row| time(row[at])).collect();
    let is_digits = |at: &usize| rows[0][*at].bytes().all(|byte| byte.is_ascii_digit());
    (0..rows[0].len()).filter(is_digits).map(|at| (rows[0][at].to_owned(), column(at))).collect()
}

/// Every time in the table of the README stands in the report, for so many digits.
#[test]
fn times_are_those_of_the_report() {
    let report = times(include_str!("../../docs/report/transform.md"), "### g(x) of f = r^0.25");
    let shown = times(README, "MDR transform of r^(1/4)");
    assert_eq!(shown.iter().map(|(_, times)| times.len()).collect::<Vec<_>>(), [5, 5, 5, 3, 3]);
    for ((digits, shown), (of, measured)) in shown.iter().zip(&report) {
        assert_eq!(digits, of);
        for (time, rounding) in shown {
            let stands = measured.iter().any(|(measured, _)| (time - measured).abs() <= *rounding);
            assert!(stands, "{time} s for {digits} digits is not in the report");
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
