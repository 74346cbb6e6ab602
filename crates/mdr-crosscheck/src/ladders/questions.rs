//! Functions, and the directions in which they are led.

use mdr_core::contact::{Ranged, Result};
use mdr_core::number::Interval;

use super::measure::{Moved, Truth, condition, judge, truth, ulps};
use super::{Family, Found, Ladder, Rung};
use super::{critical, energy, equilibria, fields, folds, functions, library, transform};
use crate::Level;

/// A function of doubles, with its truth.
#[derive(Clone, Copy)]
pub(super) struct Subject {
    /// Its name, and after a comma which of its numbers.
    pub(super) name: &'static str,
    /// The names of its inputs.
    pub(super) inputs: &'static [&'static str],
    /// What is shipped.
    pub(super) shipped: fn(&[f64]) -> Result<Ranged<f64>>,
    /// The exact result in rigorous intervals.
    pub(super) enclosed: fn(&[Interval]) -> Result<Interval>,
    /// The same with derivatives.
    pub(super) moved: fn(&[Moved]) -> Result<Moved>,
    /// The formula of textbooks.
    pub(super) naive: Option<Naive>,
}

/// The formula of textbooks in doubles.
#[derive(Clone, Copy)]
pub(super) struct Naive {
    pub(super) formula: &'static str,
    pub(super) value: fn(&[f64]) -> f64,
}

/// A subject whose truth is one generic expression.
macro_rules! subject {
    ($name:expr, $inputs:expr, |$x:ident| $shipped:expr, |$y:ident| $exact:expr $(, naive $formula:expr => $naive:expr)?) => {
        $crate::ladders::questions::Subject {
            name: $name,
            inputs: $inputs,
            shipped: |$x: &[f64]| $shipped,
            enclosed: |$y: &[mdr_core::number::Interval]| $exact,
            moved: |$y: &[$crate::ladders::measure::Moved]| $exact,
            naive: $crate::ladders::questions::first(&[
                $($crate::ladders::questions::Naive { formula: $formula, value: $naive })?
            ]),
        }
    };
}
pub(super) use subject;

/// The one there is, or none.
pub(super) fn first(naive: &[Naive]) -> Option<Naive> {
    naive.first().copied()
}

impl Subject {
    /// The name without the number.
    pub(super) fn function(&self) -> String {
        self.name.split(',').next().unwrap_or(self.name).to_owned()
    }

    /// One question.
    pub(super) fn rung(&self, parameter: f64, inputs: &[f64]) -> Rung {
        let inputs = inputs.to_vec();
        let (truth, bits) = match truth(self, &inputs) {
            Ok(known) => known,
            Err(unknown) => {
                let found = Found::Declined(format!("the truth: {unknown}"));
                return Rung { parameter, inputs, condition: None, found, naive_ulp: None };
            }
        };
        let numbers = matches!(&truth, Truth::Number(value) if !value.is_point() || !value.mid().is_zero());
        let condition = if numbers { condition(self, &inputs, bits).ok().filter(|c| c.is_finite()) } else { None };
        let found = match judge((self.shipped)(&inputs), &truth, condition.unwrap_or(1.0)) {
            Found::Flushed if self.name.starts_with("double::") => Found::Wrong("0, which is an underflow".to_owned()),
            found => found,
        };
        let naive_ulp = match (&truth, self.naive) {
            (Truth::Number(exact), Some(naive)) if numbers && in_range(exact) => {
                Some(ulps((naive.value)(&inputs), &exact.mid()))
            }
            _ => None,
        };
        Rung { parameter, inputs, condition, found, naive_ulp }
    }
}

/// Whether a double can hold the result.
fn in_range(exact: &Interval) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&exact.mid().to_f64().abs())
}

/// A direction: its family, in words, its parameter, and where the rungs are.
#[derive(Clone, Debug)]
pub(super) struct Direction {
    pub(super) family: Family,
    pub(super) toward: String,
    pub(super) axis: &'static str,
    pub(super) rungs: Vec<(f64, Vec<f64>)>,
}

impl Direction {
    /// One rung for each parameter.
    pub(super) fn new(
        family: Family,
        toward: impl Into<String>,
        axis: &'static str,
        parameters: impl IntoIterator<Item = f64>,
        inputs: impl Fn(f64) -> Vec<f64>,
    ) -> Self {
        let rungs = parameters.into_iter().map(|t| (t, inputs(t))).collect();
        Direction { family, toward: toward.into(), axis, rungs }
    }
}

/// A function in a direction.
#[derive(Clone)]
pub(super) struct Climb {
    pub(super) subject: Subject,
    pub(super) direction: Direction,
}

impl Climb {
    /// Answers its questions.
    pub(super) fn ladder(&self) -> Ladder {
        let Climb { subject, direction } = self;
        Ladder {
            function: subject.name.to_owned(),
            family: direction.family,
            toward: direction.toward.clone(),
            axis: direction.axis.to_owned(),
            inputs: subject.inputs.iter().map(|name| (*name).to_owned()).collect(),
            naive: subject.naive.map(|naive| naive.formula.to_owned()),
            rungs: direction.rungs.iter().map(|(t, inputs)| subject.rung(*t, inputs)).collect(),
        }
    }
}

/// All functions in all directions.
pub(super) fn all(level: Level) -> Vec<Climb> {
    let parts = [
        functions::climbs(level),
        critical::climbs(level),
        library::climbs(level),
        transform::climbs(level),
        folds::climbs(level),
        equilibria::climbs(level),
        fields::climbs(level),
        energy::climbs(level),
    ];
    parts.into_iter().flatten().collect()
}

/// Every subject in every direction.
pub(super) fn cross(subjects: &[Subject], directions: &[Direction]) -> Vec<Climb> {
    let led = |subject: &Subject| {
        let subject = *subject;
        directions.iter().cloned().map(move |direction| Climb { subject, direction })
    };
    subjects.iter().flat_map(led).collect()
}

/// 2⁻ᵏ for k from `first` to `last`: all of them, or a few.
pub(super) fn halvings(level: Level, first: i32, last: i32) -> Vec<f64> {
    steps(first, last, if level == Level::Quick { 12 } else { 1 }).map(|k| 2_f64.powi(-k)).collect()
}

/// 10ᵏ for k from `first` to `last`, up or down.
pub(super) fn decades(level: Level, first: i32, last: i32) -> Vec<f64> {
    let span = (last - first).abs();
    let step = if level == Level::Quick { (span / 5).max(1) } else { (span / 40).max(1) };
    // As typed: powi is off by many ulp at the ends of the range.
    let power = |k: i32| format!("1e{k}").parse().unwrap_or(f64::NAN);
    steps(0, span, step).map(|k| power(if last > first { first + k } else { first - k })).collect()
}

/// From `first` to `last`, which is always there.
fn steps(first: i32, last: i32, step: i32) -> impl Iterator<Item = i32> {
    let end = ((last - first) % step != 0).then_some(last);
    (first..=last).step_by(step as usize).chain(end)
}
