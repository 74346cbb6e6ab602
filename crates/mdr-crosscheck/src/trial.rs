//! One case of a check: its inputs, drawn from its index alone, and its comparisons.

use std::fmt;

use mdr_core::contact::Result;
use mdr_core::number::{Precision, Real};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};
use rug::Float;

use crate::report::Finding;
use crate::subject::closed::ClosedForms;

/// A function that runs a case.
pub(crate) type Case = fn(&mut Trial<'_>) -> Result<()>;

/// One case: where its inputs come from and where its comparisons go.
#[derive(Debug)]
pub(crate) struct Trial<'a> {
    /// The closed forms under test.
    pub(crate) closed: &'a ClosedForms,
    /// The precision of arbitrary-precision cases.
    pub(crate) precision: Precision,
    /// The index of the case among those of its check.
    pub(crate) index: usize,
    random: Xoshiro256PlusPlus,
    /// The inputs, as a report prints them.
    pub(crate) inputs: String,
    /// The comparisons; empty if the question is impossible in this arithmetic.
    pub(crate) comparisons: Vec<Finding>,
    /// Why a route gave no number, or an error where there must be an answer.
    pub(crate) broken: Option<String>,
}

impl<'a> Trial<'a> {
    /// Case `index` of the check `name`. Its random numbers depend on the seed, the name and the index, on nothing else.
    pub(crate) fn new(closed: &'a ClosedForms, precision: Precision, seed: u64, name: &str, index: usize) -> Self {
        let stream = name.bytes().fold(seed ^ 0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        let random = Xoshiro256PlusPlus::seed_from_u64(stream.wrapping_add(index as u64));
        let (inputs, comparisons) = (String::new(), Vec::new());
        Trial { closed, precision, index, random, inputs, comparisons, broken: None }
    }

    /// Runs `case` on this trial.
    pub(crate) fn run(mut self, case: Case) -> Self {
        if let Err(error) = case(&mut self) {
            self.broken = Some(error.to_string());
        }
        self.comparisons.iter_mut().for_each(|finding| finding.inputs.clone_from(&self.inputs));
        self
    }

    /// A number in [low, high), uniform.
    pub(crate) fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.random::<f64>()
    }

    /// Writes the inputs down, for the report.
    pub(crate) fn describe(&mut self, inputs: impl fmt::Display) {
        self.inputs = inputs.to_string();
    }

    /// Adds to the inputs written down.
    pub(crate) fn describe_also(&mut self, input: impl fmt::Display) {
        self.inputs = format!("{}, {input}", self.inputs);
    }

    /// Enters an error with its bound, both in the unit of the row. An error that is not a finite number breaks the case.
    pub(crate) fn enter(&mut self, quantity: impl Into<String>, error: f64, allowed: f64) {
        let quantity = quantity.into();
        if error.is_finite() && !allowed.is_nan() {
            self.comparisons.push(Finding { index: self.index, quantity, error, allowed, inputs: String::new() });
        } else {
            self.fail(format!("{quantity}: the two routes cannot be compared (error {error}, allowed {allowed})"));
        }
    }

    /// Compares two numbers: the relative difference in unit roundoffs of their arithmetic, against `allowed` of them.
    pub(crate) fn compare<R: Real>(&mut self, quantity: impl Into<String>, found: &R, expected: &R, allowed: f64) {
        self.enter(quantity, roundoffs(found, expected), allowed);
    }

    /// Compares two numbers that come out of a cancellation: their difference in unit roundoffs of `scale`, the size of
    /// the terms that cancel.
    pub(crate) fn compare_on<R: Real>(
        &mut self,
        quantity: impl Into<String>,
        found: &R,
        expected: &R,
        scale: &R,
        allowed: f64,
    ) {
        self.enter(quantity, roundoffs_on(found, expected, scale), allowed);
    }

    /// Demands a fact; enters 0 or 1 against 0.
    pub(crate) fn demand(&mut self, fact: impl Into<String>, holds: bool) {
        self.enter(fact, if holds { 0.0 } else { 1.0 }, 0.0);
    }

    /// Breaks the case.
    pub(crate) fn fail(&mut self, reason: impl Into<String>) {
        self.broken.get_or_insert(reason.into());
    }
}

/// |found − expected|/|expected| in unit roundoffs of their arithmetic; 0 when they are equal, also at zero.
pub(crate) fn roundoffs<R: Real>(found: &R, expected: &R) -> f64 {
    if found == expected {
        return 0.0;
    }
    roundoffs_on(found, expected, expected)
}

/// |found − expected| in unit roundoffs of `scale`, or in the distance of subnormal numbers where the scale is one of them.
fn roundoffs_on<R: Real>(found: &R, expected: &R, scale: &R) -> f64 {
    let zero = scale.lit(0);
    let difference = (found.clone() - expected).abs();
    if *scale != zero && scale.clone() * scale.unit_roundoff() == zero {
        return (difference / R::from_f64(scale.ctx(), f64::from_bits(1))).approx();
    }
    (difference / scale / scale.unit_roundoff()).abs().approx()
}

/// The error of a double in units in the last place of the correctly rounded `exact`; infinite where it is no number.
pub(crate) fn ulps(found: f64, exact: &Float) -> f64 {
    if !found.is_finite() {
        return f64::INFINITY;
    }
    let nearest = exact.to_f64();
    let spacing = nearest.abs().next_up() - nearest.abs();
    (Float::with_val(exact.prec(), found) - exact).abs().approx() / spacing
}
