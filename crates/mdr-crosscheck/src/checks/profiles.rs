//! The library of transformed profiles against quadrature of the profiles.

use mdr_analytic::profiles::ClosedReal;
use mdr_core::calculus::Estimate;
use mdr_core::contact::{Flank, Result, Shape, Transform};
use mdr_core::number::Dual;
use mdr_numeric::transform::Quadrature;

use super::common::{Drawn, ROUNDINGS};
use crate::arithmetic::Arithmetic;
use crate::subject::Part;
use crate::tolerance::{TRANSFORM, quadrature};
use crate::trial::Trial;

/// The power laws with a name.
pub(super) fn named<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let [radius, x] = [(); 2].map(|()| 10_f64.powf(trial.uniform(-30.0, 30.0)));
    let angle = trial.uniform(0.02, 1.55);
    trial.describe(format_args!("R = {radius:e}, α = {angle:e}, x = {x:e} ({})", R::NAME));
    let [radius, angle, x] = [radius, angle, x].map(|value| R::from_f64(ctx, value));
    let slope = angle.cos() / angle.sin();
    let ball = Quadrature::of([Shape::Paraboloid { radius: radius.clone() }])?.g_estimate(&x)?;
    let cone = Quadrature::of([Shape::Cone { flank: Flank::Slope(slope.clone()) }])?.g_estimate(&x)?;
    trial.compare(
        "paraboloid",
        &trial.closed.paraboloid(&radius, &x)?,
        &ball.value,
        quadrature(&ball, 2.0) + TRANSFORM,
    );
    let allowed = quadrature(&cone, 1.0) + TRANSFORM;
    trial.compare("cone", &trial.closed.cone(&slope, &x)?, &cone.value, allowed);
    let by_angle = trial.closed.cone_with_half_angle(&angle, &x)?;
    trial.compare("cone of half angle", &by_angle, &cone.value, allowed + 4.0);
    Ok(())
}

/// g, g' and ∫g of every profile with a closed form.
///
/// Each closed form does at most forty roundings and cancels no more than the question does: with the condition
/// c = |d ln(·)/d ln x| it may err by 40(1 + c), as by homogeneity the conditions in the other lengths are not larger
/// than 1 + c. x stays a fifth away from the edge.
pub(super) fn parts<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()>
where
    Dual<R>: ClosedReal,
{
    let profile = Drawn::<R>::draw(trial, ctx);
    let x = profile.radius(trial, round % 6 < 4, ctx)?;
    trial.describe(format_args!("{profile}, x = {:e} ({})", x.approx(), R::NAME));
    let closed = profile.closed::<R>()?;
    let with_slopes = profile.closed::<Dual<R>>()?;
    let transform = Quadrature::of(profile.terms::<R>())?;

    let y = Dual::variable(x.clone());
    let condition = |value: Dual<R>| {
        let condition = (value.slope * &x / value.value).abs().approx();
        if condition.is_finite() { condition } else { 0.0 }
    };
    let forms = trial.closed;
    let mut compare = |part, closed: R, numeric: Estimate<R>, condition: f64| {
        let closed = forms.profile(profile.name, part, closed, &x);
        let allowed = ROUNDINGS * (1.0 + condition) + quadrature(&numeric, condition);
        trial.compare(format!("{part:?}"), &closed, &numeric.value, allowed);
    };
    compare(Part::G, closed.g(&x)?, transform.g_estimate(&x)?, condition(with_slopes.g(&y)?));
    compare(Part::Slope, closed.slope(&x)?, transform.slope_estimate(&x)?, condition(with_slopes.slope(&y)?));
    let integral = with_slopes.integral(&y)?;
    compare(Part::Mean, closed.integral(&x)? / &x, transform.mean_estimate(&x)?, condition(integral));
    Ok(())
}
