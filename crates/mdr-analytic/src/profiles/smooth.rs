//! Profiles with one formula from the tip on: cone, paraboloid, sphere, ellipsoid, hyperboloid.

use mdr_core::contact::{Kink, Result, Slopes};
use mdr_core::number::Special;

use super::ranged::{Scale, length, ratio};
use super::{ClosedForm, positive, profiles, scaled, shapes, transform};

transform!(Cone, Paraboloid, Sphere, Ellipsoid, Hyperboloid);
shapes!(Special {
    Paraboloid { radius } => Paraboloid::new(radius),
    Cone { flank } => Cone::new(flank.slope()),
    Sphere { radius } => Sphere::new(radius),
    Ellipsoid { lateral, height } => Ellipsoid::new(lateral, height),
    Hyperboloid { flank, lateral } => Hyperboloid::new(flank.slope(), lateral),
});
scaled!(Sphere { 0: Scale::scaled });

profiles! {
/// The cone f = r tan θ: g = (π/2) x tan θ (Love 1939; Heß 2011).
pub struct Cone { slope: ratio }

impl Cone {
    /// A cone whose flank rises with `slope` = tan θ.
    pub fn new;
}

/// The paraboloid f = r²/2R: g = x²/R (Hertz; Johnson, Kendall & Roberts 1971).
pub struct Paraboloid { radius: length }

impl Paraboloid {
    /// A paraboloid with the radius of curvature `radius` at its tip.
    pub fn new;
}

/// The half-ellipsoid f = c(1 − √(1 − r²/A²)), r < A: g = (c x/A) artanh(x/A).
pub struct Ellipsoid { lateral: length, height: length }

impl Ellipsoid {
    /// An ellipsoid with the semi-axes `lateral` A (in the plane of contact) and `height` c.
    pub fn new;
}

/// The hyperboloid f = cot α (√(r² + A²) − A): g = x cot α arctan(x/A).
pub struct Hyperboloid { slope: ratio, lateral: length }

impl Hyperboloid {
    /// A hyperboloid with the asymptotic `slope` cot α and the length `lateral` A over which its tip is round.
    pub fn new;
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
    fn end(&self) -> Option<&R> {
        self.0.end()
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        self.0.at_edge(margin)
    }
}

impl<R: Special> Ellipsoid<R> {
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
}
