//! g, g' and G of the interpolant, piece by piece.

use mdr_core::contact::{Error, Kink, Quantity, Result, Slopes, Transform};
use mdr_core::number::Special;

use super::MeasuredProfile;
use super::arc::{Arc, Spoke};
use super::hermite::{Piece, Quadratic};
use super::series;

/// The three integrals over θ, r = x sin θ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// g/x = ∫ f' dθ (1.1).
    Value,
    /// g' = ∫ (r f')' dθ.
    Slope,
    /// G/x² = ∫ f' cos²θ dθ.
    Integral,
}

impl<R: Special> MeasuredProfile<R> {
    /// The integral from the tip to x.
    fn integrate(&self, part: Part, x: &R) -> Result<R> {
        if !(*x > x.lit(0)) {
            return Err(Error::domain(Quantity::Radius, x, "positive"));
        }
        if !(*x <= self.end) {
            return Err(Error::domain(Quantity::Radius, x, "at most the last radius of the table"));
        }
        let whole = self.pieces.partition_point(|piece| piece.start < *x) - 1;
        if self.pieces.get(whole + 1).is_some_and(|next| !(*x <= next.start)) {
            return Err(Error::domain(Quantity::Radius, x, "certainly on one side of each row of the table"));
        }
        Ok(self.sum(part, x, whole))
    }

    /// For x in the piece of index `whole`.
    fn sum(&self, part: Part, x: &R, whole: usize) -> R {
        if whole == 0 {
            return self.pieces[0].share_at_tip(part, x);
        }
        let (sum, spoke) = self.below(part, x, whole);
        let last = &self.pieces[whole];
        let length = (x.clone() - &last.start) / &last.width;
        sum + last.share(part, x, &spoke, &Spoke::edge(x), &length)
    }
}

impl<R: Special> MeasuredProfile<R> {
    /// The contribution of all pieces before that of index `whole`, far ones together, and the spoke to its start.
    fn below(&self, part: Part, x: &R, whole: usize) -> (R, Spoke<R>) {
        let tree = if self.far.is_some() { None } else { self.series.tree(&self.pieces) };
        let tree = tree.map(|tree| (tree, series::bits_of(x)));
        let far = |next: usize| match (&self.far, tree) {
            (Some(far), _) => far.cluster(next, whole, x).map(|(cluster, after)| (far.share(cluster, part, x), after)),
            (None, Some((tree, bits))) => tree.share(part, x, bits, next, whole),
            (None, None) => None,
        };
        let mut sum = x.lit(0);
        let mut next = 0;
        let mut spoke = Spoke::new(&x.lit(0), x);
        while next < whole {
            if let Some((share, after)) = far(next) {
                sum += &share;
                next = after;
                spoke = Spoke::new(&self.pieces[next].start, x);
            } else {
                let to = Spoke::new(&self.pieces[next + 1].start, x);
                sum += &self.pieces[next].share(part, x, &spoke, &to, &x.lit(1));
                next += 1;
                spoke = to;
            }
        }
        (sum, spoke)
    }
}

impl<R: Special> Piece<R> {
    /// The contribution of the first `length` (of its width) of this piece, between two spokes.
    pub(super) fn share(&self, part: Part, x: &R, from: &Spoke<R>, to: &Spoke<R>, length: &R) -> R {
        let arc = Arc::new(from, to, length, &(x.clone() / &self.width));
        let density = if part == Part::Slope { &self.bend } else { &self.slope };
        let moments = if part == Part::Integral { arc.lifted() } else { arc.weighted() };
        let terms = density.about(&arc.centre).into_iter().zip(&moments);
        terms.fold(x.lit(0), |sum, (coefficient, moment)| sum + coefficient * moment)
    }

    /// The contribution of the piece that begins at the tip, for x within it: a polynomial in x, by ∫ sinᵏθ dθ or ∫
    /// sinᵏθ cos²θ dθ from 0 to π/2. An enclosure is valid for all radii down to the tip at once.
    fn share_at_tip(&self, part: Part, x: &R) -> R {
        let Quadratic([c0, c1, c2]) = if part == Part::Slope { &self.bend } else { &self.slope };
        let eighth = x.pi().over(4);
        let [m0, m1, m2] = match part {
            Part::Integral => [eighth.clone(), x.ratio(1, 3), eighth.over(4)],
            _ => [eighth.clone().times(2), x.lit(1), eighth],
        };
        let s = x.clone() / &self.width;
        ((m2 * c2) * &s + m1 * c1) * s + m0 * c0
    }
}

/// sum · xᵏ, if it is in range.
fn in_range<R: Special>(sum: R, x: &R, power: i32) -> Result<R> {
    let zero = sum == sum.lit(0);
    let log10 = sum.approx().abs().log10() + f64::from(power) * x.approx().log10();
    let value = (0..power).fold(sum, |product, _| product * x);
    if value.is_finite() && (zero || value != value.lit(0)) {
        Ok(value)
    } else {
        Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 })
    }
}

/// Exact up to rounding: see [`MeasuredProfile`] for the bounds. The kinks are all radii of the table, where f'' jumps
/// and g'' has a square-root singularity from outside; g and g' are continuous.
impl<R: Special> Transform<R> for MeasuredProfile<R> {
    fn g(&self, x: &R) -> Result<R> {
        in_range(self.integrate(Part::Value, x)?, x, 1)
    }

    fn slope(&self, x: &R) -> Result<R> {
        in_range(self.integrate(Part::Slope, x)?, x, 0)
    }

    fn integral(&self, x: &R) -> Result<R> {
        in_range(self.integrate(Part::Integral, x)?, x, 2)
    }

    fn outer_radius(&self) -> Option<R> {
        Some(self.end.clone())
    }

    fn kinks(&self) -> Vec<R> {
        self.pieces.iter().skip(1).map(|piece| piece.start.clone()).collect()
    }

    fn kink(&self, index: usize, margin: &R) -> Result<Option<Kink<R>>> {
        let Some(next) = self.pieces.get(index + 1) else { return Ok(None) };
        let b = &next.start;
        let near = b.clone().inflate(&(margin.clone() * b));
        // The interval must not reach the next row.
        let last = next.start.clone() + &next.width;
        if !(near > self.pieces[index].start && near < last) {
            return Ok(None);
        }
        let value = (self.sum(Part::Value, b, index) * b, self.sum(Part::Integral, b, index) * b);
        let inside = Slopes::within(self.sum(Part::Slope, &near, index));
        let outside = Slopes::within(self.just_outside(index, &near, margin));
        Ok(Some(Kink { value: Some(value), inside, outside }))
    }
}

impl<R: Special> MeasuredProfile<R> {
    /// g' at all x between b = the end of the piece of index `last` and b(1 + margin).
    ///
    /// The part beyond b has the angle arccos(b/x), which begins at 0; the pieces up to b have the remaining angle.
    fn just_outside(&self, last: usize, x: &R, margin: &R) -> R {
        let up_to = |greatest: R| {
            let half = greatest.over(2);
            half.clone().inflate(&half)
        };
        let (piece, next) = (&self.pieces[last], &self.pieces[last + 1]);
        let stretch = margin.lit(1) + margin;
        let tangent = ((margin.lit(2) + margin) * margin).sqrt();
        let spoke = Spoke { sin: next.start.clone() / x, cos: up_to(tangent.clone() / &stretch) };
        let (before, from) = self.below(Part::Slope, x, last);
        let whole = piece.share(Part::Slope, x, &from, &spoke, &x.lit(1));
        let beyond = next.bend.at(&up_to(margin.clone() * &next.start / &next.width)) * up_to(tangent.atan());
        before + whole + beyond
    }
}
