//! The dependence of the estimates on the smoothing of a measured tip, which shows the effect of its noise.

use super::answer::{Fit, SmoothedFit};
use super::drive;
use super::limits;
use super::problem::Problem;
use super::start::Source;
use mdr::scene::Measured;

/// Lengths over the one that is stated; `None` for the rows as they are.
const FACTORS: [Option<f64>; 3] = [None, Some(0.5), Some(2.0)];

/// Lengths in spacings of the rows, where none is stated.
const SPACINGS: [f64; 3] = [2.0, 8.0, 32.0];

/// Adds the fits with other smoothings of the tip, and a warning if an estimate moves by more than its standard error.
pub(super) fn add(fit: &mut Fit, problem: &Problem) {
    let tables = problem.profile.tables();
    let Some(first) = tables.first().filter(|_| fit.status.has_estimates()) else { return };
    let stated = tables.iter().find_map(|table| table.length());
    let lengths: Vec<Option<f64>> = match stated {
        Some(length) => FACTORS.iter().map(|factor| factor.map(|factor| factor * length)).collect(),
        None => {
            let spacing = first.spacing();
            let widest = fit.rows.iter().filter_map(|row| row.contact_radius).fold(0.0, f64::max);
            SPACINGS.iter().map(|count| count * spacing).filter(|length| *length < widest).map(Some).collect()
        }
    };
    fit.smoothing = lengths.into_iter().filter_map(|length| with(fit, problem, length)).collect();
    for (place, estimate) in fit.parameters.iter().enumerate() {
        let (Some(value), Some(stderr)) = (estimate.value, estimate.stderr) else { continue };
        // The rows as they are, and twice the length or two spacings: what would be an equal choice.
        let near = if stated.is_some() { fit.smoothing.last() } else { fit.smoothing.first() };
        let Some(other) = near.and_then(|other| other.estimates[place]) else { continue };
        if (other - value).abs() > 2.0 * stderr {
            fit.warnings.push(format!(
                "`{}` moves by {:.1} standard errors with the smoothing of the tip: the noise of the tip counts more than that of the \
                 curve",
                estimate.name,
                (other - value).abs() / stderr
            ));
        }
    }
}

/// The fit with the tip smoothed over another length, from the same estimates; `None` if there is no such tip, or no fit.
fn with(fit: &Fit, problem: &Problem, length: Option<f64>) -> Option<SmoothedFit> {
    let smoothed = |table: &Measured| table.smoothed(length);
    let other = Problem { profile: problem.profile.with_tables(&smoothed)?, ..limits::started(problem, fit) };
    let (estimates, rss) = drive::estimates(&other, &[Source::Given]).ok()?;
    Some(SmoothedFit { length, estimates, rss })
}
