//! The results that are rational, decided by number theory (see the [module page](super)).

use mdr_core::contact::Control;
use mdr_core::number::{Interval, Precision};
use rug::Rational;

use super::Question;
use crate::kappa::kappa_enclosure;

/// For even n up to this, κ_n is computed as a fraction; beyond it the fraction is long and not a decimal tie.
const LARGEST_EVEN: u32 = 64;

/// κ_n for a small even n: Π 2j/(2j−1), j = 1 to n/2.
pub(super) fn kappa(n: &Rational) -> Option<Rational> {
    if !n.is_integer() || *n > LARGEST_EVEN || n.numer().is_odd() {
        return None;
    }
    let even = n.numer().to_u32()?;
    Some((2..=even).step_by(2).fold(Rational::from(1), |product, j| product * Rational::from((j, j - 1))))
}

/// An enclosure of κ_n.
pub(super) fn kappa_interval(precision: Precision, n: &Rational) -> Interval {
    match kappa(n) {
        Some(exact) => Interval::from_rational(precision, &exact),
        None => kappa_enclosure(precision, n),
    }
}

/// The critical d under controlled indentation or force where it is rational: the cone, and n = 3/2 under a dead load.
pub(super) fn indentation<S>(question: &Question, control: &Control<S>) -> Option<Rational> {
    let length = || Rational::from(&question.work_of_adhesion / &question.effective_modulus) / &question.coefficient;
    let cone = question.exponent == 1;
    match control {
        Control::Indentation if cone => Some(-length()),
        Control::Force if cone => Some(length() * 3),
        Control::Force if question.exponent == 1.5 => Some(Rational::new()),
        _ => None,
    }
}
