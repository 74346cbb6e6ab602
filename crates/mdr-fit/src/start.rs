//! Values to begin from: by the two-point method, or by a search.

use mdr_core::contact::{Control, Flank, Fold, Shape};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds;
use nalgebra::{DMatrix, DVector};

use super::contact::Tip;
use super::edges;
use super::hypotheses;
use super::judge;
use super::objective::Objective;
use super::observation::{Leg, Observation};
use super::problem::{Kind, Problem};
use super::trends;
use mdr::scene::Profile;

/// Materials to try, w/E* against the span of depths: three in a decade.
const LENGTHS: std::ops::RangeInclusive<i32> = -27..=6;

/// How many minima of a search over w/E* are looked at more closely.
const MINIMA: usize = 3;

/// By how many typical steps Y rises at a pull-off.
const JUMP: f64 = 5.0;

/// The data of a record from which E*, w and the offsets are estimated without a fit.
struct Record {
    /// Rows as (d, F), without baseline, and up to the contact point.
    states: Vec<[f64; 2]>,
    /// The last state before the pull-off, where a jump is seen.
    last: Option<[f64; 2]>,
    baseline: f64,
}

/// Where a start comes from, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// The problem.
    Given,
    /// The two-point method of a power law; linear regression where the contact radius is known.
    Formula,
    /// Hypotheses on the record: all rows in contact, or a jump between any two.
    Record,
    /// A search over w/E*.
    Search,
}

impl Source {
    pub(super) const ALL: [Source; 4] = [Source::Given, Source::Formula, Source::Record, Source::Search];
}

/// Fitted values to begin from with their names, in the order of the free numbers: first the given numbers, completed from the
/// data; then the data alone.
pub(super) fn candidates(objective: &Objective<'_>, source: Source) -> Vec<(&'static str, Vec<f64>)> {
    let problem = objective.problem;
    let given = (0..objective.free.len()).map(|place| {
        let parameter = objective.parameter(place);
        let is_trend = parameter.kind.is_trend() && source == Source::Given;
        let is_profile = matches!(parameter.kind, Kind::Profile(_) | Kind::Stiffness | Kind::Sensitivity);
        parameter.guess().or(parameter.value.filter(|_| is_profile || is_trend))
    });
    let given: Vec<Option<f64>> = given.collect();
    let complete = |found: &dyn Fn(Kind) -> Option<f64>, keep: bool| -> Option<Vec<f64>> {
        let value = |(place, given): (usize, &Option<f64>)| {
            let kind = objective.kind(place);
            let value = if keep { given.or_else(|| found(kind)) } else { found(kind).or(*given) };
            value.filter(|value| value.is_finite()).map(|value| objective.to_fitted(place, value))
        };
        given.iter().enumerate().map(value).collect()
    };
    if source == Source::Given {
        return complete(&|_| None, true).map(|start| ("given", start)).into_iter().collect();
    }
    let mut candidates = Vec::new();
    for problem in trends::variants(problem) {
        let found = if problem.has_two_works() {
            edges::from_legs(objective, &problem, source)
        } else {
            let one = |(name, [e_star, work, contact_point, baseline]): (_, [f64; 4])| {
                (name, Start { e_star, works: [work; 2], contact_point, baseline })
            };
            from_data(&problem, source).into_iter().map(one).collect()
        };
        for (name, found) in found {
            let of = |kind: Kind| found.of(kind).or_else(|| problem.known(kind).filter(|_| kind.is_trend()));
            let completed = [true, false].into_iter().filter_map(|keep| complete(&of, keep));
            candidates.extend(completed.map(|start| (name, start)));
        }
    }
    candidates.dedup_by(|one, other| one.1 == other.1);
    candidates
}

/// Numbers that a record tells.
#[derive(Clone, Copy)]
pub(super) struct Start {
    pub(super) e_star: f64,
    /// Of an edge that advances, and that recedes.
    pub(super) works: [f64; 2],
    pub(super) contact_point: f64,
    pub(super) baseline: f64,
}

impl Start {
    pub(super) fn of(&self, kind: Kind) -> Option<f64> {
        match kind {
            Kind::EffectiveModulus => Some(self.e_star),
            Kind::WorkOfAdhesion => Some(self.works[0]),
            Kind::Work(edge) => Some(self.works[edge as usize]),
            Kind::ContactPoint => Some(self.contact_point),
            Kind::Baseline => Some(self.baseline),
            _ => None,
        }
    }
}

/// E*, w, contact point and baseline by the record, the likeliest first.
pub(super) fn from_data(problem: &Problem, source: Source) -> Vec<(&'static str, [f64; 4])> {
    let numbers: Vec<f64> = problem
        .parameters
        .iter()
        .filter(|parameter| matches!(parameter.kind, Kind::Profile(_)))
        .map(|parameter| parameter.known().unwrap_or(f64::NAN))
        .collect();
    let Ok(tip) = Tip::<f64>::new(problem, (), &numbers, &[]) else { return Vec::new() };
    match (problem.observation.sees_radius(), source) {
        (true, Source::Formula) => {
            by_regression(problem, &tip).map(|numbers| ("regression", numbers)).into_iter().collect()
        }
        (false, Source::Formula) => {
            let found =
                if problem.medium.is_half_space() { two_points(problem, &record(problem), &numbers) } else { None };
            found.map(|numbers| ("two-points", numbers)).into_iter().collect()
        }
        (false, Source::Record) => hypotheses::starts(problem, &tip),
        (false, Source::Search) => {
            by_search(problem, &record(problem), &tip).into_iter().map(|numbers| ("search", numbers)).collect()
        }
        _ => Vec::new(),
    }
}

/// Depth and force of the rows of the last leg, the one that retracts where there is one.
fn record(problem: &Problem) -> Record {
    let retracts = problem.rows.iter().any(|row| row.leg == Leg::Retract);
    let rows: Vec<[f64; 2]> =
        problem.rows.iter().filter(|row| !retracts || row.leg == Leg::Retract).map(|row| problem.seen(row)).collect();
    // Under a dead load nothing is seen of a contact that is broken.
    let has_tail = problem.observation != Observation::IndentationOfForce;
    let last = pull_off(&rows).filter(|_| has_tail);
    let baseline = if problem.is_free(Kind::Baseline) && has_tail {
        tail(&rows, last).or(problem.known(Kind::Baseline)).unwrap_or(0.0)
    } else {
        problem.known(Kind::Baseline).unwrap_or(0.0)
    };
    let stiffness = problem.known(Kind::Stiffness).unwrap_or(f64::INFINITY);
    let state = |row: &[f64; 2]| problem.observation.state(*row, [0.0, baseline], stiffness);
    Record { states: rows.iter().map(state).collect(), last: last.as_ref().map(state), baseline }
}

/// The last row before the pull-off: where, pulled further than at the smallest Y, Y rises at once by more than anywhere else.
fn pull_off(rows: &[[f64; 2]]) -> Option<[f64; 2]> {
    let mut beyond = beyond_lowest(rows)?;
    beyond.sort_by(|one, other| other[0].total_cmp(&one[0]));
    let rise = |pair: &[[f64; 2]]| pair[1][1] - pair[0][1];
    let jump = beyond.windows(2).max_by(|one, other| rise(one).total_cmp(&rise(other)))?;
    let typical = super::judge::median(beyond.windows(2).map(|pair| rise(pair).abs()).collect());
    (rise(jump) > JUMP * typical).then_some(jump[0])
}

/// The row of the smallest Y and all that are pulled further.
fn beyond_lowest(rows: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
    let lowest = rows.iter().min_by(|one, other| one[1].total_cmp(&other[1]))?;
    Some(rows.iter().copied().filter(|row| row[0] <= lowest[0]).collect())
}

/// The median of the detached rows: those after the pull-off, or after the smallest Y where no jump is seen.
fn tail(rows: &[[f64; 2]], last: Option<[f64; 2]>) -> Option<f64> {
    let detached = match last {
        Some(last) => rows.iter().copied().filter(|row| row[0] < last[0]).collect(),
        None => beyond_lowest(rows).filter(|beyond| beyond.len() > 3)?,
    };
    Some(super::judge::median(detached.into_iter().map(|row| row[1]).collect()))
}

impl Record {
    /// The state of the smallest force.
    fn lowest(&self) -> [f64; 2] {
        self.states
            .iter()
            .copied()
            .fold([0.0, f64::INFINITY], |best, state| if state[1] < best[1] { state } else { best })
    }

    /// The depth at which the force vanishes, deeper than where it is smallest; `None` if it never does.
    fn depth_without_force(&self) -> Option<f64> {
        let lowest = self.lowest();
        let mut inside: Vec<[f64; 2]> = self.states.iter().copied().filter(|state| state[0] > lowest[0]).collect();
        inside.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let crossing = inside.windows(2).find(|pair| pair[0][1] < 0.0 && pair[1][1] >= 0.0)?;
        let share = crossing[0][1] / (crossing[0][1] - crossing[1][1]);
        Some(crossing[0][0] + share * (crossing[1][0] - crossing[0][0]))
    }
}

/// The two-point method of a power law: the smallest force F_ad, and how much deeper the force vanishes.
fn two_points(problem: &Problem, record: &Record, numbers: &[f64]) -> Option<[f64; 4]> {
    let [n, c] = match &problem.profile {
        Profile::Shape(Shape::Power { .. }) => [numbers[0], numbers[1]],
        Profile::Shape(Shape::Cone { flank: Flank::Slope(_) }) => [1.0, numbers[0]],
        Profile::Shape(Shape::Paraboloid { .. }) => [2.0, 0.5 / numbers[0]],
        _ => return None,
    };
    let [lowest_depth, lowest] = record.lowest();
    if !(n > 0.5 && lowest < 0.0) {
        return None;
    }
    let width = record.depth_without_force()? - lowest_depth;
    let q = (2.0 * (2.0 * (n + 1.0) / 3.0).powf(1.0 / (2.0 * n - 1.0)) + 2.0 * n - 3.0) / n;
    let scale = n * mdr_analytic::kappa(&n).ok()? * c;
    let radius = (3.0 * width / (q * scale)).powf(1.0 / n);
    let e_star = -lowest * (n + 1.0) * q / (2.0 * (2.0 * n - 1.0) * width * radius);
    let work = 2.0 * e_star * width * width / (std::f64::consts::PI * q * q * radius);
    // The depth at the smallest force is ((3 − 2n)/n) √(B a_F), B = πw/2E*.
    let depth = (3.0 - 2.0 * n) / n * (std::f64::consts::PI * work * radius / (2.0 * e_star)).sqrt();
    Some([e_star, work, lowest_depth - depth, record.baseline])
}

/// A search over w/E*: E* and the contact point follow from a row at which a fold is.
fn by_search(problem: &Problem, record: &Record, tip: &Tip<f64>) -> Vec<[f64; 4]> {
    let [low, high] = judge::extent(record.states.iter().map(|state| state[0]));
    let span = high - low;
    let mut minima: Vec<(f64, [f64; 4], Anchor)> = Vec::new();
    for anchor in [Anchor::SmallestForce, Anchor::PullOff] {
        let coarse: Vec<_> = LENGTHS
            .map(|power| {
                let length = tip.work_of_length(span * 10f64.powf(f64::from(power) / 3.0));
                with_length(problem, record, tip, length, anchor)
            })
            .collect();
        let cost = |index: Option<usize>| {
            let found = index.and_then(|index| coarse.get(index)?.as_ref());
            found.map_or(f64::INFINITY, |(cost, _)| *cost)
        };
        let is_least = |index: usize| {
            cost(Some(index)) <= cost(index.checked_sub(1)) && cost(Some(index)) <= cost(Some(index + 1))
        };
        let least = coarse.iter().enumerate().filter(|(index, _)| is_least(*index));
        minima.extend(least.filter_map(|(_, found)| found.map(|(cost, numbers)| (cost, numbers, anchor))));
    }
    minima.sort_by(|one, other| one.0.total_cmp(&other.0));
    // Once more, finer, around each: the true one may be narrow.
    let finer = |(_, [e_star, work, ..], anchor): &(f64, [f64; 4], Anchor)| {
        let at = |step: i32| {
            let length = work / e_star * 10f64.powf(f64::from(step) / 30.0);
            with_length(problem, record, tip, length, *anchor)
        };
        (-10..=10).filter_map(at).min_by(|one, other| one.0.total_cmp(&other.0))
    };
    let mut found: Vec<(f64, [f64; 4])> = minima.iter().take(MINIMA).filter_map(finer).collect();
    found.sort_by(|one, other| one.0.total_cmp(&other.0));
    found.into_iter().map(|(_, numbers)| numbers).collect()
}

/// A row that a curve of the search goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Anchor {
    /// The row of the smallest force, the fold under a dead load.
    SmallestForce,
    /// The last before the pull-off, the fold under fixed grips.
    PullOff,
}

/// The material with this w/E* whose fold is at the anchor, and how far the rows are from its curve.
fn with_length(
    problem: &Problem,
    record: &Record,
    tip: &Tip<f64>,
    length: f64,
    anchor: Anchor,
) -> Option<(f64, [f64; 4])> {
    let (control, [at, smallest]) = match anchor {
        Anchor::SmallestForce => (Control::Force, record.lowest()),
        Anchor::PullOff => (Control::Indentation, record.last?),
    };
    let curve = tip.on([1.0, length], control).ok()?;
    let folds = folds::find(&curve).ok()?;
    let held = |fold: &Fold<f64>| if anchor == Anchor::PullOff { fold.indentation } else { fold.force };
    let lowest = folds.folds.iter().min_by(|one, other| held(one).total_cmp(&held(other)))?;
    let free = [Kind::EffectiveModulus, Kind::WorkOfAdhesion].map(|kind| problem.is_free(kind));
    let stated = [Kind::EffectiveModulus, Kind::WorkOfAdhesion].map(|kind| problem.known(kind));
    let e_star = match (free, stated) {
        ([true, true], _) if smallest < 0.0 && lowest.force < 0.0 => Some(smallest / lowest.force),
        // No adhesion is seen: the deepest row tells E*.
        ([true, true], _) if anchor == Anchor::SmallestForce => {
            let [depth, force] = record.states.iter().copied().max_by(|one, other| one[0].total_cmp(&other[0]))?;
            let target = depth - problem.known(Kind::ContactPoint).unwrap_or(0.0);
            let radius = radius_at(&curve, lowest.contact_radius, target)?;
            Some(force / curve.force(&radius).ok()?)
        }
        ([true, true], _) => None,
        ([false, _], [e_star, _]) => e_star,
        ([true, false], [_, work]) => work.map(|work| work / length),
    }
    .filter(|e_star| *e_star > 0.0)?;
    let contact_point = if problem.is_free(Kind::ContactPoint) && smallest < 0.0 {
        at - lowest.indentation
    } else {
        problem.known(Kind::ContactPoint).unwrap_or(0.0)
    };
    // How far the rows in contact are from the curve in force.
    let mut radius = lowest.contact_radius;
    let (mut cost, mut count) = (0.0, 0);
    let mut states: Vec<[f64; 2]> = record.states.iter().copied().filter(|state| state[0] >= at).collect();
    states.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let stride = states.len().div_ceil(60).max(1);
    for [d, f] in states.into_iter().step_by(stride) {
        radius = radius_at(&curve, radius, d - contact_point)?;
        let error = e_star * curve.force(&radius).ok()? - f;
        cost += error * error;
        count += 1;
    }
    // A curve through the anchor and two others says something.
    (count > 2).then_some((cost / f64::from(count), [e_star, e_star * length, contact_point, record.baseline]))
}

/// The first radius from `radius` outward at which the contact is this deep, to a hundredth.
fn radius_at(curve: &Contact<f64>, mut radius: f64, depth: f64) -> Option<f64> {
    for _ in 0..2000 {
        if curve.indentation(&radius).ok()? >= depth {
            return Some(radius);
        }
        radius *= 1.01;
    }
    None
}

/// With the contact radius known, force is linear in E*, √(E*w) and the baseline.
fn by_regression(problem: &Problem, tip: &Tip<f64>) -> Option<[f64; 4]> {
    let rows: Vec<[f64; 2]> = problem
        .rows
        .iter()
        .map(|row| if problem.observation == Observation::ForceOfRadius { [row.x, row.y] } else { [row.y, row.x] })
        .filter(|[radius, _]| *radius > 0.0)
        .collect();
    let with_baseline = problem.is_free(Kind::Baseline);
    let columns = if with_baseline { 3 } else { 2 };
    let mut matrix = DMatrix::zeros(rows.len(), columns);
    let mut forces = DVector::zeros(rows.len());
    for (index, [radius, force]) in rows.iter().enumerate() {
        let [stiffness, pull] = tip.unit_forces(*radius);
        matrix[(index, 0)] = stiffness * tip.transform.above_mean(radius).ok()?;
        matrix[(index, 1)] = -pull;
        if with_baseline {
            matrix[(index, 2)] = 1.0;
        }
        forces[index] = *force;
    }
    let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    for (mut column, length) in matrix.column_iter_mut().zip(&lengths) {
        column /= *length;
    }
    let solution = judge::least_squares(matrix, &forces, 1e-12)?;
    let [e_star, root] = [solution[0] / lengths[0], solution[1] / lengths[1]];
    let baseline = if with_baseline { solution[2] / lengths[2] } else { 0.0 };
    (e_star > 0.0 && root > 0.0).then_some([e_star, root * root / e_star, 0.0, baseline])
}
