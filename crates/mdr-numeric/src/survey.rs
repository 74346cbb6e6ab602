//! The crossings of a ratio through one: a search over the whole range of contact radii.
//!
//! The range is covered by panels in t = ln(a/ℓ), ℓ a length of the problem, that widen away from t = 0. A panel is
//! sampled at nine Chebyshev points and halved until it is settled: its samples and those of two enclosing panels stay
//! away from the crossing by a margin, or the polynomial through them, or through their logarithms, is resolved and
//! either has no zero or is monotone. Nothing depends on the unit of length. The search is adaptive, so it finds pairs
//! of crossings that a fixed step would miss; it is numerical evidence, not a proof.
//!
//! It complements `mdr_core::calculus::isolate`, which proves what it finds on a bounded range: this search
//! extends to the ends of the exponent range, over kinks, and past radii where the ratio is out of range or cannot be
//! computed.

mod chebyshev;
mod panel;

use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::{Real, order};

use chebyshev::{DEGREE, share};
use panel::{Settled, fit, is_quiet, outside, settle};

/// A sign change of ln(ratio) between two radii.
#[derive(Clone, Debug)]
pub(crate) struct Crossing<R> {
    /// A radius below it.
    pub(crate) lower: R,
    /// A radius above it.
    pub(crate) upper: R,
    /// Whether the ratio increases through one.
    pub(crate) rising: bool,
}

/// All crossings that were found, ascending.
#[derive(Clone, Debug)]
pub(crate) struct Survey<R> {
    pub(crate) crossings: Vec<Crossing<R>>,
    /// Whether every panel was settled.
    pub(crate) resolved: bool,
    /// Whether the ratio is one up to rounding over a whole panel, so that every radius there may be a crossing.
    pub(crate) flat: bool,
    /// The largest step in ln a between two samples, from two below the scale on.
    pub(crate) widest: f64,
}

/// The range of a search.
pub(crate) struct Range<'a, R> {
    /// What the search costs is read off this.
    pub(crate) transform: &'a dyn Transform<R>,
    /// The length ℓ.
    pub(crate) scale: R,
    /// Radii where the ratio may jump, ascending.
    pub(crate) kinks: Vec<R>,
    /// The end of the range, if it is finite.
    pub(crate) outer: Option<R>,
    /// The largest −t and t of the search, at most [`REACH`].
    pub(crate) reach: [f64; 2],
    /// The most heights that are evaluated for it.
    pub(crate) heights: u64,
}

/// A search that has seen nothing.
impl<R> Default for Survey<R> {
    fn default() -> Self {
        Survey { crossings: Vec::new(), resolved: false, flat: false, widest: f64::INFINITY }
    }
}

impl<'a, R: Real> Range<'a, R> {
    /// All radii of a profile, in units of ℓ = `scale`.
    pub(crate) fn whole(transform: &'a dyn Transform<R>, scale: R) -> Self {
        let (kinks, outer) = (transform.kinks(), transform.outer_radius());
        Range { transform, scale, kinks, outer, reach: [REACH; 2], heights: HEIGHTS }
    }
}

/// The largest |t| of a search: 10^±455000; only n = 1/2 ± 10⁻⁶ and closer has crossings far beyond.
pub(crate) const REACH: f64 = 1_048_576.0;
/// The largest −t at which a ratio without a value leaves the search unresolved: further below ℓ a fold would need a profile that
/// rises by 10²⁷ times the distance from its tip.
const NEAR: f64 = 64.0;
/// Panels are not halved below this width in ln a.
const FINEST: f64 = 1e-7;
/// The distance in ln a of the search from a kink and from the outer radius, where quadrature loses its digits.
const KINK_MARGIN: f64 = 1e-12;
const OUTER_MARGIN: f64 = 1e-6;
/// The number of nested panels that must be quiet before the innermost is accepted.
const QUIET: usize = 3;
/// A bound of the number of panels, which increases with each crossing found: the two of a wave take about ten panels.
const BUDGET: usize = 20_000;
const PER_CROSSING: usize = 64;
/// The search ends, unresolved, when so many crossings are found, or so many heights were evaluated for it. (Ten thousand
/// waves take 10⁴ crossings, an ordinary formula 10⁵ heights.)
const MOST: usize = 30_000;
pub(crate) const HEIGHTS: u64 = 20_000_000;
/// The uncertainty of the logarithm of a ratio, in unit roundoffs of the arithmetic: four times the accuracy of a
/// quadrature.
const NOISE: f64 = 128.0;
/// Levels below this are compressed, so that a ratio may pass through zero.
const FLOOR: f64 = -3.0;
const CEILING: f64 = 600.0;

/// Finds the crossings of `ratio` through one, which must not be one up to rounding over a whole panel.
///
/// # Errors
/// [`Error::Undecided`] where it is; as [`crossings`].
pub(crate) fn survey<R: Real>(range: &Range<'_, R>, ratio: impl Fn(&R) -> Result<R>) -> Result<Survey<R>> {
    let found = crossings(range, ratio)?;
    if found.flat {
        let what = "which radius it is: the condition holds up to rounding over a whole range of them";
        return Err(Error::undecided(Quantity::ContactRadius, &range.scale, what));
    }
    Ok(found)
}

/// Finds the crossings of `ratio` through one.
///
/// # Errors
/// [`Error::Stopped`] and [`Error::BudgetSpent`]: what was found up to there is not all.
pub(crate) fn crossings<R: Real>(range: &Range<'_, R>, ratio: impl Fn(&R) -> Result<R>) -> Result<Survey<R>> {
    let roundoff = range.scale.unit_roundoff().approx();
    let crossings = Vec::new();
    let kinks = range.kinks.iter().map(|kink| position(kink, &range.scale)).collect();
    let scale = &range.scale;
    let (resolved, flat, widest, panels) = (true, false, 0.0, 0);
    let (transform, last) = (range.transform, range.transform.work().saturating_add(range.heights));
    let mut search = Search {
        transform,
        last,
        scale,
        kinks,
        ratio,
        roundoff,
        crossings,
        resolved,
        flat,
        widest,
        panels,
        ended: None,
    };
    let mut edge: Option<Sample> = None;
    for (lower, upper) in cut(range) {
        let (first, last) = search.panel(lower, upper, 0);
        // Across a kink, or between two panels that were settled separately.
        if let (Some(before), Some(after)) = (edge, first)
            && before.above != after.above
        {
            search.push(before, after);
        }
        edge = last;
        if let Some(error) = search.ended {
            return Err(error);
        }
    }
    search.crossings.sort_by(|a, b| order(&a.lower, &b.lower));
    let Search { crossings, resolved, flat, widest, .. } = search;
    Ok(Survey { crossings, resolved, flat, widest })
}

/// The radius up to which a search goes before an outer radius.
pub(crate) fn surveyed_to<R: Real>(outer: &R) -> R {
    outer.clone() - R::from_f64(outer.ctx(), OUTER_MARGIN) * outer
}

/// ± [0, 2], [2, 4], [4, 8], …, cut at kinks and ends.
fn cut<R: Real>(range: &Range<'_, R>) -> Vec<(f64, f64)> {
    let position = |a: &R| position(a, &range.scale);
    let lowest = reach(&range.scale, -range.reach[0]);
    let highest = match &range.outer {
        Some(outer) => position(outer) - OUTER_MARGIN,
        None => reach(&range.scale, range.reach[1]),
    };
    let doubling = std::iter::successors(Some(2.0), |t| Some(2.0 * t)).take_while(|t| *t < REACH);
    let mut cuts: Vec<(f64, f64)> = doubling.flat_map(|t| [t, -t]).chain([0.0]).map(|t| (t, 0.0)).collect();
    cuts.extend(range.kinks.iter().map(|kink| (position(kink), KINK_MARGIN)));
    cuts.retain(|(t, _)| *t > lowest && *t < highest);
    cuts.extend([(lowest, 0.0), (highest, 0.0)]);
    cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
    cuts.windows(2).map(|pair| (pair[0].0 + pair[0].1, pair[1].0 - pair[1].1)).filter(|(a, b)| a < b).collect()
}

/// The t of largest magnitude towards `end` at which ℓeᵗ stays away from the ends of the range of the arithmetic: by
/// ten octaves from the largest numbers, by u² (u the unit roundoff) from the smallest, which do not have all their
/// digits.
fn reach<R: Real>(scale: &R, end: f64) -> f64 {
    let direction = end.signum();
    let normal = |t: f64| {
        let a = radius(scale, direction * t);
        a.clone().times(1024).is_finite() && a.unit_roundoff().square() * &a > a.lit(0)
    };
    let (mut inside, mut outside) = (0.0, end.abs());
    if normal(outside) {
        return direction * outside;
    }
    while outside - inside > 1e-3 {
        let middle = 0.5 * (inside + outside);
        if normal(middle) { inside = middle } else { outside = middle }
    }
    direction * inside
}

fn position<R: Real>(a: &R, scale: &R) -> f64 {
    (a.clone() / scale).ln().approx()
}

fn radius<R: Real>(scale: &R, t: f64) -> R {
    R::from_f64(scale.ctx(), t).exp() * scale
}

/// The ratio at one radius.
#[derive(Clone, Copy, Debug)]
struct Sample {
    t: f64,
    /// ln(ratio), compressed.
    level: f64,
    /// ratio − 1.
    excess: f64,
    /// Whether the ratio is at least one, decided in the full arithmetic.
    above: bool,
}

struct Search<'a, R, F> {
    transform: &'a dyn Transform<R>,
    /// The work of the transform at which the search ends.
    last: u64,
    scale: &'a R,
    /// In t, ascending.
    kinks: Vec<f64>,
    ratio: F,
    /// u.
    roundoff: f64,
    crossings: Vec<Crossing<R>>,
    resolved: bool,
    /// Whether the ratio was one over a whole panel.
    flat: bool,
    /// The largest step between the samples of panels that were not halved.
    widest: f64,
    panels: usize,
    /// What ended the evaluations.
    ended: Option<Error>,
}

impl<R: Real, F: Fn(&R) -> Result<R>> Search<'_, R, F> {
    /// Searches one panel, which is nested in `quiet` quiet ones; returns its first and last sample, if they exist.
    fn panel(&mut self, lower: f64, upper: f64, quiet: usize) -> (Option<Sample>, Option<Sample>) {
        if self.ended.is_some() {
            return (None, None);
        }
        if self.crossings.len() >= MOST || self.transform.work() >= self.last {
            self.resolved = false;
            return (None, None);
        }
        let (samples, blind) = self.samples(lower, upper);
        if self.ended.is_some() {
            return (None, None);
        }
        self.panels += 1;
        let (first, last) = (samples[0], samples[DEGREE]);
        let known: Vec<Sample> = samples.into_iter().flatten().collect();
        let narrow = self.is_finest(lower, upper) || self.panels > BUDGET + PER_CROSSING * self.crossings.len();
        let by_level = (known.len() == DEGREE + 1).then(|| fit(&known, |sample| sample.level));
        let quiet = if by_level.as_ref().is_some_and(|fit| is_quiet(&known, fit)) { quiet + 1 } else { 0 };
        let verdict = match by_level {
            _ if quiet == QUIET => Settled::Empty,
            Some(by_level) => settle(&known, &by_level, self.roundoff),
            None => outside(&known, upper - lower, blind),
        };
        if (!matches!(verdict, Settled::Open) || narrow) && lower >= -2.0 {
            self.widest = self.widest.max((upper - lower) * (share(DEGREE / 2 + 1) - share(DEGREE / 2)));
        }
        match verdict {
            Settled::Empty => {}
            Settled::Flat => self.flat = true,
            Settled::Monotone => self.between(&known),
            Settled::Open if narrow => {
                self.resolved = false;
                self.between(&known);
            }
            Settled::Open => {
                let middle = 0.5 * (lower + upper);
                let (first, _) = self.panel(lower, middle, quiet);
                let (_, last) = self.panel(middle, upper, quiet);
                return (first, last);
            }
        }
        (first, last)
    }

    /// Whether a panel is not halved further. Beside a kink, where g' may have an inverse root, panels are halved down
    /// to the distance left out there.
    fn is_finest(&self, lower: f64, upper: f64) -> bool {
        let width = upper - lower;
        let beside = |kink: &f64| (lower - kink).abs().min((upper - kink).abs()) <= 2.0 * KINK_MARGIN;
        width < KINK_MARGIN || width < FINEST && !self.kinks.iter().any(beside)
    }

    /// The samples of a panel, and whether one of them could not be computed although it is in range.
    fn samples(&mut self, lower: f64, upper: f64) -> ([Option<Sample>; DEGREE + 1], bool) {
        let mut blind = false;
        let samples = std::array::from_fn(|i| {
            if self.ended.is_some() {
                return None;
            }
            let t = lower * (1.0 - share(i)) + upper * share(i);
            match (self.ratio)(&radius(self.scale, t)) {
                Ok(ratio) => sample(t, &ratio),
                // Towards the tip no height overflows: a part of it has left the range of the arithmetic, and nothing is known.
                Err(Error::OutOfRange { log10, .. }) if !log10.is_finite() && (-NEAR..=0.0).contains(&t) => {
                    self.resolved = false;
                    None
                }
                Err(Error::OutOfRange { .. } | Error::Domain { .. }) => None,
                Err(error) => {
                    if error.is_interruption() {
                        self.ended = Some(error);
                    }
                    blind = true;
                    None
                }
            }
        });
        self.resolved &= !blind;
        (samples, blind)
    }

    /// Every sign change between neighbours.
    fn between(&mut self, samples: &[Sample]) {
        for pair in samples.windows(2) {
            if pair[0].above != pair[1].above {
                self.push(pair[0], pair[1]);
            }
        }
    }

    fn push(&mut self, before: Sample, after: Sample) {
        let (lower, upper) = (radius(self.scale, before.t), radius(self.scale, after.t));
        self.crossings.push(Crossing { lower, upper, rising: after.above });
    }
}

/// `None` if the ratio is NaN. An infinite ratio is a sample.
fn sample<R: Real>(t: f64, ratio: &R) -> Option<Sample> {
    let one = ratio.lit(1);
    let above = match ratio.partial_cmp(&one)? {
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal | std::cmp::Ordering::Greater => true,
    };
    let plain = ratio.approx();
    let level = if plain > FLOOR.exp() { ratio.ln().approx() } else { FLOOR - 1.0 + plain / FLOOR.exp() };
    let excess = (ratio.clone() - one).approx();
    Some(Sample { t, level: level.clamp(-CEILING, CEILING), excess, above })
}
