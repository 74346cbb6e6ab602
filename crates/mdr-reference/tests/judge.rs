//! The judge: what is right, what is wrong, and what is no answer at all.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::io::{BufRead, BufReader, Read};

use mdr_reference::{
    Answer, Claim, Decimal, Difficulty, Judge, Limits, Mark, Status, Verdict, judge, mark, record, records,
};

const PULL_OFF: &str = "critical/jkr-unit/force/force";
const OVERFLOW: &str = "critical/half+2^-13/force/contact_radius";

fn marked(id: &str, answer: &Answer) -> Mark {
    mark(record(id).unwrap(), answer, &Limits::default())
}

fn line(json: &str) -> Mark {
    let (id, answer) = Answer::from_json(json).unwrap();
    marked(&id, &answer)
}

/// The certified values themselves, the nearest doubles, and the next doubles are right; so is every claim that covers
/// them.
#[test]
fn the_records_are_right() {
    for record in records().iter().filter(|record| record.value.is_some()) {
        let value = record.decimal().unwrap();
        let exact = mark(record, &value.clone().into(), &Limits::default());
        assert_eq!(exact.verdict, Verdict::Right, "{}: {exact:?}", record.id);
        if !value.is_zero() {
            let lre = exact.lre.unwrap();
            assert!(lre.low > 48.0 && lre.high == f64::INFINITY, "{}: {lre:?}", record.id);
        }
        if record.status == Status::Ok {
            for double in [record.nearest(), record.nearest().next_up()] {
                let mark = mark(record, &double.into(), &Limits::default());
                assert!(mark.verdict == Verdict::Right && mark.status_matches, "{}: {mark:?}", record.id);
                assert!(mark.lre.unwrap().low > 15.0, "{}: {mark:?}", record.id);
            }
        }
    }
}

/// A relative error of 10^−k has k right digits; the excess loss is what is above u·condition.
#[test]
fn digits_and_excess_loss() {
    for k in 1..40 {
        let value: Decimal = record(PULL_OFF).unwrap().decimal().unwrap();
        // value·(1 + 10^−k), exactly.
        let step: Decimal = format!("{value}e-{k}").parse().unwrap();
        let mark = marked(PULL_OFF, &(&value + &step).into());
        let (lre, loss) = (mark.lre.unwrap(), mark.excess_loss.unwrap());
        let k = f64::from(k);
        assert!(lre.low <= k && k <= lre.high && lre.high - lre.low < 1e-8, "{k}: {lre:?}");
        let condition = record(PULL_OFF).unwrap().total_condition();
        let cost = (mdr_reference::UNIT_ROUNDOFF * condition).log10();
        assert!((loss.low + k + cost).abs() < 1e-6, "{k}: {loss:?}");
        let expected = match k as i32 {
            1..=12 => Verdict::Inaccurate,
            _ => Verdict::Right,
        };
        assert_eq!(mark.verdict, expected, "{k}");
    }
}

/// The judge knows half the last digit: it does not call an answer wrong that may be right.
#[test]
fn the_benefit_of_the_doubt_ends_at_the_radius() {
    let certified = record(PULL_OFF).unwrap().value.as_ref().unwrap();
    let [mid, rad]: [Decimal; 2] = [&certified.mid, &certified.rad].map(|text| text.parse().unwrap());
    let off = |factor: &str| {
        let step: Decimal = format!("{factor}{}", certified.rad.trim_start_matches('5')).parse().unwrap();
        let claim = r#""error":"0""#;
        line(&format!(r#"{{"id":"{PULL_OFF}","value":"{}",{claim}}}"#, &mid + &step))
    };
    assert_eq!(off("4.999").claim, Claim::Holds);
    assert_eq!(off("5.001").claim, Claim::TooSmall);
    assert!(!rad.is_zero());
}

#[test]
fn claims() {
    let claimed = |value: &str, error: &str| line(&format!(r#"{{"id":"{PULL_OFF}","value":{value},"error":{error}}}"#));
    let holds = claimed("-4.712", "1e-3");
    assert_eq!((holds.claim, holds.verdict), (Claim::Holds, Verdict::Right));
    let small = claimed("-4.712", "\"1e-4\"");
    assert_eq!((small.claim, small.verdict), (Claim::TooSmall, Verdict::Wrong));
    let large = claimed("-4.71238898038469", "0.1");
    assert_eq!((large.claim, large.verdict), (Claim::Overstated, Verdict::Inaccurate));
    // It would hold for any answer.
    let idle = claimed("7", "100");
    assert_eq!((idle.claim, idle.verdict), (Claim::Overstated, Verdict::Inaccurate));
    for error in ["NaN", "\"inf\""] {
        let line = format!(r#"{{"id":"{PULL_OFF}","value":1,"error":{error}}}"#);
        assert!(Answer::from_json(&line).unwrap_err().contains("finite"), "{error}");
    }
}

#[test]
fn what_a_wrong_convention_leaves_behind() {
    let hint = |factor: f64| marked(PULL_OFF, &(record(PULL_OFF).unwrap().nearest() * factor).into()).reason;
    assert!(hint(-1.0).contains("the other sign"));
    assert!(hint(2.0).contains("w = 2γ"));
    assert!(hint(4.0 / 3.0).contains("K = 4E*/3"));
    assert!(hint(5.0 / 9.0).contains("fixed grips"));
    assert!(hint(1e10).ends_with("no digit is right"));
    // A result flushed to zero in silence.
    assert_eq!(hint(0.0), "0 in place of a number of size 10^0.7");
}

#[test]
fn statuses() {
    let verdict = |json: &str| line(json).verdict;
    // Out of the range of doubles: to say so is right, and so is a number of another arithmetic.
    assert_eq!(record(OVERFLOW).unwrap().status, Status::Overflow);
    let answer = |rest: &str| verdict(&format!(r#"{{"id":"{OVERFLOW}",{rest}}}"#));
    assert_eq!(answer(r#""status":"overflow""#), Verdict::Right);
    assert_eq!(answer(r#""value":"inf","status":"overflow""#), Verdict::Right);
    assert_eq!(answer(r#""value":"inf""#), Verdict::Wrong);
    assert_eq!(answer(r#""value":0,"status":"underflow""#), Verdict::Wrong);
    assert_eq!(answer(r#""value":1.7976931348623157e308,"status":"overflow""#), Verdict::Wrong);
    let mid = &record(OVERFLOW).unwrap().value.as_ref().unwrap().mid;
    assert_eq!(answer(&format!(r#""value":"{mid}""#)), Verdict::Right);
    for below in records().iter().filter(|record| record.status == Status::Underflow) {
        let answer = |value: f64| marked(&below.id, &Answer::from(value).with_status(Status::Underflow));
        assert_eq!(answer(below.nearest()).verdict, Verdict::Right, "{}", below.id);
        assert_eq!(answer(0.0).verdict, Verdict::Right, "{}", below.id);
        assert_eq!(answer(42.0).verdict, Verdict::Wrong, "{}", below.id);
    }
    // There is a number: not to give it is wrong.
    for rest in [r#""status":"no-equilibrium""#, r#""value":NaN"#, r#""value":"nan""#, r#""value":null,"status":"ok""#]
    {
        assert_eq!(verdict(&format!(r#"{{"id":"{PULL_OFF}",{rest}}}"#)), Verdict::Wrong, "{rest}");
    }
}

/// Where there is no number, only the status is right.
#[test]
fn no_equilibrium() {
    let id = "equilibrium/jkr-unit/past=2^-40/outer/indentation/contact_radius";
    assert_eq!(marked(id, &Status::NoEquilibrium.into()).verdict, Verdict::Right);
    assert!(marked(id, &f64::NAN.into()).reason.starts_with("NaN"));
    assert!(marked(id, &0.7.into()).reason.starts_with("a number where there is none"));
    assert_eq!(marked(id, &Status::Overflow.into()).verdict, Verdict::Wrong);
}

/// Where the value is 0, errors count against the terms that cancel.
#[test]
fn an_exact_zero() {
    let id = "critical/n=1.5/force/indentation";
    assert_eq!(marked(id, &0.0.into()).verdict, Verdict::Right);
    assert_eq!(marked(id, &1e-16.into()).verdict, Verdict::Right);
    assert_eq!(marked(id, &1e-5.into()).verdict, Verdict::Inaccurate);
    assert_eq!(marked(id, &1.0.into()).verdict, Verdict::Wrong);
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
    let mut judge = Judge::new(records(), Limits::default());
    judge.read(&bytes[..]).unwrap();
    let report = judge.report();
    let malformed: Vec<_> = report.malformed.first.iter().map(|(line, _)| *line).collect();
    assert_eq!(malformed, [3, 4, 5, 6, 7, 8, 9, 13]);
    assert_eq!((report.unknown.count, report.unknown.first[0].0), (1, 10));
    assert_eq!((report.repeated.count, report.repeated.first[0].0), (1, 11));
    assert_eq!((report.answered(), report.passed()), (2, true));
    for line in report.to_json_lines().lines() {
        let value: serde_json::Value = serde_json::from_str(line).unwrap();
        assert_eq!(value["schema"], "mdr.judge/1");
    }
    let summary: serde_json::Value = serde_json::from_str(report.to_json_lines().lines().last().unwrap()).unwrap();
    assert_eq!((&summary["summary"]["answered"], &summary["summary"]["malformed"]), (&2.into(), &8.into()));
}

/// Lines that are made as they are read.
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
    let mut judge = Judge::new(records(), Limits::default());
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

/// A solver with one wrong convention: the report finds it, and knows where.
#[test]
fn a_solver_in_one_call() {
    let solver = |factor: f64| {
        judge(records(), move |question| {
            // Where the question costs all digits of a double, nothing is certainly wrong.
            let certain = question.status == Status::Ok && question.difficulty != Difficulty::Higher;
            (certain && question.formula == "critical" && question.quantity == "force")
                .then(|| (question.nearest() * factor).into())
        })
    };
    assert!(solver(1.0).passed());
    let wrong = solver(2.0);
    assert!(!wrong.passed() && wrong.count(Verdict::Wrong) == wrong.answered(), "{wrong}");
    assert!(wrong.to_string().contains("w = 2γ"));
    let none = judge(records(), |_| None);
    assert_eq!((none.answered(), none.passed()), (0, false));
}

/// Infinite ends of ranges become null: every line is JSON.
#[test]
fn an_empty_report_is_json() {
    let report = Judge::new(records(), Limits::default()).report();
    assert_eq!(report.to_json_lines().lines().count(), 1);
    assert!(serde_json::from_str::<serde_json::Value>(&report.to_json_lines()).is_ok());
    assert!(BufReader::new(&b""[..]).lines().next().is_none());
}
