//! The heights of every shape of the library, by its name.

use mdr_core::contact::{Flank, Profile, Shape};
use mdr_core::number::{Lift, Special};

use super::{parabola, power, spherical, waves};

/// The heights of a shape, or of a sum of shapes.
///
/// A parameter out of its domain gives heights that are no numbers, and integrals that do not converge.
///
/// ```
/// use mdr_core::contact::{Flank, Profile, Shape};
/// use mdr_numeric::profiles::Heights;
/// let sphere = Heights::new(vec![Shape::Sphere { radius: 5.0 }]);
/// assert!((sphere.height(&3.0) - 1.0).abs() < 1e-15);
/// let cone = Shape::Cone { flank: Flank::Slope(0.5) };
/// let sum = Heights::new(vec![Shape::Paraboloid { radius: 2.0 }, cone]);
/// assert_eq!(sum.height(&2.0), 2.0);
/// let wedge = Heights::new(vec![Shape::Cone { flank: Flank::HalfAngleDegrees(60.0) }]);
/// assert!((wedge.height(&3f64.sqrt()) - 1.0).abs() < 1e-15, "tan 30°");
/// let punch = Heights::new(vec![Shape::FlatPunch { radius: 2.0 }]);
/// assert!(punch.wall() && punch.outer_radius() == Some(2.0) && punch.height(&1.0) == 0.0);
/// ```
#[derive(Clone, Debug)]
pub struct Heights<R> {
    terms: Vec<Shape<R>>,
}

impl<R: Special> Heights<R> {
    /// The sum of shapes; of none of them it is the plane.
    pub fn new(terms: Vec<Shape<R>>) -> Self {
        Heights { terms }
    }
}

impl<R: Special> Profile<R> for Heights<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let mut heights = self.terms.iter().map(|shape| height(shape, r));
        let first = heights.next().unwrap_or_else(|| r.lit(0));
        heights.fold(first, |sum, height| sum + height)
    }

    fn kinks(&self) -> Vec<R> {
        let mut kinks: Vec<R> = self.terms.iter().filter_map(kink).collect();
        kinks.sort_by(|one, other| one.partial_cmp(other).unwrap_or(std::cmp::Ordering::Equal));
        kinks
    }

    fn outer_radius(&self) -> Option<R> {
        let radii = self.terms.iter().filter_map(outer_radius).cloned();
        radii.reduce(|one, other| if other < one { other } else { one })
    }

    fn wall(&self) -> bool {
        self.terms.iter().any(|shape| matches!(shape, Shape::FlatPunch { .. }))
    }

    fn tip_exponent(&self) -> Option<R> {
        let exponents = self.terms.iter().filter_map(tip_exponent);
        exponents.reduce(|one, other| if other < one { other } else { one })
    }
}

/// f(r) of one shape.
fn height<R: Special, S: Lift<R>>(shape: &Shape<R>, r: &S) -> S {
    let beyond = |edge: &R| Some(r.clone() - S::lift(edge)).filter(|beyond| *beyond > r.lit(0));
    match shape {
        Shape::Power { n, c } => power(r, n, c),
        Shape::Paraboloid { radius } => parabola(r, radius),
        Shape::Cone { flank } => S::lift(&slope(flank)) * r,
        Shape::Sphere { radius } => spherical(r, radius, radius),
        Shape::Ellipsoid { lateral, height } => spherical(r, lateral, height),
        Shape::FlatPunch { .. } => r.lit(0),
        Shape::TruncatedCone { flank, flat } => {
            beyond(flat).map_or_else(|| r.lit(0), |beyond| S::lift(&slope(flank)) * beyond)
        }
        Shape::TruncatedParaboloid { radius, flat } => {
            let sum = r.clone() + S::lift(flat);
            beyond(flat).map_or_else(|| r.lit(0), |beyond| (beyond / S::lift(radius) * sum).over(2))
        }
        Shape::RoundedPunch { radius, flat } => {
            beyond(flat).map_or_else(|| r.lit(0), |beyond| parabola(&beyond, radius))
        }
        Shape::ConeParabolicCap { flank, cap } => {
            let (slope, cap_radius) = (S::lift(&slope(flank)), S::lift(cap));
            match beyond(cap) {
                Some(_) => slope * (r.clone() - cap_radius.over(2)),
                None => (slope * r / cap_radius * r).over(2),
            }
        }
        Shape::ConeSphericalCap { flank, radius } => {
            let edge = cap_radius(flank, radius);
            match beyond(&edge) {
                Some(beyond) => spherical(&S::lift(&edge), radius, radius) + S::lift(&slope(flank)) * beyond,
                None => spherical(r, radius, radius),
            }
        }
        Shape::Hyperboloid { flank, lateral } => {
            let b = S::lift(lateral);
            let s = r.clone() / &b;
            S::lift(&slope(flank)) * s.clone() * r / ((s.square() + s.lit(1)).sqrt() + s.lit(1))
        }
        Shape::DisplacedParaboloid { radius, offset } => {
            ((r.clone() - S::lift(offset).times(2)) / S::lift(radius) * r).over(2)
        }
        Shape::ParabolicDimple { depth, radius } => match beyond(radius) {
            Some(_) => -S::lift(depth),
            None => -((r.clone() / S::lift(radius)).square() * S::lift(depth)),
        },
        Shape::EllipticalDimple { depth, radius } => -spherical(r, radius, depth),
        Shape::WavyParaboloid { radius, amplitude, wavelength } => {
            parabola(r, radius) + waves(r, amplitude, wavelength)
        }
    }
}

/// tan θ: for half the angle α at the apex, cos α/sin α.
fn slope<R: Special>(flank: &Flank<R>) -> R {
    match flank {
        Flank::Slope(slope) => slope.clone(),
        Flank::HalfAngleDegrees(degrees) => {
            let radians = (degrees.pi() * degrees).over(180);
            radians.cos() / radians.sin()
        }
    }
}

/// Where the spherical cap of a cone ends: Rt/√(1 + t²), where the sphere has the slope t of the cone.
fn cap_radius<R: Special>(flank: &Flank<R>, radius: &R) -> R {
    let slope = slope(flank);
    (slope.square() + slope.lit(1)).sqrt().inv() * &slope * radius
}

/// Where f or a derivative of it jumps.
fn kink<R: Special>(shape: &Shape<R>) -> Option<R> {
    match shape {
        Shape::TruncatedCone { flat, .. }
        | Shape::TruncatedParaboloid { flat, .. }
        | Shape::RoundedPunch { flat, .. } => Some(flat.clone()),
        Shape::ConeParabolicCap { cap, .. } => Some(cap.clone()),
        Shape::ConeSphericalCap { flank, radius } => Some(cap_radius(flank, radius)),
        Shape::ParabolicDimple { radius, .. } => Some(radius.clone()),
        _ => None,
    }
}

/// Where the shape ends.
fn outer_radius<R>(shape: &Shape<R>) -> Option<&R> {
    match shape {
        Shape::Sphere { radius } | Shape::FlatPunch { radius } | Shape::EllipticalDimple { radius, .. } => Some(radius),
        Shape::Ellipsoid { lateral, .. } => Some(lateral),
        _ => None,
    }
}

/// p of f ≈ c rᵖ at the tip; none for a flat face.
fn tip_exponent<R: Special>(shape: &Shape<R>) -> Option<R> {
    let (like, exponent) = match shape {
        Shape::Power { n, .. } => return Some(n.clone()),
        Shape::Cone { flank } => (flank.parameter().1, 1),
        Shape::DisplacedParaboloid { radius, .. } => (radius, 1),
        Shape::FlatPunch { .. }
        | Shape::TruncatedCone { .. }
        | Shape::TruncatedParaboloid { .. }
        | Shape::RoundedPunch { .. } => return None,
        other => (other.parameters().first()?.1, 2),
    };
    Some(like.lit(exponent))
}
