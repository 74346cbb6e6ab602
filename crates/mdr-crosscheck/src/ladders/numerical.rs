//! The ladders of the numerical route: quadratures, folds, equilibria, fields and energies.

use std::f64::consts::PI;

use mdr_analytic::double;
use mdr_core::contact::{Control, Quantity, Result};

use super::Family;
use super::approach::{Approach, LadderCase, Reach, Steps, cross};
use crate::subject::double::{LAW, material, planted};
use crate::subject::numerical::*;
use crate::subject::profiles::{POWER_QUADRATURE, PUNCH_QUADRATURE, SPHERE_QUADRATURE, WAVES_QUADRATURE};

pub(super) fn cases(steps: Steps) -> Vec<LadderCase> {
    [quadratures(steps), folds(steps), equilibria(steps), fields(steps), energies(steps)].concat()
}

/// All lengths by a factor to both ends.
fn lengths(steps: Steps, end: i32, also: &str, inputs: impl Fn(f64) -> Vec<f64>) -> [Approach; 2] {
    let toward = |end| format!("all lengths → 10^{end}{also}");
    Approach::to_both_ends(steps, Family::Scale, toward, "factor", end, inputs)
}

fn quadratures(steps: Steps) -> Vec<LadderCase> {
    // Steeper heights than r^1000 are known no better than their radii, which a quadrature has to step over.
    let reach = Reach { half: 50, small: -290, large: [0, 3] };
    let mut powers = Approach::of_exponent(steps, reach, |n| vec![n, 1.0, 1.0 - 0.5 / (1.0 + n)]);
    powers.extend(Approach::of_each_input(steps, POWER_QUADRATURE[0].inputs, &[1.5, 1.0, 1.0], 1));
    let mut spheres = vec![
        Approach::new(Family::Tip, "x → 0", "x", steps.decades(0, -300), |x| vec![1.0, 0.9 * x]),
        Approach::new(Family::Edge, "x → R", "1 − x/R", steps.halvings(1, 53), |t| vec![1.0, 1.0 - t]),
    ];
    spheres.extend(lengths(steps, 300, "", |t| vec![t, 0.5 * t]));
    let punches = [
        Approach::new(Family::Edge, "x → b from outside", "x/b − 1", steps.halvings(1, 52), |t| {
            vec![5.0, 1.0, 1.0 + t]
        }),
        Approach::new(Family::Far, "x → ∞", "x", steps.decades(1, 300), |x| vec![5.0, 1.0, x]),
    ];
    let waves = [
        Approach::new(Family::Tip, "x → 0", "x", steps.decades(-1, -300), |x| vec![1.0, 5e-4, 0.1, x]),
        // Five hundred waves are the patience of the quadrature.
        Approach::new(Family::Wavelength, "λ → 0", "λ", steps.halvings(0, 11), |t| vec![1.0, 5e-4, t, 0.17]),
    ];
    [
        cross(&POWER_QUADRATURE, &powers),
        cross(&SPHERE_QUADRATURE, &spheres),
        cross(&PUNCH_QUADRATURE, &punches),
        cross(&WAVES_QUADRATURE, &waves),
    ]
    .concat()
}

fn folds(steps: Steps) -> Vec<LadderCase> {
    let law = |n: f64| vec![n, planted(n, 1.0), 1.0, 1.0];
    // Nearer to 1/2 the other fold of the two controls is 10^±10⁵ away.
    let mut laws = Approach::of_exponent(steps, Reach { half: 8, small: -12, large: [0, 6] }, law);
    laws.extend(Approach::of_each_input(steps, LAW, &[2.0, 0.5, 1.0, 1.0], 2));
    let machines = [2.0, 0.25].map(|n| {
        let toward = |end| format!("k → 10^{end}, n = {n}");
        Approach::to_both_ends(steps, Family::Stiffness, toward, "k", 300, |k| [law(n), vec![k]].concat())
    });
    [cross(&FOLDS, &laws), cross(&FOLDS_ON_MACHINE, machines.as_flattened())].concat()
}

fn equilibria(steps: Steps) -> Vec<LadderCase> {
    let [outer_at_d, inner_at_d] = AT_INDENTATION;
    let [outer_at_f, inner_at_f] = AT_FORCE;
    let (grips, load) = (Control::Indentation, Control::Force);
    let cases = [
        (outer_at_d, &grips, true),
        (inner_at_d, &grips, false),
        (outer_at_f, &load, true),
        (inner_at_f, &load, false),
    ];
    cases.into_iter().flat_map(|(routine, control, outer)| cross(&[routine], &to_fold(steps, control, outer))).collect()
}

/// The critical value of the controlled quantity.
fn critical(law: [f64; 4], control: &Control<f64>) -> f64 {
    let value = || -> Result<f64> {
        let state = double::critical(law[0], law[1], &material(&law[2..])?, control)?;
        match control {
            Control::Force => state.force.value(Quantity::Force),
            _ => state.indentation.value(Quantity::Indentation),
        }
    };
    value().unwrap_or(f64::NAN)
}

/// Controlled values that tend to the critical one, or at half of it to the ends of the range.
fn to_fold(steps: Steps, control: &Control<f64>, outer: bool) -> Vec<Approach> {
    let law = [2.0, 0.5, 1.0, 1.0];
    let near = |toward, law: [f64; 4]| {
        let fold = critical(law, control);
        let halvings = steps.halvings(1, 50);
        Approach::new(Family::Fold, toward, "1 − value/critical", halvings, |t| {
            [law.to_vec(), vec![fold * (1.0 - t)]].concat()
        })
    };
    let mut approaches = vec![near("to the fold, n = 2", law), near("to the fold, n = 1/4", [0.25, 0.5, 1.0, 1.0])];
    if outer {
        approaches.push(Approach::new(Family::Far, "pressed in, n = 2", "value", steps.decades(0, 90), |t| {
            [law.to_vec(), vec![t]].concat()
        }));
    }
    for index in [2, 3] {
        let toward = |end| format!("{} → 10^{end} at half the critical value", LAW[index]);
        approaches.extend(Approach::to_both_ends(steps, Family::Scale, toward, "the input", 200, |t| {
            let mut law = law;
            law[index] = t;
            [law.to_vec(), vec![0.5 * critical(law, control)]].concat()
        }));
    }
    approaches
}

fn fields(steps: Steps) -> Vec<LadderCase> {
    let at = |r: f64| vec![1.0, 1.0, 1.0, 2.0, r];
    let scaled = |r: f64| lengths(steps, 150, ", w/E* with them", move |t| vec![t, 1.0, t, 2.0 * t, r * t]);
    // The pressure is 0 where 2(a² − r²) = RΔl.
    let zero = (4.0 - (4.0 * PI).sqrt() / 2.0).sqrt();
    let within = [
        Approach::new(Family::Edge, "r → a from inside", "1 − r/a", steps.halvings(1, 52), |t| at(2.0 * (1.0 - t))),
        Approach::new(Family::Tip, "r → 0", "r", steps.decades(0, -300), at),
        Approach::new(Family::Zero, "r → the zero of p", "r/r₀ − 1", steps.halvings(3, 50), |t| {
            at(zero * (1.0 + t))
        }),
    ];
    let outside = [
        Approach::new(Family::Edge, "r → a from outside", "r/a − 1", steps.halvings(1, 51), |t| at(2.0 * (1.0 + t))),
        Approach::new(Family::Far, "r → ∞", "r", steps.decades(1, 150), at),
    ];
    let state = |a: f64| vec![1.0, 1.0, 1.0, a];
    let states = [
        Approach::new(Family::Fold, "a → the fold", "a/a_c − 1", steps.halvings(2, 50), |t| {
            state((PI / 8.0).cbrt() * (1.0 + t))
        }),
        Approach::new(Family::Zero, "a → the zero at the fold of F", "a/a_F − 1", steps.halvings(2, 50), |t| {
            state((9.0 * PI / 8.0).cbrt() * (1.0 + t))
        }),
        Approach::new(Family::Tip, "a → 0", "a", steps.decades(0, -150), state),
        Approach::new(Family::Far, "a → ∞", "a", steps.decades(0, 150), state),
    ];
    [
        cross(&PRESSURE, &[&within[..], &scaled(0.7)].concat()),
        cross(&OUTSIDE, &[&outside[..], &scaled(3.0)].concat()),
        cross(&STIFFNESS, &states),
    ]
    .concat()
}

fn energies(steps: Steps) -> Vec<LadderCase> {
    let at = |a: f64, d: f64| vec![1.0, 1.0, 1.0, a, d];
    // At a = 1 Π vanishes with (d − 1/3)² = π − 4/45.
    let zero = 1.0 / 3.0 + (PI - 4.0 / 45.0).sqrt();
    let halvings = steps.halvings(2, 50);
    let to_zero = Approach::new(Family::Zero, "d → the zero of Π", "d/d₀ − 1", halvings.clone(), |t| {
        at(1.0, zero * (1.0 + t))
    });
    let to_g = Approach::new(Family::Zero, "d → g(a)", "d − 1", halvings, |t| at(1.0, 1.0 + t));
    let mut states = vec![Approach::new(Family::Tip, "a → 0", "a", steps.decades(0, -120), |a| at(a, -0.1))];
    states.extend(lengths(steps, 100, ", w/E* with them", |t| vec![t, 1.0, t, t, -0.3 * t]));
    // At d = d_c the energy has an inflection in a.
    let fold = (PI / 8.0).cbrt();
    let d = fold * fold - (2.0 * PI * fold).sqrt();
    let jumps = [
        Approach::new(Family::Fold, "the jump → 0", "1 − to/from", steps.halvings(2, 40), |t| {
            vec![1.0, 1.0, 1.0, 1.0, 1.0 - t, -0.3]
        }),
        Approach::new(Family::Fold, "the jump → 0 at the fold", "1 − to/from", steps.halvings(2, 14), |t| {
            vec![1.0, 1.0, 1.0, fold * (1.0 + t / 2.0), fold * (1.0 - t / 2.0), d]
        }),
    ];
    [
        cross(&POTENTIAL, &[&[to_zero][..], &states].concat()),
        cross(&RELEASE, &[&[to_g][..], &states].concat()),
        cross(&DISSIPATED, &jumps),
    ]
    .concat()
}
