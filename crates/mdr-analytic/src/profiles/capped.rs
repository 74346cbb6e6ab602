//! Cones with a rounded tip: a paraboloid or a sphere that joins the flank with a continuous slope.

use mdr_core::contact::{Kink, Quantity, Result, Slopes};
use mdr_core::number::Special;

use super::edge::{Edge, around, atanh_moment};
use super::ranged::{Scale, length, ratio};
use super::smooth::{Paraboloid, Sphere};
use super::{ClosedForm, positive, scaled, shapes, transform};
use crate::range::representable;

transform!(ParabolicCapCone, SphericalCapCone);
shapes!(Special {
    ConeParabolicCap { flank, cap } => ParabolicCapCone::new(flank.slope(), cap),
    ConeSphericalCap { flank, radius } => SphericalCapCone::new(flank.slope(), radius),
});
scaled!(ParabolicCapCone { slope: ratio, cap: length, tip: Scale::scaled });
scaled!(SphericalCapCone { slope: ratio, radius: length, cap: length, level: length, tip: Scale::scaled });

/// A cone of slope t with a parabolic cap of radius b: f = t r²/2b for r < b, t(r − b/2) beyond. For x > b,
/// g = t x [b/(x + √(x² − b²)) + arccos(b/x)] (Maugis & Barquins 1983).
#[derive(Clone, Debug)]
pub struct ParabolicCapCone<R> {
    slope: R,
    cap: R,
    tip: Paraboloid<R>,
}

impl<R: Special> ParabolicCapCone<R> {
    /// A cone of flank `slope` t = tan θ, capped up to the radius `cap` b by a paraboloid of curvature radius b/t.
    ///
    /// # Errors
    /// Unless both are positive and finite; [`OutOfRange`](mdr_core::contact::Error::OutOfRange) if b/t is not.
    pub fn new(slope: R, cap: R) -> Result<Self> {
        let slope = positive("slope", slope)?;
        let cap = positive("cap", cap)?;
        let curvature = Quantity::Parameter("the radius of curvature of the cap");
        let tip = Paraboloid::new(representable(curvature, cap.clone() / &slope, || cap.ln() - slope.ln())?)?;
        Ok(ParabolicCapCone { slope, cap, tip })
    }

    /// b/(x + q) = (x − q)/b.
    fn cap_share(&self, x: &R, edge: &Edge<R>) -> R {
        self.cap.clone() / &(edge.leg.clone() + x)
    }

    fn outer_slope(&self, x: &R, edge: &Edge<R>) -> R {
        (self.cap_share(x, edge).times(2) + &edge.angle) * &self.slope
    }
}

impl<R: Special> ClosedForm<R> for ParabolicCapCone<R> {
    fn g_at(&self, x: &R) -> R {
        match Edge::at(x, &self.cap) {
            None => self.tip.g_at(x),
            Some(edge) => (self.cap_share(x, &edge) + &edge.angle) * x * &self.slope,
        }
    }
    fn slope_at(&self, x: &R) -> R {
        match Edge::at(x, &self.cap) {
            None => self.tip.slope_at(x),
            Some(edge) => self.outer_slope(x, &edge),
        }
    }
    /// t[(x³ − q³)/3b + ½(x²θ − bq)]/x, with x³ − q³ = (x − q)(x² + xq + q²).
    fn mean_at(&self, x: &R) -> R {
        match Edge::at(x, &self.cap) {
            None => self.tip.mean_at(x),
            Some(edge) => {
                let lengths = edge.leg.clone() / x * &edge.leg + &edge.leg + x;
                let cap = self.cap_share(x, &edge) * lengths.over(3);
                (cap + edge.cone_mean(x, &self.cap)) * &self.slope
            }
        }
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.cap)
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        Some(joint(&self.tip, &self.cap, margin, |x, edge| self.outer_slope(x, edge)))
    }
}

/// A cone of slope t with a spherical cap of radius R up to b = R t/√(1 + t²). For x > b, g is
/// x ln[(R + x)/(√(R² − b²) + √(x² − b²))] + x t arccos(b/x) (Maugis & Barquins 1983).
#[derive(Clone, Debug)]
pub struct SphericalCapCone<R> {
    slope: R,
    radius: R,
    /// b.
    cap: R,
    /// √(R² − b²) = R/√(1 + t²).
    level: R,
    tip: Sphere<R>,
}

impl<R: Special> SphericalCapCone<R> {
    /// A cone of flank `slope` t = tan θ whose tip is a sphere of the given `radius` R.
    ///
    /// # Errors
    /// Unless both are positive and finite.
    pub fn new(slope: R, radius: R) -> Result<Self> {
        let slope = positive("slope", slope)?;
        let radius = positive("radius", radius)?;
        let [sine, cosine] = sine_and_cosine(&slope);
        let (level, cap) = (cosine * &radius, sine * &radius);
        let tip = Sphere::new(radius.clone())?;
        Ok(SphericalCapCone { slope, radius, cap, level, tip })
    }

    /// ln[(R + x)/(s + q)] with s = √(R² − b²), q = √(x² − b²); R − s and x − q are written without cancellation.
    fn logarithm(&self, x: &R, edge: &Edge<R>) -> R {
        let [own, beyond] =
            [self.radius.clone() + &self.level, edge.leg.clone() + x].map(|sum| self.cap.clone() / &sum);
        ((own + beyond) * (self.cap.clone() / &(self.level.clone() + &edge.leg))).ln_1p()
    }

    /// ln[…] + tθ + R b t/(Rq + sx): the terms that are singular at b cancel exactly.
    fn outer_slope(&self, x: &R, edge: &Edge<R>) -> R {
        let denominator = edge.leg.clone() + self.level.clone() / &self.radius * x;
        let joint = self.cap.clone() / &denominator;
        self.logarithm(x, edge) + (joint + &edge.angle) * &self.slope
    }
}

impl<R: Special> ClosedForm<R> for SphericalCapCone<R> {
    fn g_at(&self, x: &R) -> R {
        match Edge::at(x, &self.cap) {
            None => self.tip.g_at(x),
            Some(edge) => (self.logarithm(x, &edge) + edge.angle * &self.slope) * x,
        }
    }
    fn slope_at(&self, x: &R) -> R {
        match Edge::at(x, &self.cap) {
            None => self.tip.slope_at(x),
            Some(edge) => self.outer_slope(x, &edge),
        }
    }
    /// [½(x² − R²) ln[…] + ½(Rx − sq) + ½t(x²θ − bq)]/x; well inside R the first two are the difference of two integrals
    /// of a sphere, ½x²m(x/R) − ½q²m(q/s) with m(t) = [t − (1 − t²) artanh t]/t².
    fn mean_at(&self, x: &R) -> R {
        let Some(edge) = Edge::at(x, &self.cap) else {
            return self.tip.mean_at(x);
        };
        let (radius, s) = (&self.radius, &self.level);
        let sphere = if x.clone().times(2) < *radius {
            let moment = |leg: &R, radius: &R| leg.clone() / x * leg * atanh_moment(&(leg.clone() / radius));
            moment(x, radius) - moment(&edge.leg, s)
        } else {
            let area = (x.clone() - radius) * (radius.clone() / x + x.lit(1));
            // Rx − sq without cancellation.
            let sum = radius.clone() * x + s.clone() * &edge.leg;
            let difference = (s.square() + x.square()) / &sum * (self.cap.clone() / x) * &self.cap;
            self.logarithm(x, &edge) * area + difference
        };
        sphere.over(2) + edge.cone_mean(x, &self.cap) * &self.slope
    }
    fn edge(&self) -> Option<&R> {
        Some(&self.cap)
    }
    fn at_edge(&self, margin: &R) -> Option<Kink<R>> {
        Some(joint(&self.tip, &self.cap, margin, |x, edge| self.outer_slope(x, edge)))
    }
}

/// sin θ and cos θ of an angle with the tangent t; no square leaves the range.
fn sine_and_cosine<R: Special>(t: &R) -> [R; 2] {
    let flat = *t < t.lit(1);
    let small = if flat { t.clone() } else { t.clone().inv() };
    let larger = (small.square() + t.lit(1)).sqrt().inv();
    let smaller = small * &larger;
    if flat { [smaller, larger] } else { [larger, smaller] }
}

/// The joint between a tip and the flank at b, with the slope of g beyond.
fn joint<R: Special>(tip: &impl ClosedForm<R>, b: &R, margin: &R, outer_slope: impl Fn(&R, &Edge<R>) -> R) -> Kink<R> {
    let x = around(b, margin);
    Kink {
        value: Some((tip.g_at(b), tip.mean_at(b))),
        inside: Slopes::within(tip.slope_at(&x)),
        outside: Slopes::within(outer_slope(&x, &Edge::beside(b, margin))),
    }
}
