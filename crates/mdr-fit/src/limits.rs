//! Limits of a work of adhesion that the rows do not determine: above one that is not told from zero, below one whose edge never recedes.

use mdr_core::contact::Edge;

use super::answer::{Fit, FitEstimate, FitLimit};
use super::drive::{self, Outcome};
use super::judge;
use super::minimise::Minimum;
use super::objective::Objective;
use super::problem::{Kind, Problem};
use super::start::Source;
use mdr::Result;

/// The rise of χ² at an upper limit of 95 %.
const RISE: f64 = 2.705_543_454_095_404;

/// How often the work of adhesion grows tenfold, and the last factor is halved.
const DECADES: usize = 40;
const HALVINGS: usize = 9;

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
        let next = objective.rows.get(index + 1).filter(|next| next.at.part == row.at.part);
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
        None => format!(
            "the edge of the contact is pinned in all rows of the retraction, so that there is only a lower limit of `{name}`: {at_least:.4e} \
             J/m²; record until the contact breaks"
        ),
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

/// The fit with a work of adhesion that tends to zero as zero.
pub(super) fn without(problem: &Problem, outcome: Outcome) -> Result<Outcome> {
    let Some(index) = outcome.vanishing.filter(|index| problem.parameters[*index].kind.is_work()) else {
        return Ok(outcome);
    };
    let is_positive = problem.parameters[index].bounds.is_some_and(|[lower, _]| lower > 0.0);
    if is_positive || problem.parameters[index].prior.is_some() {
        return Ok(outcome);
    }
    let mut other = started(problem, &outcome.fit);
    let parameter = &mut other.parameters[index];
    (parameter.free, parameter.value, parameter.start, parameter.bounds) = (false, Some(0.0), None, None);
    let (name, unit) = (parameter.name.clone(), parameter.unit_name());
    if !other.parameters.iter().any(|parameter| parameter.free) {
        return Ok(outcome);
    }
    let mut zero = drive::fit_from(&other, &Source::ALL)?;
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
    fit.warnings.push(format!("the rows are fitted as well without adhesion: `{name}` is zero, with an upper limit"));
    Ok(zero)
}

/// The problem with starts at the estimates of a fit.
fn started(problem: &Problem, fit: &Fit) -> Problem {
    let mut other = Problem { digits: None, profile_likelihood: false, range_of_adhesion: None, ..problem.clone() };
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
    let variance = match (fit.chi2, fit.rss_unit) {
        (Some(_), "1") => 1.0,
        (Some(_), _) => fit.sigma[1].powi(2),
        (None, _) => fit.rss / fit.dof.max(1) as f64,
    };
    let target = fit.rss + RISE * variance;
    let mut other = started(problem, fit);
    (other.parameters[index].free, other.parameters[index].start, other.parameters[index].prior) = (false, None, None);
    let mut rss = |work: f64| -> Option<f64> {
        other.parameters[index].value = Some(work);
        let found = drive::fit_from(&other, &[Source::Given]).ok()?.fit;
        let rss = found.rss;
        other = started(&other, &found);
        Some(rss)
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
        match rss(next) {
            Some(rss) if rss < target => low = next,
            _ => {
                high = Some(next);
                break;
            }
        }
    }
    let mut high = high?;
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        match rss(middle) {
            Some(rss) if rss < target => low = middle,
            _ => high = middle,
        }
    }
    Some(high)
}
