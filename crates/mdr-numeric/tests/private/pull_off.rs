//! The derivatives of both conditions bound their differences, and are no wider than they need be.

use std::sync::Arc;

use mdr_core::contact::{Control, Expression, Material};
use mdr_core::number::Precision;

use super::*;
use crate::contact::Contact;
use crate::transform::Enclosed;

/// Profiles with a contact radius and the width of a ring: wide, narrow, and over a kink and under one.
const RINGS: [(&str, f64, f64); 6] = [
    ("r^2/2", 0.02, 0.025),
    ("r^2/2", 0.0328, 7.4e-6),
    ("0.5*r + r^3", 0.3, 0.1),
    ("r^2/2 + 0.3*max(0, r - 0.1)", 0.09, 0.03),
    ("r^2/2 + 0.3*max(0, r - 0.1)", 0.11, 0.03),
    ("sqrt(r^2 + 0.01) - 0.1", 0.0027, 0.011),
];

#[test]
fn slopes_bound_differences() {
    let precision = Precision::new(120);
    let number = |value: f64| Interval::from_f64(precision, value);
    for (formula, a, width) in RINGS {
        let (parsed, none) = (formula.parse::<Expression>().expect("a formula"), Default::default());
        let breaks = parsed.breaks(&none).expect("kinks");
        let bound = || parsed.enclosed(&none, &breaks, precision).expect("no names");
        let material = Material::new(number(1.0), number(1e-3)).expect("positive");
        let transform = Arc::new(Enclosed::new(bound(), precision));
        let contact = Contact::half_space(&transform, &material, &Control::Force);
        let contact = Dugdale::new(contact, &number(1e-3)).expect("a separation");
        let profile = Continuation::new(vec![bound()]).expect("kinks apart");
        let proof = EnclosedPullOff::new(&contact, &profile);
        let far = [number(a * (1.0 + 1e-13)), number(width * (1.0 - 2e-13))];
        let near = [number(a), number(width)];
        let both = [0, 1].map(|i| near[i].hull(&far[i]));
        let [one, other, over] = [&near, &far, &both].map(|place| proof.conditions(place).expect("conditions"));
        for condition in 0..2 {
            let change = other.values[condition].clone() - &one.values[condition];
            let steps = [0, 1].map(|i| (far[i].clone() - &near[i]) * &over.slopes[condition][i]);
            let bound = steps[0].clone() + &steps[1];
            assert!(bound.overlaps(&change), "{formula}, {a}, {condition}: {change} and {bound}");
            let size = steps[0].abs() + steps[1].abs();
            assert!(Interval::point(bound.radius()) < size.over(100), "{formula}, {a}, {condition}: {bound}");
        }
    }
}
