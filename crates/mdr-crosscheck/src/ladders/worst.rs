//! The worst inputs that were ever found, one a function and family: they are asked again on every run.

use serde::{Deserialize, Serialize};
use thiserror::Error as ThisError;

use super::{Found, Ladder, Rung, measure};
use crate::subject::routines;

/// The list. It only grows: `cargo run --release -p mdr-crosscheck --example ladders -- --worst` writes it anew, with its old
/// lines and the inputs that were found to be worse.
const KEPT: &str = include_str!("../../data/worst.jsonl");

/// An input that did worst.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Worst {
    /// The function, as in [`Ladder::function`].
    pub function: String,
    /// The family of the direction in which it was found.
    pub family: String,
    /// The inputs, to the last bit.
    pub inputs: Vec<f64>,
    /// The excess loss when it was found, to two digits.
    pub excess: f64,
}

/// A line that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, ThisError)]
#[error("worst inputs, line {line}: {what}")]
#[non_exhaustive]
pub struct WorstError {
    /// From 1.
    pub line: usize,
    /// The reason.
    pub what: String,
}

/// All that are kept.
///
/// # Errors
/// Where a line is no input.
pub fn worst_inputs() -> Result<Vec<Worst>, WorstError> {
    let read = |(index, line)| {
        serde_json::from_str(line).map_err(|error| WorstError { line: index + 1, what: error.to_string() })
    };
    KEPT.lines().enumerate().map(read).collect()
}

impl Worst {
    /// Evaluates the function at the kept inputs again; `None` if the function no longer exists.
    pub fn ask(&self) -> Option<Rung> {
        let routine = routines().into_iter().find(|routine| routine.name == self.function)?;
        Some(measure::rung(&routine, f64::NAN, &self.inputs))
    }

    /// The worst rung of each function and family that is an error at all, if it is worse than the kept one.
    pub fn found(ladders: &[Ladder], kept: &[Worst]) -> Vec<Worst> {
        let mut all = kept.to_vec();
        for ladder in ladders {
            let Some(rung) = ladder.worst() else { continue };
            let (Found::Number { excess, .. } | Found::Beyond { excess }) = rung.found else { continue };
            let excess = (excess * 100.0).round() / 100.0;
            let family = ladder.family.name().to_owned();
            let before = all.iter().filter(|worst| worst.function == ladder.function && worst.family == family);
            let most = before.map(|worst| worst.excess).fold(f64::NEG_INFINITY, f64::max);
            if excess > most.max(-1.0) {
                all.retain(|worst| kept.contains(worst) || worst.function != ladder.function || worst.family != family);
                all.push(Worst { function: ladder.function.clone(), family, inputs: rung.inputs.clone(), excess });
            }
        }
        all
    }
}
