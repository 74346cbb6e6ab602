//! All sign changes of a function on a range of radii.
//!
//! The range is halved in log x until each cell contains at most one zero. An enclosure test proves this for a cell;
//! samples only make it likely, and the result is then marked as not proved.

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
    /// Intervals that may contain further zeros, ascending: double zeros, pairs closer than √u relative to x, and cells
    /// left when the budget is spent.
    pub undecided: Vec<(R, R)>,
    /// Whether everything outside `undecided` is proved by an enclosure test, not just sampled.
    pub proved: bool,
    /// Evaluations of the function.
    pub evaluations: usize,
}

impl<R> Isolation<R> {
    /// Whether the brackets are proved to contain all zeros, one each.
    pub fn is_complete(&self) -> bool {
        self.proved && self.undecided.is_empty()
    }
}

/// The sign changes of f on (lower, upper), 0 < lower < upper, with proof: every cell must pass the enclosure `test`.
/// Cells that fail it down to the relative width √u (u the unit roundoff), or when about `budget` evaluations are
/// spent, are undecided. The work is spread evenly, one level of halving after the other.
///
/// # Errors
/// [`Error::Domain`] for other ranges or where f is not a number; whatever f and the test return.
pub fn isolate_with_proof<R: Real>(
    lower: &R,
    upper: &R,
    budget: usize,
    f: impl FnMut(&R) -> Result<R>,
    mut test: impl FnMut(&R, &R) -> Result<Behaviour>,
) -> Result<Isolation<R>> {
    let mut sampler = Sampler { f, evaluations: 0 };
    let range = sampler.ends(lower, upper)?;
    let isolation = subdivide(&mut sampler, vec![range], budget, |sampler, cell| {
        let Cell { lower, upper, .. } = cell;
        Ok(match test(&lower.x, &upper.x)? {
            Behaviour::Nonzero => Verdict::Settled(None),
            Behaviour::Monotone if lower.differs(upper) || lower.agrees(upper) => Verdict::settled(&[lower, upper]),
            _ => Verdict::Split(cell.halves(&sampler.between(lower, upper)?, None, None)),
        })
    })?;
    Ok(Isolation { proved: true, ..isolation })
}

/// The sign changes of f on (lower, upper), 0 < lower < upper, from samples alone: `proved` is false. A cell is settled
/// when six samples fit a smooth model, both in it and in its parent cell: ln|f| nearly quadratic in ln x (no zero), or
/// f monotone and nearly quadratic (at most one). There are at least 16 cells, none wider than four octaves (up to 4096
/// cells); `budget` limits the number of evaluations approximately.
///
/// ```
/// use mdr_core::calculus::{isolate::isolate, roots::refine, roundoff_tolerance};
/// let f = |x: &f64| Ok((x - 1e-9) * (x - 1.0) * (x - 1.001));
/// let found = isolate(&1e-12, &1e3, 10_000, f)?;
/// assert_eq!((found.brackets.len(), found.undecided.len(), found.is_complete()), (3, 0, false));
/// let first = refine(found.brackets[0].clone(), &roundoff_tolerance(&1.0), f)?;
/// assert!((first.value - 1e-9).abs() < 1e-23);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// As [`isolate_with_proof`].
pub fn isolate<R: Real>(lower: &R, upper: &R, budget: usize, f: impl FnMut(&R) -> Result<R>) -> Result<Isolation<R>> {
    let mut sampler = Sampler { f, evaluations: 0 };
    let mut cells = vec![sampler.ends(lower, upper)?];
    while cells.len() < 16 || (cells.len() < 4096 && cells[0].octaves_exceed(4)) {
        let mut halves = Vec::with_capacity(2 * cells.len());
        for cell in cells {
            halves.extend(cell.halves(&sampler.between(&cell.lower, &cell.upper)?, None, None));
        }
        cells = halves;
    }
    subdivide(&mut sampler, cells, budget, |sampler, cell| {
        let Cell { lower, upper, .. } = cell;
        let middle = cell.inner.clone().map_or_else(|| sampler.between(lower, upper), Ok)?;
        let first = sampler.between(lower, &middle)?;
        let last = sampler.between(&middle, upper)?;
        let aside = sampler.aside(lower, upper)?;
        let six = [lower, &first, &aside, &middle, &last, upper];
        let fits = fits_logarithm(&six) || fits_monotone(&six);
        Ok(if fits && (cell.fitted || cell.is_narrow()) {
            Verdict::settled(&six)
        } else {
            Verdict::Split(cell.halves(&middle, Some(first), Some(last)).map(|half| Cell { fitted: fits, ..half }))
        })
    })
}

struct Cell<R> {
    lower: Sample<R>,
    /// The sample at the middle, if it was already taken.
    inner: Option<Sample<R>>,
    upper: Sample<R>,
    /// Whether the samples of the parent cell fitted a smooth model.
    fitted: bool,
}

impl<R: Real> Cell<R> {
    /// The halves, with their own inner samples.
    fn halves(&self, middle: &Sample<R>, first: Option<Sample<R>>, last: Option<Sample<R>>) -> [Self; 2] {
        let half = |lower: &Sample<R>, inner, upper: &Sample<R>| {
            let (lower, upper) = (lower.clone(), upper.clone());
            Cell { lower, inner, upper, fitted: false }
        };
        [half(&self.lower, first, middle), half(middle, last, &self.upper)]
    }

    fn octaves_exceed(&self, octaves: i64) -> bool {
        (self.upper.x.clone() / &self.lower.x).steer() > self.lower.x.lit(2).powi(octaves)
    }

    /// Whether a double zero and a pair of zeros can no longer be separated.
    fn is_narrow(&self) -> bool {
        let width = (self.upper.x.clone() - &self.lower.x).steer();
        width <= (self.lower.x.unit_roundoff().sqrt() * &self.lower.x).steer()
    }
}

enum Verdict<R> {
    /// No zero, or one in a bracket.
    Settled(Option<Bracket<R>>),
    Split([Cell<R>; 2]),
}

impl<R: Real> Verdict<R> {
    /// Settled, with the sign change between successive samples, if there is one.
    fn settled(samples: &[&Sample<R>]) -> Self {
        let pair = samples.windows(2).find(|pair| pair[0].differs(pair[1]));
        Verdict::Settled(pair.and_then(|pair| Bracket::between(pair[0].clone(), pair[1].clone(), 0)))
    }
}

struct Sampler<F> {
    f: F,
    evaluations: usize,
}

impl<F> Sampler<F> {
    fn ends<R: Real>(&mut self, lower: &R, upper: &R) -> Result<Cell<R>>
    where
        F: FnMut(&R) -> Result<R>,
    {
        let lower = Error::require_positive(Quantity::Radius, lower.clone())?;
        let upper = Error::require_positive(Quantity::Radius, upper.clone())?;
        if !(lower.steer() < upper.steer()) {
            return Err(Error::domain(Quantity::Radius, &upper, "above the lower end of its range"));
        }
        Ok(Cell { lower: self.take(lower)?, inner: None, upper: self.take(upper)?, fitted: false })
    }

    fn take<R: Real>(&mut self, x: R) -> Result<Sample<R>>
    where
        F: FnMut(&R) -> Result<R>,
    {
        self.evaluations += 1;
        Sample::take(x, &mut self.f)
    }

    /// A sample at the geometric mean, or slightly beside it if the function is exactly zero there.
    fn between<R: Real>(&mut self, lower: &Sample<R>, upper: &Sample<R>) -> Result<Sample<R>>
    where
        F: FnMut(&R) -> Result<R>,
    {
        let middle = geometric_mean(&lower.x, &upper.x);
        let sample = self.take(middle)?;
        if sample.agrees(&sample) {
            return Ok(sample);
        }
        let beside = (0..5).fold(upper.x.clone(), |x, _| geometric_mean(&sample.x, &x));
        self.take(beside)
    }

    /// A sample at 5/13 of the cell in log x: off every dyadic grid, so that an oscillation in step with one is
    /// detected.
    fn aside<R: Real>(&mut self, lower: &Sample<R>, upper: &Sample<R>) -> Result<Sample<R>>
    where
        F: FnMut(&R) -> Result<R>,
    {
        let ratio = upper.x.clone() / &lower.x;
        self.take(ratio.ln().times(5).over(13).exp() * &lower.x)
    }
}

/// Level after level, so that the budget is spent evenly.
fn subdivide<R: Real, F>(
    sampler: &mut Sampler<F>,
    mut cells: Vec<Cell<R>>,
    budget: usize,
    mut judge: impl FnMut(&mut Sampler<F>, &Cell<R>) -> Result<Verdict<R>>,
) -> Result<Isolation<R>> {
    let mut brackets: Vec<Bracket<R>> = Vec::new();
    let mut undecided = Vec::new();
    while !cells.is_empty() {
        let mut next = Vec::new();
        for cell in cells {
            let verdict = if sampler.evaluations < budget { Some(judge(sampler, &cell)?) } else { None };
            match verdict {
                Some(Verdict::Settled(bracket)) => brackets.extend(bracket),
                Some(Verdict::Split(halves)) if !cell.is_narrow() => next.extend(halves),
                _ => undecided.push((cell.lower.x, cell.upper.x)),
            }
        }
        cells = next;
    }
    brackets.sort_by(|one, other| order(&one.lower.x, &other.lower.x));
    let undecided = merge(undecided);
    Ok(Isolation { brackets, undecided, proved: false, evaluations: sampler.evaluations })
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

/// The largest deviation of the quadratic through the ends and the middle from the other three of six values, which lie
/// at the fractions 0, 1/4, 5/13, 1/2, 3/4 and 1 of a cell.
fn misfit<R: Real>([v0, v1, aside, v2, v3, v4]: [&R; 6]) -> R {
    let miss = |value: &R, weights: [i64; 3], total: i64| {
        let model = v0.clone().times(weights[0]) + v2.clone().times(weights[1]) + v4.clone().times(weights[2]);
        (model.over(total) - value).abs().steer()
    };
    let larger = |x: R, y: R| if x > y { x } else { y };
    larger(larger(miss(v1, [3, 6, -1], 8), miss(v3, [-1, 6, 3], 8)), miss(aside, [24, 160, -15], 169))
}

/// One certain sign, and ln|f| within 1/8 of a quadratic; or out of range everywhere.
fn fits_logarithm<R: Real>(six: &[&Sample<R>; 6]) -> bool {
    let logs = six.map(|sample| sample.f.abs().ln());
    let smooth = || misfit(logs.each_ref()) <= logs[0].ratio(1, 8);
    let infinite = || six.iter().all(|sample| !sample.f.is_finite());
    six.iter().all(|sample| sample.agrees(six[0])) && (infinite() || smooth())
}

/// Of certain signs, strictly monotone, and within 1/16 of its range of a quadratic that is itself monotone.
fn fits_monotone<R: Real>(six: &[&Sample<R>; 6]) -> bool {
    let values = six.map(|sample| sample.f.steer());
    let [v0, _, _, v2, _, v4] = values.each_ref();
    let range = v4.clone() - v0;
    // Twice the slopes at the ends; for a straight line both are twice the range.
    let bend = (v0.clone() + v4 - &v2.clone().times(2)).times(2);
    let steep = |slope: R| slope.abs().times(4) >= range.abs() && (slope * &range) > range.lit(0);
    let straight = || steep(range.clone() - &bend) && steep(range.clone() + &bend);
    let smooth = || misfit(values.each_ref()) <= range.abs().over(16);
    let rising = values.windows(2).all(|pair| pair[0] < pair[1]);
    let falling = values.windows(2).all(|pair| pair[0] > pair[1]);
    six.iter().all(|sample| sample.agrees(sample)) && (rising || falling) && straight() && smooth()
}
