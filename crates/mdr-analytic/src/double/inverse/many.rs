//! The equilibria at many values: rows of them, several per instruction.

use mdr_core::contact::{Error, Quantity, Ranged, Result, Stability, Status};

use super::Inverse;
use super::kernel::{Constants, Lanes};
use crate::double::grid::{BatchReport, Work};
use crate::double::pair::Arithmetic;
use crate::inverse::{Branch, Count, Held};

/// Values in a row.
pub(super) const LEN: usize = 64;
type Row = [f64; LEN];

/// The equilibria with the smaller radius, or those with the larger. NaN if there is none or it is out of range.
#[derive(Debug)]
pub struct BranchSlices<'a> {
    /// a, in m.
    pub contact_radius: &'a mut [f64],
    /// The quantity that is not controlled: F, in N, or d, in m.
    pub uncontrolled: &'a mut [f64],
}

/// The results at many values, all slices as long as the values.
///
/// | status | meaning |
/// |---|---|
/// | `Ok` | two equilibria, or the larger one alone |
/// | `NoEquilibrium` | none: beyond the fold |
/// | `Fold` | the double root, on both sides |
/// | `Overflow`, `Underflow` | a quantity leaves the range of `f64` (the first that does) and is NaN; [`Inverse::equilibria`] gives its log₁₀ |
/// | `DomainError` | the value is not finite |
/// | `Undecided` | 256 bits do not decide, see [the module](super::super#errors) |
#[derive(Debug)]
pub struct InverseBatch<'a> {
    /// Stable for n < 1/2.
    pub smaller: BranchSlices<'a>,
    /// Stable for n > 1/2. The only equilibrium at n = 1/2, stable or not, is also stored here.
    pub larger: BranchSlices<'a>,
    /// The number of equilibria, or why there is none.
    pub status: &'a mut [Status],
}

impl Inverse {
    /// The equilibria at many values of the controlled quantity, each quantity within one ulp as in
    /// [`Inverse::equilibria`], several values per instruction.
    ///
    /// ```
    /// use mdr_analytic::double::{InverseBatch, Inverse, BranchSlices};
    /// use mdr_core::contact::{Control, Material, Status};
    /// let ball = Inverse::new(2.0, 0.5, &Material::new(1.0, 1.0)?, &Control::Indentation)?;
    /// let ([mut a0, mut f0, mut a1, mut f1], mut status) = ([[0.0; 3]; 4], [Status::Ok; 3]);
    /// let tally = ball.branches(&[-2.0, -1.0, 0.0], &mut InverseBatch {
    ///     smaller: BranchSlices { contact_radius: &mut a0, uncontrolled: &mut f0 },
    ///     larger: BranchSlices { contact_radius: &mut a1, uncontrolled: &mut f1 },
    ///     status: &mut status,
    /// })?;
    /// assert_eq!(status, [Status::NoEquilibrium, Status::Ok, Status::Ok]);
    /// assert!(a1[0].is_nan() && a0[1] < a1[1] && a0[2].is_nan());
    /// assert_eq!(a1[2], 1.8452701486440284); // (2π)^(1/3)
    /// assert_eq!((tally.passed_on, tally.without_value), (0, 1));
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Length`] when slices differ in length. Failures at a value are reported by its status.
    pub fn branches(&self, values: &[f64], branches: &mut InverseBatch<'_>) -> Result<BatchReport> {
        let InverseBatch { smaller, larger, status } = branches;
        let expected = values.len();
        let lengths = [
            (Quantity::ContactRadius, smaller.contact_radius.len()),
            (self.held.pick(Quantity::Force, Quantity::Indentation), smaller.uncontrolled.len()),
            (Quantity::ContactRadius, larger.contact_radius.len()),
            (self.held.pick(Quantity::Force, Quantity::Indentation), larger.uncontrolled.len()),
            (Quantity::Parameter("the status"), status.len()),
        ];
        Error::require_length(expected, lengths)?;
        let mut tally = BatchReport::default();
        match self.better() {
            Some(constants) => self.path.run(Rows { inverse: self, constants, values, branches, tally: &mut tally }),
            None => (0..expected).for_each(|i| self.pass_on(values[i], i, branches, &mut tally)),
        }
        Ok(tally)
    }

    /// One value in extended precision.
    #[cold]
    #[inline(never)]
    fn pass_on(&self, value: f64, i: usize, branches: &mut InverseBatch<'_>, tally: &mut BatchReport) {
        let mut status = Status::Ok;
        let mut number = |x: &Ranged<f64>| {
            if status == Status::Ok {
                status = x.status();
            }
            x.value(Quantity::ContactRadius).unwrap_or(f64::NAN)
        };
        let nothing = [f64::NAN; 2];
        let (sides, status) = match super::finite(value).map(|value| self.with_words(value)) {
            Err(_) => ([nothing; 2], Status::DomainError),
            Ok(Err(_)) => ([nothing; 2], Status::Undecided),
            Ok(Ok(found)) => {
                let states = found.as_slice();
                let mut pair = |i: usize| {
                    let state = &states[i];
                    [number(&state.contact_radius), number(self.held.pick(&state.force, &state.indentation))]
                };
                match states {
                    [] => ([nothing; 2], Status::NoEquilibrium),
                    [only] if only.stability == Stability::Neutral => {
                        let both = pair(0);
                        ([both; 2], if status == Status::Ok { Status::Fold } else { status })
                    }
                    [_] => ([nothing, pair(0)], status),
                    _ => ([pair(0), pair(1)], status),
                }
            }
        };
        for (side, [a, other]) in [&mut branches.smaller, &mut branches.larger].into_iter().zip(sides) {
            (side.contact_radius[i], side.uncontrolled[i]) = (a, other);
        }
        branches.status[i] = status;
        tally.passed_on += 1;
        tally.without_value += usize::from(!matches!(status, Status::Ok | Status::Fold));
    }
}

/// The data of one call.
struct Rows<'a, 's> {
    inverse: &'a Inverse,
    constants: &'a Constants,
    values: &'a [f64],
    branches: &'a mut InverseBatch<'s>,
    tally: &'a mut BatchReport,
}

impl Work for Rows<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Arithmetic>(mut self, arithmetic: A) {
        match self.constants.held {
            Held::Indentation => self.rows::<A, false>(arithmetic),
            Held::Force => self.rows::<A, true>(arithmetic),
        }
    }
}

impl Rows<'_, '_> {
    #[inline(always)]
    fn rows<A: Arithmetic, const FORCE: bool>(&mut self, arithmetic: A) {
        for (row, values) in self.values.chunks(LEN).enumerate() {
            let mut counts = [Some(Count::Two); LEN];
            // Lanes without a solution compute another one, which is discarded.
            let mut x: Row = [0.5 * self.constants.fold; LEN];
            for (i, &value) in values.iter().enumerate() {
                counts[i] = self.constants.count(value);
                x[i] = if matches!(counts[i], Some(Count::Two | Count::Larger)) { value } else { x[i] };
            }
            let larger = self.branch::<A, FORCE>(arithmetic, &x, Branch::Larger);
            for (x, count) in x.iter_mut().zip(&counts) {
                *x = if *count == Some(Count::Two) { *x } else { 0.5 * self.constants.fold };
            }
            let smaller = self.branch::<A, FORCE>(arithmetic, &x, Branch::Smaller);
            for (i, &value) in values.iter().enumerate() {
                self.set(row * LEN + i, i, value, counts[i], [&smaller, &larger]);
            }
        }
    }

    #[inline(always)]
    fn branch<A: Arithmetic, const FORCE: bool>(&self, arithmetic: A, x: &Row, branch: Branch) -> Lanes<LEN> {
        self.constants.on_branches::<A, FORCE, LEN>(arithmetic, x, |_| branch)
    }

    /// Stores the result of lane `lane` for the value `i`.
    #[inline(always)]
    fn set(&mut self, i: usize, lane: usize, value: f64, count: Option<Count>, [smaller, larger]: [&Lanes<LEN>; 2]) {
        let (has_smaller, has_larger) = (count == Some(Count::Two), matches!(count, Some(Count::Two | Count::Larger)));
        let known = (smaller.trusted[lane] | !has_smaller) & (larger.trusted[lane] | !has_larger);
        if !known | count.is_none() {
            self.inverse.pass_on(value, i, self.branches, self.tally);
            return;
        }
        let InverseBatch { smaller: left, larger: right, status } = &mut *self.branches;
        for (side, lanes, exists) in [(left, smaller, has_smaller), (right, larger, has_larger)] {
            side.contact_radius[i] = if exists { lanes.radius[lane] } else { f64::NAN };
            side.uncontrolled[i] = if exists { lanes.other[lane] } else { f64::NAN };
        }
        status[i] = if has_larger { Status::Ok } else { Status::NoEquilibrium };
        self.tally.without_value += usize::from(!has_larger);
    }
}
