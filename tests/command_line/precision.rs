//! Certified answers: every digit, at every number of digits.

use crate::decimal::{Decimal, significant_digits};
use crate::reference::{FOLDS, STATES};
use crate::{critical, text};

const QUANTITIES: [&str; 4] = ["kappa", "contact_radius", "indentation", "force"];

#[test]
fn fifty_digits_agree_with_mpmath() {
    for (flags, expected) in STATES {
        let answer = critical(&format!("{flags} --digits 50"));
        for (key, expected) in QUANTITIES.into_iter().zip(expected) {
            assert_eq!(Decimal::new(text(&answer, key)), Decimal::new(expected), "{key} of {flags}");
        }
    }
}

#[test]
fn folds_of_a_machine_agree_with_mpmath() {
    for (flags, expected) in FOLDS {
        let answer = critical(&format!("{flags} --digits 50"));
        let folds = answer["folds"].as_array().unwrap();
        assert_eq!(folds.len(), expected.len(), "{flags}");
        for (fold, [a, d, f, kind]) in folds.iter().zip(*expected) {
            for (key, expected) in QUANTITIES[1..].iter().zip([a, d, f]) {
                assert_eq!(Decimal::new(text(fold, key)), Decimal::new(expected), "{key} of {flags}");
            }
            assert_eq!((text(fold, "kind"), text(fold, "status")), (*kind, "ok"), "{flags}");
        }
    }
}

/// Fewer digits are the rounding of more, through one, two and fifteen to ten thousand.
fn agree(flags: &str, ladder: &[usize]) {
    let answers = ladder.iter().map(|digits| critical(&format!("{flags} --digits {digits}"))).collect::<Vec<_>>();
    let longest = answers.last().unwrap();
    for (digits, answer) in ladder.iter().zip(&answers) {
        assert_eq!(answer["digits"], *digits as u64);
        for key in QUANTITIES {
            let shown = text(answer, key);
            assert_eq!(Decimal::new(shown), Decimal::new(text(longest, key)).round(*digits), "{key}, {digits} digits");
            assert_eq!(significant_digits(shown), *digits, "{key} = {shown}");
        }
    }
}

#[test]
fn fewer_digits_are_the_rounding_of_more() {
    let ladder = [1, 2, 3, 7, 15, 16, 17, 20, 34, 50, 100, 200, 1000];
    agree("--n 0.25 --c 1 --e-star 1e9 --work 0.05", &ladder);
    agree("--n 0.6 --c 3 --e-star 7 --work 2 --control force", &ladder);
    agree("--n 0.5001 --c 3 --e-star 7 --work 2", &ladder);
    agree("--n 2.5 --c 1e3 --e1 1e6 --nu1 0.49 --e2 2.1e11 --nu2 0.3 --work 0.05", &ladder);
    agree("--n 0.7 --c 5 --e-star 3 --work 2 --control machine --stiffness 1", &[1, 2, 15, 50, 200, 1000]);
}

/// The last digits of many where n overflows the squares and fourth powers of doubles, by Arb with ln Γ at 12 000 bits.
#[test]
fn large_exponents_agree_with_arb() {
    let last = [
        ("1e80", 480, ["09451551144", "78846361802", "25915851237", "09323538289"]),
        ("1e154", 340, ["11528549494", "", "", ""]),
        ("1e300", 1000, ["02872445427", "93366988692", "53569665924", "24656289551"]),
        ("3e76", 400, ["02486769489", "69547328204", "36538367775", "71221596825"]),
    ];
    for (n, digits, expected) in last {
        let answer = critical(&format!("--n {n} --c 3 --e-star 1 --work 1 --digits {digits}"));
        for (key, expected) in QUANTITIES.into_iter().zip(expected) {
            let shown = text(&answer, key);
            let mantissa = shown.split('e').next().unwrap();
            assert!(mantissa.ends_with(expected), "{key}, n = {n}: {shown}");
        }
    }
}

/// 2698 to three digits is 2.70e+3 and not 2700: over ten decades no zero stands for a digit that is not proved.
#[test]
fn no_digit_is_shown_beyond_those_asked_for() {
    for decade in -2..8 {
        agree(&format!("--n 2 --c 3.7 --e-star 2.3 --work 1.1e{decade} --control force"), &[1, 2, 3, 4, 5, 9, 30]);
    }
    let answer = critical("--n 2 --c 0.5 --e-star 1 --work 572.6 --control force --digits 3");
    assert_eq!(text(&answer, "force"), "-2.70e+3");
}

#[test]
fn ten_thousand_digits() {
    agree("--n 1/3 --c 0.7 --e-star 3e8 --work 0.02", &[1, 2, 15, 50, 1000, 10_000]);
}

/// κ₂ = 2, and d of the cone under fixed grips is −w/(E* tanθ): rational, with ties at some numbers of digits.
#[test]
fn exact_values_are_decided() {
    for digits in [1, 2, 3, 15, 50, 1000] {
        let paraboloid = critical(&format!("--n 2 --c 50 --e-star 1e6 --work 0.05 --digits {digits}"));
        assert_eq!(Decimal::new(text(&paraboloid, "kappa")), Decimal::new("2"));
        // −1/8 is a tie at one and two digits: to the even digit.
        let cone = critical(&format!("--n 1 --c 2 --e-star 4 --work 1 --digits {digits}"));
        let expected = match digits {
            1 => "-0.1",
            2 => "-0.12",
            _ => "-0.125",
        };
        assert_eq!(Decimal::new(text(&cone, "indentation")), Decimal::new(expected), "{digits} digits");
    }
    let cone = critical("--n 1 --c 2 --e-star 4 --work 1 --control force --digits 2");
    assert_eq!(text(&cone, "indentation"), "0.38", "3w/(E* tanθ) = 0.375, a tie");
}

/// Under a dead load the critical depth at n = 3/2 is zero, whatever the arithmetic.
#[test]
fn exact_zero() {
    for n in ["1.5", "3/2", "15e-1", "6/4"] {
        for digits in [1, 50, 1000] {
            let answer =
                critical(&format!("--n {n} --c 12 --e-star 2e6 --work 0.07 --control force --digits {digits}"));
            assert_eq!(text(&answer, "indentation"), "0");
            assert_eq!(answer["status"], "ok");
        }
    }
}

#[test]
fn results_far_beyond_the_range_of_hardware() {
    // 1/(2n−1) = 5000: the three scales of a length, its square root and a force.
    let answer = critical("--n 0.5001 --c 3 --e-star 7 --work 2 --digits 5");
    assert_eq!(text(&answer, "contact_radius"), "1.4772e-4678");
    assert_eq!(text(&answer, "indentation"), "-3.2562e-2343");
    assert_eq!(text(&answer, "force"), "-2.2452e-7016");
    assert_eq!(answer["status"], "ok");
    // 1/(2n−1) = 5·10¹⁰: beyond the exponents of MPFR.
    let answer = critical("--n 0.50000000001 --c 3 --e-star 7 --work 2 --digits 5");
    let exponent: i64 = text(&answer, "contact_radius").split_once('e').unwrap().1.parse().unwrap();
    assert!((-60_000_000_000..-40_000_000_000).contains(&exponent), "{answer}");
}
