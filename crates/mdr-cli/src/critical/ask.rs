//! From checked inputs to an answer, in either arithmetic.

use mdr_analytic::certified::{Answer as Certified, Elasticity as ExactElasticity, Question};
use mdr_core::contact::{Body, Control, Instability, Status};
use mdr_core::number::Literal;
use mdr_core::number::certify::{Decimal, Enclosure};

use super::answer::{Answer, Bodies, Entry, Fold, Inputs, State, Threshold};
use super::{Checked, ControlKind, Elasticity};
use crate::error::Result;
use crate::flags::Arithmetic;
use crate::number::Number;

/// Names the keys of the answer and their meaning.
pub(super) const SCHEMA: &str = "mdr.critical/1";

pub(crate) fn ask(checked: &Checked, arithmetic: Arithmetic) -> Result<Answer> {
    match arithmetic {
        Arithmetic::Certified { digits } => certified(checked, digits),
        Arithmetic::Double => super::double::answer(checked),
    }
}

/// The exact question.
pub(super) fn question(checked: &Checked) -> Result<Question> {
    let elasticity = match &checked.elasticity {
        Elasticity::Effective(e_star) => ExactElasticity::Effective(e_star.clone()),
        Elasticity::Bodies(constants) => {
            let [e1, nu1, e2, nu2] = constants.as_ref();
            let body = |e: &Literal, nu: &Literal| Body { youngs_modulus: e.clone(), poissons_ratio: nu.clone() };
            ExactElasticity::Bodies(Box::new([body(e1, nu1), body(e2, nu2)]))
        }
    };
    let control = match (checked.control, &checked.stiffness) {
        (ControlKind::Force, _) => Control::Force,
        (ControlKind::Machine, Some(stiffness)) => Control::Machine { stiffness: stiffness.clone() },
        _ => Control::Indentation,
    };
    Ok(Question::new(&checked.n, &checked.c, &elasticity, &checked.work, &control)?)
}

fn certified(checked: &Checked, digits: u32) -> Result<Answer> {
    let question = question(checked)?;
    let Certified { regime, kappa, critical, folds, threshold, ratio } = question.answer(digits)?;
    let state = critical.map_or_else(State::absent, |critical| {
        State::new([critical.contact_radius, critical.indentation, critical.force].map(entry))
    });
    let e_star = || {
        let exact = question.effective_modulus();
        let decimal = Enclosure::Exact(exact.clone()).round(digits);
        Number::Decimal(decimal.map_or_else(|| exact.to_string(), |decimal| decimal.to_string()))
    };
    Ok(Answer {
        schema: SCHEMA,
        arithmetic: "certified",
        digits: Some(digits),
        control: checked.control.name(),
        regime,
        inputs: checked.inputs(|literal| Number::Decimal(literal.to_string()), e_star),
        kappa: Number::Decimal(kappa.to_string()),
        status: Status::Ok,
        state,
        threshold: match (threshold, ratio) {
            (Some(threshold), Some(ratio)) => Threshold::new(entry(threshold), entry(ratio)),
            _ => Threshold::absent(),
        },
        folds: (checked.control == ControlKind::Machine).then(|| folds.into_iter().map(fold).collect()),
    })
}

fn entry(decimal: Decimal) -> Entry {
    Entry::Value(Number::Decimal(decimal.to_string()))
}

fn fold(fold: Instability<Decimal>) -> Fold {
    let Instability { contact_radius, indentation, force, kind } = fold;
    Fold { state: State::new([contact_radius, indentation, force].map(entry)), kind, status: Status::Ok }
}

impl ControlKind {
    pub(super) fn name(self) -> &'static str {
        match self {
            ControlKind::Indentation => "indentation",
            ControlKind::Force => "force",
            ControlKind::Machine => "machine",
        }
    }
}

impl Checked {
    /// The inputs in the arithmetic of the answer; `derived` is the E* of two bodies.
    pub(super) fn inputs(&self, number: impl Fn(&Literal) -> Number, derived: impl FnOnce() -> Number) -> Inputs {
        let (bodies, e_star) = match &self.elasticity {
            Elasticity::Effective(e_star) => (None, number(e_star)),
            Elasticity::Bodies(constants) => {
                let [e1, nu1, e2, nu2] = constants.as_ref().each_ref().map(&number);
                (Some(Bodies { e1, nu1, e2, nu2 }), derived())
            }
        };
        Inputs {
            n: number(&self.n),
            c: number(&self.c),
            bodies,
            e_star,
            work: number(&self.work),
            stiffness: self.stiffness.as_ref().map(&number),
        }
    }
}
