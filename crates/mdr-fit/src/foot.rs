//! The point of an arc with which a row is compared.

use mdr_core::contact::Result;

use super::arcs::{Arc, Sample};
use super::contact::{Contact, Point};

/// A step of the secant method, relative to the radius, after which none is needed.
const NEAR: f64 = 1e-8;

/// What a step of Newton's method may leave, relative to the radius: far below the rounding of a double, since the curvature is that
/// between two samples, and so that what is linear along the step needs no further state.
const LEFT: f64 = 1e-22;

/// The least curvature X''s/2X' of a segment that is reckoned with: two slopes are alike on both sides of an inflection too.
const STRAIGHT: f64 = 1e-2;

/// The most rounds of Newton's method, some of which are bisections.
const ROUNDS: usize = 80;

/// The slope of X in a segment, against its mean, from which on the segment has no fold beside it.
const STEEP: f64 = 0.5;

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
    /// The scale of X for points beyond the end of an arc.
    pub(super) beyond: f64,
}

/// A place of an arc with a given X.
struct Place {
    s: f64,
    y: f64,
    tangent: [f64; 2],
}

impl Arc {
    /// The point to which a row is compared. X of the row is looked for first in the segment before the sample `near`, which becomes that
    /// of the row: rows are mostly beside those before them.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn foot(
        &self,
        contact: &Contact<'_, f64>,
        row: [f64; 2],
        scales: &Scales,
        near: &mut usize,
    ) -> Result<Foot> {
        match scales.x {
            None => self.vertical_foot(contact, row, scales, near),
            Some(x) => self.nearest(contact, row, [x, scales.y]),
        }
    }

    fn vertical_foot(
        &self,
        contact: &Contact<'_, f64>,
        row: [f64; 2],
        scales: &Scales,
        near: &mut usize,
    ) -> Result<Foot> {
        let [lower, upper] = self.ends();
        if !(row[0] > lower.at[0] && row[0] < upper.at[0]) {
            let end = if row[0] <= lower.at[0] { lower } else { upper };
            return Ok(foot_at_end(end, row, [scales.beyond, scales.y]));
        }
        let Place { s, y, tangent } = self.at(contact, row[0], near)?;
        let weights = [-tangent[1] / tangent[0] / scales.y, 1.0 / scales.y];
        Ok(Foot { s, residual: (y - row[1]) / scales.y, weights, is_end: false })
    }

    /// Where X is `x`, between the ends of the arc.
    pub(super) fn parameter(&self, contact: &Contact<'_, f64>, x: f64) -> Result<f64> {
        self.at(contact, x, &mut 0).map(|place| place.s)
    }

    /// The sample after X: that which is `near`, if it is.
    fn after(&self, x: f64, near: usize) -> usize {
        let is_here = |place: usize| {
            let (before, after) = (self.samples.get(place.wrapping_sub(1)), self.samples.get(place));
            before.zip(after).is_some_and(|(before, after)| before.at[0] <= x && x < after.at[0])
        };
        if is_here(near) {
            return near;
        }
        self.samples.partition_point(|sample| sample.at[0] <= x).clamp(1, self.samples.len() - 1)
    }

    /// The place at which X is `x`, between the ends of the arc, by Newton's method within a bracket; `near` is the sample after it.
    fn at(&self, contact: &Contact<'_, f64>, x: f64, near: &mut usize) -> Result<Place> {
        *near = self.after(x, *near);
        let [before, after] = [&self.samples[*near - 1], &self.samples[*near]];
        let [mut low, mut high] = [before.s, after.s];
        // What a step leaves is the curvature of X times half the square of the step.
        let seen = 0.5 * ((after.tangent[0] - before.tangent[0]) / (high - low)).abs();
        let bend = seen.max(STRAIGHT * after.tangent[0].max(before.tangent[0]) / high);
        let mut s = guess(before, after, x);
        for _ in 0..ROUNDS {
            if !(s > low && s < high) {
                s = 0.5 * (low + high);
            }
            let Point { at, tangent, .. } = contact.point(&s)?;
            let excess = at[0] - x;
            *if excess > 0.0 { &mut high } else { &mut low } = s;
            let step = excess / tangent[0];
            let next = s - step;
            // A step below the rounding of s stays at an end of the bracket.
            if bend * step * step <= LEFT * s * tangent[0] && next >= low && next <= high {
                return Ok(Place { s: next, y: at[1] - tangent[1] * step, tangent });
            }
            if excess == 0.0 || high - low <= 4.0 * f64::EPSILON * s {
                return Ok(Place { s, y: at[1], tangent });
            }
            s = next;
        }
        let Point { at, tangent, .. } = contact.point(&s)?;
        Ok(Place { s, y: at[1], tangent })
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

    /// The nearest segment of the polyline through the samples, and the parameter of the nearest point on it. X grows along the
    /// arc, so a segment further in X than the best distance is not measured, nor any beyond it.
    fn nearest_segment(&self, row: [f64; 2], scales: [f64; 2]) -> (usize, f64) {
        let middle = self.samples.partition_point(|sample| sample.at[0] <= row[0]).clamp(1, self.samples.len() - 1) - 1;
        let mut best = (f64::INFINITY, middle, self.samples[middle].s);
        let mut measure = |index: usize, nearer_end: usize| {
            let ahead = scaled(self.samples[nearer_end].at, row, scales)[0];
            let is_beyond = if nearer_end == index { ahead > 0.0 } else { ahead < 0.0 };
            if is_beyond && ahead * ahead > best.0 {
                return false;
            }
            let [start, end] = [&self.samples[index], &self.samples[index + 1]];
            let [from, to] = [start, end].map(|sample| scaled(sample.at, row, scales));
            let along = [to[0] - from[0], to[1] - from[1]];
            let length = along[0] * along[0] + along[1] * along[1];
            let share = (-(from[0] * along[0] + from[1] * along[1]) / length).clamp(0.0, 1.0);
            let [x, y] = [from[0] + share * along[0], from[1] + share * along[1]];
            let distance = x * x + y * y;
            if distance < best.0 {
                best = (distance, index, start.s + share * (end.s - start.s));
            }
            true
        };
        for index in middle..self.samples.len() - 1 {
            if !measure(index, index) {
                break;
            }
        }
        for index in (0..middle).rev() {
            if !measure(index, index + 1) {
                break;
            }
        }
        (best.1, best.2)
    }
}

fn scaled(at: [f64; 2], row: [f64; 2], scales: [f64; 2]) -> [f64; 2] {
    [(at[0] - row[0]) / scales[0], (at[1] - row[1]) / scales[1]]
}

/// Half the derivative of the squared distance along the curve.
fn slope_of_distance(at: [f64; 2], tangent: [f64; 2], row: [f64; 2], scales: [f64; 2]) -> f64 {
    let [x, y] = scaled(at, row, scales);
    x * tangent[0] / scales[0] + y * tangent[1] / scales[1]
}

/// The minimum of the distance in a bracket, by the secant method with bisection. After a step as small as NEAR the remainder is
/// rounding.
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
        if slope == 0.0 || high - low <= 4.0 * f64::EPSILON * s {
            return Ok((s, point));
        }
        let is_near = (next - s).abs() <= NEAR * s;
        before = Some([s, slope]);
        s = next;
        if is_near && s > low && s < high {
            break;
        }
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

/// The fold at which an arc ends, for a row whose X is held there: the distance in Y.
pub(super) fn at_fold(end: &Sample, row: [f64; 2], y_scale: f64) -> Foot {
    Foot { s: end.s, residual: (end.at[1] - row[1]) / y_scale, weights: [0.0, 1.0 / y_scale], is_end: true }
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

/// Where X is `x` between two samples: by the cubic that has their slopes ds/dX; beside a fold, where there are none, by the parabola
/// that X looks like there.
fn guess(low: &Sample, high: &Sample, x: f64) -> f64 {
    let (width, rise) = (high.s - low.s, high.at[0] - low.at[0]);
    let share = (x - low.at[0]) / rise;
    let [start, end] = [low.tangent[0] * width / rise, high.tangent[0] * width / rise];
    let t = if start > STEEP && end > STEEP {
        let (rest, product) = (1.0 - share, share * (1.0 - share));
        share * share * (1.0 + 2.0 * rest) + product * (rest / start - share / end)
    } else {
        // share = start·t + (1 − start) t².
        2.0 * share / (start + (start * start + 4.0 * (1.0 - start) * share).sqrt())
    };
    low.s + if t.is_finite() { t.clamp(0.0, 1.0) } else { share } * width
}

#[cfg(test)]
mod tests {
    use super::super::arcs;
    use super::super::contact::{Numbers, Tip};
    use super::super::observation::Observation;
    use super::super::problem::Problem;
    use super::*;
    use mdr_core::contact::Shape;

    #[test]
    fn feet_do_not_depend_on_how_fine_an_arc_is() {
        let tip = Shape::Paraboloid { radius: "1e-5" };
        let x: Vec<f64> = (0..400).map(|index| 1.5e-6 - 5e-9 * f64::from(index)).collect();
        let problem = Problem::new(tip, Observation::ForceOfIndentation, &x, &x).unwrap();
        let mut numbers = Numbers::of(&problem, |_| 0.0, || 0.0);
        (numbers.e_star, numbers.work, numbers.profile) = (2e6, 0.05, vec![1e-5]);
        let tip = Tip::new(&problem, (), &numbers.profile, &[]).unwrap();
        let contact = Contact::new(&tip, numbers, Observation::ForceOfIndentation);
        let turns = arcs::turns(&contact).unwrap();
        let [coarse, fine] = [1, 16].map(|fineness| arcs::arcs(&contact, &turns, [x[399], x[0]], fineness).unwrap());
        let drawn = [&coarse[0], &fine[0]].map(|arc| arc.drawn().map(|sample| sample.s).collect::<Vec<_>>());
        assert_eq!(drawn[0].len(), drawn[1].len());
        assert!(drawn[0].iter().zip(&drawn[1]).all(|(one, other)| (one - other).abs() < 1e-13 * one));
        let scales = Scales { x: None, y: 1e-8, beyond: 1e-9 };
        let (mut near, mut compared) = ([0, 0], 0);
        for x in x {
            let [one, other] = [(&coarse, 0), (&fine, 1)]
                .map(|(arcs, place)| arcs[0].foot(&contact, [x, 0.0], &scales, &mut near[place]).unwrap());
            assert_eq!(one.is_end, other.is_end, "{x}");
            if one.is_end {
                continue;
            }
            assert!((contact.point(&one.s).unwrap().at[0] - x).abs() < 1e-21, "{x}");
            assert!((one.s - other.s).abs() < 1e-13 * one.s, "{x}: {} and {}", one.s, other.s);
            assert!((one.residual - other.residual).abs() < 1e-9, "{x}");
            compared += 1;
        }
        assert!(compared > 300, "{compared}");
    }
}
