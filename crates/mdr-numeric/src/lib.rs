//! The independent numerical route: nothing here knows a closed form of any transform.
//!
//! Heights go in; instabilities, equilibria and loading paths come out. The wavy paraboloid of figure 4 of the source paper
//! has three folds. Pulled off from d = 0 it jumps once, from crest to crest, and then breaks:
//!
//! ```
//! use mdr_core::contact::{Control, Material};
//! use mdr_numeric::branch::Branched;
//! use mdr_numeric::path::{EventKind, Path, Start};
//! use mdr_numeric::{curve::Curve, equilibrium::Branches, profiles::WavyParaboloid, transform::Quadrature};
//!
//! let profile = Quadrature::new(WavyParaboloid::new(1.0, 5e-4, 0.1)?); // R, A, λ in m
//! let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation); // E* in Pa, w in J/m²
//! let branches = Branches::new(Curve::new(&profile, &material, &control))?;
//!
//! let radii: Vec<f64> = branches.folds().iter().map(|fold| fold.contact_radius).collect();
//! assert_eq!(radii.len(), 3);
//! for (radius, six_digits) in radii.iter().zip([0.0189447, 0.0534681, 0.0644590]) {
//!     assert!((radius - six_digits).abs() < 0.5e-7);
//! }
//! // Two of the four equilibria at d = −1.83 mm are stable; which one is taken depends on where the contact came from.
//! assert_eq!(branches.equilibria(&-1.83e-3)?.len(), 4);
//!
//! let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.01])?;
//! let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
//! assert_eq!(kinds, [EventKind::Start, EventKind::Jump, EventKind::Detached, EventKind::End]);
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```
//!
//! * [`profiles`]: heights f(r).
//! * [`transform`]: g, g' and ∫g by quadrature, for any profile.
//! * [`curve`]: the equilibria of (1.5) and (1.6) as a curve, and the direction of change off it.
//! * [`folds`]: the instabilities, by tangency (1.10), under every control.
//! * [`equilibrium`]: all equilibria at a given indentation, force or machine position, and what an instability leads to.
//! * [`branch`]: the curve cut at its folds, as a loading path needs it.
//! * [`admissible`]: whether the surfaces are apart outside of the contact, as the theory assumes.
//! * [`path`]: what the contact does along a loading path.
//! * [`energy`]: the same equilibria from the potential energy (Griffith).
//! * [`springs`]: the elastic foundation of discrete springs, the paper's procedure taken literally.
//! * [`fields`]: pressure, displacement, gap.
//! * [`table`]: measured profiles from a CSV file, transformed exactly.
//! * `proof`, with the feature `mp`: folds with a proof that none is missed.

#![forbid(unsafe_code)]

pub mod admissible;
pub mod branch;
pub mod curve;
pub mod energy;
pub mod equilibrium;
pub mod fields;
pub mod folds;
pub mod path;
pub mod profiles;
#[cfg(feature = "mp")]
pub mod proof;
mod rim;
pub mod springs;
mod survey;
pub mod table;
pub mod transform;
