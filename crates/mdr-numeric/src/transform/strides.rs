//! An integral in strides, for integrands with many waves.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Result};
use mdr_core::number::Real;

/// ∫ from `lower` to `upper` by a rule that can only do so much at once: from the lower end in strides, halved where
/// `integral(from, to)` does not converge and doubled after one that took a quarter of the evaluations of the dearest.
///
/// So nothing has to be known of the waves, whose number in a stride the rule itself decides; what is spent on strides
/// that were too wide is paid once, at the beginning. When the narrowest, the interval over `most`, does not converge,
/// there is no use in going on.
pub(super) fn strides<R: Real>(
    lower: &R,
    upper: &R,
    most: i64,
    mut integral: impl FnMut(&R, &R) -> Result<Estimate<R>>,
) -> Result<Estimate<R>> {
    let whole = upper.clone() - lower;
    let narrowest = whole.clone().over(most);
    let mut total = Estimate { value: lower.lit(0), error: lower.lit(0), evaluations: 0 };
    let (mut from, mut width, mut dearest) = (lower.clone(), whole, 0);
    while from < *upper {
        let next = from.clone() + &width;
        let to = if next < *upper { next } else { upper.clone() };
        match integral(&from, &to) {
            Ok(stride) => {
                total.value += &stride.value;
                total.error += &stride.error;
                total.evaluations += stride.evaluations;
                dearest = dearest.max(stride.evaluations);
                if stride.evaluations.saturating_mul(4) <= dearest {
                    width = width.times(2);
                }
                from = to;
            }
            Err(Error::NoConvergence { evaluations, .. }) if width > narrowest => {
                total.evaluations += evaluations;
                dearest = dearest.max(evaluations);
                width = width.over(2);
            }
            Err(error) => return Err(error),
        }
    }
    Ok(total)
}
