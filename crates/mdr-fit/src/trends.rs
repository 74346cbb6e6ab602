//! Slope and drift of the baseline, as the rows that are farthest from contact tell them.

use nalgebra::{DMatrix, DVector};

use super::judge;
use super::problem::{Kind, Problem};

/// The share of the range of X, from its lowest end, in which a baseline is looked for.
const FAR: f64 = 0.2;

/// The fewest rows of a baseline.
const ROWS: usize = 8;

/// The problem with free trends at their given values or zero, and with those of the rows that are farthest from contact.
pub(super) fn variants(problem: &Problem) -> Vec<Problem> {
    let is_open = |kind: Kind| {
        let parameter = problem.parameters.iter().find(|parameter| parameter.kind == kind);
        parameter.is_some_and(|parameter| parameter.free && parameter.guess().is_none())
    };
    let kinds: Vec<Kind> =
        [Kind::BaselineSlope, Kind::BaselineDrift].into_iter().filter(|kind| is_open(*kind)).collect();
    let found = if kinds.is_empty() { None } else { regression(problem, &kinds) };
    let mut variants = vec![problem.clone()];
    if let Some(found) = found {
        let mut other = problem.clone();
        for (kind, value) in kinds.iter().zip(found) {
            for parameter in other.parameters.iter_mut().filter(|parameter| parameter.kind == *kind) {
                parameter.start = Some(value);
            }
        }
        variants.push(other);
    }
    variants
}

/// Slope and drift by linear regression.
fn regression(problem: &Problem, kinds: &[Kind]) -> Option<Vec<f64>> {
    let rows = &problem.rows;
    let ends = judge::extent(rows.iter().map(|row| row.x));
    let span = ends[1] - ends[0];
    let far: Vec<_> = rows.iter().filter(|row| row.x <= ends[0] + FAR * span).collect();
    if far.len() < ROWS {
        return None;
    }
    let longest = rows.iter().map(|row| row.time.abs()).fold(f64::MIN_POSITIVE, f64::max);
    // In units of the range of X and of the time of the record.
    let units: Vec<f64> = kinds.iter().map(|kind| if *kind == Kind::BaselineSlope { span } else { longest }).collect();
    let matrix = DMatrix::from_fn(far.len(), kinds.len() + 1, |row, column| match column.checked_sub(1) {
        None => 1.0,
        Some(index) if kinds[index] == Kind::BaselineSlope => (far[row].x - ends[0]) / span,
        Some(_) => far[row].time / longest,
    });
    let forces = DVector::from_iterator(far.len(), far.iter().map(|row| row.y));
    let found = judge::least_squares(matrix, &forces, 1e-6)?;
    let values: Vec<f64> = units.iter().enumerate().map(|(index, unit)| found[index + 1] / unit).collect();
    values.iter().all(|value| value.is_finite()).then_some(values)
}
