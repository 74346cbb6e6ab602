//! Rows, arcs, ends of descents and correlations, as an answer has them.

use super::answer::FittedRow;
use super::arcs;
use super::descents;
use super::minimise::Minimum;
use super::objective::Objective;
use mdr::Result;

/// The result of a descent.
pub(super) fn described(objective: &Objective<'_>, attempt: &descents::Attempt, alike: bool) -> super::answer::Attempt {
    let unit = if alike { objective.noise.y_scale } else { 1.0 / objective.noise.unit };
    let estimates = attempt.fitted.iter().enumerate().map(|(place, fitted)| objective.value(place, *fitted));
    super::answer::Attempt {
        start: attempt.start,
        detached: attempt.detached,
        estimates: estimates.collect(),
        rss: (attempt.cost.sqrt() * unit).powi(2),
    }
}

/// Each row beside the curve.
pub(super) fn rows(objective: &Objective<'_>, minimum: &Minimum) -> Result<Vec<FittedRow>> {
    let evaluation = &minimum.evaluation;
    // Labels count from the outermost arc on which a row of its curve lies.
    let mut outermost = vec![0; evaluation.sheets.len()];
    for (row, label) in objective.rows.iter().zip(&evaluation.labels) {
        let outermost = &mut outermost[evaluation.sheet_of(row)];
        *outermost = (*outermost).max(*label);
    }
    let row = |(index, row): (usize, &super::problem::DataRow)| {
        let residual = evaluation.residuals[index] / objective.noise.unit;
        let sheet = evaluation.sheet_of(row);
        let place = evaluation.numbers.untrended(row);
        let trend = [row.x - place[0], row.y - place[1]];
        let (at, contact_radius, label, pinned) = match &evaluation.feet[index] {
            Some(foot) => {
                let point = evaluation.contact(objective.problem.observation, sheet).point(&foot.s)?;
                let label = outermost[sheet] as i32 - evaluation.labels[index] as i32;
                (point.at, Some(point.a), label, evaluation.sheets[sheet].is_pinned(foot))
            }
            None => ([place[0], evaluation.numbers.baseline], None, -1, false),
        };
        let fitted = [at[0] + trend[0], at[1] + trend[1]];
        Ok::<_, mdr::Error>(FittedRow {
            x: row.x,
            y: row.y,
            leg: row.leg,
            label,
            residual,
            fitted,
            contact_radius,
            pinned,
        })
    };
    // So many, and no more.
    let mut rows = Vec::with_capacity(objective.rows.len());
    for pair in objective.rows.iter().enumerate() {
        rows.push(row(pair)?);
    }
    Ok(rows)
}

/// The arcs as points (X, Y, a): of each leg the outermost first.
pub(super) fn drawn(objective: &Objective<'_>, minimum: &Minimum) -> Result<Vec<Vec<[f64; 3]>>> {
    let evaluation = &minimum.evaluation;
    let mut drawn = Vec::new();
    for (index, sheet) in evaluation.sheets.iter().enumerate() {
        let contact = evaluation.contact(objective.problem.observation, index);
        let point = |sample: &arcs::Sample| Ok([sample.at[0], sample.at[1], contact.point(&sample.s)?.a]);
        for arc in sheet.arcs.iter().rev() {
            drawn.push(arc.drawn().map(point).collect::<Result<_>>()?);
        }
    }
    Ok(drawn)
}

pub(super) fn correlation(covariance: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let deviation = |index: usize| covariance[index][index].sqrt();
    let of = |row: usize, column: usize| {
        let scale = deviation(row) * deviation(column);
        if row == column {
            1.0
        } else if scale > 0.0 {
            covariance[row][column] / scale
        } else {
            0.0
        }
    };
    (0..covariance.len()).map(|row| (0..covariance.len()).map(|column| of(row, column)).collect()).collect()
}
