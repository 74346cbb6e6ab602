//! Adhesion of finite range: limits, edges and scales. A check of mdr-crosscheck compares the states with those of Maugis 1992.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Error, Flank, Material, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation, tabor_number};
use mdr_numeric::folds::folds;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

fn pull_off(
    profile: &(impl Transform<f64> + Clone + 'static),
    e_star: f64,
    work: f64,
    range: f64,
) -> CohesiveState<f64> {
    let material = Material::new(e_star, work).unwrap();
    let radii: Vec<f64> = folds(&Arc::new(profile.clone()), &material, &Control::Force)
        .unwrap()
        .iter()
        .map(|fold| fold.contact_radius)
        .collect();
    let contact =
        Dugdale::new(Contact::half_space(&Arc::new(profile.clone()), &material, &Control::Force), &separation(&range))
            .unwrap();
    contact.pull_off(&radii).unwrap().unwrap()
}

#[test]
fn a_paraboloid_is_between_jkr_and_dmt() {
    // Units of πwR: 3/2 for a short range, 2 for a long one, and in between as in the table of Maugis.
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap());
    let share = |range: f64| -pull_off(&ball, 1.0, 1e-6, range).force / (PI * 1e-6);
    let shares: Vec<f64> = [1e-8, 1e-5, 1e-4, 1e-3, 1e-1].map(share).to_vec();
    assert!(shares.is_sorted(), "{shares:?}");
    // μ is 10⁴ and 10⁻³ at the ends.
    assert_relative_eq!(shares[0], 1.5, max_relative = 1e-8);
    assert_relative_eq!(shares[4], 2.0, max_relative = 1e-4);
}

#[test]
fn results_do_not_depend_on_units() {
    let ball = Arc::new(|radius: f64| Quadrature::of([Shape::Paraboloid { radius }]).unwrap());
    let nature = pull_off(&ball(1.0), 1.0, 1e-6, 3e-4);
    // Lengths times 10⁻⁸ and forces times 10⁻⁷.
    for (length, force) in [(1e-8, 1e-7), (1e40, 1e-60)] {
        let state = pull_off(&ball(length), force / length.powi(2), 1e-6 * force / length, 3e-4 * length);
        assert_relative_eq!(state.force, nature.force * force, max_relative = 1e-12);
        assert_relative_eq!(state.outer_radius, nature.outer_radius * length, max_relative = 1e-7);
        assert_relative_eq!(state.indentation, nature.indentation * length, max_relative = 1e-6);
    }
}

#[test]
fn a_sharp_tip_has_a_finite_pull_off_force() {
    // n = 1/4: with a short range the force is that of the stress w/h₀ on the disc on which the gap of the rigid tip is
    // below h₀.
    let tip = Arc::new(Quadrature::of([Shape::Power { n: 0.25, c: 1.0 }]).unwrap());
    let range = 1e-3;
    let opening = separation(&range);
    let state = pull_off(&tip, 1.0, 1e-4, range);
    assert_relative_eq!(state.force, -PI * 1e-4 / opening * opening.powi(8), max_relative = 0.05);
    assert_relative_eq!(state.outer_radius, opening.powi(4), max_relative = 0.05);
    assert!(state.contact_radius < 1e-3 * state.outer_radius);
}

#[test]
fn a_flat_punch_goes_from_kendall_to_the_full_stress() {
    let punch = Quadrature::of([Shape::FlatPunch { radius: 1.0 }]).unwrap();
    let kendall = -f64::sqrt(8.0 * PI * 1e-4);
    // The ring is at most as wide as the punch, and the correction falls with the range.
    let changes = [1e-6, 1e-4].map(|range| pull_off(&punch, 1.0, 1e-4, range).force / kendall - 1.0);
    assert!(changes[0].abs() < 1e-3 && changes[0].abs() < changes[1].abs(), "{changes:?}");
    assert_relative_eq!(pull_off(&punch, 1.0, 1e-4, 1.0).force, -PI * 1e-4 / separation(&1.0), max_relative = 1e-9);
}

#[test]
fn tabors_own_number() {
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 10e-9 }]).unwrap());
    let material = Material::new(5e9, 0.05).unwrap();
    let curve = Contact::half_space(&ball, &material, &Control::Force);
    let fold = folds(&ball, &material, &Control::Force).unwrap()[0].contact_radius;
    let tabor = (10e-9 * 0.05_f64.powi(2) / (5e9_f64.powi(2) * 0.3e-9_f64.powi(3))).cbrt();
    assert_relative_eq!(tabor_number(&curve, &fold, &0.3e-9).unwrap(), tabor, max_relative = 1e-13);
}

#[test]
fn inputs_out_of_their_domain() {
    let ball = Arc::new(Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap());
    let material = Material::new(1.0, 1e-6).unwrap();
    let curve = || Contact::half_space(&ball, &material, &Control::Force);
    for bad in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        assert!(matches!(Dugdale::new(curve(), &bad), Err(Error::Domain { .. })), "{bad}");
        assert!(matches!(tabor_number(&curve(), &0.1, &bad), Err(Error::Domain { .. })), "{bad}");
        assert!(matches!(Dugdale::new(curve(), &1e-3).unwrap().state(&bad), Err(Error::Domain { .. })), "{bad}");
    }
    // The gap at the equator is 1 at most: no ring of attraction ends on the sphere.
    let message = Dugdale::new(curve(), &10.0).unwrap().pull_off(&[0.01]).unwrap_err().to_string();
    assert!(message.contains("the range of adhesion") && message.contains("within the profile"), "{message}");
}

#[test]
fn the_ring_of_a_flat_tip_ends_at_the_edge_of_the_flat() {
    // With g = 0 under the contact and under the ring, the gap at c = b fixes a, h₀ = (2/π)s(qθ − (c − a)), and
    // F = −E*s(c²θ + aq); there g' jumps from 0 to infinity, and the force turns.
    let flat = 0.1;
    let tips =
        [Shape::TruncatedCone { flank: Flank::Slope(0.2), flat }, Shape::TruncatedParaboloid { radius: 0.5, flat }];
    for tip in tips {
        let state = pull_off(&Quadrature::of([tip]).unwrap(), 1.0, 1e-5, 1e-4);
        assert_relative_eq!(state.contact_radius, 0.09925304904187958, max_relative = 1e-12);
        assert_relative_eq!(state.outer_radius, flat, max_relative = 1e-12);
        assert_relative_eq!(state.force, -4.997_680_871_569_79e-4, max_relative = 1e-12);
    }
}

/// The states of a tip with a flat face along its contact radius, with the edge of the flat under the contact, in the ring, at
/// its ends and beyond: F is the integral of its slope, and continuous.
#[test]
fn a_ring_over_the_edge_of_a_flat_is_resolved() {
    let flat = 0.1;
    let tip = Arc::new(Quadrature::of([Shape::TruncatedCone { flank: Flank::Slope(0.2), flat }]).unwrap());
    let material = Material::new(1.0, 1e-5).unwrap();
    let contact = Dugdale::new(Contact::half_space(&tip, &material, &Control::Force), &separation(&1e-4)).unwrap();
    let force = |a: f64| contact.state(&a).unwrap().force;
    let edge = 0.09925304904187958;
    let near = (1..50).step_by(8).map(|bits| 2_f64.powi(-bits));
    let radii: Vec<f64> =
        near.flat_map(|step| [edge, flat].map(|a| [a * (1.0 - step), a * (1.0 + step)]).concat()).collect();
    for a in radii {
        let force = force(a);
        assert!(force.is_finite(), "{a}");
    }
    for centre in [edge, flat] {
        // The force has at most a bend: over a step that halves, so does its change, but for a root.
        let change = |step: f64| (force(centre * (1.0 + step)) - force(centre * (1.0 - step))).abs();
        assert!(change(1e-12) < 1e-4 * 5e-4 && change(1e-13) < 1e-4 * 5e-4, "{} {}", change(1e-12), change(1e-13));
    }
}

/// The ring is looked for from its narrow side: far beyond its end it would hold hundreds of waves.
#[test]
fn a_ring_over_waves() {
    for wavelength in [0.58244, 0.2] {
        let (radius, a) = (1.2603, 1.52324);
        let amplitude = wavelength * wavelength / (32.0 * radius);
        let tip = |amplitude| Quadrature::of([Shape::WavyParaboloid { radius, amplitude, wavelength }]).unwrap();
        let material = Material::new(1.0, 0.63694).unwrap();
        let state = |tip: Quadrature<f64, Heights<f64>>| {
            let curve = Contact::half_space(&Arc::new(tip), &material, &Control::Force);
            Dugdale::new(curve, &2.70147).unwrap().state(&a).unwrap()
        };
        let (flat, wavy) = (state(tip(0.0)), state(tip(amplitude)));
        // The waves change the gap by their height, 2A of 2.7, and g by more, with the root of the number of waves.
        let waves = (a / wavelength).sqrt() * amplitude * 8.0;
        assert!((wavy.outer_radius - flat.outer_radius).abs() < waves, "{wavy:?} {flat:?}");
    }
}

/// A table has a kink at every row, and a ring may end a few roundings beyond one of them.
#[test]
fn the_pull_off_of_a_table() {
    let rows: Vec<(f64, f64)> = (0..=200).map(|i| f64::from(i) / 200.0).map(|r| (r, r * r / 2.0)).collect();
    let table = Arc::new(mdr_numeric::table::MeasuredProfile::new(rows).unwrap());
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap());
    let [table, ball] = [pull_off(&table, 1.0, 1e-4, 1e-3), pull_off(&ball, 1.0, 1e-4, 1e-3)];
    // A table reproduces the paraboloid; half of the digits of the integrals stand, where the force is stationary.
    assert_relative_eq!(table.force, ball.force, max_relative = 1e-10);
    assert_relative_eq!(table.contact_radius, ball.contact_radius, max_relative = 1e-4);
}
