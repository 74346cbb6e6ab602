//! Adhesive contacts of axisymmetric tips: pull-off forces, jumps and force curves, with digits that are proved.
//!
//! A [`Scene`] has a contact, its control, and the requested outputs; its [`Answer`] has a typed output for each request, and
//! every number carries its [promise](answer::Promise) or the reason why there is none.
//!
//! ```
//! use mdr::prelude::*;
//! // A sphere of 1 cm on rubber, pulled off under a dead load: JKR's −3/2 π w R, to twenty proved digits.
//! let tip = Shape::Paraboloid { radius: "0.01" };
//! let scene = Scene::new(tip, Elasticity::effective("1e6")?, "0.05")?.control(Control::Force).want(Want::Folds { range: None });
//! # #[cfg(feature = "mp")] {
//! let answer = scene.solve()?;
//! let pull_off = &answer.folds().expect("wanted").items[0].force;
//! assert_eq!(pull_off.to_string(), "-0.0023561944901923449288");
//! # }
//! # Ok::<(), mdr::Error>(())
//! ```
//!
//! This scene as TOML, for [`Scene::from_toml`] and the command line:
//!
//! ```toml
//! [profile]
//! kind = "paraboloid"
//! radius = 0.01
//! [material]
//! e_star = 1e6
//! work_of_adhesion = 0.05
//! [control]
//! kind = "force"
//! [output]
//! want = ["folds"]
//! ```
//!
//! # A profile of your own
//!
//! A tip is a shape of the library, a formula, measured rows, or a function of your program: [`Function`](contact::Function), from a
//! closure that gives f, f' and f'', or over numbers that carry their derivatives. It solves scenes in f64, like any other profile:
//!
//! ```
//! use mdr::contact::Function;
//! use mdr::prelude::*;
//! // A blunt tip f = r⁴/4L³, L = 20 nm, pulled off a solid of 1 GPa under a dead load.
//! let length = 20e-9_f64;
//! let tip = Function::new(move |r| [r.powi(4) / 4.0, r.powi(3), 3.0 * r.powi(2)].map(|x| x / length.powi(3)))?;
//! let scene = Scene::new(tip, Elasticity::effective("1e9")?, "0.05")?
//!     .control(Control::Force)
//!     .want(Want::Folds { range: None })
//!     .arithmetic(Arithmetic::F64);
//! let pull_off = scene.solve()?.folds().expect("wanted").items[0].force.to_f64().expect("a number");
//! // The power law with n = 4 and C = 1/4L³.
//! let law = Shape::Power { n: 4.0, c: 1.0 / (4.0 * length.powi(3)) };
//! let closed = Scene::new(law, Elasticity::effective("1e9")?, "0.05")?.control(Control::Force).contact()?;
//! assert!((pull_off / mdr::contact::folds::find(&closed)?[0].force - 1.0).abs() < 1e-9);
//! # Ok::<(), mdr::Error>(())
//! ```
//!
//! Rows are a profile by [`Measured::from_rows`](scene::Measured::from_rows). [`Scene::contact`] is the contact of a scene, for questions
//! that no output has, and [`contact`] builds one from a profile or a transform g of your own.
//!
//! # Where to find it
//!
//! | task | where |
//! |---|---|
//! | describe a contact | [`Scene`], [`Shape`](prelude::Shape), [`Profile`](scene::Profile), [`Want`](prelude::Want) |
//! | read it from a file | [`Scene::open`], [`Scene::from_toml`], `Scene::from_json` |
//! | solve it | [`Scene::solve`]; with progress, or until stopped: [`Scene::solve_with`] |
//! | use the answer | [`Answer`], its [`folds`](Answer::folds), [`path`](Answer::path), … |
//! | print it | `Answer::to_json`, [`Output::table`](answer::Output::table); in units and notations [`NumberStyle`](answer::NumberStyle) |
//! | draw it | [`Scene::diagram`] |
//! | fit a measured curve | the crate `mdr-fit` |
//! | one power law, at a point | [`critical()`] |
//! | whether the theory holds | [`Scene::range_of_adhesion`], [`validity`] |
//! | many states in f64, from slices | [`batch`] |
//! | one contact at arrays of values | [`columns`] |
//! | a profile of your own, from a closure or slices | [`Function`](contact::Function), [`Measured::from_rows`](scene::Measured::from_rows) |
//! | a transform g of your own, any state, in any arithmetic | [`contact`] |
//!
//! # Features
//! * `mp` (default): certified digits, by GMP and MPFR. Without it the crate is pure Rust, builds for `wasm32-unknown-unknown`,
//!   and answers in f64; certified digits are [`Error::NeedsMp`]. E* of two bodies and f(0) = 0 of a formula are then decided in
//!   doubles, formulas with `abs`, `min` or `max` are refused, and numbers out of range have their log₁₀ if f64 can compute it.
//! * `toml`, `serde` (default): scenes as TOML; scenes and answers as JSON.
//!
//! # Accuracy
//! Certified digits are proved and correctly rounded. Doubles are accurate to some roundings times the condition of the question,
//! and never stand in for a number that f64 cannot hold.
//!
//! # What mdr does not do
//! * **Adhesion of long range**: only Tabor's number, and the states and pull-off force of Maugis–Dugdale: [`validity`].
//! * **Friction and tangential loads**: surfaces slide freely, and the load is normal.
//! * **Viscosity, plasticity, wear, electric charge, capillary bridges**: bodies are linearly elastic, and w depends on no rate.
//! * **Layers and thin samples**: the elastic body is deep against the contact.
//! * **Large strains and steep flanks**: slopes are small against 1; [`validity`] has the slope at the edge.
//! * **Several contacts**: the contact is one disc. A state whose surfaces would overlap outside of it is marked as not admissible.
//! * **Bodies without an axis**: profiles are f(r), or f(x) of a line contact.
//! * **Dynamics**: a jump leads to the next equilibrium at once; its energy is reported, its duration is not.
//!
//! # Documents of the repository
//! `docs/theory.md` restates the theory, `docs/scenes.md` has all keys of a scene, `docs/validity.md` helps to decide whether the theory
//! holds, `docs/fit.md` is about fits, `docs/accuracy.md` about what each arithmetic promises, `docs/conformance.md` leads from
//! equations to functions and tests, `docs/contributing.md` has recipes for additions. `make book` shows them as pages.

#![forbid(unsafe_code)]

pub mod answer;
#[cfg(all(feature = "mp", feature = "serde"))]
mod certificate;
pub mod columns;
pub mod critical;
pub mod diagram;
mod error;
pub mod files;
mod outputs;
mod run;
pub mod scene;
mod solve;
pub mod validity;

pub use answer::Answer;
pub use critical::critical;
pub use error::{Error, Place, Result};
pub use mdr_core::contact::Error as ContactError;
pub use mdr_core::units;
pub use run::{ARITHMETICS, BUDGET, Cost, Observer, Run, Stop, free_thread_cache};
pub use scene::{Scene, no_files};
pub use validity::Validity;

/// Critical states of many power laws in f64: slices in, slices out.
pub mod batch {
    pub use mdr_analytic::double::grid::*;
}

/// One contact in Rust: a profile or a transform of your own on a medium, with every computation of the library in any arithmetic.
///
/// ```
/// use mdr::contact::{Adhesion, Contact, Function, Medium, Quadrature, folds};
/// use mdr::prelude::*;
/// // A tip f = r²/2R + r⁴/8R³, from f, f' and f''; R = 20 nm.
/// let r0 = 20e-9_f64;
/// let tip = Function::new(move |r| {
///     let s = r / r0;
///     [r0 * (s * s / 2.0 + s.powi(4) / 8.0), s + s.powi(3) / 2.0, (1.0 + 1.5 * s * s) / r0]
/// })?;
/// let contact = Contact::new(Quadrature::new(tip), Medium::half_space(1e9)?, Adhesion::new(0.05)?, Control::Force);
/// let pull_off = folds::find(&contact)?[0].force;
/// assert!(pull_off < 0.0 && (pull_off / -4.7124e-9 - 1.0).abs() < 0.02); // near −3/2 πwR
/// # Ok::<(), mdr::ContactError>(())
/// ```
///
/// Where g is known, a [`Transform`](contact::Transform) is all that a contact needs: g, g' and the integral of g. A paraboloid
/// has g = x²/R:
///
/// ```
/// use mdr::ContactError;
/// use mdr::contact::{Adhesion, Contact, EquilibriumBranches, Medium, SearchedBranches, Transform};
/// use mdr::prelude::*;
/// struct Ball(f64);
/// impl Transform<f64> for Ball {
///     fn g(&self, x: &f64) -> Result<f64, ContactError> {
///         Ok(x * x / self.0)
///     }
///     fn slope(&self, x: &f64) -> Result<f64, ContactError> {
///         Ok(2.0 * x / self.0)
///     }
///     fn integral(&self, x: &f64) -> Result<f64, ContactError> {
///         Ok(x.powi(3) / (3.0 * self.0))
///     }
/// }
/// let contact = Contact::new(Ball(1e-6), Medium::half_space(1e6)?, Adhesion::new(0.05)?, Control::Force);
/// let branches = SearchedBranches::new(contact)?;
/// assert!((branches.folds()[0].force / (-1.5 * std::f64::consts::PI * 0.05 * 1e-6) - 1.0).abs() < 1e-13);
/// // Two equilibria under a pull; the one with the larger radius is stable.
/// let found = branches.equilibria(&-2e-7)?;
/// assert_eq!(found.iter().map(|state| state.stability).collect::<Vec<_>>(), [Stability::Unstable, Stability::Stable]);
/// # Ok::<(), ContactError>(())
/// ```
pub mod contact {
    pub use mdr_core::contact::{Profile, Transform};
    pub use mdr_numeric::admissible;
    pub use mdr_numeric::branch::EquilibriumBranches;
    pub use mdr_numeric::contact::{Contact, Input};
    pub use mdr_numeric::equilibrium::SearchedBranches;
    pub use mdr_numeric::fields::Fields;
    pub use mdr_numeric::folds;
    pub use mdr_numeric::function::{Differentiated, Function};
    pub use mdr_numeric::medium::{Adhesion, Medium};
    pub use mdr_numeric::path;
    pub use mdr_numeric::transform::{LineLoad, Powers, Quadrature, Wave, Weighted, graded_kappa};

    pub use crate::scene::{ProfileReal, SceneReal};
    pub use crate::solve::GradedReal;
}

/// The reader of TOML and JSON with places, for documents that contain parts of scenes: a fit, for example.
pub mod reading {
    #[cfg(feature = "serde")]
    pub use crate::scene::parse::json;
    pub use crate::scene::parse::{Source, open, toml};
    pub use crate::scene::place::Location;
    pub use crate::scene::tree::{InputValue, Section, unknown_name_of_input};
}

/// The items that a program needs: `use mdr::prelude::*`.
pub mod prelude {
    pub use mdr_core::contact::{
        Body, Control, ControlKind, Edge, Elasticity, Flank, FoldKind, Shape, Stability, Status,
    };
    pub use mdr_core::number::{Exact, Literal};
    pub use mdr_numeric::path::EventKind;

    pub use crate::answer::{Answer, Field, Number, Output, OutputKind, Promise, Value};
    pub use crate::scene::{Arithmetic, ExactMedium, Formula, Grading, Measured, Profile, Scene, Start, Want};
    pub use crate::{Error, Observer, Run, Stop};
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
