//! The shape-preserving cubic: slopes at the points, pieces between them.

#[cfg(feature = "mp")]
use mdr_core::contact::LocalPolynomial;
use mdr_core::contact::{Error, Profile, Quantity, Result};
#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::{Lift, Real};

use super::MeasuredProfile;

/// c₀ + c₁s + c₂s².
#[derive(Clone, Debug)]
pub(super) struct Quadratic<R>(pub(super) [R; 3]);

impl<R: Real> Quadratic<R> {
    /// Its value at s.
    pub(super) fn at(&self, s: &R) -> R {
        let [c0, c1, c2] = &self.0;
        (c2.clone() * s + c1) * s + c0
    }

    /// The polynomial in powers of s − centre.
    pub(super) fn about(&self, centre: &R) -> [R; 3] {
        let [c0, c1, c2] = &self.0;
        let slope = c2.clone() * centre;
        let value = (slope.clone() + c1) * centre + c0;
        [value, slope.times(2) + c1, c2.clone()]
    }
}

/// One cubic piece, in the local coordinate s = (r − start)/width in [0, 1].
#[derive(Clone, Debug)]
pub(super) struct Piece<R> {
    pub(super) start: R,
    pub(super) width: R,
    height: R,
    /// f'.
    pub(super) slope: Quadratic<R>,
    /// (r f')' = f' + r f''.
    pub(super) bend: Quadratic<R>,
}

impl<R: Real> Piece<R> {
    /// The Hermite cubic with the difference quotient `secant` between the slopes `first` and `last`. All coefficients
    /// are sums of the two differences of slopes, so none exceeds the variation of f'. From a flat start to the steepest monotone
    /// end, three times the secant, there is no curvature at the start: not one of the size of a rounding either, which would make
    /// a dimple or none by the unit of length.
    fn new((start, height): &(R, R), width: &R, secant: &R, first: &R, last: &R) -> Self {
        let (before, after) = (secant.clone() - first, last.clone() - secant);
        let zero = first.lit(0);
        let inflected = *first == zero && *last == secant.clone().times(3);
        let c1 = if inflected { zero } else { before.clone().times(4) - after.clone().times(2) };
        let c2 = (after - before).times(3);
        let aspect = start.clone() / width;
        let bend = Quadratic([
            first.clone() + aspect.clone() * &c1,
            (c1.clone() + aspect * &c2).times(2),
            c2.clone().times(3),
        ]);
        let slope = Quadratic([first.clone(), c1, c2]);
        Piece { start: start.clone(), width: width.clone(), height: height.clone(), slope, bend }
    }

    /// f(r).
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        self.height_at(&((r.clone() - S::lift(&self.start)) / S::lift(&self.width)))
    }

    /// f at s, by Horner.
    pub(super) fn height_at<S: Lift<R>>(&self, s: &S) -> S {
        let Quadratic([c0, c1, c2]) = &self.slope;
        let lift = S::lift;
        let mean_slope = ((lift(c2).over(3) * s + lift(c1).over(2)) * s) + lift(c0);
        mean_slope * s * lift(&self.width) + lift(&self.height)
    }
}

#[cfg(feature = "mp")]
impl Piece<Interval> {
    /// f(r).
    pub(super) fn polynomial(&self) -> LocalPolynomial {
        let Quadratic([c0, c1, c2]) = &self.slope;
        let along = |coefficient: &Interval, order: i64| coefficient.clone().over(order) * &self.width;
        let coefficients = vec![self.height.clone(), along(c0, 1), along(c1, 2), along(c2, 3)];
        LocalPolynomial { start: self.start.clone(), width: self.width.clone(), coefficients }
    }
}

/// The pieces through points whose first is the tip.
pub(super) fn pieces<R: Real>(points: &[(R, R)]) -> Result<Vec<Piece<R>>> {
    let mut widths = Vec::with_capacity(points.len());
    let mut secants = Vec::with_capacity(points.len());
    for pair in points.windows(2) {
        let [(r, f), (next_r, next_f)] = pair else { continue };
        let width = next_r.clone() - r;
        if !(width > width.lit(0) && next_r.is_finite()) {
            let requirement = "finite and larger than the radius before it";
            return Err(Error::domain(Quantity::Parameter("a radius of the table"), next_r, requirement));
        }
        let secant = (next_f.clone() - f) / &width;
        if !secant.clone().times(16).is_finite() {
            let requirement = "finite, also as a difference quotient";
            return Err(Error::domain(Quantity::Parameter("a height of the table"), next_f, requirement));
        }
        widths.push(width);
        secants.push(secant);
    }
    let slopes = slopes(&widths, &secants);
    let piece = |i: usize| Piece::new(&points[i], &widths[i], &secants[i], &slopes[i], &slopes[i + 1]);
    Ok((0..widths.len()).map(piece).collect())
}

/// f' at the points: 0 at the tip; then that of the parabola through the point and its two neighbours, limited so that
/// the pieces on either side are monotone; at the end that of the last such parabola.
fn slopes<R: Real>(widths: &[R], secants: &[R]) -> Vec<R> {
    let mut slopes = vec![widths[0].lit(0)];
    for i in 1..widths.len() {
        let [left, right] = [&widths[i - 1], &widths[i]];
        let [before, after] = [&secants[i - 1], &secants[i]];
        let parabola = (before.clone() * right + after.clone() * left) / (left.clone() + right);
        slopes.push(cut_back(parabola, before, after));
    }
    let [.., left, right] = widths else { return slopes };
    let [.., before, last] = secants else { return slopes };
    let parabola = (last.clone() - before) * right / (left.clone() + right) + last;
    slopes.push(cut_back(parabola, last, last));
    slopes
}

/// `slope` if both secants have its sign and it is at most three times the smaller; else the nearest slope that
/// satisfies this, or 0.
///
/// Written as a lower and an upper bound, one of which is 0: a continuous function of all three, which an enclosure can
/// evaluate without knowing their order.
fn cut_back<R: Real>(slope: R, before: &R, after: &R) -> R {
    let zero = slope.lit(0);
    let steepest_rise = before.lesser(after).greater(&zero).times(3);
    let steepest_fall = before.greater(after).lesser(&zero).times(3);
    slope.lesser(&steepest_rise).greater(&steepest_fall)
}

/// The height of the interpolant, for r up to the last radius; beyond it the last cubic is continued.
impl<R: Real> Profile<R> for MeasuredProfile<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let below = self.pieces.partition_point(|piece| S::lift(&piece.start) < *r);
        self.pieces[below.max(1) - 1].height(r)
    }

    fn kinks(&self) -> Vec<R> {
        self.pieces.iter().skip(1).map(|piece| piece.start.clone()).collect()
    }

    fn outer_radius(&self) -> Option<R> {
        Some(self.end.clone())
    }

    /// The first piece begins as c r², unless it is flat.
    fn tip_exponent(&self) -> Option<R> {
        let Quadratic([_, curvature, third]) = &self.pieces[0].slope;
        let zero = curvature.lit(0);
        if *curvature != zero {
            Some(zero.lit(2))
        } else if *third != zero {
            Some(zero.lit(3))
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second height is more than four times the first: the slope at the first row is cut back to three secants. In f64 the
    /// curvature was a rounding of either sign.
    #[test]
    fn the_tip_of_a_steepening_table_is_no_dimple_in_any_unit_of_length() {
        let curvatures = |scale: f64| {
            let points: Vec<_> = [(0.0, 0.0), (0.09, 0.0033), (0.18, 0.0225), (0.27, 0.0806)]
                .map(|(r, f): (f64, f64)| (r * scale, f * scale))
                .to_vec();
            pieces(&points).expect("rows of a profile")[0].slope.0
        };
        for i in 0..200 {
            let [first, curvature, third] = curvatures(1.37f64.powi(i - 100));
            assert!(first == 0.0 && curvature == 0.0 && third > 0.0, "{i}: {curvature}");
        }
    }
}
