//! Fits of measured curves: E*, w and other unknowns of a contact from force, depth or contact radius, with their errors.
//!
//! A [`Problem`] has a profile, an observation, rows and unknowns; its [`Fit`] has estimates with standard errors, or states what
//! the data do not determine. The theory decides on which branch a row lies and where the contact jumps: no row is clipped, and
//! none is compared with a curve beyond its fold.
//!
//! ```
//! use mdr_fit::{Observation, Problem};
//! use mdr::prelude::*;
//! // A sphere of 10 µm: force against depth, in newtons and metres (a paraboloid with E* = 2 MPa and w = 50 mJ/m²).
//! let depth = [2e-6, 1.5e-6, 1e-6, 5e-7, 0.0, -2e-7];
//! let force = [2.2186360e-5, 1.3808215e-5, 6.7180796e-6, 1.2022626e-6, -2.0943951e-6, -2.2933885e-6];
//! let tip = Shape::Paraboloid { radius: "1e-5" };
//! let fit = Problem::new(tip, Observation::ForceOfIndentation, &depth, &force)?
//!     .free(["e_star", "work_of_adhesion"])?
//!     .fit()?;
//! let e_star = fit.estimate("e_star").and_then(|e_star| e_star.value).expect("determined");
//! assert!((e_star / 2e6 - 1.0).abs() < 1e-4);
//! # Ok::<(), mdr::Error>(())
//! ```
//!
//! # The model
//! A state is a function of its contact radius a: d = g(a) − Δl(a) (1.5), F = 2E*(a d − ∫₀ᵃ g) (1.6). The given quantity, X, and
//! the measured quantity, Y, are listed at [`Observation`]. Stable arcs lie between the folds of X(a). Every row has a label: its
//! arc, or detached; the labels of a leg are those of least cost that are monotone along it.
//!
//! # The objective
//! A row in contact has its orthogonal distance to its arc, the end of the arc included, in units of (σ_X, σ_Y); with x exact,
//! the default, the vertical distance, and the fold is at or beyond the last row of its arc. A detached row has (Y − baseline)/σ_Y.
//! Levenberg–Marquardt leads from several starts to stationary points of the sum of squares, of which the least counts, with exact
//! derivatives: at fixed a, ∂d/∂ln E* = Δl/2 and ∂F/∂ln E* = F + E*aΔl; for numbers of the profile by dual numbers.
//!
//! # Accuracy
//! Estimates in f64, converged to the rounding of the residuals; a common factor of all stated standard deviations does not move them. Standard errors are those of the linearised model.

#![cfg_attr(
    not(any(feature = "toml", feature = "serde")),
    allow(dead_code, unused_imports, reason = "what reads is not called")
)]

mod answer;
mod arcs;
mod budget;
#[cfg(feature = "mp")]
mod certified;
mod contact;
mod data;
mod derivatives;
mod descents;
mod drive;
mod edges;
mod errors;
mod events;
mod foot;
mod hypotheses;
mod hysteresis;
mod judge;
mod labelling;
mod labels;
mod limits;
mod minimise;
mod objective;
mod observation;
mod parameter;
mod pieces;
mod problem;
mod profile;
mod quantities;
mod read;
mod refusals;
mod reported;
mod select;
mod sheet;
mod smoothing;
mod start;
mod steepness;
mod suspects;
mod text;
mod trends;
mod validity;
mod warnings;
mod words;

pub use answer::{
    Attempt, Autocorrelation, BudgetEntry, CertifiedEstimate, CertifiedFit, Fit, FitEstimate, FitEvent, FitLimit,
    FitQuantity, FitStatus, FittedLeg, FittedRow, Invariant, LikelihoodInterval, RunsTest, SkippedRows, SmoothedFit,
};
pub use observation::{Leg, Loss, Observation};
pub use problem::Problem;
pub use text::{CurveColumn, CurveText};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
