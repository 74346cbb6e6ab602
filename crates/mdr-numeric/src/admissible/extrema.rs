//! The monotone pieces of g, and the intervals on which it is below an indentation.

use std::sync::{Arc, OnceLock};

use mdr_core::contact::{Result, Transform};

use super::gap::Node;
use crate::survey::{self, Range};

/// A radius, with its g, where g or the sign of its slope may change; between two of them g is monotone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) x: f64,
    pub(super) g: f64,
}

/// g between edges, in double precision.
pub(super) struct Terrain {
    pub(super) transform: Arc<dyn Transform<f64>>,
    /// By increasing radius. Beyond the last one g increases, or is not defined.
    pub(super) edges: Vec<Edge>,
    /// The least g from an edge on.
    least: Vec<f64>,
    /// Whether the search resolved g everywhere.
    pub(super) resolved: bool,
    /// The largest distance between two radii at which the search has seen g, over the smaller one.
    pub(super) width: f64,
    /// The radii between which the search was made.
    searched: [f64; 2],
    /// Nodes between an edge and the next one, evaluated once.
    pub(super) panels: Vec<OnceLock<Result<Vec<Node>>>>,
}

/// The relative distance at which g is sampled beside a radius where it diverges.
const BESIDE: f64 = 1e-12;
/// The factor on the relative slope of g, so that the search keeps a margin where the slope is of order one.
const MARGIN: f64 = 1024.0;
/// The start of a search in ln x above its lower end.
const HALF_WAY: f64 = 32.0;
/// Bisection steps to the ends of an interval.
const HALVINGS: usize = 44;
/// Fractions of a piece at which the gap is sampled, apart from the ends of the interval.
const SAMPLES: [f64; 4] = [0.15, 0.5, 0.85, 1.0];
/// A sample is refined only if a neighbour exceeds it by more than this share: rounding makes a valley of each sample of a gap that is
/// constant over hundreds of octaves.
const FLAT: f64 = 1e-9;

impl Terrain {
    pub(super) fn new(transform: Arc<dyn Transform<f64>>, [lower, upper]: [f64; 2]) -> Self {
        let outer = transform.outer_radius();
        let kinks = transform.kinks();
        let upper = kinks.last().map_or(upper, |kink| upper.max(2.0 * kink));
        let upper = outer.unwrap_or(upper);
        let scale = upper.min(lower * HALF_WAY.exp());
        // x g' relative to lengths that do not oscillate with it, plus one: the ratio passes one where g' changes its
        // sign, and is far from it elsewhere.
        let ratio = |x: &f64| {
            let size = transform.g(x)?.hypot(transform.g(&(x / 2.0))?);
            Ok(1.0 + MARGIN * (transform.slope(x)? / size * x))
        };
        // Where g is constant up to rounding its direction does not matter.
        let reach = [(scale / lower).ln(), (upper / scale).ln()];
        let found = survey::crossings(&Range { reach, ..Range::whole(&*transform, scale) }, ratio).unwrap_or_default();
        let (resolved, width) = (found.resolved, found.widest.exp_m1());
        let searched = [lower, upper];
        let mut radii = kinks.clone();
        for crossing in &found.crossings {
            if !kinks.iter().any(|kink| *kink >= crossing.lower && *kink <= crossing.upper) {
                radii.push(turning_point(&*transform, crossing.lower, crossing.upper, crossing.rising));
            }
        }
        radii.sort_by(f64::total_cmp);
        let terrain =
            Terrain { transform, edges: Vec::new(), least: Vec::new(), resolved, width, searched, panels: Vec::new() };
        let mut terrain = terrain.with_edges(&radii, upper);
        // Where the work was ended on the way, edges may be missing or misplaced.
        terrain.resolved &= !terrain.transform.g(&scale).is_err_and(|error| error.is_interruption());
        terrain
    }

    /// The edges at ascending radii, and beyond `upper` where g falls there.
    fn with_edges(self, radii: &[f64], upper: f64) -> Self {
        let mut terrain = self;
        for radius in in_octaves(radii) {
            terrain.push(radius);
        }
        terrain.extend_outwards(upper);
        terrain.least = terrain
            .edges
            .iter()
            .rev()
            .scan(f64::INFINITY, |least, edge| {
                *least = least.min(edge.g);
                Some(*least)
            })
            .collect();
        terrain.least.reverse();
        terrain.panels = terrain.edges.iter().skip(1).map(|_| OnceLock::new()).collect();
        terrain
    }

    /// Adds an edge if g can be computed at it or beside it; the smaller value if g jumps.
    fn push(&mut self, x: f64) {
        let g = |x: f64| self.transform.g(&x).ok().filter(|g| !g.is_nan());
        let beside = || [x * (1.0 - BESIDE), x * (1.0 + BESIDE)].into_iter().filter_map(g).reduce(f64::min);
        if let Some(g) = g(x).or_else(beside) {
            self.edges.push(Edge { x, g });
        }
    }

    /// Adds the end of the profile, and radii further out while g decreases.
    fn extend_outwards(&mut self, from: f64) {
        if let Some(outer) = self.transform.outer_radius() {
            return self.push(outer);
        }
        for octaves in (0..10).map(|power| 1 << power) {
            let x = from * 2f64.powi(octaves);
            let before = self.edges.len();
            if !(x < f64::MAX / 1024.0) {
                break;
            }
            self.push(x);
            let falls = matches!(self.edges[..], [.., before, last] if last.g < before.g)
                || matches!(self.edges[..], [only] if only.g < 0.0);
            if !falls {
                self.edges.truncate(before);
                break;
            }
        }
    }

    /// Whether g is covered outside a contact radius: where its extrema were searched, and beyond if some samples increase.
    pub(super) fn knows(&self, a: f64) -> bool {
        let g = |x: f64| self.transform.g(&x).ok();
        let rises = || {
            let samples: Vec<_> = (0..16).map(|i| g(a * 2f64.powf(f64::from(i) / 4.0))).collect();
            samples.windows(2).all(|pair| matches!(pair, [Some(inner), Some(outer)] if inner <= outer))
        };
        self.resolved && a >= self.searched[0] && (a <= self.searched[1] || rises())
    }

    /// The least g at the edges from an index on.
    fn least_from(&self, index: usize) -> f64 {
        self.least.get(index).copied().unwrap_or(f64::INFINITY)
    }

    /// The radius of the narrowest gap outside a contact, and that gap by the fast rule; `None` if g is nowhere less
    /// than d. With `any` the first gap that is clearly negative is returned.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn narrowest(&self, a: f64, d: f64, any: bool) -> Result<Option<(f64, f64)>> {
        if self.transform.outer_radius().is_some_and(|outer| a >= outer) {
            return Ok(None);
        }
        let mut next = self.edges.partition_point(|edge| edge.x <= a);
        let mut before = Edge { x: a, g: if a > 0.0 { self.transform.g(&a)? } else { 0.0 } };
        let mut best: Option<(f64, f64)> = None;
        while before.g < d || self.least_from(next) < d {
            let Some(first) = self.edges[next..].iter().position(|edge| edge.g < d).map(|i| next + i) else {
                return Ok(best);
            };
            if first > next {
                before = self.edges[first - 1];
            }
            let end = self.edges[first..].iter().position(|edge| !(edge.g < d)).map_or(self.edges.len(), |i| first + i);
            let mut radii = vec![if before.g > d { self.reach(d, before.x, self.edges[first].x) } else { before.x }];
            radii.extend(self.edges[first..end].iter().map(|edge| edge.x));
            let last = self.edges[end - 1];
            match self.edges.get(end) {
                Some(after) => radii.push(self.reach(d, last.x, after.x)),
                None => radii.extend(self.reach_outwards(d, last.x)),
            }
            let depth = self.edges[first..end].iter().fold(before.g - d, |depth, edge| depth.max(d - edge.g));
            let found = self.narrowest_on(&in_octaves(&radii), a, d)?;
            if best.is_none_or(|best| found.1 < best.1) {
                best = Some(found);
            }
            if any && found.1 < -super::gap::COARSE * depth {
                return Ok(best);
            }
            before = self.edges.get(end).copied().unwrap_or(last);
            next = end + 1;
            if end >= self.edges.len() {
                return Ok(best);
            }
        }
        Ok(best)
    }

    /// The radius between two at which g = d.
    fn reach(&self, d: f64, mut lower: f64, mut upper: f64) -> f64 {
        let above = |x: f64| self.transform.g(&x).is_ok_and(|g| g > d);
        let at_upper = above(upper);
        for _ in 0..HALVINGS {
            let middle = if upper > 2.0 * lower { (lower * upper).sqrt() } else { lower + (upper - lower) / 2.0 };
            if !(middle > lower && middle < upper) {
                break;
            }
            if above(middle) == at_upper { upper = middle } else { lower = middle }
        }
        lower
    }

    /// The radius beyond the last edge where g has increased to d; `None` if g ends there.
    fn reach_outwards(&self, d: f64, last: f64) -> Option<f64> {
        let steps = (0..).map(|power| last * 2f64.powi(1 << power)).take_while(|x| *x < f64::MAX / 1024.0);
        let beyond = steps.map_while(|x| Some((x, self.transform.g(&x).ok()?))).find(|(_, g)| *g > d);
        beyond.map(|(x, _)| self.reach(d, last, x))
    }

    /// The narrowest gap on an interval: the samples that are least among their neighbours, refined between these.
    fn narrowest_on(&self, radii: &[f64], a: f64, d: f64) -> Result<(f64, f64)> {
        let ends: Vec<f64> = radii.iter().copied().filter(|r| *r > a).collect();
        let first = radii.first().filter(|first| **first > a).into_iter().copied();
        let within = radii.windows(2).flat_map(|pair| SAMPLES.map(|share| pair[0] + share * (pair[1] - pair[0])));
        let mut samples: Vec<(f64, f64)> = Vec::new();
        for r in first.chain(within).filter(|r| *r > a) {
            samples.push((r, self.gap(a, d, r)?));
        }
        // Of two valleys the deeper one may have the higher sample, so each is refined.
        let mut best: Option<(f64, f64)> = None;
        for (i, sample) in samples.iter().enumerate() {
            let [before, after] = [i.saturating_sub(1), (i + 1).min(samples.len() - 1)].map(|i| samples[i]);
            if sample.1 > before.1 || sample.1 > after.1 {
                continue;
            }
            let is_flat = [before, after].iter().all(|other| other.1 - sample.1 <= FLAT * sample.1.abs());
            let found =
                if is_flat { *sample } else { self.least_between(before.0, after.0, *sample, |r| self.gap(a, d, r))? };
            if best.is_none_or(|best| found.1 < best.1) {
                best = Some(found);
            }
        }
        Ok(best.unwrap_or((ends.last().copied().unwrap_or(a), 0.0)))
    }

    /// The minimum of a function between two radii, by parabolas through three points and sections where they do not help (Brent).
    pub(super) fn least_between(
        &self,
        mut lower: f64,
        mut upper: f64,
        mut best: (f64, f64),
        f: impl Fn(f64) -> Result<f64>,
    ) -> Result<(f64, f64)> {
        const SECTION: f64 = 0.381_966_011_250_105;
        const NEAR: f64 = 1e-8;
        let (mut second, mut third) = (best, best);
        let mut steps = [upper - lower; 2];
        for _ in 0..40 {
            let near = NEAR * upper;
            let middle = lower + (upper - lower) / 2.0;
            if (best.0 - middle).abs() + (upper - lower) / 2.0 <= 2.0 * near {
                break;
            }
            let parabola = vertex(best, second, third)
                .filter(|r| *r > lower && *r < upper && (r - best.0).abs() < steps[0].abs() / 2.0);
            let rest = if best.0 < middle { upper - best.0 } else { lower - best.0 };
            let step = parabola.map_or(SECTION * rest, |r| r - best.0);
            let step = if step.abs() < near { near.copysign(step) } else { step };
            steps = [steps[1], step];
            let r = best.0 + step;
            if !(r > lower && r < upper) {
                break;
            }
            let found = (r, f(r)?);
            if found.1 <= best.1 {
                if r > best.0 {
                    lower = best.0
                } else {
                    upper = best.0
                }
                (third, second, best) = (second, best, found);
            } else {
                if r > best.0 {
                    upper = r
                } else {
                    lower = r
                }
                if found.1 <= second.1 || second.0 == best.0 {
                    (third, second) = (second, found);
                } else if found.1 <= third.1 || third.0 == best.0 || third.0 == second.0 {
                    third = found;
                }
            }
        }
        Ok(best)
    }
}

/// The vertex of the parabola through three points; `None` if they are on a line.
fn vertex(best: (f64, f64), second: (f64, f64), third: (f64, f64)) -> Option<f64> {
    let [to_second, to_third] = [second, third].map(|point| best.0 - point.0);
    let [one, other] = [to_second * (best.1 - third.1), to_third * (best.1 - second.1)];
    let r = best.0 - 0.5 * (to_second * one - to_third * other) / (one - other);
    Some(r).filter(|r| r.is_finite())
}

/// The turning point of g between two radii, by the sign of its slope.
fn turning_point(transform: &dyn Transform<f64>, mut lower: f64, mut upper: f64, rising: bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = lower + (upper - lower) / 2.0;
        if !(middle > lower && middle < upper) {
            break;
        }
        let rises = transform.slope(&middle).is_ok_and(|slope| slope >= 0.0);
        if rises == rising { upper = middle } else { lower = middle }
    }
    lower + (upper - lower) / 2.0
}

/// Ascending radii with intermediate ones, none more than an octave from the next.
pub(super) fn in_octaves(radii: &[f64]) -> Vec<f64> {
    let mut dense: Vec<f64> = Vec::with_capacity(radii.len());
    for &radius in radii {
        while let Some(&last) = dense.last().filter(|last| 2.0 * **last < radius && **last > 0.0) {
            dense.push(2.0 * last);
        }
        if dense.last().is_none_or(|last| *last < radius) {
            dense.push(radius);
        }
    }
    dense
}
