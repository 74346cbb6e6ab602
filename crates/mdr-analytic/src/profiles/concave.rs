//! Profiles that first go down: displaced paraboloid, parabolic and elliptical dimple. Their g is negative near the axis.

use mdr_core::contact::{Kink, Result, Slopes};
use mdr_core::number::Special;

use super::edge::{Edge, around};
use super::smooth::{Cone, Ellipsoid, Paraboloid};
use super::{ClosedForm, positive, transform};

transform!(DisplacedParaboloid, ParabolicDimple, EllipticalDimple);

/// The displaced paraboloid f = (r − b)²/2R (a torus-like ridge at b): g = x²/R − πbx/2R (Argatov, Li, Pohrt & Popov
/// 2016). It is a paraboloid less a cone of slope b/R.
#[derive(Clone, Debug)]
pub struct DisplacedParaboloid<R> {
    ridge: Paraboloid<R>,
    cone: Cone<R>,
}

impl<R: Special> DisplacedParaboloid<R> {
    /// A paraboloid of curvature radius `radius` R whose lowest points lie on the circle of radius `offset` b.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(radius: R, offset: R) -> Result<Self> {
        let ridge = Paraboloid::new(radius.clone())?;
        let cone = Cone::new(positive("offset", offset)? / &radius)?;
        Ok(DisplacedParaboloid { ridge, cone })
    }
}

impl<R: Special> ClosedForm<R> for DisplacedParaboloid<R> {
    fn g_at(&self, x: &R) -> R {
        self.ridge.g_at(x) - self.cone.g_at(x)
    }
    fn slope_at(&self, x: &R) -> R {
        self.ridge.slope_at(x) - self.cone.slope_at(x)
    }
    fn integral_at(&self, x: &R) -> R {
        self.ridge.integral_at(x) - self.cone.integral_at(x)
    }
}

/// A flat punch with a parabolic dimple, f = h(1 − r²/b²) for r < b, 0 beyond: g = −2hx²/b² inside,
/// −2hx/(x + √(x² − b²)) beyond.
#[derive(Clone, Debug)]
pub struct ParabolicDimple<R> {
    depth: R,
    radius: R,
}

impl<R: Special> ParabolicDimple<R> {
    /// A dimple of the given `depth` h and `radius` b.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(depth: R, radius: R) -> Result<Self> {
        Ok(ParabolicDimple { depth: positive("depth", depth)?, radius: positive("radius", radius)? })
    }

    /// 2h(x − q)/(q(x + q)) = 2hb²/(q(x + q)²).
    fn outer_slope(&self, x: &R, leg: &R) -> R {
        let sum = leg.clone() + x;
        (self.depth.clone() * self.radius.square()).times(2) / &(leg.clone() * sum.square())
    }

    fn inner_slope(&self, x: &R) -> R {
        -(self.curvature() * x).times(4)
    }

    /// h/b².
    fn curvature(&self) -> R {
        self.depth.clone() / &self.radius.square()
    }
}

impl<R: Special> ClosedForm<R> for ParabolicDimple<R> {
    fn g_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => -(self.curvature() * x.square()).times(2),
            Some(edge) => -(self.depth.clone() * x).times(2) / &(edge.leg + x),
        }
    }
    fn slope_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => self.inner_slope(x),
            Some(edge) => self.outer_slope(x, &edge.leg),
        }
    }
    /// Beyond b: −(2h/3b²)(x³ − q³) = −(2h/3)(x² + xq + q²)/(x + q).
    fn integral_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => -(self.curvature() * x.powi(3)).times(2).over(3),
            Some(edge) => {
                let squares = x.square() + edge.leg.square() + edge.leg.clone() * x;
                -(self.depth.clone() * squares).times(2).over(3) / &(edge.leg + x)
            }
        }
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.radius)
    }
    /// g = −2h with the mean −2h/3; beyond b, g' falls with q and with x.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let (b, x) = (&self.radius, around(&self.radius, margin));
        let g = -self.depth.clone().times(2);
        let outside = Slopes::at_least(self.outer_slope(&x, &Edge::reach(b, margin)));
        Some(Kink { value: Some((g.clone(), g.over(3))), inside: Slopes::within(self.inner_slope(&x)), outside })
    }
}

/// A flat punch with an elliptical dimple, f = h√(1 − r²/b²) for r < b, 0 beyond: g = −(hx/b) artanh(x/b) inside,
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
        let inside = Ellipsoid::new(radius.clone(), depth.clone())?;
        Ok(EllipticalDimple { depth: positive("depth", depth)?, radius: positive("radius", radius)?, inside })
    }

    /// h/b.
    fn aspect(&self) -> R {
        self.depth.clone() / &self.radius
    }

    /// artanh(b/x).
    fn outer(&self, x: &R) -> R {
        (self.radius.clone() / x).atanh()
    }
}

impl<R: Special> ClosedForm<R> for EllipticalDimple<R> {
    fn g_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.g_at(x);
        }
        -(self.outer(x) * x * self.aspect())
    }
    fn slope_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.slope_at(x);
        }
        let b = &self.radius;
        let rest = (x.clone() - b) * (x.clone() + b);
        (b.clone() * x / &rest - self.outer(x)) * self.aspect()
    }
    /// Beyond b: −(h/b)½[(x² − b²) artanh(b/x) + bx].
    fn integral_at(&self, x: &R) -> R {
        if x < &self.radius {
            return -self.inside.integral_at(x);
        }
        let b = &self.radius;
        let rest = (x.clone() - b) * (x.clone() + b);
        -((self.outer(x) * rest + b.clone() * x) * self.aspect()).over(2)
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.radius)
    }
    /// With x = b(1 ± m): inside, g' = −(h/b)[artanh(1 − m) + (1 − m)/(m(2 − m))] falls to −∞; outside, it falls from ∞
    /// to (h/b)[(1 + m)/(m(2 + m)) − artanh(1/(1 + m))], with the derivative −2/(m(2 + m))² in m.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let (one, two) = (margin.lit(1), margin.lit(2));
        let (below, above) = (one.clone() - margin, one + margin);
        let inside = below.atanh() + below / ((two.clone() - margin) * margin);
        let outside = above.clone() / ((two + margin) * margin) - above.inv().atanh();
        let [inside, outside] = [-inside, outside].map(|slope| slope * self.aspect());
        Some(Kink { value: None, inside: Slopes::at_most(inside), outside: Slopes::at_least(outside) })
    }
}
