//! Adhesion of finite range: limits, edges and scales. That the states are those of Maugis 1992 is a check of mdr-crosscheck.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Error, Material, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation, tabor_number};
use mdr_numeric::folds::folds;
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
    let tip = Quadrature::of([Shape::Power { n: 0.25, c: 1.0 }]).unwrap();
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
