//! The README and the documents promise nothing that does not work.

use std::path::PathBuf;

use crate::{output, root, without_program};

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
        assert_eq!(output(&arguments).trim_end(), without_program(&shown), "{arguments}");
    }
}

/// The lines of `sh` blocks with commands `mdr`, run as typed in a folder that has examples/ and docs/. A comment says the exit
/// status where it is not 0. Without python3 the rest of a block that needs it is left out.
#[cfg(unix)]
#[test]
fn commands_work_as_typed() {
    let folder = std::env::temp_dir().join(format!("mdr-readme-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["examples", "docs"] {
        std::os::unix::fs::symlink(root().join(name).canonicalize().unwrap(), folder.join(name)).unwrap();
    }
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_mdr")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let run = |line: &str| {
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", line]).current_dir(&folder).env("PATH", &path).output().unwrap()
    };
    let mut commands = 0;
    for block in README.split("```sh\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let foreign = |line: &&str| !["cargo ", "make ", "pip "].iter().any(|tool| line.starts_with(tool));
        for line in block.lines().filter(foreign) {
            if line.starts_with("python3 ") && !run("python3 --version").status.success() {
                break;
            }
            let expected = line.split_once("# exit status ").map_or(0, |(_, rest)| rest[..1].parse().unwrap());
            let found = run(line);
            assert_eq!(found.status.code(), Some(expected), "{line}: {}", String::from_utf8_lossy(&found.stderr));
            commands += 1;
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(commands >= 5, "{commands}");
}

/// The first lines of the table that the README shows are those of the file.
#[test]
fn the_small_table_is_shown_as_it_is() {
    let file = include_str!("../../docs/reference/jkr-sphere.csv");
    let (_, text) = README.split_once("[jkr-sphere.csv](docs/reference/jkr-sphere.csv):\n\n```text\n").unwrap();
    let shown: Vec<_> = text.split("```").next().unwrap().lines().collect();
    assert!(shown.len() >= 2 && shown[0].contains("contact_radius (m),indentation (m),force (N)"));
    for line in shown {
        let line = line.strip_suffix(",…").unwrap();
        assert!(file.lines().any(|row| row.starts_with(&format!("{line},"))), "{line}");
    }
}

/// Each published package has a README of its own, of about ten lines and with an example; it says what is not done.
#[test]
fn every_published_package_has_its_own_readme() {
    let mut published = 0;
    for entry in std::fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        if manifest.contains("publish = false") {
            continue;
        }
        published += 1;
        let name = manifest.split("name = \"").nth(1).unwrap().split('"').next().unwrap();
        assert!(manifest.contains("\nreadme = \"README.md\"\n"), "{name}: readme of the manifest");
        let text = std::fs::read_to_string(folder.join("README.md")).unwrap();
        assert!(text.starts_with(&format!("# {name}")), "{name}: heading");
        for part in ["```", "Features: ", "](../../README.md)"] {
            assert!(text.contains(part) || text.replace("Features, ", "Features: ").contains(part), "{name}: {part}");
        }
        assert!((8..=20).contains(&text.lines().count()), "{name}: {} lines", text.lines().count());
        if let Ok(library) = std::fs::read_to_string(folder.join("src/lib.rs")) {
            assert!(library.contains("#[doc = include_str!(\"../README.md\")]"), "{name}: its example is no doctest");
        }
    }
    assert!(published >= 10, "{published}");
}

/// The limits that the README lists are those of the first page of the documentation of Rust.
#[test]
fn both_lists_of_limits_are_one() {
    let limits = |text: &str, prefix: &str| {
        let (_, text) = text.split_once("# What mdr does not do\n").unwrap();
        let lines = text.lines().map(|line| line.strip_prefix(prefix).unwrap_or(line).trim_start());
        let section = lines.take_while(|line| !line.starts_with('#'));
        let items = section
            .filter_map(|line| line.strip_prefix("* **"))
            .map(|item| item.split("**").next().unwrap().trim_end_matches('.').to_owned());
        items.collect::<Vec<_>>()
    };
    let readme = limits(README, "");
    assert!(readme.len() >= 5);
    assert_eq!(readme, limits(include_str!("../../crates/mdr/src/lib.rs"), "//!"));
}

/// All Markdown of the repository: name from its folder, and text.
fn documents() -> Vec<(PathBuf, String)> {
    let root = root();
    let crates = std::fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let folders = ["", "docs", "docs/reference"].map(|folder| root.join(folder)).into_iter().chain(crates);
    let files = folders.flat_map(|folder| std::fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
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
    let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(data.as_bytes());
    let rows: Vec<_> = reader.into_records().map(Result::unwrap).collect();
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
        // A row of the paper begins with an equation; behind the files stands the physics, checks again.
        let from = if row.starts_with("| (1.") { 4 } else { 3 };
        let [named, files, physics @ ..] = &columns[from..] else { panic!("{row}") };
        let named = named.split('`').skip(1).step_by(2);
        for check in named.chain(physics.iter().flat_map(|cell| cell.split('`').skip(1).step_by(2))) {
            assert!(checks.contains(&check), "no check {check}; there are {checks:?}");
        }
        for file in files.split('`').skip(1).step_by(2) {
            assert!(root.join(file).is_file(), "{file}");
        }
    }
}
