//! Derivatives of ln κ_n: ½(ψ(1+n/2) − ψ((n+1)/2)) = Σ_j (−1)ʲ/(n+1+j), and its derivatives term by term.
//!
//! 1/(z+j)ᵏ = ∫₀¹ tʲ dμ(t) with a positive measure, so the acceleration of Cohen, Rodriguez Villegas and Zagier
//! (Experimental Mathematics 9, 2000) applies with its bound: N terms leave at most 1/T_N(3) of the sum, where T_N(3) ≥
//! (3+√8)^N/2 is a Chebyshev polynomial: 2.54 bits per term for every n.

use mdr_core::number::Real;

/// (−1)^{k−1} (k−1)! Σ_j (−1)ʲ/(n+1+j)ᵏ for the order k ≥ 1.
pub(super) fn ln_kappa_derivative<R: Real>(n: &R, order: u32) -> R {
    let power = i64::from(order);
    // log₂(3+√8) > 5/2.
    let terms = (n.precision() + 3) * 2 / 5 + 1;
    let sum = alternating_sum(n, i64::from(terms), |j| (n.lit(j + 1) + n).powi(-power));
    let factorial = (1..power).fold(sum, R::times);
    if order.is_multiple_of(2) { -factorial } else { factorial }
}

/// Σ_j (−1)ʲ a_j for a totally monotone sequence a, in the precision of `like`.
pub(super) fn alternating_sum<R: Real>(like: &R, terms: i64, sequence: impl Fn(i64) -> R) -> R {
    let total = chebyshev_at_three(like, terms);
    let mut binomial = like.lit(-1);
    let mut weight = -total.clone();
    let mut sum = like.lit(0);
    for j in 0..terms {
        weight = binomial.clone() - &weight;
        sum += &(sequence(j) * &weight);
        binomial = binomial.times(2 * (j + terms) * (j - terms)).over((2 * j + 1) * (j + 1));
    }
    (sum / &total).inflate(&(sequence(0) / &total))
}

/// T_N(3), by T_{N+1} = 6 T_N − T_{N−1}.
fn chebyshev_at_three<R: Real>(like: &R, degree: i64) -> R {
    let (mut current, mut next) = (like.lit(1), like.lit(3));
    for _ in 0..degree {
        let following = next.clone().times(6) - &current;
        (current, next) = (next, following);
    }
    current
}
