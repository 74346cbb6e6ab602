//! The truth, from a series of positive terms that no contestant sums.

use mdr_core::number::{Interval, Precision, Real};

/// Bits beyond those that are wanted: each of the terms is a few roundings wide.
const GUARD: u32 = 64;

/// κ_n = Σ_k Π_{j<k} (n+j)/(n+2+2j) for 0 < n ≤ 2, Gauss's second theorem (DLMF 15.4.28). A term is then at most half the
/// one before, so that all that follow the last are together no larger.
fn positive_series(one: Interval, next: impl Fn(Interval, i64) -> Interval) -> Interval {
    let least = one.unit_roundoff();
    let (mut sum, mut term) = (one.clone(), one);
    for j in 0.. {
        term = next(term, j);
        sum += &term;
        if term < least {
            break;
        }
    }
    sum.inflate(&term)
}

/// κ_{p/q} for 0 < p ≤ 2q.
pub(super) fn kappa_of_fraction(precision: Precision, p: i64, q: i64) -> Interval {
    let one = Interval::from_int(Precision::new(precision.bits() + GUARD), 1);
    positive_series(one, |term, j| term.times(p + j * q).over(p + (2 + 2 * j) * q))
}

/// κ_n for an enclosure of n in (0, 2).
pub(in super::super) fn kappa_of(n: &Interval) -> Interval {
    positive_series(n.lit(1), |term, j| term * (n.lit(j) + n) / (n.lit(2 + 2 * j) + n))
}

/// κ, a, d, F of the power law f = C rⁿ at its fold under fixed grips, for C, E* and w: a from the tangency (1.14) in
/// logarithms, d and F from (1.13) and (1.16) there, where the contestants have (1.15) and (1.17).
pub(in super::super) fn critical(n: &Interval, kappa: Interval, [c, e, w]: [Interval; 3]) -> Vec<Interval> {
    // ln g' = ln Δl' is (n − 1/2) ln a = ½ ln(πw/2E*) − ln(nκC).
    let tension = (w.pi() * &w / &e).over(2).ln().over(2);
    let stiffness = n.ln() + kappa.ln() + c.ln();
    let ln_a = (tension - stiffness) / (n.clone() - n.ratio(1, 2));
    let a = ln_a.exp();
    let g = (ln_a * n).exp() * &c * &kappa;
    let elongation = (a.pi().times(2) * &a * &w / &e).sqrt();
    let d = g.clone() - &elongation;
    let f = (g * n / (n.lit(1) + n) - elongation) * &a * &e.times(2);
    vec![kappa, a, d, f]
}
