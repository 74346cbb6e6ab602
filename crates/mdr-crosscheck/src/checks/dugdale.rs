//! Adhesion of finite range: the numerical route of Maugis and Dugdale against the closed equations of Maugis (1992) for the
//! paraboloid, against the gap of the heights for the profiles of the library, and the pull-off force against its limits.

use std::sync::Arc;

use mdr_analytic::profiles::closed_form;
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::calculus::Tolerance;
use mdr_core::calculus::quadrature::tanh_sinh_pieces;
use mdr_core::contact::{Control, Error, Material, Profile, Result, Shape, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::dugdale::{CohesiveState, Dugdale, tabor_number};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use rug::Float;

use super::common::Drawn;
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Held};
use crate::trial::Trial;

/// The ring of attraction by quadrature put into the closed equations, which are also enclosed: over intervals of twice the
/// precision the balance is proved to pass through 1 within the error that is allowed for c.
///
/// * The closed equations do 40 roundings; they cancel by 1/(m − 1), and so does c − a.
/// * The quadrature errs by 32 roundings of its terms, of which g(a)θ is the largest beside h₀.
pub(super) fn paraboloid<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let [radius, e_star, work] = [(); 3].map(|()| 10_f64.powf(trial.uniform(-9.0, 9.0)));
    let (lambda, reduced) = (10_f64.powf(trial.uniform(-1.3, 1.0)), trial.uniform(0.3, 3.0));
    let modulus = 4.0 * e_star / 3.0;
    let adhesion = std::f64::consts::PI * work;
    let separation = 2.0 * work / lambda * (radius / (adhesion * modulus * modulus)).cbrt();
    let a = reduced * (adhesion * radius * radius / modulus).cbrt();
    trial.describe(format_args!(
        "λ = {lambda:e}, ã = {reduced}, R = {radius:e}, E* = {e_star:e}, w = {work:e} ({})",
        R::NAME
    ));
    let [r, e, w, h0, a] = [radius, e_star, work, separation, a].map(|value| R::from_f64(ctx, value));

    let material = Material::new(e.clone(), w.clone())?;
    let heights = Arc::new(Quadrature::of([Shape::Paraboloid { radius: r.clone() }])?);
    let curve = Contact::half_space(&heights, &material, &Control::Force);
    let state = Dugdale::new(curve.clone(), &h0)?.state(&a)?;
    let c = &state.outer_radius;
    let closed = trial.closed.maugis_state(&r, &material, &h0, [&a, c])?;
    let thin = (a.clone() / (c.clone() - &a)).approx();
    let strength = w.clone() / &h0 / &e;
    let leg = (c.clone() - &a).sqrt() * (c.clone() + &a).sqrt();
    let terms = ((a.square() / &r) * (leg.clone() / &a).atan() / &h0).approx();
    let allowed = 40.0 * (1.0 + thin) + 160.0 * (1.0 + terms);
    trial.compare("gap at c", &closed.balance, &closed.balance.lit(1), allowed);
    let depth = (strength * &leg).times(2) + a.square() / &r;
    trial.compare_on("d", &state.indentation, &closed.indentation, &depth, 40.0 * (2.0 + thin));
    let scale = depth * (c.clone() + &a) * &e * (c.clone() / &a);
    trial.compare_on("F", &state.force, &closed.force, &scale, 40.0 * (2.0 + thin));
    enclose(trial, [&r, &e, &w, &h0, &a], c, allowed)?;

    let pull_off =
        PowerLawContact::new(PowerLaw::paraboloid(r.clone())?, material.clone()).critical(&Control::Force)?;
    let tabor = trial.closed.tabor_number(&r, &material, &h0)?;
    // a_F errs by a third of the roundings under its root, μ by as many under its own.
    trial.compare("Tabor", &tabor_number(&curve, &pull_off.contact_radius, &h0)?, &tabor, 40.0);
    Ok(())
}

/// Proves the balance to be below 1 at a ring that is narrower by the allowed error, and above 1 at one that is wider by it.
fn enclose<R: Arithmetic>(trial: &mut Trial<'_>, inputs: [&R; 5], c: &R, allowed: f64) -> Result<()> {
    let bits = Precision::new(2 * c.precision());
    let exact = |value: &R| Interval::point(Float::with_val(bits.bits(), value.widen()));
    let [r, e, w, h0, a] = inputs.map(exact);
    let material = Material::new(e, w)?;
    let ring = exact(c) - &a;
    let error = exact(&c.unit_roundoff()) * Interval::from_f64(bits, allowed) * &ring;
    let balance = |end: Interval| trial.closed.maugis_state(&r, &material, &h0, [&a, &end]).map(|state| state.balance);
    let (below, above) = (balance(exact(c) - &error)?, balance(exact(c) + error)?);
    let holds = below < below.lit(1) && above > above.lit(1);
    trial.demand("c is enclosed", holds);
    Ok(())
}

/// Maugis–Dugdale states of fifteen profiles, from closed forms of g over a < x < c, against the heights: the gap at c is
/// f(c) − d + u(c), with u of the contact and of the ring, and F is the sum of both. It errs by 32 roundings of its terms.
///
/// * The width of the ring is found to a rounding, and c is rounded: by 2u c. That changes f by 2u c f'(c), where f' is the
///   larger on both sides of c, since c may be beside a kink; and d and u by their condition c/(c − a).
pub(super) fn profile<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let profile = Drawn::<R>::draw(trial, ctx);
    let beyond = trial.uniform(0.0, 1.0) < 0.7;
    let a = profile.radius(trial, beyond, ctx)?;
    let transform: Arc<dyn Transform<R>> = Arc::from(profile.closed::<R>()?);
    let e_star = R::from_f64(ctx, 10_f64.powf(trial.uniform(-9.0, 9.0)));
    // A separation and an opening near the height of the contact.
    let height = transform.slope(&a)?.abs().greater(&profile.steepness().over(16)) * &a;
    let h0 = height.clone() * R::from_f64(ctx, 10_f64.powf(trial.uniform(-1.5, 0.0)));
    let strength = height / &a * R::from_f64(ctx, 10_f64.powf(trial.uniform(-1.0, 0.5)));
    let work = strength.clone() * &e_star * &h0 / e_star.lit(2);
    let [at, opening, s] = [&a, &h0, &strength].map(R::approx);
    trial.describe(format_args!("{profile}, a = {at:e}, h0 = {opening:e}, s = {s:e} ({})", R::NAME));
    let material = Material::new(e_star.clone(), work)?;
    let contact = Dugdale::new(Contact::half_space(&transform, &material, &Control::Force), &h0)?;
    let state = match contact.state(&a) {
        // The ring would reach beyond the equator of a sphere.
        Err(Error::Domain { .. }) if transform.outer_radius().is_some() => return Ok(()),
        state => state?,
    };
    let CohesiveState { outer_radius: c, indentation: d, force, .. } = &state;
    let leg = (c.clone() - &a).sqrt() * (c.clone() + &a).sqrt();
    let angle = (a.clone() / &leg).atan();
    let tolerance = Tolerance::of_cancelling(&a);
    let breaks: Vec<R> =
        transform.kinks().iter().filter(|kink| **kink < a).map(|kink| (kink.clone() / c).asin()).collect();
    let mut largest = d.abs();
    let displaced = tanh_sinh_pieces(&a.lit(0), &angle, &breaks, tolerance, |angle| {
        let g = transform.g(&(angle.sin() * c).lesser(&a).greater(&(a.clone() * a.unit_roundoff())))?;
        largest = largest.greater(&g.abs());
        Ok(d.clone() - g)
    })?;
    let equator = (c.clone() - &a) * &strength;
    let f = profile.heights()?.height(c);
    if !f.is_finite() {
        // The heights of a dimple end at its edge.
        return Ok(());
    }
    let steep = steepest(&profile.heights()?, c);
    let gap = f.clone() - d + (displaced.value - &equator) * (a.lit(2) / a.pi());
    let scale = f.abs() + &largest + equator + &h0;
    let rounded = (steep * c / &scale).approx();
    let allowed = 400.0 + 4.0 * a.clone().greater(c).approx() / (c.clone() - &a).approx() + 2.0 * rounded;
    trial.compare_on("gap at c", &gap, &h0, &scale, allowed);
    let ring = (c.square() * (leg.clone() / &a).atan() - a.clone() * &leg) * &strength * &e_star;
    let inner = (a.clone() * d - transform.integral(&a)?) * e_star.times(2);
    let scale = (largest * &a + strength * leg * c) * contact.contact().modulus().clone().times(2);
    trial.compare_on("F", force, &(inner - ring), &scale, 400.0);
    Ok(())
}

/// The larger of |f'| within four roundings on both sides of a radius.
fn steepest<R: Arithmetic>(heights: &Heights<R>, r: &R) -> R {
    let beside = [-4, 4].map(|roundings| r.unit_roundoff().times(roundings) * r + r);
    let [inner, outer] = beside.map(|r| heights.height(&Dual::variable(r)).slope.abs());
    // The heights of a dimple end at its edge.
    if outer.is_finite() { inner.greater(&outer) } else { inner }
}

/// The pull-off force of power laws n > 1/2: least among its neighbours, where a parabola through three of them has its
/// vertex, and that of short range but for the term of first order in h₀ when μ is large.
pub(super) fn pull_off(trial: &mut Trial<'_>) -> Result<()> {
    let round = trial.index;
    let n = if round.is_multiple_of(4) { 2.0 } else { trial.uniform(0.7, 4.0) };
    let scene = trial.scene::<f64>(round, Exponent::Double(n), Held::Force.lambda(), ());
    let tabor = 10_f64.powf(trial.uniform(-2.0, 4.0));
    trial.describe_also(format_args!("μ = {tabor:e}"));
    let jkr = scene.contact()?.critical(&Control::Force)?;
    let transform: Arc<dyn Transform<f64>> = Arc::from(closed_form(Shape::Power { n: scene.n, c: scene.c })?);
    let material = scene.material()?;
    let curve = Contact::half_space(&transform, &material, &Control::Force);
    let separation = tabor_number(&curve, &jkr.contact_radius, &1.0)? / tabor;
    let contact = Dugdale::new(curve, &separation)?;
    let Some(state) = contact.pull_off(&[jkr.contact_radius])? else {
        trial.fail("no pull-off");
        return Ok(());
    };
    is_vertex(trial, &contact, &state, n)?;
    let change = (state.force / jkr.force - 1.0).abs();
    // The ring is a share π h₀/(s a) = O(1/μ) of the contact, and so is the change of the force.
    trial.enter("change of F", change, 3.0 * (n + 2.0).powi(2) / tabor);
    if n == 2.0 {
        let dmt = state.force / jkr.force * 0.75;
        trial.demand("between JKR and DMT", dmt > 0.75 - 1e-12 && dmt < 1.0);
        trial.enter("DMT limit", 1.0 - dmt, 0.7 * tabor.powf(0.75).min(1.0));
    }
    Ok(())
}

/// The state has the least force among its neighbours, and a parabola through three of them has its vertex there.
///
/// The force is known to 10⁻¹⁴. Where the adhesion has a long range, F hardly changes with a, so that the neighbours are taken
/// farther away, up to a half of a, until the bend of the parabola exceeds what is not known of it a thousand times.
fn is_vertex(trial: &mut Trial<'_>, contact: &Dugdale<f64>, state: &CohesiveState<f64>, n: f64) -> Result<()> {
    let noise = 1e-14 * state.force.abs();
    let mut step = 1.0 / 1024.0;
    loop {
        let beside = |k: f64| contact.state(&(state.contact_radius * k)).map(|state| state.force);
        let (below, above) = (beside(1.0 - step)?, beside(1.0 + step)?);
        trial.demand("F is least", state.force <= below.min(above) + 2.0 * noise);
        let (tilt, bend) = ((above - below) / 2.0, above + below - 2.0 * state.force);
        if bend > 1000.0 * noise {
            // The third derivative moves the vertex by step² of a.
            trial.enter(
                "vertex",
                (tilt / bend * step).abs(),
                step * step * 4.0 * (n + 2.0) + 4.0 * noise / bend * step,
            );
            return Ok(());
        }
        if step >= 0.5 {
            return Ok(());
        }
        step *= 2.0;
    }
}
