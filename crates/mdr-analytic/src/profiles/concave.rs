//! Profiles that first go down: displaced paraboloid, parabolic and elliptical dimple. Their g is negative near the axis.

use mdr_core::contact::Result;
use mdr_core::number::Special;

use super::edge::Edge;
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
    /// Beyond b: −(2h/b²)(x − q)(1 − x/q) = 2h(x − q)/(q(x + q)).
    fn slope_at(&self, x: &R) -> R {
        match Edge::at(x, &self.radius) {
            None => -(self.curvature() * x).times(4),
            Some(edge) => {
                let sum = edge.leg.clone() + x;
                (self.depth.clone() * self.radius.square()).times(2) / &(edge.leg * sum.square())
            }
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
}
