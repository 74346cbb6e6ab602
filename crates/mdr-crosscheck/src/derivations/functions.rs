//! Functions outside the algebra, enclosed.

use mdr_analytic::struve::Struve;
use mdr_core::number::{Gamma, Interval, Real, Special};
use mdr_symbolic::formula::Function;

/// The value of a function; the entire line outside its domain.
pub(super) fn value(function: Function, arguments: &[Interval]) -> Interval {
    let unknown = |like: &Interval| Interval::entire(like.ctx());
    match (function, arguments) {
        (Function::Gamma, [z]) => gamma(z),
        (Function::Kappa, [n]) => kappa(n),
        (Function::Agm, [x, y]) => arithmetic_geometric_mean(x, y),
        (Function::Sine, [z]) => z.sin(),
        (Function::StruveH0, [z]) if *z >= z.lit(0) => z.struve_h0(),
        (Function::Hypergeometric, [b, c]) => hypergeometric(b, c),
        (_, [first, ..]) => unknown(first),
        (_, []) => unknown(&Interval::from_int(mdr_core::number::Precision::new(super::BITS), 0)),
    }
}

/// Steps of Γ(z + 1) = zΓ(z) that are taken to the left of 0.
const LARGEST_SHIFT: u32 = 2000;

/// Γ(z), to the left of 0 by Γ(z) = Γ(z + 1)/z; the entire line beside a pole, or too far left.
pub(super) fn gamma(z: &Interval) -> Interval {
    let (mut right, mut product) = (z.clone(), z.lit(1));
    let steps = if z.is_finite() { LARGEST_SHIFT } else { 0 };
    for _ in 0..=steps {
        if right > right.lit(0) {
            return right.gamma() / product;
        }
        product *= &right;
        right += &z.lit(1);
    }
    Interval::entire(z.ctx())
}

/// κ_n = (√π/2) n Γ(n/2)/Γ((n+1)/2), as printed in (1.12), also where n is negative.
pub(super) fn kappa(n: &Interval) -> Interval {
    let upper = (n.clone() + n.lit(1)).over(2);
    n.pi().sqrt().over(2) * n * gamma(&n.clone().over(2)) / gamma(&upper)
}

/// agm(x, y) for positive arguments: it lies between the means of every step.
fn arithmetic_geometric_mean(x: &Interval, y: &Interval) -> Interval {
    let (mut arithmetic, mut geometric) = (x.clone(), y.clone());
    // The difference of the means is squared in each step.
    for _ in 0..super::BITS.ilog2() + 4 {
        let mean = (arithmetic.clone() + &geometric).over(2);
        geometric = (arithmetic * &geometric).sqrt();
        arithmetic = mean;
    }
    arithmetic.hull(&geometric)
}

/// ₂F₁(1, b; c; 1/2) = Σ Π (b+j)/(2(c+j)), for b, c > 0.
///
/// The ratio of the terms tends to 1/2 monotonically. So from a term on, of which it is below one, the tail is at most that
/// of a geometric series with the larger of the ratio there and 1/2.
pub(crate) fn hypergeometric(b: &Interval, c: &Interval) -> Interval {
    let zero = b.lit(0);
    let mut sum = b.lit(0);
    if !(*b > zero && *c > zero) {
        return Interval::entire(b.ctx());
    }
    let mut term = b.lit(1);
    for j in 0..20 * i64::from(b.precision()) {
        sum += &term;
        let ratio = (b.clone() + b.lit(j)) / (c.clone() + b.lit(j)).times(2);
        term *= &ratio;
        let bound = ratio.hull(&b.ratio(1, 2));
        if bound < b.lit(1) && term < sum.clone() * b.unit_roundoff() {
            return sum.inflate(&(term / (b.lit(1) - &bound)));
        }
    }
    Interval::entire(b.ctx())
}
