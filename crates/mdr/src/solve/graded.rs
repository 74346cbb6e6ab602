//! Functions of the exponents of a profile and a graded medium, which involve the Gamma function.

#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::{Dual, Gamma, Special};
use mdr_numeric::transform::graded_kappa;

/// An arithmetic with the functions of the exponents of a profile and of a graded medium that involve the Gamma function. Over dual
/// numbers k is a constant, and over those of enclosures n as well.
///
/// ```
/// use mdr::contact::GradedReal;
/// assert_eq!(f64::kappa_of_grade(&2.0, &0.0), 2.0); // the half-space: g = x²/R of x²/2R
/// ```
pub trait GradedReal: Special {
    /// κ(n, k) = Γ(1 + n/2)Γ((1 + k)/2)/Γ((n + 1 + k)/2), the factor between C rⁿ and its transform on a medium graded as zᵏ.
    fn kappa_of_grade(n: &Self, k: &Self) -> Self;

    /// h_N(k, ν): the coefficient of one graded body is c = h_N E/((1 − ν²)z₀ᵏ).
    fn factor_of_grade(k: &Self, nu: &Self) -> Self;
}

/// h_N(k, ν) = 2(1 + k) cos(kπ/2) Γ(1 + k/2)/(√π C β sin(βπ/2) Γ((1 + k)/2)), where β² = (1 + k)(1 − kν/(1 − ν)) and
/// C = 2^(1+k) Γ((3 + k + β)/2) Γ((3 + k − β)/2)/(π Γ(2 + k)): c of one graded body is h_N E/((1 − ν²)z₀ᵏ) (A. E. Giannakopoulos
/// and S. Suresh, Int. J. Solids Struct. 34 (1997) 2357).
fn factor_of_grade<R: Gamma + Special>(k: &R, nu: &R) -> R {
    let one = k.lit(1);
    let order = one.clone() + k;
    let beta = (order.clone() * (one.clone() - k.clone() * nu / (one.clone() - nu))).sqrt();
    let half_of_pi = k.pi().over(2);
    let ends = [k.lit(3) + k + &beta, k.lit(3) + k - &beta].map(|end| end.over(2).gamma());
    let [first, second] = ends;
    let c = k.lit(2).pow(&order) * first * second / (k.pi() * (k.lit(2) + k).gamma());
    let top = order.clone().times(2) * (half_of_pi.clone() * k).cos() * (one + k.clone().over(2)).gamma();
    top / (k.pi().sqrt() * c * &beta * (half_of_pi * &beta).sin() * order.over(2).gamma())
}

/// By an enclosure of 160 bits, which leaves the rounding alone.
#[cfg(feature = "mp")]
impl GradedReal for f64 {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        use mdr_core::number::Real;
        let [n, k] = [n, k].map(|x| enclosed(*x));
        graded_kappa(&n, &k).approx()
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        use mdr_core::number::Real;
        let [k, nu] = [k, nu].map(|x| enclosed(*x));
        factor_of_grade(&k, &nu).approx()
    }
}

#[cfg(feature = "mp")]
fn enclosed(x: f64) -> Interval {
    use mdr_core::number::Real;
    Interval::from_f64(mdr_core::number::Precision::new(160), x)
}

#[cfg(not(feature = "mp"))]
impl GradedReal for f64 {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        graded_kappa(n, k)
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        factor_of_grade(k, nu)
    }
}

/// With thirty-two guard bits.
#[cfg(feature = "mp")]
impl GradedReal for rug::Float {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        let [wide_n, wide_k] = [n, k].map(|x| rug::Float::with_val(n.prec() + 32, x));
        rug::Float::with_val(n.prec(), graded_kappa(&wide_n, &wide_k))
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        let [wide_k, wide_nu] = [k, nu].map(|x| rug::Float::with_val(k.prec() + 32, x));
        rug::Float::with_val(k.prec(), factor_of_grade(&wide_k, &wide_nu))
    }
}

#[cfg(feature = "mp")]
impl GradedReal for Interval {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        graded_kappa(n, k)
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        factor_of_grade(k, nu)
    }
}

#[cfg(feature = "mp")]
impl GradedReal for Dual<Interval> {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        Dual::constant(Interval::kappa_of_grade(&n.value, &k.value))
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        Dual::constant(Interval::factor_of_grade(&k.value, &nu.value))
    }
}

#[cfg(feature = "mp")]
impl GradedReal for Dual<Dual<Interval>> {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        Dual::constant(Dual::kappa_of_grade(&n.value, &k.value))
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        Dual::constant(Dual::factor_of_grade(&k.value, &nu.value))
    }
}

/// With the slope of n, κ'/κ = ½ψ(1 + n/2) − ½ψ((n + 1 + k)/2).
impl GradedReal for Dual<f64> {
    fn kappa_of_grade(n: &Self, k: &Self) -> Self {
        let value = f64::kappa_of_grade(&n.value, &k.value);
        let [top, bottom] = [1.0 + n.value / 2.0, (n.value + 1.0 + k.value) / 2.0].map(|x| Gamma::digamma(&x));
        n.clone().chain(value, value * (top - bottom) / 2.0)
    }

    fn factor_of_grade(k: &Self, nu: &Self) -> Self {
        Dual::constant(f64::factor_of_grade(&k.value, &nu.value))
    }
}
