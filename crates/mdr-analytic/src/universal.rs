//! The one-parameter family behind all power laws: lengths in units of a_c, indentation of |d_c|, force of |F_c|.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

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
/// [`Error::Domain`] unless n > 0, n ≠ 1/2 and ã > 0 are finite.
pub fn universal_indentation<R: Real>(n: &R, scaled_radius: &R) -> Result<R> {
    let excess = checked(n, scaled_radius)?;
    let growth = scaled_radius.pow_m1(&excess.clone().over(2));
    Ok((growth - &excess) * scaled_radius.sqrt() / excess.abs())
}

/// F/|F_c| = (ãⁿ⁺¹ − 2(n+1)ã^{3/2})/(2n+1) along the equilibria, with ã = a/a_c of controlled indentation; −1 at ã = 1.
///
/// # Errors
/// As [`universal_indentation`].
pub fn universal_force<R: Real>(n: &R, scaled_radius: &R) -> Result<R> {
    let excess = checked(n, scaled_radius)?;
    let growth = scaled_radius.pow(&excess.clone().over(2));
    let next = n.lit(1) + n;
    Ok((growth - next.times(2)) * scaled_radius.sqrt() * scaled_radius / (excess + n.lit(2)))
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
