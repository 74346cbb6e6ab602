//! An integral in strides, for integrands with many waves.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Result};
use mdr_core::number::Real;

/// ∫ from `lower` to `upper` by a rule of limited capacity: from the lower end in strides, the first of them the
/// narrowest, the interval over `most`. They are doubled until `integral(from, to)` does not converge, then halved, and
/// doubled again after one that took at most a quarter of the evaluations of the most expensive failure.
///
/// So nothing needs to be known of the waves, whose number in a stride the rule itself decides, and few evaluations are
/// spent on strides that are too wide. If the narrowest does not converge, the integral fails.
pub(crate) fn strides<R: Real>(
    lower: &R,
    upper: &R,
    most: i64,
    mut integral: impl FnMut(&R, &R) -> Result<Estimate<R>>,
) -> Result<Estimate<R>> {
    let narrowest = (upper.clone() - lower).over(most);
    let mut total = Estimate::exact(lower.lit(0));
    let (mut from, mut width, mut dearest) = (lower.clone(), narrowest.clone(), None);
    while from < *upper {
        let next = from.clone() + &width;
        let to = if next < *upper { next } else { upper.clone() };
        match integral(&from, &to) {
            Ok(stride) => {
                total += &stride;
                if dearest.is_none_or(|dearest| stride.evaluations.saturating_mul(4) <= dearest) {
                    width = width.times(2);
                }
                from = to;
            }
            Err(Error::NoConvergence { evaluations, .. }) if width > narrowest => {
                dearest = dearest.max(Some(evaluations));
                width = width.over(2);
            }
            Err(error) => return Err(error),
        }
    }
    Ok(total)
}
