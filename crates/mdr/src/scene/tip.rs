//! Whether a formula is zero at the tip, from where heights are measured.

use std::collections::BTreeMap;

use mdr_core::contact::{Expression, Profile as Height};
use mdr_core::number::Literal;

/// Refuses a formula with f(0) ≠ 0, decided exactly. Where it is not defined at 0 itself, such as r ln(1 + 1/r), it must fall
/// on the way there; its terms may cancel there, so that the precision grows until enclosures tell.
#[cfg(feature = "mp")]
pub(super) fn zero_at_the_tip(
    formula: &Expression,
    values: &BTreeMap<String, Literal>,
) -> std::result::Result<(), String> {
    use mdr_core::number::{Interval, Precision, Real};
    let precision = Precision::new(128);
    let profile = formula.bind::<Interval>(precision, values).map_err(|error| error.to_string())?;
    let tip = profile.height(&Interval::from_int(precision, 0));
    if tip.is_finite() {
        if tip.contains_zero() {
            return Ok(());
        }
        return Err(not_zero(tip.approx()));
    }
    let mut left = MOST_WORK;
    for (bits, radii) in APPROACHES {
        left = left.saturating_sub(formula.operations().saturating_mul(bits.into()));
        if left == 0 {
            break;
        }
        let precision = Precision::new(bits);
        let profile = formula.bind::<Interval>(precision, values).map_err(|error| error.to_string())?;
        let heights = radii.map(|k| profile.height(&Interval::from_int(precision, 10).powi(k)).abs());
        let (near, twice) = (&heights[0], heights[1].clone().times(2));
        if twice < *near {
            return Ok(());
        }
        if twice > *near {
            let heights = heights.map(|height| height.mid().to_string_radix(10, Some(4)));
            return Err(no_limit(&radii.map(|k| format!("1e{k}")), &heights));
        }
    }
    Err("whether the profile tends to 0 at the tip, r → 0, is not decided: its terms cancel there; heights are measured from \
         there, write the formula without the cancellation"
        .to_owned())
}

/// Bits of enclosures, and the powers of ten of two radii on the way to the tip: first those that are nearest, then those that need fewer
/// digits.
#[cfg(feature = "mp")]
const APPROACHES: [(u32, [i64; 2]); 5] = [
    (128, [-1000, -10_000]),
    (1 << 10, [-1000, -10_000]),
    (1 << 13, [-100, -1000]),
    (1 << 15, [-100, -1000]),
    (1 << 17, [-100, -1000]),
];

/// The most operations times bits that may be spent on it.
#[cfg(feature = "mp")]
const MOST_WORK: u64 = 1 << 27;

/// Checks f(0) = 0 of a formula in doubles, up to their rounding.
#[cfg(not(feature = "mp"))]
pub(super) fn zero_at_the_tip(
    formula: &Expression,
    values: &BTreeMap<String, Literal>,
) -> std::result::Result<(), String> {
    let profile = formula.bind::<f64>((), values).map_err(|error| error.to_string())?;
    let height = |r: f64| Height::<f64>::height(&profile, &r);
    let tip = height(0.0);
    if tip.is_finite() {
        let largest = (-12..=0).map(|k| height(10f64.powi(k)).abs()).filter(|f| f.is_finite()).fold(0.0, f64::max);
        return if tip.abs() <= 1e-12 * largest { Ok(()) } else { Err(not_zero(tip)) };
    }
    let heights = [1e-30, 1e-300].map(|r| height(r).abs());
    if 2.0 * heights[1] < heights[0] {
        return Ok(());
    }
    Err(no_limit(&["1e-30", "1e-300"].map(str::to_owned), &heights.map(|height| height.to_string())))
}

/// What is seen of a formula that does not fall towards the tip, in magnitude.
fn no_limit([far, near]: &[String; 2], heights: &[String; 2]) -> String {
    format!(
        "the profile is not seen to tend to 0 at the tip, r → 0: |f| is {} at r = {far} m and {} at r = {near} m; heights are \
         measured from there",
        heights[0], heights[1]
    )
}

fn not_zero(height: f64) -> String {
    if height == 0.0 {
        return "the profile is not zero at the tip: f(0) is too small for a double, but not 0; subtract the formula at r = 0 from \
                it"
            .to_owned();
    }
    format!("the profile is not zero at the tip, f(0) = {height}; subtract {height} from it")
}
