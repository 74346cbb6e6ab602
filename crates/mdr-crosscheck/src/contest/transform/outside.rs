//! Contestants of other projects on the same questions.

use rug::Rational;
use serde_json::{Map, Value};

use super::subject::{Kind, Question};
use super::{Arithmetic, Effort};
use crate::contest::outside::{Outsider, question};

/// Those who integrate: QUADPACK in scipy, in θ and with the weights of its QAWS; mpmath; Arb, rigorously.
pub(super) fn outsiders(question: &Question, effort: Effort) -> Vec<Outsider> {
    let full = effort == Effort::Full;
    let tolerances: &[u32] = if full { &[2, 4, 6, 8, 10, 12, 13] } else { &[6, 12] };
    let digits: &[u32] = if full { &[15, 30, 50, 100] } else { &[15] };
    let asked = |by: &str, efforts: &[u32], unit: &str| {
        let ask = |effort: &u32| {
            let setting = if unit == "digits" { format!("{effort} digits") } else { format!("tolerance 1e-{effort}") };
            (setting, asked(question, by, *effort))
        };
        efforts.iter().map(ask).collect::<Vec<_>>()
    };
    let outsider = |name, package, arithmetic, questions| Outsider { name, package, arithmetic, questions };
    vec![
        outsider("quad in θ", "scipy", Arithmetic::Double, asked("scipy.quad in θ", tolerances, "tolerance")),
        outsider("quad, QAWS", "scipy", Arithmetic::Double, asked("scipy.quad, QAWS", tolerances, "tolerance")),
        outsider("quad in θ", "mpmath", Arithmetic::Mp, asked("mpmath.quad", digits, "digits")),
        outsider("integral", "python-flint", Arithmetic::Certified, asked("arb", digits, "digits")),
    ]
}

/// The question, with every double as the fraction that it is.
fn asked(question: &Question, by: &str, effort: u32) -> Map<String, Value> {
    let exact = |value: &f64| Rational::from_f64(*value).map_or_else(String::new, |value| value.to_string());
    let (profile, parameters) = match &question.profile {
        Kind::Power(n) => ("power", vec![exact(n)]),
        Kind::Shape(shape, parameters) => (shape.name(), parameters.iter().map(exact).collect()),
    };
    question! {
        "ask": "transform", "by": by, "effort": effort, "x": exact(&question.x),
        "profile": profile, "parameters": parameters,
    }
}
