//! What is private in `mdr_crosscheck::derivations::direct`.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use super::super::{SamplePoints, Truth, truth_as_written};
use super::*;
use mdr_symbolic::Statement;

fn judged(text: &str) -> Truth {
    let point = SamplePoints::new(text, Domain::Above, &[]).next().unwrap();
    truth_as_written(&text.parse::<Statement>().unwrap(), Domain::Above, &point).unwrap()
}

/// Each operation, alone and within each other, has its value; a wrong one is seen.
#[test]
fn operations_have_their_values() {
    let cases = [
        ("diff(a^3*w, a) = 3*a^2*w", "diff(a^3*w, a) = 2*a^2*w"),
        ("diff(diff(a^n, a), a) = n*(n - 1)*a^(n - 2)", "diff(diff(a^n, a), a) = n^2*a^(n - 2)"),
        ("diff(diff(diff(1/a, a), a), a) = -6/a^4", "diff(diff(diff(1/a, a), a), a) = 6/a^4"),
        ("at(diff(a^2*x, a), a, x + d) = 2*(x + d)*x", "at(diff(a^2*x, a), a, x + d) = 2*a*x"),
        ("diff(at(x^2, x, a*d), a) = 2*a*d^2", "diff(at(x^2, x, a*d), a) = 2*a*d"),
        ("int(x^(n - 1), x, a) = a^n/n", "int(x^(n - 1), x, a) = a^n/(n + 1)"),
        ("diff(int((a - x)^2, x, a), a) = a^2", "diff(int((a - x)^2, x, a), a) = 0*a"),
        ("diff(G, a) + diff(Q, a) = g + g^2", "diff(G, a) + diff(Q, a) = 2*g"),
        ("diff(g, a) = g'", "diff(g, a) = g/a"),
        ("diff(cosθ*sinθ, θ) = 1 - 2*sinθ^2", "diff(cosθ*sinθ, θ) = cosθ^2"),
        ("at(κ*C^n, n, 2) = 2*C^2", "at(κ*C^n, n, 2) = κ*C^2"),
        ("at(d_g, g, C*a) = C*a - Δl", "at(d_g, g, C*a) = d_g"),
    ];
    for (right, wrong) in cases {
        assert_eq!((judged(right), judged(wrong)), (Truth::Certain, Truth::False), "{right}");
    }
}

/// What the normal form has lost is seen: there is no value.
#[test]
fn cancelled_divisors_are_divided_by() {
    assert!(matches!(judged("at(x^2/x^2, x, 0) = 1"), Truth::Undefined | Truth::Unknown));
    let point = SamplePoints::new("", Domain::Above, &[]).next().unwrap();
    let fourth: Formula = "diff(diff(diff(diff(a, a), a), a), a)".parse().unwrap();
    let value = evaluate(&fourth, Domain::Above, &Direct::<Interval>::new(&point, []));
    assert!(matches!(value, Err(Error::TooLarge(_))), "{value:?}");
}
