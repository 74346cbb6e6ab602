//! Adhesive contact by numerical methods: heights f(r) in; folds, equilibria, loading paths, energies and fields out. No
//! closed form of a transform is used here, so the results are independent of the analytic crate. The example is the wavy
//! paraboloid of figure 4 of the source paper, which has three folds. Pulled off from d = 0 it jumps once, from crest to
//! crest, and then breaks.
//!
//! ```
//! use std::sync::Arc;
//! use mdr_core::contact::{Control, Material, Shape};
//! use mdr_numeric::branch::EquilibriumBranches;
//! use mdr_numeric::path::{EventKind, Path, Start};
//! use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
//!
//! let profile = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }])?); // R, A, λ in m
//! let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation); // E* in Pa, w in J/m²
//! let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control))?;
//!
//! let radii: Vec<f64> = branches.folds().iter().map(|fold| fold.contact_radius).collect();
//! assert_eq!(radii.len(), 3);
//! for (radius, six_digits) in radii.iter().zip([0.0189447, 0.0534681, 0.0644590]) {
//!     assert!((radius - six_digits).abs() < 0.5e-7);
//! }
//! // Two of the four equilibria at d = −1.83 mm are stable; the history of the contact selects one of them.
//! assert_eq!(branches.equilibria(&-1.83e-3)?.len(), 4);
//!
//! let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.01])?;
//! let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
//! assert_eq!(kinds, [EventKind::Start, EventKind::Jump, EventKind::Detached, EventKind::End]);
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```
//!
//! | task | module |
//! |---|---|
//! | heights f(r) | [`profiles`]; measured ones from a CSV file: [`table`]; of your own: [`function`] |
//! | g, g' and ∫g of any profile, by quadrature | [`transform`] |
//! | the elastic medium, as a row of springs | [`medium`] |
//! | a profile on a medium: states (a, d, F) by (1.5) and (1.6), and the direction of change off equilibrium | [`contact`] |
//! | folds by tangency (1.10), under every control | [`folds`] |
//! | equilibria at an indentation, a force or a machine position | [`equilibrium`] |
//! | outcome of an instability; the curve cut at its folds | [`branch`] |
//! | loading paths, their work and dissipation | [`path`] |
//! | whether the surfaces are separated outside the contact, as the theory assumes | [`admissible`] |
//! | pressure, displacement, gap | [`fields`] |
//! | adhesion of finite range: Tabor's number, Maugis–Dugdale states | [`dugdale`] |
//! | the same equilibria from the potential energy (Griffith) | [`energy`] |
//! | the elastic foundation of discrete springs, the procedure of the paper | [`springs`] |
//! | folds and equilibria with a proof of completeness | `proof` |
//!
//! # Features
//! `mp` (default): `proof`, and all methods in arbitrary precision. Without it the crate is pure Rust.
//!
//! # Accuracy and errors
//! Quadrature is accurate to 32 unit roundoffs of the integral of the magnitude unless a tolerance is set, and returns an
//! error estimate. A search in `f64` or arbitrary precision reports its [`SearchQuality`](folds::SearchQuality), which is
//! no proof; over intervals results are proved. Decisions that an arithmetic cannot make are
//! [`Error::Undecided`](mdr_core::contact::Error::Undecided), integrals that miss their tolerance
//! [`Error::NoConvergence`](mdr_core::contact::Error::NoConvergence).

#![forbid(unsafe_code)]

pub mod admissible;
pub mod branch;
pub mod contact;
pub mod dugdale;
pub mod energy;
mod equator;
pub mod equilibrium;
pub mod fields;
pub mod folds;
pub mod function;
#[cfg(all(debug_assertions, not(test)))]
mod instances;
pub mod medium;
pub mod path;
pub mod profiles;
#[cfg(feature = "mp")]
pub mod proof;
#[cfg(feature = "mp")]
mod recent;
pub mod springs;
mod survey;
pub mod table;
pub mod tabulated;
pub mod transform;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
