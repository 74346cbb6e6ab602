//! Profiles with one formula from the tip on: cone, paraboloid, sphere, ellipsoid, hyperboloid.

use mdr_core::contact::{Kink, Result, Slopes};
use mdr_core::number::Special;

use super::ranged::length;
use super::{ClosedForm, positive, transform};

transform!(Cone, Paraboloid, Sphere, Ellipsoid, Hyperboloid);

/// The cone f = r tan θ: g = (π/2) x tan θ (Love 1939; Heß 2011).
#[derive(Clone, Debug)]
pub struct Cone<R> {
    slope: R,
}

impl<R: Special> Cone<R> {
    /// A cone whose flank rises with `slope` = tan θ.
    ///
    /// # Errors
    /// Unless the slope is positive and finite.
    pub fn new(slope: R) -> Result<Self> {
        Ok(Cone { slope: positive("slope", slope)? })
    }
}

impl<R: Special> ClosedForm<R> for Cone<R> {
    fn g_at(&self, x: &R) -> R {
        self.slope_at(x) * x
    }
    fn slope_at(&self, x: &R) -> R {
        x.pi().over(2) * &self.slope
    }
    fn mean_at(&self, x: &R) -> R {
        self.g_at(x).over(2)
    }
    fn scaled(&self, _k: i64) -> Option<Self> {
        Some(self.clone())
    }
}

/// The paraboloid f = r²/2R: g = x²/R (Hertz; Johnson, Kendall & Roberts 1971).
#[derive(Clone, Debug)]
pub struct Paraboloid<R> {
    radius: R,
}

impl<R: Special> Paraboloid<R> {
    /// A paraboloid with the radius of curvature `radius` at its tip.
    ///
    /// # Errors
    /// Unless the radius is positive and finite.
    pub fn new(radius: R) -> Result<Self> {
        Ok(Paraboloid { radius: positive("radius", radius)? })
    }
}

impl<R: Special> ClosedForm<R> for Paraboloid<R> {
    fn g_at(&self, x: &R) -> R {
        x.square() / &self.radius
    }
    fn slope_at(&self, x: &R) -> R {
        x.clone().times(2) / &self.radius
    }
    fn mean_at(&self, x: &R) -> R {
        self.g_at(x).over(3)
    }
    fn scaled(&self, k: i64) -> Option<Self> {
        Some(Paraboloid { radius: length(&self.radius, k)? })
    }
}

/// The true sphere f = R − √(R² − r²), r < R: g = x artanh(x/R) (Segedin 1957; Maugis 1995).
#[derive(Clone, Debug)]
pub struct Sphere<R>(Ellipsoid<R>);

impl<R: Special> Sphere<R> {
    /// A sphere of the given radius.
    ///
    /// # Errors
    /// Unless the radius is positive and finite.
    pub fn new(radius: R) -> Result<Self> {
        let radius = positive("radius", radius)?;
        Ok(Sphere(Ellipsoid { lateral: radius.clone(), height: radius }))
    }
}

impl<R: Special> ClosedForm<R> for Sphere<R> {
    fn g_at(&self, x: &R) -> R {
        self.0.g_at(x)
    }
    fn slope_at(&self, x: &R) -> R {
        self.0.slope_at(x)
    }
    fn mean_at(&self, x: &R) -> R {
        self.0.mean_at(x)
    }
    fn scaled(&self, k: i64) -> Option<Self> {
        Some(Sphere(self.0.scaled(k)?))
    }
    fn end(&self) -> Option<&R> {
        self.0.end()
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        self.0.at_edge(margin)
    }
}

/// The half-ellipsoid f = c(1 − √(1 − r²/A²)), r < A: g = (c x/A) artanh(x/A).
#[derive(Clone, Debug)]
pub struct Ellipsoid<R> {
    lateral: R,
    height: R,
}

impl<R: Special> Ellipsoid<R> {
    /// An ellipsoid with the semi-axes `lateral` A (in the plane of contact) and `height` c.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(lateral: R, height: R) -> Result<Self> {
        Ok(Ellipsoid { lateral: positive("lateral", lateral)?, height: positive("height", height)? })
    }

    /// c/A, which is exactly one for the sphere.
    fn aspect(&self) -> R {
        self.height.clone() / &self.lateral
    }

    /// artanh(x/A); close to A as ½ ln((A + x)/(A − x)), because x/A would be rounded.
    fn artanh(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        if t > t.ratio(15, 16) {
            ((self.lateral.clone() + x) / (self.lateral.clone() - x)).ln().over(2)
        } else {
            t.atanh()
        }
    }

    /// (A − x)/A · (1 + x/A), which is accurate as x → A and in range for any A.
    fn rest(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        (self.lateral.clone() - x) / &self.lateral * (t.lit(1) + &t)
    }
}

impl<R: Special> ClosedForm<R> for Ellipsoid<R> {
    fn g_at(&self, x: &R) -> R {
        self.artanh(x) * x * self.aspect()
    }
    fn slope_at(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        (self.artanh(x) + t / self.rest(x)) * self.aspect()
    }
    /// ½Ac[t − (1 − t²) artanh t]/x with t = x/A, whose bracket starts with (2/3)t³: ½c·t·m(t).
    fn mean_at(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        let moment = super::edge::atanh_moment(&t);
        t * &self.height * moment.over(2)
    }
    fn scaled(&self, k: i64) -> Option<Self> {
        Some(Ellipsoid { lateral: length(&self.lateral, k)?, height: length(&self.height, k)? })
    }
    fn end(&self) -> Option<&R> {
        Some(&self.lateral)
    }
    /// g and g' grow without bound: beyond t = 1 − margin g' is at least its value there.
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        let (t, sum) = (margin.lit(1) - margin, margin.lit(2) - margin);
        let artanh = (sum.clone() / margin).ln().over(2);
        let least = (artanh + t / (sum * margin)) * self.aspect();
        Some(Kink { value: None, inside: Slopes::at_least(least), outside: Slopes::unknown() })
    }
}

/// The hyperboloid f = cot α (√(r² + A²) − A): g = x cot α arctan(x/A).
#[derive(Clone, Debug)]
pub struct Hyperboloid<R> {
    slope: R,
    lateral: R,
}

impl<R: Special> Hyperboloid<R> {
    /// A hyperboloid with the asymptotic `slope` cot α and the length `lateral` A over which its tip is round.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(slope: R, lateral: R) -> Result<Self> {
        Ok(Hyperboloid { slope: positive("slope", slope)?, lateral: positive("lateral", lateral)? })
    }
}

impl<R: Special> ClosedForm<R> for Hyperboloid<R> {
    fn g_at(&self, x: &R) -> R {
        (x.clone() / &self.lateral).atan() * x * &self.slope
    }
    fn slope_at(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        // t/(1 + t²) without a square that leaves the range.
        let rational =
            if t > t.lit(1) { (t.clone() + t.clone().inv()).inv() } else { t.clone() / (t.lit(1) + t.square()) };
        (t.atan() + rational) * &self.slope
    }
    /// ½A²[(1 + t²) arctan t − t]/x with t = x/A, whose bracket starts with (2/3)t³: ½x·m(t).
    fn mean_at(&self, x: &R) -> R {
        let t = x.clone() / &self.lateral;
        super::edge::atan_moment(&t) * &self.slope * x.clone().over(2)
    }
    fn scaled(&self, k: i64) -> Option<Self> {
        Some(Hyperboloid { slope: self.slope.clone(), lateral: length(&self.lateral, k)? })
    }
}
