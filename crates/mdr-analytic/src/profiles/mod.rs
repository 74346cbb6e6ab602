//! The MDR-transformed profiles with closed forms of g, g', the mean of g and G = ∫₀ˣ g.
//!
//! Every profile is a small struct with a validating constructor and implements
//! [`Transform`](mdr_core::contact::Transform). Lengths are in metres, slopes are tan θ. All formulas are generic: the
//! same code gives f64 values, p-bit values and rigorous enclosures. At a kink the slope is the one from inside.
//!
//! | module | profiles | source |
//! |---|---|---|
//! | [`smooth`] | cone, paraboloid, sphere, ellipsoid, hyperboloid | Heß 2011; Popov, Heß & Willert 2019 |
//! | [`punch`] | flat punch, truncated cone and paraboloid, rounded-edge punch | ibid. |
//! | [`capped`] | cone with parabolic and with spherical cap | ibid. |
//! | [`concave`] | displaced paraboloid, parabolic and elliptical dimple | ibid. |
//! | [`wavy`] | paraboloid with concentric waves | Guduru 2007 |
//! | [`closed_form`] | any of them by its [`Shape`](mdr_core::contact::Shape) | |
//!
//! ```
//! use mdr_analytic::profiles::Sphere;
//! use mdr_core::contact::Transform;
//! // The sphere and its paraboloid x²/R: g is 3 % larger already at a = 0.3 R.
//! let ball = Sphere::new(1.0)?;
//! let ratio = ball.g(&0.3)? / 0.09;
//! assert!((ratio - 1.0317).abs() < 1e-4);
//! assert!(ball.g(&1.5).is_err());
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```

pub mod capped;
pub mod concave;
mod edge;
pub mod punch;
mod ranged;
mod shape;
pub mod smooth;
mod sum;
pub mod wavy;

pub use capped::*;
pub use concave::*;
pub use punch::*;
pub use shape::{ClosedReal, closed_form};
pub use smooth::*;
pub use sum::Sum;
pub use wavy::*;

use mdr_core::contact::{Error, Kink, Quantity, Result};
use mdr_core::number::{Real, Special};
use ranged::Scale;

/// The closed forms of a profile, for a radius in their domain.
trait ClosedForm<R: Special>: Scale {
    /// g(x).
    fn g_at(&self, x: &R) -> R;
    /// g'(x).
    fn slope_at(&self, x: &R) -> R;
    /// (1/x) ∫₀ˣ g.
    fn mean_at(&self, x: &R) -> R;
    /// The radius where the profile ends.
    fn end(&self) -> Option<&R> {
        None
    }
    /// Whether the profile ends with a vertical edge; its formulas then also hold at the end.
    fn vertical_edge(&self) -> bool {
        false
    }
    /// Whether g is nondecreasing, as for every f with nondecreasing r f'.
    fn rises(&self) -> bool {
        true
    }
    /// Whether g is nondecreasing from a radius on.
    fn rises_beyond(&self, _x: &R) -> bool {
        self.rises()
    }
    /// The radius at which its formula changes.
    fn edge(&self) -> Option<&R> {
        None
    }
    /// Bounds of g at the edge, or else at a vertical edge or where g diverges, and up to the relative distance
    /// `margin` from it.
    fn at_edge(&self, _margin: &R) -> Option<Kink<R>> {
        None
    }
    /// Returns a radius that lies in (0, end), or at the end with a vertical edge.
    fn checked<'a>(&self, x: &'a R) -> Result<&'a R> {
        let requirement = match self.end() {
            _ if !(*x > x.lit(0) && x.is_finite()) => "positive and finite",
            Some(end) if self.vertical_edge() && !(x <= end) => "no larger than the radius where the profile ends",
            Some(end) if !self.vertical_edge() && !(x < end) => "smaller than the radius where the profile ends",
            _ => return Ok(x),
        };
        Err(Error::domain(Quantity::Radius, x, requirement))
    }
}

/// A length or slope of a profile.
fn positive<R: Real>(name: &'static str, value: R) -> Result<R> {
    Error::require_positive(Quantity::Parameter(name), value)
}

/// `Transform` for profiles with a `ClosedForm`: check the radius, then evaluate.
macro_rules! transform {
    ($($profile:ident),*) => { $crate::profiles::transform!(mdr_core::number::Special: $($profile),*); };
    ($bound:path: $($profile:ident),*) => {$(
        impl<R: $bound> mdr_core::contact::Transform<R> for $profile<R> {
            fn g(&self, x: &R) -> mdr_core::contact::Result<R> {
                $crate::profiles::ranged::evaluate(self, self.checked(x)?, 1, Self::g_at)
            }
            fn slope(&self, x: &R) -> mdr_core::contact::Result<R> {
                $crate::profiles::ranged::evaluate(self, self.checked(x)?, 0, Self::slope_at)
            }
            fn integral(&self, x: &R) -> mdr_core::contact::Result<R> {
                let integral = |profile: &Self, x: &R| profile.mean_at(x) * x;
                $crate::profiles::ranged::evaluate(self, self.checked(x)?, 2, integral)
            }
            fn mean(&self, x: &R) -> mdr_core::contact::Result<R> {
                $crate::profiles::ranged::evaluate(self, self.checked(x)?, 1, Self::mean_at)
            }
            fn outer_radius(&self) -> Option<R> {
                self.end().cloned()
            }
            fn vertical_edge(&self) -> bool {
                ClosedForm::vertical_edge(self)
            }
            fn kinks(&self) -> Vec<R> {
                self.edge().cloned().into_iter().collect()
            }
            fn rises(&self) -> bool {
                ClosedForm::rises(self)
            }
            fn rises_beyond(&self, x: &R) -> bool {
                ClosedForm::rises_beyond(self, x)
            }
            fn kink(&self, index: usize, margin: &R) -> mdr_core::contact::Result<Option<mdr_core::contact::Kink<R>>> {
                Ok(if index == 0 { self.at_edge(margin) } else { None })
            }
        }
    )*};
}
use transform;

/// `closed_form` of a module, for the shapes whose profiles are in it: `None` for any other shape.
macro_rules! shapes {
    ($bound:ident { $($shape:ident { $($field:ident),* } => $profile:expr,)* }) => {
        pub(super) fn closed_form<R: $bound>(
            shape: &mdr_core::contact::Shape<R>,
        ) -> Option<mdr_core::contact::Result<Box<dyn mdr_core::contact::Transform<R>>>> {
            use mdr_core::contact::{Shape, Transform};
            match shape.clone() {
                $(Shape::$shape { $($field),* } => Some($profile.map(|profile| Box::new(profile) as Box<dyn Transform<R>>)),)*
                _ => None,
            }
        }
    };
}
use shapes;

/// `Scale` for a profile, from the function that scales each of its fields.
macro_rules! scaled {
    ($profile:ident { $($field:tt: $by:path),* }) => {
        impl<R: mdr_core::number::Special> $crate::profiles::ranged::Scale for $profile<R> {
            fn scaled(&self, k: i64) -> Option<Self> {
                Some($profile { $($field: $by(&self.$field, k)?),* })
            }
        }
    };
}
use scaled;

/// Profiles that consist of positive numbers, each a [`ratio`](ranged::ratio) or a [`length`](ranged::length).
macro_rules! profiles {
    ($(
        $(#[$doc:meta])*
        pub struct $profile:ident { $($field:ident: $by:path),* }
        impl $of:ident {
            $(#[$new:meta])*
            $access:vis fn new;
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $profile<R> {
            $($field: R),*
        }

        impl<R: mdr_core::number::Special> $of<R> {
            $(#[$new])*
            ///
            /// # Errors
            /// Unless every number is positive and finite.
            $access fn new($($field: R),*) -> mdr_core::contact::Result<Self> {
                Ok($profile { $($field: $crate::profiles::positive(stringify!($field), $field)?),* })
            }
        }

        $crate::profiles::scaled!($profile { $($field: $by),* });
    )*};
}
use profiles;
