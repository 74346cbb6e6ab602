//! One answer against one record.

use crate::decimal::Decimal;
use crate::judge::answer::Answer;
use crate::judge::digits::{OVERSTATED, compared};
use crate::named::named;
use crate::number::Number;
use crate::record::{Record, Status};

named! {
    /// The verdict on an answer.
    pub enum Verdict {
        /// Within its claimed error; or without a claim, and as accurate as the question allows in double precision, apart
        /// from the digits of [`Limits::excess_loss`].
        Right = "right",
        /// Without a claim, and with a larger loss of digits than the question causes; or its claim is true because it is
        /// overstated, though a digit is correct; or it reports a double root without its number.
        Inaccurate = "inaccurate",
        /// Less accurate than it claims; without a single correct digit although the question leaves one, whatever it
        /// claims, unless that is an honest error below its own size; or not the required kind of answer: [`mark`] has the
        /// table.
        Wrong = "wrong",
    }
}

named! {
    /// The verdict on a claimed error.
    pub enum Claim {
        /// There is no claim.
        None = "none",
        /// The true error is not larger.
        Holds = "holds",
        /// The true error is certainly larger.
        TooSmall = "too-small",
        /// The claim is true, but exceeds the true error and the loss of double precision by more than
        /// [`Limits::overstatement`]; or it is as large as the value, that of the answer or the certified one, although the
        /// question leaves a digit.
        Overstated = "overstated",
    }
}

/// The limits of the judge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The decimal digits that an answer without a claim may lose beyond the loss that the question causes in double
    /// precision. An answer without a correct digit is wrong at three of them at the latest.
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
    /// The lower bound.
    pub low: f64,
    /// The upper bound.
    pub high: f64,
}

/// The judgement of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The verdict.
    pub verdict: Verdict,
    /// The reason, if the verdict is not `Right`.
    pub reason: String,
    /// Whether the answer has the status of the record.
    pub status_matches: bool,
    /// The log relative error −log₁₀(|value − certified|/|certified|), the number of correct digits; ∞ at the upper end
    /// if the answer may be exact. `None` if there are no two numbers to compare.
    pub lre: Option<Range>,
    /// The excess loss log₁₀(relative error/(u·max(1, condition))) with u = 2⁻⁵³: the digits lost by the algorithm. At
    /// about 0 or below, the error is that of the condition of the question.
    pub excess_loss: Option<Range>,
    /// The claimed error.
    pub claim: Claim,
}

impl Mark {
    /// A mark without numbers to compare.
    pub(crate) fn of(verdict: Verdict, reason: impl Into<String>) -> Self {
        let (reason, claim) = (reason.into(), Claim::None);
        Mark { verdict, reason, status_matches: false, lre: None, excess_loss: None, claim }
    }
}

/// Judges an answer to the question of a record, by the kinds of both:
///
/// | answer | a number, `ok` or `fold` | `overflow` | `underflow` | no number |
/// |---|---|---|---|---|
/// | a number | by its digits | by its digits | by its digits, 0 wrong; if marked, right where it is 0 or next to the nearest double | wrong |
/// | ±∞ | wrong | right if the sign is | wrong | wrong |
/// | NaN | wrong | wrong | wrong | wrong |
/// | none, the status of the record | wrong; a `fold` is inaccurate | right | right | right |
/// | none, the status `ok` | wrong | wrong | wrong | wrong |
///
/// An answer without a status, or with `ok`, is judged by its value alone. Any other status than that of the record is
/// wrong.
///
/// ```
/// use mdr_reference::{Answer, Limits, Verdict, mark, record};
/// let question = record("critical/jkr-unit/force/force").expect("a record");
/// // −(3/2)πwR, once in full and once to four digits with an honest error.
/// let exact: Answer = (-1.5 * std::f64::consts::PI).into();
/// assert_eq!(mark(question, &exact, &Limits::default()).verdict, Verdict::Right);
/// let rough = Answer::from(-4.712).with_error(0.001)?;
/// assert_eq!(mark(question, &rough, &Limits::default()).verdict, Verdict::Right);
/// // −2πwR is Bradley's answer, not that of Johnson, Kendall and Roberts.
/// let other: Answer = (-2.0 * std::f64::consts::PI).into();
/// assert_eq!(mark(question, &other, &Limits::default()).verdict, Verdict::Wrong);
/// # Ok::<(), mdr_reference::ClaimError>(())
/// ```
pub fn mark(record: &Record, answer: &Answer, limits: &Limits) -> Mark {
    let status = answer.status.unwrap_or(Status::Ok);
    let marked = status == record.status;
    let compared = |value: &Decimal, mid: &Decimal| compared(record, value, mid, answer.error.as_ref(), limits);
    let judgement = match (&answer.value, record.decimal(), record.status) {
        (None, _, asked) => without_value(marked, asked),
        (Some(Number::Finite(value)), Some(mid), Status::Underflow) => {
            below_range(value, &mid, marked, answer.error.as_ref(), compared(value, &mid))
        }
        (Some(Number::Finite(value)), Some(mid), _) => compared(value, &mid),
        (Some(Number::Finite(_)), None, asked) => wrong(format!("a number where there is none: {asked}")),
        (Some(Number::Infinite { negative }), Some(mid), Status::Overflow) => {
            beyond_range(*negative, &mid, answer.error.is_some())
        }
        (Some(Number::Infinite { .. }), Some(mid), _) => instead_of("an infinity", &mid),
        (Some(Number::Infinite { .. }), None, asked) => wrong(format!("an infinity where there is no number: {asked}")),
        (Some(Number::Nan), Some(mid), _) => instead_of("NaN", &mid),
        (Some(Number::Nan), None, _) if marked => wrong(format!("NaN beside {status}: leave the value out")),
        (Some(Number::Nan), None, asked) => wrong(format!("NaN instead of the status {asked}")),
    };
    if marked || status == Status::Ok {
        Mark { status_matches: marked, ..judgement }
    } else {
        let reason = format!("{status} where the status is {}", record.status);
        Mark { verdict: Verdict::Wrong, reason, ..judgement }
    }
}

fn wrong(reason: impl Into<String>) -> Mark {
    Mark::of(Verdict::Wrong, reason)
}

/// The mark of an answer that is not a number where one is required.
fn instead_of(what: &str, mid: &Decimal) -> Mark {
    let number = if mid.is_zero() { "0".to_owned() } else { format!("a number of size 10^{:.1}", mid.log10()) };
    wrong(format!("{what} in place of {number}"))
}

/// A status alone, `ok` if it is not that of the record.
fn without_value(marked: bool, asked: Status) -> Mark {
    match (marked, asked) {
        (_, Status::Ok) | (false, Status::Fold) => wrong("the number is missing"),
        (false, _) => wrong(format!("neither a number nor the status {asked}")),
        (true, Status::Fold) => Mark::of(Verdict::Inaccurate, "the number is missing: a double root has one"),
        (true, _) => Mark::of(Verdict::Right, ""),
    }
}

/// An infinity for a number beyond the largest double; it needs no status.
fn beyond_range(negative: bool, mid: &Decimal, claims: bool) -> Mark {
    if negative != mid.is_negative() {
        wrong("an infinity of the other sign")
    } else if claims {
        Mark { claim: Claim::TooSmall, ..wrong("an infinity with a finite claimed error") }
    } else {
        Mark::of(Verdict::Right, "")
    }
}

/// The remedy for a number below the range.
const REMEDY: &str = "; mark it underflow";

/// A number for one below the smallest normal double. The result of double precision, 0 or a subnormal double within
/// one spacing, is right if it has the status, with a claim up to the smallest normal double; without the status it is
/// judged by its digits, of which 0 has none. The shortest decimal of a subnormal double (`5e-324`) counts as that
/// double.
fn below_range(value: &Decimal, mid: &Decimal, marked: bool, claim: Option<&Decimal>, compared: Mark) -> Mark {
    let distance = Decimal::from_double(value.nearest()).map(|double| (&double - mid).abs());
    let is_beside = distance.is_some() && distance <= Decimal::from_double(f64::from_bits(1));
    let is_left = value.is_zero() || is_beside;
    let beyond_subnormal = claim.cloned() > Decimal::from_double(f64::MIN_POSITIVE);
    match (is_left, marked, compared.claim) {
        (false, ..) | (true, true, Claim::TooSmall) => compared,
        (true, true, Claim::Overstated) if beyond_subnormal => {
            Mark { verdict: Verdict::Inaccurate, reason: OVERSTATED.to_owned(), ..compared }
        }
        (true, true, Claim::None) => Mark::of(Verdict::Right, ""),
        (true, true, Claim::Holds | Claim::Overstated) => Mark { claim: Claim::Holds, ..Mark::of(Verdict::Right, "") },
        (true, false, Claim::None) if value.is_zero() => {
            let Mark { reason, .. } = instead_of("0", mid);
            Mark { verdict: Verdict::Wrong, reason: reason + REMEDY, ..compared }
        }
        (true, false, _) if compared.verdict == Verdict::Right => compared,
        (true, false, _) => Mark { reason: format!("{}{REMEDY}", compared.reason), ..compared },
    }
}
