//! Closed forms of the theory of adhesive contact of axisymmetric profiles: equilibria, critical states and folds of
//! power laws f = C rⁿ, and the transformed profiles g(x) of many other shapes. Every closed form is one generic
//! function over [`Real`](mdr_core::number::Real), documented with its equation number in the source paper. The same
//! function is evaluated in `f64`, in arbitrary precision, over rigorous intervals, and over dual numbers for
//! derivatives.
//!
//! ```
//! use mdr_analytic::{PowerLawContact, PowerLaw};
//! use mdr_core::contact::{Control, Material, Regime};
//! // f = 1 · r^0.25 on rubber: E* = 1 MPa, w = 0.05 J/m².
//! let tip = PowerLawContact::new(PowerLaw::new(0.25, 1.0)?, Material::new(1e6, 0.05)?);
//! assert_eq!(tip.regime()?, Regime::CompleteContact);
//! let critical = tip.critical(&Control::Indentation)?;
//! assert!((critical.indentation / 603.9026733142962 - 1.0).abs() < 1e-13);
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```
//!
//! | task | equation | item |
//! |---|---|---|
//! | transform of a power law, g = κ_n C xⁿ | (1.12) | [`PowerLaw`], [`kappa()`] |
//! | transform of another shape | | [`profiles`], [`struve`] |
//! | elongation of the edge springs at detachment | (1.4) | [`detachment_elongation`] |
//! | d(a), F(a), Π(a, d) | (1.5), (1.6), (1.13), (1.16) | [`PowerLawContact::indentation`], [`PowerLawContact::force`], [`PowerLawContact::energy`] |
//! | tangency d'(a), F'(a) | (1.10), (1.14) | [`PowerLawContact::indentation_slope`], [`PowerLawContact::force_slope`] |
//! | critical states | (1.15) corrected, (1.17) | [`PowerLawContact::critical`] |
//! | folds on a machine of finite stiffness | | [`PowerLawContact::machine_folds`] |
//! | n = 1/2 | (1.18), (1.19) | [`threshold()`], [`PowerLawContact::ratio`], [`PowerLawContact::fate`] |
//! | equilibria at a given d or F | | [`PowerLawContact::equilibria`], [`PowerLawContact::equilibria_at_distance`] |
//! | energy dissipated in a jump | | [`PowerLawContact::energy_lost_at_pull_off`], [`PowerLawContact::energy_lost_at_jump_in`] |
//! | two works of adhesion: preload, pull-off, work of a loop | | [`least_ratio_for_full_pull_off`], [`PowerLawContact::preload_for_full_pull_off`], [`PowerLawContact::pull_off_from`], [`PowerLawContact::loop_work`] |
//! | all power laws as one family | | [`universal_indentation`], [`universal_force`] |
//! | paraboloid, cone, flat punch | | [`PowerLaw::paraboloid`], [`PowerLaw::cone`], [`flat_punch_pull_off`] |
//! | range of adhesion: Tabor's number, Maugis's states of a paraboloid | | [`tabor_number`], [`maugis_state`] |
//! | graded half-space, Winkler foundation, line contact, wave of Johnson (1995) | | [`media`] |
//! | `f64` within 1 ulp; batches | | [`double`], [`double::grid`] |
//! | any number of proved digits | | `certified` |
//!
//! The sensitivity to an input is the slope of a dual number, here that of the pull-off force to the exponent:
//!
//! ```
//! use mdr_analytic::{PowerLawContact, PowerLaw};
//! use mdr_core::contact::{Control, Material};
//! use mdr_core::number::Dual;
//! let constant = |x| Dual::constant(x);
//! let profile = PowerLaw::new(Dual::variable(2.0), constant(0.5))?;
//! let contact = PowerLawContact::new(profile, Material::new(constant(1.0), constant(1.0))?);
//! let force = contact.critical(&Control::Indentation)?.force;
//! let relative = force.slope / force.value;
//! assert!((relative - -0.3149099619498).abs() < 1e-12);
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```
//!
//! # Features
//! `mp` (default): `certified`, and κ_n and the Struve functions over `rug::Float` and `Interval`. Without it the crate
//! is pure Rust.
//!
//! # Accuracy and errors
//! A generic function is accurate to the roundings of its formula and rigorous over intervals; [`double`] is within
//! 1 ulp of the true value. Inputs outside their domain give [`Error::Domain`](mdr_core::contact::Error::Domain), results
//! out of range [`Error::OutOfRange`](mdr_core::contact::Error::OutOfRange) with their log₁₀, and decisions that an interval
//! cannot make [`Error::Undecided`](mdr_core::contact::Error::Undecided).

#![forbid(unsafe_code)]

#[cfg(feature = "mp")]
pub mod certified;
mod contact;
mod critical;
pub mod double;
mod hysteresis;
mod inverse;
mod jump;
mod kappa;
mod machine;
mod maugis;
pub mod media;
mod newton;
mod power_law;
pub mod profiles;
mod range;
mod special;
mod state;
pub mod struve;
mod threshold;
mod universal;

pub use contact::{PowerLawContact, detachment_elongation};
pub use hysteresis::{LoopWork, least_ratio_for_full_pull_off};
pub use inverse::Equilibria;
pub use kappa::{Kappa, kappa};
#[cfg(feature = "mp")]
pub use kappa::{free_cache, kappa_enclosure};
pub use maugis::{MaugisState, maugis_state, tabor_number};
pub use power_law::PowerLaw;
pub use special::flat_punch_pull_off;
pub use state::State;
pub use threshold::{ScaleFreeOutcome, lemniscate_constant, threshold};
pub use universal::{universal_force, universal_indentation};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
