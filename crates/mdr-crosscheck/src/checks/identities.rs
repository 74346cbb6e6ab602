//! The closed forms against each other: critical states put back into the equations they solve, and in other systems of
//! units. (1.15) as it is printed, refuted: the printed form exists here and nowhere else.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Dual;

use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// (1.17) against (1.16) at a_c, d_c against (1.13), and the condition (1.10), (1.14) with its analogue for a dead load.
pub(super) fn critical<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(50)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let contact = scene.contact()?;
    let state = trial.closed.critical(&contact, &held.control())?;
    let a = &state.contact_radius;
    let allowed = scene.tangent(held.lambda(), a);
    let elongation = trial.closed.detachment_elongation(contact.material(), a)?;
    let force_scale = elongation.clone() * a * contact.material().effective_modulus().clone().times(2);

    let d = trial.closed.indentation(&contact, a)?;
    trial.compare_on(format!("d ({held})"), &state.indentation, &d, &elongation, allowed.indentation_at_radius());
    let f = trial.closed.force(&contact, a)?;
    trial.compare_on(format!("F ({held})"), &state.force, &f, &force_scale, allowed.force_at_radius());
    let slope = trial.closed.slope(contact.profile(), a)?;
    let unit = (elongation / a).over(2);
    let tension = unit.clone() * R::from_f64(ctx, held.lambda());
    trial.compare_on(format!("g' ({held})"), &slope, &tension, &unit, allowed.slope_at_radius());
    Ok(())
}

/// The slopes along the equilibria against derivatives by dual numbers, and F' = 2E*(a d' − Δl).
pub(super) fn slopes<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family::up_to(50));
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let contact = scene.contact()?;
    // Off the fold by up to a factor of two in the terms of d', so that nothing of it is small.
    let stretch = R::from_f64(ctx, trial.uniform(-1.0, 1.0)) / (scene.n.clone() + scene.n.lit(1));
    let a = contact.critical(&Control::Indentation)?.contact_radius * stretch.exp();
    let dual = scene.map(|x| Dual::constant(x.clone())).contact()?;
    let x = Dual::variable(a.clone());
    let n = scene.n.approx();
    let exponents = (n + 1.0) * (a.ln().approx().abs() + 1.0);

    let profile = contact.profile();
    let g = trial.closed.g(profile, &a)?;
    let slope = trial.closed.slope(profile, &a)?;
    let integral = trial.closed.integral(dual.profile(), &x)?;
    // n·g/x on one side; on the other a power with the rounded exponent n − 1.
    trial.compare("g", &integral.slope, &g, 2.0 * TRANSFORM + 6.0 + exponents);
    let tension = trial.closed.detachment_elongation(contact.material(), &a)? / a.clone().times(2);
    let terms = slope.clone() + &tension;
    let allowed = 2.0 * TRANSFORM + 2.0 * ELONGATION + 8.0 + exponents;
    let d = trial.closed.indentation(&dual, &x)?;
    trial.compare_on("d'", &trial.closed.indentation_slope(&contact, &a)?, &d.slope, &terms, allowed);
    let f = trial.closed.force(&dual, &x)?;
    let scale = terms * &a * scene.e_star.clone().times(2);
    trial.compare_on("F'", &trial.closed.force_slope(&contact, &a)?, &f.slope, &scale, 3.0 * allowed + 6.0);
    Ok(())
}

/// Logarithms of a critical state against the state.
pub(super) fn logarithms<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(40)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let contact = scene.contact()?;
    // Each logarithm in ln q is rounded to its own size, and so are the sums: three roundings of their total.
    let terms = [&scene.e_star, &scene.work, &scene.c, &scene.c, &scene.n, &scene.n, &scene.n, &scene.n];
    let sizes: f64 = terms.iter().map(|x| x.ln().approx().abs() + 1.0).sum();
    let state = trial.closed.critical(&contact, &held.control())?;
    let ln = trial.closed.ln_critical(&contact, &held.control())?;
    let tangent = scene.tangent(held.lambda(), &state.contact_radius);
    let radius = tangent.radius() + 3.0 * sizes / tangent.excess();
    let mut compare = |name, value: &R, ln: &R, allowed: f64| {
        let error = (ln.clone() - value.abs().ln()) / value.unit_roundoff();
        trial.enter(format!("{name} ({held})"), error.abs().approx(), allowed);
    };
    compare("ln a", &state.contact_radius, &ln.contact_radius, radius);
    if state.indentation != state.indentation.lit(0) {
        compare("ln|d|", &state.indentation, &ln.indentation, 0.5 * radius + 3.0 * sizes + 20.0);
    }
    compare("ln|F|", &state.force, &ln.force, 1.5 * radius + 6.0 * sizes + 20.0);
    Ok(())
}

/// E* and w in a unit of force 4^m times smaller: B does not change, so that a and d are the same bits and F is
/// exactly 4^m times as large.
pub(super) fn unit_of_force<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(50)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let factor = R::from_int(ctx, 4).powi([7, -5, 20, -16, 1][round % 5]);
    let scaled = Scene { e_star: scene.e_star.clone() * &factor, work: scene.work.clone() * &factor, ..scene.clone() };
    let state = trial.closed.critical(&scene.contact()?, &held.control())?;
    let other = trial.closed.critical(&scaled.contact()?, &held.control())?;
    trial.demand(format!("a ({held})"), state.contact_radius == other.contact_radius);
    trial.demand(format!("d ({held})"), state.indentation == other.indentation);
    trial.demand(format!("F ({held})"), state.force * &factor == other.force);
    Ok(())
}

/// C, E* and w in a unit of length 2^m times smaller, for exponents where 2^{m(1−n)} is a power of two.
pub(super) fn unit_of_length<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    // n = p/q and m a multiple of q.
    let (p, q) = [(2, 1), (1, 4), (1, 1), (3, 4), (3, 2), (5, 2), (5, 8), (3, 8), (3, 1), (7, 16)][round % 10];
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, Exponent::Fraction(p, q), held.lambda(), ctx);
    let m = q * [1, -2, 3][round % 3];
    let two = R::from_int(ctx, 2);
    let s = two.powi(m);
    let scaled = scene.in_smaller_unit(&s, &two.powi(m / q * (q - p)));
    let state = trial.closed.critical(&scene.contact()?, &held.control())?;
    let other = trial.closed.critical(&scaled.contact()?, &held.control())?;
    let [here, there] = [(&scene, &state), (&scaled, &other)]
        .map(|(scene, state)| scene.tangent(held.lambda(), &state.contact_radius).radius());
    let allowed = here + there;
    trial.compare(format!("a ({held})"), &other.contact_radius, &(state.contact_radius * &s), allowed);
    if state.indentation == s.lit(0) {
        trial.demand("d = 0", other.indentation == s.lit(0));
    } else {
        trial.compare(format!("d ({held})"), &other.indentation, &(state.indentation * &s), 0.5 * allowed + 24.0);
    }
    trial.compare(format!("F ({held})"), &other.force, &state.force, 1.5 * allowed + 24.0);
    Ok(())
}

/// (πw/(2E*n²κ_n²C²))^{1/(1−2n)}: (1.15) as printed.
pub(super) fn printed_radius<R: Arithmetic>(scene: &Scene<R>) -> Result<R> {
    let kappa = mdr_analytic::kappa(&scene.n)?;
    let slope = kappa * &scene.n * &scene.c;
    let base = scene.work.pi() * &scene.work / &scene.e_star / slope.square().times(2);
    let one = scene.n.lit(1);
    Ok(base.pow(&(one.clone() - scene.n.clone().times(2)).inv()))
}

/// The exponent of (1.15) must be 1/(2n−1); printed is 1/(1−2n).
///
/// Dimensions: in a unit of length s times smaller a radius is s times larger. The corrected form scales with s¹, the
/// printed one with s⁻¹, for every n.
pub(super) fn dimensions<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, most: 20.0, nearest: 20 });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let s = R::from_int(ctx, [1000, 2, 100, 10][round % 4]);
    let smaller = scene.in_smaller_unit(&s, &s.pow(&(s.lit(1) - &scene.n)));
    let radius = |trial: &Trial<'_>, scene: &Scene<R>| -> Result<R> {
        Ok(trial.closed.critical(&scene.contact()?, &Control::Indentation)?.contact_radius)
    };
    let (a, a_smaller) = (radius(trial, &scene)?, radius(trial, &smaller)?);
    let ln_s = s.ln();
    let exponent_of = |long: &R, short: &R| (short.ln() - long.ln()) / &ln_s;

    // Both radii, the rounding of the scaled inputs (C scales with a power), and two logarithms.
    let inputs = 8.0 + (1.0 - scene.n.approx()).abs() * ln_s.approx();
    let tangents = [scene.tangent(1.0, &a), smaller.tangent(1.0, &a_smaller)];
    let errors: f64 = tangents.iter().map(|t| t.radius() + t.ln_a.abs() + inputs / t.excess()).sum();
    let allowed = errors / ln_s.approx() + 4.0;
    trial.compare("dimension of a_c", &exponent_of(&a, &a_smaller), &s.lit(1), allowed);

    let printed = exponent_of(&printed_radius(&scene)?, &printed_radius(&smaller)?);
    let distance = ((printed - s.lit(1)).abs() / s.unit_roundoff()).approx();
    trial.demand("(1.15) as printed is no length", distance > allowed);
    Ok(())
}
