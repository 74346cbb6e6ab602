//! What may mislead in a fit that has ended well.

use mdr_core::contact::Shape;

use super::answer::{Fit, FitStatus};
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Observation;
use super::problem::Kind;
use crate::scene::Profile;

/// A singular value below this share of the largest leaves a direction nearly open.
const NEARLY_OPEN: f64 = 1e-3;

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
    if let Some(stiffness) = numbers.stiffness {
        let ratio = 2.0 * numbers.e_star * widest / stiffness;
        if ratio > 10.0 {
            warnings.push(format!(
                "the contact is {ratio:.0} times stiffer than the machine, 2E*a/k, so that the curve shows the machine rather than \
                 the contact: errors of the stiffness weigh heavily"
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
        warnings.push(format!(
            "the residuals are not random: {} runs of equal sign where {:.0} are expected (p = {:.1e}); the standard errors are \
             too small if they are correlated",
            test.runs, test.expected, test.p
        ));
    }
    if let (Some(chi2), Some(p)) = (fit.chi2, fit.chi2_p)
        && !(1e-3..=1.0 - 1e-3).contains(&p)
    {
        let verdict =
            if p < 0.5 { "larger than the stated σ explains" } else { "smaller than the stated σ explains" };
        warnings.push(format!("χ² = {chi2:.4} for {} degrees of freedom is {verdict} (p = {p:.1e})", fit.dof));
    }
    fit.warnings = warnings;
}
