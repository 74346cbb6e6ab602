//! Equilibria where m = 2: a quadratic equation.
//!
//! Under a dead load that is n = 2, JKR, whose √a³ is the root; at a given depth the cone, whose √a it is, and n = 1/4. With
//! E = e^v and P = E² the equation 2E − E² − z = 0 has the roots 1 ± √τ, τ = 1 − z. The smaller one is z/(1 + √τ), which
//! cancels nothing. H is E, its square, or under a dead load its cube root.
//!
//! **Error.** z has that of μ/x_fold, and 1 + |z| times it is that of τ. Half of it over √τ is that of √τ, which beside that is a step of
//! Newton from a rounded root, 2⁻¹⁰⁵. The cube root is a step of Newton from h, which is within 8 roundings: 2⁻¹⁰⁰, with the
//! rounding of the step. Each is below [`PAIR`].

use super::super::exponential::{FROM_INTEGER, TO_INTEGER};
use super::super::pair::{Arithmetic, Pair};
use super::kernel::{Constants, LENGTHS, Lanes, PAIR};
use crate::inverse::{Branch, Held};

/// H of a root E.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Length {
    /// E, of the cone at a given depth.
    Root,
    /// E², of n = 1/4 at a given depth.
    Square,
    /// E^(1/3), of n = 2 under a dead load.
    CubeRoot,
}

impl Length {
    /// That of the exponents whose equation is quadratic.
    pub(super) fn of(held: Held, n: f64) -> Option<Self> {
        match held {
            Held::Force => (n == 2.0).then_some(Length::CubeRoot),
            Held::Indentation if n == 1.0 => Some(Length::Root),
            Held::Indentation => (n == 0.25).then_some(Length::Square),
        }
    }

    /// H and the bound of its relative error, which is ∞ if nothing is known.
    #[inline(always)]
    fn of_root<A: Arithmetic>(self, arithmetic: A, (root, error): (Pair, f64)) -> (Pair, f64) {
        let (length, error) = match self {
            Length::Root => (root, error),
            Length::Square => (root.square(arithmetic), 2.0 * error + PAIR),
            Length::CubeRoot => (cube_root(arithmetic, root), error * (1.0 / 3.0) + PAIR),
        };
        let known = (length.hi > 1.0 / LENGTHS) & (length.hi < LENGTHS);
        (length, if known { error } else { f64::INFINITY })
    }
}

impl Constants {
    /// The equilibria at x, each on its branch, by the quadratic equation.
    #[inline(always)]
    pub(super) fn closed<A: Arithmetic, const FORCE: bool, const N: usize>(
        &self,
        arithmetic: A,
        length: Length,
        x: &[f64; N],
        branch: impl Fn(usize) -> Branch,
    ) -> Lanes<N> {
        let mut lanes = Lanes { radius: [0.0; N], other: [0.0; N], trusted: [false; N] };
        for (i, &x) in x.iter().enumerate() {
            let length = length.of_root(arithmetic, self.root(arithmetic, x, branch(i)));
            (lanes.radius[i], lanes.other[i], lanes.trusted[i]) = self.state::<A, FORCE>(arithmetic, x, length);
        }
        lanes
    }

    /// E of a branch, and the bound of its relative error.
    #[inline(always)]
    fn root<A: Arithmetic>(&self, arithmetic: A, x: f64, branch: Branch) -> (Pair, f64) {
        let z = self.share.pair.scaled(arithmetic, x);
        // Near the fold 1 − z cancels, and its lower part need no longer be small beside its upper one.
        let tau = Pair::from(1.0).minus(z);
        let tau = Pair::quick_sum(tau.hi, tau.lo);
        let first = tau.hi.sqrt();
        let half = 0.5 / first;
        let rest = (A::residual(tau.hi, first, first) + tau.lo) * half;
        let larger = Pair::sum(1.0, first);
        let larger = Pair { hi: larger.hi, lo: larger.lo + rest };
        let of_value = self.share.error + PAIR;
        // (1 + |z|)/2√τ over 1 + √τ is at most 1/2 for z < 0 and 1/√τ for z > 0.
        let error = of_value * (0.5 + 2.0 * half) + PAIR;
        match branch {
            Branch::Larger => (larger, error),
            Branch::Smaller => (z.over(arithmetic, larger, 1.0 / larger.hi), of_value + error + PAIR),
        }
    }
}

/// The cube root of a positive number far from the ends of the range.
#[inline(always)]
fn cube_root<A: Arithmetic>(arithmetic: A, x: Pair) -> Pair {
    // A third of the exponent, with the first bits of the significand.
    let leading = f64::from_bits(x.hi.to_bits() >> 32 | FROM_INTEGER.to_bits()) - FROM_INTEGER;
    let third = A::multiply_add(leading, -1.0 / 3.0, TO_INTEGER + f64::from(START));
    let start = f64::from_bits(third.to_bits() << 32);
    let defect = |y: f64| A::residual(1.0, x.hi * y, y * y);
    let t = defect(start);
    let series = A::multiply_add(A::multiply_add(t, 35.0 / 243.0, 14.0 / 81.0), t, 2.0 / 9.0);
    let inverse = A::multiply_add(start * t, A::multiply_add(series, t, 1.0 / 3.0), start);
    let t = defect(inverse);
    let inverse = A::multiply_add(inverse * t, A::multiply_add(t, 2.0 / 9.0, 1.0 / 3.0), inverse);
    let square = inverse * inverse;
    let root = x.hi * square;
    let cube = A::product(root, root).scaled(arithmetic, root);
    let rest = ((x.hi - cube.hi) - cube.lo + x.lo) * (square * (1.0 / 3.0));
    Pair::quick_sum(root, rest)
}

/// The leading 32 bits of the start of an inverse cube root of 1, less a third of those of 1; so |1 − xy³| < 0.12.
const START: u32 = 0x553E_F0FF;

#[cfg(test)]
#[path = "../../../tests/private/quadratic.rs"]
mod tests;
