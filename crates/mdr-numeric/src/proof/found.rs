//! What a proof of all folds found, and what it left undecided.

use mdr_core::contact::{Error, Fold, Result};
use mdr_core::number::Interval;
use rug::Float;

use super::ProvedCell;

/// The folds found on a range of radii, and the parts left undecided.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ProvedFolds {
    /// The range. Nothing is claimed outside it.
    pub range: (Float, Float),
    /// The folds, by increasing radius; each quantity is an enclosure.
    pub folds: Vec<Fold<Interval>>,
    /// Radii where g, and with it the controlled quantity, diverges: the curve of equilibria is cut there as by a fold.
    /// The radius is somewhere in its enclosure; indentation and force are unbounded.
    pub poles: Vec<Fold<Interval>>,
    /// Parts of the range that may contain further folds: around kinks without known bounds, where two folds nearly
    /// merge, cells in which g is not proved, and those left when the budget is spent.
    pub undecided: Vec<(Float, Float)>,
    /// The decided parts of the range, ascending, and how the controlled quantity behaves on each.
    pub cells: Vec<ProvedCell>,
    /// Evaluations of the tangency condition.
    pub evaluations: usize,
    /// Whether the [work](Error::BudgetSpent) that the evaluations may take was spent: something undecided was not looked at then.
    pub is_spent: bool,
}

impl ProvedFolds {
    /// Nothing found yet on a range.
    pub fn on(range: (Float, Float)) -> Self {
        let (folds, poles, undecided, cells) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        ProvedFolds { range, folds, poles, undecided, cells, evaluations: 0, is_spent: false }
    }

    /// Leaves a part undecided where the error says that the work was spent or that something is not proved there.
    ///
    /// # Errors
    /// Any other error.
    pub(super) fn leave(&mut self, part: (Float, Float), error: Error) -> Result<()> {
        match error {
            Error::BudgetSpent { .. } => self.is_spent = true,
            Error::Unproved { .. } => {}
            error => return Err(error),
        }
        self.undecided.push(part);
        Ok(())
    }

    /// Whether the folds are proved to be all in the range.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_empty()
    }

    /// The parts of the range between those that are undecided: the folds of each are all that it has. Parts with a fold that is not certainly
    /// on one side of an end are left out; without anything undecided the range is the only part.
    ///
    /// ```
    /// use mdr_numeric::proof::ProvedFolds;
    /// use rug::Float;
    /// let mut found = ProvedFolds::on((Float::with_val(53, 1), Float::with_val(53, 4)));
    /// found.undecided.push((Float::with_val(53, 2), Float::with_val(53, 3)));
    /// let parts = found.decided_parts();
    /// assert!(parts.len() == 2 && parts[0].range.1 == 2 && parts[1].range.0 == 3 && parts[1].is_complete());
    /// ```
    pub fn decided_parts(&self) -> Vec<ProvedFolds> {
        if self.is_complete() {
            return vec![self.clone()];
        }
        let mut undecided = self.undecided.clone();
        undecided.sort_by(|one, other| one.0.total_cmp(&other.0));
        let ends = undecided.iter().map(|(from, _)| from).chain([&self.range.1]);
        let mut from = &self.range.0;
        let mut parts = Vec::new();
        for (index, to) in ends.enumerate() {
            parts.extend(self.part(from, to).filter(|_| from < to));
            from = undecided.get(index).map_or(from, |(_, end)| if end > from { end } else { from });
        }
        parts
    }

    /// What was found between two radii; `None` if a fold is not certainly on one side of them.
    fn part(&self, from: &Float, to: &Float) -> Option<ProvedFolds> {
        let range = Interval::new(from.clone(), to.clone());
        let within = |folds: &[Fold<Interval>]| {
            let meets = |fold: &&Fold<Interval>| fold.contact_radius.overlaps(&range);
            let folds: Vec<_> = folds.iter().filter(meets).cloned().collect();
            folds.iter().all(|fold| range.encloses(&fold.contact_radius)).then_some(folds)
        };
        let cells = self.cells.iter().filter(|cell| cell.from >= *from && cell.to <= *to).cloned().collect();
        let (folds, poles) = (within(&self.folds)?, within(&self.poles)?);
        Some(ProvedFolds { folds, poles, cells, ..ProvedFolds::on((from.clone(), to.clone())) })
    }
}
