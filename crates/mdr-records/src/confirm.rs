//! The second method: whether the numerical route, which uses heights f(r) only, has the same answer.
//!
//! A certified radius is confirmed by a change of sign: of the tangency, or of the direction of change, between
//! a(1 − 10⁻⁴⁵) and a(1 + 10⁻⁴⁵), both from quadratures of the profile.

use mdr_core::contact::Result;
use mdr_core::number::{Decimal, Precision, Real};
use mdr_numeric::contact::Contact;
use rug::Float;

use crate::contact::CaseContact;
use crate::sensitivity::{Conditions, largest};
use crate::{Failure, float};

/// The digits to which the two methods have to agree.
const AGREED: u32 = 45;

/// Digits of the quadratures beyond what a question of the given condition loses.
const WORKING: f64 = 64.0;

/// The precision for a question of these conditions.
pub(crate) fn precision(conditions: &[Conditions]) -> Precision {
    Precision::from_digits((WORKING + largest(conditions).log10()) as u32)
}

/// Whether a function has different signs at x(1 − 10^−AGREED) and x(1 + 10^−AGREED).
pub(crate) fn changes_sign(x: &Float, mut f: impl FnMut(&Float) -> Result<Float>) -> Result<bool> {
    let step = x.lit(10).powi(-i64::from(AGREED)) * x;
    let [below, above] = [x.clone() - &step, x.clone() + &step];
    Ok(f(&below)?.is_sign_negative() != f(&above)?.is_sign_negative())
}

/// Whether two numbers agree, relative to a scale.
pub(crate) fn agree(a: &Float, b: &Float, scale: &Float) -> bool {
    (a.clone() - b).abs() <= scale.lit(10).powi(-i64::from(AGREED)) * scale
}

/// A fold: the tangency changes its sign at a, and d and F are on the curve of equilibria.
pub(crate) fn fold(contact: &CaseContact, values: &[Decimal; 3], conditions: &[Conditions]) -> crate::Result<()> {
    let tangency = |curve: &Contact<Float>, a: &Float| Ok(curve.tangency(a)? - curve.critical_ratio(a)?);
    Failure::unless("the fold", state(contact, values, precision(conditions), tangency)?)
}

/// An equilibrium at a value of the controlled quantity: the direction of change turns at a, and d and F are on the curve.
pub(crate) fn equilibrium(
    contact: &CaseContact,
    value: &Float,
    values: &[Decimal; 3],
    ctx: Precision,
) -> crate::Result<()> {
    let direction = |curve: &Contact<Float>, a: &Float| curve.direction(a, value);
    Failure::unless("the equilibrium", state(contact, values, ctx, direction)?)
}

/// Whether a function on the curve changes its sign at a, to which d and F belong.
fn state(
    contact: &CaseContact,
    values: &[Decimal; 3],
    ctx: Precision,
    f: impl Fn(&Contact<Float>, &Float) -> Result<Float>,
) -> Result<bool> {
    contact.float(ctx)?.integrated(|curve| {
        let state = values.each_ref().map(|value| float(ctx, value));
        Ok(changes_sign(&state[0], |a| f(curve, a))? && on_curve(curve, state.each_ref())?)
    })
}

/// Whether d and F belong to a; they are compared to the terms of which they are the difference.
pub(crate) fn on_curve(curve: &Contact<Float>, [a, d, f]: [&Float; 3]) -> Result<bool> {
    let (indentation, force) = curve.state(a)?;
    let length = curve.detachment_elongation(a)? + d.clone().abs();
    let load = length.clone() * a * curve.modulus();
    Ok(agree(&indentation, d, &length) && agree(&force, f, &load.times(2)))
}
