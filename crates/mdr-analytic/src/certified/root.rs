//! The radius at which the curve of equilibria has a value, enclosed.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Result};
use mdr_core::number::{Interval, Real};

use super::Curve;
use super::scaled::Scaled;
use crate::newton;
use crate::range::ln_sum;

impl Curve {
    /// ln P and ln Q, with their slopes.
    fn terms(&self, u: &Interval) -> [(Interval, Interval); 2] {
        let (n, one) = (&self.exponent, u.lit(1));
        let share = n.clone() / (one.clone() + n);
        let g = (n.clone() * u + &self.ln_strength, n.clone());
        let t = (self.ln_elongation(u), one.clone().over(2));
        let (p, q) = match (&self.control, &self.ln_softness) {
            (Control::Force, _) => {
                let whole = self.ln_modulus.clone() + u;
                ((whole.clone() + share.ln(), one.clone()), (whole, one))
            }
            (_, Some(ln_softness)) => {
                let s = ln_softness.clone() + u;
                (softplus(&(s.clone() + share.ln())), softplus(&s))
            }
            _ => return [g, t],
        };
        [(g.0 + p.0, g.1 + p.1), (t.0 + q.0, t.1 + q.1)]
    }

    /// A function with the sign of P − Q − x that stays in range, ln P/(Q + x) or ln (P − x)/Q, and its slope.
    fn imbalance(&self, u: &Interval, value: &Scaled) -> (Interval, Interval) {
        let [(p, rise), (q, fall)] = self.terms(u);
        let sign = value.sign();
        if sign == Some(Ordering::Equal) {
            return (p - q, rise - fall);
        }
        let x = value.ln_magnitude();
        if sign == Some(Ordering::Greater) {
            (p - ln_sum(&q, &x), rise - fall * logistic(&(q - x)))
        } else {
            (ln_sum(&p, &x) - q, rise * logistic(&(p - x)) - fall)
        }
    }

    /// ln a of the only root between two folds, where x − value changes sign, from negative if it is `rising`.
    pub(super) fn root(&self, value: &Scaled, ends: [Option<&Interval>; 2], rising: bool) -> Result<Interval> {
        let [lower, upper] = self.bracket(value, ends, rising)?;
        let imbalance = |u: &Interval| self.imbalance(u, value);
        let mut guess = newton::within(lower, upper, rising, imbalance);
        let (mut defect, mut slope) = imbalance(&guess);
        // Close to a fold the initial accuracy is lower.
        for _ in 0..6 {
            let next = (guess.clone() - defect.midpoint() / slope.midpoint()).midpoint();
            if defect.contains_zero() || !next.is_finite() {
                break;
            }
            guess = next;
            (defect, slope) = imbalance(&guess);
        }
        let ulps = (guess.abs() + guess.lit(1)) * guess.unit_roundoff().times(4);
        let step = (defect.abs().times(4) / slope.midpoint()).abs().midpoint();
        let mut radius = if step.is_finite() { (step + &ulps).midpoint() } else { ulps };
        let zero = guess.lit(0);
        for _ in 0..guess.precision().div_ceil(4) {
            let [from, to] = [guess.clone() - &radius, guess.clone() + &radius].map(|u| u.midpoint());
            // The root lies between the folds, so the search does not pass them.
            let below = ends[0].filter(|fold| !(from > **fold));
            let above = ends[1].filter(|fold| !(to < **fold));
            let lies = |u: &Interval, right: bool| {
                let excess = imbalance(u).0;
                if right == rising { excess > zero } else { excess < zero }
            };
            if (below.is_some() || lies(&from, false)) && (above.is_some() || lies(&to, true)) {
                let lower = below.map_or(from.lower(), |fold| fold.lower());
                let upper = above.map_or(to.upper(), |fold| fold.upper());
                return Ok(Interval::new(lower.clone(), upper.clone()));
            }
            radius = radius.times(8);
        }
        Err(self.undecided("where exactly the equilibrium lies"))
    }

    /// Numbers on both sides of the root: the folds, or points found from them by steps of increasing length.
    fn bracket(&self, value: &Scaled, ends: [Option<&Interval>; 2], rising: bool) -> Result<[Interval; 2]> {
        // At the radius where Q is of the magnitude of the value.
        let start = || {
            let guess = (value.ln_magnitude() - &self.ln_edge).times(2).midpoint();
            if guess.is_finite() { guess } else { guess.lit(0) }
        };
        let walk = |from: &Interval, outwards: bool| {
            let (mut step, zero) = (from.lit(if outwards { 1 } else { -1 }), from.lit(0));
            for _ in 0..from.precision() + 64 {
                let next = (from.clone() + &step).midpoint();
                let excess = self.imbalance(&next, value).0;
                if (outwards == rising && excess > zero) || (outwards != rising && excess < zero) {
                    return Ok(next);
                }
                step = step.times(2);
            }
            Err(self.undecided("where the equilibrium lies"))
        };
        Ok(match ends.map(|end| end.map(Real::midpoint)) {
            [Some(lower), Some(upper)] => [lower, upper],
            [Some(lower), None] => [lower.clone(), walk(&lower, true)?],
            [None, Some(upper)] => [walk(&upper, false)?, upper],
            [None, None] => [walk(&start(), false)?, walk(&start(), true)?],
        })
    }
}

/// ln(1 + eˣ), and its slope.
fn softplus(x: &Interval) -> (Interval, Interval) {
    (ln_sum(&x.lit(0), x), logistic(x))
}

/// 1/(1 + e⁻ˣ).
fn logistic(x: &Interval) -> Interval {
    x.lit(1) / &((-x.clone()).exp() + x.lit(1))
}
