//! The stable equilibrium at many values: one branch of the curve, several values per instruction.

use mdr_core::contact::{Error, Quantity, Ranged, Regime, Result, Stability, Status};

use super::Inverse;
use super::kernel::{Constants, Lanes};
use super::many::{BranchSlices, LEN};
use crate::double::grid::{BatchReport, Work};
use crate::double::pair::Arithmetic;
use crate::inverse::{Branch, Held};

impl Inverse {
    /// The stable equilibrium at many values of the controlled quantity, NaN where there is none, with the numbers that
    /// [`Inverse::branches`] has for its branch; the other branch is not computed, which takes half the time. At the fold it is
    /// the double root, and the status is `Fold`. A status says nothing of the other branch.
    ///
    /// ```
    /// use mdr_analytic::double::{BranchSlices, Inverse};
    /// use mdr_core::contact::{Control, Material, Status};
    /// let ball = Inverse::new(2.0, 0.5, &Material::new(1.0, 1.0)?, &Control::Indentation)?;
    /// let ([mut a, mut force], mut status) = ([[0.0; 2]; 2], [Status::Ok; 2]);
    /// ball.stable(&[-2.0, 0.0], &mut BranchSlices { contact_radius: &mut a, uncontrolled: &mut force }, &mut status)?;
    /// assert_eq!(status, [Status::NoEquilibrium, Status::Ok]);
    /// assert!(a[0].is_nan() && a[1] == 1.8452701486440284); // (2π)^(1/3)
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Length`] when slices differ in length. Failures at a value are reported by its status.
    pub fn stable(&self, values: &[f64], found: &mut BranchSlices<'_>, status: &mut [Status]) -> Result<BatchReport> {
        let expected = values.len();
        let lengths = [
            (Quantity::ContactRadius, found.contact_radius.len()),
            (self.held.pick(Quantity::Force, Quantity::Indentation), found.uncontrolled.len()),
            (Quantity::Parameter("the status"), status.len()),
        ];
        Error::require_length(expected, lengths)?;
        let mut rows = Rows { inverse: self, values, found, status, report: BatchReport::default() };
        match self.better() {
            Some(constants) => Ok(self.path.run(Stable { constants, rows })),
            None => {
                (0..expected).for_each(|i| rows.pass_on(i));
                Ok(rows.report)
            }
        }
    }
}

/// The values of one call, and what is found at them.
struct Rows<'a, 's> {
    inverse: &'a Inverse,
    values: &'a [f64],
    found: &'a mut BranchSlices<'s>,
    status: &'a mut [Status],
    report: BatchReport,
}

impl Rows<'_, '_> {
    fn set(&mut self, i: usize, [a, other]: [f64; 2], status: Status) {
        (self.found.contact_radius[i], self.found.uncontrolled[i], self.status[i]) = (a, other, status);
        self.report.without_value += usize::from(!matches!(status, Status::Ok | Status::Fold));
    }

    /// One value in extended precision.
    #[cold]
    #[inline(never)]
    fn pass_on(&mut self, i: usize) {
        self.report.passed_on += 1;
        let (value, held) = (self.values[i], self.inverse.held);
        let states = match super::finite(value).map(|value| self.inverse.with_words(value)) {
            Err(_) => return self.set(i, [f64::NAN; 2], Status::DomainError),
            Ok(Err(_)) => return self.set(i, [f64::NAN; 2], Status::Undecided),
            Ok(Ok(states)) => states,
        };
        let Some(state) = states.as_slice().iter().find(|state| state.stability != Stability::Unstable) else {
            return self.set(i, [f64::NAN; 2], Status::NoEquilibrium);
        };
        let numbers = [&state.contact_radius, held.pick(&state.force, &state.indentation)];
        let first_lost = numbers.iter().map(|number| number.status()).find(|status| *status != Status::Ok);
        let neutral = if state.stability == Stability::Neutral { Status::Fold } else { Status::Ok };
        let value = |number: &Ranged<f64>| number.value(Quantity::ContactRadius).unwrap_or(f64::NAN);
        self.set(i, numbers.map(value), first_lost.unwrap_or(neutral));
    }
}

impl Rows<'_, '_> {
    /// The results of the lanes for the `len` values from `start` on.
    #[inline(always)]
    fn store(&mut self, start: usize, len: usize, lanes: &Lanes<LEN>, decided: &[bool; LEN], exists: &[bool; LEN]) {
        let mut all = true;
        for (exists, trusted) in exists.iter().zip(&lanes.trusted) {
            all &= exists & trusted;
        }
        if all & (len == LEN) {
            let rows = start..start + LEN;
            self.found.contact_radius[rows.clone()].copy_from_slice(&lanes.radius);
            self.found.uncontrolled[rows.clone()].copy_from_slice(&lanes.other);
            self.status[rows].fill(Status::Ok);
            return;
        }
        for i in 0..len {
            if !decided[i] | (exists[i] & !lanes.trusted[i]) {
                self.pass_on(start + i);
            } else if exists[i] {
                self.set(start + i, [lanes.radius[i], lanes.other[i]], Status::Ok);
            } else {
                self.set(start + i, [f64::NAN; 2], Status::NoEquilibrium);
            }
        }
    }
}

/// The rows, with the constants of the kernel.
struct Stable<'a, 's> {
    constants: &'a Constants,
    rows: Rows<'a, 's>,
}

impl Work for Stable<'_, '_> {
    type Output = BatchReport;

    #[inline(always)]
    fn run<A: Arithmetic>(mut self, arithmetic: A) -> BatchReport {
        match self.constants.held {
            Held::Indentation => self.all::<A, false>(arithmetic),
            Held::Force => self.all::<A, true>(arithmetic),
        }
        self.rows.report
    }
}

impl Stable<'_, '_> {
    #[inline(always)]
    fn all<A: Arithmetic, const FORCE: bool>(&mut self, arithmetic: A) {
        match self.constants.regime {
            Regime::PullOff => self.on_branch::<A, FORCE>(arithmetic, Branch::Larger),
            _ => self.on_branch::<A, FORCE>(arithmetic, Branch::Smaller),
        }
    }

    #[inline(always)]
    fn on_branch<A: Arithmetic, const FORCE: bool>(&mut self, arithmetic: A, branch: Branch) {
        let constants = self.constants;
        let values = self.rows.values;
        for (row, values) in values.chunks(LEN).enumerate() {
            let mut padded = [0.0; LEN];
            padded[..values.len()].copy_from_slice(values);
            let (mut decided, mut exists) = ([false; LEN], [false; LEN]);
            // Lanes without a solution compute another one, which is discarded.
            let (mut x, inside) = ([0.0; LEN], 0.5 * constants.fold);
            for i in 0..LEN {
                let place = constants.place(padded[i]);
                let is_there = place.decided & place.exists & (place.pulled | (branch == Branch::Larger));
                (decided[i], exists[i]) = (place.decided, is_there);
                x[i] = if is_there { padded[i] } else { inside };
            }
            let lanes = constants.on_branches::<A, FORCE, LEN>(arithmetic, &x, |_| branch);
            self.rows.store(row * LEN, values.len(), &lanes, &decided, &exists);
        }
    }
}
