//! The ladders of `mdr_analytic::double`.

use std::f64::consts::PI;

use super::Family;
use super::approach::{Approach, FAR, LadderCase, Steps, cross};
use crate::subject::double::*;

/// One of the two folds on a machine of E* = w = k = 1 merges with the other at this C, at the smaller turning point s of
/// the tangency condition: 3μs² − 2(1−2μ)s + μ = 0, λ = (1+3s)/(1+s), a = s/2.
fn merging(n: f64) -> f64 {
    let mu = n - 0.5;
    let half = 1.0 - 2.0 * mu;
    let s = mu / (half + (half * half - 3.0 * mu * mu).sqrt());
    (1.0 + 3.0 * s) / (1.0 + s) * planted(n, 1.0) * (s / 2.0).powf(-mu)
}

pub(super) fn cases(steps: Steps) -> Vec<LadderCase> {
    [along(steps), critical(steps), machine(steps), scale_free(steps)].concat()
}

/// κ_n, the universal curves, g and the states along the equilibria.
fn along(steps: Steps) -> Vec<LadderCase> {
    let mut cases = cross(&KAPPA, &Approach::of_exponent(steps, FAR, |n| vec![n]));

    let mut curves = Approach::of_exponent(steps, FAR, |n| vec![n, 0.75]);
    // d = 0 at ã = 4^(2/3) for the paraboloid, F = 0 at ã = 16 for the cone.
    curves.push(Approach::new(Family::Zero, "ã → the zero", "ã/ã₀ − 1", steps.halvings(2, 52), |t| {
        vec![2.0, 4_f64.powf(2.0 / 3.0) * (1.0 + t)]
    }));
    curves.push(Approach::new(
        Family::Zero,
        "ã → the zero of the cone",
        "ã/16 − 1",
        steps.halvings(2, 52),
        |t| vec![1.0, 16.0 * (1.0 + t)],
    ));
    curves.extend(Approach::of_each_input(steps, UNIVERSAL[0].inputs, &[2.0, 1.0], 1));
    curves.extend(Approach::of_each_input(steps, UNIVERSAL[0].inputs, &[0.25, 1.0], 1));
    cases.extend(cross(&UNIVERSAL, &curves));

    let mut transforms = Approach::of_exponent(steps, FAR, |n| vec![n, planted(n, 1.0), 1.0 - 0.5 / (1.0 + n)]);
    transforms.extend(Approach::of_each_input(steps, TRANSFORM[0].inputs, &[1.5, 1.0, 1.0], 1));
    cases.extend(cross(&TRANSFORM, &transforms));
    cases.extend(cross(&ELONGATION, &Approach::of_each_input(steps, ELONGATION[0].inputs, &[1.0; 3], 0)));

    let state = |n: f64| vec![n, planted(n, 1.0), 1.0, 1.0, 1.0 - 0.5 / (1.0 + n)];
    let mut states = Approach::of_exponent(steps, FAR, state);
    for n in [2.0, 0.25] {
        states.extend(Approach::of_each_input(steps, INDENTATION[0].inputs, &[n, 0.5, 1.0, 1.0, 1.0], 1));
    }
    // For the paraboloid d = a² − √(2πa) and F ∝ ⅔a³ − √(2πa³): a³ at their zeros and those of their slopes.
    for (routines, toward, cube) in [
        (INDENTATION, "a → the zero of d", 2.0 * PI),
        (FORCE, "a → the zero of F", 4.5 * PI),
        (INDENTATION_SLOPE, "a → the fold of d", PI / 8.0),
        (FORCE_SLOPE, "a → the fold of F", 9.0 * PI / 8.0),
    ] {
        let (axes, zero) = (["a/a₀ − 1", "1 − a/a₀"], cube.powf(1.0 / 3.0));
        let zeros = Approach::from_both_sides(Family::Zero, toward, axes, &steps.halvings(2, 52), |t| {
            vec![2.0, 0.5, 1.0, 1.0, zero * (1.0 + t)]
        });
        cases.extend(cross(&routines, &[&states[..], &zeros].concat()));
    }

    // At a = 1 Π vanishes with (d − 1/3)² = π − 4/45.
    let zero = 1.0 / 3.0 + (PI - 4.0 / 45.0).sqrt();
    let mut states = Approach::of_exponent(steps, FAR, |n| [state(n), vec![0.1]].concat());
    states.extend(Approach::of_each_input(steps, ENERGY[0].inputs, &[2.0, 0.5, 1.0, 1.0, 1.0, 1.0], 1));
    states.push(Approach::new(Family::Zero, "d → the zero of Π", "d/d₀ − 1", steps.halvings(2, 52), |t| {
        vec![2.0, 0.5, 1.0, 1.0, 1.0, zero * (1.0 + t)]
    }));
    cases.extend(cross(&ENERGY, &states));
    cases
}

/// Critical states and jumps.
fn critical(steps: Steps) -> Vec<LadderCase> {
    let mut laws = Approach::of_exponent(steps, FAR, |n| vec![n, planted(n, 1.0), 1.0, 1.0]);
    for n in [2.0, 0.25] {
        laws.extend(Approach::of_each_input(steps, LAW, &[n, 0.5, 1.0, 1.0], 1));
    }
    let mut near = laws.clone();
    near.push(Approach::new(Family::Half, "n → 1/2, C = 1", "n − 1/2", steps.halvings(2, 50), |t| {
        vec![0.5 + t, 1.0, 1.0, 1.0]
    }));
    near.push(Approach::new(Family::Zero, "n → 3/2", "n − 3/2", steps.halvings(2, 52), |t| {
        vec![1.5 + t, 1.0, 1.0, 1.0]
    }));
    let mut cases = cross(&[CRITICAL_INDENTATION, CRITICAL_FORCE].concat(), &near);
    cases.extend(cross(&[&ZERO_INDENTATION[..], &LOSSES, &BARRIER].concat(), &laws));
    cases
}

/// Folds on a machine.
fn machine(steps: Steps) -> Vec<LadderCase> {
    // ρ = 2 in the middle of the thresholds: near n = 1/2 the middle fold stays at 2E*a = k.
    let near = |n: f64| vec![n, planted(n, 2.0) * 2_f64.powf(n - 0.5), 1.0, 1.0, 1.0];
    let stiff = |n: f64, k: f64| vec![n, planted(n, 1.0), 1.0, 1.0, k];
    let merge = |t: f64| vec![0.6, merging(0.6) * (1.0 + t), 1.0, 1.0, 1.0];
    let axes = ["n − 1/2", "1/2 − n"];
    let halvings = steps.halvings(2, 20);
    let mut approaches =
        Approach::from_both_sides(Family::Half, "n → 1/2", axes, &halvings, |t| near(0.5 + t)).to_vec();
    let merged = steps.halvings(3, 44);
    approaches.extend([
        Approach::new(Family::SmallExponent, "n → 0", "n", steps.decades(-1, -14), near),
        Approach::new(Family::LargeExponent, "n → ∞", "n", steps.decades(1, 12), |n| stiff(n, 1.0)),
        Approach::new(Family::Fold, "C → two folds merge", "C/C* − 1", merged.clone(), merge),
        Approach::new(Family::Fold, "C → two folds merge, from one", "1 − C/C*", merged, |t| merge(-t)),
    ]);
    for n in [2.0, 0.7, 0.25] {
        let toward = |end| format!("k → 10^{end}, n = {n}");
        approaches.extend(Approach::to_both_ends(steps, Family::Stiffness, toward, "k", -300, |k| stiff(n, k)));
    }
    let scales = Approach::of_each_input(steps, LAW, &[2.0, 0.5, 1.0, 1.0], 1);
    approaches.extend(scales.into_iter().map(|approach| approach.followed_by(&[1.0])));
    cross(&[&CRITICAL_ON_MACHINE[..], &MACHINE_FOLDS].concat(), &approaches)
}

/// n = 1/2, and the flat punch.
fn scale_free(steps: Steps) -> Vec<LadderCase> {
    let ends = |names: &[&str]| Approach::of_each_input(steps, names, &vec![1.0; names.len()], 0);
    let mut cases = cross(&RATIO, &ends(RATIO[0].inputs));
    cases.extend(cross(&THRESHOLDS, &ends(THRESHOLDS[0].inputs)));
    // ρ = κC/√(2πw/E*) = 1 and 3 are the zeros of d and F.
    for (routine, zero) in SCALE_FREE_STATE.into_iter().zip([1.0, 3.0]) {
        let threshold = zero * (2.0 * PI).sqrt() / 1.311_028_777_146_059_9;
        let axes = ["|ρ/ρ₀ − 1|"; 2];
        let zeros = Approach::from_both_sides(Family::Zero, "ρ → ρ₀", axes, &steps.halvings(2, 52), |t| {
            vec![threshold * (1.0 + t), 1.0, 1.0, 1.0]
        });
        cases.extend(cross(&[routine], &[ends(routine.inputs), zeros.to_vec()].concat()));
    }
    cases.extend(cross(&FLAT_PUNCH, &ends(FLAT_PUNCH[0].inputs)));
    cases
}
