//! `mdr judge`.

use serde_json::Value;

use crate::mdr;

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
    let (code, table) = judged(&format!("{RIGHT}\n{ROUGH}"), "");
    assert_eq!(code, 0);
    assert!(table.contains("1 right, 1 inaccurate, 0 wrong"), "{table}");
    assert_eq!(judged(ROUGH, "--strict").0, 1);
    assert_eq!(judged(ROUGH, "--strict --excess 14").0, 0);
    let (code, table) = judged(&format!("{RIGHT}\n{CLAIM}"), "");
    assert_eq!(code, 1);
    assert!(table.contains("further off than it claims"), "{table}");
    assert_eq!(judged("", "").0, 1, "nothing to judge");
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
