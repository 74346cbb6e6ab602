//! Charts of adhesive contacts: an SVG for the eye, and its data as CSV.
//!
//! ```
//! use mdr::prelude::*;
//! // An AFM tip of 50 nm on mica is pulled off under a dead load.
//! let tip = Shape::Paraboloid { radius: "50e-9" };
//! let scene = Scene::new(tip, Elasticity::effective("5e10")?, "0.1")?
//!     .control(Control::Force)
//!     .path(["0", "-1e-7"])?
//!     .arithmetic(Arithmetic::F64);
//! let picture = mdr_plot::scene("AFM tip", &scene.diagram()?);
//! assert!(picture.svg().contains("<title>AFM tip</title>"));
//! assert!(picture.csv().lines().any(|row| row.starts_with("2,arrow,detached,")));
//! # Ok::<(), mdr::Error>(())
//! ```
//!
//! Charts of other data are made of the same parts:
//!
//! ```
//! use mdr_plot::{Axis, Colour, Mark, Panel, Picture, Unit};
//! let time = Axis::log("time", Unit::Si("s"), 1e-6, 1e-2);
//! let error = Axis::log("relative error", Unit::One, 1e-16, 1.0);
//! let mut panel = Panel::new("(a)  quadrature", time, error);
//! panel.series("Gauss–Jacobi", vec![[1e-5, 1e-3], [2e-5, 1e-9]], Mark::Filled, Colour::series(0));
//! let picture = Picture { title: "Error against time".into(), description: "…".into(), panels: vec![panel] };
//! assert!(picture.svg().contains("Gauss–Jacobi"));
//! ```
//!
//! | task | where |
//! |---|---|
//! | draw a scene | [`scene()`] of [`Scene::diagram`](mdr::Scene::diagram) |
//! | draw a fit | `fit()`, with the feature `fit` |
//! | draw figures 1 to 4 of the theory, and one of a wave | [`figures`] |
//! | draw judged answers of another program | [`judged()`] of a [`Report`](mdr_reference::Report) |
//! | draw methods by time and error | [`comparison()`] |
//! | draw anything else | [`Picture`], [`Panel`], [`Axis`], [`Layer`] |
//! | write it | [`Picture::svg`], [`Picture::svg_in`] a [`Theme`], [`Picture::svg_on`] a [`Sheet`], [`Picture::csv`] |
//! | write one panel of it | [`Picture::only`] |
//!
//! # Markup
//! Names and texts may have `*a*` for slanted letters, `_{c}` for an index below and `^{1/4}` for one above the line.

#![forbid(unsafe_code)]

mod axis;
mod balance;
mod chart;
mod comparison;
mod data;
pub mod figures;
#[cfg(feature = "fit")]
mod fit;
mod judged;
mod loading;
mod markup;
mod scene;
mod svg;

pub use axis::{Axis, Unit, typographic};
pub use chart::{Colour, Layer, Look, Mark, Panel, Picture, Point, Side, Stroke, Theme};
pub use comparison::{ComparedMethod, ComparedQuestion, comparison};
pub use data::{CSV_HEADER, is_data};
#[cfg(feature = "fit")]
pub use fit::fit;
pub use judged::judged;
pub use scene::scene;
pub use svg::Sheet;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
