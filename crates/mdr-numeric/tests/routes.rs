//! Energy and springs give the contact that tangency and the rule of Heß give.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Flank, FoldKind, Material, Outcome, Shape, Stability, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::equilibria;
use mdr_numeric::folds::folds;
use mdr_numeric::springs::Foundation;
use mdr_numeric::transform::Quadrature;

/// The method of force balance and the rule of Heß, against that of the energy, state by state.
fn assert_routes_agree(
    transform: &(impl Transform<f64> + Clone + 'static),
    material: &Material<f64>,
    control: &Control<f64>,
    value: f64,
) {
    let forces = equilibria(&Arc::new(transform.clone()), material, control, &value).unwrap();
    let energies = Energy::new(Contact::half_space(&Arc::new(transform.clone()), material, &Control::Indentation))
        .unwrap()
        .equilibria(control, &value)
        .unwrap();
    assert_eq!(forces.len(), energies.len(), "{forces:?} {energies:?}");
    for (by_force, by_energy) in forces.iter().zip(&energies) {
        assert_eq!(by_force.stability, by_energy.stability);
        // The integral of the release rate is accurate to 128u (its tolerance), the residual of the other method to
        // 32u; at 10 % from the fold the radius d/(a d') ~ 1/√(2·0.1)/(n−1/2) is about 20 times as sensitive, at n =
        // 0.6.
        assert_relative_eq!(by_force.contact_radius, by_energy.contact_radius, max_relative = 2000.0 * f64::EPSILON);
        assert_relative_eq!(by_force.force, by_energy.force, max_relative = 4000.0 * f64::EPSILON);
    }
}

#[test]
fn energy_agrees_with_forces() {
    let material = Material::new(1.0, 1.0).unwrap();
    for n in [0.25, 0.6, 2.0] {
        let profile = Arc::new(Quadrature::of([Shape::Power { n, c: 1.0 }]).unwrap());
        for control in [Control::Indentation, Control::Force, Control::machine(1.0).unwrap()] {
            let fold = &folds(&profile, &material, &control).unwrap()[0];
            let extremum = control.controlled(&fold.indentation, &fold.force);
            assert_routes_agree(&profile, &material, &control, 0.9 * extremum);
            assert_routes_agree(&profile, &material, &control, -0.9 * extremum);
            assert_routes_agree(&profile, &material, &control, 1.1 * extremum);
        }
    }
}

#[test]
fn energy_agrees_with_forces_on_waves() {
    let wavy = Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }]).unwrap();
    assert_routes_agree(&wavy, &Material::new(1.0, 1e-4).unwrap(), &Control::Indentation, -0.00184);
}

#[test]
fn energy_agrees_with_forces_on_a_sphere() {
    let sphere = Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap();
    assert_routes_agree(&sphere, &Material::new(1.0, 1e-4).unwrap(), &Control::Indentation, -0.001);
}

#[test]
fn energy_agrees_with_forces_on_a_rounded_punch_and_a_tiny_paraboloid() {
    let punch = Quadrature::of([Shape::RoundedPunch { radius: 1.0, flat: 0.3 }]).unwrap();
    assert_routes_agree(&punch, &Material::new(1.0, 1e-4).unwrap(), &Control::Indentation, -0.01);
    let tiny = Quadrature::of([Shape::Paraboloid { radius: 1e-200 }]).unwrap();
    assert_routes_agree(&tiny, &Material::new(1e200, 1.0).unwrap(), &Control::Indentation, -1.2e-200);
}

#[test]
fn stable_means_minimum() {
    let (cone, material) = (
        Arc::new(Quadrature::of([Shape::Cone { flank: Flank::Slope(1.0) }]).unwrap()),
        Material::new(1.0, 1.0).unwrap(),
    );
    let energy = Energy::new(Contact::half_space(&cone, &material, &Control::Indentation)).unwrap();
    let d = -0.5;
    let found = energy.equilibria(&Control::Indentation, &d).unwrap();
    for state in &found {
        let at = |factor: f64| energy.potential(&(factor * state.contact_radius), &d).unwrap();
        let neighbours = [at(0.99), at(1.01)];
        match state.stability {
            Stability::Stable => assert!(neighbours.iter().all(|p| *p > at(1.0))),
            _ => assert!(neighbours.iter().all(|p| *p < at(1.0))),
        }
    }
    assert_eq!(found.len(), 2);
}

/// Pressed in far from its fold a contact is nearly that of Hertz: Δl is a small fraction of d, and equilibrium a small
/// difference of large terms. There the two methods agree to 128·64 roundings of those terms, over the logarithmic
/// derivative of the release rate.
#[test]
fn nearly_hertzian_contacts_are_stationary_too() {
    let material = Material::new(1.0, 1e-3).unwrap();
    let blade = Arc::new(Quadrature::of([Shape::Power { n: 0.17, c: 1.0 }]).unwrap());
    let fold = &folds(&blade, &material, &Control::Indentation).unwrap()[0];
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap());
    let cases: [(Arc<dyn Transform<f64>>, f64, usize); 3] =
        [(blade.clone(), 0.1 * fold.indentation, 2), (blade.clone(), 0.01 * fold.indentation, 2), (ball, 100.0, 1)];
    for (transform, d, count) in cases {
        let by_force = equilibria(&transform, &material, &Control::Indentation, &d).unwrap();
        let by_energy = Energy::new(Contact::half_space(&transform, &material, &Control::Indentation))
            .unwrap()
            .equilibria(&Control::Indentation, &d)
            .unwrap();
        assert_eq!((by_force.len(), by_energy.len()), (count, count), "d = {d}");
        let curve = Contact::half_space(&transform, &material, &Control::Indentation);
        for (force, energy) in by_force.iter().zip(&by_energy) {
            assert_eq!(force.stability, energy.stability);
            let a = force.contact_radius;
            let elongation = curve.detachment_elongation(&a).unwrap();
            let terms = (d + transform.g(&a).unwrap() + elongation) / elongation;
            let steepness = a * transform.slope(&a).unwrap() / elongation;
            let bound = 8192.0 * f64::EPSILON * terms.powi(2) * (1.0 + steepness / terms) / (steepness - 0.5).abs();
            assert_relative_eq!(energy.contact_radius, a, max_relative = bound);
        }
    }
}

#[test]
fn energy_lost_when_a_ball_breaks_away() {
    // From the fold to separation 2/5, and in the jump into contact at d = 0, 3/5 of πa²w.
    let (ball, material) =
        (Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap()), Material::new(1.0, 1.0).unwrap());
    let energy = Energy::new(Contact::half_space(&ball, &material, &Control::Indentation)).unwrap();
    let fold = &folds(&ball, &material, &Control::Indentation).unwrap()[0];
    let lost = energy.potential(&fold.contact_radius, &fold.indentation).unwrap();
    // At the fold Π is stationary in a, and dΠ/dd = F: 64 roundings of terms five times as large.
    let rounding = 320.0 * f64::EPSILON;
    assert_relative_eq!(lost, 0.4 * PI * fold.contact_radius.powi(2), max_relative = rounding);
    let touching = &equilibria(&ball, &material, &Control::Indentation, &0.0).unwrap()[0];
    let gained = energy.dissipated(&(1e-30 * touching.contact_radius), &touching.contact_radius, &0.0).unwrap();
    assert_relative_eq!(gained, 0.6 * PI * touching.contact_radius.powi(2), max_relative = rounding);
}

/// The worst errors of a, d, F relative to the continuous fold, over sixteen spacings near 1/count of the critical radius
/// for which the fold lies at sixteen different places between two springs.
fn spring_errors(
    transform: &(impl Transform<f64> + Clone + 'static),
    material: &Material<f64>,
    control: &Control<f64>,
    count: f64,
) -> [f64; 3] {
    let fold = &folds(&Arc::new(transform.clone()), material, control).unwrap()[0];
    let mut worst = [0.0; 3];
    for j in 0..16 {
        let spacing = fold.contact_radius / (count + (f64::from(j) + 0.5) / 16.0);
        let reach = (2.0 * fold.contact_radius / spacing) as usize;
        let foundation = Foundation::new(transform, material, spacing, reach).unwrap();
        let cascades = match fold.kind {
            FoldKind::Minimum => foundation.pull(reach, control).unwrap(),
            FoldKind::Maximum => foundation.press(1, control).unwrap(),
        };
        let [cascade] = cascades.as_slice() else { panic!("one instability, not {cascades:?}") };
        let expected = if fold.kind == FoldKind::Minimum { Outcome::Detached } else { Outcome::CompleteContact };
        assert_eq!(cascade.outcome, expected);
        let found = &cascade.instability;
        let errors = [
            found.contact_radius / fold.contact_radius - 1.0,
            found.indentation / fold.indentation - 1.0,
            found.force / fold.force - 1.0,
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = f64::max(*worst, error.abs());
        }
    }
    worst
}

/// The exponents of h in the errors, by regression over 1/25, 1/50, …, 1/800 of the critical radius.
fn spring_orders(
    transform: &(impl Transform<f64> + Clone + 'static),
    material: &Material<f64>,
    control: &Control<f64>,
) -> [f64; 3] {
    let counts: Vec<f64> = (0..6).map(|k| 25.0 * f64::powi(2.0, k)).collect();
    let errors: Vec<[f64; 3]> =
        counts.iter().map(|count| spring_errors(transform, material, control, *count)).collect();
    std::array::from_fn(|quantity| {
        let points = counts.iter().zip(&errors).map(|(count, error)| (-count.ln(), error[quantity].ln()));
        let (n, sx, sy) = points.clone().fold((0.0, 0.0, 0.0), |(n, sx, sy), (x, y)| (n + 1.0, sx + x, sy + y));
        let (mx, my) = (sx / n, sy / n);
        let (sxy, sxx) =
            points.fold((0.0, 0.0), |(sxy, sxx), (x, y)| (sxy + (x - mx) * (y - my), sxx + (x - mx).powi(2)));
        sxy / sxx
    })
}

#[test]
fn springs_converge_at_their_orders() {
    let material = Material::new(1.0, 1.0).unwrap();
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap());
    let blade = Arc::new(Quadrature::of([Shape::Power { n: 0.25, c: 1.0 }]).unwrap());
    // Orders 1, 2, 1, derived in the module. The next order is at most 1/25 on the first of six octaves: it changes a
    // slope by about 0.01.
    for (profile, control) in [(ball.clone(), Control::Indentation), (blade, Control::Indentation)] {
        let orders = spring_orders(&profile, &material, &control);
        for (order, expected) in orders.into_iter().zip([1.0, 2.0, 1.0]) {
            assert_relative_eq!(order, expected, epsilon = 0.05);
        }
    }
    // A dead load fixes the fold through the force, whose own error shifts the extremum: all of first order.
    for order in spring_orders(&ball, &material, &Control::Force) {
        assert_relative_eq!(order, 1.0, epsilon = 0.05);
    }
}

#[test]
fn springs_stay_within_their_bounds() {
    let material = Material::new(1.0, 1.0).unwrap();
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap());
    let fold = &folds(&ball, &material, &Control::Indentation).unwrap()[0];
    let h = 1e-3;
    let [a, d, force] = spring_errors(&ball, &material, &Control::Indentation, 1.0 / h);
    // a: h/2. The next order of d around its minimum shifts the nearest spring by O(h²).
    assert!(a <= 0.5 * h * (1.0 + h));
    // d'' = 2 + √(2π)a^(−3/2)/4 for R = E* = w = 1, and d'' Δx²/8.
    let a_c = fold.contact_radius;
    let bend = 2.0 + f64::sqrt(2.0 * PI) * a_c.powf(-1.5) / 4.0;
    assert!(d <= bend * (h * a_c).powi(2) / 8.0 / fold.indentation.abs() * (1.0 + h));
    // F: E*Δl Δx for the half strips, and 2E*Δl Δx/2 for the radius.
    let elongation = f64::sqrt(2.0 * PI * a_c);
    assert!(force <= 2.0 * elongation * h * a_c / fold.force.abs() * (1.0 + h));
}

#[test]
fn springs_follow_the_jumps_of_a_wavy_profile() {
    let (profile, material) = (
        Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }]).unwrap()),
        Material::new(1.0, 1e-4).unwrap(),
    );
    let spacing = 2e-5;
    let foundation = Foundation::new(&profile, &material, spacing, 7500).unwrap();
    // The springs of the largest contact at d = 0 are stretched by less than Δl, and the next one would be by more.
    let holds = |i| foundation.elongation(i, &0.0).unwrap() <= f64::sqrt(2e-4 * PI * foundation.position(i));
    let start = (1..7500).rev().find(|&i| holds(i) && !holds(i + 1)).unwrap();
    assert_relative_eq!(foundation.position(start), 0.0926, epsilon = 1e-4);
    let found = folds(&profile, &material, &Control::Indentation).unwrap();
    let cascades = foundation.pull(start, &Control::Indentation).unwrap();
    assert_eq!(cascades.len(), 2);
    assert_relative_eq!(cascades[0].instability.contact_radius, found[2].contact_radius, epsilon = spacing);
    assert_relative_eq!(cascades[1].instability.contact_radius, found[0].contact_radius, epsilon = spacing);
    let Outcome::Jump { to } = cascades[0].outcome else { panic!("a jump") };
    assert_relative_eq!(to, 0.0474, epsilon = 1e-4);
    assert_eq!(cascades[1].outcome, Outcome::Detached);
}

#[test]
fn bad_foundations_are_refused() {
    let (ball, material) =
        (Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap()), Material::new(1.0, 1.0).unwrap());
    assert!(Foundation::new(&ball, &material, 0.0, 10).is_err());
    assert!(Foundation::new(&ball, &material, f64::NAN, 10).is_err());
    assert!(Foundation::new(&ball, &material, 0.1, 0).is_err());
    let sphere = Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap();
    assert!(Foundation::new(&sphere, &material, 0.1, 10).is_err());

    let foundation = Foundation::new(&ball, &material, 0.1, 10).unwrap();
    assert!(foundation.force(10, &0.0).is_ok() && foundation.elongation(10, &0.0).is_ok());
    assert!(foundation.force(11, &0.0).is_err() && foundation.elongation(11, &0.0).is_err());
    assert!(foundation.force(1, &f64::NAN).is_err());
    let machine = Control::Machine { stiffness: -1.0 };
    assert!(foundation.pull(10, &machine).is_err() && foundation.press(1, &machine).is_err());
}
