//! κ_n against closed forms, its functional equation, and Γ of MPFR.

use mdr_analytic::Kappa;
use mdr_core::number::{Dual, Real};

/// n from 10⁻³⁰⁰ to 10³⁰⁰, dense where the expansion changes.
fn exponents() -> impl Iterator<Item = f64> {
    let decades = (-300..=300).step_by(25).map(|e| 10f64.powi(e));
    let dense = (1..400).map(|k| f64::from(k) * 0.25);
    decades.chain(dense)
}

#[test]
fn known_values() {
    use std::f64::consts::PI;
    // 0.51 ulp of κ_n, two roundings in the longest of the values, and one of their ratio.
    for (n, value) in [
        (0.5, 1.3110287771460599),
        (1.0, PI / 2.0),
        (2.0, 2.0),
        (3.0, 3.0 * PI / 4.0),
        (4.0, 8.0 / 3.0),
        (6.0, 3.2),
        (1e-300, 1.0),
        (1e300, (PI * 1e300 / 2.0).sqrt()),
    ] {
        let relative = (f64::kappa(&n) / value - 1.0).abs();
        assert!(relative <= 2.1 * f64::EPSILON, "n = {n}: {relative:e}");
    }
}

#[test]
fn neighbours_multiply_to_a_multiple_of_pi() {
    // κ_n κ_{n+1} = π(n+1)/2; 10 ulp for two values and the product.
    for n in exponents().filter(|n| *n > 1e-3 && *n < 1e15) {
        let product = f64::kappa(&n) * f64::kappa(&(n + 1.0)) / (n.pi() * (n + 1.0) / 2.0);
        assert!((product - 1.0).abs() < 10.0 * f64::EPSILON, "n = {n}: {product}");
    }
}

#[test]
fn derivative_agrees_with_a_difference() {
    for n in exponents().filter(|n| (0.1..1e3).contains(n)) {
        let dual = Dual::kappa(&Dual::variable(Dual::variable(n)));
        // Central differences of half-width h = n/4096: truncation ~ h²κ'''/6, below 10⁻⁷ of κ'.
        let h = n / 4096.0;
        let first = (f64::kappa(&(n + h)) - f64::kappa(&(n - h))) / (2.0 * h);
        let second = (f64::kappa(&(n + h)) - 2.0 * f64::kappa(&n) + f64::kappa(&(n - h))) / (h * h);
        assert!((dual.slope.value / first - 1.0).abs() < 1e-7, "n = {n}");
        assert_eq!(dual.slope.value, dual.value.slope);
        // The second difference loses (4096)² u/|κ''n²/κ|, and κ''n²/κ is at least 0.01 here.
        assert!((dual.slope.slope / second - 1.0).abs() < 1e-5, "n = {n}: {} {second}", dual.slope.slope);
    }
}

#[cfg(feature = "mp")]
mod mp {
    use mdr_analytic::kappa_enclosure;
    use mdr_core::number::{Dual, Interval, Literal, Precision};
    use rug::{Float, Integer, Rational};

    use super::*;

    /// √π Γ(1+n/2)/Γ((n+1)/2) by MPFR with ample guard bits.
    fn kappa_by_gamma(n: &Float) -> Float {
        let wide = Float::with_val(n.prec() + 256, n);
        let numerator: Float = (wide.clone() / 2u32) + 1u32;
        let denominator: Float = (wide.clone() + 1u32) / 2u32;
        let ratio = if numerator > 1000 {
            (numerator.ln_gamma() - denominator.ln_gamma()).exp()
        } else {
            numerator.gamma() / denominator.gamma()
        };
        ratio * wide.pi().sqrt()
    }

    /// Fractions with numbers close to the word size use the expansions for any n.
    #[test]
    fn no_fraction_is_too_long() {
        for bits in [31_u32, 32, 57, 61, 62, 63, 64] {
            for (above, below) in [(-1, -1), (1, -1), (-3, 1), (1, 1)] {
                let end = Integer::from(1) << bits;
                for n in [(end.clone() + above, end.clone() * 3 + below), (Integer::from(1), end + below)] {
                    let n = Rational::from(n);
                    let [one, two] = [1700, 3400].map(|bits| kappa_enclosure(Precision::new(bits), &n));
                    assert!(one.overlaps(&two) && one.accuracy_bits() > 1690, "{n}: {one} {two}");
                }
            }
        }
    }

    /// Where doubles overflow, underflow, or come close to it, an enclosure at p bits overlaps one at 2p bits, is as
    /// tight as elsewhere, and κ_n κ_{n+1} = π(n+1)/2.
    #[test]
    fn no_exponent_is_out_of_range() {
        let powers = (-300..=300).step_by(25).chain([76, 77, 80, 154, 308, 309, -330, 1000, -1000, 20_000]);
        for power in powers {
            let power_of_ten: Rational = format!("1e{power}").parse::<Literal>().unwrap().to_rational();
            for n in [power_of_ten.clone() * 3u32 / 7u32, power_of_ten] {
                for bits in [70, 1000, 1600, 3400, 10_000] {
                    let [one, two] = [bits, 2 * bits].map(|bits| kappa_enclosure(Precision::new(bits), &n));
                    assert!(one.overlaps(&two), "10^{power}, {bits} bits: {one} {two}");
                    assert!(one.accuracy_bits() >= i64::from(bits) - 3, "10^{power}, {bits} bits: {one}");
                    let next = Rational::from(&n + 1u32);
                    let product = kappa_enclosure(Precision::new(bits), &next) * &one;
                    let expected = Interval::from_rational(Precision::new(bits), &next) * product.pi().over(2);
                    assert!(product.overlaps(&expected), "10^{power}, {bits} bits: {product} {expected}");
                    // n itself is rounded, by which κ_n changes half as much.
                    let float = Float::kappa(&Float::with_val(bits, &n));
                    let error = Float::with_val(bits, float - two.mid()).abs();
                    assert!(error <= two.mid() >> (bits - 1), "10^{power}, {bits} bits: {error}");
                }
            }
        }
    }

    fn relative_difference(value: &Float, reference: &Float) -> f64 {
        ((value.clone() - reference) / reference).abs().to_f64()
    }

    #[test]
    fn agrees_with_gamma() {
        for bits in [24, 53, 113, 167, 400, 1500] {
            for n in exponents().filter(|n| (1e-60..1e60).contains(n)).step_by(7) {
                let n = Float::from_f64(Precision::new(bits), n);
                let relative = relative_difference(&Float::kappa(&n), &kappa_by_gamma(&n));
                // Half an ulp of rounding; the 32 guard bits leave the rest.
                assert!(relative <= 0.501 * 2f64.powi(1 - bits as i32), "n = {n}, {bits} bits: {relative:e}");
            }
        }
    }

    #[test]
    fn derivative_agrees_with_digamma() {
        for n in [1e-9, 0.25, 0.5, 2.0, 37.5, 1e6] {
            let n = Float::with_val(200, n);
            let dual = Dual::kappa(&Dual::variable(n.clone()));
            let half: Float = n.clone() / 2u32;
            let upper = Float::with_val(300, half.clone() + 1u32).digamma();
            let lower = Float::with_val(300, Float::with_val(300, half + 0.5f64)).digamma();
            let expected = (upper - lower) / 2u32 * &dual.value;
            // 80 terms of the alternating series at 200 bits.
            assert!(relative_difference(&dual.slope, &expected) < 2f64.powi(-190), "n = {n}");
        }
    }

    #[test]
    fn intervals_contain_kappa_and_are_tight() {
        for (numerator, denominator) in
            [(1, 3), (1, 2), (2, 1), (1, 1), (7, 1), (1, 1000), (100, 3), (1000, 7), (123_456, 1), (10_000_000, 3)]
        {
            for bits in [20, 53, 200, 700] {
                let n = rug::Rational::from((numerator, denominator));
                // The reference has 200 bits more and an error below 2^-100 of an ulp.
                let exact = Interval::point(kappa_by_gamma(&Float::with_val(bits + 200, &n)));
                let exact = exact.clone().inflate(&(exact.unit_roundoff() * exact.lit(2).powi(100)));
                for kappa in [
                    kappa_enclosure(Precision::new(bits), &n),
                    Interval::kappa(&Interval::from_rational(Precision::new(bits + 32), &n)),
                ] {
                    assert!(kappa.overlaps(&exact), "n = {n}, {bits} bits: {kappa} {exact}");
                    assert!(kappa.accuracy_bits() >= i64::from(bits) - 2, "n = {n}, {bits} bits: {kappa:?}");
                }
            }
        }
    }

    /// An enclosure by Γ of MPFR at twice the precision and more.
    fn enclosure_by_gamma(n: &rug::Rational, bits: u32) -> Interval {
        let value = Interval::point(kappa_by_gamma(&Float::with_val(2 * bits + 200, n)));
        // A unit of the 256 guard bits, magnified by ln Γ where n is large.
        let bound = value.unit_roundoff() * value.lit(2).powi(64) * &value;
        value.inflate(&bound)
    }

    fn assert_encloses(kappa: &Interval, exact: &Interval, bits: u32, what: &dyn std::fmt::Display) {
        let inside = kappa.lower() <= exact.lower() && exact.upper() <= kappa.upper();
        assert!(inside, "{what}, {bits} bits: {kappa} does not contain {exact}");
        assert!(kappa.accuracy_bits() >= i64::from(bits) - 2, "{what}, {bits} bits: {kappa}");
    }

    /// n short and long, very small and very large, even (the series ends), and where the expansion changes.
    #[test]
    fn enclosures_contain_kappa_at_any_precision() {
        use rand::{RngExt, SeedableRng};
        let mut random = rand::rngs::Xoshiro256PlusPlus::seed_from_u64(1);
        let mut exponents: Vec<rug::Rational> =
            [(1, 3), (3, 10), (8, 1), (41, 2), (61, 60), (142, 1), (1000, 7), (123_456, 1)]
                .map(rug::Rational::from)
                .into();
        for length in [4, 8, 20, 40, 62] {
            let mut part = || rug::Integer::from(random.random_range(1..1_i64 << length));
            exponents.extend((0..3).map(|_| rug::Rational::from((part(), part()))));
        }
        exponents.push(rug::Rational::from((3, 7)) >> 900u32);
        exponents.extend([0.3, 1.7, 55.5].into_iter().filter_map(rug::Rational::from_f64));
        for bits in (2..40).step_by(3).chain([53, 60, 64, 113, 200, 333, 700]) {
            for n in &exponents {
                let exact = enclosure_by_gamma(n, bits);
                assert_encloses(&kappa_enclosure(Precision::new(bits), n), &exact, bits, n);
                let point = Interval::from_rational(Precision::new(bits + 32), n);
                assert_encloses(&Interval::kappa(&point), &exact, bits + 30, n);
            }
        }
    }

    /// s < 4κ_n²/π < s + 1/2s with s = 2n + 1, which is accurate to 1000 bits here.
    #[test]
    fn huge_exponents_are_enclosed() {
        for bits in [2, 53, 400] {
            for shift in [500_u32, 900, 5000] {
                let n = rug::Rational::from((3, 7)) << shift;
                let s = Interval::from_rational(Precision::new(2 * bits + 300), &(n.clone() * 2u32 + 1u32));
                let square = s.clone() + (s.lit(1) / s.clone().times(2)).hull(&s.lit(0));
                let exact = (square * s.pi()).sqrt().over(2);
                assert_encloses(&kappa_enclosure(Precision::new(bits), &n), &exact, bits, &n);
            }
        }
    }

    /// A wrong factor must be detected: κ of a neighbouring n is outside the enclosure.
    #[test]
    fn the_next_number_is_not_enclosed() {
        for n in [0.3, 1.7, 30.0] {
            let kappa = Interval::kappa(&Interval::point(Float::with_val(60, n)));
            let next = Float::with_val(200, n) + (Float::with_val(200, n) >> 50);
            assert!(!kappa.contains(&Float::kappa(&next)), "n = {n}");
        }
    }

    #[test]
    fn a_wide_interval_gives_the_hull() {
        let n = Interval::new(Float::with_val(100, 0.4), Float::with_val(100, 0.6));
        let kappa = Interval::kappa(&n);
        for end in [n.lower(), n.upper()] {
            assert!(kappa.contains(&Float::kappa(end)));
        }
        let width = Float::with_val(100, kappa.upper() - kappa.lower()).to_f64();
        assert!(width < 1.0001 * (f64::kappa(&0.6) - f64::kappa(&0.4)));
    }

    #[test]
    fn derivatives_of_intervals_enclose() {
        let n = Interval::from_rational(Precision::new(120), &(2, 3).into());
        let dual = Dual::kappa(&Dual::variable(Dual::variable(n)));
        let sharp = Dual::kappa(&Dual::variable(Dual::variable(Float::with_val(300, 2) / 3u32)));
        assert!(dual.slope.value.contains(&sharp.slope.value) && dual.slope.value.accuracy_bits() > 100);
        assert!(dual.slope.slope.contains(&sharp.slope.slope) && dual.slope.slope.accuracy_bits() > 100);
    }
}
