//! Evaluation of closed forms at any scale: squares and cubes of lengths do not leave the range if the result does not.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Special;

use super::ClosedForm;

/// Radii for which four factors of their magnitude stay in the range of doubles.
const COMFORTABLE: std::ops::Range<f64> = 1e-60..1e60;

/// A formula of dimension length^`degree` at x. g, g' and G are homogeneous in the lengths, so if x is far from 1 all
/// lengths are first scaled by a power of two, which is exact.
///
/// A result below the range of the arithmetic is rounded as usual: to a subnormal number or 0.
pub(super) fn evaluate<R: Special, P: ClosedForm<R>>(
    profile: &P,
    x: &R,
    degree: i64,
    formula: impl Fn(&P, &R) -> R,
) -> Result<R> {
    if COMFORTABLE.contains(&x.approx()) {
        let value = formula(profile, x);
        if value.is_finite() {
            return Ok(value);
        }
    }
    rescaled(profile, x, degree, &formula)
}

/// The formula at another scale; compiled once for all formulas of a profile.
#[cold]
fn rescaled<R: Special, P: ClosedForm<R>>(profile: &P, x: &R, degree: i64, formula: &dyn Fn(&P, &R) -> R) -> Result<R> {
    let k = (x.ln().approx() / std::f64::consts::LN_2).floor() as i64;
    let (value, k) = match (profile.scaled(-k), times_power_of_two(x, -k)) {
        (Some(near), Some(x)) => (formula(&near, &x), k),
        _ => (formula(profile, x), 0),
    };
    if !value.is_finite() {
        return Err(singular(x, profile.edge()));
    }
    scaled_back(&value, degree * k)
}

/// The error where a formula has no finite value.
fn singular<R: Special>(x: &R, edge: Option<&R>) -> Error {
    let Some(edge) = edge else {
        let requirement = "small enough, against the shortest length of the profile, for this arithmetic";
        return Error::domain(Quantity::Radius, x, requirement);
    };
    let requirement = "away from the edge where the transformed profile is singular";
    let value = format!("{:?} for the edge {:?}", x.approx(), edge.approx());
    Error::Domain { quantity: Quantity::Radius, value, requirement }
}

/// A value times 2ᵏ, if it is in range.
fn scaled_back<R: Special>(value: &R, k: i64) -> Result<R> {
    times_power_of_two(value, k).ok_or_else(|| {
        let log2 = value.abs().ln().approx() / std::f64::consts::LN_2 + k as f64;
        Error::OutOfRange { quantity: Quantity::TransformedProfile, log10: log2 * std::f64::consts::LOG10_2 }
    })
}

/// x·2ᵏ, in two steps if the power of two is itself out of range; `None` if it overflows.
fn times_power_of_two<R: Special>(x: &R, k: i64) -> Option<R> {
    let power = x.lit(2).powi(k);
    let value = if power.is_finite() && power != x.lit(0) {
        power * x
    } else {
        x.lit(2).powi(k / 2) * x * x.lit(2).powi(k - k / 2)
    };
    value.is_finite().then_some(value)
}

/// Profiles whose lengths can be scaled.
pub(super) trait Scale: Sized {
    /// The profile with all lengths times 2ᵏ; `None` if one of them leaves the range of the arithmetic.
    fn scaled(&self, k: i64) -> Option<Self>;
}

/// A number without a unit, which does not change.
pub(super) fn ratio<R: Special>(x: &R, _k: i64) -> Option<R> {
    Some(x.clone())
}

/// A length times 2ᵏ; `None` if it leaves the range.
pub(super) fn length<R: Special>(x: &R, k: i64) -> Option<R> {
    times_power_of_two(x, k).filter(|length| *length != length.lit(0))
}
