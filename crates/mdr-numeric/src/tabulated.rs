//! A stable branch in doubles, tabulated for many values: polynomials take the place of a search at each.
//!
//! Between two kinks the indentation d and its height above the mean of g are piecewise polynomials of the contact radius a, or of
//! √(a − b) beyond a kink b, where they may have roots of a − b. The controlled quantity rises along a stable branch; a third
//! polynomial returns the radius from it, or from the root of its distance from a fold or a kink, roughly, and one step with the
//! first two corrects that to the rounding of g and Δl, which is what a search leaves.

mod polynomial;

use std::f64::consts::PI;
use std::ops::ControlFlow;

use mdr_core::contact::{Control, Equilibrium, Error, Result, Stability};

use self::polynomial::{Polynomial, TERMS, fit, horner, through};
use crate::branch::EquilibriumBranches;
use crate::contact::{Contact, negligible};
use crate::equilibrium::SearchedBranches;

/// How close to a fold the table begins, relative to its radius: whether a value is that of the fold is left to the search.
const FROM_FOLD: f64 = 1.0 / 4096.0;
/// How close to a fold at a kink, where the value may rise like a root.
const FROM_KINK: f64 = 1.0 / (1 << 30) as f64;
/// How close to an outer radius the table ends, relative to it: g may diverge there.
const FROM_END: f64 = 1.0 / 256.0;
/// The longest piece that is tried, as a ratio of radii.
const LONGEST: f64 = 1.25;
/// How often a piece is halved that does not hold.
const HALVINGS: u32 = 24;
/// The error of g that a piece may have, in unit roundoffs of |g| + Δl, beside that of a rounded radius: that of a good quadrature.
const ROUNDINGS: f64 = 8.0;
/// The error of the rough argument; the step that follows squares it.
const ROUGH: f64 = 1e-9;
/// Where a piece is compared with the transform, besides its nodes.
const CHECKS: [f64; 4] = [-1.0, -0.31, 0.52, 1.0];
/// Evaluations of g that a piece takes.
const COST: usize = 2 * (TERMS + CHECKS.len());
/// Values that a pass takes at once.
const AT_ONCE: usize = 32;
/// The share of a distance by which a value is certainly beyond a fold.
const CERTAIN: f64 = 1e-9;

/// One stable branch of a contact between two values of the controlled quantity, in doubles.
///
/// ```
/// use mdr_core::contact::{Control, Shape};
/// use mdr_numeric::branch::EquilibriumBranches;
/// use mdr_numeric::equilibrium::SearchedBranches;
/// use mdr_numeric::medium::{Adhesion, Medium};
/// use mdr_numeric::tabulated::TabulatedBranch;
/// use mdr_numeric::{contact::Contact, transform::Quadrature};
/// let ball = Quadrature::of([Shape::Sphere { radius: 1.0 }])?;
/// let contact = Contact::new(ball, Medium::half_space(1.0)?, Adhesion::new(1e-3)?, Control::Force);
/// let branches = SearchedBranches::new(contact)?;
/// let table = TabulatedBranch::new(&branches, 1, [-1e-3, 0.1], 10_000)?.expect("worth its evaluations");
/// let (one, other) = (table.at(0.05).expect("on the table"), branches.on_branch(1, &0.05)?.expect("at rest"));
/// assert!((one.contact_radius - other.contact_radius).abs() < 1e-15);
/// assert!(table.is_beyond(-1.0) && table.at(-1.0).is_none());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct TabulatedBranch {
    curve: Contact<f64>,
    /// By increasing value; `None` where no polynomial holds to the rounding of g.
    pieces: Vec<Option<Piece>>,
    /// The values at which they begin.
    starts: Vec<f64>,
    end: f64,
    /// The values of the folds at the two ends.
    folds: [Option<f64>; 2],
}

/// A part of the branch.
struct Piece {
    chart: Chart,
    measure: Measure,
    /// The argument of the chart, from the measure of the value.
    inverse: Polynomial,
    /// d (1.5), from the argument of the chart.
    indentation: Polynomial,
    /// d minus the mean of g, which times the stiffness is the force (1.6).
    excess: Polynomial,
}

/// The argument t of a value before it is corrected, and its rate of change with the value.
#[derive(Clone, Copy)]
struct Rough {
    t: f64,
    rate: f64,
}

/// A contact radius from an argument t: s = middle + half·t, or b + s² beyond a kink b.
#[derive(Clone, Copy)]
struct Chart {
    kink: Option<f64>,
    middle: f64,
    half: f64,
}

/// A number from a value of the controlled quantity, of which the radius is a smooth function, mapped to [−1, 1].
#[derive(Clone, Copy)]
struct Measure {
    origin: Origin,
    middle: f64,
    scale: f64,
}

/// Where the radius has a root as a function of the value.
#[derive(Clone, Copy)]
enum Origin {
    Nowhere,
    /// At the fold or kink below.
    Below(f64),
    /// At the fold above.
    Above(f64),
}

impl TabulatedBranch {
    /// The table of a branch for values between the first and the last; `None` if it takes more than about `budget` evaluations of g,
    /// or if the branch is not stable or has no states there.
    ///
    /// # Errors
    /// Errors of the transform that do not concern one radius.
    pub fn new(
        branches: &SearchedBranches<f64>,
        branch: usize,
        [first, last]: [f64; 2],
        budget: usize,
    ) -> Result<Option<Self>> {
        if branches.is_stable(branch) != Some(true) || !(first <= last) {
            return Ok(None);
        }
        let curve = branches.curve().clone();
        let below = branch.checked_sub(1).and_then(|index| branches.folds().get(index));
        let above = branches.folds().get(branch);
        let at = |value: f64| Ok(beside(branches.on_branch(branch, &value))?.flatten().map(|rest| rest.contact_radius));
        let kinks = curve.transform().kinks();
        let lower = match below {
            Some(fold) if kinks.contains(&fold.contact_radius) => Some(fold.contact_radius * (1.0 + FROM_KINK)),
            Some(fold) => Some(fold.contact_radius * (1.0 + FROM_FOLD)),
            None => at(first)?,
        };
        let end = curve.transform().outer_radius().map(|outer| outer * (1.0 - FROM_END));
        let upper = match above {
            Some(fold) => Some(fold.contact_radius * (1.0 - FROM_FOLD)),
            None => at(last)?.or(end),
        };
        let Some([lower, upper]) = lower.zip(upper).map(|(lower, upper)| [lower, upper.min(end.unwrap_or(upper))])
        else {
            return Ok(None);
        };
        if !(lower > 0.0 && lower < upper && upper.is_finite()) {
            return Ok(None);
        }
        let control = curve.control();
        let folds = [below, above].map(|fold| {
            fold.map(|fold| control.controlled(&fold.indentation, &fold.force)).filter(|value| value.is_finite())
        });
        let mut builder = Builder { curve: &curve, folds, left: budget, pieces: Vec::new(), starts: Vec::new() };
        let Some(end) = builder.build(lower, upper)? else { return Ok(None) };
        let Builder { pieces, starts, .. } = builder;
        Ok(Some(TabulatedBranch { curve, pieces, starts, end, folds }))
    }

    /// The state at a value; `None` outside of the table, and where g is no polynomial to its rounding.
    pub fn at(&self, value: f64) -> Option<Equilibrium<f64>> {
        let piece = self.piece(value)?;
        piece.state(&self.curve, value, piece.rough(value))
    }

    /// Passes on the state at each value, as [`at`](TabulatedBranch::at) has it, until `take` breaks off. At many values a processor
    /// works on several at once.
    pub fn at_each<B>(
        &self,
        values: &[f64],
        mut take: impl FnMut(f64, Option<Equilibrium<f64>>) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        // In each pass no value waits for another.
        for values in values.chunks(AT_ONCE) {
            let mut pieces = [None; AT_ONCE];
            let mut rough = [Rough { t: 0.0, rate: 0.0 }; AT_ONCE];
            let mut states = [const { None }; AT_ONCE];
            pieces.iter_mut().zip(values).for_each(|(piece, value)| *piece = self.piece(*value));
            for ((rough, piece), value) in rough.iter_mut().zip(pieces).zip(values) {
                *rough = piece.map_or(*rough, |piece: &Piece| piece.rough(*value));
            }
            for (((state, piece), rough), value) in states.iter_mut().zip(pieces).zip(rough).zip(values) {
                *state = piece.and_then(|piece| piece.state(&self.curve, *value, rough));
            }
            values.iter().zip(states).try_for_each(|(value, state)| take(*value, state))?;
        }
        ControlFlow::Continue(())
    }

    /// The piece with a value.
    fn piece(&self, value: f64) -> Option<&Piece> {
        if !(value <= self.end) {
            return None;
        }
        let index = self.starts.partition_point(|start| *start <= value).checked_sub(1)?;
        self.pieces.get(index)?.as_ref()
    }

    /// The largest value of the table.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Whether a value is certainly beyond a fold at an end of the branch, so that there is no state on it.
    pub fn is_beyond(&self, value: f64) -> bool {
        let margin = CERTAIN * (self.end - self.starts.first().copied().unwrap_or(self.end)).max(value.abs());
        let [below, above] = self.folds;
        below.is_some_and(|fold| value < fold - margin) || above.is_some_and(|fold| value > fold + margin)
    }
}

/// `None` where an error concerns one radius or value.
///
/// # Errors
/// Other errors.
fn beside<T>(result: Result<T>) -> Result<Option<T>> {
    match result {
        Err(
            Error::Domain { .. }
            | Error::OutOfRange { .. }
            | Error::NoConvergence { .. }
            | Error::NoEquilibrium { .. }
            | Error::Undecided { .. },
        ) => Ok(None),
        result => result.map(Some),
    }
}

struct Builder<'c> {
    curve: &'c Contact<f64>,
    folds: [Option<f64>; 2],
    /// Evaluations that may be spent.
    left: usize,
    pieces: Vec<Option<Piece>>,
    starts: Vec<f64>,
}

/// The part of a branch between two kinks, in the argument s of its chart.
struct Section {
    kink: Option<f64>,
    ends: [f64; 2],
    /// The values of a fold or kink below, and of a fold above.
    roots: [Option<f64>; 2],
}

impl Builder<'_> {
    /// The value at the end of the pieces between two radii; `None` if they cost too much.
    fn build(&mut self, lower: f64, upper: f64) -> Result<Option<f64>> {
        let kinks = self.curve.transform().kinks();
        let first = kinks.iter().copied().rfind(|kink| *kink <= lower);
        let kinks: Vec<f64> = kinks.into_iter().filter(|kink| *kink > lower && *kink < upper).collect();
        let ends: Vec<f64> = std::iter::once(lower).chain(kinks).chain([upper]).collect();
        if self.left < (ends.len() - 1) * COST {
            return Ok(None);
        }
        for (index, pair) in ends.windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]];
            let (kink, below) = match index {
                0 => (first, self.folds[0]),
                _ => (Some(from), beside(self.curve.controlled(&from))?),
            };
            let above = self.folds[1].filter(|_| to == upper);
            let ends = kink.map_or([from, to], |kink| [from, to].map(|end| (end - kink).sqrt()));
            if !self.fill(&Section { kink, ends, roots: [below, above] }, ends, 0)? {
                return Ok(None);
            }
        }
        let rising = self.starts.windows(2).all(|pair| pair[0] < pair[1]);
        Ok(beside(self.curve.controlled(&upper))?
            .filter(|end| rising && self.starts.last().is_some_and(|last| last < end)))
    }

    /// Pieces for a part of a section; false if the budget is spent.
    fn fill(&mut self, section: &Section, [from, to]: [f64; 2], depth: u32) -> Result<bool> {
        let is_long = section.kink.is_none() && to > LONGEST * from;
        let middle = if is_long { (from * to).sqrt() } else { 0.5 * (from + to) };
        if !is_long {
            let Some(left) = self.left.checked_sub(COST) else { return Ok(false) };
            self.left = left;
            let found = self.piece(section, [from, to])?;
            if found.is_some() || depth == HALVINGS || !(from < middle && middle < to) {
                let start = Chart { kink: section.kink, middle: from, half: 0.0 }.radius(0.0);
                // Where even this number is missing the values around it are searched.
                let start = beside(self.curve.controlled(&start))?.unwrap_or(f64::NAN);
                self.starts.push(start);
                self.pieces.push(found);
                return Ok(true);
            }
        }
        let depth = if is_long { depth } else { depth + 1 };
        Ok(self.fill(section, [from, middle], depth)? && self.fill(section, [middle, to], depth)?)
    }

    /// One piece, if it holds at the checks.
    fn piece(&self, section: &Section, [from, to]: [f64; 2]) -> Result<Option<Piece>> {
        let chart = Chart { kink: section.kink, middle: 0.5 * (from + to), half: 0.5 * (to - from) };
        let nodes: [f64; TERMS] = std::array::from_fn(|i| -(PI * (i as f64 + 0.5) / TERMS as f64).cos());
        let [mut indentation, mut excess, mut values] = [[0.0; TERMS]; 3];
        for (i, t) in nodes.iter().enumerate() {
            let Some(sample) = self.sample(chart.radius(*t))? else { return Ok(None) };
            (indentation[i], excess[i], values[i]) = (sample.indentation, sample.excess, sample.value);
        }
        let [first, last] = [self.sample(chart.radius(-1.0))?, self.sample(chart.radius(1.0))?];
        let Some([first, last]) = first.zip(last).map(|(first, last)| [first.value, last.value]) else {
            return Ok(None);
        };
        let is_lower = from + to < section.ends[0] + section.ends[1];
        let origin = match section.roots {
            [Some(below), above] if is_lower || above.is_none() => Origin::Below(below),
            [_, Some(above)] => Origin::Above(above),
            _ => Origin::Nowhere,
        };
        let [low, high] = [first, last].map(|value| origin.measure(value).0);
        let measure = Measure { origin, middle: 0.5 * (low + high), scale: 2.0 / (high - low) };
        let inverse = through(&values.map(|value| measure.of(value).0), &nodes);
        let piece = Piece { chart, measure, inverse, indentation: fit(&indentation), excess: fit(&excess) };
        for t in CHECKS {
            let Some(sample) = self.sample(chart.radius(t))? else { return Ok(None) };
            if !piece.holds(t, &sample) {
                return Ok(None);
            }
        }
        Ok(Some(piece))
    }

    fn sample(&self, a: f64) -> Result<Option<Sample>> {
        let (curve, elongation) = (self.curve, self.curve.elongation(&a));
        let g = beside(curve.transform().g_within(&a, &negligible(&elongation)))?;
        let above_mean = beside(curve.transform().above_mean(&a))?;
        let Some((g, above_mean)) = g.zip(above_mean) else { return Ok(None) };
        let (indentation, excess) = (g - elongation, above_mean - elongation);
        let value = curve.control().controlled(&indentation, &(curve.stiffness(&a) * excess));
        let lengths = g.abs() + elongation;
        Ok(value.is_finite().then_some(Sample { indentation, excess, lengths, value }))
    }
}

/// The equilibrium with a radius.
struct Sample {
    indentation: f64,
    /// d minus the mean of g.
    excess: f64,
    /// |g| + Δl, the lengths of which they are differences.
    lengths: f64,
    /// The controlled quantity.
    value: f64,
}

impl Piece {
    /// The argument of a value within the piece, roughly.
    #[inline]
    fn rough(&self, value: f64) -> Rough {
        let (measured, rate) = self.measure.of(value);
        let (t, turn) = horner(&self.inverse, measured);
        Rough { t, rate: turn * rate }
    }

    /// The state at a value within the piece.
    #[inline]
    fn state(&self, curve: &Contact<f64>, value: f64, Rough { t, rate }: Rough) -> Option<Equilibrium<f64>> {
        let ((depth, depth_rate), (excess, excess_rate)) = (horner(&self.indentation, t), horner(&self.excess, t));
        let force = curve.stiffness(&self.chart.radius(t)) * excess;
        let step = (value - curve.control().controlled(&depth, &force)) * rate;
        let contact_radius = self.chart.radius(t + step);
        let stiffness = curve.stiffness(&contact_radius);
        let (indentation, force) = (depth + depth_rate * step, stiffness * (excess + excess_rate * step));
        let force = match curve.control() {
            // That of the spring: S(a) times a difference of lengths would lose digits on a soft machine.
            Control::Machine { stiffness: spring } if *spring < stiffness => spring * (value - indentation),
            _ => force,
        };
        let known = contact_radius.is_finite() && indentation.is_finite() && force.is_finite();
        known.then_some(Equilibrium { contact_radius, indentation, force, stability: Stability::Stable })
    }

    /// Whether the polynomials have the numbers of the transform at an argument.
    fn holds(&self, t: f64, sample: &Sample) -> bool {
        let noise = ROUNDINGS * 0.5 * f64::EPSILON * sample.lengths;
        let near = |polynomial: &Polynomial, number: f64| {
            let (value, slope) = horner(polynomial, t);
            // The radius of the sample is rounded, which is much beside a kink with a root.
            let rounding = f64::EPSILON * self.chart.radius(t) * (slope / self.chart.rate(t)).abs();
            (value - number).abs() <= noise + rounding
        };
        let rough = self.rough(sample.value).t;
        near(&self.indentation, sample.indentation) && near(&self.excess, sample.excess) && (rough - t).abs() <= ROUGH
    }
}

impl Chart {
    #[inline]
    fn radius(&self, t: f64) -> f64 {
        let s = self.middle + self.half * t;
        match self.kink {
            Some(kink) => kink + s * s,
            None => s,
        }
    }

    /// The rate of change of the radius with the argument.
    fn rate(&self, t: f64) -> f64 {
        let stretch = if self.kink.is_some() { 2.0 * (self.middle + self.half * t) } else { 1.0 };
        stretch * self.half
    }
}

impl Measure {
    /// The measure of a value, and its rate of change with it.
    #[inline]
    fn of(&self, value: f64) -> (f64, f64) {
        let (measure, rate) = self.origin.measure(value);
        ((measure - self.middle) * self.scale, rate * self.scale)
    }
}

impl Origin {
    #[inline]
    fn measure(self, value: f64) -> (f64, f64) {
        match self {
            Origin::Nowhere => (value, 1.0),
            Origin::Below(origin) => {
                let root = (value - origin).max(0.0).sqrt();
                (root, 0.5 / root)
            }
            Origin::Above(origin) => {
                let root = (origin - value).max(0.0).sqrt();
                (root, -0.5 / root)
            }
        }
    }
}
