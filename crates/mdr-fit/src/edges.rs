//! Starts for two works of adhesion: each leg alone tells E*, its own w and the offsets; the other w is searched for.

use std::sync::Arc as Shared;

use mdr_core::contact::Edge;

use super::judge;
use super::objective::Objective;
use super::observation::Leg;
use super::problem::{Kind, Problem};
use super::start::{Source, Start, from_data};

/// How many starts of a leg are completed, and how many ends of each search are kept.
const OF_A_LEG: usize = 3;
const KEPT: usize = 2;

/// Works of adhesion to try, w/E* against the span of X: four in a decade.
const LENGTHS: std::ops::RangeInclusive<i32> = -32..=6;
const IN_A_DECADE: f64 = 4.0;

/// How far inside a range of equal works of adhesion a start is.
const INSIDE: usize = 3;

/// Rows that are looked at.
const ROWS: usize = 80;

/// The share of the lower end of a leg that retracts, from its smallest force up, where the edge is hardly pinned any more; with an approach, which
/// tells more, and without.
const LOWER: [f64; 2] = [1.0, 0.5];
const LOWER_ALONE: [f64; 5] = [1.0, 0.7, 0.45, 0.25, 0.12];

/// Starts by each leg alone.
pub(super) fn from_legs(objective: &Objective<'_>, problem: &Problem, source: Source) -> Vec<(&'static str, Start)> {
    let stride = problem.rows.len().div_ceil(ROWS).max(1);
    let few = Problem { rows: Shared::new(problem.rows.iter().copied().step_by(stride).collect()), ..problem.clone() };
    let Ok(search) = Objective::new(&few, objective.x_scale, objective.noise) else { return Vec::new() };
    let ends = judge::extent(problem.rows.iter().map(|row| row.x));
    let span = ends[1] - ends[0];
    let mut starts = Vec::new();
    for (leg, edge, name) in
        [(Leg::Approach, Edge::Advancing, "approach-alone"), (Leg::Retract, Edge::Receding, "retract-alone")]
    {
        let shares: &[f64] = match leg {
            Leg::Approach => &LOWER[..1],
            Leg::Retract if problem.rows.iter().any(|row| row.leg == Leg::Approach) => &LOWER,
            Leg::Retract => &LOWER_ALONE,
        };
        let of_leg = problem.rows.iter().filter(|row| row.leg == leg);
        let lowest = of_leg.min_by(|one, other| one.y.total_cmp(&other.y)).map_or(ends[0], |row| row.x);
        for share in shares {
            let Some(alone) = alone(problem, leg, edge, lowest + share * (ends[1] - lowest)) else { continue };
            for (_, [e_star, work, contact_point, baseline]) in from_data(&alone, source).into_iter().take(OF_A_LEG) {
                let start = Start { e_star, works: [work; 2], contact_point, baseline };
                starts.extend(searched(&search, start, edge, span).into_iter().map(|start| (name, start)));
            }
        }
    }
    starts
}

/// The problem of one leg with one work of adhesion, up to a place.
fn alone(problem: &Problem, leg: Leg, edge: Edge, up_to: f64) -> Option<Problem> {
    let rows: Vec<_> = problem.rows.iter().copied().filter(|row| row.leg == leg && row.x <= up_to).collect();
    let mut alone = Problem { rows: Shared::new(rows), ..problem.clone() };
    let own = alone.parameters.iter().find(|parameter| parameter.kind == Kind::Work(edge))?.clone();
    for parameter in &mut alone.parameters {
        match parameter.kind {
            Kind::Work(_) => {
                (parameter.free, parameter.value, parameter.start, parameter.prior) = (false, None, None, None)
            }
            Kind::WorkOfAdhesion => {
                (parameter.free, parameter.value, parameter.start, parameter.prior) =
                    (own.free, own.value, own.start, own.prior);
            }
            _ => {}
        }
    }
    (super::data::check(&alone.rows).is_ok()).then_some(alone)
}

/// A start with the work of adhesion of the other edge at the least sums of squares.
fn searched(objective: &Objective<'_>, start: Start, known: Edge, span: f64) -> Vec<Start> {
    let other = if known == Edge::Advancing { Edge::Receding } else { Edge::Advancing };
    let place = |kind: Kind| (0..objective.free.len()).find(|place| objective.kind(*place) == kind);
    let fitted = |start: &Start| -> Option<Vec<f64>> {
        let value = |place: usize| {
            let parameter = objective.parameter(place);
            let value = start.of(parameter.kind).or_else(|| parameter.known())?;
            Some(objective.to_fitted(place, value)).filter(|value| value.is_finite())
        };
        (0..objective.free.len()).map(value).collect()
    };
    let cost = |start: &Start| {
        let evaluation = fitted(start).and_then(|fitted| objective.evaluate(&fitted, None).ok());
        evaluation.map_or(f64::INFINITY, |evaluation| evaluation.cost())
    };
    if place(Kind::Work(other)).is_none() {
        return vec![start];
    }
    let with = |work: f64| {
        let mut start = start;
        start.works[other as usize] = work;
        start
    };
    let mut tried: Vec<(f64, Start)> = LENGTHS
        .map(|power| span * 10f64.powf(f64::from(power) / IN_A_DECADE))
        .map(|length| objective.problem.work_of_length(start.e_star, length))
        .filter(
            |work| if other == Edge::Receding { *work > 0.5 * start.works[0] } else { *work < 2.0 * start.works[1] },
        )
        .chain([start.works[known as usize]])
        .map(|work| (cost(&with(work)), with(work)))
        .filter(|(cost, _)| cost.is_finite())
        .collect();
    let of_other = |start: &Start| start.works[other as usize];
    tried.sort_by(|one, other| of_other(&one.1).total_cmp(&of_other(&other.1)));
    // Where an edge never recedes, all that are large enough are equal: one of them, well inside.
    if let Some(&(largest, _)) = tried.last() {
        let same = tried.iter().rev().take_while(|(cost, _)| (cost - largest).abs() <= 1e-9 * largest).count();
        let begin = tried.len() - same;
        if same > 1 {
            let one = tried[(begin + INSIDE).min(tried.len() - 1)];
            tried.truncate(begin);
            tried.push(one);
        }
    }
    let least = |index: usize| {
        let beside = [index.checked_sub(1), Some(index + 1)].map(|beside| beside.and_then(|beside| tried.get(beside)));
        beside.iter().flatten().all(|beside| tried[index].0 <= beside.0)
    };
    let mut minima: Vec<(f64, Start)> =
        (0..tried.len()).filter(|index| least(*index)).map(|index| tried[index]).collect();
    minima.sort_by(|one, other| one.0.total_cmp(&other.0));
    minima.into_iter().take(KEPT).map(|(_, start)| start).collect()
}
