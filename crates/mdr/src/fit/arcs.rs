//! The stable arcs of an observed curve between the folds of X, and the distance of a row to an arc.

use mdr_core::contact::{Control, FoldKind, Material, Result};
use mdr_numeric::curve::Curve;
use mdr_numeric::folds;

use super::contact::{Contact, Point};
use super::observation::Observation;
use super::problem::Kind;

/// How many points of an arc a search begins with.
const SAMPLES: usize = 48;

/// A part of the curve along which X grows with the contact radius.
#[derive(Debug)]
pub(super) struct Arc {
    /// Whether the lower and the upper end are folds, where the arc ends.
    folds: [bool; 2],
    /// Points from the lower to the upper end, or until X is beyond all rows.
    pub(super) samples: Vec<Sample>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) s: f64,
    pub(super) at: [f64; 2],
    tangent: [f64; 2],
}

/// The point of an arc to which a row is compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub(super) s: f64,
    /// The residual, curve minus datum, in units of σ.
    pub(super) residual: f64,
    /// Its derivatives with respect to the place (X, Y) of the curve.
    pub(super) weights: [f64; 2],
    /// Whether it is the end of the arc, which moves with the numbers of the problem.
    pub(super) is_end: bool,
}

/// The scales of X and Y; `None` for vertical distances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    pub(super) x: Option<f64>,
    pub(super) y: f64,
    /// The scale of X for what lies beyond the end of an arc.
    pub(super) beyond: f64,
}

/// Where a curve turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) s: f64,
    pub(super) kind: FoldKind,
    /// Whether it is a fold with a state, not a pole of g.
    is_fold: bool,
}

/// The folds of X(a), by increasing radius.
///
/// # Errors
/// As [`folds::find`].
pub(super) fn turns(contact: &Contact<'_, f64>) -> Result<Vec<Turn>> {
    let material = Material::new(contact.numbers.e_star, contact.numbers.work)?;
    let control = match (contact.observation, contact.numbers.stiffness) {
        (Observation::ForceOfRadius, _) => return Ok(Vec::new()),
        (Observation::ForceOfIndentation, _) => Control::Indentation,
        (Observation::IndentationOfForce | Observation::RadiusOfForce, _) => Control::Force,
        (_, Some(stiffness)) => Control::Machine { stiffness },
        (_, None) => Control::Indentation,
    };
    let found = folds::find(&Curve::new(contact.tip.transform(), &material, &control))?;
    let turn = |is_fold: bool| {
        move |fold: &mdr_core::contact::Instability<f64>| Turn { s: fold.contact_radius, kind: fold.kind, is_fold }
    };
    let mut turns: Vec<Turn> = found.folds.iter().map(turn(true)).chain(found.poles.iter().map(turn(false))).collect();
    turns.sort_by(|one, other| one.s.total_cmp(&other.s));
    Ok(turns)
}

/// Follows folds to nearby numbers of the problem; none when one of them cannot be followed.
pub(super) fn followed(contact: &Contact<'_, f64>, turns: &[Turn]) -> Option<Vec<Turn>> {
    let follow = |turn: &Turn| {
        if !turn.is_fold || contact.tip.transform().kinks().contains(&turn.s) || contact.edge == Some(turn.s) {
            return None;
        }
        let mut s = turn.s;
        for _ in 0..30 {
            let point = contact.point(&s).ok()?;
            let step = point.tangent[0] / contact.curvature(&point).ok()?[0];
            let next = s - step;
            if !(next > 0.5 * turn.s && next < 2.0 * turn.s) {
                return None;
            }
            let done = step.abs() <= 1e-14 * s;
            s = next;
            if done || (step.abs() <= 1e-9 * s) {
                let [curvature, _] = contact.curvature(&contact.point(&s).ok()?).ok()?;
                return ((curvature > 0.0) == (turn.kind == FoldKind::Minimum)).then_some(Turn { s, ..*turn });
            }
        }
        None
    };
    let followed: Vec<Turn> = turns.iter().map(follow).collect::<Option<_>>()?;
    followed.windows(2).all(|pair| pair[0].s < pair[1].s).then_some(followed)
}

/// The arcs that reach into the range of X, the innermost first.
///
/// # Errors
/// Those of the transform.
pub(super) fn arcs(contact: &Contact<'_, f64>, turns: &[Turn], x: [f64; 2]) -> Result<Vec<Arc>> {
    let mut arcs: Vec<Arc> = Vec::new();
    let mut lower: Option<&Turn> = None;
    let rises_first = match turns.first() {
        Some(turn) => turn.kind == FoldKind::Maximum,
        None => contact.point(&scale(contact))?.tangent[0] > 0.0,
    };
    let mut open = rises_first;
    for turn in turns {
        match turn.kind {
            FoldKind::Minimum => (lower, open) = (Some(turn), true),
            FoldKind::Maximum if open => {
                arcs.push(Arc::sampled(contact, lower, Some(turn), x)?);
                (lower, open) = (None, false);
            }
            FoldKind::Maximum => {}
        }
        // Arcs further out begin beyond all rows.
        if arcs.len() > 1 && arcs[arcs.len() - 1].samples[0].at[0] > x[1] {
            arcs.pop();
            return Ok(arcs);
        }
    }
    if open {
        arcs.push(Arc::sampled(contact, lower, None, x)?);
    }
    if arcs.len() > 1 && arcs[arcs.len() - 1].samples[0].at[0] > x[1] {
        arcs.pop();
    }
    Ok(arcs)
}

/// A length of the contact: where Δl is a as a sphere of that radius would have it.
fn scale(contact: &Contact<'_, f64>) -> f64 {
    let length = contact.numbers.work / contact.numbers.e_star;
    contact.tip.transform().outer_radius().map_or(length, |outer| (0.5 * outer).min(length))
}

impl Arc {
    fn sampled(contact: &Contact<'_, f64>, lower: Option<&Turn>, upper: Option<&Turn>, x: [f64; 2]) -> Result<Arc> {
        // A pole and the end of a profile have no value.
        let inner = |turn: &Turn| if turn.is_fold { turn.s } else { turn.s * (1.0 + 1e-12) };
        let outer = |turn: &Turn| if turn.is_fold { turn.s } else { turn.s * (1.0 - 1e-12) };
        let end =
            contact.tip.transform().outer_radius().filter(|_| contact.edge.is_none()).map(|end| end * (1.0 - 1e-12));
        let last = match (upper.map(outer), end) {
            (Some(upper), Some(end)) => Some(upper.min(end)),
            (upper, end) => upper.or(end),
        };
        let first = match lower {
            Some(turn) => inner(turn),
            None => smallest(contact, last, x),
        };
        let last = grown(contact, first, last, x[1])?;
        let folds = [lower.is_some_and(|turn| turn.is_fold), upper.is_some_and(|turn| turn.is_fold && last == turn.s)];
        let ratio = (last / first).ln() / (SAMPLES - 1) as f64;
        let sample = |index: usize| {
            let s = if index + 1 == SAMPLES { last } else { first * (ratio * index as f64).exp() };
            let Point { at, mut tangent, .. } = contact.point(&s)?;
            if index == 0 && tangent[0] < 0.0 {
                tangent = contact.point(&(s * (1.0 + 1e-9)))?.tangent;
            }
            Ok(Sample { s, at, tangent })
        };
        Ok(Arc { folds, samples: (0..SAMPLES).map(sample).collect::<Result<_>>()? })
    }

    fn ends(&self) -> [&Sample; 2] {
        [&self.samples[0], &self.samples[self.samples.len() - 1]]
    }

    /// Its inner end, where it is a fold.
    pub(super) fn inner_fold(&self) -> Option<f64> {
        self.folds[0].then(|| self.samples[0].s)
    }

    /// The point to which a row is compared.
    ///
    /// # Errors
    /// Those of the transform.
    pub(super) fn foot(&self, contact: &Contact<'_, f64>, row: [f64; 2], scales: &Scales) -> Result<Foot> {
        match scales.x {
            None => self.vertical_foot(contact, row, scales),
            Some(x) => self.nearest(contact, row, [x, scales.y]),
        }
    }

    fn vertical_foot(&self, contact: &Contact<'_, f64>, row: [f64; 2], scales: &Scales) -> Result<Foot> {
        let [lower, upper] = self.ends();
        if !(row[0] > lower.at[0] && row[0] < upper.at[0]) {
            let end = if row[0] <= lower.at[0] { lower } else { upper };
            return Ok(foot_at_end(end, row, [scales.beyond, scales.y]));
        }
        let s = self.parameter(contact, row[0])?;
        let Point { at, tangent, .. } = contact.point(&s)?;
        let weights = [-tangent[1] / tangent[0] / scales.y, 1.0 / scales.y];
        Ok(Foot { s, residual: (at[1] - row[1]) / scales.y, weights, is_end: false })
    }

    /// Where X is `x`, between the ends of the arc, by Newton's method within a bracket.
    fn parameter(&self, contact: &Contact<'_, f64>, x: f64) -> Result<f64> {
        let after = self.samples.partition_point(|sample| sample.at[0] <= x).clamp(1, self.samples.len() - 1);
        let [mut low, mut high] = [self.samples[after - 1].s, self.samples[after].s];
        let mut s = guess(&self.samples[after - 1], &self.samples[after], x);
        for _ in 0..80 {
            if !(s > low && s < high) {
                s = 0.5 * (low + high);
            }
            let Point { at, tangent, .. } = contact.point(&s)?;
            let excess = at[0] - x;
            *if excess > 0.0 { &mut high } else { &mut low } = s;
            let next = s - excess / tangent[0];
            if (next - s).abs() <= 1e-9 * s && next > low && next < high {
                return Ok(next);
            }
            if excess == 0.0 || high - low <= 4.0 * f64::EPSILON * s {
                return Ok(s);
            }
            s = next;
        }
        Ok(s)
    }

    /// The nearest point in units of the scales, the ends included.
    fn nearest(&self, contact: &Contact<'_, f64>, row: [f64; 2], scales: [f64; 2]) -> Result<Foot> {
        let (segment, start) = self.nearest_segment(row, scales);
        let away = |sample: &Sample| slope_of_distance(sample.at, sample.tangent, row, scales);
        // The distance falls towards a minimum from both sides of it.
        let mut low = segment;
        while low > 0 && away(&self.samples[low]) > 0.0 {
            low -= 1;
        }
        let mut high = segment + 1;
        while high + 1 < self.samples.len() && away(&self.samples[high]) < 0.0 {
            high += 1;
        }
        let [lower, upper] = self.ends();
        if low == 0 && away(lower) >= 0.0 {
            return Ok(foot_at_end(lower, row, scales));
        }
        if high + 1 == self.samples.len() && away(upper) <= 0.0 {
            return Ok(foot_at_end(upper, row, scales));
        }
        let bracket = [self.samples[low].s, self.samples[high].s];
        let point = minimum(contact, row, scales, bracket, start)?;
        Ok(normal_foot(point, row, scales))
    }

    /// The nearest segment of the polyline through the samples, and the parameter of the nearest point on it.
    fn nearest_segment(&self, row: [f64; 2], scales: [f64; 2]) -> (usize, f64) {
        let mut best = (f64::INFINITY, 0, self.samples[0].s);
        for (index, pair) in self.samples.windows(2).enumerate() {
            let from = scaled(pair[0].at, row, scales);
            let to = scaled(pair[1].at, row, scales);
            let along = [to[0] - from[0], to[1] - from[1]];
            let length = along[0] * along[0] + along[1] * along[1];
            let share = (-(from[0] * along[0] + from[1] * along[1]) / length).clamp(0.0, 1.0);
            let [x, y] = [from[0] + share * along[0], from[1] + share * along[1]];
            let distance = x * x + y * y;
            if distance < best.0 {
                best = (distance, index, pair[0].s + share * (pair[1].s - pair[0].s));
            }
        }
        (best.1, best.2)
    }

    /// How the place of the foot moves with a number of the problem: at a fixed parameter, and with the end where it is one.
    ///
    /// # Errors
    /// Those of the transform.
    pub(super) fn partial(
        &self,
        contact: &Contact<'_, f64>,
        kind: Kind,
        foot: &Foot,
        point: &Point<f64>,
    ) -> Result<[f64; 2]> {
        let mut partial = contact.partial(kind, point)?;
        if foot.is_end && self.is_fold(foot.s) {
            let speed = end_speed(contact, kind, point)?;
            partial[0] += point.tangent[0] * speed;
            partial[1] += point.tangent[1] * speed;
        }
        Ok(partial)
    }

    /// Whether a parameter is that of an end which is a fold.
    pub(super) fn is_fold(&self, s: f64) -> bool {
        let [lower, upper] = self.ends();
        (self.folds[0] && lower.s == s) || (self.folds[1] && upper.s == s)
    }
}

/// How fast a fold moves along the curve with a number of the problem: −∂X'/X''; or with a kink or a vertical edge that it is at.
///
/// # Errors
/// Those of the transform.
pub(super) fn end_speed(contact: &Contact<'_, f64>, kind: Kind, point: &Point<f64>) -> Result<f64> {
    if contact.edge == Some(point.a) {
        // At the edge the partial derivatives are at a fixed contact radius; the edge moves with the number that is its radius.
        let moved = contact.edge_partial(kind);
        return Ok(moved);
    }
    let kinks = contact.tip.transform().kinks();
    if kinks.contains(&point.a) {
        return Ok(contact.kink_partial(kind, &point.a));
    }
    Ok(-contact.x_slope_partial(kind, point)? / contact.curvature(point)?[0])
}

fn scaled(at: [f64; 2], row: [f64; 2], scales: [f64; 2]) -> [f64; 2] {
    [(at[0] - row[0]) / scales[0], (at[1] - row[1]) / scales[1]]
}

/// Half the derivative of the squared distance along the curve.
fn slope_of_distance(at: [f64; 2], tangent: [f64; 2], row: [f64; 2], scales: [f64; 2]) -> f64 {
    let [x, y] = scaled(at, row, scales);
    x * tangent[0] / scales[0] + y * tangent[1] / scales[1]
}

/// The minimum of the distance in a bracket, by the secant method with bisection.
fn minimum(
    contact: &Contact<'_, f64>,
    row: [f64; 2],
    scales: [f64; 2],
    [mut low, mut high]: [f64; 2],
    start: f64,
) -> Result<(f64, Point<f64>)> {
    let mut s = start;
    let mut before: Option<[f64; 2]> = None;
    for round in 0..100 {
        if !(s > low && s < high) || round % 10 == 9 {
            s = 0.5 * (low + high);
        }
        let point = contact.point(&s)?;
        let slope = slope_of_distance(point.at, point.tangent, row, scales);
        *if slope > 0.0 { &mut high } else { &mut low } = s;
        let [x, y] = [point.tangent[0] / scales[0], point.tangent[1] / scales[1]];
        // The curvature of the curve counts as soon as two slopes are known.
        let steepness = match before {
            Some([s0, slope0]) if s0 != s && (slope - slope0) / (s - s0) > 0.0 => (slope - slope0) / (s - s0),
            _ => x * x + y * y,
        };
        let next = s - slope / steepness;
        if slope == 0.0 || (next - s).abs() <= 1e-14 * s || high - low <= 4.0 * f64::EPSILON * s {
            return Ok((s, point));
        }
        before = Some([s, slope]);
        s = next;
    }
    let point = contact.point(&s)?;
    Ok((s, point))
}

/// The foot of a perpendicular.
fn normal_foot((s, point): (f64, Point<f64>), row: [f64; 2], scales: [f64; 2]) -> Foot {
    let [x, y] = scaled(point.at, row, scales);
    let normal = normal(point.tangent, scales);
    let residual = x * normal[0] + y * normal[1];
    Foot { s, residual, weights: [normal[0] / scales[0], normal[1] / scales[1]], is_end: false }
}

/// The unit normal of a curve in units of the scales, upwards.
fn normal(tangent: [f64; 2], scales: [f64; 2]) -> [f64; 2] {
    let [x, y] = [tangent[0] / scales[0], tangent[1] / scales[1]];
    let length = x.hypot(y);
    [-y / length, x / length]
}

/// The end of an arc as the nearest point.
fn foot_at_end(end: &Sample, row: [f64; 2], scales: [f64; 2]) -> Foot {
    let [x, y] = scaled(end.at, row, scales);
    let distance = x.hypot(y);
    let normal = normal(end.tangent, scales);
    if distance == 0.0 {
        return Foot { s: end.s, residual: 0.0, weights: [normal[0] / scales[0], normal[1] / scales[1]], is_end: true };
    }
    let sign = if x * normal[0] + y * normal[1] < 0.0 { -1.0 } else { 1.0 };
    let weights = [sign * x / distance / scales[0], sign * y / distance / scales[1]];
    Foot { s: end.s, residual: sign * distance, weights, is_end: true }
}

/// Where X is `x` between two samples, by the cubic in s² − s₀² that a fold looks like, else linearly.
fn guess(low: &Sample, high: &Sample, x: f64) -> f64 {
    let share = (x - low.at[0]) / (high.at[0] - low.at[0]);
    let width = high.s - low.s;
    let [start, end] = [low.tangent[0] * width, high.tangent[0] * width].map(|slope| slope / (high.at[0] - low.at[0]));
    // X is nearly a parabola between samples: share = start·t + (1 − start) t².
    let bend = 1.0 - start;
    let root = (start * start + 4.0 * bend * share).sqrt();
    let t = 2.0 * share / (start + root);
    if t.is_finite() && end.is_finite() { low.s + t.clamp(0.0, 1.0) * width } else { low.s + share * width }
}

/// A radius below all rows, for an arc that begins at the tip.
fn smallest(contact: &Contact<'_, f64>, last: Option<f64>, x: [f64; 2]) -> f64 {
    let mut s = last.unwrap_or_else(|| scale(contact));
    if contact.observation == Observation::ForceOfRadius {
        return 0.5 * x[0].max(1e-6 * x[1]);
    }
    for _ in 0..60 {
        s *= 0.5;
        if contact.point(&s).is_ok_and(|point| point.at[0] <= x[0]) {
            break;
        }
    }
    s
}

/// The radius at which X is beyond all rows, or the end of the arc.
fn grown(contact: &Contact<'_, f64>, first: f64, last: Option<f64>, x: f64) -> Result<f64> {
    let (mut s, mut step) = (first, 0.02);
    loop {
        let next = s * (1.0 + step);
        match last {
            Some(last) if next >= last => return Ok(last),
            _ => s = next,
        }
        if contact.point(&s)?.at[0] > x || s > 1e40 * first {
            return Ok(s);
        }
        step *= 1.5;
    }
}
