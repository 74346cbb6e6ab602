//! Critical states: the folds that the numerical route finds by tangency, or by the procedure of the paper taken literally,
//! discrete springs, the outer ones detaching by the rule of Heß; against the closed forms.

use std::sync::Arc;

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Control, Error, Fold, FoldKind, Outcome, Result};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::folds;
use mdr_numeric::profiles::Heights;
use mdr_numeric::springs::Foundation;
use mdr_numeric::transform::Quadrature;

use super::common::{Machine, Quadratures, compare, part, transform};
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::trial::Trial;

/// The folds. In f64, and in every eighth case of arbitrary precision, by the search over all radii; in the others by
/// refinement of the tangency around the planted radius, which costs a hundredth.
pub(super) fn search<R: Arithmetic>(
    transform: &Arc<Quadrature<R, Heights<R>>>,
    scene: &Scene<R>,
    control: &Control<R>,
    round: usize,
    planted: f64,
) -> Result<Vec<Fold<R>>> {
    let material = scene.material()?;
    if finds_all::<R>(round) {
        return Ok(folds(transform, &material, control)?.folds);
    }
    let curve = Contact::half_space(transform, &material, control);
    let near = R::from_f64(scene.n.ctx(), planted);
    let ratio = |a: &R| Ok(curve.tangency(a)? / curve.critical_ratio(a)? - a.lit(1));
    let mut folds = Vec::new();
    // Of two folds in one bracket nothing is seen: closer then.
    for k in [3, 6, 9, 12] {
        let spread = near.lit(1) + near.lit(2).powi(-k);
        let Some(bracket) = Bracket::new(&(near.clone() / &spread), &(near.clone() * spread), ratio)? else { continue };
        let kind = if bracket.lower.f < bracket.upper.f { FoldKind::Minimum } else { FoldKind::Maximum };
        let contact_radius = roots::refine(bracket, &scene.n.unit_roundoff(), ratio)?.value;
        let (indentation, force) = curve.state(&contact_radius)?;
        folds.push(Fold { contact_radius, indentation, force, kind });
        break;
    }
    Ok(folds)
}

/// Whether [`search`] looks at all radii.
fn finds_all<R: Arithmetic>(round: usize) -> bool {
    R::NAME == f64::NAME || round.is_multiple_of(8)
}

/// Which exponents: in f64 a radius magnified by more than 2⁴⁰ has no digit left to compare.
fn family<R: Arithmetic>() -> Family {
    Family::up_to(if R::NAME == f64::NAME { 36 } else { 40 })
}

/// a, d and F of the critical state under a control.
pub(super) fn critical<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx, held: Held) -> Result<()> {
    let exponent = trial.exponent(round, family::<R>());
    let scales = trial.scales::<R>(round, exponent);
    let scene: Scene<R> = trial.planted(exponent, held.lambda(), scales, ctx);
    let (material, control) = (scene.material()?, held.control());
    let state = trial.closed.critical(&scene.contact()?, &control)?;
    let transform = transform(&scene)?;
    let found = search(&transform, &scene, &control, round, scales.radius)?;
    trial.demand("one fold", found.len() == 1);
    let Some(fold) = found.first() else { return Ok(()) };
    let closed = Fold {
        contact_radius: state.contact_radius,
        indentation: state.indentation,
        force: state.force,
        kind: if scene.n < scene.n.ratio(1, 2) { FoldKind::Maximum } else { FoldKind::Minimum },
    };
    let tangent = scene.tangent(held.lambda(), &fold.contact_radius);
    let errors = Quadratures::at(&transform, tangent.n, &fold.contact_radius)?;
    let radii = (tangent.radius(), tangent.found_radius(errors.slope));
    compare(trial, &closed, fold, &material, tangent, radii, errors);
    Ok(())
}

/// All folds of a machine, up to three.
pub(super) fn machine<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let nearest = if R::NAME == f64::NAME { 5 } else { 16 };
    let machine = trial.machine::<R>(round, Family::up_to(nearest), ctx);
    let Machine { scene, stiffness, .. } = &machine;
    let material = scene.material()?;
    let control = Control::machine(stiffness.clone())?;
    let closed = match trial.closed.machine_folds(&scene.contact()?, stiffness) {
        Err(Error::OutOfRange { quantity, log10 }) => return machine.is_beyond(trial, quantity, log10),
        closed => closed?,
    };
    let transform = transform(scene)?;
    let found = search(&transform, scene, &control, round, machine.radius)?;
    trial.demand(
        "the number of folds",
        if finds_all::<R>(round) { closed.len() == found.len() } else { !found.is_empty() },
    );
    for found in &found {
        let distance = |fold: &Fold<R>| (fold.contact_radius.clone() / &found.contact_radius).ln().abs().approx();
        let Some(closed) = closed.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) else { continue };
        let share = found.contact_radius.clone() * &scene.e_star / stiffness;
        let share = share.times(2);
        let s = share.approx();
        let tangent = scene.tangent(1.0 + 2.0 * part(s), &found.contact_radius);
        let errors = Quadratures::at(&transform, tangent.n, &found.contact_radius)?;
        // |φ'| = |μ − 2s/((1+s)(1+3s))|, in place of n − ½.
        let steepness = (tangent.n - 0.5 - 2.0 * part(s) / (1.0 + 3.0 * s)).abs();
        let closed_radius = machine.balance(&share) / steepness + 2.0;
        let found_radius = (tangent.found_radius(errors.slope) - 4.0) * tangent.excess() / 2.0 / steepness + 4.0;
        compare(trial, closed, found, &material, tangent, (2.0 * closed_radius, found_radius), errors);
    }
    Ok(())
}

/// (1.15) as printed against the fold: it is the reciprocal, so it must miss wherever a_c is not 1 m.
pub(super) fn printed<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, most: 20.0, nearest: 12 });
    let scales = trial.scales::<R>(round, exponent);
    let scene: Scene<R> = trial.planted(exponent, 1.0, scales, ctx);
    let transform = transform(&scene)?;
    let found = search(&transform, &scene, &Control::Indentation, round, scales.radius)?;
    let Some(fold) = found.first() else { return Ok(()) };
    let a = &fold.contact_radius;
    let tangent = scene.tangent(1.0, a);
    let errors = Quadratures::at(&transform, tangent.n, a)?;
    let allowed = tangent.radius() + tangent.found_radius(errors.slope);
    let corrected = trial.closed.critical(&scene.contact()?, &Control::Indentation)?.contact_radius;
    let distance = |radius: R| ((radius / a).ln() / a.unit_roundoff()).abs().approx();
    trial.enter("ln a_c", distance(corrected), allowed);
    trial.demand("(1.15) as printed misses the fold", distance(super::identities::printed_radius(&scene)?) > allowed);
    Ok(())
}

/// Critical states of a foundation of springs at spacing Δx = a_c/N against the closed forms, at their order.
///
/// * a: the last spring to let go stands within Δx/2 of a_c: 1/2N;
/// * d: the extremum of d(a) sampled within Δx/2 of it, d''a² = ¼(2n−1)Δl there: |2n−1|/32N² of Δl;
/// * F: the two half strips at the edge, and F'(a)|_d = −2E*Δl over Δx/2: together 1/N of 2E*aΔl;
/// * each times (1 + (n+3)/N)², for the derivatives one order higher across Δx.
pub(super) fn foundation(trial: &mut Trial<'_>) -> Result<()> {
    let round = trial.index;
    let n = if round.is_multiple_of(3) { trial.uniform(0.1, 0.45) } else { trial.uniform(0.6, 6.0) };
    let springs = [100, 200, 400][round / 3 % 3];
    let exponent = Exponent::Double(n);
    let scene: Scene<f64> = trial.scene(round, exponent, 1.0, ());
    trial.describe_also(format_args!("N = {springs}"));
    let (contact, material) = (scene.contact()?, scene.material()?);
    let state = trial.closed.critical(&contact, &Control::Indentation)?;
    let a = state.contact_radius;
    let transform = transform(&scene)?;
    let reach = 2 * springs;
    let spacing = a / springs as f64;
    let foundation = Foundation::new(&*transform, &material, spacing, reach)?;
    let pull_off = n > 0.5;
    let (cascades, end) = if pull_off {
        (foundation.pull(reach, &Control::Indentation)?, Outcome::Detached)
    } else {
        (foundation.press(1, &Control::Indentation)?, Outcome::CompleteContact)
    };
    trial.demand("one instability, and what it ends in", cascades.len() == 1 && cascades[0].outcome == end);
    let Some(cascade) = cascades.first() else { return Ok(()) };
    let found = &cascade.instability;

    let count = springs as f64;
    let higher = (1.0 + (n + 3.0) / count).powi(2);
    let elongation = mdr_analytic::detachment_elongation(&material, &a)?;
    let scale = 2.0 * scene.e_star * a * elongation;
    // Under pressure the spring named is the last one before the jump: the critical one is its outer neighbour.
    let radius = if pull_off { found.contact_radius } else { found.contact_radius + spacing };
    trial.enter("a", (radius / a - 1.0).abs(), 0.5 / count * higher);
    let allowed = (2.0 * n - 1.0).abs() / (32.0 * count * count) * higher + 1e-12;
    trial.enter("d/Δl", ((found.indentation - state.indentation) / elongation).abs(), allowed);
    let strip = if pull_off { 0.0 } else { 1.0 / count };
    trial.enter("F/2E*aΔl", ((found.force - state.force) / scale).abs(), (1.0 / count + strip) * higher);
    Ok(())
}
