//! Profiles that fall from the axis: displaced paraboloid, parabolic and elliptical dimple. Their g is negative near
//! the axis.

use mdr_core::contact::{Kink, Result, Slopes};
use mdr_core::number::Special;

use super::edge::{Edge, around, atanh_excess};
use super::ranged::{Scale, length};
use super::smooth::Ellipsoid;
use super::{ClosedForm, positive, profiles, scaled, shapes, transform};

transform!(DisplacedParaboloid, ParabolicDimple, EllipticalDimple);
shapes!(Special {
    DisplacedParaboloid { radius, offset } => DisplacedParaboloid::new(radius, offset),
    ParabolicDimple { depth, radius } => ParabolicDimple::new(depth, radius),
    EllipticalDimple { depth, radius } => EllipticalDimple::new(depth, radius),
});
scaled!(EllipticalDimple { depth: length, radius: length, inside: Scale::scaled });

profiles! {
/// The displaced paraboloid f = ((r − b)² − b²)/2R, a torus-like ridge at b, b²/2R below the tip: g = x²/R − πbx/2R
/// (Argatov, Li, Pohrt & Popov 2016).
pub struct DisplacedParaboloid { radius: length, offset: length }

impl DisplacedParaboloid {
    /// A paraboloid of curvature radius `radius` R whose lowest points lie on the circle of radius `offset` b.
    pub fn new;
}

/// A flat punch with a parabolic dimple, f = −hr²/b² for r < b, −h beyond: g = −2hx²/b² inside,
/// −2hx/(x + √(x² − b²)) beyond.
pub struct ParabolicDimple { depth: length, radius: length }

impl ParabolicDimple {
    /// A dimple of the given `depth` h and `radius` b.
    pub fn new;
}
}

impl<R: Special> DisplacedParaboloid<R> {
    /// πb/2, where g has its zero.
    fn zero(&self) -> R {
        self.offset.pi().over(2) * &self.offset
    }
}

impl<R: Special> ClosedForm<R> for DisplacedParaboloid<R> {
    fn rises(&self) -> bool {
        false
    }
    /// x(x − πb/2)/R.
    fn g_at(&self, x: &R) -> R {
        (x.clone() - self.zero()) / &self.radius * x
    }
    fn slope_at(&self, x: &R) -> R {
        (x.clone().times(2) - self.zero()) / &self.radius
    }
    /// x(x/3 − πb/4)/R.
    fn mean_at(&self, x: &R) -> R {
        (x.clone().over(3) - self.zero().over(2)) / &self.radius * x
    }
}

impl<R: Special> ParabolicDimple<R> {
    /// 2h(x − q)/(q(x + q)) = 2(h/q)(b/(x + q))².
    fn outer_slope(&self, x: &R, leg: &R) -> R {
        let share = self.radius.clone() / &(leg.clone() + x);
        (self.depth.clone() / leg * &share).times(2) * share
    }

    /// −4hx/b².
    fn inner_slope(&self, x: &R) -> R {
        -(x.clone() / &self.radius * (self.depth.clone() / &self.radius)).times(4)
    }
}

impl<R: Special> ClosedForm<R> for ParabolicDimple<R> {
    fn rises(&self) -> bool {
        false
    }
    fn rises_beyond(&self, x: &R) -> bool {
        *x >= self.radius
    }
    fn g_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => {
                let t = x.clone() / &self.radius;
                -(t.clone() * &self.depth).times(2) * t
            }
            Some(edge) => -(x.clone() / &(edge.leg + x) * &self.depth).times(2),
        }
    }
    fn slope_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => self.inner_slope(x),
            Some(edge) => self.outer_slope(x, &edge.leg),
        }
    }
    /// Beyond b: −(2h/3b²)(x³ − q³)/x = −(2h/3)(x² + xq + q²)/x(x + q).
    fn mean_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => {
                let t = x.clone() / &self.radius;
                -(t.clone() * &self.depth * t).times(2).over(3)
            }
            // (x² + xq + q²)/x(x + q) = 1 + q²/x(x + q).
            Some(edge) => {
                let share = edge.leg.clone() / &(edge.leg.clone() + x);
                -(share * (edge.leg / x) + x.lit(1)).times(2).over(3) * &self.depth
            }
        }
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.radius)
    }
    /// g = −2h with the mean −2h/3; beyond b, g' decreases with q and with x.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let (b, x) = (&self.radius, around(&self.radius, margin));
        let g = -self.depth.clone().times(2);
        let outside = Slopes::at_least(self.outer_slope(&x, &Edge::reach(b, margin)));
        Some(Kink { value: Some((g.clone(), g.over(3))), inside: Slopes::within(self.inner_slope(&x)), outside })
    }
}

/// A flat punch with an elliptical dimple, f = h(√(1 − r²/b²) − 1) for r < b, −h beyond: g = −(hx/b) artanh(x/b) inside,
/// −(hx/b) artanh(b/x) beyond, with a logarithmic singularity at b.
#[derive(Clone, Debug)]
pub struct EllipticalDimple<R> {
    depth: R,
    radius: R,
    inside: Ellipsoid<R>,
}

impl<R: Special> EllipticalDimple<R> {
    /// A dimple of the given `depth` h and `radius` b.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(depth: R, radius: R) -> Result<Self> {
        let (depth, radius) = (positive("depth", depth)?, positive("radius", radius)?);
        let inside = Ellipsoid::new(radius.clone(), depth.clone())?;
        Ok(EllipticalDimple { depth, radius, inside })
    }

    /// h/b.
    fn aspect(&self) -> R {
        self.depth.clone() / &self.radius
    }

    /// 1 − b²/x², beyond b.
    fn rest(&self, x: &R) -> R {
        (x.clone() - &self.radius) / x * (self.radius.clone() / x + x.lit(1))
    }
}

impl<R: Special> ClosedForm<R> for EllipticalDimple<R> {
    fn rises(&self) -> bool {
        false
    }
    fn rises_beyond(&self, x: &R) -> bool {
        *x >= self.radius
    }
    fn g_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.g_at(x);
        }
        -((self.radius.clone() / x).atanh() * x * self.aspect())
    }
    fn slope_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.slope_at(x);
        }
        let t = self.radius.clone() / x;
        let steep = t.clone() / &self.rest(x);
        if !(t < t.ratio(1, 2)) {
            return (steep - t.atanh()) * self.aspect();
        }
        // t/(1 − t²) − artanh t = t³/(1 − t²) − (artanh t − t): of order t³, while the terms are of order t.
        (steep / &t - atanh_excess(&t)) * &t * (self.depth.clone() / x) * &t
    }
    /// Beyond b, with t = b/x: −(h/2)[(1 − t²)(artanh t)/t + 1].
    fn mean_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.mean_at(x);
        }
        let t = self.radius.clone() / x;
        let mean = if t < t.ratio(1, 2) { atanh_excess(&t) * t.square() + t.lit(1) } else { t.atanh() / &t };
        -((mean * self.rest(x) + t.lit(1)) * &self.depth).over(2)
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.radius)
    }
    /// With x = b(1 ± m): inside, g' = −(h/b)[artanh(1 − m) + (1 − m)/(m(2 − m))] decreases to −∞; outside, it
    /// decreases from ∞ to (h/b)[(1 + m)/(m(2 + m)) − artanh(1/(1 + m))], with the derivative −2/(m(2 + m))² in m.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let (one, two) = (margin.lit(1), margin.lit(2));
        let (below, above) = (one.clone() - margin, one + margin);
        let inside = below.atanh() + below / ((two.clone() - margin) * margin);
        let outside = above.clone() / ((two + margin) * margin) - above.inv().atanh();
        let [inside, outside] = [-inside, outside].map(|slope| slope * self.aspect());
        Some(Kink { value: None, inside: Slopes::at_most(inside), outside: Slopes::at_least(outside) })
    }
}
