//! Adhesion force, the force before the jump, and the work of separation: of the fitted curve, and of the rows.

use nalgebra::DVector;

use super::answer::{Fit, FitQuantity};
use super::arcs::{Arc, end_speed};
use super::contact::{Contact, Point};
use super::errors::Errors;
use super::minimise::Minimum;
use super::observation::Leg;
use mdr_core::contact::Result;

/// Intervals of Simpson's rule along an arc.
const INTERVALS: usize = 128;

/// How often a bracket around the smallest force is shortened.
const ROUNDS: usize = 60;

/// Adds what a record of force tells. Pulling counts positive here.
///
/// # Errors
/// Errors of the transform.
pub(super) fn add(fit: &mut Fit, errors: &Errors<'_>, minimum: &Minimum) -> Result<()> {
    let problem = errors.objective.problem;
    if problem.observation.sees_radius() || !fit.status.has_estimates() {
        return Ok(());
    }
    let mut quantities = Vec::new();
    let mut add = |name, label, value: f64, stderr: Option<f64>, unit| {
        if value.is_finite() {
            quantities.push(FitQuantity { name, label, value, stderr, unit });
        }
    };
    let [force_unit, work_unit] = if problem.medium.force_unit() == "N" { ["N", "J"] } else { ["N/m", "J/m"] };
    let evaluation = &minimum.evaluation;
    let sheet = evaluation.breaking();
    let kinds = errors.kinds();
    let contact = &evaluation.contacts(problem.observation, &kinds)?[sheet];
    let arcs = &evaluation.sheets[sheet].arcs;
    if let Some((point, is_fold)) = smallest_force(contact, arcs)? {
        let mut gradient = DVector::zeros(kinds.len());
        for (index, kind) in kinds.iter().enumerate() {
            let moves = if is_fold { point.slopes[1] * end_speed(contact, *kind, &point)? } else { 0.0 };
            gradient[index] = contact.state_partial(*kind, &point)?[1] + moves;
        }
        let label = "adhesion force: the smallest force of the fitted curve";
        add("adhesion_force", label, -point.f, Some(errors.stderr(&gradient)), force_unit);
    }
    let rows = || retracted(fit, errors, minimum);
    let lowest = rows().filter(|row| row.in_contact).map(|row| row.force).fold(f64::INFINITY, f64::min);
    add("adhesion_force_measured", "adhesion force: the smallest force of a row in contact", -lowest, None, force_unit);
    if let Some(event) = &fit.predicted_pull_off
        && let Some(force) = event.force
    {
        let label = "force before the jump out of contact, of the fitted curve";
        add("pull_off_force", label, -force, event.stderr.map(|stderr| stderr[2]), force_unit);
    }
    if let Some(force) = fit.measured_pull_off.as_ref().and_then(|event| event.force) {
        add(
            "pull_off_force_measured",
            "force of the last row before the jump out of contact",
            -force,
            None,
            force_unit,
        );
    }
    if problem.observation.has_depth() {
        let label = match problem.observation.has_machine() {
            true => "work of separation: adhesive force over position, of the fitted curve",
            false => "work of separation: adhesive force over depth, of the fitted curve",
        };
        if let Some(work) = separation(contact, arcs)? {
            add("separation_work", label, work, None, work_unit);
        }
        let pulled = |(one, next): (Row, Row)| {
            let mean = [&one, &next].map(|row| (-row.force).max(0.0)).iter().sum::<f64>() / 2.0;
            if next.in_contact { mean * (one.x - next.x) } else { 0.0 }
        };
        let breaks = rows().any(|row| row.in_contact) && rows().last().is_some_and(|row| !row.in_contact);
        if breaks {
            let work: f64 = rows().zip(rows().skip(1)).map(pulled).sum();
            add("separation_work_measured", "work of separation: of the rows in contact", work, None, work_unit);
        }
    }
    fit.quantities = quantities;
    Ok(())
}

/// A row of the last leg that retracts.
struct Row {
    x: f64,
    force: f64,
    in_contact: bool,
}

/// The rows of the last leg that retracts.
fn retracted<'f>(fit: &'f Fit, errors: &'f Errors<'_>, minimum: &'f Minimum) -> impl Iterator<Item = Row> + 'f {
    let data = &errors.objective.rows;
    let numbers = &minimum.evaluation.numbers;
    let last = data.iter().rev().find(|row| row.leg == Leg::Retract).map(|row| row.part);
    let rows = data.iter().zip(&fit.rows).filter(move |(row, _)| Some(row.part) == last);
    let row = |(row, fitted): (&super::problem::DataRow, &super::answer::FittedRow)| {
        let [x, y] = numbers.untrended(row);
        let [_, force] = numbers.state(errors.objective.problem.observation, [x, y]);
        Row { x, force, in_contact: fitted.label >= 0 }
    };
    rows.map(row)
}

/// The smallest force on stable arcs, and whether it is at a fold.
fn smallest_force(contact: &Contact<'_, f64>, arcs: &[Arc]) -> Result<Option<(Point<f64>, bool)>> {
    let mut least: Option<(Point<f64>, bool)> = None;
    for arc in arcs {
        let mut place = 0;
        let mut smallest = f64::INFINITY;
        for (index, sample) in arc.samples.iter().enumerate() {
            let force = contact.point(&sample.s)?.f;
            if force < smallest {
                (place, smallest) = (index, force);
            }
        }
        let last = arc.samples.len() - 1;
        let [mut low, mut high] = [place.saturating_sub(1), (place + 1).min(last)].map(|index| arc.samples[index].s);
        for _ in 0..ROUNDS {
            let [one, other] = [low + (high - low) * 0.382, low + (high - low) * 0.618];
            if contact.point(&one)?.f < contact.point(&other)?.f {
                high = other;
            } else {
                low = one;
            }
        }
        let inner = contact.point(&arc.samples[0].s)?;
        let inside = contact.point(&(0.5 * (low + high)))?;
        let (point, at_end) = if inner.f <= inside.f { (inner, true) } else { (inside, false) };
        if least.as_ref().is_none_or(|(least, _)| point.f < least.f) {
            least = Some((point, at_end && arc.inner_fold().is_some()));
        }
    }
    Ok(least)
}

/// −∫F dX from where the force vanishes to where the contact breaks, over all arcs that a retraction passes.
fn separation(contact: &Contact<'_, f64>, arcs: &[Arc]) -> Result<Option<f64>> {
    let mut work = 0.0;
    let mut begin: Option<f64> = None;
    for arc in arcs.iter().rev() {
        let Some(fold) = arc.inner_fold() else { return Ok(None) };
        let [_, upper] = arc.ends();
        let from = match begin {
            Some(x) if x >= upper.at[0] => upper.s,
            Some(x) => arc.parameter(contact, x)?,
            None => {
                // The force rises from its minimum outwards: where it vanishes.
                let (mut low, mut high) = (fold.s, upper.s);
                if contact.point(&high)?.f > 0.0 {
                    for _ in 0..ROUNDS {
                        let middle = 0.5 * (low + high);
                        *if contact.point(&middle)?.f > 0.0 { &mut high } else { &mut low } = middle;
                    }
                }
                high
            }
        };
        begin = Some(fold.at[0]);
        let pin = contact.edge.filter(|edge| *edge > fold.s && *edge < from);
        let mut ends = vec![fold.s];
        ends.extend(pin);
        ends.push(from);
        for pair in ends.windows(2) {
            work -= simpson(contact, [pair[0], pair[1]])?;
        }
    }
    Ok(begin.map(|_| work))
}

/// ∫F dX along the curve.
fn simpson(contact: &Contact<'_, f64>, [from, to]: [f64; 2]) -> Result<f64> {
    let mut sum = 0.0;
    for index in 0..=INTERVALS {
        let share = index as f64 / INTERVALS as f64;
        let point = contact.point(&(from + (to - from) * share))?;
        let weight = match index {
            0 | INTERVALS => 1.0,
            odd if odd % 2 == 1 => 4.0,
            _ => 2.0,
        };
        // Beyond a pinned edge the slope from inside is not that of the segment.
        let is_start = index == 0 && contact.edge == Some(from);
        let slope = if is_start { contact.point(&(from + 1e-9 * (to - from)))?.tangent[0] } else { point.tangent[0] };
        sum += weight * point.f * slope;
    }
    Ok(sum * (to - from) / (3.0 * INTERVALS as f64))
}
