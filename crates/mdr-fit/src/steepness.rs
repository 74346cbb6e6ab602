//! Residuals that grow with the slope of the curve, as errors of an x that is taken for exact do.

use super::answer::{Fit, FitStatus};
use super::minimise::Minimum;
use super::objective::Objective;
use mdr::Result;

/// The score of T. S. Breusch and A. R. Pagan, Econometrica 47 (1979) 1287, above which there is a warning: χ² with one degree of
/// freedom exceeds it with the probability 0.0005, half of it with growing residuals.
const SCORE: f64 = 12.1;

/// The fewest rows of which it is said.
const FEWEST: usize = 30;

/// The share of the rows that are the steepest, beside folds, and count as the next.
const STEEPEST: f64 = 0.05;

/// The probability of the runs of the residuals below which it is the curve that misses.
const CURVE: f64 = 0.01;

/// Warns of residuals of an exact x that grow with the slope of the curve: a row with an error of x is off by the slope times it.
///
/// # Errors
/// Errors of the transform.
pub(super) fn add(fit: &mut Fit, objective: &Objective<'_>, minimum: &Minimum) -> Result<()> {
    let own = objective.rows.iter().any(|row| row.sigma[1].get().is_some());
    let misses = fit.runs_test.is_some_and(|test| test.z < 0.0 && test.p < CURVE);
    if objective.x_scale.is_some() || own || misses || !matches!(fit.status, FitStatus::Fitted | FitStatus::PoorFit) {
        return Ok(());
    }
    let evaluation = &minimum.evaluation;
    let mut squares = Vec::with_capacity(objective.rows.len());
    for (index, row) in objective.rows.iter().enumerate() {
        let Some(foot) = &evaluation.feet[index] else {
            squares.push([0.0, evaluation.residuals[index].powi(2)]);
            continue;
        };
        if foot.is_end {
            continue;
        }
        let contact = evaluation.contact(objective.problem.observation, evaluation.sheet_of(row));
        let [x, y] = contact.point(&foot.s)?.tangent;
        squares.push([(y / x).powi(2), evaluation.residuals[index].powi(2)]);
    }
    let Some(variance) = growth(&mut squares) else { return Ok(()) };
    let [unit, _] = fit.units;
    fit.warnings.push(format!(
        "the residuals grow with the slope of the curve: x, which is taken for exact, seems to have an error of about {:.1e} {unit}, and the \
         estimates may be off by many standard errors; state it: sigma = {{ x = \"…\" }}",
        variance.sqrt() * objective.noise.y_scale
    ));
    Ok(())
}

/// The variance per squared slope, from squared slopes and squared residuals, if it is not by chance.
fn growth(squares: &mut [[f64; 2]]) -> Option<f64> {
    if squares.len() < FEWEST {
        return None;
    }
    squares.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let count = squares.len() as f64;
    let cap = squares[((1.0 - STEEPEST) * count) as usize][0];
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| squares.iter().map(of).sum::<f64>() / count;
    let (slope, power) = (mean(&|pair| pair[0].min(cap)), mean(&|pair| pair[1]));
    let spread = count * mean(&|pair| (pair[0].min(cap) - slope).powi(2));
    let common = count * mean(&|pair| (pair[0].min(cap) - slope) * (pair[1] / power - 1.0));
    let score = common * common / (2.0 * spread);
    (common > 0.0 && score > SCORE).then_some(power * common / spread)
}
