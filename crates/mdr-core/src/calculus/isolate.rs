//! All sign changes of a function on a range of radii, with proof: the range is halved in log x until an enclosure test shows
//! that each cell contains at most one zero.

use std::cell::Cell;

use super::roots::{Bracket, Sample, geometric_mean};
use crate::contact::{Error, Quantity, Result};
use crate::number::{Real, order};

/// The behaviour of a function on an interval, as an enclosure test reports it. The report must be certain: from
/// interval arithmetic, or from a theorem about the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// The function has no zero there.
    Nonzero,
    /// The function is strictly monotone there: at most one zero, which is a sign change.
    Monotone,
    /// Neither is proved.
    Unknown,
}

/// The sign changes of a function on an open interval.
#[derive(Clone, Debug)]
pub struct Isolation<R> {
    /// One bracket for each sign change, ascending.
    pub brackets: Vec<Bracket<R>>,
    /// The decided cells, ascending, each with the function at its ends: opposite signs around one zero, one sign without any.
    pub cells: Vec<[Sample<R>; 2]>,
    /// Intervals that may contain further zeros, ascending: double zeros, pairs closer than √u relative to x, cells
    /// in which f is not proved, and those left when the budget is spent. Outside of them the brackets are proved to contain all zeros, one each.
    pub undecided: Vec<(R, R)>,
    /// Evaluations of the function.
    pub evaluations: usize,
    /// Whether [work that is counted](Error::BudgetSpent) was spent before all of the interval was looked at.
    pub is_spent: bool,
}

/// So many cells are halved level by level; of more the lower ones come first, so that something is known of them when the work is spent.
const TOGETHER: usize = 256;

/// The sign changes of f on (lower, upper), 0 < lower < upper, with proof: every cell must pass the enclosure `test`.
/// Cells that fail it down to the relative width √u (u the unit roundoff), or when about `budget` evaluations are
/// spent, are undecided. The work is spread evenly, one level of halving after the other, over as many cells as are halved
/// together; of more the lower ones come first.
///
/// ```
/// use mdr_core::calculus::isolate::{Behaviour, isolate};
/// // (x − 1)(x − 2) is monotone on either side of 3/2, and below zero near it.
/// let f = |x: &f64| Ok((x - 1.0) * (x - 2.0));
/// let test = |lower: &f64, upper: &f64| {
///     Ok(match (*lower, *upper) {
///         (lower, upper) if lower > 1.1 && upper < 1.9 => Behaviour::Nonzero,
///         (lower, upper) if upper < 1.5 || lower > 1.5 => Behaviour::Monotone,
///         _ => Behaviour::Unknown,
///     })
/// };
/// let found = isolate(&1e-9, &1e9, 1000, f, test)?;
/// assert_eq!((found.brackets.len(), found.undecided.len()), (2, 0));
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] for other ranges or where f is not a number; whatever f and the test return.
pub fn isolate<R: Real>(
    lower: &R,
    upper: &R,
    budget: usize,
    f: impl FnMut(&R) -> Result<R>,
    test: impl FnMut(&R, &R) -> Result<Behaviour>,
) -> Result<Isolation<R>> {
    isolate_each(lower, upper, &Effort::of(budget, lower), f, test, |_| Ok(()))
}

/// How much an isolation may take.
#[derive(Clone, Debug)]
pub struct Effort<R> {
    /// About so many evaluations of the function.
    pub evaluations: usize,
    /// Cells narrower than this share of their radius are no longer halved.
    pub narrowest: R,
}

impl<R: Real> Effort<R> {
    /// About so many evaluations, of cells down to √u, u the unit roundoff of an arithmetic: there a double zero and a pair of zeros can no
    /// longer be told apart.
    pub fn of(evaluations: usize, like: &R) -> Self {
        Effort { evaluations, narrowest: like.unit_roundoff().sqrt() }
    }
}

/// The sign changes of [`isolate`] with a given effort, of which each is given to `found` before the next one is looked for. Where an evaluation or `found`
/// returns [`Error::BudgetSpent`], all that is left is undecided. Where the test or `found` returns [`Error::Unproved`], or f does in
/// the middle of a cell and half-way to both of its ends, that cell is undecided, and the others are still looked at.
///
/// # Errors
/// Errors of [`isolate`], and whatever `found` returns, but for these two.
pub fn isolate_each<R: Real>(
    lower: &R,
    upper: &R,
    effort: &Effort<R>,
    mut f: impl FnMut(&R) -> Result<R>,
    mut test: impl FnMut(&R, &R) -> Result<Behaviour>,
    mut found: impl FnMut(&Bracket<R>) -> Result<()>,
) -> Result<Isolation<R>> {
    let [lower, upper] = [lower, upper].map(|end| Error::require_positive(Quantity::Radius, end.clone()));
    let (lower, upper) = (lower?, upper?);
    if !(lower.midpoint() < upper.midpoint()) {
        return Err(Error::domain(Quantity::Radius, &upper, "above the lower end of its range"));
    }
    let evaluations = Cell::new(0);
    let mut sample = |x: R| {
        evaluations.update(|count| count + 1);
        Sample::take(x, &mut f)
    };
    let mut waiting = vec![vec![[sample(lower)?, sample(upper)?]]];
    let mut isolation =
        Isolation { brackets: Vec::new(), cells: Vec::new(), undecided: Vec::new(), evaluations: 0, is_spent: false };
    while let Some(cells) = waiting.pop() {
        let mut next = Vec::new();
        for cell in cells {
            if isolation.is_spent || evaluations.get() >= effort.evaluations {
                isolation.leave(cell);
                continue;
            }
            match isolation.settle(&cell, &effort.narrowest, &mut sample, &mut test, &mut found) {
                Err(Error::BudgetSpent { .. }) => {
                    isolation.is_spent = true;
                    isolation.leave(cell);
                }
                Err(Error::Unproved { .. }) => isolation.leave(cell),
                halves => next.extend(halves?.into_iter().flatten()),
            }
        }
        waiting.extend(next.chunks(TOGETHER).rev().map(<[_]>::to_vec));
    }
    isolation.brackets.sort_by(|one, other| order(&one.lower.x, &other.lower.x));
    isolation.cells.sort_by(|one, other| order(&one[0].x, &other[0].x));
    Ok(Isolation { undecided: merge(isolation.undecided), evaluations: evaluations.get(), ..isolation })
}

/// The samples at the ends of a cell.
type Borders<R> = [Sample<R>; 2];

impl<R: Real> Isolation<R> {
    fn leave(&mut self, [lower, upper]: Borders<R>) {
        self.undecided.push((lower.x, upper.x));
    }

    /// Settles a cell, or halves it.
    fn settle(
        &mut self,
        [lower, upper]: &Borders<R>,
        narrowest: &R,
        sample: impl FnMut(R) -> Result<Sample<R>>,
        test: &mut impl FnMut(&R, &R) -> Result<Behaviour>,
        found: &mut impl FnMut(&Bracket<R>) -> Result<()>,
    ) -> Result<Option<[Borders<R>; 2]>> {
        let cell = || [lower.clone(), upper.clone()];
        match test(&lower.x, &upper.x)? {
            Behaviour::Nonzero => self.cells.push(cell()),
            Behaviour::Monotone if lower.differs(upper) || lower.agrees(upper) => {
                let bracket = Bracket::between(lower.clone(), upper.clone(), 0);
                bracket.as_ref().map_or(Ok(()), found)?;
                self.cells.push(cell());
                self.brackets.extend(bracket);
            }
            _ => {
                let middle = between(lower, upper, sample)?;
                if (upper.x.clone() - &lower.x).midpoint() <= (narrowest.clone() * &lower.x).midpoint() {
                    self.leave(cell());
                } else {
                    return Ok(Some([[lower.clone(), middle.clone()], [middle, upper.clone()]]));
                }
            }
        }
        Ok(None)
    }
}

/// A sample at the geometric mean; slightly beside it if the function is exactly zero there, and half-way to an end if it is not known.
fn between<R: Real>(
    lower: &Sample<R>,
    upper: &Sample<R>,
    mut sample: impl FnMut(R) -> Result<Sample<R>>,
) -> Result<Sample<R>> {
    let middle = geometric_mean(&lower.x, &upper.x);
    match sample(middle.clone()) {
        Err(Error::Unproved { .. }) => match sample(geometric_mean(&middle, &upper.x)) {
            Err(Error::Unproved { .. }) => sample(geometric_mean(&lower.x, &middle)),
            at_quarter => at_quarter,
        },
        Ok(at_middle) if !at_middle.agrees(&at_middle) => {
            sample((0..5).fold(upper.x.clone(), |x, _| geometric_mean(&middle, &x)))
        }
        at_middle => at_middle,
    }
}

/// Sorts intervals and joins those that touch.
fn merge<R: Real>(mut intervals: Vec<(R, R)>) -> Vec<(R, R)> {
    intervals.sort_by(|one, other| order(&one.0, &other.0));
    let mut merged: Vec<(R, R)> = Vec::with_capacity(intervals.len());
    for (lower, upper) in intervals {
        match merged.last_mut() {
            Some(last) if order(&last.1, &lower).is_ge() => last.1 = upper,
            _ => merged.push((lower, upper)),
        }
    }
    merged
}
