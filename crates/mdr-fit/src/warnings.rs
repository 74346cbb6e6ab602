//! Warnings of results that may mislead, in a fit that has ended well.

use mdr_core::contact::Shape;

use super::answer::{Fit, FitStatus};
use super::descents::Attempt;
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
    let detached = fit.rows.iter().any(|row| row.label < 0);
    let sees_jump =
        detached || problem.observation.sees_radius() || problem.observation == Observation::IndentationOfForce;
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
    if let Some(test) = fit.runs_test.filter(|test| test.p < 0.01) {
        let residuals: Vec<f64> = fit.rows.iter().map(|row| row.residual).collect();
        warnings.push(format!(
            "the residuals are not random: {} runs of equal sign where {:.0} are expected (p = {:.1e}); the standard errors are \
             too small if they are correlated, by their autocorrelation {:.1} times",
            test.runs,
            test.expected,
            test.p,
            widening(&residuals)
        ));
    }
    if let (Some(chi2), Some(p)) = (fit.chi2, fit.chi2_p)
        && !(1e-3..=1.0 - 1e-3).contains(&p)
    {
        let verdict =
            if p < 0.5 { "larger than the stated σ explains" } else { "smaller than the stated σ explains" };
        warnings.push(format!("χ² = {chi2:.4} for {} degrees of freedom is {verdict} (p = {p:.1e})", fit.dof));
    }
    if !objective.at_fold.is_empty() {
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

/// By how much correlated residuals make standard errors too small: the root of the sum of their autocorrelation, up to where it vanishes.
fn widening(residuals: &[f64]) -> f64 {
    let power: f64 = residuals.iter().map(|residual| residual * residual).sum();
    let mut sum = 1.0;
    for lag in 1..residuals.len() / 4 {
        let products = residuals.iter().zip(&residuals[lag..]).map(|(one, other)| one * other);
        let correlation = products.sum::<f64>() / power;
        if !(correlation > 0.0) {
            break;
        }
        sum += 2.0 * correlation;
    }
    sum.sqrt()
}

/// Warns of another minimum that these data do not exclude: χ² rises by less than nine, three standard deviations of one number.
pub(super) fn of_minima(fit: &mut Fit, objective: &Objective<'_>, tried: &[Attempt], deviation: f64) {
    let Some(least) = tried.first() else { return };
    let near = |other: &&Attempt| other.cost - least.cost < ALIKE * deviation * deviation;
    let moved = |other: &Attempt| {
        let far = |(place, estimate): (usize, &super::answer::FitEstimate)| {
            let value = objective.value(place, other.fitted[place]);
            let distance = (value - estimate.value?).abs();
            Some(distance > 2.0 * estimate.stderr? && distance > 1e-3 * estimate.value?.abs())
        };
        fit.parameters.iter().enumerate().any(|estimate| far(estimate) == Some(true))
    };
    let Some(other) = tried[1..].iter().filter(near).find(|other| moved(other)) else { return };
    let numbers = fit.parameters.iter().zip(&other.fitted).enumerate().map(|(place, (estimate, fitted))| {
        format!("{} = {:.4e} {}", estimate.name, objective.value(place, *fitted), estimate.unit)
    });
    let warning = format!(
        "the data hardly tell this minimum from another, with {} rows detached: {}; χ² is larger there by {:.2} only",
        other.detached,
        numbers.collect::<Vec<_>>().join(", "),
        (other.cost - least.cost).max(0.0) / (deviation * deviation)
    );
    fit.warnings.push(warning);
}

/// Warns where σ is not stated and residuals are larger than the scatter of neighbouring rows.
pub(super) fn of_scatter(fit: &mut Fit, seen: f64, residual: f64) {
    if fit.chi2.is_none() && fit.chi2_p.is_none() && fit.rows.len() > 20 && seen > 0.0 && residual > LARGER * seen {
        fit.warnings.push(format!(
            "the residuals are {:.1} times as large as the scatter of neighbouring rows, {seen:.2e} {}: the curve misses the data",
            residual / seen,
            fit.units[1]
        ));
    }
}
