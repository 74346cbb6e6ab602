//! The one-parameter family behind all power laws: lengths in units of a_c, indentation of |d_c|, force of |F_c|.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

use crate::range::{balanced, ordinary, product, representable};

/// d/|d_c| = (ãⁿ − 2nã^{1/2})/|1−2n| along the equilibria, with ã = a/a_c of controlled indentation.
///
/// Evaluated as √ã ((ã^{n−1/2} − 1) − (2n−1))/|2n−1|, so that n → 1/2 costs no digits. −1 at ã = 1 for n > 1/2, +1
/// for n < 1/2.
///
/// ```
/// use mdr_analytic::universal_indentation;
/// assert_eq!(universal_indentation(&2.0, &1.0)?, -1.0);
/// assert_eq!(universal_indentation(&0.25, &1.0)?, 1.0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n > 0, n ≠ 1/2 and ã > 0 are finite; [`Error::OutOfRange`].
pub fn universal_indentation<R: Real>(n: &R, scaled_radius: &R) -> Result<R> {
    let excess = checked(n, scaled_radius)?;
    let growth = scaled_radius.pow_m1(&excess.clone().over(2));
    let beyond = growth.clone() - &excess;
    let size = Size { quantity: Quantity::Indentation, divisor: excess.abs(), leading: n };
    size.quotient(&growth, beyond, scaled_radius, [scaled_radius.sqrt()])
}

/// F/|F_c| = (ãⁿ⁺¹ − 2(n+1)ã^{3/2})/(2n+1) along the equilibria, with ã = a/a_c of controlled indentation; −1 at ã = 1.
///
/// # Errors
/// [`Error::Domain`] unless n > 0, n ≠ 1/2 and ã > 0 are finite; [`Error::OutOfRange`].
pub fn universal_force<R: Real>(n: &R, scaled_radius: &R) -> Result<R> {
    let excess = checked(n, scaled_radius)?;
    let growth = scaled_radius.pow(&excess.clone().over(2));
    let next = n.lit(1) + n;
    let beyond = growth.clone() - next.clone().times(2);
    let size = Size { quantity: Quantity::Force, divisor: excess + n.lit(2), leading: &next };
    size.quotient(&growth, beyond, scaled_radius, [scaled_radius.sqrt(), scaled_radius.clone()])
}

/// The common factor of both: (growth − …) · factors / divisor, which tends to ã^leading / divisor for large ã.
struct Size<'a, R> {
    quantity: Quantity,
    divisor: R,
    leading: &'a R,
}

impl<R: Real> Size<'_, R> {
    /// `beyond` · factors / divisor, where `beyond`, the growth minus its value at zero load or indentation, may be 0.
    fn quotient<const N: usize>(&self, growth: &R, beyond: R, scaled_radius: &R, factors: [R; N]) -> Result<R> {
        if beyond == beyond.lit(0) {
            return Ok(beyond);
        }
        let plain = factors.iter().fold(beyond.clone(), |product, factor| product * factor);
        if ordinary(&plain) {
            return representable(self.quantity, plain / &self.divisor, || self.ln(&beyond, &factors));
        }
        if growth.is_finite() {
            let inverse = self.divisor.clone().inv();
            let every: Vec<&R> = factors.iter().chain([&beyond, &inverse]).collect();
            return representable(self.quantity, balanced(every), || self.ln(&beyond, &factors));
        }
        let half = scaled_radius.pow(&self.leading.clone().over(2));
        let ln = || scaled_radius.ln() * self.leading - self.divisor.ln();
        representable(self.quantity, product([&half, &half, &self.divisor.clone().inv()]), ln)
    }

    fn ln(&self, beyond: &R, factors: &[R]) -> R {
        factors.iter().fold(beyond.abs().ln() - self.divisor.ln(), |sum, factor| sum + factor.ln())
    }
}

/// 2n − 1 for arguments in the domain.
fn checked<R: Real>(n: &R, scaled_radius: &R) -> Result<R> {
    let n = Error::require_positive(Quantity::Exponent, n.clone())?;
    Error::require_positive(Quantity::ContactRadius, scaled_radius.clone())?;
    if n == n.ratio(1, 2) {
        return Err(Error::domain(Quantity::Exponent, &n, "other than 1/2, where there is no critical radius"));
    }
    Ok(n.clone().times(2) - n.lit(1))
}
