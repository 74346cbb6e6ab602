//! Line contact: closed forms against the transform by quadrature, against the displacement by the logarithmic kernel of the
//! half-plane, −(2/πE*) ln|x − s| for a line force, and in their own equations.

use mdr_analytic::media::LineContact;
use mdr_core::calculus::quadrature::{tanh_sinh, tanh_sinh_near_ends};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Material, Result};
use mdr_core::number::Dual;

use crate::arithmetic::Arithmetic;
use crate::tolerance::{KAPPA, quadrature};
use crate::trial::Trial;

/// Roundings of N and of √(2πwb/E*), beside those of their powers of b.
const TERMS: f64 = 3.0 * KAPPA + 20.0;

/// c_n by quadrature, states and slopes by dual numbers, G = w, the fold, the equilibrium at a force, the loss at jump-in as the
/// integral of 2(w − G), the threshold at n = 1/2.
pub(super) fn states<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let n = if round % 3 == 1 { trial.uniform(0.1, 0.42) } else { trial.uniform(0.6, 6.0) };
    let mut draw = |decades: f64| 10_f64.powf(trial.uniform(-decades, decades));
    let [c, e_star, work] = [draw(2.0), draw(6.0), draw(6.0)];
    trial.describe(format_args!("n = {n}, C = {c:e}, E* = {e_star:e}, w = {work:e} ({})", R::NAME));
    let [n_, c, e, w] = [n, c, e_star, work].map(|value| R::from_f64(ctx, value));
    let contact = LineContact::new(n_.clone(), c.clone(), Material::new(e.clone(), w.clone())?)?;
    let constant = |x: &R| Dual::constant(x.clone());
    let dual = LineContact::new(constant(&n_), constant(&c), Material::new(constant(&e), constant(&w))?)?;

    let power = (n_.clone() - n_.lit(1)).over(2);
    let integral = tanh_sinh_near_ends(&n_.lit(0), &n_.lit(1), &roundoff_tolerance(&n_), |node| {
        Ok(node.from_lower.pow(&power) / node.from_upper.sqrt())
    })?;
    let factor = trial.closed.line_factor(&n_)?;
    let expected = integral.value.clone() * &n_.clone().over(2);
    trial.compare("c_n", &factor, &expected, KAPPA + 8.0 + quadrature(&integral, n));

    let [b, force] = trial.closed.line_critical(&contact)?;
    let excess = (2.0 * n - 1.0).abs();
    let radius = (40.0 + 4.0 * KAPPA) / excess + 2.0 * b.ln().approx().abs() + 2.0;
    let size = |b: &R| (w.pi() * &w * b * &e).times(2).sqrt();
    let terms = |b: &R| TERMS + 2.0 * (n + 2.0) * b.ln().approx().abs();
    let allowed = 2.0 * (n + 2.0) * radius + 4.0 * terms(&b);
    // N = Δl/2n at the fold.
    let scale = size(&b) * R::from_f64(ctx, 1.0 + 1.0 / (2.0 * n));
    trial.compare_on("F_c", &force, &contact.force(&b)?, &scale, allowed);
    trial.compare_on("F'(b_c)", &contact.force_slope(&b)?, &b.lit(0), &(scale / &b), allowed);

    let stretch = R::from_f64(ctx, trial.uniform(-2.0, 2.0) / (n + 1.0));
    let b = b * stretch.exp();
    let force = trial.closed.line_force(&contact, &b)?;
    let by_quadrature = (expected * &c * b.pow(&n_) * &e) - size(&b);
    let grown = factor * &c * b.pow(&n_) * &e;
    let scale = grown + size(&b);
    trial.compare_on("F", &force, &by_quadrature, &scale, 2.0 * terms(&b) + quadrature(&integral, n));
    let slope = trial.closed.line_force_slope(&contact, &b)?;
    let exact = dual.force(&Dual::variable(b.clone()))?.slope;
    let per_width = scale.clone() * R::from_f64(ctx, n + 1.0) / &b;
    trial.compare_on("F'", &slope, &exact, &per_width, 4.0 * terms(&b));
    // G ∝ (E*N − F)², where E*N − F is Δl out of the terms.
    let rate = trial.closed.line_release_rate(&contact, &b, &force)?;
    let condition = (scale.clone() / size(&b)).approx();
    trial.compare("G", &rate, &w, 4.0 * condition * terms(&b) + 10.0);

    // At the force of a wide contact the largest equilibrium is that contact for n > 1/2; for n < 1/2 it has F < 0 alone.
    let wide = b.clone() * b.lit(8);
    let force = contact.force(&wide)?;
    let found = trial.closed.line_half_width(&contact, &force)?;
    let slope = contact.force_slope(&wide)? * &wide / &force;
    if n > 0.5 || force < b.lit(0) {
        let condition = ((force.abs() + size(&wide).times(2)) / (slope.clone() * &force).abs()).approx();
        trial.compare("b(F)", &found, &wide, 8.0 * condition * terms(&wide) + 16.0);
    }
    if n > 0.5 {
        let touching = contact.half_widths(&b.lit(0))?.last().map_or(b, |(half_width, _)| half_width.clone());
        let integral = tanh_sinh(&w.lit(0), &touching, &roundoff_tolerance(&w), |x| {
            Ok((w.clone() - contact.energy_release_rate(x, &w.lit(0))?).times(2))
        })?;
        let lost = trial.closed.line_jump_in(&contact)?;
        // w − G cancels at the end, where the integrand is small; the loss is (2 − 1/n) of w b₀.
        let allowed = quadrature(&integral, n) + (16.0 * terms(&touching) + 4.0 * radius) * 4.0 * n / excess;
        trial.compare("loss", &lost, &integral.value, allowed);
    }

    let material = Material::new(e.clone(), w.clone())?;
    let half = LineContact::new(n_.ratio(1, 2), trial.closed.line_threshold(&material)?, material)?;
    let held = half.force(&wide)?;
    trial.compare_on("threshold", &held, &wide.lit(0), &size(&wide), 2.0 * TERMS + 2.0 * wide.ln().approx().abs());
    Ok(())
}

/// The pressure of a cylinder in the kernel: the surface falls by δ − x²/2R under the contact, against a point at the distance L;
/// the force; the strip. With x = b sin θ the pressure is smooth in θ.
pub(super) fn kernel<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let mut draw = |decades: f64| 10_f64.powf(trial.uniform(-decades, decades));
    let [radius, e_star, work, b] = [draw(1.0), draw(6.0), draw(6.0), draw(1.0)];
    let (reference, place) = (b * (1.0 + draw(1.0)), trial.uniform(-0.9, 0.9));
    trial.describe(format_args!(
        "R = {radius:e}, E* = {e_star:e}, w = {work:e}, b = {b:e}, L = {reference:e}, x = {place} b ({})",
        R::NAME
    ));
    let [r, e, w, b, l, x] = [radius, e_star, work, b, reference, place].map(|value| R::from_f64(ctx, value));
    let material = Material::new(e.clone(), w.clone())?;
    let cylinder = LineContact::cylinder(r.clone(), material.clone())?;
    let force = trial.closed.line_force(&cylinder, &b)?;
    let x = x * &b;
    let half_pi = b.pi().over(2);
    let goal = roundoff_tolerance(&b);

    // p dx/E* = [(πb²/2R)cos²θ − Δl]dθ/π.
    let elongation = (b.pi() * &w * &b / &e).times(2).sqrt();
    let pressed = b.pi() * b.square() / r.clone().times(2);
    let density = |theta: &R| (theta.cos().square() * &pressed - &elongation) / theta.pi();
    let size = pressed.clone() + &elongation;
    // The logarithm is infinite at θ₀ = arcsin x/b; x − s = 2b sin((θ₀−θ)/2) cos((θ₀+θ)/2).
    let middle = (x.clone() / &b).asin();
    let displacement = |density: &dyn Fn(&R) -> R| -> Result<(R, f64)> {
        let (mut sum, mut cost) = (b.lit(0), 0.0);
        for (from, to, at_lower) in [(-half_pi.clone(), middle.clone(), false), (middle.clone(), half_pi.clone(), true)]
        {
            let integral = tanh_sinh_near_ends(&from, &to, &goal, |node| {
                let away = if at_lower { &node.from_lower } else { &node.from_upper };
                let s = node.x.sin() * &b;
                let near = (away.clone().over(2).sin() * (node.x.clone() + &middle).over(2).cos() * &b).times(2);
                Ok(((l.clone() - s) / near.abs()).ln() * density(&node.x))
            })?;
            cost += integral.evaluations as f64 + (integral.error / size.unit_roundoff() / &size).approx();
            sum += &integral.value;
        }
        Ok((sum.times(2) / b.pi(), cost))
    };
    // The logarithm is at most ln 2L/b beside its integrable peak; middle errs by the rounding over cos θ₀.
    let logarithm = (l.clone() / &b).ln().approx() + 4.0;
    let (depth, cost) = displacement(&density)?;
    let closed = trial.closed.cylinder_depth(&r, &b, &(force.clone() / &e), &l)?;
    let shape = x.square() / r.clone().times(2);
    let scale = size.clone() * R::from_f64(ctx, logarithm) + &shape;
    trial.compare_on("δ − x²/2R", &depth, &(closed - shape), &scale, 8.0 * (TERMS + cost));
    let integral = tanh_sinh(&-half_pi.clone(), &half_pi, &goal, |theta| Ok(density(theta)))?;
    trial.compare_on(
        "F",
        &(integral.value * &e),
        &force,
        &(size.clone() * &e),
        4.0 * (TERMS + integral.evaluations as f64),
    );
    // A flat strip: p = q/(π√(b²−x²)).
    let (strip, cost) = displacement(&|theta: &R| size.clone() / theta.pi())?;
    let stiffness = trial.closed.line_stiffness(&material, &b, &l)?;
    trial.compare("S", &(size / strip * &e), &stiffness, 8.0 * (TERMS + cost) * logarithm);
    Ok(())
}
