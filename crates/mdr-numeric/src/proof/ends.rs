//! Radii outside the range of a proof: whether folds exist towards the tip or outwards.

use std::cmp::Ordering;

use mdr_core::contact::Result;
use mdr_core::number::{Interval, Real};
use rug::Float;

use super::{ProvedBranches, Trend, kinks};
use crate::path::{ContactState, EventKind, Path};

/// The range on which the condition is enclosed at both ends, in octaves: contact radii of 2^±1048576 m.
pub(super) const FAR: f64 = 1_048_576.0;
/// The most enclosures of the condition at each end.
const CELLS: usize = 512;

impl ProvedBranches {
    /// Checks that a path uses proved results only. If it reaches radii outside the range, or no radius, it must be
    /// certain that no fold lies there. The choice of the largest state, say, refers to the range only.
    ///
    /// # Errors
    /// [`Error::Undecided`](mdr_core::contact::Error::Undecided) otherwise.
    pub fn check(&self, path: &Path<Interval>) -> Result<()> {
        let states = || path.events.iter().flat_map(|event| [&event.before, &event.after]);
        // Surfaces that stay apart have no states that a fold could end.
        if states().all(|state| matches!(state, ContactState::Detached)) {
            return Ok(());
        }
        let (lower, upper) = self.range();
        let inwards = states().any(|state| match state {
            ContactState::Contact(rest) => rest.contact_radius.lower() < lower,
            ContactState::Detached => true,
            ContactState::Complete => false,
        });
        let outwards = states().any(|state| match state {
            ContactState::Contact(rest) => rest.contact_radius.upper() > upper,
            ContactState::Detached => false,
            ContactState::Complete => true,
        }) || path.events.iter().any(|event| event.kind == EventKind::EndOfProfile);
        let free = (!inwards || self.inwards()?.is_some()) && (!outwards || self.outwards_is_free()?);
        if free { Ok(()) } else { Err(self.curve.undecided("whether folds lie outside the radii of the proof")) }
    }

    /// The trend of the controlled quantity from the tip to the range, if the tangency condition certainly has one sign there.
    ///
    /// # Errors
    /// Errors of the transform.
    pub fn inwards(&self) -> Result<Option<Trend>> {
        let (lower, _) = self.range();
        let last = octave(lower);
        let end = |octave: f64| if octave < last { self.power(octave) } else { lower.clone() };
        Ok(self.one_sign([-FAR, last], end)?.map(|sign| Trend::between(sign, sign)))
    }

    /// Whether it has one sign from the range outwards, to 2⁻ᵖ before an outer radius at a precision of p bits.
    fn outwards_is_free(&self) -> Result<bool> {
        let (_, upper) = self.range();
        if self.edge.is_some() || self.equator.is_some() {
            return Ok(true);
        }
        let Some(outer) = self.curve.plain.transform().outer_radius() else {
            let first = octave(upper);
            let end = |octave: f64| if octave > first { self.power(octave) } else { upper.clone() };
            return Ok(self.one_sign([first, FAR], end)?.is_some());
        };
        let outer = outer.lower();
        let [first, last] = [
            -octave(&(Float::with_val(outer.prec(), outer - upper) / outer)),
            f64::from(self.curve.precision().bits() - 2),
        ];
        let before =
            |octave: f64| if octave > first { kinks::shifted(outer, -1, octave as u32) } else { upper.clone() };
        Ok(first >= last || self.one_sign([first, last], |octave| before(octave.floor()))?.is_some())
    }

    fn power(&self, octave: f64) -> Float {
        Float::with_val(self.curve.precision().bits(), octave).exp2()
    }

    /// The sign of the condition on all radii between two octaves, which are halved until it is certain; `None` where it has
    /// both signs, or stays open.
    fn one_sign(&self, [first, last]: [f64; 2], end: impl Fn(f64) -> Float) -> Result<Option<Ordering>> {
        let mut open = vec![(first, last)];
        let mut sign = None;
        for _ in 0..CELLS {
            let Some((from, to)) = open.pop() else { return Ok(sign) };
            let condition = self.curve.condition(&Interval::new(end(from), end(to)))?;
            match condition.partial_cmp(&condition.lit(0)) {
                Some(order) if order != Ordering::Equal && sign.is_none_or(|sign| sign == order) => sign = Some(order),
                Some(_) => return Ok(None),
                None if to - from < 1e-3 => return Ok(None),
                None => {
                    let middle = 0.5 * (from + to);
                    open.extend([(from, middle), (middle, to)]);
                }
            }
        }
        Ok(None)
    }
}

/// log₂ of a radius.
pub(super) fn octave(radius: &Float) -> f64 {
    let (mantissa, exponent) = radius.to_f64_exp();
    mantissa.log2() + f64::from(exponent)
}
