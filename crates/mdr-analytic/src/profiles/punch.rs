//! Punches with an edge: flat punch, truncated cone, truncated paraboloid, rounded-edge flat punch.

use mdr_core::contact::{Kink, Slopes};
use mdr_core::number::Special;

use super::edge::{Edge, tangent_excess};
use super::ranged::{length, ratio};
use super::{ClosedForm, profiles, shapes, transform};

transform!(FlatPunch, TruncatedCone, TruncatedParaboloid, RoundedPunch);
shapes!(Special {
    FlatPunch { radius } => FlatPunch::new(radius),
    TruncatedCone { flank, flat } => TruncatedCone::new(flank.slope(), flat),
    TruncatedParaboloid { radius, flat } => TruncatedParaboloid::new(radius, flat),
    RoundedPunch { radius, flat } => RoundedPunch::new(radius, flat),
});

profiles! {
/// The flat punch f = 0 for r < b with a vertical edge at b: g = 0 for x ≤ b (Kendall 1971). The contact edge can stay
/// at the vertical edge.
///
/// ```
/// use mdr_analytic::profiles::FlatPunch;
/// use mdr_core::contact::Transform;
/// let punch = FlatPunch::new(2.0)?;
/// assert_eq!((punch.g(&2.0)?, punch.vertical_edge()), (0.0, true));
/// assert!(punch.g(&2.1).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct FlatPunch { radius: length }

impl FlatPunch {
    /// A flat-ended cylinder of the given `radius` b.
    pub fn new;
}

/// The truncated cone f = (r − b) tan θ for r > b, 0 inside: g = x tan θ arccos(b/x) for x > b (Ejike 1981).
pub struct TruncatedCone { slope: ratio, flat: length }

impl TruncatedCone {
    /// A cone of the given flank `slope` = tan θ, cut off at the radius `flat` b.
    pub fn new;
}

/// The truncated paraboloid f = (r² − b²)/2R for r > b, 0 inside: g = (x/R)√(x² − b²) for x > b (Ejike 1981).
pub struct TruncatedParaboloid { radius: length, flat: length }

impl TruncatedParaboloid {
    /// A paraboloid of curvature radius `radius` R, cut off at the radius `flat` b.
    pub fn new;
}

/// The flat punch with a rounded edge f = (r − b)²/2R for r > b, 0 inside: g = (x/R)[√(x² − b²) − b arccos(b/x)] for
/// x > b (Schubert 1942; Ciavarella 1999).
pub struct RoundedPunch { radius: length, flat: length }

impl RoundedPunch {
    /// A punch flat up to the radius `flat` b, then rounded with the curvature radius `radius` R.
    pub fn new;
}
}

impl<R: Special> ClosedForm<R> for FlatPunch<R> {
    fn g_at(&self, x: &R) -> R {
        x.lit(0)
    }
    fn slope_at(&self, x: &R) -> R {
        x.lit(0)
    }
    fn mean_at(&self, x: &R) -> R {
        x.lit(0)
    }
    fn end(&self) -> Option<&R> {
        Some(&self.radius)
    }
    fn vertical_edge(&self) -> bool {
        true
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        Some(beside_flat(margin, Slopes::unknown()))
    }
}

impl<R: Special> ClosedForm<R> for TruncatedCone<R> {
    fn g_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| edge.angle * x * &self.slope)
    }
    fn slope_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| (self.flat.clone() / &edge.leg + &edge.angle) * &self.slope)
    }
    /// ½ tan θ [x²θ − bq]/x = ½ tan θ [q²θ − b²(tan θ − θ)]/x, with x² = q² + b².
    fn mean_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| edge.cone_mean(x, &self.flat) * &self.slope)
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.flat)
    }
    /// Beyond b, g' is at least (b/q) tan θ.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let steepest = self.flat.clone() / Edge::reach(&self.flat, margin) * &self.slope;
        Some(beside_flat(margin, Slopes::at_least(steepest)))
    }
}

impl<R: Special> ClosedForm<R> for TruncatedParaboloid<R> {
    fn g_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| edge.leg / &self.radius * x)
    }
    fn slope_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| (x.clone() / &edge.leg * x + &edge.leg) / &self.radius)
    }
    fn mean_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| edge.leg.clone() / &self.radius * (edge.leg.clone() / x) * edge.leg.over(3))
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.flat)
    }
    /// Beyond b, g' is at least b²/Rq.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let steepest = self.flat.square() / Edge::reach(&self.flat, margin) / &self.radius;
        Some(beside_flat(margin, Slopes::at_least(steepest)))
    }
}

impl<R: Special> RoundedPunch<R> {
    /// √(x² − b²) − b arccos(b/x) = b(tan θ − θ).
    fn excess(&self, edge: &Edge<R>) -> R {
        tangent_excess(&(edge.leg.clone() / &self.flat), &edge.angle) * &self.flat
    }

    /// (2q − bθ)/R = (q + b(tan θ − θ))/R.
    fn outer_slope(&self, edge: &Edge<R>) -> R {
        (self.excess(edge) + &edge.leg) / &self.radius
    }
}

impl<R: Special> ClosedForm<R> for RoundedPunch<R> {
    fn g_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| self.excess(&edge) / &self.radius * x)
    }
    fn slope_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| self.outer_slope(&edge))
    }
    /// [q³/3 − ½b(x²θ − bq)]/Rx = ½b³[t³·2/3 − (1 + t²)θ + t]/Rx with t = tan θ.
    fn mean_at(&self, x: &R) -> R {
        beyond(x, &self.flat, |edge| edge.rounded_mean(x, &self.flat, &self.radius))
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.flat)
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        Some(beside_flat(margin, Slopes::within(self.outer_slope(&Edge::beside(&self.flat, margin)))))
    }
}

/// The value of a formula at a radius beyond the edge of a flat face, and 0 within.
fn beyond<R: Special>(x: &R, flat: &R, formula: impl FnOnce(Edge<R>) -> R) -> R {
    Edge::at(x, flat).map_or_else(|| x.lit(0), formula)
}

/// The kink at the edge of a flat face, with the bounds of g' beyond it.
fn beside_flat<R: Special>(like: &R, outside: Slopes<R>) -> Kink<R> {
    let zero = like.lit(0);
    Kink { value: Some((zero.clone(), zero.clone())), inside: Slopes::within(zero), outside }
}
