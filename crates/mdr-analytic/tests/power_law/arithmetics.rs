//! The functions of power laws in other arithmetics than f64.

use approx::assert_relative_eq;
use mdr_analytic::{PowerLaw, PowerLawContact, State, threshold};
use mdr_core::contact::{Control, Material};
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use rug::Float;

fn generic<R: mdr_analytic::Kappa>(ctx: R::Ctx, inputs: [&str; 4]) -> PowerLawContact<R> {
    let [n, c, e, w] = inputs.map(|text| R::from_literal(ctx, &text.parse::<Literal>().unwrap()));
    PowerLawContact::new(PowerLaw::new(n, c).unwrap(), Material::new(e, w).unwrap())
}

/// All numbers that the closed forms give, in one arithmetic.
fn everything<R: mdr_analytic::Kappa>(ctx: R::Ctx, inputs: [&str; 4]) -> Vec<R> {
    let contact = generic::<R>(ctx, inputs);
    let stiffness = contact.material().effective_modulus().clone();
    let mut numbers = vec![contact.profile().kappa().clone()];
    let mut state = |state: State<R>| numbers.extend([state.contact_radius, state.indentation, state.force]);
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
            // |2n−1| ≥ 0.2 and |ln a| < 80: see `bound`. Rounding n itself contributes as much again.
            assert_relative_eq!(*double, value.to_f64(), max_relative = 600.0 * f64::EPSILON);
        }
    }
}

#[test]
fn duals_carry_the_derivatives_of_folds() {
    let at = |text: &str| {
        let n = Float::with_val(300, Float::parse(text).unwrap());
        let one = Float::with_val(300, 1);
        let contact = PowerLawContact::new(
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
    let contact = PowerLawContact::new(
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
    // n = 0.6, E* = w = k = 1: the maximum of φ vanishes for one C. Between one fold and three an interval gives the
    // correct number or is undecided.
    let mut counts = Vec::new();
    for c in ["2.3", "2.4", "2.4829", "2.6", "2.9"] {
        let one = Interval::from_int(Precision::new(100), 1);
        counts.push(generic::<Interval>(Precision::new(100), ["0.6", c, "1", "1"]).machine_folds(&one).unwrap().len());
    }
    assert!(counts.contains(&1) && counts.contains(&3), "{counts:?}");
}

/// C at the threshold grows as √(w/E*): enclosures of its derivative are sharp, as ϖ is a constant.
#[test]
fn the_threshold_is_differentiated_over_enclosures() {
    let precision = Precision::new(120);
    let [two, three] = [2, 3].map(|value| Interval::from_int(precision, value));
    let material = Material::new(Dual::constant(three), Dual::variable(two)).unwrap();
    for control in [Control::Indentation, Control::Force] {
        let threshold = threshold(&material, &control).unwrap();
        let half = threshold.slope.times(4) / threshold.value;
        assert!(half.contains(&Float::with_val(120, 1)) && half.accuracy_bits() > 110, "{half:?}");
    }
}
