//! The residuals of each leg, and hysteresis that one work of adhesion does not serve.

use mdr_core::contact::Edge;

use super::answer::{Fit, FitStatus, FittedLeg};
use super::drive;
use super::judge;
use super::limits;
use super::objective::Objective;
use super::observation::{Leg, Observation};
use super::problem::{DataRow, Kind, Problem};
use super::start::Source;

/// The probability of a χ² or of runs below which a second work of adhesion is tried.
const SUSPICIOUS: f64 = 1e-3;

/// The residuals over the scatter of neighbouring rows above which a second work of adhesion is tried.
const LARGER: f64 = 1.3;

/// The fall of the sum of squares, in variances, for which hysteresis is named.
const FALL: f64 = 25.0;

/// Adds a judgement of the residuals of each leg.
pub(super) fn legs(fit: &mut Fit, objective: &Objective<'_>) {
    let mut first = 0;
    for leg in objective.rows.chunk_by(|one, other| one.part == other.part) {
        let rows = &fit.rows[first..first + leg.len()];
        first += leg.len();
        let residuals: Vec<f64> = rows.iter().map(|row| row.residual).collect();
        let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
        fit.legs.push(FittedLeg {
            leg: leg[0].leg,
            rows: rows.len(),
            in_contact: rows.iter().filter(|row| row.label >= 0).count(),
            pinned: rows.iter().filter(|row| row.pinned).count(),
            mean_square: Some(squares / rows.len() as f64).filter(|mean| mean.is_finite()),
            runs_test: judge::runs_test(&residuals),
            autocorrelation: judge::autocorrelation(&[&residuals], residuals.len()),
        });
    }
}

/// The residuals of each leg of a record.
pub(super) fn of_legs<'r>(objective: &Objective<'_>, residuals: &'r [f64]) -> Vec<&'r [f64]> {
    let mut rest = residuals;
    let legs = objective.rows.chunk_by(|one, other| one.part == other.part);
    let of_leg = |leg: &[DataRow]| {
        let (own, other) = rest.split_at(leg.len().min(rest.len()));
        rest = other;
        own
    };
    legs.map(of_leg).collect()
}

/// Warns of hysteresis where the residuals are not those of noise and another work of adhesion for each direction mends them.
pub(super) fn add(fit: &mut Fit, problem: &Problem, seen: f64) {
    let retracts = fit.legs.iter().any(|leg| leg.leg == Leg::Retract && leg.in_contact > 0);
    let can_be =
        retracts && problem.observation != Observation::ForceOfRadius && fit.status != FitStatus::Unidentifiable;
    if problem.has_two_works() {
        return warn_of_order(fit);
    }
    let deviation = (fit.rss / fit.dof.max(1) as f64).sqrt();
    let is_suspicious = fit.chi2_p.is_some_and(|p| p < SUSPICIOUS)
        || fit.legs.iter().any(|leg| leg.runs_test.is_some_and(|test| test.p < SUSPICIOUS))
        || (fit.chi2.is_none() && fit.rss_unit != "1" && deviation > LARGER * seen);
    if !can_be || !is_suspicious {
        return;
    }
    let mut two = problem.alone();
    for parameter in &mut two.parameters {
        match parameter.kind {
            Kind::WorkOfAdhesion => (parameter.free, parameter.value, parameter.prior) = (false, None, None),
            Kind::Work(_) => parameter.free = true,
            _ => {}
        }
        parameter.start = None;
    }
    let sources = [Source::Formula, Source::Record, Source::Search];
    let Ok(found) = drive::fit_from(&two, &sources).map(|outcome| outcome.fit) else { return };
    let value = |edge: Edge| found.estimate(edge.name())?.value;
    let [Some(advancing), receding] = [value(Edge::Advancing), value(Edge::Receding)] else { return };
    let is_better = limits::fall(fit, &found).is_some_and(|fall| fall > FALL);
    if !is_better || receding.is_some_and(|receding| receding <= advancing) {
        return;
    }
    let receding = match (receding, found.limits.first().and_then(|limit| limit.lower)) {
        (Some(receding), _) => format!("{receding:.3e} J/m² where it recedes"),
        (None, Some(lower)) => format!("at least {lower:.3e} J/m² where it recedes"),
        (None, None) => return,
    };
    fit.warnings.push(format!(
        "one work of adhesion does not serve this record: it shows hysteresis. With one for each direction, {advancing:.3e} J/m² where the \
         edge of the contact advances and {receding}, the sum of squares falls from {:.4e} to {:.4e}: free `work_of_adhesion.advancing` and \
         `work_of_adhesion.receding` instead",
        fit.rss, found.rss
    ));
}

/// Warns of two works of adhesion in the wrong order, or that are not told apart.
fn warn_of_order(fit: &mut Fit) {
    let of = |edge: Edge| fit.estimate(edge.name()).and_then(|estimate| Some([estimate.value?, estimate.stderr?]));
    let (Some([advancing, one]), Some([receding, other])) = (of(Edge::Advancing), of(Edge::Receding)) else { return };
    let apart = (receding - advancing) / one.hypot(other);
    if apart < -2.0 {
        fit.warnings.push(
            "the work of adhesion is smaller where the edge recedes than where it advances: no hysteresis of an edge; free one \
             `work_of_adhesion`, and see whether the position drifts"
                .to_owned(),
        );
    } else if apart < 2.0 {
        fit.warnings
            .push("the two works of adhesion are not told apart: one `work_of_adhesion` serves both legs".to_owned());
    }
}
