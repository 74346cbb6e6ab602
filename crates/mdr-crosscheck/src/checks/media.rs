//! Critical states on other media than the half-space: closed forms against the numeric route, which has nothing but the heights
//! f(r), the weight of the medium in a quadrature, and the tangency of g − d to Δl.

use mdr_analytic::media::{GradedContact, GradedHalfSpace, JohnsonWave, LineContact, WaveControl};
use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{
    Control, Error, Expression, ExpressionError, Fold, FoldKind, Material, Quantity, Result, Shape, Transform,
};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::{LineLoad, Periodic, Weighted};

use super::graded::kappa_roundings;
use crate::arithmetic::Arithmetic;
use crate::trial::Trial;

/// Roundings of a quadrature with the weight of a medium: its goal of 128, and four of what it is multiplied with.
const QUADRATURE: f64 = 132.0;

/// The folds of a contact: in f64 by the search over all radii, in other arithmetics by tangency around the planted ones.
fn found<R: Arithmetic>(contact: &Contact<R>, planted: &[R]) -> Result<Vec<Fold<R>>> {
    if R::NAME == f64::NAME {
        return Ok(folds::find(contact)?.folds);
    }
    let ratio = |a: &R| Ok(contact.tangency(a)? / contact.critical_ratio(a)? - a.lit(1));
    let mut all = Vec::new();
    for near in planted {
        let spread = near.lit(1) + near.ratio(1, 64);
        let Some(bracket) = Bracket::new(&(near.clone() / &spread), &(near.clone() * spread), ratio)? else { continue };
        let kind = if bracket.lower.f < bracket.upper.f { FoldKind::Minimum } else { FoldKind::Maximum };
        let contact_radius = roots::refine(bracket, &near.unit_roundoff(), ratio)?.value;
        let (indentation, force) = contact.state(&contact_radius)?;
        all.push(Fold { contact_radius, indentation, force, kind });
    }
    Ok(all)
}

/// The closed forms of folds as a, d and F, against those that are found.
fn compare<R: Arithmetic>(
    trial: &mut Trial<'_>,
    contact: &Contact<R>,
    closed: &[[R; 3]],
    allowed: impl Fn(&R) -> Result<[f64; 2]>,
) -> Result<()> {
    let planted: Vec<R> = closed.iter().map(|[a, ..]| a.clone()).collect();
    let found = found(contact, &planted)?;
    trial.demand("as many folds", found.len() == closed.len());
    for ([a, d, force], fold) in closed.iter().zip(&found) {
        let [radius, value] = allowed(a)?;
        let length = contact.transform().g(a)?.abs() + contact.detachment_elongation(a)?;
        trial.compare("a", a, &fold.contact_radius, radius);
        if contact.medium().has_depth() {
            trial.compare_on("d", d, &fold.indentation, &length, value);
        }
        let scale = contact.medium().stiffness(a) * &length;
        trial.compare_on("F", force, &fold.force, &scale, value);
    }
    Ok(())
}

/// Power laws on graded half-spaces and Winkler foundations, at grips, under a load and on a machine.
pub(super) fn graded<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let k = if round % 4 == 3 { 1.0 } else { trial.uniform(-0.8, 0.8) };
    let threshold = (1.0 - k) / 2.0;
    let n = if round % 3 == 1 && k < 0.6 {
        threshold * trial.uniform(0.4, 0.8)
    } else {
        threshold + trial.uniform(0.2, 3.0)
    };
    let mut draw = || 10_f64.powf(trial.uniform(-1.0, 1.0));
    let [c, coefficient, work, stretch] = [draw(), draw(), 0.01 * draw(), draw()];
    trial.describe(format_args!("n = {n}, k = {k}, C = {c:e}, c = {coefficient:e}, w = {work:e} ({})", R::NAME));
    let [n_, k_, c, coefficient, work] = [n, k, c, coefficient, work].map(|value| R::from_f64(ctx, value));
    let tip = Heights::new([Shape::Power { n: n_.clone(), c: c.clone() }])?;
    let (half_space, medium, transform) = if k == 1.0 {
        let half_space = GradedHalfSpace::winkler(coefficient.clone(), work.clone())?;
        (half_space, Medium::winkler(coefficient)?, Weighted::winkler(tip, n_.clone()))
    } else {
        let half_space = GradedHalfSpace::new(k_.clone(), coefficient.clone(), work.clone())?;
        (half_space, Medium::graded(coefficient, k_.clone())?, Weighted::graded(tip, k_))
    };
    let closed = GradedContact::new(n_, c, half_space)?;
    let transform: std::sync::Arc<dyn Transform<R>> = std::sync::Arc::new(transform);
    // ln of the tangency ratio has the slope n − (1 − k)/2 in ln a, and on a machine one that vanishes where folds merge.
    let excess = (n - threshold).abs();
    let terms = |a: &R| QUADRATURE + kappa_roundings(n) + 4.0 * (n + 2.0) * (1.0 + a.ln().approx().abs());
    let contact = |control| -> Result<Contact<R>> {
        Ok(Contact::sharing(transform.clone(), medium.clone(), Adhesion::new(work.clone())?, control))
    };
    let mut controls = vec![Control::Force];
    if k < 1.0 {
        controls.push(Control::Indentation);
    }
    let mut near = None;
    for control in controls {
        let state = trial.closed.graded_critical(&closed, &control)?;
        near = near.or(Some(state.contact_radius.clone()));
        let states = [[state.contact_radius, state.indentation, state.force]];
        compare(trial, &contact(control)?, &states, |a| {
            let radius = terms(a) / excess;
            Ok([radius, 2.0 * (n + 2.0) * radius + 2.0 * terms(a)])
        })?;
    }
    let Some(near) = near else { return Ok(()) };
    let stiffness = closed.medium().punch_stiffness(&near)? * R::from_f64(ctx, stretch);
    let folds = match trial.closed.graded_machine_folds(&closed, &stiffness) {
        // On springs a fold goes to radii without bound as n goes to 2: `graded-folds` compares it in logarithms.
        Err(Error::OutOfRange { .. }) if k == 1.0 => return Ok(()),
        folds => folds?,
    };
    let on_machine = contact(Control::Machine { stiffness })?;
    let states: Vec<[R; 3]> =
        folds.into_iter().map(|fold| [fold.contact_radius, fold.indentation, fold.force]).collect();
    compare(trial, &on_machine, &states, |a| {
        // The slope of the ratio over its critical value, by a difference.
        let step = a.lit(1) + a.ratio(1, 1024);
        let ratio = |a: &R| Ok((on_machine.tangency(a)? / on_machine.critical_ratio(a)?).ln());
        let slope = ((ratio(&(step.clone() * a))? - ratio(a)?).times(1024)).approx().abs();
        let radius = 2.0 * terms(a) / slope;
        Ok([radius, 2.0 * (n + 2.0) * radius + 2.0 * terms(a)])
    })
}

/// Power laws in line contact under a load, and the depth of a cylinder against a reference.
pub(super) fn line<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let n = if round % 3 == 1 { trial.uniform(0.15, 0.4) } else { trial.uniform(0.65, 4.0) };
    let mut draw = || 10_f64.powf(trial.uniform(-1.0, 1.0));
    let [c, e_star, work, far] = [draw(), draw(), 0.01 * draw(), draw()];
    trial.describe(format_args!("n = {n}, C = {c:e}, E* = {e_star:e}, w = {work:e} ({})", R::NAME));
    let [n_, c, e, w] = [n, c, e_star, work].map(|value| R::from_f64(ctx, value));
    let material = Material::new(e.clone(), w.clone())?;
    let closed = LineContact::new(n_.clone(), c.clone(), material.clone())?;
    let tip = Heights::new([Shape::Power { n: n_.clone(), c }])?;
    let load = LineLoad::new(Box::new(Weighted::line(tip, None, n_)), None);
    let contact = Contact::new(load, Medium::plane(e.clone(), None)?, Adhesion::new(w.clone())?, Control::Force);
    let [b, force] = trial.closed.line_critical(&closed)?;
    let terms = |b: &R| QUADRATURE + kappa_roundings(n) + 4.0 * (n + 2.0) * (1.0 + b.ln().approx().abs());
    compare(trial, &contact, &[[b.clone(), b.lit(0), force]], |b| {
        let radius = terms(b) / (n - 0.5).abs();
        Ok([radius, 2.0 * (n + 2.0) * radius + 2.0 * terms(b)])
    })?;

    let radius = b.lit(1);
    let reference = R::from_f64(ctx, 1.0 + far) * &b;
    let ball = Heights::new([Shape::Paraboloid { radius: radius.clone() }])?;
    let load =
        LineLoad::new(Box::new(Weighted::line(ball, Some(reference.clone()), b.clone())), Some(reference.clone()));
    let medium = Medium::plane(e.clone(), Some(reference.clone()))?;
    let contact = Contact::new(load, medium, Adhesion::new(w)?, Control::Indentation);
    let (d, force) = contact.state(&b)?;
    let depth = trial.closed.cylinder_depth(&radius, &b, &(force / e), &reference)?;
    let length = contact.transform().g(&b)?.abs() + contact.detachment_elongation(&b)?;
    // Near the reference the depth per force is a small logarithm of their ratio.
    let near = (reference / &b - b.lit(1)).approx();
    trial.compare_on("depth of a cylinder", &depth, &d, &length, 2.0 * terms(&b) * (1.0 + 1.0 / near));
    Ok(())
}

fn no_formula(error: ExpressionError) -> Error {
    let (quantity, value) = (Quantity::Parameter("the formula of a wave"), error.to_string());
    Error::Domain { quantity, value, requirement: "a formula" }
}

/// Johnson's wave as any periodic profile, by load and by approach.
pub(super) fn wave<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let alpha = trial.uniform(0.1, 0.6);
    let compliance = [None, Some(0.0), Some(1.0), Some(3.0)][round % 4];
    trial.describe(format_args!("α = {alpha}, κ = {} ({})", compliance.unwrap_or(f64::INFINITY), R::NAME));
    let wave = JohnsonWave::of_alpha(R::from_f64(ctx, alpha))?;
    let one = wave.alpha().lit(1);
    let (by, control) = match compliance {
        None => (WaveControl::Load, Control::Force),
        Some(0.0) => (WaveControl::Approach { compliance: one.lit(0) }, Control::Indentation),
        Some(compliance) => {
            let compliance = R::from_f64(ctx, compliance);
            (
                WaveControl::Approach { compliance: compliance.clone() },
                Control::Machine { stiffness: one.pi() / compliance },
            )
        }
    };
    let formula: Expression = "1 - cos(2*pi*r)".parse().map_err(no_formula)?;
    let heights = formula.bind::<R>(ctx, &Default::default()).map_err(no_formula)?;
    let medium = Medium::periodic(one.clone(), one.clone())?;
    let work = (one.pi() * wave.alpha()).square().over(2);
    let contact = Contact::new(Periodic::new(heights, one.clone())?, medium, Adhesion::new(work)?, control);
    let states = trial.closed.wave_folds(&wave, &by)?.into_iter().map(|fold| {
        let half_width = fold.contact_radius / one.pi();
        let size = contact.medium().size_within(&half_width)?;
        Ok([size, one.clone() - fold.indentation, fold.force * one.pi()])
    });
    let states: Vec<[R; 3]> = states.collect::<Result<_>>()?;
    compare(trial, &contact, &states, |size| {
        let step = size.lit(1) + size.ratio(1, 1024);
        let ratio = |a: &R| Ok((contact.tangency(a)? / contact.critical_ratio(a)?).ln());
        let slope = ((ratio(&(step.clone() * size))? - ratio(size)?).times(1024)).approx().abs();
        let terms = QUADRATURE + 40.0 * (1.0 + size.ln().approx().abs());
        Ok([terms * 4.0 / slope, 16.0 * terms / slope + 4.0 * terms])
    })
}
