//! Limits of a work of adhesion that the rows do not determine: above one that is not told from zero, below one whose edge never recedes.

use mdr_core::contact::Edge;

use super::answer::{Fit, FitEstimate, FitLimit, FitStatus};
use super::drive::{self, Outcome};
use super::judge;
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Leg;
use super::problem::{Kind, Problem};
use super::start::Source;
use mdr::Result;

/// The rise of χ² at an upper limit of 95 %.
const RISE: f64 = 2.705_543_454_095_404;

/// How often the work of adhesion grows tenfold, and the last factor is halved.
const DECADES: usize = 40;
const HALVINGS: usize = 9;

/// The share of the rows of the retraction in contact, and a number of rows, up to which an edge that recedes may be one that does not.
const FEW: (f64, usize) = (0.3, 5);

/// A factor on a work of adhesion after which no row tells that the edge recedes.
const NEVER: f64 = 1e3;

/// The factor by which a lower limit falls until it is one.
const FALLS: f64 = 1.25;

/// From where a fit with a given work of adhesion begins, if not from the last one.
const SOURCES: [Source; 2] = [Source::Formula, Source::Record];

/// Where a work of adhesion that is zero begins, against the other.
const SMALL: f64 = 1e-2;

/// The standard error of a work of adhesion, against it, above which it has an upper limit.
const NEAR_ZERO: f64 = 0.4;

/// The works of adhesion of which no row tells a value: of an edge that recedes nowhere in the data.
pub(super) fn open(objective: &Objective<'_>, minimum: &Minimum) -> Vec<bool> {
    let evaluation = &minimum.evaluation;
    let is_depinned = || {
        objective.rows.iter().zip(&evaluation.feet).any(|(row, foot)| {
            let sheet = &evaluation.sheets[evaluation.sheet_of(row)];
            sheet.direction == Some(Edge::Receding) && foot.as_ref().is_some_and(|foot| !sheet.is_pinned(foot))
        })
    };
    let is_open = |place: usize| objective.kind(place) == Kind::Work(Edge::Receding) && !is_depinned();
    (0..objective.free.len()).map(is_open).collect()
}

/// Adds the limits of the work of adhesion of an edge that is pinned in all rows: it is at least what holds the edge at the last of them,
/// and at most what would hold it at the first row out of contact, unless the jump came early.
///
/// # Errors
/// Errors of the transform.
pub(super) fn of_pinned(fit: &mut Fit, objective: &Objective<'_>, minimum: &Minimum, open: &[bool]) -> Result<()> {
    let Some(place) = open.iter().position(|open| *open) else { return Ok(()) };
    let evaluation = &minimum.evaluation;
    let mut limits: Option<[Option<f64>; 2]> = None;
    for (index, row) in objective.rows.iter().enumerate() {
        let Some(foot) = &evaluation.feet[index] else { continue };
        let sheet = evaluation.sheet_of(row);
        if evaluation.sheets[sheet].direction != Some(Edge::Receding) {
            continue;
        }
        let contact = evaluation.contact(objective.problem.observation, sheet);
        let point = contact.point(&foot.s)?;
        // g − d = Δl holds an edge, and w grows as its square: E* (g − d)²/2πa on a half-space.
        let g = contact.tip.transform.g(&point.a)?;
        let known = contact.elongation(&point.a)?;
        let work = |d: f64| contact.numbers.work * ((g - d).max(0.0) / known).powi(2);
        let next = objective.rows.get(index + 1).filter(|next| next.part == row.part);
        let breaks = next.filter(|_| evaluation.labels[index + 1] == 0);
        let upper = breaks.map(|next| {
            let slope = contact.point(&(point.a * (1.0 + 1e-9))).map_or(1.0, |point| point.tangent[0]);
            let step = evaluation.numbers.untrended(row)[0] - evaluation.numbers.untrended(next)[0];
            work(point.d - step / slope)
        });
        let lower = work(point.d);
        if limits.is_none_or(|[known, _]| known.is_none_or(|known| lower > known)) {
            limits = Some([Some(lower), upper]);
        }
    }
    let Some([lower, upper]) = limits else { return Ok(()) };
    let parameter = objective.parameter(place);
    let estimate = &mut fit.parameters[place];
    (estimate.value, estimate.stderr, estimate.scaled_stderr) = (None, None, None);
    let name = parameter.name.clone();
    let at_least = lower.unwrap_or(0.0);
    let why = match upper {
        None => only_lower(&name, at_least),
        Some(upper) => {
            estimate.value = Some(0.5 * (at_least + upper));
            estimate.stderr = Some((upper - at_least) / 12f64.sqrt());
            estimate.scaled_stderr = estimate.stderr;
            format!(
                "the contact breaks from a pinned edge between two rows: `{name}` is between {at_least:.4e} and {upper:.4e} J/m², or larger if \
                 the jump came early; its standard error is that of a place between the two rows"
            )
        }
    };
    fit.warnings.push(why);
    fit.limits.push(FitLimit { name, lower, upper, level: None, unit: parameter.unit_name() });
    Ok(())
}

fn only_lower(name: &str, at_least: f64) -> String {
    format!(
        "the edge of the contact is pinned in all rows of the retraction, so that there is only a lower limit of `{name}`: {at_least:.4e} \
         J/m²; record until the contact breaks"
    )
}

/// The fit in which the edge of the contact never recedes, where it is nearly as good as one in which it recedes in a few rows: then the
/// rows tell only a lower limit of the work of adhesion, that at which χ² rises by 2.71.
pub(super) fn never_receding(problem: &Problem, outcome: Outcome) -> Outcome {
    let fit = &outcome.fit;
    let is_receding = |parameter: &super::problem::Parameter| parameter.kind == Kind::Work(Edge::Receding);
    let free = problem.parameters.iter().position(|parameter| is_receding(parameter) && parameter.free);
    let Some(index) = free.filter(|index| problem.parameters[*index].prior.is_none()) else { return outcome };
    let name = &problem.parameters[index].name;
    let retracting = fit.rows.iter().filter(|row| row.leg == Leg::Retract && row.label >= 0);
    let (count, receding) =
        retracting.fold((0, 0), |(count, receding), row| (count + 1, receding + usize::from(!row.pinned)));
    let Some(work) = fit.estimate(name).and_then(|estimate| estimate.value) else { return outcome };
    let is_pinned = fit.limits.iter().any(|limit| limit.name == *name);
    if is_pinned || receding == 0 || receding > FEW.1 + (FEW.0 * f64::from(count)) as usize {
        return outcome;
    }
    let mut other = Problem { digits: problem.digits, ..started(problem, fit) };
    other.parameters[index].start = Some(NEVER * work);
    let Ok(mut pinned) = drive::fit_from(&other, &[Source::Given]) else { return outcome };
    let variance = variance(fit);
    let rise = (pinned.fit.rss - fit.rss) / variance;
    let limit = pinned.fit.limits.iter().position(|limit| limit.name == *name);
    let (Some(limit), true) = (limit, rise < RISE && pinned.fit.status.has_estimates()) else { return outcome };
    let Some(geometric) = pinned.fit.limits[limit].lower else { return outcome };
    // Below it the edge recedes in the last rows.
    let target = pinned.fit.rss.min(fit.rss) + RISE * variance;
    let mut other = started(problem, fit);
    (other.parameters[index].free, other.parameters[index].start) = (false, None);
    let mut is_inside = |work: f64| {
        other.parameters[index].value = Some(work);
        drive::fit_from(&other, &[Source::Given]).is_ok_and(|found| found.fit.rss < target)
    };
    let mut inside = geometric.min(work);
    let mut outside = inside / FALLS;
    for _ in 0..DECADES {
        if !is_inside(outside) {
            break;
        }
        (inside, outside) = (outside, outside / FALLS);
    }
    for _ in 0..HALVINGS {
        let middle = (inside * outside).sqrt();
        *if is_inside(middle) { &mut inside } else { &mut outside } = middle;
    }
    let fit = &mut pinned.fit;
    fit.warnings.retain(|warning| *warning != only_lower(name, geometric));
    fit.warnings.push(format!(
        "the rows do not tell whether the edge of the contact recedes in the last of them, with `{name}` = {work:.3e} J/m², or is pinned in all: \
         χ² differs by {:.2}. There is only a lower limit, {inside:.3e} J/m² at 95 %; record until the contact breaks",
        rise.abs()
    ));
    (fit.limits[limit].lower, fit.limits[limit].level) = (Some(inside), Some(0.95));
    fit.tried.extend(outcome.fit.tried.iter().cloned());
    fit.tried[1..].sort_by(|one, other| one.rss.total_cmp(&other.rss));
    pinned
}

/// The variance of a residual in the unit of the sum of squares: of the stated σ, or of the residuals.
pub(super) fn variance(fit: &Fit) -> f64 {
    match (fit.chi2, fit.rss_unit) {
        (Some(_), "1") => 1.0,
        (Some(_), _) => fit.sigma[1].powi(2),
        (None, _) => fit.rss / fit.dof.max(1) as f64,
    }
}

/// The fall of the sum of squares from one fit to another, in variances of the other; `None` if their sums of squares are not
/// comparable or the other determines nothing.
pub(super) fn fall(fit: &Fit, other: &Fit) -> Option<f64> {
    let is_comparable = other.rss_unit == fit.rss_unit && other.status != FitStatus::Unidentifiable;
    is_comparable.then(|| (fit.rss - other.rss) / (other.rss / other.dof.max(1) as f64))
}

/// The fit with a work of adhesion that tends to zero as zero.
pub(super) fn without(problem: &Problem, outcome: Outcome) -> Result<Outcome> {
    let Some(index) = outcome.vanishing.filter(|index| problem.parameters[*index].kind.is_work()) else {
        return Ok(outcome);
    };
    let is_positive = problem.parameters[index].bounds.is_some_and(|[lower, _]| lower > 0.0);
    if is_positive || problem.parameters[index].prior.is_some() {
        return Ok(outcome);
    }
    let mut other = Problem { digits: problem.digits, ..started(problem, &outcome.fit) };
    let parameter = &mut other.parameters[index];
    (parameter.free, parameter.value, parameter.start, parameter.bounds) = (false, Some(0.0), None, None);
    let (name, unit) = (parameter.name.clone(), parameter.unit_name());
    if !other.parameters.iter().any(|parameter| parameter.free) {
        return Ok(outcome);
    }
    let mut zero = without(&other, drive::fit_from(&other, &Source::ALL)?)?;
    if !zero.fit.status.has_estimates() {
        return Ok(outcome);
    }
    // The number has its place among the free ones.
    let place = problem.parameters[..index].iter().filter(|parameter| parameter.free).count();
    let fit = &mut zero.fit;
    let estimate = FitEstimate { name: name.clone(), value: Some(0.0), stderr: None, scaled_stderr: None, unit };
    fit.parameters.insert(place, estimate);
    for (matrix, own) in [(&mut fit.covariance, 0.0), (&mut fit.correlation, 1.0)] {
        matrix.iter_mut().for_each(|row| row.insert(place, 0.0));
        let count = matrix.len() + 1;
        matrix.insert(place, (0..count).map(|column| if column == place { own } else { 0.0 }).collect());
    }
    fit.tried.iter_mut().for_each(|attempt| attempt.estimates.insert(place, 0.0));
    // Ends at which it is not zero stay known.
    let others = outcome.fit.tried.iter().filter(|other| (other.rss - fit.rss).abs() > 1e-4 * fit.rss);
    fit.tried.extend(others.cloned());
    fit.tried[1..].sort_by(|one, other| one.rss.total_cmp(&other.rss));
    fit.warnings.push(format!("the rows are fitted as well without adhesion: `{name}` is zero, with an upper limit"));
    super::warnings::of_minima(fit);
    Ok(zero)
}

/// The problem with starts at the estimates of a fit.
pub(super) fn started(problem: &Problem, fit: &Fit) -> Problem {
    let mut other = problem.alone();
    for parameter in &mut other.parameters {
        let value = fit.estimate(&parameter.name).and_then(|estimate| estimate.value);
        if let Some(value) = value.filter(|value| parameter.free && (*value != 0.0 || parameter.kind.is_offset())) {
            parameter.start = Some(value);
        }
    }
    other
}

/// Adds the upper limit of a work of adhesion that is zero, or hardly told from zero: where χ² rises by 2.71, with all others fitted again.
pub(super) fn of_weak(fit: &mut Fit, problem: &Problem) {
    for index in 0..problem.parameters.len() {
        let parameter = &problem.parameters[index];
        let Some(estimate) = fit.estimate(&parameter.name).filter(|_| parameter.free && parameter.kind.is_work())
        else {
            continue;
        };
        let Some(value) = estimate.value else { continue };
        let is_weak = value == 0.0 || estimate.stderr.is_some_and(|stderr| stderr > NEAR_ZERO * value);
        if !is_weak || !fit.status.has_estimates() || fit.limits.iter().any(|limit| limit.name == parameter.name) {
            continue;
        }
        if let Some(upper) = upper(fit, problem, index, value) {
            let (name, unit) = (parameter.name.clone(), parameter.unit_name());
            fit.warnings.push(format!("`{name}` is below {upper:.3e} {unit} at 95 %"));
            fit.limits.push(FitLimit { name, lower: None, upper: Some(upper), level: Some(0.95), unit });
        }
    }
}

fn upper(fit: &Fit, problem: &Problem, index: usize, value: f64) -> Option<f64> {
    let target = fit.rss + RISE * variance(fit);
    let mut other = started(problem, fit);
    (other.parameters[index].free, other.parameters[index].start, other.parameters[index].prior) = (false, None, None);
    let place = problem.parameters[..index].iter().filter(|parameter| parameter.free).count();
    // Another minimum that these data do not exclude may have more adhesion.
    let alike = fit.tried.iter().filter(|attempt| attempt.rss < target);
    let most = alike.max_by(|one, other| one.estimates[place].total_cmp(&other.estimates[place]));
    let most = most.filter(|attempt| attempt.estimates[place] > value);
    if let Some(attempt) = most {
        let free = problem.parameters.iter().enumerate().filter(|(_, parameter)| parameter.free);
        for ((of, _), estimate) in free.zip(&attempt.estimates).filter(|((of, _), _)| *of != index) {
            other.parameters[of].start = Some(*estimate);
        }
    }
    let value = most.map_or(value, |attempt| attempt.estimates[place]);
    let mut rss = |work: f64| -> Option<f64> {
        other.parameters[index].value = Some(work);
        // One that is zero may grow with this one.
        for parameter in other.parameters.iter_mut().filter(|parameter| parameter.free && parameter.kind.is_work()) {
            parameter.start = parameter.start.filter(|start| *start > 0.0).or(Some(SMALL * work));
        }
        let near = drive::fit_from(&other, &[Source::Given]).ok().filter(|found| found.fit.rss < target);
        let mut afresh = other.clone();
        afresh.parameters.iter_mut().for_each(|parameter| parameter.start = None);
        let found = near.or_else(|| drive::fit_from(&afresh, &SOURCES).ok())?.fit;
        if found.rss < target {
            other = started(&other, &found);
        }
        Some(found.rss)
    };
    // From far below: where E* and the range of X would be those of adhesion that is seen.
    let of_modulus = problem.parameters.iter().find(|parameter| parameter.kind == Kind::EffectiveModulus)?;
    let modulus = fit.estimate(&of_modulus.name).and_then(|estimate| estimate.value).or(of_modulus.value)?;
    let ends = judge::extent(fit.rows.iter().map(|row| row.x));
    let scale = if problem.observation.has_depth() {
        problem.work_of_length(modulus, ends[1] - ends[0])
    } else {
        value.max(1e-6)
    };
    let mut low = if value > 0.0 { value } else { 1e-12 * scale };
    let mut high = None;
    for _ in 0..DECADES {
        let next = low * if value > 0.0 { 3.0 } else { 10.0 };
        if rss(next)? < target {
            low = next;
        } else {
            high = Some(next);
            break;
        }
    }
    let mut high = high?;
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        // What cannot be told is not excluded.
        *if rss(middle).is_none_or(|rss| rss < target) { &mut low } else { &mut high } = middle;
    }
    Some(high)
}
