//! How an integral over the heights of a formula is cut, and how precise it is made.

use mdr_core::calculus::enclose::{BOUND_BITS, DOUBLE_BITS};
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;
use rug::float::Round;

use super::super::weight::Weight;

/// Intervals of radii that are wider than this ratio are not integrated.
const WIDEST: f64 = 1.5;
/// Bits by which the aim of a rule is below the size of the integral,
const SPARE: i32 = 6;
/// and below the width of an enclosure over an interval of radii.
const BELOW_WIDTH: i32 = 9;

/// Intervals of radii that are wider than 2^−WIDE of themselves are integrated in doubles, whose roundings are far narrower.
const WIDE: i32 = 26;

/// How precisely an interval of radii is integrated.
pub(super) struct Span {
    pub(super) is_wide: bool,
    ratio: Float,
    pub(super) bits: u32,
    /// The aim relative to the size of the integrand.
    pub(super) aim: Float,
}

impl Span {
    pub(super) fn is_for_ranges(&self) -> bool {
        self.ratio > WIDEST
    }

    pub(super) fn of(x: &Interval) -> Self {
        let bits = x.lower().prec();
        let ratio = Float::with_val_round(BOUND_BITS, x.upper() / x.lower(), Round::Up).0;
        let width = relative_width(x);
        let by_width = Float::with_val(BOUND_BITS, &width) >> BELOW_WIDTH;
        // Half of the bits say all about an interval of that width.
        let is_wide = width > Float::with_val(BOUND_BITS, Float::i_exp(1, -(bits as i32) / 2));
        let enough = match width.get_exp() {
            Some(exponent) if exponent > -WIDE => DOUBLE_BITS.min(bits),
            Some(exponent) if is_wide => (2 * exponent.unsigned_abs() + 64).min(bits),
            _ => bits,
        };
        Span { is_wide, ratio, bits: enough, aim: finest(enough).max(&by_width) }
    }
}

/// The width of an interval of radii over its lower end.
pub(super) fn relative_width(x: &Interval) -> Float {
    Float::with_val_round(BOUND_BITS, x.upper() - x.lower(), Round::Up).0 / x.lower()
}

/// The finest aim for so many bits.
fn finest(bits: u32) -> Float {
    Float::with_val(BOUND_BITS, Float::i_exp(1, SPARE - bits as i32))
}

/// An enclosure of places t on which breaks lie, and the parts before and after them.
pub(super) struct Gap {
    pub(super) from: Float,
    pub(super) to: Float,
    pub(super) first: usize,
    pub(super) last: usize,
}

/// The gaps around the places of b/x, those that overlap in one.
pub(super) fn gaps(x: &Interval, breaks: &[Interval], weight: &Weight<Interval>, end: &Float) -> Vec<Gap> {
    let precision = Precision::new(end.prec());
    let x = x.rounded(precision);
    let one = x.lit(1);
    let mut gaps: Vec<Gap> = Vec::new();
    for (index, b) in breaks.iter().enumerate() {
        if b.lower() >= x.upper() {
            break;
        }
        let sine = (b.rounded(precision) / &x).lesser(&one);
        let t = weight.position(&sine);
        let [from, to] = [t.lower(), t.upper()].map(|place| place.clone().min(end));
        match gaps.last_mut() {
            Some(last) if last.to >= from => {
                last.to.max_mut(&to);
                last.last = index + 1;
            }
            _ => gaps.push(Gap { from, to, first: index, last: index + 1 }),
        }
    }
    gaps
}
