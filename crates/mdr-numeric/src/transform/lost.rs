//! Radii next to the tip at which the terms of a profile cancel in doubles.

use mdr_core::contact::Profile;
use mdr_core::number::{Interval, Precision, Real};

use super::integrand::Integrand;

/// Radii are looked at that are this times powers of ten, as kinks are often at those themselves,
const BESIDE: f64 = 1.37;
/// and these powers.
const DECADES: std::ops::RangeInclusive<i32> = -24..=20;
/// The relative error of a double in which it is lost.
const LOST: f64 = 1e-8;
/// Bits of an enclosure that tells.
const SHARP: i64 = 40;
/// Magnitudes below which a double may be lost because it underflows.
const SMALL: f64 = 1e-280;

/// For each integrand of the [quadratures](super::Quadrature) the radius below which its doubles are lost to the rounding of terms that cancel,
/// such as those of (exp(r) + r) − (1 + 2r), by a profile over enclosures; 0 where none are.
///
/// ```
/// use mdr_core::contact::Expression;
/// use mdr_core::number::Precision;
/// use mdr_numeric::transform::lost_below;
/// let of = |text: &str| {
///     let (formula, none): (Expression, _) = (text.parse()?, Default::default());
///     Ok::<_, Box<dyn std::error::Error>>(lost_below(&formula.bind((), &none)?, &formula.bind(Precision::new(256), &none)?))
/// };
/// assert_eq!(of("r^2/2")?, [0.0; 4]);
/// let [height, rise, ..] = of("(exp(r) + r) - (1 + 2*r)")?;
/// assert!(height > 1e-5 && height < 1e-2 && rise > 1e-9 && rise < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lost_below(profile: &impl Profile<f64>, enclosed: &impl Profile<Interval>) -> [f64; 4] {
    Integrand::ALL.map(|integrand| below(integrand, profile, enclosed))
}

/// Bits of the enclosures.
const BITS: u32 = 256;

fn below(integrand: Integrand, profile: &impl Profile<f64>, enclosed: &impl Profile<Interval>) -> f64 {
    let precision = Precision::new(BITS);
    let mut lost = 0.0;
    for decade in DECADES {
        let r = BESIDE * 10f64.powi(decade);
        let known = integrand.at(enclosed, &Interval::from_int(precision, 1), &Interval::from_f64(precision, r));
        let is_known = known.is_finite() && !known.contains_zero() && known.accuracy_bits() >= SHARP;
        let known = known.approx();
        if !is_known || known.abs() < SMALL {
            continue;
        }
        let found = integrand.at(profile, &1.0, &r);
        if (found - known).abs() <= LOST * known.abs() {
            break;
        }
        lost = 10.0 * r;
    }
    lost
}
