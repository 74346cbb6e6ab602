//! Two works of adhesion: the closed forms of power laws against paths by quadrature.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Edge, Fold, FoldKind, Result, Transform};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::path::{Dissipation, EdgeEnergies, Edges, Event, EventKind, Path, Start};

use super::common::{Quadratures, compare, transform};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Held, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// Jump-in, reversal and pull-off between w₁ = s²w and w: the state that breaks, the load that full pull-off needs, the least
/// ratio of the works, and under fixed grips the energies lost.
///
/// The closed forms are taken at the radius at which the path is pinned, so that its error does not enter. A fold and a jump have
/// the errors of their radii, as in the checks without hysteresis.
pub(super) fn loops<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 0.6, most: 6.0, nearest: 2 });
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let (root, reach) = (trial.uniform(0.05, 0.95), 10_f64.powf(trial.uniform(-0.5, 0.5)));
    trial.describe_also(format_args!("{held}, s = {root}, a/a_λ = {reach}"));
    let (contact, control) = (scene.contact()?, held.control());
    let (n, s) = (scene.n.clone(), R::from_f64(ctx, root));
    let advancing = scene.work.clone() * s.square();
    let transform = transform(&scene)?;
    let adhesion = Adhesion::hysteretic(advancing.clone(), scene.work.clone())?;
    let both = Contact::new(transform.clone(), Medium::half_space(scene.e_star.clone())?, adhesion, control.clone());
    let inner = SearchedBranches::new(both.at(Edge::Advancing))?;
    let outer = SearchedBranches::new(both.at(Edge::Receding))?;
    let Some(fold) = outer.folds().first() else {
        trial.fail("a receding edge has a fold");
        return Ok(());
    };
    // Beyond the jump into contact, whose radius is (λ'/λ)^(2/(2n−1)) that of the fold, and not beside the fold.
    let lambda = held.lambda();
    let double = held.of([2.0, 2.0]) * (n.approx() + held.of([0.0, 1.0]));
    let touched = (double * root / lambda).powf(2.0 / (2.0 * n.approx() - 1.0));
    let reach = reach.max(1.1 * touched);
    let reach = if reach.ln().abs() < 0.05 { 1.2 * reach } else { reach };
    let turn = both.at(Edge::Advancing).controlled(&(R::from_f64(ctx, reach) * &fold.contact_radius))?;
    let apart = control.controlled(&fold.indentation, &fold.force).times(4);
    let edges = Edges::new(&both, &inner, &outer);
    let path = Path::follow_edges(&edges, &Start::Detached, &[apart.clone(), turn, apart], None)?;
    let [_, jump, _, pinned, _, breaks, _] = path.events.as_slice() else {
        trial.fail("jump-in, reversal and pull-off");
        return Ok(());
    };
    trial.demand("jump-in and pull-off", [jump.kind, breaks.kind] == [EventKind::JumpIn, EventKind::Detached]);
    let rests = [&jump.after, &pinned.after, &breaks.before].map(|state| state.contact());
    let [Some(jumped), Some(pinned), Some(rest)] = rests else {
        trial.fail("in contact");
        return Ok(());
    };

    let found = Fold { kind: FoldKind::Minimum, ..fold.clone() };
    let tangent = scene.tangent(lambda, &fold.contact_radius);
    let errors = Quadratures::at(&transform, n.approx(), &fold.contact_radius)?;
    let radii = (tangent.radius(), tangent.found_radius(errors.slope));
    let at_pin = Quadratures::at(&transform, n.approx(), &pinned.contact_radius)?;
    let terms = at_pin.g + at_pin.mean + TRANSFORM + ELONGATION + 16.0;

    // The state in which the contact breaks.
    let closed = trial.closed.pull_off_from(&contact, &pinned.contact_radius, &control)?;
    let closed = Fold {
        contact_radius: closed.contact_radius,
        indentation: closed.indentation,
        force: closed.force,
        kind: found.kind,
    };
    let full = reach > 1.0;
    // Lengths and forces that are added in d and F.
    let length = |a: &R| -> Result<R> { Ok(contact.detachment_elongation(a)? + contact.profile().g(a)?) };
    let load = |a: &R| -> Result<R> { Ok(length(a)? * a * scene.e_star.clone().times(2)) };
    if full {
        let found = Fold {
            contact_radius: rest.contact_radius.clone(),
            indentation: rest.indentation.clone(),
            force: rest.force.clone(),
            ..found
        };
        compare(trial, &closed, &found, &scene.material()?, tangent, radii, errors);
    } else {
        trial.compare("a", &rest.contact_radius, &closed.contact_radius, 1.0);
        trial.compare_on("d", &rest.indentation, &closed.indentation, &length(&pinned.contact_radius)?, terms);
        trial.compare_on("F", &rest.force, &closed.force, &load(&pinned.contact_radius)?, terms);
    }

    // The load of an advancing edge at the radius of the fold: along it the terms change at most n + 3/2 times as the radius.
    let preload = trial.closed.preload_for_full_pull_off(&contact, &advancing, &control)?;
    let by_quadrature = both.at(Edge::Advancing).controlled(&fold.contact_radius)?;
    let scale = if held == Held::Force { load(&fold.contact_radius)? } else { length(&fold.contact_radius)? };
    let allowed = (n.approx() + 1.5) * (radii.0 + radii.1) + errors.g + errors.mean + TRANSFORM + ELONGATION + 40.0;
    trial.compare_on("preload", &by_quadrature, &preload, &scale, allowed);

    // The radius after the jump into contact over that of the fold is (s²/ratio)^(1/(2n−1)).
    let ratio = trial.closed.least_ratio_for_full_pull_off(&n, &control)?;
    let share = (fold.contact_radius.clone() / &jumped.contact_radius).pow(&(n.clone().times(2) - n.lit(1)));
    let at_jump = Quadratures::at(&transform, n.approx(), &jumped.contact_radius)?;
    let balance = 2.0 * (at_jump.g + at_jump.mean + TRANSFORM + ELONGATION + 8.0) / tangent.excess() + 4.0;
    let allowed = tangent.excess() * (balance + radii.1 + 2.0 * touched.ln().abs() + 2.0) + 16.0;
    trial.compare("w₁/w₂", &(s.square() * share), &ratio, allowed);

    if held == Held::Indentation {
        let spent = Spent { jump, breaks, edges: EdgeEnergies::new(&inner, &outer), full, radii, balance, terms };
        spent.compare(trial, &scene, &path, [&advancing, &pinned.contact_radius, &jumped.contact_radius], &length)?;
    }
    Ok(())
}

/// What is lost on a path, and the errors of its radii.
struct Spent<'a, R: Arithmetic> {
    jump: &'a Event<R>,
    breaks: &'a Event<R>,
    edges: EdgeEnergies<'a, R>,
    /// Whether the contact breaks at the fold.
    full: bool,
    radii: (f64, f64),
    balance: f64,
    terms: f64,
}

impl<R: Arithmetic> Spent<'_, R> {
    /// Enters the energies lost in the jumps and by the receding edge.
    fn compare(
        &self,
        trial: &mut Trial<'_>,
        scene: &Scene<R>,
        path: &Path<R>,
        [advancing, pinned, jumped]: [&R; 3],
        length: &dyn Fn(&R) -> Result<R>,
    ) -> Result<()> {
        let contact = scene.contact()?;
        let closed = trial.closed.loop_work(&contact, advancing, pinned)?;
        let unit = |a: &R, work: &R| a.pi() * a * a * work;
        let error = |lost: &Estimate<R>, unit: &R| (lost.error.clone() / unit / unit.unit_roundoff()).approx();
        let mut hysteresis = pinned.lit(0);
        for (event, loss) in path.events.iter().zip(self.edges.losses(path)) {
            let loss = loss?;
            hysteresis += &loss.hysteresis;
            let Dissipation::Finite(lost) = &loss.jump else {
                trial.fail("what is lost under fixed grips is finite");
                return Ok(());
            };
            if std::ptr::eq(event, self.jump) {
                let unit = unit(jumped, advancing);
                let allowed = error(lost, &unit) + 2.0 * (self.radii.0 + self.balance) + 24.0;
                trial.compare_on("jump-in", &lost.value, &closed.jump_in, &unit, allowed);
            } else if std::ptr::eq(event, self.breaks) && self.full {
                let radius = event.before.contact().map_or_else(|| pinned.clone(), |rest| rest.contact_radius.clone());
                let unit = unit(&radius, &scene.work);
                let allowed = error(lost, &unit) + 2.0 * (self.radii.0 + self.radii.1) + 24.0;
                trial.compare_on("pull-off", &lost.value, &closed.pull_off, &unit, allowed);
            } else if std::ptr::eq(event, self.breaks) {
                // E*a times the square of lengths, of which Δl alone gives 2πa²w.
                let ratio = length(pinned)? / contact.detachment_elongation(pinned)?;
                let unit = unit(pinned, &scene.work) * ratio.square().times(3);
                trial.compare_on(
                    "pull-off",
                    &lost.value,
                    &closed.pull_off,
                    &unit,
                    error(lost, &unit) + 4.0 * self.terms,
                );
            }
        }
        let more = scene.work.clone() - advancing;
        let scale = unit(pinned, &scene.work);
        trial.compare_on("hysteresis", &hysteresis, &unit(pinned, &more), &scale, 32.0);
        trial.compare_on("closed hysteresis", &hysteresis, &closed.hysteresis, &scale, 32.0);
        Ok(())
    }
}
