//! Tables of stable branches, in place of a search for each of many values.

use std::cell::OnceCell;
use std::ops::ControlFlow;

use mdr_core::contact::{Equilibrium, Result, Status};
use mdr_numeric::admissible::GapVerdict;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::tabulated::TabulatedBranch;

/// From so many values on tables are built.
const FEWEST: usize = 1024;
/// Evaluations of g, per value, that a table may take: a search takes about as many.
const PER_VALUE: usize = 8;

/// The stable branches of a contact, tabulated when they are needed.
pub(super) struct Tables<'b> {
    branches: &'b SearchedBranches<f64>,
    range: [f64; 2],
    budget: usize,
    known: Vec<OnceCell<Option<Known>>>,
}

/// A stable branch.
pub(super) struct Known {
    pub(super) table: TabulatedBranch,
    /// All states with radii up to this one are admissible: that is lost once on a stable branch, and for all larger radii.
    admitted: f64,
}

/// What tables tell of a value.
pub(super) enum Found {
    /// The state on the first branch that has one.
    State(Equilibrium<f64>, Status),
    /// There is none.
    Nothing,
    /// It must be searched.
    Open,
}

impl<'b> Tables<'b> {
    /// `None` for few values.
    pub(super) fn new(branches: &'b SearchedBranches<f64>, values: &[f64]) -> Option<Self> {
        if values.len() < FEWEST {
            return None;
        }
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let range = [finite().reduce(f64::min)?, finite().reduce(f64::max)?];
        let known = std::iter::repeat_with(OnceCell::new).take(branches.folds().len() + 1).collect();
        Some(Tables { branches, range, budget: PER_VALUE * values.len(), known })
    }

    /// The table of a branch, if there is one.
    ///
    /// # Errors
    /// Errors of the transform that do not concern one radius.
    pub(super) fn branch(&self, branch: usize) -> Result<Option<&Known>> {
        let Some(cell) = self.known.get(branch) else { return Ok(None) };
        if let Some(known) = cell.get() {
            return Ok(known.as_ref());
        }
        let table = TabulatedBranch::new(self.branches, branch, self.range, self.budget)?;
        let known = table.map(|table| {
            let last = table.at(table.end().min(self.range[1]));
            let admitted = last.filter(|last| self.verdict(last) == GapVerdict::Admissible);
            Known { admitted: admitted.map_or(0.0, |last| last.contact_radius), table }
        });
        Ok(cell.get_or_init(|| known).as_ref())
    }

    /// The state at a value on the first of these branches that has one.
    ///
    /// # Errors
    /// Errors of the transform that do not concern one radius.
    pub(super) fn first(&self, order: &[usize], value: f64) -> Result<Found> {
        for branch in order {
            let Some(known) = self.branch(*branch)? else { return Ok(Found::Open) };
            if let Some(found) = self.on(known, value, known.table.at(value)) {
                return Ok(found);
            }
        }
        Ok(Found::Nothing)
    }

    /// Passes on what [`Tables::first`] finds at each value, in less time.
    ///
    /// # Errors
    /// Errors of the transform that do not concern one radius, and of `take`.
    pub(super) fn first_of_each(
        &self,
        order: &[usize],
        values: &[f64],
        mut take: impl FnMut(f64, Found) -> Result<()>,
    ) -> Result<()> {
        let known = order.first().map_or(Ok(None), |branch| self.branch(*branch))?;
        let Some(known) = known else {
            return values.iter().try_for_each(|value| take(*value, self.first(order, *value)?));
        };
        let stopped = known.table.at_each(values, |value, state| {
            let found = self.on(known, value, state).map_or_else(|| self.first(&order[1..], value), Ok);
            match found.and_then(|found| take(value, found)) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => ControlFlow::Break(error),
            }
        });
        stopped.break_value().map_or(Ok(()), Err)
    }

    /// What the table of one branch tells of a value, at which it has this state; `None` if the branch ends before the value.
    fn on(&self, known: &Known, value: f64, state: Option<Equilibrium<f64>>) -> Option<Found> {
        match state {
            Some(state) if known.admits(&state) => Some(Found::State(state, Status::Ok)),
            Some(state) => {
                let interpenetrates = matches!(self.verdict(&state), GapVerdict::Interpenetrating { .. });
                Some(Found::State(state, if interpenetrates { Status::NotAdmissible } else { Status::Ok }))
            }
            None => (!known.table.is_beyond(value)).then_some(Found::Open),
        }
    }

    fn verdict(&self, state: &Equilibrium<f64>) -> GapVerdict {
        self.branches.admissibility().of(state.contact_radius, state.indentation)
    }
}

impl Known {
    /// Whether a state of the branch is known to be admissible.
    pub(super) fn admits(&self, state: &Equilibrium<f64>) -> bool {
        state.contact_radius <= self.admitted
    }

    /// Passes on the states at these values, up to the first that is not known to be admissible.
    pub(super) fn admissible(&self, values: &[f64], mut take: impl FnMut(f64, Equilibrium<f64>)) {
        let _ = self.table.at_each(values, |value, state| match state.filter(|state| self.admits(state)) {
            Some(state) => {
                take(value, state);
                ControlFlow::Continue(())
            }
            None => ControlFlow::Break(()),
        });
    }
}
