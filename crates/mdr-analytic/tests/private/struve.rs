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
