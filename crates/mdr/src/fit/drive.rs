//! From a problem to its answer: starts, continuation, the minimum, and what it says.

use super::answer::{Fit, FitStatus, FittedRow};
use super::arcs;
use super::errors::Errors;
use super::judge::{self, Spectrum};
use super::minimise::{self, Minimum};
use super::objective::Objective;
use super::observation::Loss;
use super::problem::{Kind, Problem};
use super::start::{self, Source};
use crate::error::Result;
use crate::scene::{Location, Profile};

/// Scales of X, in its last scale, from which the labels of a bad start find their way.
const CONTINUATION: [f64; 3] = [70.0, 15.0, 4.0];

/// The cosine between residuals and the Jacobian below which a minimum is one.
const CONVERGED: f64 = 1e-6;

/// A row is at the fold within this share of the scale of X beyond it.
const AT_FOLD: f64 = 1e-2;

/// The sum of squares over the degrees of freedom below which no other start is tried, where the noise is only seen in the data.
const GOOD: f64 = 3.0;

pub(super) fn fit(problem: &Problem) -> Result<Fit> {
    let mut fit = fit_from(problem, &Source::ALL)?;
    super::smoothing::add(&mut fit, problem);
    Ok(fit)
}

/// The fit with the tip as it is given, from starts of these sources.
pub(super) fn fit_from(problem: &Problem, sources: &[Source]) -> Result<Fit> {
    check(problem)?;
    let noise = Noise::of(problem);
    noise.check(problem)?;
    let given = problem.sigma[0].or(problem.rows[0].sigma[0].map(|_| 0.0));
    // Before labels are known a jump may be in the data.
    let first = match given {
        Some(0.0) if problem.rows[0].sigma[0].is_none() => None,
        Some(sigma) => Some(sigma),
        None => Some(noise.beyond),
    };
    let mut objective = Objective::new(problem, first, noise.y, noise.beyond)?;
    let mut minimum = least(&mut objective, sources, noise.stated)?;
    let jumps = minimum.evaluation.labels.iter().any(|label| *label != minimum.evaluation.labels[0]);
    if given.is_none() && !jumps {
        objective.x_scale = None;
        let evaluations = minimum.evaluations;
        let (fitted, more) = minimise::descend(&objective, &minimum.fitted, 1e-14, 100)?;
        minimum = minimise::polish(&objective, &fitted, evaluations + more)?;
    }
    if minimum.evaluation.labels.iter().all(|label| *label == 0) {
        return Err(problem.place.refuse(
            "all rows are out of contact for every E* and w that was tried: nothing of the contact is in the data; \
             check the signs of x and y (pressing in and pressing are positive) and their units",
        ));
    }
    answer(&objective, &noise, &minimum)
}

/// What is not a problem of fitting.
fn check(problem: &Problem) -> Result<()> {
    let refuse = |key: &str, why: String| Err(Location::built(key).refuse(why));
    let free = problem.parameters.iter().filter(|parameter| parameter.free).count();
    if free == 0 {
        return refuse("fit.free", "nothing is free".to_owned());
    }
    let priors = problem.priors();
    if problem.rows.len() + priors <= free {
        let why = format!("{} rows cannot determine {free} numbers and their errors", problem.rows.len());
        return Err(problem.place.refuse(why));
    }
    let missing = problem.parameters.iter().find(|parameter| !parameter.free && parameter.value.is_none());
    if let Some(parameter) = missing {
        let name = &parameter.name;
        let where_to = match parameter.kind {
            Kind::Stiffness => "[control]",
            _ => "[material]",
        };
        return refuse(
            "fit.free",
            format!("`{name}` is neither free nor given: add it to `free`, or give it in {where_to}"),
        );
    }
    let has_sigma = problem.sigma[1].is_some() || problem.rows.iter().all(|row| row.sigma[1].is_some());
    if !has_sigma && (priors > 0 || problem.loss == Loss::Huber) {
        let what = if priors > 0 { "a prior is weighed against the rows" } else { "the loss `huber` counts in σ" };
        return refuse(
            "data.sigma",
            format!("{what}, so it needs the standard deviation of y: sigma = {{ y = \"…\" }}"),
        );
    }
    let of_profile =
        |parameter: &super::problem::Parameter| parameter.free && matches!(parameter.kind, Kind::Profile(_));
    if let Profile::Formula(formula) = &problem.profile
        && !formula.expression.is_smooth()
        && problem.parameters.iter().any(of_profile)
    {
        return refuse(
            "fit.free",
            "a number of a formula with `abs`, `min` or `max` cannot be free: its kinks move".to_owned(),
        );
    }
    Ok(())
}

/// The scatter of the data.
struct Noise {
    y: f64,
    /// Whether σ_Y is stated.
    stated: bool,
    beyond: f64,
    /// As it shows in the second differences of Y.
    seen: f64,
}

impl Noise {
    fn of(problem: &Problem) -> Self {
        let rows = &problem.rows;
        let steps: Vec<f64> =
            rows.windows(2).map(|pair| (pair[1].x - pair[0].x).abs()).filter(|step| *step > 0.0).collect();
        let spacing = judge::median(steps);
        // Of independent errors: their second differences have √6 times their standard deviation.
        let seconds: Vec<f64> = rows
            .windows(3)
            .filter(|three| three[0].leg == three[2].leg)
            .map(|three| (three[0].y - 2.0 * three[1].y + three[2].y).abs())
            .collect();
        let range =
            rows.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], row| [low.min(row.y), high.max(row.y)]);
        let range = range[1] - range[0];
        let seen = judge::median(seconds) / (0.6745 * 6f64.sqrt());
        let own = rows.iter().all(|row| row.sigma[1].is_some());
        let y =
            problem.sigma[1].unwrap_or_else(|| if seen.is_finite() { seen.max(1e-4 * range) } else { 1e-2 * range });
        let stated_x = problem.sigma[0].filter(|sigma| *sigma > 0.0);
        let beyond = stated_x.unwrap_or(spacing / 12f64.sqrt());
        Noise { y, stated: own || problem.sigma[1].is_some(), beyond, seen }
    }

    /// Refuses rows that are nothing but noise.
    fn check(&self, problem: &Problem) -> Result<()> {
        let middle = judge::median(problem.rows.iter().map(|row| row.y).collect());
        let farthest = problem.rows.iter().map(|row| (row.y - middle).abs()).fold(0.0, f64::max);
        if problem.rows.len() > 10 && self.seen.is_finite() && farthest < 6.0 * self.seen {
            return Err(problem.place.refuse(format!(
                "no row differs from the others by more than the noise, {:.2e}: all rows seem to be out of contact",
                self.seen
            )));
        }
        Ok(())
    }
}

/// The minimum of least cost that is found from the starts, until one fits as well as noise lets it: within a standard deviation of χ²
/// where σ is stated, since a second minimum may be little worse.
fn least(objective: &mut Objective<'_>, sources: &[Source], is_stated: bool) -> Result<Minimum> {
    let dof = objective.rows.len().saturating_sub(objective.free.len()).max(1) as f64;
    let enough = if is_stated { dof + (2.0 * dof).sqrt() } else { GOOD * dof };
    let mut best: Option<Minimum> = None;
    let mut failure = None;
    let has_start = objective.problem.parameters.iter().any(|parameter| parameter.start.is_some());
    for &source in sources {
        // What the data say themselves is near enough.
        let scales: &[f64] = if source == Source::Given || has_start { &CONTINUATION } else { &CONTINUATION[2..] };
        for start in start::candidates(objective, source) {
            match from(objective, &start, scales) {
                Ok(minimum) => {
                    if best.as_ref().is_none_or(|best| minimum.evaluation.cost() < best.evaluation.cost()) {
                        best = Some(minimum);
                    }
                }
                Err(error) => failure = Some(error),
            }
            let good = |best: &Minimum| best.evaluation.cost() < enough && best.gradient < CONVERGED;
            if let Some(best) = best.take_if(|best| good(best)) {
                return Ok(best);
            }
        }
    }
    best.ok_or_else(|| match failure {
        Some(error) => objective.problem.place.refuse(format!(
            "no minimum was found from any start: {error} on the way; give a start, bounds, or fewer free numbers"
        )),
        None => {
            let names: Vec<&str> = (0..objective.free.len())
                .map(|place| objective.parameter(place))
                .filter(|parameter| parameter.start.or(parameter.value).is_none())
                .map(|parameter| parameter.name.as_str())
                .collect();
            Location::built("fit.start").refuse(format!(
                "no values to begin from were found in the data: give a start for `{}`",
                names.join("`, `")
            ))
        }
    })
}

/// The minimum that is reached from one start: the scale of X falls through `scales` to its value, on a part of the rows; then all rows.
fn from(objective: &mut Objective<'_>, start: &[f64], scales: &[f64]) -> mdr_core::contact::Result<Minimum> {
    let (scale, all) = (objective.x_scale, objective.rows.clone());
    let last = scale.filter(|scale| *scale > 0.0).unwrap_or(objective.beyond);
    let mut end = (start.to_vec(), 0);
    objective.rows = all.iter().copied().step_by(all.len().div_ceil(150).max(1)).collect();
    for factor in scales {
        objective.x_scale = Some(factor * last);
        // A step of the continuation that fails leaves its start to the next.
        if let Ok((fitted, evaluations)) = minimise::descend(objective, &end.0, 1e-5, 30) {
            end = (fitted, end.1 + evaluations);
        }
    }
    (objective.rows, objective.x_scale) = (all, Some(last));
    if let Ok((fitted, evaluations)) = minimise::descend(objective, &end.0, 1e-8, 100) {
        end = (fitted, end.1 + evaluations);
    }
    if scale != Some(last) {
        objective.x_scale = scale;
        let (fitted, evaluations) = minimise::descend(objective, &end.0, 1e-12, 100)?;
        end = (fitted, end.1 + evaluations);
    }
    minimise::polish(objective, &end.0, end.1)
}

/// The answer at a minimum.
fn answer(objective: &Objective<'_>, noise: &Noise, minimum: &Minimum) -> Result<Fit> {
    let Minimum { fitted, evaluation, jacobian, .. } = minimum;
    let problem = objective.problem;
    let held = minimise::held(objective, fitted, jacobian, evaluation);
    let kept: Vec<usize> = (0..fitted.len()).filter(|place| !held[*place]).collect();
    let information = objective.information(fitted, evaluation)?;
    let spectrum = Spectrum::new(&information.select_columns(&kept));
    let cost = evaluation.cost();
    // Of what the data do not determine nothing is used up.
    let counted = problem.rows.len() + problem.priors() + usize::from(problem.pull_off.is_some());
    let dof = counted.saturating_sub(kept.len() - spectrum.nullity());
    let by_residuals = (cost / dof.max(1) as f64).sqrt();
    let scales = [if noise.stated { 1.0 } else { by_residuals }, by_residuals];
    let errors = Errors { objective, fitted, kept: &kept, spectrum: &spectrum, scales };
    let determined = spectrum.nullity() == 0;
    let converged = minimum.gradient < CONVERGED || is_exact(objective, minimum);
    let status = match (determined, converged) {
        (false, _) => FitStatus::Unidentifiable,
        (true, true) => FitStatus::Fitted,
        (true, false) => FitStatus::NotConverged,
    };
    let (invariants, reason) = match status {
        FitStatus::Fitted => (Vec::new(), String::new()),
        FitStatus::Unidentifiable => errors.invariants(),
        FitStatus::NotConverged => (Vec::new(), not_converged(objective, minimum)),
    };
    let vertical = objective.x_scale.is_none();
    let alike = objective.counts_alike();
    let unit = match problem.observation.units()[1] {
        "N" => "N^2",
        _ => "m^2",
    };
    let rows = rows(objective, minimum)?;
    let chi2 = noise.stated.then_some(cost);
    let residuals: Vec<f64> = rows.iter().map(|row| row.residual).collect();
    let covariance = if status == FitStatus::Fitted { errors.covariance() } else { Vec::new() };
    let mut fit = Fit {
        status,
        reason,
        profile: problem.profile.name(),
        observation: problem.observation,
        parameters: errors.estimates(status),
        correlation: correlation(&covariance),
        covariance,
        invariants,
        singular_values: spectrum.values.clone(),
        rss: if alike { cost * noise.y * noise.y } else { cost },
        rss_unit: if alike { unit } else { "1" },
        dof,
        chi2,
        chi2_p: chi2.and_then(|chi2| judge::chi2_p(chi2, dof)),
        sigma: [objective.x_scale.unwrap_or(0.0), noise.y],
        distance: if vertical { "vertical" } else { "orthogonal" },
        runs_test: judge::runs_test(&residuals),
        rows,
        arcs: evaluation.arcs.iter().rev().map(|arc| drawn(objective, minimum, arc)).collect::<Result<_>>()?,
        predicted_pull_off: None,
        measured_pull_off: None,
        predicted_jump_in: None,
        measured_jump_in: None,
        validity: None,
        warnings: Vec::new(),
        certified: None,
        evaluations: minimum.evaluations,
        intervals: Vec::new(),
        smoothing: Vec::new(),
    };
    super::events::add(&mut fit, &errors, minimum)?;
    if fit.status == FitStatus::Unidentifiable {
        // Where not even the numbers are determined, no contact radius is told.
        fit.rows.iter_mut().for_each(|row| row.contact_radius = None);
    }
    super::warnings::add(&mut fit, objective, minimum, &held, spectrum.smallest());
    if problem.profile_likelihood && fit.status == FitStatus::Fitted {
        super::profile::add(&mut fit, &errors, minimum, noise.stated);
    }
    super::validity::add(&mut fit, problem, &minimum.evaluation.numbers)?;
    match problem.digits.filter(|_| fit.status == FitStatus::Fitted) {
        None => {}
        #[cfg(feature = "mp")]
        Some(digits) => match super::certified::certified(objective, minimum, digits, dof) {
            Ok(certified) => fit.certified = Some(certified),
            Err(why) => fit.warnings.push(why),
        },
        #[cfg(not(feature = "mp"))]
        Some(_) => return Err(crate::Error::NeedsMp { what: "a fit in certified digits" }),
    }
    Ok(fit)
}

/// Why a minimum is none, and what helps.
fn not_converged(objective: &Objective<'_>, minimum: &Minimum) -> String {
    let Minimum { evaluation, gradient, evaluations, .. } = minimum;
    let is_at_fold = |(row, label): (&super::problem::DataRow, &usize)| {
        let end = label.checked_sub(1).and_then(|arc| evaluation.arcs[arc].inner_fold());
        end.is_some_and(|end| (row.x - end.at[0]).abs() < AT_FOLD * objective.beyond)
    };
    if objective.x_scale.is_none() && objective.rows.iter().zip(&evaluation.labels).any(is_at_fold) {
        return "a row lies at the fold, where the curve is vertical: the sum of squares of vertical distances has a kink there and no \
                derivative; give the standard deviation of x: sigma = { x = \"…\" }"
            .to_owned();
    }
    format!(
        "the residuals still fall: the cosine between them and a derivative is {gradient:.1e} after {evaluations} evaluations; give a \
         start, or free fewer numbers"
    )
}

/// Whether the residuals are the rounding of the data: then their direction says nothing.
fn is_exact(objective: &Objective<'_>, minimum: &Minimum) -> bool {
    let largest = objective.rows.iter().map(|row| row.y.abs()).fold(0.0, f64::max);
    let count = objective.rows.len() as f64;
    minimum.evaluation.cost().sqrt() * objective.y_scale <= 1e-11 * largest * count.sqrt()
}

fn correlation(covariance: &[Vec<f64>]) -> Vec<Vec<f64>> {
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

/// Each row beside the curve.
fn rows(objective: &Objective<'_>, minimum: &Minimum) -> Result<Vec<FittedRow>> {
    let evaluation = &minimum.evaluation;
    let contact = evaluation.contact(objective.problem.observation);
    // Labels count from the outermost arc on which a row lies.
    let outermost = evaluation.labels.iter().copied().max().unwrap_or(0) as i32;
    let row = |(index, row): (usize, &super::problem::DataRow)| {
        let residual = evaluation.residuals[index];
        let (fitted, contact_radius, label) = match &evaluation.feet[index] {
            Some(foot) => {
                let point = contact.point(&foot.s)?;
                (point.at, Some(point.a), outermost - evaluation.labels[index] as i32)
            }
            None => ([row.x, evaluation.numbers.baseline], None, -1),
        };
        Ok(FittedRow { x: row.x, y: row.y, leg: row.leg, label, residual, fitted, contact_radius })
    };
    objective.rows.iter().enumerate().map(row).collect()
}

/// An arc as points (X, Y, a).
fn drawn(objective: &Objective<'_>, minimum: &Minimum, arc: &arcs::Arc) -> Result<Vec<[f64; 3]>> {
    let contact = minimum.evaluation.contact(objective.problem.observation);
    let point = |sample: &arcs::Sample| Ok([sample.at[0], sample.at[1], contact.point(&sample.s)?.a]);
    arc.samples.iter().map(point).collect()
}
