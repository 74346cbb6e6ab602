//! The profiles of the library as heights, written from the geometry.

use mdr_core::contact::Profile;
use mdr_core::number::{Lift, Real};

/// A profile by its kind and its parameters in the order of the records.
#[derive(Clone, Debug)]
pub(super) struct Height<R> {
    pub(super) kind: &'static str,
    pub(super) parameters: Vec<R>,
}

impl<R: Real> Height<R> {
    fn parameter(&self, index: usize) -> &R {
        &self.parameters[index.min(self.parameters.len() - 1)]
    }

    /// Where the cap of a cone ends: Rt/√(1 + t²), where the sphere has the slope t.
    fn cap(&self) -> R {
        let (slope, radius) = (self.parameter(0), self.parameter(1));
        (slope.square() + slope.lit(1)).sqrt().inv() * slope * radius
    }
}

/// h(1 − √(1 − (r/l)²)) without cancellation.
fn spherical<S: Real>(r: &S, l: &S, h: &S) -> S {
    let s = r.clone() / l;
    let cosine = ((s.lit(1) - &s) * (s.lit(1) + &s)).sqrt();
    s.square() * h / (s.lit(1) + cosine)
}

impl<R: Real> Profile<R> for Height<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let [p, q] = [0, 1].map(|index| S::lift(self.parameter(index)));
        let beyond = r.clone() - &q;
        let outside = beyond > r.lit(0);
        match self.kind {
            "cone" => p * r,
            "paraboloid" => r.square() / p.times(2),
            "sphere" => spherical(r, &p, &p),
            "ellipsoid" => spherical(r, &p, &q),
            "hyperboloid" => p * r.square() / ((r.square() + q.square()).sqrt() + &q),
            "truncated-cone" if outside => p * beyond,
            "truncated-paraboloid" if outside => beyond * (r.clone() + &q) / p.times(2),
            "rounded-punch" if outside => beyond.square() / p.times(2),
            "cone-parabolic-cap" if outside => p * (r.clone() - q.over(2)),
            "cone-parabolic-cap" => p * r.square() / q.times(2),
            "cone-spherical-cap" => {
                let edge = S::lift(&self.cap());
                if *r > edge { spherical(&edge, &q, &q) + p * (r.clone() - &edge) } else { spherical(r, &q, &q) }
            }
            "displaced-paraboloid" => (r.clone() - q.times(2)) * r / p.times(2),
            "parabolic-dimple" if outside => -p,
            "parabolic-dimple" => -(r.square() / q.square() * p),
            "elliptical-dimple" => -spherical(r, &q, &p),
            "wavy-paraboloid" => {
                let phase = r.pi() * r / S::lift(self.parameter(2));
                r.square() / p.times(2) + (phase.sin().square() * q).times(2)
            }
            "sum" => r.square() / p.times(2) + q * r,
            _ => r.lit(0),
        }
    }

    fn kinks(&self) -> Vec<R> {
        match self.kind {
            "truncated-cone" | "truncated-paraboloid" | "rounded-punch" | "cone-parabolic-cap" | "parabolic-dimple" => {
                vec![self.parameter(1).clone()]
            }
            "cone-spherical-cap" => vec![self.cap()],
            _ => Vec::new(),
        }
    }

    fn outer_radius(&self) -> Option<R> {
        match self.kind {
            "sphere" | "ellipsoid" => Some(self.parameter(0).clone()),
            "elliptical-dimple" => Some(self.parameter(1).clone()),
            _ => None,
        }
    }

    fn tip_exponent(&self) -> Option<R> {
        let exponent = match self.kind {
            "cone" | "displaced-paraboloid" | "sum" => 1,
            "truncated-cone" | "truncated-paraboloid" | "rounded-punch" => return None,
            _ => 2,
        };
        Some(self.parameter(0).lit(exponent))
    }
}
