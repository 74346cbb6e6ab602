//! The generic functions in every arithmetic, and identities of the family and of physics.

use mdr_analytic::{Equilibria, PowerLaw, PowerLawContact, double};
use mdr_core::contact::{Control, Equilibrium, Material, Ranged, Stability};
use mdr_core::number::{Dual, Interval, Precision, Real};
use proptest::prelude::*;
use rug::Float;
use rug::ops::Pow;

use super::bisection::{BITS, Scene, float};
use crate::common::mpfr::ulps;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 150 / 256))]

    #[test]
    fn every_arithmetic_agrees(n in 0.05..6.0f64, f in 0.01..0.999f64, other in any::<bool>(), by_force in any::<bool>()) {
        prop_assume!((n - 0.5).abs() > 1e-2);
        let scene = Scene::with_fold(n, 1e-6, 1e7, 0.05, by_force);
        let value = scene.truth().at_fold() * if other { -1.0 / f } else { f };
        let truth = scene.truth();
        let radii = truth.equilibria(value);
        let precision = Precision::new(200);
        let intervals = scene.contact::<Interval>(precision);
        let enclosed = intervals.equilibria(&scene.control(), &Interval::from_f64(precision, value)).unwrap();
        let floats = scene.contact::<Float>(precision);
        let floats = floats.equilibria(&scene.control(), &Float::with_val(200, value)).unwrap();
        let doubles = scene.contact::<f64>(()).equilibria(&scene.control(), &value).unwrap();
        prop_assert_eq!(enclosed.as_slice().len(), radii.len());
        prop_assert_eq!(floats.as_slice().len(), radii.len());
        prop_assert_eq!(doubles.as_slice().len(), radii.len());
        for (i, ln_a) in radii.iter().enumerate() {
            let (a, [_, force]) = (ln_a.clone().exp(), truth.state(ln_a));
            let state = &enclosed.as_slice()[i];
            prop_assert!(state.contact_radius.contains(&a) && state.force.contains(&Float::with_val(200, &force)) | by_force);
            prop_assert!(state.contact_radius.accuracy_bits() > 160, "{}", state.contact_radius.accuracy_bits());
            // Terms over slope: the effect of a relative rounding of a term on ln a.
            let [g, elongation, _] = truth.terms(ln_a);
            let terms = (g + elongation) * if by_force { a.clone() * 2u32 * scene.e } else { float(1.0) };
            let condition = (terms / truth.slope(ln_a)).abs().to_f64() + 1.0;
            let error = |found: &Float| (Float::with_val(BITS, found - &a) / &a).abs().to_f64();
            // κ and powers err by up to 40 roundings and |n ln a| ones.
            let allowed = (60.0 + 2.0 * (n + 1.0) * ln_a.to_f64().abs()) * condition;
            let mp = error(&floats.as_slice()[i].contact_radius);
            prop_assert!(mp <= allowed * 2f64.powi(-200), "{} of {}", mp * 2f64.powi(200), allowed);
            let double = error(&float(doubles.as_slice()[i].contact_radius));
            prop_assert!(double <= allowed * 2f64.powi(-53), "{} of {}", double * 2f64.powi(53), allowed);
        }
    }

    /// The stable equilibrium is the lower in energy, d'(a) or F'(a) has the sign of stability, and da/dx = 1/x'(a).
    #[test]
    fn stability_energy_and_slope(n in 0.05..6.0f64, f in 0.05..0.95f64, by_force in any::<bool>()) {
        prop_assume!((n - 0.5).abs() > 1e-2);
        let scene = Scene::with_fold(n, 1e-6, 1e7, 0.05, by_force);
        let value = scene.truth().at_fold() * f;
        let contact = scene.contact::<f64>(());
        let found = contact.equilibria(&scene.control(), &value).unwrap();
        let Equilibria::Two(states) = &found else { panic!("two equilibria") };
        let slope = |state: &Equilibrium<f64>| {
            let a = &state.contact_radius;
            if by_force { contact.force_slope(a).unwrap() } else { contact.indentation_slope(a).unwrap() }
        };
        for state in states {
            prop_assert_eq!(slope(state) > 0.0, state.stability == Stability::Stable);
        }
        // Under a dead load the energy of the load is included.
        let energy = |state: &Equilibrium<f64>| {
            let elastic = contact.energy(&state.contact_radius, &state.indentation).unwrap();
            if by_force { elastic - value * state.indentation } else { elastic }
        };
        let stable = found.stable().unwrap();
        let unstable = states.iter().find(|state| state.stability == Stability::Unstable).unwrap();
        prop_assert!(energy(stable) < energy(unstable));

        let constant = Dual::constant;
        let profile = PowerLaw::new(constant(scene.n), constant(scene.c)).unwrap();
        let dual = PowerLawContact::new(profile, Material::new(constant(scene.e), constant(scene.w)).unwrap());
        let control = if by_force { Control::Force } else { Control::Indentation };
        let moved = dual.equilibria(&control, &Dual::variable(value)).unwrap();
        for (state, moved) in states.iter().zip(moved.as_slice()) {
            prop_assert!((moved.contact_radius.slope * slope(state) - 1.0).abs() < 1e-6);
        }
    }

    /// m = 2: a = a_c(1 ± √τ)² for the cone and a_c(1 ± √τ)⁴ for n = 1/4, at any distance from the fold.
    #[test]
    fn the_family_of_the_cone(ln_distance in -600.0..-1e-3f64, c in 0.1..10.0f64, quarter in any::<bool>()) {
        let distance = ln_distance.exp();
        let (n, power) = if quarter { (0.25, 4) } else { (1.0, 2) };
        let material = Material::new(1e6, 0.05).unwrap();
        let control = Control::Indentation;
        let found = double::equilibria_at_distance(n, c, &material, &control, distance).unwrap();
        let wide = Scene { n, c, e: 1e6, w: 0.05, by_force: false };
        let fold = wide.truth().ln_fold.exp();
        prop_assert_eq!(found.as_slice().len(), 2);
        for (state, sign) in found.as_slice().iter().zip([-1, 1]) {
            let truth = Float::with_val(BITS, float(distance).sqrt() * sign + 1u32).pow(power) * &fold;
            let Ranged::Value(a) = state.contact_radius else { panic!("in range") };
            prop_assert!(ulps(a, &truth) <= 1.0);
        }
        // In plain f64 the radius is as accurate as that of the fold: κ, powers and |ln a| of roundings.
        let plain = wide.contact::<f64>(()).equilibria_at_distance(&control, &distance).unwrap();
        for (state, sign) in plain.as_slice().iter().zip([-1, 1]) {
            let truth = Float::with_val(BITS, float(distance).sqrt() * sign + 1u32).pow(power) * &fold;
            let allowed = 200.0 / (1.0 - distance.sqrt());
            prop_assert!(ulps(state.contact_radius, &truth) <= allowed, "{}", ulps(state.contact_radius, &truth));
        }
    }

    /// n = 1/2: one equilibrium or none.
    #[test]
    fn scale_free(factor in 0.2..5.0f64, value in -1e-3..1e-3f64, by_force in any::<bool>()) {
        prop_assume!((factor - 1.0).abs() > 1e-6 && value != 0.0);
        let material = Material::new(1e6, 0.05).unwrap();
        let control = if by_force { Control::Force } else { Control::Indentation };
        let c = factor * mdr_analytic::threshold(&material, &control).unwrap();
        let contact = PowerLawContact::new(PowerLaw::new(0.5, c).unwrap(), material.clone());
        let found = contact.equilibria(&control, &value).unwrap();
        prop_assert_eq!(found.as_slice().len(), usize::from((factor > 1.0) == (value > 0.0)));
        let doubles = double::equilibria(0.5, c, &material, &control, value).unwrap();
        prop_assert_eq!(doubles.as_slice().len(), found.as_slice().len());
        for (state, double) in found.as_slice().iter().zip(doubles.as_slice()) {
            prop_assert_eq!(state.stability, if factor > 1.0 { Stability::Stable } else { Stability::Unstable });
            let a = &state.contact_radius;
            let (d, f) = (contact.indentation(a).unwrap(), contact.force(a).unwrap());
            // The difference ρ − 1 or ρ/3 − 1 has lost some of its digits.
            let allowed = 200.0 * f64::EPSILON / (factor - 1.0).abs();
            // d vanishes at ρ = 1 and F at ρ = 3: both on the scale of their terms.
            let terms = contact.detachment_elongation(a).unwrap() * (1.0 + factor * 3.0);
            prop_assert!((d - state.indentation).abs() < allowed * terms);
            prop_assert!((f - state.force).abs() < allowed * terms * 2e6 * a);
            let Ranged::Value(double) = double.contact_radius else { panic!("in range") };
            prop_assert!((double / a - 1.0).abs() < allowed * (1.0 + factor));
        }
    }
}
