//! The closed forms of power laws: published numbers, one function in several arithmetics, and properties.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::PI;

use approx::assert_relative_eq;
use mdr_analytic::{
    Contact, Critical, Fate, PowerLaw, flat_punch_pull_off, lemniscate_constant, threshold, universal_force,
    universal_indentation,
};
use mdr_core::contact::{Control, Error, FoldKind, Material, Regime, Transform};
use mdr_core::number::Dual;
use proptest::prelude::*;

fn contact(n: f64, c: f64, e_star: f64, work: f64) -> Contact<f64> {
    Contact::new(PowerLaw::new(n, c).unwrap(), Material::new(e_star, work).unwrap())
}

fn machine(stiffness: f64) -> Control<f64> {
    Control::machine(stiffness).unwrap()
}

/// A relative bound for quantities that need ln(B/N²)/(2n−1): the logarithm is wrong by a few units of 2⁻⁵³ from its
/// argument, 2n−1 divides that, and the quotient, as an exponent, contributes its own size.
fn bound(contact: &Contact<f64>, a: f64) -> f64 {
    let excess = (2.0 * contact.profile().exponent() - 1.0).abs();
    f64::EPSILON * (10.0 + 10.0 / excess + 3.0 * a.ln().abs())
}

// Published values.

#[test]
fn johnson_kendall_roberts() {
    let (radius, e_star, work) = (2e-3, 3e6, 0.07);
    let ball = Contact::new(PowerLaw::paraboloid(radius).unwrap(), Material::new(e_star, work).unwrap());
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
    let cone = Contact::new(PowerLaw::cone(0.2).unwrap(), material.clone());
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

/// C at the threshold grows as √(w/E*): enclosures of its derivative are sharp, as ϖ is a constant.
#[cfg(feature = "mp")]
#[test]
fn the_threshold_is_differentiated_over_enclosures() {
    use mdr_core::number::{Interval, Precision, Real};

    let precision = Precision::new(120);
    let [two, three] = [2, 3].map(|value| Interval::from_int(precision, value));
    let material = Material::new(Dual::constant(three), Dual::variable(two)).unwrap();
    for control in [Control::Indentation, Control::Force] {
        let threshold = threshold(&material, &control).unwrap();
        let half = threshold.slope.times(4) / threshold.value;
        assert!(half.contains(&rug::Float::with_val(120, 1)) && half.accuracy_bits() > 110, "{half:?}");
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
        (0.9 * critical_c, Fate::CompleteContact, Fate::CompleteContact),
        (1.1 * critical_c, Fate::Shrinks, Fate::CompleteContact),
        (3.1 * critical_c, Fate::Shrinks, Fate::Shrinks),
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
    // log10 of a result that f64 cannot hold: ln(B/N²)/(2n−1) with 2n−1 = 2⁻⁹.
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

// Properties.

prop_compose! {
    fn exponent()(n in prop_oneof![0.02..0.49, 0.51..0.8, 0.8..5.0, 5.0..60.0f64]) -> f64 { n }
}

prop_compose! {
    fn contact_with(n: impl Strategy<Value = f64>)(n in n, c in -3.0..3.0f64, e in -3.0..9.0f64, w in -3.0..1.0f64) -> Contact<f64> {
        contact(n, 10f64.powf(c), 10f64.powf(e), 10f64.powf(w))
    }
}

fn any_contact() -> impl Strategy<Value = Contact<f64>> {
    contact_with(exponent())
}

fn controls() -> impl Strategy<Value = Control<f64>> {
    prop_oneof![Just(Control::Indentation), Just(Control::Force), (-6.0..6.0f64).prop_map(|k| machine(10f64.powf(k)))]
}

/// Whether all numbers on the way to the critical state are in the range of `f64`.
fn in_range(result: &Result<Critical<f64>, Error>) -> bool {
    result.as_ref().is_ok_and(|c| (1e-100..1e100).contains(&c.contact_radius))
}

proptest! {
    #[test]
    fn critical_states_are_equilibria_and_extrema(contact in any_contact(), control in controls()) {
        let critical = contact.critical(&control);
        prop_assume!(in_range(&critical));
        let Critical { contact_radius: a, indentation: d, force: f } = critical.unwrap();
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
        let lifted = Contact::new(profile, Material::new(dual(*e), dual(*w)).unwrap());
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
        let Critical { contact_radius: a_c, indentation, force } = critical.unwrap();
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
        let Critical { contact_radius: a, indentation: d, .. } = critical.unwrap();
        let adhesion = PI * a * a * contact.material().work_of_adhesion();
        let lost = contact.energy_lost_at_pull_off().unwrap();
        // Π = E*∫(d−g)² − πa²w loses what cancels; the first term is at most a few times the second.
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
        let scaled = Contact::new(contact.profile().clone(), Material::new(e * factor, w * factor).unwrap());
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

// The same functions in other arithmetics.

#[cfg(feature = "mp")]
mod arithmetics {
    use mdr_core::number::{Interval, Literal, Precision, Real};
    use rug::Float;

    use super::*;

    fn generic<R: mdr_analytic::Kappa>(ctx: R::Ctx, inputs: [&str; 4]) -> Contact<R> {
        let [n, c, e, w] = inputs.map(|text| R::from_literal(ctx, &text.parse::<Literal>().unwrap()));
        Contact::new(PowerLaw::new(n, c).unwrap(), Material::new(e, w).unwrap())
    }

    /// All numbers that the closed forms give, in one arithmetic.
    fn everything<R: mdr_analytic::Kappa>(ctx: R::Ctx, inputs: [&str; 4]) -> Vec<R> {
        let contact = generic::<R>(ctx, inputs);
        let stiffness = contact.material().effective_modulus().clone();
        let mut numbers = vec![contact.profile().kappa().clone()];
        let mut state = |state: Critical<R>| numbers.extend([state.contact_radius, state.indentation, state.force]);
        for control in [Control::Indentation, Control::Force, Control::machine(stiffness.clone()).unwrap()] {
            state(contact.critical(&control).unwrap());
        }
        for fold in contact.machine_folds(&stiffness).unwrap() {
            numbers.extend([fold.contact_radius, fold.indentation, fold.force]);
        }
        let a = contact.radius_at_zero_indentation().unwrap();
        numbers.push(contact.energy(&a, &a).unwrap());
        numbers.push(threshold(contact.material(), &Control::Force).unwrap());
        numbers
    }

    const CASES: [[&str; 4]; 6] = [
        ["2", "0.5", "1e6", "0.05"],
        ["0.25", "1", "1e6", "0.05"],
        ["0.6", "2.4829", "1", "1"],
        ["0.7", "1", "1", "1"],
        ["3.3", "1e5", "1e9", "0.01"],
        ["40", "1e3", "1e3", "1"],
    ];

    #[test]
    fn intervals_contain_what_more_bits_give() {
        for inputs in CASES {
            let narrow = everything::<Interval>(Precision::new(160), inputs);
            let sharp = everything::<Float>(Precision::new(400), inputs);
            assert_eq!(narrow.len(), sharp.len());
            for (enclosure, value) in narrow.iter().zip(&sharp) {
                assert!(enclosure.contains(value), "{inputs:?}: {enclosure:?} {value}");
                assert!(enclosure.accuracy_bits() > 120, "{inputs:?}: {enclosure:?}");
            }
        }
    }

    #[test]
    fn doubles_agree_with_many_bits() {
        for inputs in CASES {
            let doubles = everything::<f64>((), inputs);
            let sharp = everything::<Float>(Precision::new(200), inputs);
            for (double, value) in doubles.iter().zip(&sharp) {
                // |2n−1| ≥ 0.2 and |ln a| < 80: see `bound`. Rounding n itself costs as much again.
                assert_relative_eq!(*double, value.to_f64(), max_relative = 600.0 * f64::EPSILON);
            }
        }
    }

    #[test]
    fn duals_carry_the_derivatives_of_folds() {
        let at = |text: &str| {
            let n = Float::with_val(300, Float::parse(text).unwrap());
            let one = Float::with_val(300, 1);
            let contact = Contact::new(
                PowerLaw::new(Dual::variable(n), Dual::constant(one.clone())).unwrap(),
                Material::new(Dual::constant(one.clone()), Dual::constant(one.clone())).unwrap(),
            );
            contact.machine_folds(&Dual::constant(one)).unwrap()[0].contact_radius.clone()
        };
        let here = at("0.9");
        // A central difference of half-width h = 10⁻²⁰: truncation ~ h², far below the 30 digits that are left.
        let (above, below) = (at("0.90000000000000000001"), at("0.89999999999999999999"));
        let difference: Float = (above.value - below.value) * Float::with_val(300, Float::parse("5e19").unwrap());
        let relative: Float = difference / &here.slope - 1u32;
        assert!(relative.abs() < 1e-30);
        // Over intervals derivative and value are enclosures: n in 9/10 ± 2⁻⁹⁶.
        let one = Interval::from_int(Precision::new(100), 1);
        let n = one.ratio(9, 10).inflate(&one.lit(2).powi(-96));
        let contact = Contact::new(
            PowerLaw::new(Dual::variable(n), Dual::constant(one.clone())).unwrap(),
            Material::new(Dual::constant(one.clone()), Dual::constant(one.clone())).unwrap(),
        );
        let enclosed = contact.machine_folds(&Dual::constant(one)).unwrap()[0].contact_radius.clone();
        assert!(enclosed.value.contains(&here.value) && enclosed.slope.contains(&here.slope));
        assert!(enclosed.value.accuracy_bits() > 80 && enclosed.slope.accuracy_bits() > 60);
    }

    #[test]
    fn extreme_machines_tend_to_the_limits() {
        let precision = Precision::new(200);
        for inputs in CASES {
            let contact = generic::<Interval>(precision, inputs);
            let at = |k: &str| {
                let stiffness = Interval::from_literal(precision, &k.parse::<Literal>().unwrap());
                contact.critical(&Control::machine(stiffness).unwrap()).unwrap().contact_radius
            };
            let relative = |a: Interval, control| {
                let limit = contact.critical(&control).unwrap().contact_radius;
                ((a - &limit) / limit).approx().abs()
            };
            // s = 2E*a/k is below 10⁻⁴⁰ and above 10⁴⁰.
            assert!(relative(at("1e90"), Control::Indentation) < 1e-38);
            assert!(relative(at("1e-90"), Control::Force) < 1e-38);
        }
    }

    #[test]
    fn merging_folds_are_told_apart_or_undecided() {
        // n = 0.6, E* = w = k = 1: φ at its maximum vanishes for one C. Between one fold and three an interval either
        // knows or says so.
        let mut counts = Vec::new();
        for c in ["2.3", "2.4", "2.4829", "2.6", "2.9"] {
            let one = Interval::from_int(Precision::new(100), 1);
            counts.push(
                generic::<Interval>(Precision::new(100), ["0.6", c, "1", "1"]).machine_folds(&one).unwrap().len(),
            );
        }
        assert!(counts.contains(&1) && counts.contains(&3), "{counts:?}");
    }
}
