//! Published values, and rejected inputs.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use mdr_analytic::{
    PowerLaw, PowerLawContact, ScaleFreeOutcome, flat_punch_pull_off, lemniscate_constant, threshold,
    universal_indentation,
};
use mdr_core::contact::{Control, Error, FoldKind, Material, Regime};

use crate::common::contact;

#[test]
fn johnson_kendall_roberts() {
    let (radius, e_star, work) = (2e-3, 3e6, 0.07);
    let ball = PowerLawContact::new(PowerLaw::paraboloid(radius).unwrap(), Material::new(e_star, work).unwrap());
    let force = ball.critical(&Control::Force).unwrap();
    assert_relative_eq!(force.force, -1.5 * PI * work * radius, max_relative = 1e-14);
    let grips = ball.critical(&Control::Indentation).unwrap();
    assert_relative_eq!(grips.force, -5.0 / 6.0 * PI * work * radius, max_relative = 1e-14);
    // a³ = πwR²/(8E*) under fixed grips, 9 times that under a dead load.
    let cubed = PI * work * radius * radius / (8.0 * e_star);
    assert_relative_eq!(grips.contact_radius.powi(3), cubed, max_relative = 1e-14);
    assert_relative_eq!(force.contact_radius.powi(3), 9.0 * cubed, max_relative = 1e-14);
    // JKR in their own form: a³ = (R/K)(F + 3πwR + √(6πwRF + (3πwR)²)), K = 4E*/3, here at F = 0.
    let a = (6.0 * PI * work * radius * radius / (4.0 * e_star / 3.0)).cbrt();
    assert!(ball.force(&a).unwrap().abs() < 1e-13 * work * radius);
}

#[test]
fn energies_of_the_paraboloid() {
    let ball = contact(2.0, 0.5, 1.0, 1.0);
    let a = ball.critical(&Control::Indentation).unwrap().contact_radius;
    assert_relative_eq!(ball.energy_lost_at_pull_off().unwrap(), 0.4 * PI * a * a, max_relative = 1e-14);
    let a = ball.radius_at_zero_indentation().unwrap();
    assert_relative_eq!(ball.energy_lost_at_jump_in().unwrap(), 0.6 * PI * a * a, max_relative = 1e-14);
    assert!(ball.indentation(&a).unwrap().abs() < 1e-14);
}

#[test]
fn kendall() {
    let material = Material::new(2.0, 3.0).unwrap();
    let punch = flat_punch_pull_off(&0.5, &material).unwrap();
    assert_relative_eq!(punch.force, -(8.0 * PI * 2.0 * 3.0 * 0.125f64).sqrt(), max_relative = 1e-14);
    assert_relative_eq!(punch.indentation, -(2.0 * PI * 3.0 * 0.5 / 2.0f64).sqrt(), max_relative = 1e-14);
    // C = 1, E* = w = 1 tends to the punch of radius 1. To first order in 1/n, with N² ≈ πn³/2 and B = π/2, the force
    // ratio is 1 − (3/(4n))·ln(n³/9) − 3/(2n); the next order is the square of that.
    for n in [1e4, 1e6, 1e8] {
        let blunt = contact(n, 1.0, 1.0, 1.0);
        let limit = blunt.flat_punch_limit().unwrap();
        assert_relative_eq!(limit.contact_radius, 1.0);
        let deficit = 1.0 - blunt.critical(&Control::Force).unwrap().force / limit.force;
        let first = (0.75 * (n.powi(3) / 9.0).ln() + 1.5) / n;
        assert!((deficit - first).abs() < first * first + 10.0 * f64::EPSILON, "n = {n}: {deficit} {first}");
    }
}

#[test]
fn cone() {
    let material = Material::new(4.0, 0.3).unwrap();
    let cone = PowerLawContact::new(PowerLaw::cone(0.2).unwrap(), material.clone());
    let critical = cone.critical(&Control::Indentation).unwrap();
    // a = 2w/(πE*tan²θ), d = −w/(E*tanθ), F = −6w²/(πE*tan³θ); a dead load −54w²/(πE*tan³θ)
    // (Popov, Heß, Willert, Handbook of Contact Mechanics, 3.5.2).
    assert_relative_eq!(critical.contact_radius, 0.6 / (PI * 4.0 * 0.04), max_relative = 1e-14);
    assert_relative_eq!(critical.indentation, -0.3 / 0.8, max_relative = 1e-14);
    assert_relative_eq!(critical.force, -6.0 * 0.09 / (PI * 4.0 * 0.008), max_relative = 1e-14);
    let load = cone.critical(&Control::Force).unwrap();
    assert_relative_eq!(load.force, -54.0 * 0.09 / (PI * 4.0 * 0.008), max_relative = 1e-14);
    let same = PowerLaw::cone_with_half_angle(5f64.atan()).unwrap();
    assert_relative_eq!(*same.coefficient(), 0.2, max_relative = 1e-15);
    assert!(PowerLaw::cone_with_half_angle(1.6).is_err());
}

#[test]
fn paraboloid_on_a_machine() {
    let ball = contact(2.0, 0.5, 1.0, 1.0);
    let a_c = ball.critical(&Control::Indentation).unwrap().contact_radius;
    for (stiffness, ratio) in [(0.1, 2.036_586_53), (1.0, 1.725_266_27), (10.0, 1.131_289_34)] {
        let folds = ball.machine_folds(&(stiffness * 2.0 * a_c)).unwrap();
        assert_eq!(folds.len(), 1);
        assert_eq!(folds[0].kind, FoldKind::Minimum);
        // The references have nine digits.
        assert_relative_eq!(folds[0].contact_radius / a_c, ratio, max_relative = 5e-9);
    }
}

#[test]
fn three_folds() {
    let folds = contact(0.6, 2.4829, 1.0, 1.0).machine_folds(&1.0).unwrap();
    let kinds: Vec<_> = folds.iter().map(|fold| fold.kind).collect();
    assert_eq!(kinds, [FoldKind::Minimum, FoldKind::Maximum, FoldKind::Minimum]);
    for (fold, radius) in folds.iter().zip([0.01271, 0.06940, 459.2]) {
        assert_relative_eq!(fold.contact_radius, radius, max_relative = 5e-4);
    }
}

#[test]
fn one_half() {
    // ϖ = 2.62205755429211981046… (OEIS A062539).
    assert_relative_eq!(lemniscate_constant(&1.0), 2.622_057_554_292_119_8, max_relative = 4.0 * f64::EPSILON);
    let unit = contact(0.5, 1.0, 2.0 * PI, 1.0);
    let critical_c = threshold(unit.material(), &Control::Indentation).unwrap();
    assert!(matches!(unit.critical(&Control::Force), Err(Error::Domain { .. })));
    for (c, fate, under_force) in [
        (0.9 * critical_c, ScaleFreeOutcome::CompleteContact, ScaleFreeOutcome::CompleteContact),
        (1.1 * critical_c, ScaleFreeOutcome::Shrinks, ScaleFreeOutcome::CompleteContact),
        (3.1 * critical_c, ScaleFreeOutcome::Shrinks, ScaleFreeOutcome::Shrinks),
    ] {
        let contact = contact(0.5, c, 2.0 * PI, 1.0);
        assert_eq!(contact.fate(&Control::Indentation).unwrap(), fate);
        assert_eq!(contact.fate(&Control::Force).unwrap(), under_force);
        assert_relative_eq!(contact.ratio().unwrap(), c / critical_c, max_relative = 1e-14);
        let state = contact.scale_free_state(&2.0).unwrap();
        assert_relative_eq!(state.indentation, contact.indentation(&2.0).unwrap(), max_relative = 1e-13);
        assert_relative_eq!(state.force, contact.force(&2.0).unwrap(), max_relative = 1e-13);
        let folds = contact.machine_folds(&3.0).unwrap();
        assert_eq!(folds.len(), usize::from(fate != under_force));
    }
}

#[test]
fn refusals() {
    assert!(PowerLaw::new(f64::NAN, 1.0).is_err());
    assert!(PowerLaw::new(f64::INFINITY, 1.0).is_err());
    assert!(PowerLaw::new(1.0, -1.0).is_err());
    let sharp = contact(0.25, 1.0, 1.0, 1.0);
    assert!(sharp.energy_lost_at_pull_off().is_err() && sharp.energy_lost_at_jump_in().is_err());
    assert!(sharp.barrier_to_complete_contact().unwrap() > 0.0);
    assert!(sharp.indentation(&-1.0).is_err() && sharp.force(&f64::NAN).is_err());
    assert!(universal_indentation(&0.5, &1.0).is_err());
    assert!(sharp.machine_folds(&0.0).is_err());
    // log10 of a result out of the range of f64: ln(B/N²)/(2n−1) with 2n−1 = 2⁻⁹.
    let near = contact(0.5 + 2f64.powi(-10), 1e-3, 1.0, 1.0);
    match near.critical(&Control::Indentation) {
        Err(Error::OutOfRange { log10, .. }) => assert!(log10 > 1000.0, "{log10}"),
        other => panic!("{other:?}"),
    }
    // N² overflows here, the radius does not: (B/N²)^{1/3} with N = 4·10²⁰⁰.
    let steep = contact(2.0, 1e200, 1.0, 1.0).critical(&Control::Indentation).unwrap();
    let expected = (PI / 32.0).cbrt() * 10f64.powf(-400.0 / 3.0);
    // ln a ≈ −308 as an exponent, on both sides.
    assert_relative_eq!(steep.contact_radius, expected, max_relative = 700.0 * f64::EPSILON);
    assert_eq!(contact(0.5, 1.0, 1.0, 1.0).regime().unwrap(), Regime::ScaleFree);
}
