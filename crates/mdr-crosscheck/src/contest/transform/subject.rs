//! The profiles that are transformed, and the truth about them.

use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::contact::{Profile, Result};
use mdr_core::number::{Interval, Lift, Precision, Real};
use mdr_numeric::profiles::Power;

use super::super::kappa;
use crate::library::{Height, Shape, closed_form};

/// What is asked: g at one radius. All numbers are the doubles that they are, in every arithmetic.
pub(in super::super) struct Question {
    /// The end of the name of the diagram.
    pub(super) id: String,
    /// The profile in words and the radius.
    pub(super) title: String,
    /// The profile.
    pub(super) profile: Kind,
    /// x.
    pub(in super::super) x: f64,
}

pub(super) enum Kind {
    /// f = rⁿ.
    Power(f64),
    /// One of the library, with its parameters.
    Shape(Shape, Vec<f64>),
}

/// A profile as a height, in one arithmetic.
pub(super) enum Heights<R> {
    Power(Power<R>),
    Shape(Height<R>),
}

/// The powers r^n.
pub(super) const EXPONENTS: [f64; 7] = [0.05, 0.25, 0.5, 1.0, 2.0, 3.7, 20.0];

/// All questions.
pub(super) fn questions() -> Vec<Question> {
    let shape = |id: &str, words: &str, shape, parameters: &[f64], x| Question {
        id: id.to_owned(),
        title: format!("g(x) of {words} at x = {x}"),
        profile: Kind::Shape(shape, parameters.to_vec()),
        x,
    };
    let mut questions = Vec::from(EXPONENTS.map(Question::power));
    let cone = [0.5, 0.3];
    questions.extend([
        shape("sphere", "the sphere of radius 1", Shape::Sphere, &[1.0], 0.6),
        shape("truncated-cone", "the cone of slope 1/2, flat up to r = 0.3", Shape::TruncatedCone, &cone, 0.7),
        shape("capped-cone", "the cone of slope 1/2, a paraboloid up to r = 0.3", Shape::ParabolicCapCone, &cone, 0.7),
        shape("wavy", "the wavy paraboloid of figure 4 of the paper", Shape::WavyParaboloid, &[1.0, 5e-4, 0.1], 0.73),
    ]);
    questions
}

impl Question {
    /// g(0.7) of f = rⁿ.
    pub(in super::super) fn power(n: f64) -> Self {
        Question {
            id: format!("power-{n}"),
            title: format!("g(x) of f = r^{n} at x = 0.7"),
            profile: Kind::Power(n),
            x: 0.7,
        }
    }

    /// The heights of the profile.
    pub(super) fn heights<R: Real>(&self, ctx: R::Ctx) -> Result<Heights<R>> {
        Ok(match &self.profile {
            Kind::Power(n) => Heights::Power(Power::new(R::from_f64(ctx, *n), R::from_int(ctx, 1))?),
            Kind::Shape(shape, parameters) => {
                Heights::Shape(Height { shape: *shape, parameters: lift(ctx, parameters) })
            }
        })
    }

    /// An enclosure of g(x) by its closed form.
    pub(super) fn truth(&self, precision: Precision) -> Result<Interval> {
        let x = Interval::from_f64(precision, self.x);
        match &self.profile {
            Kind::Power(n) => {
                let n = Interval::from_f64(precision, *n);
                Ok(kappa::exact(&n) * x.pow(&n))
            }
            Kind::Shape(shape, parameters) => closed_form::<Interval>(*shape, &lift(precision, parameters))?.g(&x),
        }
    }

    /// |x g'/g|, what a relative change of x is multiplied by.
    pub(super) fn condition(&self) -> Result<f64> {
        match &self.profile {
            Kind::Power(n) => Ok(*n),
            Kind::Shape(shape, parameters) => {
                let closed = closed_form(*shape, parameters)?;
                Ok((self.x * closed.slope(&self.x)? / closed.g(&self.x)?).abs())
            }
        }
    }

    /// Where the truth comes from.
    pub(super) fn source(&self) -> &'static str {
        match self.profile {
            Kind::Power(_) => {
                "κ_n xⁿ (1.12) over intervals, κ_n from the Γ of MPFR; every contestant integrates heights"
            }
            Kind::Shape(..) => "the closed form of g over intervals; every contestant integrates heights",
        }
    }
}

/// The same numbers, exactly.
fn lift<R: Real>(ctx: R::Ctx, values: &[f64]) -> Vec<R> {
    values.iter().map(|value| R::from_f64(ctx, *value)).collect()
}

impl<R: Real> Profile<R> for Heights<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        match self {
            Heights::Power(power) => power.height(r),
            Heights::Shape(height) => height.height(r),
        }
    }
    fn kinks(&self) -> Vec<R> {
        match self {
            Heights::Power(power) => power.kinks(),
            Heights::Shape(height) => height.kinks(),
        }
    }
    fn outer_radius(&self) -> Option<R> {
        match self {
            Heights::Power(power) => power.outer_radius(),
            Heights::Shape(height) => height.outer_radius(),
        }
    }
    fn tip_exponent(&self) -> Option<R> {
        match self {
            Heights::Power(power) => power.tip_exponent(),
            Heights::Shape(height) => height.tip_exponent(),
        }
    }
}

/// A profile that counts how often it is asked for its height, or leaves it.
pub(super) struct Counted<'a, R> {
    pub(super) heights: &'a Heights<R>,
    pub(super) count: Option<&'a AtomicU64>,
}

impl<R: Real> Profile<R> for Counted<'_, R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        if let Some(count) = self.count {
            count.fetch_add(1, Ordering::Relaxed);
        }
        self.heights.height(r)
    }
    fn kinks(&self) -> Vec<R> {
        self.heights.kinks()
    }
    fn outer_radius(&self) -> Option<R> {
        self.heights.outer_radius()
    }
    fn tip_exponent(&self) -> Option<R> {
        self.heights.tip_exponent()
    }
}
