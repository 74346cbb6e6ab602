//! Properties of any contact.

use std::f64::consts::PI;

use mdr_analytic::{PowerLaw, PowerLawContact, State, universal_force, universal_indentation};
use mdr_core::contact::{Control, Error, Material, Transform};
use mdr_core::number::Dual;
use proptest::prelude::*;

use crate::common::contact;

fn machine(stiffness: f64) -> Control<f64> {
    Control::machine(stiffness).unwrap()
}

/// A relative bound for quantities that need ln(B/N²)/(2n−1): the error of the logarithm is a few units of 2⁻⁵³ from
/// its argument, 2n−1 divides that, and the quotient, as an exponent, contributes its own magnitude.
fn bound(contact: &PowerLawContact<f64>, a: f64) -> f64 {
    let excess = (2.0 * contact.profile().exponent() - 1.0).abs();
    f64::EPSILON * (10.0 + 10.0 / excess + 3.0 * a.ln().abs())
}

prop_compose! {
    fn exponent()(n in prop_oneof![0.02..0.49, 0.51..0.8, 0.8..5.0, 5.0..60.0f64]) -> f64 { n }
}

prop_compose! {
    fn contact_with(n: impl Strategy<Value = f64>)(n in n, c in -3.0..3.0f64, e in -3.0..9.0f64, w in -3.0..1.0f64) -> PowerLawContact<f64> {
        contact(n, 10f64.powf(c), 10f64.powf(e), 10f64.powf(w))
    }
}

fn any_contact() -> impl Strategy<Value = PowerLawContact<f64>> {
    contact_with(exponent())
}

fn controls() -> impl Strategy<Value = Control<f64>> {
    prop_oneof![Just(Control::Indentation), Just(Control::Force), (-6.0..6.0f64).prop_map(|k| machine(10f64.powf(k)))]
}

/// Whether all numbers on the way to the critical state are in the range of `f64`.
fn in_range(result: &Result<State<f64>, Error>) -> bool {
    result.as_ref().is_ok_and(|c| (1e-100..1e100).contains(&c.contact_radius))
}

proptest! {
    #[test]
    fn critical_states_are_equilibria_and_extrema(contact in any_contact(), control in controls()) {
        let critical = contact.critical(&control);
        prop_assume!(in_range(&critical));
        let State { contact_radius: a, indentation: d, force: f } = critical.unwrap();
        let tolerance = bound(&contact, a) * (1.0 + contact.profile().exponent());
        // d = g − Δl and F = 2E*(ad − G), against the larger of the two terms.
        let elongation = contact.detachment_elongation(&a).unwrap();
        let g = contact.profile().g(&a).unwrap();
        prop_assert!((contact.indentation(&a).unwrap() - d).abs() <= tolerance * elongation.max(g));
        let scale = 2.0 * contact.material().effective_modulus() * a * elongation.max(g);
        prop_assert!((contact.force(&a).unwrap() - f).abs() <= tolerance * scale);
        // The controlled quantity is stationary.
        let (d_slope, f_slope) = (contact.indentation_slope(&a).unwrap(), contact.force_slope(&a).unwrap());
        let (slope, size) = match control {
            Control::Indentation => (d_slope, elongation / a),
            Control::Force => (f_slope, scale / a),
            Control::Machine { stiffness } => (stiffness * d_slope + f_slope, stiffness * elongation / a + scale / a),
        };
        prop_assert!(slope.abs() <= 10.0 * tolerance * size, "{slope:e} {size:e}");
    }

    #[test]
    fn slopes_are_derivatives(contact in any_contact(), ln_a in -5.0..5.0f64) {
        let dual = |x: f64| Dual::constant(x);
        let profile = PowerLaw::new(dual(*contact.profile().exponent()), dual(*contact.profile().coefficient())).unwrap();
        let (e, w) = (contact.material().effective_modulus(), contact.material().work_of_adhesion());
        let lifted = PowerLawContact::new(profile, Material::new(dual(*e), dual(*w)).unwrap());
        let a = ln_a.exp();
        let variable = Dual::variable(a);
        let (d, f) = (lifted.indentation(&variable).unwrap(), lifted.force(&variable).unwrap());
        // Each is a difference of two terms; both sides round in both.
        let size = contact.profile().slope(&a).unwrap() + contact.detachment_elongation(&a).unwrap() / a;
        let tolerance = 1e-13 * size;
        prop_assert!((d.slope - contact.indentation_slope(&a).unwrap()).abs() <= tolerance);
        prop_assert!((f.slope - contact.force_slope(&a).unwrap()).abs() <= tolerance * 8.0 * e * a);
        // ∂Π/∂d = F and ∂Π/∂a = 0 at an equilibrium.
        let along_d = lifted.energy(&dual(a), &Dual::variable(d.value)).unwrap().slope;
        prop_assert!((along_d - f.value).abs() <= tolerance * 8.0 * e * a * a);
        let along_a = lifted.energy(&variable, &dual(d.value)).unwrap().slope;
        prop_assert!(along_a.abs() <= 1e-13 * (1.0 + 1.0 / contact.profile().exponent()) * 40.0 * e * a * a * size * size);
    }

    #[test]
    fn universal_curves(contact in any_contact(), ln_scaled in -2.0..2.0f64) {
        let critical = contact.critical(&Control::Indentation);
        prop_assume!(in_range(&critical));
        let State { contact_radius: a_c, indentation, force } = critical.unwrap();
        let (n, scaled) = (*contact.profile().exponent(), ln_scaled.exp());
        let a = scaled * a_c;
        let tolerance = bound(&contact, a_c) * (1.0 + n);
        let elongation = contact.detachment_elongation(&a).unwrap();
        let g = contact.profile().g(&a).unwrap();
        let d = universal_indentation(&n, &scaled).unwrap() * indentation.abs();
        prop_assert!((contact.indentation(&a).unwrap() - d).abs() <= tolerance * elongation.max(g));
        let scale = 2.0 * contact.material().effective_modulus() * a * elongation.max(g);
        let f = universal_force(&n, &scaled).unwrap() * force.abs();
        prop_assert!((contact.force(&a).unwrap() - f).abs() <= tolerance * scale);
    }

    #[test]
    fn folds_lie_between_the_limits(contact in any_contact(), k in -8.0..8.0f64) {
        let limits = (contact.critical(&Control::Indentation), contact.critical(&Control::Force));
        prop_assume!(in_range(&limits.0) && in_range(&limits.1));
        let (grips, load) = (limits.0.unwrap().contact_radius, limits.1.unwrap().contact_radius);
        let folds = contact.machine_folds(&10f64.powf(k)).unwrap();
        prop_assert!(folds.len() == 1 || folds.len() == 3);
        // The radius in units of k/2E* comes from its logarithm, where (n − 1/2) ln(k/2E*) is rounded and divided again.
        let unit = 10f64.powf(k) / (2.0 * contact.material().effective_modulus());
        let slack = 4.0 * bound(&contact, grips.max(load)) + 4.0 * f64::EPSILON * unit.ln().abs();
        for fold in &folds {
            prop_assert!(fold.contact_radius >= grips.min(load) * (1.0 - slack));
            prop_assert!(fold.contact_radius <= grips.max(load) * (1.0 + slack));
        }
        prop_assert!(folds.windows(2).all(|pair| pair[0].contact_radius < pair[1].contact_radius));
    }

    #[test]
    fn work_lost_is_the_difference_in_energy(contact in contact_with(0.51..60.0)) {
        let critical = contact.critical(&Control::Indentation);
        prop_assume!(in_range(&critical));
        let State { contact_radius: a, indentation: d, .. } = critical.unwrap();
        let adhesion = PI * a * a * contact.material().work_of_adhesion();
        let lost = contact.energy_lost_at_pull_off().unwrap();
        // Π = E*∫(d−g)² − πa²w cancels in part; the first term is at most a few times the second.
        let tolerance = 40.0 * bound(&contact, a) * adhesion;
        prop_assert!((contact.energy(&a, &d).unwrap() - lost).abs() <= tolerance);
        let a = contact.radius_at_zero_indentation().unwrap();
        let adhesion = PI * a * a * contact.material().work_of_adhesion();
        let lost = contact.energy_lost_at_jump_in().unwrap();
        prop_assert!((contact.energy(&a, &0.0).unwrap() + lost).abs() <= 40.0 * bound(&contact, a) * adhesion);
    }

    /// Powers of two change no significand: E* and w by the same factor leaves a and d bit-identical and multiplies F.
    #[test]
    fn powers_of_two(contact in any_contact(), shift in -40..40i32) {
        let factor = 2f64.powi(shift);
        let (e, w) = (contact.material().effective_modulus(), contact.material().work_of_adhesion());
        let scaled = PowerLawContact::new(contact.profile().clone(), Material::new(e * factor, w * factor).unwrap());
        for control in [Control::Indentation, Control::Force] {
            let (one, other) = (contact.critical(&control), scaled.critical(&control));
            prop_assume!(in_range(&one));
            let (one, other) = (one.unwrap(), other.unwrap());
            prop_assert_eq!(one.contact_radius, other.contact_radius);
            prop_assert_eq!(one.indentation, other.indentation);
            prop_assert_eq!(one.force * factor, other.force);
        }
    }

    #[test]
    fn larger_work_of_adhesion_needs_a_larger_pull(n in 0.6..20.0f64, w in 0.01..1.0f64, more in 1.001..3.0f64) {
        let pull = |w| contact(n, 1.0, 1.0, w).critical(&Control::Force).unwrap().force;
        prop_assert!(pull(w * more) < pull(w));
    }
}
