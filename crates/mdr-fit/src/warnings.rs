//! Warnings of results that may mislead, in a fit that has ended well.

use mdr_core::contact::Shape;

use super::answer::{Attempt, Autocorrelation, Fit, FitStatus};
use super::errors::Step;
use super::judge;
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Observation;
use super::problem::{Kind, Problem};
use mdr::scene::Profile;

/// A singular value below this share of the largest leaves a direction nearly open.
const NEARLY_OPEN: f64 = 1e-3;

/// The standard error of a positive number, against it, above which zero is not excluded.
const NEAR_ZERO: f64 = 0.4;

/// The difference of χ² up to which the data do not distinguish two minima.
pub(super) const ALIKE: f64 = 9.0;

/// The probability of each of two statistics of the order of residuals below which there is a warning.
const UNLIKELY: f64 = 0.005;

/// The rise of the sum of squares, in variances, one standard error away above which the standard error is rough.
const STEEP: f64 = 16.0;

/// The fewest rows out of contact that make a tail.
const TAIL: usize = 3;

/// The deviation of the residuals over the scatter of neighbouring rows above which there is a warning.
const LARGER: f64 = 2.0;

/// Adds the warnings.
pub(super) fn add(fit: &mut Fit, objective: &Objective<'_>, minimum: &Minimum, held: &[bool], smallest: f64) {
    let problem = objective.problem;
    let mut warnings = Vec::new();
    for place in (0..held.len()).filter(|place| held[*place]) {
        let name = &objective.parameter(place).name;
        warnings.push(format!("`{name}` is at its bound and has no standard error"));
    }
    if fit.status != FitStatus::Unidentifiable && smallest < NEARLY_OPEN {
        warnings.push(format!(
            "the data hardly determine all free numbers: the smallest singular value is {smallest:.1e} of the largest; standard \
             errors are those of the linearised model"
        ));
    }
    for (place, estimate) in fit.parameters.iter().enumerate() {
        let share = estimate.stderr.zip(estimate.value).map(|(stderr, value)| stderr / value.abs());
        if let Some(share) = share.filter(|share| !objective.is_offset(place) && *share > NEAR_ZERO) {
            warnings.push(format!(
                "the data hardly tell `{}` from zero: its standard error, of the linearised model, is {share:.1} times its value; see \
                 --profile-likelihood",
                estimate.name
            ));
        }
    }
    let detached = fit.rows.iter().filter(|row| row.label < 0).count();
    if (1..TAIL).contains(&detached) && problem.is_free(Kind::Baseline) {
        warnings.push(format!(
            "the baseline is free, and rests on {detached} {} out of contact: if the record ends in contact, all numbers are others; record the \
             tail after pull-off",
            if detached == 1 { "row" } else { "rows" }
        ));
    }
    let sees_jump =
        detached > 0 || problem.observation.sees_radius() || problem.observation == Observation::IndentationOfForce;
    if !sees_jump && problem.is_free(Kind::Baseline) {
        warnings.push("the baseline is free, and no detached row pins it: record the tail after pull-off".to_owned());
    } else if !sees_jump {
        warnings.push("the jump out of contact is not in the data: the pull-off is an extrapolation".to_owned());
    }
    let widest = fit.rows.iter().filter_map(|row| row.contact_radius).fold(0.0, f64::max);
    let numbers = &minimum.evaluation.numbers;
    let cycles = fit.legs.iter().filter(|leg| leg.leg == super::observation::Leg::Retract).count();
    if cycles > 1 {
        warnings.push(format!("the record has {cycles} cycles; all of them are fitted by one set of numbers"));
    }
    if let Some(stiffness) = numbers.stiffness {
        let ratio = minimum.evaluation.contact(problem.observation, 0).stiffness(&widest).unwrap_or(0.0) / stiffness;
        if ratio > 10.0 {
            warnings.push(format!(
                "the contact is {ratio:.0} times stiffer than the machine, {}, so that the curve shows the machine rather than \
                 the contact: errors of the stiffness weigh heavily",
                if problem.medium.is_half_space() { "2E*a/k" } else { "S/k" }
            ));
        }
    }
    if let Profile::Shape(Shape::Paraboloid { .. } | Shape::Sphere { .. } | Shape::WavyParaboloid { .. }) =
        problem.profile
        && let Some(radius) = numbers.profile.first()
        && widest > 0.3 * radius
    {
        warnings.push(format!("the contact is not small: a/R reaches {:.2}", widest / radius));
    }
    warnings.extend(of_order(fit));
    if let (Some(chi2), Some(p)) = (fit.chi2, fit.chi2_p)
        && !(1e-3..=1.0 - 1e-3).contains(&p)
    {
        let verdict =
            if p < 0.5 { "larger than the stated σ explains" } else { "smaller than the stated σ explains" };
        warnings.push(format!("χ² = {chi2:.4} for {} degrees of freedom is {verdict} (p = {p:.1e})", fit.dof));
    }
    if objective.at_fold.iter().any(|held| !objective.is_bracketed(&minimum.evaluation, held)) {
        warnings.push(
            "the fold of the curve is held at the last row, and no row lies beyond it: the contact may break anywhere beyond, so that w may be \
             many standard errors larger; record until it breaks, or give the baseline or the contact point"
                .to_owned(),
        );
    } else if !objective.at_fold.is_empty() {
        warnings.push(
            "the fold of the curve is held at the last row in contact, since x is exact there: errors of w and of the contact point are \
             rough; where x has noise, state it: sigma = { x = \"…\" }"
                .to_owned(),
        );
    }
    fit.warnings = warnings;
}

/// So many rows in a row with the largest or the smallest Y are a detector at its end.
const SATURATED: usize = 5;

/// Warns of rows at which the detector seems to be at its end.
pub(super) fn of_rows(fit: &mut Fit, problem: &Problem) {
    for end in judge::extent(problem.rows.iter().map(|row| row.y)) {
        let longest =
            problem.rows.chunk_by(|one, other| one.y == other.y).filter(|run| run[0].y == end).map(<[_]>::len).max();
        if let Some(count) = longest.filter(|count| *count >= SATURATED) {
            fit.warnings.push(format!(
                "{count} rows one after the other have y = {end:.4e} {}, the most extreme of all: a detector at its end? leave them out by \
                 saturation = [lowest, highest]",
                problem.units()[1]
            ));
        }
    }
}

/// A warning of residuals in an order that white noise has in one of a hundred records: too few runs of equal sign, or neighbours that are
/// alike. Its factor is that by which standard errors grow; they are stated without it.
fn of_order(fit: &Fit) -> Option<String> {
    let runs = fit.runs_test.filter(|test| test.z < 0.0 && test.p < UNLIKELY);
    let alike = fit.autocorrelation.filter(|correlation| correlation.p < UNLIKELY);
    if runs.is_none() && alike.is_none() {
        return None;
    }
    let of_runs = fit.runs_test.map(|test| {
        format!("{} runs of equal sign where {:.0} are expected (p = {:.1e})", test.runs, test.expected, test.p)
    });
    let of_neighbours = fit.autocorrelation.map(|Autocorrelation { lag_one, p, widening, .. }| {
        format!(
            "neighbours are correlated by {lag_one:.2} (p = {p:.1e}): where that is noise and not the curve, the standard errors are {widening:.1} \
             times as large as stated"
        )
    });
    let found: Vec<String> = [of_runs, of_neighbours].into_iter().flatten().collect();
    Some(format!("the residuals are not random: {}", found.join("; ")))
}

/// Warns of standard errors that the curve is not linear enough for. Where a fold is held, errors are known to be rough.
pub(super) fn of_steps(fit: &mut Fit, objective: &Objective<'_>, steps: &[Step]) {
    let steepest = steps.iter().max_by(|one, other| one.rise.total_cmp(&other.rise));
    let Some(step) = steepest.filter(|step| step.rise > STEEP && objective.at_fold.is_empty()) else { return };
    if fit.status.has_estimates() {
        fit.warnings.push(format!(
            "standard errors are rough: one of `{}` away from the answer, with the others following it, the sum of squares rises by {:.0} variances \
             instead of one, as where a row lies beside a fold of the curve or where the edge of the contact is set free; see --profile-likelihood",
            objective.parameter(step.place).name,
            step.rise
        ));
    }
}

/// Warns of another minimum that these data do not exclude: χ² rises by less than nine, three standard deviations of one number.
pub(super) fn of_minima(fit: &mut Fit) {
    let variance = super::limits::variance(fit);
    let rss = fit.rss;
    let moved = |other: &&Attempt| {
        let far = |(estimate, value): (&super::answer::FitEstimate, &f64)| {
            let distance = (value - estimate.value?).abs();
            Some(distance > 2.0 * estimate.stderr? && distance > 1e-3 * estimate.value?.abs())
        };
        fit.parameters.iter().zip(&other.estimates).any(|both| far(both) == Some(true))
    };
    let near = |other: &&Attempt| other.rss - rss < ALIKE * variance;
    let Some(other) = fit.tried.iter().skip(1).filter(near).find(moved) else { return };
    let numbers = fit.parameters.iter().zip(&other.estimates);
    let numbers = numbers.map(|(estimate, value)| format!("{} = {value:.4e} {}", estimate.name, estimate.unit));
    let warning = format!(
        "the data hardly tell this minimum from another, with {} rows detached: {}; χ² is larger there by {:.2} only",
        other.detached,
        numbers.collect::<Vec<_>>().join(", "),
        ((other.rss - rss) / variance).max(0.0)
    );
    fit.warnings.push(warning);
}

/// Whether σ is not stated and the residuals are larger than the scatter of neighbouring rows.
pub(super) fn misses(fit: &Fit, seen: f64, residual: f64) -> bool {
    fit.chi2.is_none() && fit.chi2_p.is_none() && fit.rows.len() > 20 && seen > 0.0 && residual > LARGER * seen
}

/// Warns of residuals that are larger than the scatter of neighbouring rows.
pub(super) fn of_scatter(fit: &mut Fit, seen: f64, residual: f64) {
    if misses(fit, seen, residual) {
        fit.warnings.push(format!(
            "the residuals are {:.1} times as large as the scatter of neighbouring rows, {seen:.2e} {}: the curve misses the data",
            residual / seen,
            fit.units[1]
        ));
    }
}
