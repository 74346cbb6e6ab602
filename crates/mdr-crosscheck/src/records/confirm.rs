//! The second method: whether the numerical route, which knows heights f(r) only, has the same answer.
//!
//! A certified radius is confirmed by a change of sign: of the tangency, or of the direction of change, between
//! a(1 − 10⁻⁴⁵) and a(1 + 10⁻⁴⁵), both from quadratures of the profile.

use mdr_core::contact::{Control, Material, Result, Transform};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::profiles;
use mdr_numeric::transform::Quadrature;
use rug::Float;

use super::RecordError;
use super::draft::literal;
use super::power::Power;

/// The digits to which the two methods have to agree.
pub(super) const AGREED: u32 = 45;

/// Digits of the quadratures beyond what a question of the given condition loses.
const WORKING: f64 = 64.0;

/// The precision for a question of this condition.
pub(super) fn precision(condition: f64) -> Precision {
    Precision::from_digits((WORKING + condition.max(1.0).log10()) as u32)
}

/// The number that a decimal is.
pub(super) fn float(ctx: Precision, value: &Decimal) -> Float {
    let parsed = Float::parse(value.to_string());
    parsed.map_or_else(|_| Float::with_val(ctx.bits(), f64::NAN), |text| Float::with_val(ctx.bits(), text))
}

/// x(1 − 10^−AGREED) and x(1 + 10^−AGREED).
pub(super) fn around(x: &Float) -> [Float; 2] {
    let step = x.lit(10).powi(-i64::from(AGREED)) * x;
    [x.clone() - &step, x.clone() + &step]
}

/// Whether a function has different signs on both sides of x.
pub(super) fn changes_sign(x: &Float, mut f: impl FnMut(&Float) -> Result<Float>) -> Result<bool> {
    let [below, above] = around(x);
    Ok(f(&below)?.is_sign_negative() != f(&above)?.is_sign_negative())
}

/// Whether two numbers agree, relative to a scale.
pub(super) fn agree(a: &Float, b: &Float, scale: &Float) -> bool {
    (a.clone() - b).abs() <= scale.lit(10).powi(-i64::from(AGREED)) * scale
}

/// A power law as a height, in quadratures.
type Height = Quadrature<Float, profiles::Power<Float>>;

/// A power law and its material in the arithmetic of the second method.
pub(super) fn power(power: &Power, ctx: Precision) -> Result<(Height, Material<Float>)> {
    let [n, c, e_star, work] = power.texts().map(|text| Float::from_literal(ctx, &literal(text)));
    Ok((Quadrature::new(profiles::Power::new(n, c)?), Material::new(e_star, work)?))
}

/// κ_n = g(1) for C = 1.
pub(super) fn kappa(law: &Power, value: &Decimal) -> std::result::Result<(), RecordError> {
    let check = || {
        let ctx = precision(1.0);
        let n = Float::from_literal(ctx, &literal(&law.n));
        let one = n.lit(1);
        let g = Quadrature::new(profiles::Power::new(n, one.clone())?).g(&one)?;
        let value = float(ctx, value);
        Ok(agree(&g, &value, &value))
    };
    RecordError::unless(&law.name, "kappa", check())
}

/// A fold: tangency at a, and d and F on the curve of equilibria.
pub(super) fn fold(
    law: &Power,
    control: &Control<Float>,
    [a, d, f]: &[Decimal; 3],
    condition: f64,
) -> std::result::Result<(), RecordError> {
    let check = || {
        let ctx = precision(condition);
        let (transform, material) = power(law, ctx)?;
        state_at_fold(&Curve::new(&transform, &material, control), &[a, d, f].map(|x| float(ctx, x)))
    };
    RecordError::unless(&law.name, "the fold", check())
}

/// Whether the curve has a fold at a with these d and F.
pub(super) fn state_at_fold(curve: &Curve<'_, Float>, [a, d, f]: &[Float; 3]) -> Result<bool> {
    let tangent = changes_sign(a, |a| Ok(curve.tangency(a)? - curve.threshold(a)?))?;
    Ok(tangent && on_curve(curve, [a, d, f])?)
}

/// Whether d and F belong to a; they are compared to the terms of which they are the difference.
pub(super) fn on_curve(curve: &Curve<'_, Float>, [a, d, f]: [&Float; 3]) -> Result<bool> {
    let (indentation, force) = curve.state(a)?;
    let length = curve.detachment_elongation(a)? + d.clone().abs();
    let load = length.clone() * a * curve.effective_modulus();
    Ok(agree(&indentation, d, &length) && agree(&force, f, &load.times(2)))
}
