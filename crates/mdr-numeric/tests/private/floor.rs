//! A floor of g is not above a state where g falls below its indentation further out, nor where it is not known.

use std::sync::Arc;

use mdr_core::contact::{Control, Expression, Material};
use mdr_core::number::{Dual, Precision, Real};

use super::*;
use crate::contact::Contact;
use crate::transform::{Enclosed, EnclosedWithSlopes};

fn number(text: &str) -> Interval {
    Interval::from_literal(Precision::new(64), &text.parse().unwrap())
}

fn curve(formula: &str) -> EnclosedCurve {
    let (formula, none): (Expression, _) = (formula.parse().unwrap(), Default::default());
    let bound = formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(64)).unwrap();
    let transform = Enclosed::new(bound, Precision::new(64));
    let moving = Arc::new(EnclosedWithSlopes::new(transform.clone()));
    let [one, work] = ["1", "1e-4"].map(number);
    let of_dual = Material::new(Dual::constant(one.clone()), Dual::constant(work.clone())).unwrap();
    let moving = Contact::half_space(&moving, &of_dual, &Control::Indentation);
    let plain = Contact::half_space(&Arc::new(transform), &Material::new(one, work).unwrap(), &Control::Indentation);
    EnclosedCurve::new(plain, moving).by_integrals()
}

/// Of a dip at 0.5, of which g falls to −5 and rises to 2.6 again.
#[test]
fn what_falls_below_a_state_is_seen() {
    let curve = curve("r^2/2 - 0.2*(exp(-((r - 0.5)*1000)^2) - exp(-(0.5*1000)^2))");
    let range = (number("1e-2").lower().clone(), number("1").upper().clone());
    let floor = Floor::new(curve.clone(), range, 4000);
    let is_above = |a: &str, to: &str| {
        let a = number(a);
        let d = curve.plain().indentation(&a).unwrap();
        floor.is_above(&Place { a, d }, number(to).lower())
    };
    // Before the dip, at the least g beside it, below the greatest and beyond that, and where g rises for ever.
    for (a, expected) in [("0.3", false), ("0.4996", true), ("0.501", false), ("0.502", false), ("0.7", true)] {
        assert_eq!(is_above(a, "3"), expected, "{a}");
    }
    assert!(!is_above("0.7", "9") && !is_above("0.001", "3"), "where the minima are not known");
}
