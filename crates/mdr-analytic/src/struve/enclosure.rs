//! H₀ and H₁ with a proof: over intervals, and from them over `rug::Float`.

use mdr_core::number::{Interval, Precision, Real};
use rug::Float;
use rug::float::Round;

use super::{Struve, power_series};

impl Struve for Interval {
    fn struve_h0(&self) -> Self {
        // |H₀'| = (2/π)|∫₀^{π/2} cos θ cos(z cos θ) dθ| ≤ 2/π.
        spread(self, 0, |width| width.times(2) / self.pi())
    }

    fn struve_h1(&self) -> Self {
        // |H₁'| = |H₀''| = (2/π)|∫₀^{π/2} cos²θ sin(z cos θ) dθ| ≤ 1/2 and ≤ 4z/3π.
        spread(self, 1, |width| {
            let near_zero = self.clone().times(4) / self.pi().times(3);
            let half = width.ratio(1, 2);
            width * if near_zero.upper() < half.upper() { near_zero } else { half }
        })
    }
}

/// The value at the middle, widened by the largest slope times the distance to the ends, and what the envelope leaves of
/// it. Over a wave and more the envelope alone.
fn spread(z: &Interval, order: i64, change: impl Fn(Interval) -> Interval) -> Interval {
    if !z.is_finite() || *z.lower() < 0 {
        return Interval::entire(z.ctx());
    }
    if z.is_point() {
        return at_point(z, order);
    }
    let radius = Interval::point(z.radius());
    let envelope = (*z.lower() >= 1).then(|| envelope(&Interval::point(z.lower().clone()), order));
    match envelope {
        Some(envelope) if *radius.lower() > 4 => envelope,
        envelope => {
            let value = at_point(&Interval::point(z.mid()), order).inflate(&change(radius));
            envelope.and_then(|envelope| envelope.intersect(&value)).unwrap_or(value)
        }
    }
}

/// What H is at all arguments from z on.
///
/// |Y_ν| ≤ √(J_ν² + Y_ν²), of which the square is at most 2/πz for ν = 0 and (2/πz)(1 + 3/8z²) for ν = 1 (Watson 1944,
/// §13.74 and §13.75). H₀ − Y₀ lies between 0 and 2/πz, H₁ − Y₁ between 2/π and (2/π)(1 + 1/z²) (DLMF 11.6.1).
fn envelope(z: &Interval, order: i64) -> Interval {
    let share = z.lit(2) / z.pi();
    let decay = share.clone() / z;
    if order == 0 {
        let bessel = decay.sqrt();
        return (-bessel.clone()).hull(&(bessel + decay));
    }
    let square = z.lit(1) / z.square();
    let bessel = (decay * (square.clone().times(3).over(8) + z.lit(1))).sqrt();
    (share.clone() - &bessel).hull(&(bessel + (square + z.lit(1)) * share))
}

/// H at an exactly known point.
fn at_point(z: &Interval, order: i64) -> Interval {
    let bits = z.precision();
    let size = z.mid().to_f64();
    if size > 0.7 * f64::from(bits) + 10.0 {
        return far(z, order);
    }
    // The terms of the series grow to e^z while the sum stays of order one.
    let working = Precision::new(bits + (1.45 * size) as u32 + 16);
    let wide = Interval::new(Float::with_val(working.bits(), z.lower()), Float::with_val(working.bits(), z.upper()));
    let sum = power_series(&wide, order).times(2) / wide.pi();
    let round = |end: &Float, round| Float::with_val_round(bits, end, round).0;
    Interval::new(round(sum.lower(), Round::Down), round(sum.upper(), Round::Up))
}

/// Y_ν from MPFR, correctly rounded, and H_ν − Y_ν from its asymptotic series. The series of (π/2)(H₀ − Y₀) starts with
/// 1/z and has the ratio −(2k+1)²/z²; that of (π/2)(H₁ − Y₁) starts with 1 and has the ratio (1+2k)(1−2k)/z².
fn far(z: &Interval, order: i64) -> Interval {
    let bits = z.precision();
    let square = z.square();
    let mut term = if order == 0 { z.lit(1) / z } else { z.lit(1) };
    let mut sum = term.clone();
    let mut k = 0;
    loop {
        let numerator = if order == 0 { -(2 * k + 1) * (2 * k + 1) } else { (1 + 2 * k) * (1 - 2 * k) };
        term = term.times(numerator) / &square;
        k += 1;
        // z > 0.7 p: the terms reach 2^−p before they grow.
        if term.abs().mid() <= sum.abs().mid() * z.unit_roundoff().mid() {
            break;
        }
        sum += &term;
    }
    let difference = sum.inflate(&term).times(2) / z.pi();
    let bessel = |round| {
        let mut y = Float::with_val(bits, z.lower());
        if order == 0 {
            y.y0_round(round)
        } else {
            y.y1_round(round)
        };
        y
    };
    Interval::new(bessel(Round::Down), bessel(Round::Up)) + difference
}

impl Struve for Float {
    fn struve_h0(&self) -> Float {
        rounded(self, Interval::struve_h0)
    }

    fn struve_h1(&self) -> Float {
        rounded(self, Interval::struve_h1)
    }
}

/// The middle of an enclosure that is some bits finer than the result.
fn rounded(z: &Float, function: fn(&Interval) -> Interval) -> Float {
    let fine = Float::with_val(z.prec() + 16, z);
    Float::with_val(z.prec(), function(&Interval::point(fine)).mid())
}
