//! From a problem to its answer: the scatter of its rows, the least minimum, and its assessment.

use super::answer::{Fit, FitStatus, SkippedRows};
use super::arcs;
use super::descents::{self, AT_FOLD, Attempt, CONVERGED, Found};
use super::errors::Errors;
use super::hysteresis;
use super::judge::{self, Spectrum};
use super::limits;
use super::minimise::{self, Minimum};
use super::objective::{Noise, Objective};
use super::problem::Problem;
use super::refusals::{check, out_of_contact};
use super::reported::{correlation, described, drawn, rows};
use super::start::Source;
use super::suspects;
use mdr::Result;

/// The length of a column of the Jacobian below which a change of the number by its own size is less than a standard deviation of the noise.
const VANISHING: f64 = 1.0;

/// The probability of χ² below which a fit is called poor.
const IMPROBABLE: f64 = 1e-6;

/// The rise of the sum of squares, in variances, one standard error away below which another descent begins there, and how often one does.
const LOWER: f64 = -0.1;
const RESTARTS: usize = 6;

/// A fit, and what is asked further of it.
pub(super) struct Outcome {
    pub(super) fit: Fit,
    /// The number that tends to zero, by its index, where the iteration has not converged for it.
    pub(super) vanishing: Option<usize>,
    /// The slope or drift that is not free, by its index, with which the residuals fall most.
    pub(super) trend: Option<usize>,
    /// The scatter of neighbouring rows.
    seen: f64,
    /// The standard deviation of the residuals in the unit of Y.
    residual: f64,
}

pub(super) fn fit(problem: &Problem) -> Result<Fit> {
    let outcome = limits::never_receding(problem, fit_from(problem, &Source::ALL)?);
    let Outcome { mut fit, seen, residual, trend, .. } = limits::without(problem, outcome)?;
    limits::of_weak(&mut fit, problem);
    let known = fit.warnings.len();
    hysteresis::add(&mut fit, problem, seen);
    if fit.warnings.len() == known || problem.has_two_works() {
        if let Some(index) = trend {
            suspects::add_trend(&mut fit, problem, index);
        }
        let misses = super::warnings::misses(&fit, seen, residual);
        suspects::add_signs(&mut fit, problem, misses);
    }
    super::warnings::of_rows(&mut fit, problem);
    super::smoothing::add(&mut fit, problem);
    let skipped = problem.selection.skipped.iter();
    fit.skipped = skipped.map(|(why, rows)| SkippedRows { why, rows: *rows }).collect();
    if let Some((text, remark)) = &problem.read {
        fit.read = Some(Box::new(text.clone()));
        fit.warnings.extend(remark.clone());
    }
    Ok(fit)
}

/// The objective of a problem, and the scatter of its rows.
fn begun(problem: &Problem) -> Result<(Objective<'_>, Scatter)> {
    check(problem)?;
    let scatter = Scatter::of(problem);
    scatter.check(problem)?;
    let own = problem.rows[0].sigma[0].get().map(|_| 0.0);
    // What is far below the rounding of x is none.
    let stated = problem.sigma[0].map(|sigma| scatter.noise.scaled(sigma));
    let x_scale = stated.filter(|sigma| *sigma > f64::EPSILON * scatter.span).or(own);
    Ok((Objective::new(problem, x_scale, scatter.noise)?, scatter))
}

/// The estimates alone, those that the data determine, and the sum of squares, from starts of these sources.
pub(super) fn estimates(problem: &Problem, sources: &[Source]) -> Result<(Vec<Option<f64>>, f64)> {
    let (mut objective, scatter) = begun(problem)?;
    let minimum = descents::least(&mut objective, sources, scatter.stated)?.minimum;
    let resolved = Resolved::at(&minimum, &objective, &scatter)?;
    let is_determined = resolved.spectrum.nullity() == 0;
    let status = if is_determined { FitStatus::Fitted } else { FitStatus::Unidentifiable };
    let estimates = resolved.errors(&objective, &minimum).estimates(status);
    Ok((estimates.into_iter().map(|estimate| estimate.value).collect(), rss(&objective, &minimum)))
}

/// The sum of squares as it is told: in the unit of Y if all rows count alike, else in units of σ.
fn rss(objective: &Objective<'_>, minimum: &Minimum) -> f64 {
    let cost = minimum.evaluation.cost();
    if objective.counts_alike() {
        cost * objective.noise.y_scale.powi(2)
    } else {
        (cost.sqrt() / objective.noise.unit).powi(2)
    }
}

/// The fit with the tip as it is given, from starts of these sources.
pub(super) fn fit_from(problem: &Problem, sources: &[Source]) -> Result<Outcome> {
    let (mut objective, scatter) = begun(problem)?;
    let Found { mut minimum, mut tried } = descents::least(&mut objective, sources, scatter.stated)?;
    if minimum.evaluation.labels.iter().all(|label| *label == 0) {
        return Err(problem.place.refuse(out_of_contact(problem)));
    }
    let mut found = answer(&objective, &scatter, &minimum, &tried)?;
    for _ in 0..RESTARTS {
        let Some(start) = &found.lower else { break };
        if !descents::improve(&mut objective, start, &mut minimum, &mut tried) {
            break;
        }
        found = answer(&objective, &scatter, &minimum, &tried)?;
    }
    let Answer { mut fit, trend, resolved, .. } = found;
    further(&mut fit, &resolved.errors(&objective, &minimum), &minimum, scatter.stated)?;
    let vanishing = if fit.status == FitStatus::NotConverged { vanishing(&objective, &minimum) } else { None };
    let vanishing = vanishing.map(|place| objective.free[place]);
    let residual = (minimum.evaluation.cost() / fit.dof.max(1) as f64).sqrt() * scatter.noise.y_scale;
    Ok(Outcome { fit, vanishing, trend, seen: scatter.seen, residual })
}

/// The scatter of the data.
struct Scatter {
    noise: Noise,
    /// Whether σ_Y is stated.
    stated: bool,
    /// As it shows in the second differences of Y.
    seen: f64,
    /// The range of X.
    span: f64,
}

impl Scatter {
    fn of(problem: &Problem) -> Self {
        let rows = &problem.rows;
        let steps: Vec<f64> =
            rows.windows(2).map(|pair| (pair[1].x - pair[0].x).abs()).filter(|step| *step > 0.0).collect();
        let spacing = judge::median(steps);
        // Of independent errors: their second differences have √6 times their standard deviation.
        let seconds: Vec<f64> = rows
            .windows(3)
            .filter(|three| three[0].part == three[2].part)
            .map(|three| (three[0].y - 2.0 * three[1].y + three[2].y).abs())
            .collect();
        let range = |of: fn(&super::problem::DataRow) -> f64| {
            let [low, high] = judge::extent(rows.iter().map(of));
            high - low
        };
        let (range, span) = (range(|row| row.y), range(|row| row.x));
        let seen = judge::median(seconds) / (0.6745 * 6f64.sqrt());
        let own = rows.iter().all(|row| row.sigma[1].get().is_some());
        let natural = if seen.is_finite() { seen.max(1e-4 * range) } else { 1e-2 * range };
        // Rows may have their own.
        let stated = match own {
            true => Some(judge::median(rows.iter().filter_map(|row| row.sigma[1].get()).collect())),
            false => problem.sigma[1],
        };
        let (y, unit) = stated.map_or((natural, 1.0), |sigma| (sigma, (sigma / natural).clamp(1e-300, 1e300)));
        let mut noise = Noise { y, y_scale: natural, unit, beyond: spacing / 12f64.sqrt() };
        let stated_x = problem.sigma[0].map(|sigma| noise.scaled(sigma)).filter(|sigma| *sigma > f64::EPSILON * span);
        noise.beyond = stated_x.unwrap_or(noise.beyond);
        Scatter { noise, stated: stated.is_some(), seen, span }
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

/// The answer at a minimum, with what may be better.
struct Answer {
    fit: Fit,
    /// The slope or drift that it seems to lack, by its index.
    trend: Option<usize>,
    /// Fitted values nearby at which the sum of squares is smaller.
    lower: Option<Vec<f64>>,
    resolved: Resolved,
}

/// What the rows tell of the free numbers at a minimum.
struct Resolved {
    /// The numbers that a bound holds.
    held: Vec<bool>,
    /// The numbers of which no row tells a value.
    open: Vec<bool>,
    /// The places of all others.
    kept: Vec<usize>,
    /// Of the information on these.
    spectrum: Spectrum,
    dof: usize,
    /// The factors of standard errors: of the stated σ, and of the residuals.
    scales: [f64; 2],
}

impl Resolved {
    fn at(minimum: &Minimum, objective: &Objective<'_>, scatter: &Scatter) -> Result<Self> {
        let Minimum { fitted, evaluation, jacobian, .. } = minimum;
        let problem = objective.problem;
        let held = minimise::held(objective, fitted, jacobian, evaluation);
        let open = limits::open(objective, minimum);
        let kept: Vec<usize> = (0..fitted.len()).filter(|place| !held[*place] && !open[*place]).collect();
        let all = objective.information(fitted, evaluation)?;
        let spectrum = Spectrum::new(if kept.len() < fitted.len() { all.select_columns(&kept) } else { all });
        // Of what the data do not determine nothing is used up.
        let counted = problem.rows.len() + problem.priors() + usize::from(problem.pull_off.is_some());
        let dof = counted.saturating_sub(kept.len() - spectrum.nullity());
        let by_residuals = (evaluation.cost() / dof.max(1) as f64).sqrt();
        let scales = [if scatter.stated { objective.noise.unit } else { by_residuals }, by_residuals];
        Ok(Resolved { held, open, kept, spectrum, dof, scales })
    }

    fn errors<'a>(&'a self, objective: &'a Objective<'a>, minimum: &'a Minimum) -> Errors<'a> {
        let Resolved { kept, spectrum, scales, .. } = self;
        Errors { objective, fitted: &minimum.fitted, kept, spectrum, scales: *scales }
    }
}

/// The answer at a minimum.
fn answer(objective: &Objective<'_>, scatter: &Scatter, minimum: &Minimum, tried: &[Attempt]) -> Result<Answer> {
    let problem = objective.problem;
    let evaluation = &minimum.evaluation;
    let resolved = Resolved::at(minimum, objective, scatter)?;
    let errors = resolved.errors(objective, minimum);
    let Resolved { spectrum, dof, scales, .. } = &resolved;
    let (dof, [_, by_residuals]) = (*dof, *scales);
    let cost = evaluation.cost();
    let determined = spectrum.nullity() == 0;
    let converged = minimum.gradient < CONVERGED || is_exact(objective, minimum);
    let in_sigma = (cost.sqrt() / objective.noise.unit).powi(2);
    let chi2 = scatter.stated.then_some(in_sigma);
    let chi2_p = chi2.and_then(|chi2| judge::chi2_p(chi2, dof));
    let status = match (determined, converged) {
        (false, _) => FitStatus::Unidentifiable,
        (true, true) if chi2_p.is_some_and(|p| p < IMPROBABLE) => FitStatus::PoorFit,
        (true, true) => FitStatus::Fitted,
        (true, false) => FitStatus::NotConverged,
    };
    let (invariants, reason) = match status {
        FitStatus::Fitted => (Vec::new(), String::new()),
        FitStatus::PoorFit => (Vec::new(), poor_fit(in_sigma, dof, chi2_p.unwrap_or(0.0))),
        FitStatus::Unidentifiable => errors.invariants(),
        FitStatus::NotConverged => (Vec::new(), not_converged(objective, minimum)),
    };
    let vertical = objective.x_scale.is_none();
    let alike = objective.counts_alike();
    let unit = match problem.units()[1] {
        "N" => "N^2",
        "m" => "m^2",
        _ => "N^2/m^2",
    };
    // What evaluates the objective again comes before the rows of the answer: of a long record each of these counts.
    let steps = if determined { errors.steps(evaluation) } else { Vec::new() };
    let budget = if status.has_estimates() { super::budget::of(&errors, minimum) } else { Vec::new() };
    let trend = if status.has_estimates() { suspects::trend(objective, &errors, minimum, dof) } else { None };
    let rows = rows(objective, minimum)?;
    let residuals: Vec<f64> = rows.iter().map(|row| row.residual).collect();
    let of_legs = hysteresis::of_legs(objective, &residuals);
    let covariance = if status.has_estimates() { errors.covariance(scales[0]) } else { Vec::new() };
    let mut fit = Fit {
        status,
        reason,
        profile: problem.profile.name(),
        medium: (!problem.medium.is_half_space()).then(|| problem.medium.name()),
        observation: problem.observation,
        units: problem.units(),
        parameters: errors.estimates(status),
        // Without a factor of σ, which may be so small or large that products leave the range of doubles.
        correlation: if status.has_estimates() { correlation(&errors.covariance(1.0)) } else { Vec::new() },
        covariance,
        invariants,
        singular_values: spectrum.values.clone(),
        rss: rss(objective, minimum),
        rss_unit: if alike { unit } else { "1" },
        dof,
        chi2: chi2.filter(|chi2| chi2.is_finite()),
        chi2_p,
        sigma: [objective.x_scale.and(problem.sigma[0]).unwrap_or(0.0), objective.noise.y],
        distance: if vertical { "vertical" } else { "orthogonal" },
        runs_test: judge::runs_test(&residuals),
        autocorrelation: judge::autocorrelation(&of_legs, dof),
        rows,
        arcs: drawn(objective, minimum)?,
        predicted_pull_off: None,
        measured_pull_off: None,
        pull_off_between: None,
        predicted_jump_in: None,
        measured_jump_in: None,
        jump_in_between: None,
        validity: None,
        warnings: Vec::new(),
        certified: None,
        read: None,
        evaluations: minimum.evaluations,
        tried: tried.iter().map(|attempt| described(objective, attempt, alike)).collect(),
        intervals: Vec::new(),
        smoothing: Vec::new(),
        legs: Vec::new(),
        quantities: Vec::new(),
        budget,
        limits: Vec::new(),
        skipped: Vec::new(),
    };
    super::events::add(&mut fit, &errors, minimum)?;
    hysteresis::legs(&mut fit, objective);
    if fit.status == FitStatus::Unidentifiable {
        // Where not even the numbers are determined, no contact radius is told.
        fit.rows.iter_mut().for_each(|row| row.contact_radius = None);
    }
    super::warnings::add(&mut fit, objective, minimum, &resolved.held, spectrum.smallest());
    if fit.status.has_estimates() {
        super::quantities::add(&mut fit, &errors, minimum)?;
    }
    limits::of_pinned(&mut fit, objective, minimum, &resolved.open)?;
    super::warnings::of_minima(&mut fit);
    super::warnings::of_scatter(&mut fit, scatter.seen, by_residuals * objective.noise.y_scale);
    super::steepness::add(&mut fit, objective, minimum)?;
    let lowest = steps.iter().min_by(|one, other| one.rise.total_cmp(&other.rise));
    let lower = lowest.filter(|step| step.rise < LOWER).map(|step| step.fitted.clone());
    super::warnings::of_steps(&mut fit, objective, &steps);
    Ok(Answer { fit, trend, lower, resolved })
}

/// Adds what is asked of the last answer alone: intervals of the profile likelihood, the range of validity, certified digits.
fn further(fit: &mut Fit, errors: &Errors<'_>, minimum: &Minimum, stated: bool) -> Result<()> {
    let objective = errors.objective;
    let problem = objective.problem;
    if problem.profile_likelihood && fit.status.has_estimates() {
        super::profile::add(fit, errors, minimum, stated);
    }
    super::validity::add(fit, problem, &minimum.evaluation.numbers)?;
    match problem.digits.filter(|_| fit.status.has_estimates()) {
        None => {}
        #[cfg(feature = "mp")]
        Some(digits) => match super::certified::certified(objective, minimum, digits, fit.dof) {
            Ok(certified) => fit.certified = Some(certified),
            Err(why) => fit.warnings.push(why),
        },
        #[cfg(not(feature = "mp"))]
        Some(_) => return Err(mdr::Error::NeedsMp { what: "a fit in certified digits" }),
    }
    Ok(())
}

/// Why estimates are not to be trusted.
fn poor_fit(chi2: f64, dof: usize, p: f64) -> String {
    let size = if chi2.is_finite() { format!("{chi2:.5e}") } else { "beyond the range of a double".to_owned() };
    format!(
        "χ² is {size} for {dof} degrees of freedom (p = {p:.1e}): the stated σ is too small, or neither this tip nor the theory describes \
         these rows; the numbers are those of the least sum of squares that was found"
    )
}

/// The reason why an end is no stationary point, and a remedy.
fn not_converged(objective: &Objective<'_>, minimum: &Minimum) -> String {
    let Minimum { evaluation, gradient, evaluations, .. } = minimum;
    let is_at_fold = |(row, label): (&super::problem::DataRow, &u32)| {
        let end = evaluation.arc(row, *label).and_then(arcs::Arc::inner_fold);
        end.is_some_and(|end| {
            (evaluation.numbers.untrended(row)[0] - end.at[0]).abs() < AT_FOLD * objective.noise.beyond
        })
    };
    if objective.x_scale.is_none() && objective.rows.iter().zip(&evaluation.labels).any(is_at_fold) {
        return "a row lies at the fold, where the curve is vertical: the sum of squares of vertical distances has a kink there and no \
                derivative; give the standard deviation of x: sigma = { x = \"…\" }"
            .to_owned();
    }
    if let Some(place) = vanishing(objective, minimum) {
        let name = &objective.parameter(place).name;
        return format!(
            "`{name}` tends to zero, {:.1e} {}: the rows are fitted as well without it; give it as a small fixed number, or a lower bound",
            objective.value(place, minimum.fitted[place]),
            objective.parameter(place).unit_name()
        );
    }
    format!(
        "the residuals still fall: the cosine between them and a derivative is {gradient:.1e} after {evaluations} evaluations; give a \
         start, or free fewer numbers"
    )
}

/// A logarithm that runs away: its column of the Jacobian is as good as zero beside the others.
fn vanishing(objective: &Objective<'_>, minimum: &Minimum) -> Option<usize> {
    let lengths: Vec<f64> = minimum.jacobian.column_iter().map(|column| column.norm()).collect();
    let open = limits::open(objective, minimum);
    (0..lengths.len()).find(|place| !objective.is_offset(*place) && !open[*place] && lengths[*place] < VANISHING)
}

/// Whether the residuals are the rounding of the data: then their direction says nothing.
fn is_exact(objective: &Objective<'_>, minimum: &Minimum) -> bool {
    let largest = objective.rows.iter().map(|row| row.y.abs()).fold(0.0, f64::max);
    let count = objective.rows.len() as f64;
    minimum.evaluation.cost().sqrt() * objective.noise.y_scale <= 1e-11 * largest * count.sqrt()
}
