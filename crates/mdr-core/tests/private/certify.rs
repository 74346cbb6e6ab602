//! What is private in `mdr_core::number::certify`.

use super::*;

/// The two roundings of an interval against that of a rational, also at ties and at both ends of a decade.
#[test]
fn an_interval_rounds_as_its_rational_does() {
    let texts = [
        (1, 8),
        (5, 4),
        (15, 4),
        (-25, 2),
        (999_999, 1),
        (9_999_995, 10),
        (1, 1 << 20),
        (7, 1),
        (1 << 30, 1),
        (-3, 64),
    ];
    for value in texts.map(Rational::from) {
        for shift in [-3000, -40, 0, 40, 3000] {
            let value = value.clone() << shift;
            for digits in 1..8 {
                let point = Interval::from_rational(Precision::new(40), &value);
                assert!(point.is_point());
                let exact = Some(round_rational(&value, digits));
                assert_eq!(round_interval(&point, digits), exact, "{value}, {digits} digits");
                // A power of ten below 1 is not a binary number, so a tie may stay undecided.
                let far = round_far(&point, digits);
                assert!(far.is_none() || far == exact, "{value}, {digits} digits: {far:?}");
            }
        }
    }
}

/// Every number of a wide interval rounds to the same decimal, or there is none.
#[test]
fn a_decimal_is_that_of_both_ends() {
    let interval = |lower: f64, upper: f64| Interval::new(Float::with_val(60, lower), Float::with_val(60, upper));
    let round = |lower, upper, digits| round_interval(&interval(lower, upper), digits).map(|d| d.to_string());
    assert_eq!(round(9.96, 9.99, 2).as_deref(), Some("10"));
    assert_eq!(round(9.96, 10.04, 2).as_deref(), Some("10"));
    assert_eq!(round(9.94, 9.96, 2), None);
    assert_eq!(round(0.996, 1.004, 3), None);
    assert_eq!(round(-2.4375, -2.4296875, 2).as_deref(), Some("-2.4"));
    assert_eq!(round(-1.0, 1.0, 2), None);
}
