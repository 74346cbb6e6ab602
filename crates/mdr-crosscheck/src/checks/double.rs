//! The f64 functions, which promise an ulp, or two for many points at once, against the same closed forms at 400 bits.

use mdr_analytic::double::grid::{InstructionSet, Materials, Points, States, critical_states_on};
use mdr_analytic::double::{BranchSlices, InverseBatch};
use mdr_analytic::{Equilibria, PowerLawContact, double};
use mdr_core::contact::{Error, Ranged, Result, Status};
use mdr_core::number::{Precision, Real};
use rug::Float;

use crate::grid::{Exponent, Family, Held, Scene};
use crate::subject::double::*;
use crate::subject::routine::Routine;
use crate::trial::{Trial, ulps};

/// The error bound that a function promises, in ulp.
fn promised_ulp(name: &str) -> f64 {
    if matches!(name, "double::critical_states" | "double::Inverse::branches") { 2.0 } else { 1.0 }
}

/// Enough for 1/2 ± 2⁻⁵⁰, for ln a of any size and for what cancels in d, F and their slopes.
const REFERENCE_BITS: u32 = 400;

/// Every function of `mdr_analytic::double`, also where its result is out of the range of f64.
pub(super) fn functions(trial: &mut Trial<'_>) -> Result<()> {
    let held = trial.held();
    let round = trial.index;
    if round % 6 == 5 {
        return scale_free(trial, held);
    }
    let exponent = trial.exponent(round, Family::up_to(50));
    let mut scene: Scene<f64> = trial.scene(round, exponent, held.lambda(), ());
    // Every fourth coefficient is off by decades: results leave the range of f64.
    if round % 4 == 3 {
        let off = trial.uniform(-3.0, 3.0);
        scene.c *= 10_f64.powf(off);
        trial.describe_also(format_args!("C times 10^{off:e}"));
    }
    let stretch = (trial.uniform(-1.0, 1.0) / (scene.n + 1.0)).exp();
    let Scene { n, c, e_star: e, work: w } = scene;
    let (law, material) = ([n, c, e, w], scene.material()?);
    let found = compare(trial, &held.of([CRITICAL_INDENTATION, CRITICAL_FORCE]), &law)?;
    let Some(Ranged::Value(radius)) = found.first() else { return Ok(()) };
    let a = radius * stretch;
    let state = [n, c, e, w, a];
    compare(trial, &KAPPA[..1], &[n])?;
    compare(trial, &TRANSFORM, &[n, c, a])?;
    compare(trial, &ELONGATION, &[e, w, a])?;
    compare(trial, &STATE, &state)?;
    compare(trial, &ENERGY, &[n, c, e, w, a, n.mul_add(a, -a)])?;
    compare(trial, &UNIVERSAL, &[n, stretch])?;
    compare(trial, &ZERO_INDENTATION, &law)?;
    if n > 0.5 {
        compare(trial, &LOSSES, &law)?;
    } else {
        compare(trial, &BARRIER, &law)?;
    }
    let punch = double::flat_punch_pull_off(a, &material)?;
    enter(trial, "double::flat_punch_pull_off", punch.contact_radius, Ok(float(a)))?;
    compare(trial, &FLAT_PUNCH, &[a, e, w])?;
    let exact = wide(&scene)?;
    batch(trial, &scene, held, &exact)?;
    equilibria(trial, &scene, held, &exact)?;
    let stiffness = 2.0 * e * a;
    if (n - 0.5).abs() > 0.03 {
        let folds = double::machine_folds(n, c, &material, stiffness)?;
        let expected = exact.machine_folds(&float(stiffness))?;
        trial.demand("the number of machine folds", folds.len() == expected.len());
        for (fold, exact) in folds.into_iter().zip(expected) {
            enter(trial, "double::machine_folds", fold.contact_radius, Ok(exact.contact_radius))?;
            enter(trial, "double::machine_folds", fold.indentation, Ok(exact.indentation))?;
            enter(trial, "double::machine_folds", fold.force, Ok(exact.force))?;
        }
    }
    Ok(())
}

/// Compares the shipped functions with the exact results, and returns their results.
fn compare(trial: &mut Trial<'_>, routines: &[Routine], inputs: &[f64]) -> Result<Vec<Ranged<f64>>> {
    let exact: Vec<_> = inputs.iter().copied().map(float).collect();
    let mut results = Vec::new();
    for routine in routines {
        let found = (routine.shipped)(inputs)?;
        enter(trial, routine.function(), found, (routine.exact.float)(&exact))?;
        results.push(found);
    }
    Ok(results)
}

/// The critical state as a batch of one point, by all instructions that the processor has.
fn batch(trial: &mut Trial<'_>, scene: &Scene<f64>, held: Held, exact: &PowerLawContact<Float>) -> Result<()> {
    let material = scene.material()?;
    let points = Points { exponent: &[scene.n], coefficient: &[scene.c], material: Materials::One(&material) };
    let expected = exact.critical(&held.control())?;
    for path in InstructionSet::available() {
        let [mut kappa, mut contact_radius, mut indentation, mut force] = [[0.0]; 4];
        let mut status = [Status::Ok];
        let mut states = States {
            kappa: &mut kappa,
            contact_radius: &mut contact_radius,
            indentation: &mut indentation,
            force: &mut force,
            status: &mut status,
        };
        critical_states_on(path, &points, &held.control(), &mut states)?;
        // Out of range the log10 is that of double::critical.
        if status == [Status::Ok] {
            let numbers = [
                (kappa, exact.profile().kappa()),
                (contact_radius, &expected.contact_radius),
                (indentation, &expected.indentation),
                (force, &expected.force),
            ];
            for ([found], expected) in numbers {
                enter(trial, "double::critical_states", Ranged::Value(found), Ok(expected.clone()))?;
            }
        }
    }
    Ok(())
}

/// Both sides of the fold, from close to it to far: at a value, fresh and ready, and at a distance.
fn equilibria(trial: &mut Trial<'_>, scene: &Scene<f64>, held: Held, exact: &PowerLawContact<Float>) -> Result<()> {
    let (n, c, material, control) = (scene.n, scene.c, scene.material()?, held.control::<f64>());
    let fold = double::critical(n, c, &material, &control)?;
    let Ranged::Value(at_fold) = held.of([fold.indentation, fold.force]) else { return Ok(()) };
    let distance = 2_f64.powf(trial.uniform(-50.0, 3.0));
    let value = at_fold - distance * at_fold;
    if !(value.is_normal() && at_fold.is_normal()) {
        return Ok(());
    }
    trial.describe_also(format_args!("{held}, τ = {distance:e}"));
    let fresh = double::equilibria(n, c, &material, &control, value)?;
    let ready = double::Inverse::new(n, c, &material, &control)?.equilibria(value)?;
    let expected = exact.equilibria(&held.control(), &float(value))?;
    let beside = double::equilibria_at_distance(n, c, &material, &control, distance)?;
    let expected_beside = exact.equilibria_at_distance(&held.control(), &float(distance))?;
    for (name, found, expected) in [
        ("double::equilibria", fresh, &expected),
        ("double::Inverse::equilibria", ready, &expected),
        ("double::equilibria_at_distance", beside, &expected_beside),
    ] {
        let (found, expected) = (found.as_slice(), expected.as_slice());
        let same = found.iter().map(|x| x.stability).eq(expected.iter().map(|x| x.stability));
        trial.demand(format!("number and stability of {name}"), same);
        for (found, expected) in found.iter().zip(expected) {
            enter(trial, name, found.contact_radius, Ok(expected.contact_radius.clone()))?;
            enter(trial, name, found.indentation, Ok(expected.indentation.clone()))?;
            enter(trial, name, found.force, Ok(expected.force.clone()))?;
        }
    }
    branches(trial, &double::Inverse::new(n, c, &material, &control)?, value, held, &expected)
}

/// The equilibria as a batch of one value, by all instructions that the processor has.
fn branches(
    trial: &mut Trial<'_>,
    inverse: &double::Inverse,
    value: f64,
    held: Held,
    expected: &Equilibria<Float>,
) -> Result<()> {
    for path in InstructionSet::available() {
        let ([mut a0, mut x0, mut a1, mut x1], mut status) = ([[0.0]; 4], [Status::Ok]);
        let mut found = InverseBatch {
            smaller: BranchSlices { contact_radius: &mut a0, uncontrolled: &mut x0 },
            larger: BranchSlices { contact_radius: &mut a1, uncontrolled: &mut x1 },
            status: &mut status,
        };
        inverse.clone().with_instructions(path).branches(&[value], &mut found)?;
        // Out of range the log10 is that of double::equilibria.
        let sides = match expected.as_slice() {
            [only] if status == [Status::Ok] => vec![(only, a1, x1)],
            [smaller, larger] if status == [Status::Ok] => vec![(smaller, a0, x0), (larger, a1, x1)],
            _ => continue,
        };
        for (expected, [a], [x]) in sides {
            let other = held.of([&expected.force, &expected.indentation]);
            for (found, expected) in [(a, &expected.contact_radius), (x, other)] {
                enter(trial, "double::Inverse::branches", Ranged::Value(found), Ok(expected.clone()))?;
            }
        }
    }
    Ok(())
}

fn scale_free(trial: &mut Trial<'_>, held: Held) -> Result<()> {
    let exponent = Exponent::Fraction(1, 2);
    let scales = trial.scales::<f64>(trial.index, exponent);
    let rho = 2_f64.powf(trial.uniform(-3.0, 3.0));
    let scene: Scene<f64> = trial.planted(exponent, rho, scales, ());
    let Scene { c, e_star: e, work: w, .. } = scene;
    let (a, material) = (scales.radius, scene.material()?);
    let state = double::scale_free_state(c, &material, a)?;
    enter(trial, "double::scale_free_state", state.contact_radius, Ok(float(a)))?;
    compare(trial, &SCALE_FREE_STATE, &[c, e, w, a])?;
    compare(trial, &RATIO, &[c, e, w])?;
    compare(trial, &[held.of(THRESHOLDS)], &[e, w])?;
    let fate = double::fate(c, &material, &held.control())?;
    trial.demand("fate", fate == wide(&scene)?.fate(&held.control())?);
    Ok(())
}

fn float(x: f64) -> Float {
    Float::from_f64(Precision::new(REFERENCE_BITS), x)
}

/// The contact of a scene at 400 bits.
fn wide(scene: &Scene<f64>) -> Result<PowerLawContact<Float>> {
    scene.map(|x| float(*x)).contact()
}

/// Compares a result of the function of that name, or its log10 where it is out of the range of f64.
fn enter(trial: &mut Trial<'_>, name: &'static str, found: Ranged<f64>, expected: Result<Float>) -> Result<()> {
    let (log10, exact) = match (found, expected) {
        (Ranged::Value(value), expected) => {
            let (value, expected) = (trial.closed.double(name, value), expected?);
            let error = if value == 0.0 && expected == 0 { 0.0 } else { ulps(value, &expected) };
            trial.enter(name, error, promised_ulp(name));
            return Ok(());
        }
        (Ranged::Overflow { log10 }, Ok(exact)) => {
            trial.demand(format!("{name} overflows"), exact.clone().abs() > f64::MAX);
            (log10, exact)
        }
        (Ranged::Underflow { log10 }, Ok(exact)) => {
            // 2⁻¹⁰⁷⁴ is the smallest.
            trial.demand(format!("{name} underflows"), exact != 0 && exact.get_exp().is_some_and(|e| e <= -1074));
            (log10, exact)
        }
        // Towards n = 1/2 some results, or intermediate ones, are also out of the range of MPFR.
        (Ranged::Overflow { .. } | Ranged::Underflow { .. }, Err(Error::OutOfRange { .. })) => return Ok(()),
        (_, Err(error)) => return Err(error),
    };
    trial.enter(format!("log10 of {name}"), ulps(log10, &exact.abs().log10()), 1.0);
    Ok(())
}
