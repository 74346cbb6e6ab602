//! The library of transformed profiles against quadrature of the profiles.

use mdr_analytic::Kappa;
use mdr_analytic::struve::Struve;
use mdr_core::calculus::Estimate;
use mdr_core::contact::{Flank, Profile, Result, Shape, Transform};
use mdr_core::number::{Dual, Lift, Real, Special};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

use crate::arithmetic::Arithmetic;
use crate::subject::Part;
use crate::subject::profiles::{NAMES, closed_form, terms};
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

/// Roundings of a closed form of the library.
pub(super) const ROUNDINGS: f64 = 40.0;

/// A profile: its name, a length L, a second length b = ratio·L where there is one, and a slope or height over L.
#[derive(Clone)]
pub(super) struct Drawn<R> {
    name: &'static str,
    length: R,
    second: R,
    slope: R,
}

impl<R: Arithmetic> Drawn<R> {
    /// The profile of this case, at any scale.
    pub(super) fn draw(trial: &mut Trial<'_>, ctx: R::Ctx) -> Self {
        let name = NAMES[trial.index % NAMES.len()];
        let length = R::from_f64(ctx, 10_f64.powf(trial.uniform(-15.0, 15.0)));
        let ratio = R::from_f64(ctx, 2_f64.powf(trial.uniform(-2.0, 1.0)));
        let slope = R::from_f64(ctx, 2_f64.powf(trial.uniform(-4.0, 1.0)));
        let second = ratio * &length;
        Drawn { name, length, second, slope }
    }

    /// A radius within the profile, off its edge by a fifth or more on the given side.
    ///
    /// # Errors
    /// Parameters out of their domain.
    pub(super) fn radius(&self, trial: &mut Trial<'_>, beyond: bool, ctx: R::Ctx) -> Result<R> {
        let heights = self.heights()?;
        if let Some(end) = heights.outer_radius() {
            return Ok(end * R::from_f64(ctx, trial.uniform(0.05, 0.8)));
        }
        let edge = heights.kinks().into_iter().next().unwrap_or_else(|| self.second.clone());
        let octaves = trial.uniform(0.3, 2.0);
        let octaves = if beyond { octaves } else { -octaves };
        Ok(edge * R::from_f64(ctx, 2_f64.powf(octaves)))
    }

    /// The slope or height over L.
    pub(super) fn steepness(&self) -> R {
        self.slope.clone()
    }
}

impl<R: Real> std::fmt::Display for Drawn<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [length, second, slope] = [&self.length, &self.second, &self.slope].map(R::approx);
        write!(f, "{}, L = {length:e}, b = {second:e}, t = {slope:e}", self.name)
    }
}

impl Drawn<f64> {
    /// The drawn profile, exactly, in another arithmetic.
    pub(super) fn lifted<R: Real>(&self, ctx: R::Ctx) -> Drawn<R> {
        let [length, second, slope] = [self.length, self.second, self.slope].map(|value| R::from_f64(ctx, value));
        Drawn { name: self.name, length, second, slope }
    }
}

impl<R: Real> Drawn<R> {
    /// Its shapes, over numbers in which R is a constant.
    fn terms<S: Lift<R>>(&self) -> Vec<Shape<S>> {
        let [l, b, t] = [&self.length, &self.second, &self.slope].map(S::lift);
        terms(self.name, |key| match key {
            "slope" => t.clone(),
            "flat" | "cap" | "offset" | "wavelength" => b.clone(),
            "height" | "depth" => t.clone() * &l,
            "amplitude" => b.square() / l.clone().times(32),
            _ => l.clone(),
        })
    }

    /// The profile by its heights.
    pub(super) fn heights(&self) -> Result<Heights<R>>
    where
        R: Lift<R> + Special,
    {
        Heights::new(self.terms::<R>())
    }

    /// The closed form, over numbers in which R is a constant.
    pub(super) fn closed<S: Lift<R> + Struve + Kappa>(&self) -> Result<Box<dyn Transform<S>>> {
        closed_form(self.terms::<S>())
    }
}

/// g, g' and ∫g of every profile with a closed form.
///
/// Each closed form does at most forty roundings and cancels no more than the question does: with the condition
/// c = |d ln(·)/d ln x| it may err by 40(1 + c), as by homogeneity the conditions in the other lengths are not larger
/// than 1 + c. x stays a fifth away from the edge.
pub(super) fn parts<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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
