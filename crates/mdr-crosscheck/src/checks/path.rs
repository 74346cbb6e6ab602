//! Loading paths and the balance of their energy.

use std::sync::Arc;

use mdr_analytic::profiles as closed;
use mdr_core::contact::{Control, FoldKind, Material, Profile, Result, Shape, Stability, Transform};
use mdr_core::number::Real;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::fields::Fields;
use mdr_numeric::path::{Dissipation, EventKind, Path, PathEnergy, Start};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

use super::common::{Quadratures, transform};
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// Paths over waves so steep that the next crest is touched. Whatever the path does, no event of it gains energy; where it
/// ends because the surfaces meet, the gap f − d + u vanishes on the ring, with u an integral over the contact and not, as in
/// the search, over what is outside.
///
/// The bound is that of the quadratures, which stop at the noise of their integrands, on the scale of f, d and A.
pub(super) fn admissible(trial: &mut Trial<'_>) -> Result<()> {
    const NOISE: f64 = 3.0 * 4096.0;
    let scale = 10_f64.powf(trial.uniform(-20.0, 20.0));
    let wavelength = scale * 10_f64.powf(trial.uniform(-1.5, -0.5));
    let amplitude = (wavelength / scale).powi(2) * scale / 40.0 * 10_f64.powf(trial.uniform(0.5, 1.5));
    let work = scale * 10_f64.powf(trial.uniform(-6.0, -3.0));
    let control = control(trial.index, &scale)?;
    let ways: Vec<f64> = (0..4).map(|_| trial.uniform(-1.0, 3.0) * amplitude).collect();
    let ways: Vec<f64> = ways.into_iter().map(|d| if control == Control::Force { d * wavelength } else { d }).collect();
    trial.describe(format_args!(
        "R = {scale:e}, A = {amplitude:e}, λ = {wavelength:e}, w = {work:e}, {control:?}, {ways:?}"
    ));
    let profile = Arc::new(closed::WavyParaboloid::new(scale, amplitude, wavelength)?);
    let material = Material::new(1.0, work)?;
    let height = Heights::new([Shape::WavyParaboloid { radius: scale, amplitude, wavelength }])?;
    let curve = Contact::half_space(&profile, &material, &control);
    let branches = SearchedBranches::new(curve.clone())?;
    let Ok(path) = Path::follow(&branches, &Start::Smallest, &ways) else { return Ok(()) };
    let energies = PathEnergy::new(&path, &branches)?;
    let gains = |loss: &Dissipation<f64>| matches!(loss, Dissipation::Finite(dissipated) if dissipated.value < -dissipated.error);
    trial.demand("no event gains energy", !energies.entries.iter().any(|entry| gains(&entry.dissipated)));
    let Some(event) = path.events.last() else { return Ok(()) };
    if let (Some(ring), Some(rest)) = (&event.ring, event.after.contact())
        && ring.gap == 0.0
        && path.events.len() > 1
    {
        let f = height.height(&ring.radius);
        let lift = Fields::of(curve, rest)?.displacement(&ring.radius)?;
        let size = f + rest.indentation.abs() + amplitude;
        trial.compare_on("gap", &(f + lift), &rest.indentation, &size, NOISE);
    }
    Ok(())
}

/// Indentation, force, or a machine of the stiffness k.
fn control<R: Real>(turn: usize, stiffness: &R) -> Result<Control<R>> {
    match turn % 3 {
        0 => Ok(Control::Indentation),
        1 => Ok(Control::Force),
        _ => Control::machine(stiffness.clone()),
    }
}

/// work − lost = Π(end) − Π(start) along random paths of power laws, by quadrature, and of wavy paraboloids.
///
/// The bound is that of the energies of the path: errors of their quadratures, and the rounding of their integrands.
pub(super) fn balance<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let by_waves = !round.is_multiple_of(3);
    let n = if by_waves { 2.0 } else { [trial.uniform(0.6, 6.0), trial.uniform(0.2, 0.45)][round / 3 % 2] };
    let scales = trial.scales::<R>(round, Exponent::Double(n));
    let scene: Scene<R> = trial.planted(Exponent::Double(n), 1.0, scales, ctx);
    let material = scene.material()?;
    let length = R::from_f64(ctx, scales.radius);
    let stiffness = scene.e_star.clone() * &length * R::from_f64(ctx, 10_f64.powf(trial.uniform(-1.5, 1.5)));
    let control = control(round, &stiffness)?;
    if by_waves {
        // a²/2R + A(1 − cos 2πr/λ), A k²R of the order of one.
        let curvature = scene.c.clone().times(2).inv();
        let wavelength = length * R::from_f64(ctx, trial.uniform(0.5, 3.0));
        let steepness = R::from_f64(ctx, trial.uniform(0.2, 1.5));
        let amplitude = wavelength.square() / wavelength.pi().square() / curvature.clone().times(4) * steepness;
        trial.describe_also(format_args!("A = {:e}, λ = {:e}", amplitude.approx(), wavelength.approx()));
        let profile = closed::WavyParaboloid::new(curvature, amplitude, wavelength)?;
        balance_energy(trial, Contact::half_space(&Arc::new(profile), &material, &control))
    } else {
        balance_energy(trial, Contact::half_space(&transform(&scene)?, &material, &control))
    }
}

fn balance_energy<R: Arithmetic>(trial: &mut Trial<'_>, contact: Contact<R>) -> Result<()> {
    let control = contact.control().clone();
    let branches = SearchedBranches::new(contact)?;
    let Some(fold) = branches.folds().first() else { return Ok(()) };
    let unit = control.controlled(&fold.indentation, &fold.force).abs();
    // A pull-off by a dead load and complete contact have no finite energy.
    let (least, most) = match (fold.kind, &control) {
        (FoldKind::Maximum, _) => (-1.0, 0.9),
        (FoldKind::Minimum, Control::Force) => (-0.1, 4.0),
        (FoldKind::Minimum, _) => (-2.0, 4.0),
    };
    let ways: Vec<f64> = (0..4).map(|_| trial.uniform(least, most)).collect();
    trial.describe_also(format_args!("{:?}, way {ways:?}", control));
    let way: Vec<R> = std::iter::once(0.0).chain(ways).map(|x| R::from_f64(unit.ctx(), x) * &unit).collect();
    let path = Path::follow(&branches, &Start::Detached, &way)?;
    let overlaps = path.events.last().is_some_and(|event| event.kind == EventKind::NotAdmissible);
    trial.demand("the path comes to its end", path.is_finished() || overlaps);
    let energies = PathEnergy::new(&path, &branches)?;
    let mut positive = true;
    let mut scale = unit.lit(0);
    for entry in &energies.entries {
        scale += &entry.work.value.abs();
        if let Dissipation::Finite(dissipated) = &entry.dissipated {
            positive &= dissipated.value >= -dissipated.error.clone();
            scale += &dissipated.value.abs();
        }
    }
    trial.demand("no jump gains energy", positive);
    let Some(balance) = energies.balance(&path, &branches)? else {
        trial.fail("an energy is unbounded");
        return Ok(());
    };
    if scale > scale.lit(0) {
        let allowed = balance.bound / &scale / scale.unit_roundoff();
        trial.compare_on("balance", &(balance.work - &balance.dissipated), &balance.stored, &scale, allowed.approx());
    }
    Ok(())
}

/// Work lost at jump-in and pull-off, on the scale πa²w.
///
/// The integrands vanish at the radius of a fold or an equilibrium, so its error δ enters through πa²w only: 2δ times the
/// loss.
pub(super) fn losses<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 0.51, most: 12.0, nearest: 10 });
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    trial.describe_also(held);
    let (contact, material, control) = (scene.contact()?, scene.material()?, held.control());
    let transform = transform(&scene)?;
    let branches = SearchedBranches::new(Contact::half_space(&transform, &material, &control))?;
    let [zero, one] = [scene.n.lit(0), scene.n.lit(1)];
    let critical = contact.critical(&control)?;
    let beyond = control.controlled(&critical.indentation, &critical.force).times(2);
    let path = Path::follow(&branches, &Start::Detached, &[zero, beyond])?;
    let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
    let expected = [EventKind::Start, EventKind::JumpIn, EventKind::Detached, EventKind::End];
    trial.demand("jump-in and pull-off", kinds == expected);
    let energies = PathEnergy::new(&path, &branches)?;
    let unit = |a: &R| a.pi() * a * a * &scene.work;

    let start = contact.radius_at_zero_indentation()?;
    // Of πa²w lost, a loss at F = 0 has the same share as one at d = 0.
    let jump_in = trial.closed.energy_lost_at_jump_in(&contact)? / unit(&start);
    let fixed_grips = contact.critical(&Control::Indentation)?.contact_radius;
    let pull_off = trial.closed.energy_lost_at_pull_off(&contact)? / unit(&fixed_grips);
    for (entry, event) in energies.entries.iter().zip(&path.events) {
        let (share, name) = match event.kind {
            EventKind::JumpIn => (&jump_in, "jump-in"),
            EventKind::Detached => (&pull_off, "pull-off"),
            _ => continue,
        };
        let Dissipation::Finite(dissipated) = &entry.dissipated else {
            trial.demand("only a dead load is unbounded", held == Held::Force && event.kind == EventKind::Detached);
            continue;
        };
        let Some(rest) = event.after.contact().or(event.before.contact()) else { continue };
        let a = &rest.contact_radius;
        let errors = Quadratures::at(&transform, scene.n.approx(), a)?;
        let tangent = scene.tangent(held.lambda(), a);
        let balance = 2.0 * (errors.g + errors.mean + TRANSFORM + ELONGATION + 8.0) / tangent.excess() + 4.0;
        let radius = balance + tangent.found_radius(errors.slope);
        let error = (dissipated.error.clone() / unit(a) / a.unit_roundoff()).approx();
        let allowed = error + 2.0 * share.approx() * radius + 24.0;
        trial.compare_on(name, &(dissipated.value.clone() / unit(a)), share, &one, allowed);
    }
    Ok(())
}

/// The flat punch with its contact at the vertical edge, under every control: jump-in, linear compression, pull-off; πb²w lost in
/// either, and F²/2k of the machine.
pub(super) fn flat_punch<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let [radius, e_star, work] = [(); 3].map(|()| R::from_f64(ctx, 10_f64.powf(trial.uniform(-20.0, 20.0))));
    let share = R::from_f64(ctx, 10_f64.powf(trial.uniform(-2.0, 2.0)));
    let control = control(round, &(share * &e_star * &radius))?;
    let [b, e, w] = [&radius, &e_star, &work].map(R::approx);
    trial.describe(format_args!("b = {b:e}, E* = {e:e}, w = {w:e}, {control:?} ({})", R::NAME));
    let material = Material::new(e_star.clone(), work.clone())?;
    let [d, f] = trial.closed.flat_punch_pull_off(&radius, &material)?;
    let by_heights = Quadrature::of([Shape::FlatPunch { radius: radius.clone() }])?;
    let by_form = closed::FlatPunch::new(radius.clone())?;
    let transforms: [Arc<dyn Transform<R>>; 2] = [Arc::new(by_form), Arc::new(by_heights)];
    let pull_off = control.controlled(&d, &f);
    for transform in transforms {
        let branches = SearchedBranches::new(Contact::half_space(&transform, &material, &control))?;
        let way = [pull_off.lit(0), -pull_off.clone(), pull_off.clone().times(2)];
        let path = Path::follow(&branches, &Start::Detached, &way)?;
        let [_, jump_in, pressed, breaks, _] = path.events.as_slice() else {
            trial.fail("the flat punch jumps in and breaks");
            return Ok(());
        };
        let rests = [&jump_in.after, &pressed.after, &breaks.before].map(|state| state.contact());
        let [Some(flat), Some(pressed), Some(breaks)] = rests else {
            trial.fail("the flat punch rests at its vertical edge");
            return Ok(());
        };
        trial.demand("at the vertical edge", [flat, pressed, breaks].iter().all(|rest| rest.contact_radius == radius));
        trial.demand("stable when pressed", pressed.stability == Stability::Stable);
        // Five roundings under each root, the root, and two factors, twice; on a machine those of D and its parts.
        trial.compare("d", &breaks.indentation, &d, 24.0);
        trial.compare("F", &breaks.force, &f, 32.0);
        trial.compare("F pressed", &pressed.force, &-f.clone(), 48.0);
        let adhesion = radius.pi() * &radius * &radius * &work;
        for (entry, event) in PathEnergy::new(&path, &branches)?.entries.iter().zip(&path.events) {
            // The spring of a machine is let go with the contact.
            let expected = match (event.kind, &control) {
                (EventKind::JumpIn, _) | (EventKind::Detached, Control::Indentation) => adhesion.clone(),
                (EventKind::Detached, Control::Machine { stiffness }) => {
                    f.square() / stiffness.clone().times(2) + &adhesion
                }
                _ => continue,
            };
            let Dissipation::Finite(dissipated) = &entry.dissipated else { continue };
            let allowed = dissipated.error.clone() / &expected / expected.unit_roundoff();
            trial.compare("lost", &dissipated.value, &expected, allowed.approx() + 32.0);
        }
    }
    Ok(())
}
