//! The truth about one question, and how far an answer is from it.

use mdr_core::contact::{Error, Ranged, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;

use super::Found;
use super::questions::Subject;

/// Numbers for conditions.
pub(super) type Moved = Dual<Float>;

/// Where the precision starts.
const START: u32 = 192;
/// Where it ends: enough for ratios of scales of 10^±600 in powers near n = 1/2.
const END: u32 = 12_288;
/// An enclosure this narrow counts as known: 2⁻⁴⁰ of a roundoff.
const NARROW: i64 = 93;

/// What the exact result is, for the doubles given.
#[derive(Clone, Debug)]
pub(super) enum Truth {
    /// A number; zero is exact.
    Number(Interval),
    /// A number beyond the exponents of MPFR; its log₁₀.
    Beyond(f64),
    /// None.
    None(Error),
}

/// The exact result, and the precision at which it was known.
pub(super) fn truth(subject: &Subject, inputs: &[f64]) -> std::result::Result<(Truth, u32), String> {
    let mut bits = START;
    loop {
        let ctx = Precision::new(bits);
        let given: Vec<_> = inputs.iter().map(|x| Interval::from_f64(ctx, *x)).collect();
        match (subject.enclosed)(&given) {
            Ok(value) if value.accuracy_bits() >= NARROW => return Ok((Truth::Number(value), bits)),
            Ok(value) if value.is_point() => return Ok((Truth::Number(value), bits)),
            Ok(_) | Err(Error::Undecided { .. } | Error::NoConvergence { .. }) if bits < END => bits *= 2,
            Err(Error::OutOfRange { log10, .. }) => return Ok((Truth::Beyond(log10), bits)),
            Err(error @ (Error::Domain { .. } | Error::NoEquilibrium { .. })) => return Ok((Truth::None(error), bits)),
            Ok(value) => return Err(format!("only {value} is known at {bits} bits")),
            Err(error) => return Err(error.to_string()),
        }
    }
}

/// Σ|xᵢ ∂f/∂xᵢ|/|f| over the inputs that are rounded: not over an exponent n that is a whole number.
pub(super) fn condition(subject: &Subject, inputs: &[f64], bits: u32) -> Result<f64> {
    // Twice the bits: slopes cancel where values do.
    let ctx = Precision::new(2 * bits);
    let mut sum = 0.0;
    let exact = |index: usize| subject.inputs[index] == "n" && inputs[index].fract() == 0.0;
    for moving in (0..inputs.len()).filter(|index| !exact(*index)) {
        let given: Vec<_> = inputs
            .iter()
            .enumerate()
            .map(|(index, x)| {
                let value = Float::from_f64(ctx, *x);
                let slope = if index == moving { value.clone() } else { Float::new(ctx.bits()) };
                Dual { value, slope }
            })
            .collect();
        let Dual { value, slope } = (subject.moved)(&given)?;
        sum += (slope / value).approx().abs();
    }
    Ok(sum)
}

/// The unit in the last place of the double nearest to a number.
fn ulp(nearest: f64) -> f64 {
    nearest.abs().next_up() - nearest.abs()
}

/// |found − exact| in ulp.
pub(super) fn ulps(found: f64, exact: &Float) -> f64 {
    let nearest = exact.to_f64();
    if !found.is_finite() {
        return f64::INFINITY;
    }
    (Float::with_val(exact.prec(), found) - exact).abs().approx() / ulp(nearest)
}

/// log₁₀ of the error over u·max(1, condition)·|exact|; for subnormal results over half their spacing.
fn excess(found: f64, exact: &Float, condition: f64) -> f64 {
    let error = (Float::with_val(exact.prec(), found) - exact).abs();
    let unit = exact.clone().abs() * f64::EPSILON / 2_u32;
    let least = Float::with_val(exact.prec(), f64::from_bits(1)) / 2_u32;
    let unit = if unit < least { least } else { unit };
    (error / unit / condition.max(1.0)).log10().approx()
}

/// What became of the question.
pub(super) fn judge(answer: Result<Ranged<f64>>, truth: &Truth, condition: f64) -> Found {
    match (answer, truth) {
        (Ok(Ranged::Value(value)), Truth::Number(exact)) => number(value, &exact.mid(), condition),
        (Ok(Ranged::Overflow { log10 } | Ranged::Underflow { log10 }), truth) => beyond(log10, truth, condition),
        (Err(Error::OutOfRange { log10, .. }), truth) => beyond(log10, truth, condition),
        (Ok(Ranged::Value(value)), Truth::Beyond(log10)) => Found::Wrong(format!("{value:e} for 10^{log10}")),
        (Ok(Ranged::Value(value)), Truth::None(error)) => Found::Wrong(format!("{value:e}, but {error}")),
        (Err(Error::Domain { .. } | Error::NoEquilibrium { .. }), Truth::None(_)) => Found::Refused,
        (Err(error), _) => Found::Declined(error.to_string()),
    }
}

fn number(value: f64, exact: &Float, condition: f64) -> Found {
    let (zero, nearest) = (exact.is_zero(), exact.to_f64());
    if zero && value == 0.0 {
        return Found::Number { ulp: 0.0, excess: f64::NEG_INFINITY };
    }
    let silent = !value.is_finite() || (value == 0.0 && nearest.abs() >= f64::MIN_POSITIVE) || zero;
    if silent || nearest.is_infinite() {
        let log10 = exact.clone().abs().log10().approx();
        return Found::Wrong(format!("{value:e} for a number of the magnitude 10^{log10:.1}"));
    }
    if value == 0.0 && nearest == 0.0 {
        return Found::Flushed;
    }
    Found::Number { ulp: ulps(value, exact), excess: excess(value, exact, condition) }
}

/// The log₁₀ of a result out of range: a few roundings of it, and the condition of the result over ln 10.
fn beyond(log10: f64, truth: &Truth, condition: f64) -> Found {
    let exact = match truth {
        Truth::Number(exact) if exact.mid().is_zero() => return Found::Wrong("out of range, but it is 0".to_owned()),
        Truth::Number(exact) => exact.mid().abs().log10(),
        Truth::Beyond(exact) => Float::with_val(64, *exact),
        Truth::None(error) => return Found::Wrong(format!("out of range, but {error}")),
    };
    let nearest = match truth {
        Truth::Number(number) => number.mid().to_f64().abs(),
        _ => 0.0,
    };
    // That the log₁₀ is not known is said by an infinite one.
    if log10.is_infinite() && exact.is_sign_positive() == (log10 > 0.0) {
        return Found::Beyond { excess: f64::NEG_INFINITY };
    }
    // A subnormal result may be given, or said to be beyond.
    if (f64::MIN_POSITIVE..=f64::MAX).contains(&nearest) {
        return Found::Declined(format!("said to be out of range, but it is {nearest:e}"));
    }
    let unit = (exact.clone().abs() + condition.max(1.0)) * f64::EPSILON / 2_u32;
    let excess = ((exact - log10).abs() / unit).log10().approx();
    Found::Beyond { excess }
}
