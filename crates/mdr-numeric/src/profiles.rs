//! Profiles as heights f(r), the input of the quadrature.
//!
//! Every height is written without cancellation near the tip and with ratios of lengths only, so that it is accurate at
//! any scale.

use mdr_core::contact::{Error, Flank, Profile, Quantity, Result, Shape};
use mdr_core::number::{Lift, Real, Special};

/// The heights of a shape, or of a sum of shapes.
///
/// ```
/// use mdr_core::contact::{Flank, Profile, Shape};
/// use mdr_numeric::profiles::Heights;
/// let sphere = Heights::new([Shape::Sphere { radius: 5.0 }])?;
/// assert!((sphere.height(&3.0) - 1.0).abs() < 1e-15);
/// let sum = Heights::new([Shape::Paraboloid { radius: 2.0 }, Shape::Cone { flank: Flank::Slope(0.5) }])?;
/// assert_eq!(sum.height(&2.0), 2.0);
/// let wedge = Heights::new([Shape::Cone { flank: Flank::HalfAngleDegrees(60.0) }])?;
/// assert!((wedge.height(&3f64.sqrt()) - 1.0).abs() < 1e-15, "tan 30°");
/// let punch = Heights::new([Shape::FlatPunch { radius: 2.0 }])?;
/// assert!(punch.vertical_edge() && punch.outer_radius() == Some(2.0) && punch.height(&1.0) == 0.0);
/// let error = Heights::new([Shape::Sphere { radius: -5.0 }]).unwrap_err();
/// assert_eq!(error.to_string(), "radius must be positive and finite, got -5");
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Heights<R> {
    terms: Vec<Shape<R>>,
}

impl<R: Special> Heights<R> {
    /// The sum of shapes; an empty list is the plane.
    ///
    /// # Errors
    /// [`Error::Domain`] unless every parameter is positive and finite; the amplitude of waves may have either sign, and
    /// half the angle at an apex is smaller than 90°.
    pub fn new(terms: impl Into<Vec<Shape<R>>>) -> Result<Self> {
        let terms = terms.into();
        for (key, value) in terms.iter().flat_map(Shape::parameters) {
            require_in_domain(key, value)?;
        }
        Ok(Heights { terms })
    }
}

/// Refuses a parameter with this key of a scene that is outside of its domain.
fn require_in_domain<R: Real>(key: &'static str, value: &R) -> Result<()> {
    let (finite, positive) = (value.is_finite(), *value > value.lit(0));
    let (valid, requirement) = match key {
        "amplitude" => (finite, "finite"),
        "half_angle_degrees" => (positive && *value < value.lit(90), "positive and smaller than 90"),
        _ => (finite && positive, "positive and finite"),
    };
    let quantity = match key {
        "n" => Quantity::Exponent,
        "c" => Quantity::Coefficient,
        _ => Quantity::Parameter(key),
    };
    if valid { Ok(()) } else { Err(Error::domain(quantity, value, requirement)) }
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

    fn vertical_edge(&self) -> bool {
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
        Shape::Cone { flank } => S::lift(&flank.slope()) * r,
        Shape::Sphere { radius } => spherical(r, radius, radius),
        Shape::Ellipsoid { lateral, height } => spherical(r, lateral, height),
        Shape::FlatPunch { .. } => r.lit(0),
        Shape::TruncatedCone { flank, flat } => {
            beyond(flat).map_or_else(|| r.lit(0), |beyond| S::lift(&flank.slope()) * beyond)
        }
        Shape::TruncatedParaboloid { radius, flat } => {
            let sum = r.clone() + S::lift(flat);
            beyond(flat).map_or_else(|| r.lit(0), |beyond| (beyond / S::lift(radius) * sum).over(2))
        }
        Shape::RoundedPunch { radius, flat } => {
            beyond(flat).map_or_else(|| r.lit(0), |beyond| parabola(&beyond, radius))
        }
        Shape::ConeParabolicCap { flank, cap } => {
            let (slope, cap_radius) = (S::lift(&flank.slope()), S::lift(cap));
            match beyond(cap) {
                Some(_) => slope * (r.clone() - cap_radius.over(2)),
                None => (slope * r / cap_radius * r).over(2),
            }
        }
        Shape::ConeSphericalCap { flank, radius } => {
            let edge = cap_radius(flank, radius);
            match beyond(&edge) {
                Some(beyond) => spherical(&S::lift(&edge), radius, radius) + S::lift(&flank.slope()) * beyond,
                None => spherical(r, radius, radius),
            }
        }
        Shape::Hyperboloid { flank, lateral } => {
            let b = S::lift(lateral);
            let s = r.clone() / &b;
            S::lift(&flank.slope()) * s.clone() * r / ((s.square() + s.lit(1)).sqrt() + s.lit(1))
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

/// Where the spherical cap of a cone ends: Rt/√(1 + t²), where the sphere has the slope t of the cone.
fn cap_radius<R: Special>(flank: &Flank<R>, radius: &R) -> R {
    let slope = flank.slope();
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

/// The exponent p of f ≈ c rᵖ at the tip; `None` for a flat face.
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

/// r²/2R, by the ratio r/R.
fn parabola<R: Real, S: Lift<R>>(r: &S, radius: &R) -> S {
    (r.clone() / S::lift(radius) * r).over(2)
}

/// C rⁿ.
fn power<R: Real, S: Lift<R>>(r: &S, exponent: &R, coefficient: &R) -> S {
    let (n, c) = (S::lift(exponent), S::lift(coefficient));
    let power = r.pow(&n);
    let headroom = power.unit_roundoff().square();
    let normal = power.is_finite() && power.clone() * headroom > power.lit(0);
    if normal {
        return power * c;
    }
    // C rⁿ may be in range where rⁿ is not.
    let root = r.pow(&n.over(2));
    root.clone() * c * root
}

/// h(1 − √(1 − s²)) with s = r/b, as h s²/(1 + √((1−s)(1+s))).
fn spherical<R: Real, S: Lift<R>>(r: &S, lateral: &R, height: &R) -> S {
    let s = r.clone() / S::lift(lateral);
    let one = s.lit(1);
    let cosine = ((one.clone() - &s) * (one.clone() + &s)).sqrt();
    s.square() * S::lift(height) / (one + cosine)
}

/// A(1 − cos 2πr/λ) = 2A sin²(πr/λ), which keeps its digits near the tip.
fn waves<R: Real, S: Lift<R>>(r: &S, amplitude: &R, wavelength: &R) -> S {
    let half_phase = r.clone() / S::lift(wavelength) * r.pi();
    (half_phase.sin().square() * S::lift(amplitude)).times(2)
}
