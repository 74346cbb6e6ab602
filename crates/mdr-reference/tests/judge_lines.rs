//! The judge: lines of answers, malformed lines, and the rules for a pass.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::io::{BufReader, Read};

use mdr_reference::{Answer, Decimal, Filter, Judge, Report, Rules, Status, Verdict, judge, record, records};

const PULL_OFF: &str = "critical/jkr-unit/force/force";
const OVERFLOW: &str = "critical/half+2^-13/force/contact_radius";

fn read(answers: &str, rules: Rules) -> Report<'static> {
    let mut judge = Judge::new(records(), rules);
    judge.read(answers.as_bytes()).unwrap();
    judge.report()
}

#[test]
fn what_is_no_answer_does_not_stop_the_judge() {
    let answers = format!(
        concat!(
            "{{\"id\":\"{0}\",\"value\":\"-4.71238898038469\"}}\n\n",
            "{{\"id\":\n[1,2]\n{{\"value\":1}}\n{{\"id\":\"{0}\"}}\n{{\"id\":\"{0}\",\"value\":\"four\"}}\n",
            "{{\"id\":\"{0}\",\"value\":1,\"error\":-1}}\n{{\"id\":\"{0}\",\"status\":\"fine\"}}\n",
            "{{\"id\":\"no/such\",\"value\":1}}\r\n{{\"id\":\"{0}\",\"value\":7}}\n{{\"id\":\"{1}\",\"status\":\"overflow\"}}"
        ),
        PULL_OFF, OVERFLOW
    );
    let mut bytes = answers.into_bytes();
    bytes.extend(b"\n\xff\xfe\n");
    let mut judge = Judge::new(records(), Rules::default());
    judge.read(&bytes[..]).unwrap();
    let report = judge.report();
    let malformed: Vec<_> = report.malformed.first.iter().map(|(line, _)| *line).collect();
    assert_eq!(malformed, [3, 4, 5, 6, 7, 8, 9, 13]);
    assert_eq!((report.unknown.count, report.unknown.first[0].0), (1, 10));
    assert_eq!((report.repeated.count, report.repeated.first[0].0), (1, 11));
    assert_eq!((report.answered(), report.passed()), (2, false));
    assert_eq!(
        report.failures(),
        ["malformed lines 3, 4, 5, 6, 7, …: 8 in all", "unknown line 10", "repeated line 11"]
    );
    for line in report.to_json_lines().lines() {
        let value: serde_json::Value = serde_json::from_str(line).unwrap();
        assert_eq!(value["schema"], "mdr.judge/1");
    }
    let summary: serde_json::Value = serde_json::from_str(report.to_json_lines().lines().last().unwrap()).unwrap();
    assert_eq!((&summary["summary"]["answered"], &summary["summary"]["malformed"]), (&2.into(), &8.into()));
}

/// Lines that are generated while they are read.
struct Endless {
    left: u64,
    line: Vec<u8>,
    at: usize,
}

impl Read for Endless {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if self.at == self.line.len() {
            if self.left == 0 {
                return Ok(0);
            }
            self.left -= 1;
            self.at = 0;
        }
        let count = buffer.len().min(self.line.len() - self.at);
        buffer[..count].copy_from_slice(&self.line[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

#[test]
fn a_million_lines_and_a_line_without_an_end() {
    let mut judge = Judge::new(records(), Rules::default());
    let line = format!("{{\"id\":\"{PULL_OFF}\",\"value\":1e{}}}\n", "9".repeat(30)).into_bytes();
    judge.read(BufReader::new(Endless { left: 1_000_000, at: line.len(), line })).unwrap();
    // Two megabytes without a line feed, then an answer.
    let long = Endless { left: 2_000, line: vec![b'x'; 1_000], at: 1_000 };
    let answer = format!("\n{{\"id\":\"{PULL_OFF}\",\"value\":-4.7123889803846897}}");
    judge.read(BufReader::new(long).chain(answer.as_bytes())).unwrap();
    let report = judge.report();
    assert_eq!((report.malformed.count, report.malformed.first.len()), (1_000_001, 10));
    assert_eq!((report.answered(), report.judged[0].line), (1, 1_000_002));
}

/// Infinite ends of ranges become null: every line is JSON.
#[test]
fn an_empty_report_is_json() {
    let report = Judge::new(records(), Rules::default()).report();
    assert_eq!(report.to_json_lines().lines().count(), 1);
    assert!(serde_json::from_str::<serde_json::Value>(&report.to_json_lines()).is_ok());
}

/// Lines that are not answers fail, whatever the others are, unless the rules are lenient.
#[test]
fn one_right_answer_does_not_make_up_for_a_thousand_lines() {
    let right = format!("{{\"id\":\"{PULL_OFF}\",\"value\":-4.71238898038469}}\n");
    let lenient = Rules { lenient: true, ..Rules::default() };
    for (line, failure) in [
        ("{\"id\":\"x\",\"value\":}\n", "malformed lines 2, 3, 4, 5, 6, …: 999 in all"),
        ("{\"id\":\"x\",\"value\":1}\n", "unknown lines 2, 3, 4, 5, 6, …: 999 in all"),
        (&right, "repeated lines 2, 3, 4, 5, 6, …: 999 in all"),
    ] {
        let answers = format!("{right}{}", line.repeat(999));
        let report = read(&answers, Rules::default());
        assert_eq!(report.failures(), [failure]);
        assert!(report.to_json_lines().ends_with("\"passed\":false,\"hypotheses\":[]}}"), "{report}");
        assert!(read(&answers, lenient).passed());
    }
}

/// The notations of C, Fortran, Python and others for NaN and infinities are answers, and wrong ones.
#[test]
fn not_a_number_in_many_spellings() {
    for value in
        ["nan", "-nan", "inf", "-inf", "NaN", "Infinity", "\"-nan(ind)\"", "\"1.#QNAN\"", "1.#INF", "-1.#IND00"]
    {
        let report = read(&format!("{{\"id\":\"{PULL_OFF}\",\"value\":{value}}}"), Rules::default());
        assert_eq!((report.count(Verdict::Wrong), report.malformed.count), (1, 0), "{value}");
    }
    let infinities = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(Answer::from);
    for answer in infinities {
        assert_eq!(Answer::from_json(&answer.to_json("x")).unwrap().1, answer);
    }
}

/// `printf("%a")` of a long double, and of a double with the zeros that some libraries add.
#[test]
fn hexadecimal_answers() {
    for value in ["-0x9.6cbe3f9990e91a8p-1", "\"-0x1.2d97c7f3321d2000p+2\"", "-0X1.2D97C7F3321D2P+2"] {
        let report = read(&format!("{{\"id\":\"{PULL_OFF}\",\"value\":{value}}}"), Rules::default());
        assert!(report.passed() && report.judged[0].mark.lre.unwrap().low > 15.0, "{value}: {report}");
    }
    assert!("0x1p-2000".parse::<Decimal>().unwrap().log10() < -602.0);
}

/// Quoted texts of answers are cut, and contain no control characters for a terminal.
#[test]
fn strange_texts_are_escaped() {
    let long = "y".repeat(900_000);
    let lines = [
        format!("{{\"id\":\"{PULL_OFF}\",\"status\":\"{long}\"}}"),
        format!("{{\"id\":\"{PULL_OFF}\",\"value\":\"{long}\"}}"),
        format!("{{\"id\":\"{long}\",\"value\":1}}"),
        "{\"id\":\"\\u001b[2J\\n\\u009b\",\"value\":1}".to_owned(),
    ];
    let report = read(&lines.join("\n"), Rules::default());
    let text = report.to_string();
    assert_eq!((report.malformed.count, report.unknown.count), (2, 2), "{text}");
    assert!(text.len() < 2_000, "{} bytes", text.len());
    assert!(!text.chars().any(|letter| letter.is_control() && letter != '\n'), "{text:?}");
    assert_eq!(report.unknown.first[1].1, r#""\u{1b}[2J\n\u{9b}""#);
}

/// A selection of questions: others are set aside, and all of the selection must be answered if the rules require it.
#[test]
fn a_choice_that_is_complete() {
    let choice: Filter = "id~critical/jkr-unit control=force".parse().unwrap();
    let answers = |left_out: usize| {
        let questions = choice.select().skip(left_out).chain([record(OVERFLOW).unwrap()]);
        questions.map(|question| Answer::from(question.nearest()).to_json(&question.id) + "\n").collect::<String>()
    };
    let judged = |answers: &str, complete: bool| {
        let mut judge = Judge::new(choice.select(), Rules { complete, ..Rules::default() });
        judge.read(answers.as_bytes()).unwrap();
        judge.report()
    };
    let all = judged(&answers(0), true);
    assert!(all.passed() && all.set_aside == 1 && all.unanswered() == 0, "{all}");
    assert!(all.to_string().contains("1 answer to another record set aside"), "{all}");
    let some = judged(&answers(1), true);
    assert_eq!(some.failures(), ["1 not answered"]);
    assert!(some.to_string().contains("; 1 not answered"), "{some}");
    assert!(judged(&answers(1), false).passed());
    let solver = Rules { complete: true, ..Rules::default() }
        .judge(choice.select(), |question| (question.quantity == "force").then(|| question.nearest().into()));
    assert_eq!(solver.failures(), ["2 not answered"]);
}

/// −5.0 for −4.712 does not pass.
#[test]
fn what_passes() {
    let solve = |value: f64, rules: Rules| rules.judge(record(PULL_OFF), |_| Some(value.into())).failures();
    assert_eq!(solve(-5.0, Rules::default()), ["1 inaccurate"]);
    assert!(solve(-5.0, Rules { accept_inaccurate: true, ..Rules::default() }).is_empty());
    assert_eq!(solve(77.0, Rules { accept_inaccurate: true, lenient: true, ..Rules::default() }), ["1 wrong"]);
    let none = judge(records(), |_| None);
    assert!(!none.passed() && none.to_string().ends_with("not passed: no question was answered"), "{none}");
    assert!(!judge(records(), |question| (question.status == Status::Fold).then(|| Status::Fold.into())).passed());
}

/// JSON and rows contain the same, for an answer with one bound and for one without digits.
#[test]
fn json_and_rows_agree() {
    let exact = record(PULL_OFF).unwrap().decimal().unwrap();
    let answers = format!(
        "{{\"id\":\"{PULL_OFF}\",\"value\":{exact},\"error\":0.02}}\n{{\"id\":\"{OVERFLOW}\",\"value\":inf}}\nx"
    );
    let report = read(&answers, Rules::default());
    let rows = report.to_rows();
    let lines: Vec<serde_json::Value> =
        report.to_json_lines().lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((rows.len(), lines.len()), (4, 4));
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    for (row, line) in rows[1..3].iter().zip(&lines) {
        for (name, cell) in rows[0].iter().zip(row) {
            let (key, end) = match name.rsplit_once('_') {
                Some((key, end @ ("low" | "high"))) => (key, end),
                _ => (name.as_str(), ""),
            };
            match (&line[key], end) {
                (serde_json::Value::Null, _) => assert_eq!(cell, "", "{name}"),
                (serde_json::Value::Array(ends), end) => {
                    let (written, full) = (ends[usize::from(end == "high")].as_f64(), cell.parse::<f64>().unwrap());
                    assert!(written.map_or(full.is_infinite(), |written| (written - full).abs() < 1e-3), "{name}");
                }
                (serde_json::Value::String(text), _) => assert_eq!(cell, text, "{name}"),
                (value, _) => assert_eq!(*cell, value.to_string(), "{name}"),
            }
        }
    }
    assert_eq!(rows[3][1..3], ["3".to_owned(), "malformed".to_owned()]);
}

/// JSON, fields between any marks, and CSV with a header in any order are the same answers.
#[test]
fn answers_have_many_notations() {
    let json = format!(
        "{{\"id\":\"{PULL_OFF}\",\"value\":\"-4.712\",\"error\":\"0.001\"}}\n{{\"id\":\"{OVERFLOW}\",\"status\":\"overflow\"}}\n"
    );
    let expected = read(&json, Rules::default());
    assert_eq!((expected.answered(), expected.passed()), (2, true));
    for text in [
        format!("{PULL_OFF} -4.712 0.001\n{OVERFLOW} overflow\n"),
        format!("{PULL_OFF}\t-4.712\t0.001\n\n{OVERFLOW}\toverflow\n"),
        format!("\u{feff}{PULL_OFF},-4.712,0.001\r\n{OVERFLOW},,,overflow\r\n"),
        format!("# my solver 1.0\nid;value;error;status\n{PULL_OFF};-4.712;0.001;\n{OVERFLOW};;;overflow\n"),
        format!(
            "status,error,seconds,value,id\n,1e-3,0.1,-0x1.2d916872b020cp+2,\"{PULL_OFF}\"\noverflow,,0.2,,{OVERFLOW}\n"
        ),
        format!("id value\n{PULL_OFF} -4.712\n{OVERFLOW} overflow\n"),
        format!("{PULL_OFF} -4.712\n{{\"id\":\"{OVERFLOW}\",\"status\":\"overflow\"}}\n"),
    ] {
        let report = read(&text, Rules { accept_inaccurate: true, ..Rules::default() });
        assert_eq!((report.answered(), report.malformed.count), (2, 0), "{text}: {:?}", report.malformed.first);
        assert_eq!(report.judged.iter().filter(|judged| judged.mark.status_matches).count(), 2, "{text}");
    }
    // What is malformed is said, with what a line should be.
    for (line, why) in [
        (format!("{PULL_OFF} four"), "value: "),
        (PULL_OFF.to_owned(), "there is neither a value nor a status beside \"critical/jkr-unit"),
        (format!("{PULL_OFF} 1 2 ok more"), "5 fields where 4 may be"),
        (format!("{PULL_OFF};1,5"), "value: "),
        (format!("{PULL_OFF},-4.712,-1"), "error: must not be negative"),
        (format!("{PULL_OFF},-4.712,,fine"), "fine"),
        (",-4.712".to_owned(), "there is no id"),
        ("[1,2]".to_owned(), "expected an object"),
        (format!("{PULL_OFF} 1\nid value"), "value: "),
    ] {
        let report = read(&line, Rules::default());
        let (_, message) = &report.malformed.first[0];
        assert!(message.contains(why), "{line}: {message}");
        assert!(
            message.contains("a line is {\"id\": …, \"value\": …}, or an id and its value between blanks"),
            "{message}"
        );
    }
}

#[test]
fn inputs_are_filtered_as_numbers() {
    let count = |filter: &str| filter.parse::<Filter>().unwrap().select().count();
    let spheres = records().iter().filter(|record| record.input("n") == Some("2")).count();
    assert!(spheres > 100 && [count("n=2"), count("n=2.0"), count("n=0.2e1")] == [spheres; 3]);
    assert_eq!(count("n!=2"), records().iter().filter(|record| record.input("n").is_some()).count() - spheres);
    assert!(count("n=2 formula=critical control=force") < spheres);
    for (filter, why) in [("n=77", "none has this value of n"), ("m=2", "or an input: "), ("n=", "expected key=value")]
    {
        let error = filter.parse::<Filter>().unwrap_err().to_string();
        assert!(error.contains(why), "{filter}: {error}");
    }
}
