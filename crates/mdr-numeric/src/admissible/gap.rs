//! The gap outside a contact: a fast rule that shares its evaluations between states, and an integral to full
//! precision.

use std::sync::{Arc, LazyLock};

use mdr_core::calculus::gauss_jacobi::{self, GaussRule};
use mdr_core::calculus::quadrature::{Node as Abscissa, pieces, tanh_sinh_near_ends};
use mdr_core::calculus::{Estimate, Tolerance, roundoff_tolerance};
use mdr_core::contact::{Error, Result, Transform};
use mdr_core::number::Real;

use super::extrema::{Terrain, in_octaves};

/// g at a node of a panel, with the weight of the node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    x: f64,
    g: f64,
    weight: f64,
}

/// The fraction of g − d below which the sign of a gap by the fast rule is not trusted.
pub(super) const COARSE: f64 = 1e-3;
/// Nodes per panel. Between two extrema of g the relative error of a polynomial of this degree is below a millionth.
const NODES: usize = 16;
/// The number of octaves below the upper end in which g is integrated separately.
const OCTAVES: i32 = 40;
/// Roundings of g and d in a gap, in unit roundoffs.
const ROUNDINGS: f64 = 64.0;

static RULE: LazyLock<Option<Arc<GaussRule<f64>>>> = LazyLock::new(|| gauss_jacobi::rule(NODES, &0.0, &0.0).ok());

impl Terrain {
    /// The gap at r > a by the fast rule, in m; a may be 0.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn gap(&self, a: f64, d: f64, r: f64) -> Result<f64> {
        let first = self.edges.partition_point(|edge| edge.x <= a);
        let last = self.edges.partition_point(|edge| edge.x < r);
        if first >= last {
            return Ok(self.afresh(a, r, d, r)? * std::f64::consts::FRAC_2_PI);
        }
        let mut sum = self.afresh(a, self.edges[first].x, d, r)? + self.afresh(self.edges[last - 1].x, r, d, r)?;
        for (index, pair) in self.edges[first..last].windows(2).enumerate() {
            let (lower, upper) = (pair[0].x, pair[1].x);
            if r - upper < (upper - lower) / 2.0 {
                sum += self.afresh(lower, upper, d, r)?;
                continue;
            }
            for node in self.panel(first + index)? {
                let share = node.x / r;
                sum += node.weight * (node.g - d) / (r * ((1.0 - share) * (1.0 + share)).sqrt());
            }
        }
        Ok(sum * std::f64::consts::FRAC_2_PI)
    }

    /// The nodes between an edge and the next.
    fn panel(&self, index: usize) -> Result<&[Node]> {
        let nodes = self.panels[index].get_or_init(|| {
            let (lower, width) = (self.edges[index].x, self.edges[index + 1].x - self.edges[index].x);
            let nodes = RULE.iter().flat_map(|rule| rule.nodes());
            let node = |node: &gauss_jacobi::GaussNode<f64>| {
                let x = lower + width * node.t;
                Ok(Node { x, g: self.transform.g(&x)?, weight: width * node.weight })
            };
            nodes.map(node).collect()
        });
        nodes.as_ref().map(Vec::as_slice).map_err(Clone::clone)
    }

    /// ∫ (g − d)/√(r² − x²) dx over a part of (0, r), octave by octave in the angle arccos(x/r). Radii more than
    /// [`OCTAVES`] octaves below the upper end are one part, with some 2⁻⁴⁰ of the weight.
    fn afresh(&self, from: f64, to: f64, d: f64, r: f64) -> Result<f64> {
        let innermost = to * 2f64.powi(-OCTAVES);
        let mut ends = in_octaves(&[from.max(innermost), to]);
        if from < innermost {
            ends.insert(0, from);
        }
        let angle = |x: f64| ((r - x).sqrt() * (r + x).sqrt()).atan2(x);
        let mut sum = 0.0;
        for pair in ends.windows(2) {
            let (most, least) = (angle(pair[0]), angle(pair[1]));
            for node in RULE.iter().flat_map(|rule| rule.nodes()) {
                let x = (r * (least + (most - least) * node.t).cos()).clamp(pair[0], pair[1]);
                let g = if x > 0.0 { self.transform.g(&x)? } else { 0.0 };
                sum += (most - least) * node.weight * (g - d);
            }
        }
        Ok(sum)
    }

    /// The gap at a radius r > a of a given height, from g inside the contact by the fast rule; `None` if its sign is not certain
    /// against the error of the rule.
    ///
    /// # Errors
    /// Errors of the transform.
    #[cfg(feature = "mp")]
    pub(super) fn gap_over(&self, height: f64, r: f64, a: f64, d: f64) -> Result<Option<f64>> {
        let inside = self.afresh(0.0, a, d, r)? * std::f64::consts::FRAC_2_PI;
        let gap = height - d - inside;
        let scale = height.abs() + d.abs() + inside.abs();
        Ok((gap.abs() > COARSE * scale).then_some(gap))
    }

    /// The gap at a radius; `None` if its sign is not certain against rounding.
    pub(super) fn sign(&self, a: f64, d: f64, r: f64) -> Option<f64> {
        let breaks: Vec<f64> = self.edges.iter().map(|edge| edge.x).filter(|x| *x > a && *x < r).collect();
        let scale =
            breaks.iter().chain([&a, &r]).filter_map(|x| self.transform.g(x).ok()).fold(d.abs(), |s, g| s.max(g.abs()));
        match gap(&*self.transform, &a, &d, &r, &breaks) {
            Ok(gap) => (gap.value.abs() > gap.error + ROUNDINGS * f64::EPSILON * scale).then_some(gap.value),
            Err(_) => self.gap(a, d, r).ok().filter(|gap| gap.abs() > COARSE * scale),
        }
    }
}

/// h(r) = (2/π) ∫ₐʳ (g − d)/√(r² − x²) dx, with the error of the integral.
///
/// # Errors
/// Errors of the transform and of the quadrature.
pub(super) fn gap<R: Real>(transform: &dyn Transform<R>, a: &R, d: &R, r: &R, breaks: &[R]) -> Result<Estimate<R>> {
    weighted([a, r], breaks, d.abs(), |x| Ok(transform.g(x)? - d))
}

/// h'(r) = (2/πr) [∫ₐʳ x g'/√(r² − x²) dx + a (g(a) − d)/√(r² − a²)].
///
/// # Errors
/// Errors of the transform and of the quadrature.
pub(super) fn slope<R: Real>(transform: &dyn Transform<R>, a: &R, d: &R, r: &R, breaks: &[R]) -> Result<R> {
    let bulk = weighted([a, r], breaks, r.lit(0), |x| Ok(transform.slope(x)? * x))?.value / r;
    if *a == a.lit(0) {
        return Ok(bulk);
    }
    let span = (r.clone() - a).sqrt() * (r.clone() + a).sqrt();
    Ok(bulk + ((transform.g(a)? - d) / span * a / r).times(2) / r.pi())
}

/// (2/π) ∫ₐʳ f/√(r² − x²) dx; at an end of a piece, where f may be undefined, it is taken as zero.
///
/// f may vanish all but for rounding over a piece, as between a kink and an extremum of g that is a few roundings away. An error
/// is therefore also accepted if it is below the tolerance relative to the integral of `term`, the largest of the terms that
/// cancel in f, and of the largest |f| in the middle of a piece.
fn weighted<R: Real>([a, r]: [&R; 2], breaks: &[R], term: R, f: impl Fn(&R) -> Result<R>) -> Result<Estimate<R>> {
    let mut largest = r.lit(0);
    pieces(a, r, breaks, |from, to| {
        match f(&(from.clone() + to).over(2)).map(|middle| middle.abs()) {
            Ok(middle) if middle > largest => largest = middle,
            Ok(_) | Err(Error::Domain { .. }) => {}
            Err(error) => return Err(error),
        }
        Ok(Estimate::exact(r.lit(0)))
    })?;
    let rounding = roundoff_tolerance(r) * (largest + term) * r.pi().over(2);
    let tolerance = Tolerance::of_cancelling(r).or_error_below(&rounding);
    let integral = pieces(a, r, breaks, |from, to| {
        let beyond = r.clone() - to;
        let at = |node: &Abscissa<R>| match f(&node.x) {
            Err(Error::Domain { .. }) if node.x == *from || node.x == *to => Ok(node.x.lit(0)),
            value => Ok(value? / (beyond.clone() + &node.from_upper).sqrt() / (node.x.clone() + r).sqrt()),
        };
        tanh_sinh_near_ends(from, to, tolerance.clone(), at)
    })?;
    Ok(integral.scaled(&(r.lit(2) / r.pi())))
}
