//! One answer against one record.

use crate::decimal::Decimal;
use crate::judge::answer::{Answer, Number};
use crate::record::{Record, Status, UNIT_ROUNDOFF};

/// What is thought of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// Within what it claims; or it claims nothing, and is as good as the question allows in double precision, but for
    /// the digits of [`Limits::excess_loss`].
    Right,
    /// Claims nothing, and has lost more digits than the question costs; or its claim holds because it is overstated.
    Inaccurate,
    /// Further off than it claims, without a single right digit that the question would have left, or not the kind of
    /// answer that there is.
    Wrong,
}

impl Verdict {
    /// In a word.
    pub const fn name(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Inaccurate => "inaccurate",
            Verdict::Wrong => "wrong",
        }
    }
}

/// What is thought of a claimed error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Claim {
    /// There is none.
    None,
    /// The true error is not larger.
    Holds,
    /// The true error is certainly larger.
    TooSmall,
    /// It holds, but is larger than the true error and than what double precision costs, by more than
    /// [`Limits::overstatement`]; or as large as the value, where the question leaves a digit.
    Overstated,
}

impl Claim {
    /// In a word or two.
    pub const fn name(self) -> &'static str {
        match self {
            Claim::None => "none",
            Claim::Holds => "holds",
            Claim::TooSmall => "too-small",
            Claim::Overstated => "overstated",
        }
    }
}

/// Where the judge draws its lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The decimal digits that an answer without a claim may lose beyond what the question costs in double precision.
    pub excess_loss: f64,
    /// The decades by which a claim may exceed the true error.
    pub overstatement: f64,
}

impl Default for Limits {
    /// Three digits, six decades.
    fn default() -> Self {
        Limits { excess_loss: 3.0, overstatement: 6.0 }
    }
}

/// A number known to lie between two bounds, one of which may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// From.
    pub low: f64,
    /// To.
    pub high: f64,
}

/// The judgement of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The verdict.
    pub verdict: Verdict,
    /// Why, if the verdict is not `Right`.
    pub reason: String,
    /// Whether the answer is marked as the record is.
    pub status_matches: bool,
    /// The log relative error −log₁₀(|value − certified|/|certified|), the number of right digits; ∞ at the upper end
    /// where the answer may be exact. None where there are no two numbers to compare.
    pub lre: Option<Range>,
    /// The excess loss log₁₀(relative error/(u·max(1, condition))) with u = 2⁻⁵³: the digits lost to the algorithm. At
    /// about 0 or below, the question is to blame for the error, not the algorithm.
    pub excess_loss: Option<Range>,
    /// The claimed error.
    pub claim: Claim,
}

impl Mark {
    /// For the order of a report: worst first.
    pub(crate) fn badness(&self) -> (Verdict, f64) {
        (self.verdict, self.excess_loss.map_or(f64::INFINITY, |loss| loss.low.max(-1e9)))
    }
}

/// Judges an answer to the question of a record.
///
/// ```
/// use mdr_reference::{Answer, Limits, Verdict, mark, record};
/// let question = record("critical/jkr-unit/force/force").expect("a record");
/// // −(3/2)πwR, once in full and once to four digits with an honest error.
/// let exact: Answer = (-1.5 * std::f64::consts::PI).into();
/// assert_eq!(mark(question, &exact, &Limits::default()).verdict, Verdict::Right);
/// let rough = Answer::from(-4.712).with_error(0.001);
/// assert_eq!(mark(question, &rough, &Limits::default()).verdict, Verdict::Right);
/// // −2πwR is Bradley's answer, not that of Johnson, Kendall and Roberts.
/// let other: Answer = (-2.0 * std::f64::consts::PI).into();
/// assert_eq!(mark(question, &other, &Limits::default()).verdict, Verdict::Wrong);
/// ```
pub fn mark(record: &Record, answer: &Answer, limits: &Limits) -> Mark {
    let status = answer.status.unwrap_or(Status::Ok);
    let matches = status == record.status;
    let verdict = |verdict, reason: String| Mark {
        verdict,
        reason,
        status_matches: matches,
        lre: None,
        excess_loss: None,
        claim: Claim::None,
    };
    match (&answer.value, record.decimal()) {
        (Some(left), Some(mid)) if matches && is_left_of(left, &mid, status) => verdict(Verdict::Right, String::new()),
        (Some(Number::Finite(value)), Some(mid)) => {
            let mark = number(record, value, &mid, answer.error.as_ref(), limits);
            let mark = Mark { status_matches: matches, ..mark };
            if matches || status == Status::Ok {
                mark
            } else {
                let reason = format!("a number marked {status} where the status is {}", record.status);
                Mark { verdict: Verdict::Wrong, reason, ..mark }
            }
        }
        (Some(Number::NotFinite), Some(_)) => verdict(Verdict::Wrong, "not a finite number".to_owned()),
        (Some(Number::NotFinite), None) if status == Status::Ok => {
            verdict(Verdict::Wrong, format!("NaN or an infinity instead of the status {}", record.status))
        }
        (Some(_), None) if status == Status::Ok => {
            verdict(Verdict::Wrong, format!("a number where there is none: {}", record.status))
        }
        _ if matches && status != Status::Ok => verdict(Verdict::Right, String::new()),
        _ => verdict(Verdict::Wrong, format!("{status} where the status is {}", record.status)),
    }
}

/// Whether this is what double precision leaves of a number out of its range: an infinity; 0, or the nearest subnormal
/// double.
fn is_left_of(value: &Number, mid: &Decimal, status: Status) -> bool {
    match (status, value) {
        (Status::Overflow, Number::NotFinite) => true,
        (Status::Underflow, Number::Finite(value)) => {
            value.is_zero() || (value - mid).abs() <= Decimal::from_double(f64::from_bits(1))
        }
        _ => false,
    }
}

/// A finite number against a certified one.
fn number(record: &Record, value: &Decimal, mid: &Decimal, claim: Option<&Decimal>, limits: &Limits) -> Mark {
    let rad = record.value.as_ref().and_then(|value| value.rad.parse().ok()).unwrap_or_default();
    let distance = (value - mid).abs();
    let (most, least) = (&distance + &rad, &distance - &rad);
    let least = if least < Decimal::default() { Decimal::default() } else { least };
    let scale = match record.scale.as_deref().and_then(|text| text.parse::<Decimal>().ok()) {
        Some(scale) if mid.is_zero() => scale,
        _ => mid.clone(),
    };
    let lre = outward(scale.log10() - most.log10(), scale.log10() - least.log10());
    let cost = (UNIT_ROUNDOFF * record.total_condition().max(1.0)).log10();
    let excess_loss = outward(-lre.high - cost, -lre.low - cost);
    let claim = claim.map_or(Claim::None, |claim| {
        let slack = limits.overstatement + most.log10().max(scale.log10() + cost);
        let says_nothing = cost < 0.0 && *claim >= scale.abs();
        if least > *claim {
            Claim::TooSmall
        } else if says_nothing || claim.log10() > slack {
            Claim::Overstated
        } else {
            Claim::Holds
        }
    });
    let lost = excess_loss.low > limits.excess_loss;
    let (verdict, reason) = match claim {
        Claim::TooSmall => (Verdict::Wrong, "further off than it claims".to_owned()),
        Claim::Holds => (Verdict::Right, String::new()),
        Claim::Overstated => (Verdict::Inaccurate, "the claimed error is overstated".to_owned()),
        Claim::None if lost && lre.high < 1.0 => (Verdict::Wrong, no_digit(value, mid)),
        Claim::None if lost => (Verdict::Inaccurate, "more digits lost than the question costs".to_owned()),
        Claim::None => (Verdict::Right, String::new()),
    };
    Mark { verdict, reason, status_matches: true, lre: Some(lre), excess_loss: Some(excess_loss), claim }
}

/// A range, widened by what logarithms of doubles may err.
fn outward(low: f64, high: f64) -> Range {
    let slack = |x: f64| if x.is_finite() { 1e-12 + 1e-14 * x.abs() } else { 0.0 };
    Range { low: low - slack(low), high: high + slack(high) }
}

/// A wrong number, with the factor by which it is wrong where that tells something.
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

/// Factors that a mistaken convention leaves behind.
const KNOWN: [(f64, &str); 7] = [
    (-1.0, "the other sign"),
    (2.0, "w = 2γ?"),
    (0.5, "w = 2γ?"),
    (4.0 / 3.0, "K = 4E*/3, or −2πwR of a rigid sphere?"),
    (0.75, "K = 4E*/3?"),
    (5.0 / 9.0, "fixed grips, or a dead load?"),
    (1.8, "fixed grips, or a dead load?"),
];
