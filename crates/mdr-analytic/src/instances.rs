//! The closed forms in doubles, compiled here once for the crates above.
//!
//! In a development build a generic function is compiled by the first crate that calls it with some types, and the
//! crates above share the result. Calling it here has it optimised as this crate is, so that the crates above can do
//! without optimisation. A release shares nothing, and leaves this module out; so do unit tests.

use mdr_core::contact::{Result, Shape, Transform};
use mdr_core::number::Dual;

use crate::profiles::{Sum, closed_form};

type Closed = Box<dyn Transform<f64>>;
type ClosedWithSlopes = Box<dyn Transform<Dual<f64>>>;

#[used]
static OF_SHAPES: fn(Shape<f64>) -> Result<Closed> = closed_form;

/// With slopes by a parameter, as fits take them.
#[used]
static WITH_SLOPES: fn(Shape<Dual<f64>>) -> Result<ClosedWithSlopes> = closed_form;

#[used]
static OF_SUMS: fn(Vec<Closed>) -> Closed = |terms| Box::new(Sum::new(terms));
