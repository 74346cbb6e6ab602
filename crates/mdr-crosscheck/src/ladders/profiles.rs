//! The ladders of the profile library and of the Struve functions.

use std::f64::consts::PI;

use super::Family;
use super::approach::{Approach, LadderCase, Steps, cross};
use crate::subject::profiles::{DISPLACED_PARABOLOID, PROFILES, ProfileRoutines, STRUVE, WAVY_PARABOLOID};

pub(super) fn cases(steps: Steps) -> Vec<LadderCase> {
    let profiles = PROFILES.iter().flat_map(|profile| cross(&profile.routines, &approaches(profile, steps)));
    profiles.chain(displaced(steps)).chain(waves(steps)).chain(struve(steps)).collect()
}

/// To the tip, far out, to the edge, and to the ends of the range of doubles.
fn approaches(profile: &ProfileRoutines, steps: Steps) -> Vec<Approach> {
    let with = |x: f64| {
        let (_, parameters) = profile.base.split_last().unwrap_or((&0.0, &[]));
        [parameters, &[x]].concat()
    };
    let mut approaches = vec![Approach::new(Family::Tip, "x → 0", "x", steps.decades(0, -300), with)];
    if !profile.ends {
        approaches.push(Approach::new(Family::Far, "x → ∞", "x", steps.decades(0, 300), with));
    }
    if let Some(edge) = profile.edge {
        let b = edge(profile.base);
        if !profile.flat {
            let (toward, inside) = ("x → b from inside", steps.halvings(1, 53));
            approaches.push(Approach::new(Family::Edge, toward, "1 − x/b", inside, |t| with(b * (1.0 - t))));
        }
        if !profile.ends {
            let (toward, outside) = ("x → b from outside", steps.halvings(1, 52));
            approaches.push(Approach::new(Family::Edge, toward, "x/b − 1", outside, |t| with(b * (1.0 + t))));
        }
    }
    approaches.extend(scales(profile, steps));
    approaches
}

/// All lengths together, and each input but x alone.
fn scales(profile: &ProfileRoutines, steps: Steps) -> impl Iterator<Item = Approach> {
    let names = profile.routines[0].inputs;
    let lengths = (0..names.len()).filter(|index| names[*index] != "slope").collect();
    // The waves have approaches of their own.
    let alone = (0..names.len() - 1).filter(|index| names[*index] != "λ").map(|index| (vec![index], names[index]));
    [(lengths, "all lengths")].into_iter().chain(alone).flat_map(move |(scaled, name): (Vec<usize>, &str)| {
        let toward = |end| format!("{name} → 10^{end}");
        Approach::to_both_ends(steps, Family::Scale, toward, "factor", 300, |t| {
            let base = profile.base.iter().enumerate();
            base.map(|(index, x)| if scaled.contains(&index) { x * t } else { *x }).collect()
        })
    })
}

/// To the zeros of g, g' and ∫g of the displaced paraboloid: x = πb/2, πb/4, 3πb/4.
fn displaced(steps: Steps) -> Vec<LadderCase> {
    let cases = DISPLACED_PARABOLOID.routines.into_iter().zip([0.5, 0.25, 0.75]).flat_map(|(routine, factor)| {
        let axes = ["|x/x₀ − 1|"; 2];
        let inputs = |t: f64| vec![2.0, 0.5, factor * PI * 0.5 * (1.0 + t)];
        cross(
            &[routine],
            &Approach::from_both_sides(Family::Zero, "x → the zero", axes, &steps.halvings(2, 52), inputs),
        )
    });
    cases.collect()
}

fn waves(steps: Steps) -> Vec<LadderCase> {
    let shorter = |toward, amplitude: fn(f64) -> f64| {
        Approach::new(Family::Wavelength, toward, "λ", steps.decades(0, -18), |t| vec![1.0, amplitude(t), t, 0.07])
    };
    let approaches = [
        shorter("λ → 0", |_| 5e-4),
        shorter("λ → 0 at A ∝ λ²", |t| t * t / 40.0),
        shorter("λ → 0 at A ∝ λ³", |t| t * t * t),
        // A joint of the tables of H.
        Approach::new(Family::Edge, "kx → 3 from above", "kx/3 − 1", steps.halvings(3, 50), |t| {
            vec![1.0, 5e-4, 0.1, 0.3 / (2.0 * PI) * (1.0 + t)]
        }),
    ];
    cross(&WAVY_PARABOLOID.routines, &approaches)
}

fn struve(steps: Steps) -> Vec<LadderCase> {
    let to_joint = |toward, axis, last, side: f64| {
        Approach::new(Family::Edge, toward, axis, steps.halvings(2, last), |t| vec![3.0 * (1.0 + side * t)])
    };
    let approaches = [
        Approach::new(Family::Tip, "z → 0", "z", steps.decades(0, -300), |z| vec![z]),
        Approach::new(Family::Far, "z → ∞", "z", steps.decades(0, 18), |z| vec![z]),
        // The first zero of H₀; H₁ has none.
        Approach::new(Family::Zero, "z → the first zero of H₀", "z/z₀ − 1", steps.halvings(2, 52), |t| {
            vec![4.332_752_2 * (1.0 + t)]
        }),
        to_joint("z → 3 from above", "z/3 − 1", 51, 1.0),
        to_joint("z → 3 from below", "1 − z/3", 52, -1.0),
    ];
    cross(&STRUVE, &approaches)
}
