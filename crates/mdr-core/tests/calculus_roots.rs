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
        // Near the root x − sin x is rounded to 2⁻⁵³ with slope 1.36: the sign may turn one ulp (2⁻⁵²) from the root.
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
