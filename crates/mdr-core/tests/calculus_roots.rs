//! Brackets and roots: exact cases, the ends of the exponent range, and independence of the unit of length.

use mdr_core::calculus::roots::{Bracket, bisect, bracket_geometric, refine, refine_with_slope};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Error, Result};

/// Kepler's equation x − sin x = m at m = 1; the root from Newton's iteration at 60 digits (mpmath).
const KEPLER: f64 = 1.934_563_210_752_024_2;

fn kepler(x: &f64) -> Result<f64> {
    Ok(x - x.sin() - 1.0)
}

#[test]
fn brackets_over_the_whole_range() {
    for exponent in [-290, -200, -100, -1, 0, 1, 100, 200, 290] {
        let target = 3.0 * 10f64.powi(exponent);
        let bracket = bracket_geometric(&1.0, |x| Ok(x - target)).unwrap().unwrap();
        assert!(bracket.lower.x < target && target < bracket.upper.x);
        assert!(bracket.evaluations <= 30, "1e{exponent}: {}", bracket.evaluations);
    }
}

#[test]
fn no_sign_change_is_told_after_the_whole_range() {
    let mut extremes = (f64::MAX, 0.0f64);
    let mut evaluations = 0;
    let found = bracket_geometric(&1.0, |&x| {
        extremes = (extremes.0.min(x), extremes.1.max(x));
        evaluations += 1;
        Ok(1.0)
    });
    assert!(found.unwrap().is_none());
    assert!(extremes.0 < 1e-305 && extremes.1 > 1e305, "{extremes:?}");
    assert!(evaluations < 50, "{evaluations}");
}

#[test]
fn refines_to_adjacent_numbers() {
    let bracket = Bracket::new(&1.0, &3.0, kepler).unwrap().unwrap();
    for root in [bisect(bracket.clone(), &0.0, kepler).unwrap(), refine(bracket, &0.0, kepler).unwrap()] {
        // Near the root x − sin x is rounded to 2⁻⁵³ with slope 1.36: the sign may change one ulp (2⁻⁵²) from the root.
        assert!((root.value - KEPLER).abs() <= 2.0 * f64::EPSILON, "{root:?}");
        assert!(root.upper - root.lower <= 2.0 * f64::EPSILON * root.value, "{root:?}");
    }
}

#[test]
fn superlinear_in_evaluations() {
    let bracket = Bracket::new(&1.0, &3.0, kepler).unwrap().unwrap();
    let tolerance = roundoff_tolerance(&1.0);
    let bisected = bisect(bracket.clone(), &tolerance, kepler).unwrap();
    let refined = refine(bracket.clone(), &tolerance, kepler).unwrap();
    let newton = refine_with_slope(bracket, &tolerance, |x| Ok((kepler(x)?, 1.0 - x.cos()))).unwrap();
    assert!(bisected.evaluations > 45 && refined.evaluations < 14 && newton.evaluations < 14);
    assert!((newton.value / KEPLER - 1.0).abs() <= 2e-15 && (refined.value / KEPLER - 1.0).abs() <= 2e-15);
}

#[test]
fn exact_zero_ends_the_search() {
    let bracket = bracket_geometric(&1.0, |x| Ok(x - 4.0)).unwrap().unwrap();
    let root = refine(bracket, &0.0, |x| Ok(x - 4.0)).unwrap();
    assert_eq!((root.value, root.lower, root.upper), (4.0, 4.0, 4.0));
    let at_guess = bracket_geometric(&4.0, |x| Ok(x - 4.0)).unwrap().unwrap();
    assert_eq!((at_guess.lower.x, at_guess.upper.x, at_guess.evaluations), (4.0, 4.0, 1));
}

#[test]
fn errors_name_what_is_wrong() {
    assert!(matches!(bracket_geometric(&-1.0, |x| Ok(*x)), Err(Error::Domain { .. })));
    assert!(matches!(bracket_geometric(&1.0, |_| Ok(f64::NAN)), Err(Error::Domain { .. })));
}

/// Zeros of high order are slow for interpolation; the refinement then switches to halving.
#[test]
fn flat_zeros_end_in_bounded_time() {
    for order in [3, 9, 21] {
        let f = |x: &f64| Ok((x - 1.1).powi(order));
        let bracket = Bracket::new(&0.3, &17.0, f).unwrap().unwrap();
        let root = refine(bracket, &roundoff_tolerance(&1.0), f).unwrap();
        // |x − 1.1|^order underflows to an exact zero within 1e-15 of 1.1 only for the steepest.
        assert!((root.value - 1.1).abs() < 1e-13, "{root:?}");
        assert!(root.evaluations < 200, "order {order}: {}", root.evaluations);
        // Newton's iteration alone gains a factor 1 − 1/order a step: 690 steps for the steepest.
        let with_slope = |x: &f64| Ok((f(x)?, f64::from(order) * (x - 1.1).powi(order - 1)));
        let bracket = Bracket::new(&1.0, &1.7, f).unwrap().unwrap();
        let root = refine_with_slope(bracket, &roundoff_tolerance(&1.0), with_slope).unwrap();
        assert!((root.value - 1.1).abs() < 1e-13 && root.evaluations < 200, "order {order}: {}", root.evaluations);
    }
}

/// Across zero there is no logarithm; the tolerance refers to the bracket.
#[test]
fn brackets_across_zero() {
    let f = |x: &f64| Ok(x.tanh() - 1e-3);
    let bracket = Bracket::new(&-2.0, &3.0, f).unwrap().unwrap();
    let root = refine(bracket, &1e-12, f).unwrap();
    assert!((root.value - 1e-3f64.atanh()).abs() <= 3e-12, "{root:?}");
}

#[cfg(feature = "mp")]
mod arbitrary_precision {
    use super::*;
    use mdr_core::calculus::verify::verify;
    use mdr_core::number::{Interval, Precision, Real};
    use rug::Float;

    /// The cube root of two at 1000 digits: superlinear means a few more evaluations than at 50.
    #[test]
    fn evaluations_grow_like_the_logarithm_of_the_digits() {
        let mut spent = Vec::new();
        for digits in [50, 1000] {
            let one = Float::with_val(Precision::from_digits(digits).bits(), 1);
            let f = |x: &Float| Ok(x.clone().square() * x - 2u32);
            let bracket = bracket_geometric(&one, f).unwrap().unwrap();
            let tolerance = roundoff_tolerance(&one);
            let root = refine(bracket.clone(), &tolerance, f).unwrap();
            let truth = Float::with_val(one.prec(), 2).cbrt();
            let error = Float::with_val(53, (root.value.clone() - &truth) / &truth).abs();
            assert!(error <= tolerance && root.lower <= truth && truth <= root.upper);
            let newton = refine_with_slope(bracket, &tolerance, |x| Ok((f(x)?, x.clone().square() * 3u32))).unwrap();
            spent.push((root.evaluations, newton.evaluations));
        }
        assert!(spent[0].0 <= 16 && spent[1].0 <= spent[0].0 + 8, "{spent:?}");
        assert!(spent[0].1 <= 14 && spent[1].1 <= spent[0].1 + 8, "{spent:?}");
    }

    #[test]
    fn brackets_at_the_ends_of_the_exponent_range() {
        let one = Float::with_val(64, 1);
        for exponent in [-900_000_000i64, 900_000_000] {
            let target = Float::with_val(64, 2).powi(exponent);
            let bracket = bracket_geometric(&one, |x| Ok(x.clone() - &target)).unwrap().unwrap();
            assert!(bracket.lower.x <= target && target <= bracket.upper.x && bracket.evaluations < 130);
        }
    }

    /// In interval arithmetic the bracket is certain, and as tight as rounding allows.
    #[test]
    fn certain_brackets() {
        let ctx = Precision::new(120);
        let f = |x: &Interval| Ok(x.exp() - x.lit(3));
        let bracket = bracket_geometric(&Interval::from_int(ctx, 1), f).unwrap().unwrap();
        let root = refine(bracket, &roundoff_tolerance(&Interval::from_int(ctx, 1)), f).unwrap();
        let truth = Float::with_val(200, 3).ln();
        assert!(*root.lower.lower() < truth && truth < *root.upper.upper());
        let width = Float::with_val(53, root.upper.lower() - root.lower.upper());
        assert!(width < Float::with_val(53, 1) >> 110, "{width:e}");
    }

    #[test]
    fn interval_newton_proves_simple_zeros_only() {
        let ctx = Precision::new(120);
        let candidate = Float::with_val(120, 3).ln() * 1.000_001;
        let proof = verify(&candidate, |x| Ok(x.exp() - x.lit(3)), |x| Ok(x.exp())).unwrap().unwrap();
        assert!(proof.contains(&Float::with_val(120, 3).ln()) && proof.accuracy_bits() >= 114, "{proof:?}");
        // An exact zero is a point.
        let exact = verify(&Float::with_val(120, 1.01), |x| Ok(x.clone() - x.lit(1)), |x| Ok(x.lit(1))).unwrap();
        assert!(exact.unwrap().is_point());
        // A slope of one sign, but a zero too far away: the image must not pass as a proof.
        let far = verify(&Float::with_val(120, 30), |x| Ok(x.exp() - x.lit(3)), |x| Ok(x.exp())).unwrap();
        assert_eq!(far, None);
        // A double zero, no zero at all, and a candidate too far away.
        let double = |x: &Interval| Ok((x.clone() - x.lit(1)).square());
        let slope = |x: &Interval| Ok((x.clone() - x.lit(1)).times(2));
        assert_eq!(verify(&Float::with_val(120, 1.000_01), double, slope).unwrap(), None);
        let none = |x: &Interval| Ok(x.square() + x.lit(1));
        assert_eq!(verify(&Float::with_val(ctx.bits(), 1), none, |x| Ok(x.clone().times(2))).unwrap(), None);
    }
}
