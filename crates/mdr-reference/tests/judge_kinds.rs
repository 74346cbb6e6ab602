//! The judge: the kinds of answers against the kinds of records.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_reference::{Answer, Claim, Decimal, Limits, Mark, Record, Status, Verdict, judge, mark, record, records};

const NUMBER: &str = "critical/jkr-unit/force/force";
const OVERFLOW: &str = "critical/half+2^-13/force/contact_radius";
const NOTHING: &str = "equilibrium/jkr-unit/past=2^-1/outer/indentation/contact_radius";
const FOLD: &str = "equilibrium/jkr-unit/tau=0/outer/indentation/contact_radius";

/// The judgement of the answer with these fields.
fn answered(id: &str, fields: &str) -> Mark {
    let (id, answer) = Answer::from_json(&format!(r#"{{"id":"{id}",{fields}}}"#)).unwrap();
    mark(record(&id).unwrap(), &answer, &Limits::default())
}

fn verdicts<const N: usize>(id: &str, fields: [&str; N]) -> [Verdict; N] {
    fields.map(|fields| answered(id, fields).verdict)
}

use Verdict::{Inaccurate, Right, Wrong};

#[test]
fn a_number_is_right_by_its_digits_alone() {
    assert_eq!(record(NUMBER).unwrap().status, Status::Ok);
    let right = ["\"value\":-4.71238898038469", "\"value\":-4.71238898038469,\"status\":\"ok\""];
    assert_eq!(verdicts(NUMBER, right), [Right; 2]);
    let missing = ["\"status\":\"ok\"", "\"value\":null,\"status\":\"ok\""];
    assert_eq!(verdicts(NUMBER, missing), [Wrong; 2]);
    assert_eq!(answered(NUMBER, missing[0]).reason, "the number is missing");
    let others = [
        "\"status\":\"no-equilibrium\"",
        "\"value\":-4.71238898038469,\"status\":\"no-equilibrium\"",
        "\"value\":-4.71238898038469,\"status\":\"fold\"",
        "\"value\":-inf",
        "\"value\":nan",
    ];
    assert_eq!(verdicts(NUMBER, others), [Wrong; 5]);
    assert_eq!(answered(NUMBER, "\"value\":nan").reason, "NaN in place of a number of size 10^0.7");
}

/// An answer that only reports the double root is not false, and not complete.
#[test]
fn a_fold_has_its_number() {
    let value = record(FOLD).unwrap().nearest();
    let found = answered(FOLD, "\"status\":\"fold\"");
    assert_eq!((found.verdict, found.status_matches), (Inaccurate, true));
    assert!(found.reason.starts_with("the number is missing"), "{}", found.reason);
    let full = [format!("\"value\":{value},\"status\":\"fold\""), format!("\"value\":{value}")];
    assert_eq!(verdicts(FOLD, full.each_ref().map(String::as_str)), [Right; 2]);
    assert_eq!(verdicts(FOLD, ["\"value\":7,\"status\":\"fold\"", "\"status\":\"ok\""]), [Wrong; 2]);
}

/// A number beyond the largest double: an infinity or the status reports it; another arithmetic may have the number.
#[test]
fn overflow() {
    assert_eq!(record(OVERFLOW).unwrap().status, Status::Overflow);
    let mid = format!("\"value\":\"{}\"", record(OVERFLOW).unwrap().value.as_ref().unwrap().mid);
    let marked = format!("{mid},\"status\":\"overflow\"");
    let right =
        ["\"status\":\"overflow\"", "\"value\":inf,\"status\":\"overflow\"", "\"value\":\"1.#INF\"", &mid, &marked];
    assert_eq!(verdicts(OVERFLOW, right), [Right; 5]);
    let wrong = [
        "\"value\":\"nan\",\"status\":\"overflow\"",
        "\"value\":\"-inf\",\"status\":\"overflow\"",
        "\"value\":\"-inf\"",
        "\"value\":inf,\"error\":1",
        "\"value\":1.7976931348623157e308,\"status\":\"overflow\"",
        "\"value\":0,\"status\":\"underflow\"",
        "\"status\":\"ok\"",
    ];
    assert_eq!(verdicts(OVERFLOW, wrong), [Wrong; 7]);
    assert_eq!(answered(OVERFLOW, "\"value\":-inf").reason, "an infinity of the other sign");
    let below_zero = records().iter().find(|r| r.status == Status::Overflow && r.nearest() < 0.0).unwrap();
    assert_eq!(verdicts(&below_zero.id, ["\"value\":-inf", "\"value\":inf"]), [Right, Wrong]);
}

/// A number below the smallest normal double: the result of double precision is right with the status. Without it, the
/// reason contains the remedy.
#[test]
fn underflow() {
    let below: Vec<&Record> = records().iter().filter(|record| record.status == Status::Underflow).collect();
    assert!(below.len() > 10);
    for record in below {
        let verdict = |answer: Answer| mark(record, &answer, &Limits::default()).verdict;
        let left = Answer::from(record.nearest()).with_status(Status::Underflow);
        assert_eq!(verdict(left.clone()), Right, "{}", record.id);
        assert_eq!(verdict(left.with_error(f64::MIN_POSITIVE).unwrap()), Right, "{}", record.id);
        let zero = Answer::from(0.0).with_status(Status::Underflow);
        assert_eq!(verdict(zero.clone()), Right, "{}", record.id);
        for shortest in [format!("{:e}", record.nearest()), format!("{:.15e}", record.nearest())] {
            let shortest: Decimal = shortest.parse().unwrap();
            assert_eq!(verdict(Answer::from(shortest).with_status(Status::Underflow)), Right, "{}", record.id);
        }
        for beyond in [1e-300, 1e300] {
            let claim = mark(record, &zero.clone().with_error(beyond).unwrap(), &Limits::default());
            assert_eq!((claim.verdict, claim.claim), (Inaccurate, Claim::Overstated), "{}", record.id);
        }
        let exact = mark(record, &zero.with_error(0.0).unwrap(), &Limits::default());
        assert_eq!((exact.verdict, exact.claim), (Wrong, Claim::TooSmall), "{}", record.id);
        assert_eq!(verdict(Status::Underflow.into()), Right, "{}", record.id);
        let huge: Decimal = "1e400".parse().unwrap();
        assert_eq!(verdict(Answer::from(huge).with_status(Status::Underflow)), Wrong, "{}", record.id);
        for nonsense in [42.0, f64::NAN, f64::INFINITY] {
            assert_eq!(verdict(Answer::from(nonsense).with_status(Status::Underflow)), Wrong, "{}", record.id);
        }
        let silent = mark(record, &0.0.into(), &Limits::default());
        assert_eq!(silent.verdict, Wrong, "{}", record.id);
        assert!(silent.reason.ends_with("mark it underflow"), "{}", silent.reason);
    }
}

/// The smallest double counts as itself, in hexadecimal and in the shortest decimal.
#[test]
fn a_subnormal_double_in_any_notation() {
    for value in ["\"0x1p-1074\"", "5e-324", "4.940656458412466e-324", "4.9406564584124654e-324"] {
        let mark = answered(
            "critical/cusp-1e-100/indentation/contact_radius",
            &format!("\"status\":\"underflow\",\"value\":{value}"),
        );
        assert_eq!(mark.verdict, Right, "{value}: {}", mark.reason);
    }
}

/// Without a number only the status of the record is right.
#[test]
fn no_number() {
    assert_eq!(record(NOTHING).unwrap().status, Status::NoEquilibrium);
    assert_eq!(answered(NOTHING, "\"status\":\"no-equilibrium\"").verdict, Right);
    let wrong = [
        "\"value\":12345,\"status\":\"no-equilibrium\"",
        "\"value\":nan,\"status\":\"no-equilibrium\"",
        "\"value\":inf,\"status\":\"no-equilibrium\"",
        "\"value\":0.7",
        "\"value\":nan",
        "\"value\":-inf",
        "\"status\":\"overflow\"",
        "\"status\":\"ok\"",
    ];
    assert_eq!(verdicts(NOTHING, wrong), [Wrong; 8]);
    for (fields, reason) in [
        (wrong[0], "a number where there is none: no-equilibrium"),
        (wrong[1], "NaN beside no-equilibrium: leave the value out"),
        (wrong[4], "NaN instead of the status no-equilibrium"),
        (wrong[6], "overflow where the status is no-equilibrium"),
        (wrong[7], "neither a number nor the status no-equilibrium"),
    ] {
        assert_eq!(answered(NOTHING, fields).reason, reason);
    }
}

/// A record of another author whose radius is not a number proves nothing.
#[test]
fn a_record_without_a_radius() {
    let mut own = record(NUMBER).unwrap().clone();
    own.value.as_mut().unwrap().rad = "x".to_owned();
    let mark = mark(&own, &own.nearest().into(), &Limits::default());
    assert_eq!((mark.verdict, mark.reason.as_str()), (Wrong, "the record has no readable radius"));
}

/// Correctly rounded doubles: infinities pass, zeros that are not exact do not, and the reason contains the remedy.
#[test]
fn a_perfect_solver_in_double_precision() {
    let solve = |marks: bool| {
        judge(records(), move |question| match question.status {
            Status::NoEquilibrium | Status::DomainError | Status::NotAdmissible => Some(question.status.into()),
            Status::Underflow if marks => Some(Answer::from(question.nearest()).with_status(Status::Underflow)),
            _ => Some(question.nearest().into()),
        })
    };
    let report = solve(true);
    assert!(report.passed(), "{report}");
    let silent = solve(false);
    for judged in silent.judged.iter().filter(|judged| judged.mark.verdict != Right) {
        assert_eq!(judged.record.status, Status::Underflow, "{}", judged.record.id);
        assert!(judged.mark.reason.ends_with("mark it underflow"), "{}", judged.mark.reason);
    }
    assert!(silent.count(Wrong) > 10);
}
