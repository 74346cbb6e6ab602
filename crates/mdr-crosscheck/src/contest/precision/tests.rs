use mdr_analytic::double;
use mdr_core::contact::{Control, Material, Ranged};

use super::question::irrational;
use super::*;

fn digits(point: &Point) -> f64 {
    point.outcome.digits().unwrap_or_else(|| panic!("{point:?}"))
}

#[test]
fn whoever_is_asked_for_digits_gives_them() {
    let found = diagrams(&mut Setup::new(Effort::Quick, Clock::Off));
    assert_eq!(found.len(), 4);
    for diagram in &found {
        for curve in &diagram.curves {
            // A rule kept from before has no count of its own, and 16 digits no nodes of its own.
            let asked = &ladder(Effort::Quick)[3 - curve.points.len()..];
            for (point, asked) in curve.points.iter().zip(asked) {
                // Sixteen guard bits hold the roundings of all but the most careless formula.
                let found = digits(point);
                let (asked, name) = (f64::from(*asked), &curve.contestant);
                assert!(found >= asked && found < asked + 12.0, "{}, {name}: {found} of {asked}", diagram.id);
            }
        }
    }
}

/// κ_{1/3} and κ_{1/2} by the arithmetic-geometric mean of MPFR, rounded both ways.
#[test]
fn the_truth_agrees_with_the_arithmetic_geometric_mean() {
    use rug::float::Round;
    let precision = Precision::new(3000);
    let one = Interval::from_int(precision, 1);
    let mean = |modulus: Interval| {
        let end = |modulus: &Float, round| {
            let mut value = Float::with_val(3000, 1);
            value.agm_round(modulus, round);
            value
        };
        Interval::new(end(modulus.lower(), Round::Down), end(modulus.upper(), Round::Up))
    };
    let half = one.pi().over(2) / mean(one.lit(2).sqrt());
    let third = {
        let modulus = ((one.lit(3).sqrt() + one.lit(2)).over(4)).sqrt();
        one.lit(3).pow(&one.ratio(3, 4)).over(3) * one.pi().over(2) / mean(modulus)
    };
    for (expected, q) in [(half, 2), (third, 3)] {
        let found = truth::kappa_of_fraction(precision, 1, q);
        assert!(found.overlaps(&expected) && found.accuracy_bits() > 2990 && expected.accuracy_bits() > 2980);
    }
}

#[test]
fn the_truth_agrees_with_the_definition_by_gamma() {
    for n in [irrational::<Interval>(Precision::new(1000)), Interval::from_f64(Precision::new(1000), 1.75)] {
        let found = truth::kappa_of(&n);
        let expected = crate::checks::by_gamma(&n.mid());
        let distance = (found.mid() - &expected).abs();
        assert!(found.accuracy_bits() > 980 && distance < (Float::with_val(64, 1) >> 980));
    }
}

/// The answer in doubles has its own proof.
#[test]
fn the_truth_of_the_critical_state_is_the_answer_in_doubles() {
    let questions = questions(Precision::new(200));
    let truths = &questions.iter().find(|question| question.id == "critical").unwrap().truths;
    let material = Material::new(1e6, 0.05).unwrap();
    let state = double::critical(0.3, 1.5, &material, &Control::Indentation).unwrap();
    let values = [state.contact_radius, state.indentation, state.force];
    // n = 0.3 is off by u/4 and C, E*, w by u at most; a depends on n as ln(a)/(2n−1), about 100.
    for (value, truth) in values.into_iter().zip(&truths[1..]) {
        let Ranged::Value(value) = value else { panic!("{value:?}") };
        assert!((value / truth.mid().to_f64() - 1.0).abs() < 400.0 * f64::EPSILON);
    }
}
