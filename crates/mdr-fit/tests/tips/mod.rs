//! Tips with their transform by hand, and what a fit says of a number.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::f64::consts::PI;

use mdr::prelude::*;
use mdr_fit::Fit;

/// g and its integral, by hand.
type Formula = fn(f64) -> [f64; 2];

/// A tip, and the largest contact radius that is seen.
pub(crate) struct Tip {
    pub(crate) shape: Shape<&'static str>,
    pub(crate) formula: Formula,
    pub(crate) widest: f64,
}

pub(crate) fn tips() -> Vec<Tip> {
    let tip = |shape, formula, widest| Tip { shape, formula, widest };
    vec![
        tip(Shape::Paraboloid { radius: "1e-5" }, |x| [x * x / 1e-5, x.powi(3) / 3e-5], 6e-6),
        tip(Shape::Cone { flank: Flank::Slope("0.4") }, |x| [0.2 * PI * x, 0.1 * PI * x * x], 3e-6),
        tip(
            Shape::Sphere { radius: "1e-5" },
            |x| [x * (x / 1e-5).atanh(), 0.5 * (x * x - 1e-10) * (x / 1e-5).atanh() + 0.5e-5 * x],
            5e-6,
        ),
        tip(
            Shape::Hyperboloid { flank: Flank::Slope("0.36"), lateral: "1e-6" },
            |x| [0.36 * x * (x / 1e-6).atan(), 0.18 * ((x * x + 1e-12) * (x / 1e-6).atan() - 1e-6 * x)],
            3e-6,
        ),
        tip(
            Shape::TruncatedParaboloid { radius: "1e-5", flat: "1e-6" },
            |x| match x > 1e-6 {
                true => [x / 1e-5 * (x * x - 1e-12).sqrt(), (x * x - 1e-12).powf(1.5) / 3e-5],
                false => [0.0; 2],
            },
            6e-6,
        ),
    ]
}

pub(crate) const E_STAR: f64 = 2e6;
pub(crate) const CONTACT_POINT: f64 = 1e-7;

/// The value of a number and its standard error.
pub(crate) fn estimate(fit: &Fit, name: &str) -> [f64; 2] {
    let estimate = fit.estimate(name).unwrap();
    [estimate.value.unwrap_or(f64::NAN), estimate.stderr.unwrap_or(f64::NAN)]
}
