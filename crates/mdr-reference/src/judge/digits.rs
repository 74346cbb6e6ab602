//! The correct digits of an answer, and their judgement.

use crate::decimal::Decimal;
use crate::judge::mark::{Claim, Limits, Mark, Range, Verdict};
use crate::record::{Record, UNIT_ROUNDOFF};

/// Compares a finite number with a certified one. No answer satisfies a limit that is NaN.
pub(crate) fn compared(
    record: &Record,
    value: &Decimal,
    mid: &Decimal,
    claim: Option<&Decimal>,
    limits: &Limits,
) -> Mark {
    let Some(rad) = record.radius() else { return Mark::of(Verdict::Wrong, "the record has no readable radius") };
    let distance = (value - mid).abs();
    let (most, least) = (&distance + &rad, (&distance - &rad).max(Decimal::default()));
    let scale = match record.scale.as_deref().and_then(|text| text.parse::<Decimal>().ok()) {
        Some(scale) if mid.is_zero() => scale,
        _ => mid.clone(),
    };
    let lre = outward(scale.log10() - most.log10(), scale.log10() - least.log10());
    let cost = (UNIT_ROUNDOFF * record.total_condition().max(1.0)).log10();
    let excess_loss = outward(-lre.high - cost, -lre.low - cost);
    let claim = claim.map_or(Claim::None, |claim| {
        let slack = limits.overstatement + most.log10().max(scale.log10() + cost);
        let as_large = *claim >= scale.abs() || !mid.is_zero() && *claim >= value.abs();
        let says_nothing = cost < 0.0 && as_large;
        if least > *claim {
            Claim::TooSmall
        } else if says_nothing || !(claim.log10() <= slack) {
            Claim::Overstated
        } else {
            Claim::Holds
        }
    });
    let lost = !(excess_loss.low <= limits.excess_loss);
    let hopeless = !(excess_loss.low <= limits.excess_loss.min(Limits::default().excess_loss)) && lre.high < 1.0;
    let (verdict, reason) = match claim {
        Claim::TooSmall => (Verdict::Wrong, "further off than it claims".to_owned()),
        Claim::Holds => (Verdict::Right, String::new()),
        Claim::Overstated if hopeless => {
            (Verdict::Wrong, no_digit(value, mid) + ", and the claimed error says nothing")
        }
        Claim::Overstated => (Verdict::Inaccurate, OVERSTATED.to_owned()),
        Claim::None if hopeless => (Verdict::Wrong, no_digit(value, mid)),
        Claim::None if lost => (Verdict::Inaccurate, "more digits lost than the question costs".to_owned()),
        Claim::None => (Verdict::Right, String::new()),
    };
    Mark { verdict, reason, status_matches: false, lre: Some(lre), excess_loss: Some(excess_loss), claim }
}

/// Why an answer with an overstated claim is inaccurate.
pub(crate) const OVERSTATED: &str = "the claimed error is overstated";

/// A range, widened by the error of logarithms of doubles.
fn outward(low: f64, high: f64) -> Range {
    let slack = |x: f64| if x.is_finite() { 1e-12 + 1e-14 * x.abs() } else { 0.0 };
    Range { low: low - slack(low), high: high + slack(high) }
}

/// A wrong number, with the factor of the error if it is a known one.
fn no_digit(value: &Decimal, mid: &Decimal) -> String {
    let ratio = 10_f64.powf(value.log10() - mid.log10());
    let sign = if (*value < Decimal::default()) == (*mid < Decimal::default()) { 1.0 } else { -1.0 };
    if value.is_zero() && !mid.is_zero() {
        return format!("0 in place of a number of size 10^{:.1}", mid.log10());
    }
    if mid.is_zero() || !(1e-3..1e3).contains(&ratio) {
        return "no digit is right".to_owned();
    }
    let factor = sign * ratio;
    let hint = KNOWN.iter().find(|(known, _)| (factor / known - 1.0).abs() < 1e-4).map(|(_, hint)| hint);
    let hint = hint.map(|hint| format!(" ({hint})")).unwrap_or_default();
    format!("no digit is right: {factor:.6} times the certified value{hint}")
}

/// Factors that result from a wrong convention.
const KNOWN: [(f64, &str); 7] = [
    (-1.0, "the other sign"),
    (2.0, "w = 2γ?"),
    (0.5, "w = 2γ?"),
    (4.0 / 3.0, "K = 4E*/3, or −2πwR of a rigid sphere?"),
    (0.75, "K = 4E*/3?"),
    (5.0 / 9.0, "fixed grips, or a dead load?"),
    (1.8, "fixed grips, or a dead load?"),
];
