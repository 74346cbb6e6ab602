//! The MDR transform (1.1) of any profile, by quadrature.
//!
//! With r = x sinθ and D = r d/dr, partial integration of (1.1) leaves no singularity at either end (f(0) = 0):
//!
//! * g(x) = ∫₀^{π/2} sinθ (1+D)f dθ,
//! * g'(x) = (1/x) ∫₀^{π/2} sinθ D(1+D)f dθ,
//! * G(x) = ∫₀ˣ g = x ∫₀^{π/2} sinθ f dθ.
//!
//! The last needs no nested quadrature: g(s) = d/ds ∫₀ˢ r f(r)/√(s²−r²) dr (Abel), so the outer integral is done. All
//! three are one functional, `I[φ]` = ∫₀^{π/2} sinθ φ(x sinθ) dθ, which this module computes.

mod angles;
mod counted;
#[cfg(feature = "mp")]
mod enclosed;
mod gauss;
mod integral;
mod integrand;
mod line;
#[cfg(feature = "mp")]
mod lost;
mod periodic;
mod powers;
mod quadrature;
pub(crate) mod strides;
mod wave;
pub(crate) mod weight;
mod weighted;

#[cfg(feature = "mp")]
pub use enclosed::{Enclosed, EnclosedWithSlopes};
#[cfg(feature = "mp")]
pub(crate) use enclosed::{is_moderate, onset};
pub use line::LineLoad;
#[cfg(feature = "mp")]
pub use lost::lost_below;
pub use periodic::Periodic;
pub use powers::{Powers, graded_kappa, line_factor};
pub use quadrature::{Quadrature, Rule};
pub use wave::Wave;
pub use weighted::Weighted;
