//! Transforms and searches in doubles, compiled here once for the crates above.
//!
//! In a development build a generic function is compiled by the first crate that calls it with some types, and the
//! crates above share the result. Calling it here has it optimised as this crate is, so that the crates above can do
//! without optimisation. A release shares nothing, and leaves this module out; so do unit tests.

use mdr_core::contact::{ExpressionProfile, Profile, Result, Transform};

use crate::contact::Contact;
use crate::equilibrium::SearchedBranches;
use crate::folds::{self, Folds};
use crate::function::Function;
use crate::path::{Path, Start};
use crate::profiles::Heights;
use crate::table::MeasuredProfile;
use crate::transform::{LineLoad, Periodic, Powers, Quadrature, Wave, Weighted};

type Branches = SearchedBranches<f64>;
type Doubles = Box<dyn Transform<f64>>;

#[used]
static OF_SHAPES: fn(&Heights<f64>) -> Result<[Doubles; 3]> = |heights| by_quadrature(|| heights.clone());

#[used]
static OF_FORMULAS: fn(&ExpressionProfile<f64>) -> Result<[Doubles; 3]> = |formula| by_quadrature(|| formula.clone());

#[used]
static OF_FUNCTIONS: fn(&Function) -> Result<[Doubles; 3]> =
    |function| by_quadrature(|| function.in_arithmetic::<f64>(()).expect("this arithmetic is f64"));

#[used]
static OF_ROWS: fn(&MeasuredProfile<f64>) -> Result<[Doubles; 3]> = |rows| by_quadrature(|| rows.clone());

#[used]
static ROWS: fn(MeasuredProfile<f64>) -> Doubles = |rows| Box::new(rows);

#[used]
static ROWS_ON_MEDIA: fn(MeasuredProfile<f64>) -> Result<Doubles> = |rows| Ok(Box::new(rows.winkler()?));

#[used]
static WAVE: fn(Wave<f64>) -> Doubles = |wave| Box::new(wave);

#[used]
static POWERS: fn(Powers<f64>) -> Doubles = |powers| Box::new(powers);

#[used]
static LINE_LOAD: fn(LineLoad<f64>) -> Doubles = |load| Box::new(load);

#[used]
static FOLDS: fn(&Contact<f64>) -> Result<Folds<f64>> = folds::find;

#[used]
static EQUILIBRIA: fn(Contact<f64>) -> Result<Branches> = SearchedBranches::new;

#[used]
#[expect(clippy::type_complexity, reason = "the type of a function with three parameters")]
static PATHS: fn(&Branches, &Start<f64>, &[f64]) -> Result<Path<f64>> = Path::follow;

/// In arbitrary precision, which the cross-check integrates.
#[cfg(feature = "mp")]
#[used]
static FLOATS: fn(Heights<rug::Float>) -> Box<dyn Transform<rug::Float>> = |heights| Box::new(Quadrature::new(heights));

/// The transforms of a profile on every medium.
fn by_quadrature<P: Profile<f64> + 'static>(profile: impl Fn() -> P) -> Result<[Doubles; 3]> {
    Ok([
        Box::new(Quadrature::new(profile())),
        Box::new(Weighted::winkler(profile(), 1.0)),
        Box::new(Periodic::new(profile(), 1.0)?),
    ])
}
