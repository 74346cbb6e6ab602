//! The judge: right and wrong answers, by digits and by claims.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_reference::{Answer, Claim, Decimal, Difficulty, Limits, Mark, Status, Verdict, judge, mark, record, records};

const PULL_OFF: &str = "critical/jkr-unit/force/force";

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

/// A relative error of 10^−k has k correct digits; the excess loss is the part above u·condition.
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

/// The judge includes half a unit of the last digit: an answer that may be right is not wrong.
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
    // Such a claim would be true of any answer.
    let idle = claimed("-4.7", "100");
    assert_eq!((idle.claim, idle.verdict), (Claim::Overstated, Verdict::Inaccurate));
    for error in ["NaN", "\"inf\""] {
        let line = format!(r#"{{"id":"{PULL_OFF}","value":1,"error":{error}}}"#);
        assert!(Answer::from_json(&line).unwrap_err().contains("finite"), "{error}");
    }
}

/// A claim does not excuse a number without a correct digit, unless it is honest and below the size of the number.
#[test]
fn no_right_digit_is_wrong_whatever_is_claimed() {
    let value = record(PULL_OFF).unwrap().nearest();
    for factor in [-1.0_f64, -1e-300, 0.0, 1e-9, 0.3, 1.7, 2.0, 77.0, 1e300] {
        // From the least true claim to far beyond.
        let error = value.abs() * (factor - 1.0).abs();
        for claim in [error * 1.000_001, error * 10.0, error + 10.0, error + 1e200, f64::MAX] {
            let answer = Answer::from(value * factor).with_error(claim).unwrap();
            let mark = marked(PULL_OFF, &answer);
            let honest = claim < value.abs() && claim < (value * factor).abs();
            let expected = if honest { (Verdict::Right, Claim::Holds) } else { (Verdict::Wrong, Claim::Overstated) };
            assert_eq!((mark.verdict, mark.claim), expected, "{factor} ± {claim}: {}", mark.reason);
        }
    }
    // If the value is exactly 0, a claim is relative to the terms that cancel.
    let zero = "critical/n=1.5/force/indentation";
    let verdict = |value: f64, claim: f64| marked(zero, &Answer::from(value).with_error(claim).unwrap()).verdict;
    assert_eq!(
        [verdict(1e-16, 2e-16), verdict(0.0, 1e-16), verdict(-7.0, 1e9)],
        [Verdict::Right, Verdict::Right, Verdict::Wrong]
    );
}

#[test]
fn a_key_is_given_once() {
    for (line, key) in [
        (r#"{"id":"x","value":1,"value":2}"#, "value"),
        (r#"{"id":"x","value":2,"id":"x"}"#, "id"),
        (r#"{"error":1,"id":"x","value":1,"error":1}"#, "error"),
        (r#"{"id":"x","status":"ok","value":1,"status":null}"#, "status"),
        (r#"{"id":"x","value":1,"note":1,"n\u006fte":2}"#, "note"),
    ] {
        assert_eq!(Answer::from_json(line).unwrap_err(), format!("\"{key}\" is given more than once"), "{line}");
    }
    assert!(Answer::from_json(r#"{"id":"x","value":1,"note":{"a":1,"b":1},"more":{"a":1}}"#).is_ok());
}

#[test]
fn what_a_wrong_convention_leaves_behind() {
    let hint = |factor: f64| marked(PULL_OFF, &(record(PULL_OFF).unwrap().nearest() * factor).into()).reason;
    assert!(hint(-1.0).contains("the other sign"));
    assert!(hint(2.0).contains("w = 2γ"));
    assert!(hint(4.0 / 3.0).contains("K = 4E*/3"));
    assert!(hint(5.0 / 9.0).contains("fixed grips"));
    assert!(hint(1e10).ends_with("no digit is right"));
    // An unmarked underflow to zero.
    assert_eq!(hint(0.0), "0 in place of a number of size 10^0.7");
}

/// If the value is 0, errors are relative to the terms that cancel.
#[test]
fn an_exact_zero() {
    let id = "critical/n=1.5/force/indentation";
    assert_eq!(marked(id, &0.0.into()).verdict, Verdict::Right);
    assert_eq!(marked(id, &1e-16.into()).verdict, Verdict::Right);
    assert_eq!(marked(id, &1e-5.into()).verdict, Verdict::Inaccurate);
    assert_eq!(marked(id, &1.0.into()).verdict, Verdict::Wrong);
}

/// A solver with one wrong convention: the report finds it and its location.
#[test]
fn a_solver_in_one_call() {
    let solver = |factor: f64| {
        judge(records(), move |question| {
            // If the question costs all digits of a double, nothing is certainly wrong.
            let certain = question.status == Status::Ok && question.difficulty != Difficulty::Higher;
            (certain && question.formula == "critical" && question.quantity == "force")
                .then(|| (question.nearest() * factor).into())
        })
    };
    assert!(solver(1.0).passed());
    let wrong = solver(2.0);
    assert!(!wrong.passed() && wrong.count(Verdict::Wrong) == wrong.answered(), "{wrong}");
    assert!(wrong.to_string().contains("w = 2γ"));
}

/// However many digits may be lost, an answer without any is wrong.
#[test]
fn no_limit_makes_nonsense_right() {
    let verdict = |value: f64, excess_loss: f64| {
        mark(record(PULL_OFF).unwrap(), &value.into(), &Limits { excess_loss, ..Limits::default() }).verdict
    };
    for limit in [20.0, f64::INFINITY] {
        assert_eq!([verdict(77.0, limit), verdict(-4.7, limit)], [Verdict::Wrong, Verdict::Right], "{limit}");
    }
    assert_eq!([verdict(77.0, f64::NAN), verdict(-4.7, f64::NAN)], [Verdict::Wrong, Verdict::Inaccurate]);
    assert_eq!(verdict(-4.712_388_980_384_69, 1.0), Verdict::Right);
    let no_limit = Limits { overstatement: f64::NAN, ..Limits::default() };
    let claim = Answer::from(-4.712).with_error(0.001).unwrap();
    assert_eq!(mark(record(PULL_OFF).unwrap(), &claim, &no_limit).claim, Claim::Overstated);
}

#[test]
fn a_claim_must_be_one() {
    for error in [-0.5, f64::NAN, f64::INFINITY] {
        let refused = Answer::from(1.0).with_error(error).unwrap_err().to_string();
        assert!(refused.contains("finite and not negative") && refused.contains(&error.to_string()), "{refused}");
    }
    assert!(Answer::from(1.0).with_error(0.0).is_ok());
}

/// Beyond the digits of the records an answer may be exact: the upper bound of the loss is known nevertheless.
#[test]
fn a_class_of_exact_answers_has_a_bound() {
    let report = judge(records(), |question| {
        (question.status == Status::Ok && question.log10.is_some()).then(|| question.decimal().unwrap().into())
    });
    for class in report.classes() {
        let (median, largest) = class.excess_loss.unwrap();
        assert!(-40.0 < median && median <= largest && largest < -25.0, "{class:?}");
        assert!(!class.cells().contains(&"exact".to_owned()), "{class:?}");
    }
}

/// Of wrong answers those about real contacts come first, however far the others are off; and they are counted.
#[test]
fn real_contacts_first() {
    let questions = records().iter().filter(|record| record.formula == "critical" && record.status == Status::Ok);
    let far = |record: &mdr_reference::Record| if record.is_physical() { 2.0 } else { 1e6 };
    let report = judge(questions, |record| Some(Answer::from(record.nearest() * far(record))));
    let physical: Vec<bool> = report.judged.iter().map(|judged| judged.record.is_physical()).collect();
    let [right, inaccurate, wrong] = report.physical();
    assert_eq!((right, inaccurate + wrong), (0, physical.iter().filter(|physical| **physical).count()));
    assert!(wrong > 10 && physical[..wrong].iter().all(|physical| *physical) && !physical[wrong], "{physical:?}");
    assert!(report.to_string().contains(&format!("of real contacts: 0 right, {inaccurate} inaccurate, {wrong} wrong")));
    assert!(report.to_json_lines().contains(&format!("\"physical\":[0,{inaccurate},{wrong}]")));
    let filter: mdr_reference::Filter = "flag=physical".parse().unwrap();
    for name in ["afm-tip", "pdms-bead", "gecko-spatula", "glass-bead", "wheel-on-rail"] {
        assert!(filter.select().any(|record| record.id.contains(name)), "{name}");
    }
    assert!(filter.select().all(|record| !record.id.contains("unit")));
}
