//! Starting values from hypotheses on a record: all its rows in contact, or a jump between any two of them.
//!
//! With w/E* and the contact point given, the states of a tip are known but for the scale of forces, F = E*·φ(d), and the sum of squares
//! of a record whose rows are in contact up to a jump and detached beyond it is that of a linear regression for E* and the baseline. On a
//! grid of w/E* and contact points it is found for every jump from running sums. Its least minima are where descents begin: those without
//! any detached row, and those with a jump, each by themselves.

use super::contact::Tip;
use super::observation::{Leg, Observation};
use super::problem::{Kind, Problem};

/// w/E* against the span of depths, or E* against that of the largest force: four in a decade.
const LENGTHS: std::ops::RangeInclusive<i32> = -28..=6;
const MODULI: std::ops::RangeInclusive<i32> = -20..=16;
const IN_A_DECADE: f64 = 4.0;

/// Rows that are looked at, and radii at which the tip is.
const ROWS: usize = 90;
const RADII: usize = 360;
const OCTAVES: f64 = 18.0;

/// Intervals of depth in which forces are linear in the root of the distance from the fold.
const STEPS: usize = 256;

/// Folds inside the record, and before its first row in shares of its span.
const INSIDE: usize = 36;
const BEFORE: [f64; 9] = [1e-3, 3e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.5, 1.0];

/// How many minima of a hypothesis are followed.
const MINIMA: usize = 3;

/// Legs up to which each may also have begun or ended where the surfaces touch.
const PARTS: usize = 4;

/// How often the grid is refined around a minimum.
const ROUNDS: usize = 8;

/// The sum of squares of a minimum against the least of all, above which it is not followed unless it is the best of its hypothesis.
const WORSE: f64 = 1e2;

/// A row as a state; force without the known baseline.
#[derive(Clone, Copy)]
struct State {
    depth: f64,
    force: f64,
}

/// A part of the record with its leg.
struct Part<'s> {
    leg: Leg,
    states: &'s [State],
}

/// What is not found by least squares.
#[derive(Clone, Copy)]
struct Given {
    e_star: Option<f64>,
    /// Whether the baseline, which forces are counted from, is known.
    level: bool,
}

/// The least sum of squares of one hypothesis at one place of the grid.
#[derive(Clone, Copy)]
struct Found {
    cost: f64,
    e_star: f64,
    length: f64,
    /// The depth that is zero of the tip.
    shift: f64,
    baseline: f64,
}

/// The names of the hypotheses: no row is detached, or some are.
const NAMES: [&str; 2] = ["all-in-contact", "jump"];

/// The starts of all hypotheses with their names, the least sums of squares first: E*, w, contact point and baseline.
pub(super) fn starts(problem: &Problem, tip: &Tip<f64>) -> Vec<(&'static str, [f64; 4])> {
    search(problem, tip).unwrap_or_default()
}

fn search(problem: &Problem, pressed: &Tip<f64>) -> Option<Vec<(&'static str, [f64; 4])>> {
    let baseline = problem.known(Kind::Baseline).unwrap_or(0.0);
    let stiffness = problem.known(Kind::Stiffness).unwrap_or(f64::INFINITY);
    let stride = problem.rows.len().div_ceil(ROWS).max(1);
    let rows: Vec<_> = problem.rows.iter().step_by(stride).collect();
    let state = |row: &&super::problem::DataRow| {
        let [depth, force] = problem.observation.state(problem.seen(row), [0.0, baseline], stiffness);
        State { depth, force }
    };
    let states: Vec<State> = rows.iter().map(state).collect();
    let mut parts = Vec::new();
    let mut first = 0;
    for leg in rows.chunk_by(|one, other| one.part == other.part) {
        let states = &states[first..first + leg.len()];
        first += leg.len();
        parts.push(Part { leg: leg[0].leg, states });
    }
    let has_approach = parts.iter().any(|part| part.leg == Leg::Approach);
    let sum = |of: fn(f64) -> f64| states.iter().map(|state| of(state.force)).sum::<f64>();
    let whole = Whole { count: states.len() as f64, y: sum(|force| force), yy: sum(|force| force * force) };
    let mut depths: Vec<f64> = states.iter().map(|state| state.depth).collect();
    depths.sort_by(f64::total_cmp);
    let span = depths.last()? - depths.first()?;
    let largest = states.iter().map(|state| state.force.abs()).fold(0.0, f64::max);
    // A baseline that is free moves the depth of a row on a machine.
    let moves =
        problem.is_free(Kind::ContactPoint) || (problem.is_free(Kind::Baseline) && problem.observation.has_machine());
    let point = problem.known(Kind::ContactPoint).unwrap_or(0.0);
    let deepest = if moves { 2.5 * span } else { (depths.last()? - point).max(0.0) + 0.1 * span };
    let tip = Sampled::new(pressed, deepest)?;
    let given = |kind: Kind| problem.known(kind).filter(|_| !problem.is_free(kind));
    let level = given(Kind::Baseline).is_some();
    let lengths: Vec<(f64, Option<f64>)> = match [Kind::EffectiveModulus, Kind::WorkOfAdhesion].map(given) {
        [Some(e_star), Some(work)] => vec![(work / e_star, Some(e_star))],
        [None, Some(work)] => {
            let [stiffness, _] = pressed.unit_springs(0.0, tip.widest(span));
            // Of a half-space E*·a·d.
            let scale = largest / (stiffness / 2.0 * span);
            let e_star = |power: i32| scale * 10f64.powf(f64::from(power) / IN_A_DECADE);
            MODULI.map(e_star).map(|e_star| (work / e_star, Some(e_star))).collect()
        }
        [e_star, None] => {
            let length = |power: i32| pressed.work_of_length(span * 10f64.powf(f64::from(power) / IN_A_DECADE));
            LENGTHS.map(|power| (length(power), e_star)).collect()
        }
    };
    let has_tail = problem.observation != Observation::IndentationOfForce;
    // With the given E*, and where the fold is or, if the depth has no offset, that being given.
    let at = |curve: &Curve, fold: f64, e_star: Option<f64>, which: usize| {
        let shift = if moves { fold - curve.fold() } else { point };
        least(&parts, &whole, curve, shift, Given { e_star, level }, has_tail)[which]
    };
    let mut grids = [Vec::new(), Vec::new()];
    for (length, e_star) in lengths {
        let curve = tip.curve(length, problem.observation, has_approach);
        let shifts = if moves {
            curve.as_ref().map_or_else(Vec::new, |curve| shifts(&depths, span, curve))
        } else {
            vec![point]
        };
        let given = Given { e_star, level };
        let of = |shift: &f64| {
            curve.as_ref().map_or([None; 2], |curve| least(&parts, &whole, curve, *shift, given, has_tail))
        };
        let found: Vec<[Option<Found>; 2]> = shifts.iter().map(of).collect();
        for (grid, which) in grids.iter_mut().zip(0..) {
            grid.push(found.iter().map(|found| found[which]).collect::<Vec<_>>());
        }
    }
    // E* follows w/E* where w is given.
    let work = given(Kind::WorkOfAdhesion);
    let e_star_of = |length: f64| given(Kind::EffectiveModulus).or(work.map(|work| work / length));
    let refined = |found: Found, which: usize| {
        let is_given = work.is_some() && given(Kind::EffectiveModulus).is_some();
        let mut best = found;
        let mut steps =
            [if is_given { 0.0 } else { 0.5 / IN_A_DECADE }, if moves { span / INSIDE as f64 } else { 0.0 }];
        for _ in 0..ROUNDS {
            let lengths = [0.0, -1.0, 1.0].map(|along| best.length * 10f64.powf(steps[0] * along));
            let curves = lengths.map(|length| tip.curve(length, problem.observation, has_approach));
            let fold = curves[0].as_ref().map_or(0.0, Curve::fold) + best.shift;
            for curve in curves.iter().flatten() {
                for across in [-1.0, 0.0, 1.0] {
                    let other = at(curve, fold + steps[1] * across, e_star_of(curve.length), which);
                    if let Some(other) = other.filter(|other| other.cost < best.cost) {
                        best = other;
                    }
                }
            }
            steps = steps.map(|step| 0.6 * step);
        }
        best
    };
    let start = |found: &Found| {
        let Found { e_star, length, shift, baseline: more, .. } = *found;
        let (moved, offset) = match problem.observation {
            Observation::ForceOfPosition => (more / stiffness, more),
            Observation::DeflectionOfPosition => (more / stiffness, more / stiffness),
            _ => (0.0, more),
        };
        [e_star, e_star * length, shift + moved, baseline + offset]
    };
    let found =
        grids.iter().enumerate().flat_map(|(which, grid)| minima(grid).into_iter().map(move |found| (which, found)));
    let mut found: Vec<(usize, Found)> = found.map(|(which, found)| (which, refined(found, which))).collect();
    found.sort_by(|one, other| one.1.cost.total_cmp(&other.1.cost));
    // The best of each hypothesis, and what is not far above the best of all.
    let least = found.first().map_or(0.0, |(_, found)| found.cost);
    let is_first = |place: usize| found[..place].iter().all(|(which, _)| *which != found[place].0);
    let kept = (0..found.len()).filter(|place| is_first(*place) || found[*place].1.cost <= WORSE * least);
    Some(kept.map(|place| (NAMES[found[place].0], start(&found[place].1))).collect())
}

/// Where the fold may be: at rows, and before the first.
fn shifts(depths: &[f64], span: f64, curve: &Curve) -> Vec<f64> {
    let fold = curve.fold();
    let lowest = depths[0];
    let mut folds: Vec<f64> = BEFORE.iter().map(|share| lowest - share * span).collect();
    folds.extend(
        [0.03, 0.1, 0.3, 1.0].map(|share| lowest - share * fold.abs()).iter().filter(|at| **at > lowest - span),
    );
    folds.extend((0..INSIDE).map(|index| depths[index * (depths.len() - 1) / INSIDE]));
    folds.sort_by(f64::total_cmp);
    folds.dedup();
    folds.into_iter().map(|at| at - fold).collect()
}

/// The local minima on the grid, the least first.
fn minima(grid: &[Vec<Option<Found>>]) -> Vec<Found> {
    let cost = |row: Option<usize>, column: Option<usize>| {
        let found =
            row.and_then(|row| grid.get(row)).zip(column).and_then(|(row, column)| row.get(column).copied().flatten());
        found.map_or(f64::INFINITY, |found| found.cost)
    };
    let mut minima: Vec<Found> = Vec::new();
    for (row, line) in grid.iter().enumerate() {
        for (column, found) in line.iter().enumerate() {
            let Some(found) = found else { continue };
            let beside = [
                cost(row.checked_sub(1), Some(column)),
                cost(Some(row + 1), Some(column)),
                cost(Some(row), column.checked_sub(1)),
                cost(Some(row), Some(column + 1)),
            ];
            if beside.iter().all(|beside| found.cost <= *beside) {
                minima.push(*found);
            }
        }
    }
    minima.sort_by(|one, other| one.cost.total_cmp(&other.cost));
    minima.truncate(MINIMA);
    minima
}

/// The tip at many radii: a, g and the mean of g.
struct Sampled<'t> {
    tip: &'t Tip<f64>,
    points: Vec<[f64; 3]>,
    /// Depths beyond a vertical edge, where the contact stays.
    beyond: f64,
}

/// The states of a tip at one w/E*, by increasing depth.
struct Curve {
    /// w/E*.
    length: f64,
    /// From the inside, where a leg approaches: each arc is left where it ends.
    approach: Option<Forces>,
    /// From the outside.
    retract: Forces,
}

/// F/E* by the depth.
struct Forces {
    /// The smallest depth, and that which a row beside it may be smaller by, by rounding.
    fold: f64,
    near: f64,
    /// One over the range of depths.
    inverse: f64,
    /// At depths whose distance from the smallest grows with the square of the index: beside a fold F changes as the root of it.
    values: Vec<f64>,
}

impl Forces {
    /// Of at least two states by increasing depth.
    fn new(states: &[[f64; 2]]) -> Self {
        let (fold, deepest) = (states[0][0], states[states.len() - 1][0]);
        let mut at = 1;
        let value = |index: usize| {
            let depth = fold + (deepest - fold) * (index as f64 / STEPS as f64).powi(2);
            while at + 1 < states.len() && states[at][0] < depth {
                at += 1;
            }
            let [[d0, f0], [d1, f1]] = [states[at - 1], states[at]];
            f0 + (f1 - f0) * (depth - d0) / (d1 - d0)
        };
        let values = (0..=STEPS).map(value).collect();
        Forces { fold, near: 1e-9 * (states[1][0] - fold), inverse: 1.0 / (deepest - fold), values }
    }

    /// `None` where nothing is in equilibrium; the last two states go on beyond the largest depth.
    fn at(&self, depth: f64) -> Option<f64> {
        let above = depth - self.fold;
        if above < -self.near {
            return None;
        }
        let place = STEPS as f64 * (above.max(0.0) * self.inverse).sqrt();
        let index = (place as usize).min(STEPS - 1);
        let [one, other] = [self.values[index], self.values[index + 1]];
        Some(one + (other - one) * (place - index as f64))
    }
}

impl Curve {
    /// The smallest depth.
    fn fold(&self) -> f64 {
        self.retract.fold
    }
}

impl<'t> Sampled<'t> {
    /// Up to radii at which the contact is `deepest` without adhesion.
    fn new(tip: &'t Tip<f64>, deepest: f64) -> Option<Self> {
        let transform = &tip.transform;
        let outer = transform.outer_radius().map(|outer| outer * (1.0 - 1e-12));
        let reaches = |a: f64| transform.g(&a).map_or(true, |g| g >= deepest);
        let mut last = outer.map_or(deepest, |outer| outer.min(deepest));
        for _ in 0..400 {
            if reaches(last) || outer.is_some_and(|outer| last >= outer) {
                break;
            }
            last = outer.map_or(2.0 * last, |outer| outer.min(2.0 * last));
        }
        for _ in 0..400 {
            if !reaches(0.5 * last) {
                break;
            }
            last *= 0.5;
        }
        let radius = |index: usize| last * 2f64.powf(-OCTAVES * (1.0 - index as f64 / (RADII - 1) as f64));
        let point = |a: f64| {
            let point = [a, transform.g(&a).ok()?, transform.mean(&a).ok()?];
            point.iter().all(|value| value.is_finite()).then_some(point)
        };
        let points: Vec<[f64; 3]> = (0..RADII).map(radius).filter_map(point).collect();
        let beyond = if transform.vertical_edge() { deepest } else { 0.0 };
        (points.len() > 2).then_some(Sampled { tip, points, beyond })
    }

    /// The radius at which the contact is so deep without adhesion.
    fn widest(&self, depth: f64) -> f64 {
        let after = self.points.partition_point(|[_, g, _]| *g < depth).min(self.points.len() - 1);
        self.points[after][0]
    }

    fn curve(&self, length: f64, observation: Observation, has_approach: bool) -> Option<Curve> {
        let state = |[a, g, mean]: [f64; 3], more: f64| {
            let [stiffness, elongation] = self.tip.unit_springs(length, a);
            let d = g - elongation + more;
            [d, stiffness * (d - mean)]
        };
        let mut states: Vec<[f64; 2]> = self.points.iter().map(|point| state(*point, 0.0)).collect();
        if self.beyond > 0.0 {
            let last = self.points[self.points.len() - 1];
            states.extend((1..=8).map(|step| state(last, self.beyond * f64::from(step) / 4.0)));
        }
        // The controlled quantity grows along a stable arc: depth, or force.
        let held = usize::from(observation == Observation::IndentationOfForce);
        let rising = |states: &mut dyn Iterator<Item = [f64; 2]>, sign: f64| {
            let mut best = f64::NEG_INFINITY;
            let mut kept: Vec<[f64; 2]> = states
                .filter(|state| {
                    let is_further = sign * state[held] > best;
                    best = best.max(sign * state[held]);
                    is_further
                })
                .collect();
            kept.sort_by(|one, other| one[0].total_cmp(&other[0]));
            kept
        };
        let retract = rising(&mut states.iter().rev().copied(), -1.0);
        let approach = if has_approach {
            let lowest = states.iter().position(|state| Some(state) == retract.first())?;
            Some(rising(&mut states[lowest..].iter().copied(), 1.0))
        } else {
            None
        };
        let is_seen = retract.len() > 2 && approach.as_ref().is_none_or(|approach| approach.len() > 2);
        let approach = approach.filter(|_| is_seen).map(|approach| Forces::new(&approach));
        is_seen.then(|| Curve { length, approach, retract: Forces::new(&retract) })
    }
}

/// Sums over all rows: how many there are, of F and of F².
struct Whole {
    count: f64,
    y: f64,
    yy: f64,
}

/// Running sums of φ, φ² and φF over the rows of a part in contact.
type Sums = [f64; 3];

fn plus(one: Sums, other: Sums) -> Sums {
    [one[0] + other[0], one[1] + other[1], one[2] + other[2]]
}

/// The least sums of squares at one w/E* and shift: with all rows in contact, and with some detached.
fn least(
    parts: &[Part<'_>],
    whole: &Whole,
    curve: &Curve,
    shift: f64,
    given: Given,
    has_tail: bool,
) -> [Option<Found>; 2] {
    // Of all but the last part: in contact from where it can be, or from the first touch.
    let mut before: Vec<(Sums, usize)> = vec![([0.0; 3], 0)];
    let mut last: Vec<(Sums, usize)> = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        let choices = part.choices(curve, shift);
        if index + 1 == parts.len() {
            last = choices;
        } else {
            let touch = part.touch(shift);
            let least = choices.iter().map(|choice| choice.1).min().unwrap_or(0);
            let touch = if parts.len() > PARTS { least } else { touch.max(least) };
            let kept = choices.iter().filter(|(_, detached)| *detached == least || *detached == touch);
            before = kept.flat_map(|one| before.iter().map(|other| (plus(one.0, other.0), one.1 + other.1))).collect();
        }
    }
    let Whole { count, y, yy } = *whole;
    let share = 1.0 / count;
    let mut found = [None::<Found>; 2];
    for (first, more) in &before {
        for (sums, detached) in &last {
            let detached = detached + more;
            if detached > 0 && !has_tail {
                continue;
            }
            let [p, pp, py] = plus(*first, *sums);
            let e_star = match (given.e_star, given.level) {
                (Some(e_star), _) => e_star,
                (None, true) => py / pp,
                (None, false) => (py * count - p * y) / (pp * count - p * p),
            };
            let baseline = if given.level { 0.0 } else { (y - e_star * p) * share };
            let cost = yy + e_star * (e_star * pp - 2.0 * py) - baseline * baseline * count;
            let best = &mut found[usize::from(detached > 0)];
            if e_star > 0.0 && cost.is_finite() && best.as_ref().is_none_or(|best| cost < best.cost) {
                *best = Some(Found { cost, e_star, length: curve.length, shift, baseline });
            }
        }
    }
    found
}

impl Part<'_> {
    /// The sums of the rows in contact for every number of detached ones that is possible, with that number.
    fn choices(&self, curve: &Curve, shift: f64) -> Vec<(Sums, usize)> {
        let forces = curve.approach.as_ref().filter(|_| self.leg == Leg::Approach).unwrap_or(&curve.retract);
        // Contact is lost on the way out, and found on the way in: rows count from the end that is in contact.
        let rows = self.states.len();
        let mut sums = [0.0; 3];
        let mut choices = Vec::with_capacity(rows + 1);
        choices.push((sums, rows));
        for count in 1..=rows {
            let row = if self.leg == Leg::Retract { count - 1 } else { rows - count };
            let Some(force) = forces.at(self.states[row].depth - shift) else { break };
            sums = plus(sums, [force, force * force, force * self.states[row].force]);
            choices.push((sums, rows - count));
        }
        choices
    }

    /// How many rows lie before the first touch.
    fn touch(&self, shift: f64) -> usize {
        self.states.iter().filter(|state| state.depth < shift).count()
    }
}
