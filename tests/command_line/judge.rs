//! `mdr judge`.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::{mdr, root, without_program};

/// `mdr judge` of these answers from standard input: exit status and output.
fn judged(answers: &str, flags: &str) -> (i32, String) {
    let assert = mdr(&format!("judge - {flags}")).stdin(answers).assert();
    let output = assert.get_output();
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    (output.status.code().unwrap(), String::from_utf8(output.stdout.clone()).unwrap())
}

const RIGHT: &str = r#"{"id":"critical/jkr-unit/force/force","value":-4.71238898038469}"#;
const ROUGH: &str = r#"{"id":"critical/jkr-unit/force/contact_radius","value":"1.523"}"#;
const CLAIM: &str = r#"{"id":"critical/jkr-unit/indentation/force","value":"-2.618","error":"1e-9"}"#;

#[test]
fn right_and_wrong_answers() {
    assert_eq!(judged(RIGHT, "").0, 0);
    let both = format!("{RIGHT}\n{ROUGH}");
    let (code, table) = judged(&both, "");
    assert_eq!(code, 1);
    assert!(
        table.contains("1 right, 1 inaccurate, 0 wrong") && table.ends_with("not passed: 1 inaccurate\n"),
        "{table}"
    );
    assert_eq!(judged(&both, "--accept-inaccurate").0, 0);
    assert_eq!(judged(ROUGH, "--excess 14").0, 0);
    let (code, table) = judged(&format!("{RIGHT}\n{CLAIM}"), "--accept-inaccurate --lenient");
    assert_eq!(code, 1);
    assert!(table.contains("further off than it claims"), "{table}");
    let (code, table) = judged("", "");
    assert_eq!(code, 1);
    assert!(table.contains("not passed: no question was answered"), "{table}");
}

/// What is not judged fails, and is named by its lines, in every format.
#[test]
fn lines_that_are_no_answers() {
    let answers = format!("{RIGHT}\n{}{{\"id\":\"no/such\",\"value\":1}}", "nonsense\n".repeat(999));
    let (code, table) = judged(&answers, "");
    assert_eq!(code, 1);
    let why = "not passed: malformed lines 2, 3, 4, 5, 6, …: 999 in all; unknown line 1001\n";
    assert!(table.ends_with(why) && table.contains("989 more lines malformed"), "{table}");
    assert_eq!(judged(&answers, "--lenient").0, 0);
    let (code, csv) = judged(&answers, "--format csv");
    assert_eq!((code, csv.lines().count()), (1, 13));
    assert!(csv.contains("\n,2,malformed,") && csv.contains("\n,1001,unknown,"), "{csv}");
}

/// The questions of a choice; a program that dies after one answer.
#[test]
fn a_choice_of_questions() {
    let filter = "--filter id~critical/jkr-unit/,control=force";
    let (code, table) = judged(&format!("{RIGHT}\n{CLAIM}"), filter);
    assert_eq!(code, 0);
    let counts =
        "1 of 3 questions answered: 1 right, 0 inaccurate, 0 wrong; 2 not answered; 1 answer to another record";
    assert!(table.contains(counts), "{table}");
    let (code, table) = judged(RIGHT, &format!("{filter} --complete"));
    assert_eq!(code, 1);
    assert!(table.ends_with("not passed: 2 not answered\n"), "{table}");
    let summary = judged(RIGHT, &format!("{filter} --complete --format json")).1;
    let summary: Value = serde_json::from_str(summary.lines().last().unwrap()).unwrap();
    assert_eq!(summary["summary"]["unanswered"], 2);
    assert_eq!(
        (&summary["summary"]["passed"], &summary["summary"]["failures"][0]),
        (&false.into(), &"2 not answered".into())
    );
    let refused = mdr("judge - --filter control=force,control=machine").stdin(RIGHT).assert().code(2).stdout_eq("");
    assert!(refused.get_output().stderr.starts_with(b"error: --filter: no record meets all terms"));
}

/// The convention behind wrong answers: γ for w, known by the critical radii of three spheres.
#[test]
fn the_mistake_is_named() {
    let radius = |case: &str, c: f64, e_star: f64, w: f64| {
        let cube = 9.0 * std::f64::consts::PI * (w / 2.0) / (32.0 * c * c * e_star);
        format!("{{\"id\":\"critical/{case}/force/contact_radius\",\"value\":{:e}}}\n", cube.cbrt())
    };
    let two = radius("jkr-unit", 0.5, 1.0, 1.0) + &radius("afm-tip", 2.5e7, 7e10, 0.1);
    let three = radius("pdms-bead", 5e4, 1.3e6, 0.05) + &two;
    let sentence = "all 3 answers that are not right agree to 15 digits if your work of adhesion is w/2";
    let (code, table) = judged(&three, "");
    assert!(code == 1 && table.contains(sentence), "{table}");
    assert!(!judged(&two, "").1.contains("answers that are not right agree"));
    let summary = |answers: &str| -> Value {
        let json = judged(answers, "--format json").1;
        serde_json::from_str(json.lines().last().unwrap()).unwrap()
    };
    let named = &summary(&three)["summary"]["hypotheses"][0];
    assert_eq!(named["names"][0], "work-halved");
    assert_eq!([&named["explained"], &named["inputs"]], [3, 3]);
    assert_eq!(summary(&two)["summary"]["hypotheses"], Value::Array(Vec::new()));
}

#[test]
fn a_limit_is_a_number_of_digits() {
    for limit in ["1e400", "-1", "17"] {
        let refused = mdr(&format!("judge - --excess {limit}")).stdin(RIGHT).assert().code(2).stdout_eq("");
        assert!(refused.get_output().stderr.starts_with(b"error: --excess: must be from 0 to 16"), "{limit}");
    }
    let nonsense = r#"{"id":"critical/jkr-unit/force/force","value":77}"#;
    assert_eq!(judged(nonsense, "--excess 16 --accept-inaccurate").0, 1);
}

#[test]
fn lines_for_a_program() {
    let (code, text) = judged(&format!("nonsense\n{RIGHT}\n{CLAIM}\n{RIGHT}"), "--format json");
    assert_eq!(code, 1);
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["verdict"], "wrong");
    assert_eq!((&lines[0]["claim"], &lines[0]["line"]), (&"too-small".into(), &3.into()));
    assert_eq!((&lines[2]["refused"], &lines[2]["line"]), (&"malformed".into(), &1.into()));
    let summary = &lines.last().unwrap()["summary"];
    assert_eq!((&summary["answered"], &summary["repeated"]), (&2.into(), &1.into()));
    let (_, csv) = judged(RIGHT, "--format csv");
    assert!(csv.starts_with("id,line,verdict,") && csv.lines().count() == 2);
}

#[test]
fn a_file_that_is_not_there() {
    let assert = mdr("judge no/such.jsonl").assert().code(2).stdout_eq("");
    assert!(assert.get_output().stderr.starts_with(b"error: no/such.jsonl: "));
}

/// A file of this test.
fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Draws the judgement of these answers; the text of the picture and of its data.
fn drawn(name: &str, answers: &str) -> (String, String) {
    let svg = file(&format!("judged-{name}.svg"));
    let status = judged(answers, &format!("--plot {}", svg.display())).0;
    assert!(status <= 1, "{name}: {status}");
    let read = |path: PathBuf| std::fs::read_to_string(path).unwrap();
    (read(svg.clone()), read(svg.with_extension("csv")))
}

/// Right digits, distance to the fold and excess loss of answers whose errors are known.
#[test]
fn a_picture_of_known_errors() {
    let near = "equilibrium/jkr-unit/near=2^-12/outer/indentation/contact_radius";
    let record = mdr_reference::record(near).unwrap();
    let rough = record.nearest() * (1.0 + 1e-6);
    let answers = [
        format!("{{\"id\":\"{near}\",\"value\":{rough:e}}}"),
        r#"{"id":"equilibrium/jkr-unit/past=2^-12/outer/indentation/contact_radius","value":"nan"}"#.to_owned(),
        RIGHT.to_owned(),
    ];
    let (svg, csv) = drawn("known", &answers.join("\n"));
    roxmltree::Document::parse(&svg).unwrap();
    let points: Vec<(String, String, f64, f64)> = csv
        .lines()
        .filter(|line| line.split(',').nth(1) == Some("mark"))
        .map(|line| {
            let fields: Vec<_> = line.split(',').collect();
            (fields[0].to_owned(), fields[2].to_owned(), fields[5].parse().unwrap(), fields[7].parse().unwrap())
        })
        .collect();
    let found = |panel: &str, verdict: &str, x: f64, y: f64| {
        let beside = |(p, v, a, b): &(String, String, f64, f64)| {
            p == panel && v == verdict && (a / x - 1.0).abs() < 1e-6 && (b - y).abs() < 1e-3
        };
        assert!(points.iter().any(beside), "{panel} {verdict} {x} {y}: {points:?}");
    };
    let condition = record.total_condition();
    let loss = -6.0 - (f64::EPSILON / 2.0 * condition).log10();
    found("1", "inaccurate", condition, 6.0);
    found("2", "inaccurate", 2f64.powi(-12), 6.0);
    found("2", "wrong", 2f64.powi(-12), -1.0);
    found("3", "inaccurate", record.decades(), loss);
    assert_eq!(
        points.iter().filter(|(panel, ..)| panel == "2").count(),
        2,
        "a critical state has no distance to a fold"
    );
}

#[test]
fn without_an_answer_there_is_a_report_and_no_picture() {
    let svg = file("judged-none.svg");
    for (answers, filter, said) in [
        ("bad\n", "", "line 1: malformed"),
        (RIGHT, "--filter profile=cone", "1 answer to another record set aside"),
        ("", "", "not passed: no question was answered"),
    ] {
        let result = mdr(&format!("judge - --plot {} {filter}", svg.display())).stdin(answers).assert().code(1);
        let [report, note] =
            [&result.get_output().stdout, &result.get_output().stderr].map(|b| String::from_utf8_lossy(b));
        assert!(report.contains(said), "{report}");
        assert_eq!(note, "note: --plot: no picture, since there is no answer to draw\n");
        assert!(!svg.exists());
    }
}

/// A zero has no sign, and a range with equal ends is one number.
#[test]
fn no_right_digit_is_zero_digits() {
    let zero = r#"{"id":"critical/jkr-unit/force/force","value":0}"#;
    let (_, table) = judged(zero, "");
    assert!(table.contains(" 0.0 ") && !table.contains("-0.0") && !table.contains("0.0 to"), "{table}");
    let (_, json) = judged(zero, "--format json");
    assert!(json.contains("\"lre\":[0.000,0.000]"), "{json}");
}

/// The reason names the term, cut and escaped, and names it once.
#[test]
fn a_refused_filter_is_named_once() {
    let long = format!("profile={}\u{1b}", "x".repeat(200));
    for filter in ["profile=sfere", "sfere", &long] {
        for command in ["judge -", "reference"] {
            let result = mdr(command).args(["--filter", filter]).stdin("").assert().code(2);
            let error = String::from_utf8_lossy(&result.get_output().stderr);
            assert!(!error.contains(", got ") || error.matches("sfere").count() == 1, "{error}");
            assert!(!error.contains('\u{1b}') && !error.contains(&"x".repeat(100)), "{error}");
        }
    }
}

/// The data of a picture do not replace a file of the user; those of the same picture they do.
#[test]
fn a_file_beside_the_picture_is_left_alone() {
    let (svg, csv) = (file("judged-beside.svg"), file("judged-beside.csv"));
    std::fs::write(&csv, "id,profile\nmine,mine\n").unwrap();
    let plot = format!("judge - --plot {}", svg.display());
    let refused = mdr(&plot).stdin(RIGHT).assert().code(2).stdout_eq("");
    let error = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(error.contains("would replace") && error.contains("judged-beside.csv"), "{error}");
    assert_eq!(std::fs::read_to_string(&csv).unwrap(), "id,profile\nmine,mine\n");
    std::fs::remove_file(&csv).unwrap();
    for _ in 0..2 {
        mdr(&plot).stdin(RIGHT).assert().code(0);
    }
}

#[test]
fn a_picture_of_answers_has_a_name_that_tells_its_kind() {
    let result = mdr("judge - --plot out.txt").stdin(RIGHT).assert().code(2).stdout_eq("");
    assert!(result.get_output().stderr.starts_with(b"error: --plot: must be the name of an .svg, .png or .pdf file"));
}

/// The answers that the documents show.
const SHOWN: [&str; 6] = ["quartic", "newton", "workspace", "adhesion", "lammps", "lammps_mdr"];

fn answers(name: &str) -> String {
    std::fs::read_to_string(root().join(format!("docs/judged/{name}.jsonl"))).unwrap()
}

/// The pictures of the documents are those of this program.
#[test]
fn the_pictures_of_the_documents_are_current() {
    for name in SHOWN {
        let checked_in = std::fs::read_to_string(root().join(format!("docs/judged/{name}.svg"))).unwrap_or_default();
        assert!(
            without_program(&checked_in) == without_program(&drawn(name, &answers(name)).0),
            "stale: cargo run -p mdr-cli -- judge docs/judged/{name}.jsonl --plot docs/judged/{name}.svg; rm docs/judged/{name}.csv"
        );
    }
}

/// The digits in the table of docs/judged.md are those of the answers beside it.
#[test]
fn the_table_of_the_documents_is_current() {
    let document = std::fs::read_to_string(root().join("docs/judged.md")).unwrap();
    let rows: Vec<Vec<&str>> = document
        .lines()
        .filter(|line| line.contains("| unit |") || line.contains("| tip |"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert_eq!(rows.len(), 14);
    for (way, column) in [("quartic", 2), ("newton", 3), ("workspace", 4)] {
        let (_, csv) = judged(&answers(way), "--format csv");
        for row in &rows {
            let place = match row[0] {
                "−d_c" => "opposite".to_owned(),
                far if far.starts_with("−10") => format!("opposite-1e{}", if far.contains('⁶') { 6 } else { 3 }),
                near => format!("near=2^-{}", subscripts(near)),
            };
            let sphere = if row[1] == "unit" { "jkr-unit" } else { "afm-tip" };
            let id = format!("equilibrium/{sphere}/{place}/outer/indentation/contact_radius");
            let line = csv.lines().find(|line| line.starts_with(&format!("{id},"))).unwrap_or_else(|| panic!("{id}"));
            let tenths = |column: usize| -> f64 { line.split(',').nth(column).unwrap().parse().unwrap() };
            let shown = format!("{:.1} ({:.1})", tenths(5), tenths(7)).replace('-', "−");
            assert_eq!(row[column], shown, "{way}: {id}");
        }
    }
}

/// The number k in d_c(1 − 2⁻ᵏ).
fn subscripts(text: &str) -> String {
    text.chars()
        .filter_map(|letter| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == letter))
        .map(|digit| digit.to_string())
        .collect()
}
