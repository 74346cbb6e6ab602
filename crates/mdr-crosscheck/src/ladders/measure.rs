//! The exact result of a question, its condition, and how far an answer is from it.

use mdr_core::contact::{Error, Ranged, Result};
use mdr_core::number::certify::{Enclosure, next_precision};
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;

use super::{Found, Rung};
use crate::subject::routine::Routine;
use crate::trial::ulps;

/// Where the precision starts.
const START: u32 = 192;
/// Where it ends: enough for ratios of scales of 10^±600 in powers near n = 1/2.
const END: u32 = 12_288;
/// Relative accuracy in bits with which a result counts as known: 2⁻⁴⁰ of a roundoff.
const NARROW: u32 = 93;

/// The exact result for the doubles given.
#[derive(Clone, Debug)]
enum Reference {
    /// A number; zero is exact.
    Number(Interval),
    /// A number beyond the exponents of MPFR; its log₁₀.
    Beyond(f64),
    /// None.
    None(Error),
}

/// One question to a routine, with its outcome.
pub(super) fn rung(routine: &Routine, parameter: f64, inputs: &[f64]) -> Rung {
    let inputs = inputs.to_vec();
    let (reference, bits) = match reference(routine, &inputs) {
        Ok(known) => known,
        Err(unknown) => {
            let found = Found::Declined(format!("the truth: {unknown}"));
            return Rung { parameter, inputs, condition: None, found, naive_ulp: None };
        }
    };
    let exact = match &reference {
        Reference::Number(value) if !value.is_point() || !value.mid().is_zero() => Some(value.mid()),
        _ => None,
    };
    let condition = exact.as_ref().and_then(|_| condition(routine, &inputs, bits).ok()).filter(|c| c.is_finite());
    let found = match judge((routine.shipped)(&inputs), &reference, condition.unwrap_or(1.0)) {
        Found::Flushed if routine.name.starts_with("double::") => Found::Wrong("0, which is an underflow".to_owned()),
        found => found,
    };
    // A formula of textbooks cannot say what a double cannot hold.
    let in_range = |exact: &Float| (f64::MIN_POSITIVE..=f64::MAX).contains(&exact.to_f64().abs());
    let naive_ulp = exact.filter(in_range).zip(routine.textbook);
    let naive_ulp = naive_ulp.map(|(exact, textbook)| ulps((textbook.value)(&inputs), &exact));
    Rung { parameter, inputs, condition, found, naive_ulp }
}

/// The exact result, and the precision at which it was known.
fn reference(routine: &Routine, inputs: &[f64]) -> std::result::Result<(Reference, u32), String> {
    let mut precision = Precision::new(START);
    loop {
        let bits = precision.bits();
        let given: Vec<_> = inputs.iter().map(|x| Interval::from_f64(precision, *x)).collect();
        let open = match (routine.exact.interval)(&given) {
            Ok(value) if value.is_point() || value.accuracy_bits() >= i64::from(NARROW) => {
                return Ok((Reference::Number(value), bits));
            }
            Err(Error::OutOfRange { log10, .. }) => return Ok((Reference::Beyond(log10), bits)),
            Err(error @ (Error::Domain { .. } | Error::NoEquilibrium { .. })) => {
                return Ok((Reference::None(error), bits));
            }
            Ok(value) if bits < END => Some(Enclosure::from(value)),
            Err(Error::Undecided { .. } | Error::NoConvergence { .. }) if bits < END => None,
            Ok(value) => return Err(format!("only {value} is known at {bits} bits")),
            Err(error) => return Err(error.to_string()),
        };
        precision = next_precision(Precision::new(NARROW), precision, [open.as_ref()]);
        precision = precision.min(Precision::new(END));
    }
}

/// Σ|xᵢ ∂f/∂xᵢ|/|f| over the inputs that are rounded: not over an exponent n that is a whole number.
fn condition(routine: &Routine, inputs: &[f64], bits: u32) -> Result<f64> {
    // Twice the bits: slopes cancel where values do.
    let ctx = Precision::new(2 * bits);
    let mut sum = 0.0;
    let exact = |index: usize| routine.inputs[index] == "n" && inputs[index].fract() == 0.0;
    for seeded in (0..inputs.len()).filter(|index| !exact(*index)) {
        let given: Vec<_> = inputs
            .iter()
            .enumerate()
            .map(|(index, x)| {
                let value = Float::from_f64(ctx, *x);
                let slope = if index == seeded { value.clone() } else { Float::new(ctx.bits()) };
                Dual { value, slope }
            })
            .collect();
        let Dual { value, slope } = (routine.exact.dual)(&given)?;
        sum += (slope / value).approx().abs();
    }
    Ok(sum)
}

/// log₁₀ of the error over u·max(1, condition)·|exact|; for subnormal results over half their spacing.
fn excess(found: f64, exact: &Float, condition: f64) -> f64 {
    let error = (Float::with_val(exact.prec(), found) - exact).abs();
    let unit = exact.clone().abs() * f64::EPSILON / 2_u32;
    let least = Float::with_val(exact.prec(), f64::from_bits(1)) / 2_u32;
    let unit = if unit < least { least } else { unit };
    (error / unit / condition.max(1.0)).log10().approx()
}

/// The outcome of a question.
fn judge(answer: Result<Ranged<f64>>, reference: &Reference, condition: f64) -> Found {
    match (answer, reference) {
        (Ok(Ranged::Value(value)), Reference::Number(exact)) => number(value, &exact.mid(), condition),
        (Ok(Ranged::Overflow { log10 } | Ranged::Underflow { log10 }), reference) => {
            beyond(log10, reference, condition)
        }
        (Err(Error::OutOfRange { log10, .. }), reference) => beyond(log10, reference, condition),
        (Ok(Ranged::Value(value)), Reference::Beyond(log10)) => Found::Wrong(format!("{value:e} for 10^{log10}")),
        (Ok(Ranged::Value(value)), Reference::None(error)) => Found::Wrong(format!("{value:e}, but {error}")),
        (Err(Error::Domain { .. } | Error::NoEquilibrium { .. }), Reference::None(_)) => Found::Refused,
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
fn beyond(log10: f64, reference: &Reference, condition: f64) -> Found {
    let exact = match reference {
        Reference::Number(exact) if exact.mid().is_zero() => {
            return Found::Wrong("out of range, but it is 0".to_owned());
        }
        Reference::Number(exact) => exact.mid().abs().log10(),
        Reference::Beyond(exact) => Float::with_val(64, *exact),
        Reference::None(error) => return Found::Wrong(format!("out of range, but {error}")),
    };
    let nearest = match reference {
        Reference::Number(number) => number.mid().to_f64().abs(),
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
