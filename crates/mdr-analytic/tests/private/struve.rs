//! The sums in fixed point without a guard bit, where their errors are not hidden by the rounding of the result.

use super::*;

/// Bits of the truth.
const TRUTH: u32 = 400;

fn at(z: f64, bits: u32) -> Interval {
    Interval::point(Float::with_val(bits, z))
}

/// Numbers of four bits from 1/16 to 240.
fn arguments() -> impl Iterator<Item = f64> {
    (-4..8).flat_map(|exponent| (8..16).map(move |mantissa| f64::from(mantissa) * 2_f64.powi(exponent - 3)))
}

#[test]
fn sums_without_guard_bits_contain_the_truth() {
    for bits in 4..=32 {
        for z in arguments() {
            let [few, many] = [at(z, bits), at(z, TRUTH)];
            let large = z > 0.7 * f64::from(bits) + 10.0;
            // H itself near 0, H − Y where z is large; the truth by the sum of 400 bits, and by MPFR's Y.
            let found = if large { decaying(&few, 0) } else { near(&few, 0) };
            let truth = near(&many, GUARD);
            for order in 0..2 {
                let value = if large { bessel(&few, order as i64) + &found[order] } else { found[order].clone() };
                assert!(
                    value.contains(&truth[order].mid()),
                    "H{order}({z}) of {bits} bits: {value:?}, {}",
                    truth[order]
                );
            }
            // With guard bits it is as narrow as its precision, which the error of a sum without any is not.
            assert!(bits < 12 || large || near(&few, GUARD)[0].radius() < found[0].radius(), "H0({z}) of {bits} bits");
        }
    }
}

/// H' at the end of an interval is within its bound, and the bound decays: over a tenth of a wave far out the values are within a tenth of their
/// amplitude.
#[test]
fn slopes_are_bounded_and_decay() {
    for z in arguments().chain([1e3, 1e5]) {
        for far in [1.0, 1.1, 1.7, 2.9, 40.0] {
            let place = at(z * far, 100);
            let [h0, h1] = place.struve();
            let slopes = [place.lit(2) / place.pi() - &h1, h0 - h1 / &place];
            for (order, exact) in slopes.iter().enumerate() {
                let bound = slope(&at(z, 100).hull(&place), order as i64);
                assert!(exact.abs().lower() <= bound.upper(), "H{order}' at {z} times {far}: {exact} beyond {bound}");
            }
        }
    }
    for z in [1e3, 1e5] {
        let wide = Interval::new(Float::with_val(64, z), Float::with_val(64, z + 0.2));
        for value in wide.struve() {
            assert!(value.radius().to_f64() < 0.13 * (2.0 / (std::f64::consts::PI * z)).sqrt(), "{value} at {z}");
        }
    }
}
