//! The share of g that comes from radii well below x, over complex sets of x, for profiles with many kinks.
//!
//! From one real radius to the next, both before x, it is x ∫ f'(r)/√(x² − r²) dr. The kernel is analytic in x, whatever the kinks of f between
//! them are, and f' is real: with its positive part P = ∫ f'⁺ dr and its negative part N the share is P w − N v, where w and v are means of
//! the kernel over the radii.

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::number::{Analytic, Ends, Interval, Precision, Real, Rectangle};

/// A tree of segments between neighbouring kinks.
pub(super) struct Distant {
    root: Segment,
}

/// Radii from one kink to another.
struct Segment {
    radii: Interval,
    /// The index of the first kink that is not below it.
    after: usize,
    /// ∫ f'⁺ dr and ∫ f'⁻ dr.
    rise: Interval,
    fall: Interval,
    halves: Option<Box<[Segment; 2]>>,
}

impl Distant {
    /// From f' on the segments that end at each kink, the first of which begins at the axis; `None` where one of them is not known.
    pub(super) fn new(breaks: &[Interval], slope: impl Fn(&Interval, usize) -> Option<Interval>) -> Option<Self> {
        let bounds: Vec<Interval> = breaks.iter().map(|b| b.rounded(Precision::new(BOUND_BITS))).collect();
        let zero = bounds.first()?.lit(0);
        let from = |index: usize| index.checked_sub(1).map_or(&zero, |before| &bounds[before]);
        let segment = |(index, to): (usize, &Interval)| {
            let radii = from(index).hull(to);
            let slope = slope(&radii, index)?;
            let length = to.clone() - from(index);
            let [rise, fall] = [slope.greater(&zero), (-slope).greater(&zero)].map(|part| part * &length);
            Some(Segment { radii, after: index, rise, fall, halves: None })
        };
        let segments: Vec<Segment> = bounds.iter().enumerate().map(segment).collect::<Option<_>>()?;
        Some(Distant { root: joined(segments)? })
    }

    /// The share of g of the radii up to a kink.
    pub(super) fn g<I: Ends>(&self, x: &Rectangle<I>, kink: usize) -> Option<Rectangle<I>> {
        let squared = x.squared();
        self.root.share(x, kink, &|r| x.quotient(&difference(&squared, r).sqrt()?))
    }

    /// The share of g' of the radii up to a kink.
    pub(super) fn slope<I: Ends>(&self, x: &Rectangle<I>, kink: usize) -> Option<Rectangle<I>> {
        let squared = x.squared();
        let kernel = |r: &Interval| {
            let apart = difference(&squared, r);
            apart.constant(&(-r.square())).quotient(&apart.product(&apart.sqrt()?))
        };
        self.root.share(x, kink, &kernel)
    }
}

fn difference<I: Ends>(squared: &Rectangle<I>, r: &Interval) -> Rectangle<I> {
    squared.minus(&squared.constant(&r.square()))
}

/// A balanced tree of segments; `None` of none.
fn joined(mut segments: Vec<Segment>) -> Option<Segment> {
    if segments.len() < 2 {
        return segments.pop();
    }
    let upper = segments.split_off(segments.len() / 2);
    let [lower, upper] = [joined(segments)?, joined(upper)?];
    let sum = |one: &Interval, other: &Interval| one.clone() + other;
    Some(Segment {
        radii: lower.radii.hull(&upper.radii),
        after: upper.after,
        rise: sum(&lower.rise, &upper.rise),
        fall: sum(&lower.fall, &upper.fall),
        halves: Some(Box::new([lower, upper])),
    })
}

impl Segment {
    /// Whether its radii are at least as far from x as they are apart.
    fn is_far_from<I: Ends>(&self, x: &Rectangle<I>) -> bool {
        let [from, to] = self.radii.ends();
        let beyond = x.re().clone() - I::around(x.re().ctx(), &(to.times(2) - from));
        beyond.signs()[0].is_ge()
    }

    /// The share of the radii up to a kink.
    fn share<I: Ends>(
        &self,
        x: &Rectangle<I>,
        kink: usize,
        kernel: &impl Fn(&Interval) -> Option<Rectangle<I>>,
    ) -> Option<Rectangle<I>> {
        match &self.halves {
            Some(halves) if self.after > kink || !self.is_far_from(x) => {
                let lower = halves[0].share(x, kink, kernel)?;
                if halves[0].after >= kink {
                    return Some(lower);
                }
                Some(lower.plus(&halves[1].share(x, kink, kernel)?))
            }
            _ => {
                let kernel = kernel(&self.radii)?;
                let rises = kernel.scaled(&self.rise);
                Some(if self.fall.upper().is_zero() { rises } else { rises.minus(&kernel.scaled(&self.fall)) })
            }
        }
    }
}
