//! What is private in `mdr_crosscheck::derivations::ends`.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use super::End::{Left, Right};
use super::*;
use crate::derivations::SamplePoints;

fn width() -> Interval {
    SamplePoint::interval(&Rational::from((1, 1024)))
}

/// n = 2.
fn point() -> SamplePoint {
    SamplePoints::new("", Domain::Above, &[("n", "2")]).next().unwrap()
}

fn of(text: &str, end: End, point: &SamplePoint) -> Tail {
    tail(&text.parse().unwrap(), point, end, &width())
}

/// Antiderivatives are known. Beside the end sin t/t and cos t vary by less than ε² = 2⁻²⁰, θ by ε = 2⁻¹⁰, and what is left
/// in a sum of powers that differ by 1/2 by √ε = 2⁻⁵; counted in whole binary places up to two bits are lost.
#[test]
fn powers_are_integrated() {
    let (epsilon, sine) = (width(), width().sin());
    let root = |of: &Interval| of.sqrt().times(2);
    let tenth = |of: &Interval| of.pow(&of.ratio(1, 10)).times(10);
    let cases = [
        ("θ^(-1/2)", Left, root(&epsilon), 18),
        ("cosθ/sqrt(sinθ)", Left, root(&sine), 18),
        ("sinθ/sqrt(cosθ)", Right, root(&sine), 18),
        ("cosθ*sinθ^(n - 5/2)", Left, root(&sine), 18),
        ("cosθ*sinθ^(-9/10)", Left, tenth(&sine), 18),
        ("sinθ*cosθ^(-9/10)", Right, tenth(&sine), 18),
        ("cosθ/sqrt(sinθ^(-2) - 1)", Left, epsilon.lit(1) - epsilon.cos(), 18),
        ("sinθ*cosθ", Right, sine.square().over(2), 18),
        ("θ", Right, (epsilon.pi() - &epsilon) * &width().over(2), 8),
        ("cosθ/sqrt(sinθ) + 1", Left, root(&sine) + &epsilon, 3),
        ("1 - sinθ/sqrt(cosθ)", Right, epsilon.clone() - root(&sine), 3),
    ];
    for (text, end, value, bits) in cases {
        let Tail::Enclosed(tail) = of(text, end, &point()) else { panic!("{text}") };
        assert!(tail.overlaps(&value) && tail.accuracy_bits() >= bits, "{text}: {tail} for {value}");
    }
}

/// From the power −1 on, where the factor has a sign. Where terms cancel nothing is said.
#[test]
fn what_diverges() {
    let divergent = [
        ("1/sinθ", Left),
        ("-1/θ", Left),
        ("1/cosθ", Right),
        ("sinθ^(-n)", Left),
        ("1/sinθ - 2", Left),
        ("1/(cosθ*sqrt(sinθ))", Right),
    ];
    for (text, end) in divergent {
        assert!(matches!(of(text, end, &point()), Tail::Divergent), "{text}");
    }
    let unknown = [
        ("1/sinθ - 1/sinθ", Left),
        ("0/sinθ", Left),
        ("1/(1 - sinθ)", Right),
        ("sinθ^(-a)", Left),
        ("H0(θ)", Left),
        ("turn(1)", Left),
    ];
    for (text, end) in unknown {
        assert!(matches!(of(text, end, &point()), Tail::Unknown), "{text}");
    }
}

#[test]
fn roots_of_negative_numbers_are_noted() {
    for (end, undefined) in [(Left, false), (Right, true)] {
        let point = point();
        of("sqrt(cosθ^2 - n^2*sinθ^2)", end, &point);
        assert_eq!(point.is_undefined(), undefined, "{end:?}");
    }
}
