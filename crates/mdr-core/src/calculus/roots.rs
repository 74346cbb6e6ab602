//! Zeros of a function of one radius, without a scale.
//!
//! On positive brackets halving is geometric and tolerances are relative, so a problem multiplied by a power of two
//! takes the same steps and its root has the same significand. In interval arithmetic the abscissae are points and only
//! a certain sign counts: the bracket of the root is then rigorous.

use std::cmp::Ordering;

use crate::contact::{Error, Quantity, Result};
use crate::number::Real;

/// An argument and the function there.
#[derive(Clone, Debug)]
pub struct Sample<R> {
    /// The argument.
    pub x: R,
    /// The function value.
    pub f: R,
}

/// An interval at whose ends a function has opposite signs, or whose two ends are the same exact zero.
#[derive(Clone, Debug)]
pub struct Bracket<R> {
    /// The smaller end.
    pub lower: Sample<R>,
    /// The larger end.
    pub upper: Sample<R>,
    /// Evaluations spent so far.
    pub evaluations: usize,
}

/// A zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Root<R> {
    /// The best value found, between the bounds.
    pub value: R,
    /// The sign changes above this argument,
    pub lower: R,
    /// and below this one. Both equal the value where the function is exactly zero.
    pub upper: R,
    /// Evaluations spent, those for the bracket included.
    pub evaluations: usize,
}

impl<R: Real> Sample<R> {
    /// Evaluates `f`; infinite values have a sign and are accepted.
    ///
    /// # Errors
    /// [`Error::Domain`] when the value is not a number; whatever f returns.
    pub fn take(x: R, f: &mut impl FnMut(&R) -> Result<R>) -> Result<Self> {
        let x = x.midpoint();
        let value = f(&x)?;
        let sample = Sample { x, f: value };
        if sample.sign().is_none() && !sample.f.is_finite() {
            return Err(Error::domain(Quantity::Residual, &sample.f, "a number"));
        }
        Ok(sample)
    }

    /// The sign of the function where it is certain; `None` only for intervals.
    pub fn sign(&self) -> Option<Ordering> {
        self.f.partial_cmp(&self.f.lit(0))
    }

    /// Whether the signs certainly differ. An exact zero differs from nothing.
    pub fn differs(&self, other: &Self) -> bool {
        matches!(
            (self.sign(), other.sign()),
            (Some(Ordering::Less), Some(Ordering::Greater)) | (Some(Ordering::Greater), Some(Ordering::Less))
        )
    }

    /// Whether both are nonzero and certainly have the same sign.
    pub fn agrees(&self, other: &Self) -> bool {
        !self.is_zero() && self.sign().is_some() && self.sign() == other.sign()
    }

    fn is_zero(&self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }
}

impl<R: Real> Bracket<R> {
    /// The bracket [lower, upper], or `None` when f has the same sign at both ends. An end that is exactly zero is a
    /// bracket by itself.
    ///
    /// # Errors
    /// [`Error::Domain`] when a value of f is not a number; errors of f.
    pub fn new(lower: &R, upper: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Option<Self>> {
        let first = Sample::take(lower.clone(), &mut f)?;
        let second = Sample::take(upper.clone(), &mut f)?;
        Ok(Self::between(first, second, 2))
    }

    /// The bracket between two samples in either order, if there is one.
    pub fn between(first: Sample<R>, second: Sample<R>, evaluations: usize) -> Option<Self> {
        if let Some(zero) = [&first, &second].into_iter().find(|sample| sample.is_zero()) {
            return Some(Bracket { lower: zero.clone(), upper: zero.clone(), evaluations });
        }
        let (lower, upper) = if first.x < second.x { (first, second) } else { (second, first) };
        lower.differs(&upper).then_some(Bracket { lower, upper, evaluations })
    }
}

/// √(lower·upper) of positive numbers.
pub(super) fn geometric_mean<R: Real>(lower: &R, upper: &R) -> R {
    let ratio = upper.clone() / lower;
    // The quotient of the whole exponent range overflows; its root does not.
    let root = if ratio.is_finite() { ratio.sqrt() } else { upper.sqrt() / lower.sqrt() };
    (root * lower).midpoint()
}

/// The middle in log x for positive numbers more than an octave apart, (lower + upper)/2 otherwise.
fn middle<R: Real>(lower: &R, upper: &R) -> R {
    if *lower > lower.lit(0) && *upper > lower.clone().times(2) {
        geometric_mean(lower, upper)
    } else {
        ((upper.clone() - lower).over(2) + lower).midpoint()
    }
}

/// Searches for a sign change of f on (0, ∞), outwards from a positive `guess` on both sides in steps that double in
/// log x: about 20 evaluations reach the ends of the range of `f64`, about 60 those of arbitrary precision. `None` when
/// every sample has the same sign; a pair of zeros between two samples is not detected
/// ([`isolate`](super::isolate::isolate)).
///
/// ```
/// use mdr_core::calculus::{roots::{bracket_geometric, refine}, roundoff_tolerance};
/// let f = |x: &f64| Ok(x * x - 2e-200);
/// let bracket = bracket_geometric(&1.0, f)?.expect("a sign change");
/// let root = refine(bracket, &roundoff_tolerance(&1.0), f)?;
/// assert!((root.value / 2e-200_f64.sqrt() - 1.0).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless the guess is positive and finite, or where f is not a number; whatever f returns.
pub fn bracket_geometric<R: Real>(guess: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Option<Bracket<R>>> {
    let start = Sample::take(Error::require_positive(Quantity::Radius, guess.clone())?, &mut f)?;
    let mut evaluations = 1;
    if start.is_zero() {
        return Ok(Some(Bracket { lower: start.clone(), upper: start, evaluations }));
    }
    let mut walks = [Walk::new(&start, 1), Walk::new(&start, -1)];
    loop {
        let mut moved = false;
        for walk in &mut walks {
            let Some(x) = walk.next() else { continue };
            moved = true;
            evaluations += 1;
            let sample = Sample::take(x, &mut f)?;
            if sample.sign().is_none() {
                continue;
            }
            let last = std::mem::replace(&mut walk.last, sample.clone());
            if let Some(bracket) = Bracket::between(last, sample, evaluations) {
                return Ok(Some(bracket));
            }
        }
        if !moved {
            return Ok(None);
        }
    }
}

/// A search towards one end of the exponent range.
struct Walk<R> {
    /// The last sample whose sign is certain.
    last: Sample<R>,
    x: R,
    /// Binary logarithm of the next step; doubled until a step leaves the range, then halved.
    octaves: i64,
    growing: bool,
}

impl<R: Real> Walk<R> {
    fn new(start: &Sample<R>, octaves: i64) -> Self {
        Walk { last: start.clone(), x: start.x.clone(), octaves, growing: true }
    }

    fn next(&mut self) -> Option<R> {
        while self.octaves != 0 {
            let x = self.x.lit(2).powi(self.octaves) * &self.x;
            let in_range = x.is_finite() && x.clone() * x.unit_roundoff() > x.lit(0);
            self.growing &= in_range;
            self.octaves = if self.growing { self.octaves * 2 } else { self.octaves / 2 };
            if in_range {
                self.x = x.clone();
                return Some(x);
            }
        }
        None
    }
}

/// Halves a bracket until it is narrower than the relative `tolerance`, or its ends are adjacent numbers. Halving is in
/// log x while the ends are positive and more than an octave apart.
///
/// # Errors
/// [`Error::Domain`] where f is not a number; whatever f returns.
pub fn bisect<R: Real>(bracket: Bracket<R>, tolerance: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Root<R>> {
    Search::new(bracket, tolerance).run(|x| Ok((f(x)?, None)), |_, _| None)
}

/// Refines a bracket by inverse quadratic interpolation where it is safe and by halving elsewhere (T. R. Chandrupatla,
/// Adv. Eng. Softw. 28 (1997) 145), until the bracket is narrower than twice the relative `tolerance`. It cannot fail
/// on a valid bracket: after three slow steps of interpolation the next step halves.
///
/// The tolerance is relative to the root on positive brackets, to the larger end of others. In interval arithmetic the
/// search ends where the sign of f is uncertain, with the tightest certain bracket around that point.
///
/// # Errors
/// [`Error::Domain`] where f is not a number; whatever f returns.
pub fn refine<R: Real>(bracket: Bracket<R>, tolerance: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Root<R>> {
    Search::new(bracket, tolerance).run(|x| Ok((f(x)?, None)), |search, _| search.inverse_quadratic())
}

/// Refines a bracket by Newton's iteration to a relative `tolerance`, where `f` returns the function and its slope. See
/// [`refine`] for the meaning of the tolerance and for intervals.
///
/// # Errors
/// [`Error::Domain`] where f is not a number; errors of f.
pub fn refine_with_slope<R: Real>(
    bracket: Bracket<R>,
    tolerance: &R,
    mut f: impl FnMut(&R) -> Result<(R, R)>,
) -> Result<Root<R>> {
    let with_slope = |x: &R| f(x).map(|(value, slope)| (value, Some(slope)));
    Search::new(bracket, tolerance).run(with_slope, |search, slope| {
        let Sample { x, f } = &search.newest;
        Some((x.clone() - f.clone() / slope?).midpoint())
    })
}

/// The state of a refinement.
struct Search<R> {
    newest: Sample<R>,
    /// The nearest sample of the opposite sign.
    opposite: Sample<R>,
    /// The sample that one of them replaced.
    earlier: Option<Sample<R>>,
    evaluations: usize,
    tolerance: R,
    /// The length to which the tolerance is relative, unless it is the root itself.
    length: Option<R>,
    /// Width of the bracket and smallest |f| when halving last succeeded, and the steps since.
    pace: (R, R, u32),
}

impl<R: Real> Search<R> {
    fn new(bracket: Bracket<R>, tolerance: &R) -> Self {
        let Bracket { lower, upper, evaluations } = bracket;
        let larger = |x: R, y: R| if x > y { x } else { y };
        let tolerance = larger(tolerance.midpoint(), tolerance.unit_roundoff());
        let length = if lower.x > lower.x.lit(0) { None } else { Some(larger(lower.x.abs(), upper.x.abs())) };
        let pace = ((upper.x.clone() - &lower.x).midpoint(), upper.f.abs().midpoint(), 0);
        Search { newest: upper, opposite: lower, earlier: None, evaluations, tolerance, length, pace }
    }

    /// Samples at the proposal of `propose`, which gets the slope at the newest sample, or else at the middle.
    fn run(
        mut self,
        mut f: impl FnMut(&R) -> Result<(R, Option<R>)>,
        propose: impl Fn(&Self, Option<R>) -> Option<R>,
    ) -> Result<Root<R>> {
        let mut slope = None;
        while !self.is_done() {
            let proposal = if self.is_slow() { None } else { propose(&self, slope.take()) };
            let Some(x) = proposal.and_then(|x| self.inside(x)).or_else(|| self.middle()) else { break };
            self.evaluations += 1;
            let sample = Sample::take(x, &mut |x| {
                let (value, derivative) = f(x)?;
                slope = derivative;
                Ok(value)
            })?;
            if sample.sign().is_none() {
                return self.tighten(&sample.x, |x| Ok(f(x)?.0));
            }
            self.insert(sample);
        }
        let value = self.best().x.clone();
        Ok(self.into_root(value))
    }

    fn insert(&mut self, sample: Sample<R>) {
        let last = std::mem::replace(&mut self.newest, sample);
        if self.newest.is_zero() {
            self.opposite = self.newest.clone();
        } else if self.newest.differs(&last) {
            self.earlier = Some(std::mem::replace(&mut self.opposite, last));
        } else {
            self.earlier = Some(last);
        }
    }

    fn ends(&self) -> (&R, &R) {
        let (x, y) = (&self.newest.x, &self.opposite.x);
        if x < y { (x, y) } else { (y, x) }
    }

    fn width(&self) -> R {
        let (lower, upper) = self.ends();
        (upper.clone() - lower).midpoint()
    }

    /// The end with the smaller |f|.
    fn best(&self) -> &Sample<R> {
        let size = |sample: &Sample<R>| sample.f.abs().midpoint();
        if size(&self.opposite) < size(&self.newest) { &self.opposite } else { &self.newest }
    }

    /// The error that the tolerance allows.
    fn allowed(&self) -> R {
        self.tolerance.clone() * self.length.as_ref().unwrap_or(&self.best().x)
    }

    fn is_done(&self) -> bool {
        self.newest.is_zero() || self.width() <= self.allowed().times(2)
    }

    /// Whether three steps neither halved the bracket nor reduced |f| to 1/64, as superlinear ones do.
    fn is_slow(&mut self) -> bool {
        let (width, size) = (self.width(), self.best().f.abs().midpoint());
        if width.clone().times(2) <= self.pace.0 || size.clone().times(64) <= self.pace.1 {
            self.pace = (width, size, 0);
        }
        self.pace.2 += 1;
        self.pace.2 > 3
    }

    /// The middle of the bracket; `None` when its ends are adjacent.
    fn middle(&self) -> Option<R> {
        let (lower, upper) = self.ends();
        let middle = middle(lower, upper);
        (middle > *lower && middle < *upper).then_some(middle)
    }

    /// A proposal shifted into the bracket so that the step that finds the root also closes the bracket. `None` for one
    /// outside it, or while the bracket spans more than two octaves.
    fn inside(&self, x: R) -> Option<R> {
        let (lower, upper) = self.ends();
        let wide = *lower > lower.lit(0) && *upper > lower.clone().times(4);
        let margin = self.allowed();
        let (first, last) = ((lower.clone() + &margin).midpoint(), (upper.clone() - &margin).midpoint());
        let far =
            x < (first.clone() - margin.clone().times(2)).midpoint() || x > (last.clone() + margin.times(2)).midpoint();
        if wide || far || !(first < last) || !x.is_finite() {
            None
        } else if x < first {
            Some(first)
        } else if x > last {
            Some(last)
        } else {
            Some(x)
        }
    }

    /// The zero of the inverse quadratic through the three samples, if it is monotone between them.
    fn inverse_quadratic(&self) -> Option<R> {
        let (Sample { x: x1, f: f1 }, Sample { x: x2, f: f2 }) = (&self.newest, &self.opposite);
        let Sample { x: x3, f: f3 } = self.earlier.as_ref()?;
        let quotient = |a: &R, b: &R, c: &R, d: &R| ((a.clone() - b) / (c.clone() - d)).midpoint();
        let (xi, phi) = (quotient(x1, x2, x3, x2), quotient(f1, f2, f3, f2));
        let one = xi.lit(1);
        if !(phi.square() < xi && (one.clone() - &phi).square() < one - &xi) {
            return None;
        }
        let zero = f1.lit(0);
        let first = quotient(f1, &zero, f2, f1) * quotient(f3, &zero, f2, f3);
        let second = quotient(x3, x1, x2, x1) * quotient(f1, &zero, f3, f1) * quotient(f2, &zero, f3, f2);
        Some(((x2.clone() - x1) * (first + second) + x1).midpoint())
    }

    /// From a point of uncertain sign: steps outwards that double until the sign is certain on either side.
    fn tighten(mut self, x: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Root<R>> {
        for outwards in [-1, 1] {
            let mut step = self.allowed().times(outwards);
            loop {
                let candidate = (step.clone() + x).midpoint();
                let (lower, upper) = self.ends();
                if candidate <= *lower || candidate >= *upper {
                    break;
                }
                self.evaluations += 1;
                let sample = Sample::take(candidate, &mut f)?;
                if sample.sign().is_some() {
                    self.insert(sample);
                    break;
                }
                step = step.times(2);
            }
        }
        Ok(self.into_root(x.clone()))
    }

    fn into_root(self, value: R) -> Root<R> {
        let (lower, upper) = self.ends();
        Root { value, lower: lower.clone(), upper: upper.clone(), evaluations: self.evaluations }
    }
}
