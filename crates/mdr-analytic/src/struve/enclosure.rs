//! H₀ and H₁ with proof: over intervals, and from them over `rug::Float`.

use std::cmp::Ordering;

use mdr_core::number::{Interval, Precision, Real};
use rug::float::Round;
use rug::{Assign, Float, Integer};

use super::Struve;

impl Struve for Interval {
    fn struve_h0(&self) -> Self {
        let [h0] = spread(self, [0]);
        h0
    }

    fn struve_h1(&self) -> Self {
        let [h1] = spread(self, [1]);
        h1
    }

    fn struve(&self) -> [Self; 2] {
        spread(self, [0, 1])
    }
}

/// The values at the midpoint, widened by the largest slope times the distance to the ends and intersected with the
/// envelope. Over a full wave and more the envelope alone.
fn spread<const N: usize>(z: &Interval, orders: [i64; N]) -> [Interval; N] {
    if !z.is_finite() || *z.lower() < 0 {
        return orders.map(|_| Interval::entire(z.ctx()));
    }
    if z.is_point() {
        return at_point(z, orders);
    }
    let radius = Interval::point(z.radius());
    let bounds = orders.map(|order| (*z.lower() >= 1).then(|| envelope(z, order)));
    let values = if *radius.lower() > 4 { None } else { Some(at_point(&Interval::point(z.mid()), orders)) };
    std::array::from_fn(|i| {
        let around = values.as_ref().map(|values| values[i].clone().inflate(&(slope(z, orders[i]) * &radius)));
        match (around, &bounds[i]) {
            (Some(around), Some(bound)) => bound.intersect(&around).unwrap_or(around),
            (around, bound) => around.or_else(|| bound.clone()).unwrap_or_else(|| Interval::entire(z.ctx())),
        }
    })
}

/// A bound of |H'|: |H₀'| = (2/π)|∫₀^{π/2} cos θ cos(z cos θ) dθ| ≤ 2/π, |H₁'| = |H₀''| = (2/π)|∫₀^{π/2} cos²θ sin(z cos θ) dθ|
/// ≤ 1/2 and ≤ 4z/3π; and far out, where H₀' = 2/π − H₁ and H₁' = H₀ − H₁/z decay as H − Y and Y do, from their
/// [envelopes](envelope).
fn slope(z: &Interval, order: i64) -> Interval {
    let constant = if order == 0 { std::f64::consts::FRAC_2_PI.next_up() } else { 0.5 };
    let decaying = decaying_slope(z.lower().to_f64_round(Round::Down), order);
    if decaying < constant {
        return Interval::point(Float::with_val(53, decaying)).rounded(z.ctx());
    }
    if order == 0 {
        return z.lit(2) / z.pi();
    }
    let near_zero = z.clone().times(4) / z.pi().times(3);
    let half = z.ratio(1, 2);
    if near_zero.upper() < half.upper() { near_zero } else { half }
}

/// A bound of |H'| from z on, in doubles that are rounded up, ∞ for z < 1: |H₀'| ≤ |Y₁| + 2/πz² and |H₁'| ≤ |Y₀| + 2/πz + |H₁|/z, where
/// |H₁| < 2.3, with the bounds of the envelope.
fn decaying_slope(z: f64, order: i64) -> f64 {
    if !(z >= 1.0) {
        return f64::INFINITY;
    }
    let decay = decay(z);
    let rest = if order == 0 { up(decay / z) } else { up(decay + up(2.3 / z)) };
    up(bessel_bound(z) + rest)
}

/// An enclosure of H at all arguments from z ≥ 1 on, in doubles that are rounded outwards.
///
/// |Y_ν| ≤ √(J_ν² + Y_ν²), of which the square is at most 2/πz for ν = 0 and (2/πz)(1 + 3/8z²) for ν = 1 (Watson 1944,
/// §13.74 and §13.75). H₀ − Y₀ lies between 0 and 2/πz, H₁ − Y₁ between 2/π and (2/π)(1 + 1/z²) (DLMF 11.6.1).
fn envelope(z: &Interval, order: i64) -> Interval {
    let place = z.lower().to_f64_round(Round::Down);
    let (decay, bessel) = (decay(place), bessel_bound(place));
    let share = std::f64::consts::FRAC_2_PI;
    let [lower, upper] = if order == 0 {
        [-bessel, up(bessel + decay)]
    } else {
        [(share.next_down() - bessel).next_down(), up(up(share.next_up() + bessel) + up(decay / place))]
    };
    let end = |end: f64| Float::with_val(53, end);
    Interval::new(end(lower), end(upper)).rounded(z.ctx())
}

/// The next double: at least the exact result, of which this is the nearest.
fn up(value: f64) -> f64 {
    value.next_up()
}

/// A bound of 2/πz from above.
fn decay(z: f64) -> f64 {
    up(std::f64::consts::FRAC_2_PI.next_up() / z)
}

/// A bound of |Y₀| and of |Y₁| from z ≥ 1 on.
fn bessel_bound(z: f64) -> f64 {
    up(up(decay(z) * up(1.0 + up(up(0.375 / z) / z))).sqrt())
}

/// H at an exactly known point.
fn at_point<const N: usize>(z: &Interval, orders: [i64; N]) -> [Interval; N] {
    // Above the range of doubles the argument is infinite here, which counts as large.
    if z.mid().to_f64() > 0.7 * f64::from(z.precision()) + 10.0 {
        let decaying = decaying(z, GUARD);
        orders.map(|order| bessel(z, order) + &decaying[order as usize])
    } else {
        let both = near(z, GUARD);
        orders.map(|order| both[order as usize].clone())
    }
}

/// Guard bits of the sums in fixed point. Enclosures are right without any, and with them as tight as their precision.
const GUARD: u32 = 40;

/// H₀ = (2/π) z Σ (−1)ᵏ uₖ and H₁ = (2/π) z² Σ (−1)ᵏ uₖ/(2k+3), u₀ = 1 and uₖ₊₁ = uₖ z²/(2k+3)², in fixed point of w bits.
///
/// The terms grow to e^z while the sums stay of order one. Each step rounds down by less than one unit, in z² and in
/// the quotient, and this loss grows at most as the terms do from there: by at most a factor U, the largest of 1 and the
/// terms. So the error of uₖ is at most (2k+1)U units, that of K terms (K+1)²U, with one unit each for the quotients of
/// H₁. U < 2(M+1), where M is the largest computed term, as K is far below 2ʷ. Once the terms are below a unit they
/// decrease, and so do the omitted ones.
fn near(z: &Interval, guard: u32) -> [Interval; 2] {
    let bits = z.precision();
    // U < 2^1.45z, as the argument is below 0.7 p + 10.
    let unit = bits + (1.45 * z.mid().to_f64()) as u32 + guard;
    let square = fixed(Float::with_val(2 * bits, z.lower().square_ref()), unit);
    let mut term = Integer::from(1) << unit;
    let (mut largest, mut sums) = (term.clone(), [term.clone(), Integer::from(&term / 3u32)]);
    let mut k = 0u32;
    while term != 0 {
        term *= &square;
        term >>= unit;
        term /= 2 * k + 3;
        term /= 2 * k + 3;
        k += 1;
        if term > largest {
            largest.assign(&term);
        }
        let quotient = Integer::from(&term / (2 * k + 3));
        add(&mut sums[0], k.is_multiple_of(2), &term);
        add(&mut sums[1], k.is_multiple_of(2), &quotient);
    }
    let steps = Integer::from(k + 2);
    let error = ((largest >> unit) + 2u32) * 2u32 * Integer::from(steps.square_ref()) + steps;
    let [zero, one] = sums.map(|sum| enclosed(&sum, &error, unit, bits + guard));
    let wide = z.rounded(Precision::new(bits + guard));
    let share = wide.clone().times(2) / wide.pi();
    [zero * &share, one * share * wide].map(|value| value.rounded(z.ctx()))
}

/// H_ν − Y_ν by the asymptotic series, whose remainder is below the first omitted term: (2/π) Σ cₖ/z for ν = 0, with c₀
/// = 1 and cₖ₊₁ = −cₖ (2k+1)²/z², and (2/π)(1 − Σ cₖ/(2k−1)) from k = 1 on for ν = 1; in fixed point.
///
/// While 2k + 1 < z the terms decrease, and no (2k+1)² cₖ exceeds one. So a step adds to the error of a term less than
/// two units for that of 1/z² and one for its own rounding, and K terms have less than 3(K+1)² units in all.
fn decaying(z: &Interval, guard: u32) -> [Interval; 2] {
    let (bits, x) = (z.precision(), z.lower());
    let unit = bits + guard;
    let inverse = fixed(Float::with_val(unit, x).square().recip(), unit);
    let mut term = Integer::from(1) << unit;
    let mut sums = [term.clone(), term.clone()];
    let mut k = 0u32;
    // z > 0.7 p: the terms reach 2^−p before they grow.
    while term != 0 && *x > 2 * k + 1 {
        term *= &inverse;
        term *= 2 * k + 1;
        term *= 2 * k + 1;
        term >>= unit;
        k += 1;
        add(&mut sums[0], k.is_multiple_of(2), &term);
        add(&mut sums[1], !k.is_multiple_of(2), &Integer::from(&term / (2 * k - 1)));
    }
    // The last term included is larger than the first one omitted.
    let error = Integer::from(k + 2).square() * 4u32 + term;
    let [zero, one] = sums.map(|sum| enclosed(&sum, &error, unit, unit));
    let wide = z.rounded(Precision::new(unit));
    let share = wide.lit(2) / wide.pi();
    [zero * &share / wide, one * share].map(|value| value.rounded(z.ctx()))
}

/// Y_ν from MPFR, correctly rounded.
fn bessel(z: &Interval, order: i64) -> Interval {
    let mut y = Float::with_val(z.precision(), z.lower());
    let rounding = if order == 0 { y.y0_round(Round::Down) } else { y.y1_round(Round::Down) };
    let mut above = y.clone();
    if rounding != Ordering::Equal {
        above.next_up();
    }
    Interval::new(y, above)
}

fn add(sum: &mut Integer, positive: bool, term: &Integer) {
    if positive { *sum += term } else { *sum -= term }
}

/// A positive number in units of 2^−unit, rounded down.
fn fixed(x: Float, unit: u32) -> Integer {
    (x << unit).to_integer_round(Round::Down).map_or_else(Integer::new, |(units, _)| units)
}

/// A sum in units of 2^−unit with an error in the same units.
fn enclosed(sum: &Integer, error: &Integer, unit: u32, bits: u32) -> Interval {
    let end = |units: Integer, round| Float::with_val_round(bits, units, round).0 >> unit;
    Interval::new(end(Integer::from(sum - error), Round::Down), end(Integer::from(sum + error), Round::Up))
}

impl Struve for Float {
    fn struve_h0(&self) -> Float {
        let [h0] = rounded(self, [0]);
        h0
    }

    fn struve_h1(&self) -> Float {
        let [h1] = rounded(self, [1]);
        h1
    }

    fn struve(&self) -> [Float; 2] {
        rounded(self, [0, 1])
    }
}

/// The midpoints of enclosures that are a few bits finer than the result.
fn rounded<const N: usize>(z: &Float, orders: [i64; N]) -> [Float; N] {
    let fine = Interval::point(Float::with_val(z.prec() + 16, z));
    spread(&fine, orders).map(|value| Float::with_val(z.prec(), value.mid()))
}

#[cfg(test)]
#[path = "../../tests/private/struve.rs"]
mod tests;
