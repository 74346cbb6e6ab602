//! An output that could not be computed: it says so, and takes no other with it.

use mdr_core::contact::{Control, Error, Status};
use mdr_core::number::Literal;
use mdr_numeric::path::EventKind;

use super::search::not_proved;
use crate::answer::types::PathNumbers;
use crate::answer::{
    Admission, AtValue, CurvePoint, CurveStability, CurveSummary, Field, ForceCurve, List, LoadingPath, Optional,
    Output, PathEvent, Promise, TransformSample, Value,
};
use crate::scene::{Arithmetic, Scene, Want};

/// Whether an error is that of one output, with which no input is wrong.
pub(super) fn is_open(error: &Error) -> bool {
    matches!(
        error,
        Error::NoConvergence { .. } | Error::Undecided { .. } | Error::Unproved { .. } | Error::BudgetSpent { .. }
    )
}

/// The output without numbers, for the reason of an error.
pub(super) fn output(scene: &Scene, want: &Want, error: &Error) -> Output {
    let why = error.to_string();
    let promise = match scene.arithmetic {
        Arithmetic::Certified { .. } => Promise::Estimated,
        Arithmetic::Double => Promise::Double,
    };
    let open = || Value::unknown(Status::Undecided, why.as_str());
    let nothing = || not_proved(&format!("undecided: {why}"));
    match want {
        Want::Transform { at } => {
            let sample = |x: &Literal| TransformSample { x: x.clone(), g: open(), slope: open(), integral: open() };
            Output::Transform(List::new(promise, at.iter().map(sample).collect()))
        }
        Want::Folds { .. } => Output::Folds(List::new(promise, Vec::new()).complete(nothing())),
        Want::Curve { at } => {
            let point = |a: &Literal| CurvePoint {
                contact_radius: a.clone(),
                indentation: open(),
                force: open(),
                stability: CurveStability(Value::unknown(Status::Undecided, why.as_str())),
                admissible: None,
            };
            Output::Curve(List::new(promise, at.iter().map(point).collect()).complete(nothing()))
        }
        Want::Equilibria { .. } => {
            Output::Equilibria(List::new(promise, at_values(scene, want, error)).complete(nothing()))
        }
        Want::Path => {
            let events = vec![event(scene, &open)];
            Output::Path(Box::new(LoadingPath::new(promise, PathNumbers { events, balance: None }, nothing())))
        }
        Want::Pressure { .. } => Output::Field(Field::Pressure, List::new(promise, at_values(scene, want, error))),
        Want::Gap { .. } => Output::Field(Field::Gap, List::new(promise, at_values(scene, want, error))),
        Want::Displacement { .. } => {
            Output::Field(Field::Displacement, List::new(promise, at_values(scene, want, error)))
        }
        Want::Energy { .. } => Output::Energy(List::new(promise, at_values(scene, want, error))),
        Want::ForceCurve { .. } => {
            let [pull_off_force, jump_in_force, minimum_force, hysteresis] = [(); 4].map(|()| Some(open()));
            let summary = CurveSummary { pull_off_force, jump_in_force, minimum_force, hysteresis };
            let samples = List::new(Promise::Double, Vec::new()).complete(nothing());
            Output::ForceCurve(Box::new(ForceCurve { samples, summary }))
        }
    }
}

/// Each value without states; the start of the path where there is no value.
fn at_values<T>(scene: &Scene, want: &Want, error: &Error) -> Vec<AtValue<T>> {
    let start = scene.path.first().into_iter().filter(|_| want.values().is_empty());
    want.values().iter().chain(start).map(|value| AtValue::open(value, error)).collect()
}

/// The one event of a path that could not be followed.
fn event(scene: &Scene, open: &impl Fn() -> Value) -> PathEvent {
    let given = || scene.path.first().cloned().map(Value::Given);
    let is_machine = matches!(scene.control, Control::Machine { .. });
    let held = |is_held: bool| if is_held { given() } else { Some(open()) };
    PathEvent {
        event: EventKind::Undecided,
        position: Optional(given().filter(|_| is_machine)),
        indentation: held(matches!(scene.control, Control::Indentation)),
        force: held(matches!(scene.control, Control::Force)),
        contact_radius: Some(open()),
        to_contact_radius: None,
        to_indentation: None,
        to_force: None,
        admissible: Admission::Unknown { why: "the path could not be followed" },
        dissipated: None,
    }
}
