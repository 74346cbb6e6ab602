//! What is narrow is seen, and what is not is not.

use mdr_core::contact::Expression;
use mdr_core::number::{Precision, Real};

use super::*;

/// As many bits as a test asks for.
const MANY: u32 = 200;

pub(in crate::transform::enclosed) fn number(text: &str) -> Interval {
    Interval::from_literal(Precision::new(MANY), &text.parse().unwrap())
}

pub(in crate::transform::enclosed) fn store(formula: &str) -> Store {
    let (formula, none): (Expression, _) = (formula.parse().unwrap(), Default::default());
    let enclosed = formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(MANY)).unwrap();
    Store::new(enclosed.part(0).unwrap().clone(), Arc::default())
}

/// What is narrow is not passed over, and radii before it are not cut.
#[test]
fn cuts_lie_between_what_is_narrow_and_the_radius() {
    let dip = store("r^2/2 - 0.2*exp(-((r - 0.5037)/1e-6)^2)");
    for (x, least) in [("0.504", 0.50371), ("0.51", 0.504), ("0.8", 0.504), ("30", 0.504)] {
        let Below::Cut { at: c, .. } = dip.below(&number(x)) else { panic!("{x} is not cut") };
        assert!(c > least && c < x.parse::<f64>().unwrap(), "{x}: {c}");
    }
    assert!(matches!(dip.below(&number("0.1")), Below::Nothing));
    let close = number("0.50371").hull(&number("0.5038"));
    assert!(matches!(dip.below(&close), Below::Narrow));
}

/// Where f is level, as just before a pole, its terms cancel, and the cells are not called narrow.
#[test]
fn level_heights_are_not_narrow() {
    let pole = store("r^2/2 - 0.01/(1 + ((r - 0.4)/1e-4)^2)");
    for x in ["0.39915", "0.39917478", "0.3992", "0.3995"] {
        assert!(matches!(pole.below(&number(x)), Below::Cut { .. }), "{x}");
    }
}
