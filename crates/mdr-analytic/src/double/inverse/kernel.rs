//! Fast evaluation of equilibria at a value: pairs of doubles without branches, for one value or for rows of them.
//!
//! In the variables of [`inverse`](crate::inverse), f(v) = mE − P − μz with E = e^v and P = e^{mv}, so that f' = m(E − P):
//!
//! 1. v from [`InitialGuess`], and steps in doubles until one of them is short: with s = −f/f', α = f''/2f' and β = f'''/6f',
//!    δ = s − αs² + (2α² − β)s³.
//! 2. One more such step from v, taken as an exact double, with E, P and f in pairs. The root is v + δ.
//! 3. With H = e^u, which is E, P or, under force, one more exponential,
//!    a = a_λH²e^{2δᵤ}, Δl = sHe^{δᵤ}, s = 2√(Ba_λ), and d or F from these, each rounded once from a pair.
//!
//! **Error.** Constants and exponentials come with bounds of their errors. Their effect on f, over |f'|, is the first
//! part of the error of δ. The second is truncation. For k ≥ 2, f⁽ᵏ⁾/f' = 1 + (mᵏ⁻¹ − 1)P/(P − E), where
//! P/(P − E) ≤ 1 + 1/(μv) for v > 0 and P/(E − P) ≤ 1/(μ|v|) for v < 0; hence |f⁽ᵏ⁾/f'| ≤ (m + 1/|v|)ᵏ⁻¹ and |f⁽ᵏ⁾/(k!f')| ≤ Kᵏ⁻¹
//! with K = (m + 1/|v|)/2. So the series of the root in s is dominated by the inverse of δ − Kδ² − K²δ³ − …: s + Ks² +
//! 3K²s³ + 11K³s⁴ + … with quotients below 6 (the little Schröder numbers). For K|s| ≤ 1/128 the sum beyond the third
//! term is below 11.6K³s⁴, and the root has the sign of v, which determines its branch; δᵤ⁴/24, the first term omitted
//! by e^{δᵤ}, is below 0.4K³s⁴ of δᵤ/δ, as δᵤ ≤ mδ and m ≤ 2K. The third part are the roundings of δ in doubles, small
//! because a last step is short. Together they bound the errors of a, and of d or F; a result is trusted if they are
//! below half an ulp: with the last rounding it is within one ulp, for any starting v. Otherwise (very close to the
//! fold, to n = 1/2 or to a zero of d or F, or far out of range) extended precision is used.

use mdr_core::contact::Regime;
use mdr_core::number::{Extended, Real};

use super::super::exponential::{self, exponential, rough_exponential, rough_logarithm};
use super::super::pair::{Arithmetic, Native, Pair};
use super::quadratic::Length;
use crate::contact::PowerLawContact;
use crate::inverse::{Branch, Count, FoldFrame, Held, InitialGuess};

/// Half an ulp of any number, reduced slightly for roundings of the bounds themselves.
const ENOUGH: f64 = 0.4999 * f64::EPSILON / 2.0;

/// A generous bound for products, quotients and sums of pairs.
pub(super) const PAIR: f64 = 1.0 / (1_u128 << 98) as f64;

/// Binary exponents of constants, of E and P, and of H, within which no product is subnormal or overflows before a
/// result leaves the trusted range.
const CONSTANTS: u64 = 300;
const LOGARITHM: f64 = 600.0;
pub(super) const LENGTHS: f64 = 1e45;

/// The largest K|s| of a step in doubles after which v is accurate enough for the last step, and of the last step.
const CLOSE: f64 = 1.0 / 16.0;
const LAST: f64 = 1.0 / 128.0;

/// The number of steps in doubles that m near 1.02 takes.
const MOST_STEPS: usize = 5;

/// A constant and a bound of its relative error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) pair: Pair,
    pub(super) error: f64,
}

impl Known {
    fn new<const N: usize>(value: &Extended<N>) -> Option<Self> {
        let magnitude = Pair::of_magnitude(value, CONSTANTS)?;
        let pair = if *value < value.lit(0) { Pair { hi: -magnitude.hi, lo: -magnitude.lo } } else { magnitude };
        Some(Known { pair, error: value.error() * 2f64.powi(-64 * N as i32) + PAIR })
    }
}

/// Quantities that do not depend on the value.
#[derive(Clone, Debug)]
pub(super) struct Constants {
    pub(super) held: Held,
    pub(super) regime: Regime,
    n: f64,
    m: Pair,
    inverse_m: f64,
    guess: InitialGuess,
    /// x_fold, and the τ above which its rounding and uncertainty are negligible.
    pub(super) fold: f64,
    inverse_fold: f64,
    nearest: f64,
    /// μ/x_fold.
    pub(super) share: Known,
    /// a_λ.
    radius: Known,
    /// s.
    elongation: Known,
    /// 2E*/(n+1), or (n+1)/2E* under force.
    stiffness: Known,
    /// u/v.
    stretch: Pair,
    /// H, where the equation is quadratic.
    quadratic: Option<Length>,
}

/// Where a value lies.
pub(super) struct Place {
    /// Whether it is far enough from the fold and from the ends of the range for all else to be known here.
    pub(super) decided: bool,
    /// Whether the larger equilibrium exists.
    pub(super) exists: bool,
    /// Whether its sign is that of the fold: if the larger equilibrium exists, the smaller one does.
    pub(super) pulled: bool,
}

/// Equilibria of one branch for each lane.
pub(super) struct Lanes<const N: usize> {
    pub(super) radius: [f64; N],
    /// F, or d under force.
    pub(super) other: [f64; N],
    /// Whether both are trusted.
    pub(super) trusted: [bool; N],
}

impl Constants {
    /// `None` if a constant is out of range.
    pub(super) fn new<const N: usize>(
        contact: &PowerLawContact<Extended<N>>,
        fold: &FoldFrame<Extended<N>>,
    ) -> Option<Self> {
        let FoldFrame { held, state, family } = fold;
        let (held, excess, regime) = (*held, &family.excess, family.regime);
        let n = *contact.profile().exponent();
        let next = n + n.lit(1);
        let modulus = contact.material().effective_modulus().times(2);
        let at_fold = held.pick(&state.indentation, &state.force);
        let value = Known::new(at_fold)?;
        let above = regime == Regime::PullOff;
        let m = parameter(held, above, n.approx());
        let u = if above { Pair::from(1.0) } else { m };
        Some(Constants {
            held,
            regime,
            n: n.approx(),
            m,
            inverse_m: m.hi.recip(),
            guess: InitialGuess::new(excess.approx()),
            fold: value.pair.hi,
            inverse_fold: value.pair.hi.recip(),
            nearest: 1e-12 + 4.0 * value.error,
            share: Known::new(&(*excess / at_fold))?,
            radius: Known::new(&state.contact_radius)?,
            elongation: Known::new(&contact.elongation(&state.contact_radius))?,
            stiffness: Known::new(&held.pick(modulus / next, next / modulus))?,
            stretch: held.pick(u, u.over(Native, Pair::from(3.0), 1.0 / 3.0)),
            quadratic: Length::of(held, n.approx()),
        })
    }

    /// τ, accurate enough for a start unless it is refused.
    #[inline(always)]
    fn tau(&self, x: f64) -> f64 {
        (self.fold - x) / self.fold
    }

    /// The number of equilibria at x; `None` too close to the fold or too far from it to decide here.
    #[inline(always)]
    pub(super) fn count(&self, x: f64) -> Option<Count> {
        let Place { decided, exists, pulled } = self.place(x);
        match (decided, exists, pulled) {
            (false, ..) => None,
            (_, false, _) => Some(Count::None),
            (.., true) => Some(Count::Two),
            (.., false) => Some(Count::Larger),
        }
    }

    /// Where x is, without branches.
    #[inline(always)]
    pub(super) fn place(&self, x: f64) -> Place {
        let (z, tau) = (x * self.inverse_fold, (self.fold - x) * self.inverse_fold);
        let ordinary = |x: f64| (x == 0.0) | ((x.abs() > 1e-200) & (x.abs() < 1e200));
        let decided = (tau.abs() > self.nearest) & ordinary(x) & ordinary(z) & ((z == 0.0) == (x == 0.0));
        Place { decided, exists: tau >= 0.0, pulled: z > 0.0 }
    }

    /// The equilibria at x, each on its branch.
    #[inline(always)]
    pub(super) fn on_branches<A: Arithmetic, const FORCE: bool, const N: usize>(
        &self,
        arithmetic: A,
        x: &[f64; N],
        branch: impl Fn(usize) -> Branch,
    ) -> Lanes<N> {
        // The way from E to H is chosen outside of the loops over lanes.
        match self.quadratic {
            Some(Length::Root) if !FORCE => self.closed::<A, false, N>(arithmetic, Length::Root, x, branch),
            Some(Length::Square) if !FORCE => self.closed::<A, false, N>(arithmetic, Length::Square, x, branch),
            Some(Length::CubeRoot) if FORCE => self.closed::<A, true, N>(arithmetic, Length::CubeRoot, x, branch),
            _ => {
                let mut v = [0.0; N];
                for i in 0..N {
                    v[i] = self.first::<A>(x[i], branch(i));
                }
                self.solve::<A, FORCE, N>(arithmetic, x, v)
            }
        }
    }

    /// The initial v on a branch.
    #[inline(always)]
    fn first<A: Arithmetic>(&self, x: f64, branch: Branch) -> f64 {
        let tau = self.tau(x);
        match branch {
            Branch::Larger => rough_logarithm::<A>(1.0 + self.guess.growth(tau)) * self.inverse_m,
            Branch::Smaller => rough_logarithm::<A>(x / (self.fold * self.guess.quotient(tau))),
        }
    }

    /// The equilibria at x whose v are near `v`, provided the steps do not lead to the other branch.
    #[inline(always)]
    fn solve<A: Arithmetic, const FORCE: bool, const N: usize>(
        &self,
        arithmetic: A,
        x: &[f64; N],
        mut v: [f64; N],
    ) -> Lanes<N> {
        let (first, mut far) = (v, [1_u64; N]);
        for _ in 0..MOST_STEPS {
            // A lane that has converged stays unchanged, so that its result does not depend on the others.
            for i in 0..N {
                let (step, is_close) = self.step::<A>(x[i], v[i]);
                v[i] += if far[i] == 1 { step } else { 0.0 };
                far[i] &= u64::from(!is_close);
            }
            if far.iter().fold(0, |any, far| any | far) == 0 {
                break;
            }
        }
        let mut lanes = Lanes { radius: [0.0; N], other: [0.0; N], trusted: [false; N] };
        for i in 0..N {
            (lanes.radius[i], lanes.other[i], lanes.trusted[i]) = self.state_near::<A, FORCE>(arithmetic, x[i], v[i]);
            lanes.trusted[i] &= first[i] * v[i] > 0.0;
        }
        lanes
    }

    /// A step in doubles, and whether it was the last one in doubles.
    #[inline(always)]
    fn step<A: Arithmetic>(&self, x: f64, v: f64) -> (f64, bool) {
        let m = self.m.hi;
        let (e, p) = (rough_exponential::<A>(v), rough_exponential::<A>(m * v));
        let numerator = A::multiply_add(m, e, -p) - self.share.pair.hi * x;
        let inverse_slope = 1.0 / (m * (p - e));
        let newton = numerator * inverse_slope;
        let size = 0.5 * newton.abs() * (m + 1.0 / v.abs());
        (third_order::<A>(m, e, p, newton, inverse_slope), size < CLOSE)
    }

    /// H at the root near v, and the bound of its relative error, which is ∞ if nothing is known.
    #[inline(always)]
    fn length<A: Arithmetic, const FORCE: bool>(&self, arithmetic: A, x: f64, v: f64) -> (Pair, f64) {
        let m = self.m;
        let mv = m.scaled(arithmetic, v);
        let (e, p) = (exponential(arithmetic, Pair::from(v)), exponential(arithmetic, mv));
        let (scaled, shifted) = (m.times(arithmetic, e), self.share.pair.scaled(arithmetic, x));
        let numerator = scaled.minus(p).minus(shifted).rounded();
        let inverse_slope = 1.0 / (m.hi * p.minus(e).rounded());
        let newton = numerator * inverse_slope;
        let step = third_order::<A>(m.hi, e.hi, p.hi, newton, inverse_slope);

        let (s, steep) = (newton.abs(), inverse_slope.abs());
        let curvature = 0.5 * (m.hi + 1.0 / v.abs());
        let powers = scaled.hi + p.hi;
        let uncertain = powers * (exponential::ERROR + mv.hi.abs() * PAIR) + shifted.hi.abs() * self.share.error;
        let truncated = 12.0 * curvature * (curvature * s) * (curvature * s) * s * s;
        // f, f' and s are accurate to a few roundings, and αs², which bounds the other terms, to those of its terms.
        let rounded = s * f64::EPSILON * (4.0 + 2.0 * s * m.hi * m.hi * powers * steep);
        let step_error = uncertain * steep * (1.0 + 4.0 * curvature * s) + truncated + rounded;

        let length = if FORCE {
            exponential(arithmetic, self.stretch.scaled(arithmetic, v))
        } else if self.regime == Regime::PullOff {
            e
        } else {
            p
        };
        let small = self.stretch.hi * step;
        let growth = small * (1.0 + small * (0.5 + small * (1.0 / 6.0)));
        let grown = Pair::quick_sum(length.hi, length.hi * growth);
        let grown = Pair { hi: grown.hi, lo: grown.lo + (length.lo + length.lo * growth) };
        let error =
            exponential::ERROR + mv.hi.abs() * PAIR + self.stretch.hi * step_error + 2.0 * f64::EPSILON * growth.abs();
        let known = (curvature * s < LAST)
            & (small.abs() < LAST)
            & (mv.hi.abs() < LOGARITHM)
            & (length.hi > 1.0 / LENGTHS)
            & (length.hi < LENGTHS);
        (grown, if known { error } else { f64::INFINITY })
    }

    /// a and F (or d, under force) of the root near v, and whether they are trusted.
    #[inline(always)]
    fn state_near<A: Arithmetic, const FORCE: bool>(&self, arithmetic: A, x: f64, v: f64) -> (f64, f64, bool) {
        self.state::<A, FORCE>(arithmetic, x, self.length::<A, FORCE>(arithmetic, x, v))
    }

    /// a and F (or d, under force) from H and the bound of its error, and whether they are trusted.
    #[inline(always)]
    pub(super) fn state<A: Arithmetic, const FORCE: bool>(
        &self,
        arithmetic: A,
        x: f64,
        (grown, grown_error): (Pair, f64),
    ) -> (f64, f64, bool) {
        let a = self.radius.pair.times(arithmetic, grown.square(arithmetic));
        let a_error = self.radius.error + 2.0 * grown_error + PAIR;
        let elongation = self.elongation.pair.times(arithmetic, grown);
        let elongation_error = elongation.hi * (self.elongation.error + grown_error + PAIR);
        let (other, is_small) = if FORCE {
            let scaled = self.stiffness.pair.scaled(arithmetic, x);
            let pressed = scaled.over(arithmetic, a, 1.0 / a.hi);
            let sum = pressed.plus(elongation);
            let error = elongation_error + pressed.hi.abs() * (self.stiffness.error + a_error + PAIR);
            let is_small = error < (ENOUGH - PAIR) * sum.hi.abs();
            (sum.over(arithmetic, Pair::from(self.n), 1.0 / self.n), is_small)
        } else {
            let pressed = A::product(self.n, x).minus(elongation);
            let is_small = elongation_error < (ENOUGH - (self.stiffness.error + a_error + PAIR)) * pressed.hi.abs();
            (pressed.times(arithmetic, self.stiffness.pair).times(arithmetic, a), is_small)
        };
        let (a, other) = (a.rounded(), other.rounded());
        let inside = |value: f64| (value.abs() > 1e-250) & (value.abs() < 1e250);
        (a, other, (a_error < ENOUGH) & is_small & inside(a) & inside(other))
    }
}

/// δ = s − αs² + (2α² − β)s³.
#[inline(always)]
fn third_order<A: Arithmetic>(m: f64, e: f64, p: f64, newton: f64, inverse_slope: f64) -> f64 {
    let (scaled, half) = (m * p, 0.5 * m * inverse_slope);
    // f' = −1/inverse_slope.
    let alpha = (scaled - e) * half;
    let beta = A::multiply_add(scaled, m, -e) * half * (1.0 / 3.0);
    let third = A::multiply_add(2.0 * alpha, alpha, -beta);
    newton * A::multiply_add(newton, A::multiply_add(newton, third, -alpha), 1.0)
}

/// m > 1, p/q or its reciprocal.
fn parameter(held: Held, above: bool, n: f64) -> Pair {
    let (p, q) = held.pick((Pair::from(2.0 * n), 1.0), (Pair::sum(2.0 * n, 2.0), 3.0));
    let (upper, lower) = if above { (p, Pair::from(q)) } else { (Pair::from(q), p) };
    upper.over(Native, lower, lower.hi.recip())
}

#[cfg(test)]
#[path = "../../../tests/private/inverse_kernel.rs"]
mod tests;
