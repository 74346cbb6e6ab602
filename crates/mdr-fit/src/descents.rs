//! From starts to the least minimum that is found.

use std::sync::Arc as Shared;

use mdr_core::contact::Shape;

use super::arcs::{Arc, Turn};
use super::minimise::{self, End, Minimum, Precision, Reached};
use super::objective::{AtFold, Evaluation, Objective};
use super::parameter::Kind;
use super::problem::DataRow;
use super::start::{self, Source};
use super::warnings::ALIKE;
use mdr::Result;
use mdr::reading::Location;
use mdr::scene::Profile;

/// Scales of X, in its last scale, from which the labels of a bad start find their way.
const CONTINUATION: [f64; 3] = [70.0, 15.0, 4.0];

/// The cosine between residuals and the Jacobian below which a point is stationary.
pub(super) const CONVERGED: f64 = 1e-6;

/// A row is at the fold within this share of the scale of X beyond it; where the iteration does not converge, within that scale.
pub(super) const AT_FOLD: f64 = 1e-2;

/// A minimum with the fold at the last row is looked for where the fold is within so many widths of the noise of it.
const WIDTHS: f64 = 9.0;

/// The drop of Y at a fold, in units of σ, below which no row tells that there is one.
const UNSEEN: f64 = 0.1;

/// The sum of squares over the degrees of freedom below which no search is begun, where the noise is only seen in the data.
const GOOD: f64 = 3.0;

/// How many rows the first descents have.
const FEW: usize = 150;

/// The sum of squares at a hypothesis, against that of a good fit, above which it is not followed.
const HOPELESS: f64 = 50.0;

/// How many evaluations the first descents take for each free number: from a start that may be far off, and from the data.
const PATIENCE: [usize; 2] = [30, 8];

/// The most evaluations of a descent on all rows for each free number, and the most rows in all of these together: a descent on a long record begins
/// near its end, where those on a part of the rows have led. It has no fewer evaluations than they have.
const PATIENCE_OF_ALL: usize = 100;
const ROWS_OF_ALL: usize = 2_000_000;

/// The share of a sum of squares within which two descents on a part of the rows are at one place.
const KNOWN: f64 = 1e-4;

/// How many minima are followed to the end, and how much larger their sum of squares may be: by a share and by a number of variances.
const FOLLOWED: usize = 4;
const NEAR: [f64; 2] = [1.5, 20.0];

/// A minimum on the way, with the sum of squares of all rows there.
#[derive(Clone)]
pub(super) struct Attempt {
    pub(super) start: &'static str,
    pub(super) fitted: Vec<f64>,
    pub(super) cost: f64,
    pub(super) detached: usize,
}

/// The least minimum, and all attempts.
pub(super) struct Found {
    pub(super) minimum: Minimum,
    pub(super) tried: Vec<Attempt>,
}

/// The minimum of least cost that is reached from all starts of these sources.
///
/// # Errors
/// No start, or none at which the objective has a value.
pub(super) fn least(objective: &mut Objective<'_>, sources: &[Source], is_stated: bool) -> Result<Found> {
    let dof = degrees_of_freedom(objective);
    let enough = if is_stated { (dof + (2.0 * dof).sqrt()) * objective.noise.unit.powi(2) } else { GOOD * dof };
    let has_start = objective.problem.parameters.iter().any(|parameter| parameter.start.is_some());
    let mut search = Search { tried: Vec::new(), begun: Vec::new(), passed: Vec::new(), evaluations: 0, failure: None };
    let mut sources = sources.to_vec();
    if matches!(objective.problem.profile, Profile::Shape(Shape::WavyParaboloid { .. }) | Profile::Formula(_)) {
        // A curve of many arcs has its folds searched anew at each step from a poor start: the search, which knows them, goes first.
        sources.sort_by_key(|source| *source == Source::Record);
    }
    for source in sources {
        // A search takes long; what hypotheses on the record find is mostly as good.
        let is_good = search.tried.iter().any(|attempt| attempt.cost < enough);
        if source == Source::Search && is_good {
            continue;
        }
        // What the data say themselves is near enough.
        let scales: &[f64] = if source == Source::Given || has_start { &CONTINUATION } else { &CONTINUATION[2..] };
        for (name, start) in start::candidates(objective, source) {
            // From far above a fit that is good nothing better is reached.
            let good = search.good(enough);
            let is_far = |objective: &mut Objective<'_>, good: f64| {
                !good.is_nan() && few_cost(objective, &start) > HOPELESS * (good + dof)
            };
            if search.begun.contains(&start) || (source == Source::Record && is_far(objective, good)) {
                continue;
            }
            search.descend(objective, name, &start, Some(scales));
            // Of a start that is near, labels are right, and a larger scale of X leads away from them.
            if (source == Source::Given || objective.problem.has_two_works()) && !is_far(objective, search.good(enough))
            {
                search.descend(objective, name, &start, None);
            }
        }
    }
    search.end(objective, is_stated)
}

/// Leaves some of the rows, and returns all.
fn thinned(objective: &mut Objective<'_>) -> Shared<Vec<DataRow>> {
    let all = Shared::clone(&objective.rows);
    objective.rows = Shared::new(all.iter().copied().step_by(all.len().div_ceil(FEW).max(1)).collect());
    all
}

/// The sum of squares of all rows, by some of them.
fn few_cost(objective: &mut Objective<'_>, fitted: &[f64]) -> f64 {
    let all = thinned(objective);
    let share = all.len() as f64 / objective.rows.len().max(1) as f64;
    let cost = objective.evaluate(fitted, None).map_or(f64::INFINITY, |evaluation| evaluation.cost());
    objective.rows = all;
    share * cost
}

struct Search {
    tried: Vec<Attempt>,
    /// The starts from which the scale of X fell.
    begun: Vec<Vec<f64>>,
    /// Where descents were while the scale of X fell: that scale, the sum of squares and the number of detached rows.
    passed: Vec<[f64; 3]>,
    evaluations: usize,
    failure: Option<mdr_core::contact::Error>,
}

impl Search {
    /// The least sum of squares so far, if it is that of a good fit; else NaN.
    fn good(&self, enough: f64) -> f64 {
        self.tried.iter().map(|attempt| attempt.cost).filter(|cost| *cost < enough).fold(f64::NAN, f64::min)
    }

    /// Descends on a part of the rows: the scale of X falls through `scales` to its value, or has it from the beginning. The end is kept
    /// unless it is known.
    fn descend(&mut self, objective: &mut Objective<'_>, start: &'static str, values: &[f64], scales: Option<&[f64]>) {
        if scales.is_some() {
            self.begun.push(values.to_vec());
        }
        match self.reduced(objective, values, scales) {
            Ok(None) => {}
            Ok(Some((fitted, evaluation))) => {
                let (cost, detached) = (evaluation.cost(), evaluation.detached());
                let end = [cost, detached as f64];
                let known = |other: &Attempt| is_same([other.cost, other.detached as f64], end, KNOWN);
                if !self.tried.iter().any(known) {
                    self.tried.push(Attempt { start, fitted, cost, detached });
                }
            }
            Err(error) => self.failure = Some(error),
        }
    }

    /// The end of a descent with the objective of all rows there; `None` where it goes the way of an earlier one.
    fn reduced(
        &mut self,
        objective: &mut Objective<'_>,
        start: &[f64],
        scales: Option<&[f64]>,
    ) -> mdr_core::contact::Result<Option<(Vec<f64>, Evaluation)>> {
        let (scale, all) = (objective.x_scale, thinned(objective));
        let end = self.guided(objective, start, scales);
        objective.x_scale = scale;
        // Folds that have come up on the way are found here.
        let end = end.map(|(fitted, patience)| match self.descended(objective, &fitted, None, 1e-8, 2 * patience) {
            Ok(end) => end.fitted,
            Err(_) => fitted,
        });
        objective.rows = all;
        let Some(fitted) = end else { return Ok(None) };
        let evaluation = objective.evaluate(&fitted, None)?;
        Ok(Some((fitted, evaluation)))
    }

    /// One descent, whose evaluations count.
    fn descended(
        &mut self,
        objective: &Objective<'_>,
        start: &[f64],
        before: Option<&[Vec<Turn>]>,
        tolerance: f64,
        patience: usize,
    ) -> mdr_core::contact::Result<minimise::End> {
        let evaluation = objective.evaluate(start, before)?;
        let end = minimise::descend(objective, start, evaluation, tolerance, patience)?;
        self.evaluations += end.evaluations;
        Ok(end)
    }

    /// Follows a start while the scale of X falls; where it leads, and the patience of a descent from there. `None` where it meets the way of
    /// an earlier one.
    fn guided(
        &mut self,
        objective: &mut Objective<'_>,
        start: &[f64],
        scales: Option<&[f64]>,
    ) -> Option<(Vec<f64>, usize)> {
        let last = objective.x_scale.filter(|scale| *scale > 0.0).unwrap_or(objective.noise.beyond);
        let (scales, end): (&[f64], &[f64]) = scales.map_or((&[], &[]), |scales| (scales, &[1.0]));
        let patience = if scales.len() > 1 { PATIENCE[0] } else { PATIENCE[1] };
        let (mut fitted, mut before) = (start.to_vec(), None::<Vec<Vec<Turn>>>);
        for factor in scales.iter().chain(end) {
            objective.x_scale = Some(factor * last);
            // A step of the continuation that fails leaves its start to the next.
            if let Ok(end) = self.descended(objective, &fitted, before.as_deref(), 1e-5, patience) {
                let [cost, detached] = [end.evaluation.cost(), end.evaluation.detached() as f64];
                let has_passed =
                    |other: &[f64; 3]| other[0] == *factor && is_same([other[1], other[2]], [cost, detached], KNOWN);
                if self.passed.iter().any(has_passed) {
                    return None;
                }
                self.passed.push([*factor, cost, detached]);
                (fitted, before) = (end.fitted, Some(end.evaluation.turns));
            }
        }
        Some((fitted, patience))
    }

    /// All rows, from the best ends on.
    fn end(mut self, objective: &mut Objective<'_>, is_stated: bool) -> Result<Found> {
        self.tried.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        let least = self.tried.first().map_or(f64::INFINITY, |attempt| attempt.cost);
        let mut minima: Vec<Reached> = Vec::new();
        // The ends of free descents that were followed, and where they led.
        let mut known: Vec<([f64; 2], Attempt)> = Vec::new();
        for attempt in self.tried.iter_mut().take(FOLLOWED).filter(|attempt| attempt.cost <= NEAR[0] * least + NEAR[1])
        {
            objective.at_fold.clear();
            let free = match descended(objective, &attempt.fitted, self.evaluations) {
                Ok(free) => free,
                Err(error) => {
                    self.failure = Some(error);
                    continue;
                }
            };
            self.evaluations = free.evaluations;
            let end = [free.evaluation.cost(), free.evaluation.detached() as f64];
            if let Some((_, led)) = known.iter().find(|(other, _)| is_same(*other, end, 1e-8)) {
                *attempt = Attempt { start: attempt.start, ..led.clone() };
                continue;
            }
            match settled(objective, free, &attempt.fitted) {
                Ok(minimum) => {
                    attempt.fitted.clone_from(&minimum.fitted);
                    (attempt.cost, attempt.detached) = (minimum.cost, minimum.detached);
                    known.push((end, attempt.clone()));
                    self.evaluations = minimum.evaluations;
                    minima.push(minimum);
                }
                Err(error) => self.failure = Some(error),
            }
        }
        minima.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        let is_attached = |minimum: &Reached| minimum.detached == 0;
        if let Some(first) = minima.first()
            && (1..=pins(objective)).contains(&first.detached)
            && !minima.iter().any(is_attached)
            && let Ok(attached) = attached(objective, first, self.evaluations)
            && is_attached(&attached)
        {
            self.evaluations = attached.evaluations;
            let (fitted, cost) = (attached.fitted.clone(), attached.cost);
            self.tried.push(Attempt { start: "all-in-contact", fitted, cost, detached: 0 });
            minima.push(attached);
        }
        self.tried.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        // Rows out of contact that the free numbers of the baseline alone take up say nothing of a jump before them.
        if let Some(first) = minima.first()
            && (1..=pins(objective)).contains(&first.detached)
            && let Some(place) = minima.iter().position(is_attached)
            && minima[place].cost - first.cost < ALIKE * variance(objective, least, is_stated)
        {
            let attached = minima.remove(place);
            self.tried.sort_by_key(|attempt| attempt.fitted != attached.fitted);
            minima.insert(0, attached);
        }
        match minima.into_iter().next() {
            Some(minimum) => {
                let minimum = Reached { evaluations: self.evaluations, ..minimum }.followed(objective)?;
                Ok(Found { minimum, tried: self.tried })
            }
            None => Err(no_start(objective, self.failure)),
        }
    }
}

/// Whether two ends, each a sum of squares and a number of detached rows, are one.
fn is_same([cost, detached]: [f64; 2], other: [f64; 2], tolerance: f64) -> bool {
    detached == other[1] && (cost - other[0]).abs() <= tolerance * cost.min(other[0])
}

/// How many free numbers only rows out of contact tell from others: those of the baseline.
fn pins(objective: &Objective<'_>) -> usize {
    let kinds = [Kind::Baseline, Kind::BaselineSlope, Kind::BaselineDrift];
    kinds.into_iter().filter(|kind| objective.problem.is_free(*kind)).count()
}

/// The variance of a residual, in the unit of the sum of squares: as stated, or that of the residuals.
fn variance(objective: &Objective<'_>, least: f64, is_stated: bool) -> f64 {
    if is_stated { objective.noise.unit.powi(2) } else { least / degrees_of_freedom(objective) }
}

fn degrees_of_freedom(objective: &Objective<'_>) -> f64 {
    objective.rows.len().saturating_sub(objective.free.len()).max(1) as f64
}

/// Descends from another start, and takes its end where that is lower; whether it is.
pub(super) fn improve(
    objective: &mut Objective<'_>,
    start: &[f64],
    minimum: &mut Minimum,
    tried: &mut Vec<Attempt>,
) -> bool {
    let known = objective.at_fold.clone();
    let found = lowest_near(objective, start, minimum.evaluations);
    match found.ok().filter(|found| found.evaluation.cost() < minimum.evaluation.cost() * (1.0 - 1e-9)) {
        Some(found) => {
            let (fitted, cost) = (found.fitted.clone(), found.evaluation.cost());
            tried.insert(0, Attempt { start: "beside-another", fitted, cost, detached: found.evaluation.detached() });
            *minimum = found;
            true
        }
        None => {
            objective.at_fold = known;
            false
        }
    }
}

fn lowest_near(objective: &mut Objective<'_>, start: &[f64], evaluations: usize) -> mdr_core::contact::Result<Minimum> {
    objective.at_fold.clear();
    let free = descended(objective, start, evaluations)?;
    settled(objective, free, start)?.followed(objective)
}

/// The least minimum of all rows near a start, from which a descent has led to the free one.
///
/// Where x is exact the fold is at or beyond the last row of its arc, since rows in contact lie on the curve. Beside a fold the curve rises
/// or falls as the root of the distance, so that there may be several minima: one with the fold at the row, where the sum of squares has a
/// kink, and others with the fold beyond it, to which the other rows lead, or at which the curve goes through the row.
fn settled(objective: &mut Objective<'_>, free: Minimum, start: &[f64]) -> mdr_core::contact::Result<Reached> {
    if objective.x_scale.is_some() {
        return Ok(free.into());
    }
    let rows = near_fold(objective, &free)?;
    if rows.is_empty() {
        return Ok(free.into());
    }
    let mut evaluations = free.evaluations;
    let mut ends: Vec<Reached> = Vec::new();
    let is_beyond = free.evaluation.is_beyond();
    let free = Reached::from(free);
    if !is_beyond {
        ends.push(free);
    } else if let Ok(led) = led_by_others(objective, start, &rows, evaluations) {
        evaluations = led.evaluations;
        if !led.evaluation.is_beyond() {
            ends.push(led.into());
        }
    }
    let from = ends.first().map_or(start, |end| &end.fitted).to_vec();
    objective.at_fold.clone_from(&rows);
    if let Ok(held) = descended(objective, &from, evaluations) {
        let moved = beyond(objective, &held);
        let held = Reached::from(held);
        evaluations = held.evaluations;
        if let Ok(released) = moved.and_then(|moved| released(objective, &held, moved, evaluations))
            && !released.evaluation.is_beyond()
        {
            ends.push(released.into());
        }
        ends.push(held);
    }
    objective.at_fold.clear();
    match ends.into_iter().min_by(|one, other| one.cost.total_cmp(&other.cost)) {
        Some(minimum) => Ok(minimum),
        None => descended(objective, start, evaluations).map(Reached::from),
    }
}

fn descended(objective: &Objective<'_>, start: &[f64], evaluations: usize) -> mdr_core::contact::Result<Minimum> {
    let patience = (ROWS_OF_ALL / objective.rows.len().max(1)).clamp(PATIENCE[1], PATIENCE_OF_ALL);
    let end = minimise::descend(objective, start, objective.evaluate(start, None)?, 1e-6, patience)?;
    minimise::polish(objective, &end.fitted, end.evaluation, evaluations + end.evaluations, Precision::Comparable)
}

/// The minimum with all rows in contact beside one at which some of the last are not: that to which the others lead.
fn attached(
    objective: &mut Objective<'_>,
    minimum: &Reached,
    evaluations: usize,
) -> mdr_core::contact::Result<Reached> {
    let labels = minimum.labels(objective)?.into_iter().enumerate();
    let detached: Vec<AtFold> =
        labels.filter(|(_, label)| *label == 0).map(|(row, _)| AtFold { row, level: 0, beyond: 0.0 }).collect();
    objective.at_fold.clear();
    led_by_others(objective, &minimum.fitted, &detached, evaluations).map(Reached::from)
}

/// The minimum to which all rows but these lead, then with them.
fn led_by_others(
    objective: &mut Objective<'_>,
    start: &[f64],
    rows: &[AtFold],
    evaluations: usize,
) -> mdr_core::contact::Result<Minimum> {
    let all = Shared::clone(&objective.rows);
    let kept = |(index, row): (usize, &DataRow)| (!rows.iter().any(|held| held.row == index)).then_some(*row);
    objective.rows = Shared::new(all.iter().enumerate().filter_map(kept).collect());
    let led = objective.evaluate(start, None);
    let led = led.and_then(|evaluation| minimise::descend(objective, start, evaluation, 1e-8, 30));
    objective.rows = all;
    let End { fitted, evaluations: more, .. } = led?;
    descended(objective, &fitted, evaluations + more)
}

/// The folds that are held, moved so far that the curve goes through their rows.
fn beyond(objective: &Objective<'_>, held: &Minimum) -> mdr_core::contact::Result<Vec<AtFold>> {
    let moved = |fold: &AtFold| {
        let residual = held.evaluation.residuals[fold.row] / objective.noise.unit;
        let width = objective.width_of_fold(&held.evaluation, fold)?;
        Ok(AtFold { beyond: width * residual.powi(2).clamp(1.0, 1e3), ..*fold })
    };
    held.at_fold.iter().map(moved).collect()
}

/// The minimum beyond a held one: the folds are moved, then they are free.
fn released(
    objective: &mut Objective<'_>,
    held: &Reached,
    moved: Vec<AtFold>,
    evaluations: usize,
) -> mdr_core::contact::Result<Minimum> {
    objective.at_fold = moved;
    let away = objective.evaluate(&held.fitted, Some(&held.turns));
    let away = away.and_then(|evaluation| minimise::descend(objective, &held.fitted, evaluation, 1e-8, 30));
    objective.at_fold.clear();
    let End { fitted, evaluations: more, .. } = away?;
    descended(objective, &fitted, evaluations + more)
}

/// The last rows of arcs that lie beyond the fold or nearer to it than the noise resolves.
fn near_fold(objective: &Objective<'_>, minimum: &Minimum) -> mdr_core::contact::Result<Vec<AtFold>> {
    let evaluation = &minimum.evaluation;
    let least = objective.noise.beyond * if minimum.gradient < CONVERGED { AT_FOLD } else { 1.0 };
    let mut near = Vec::new();
    let x_of = |row: usize| evaluation.numbers.untrended(&objective.rows[row])[0];
    for (place, sheet) in evaluation.sheets.iter().enumerate() {
        for (index, arc) in sheet.arcs.iter().enumerate() {
            let Some(fold) = Arc::inner_fold(arc) else { continue };
            let level = index as u32 + 1;
            let is_on_arc =
                |row: &usize| evaluation.labels[*row] == level && evaluation.sheet_of(&objective.rows[*row]) == place;
            let on_arc = (0..objective.rows.len()).filter(is_on_arc);
            let last = on_arc.min_by(|one, other| x_of(*one).total_cmp(&x_of(*other)));
            let Some(row) = last else { continue };
            let at_fold = AtFold { row, level, beyond: 0.0 };
            // From where the edge is pinned the contact breaks without a fold, anywhere beyond the last row.
            if sheet.pin.is_some_and(|pin| pin.radius == fold.s) && x_of(row) >= fold.at[0] {
                continue;
            }
            // Without adhesion that is seen there is no jump, and the fold is as good as the first touch.
            let drop = fold.at[1] - evaluation.numbers.baseline;
            let has_depth = objective.problem.observation.has_depth();
            if has_depth && drop.abs() < UNSEEN * objective.scales(&objective.rows[row]).y * objective.noise.unit {
                continue;
            }
            let reach = least.max(WIDTHS * objective.width_of_fold(evaluation, &at_fold)?);
            if x_of(row) - fold.at[0] < reach {
                near.push(at_fold);
            }
        }
    }
    Ok(near)
}

/// Why nothing was found.
fn no_start(objective: &Objective<'_>, failure: Option<mdr_core::contact::Error>) -> mdr::Error {
    match failure {
        Some(error) => objective.problem.place.refuse(format!(
            "no minimum was found from any start: {error} on the way; give a start, bounds, or fewer free numbers"
        )),
        None => {
            let names: Vec<&str> = (0..objective.free.len())
                .map(|place| objective.parameter(place))
                .filter(|parameter| parameter.start.or(parameter.value).is_none())
                .map(|parameter| parameter.name.as_str())
                .collect();
            if names.is_empty() {
                return objective.problem.place.refuse(
                    "the curve has no value at the numbers that are given, and the data suggest no others: check the start, the signs of x \
                     and y (pressing in and pressing are positive) and their units",
                );
            }
            Location::built("fit.start").refuse(format!(
                "no values to begin from were found in the data: give a start for `{}`",
                names.join("`, `")
            ))
        }
    }
}
