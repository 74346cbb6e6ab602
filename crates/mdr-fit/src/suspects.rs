//! What a record may have that its problem has not: a slope or a drift, or signs that are reversed.

use std::sync::Arc as Shared;

use super::answer::{Fit, FitStatus};
use super::budget;
use super::drive;
use super::errors::Errors;
use super::limits;
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Leg;
use super::problem::{Kind, Problem};
use super::start::Source;

/// The fall of the sum of squares, in variances, for which a slope or a drift is named: by chance that of one of three in a thousand records.
const FALL: f64 = 13.0;

/// The most rows of a record in which a slope or a drift is looked for, which takes as long as some further evaluations.
const ROWS: usize = 100_000;

/// The most rows of a fit with a sign reversed: of a longer record every so many count.
const TELLING: usize = 10_000;

/// How many times smaller the sum of squares is with a sign reversed before that is named.
const REVERSED: f64 = 4.0;

/// The slope or drift that is not free, by its index, with which the residuals of the linearised model fall most, if by enough.
pub(super) fn trend(objective: &Objective<'_>, errors: &Errors<'_>, minimum: &Minimum, dof: usize) -> Option<usize> {
    let problem = objective.problem;
    let residuals = &minimum.evaluation.residuals;
    let fall = |index: usize| -> Option<f64> {
        let column = budget::column(objective, minimum, index)?;
        let moved = budget::followed(errors, minimum, &column)?;
        let own = &column - minimum.jacobian.select_columns(errors.kept) * moved;
        // What the free numbers follow already shows nothing of it.
        let is_seen = own.norm() > 1e-6 * column.norm();
        is_seen.then(|| (own.dot(residuals) / own.norm()).powi(2))
    };
    let given = |index: &usize| {
        let parameter = &problem.parameters[*index];
        parameter.kind.is_trend() && !parameter.free && parameter.value == Some(0.0)
    };
    if problem.rows.len() > ROWS {
        return None;
    }
    let falls = (0..problem.parameters.len()).filter(given).filter_map(|index| Some((index, fall(index)?)));
    let (index, fall) = falls.max_by(|one, other| one.1.total_cmp(&other.1))?;
    let rest = (minimum.evaluation.cost() - fall).max(0.0) / dof.max(1) as f64;
    (fall > FALL * rest).then_some(index)
}

/// Warns of a slope or a drift with which the rows are fitted much better.
pub(super) fn add_trend(fit: &mut Fit, problem: &Problem, index: usize) {
    let mut other = limits::started(problem, fit);
    let parameter = &mut other.parameters[index];
    (parameter.free, parameter.start) = (true, Some(0.0));
    let (name, kind) = (parameter.name.clone(), parameter.kind);
    let Ok(found) = drive::fit_from(&other, &[Source::Given]).map(|outcome| outcome.fit) else { return };
    let Some((value, stderr)) = found.estimate(&name).and_then(|estimate| estimate.value.zip(estimate.stderr)) else {
        return;
    };
    if limits::fall(fit, &found).is_some_and(|fall| fall > FALL && found.status.has_estimates()) {
        let what = match kind {
            Kind::BaselineSlope => "a baseline that is not level",
            Kind::BaselineDrift => "a baseline that drifts",
            _ => "a position that drifts",
        };
        fit.warnings.push(format!(
            "the record looks like one with {what}: with `{name}` free, {value:.3e} ± {stderr:.1e} {}, the sum of squares falls from {:.4e} to \
             {:.4e}; free it, or give it",
            found.estimate(&name).map_or("", |estimate| estimate.unit),
            fit.rss,
            found.rss
        ));
    }
}

/// Warns of x and y with the wrong sign, where a fit is poor and one with the other signs is not.
pub(super) fn add_signs(fit: &mut Fit, problem: &Problem, misses: bool) {
    if !misses && matches!(fit.status, FitStatus::Fitted) || !problem.observation.has_depth() {
        return;
    }
    let names = [([true, false], "x"), ([false, true], "y"), ([true, true], "x and y")];
    let reversed = names.into_iter().filter_map(|(axes, name)| {
        let found = drive::fit_from(&reversed(problem, axes), &[Source::Formula, Source::Record]).ok()?.fit;
        // As that of all rows would be.
        let share = problem.rows.len() as f64 / found.rows.len().max(1) as f64;
        limits::fall(fit, &found).map(|_| (name, share * found.rss))
    });
    let least = reversed.min_by(|one, other| one.1.total_cmp(&other.1));
    if let Some((name, rss)) = least.filter(|(_, rss)| *rss * REVERSED < fit.rss) {
        fit.warnings.push(format!(
            "with the sign of {name} reversed the sum of squares falls from {:.4e} to {rss:.4e}: pressing in and pressing count positive; \
             reverse it in the data",
            fit.rss
        ));
    }
}

/// The problem with axes reversed, on some of its rows; each leg has the direction of its x.
fn reversed(problem: &Problem, [x, y]: [bool; 2]) -> Problem {
    let mut other = problem.alone();
    let signs = [x, y].map(|is_reversed| if is_reversed { -1.0 } else { 1.0 });
    let rows = Shared::make_mut(&mut other.rows);
    if rows.len() > TELLING {
        *rows = rows.iter().copied().step_by(rows.len().div_ceil(TELLING)).collect();
    }
    rows.iter_mut().for_each(|row| (row.x, row.y) = (signs[0] * row.x, signs[1] * row.y));
    other.turns.iter_mut().for_each(|turn| turn[0] *= signs[0]);
    for leg in rows.chunk_by_mut(|one, other| one.part == other.part) {
        let direction = if leg[leg.len() - 1].x > leg[0].x { Leg::Approach } else { Leg::Retract };
        leg.iter_mut().for_each(|row| row.leg = direction);
    }
    other.parameters.iter_mut().for_each(|parameter| parameter.start = None);
    other
}
