//! A part of a profile on the circle of radius x, and the closed moments of polynomials over it.
//!
//! With r = x sin θ the part p ≤ r ≤ q is an arc of half-angle η about the direction φ. Let τ = θ − φ and z = 1 − cos τ.
//! About c = x sin φ, and with e = x cos φ, r = c + e sin τ − c z and √(x² − r²) = e cos τ − c sin τ. So every moment of
//! (r − c)ᵏ is a combination of Iⱼ = ∫₀^η zʲ dτ with positive terms, and nothing cancels: neither for a short arc
//! far from x (where closed forms in arcsin lose (x/h)² or more) nor for one that ends at x.

use std::array::from_fn;

use mdr_core::number::Real;

/// An end of an arc: r/x and √(x² − r²)/x, both to full relative accuracy.
#[derive(Clone)]
pub(super) struct Spoke<R> {
    pub(super) sin: R,
    pub(super) cos: R,
}

impl<R: Real> Spoke<R> {
    /// The direction of r = x.
    pub(super) fn edge(x: &R) -> Self {
        Spoke { sin: x.lit(1), cos: x.lit(0) }
    }

    /// The direction of r < x.
    pub(super) fn new(r: &R, x: &R) -> Self {
        let sin = r.clone() / x;
        let cos = ((x.clone() - r) / x * (sin.lit(1) + &sin)).sqrt();
        Spoke { sin, cos }
    }
}

/// The arc from p to q, in units of a length h.
pub(super) struct Arc<R> {
    /// (c − p)/h: the centre of the moments.
    pub(super) centre: R,
    /// c/h.
    sine: R,
    /// e/h.
    cosine: R,
    /// (h/x)².
    unit: R,
    /// I₀ to I₄.
    powers: [R; 5],
}

impl<R: Real> Arc<R> {
    /// The arc between two spokes at a distance `length` = (q − p)/h, for `scale` = x/h.
    ///
    /// sin 2η and cos 2η come from the spokes as quotient and sum of positive terms.
    pub(super) fn new(from: &Spoke<R>, to: &Spoke<R>, length: &R, scale: &R) -> Self {
        let sum = from.sin.clone() + &to.sin;
        let cross = to.sin.clone() * &from.cos + from.sin.clone() * &to.cos;
        let dot = from.cos.clone() * &to.cos + from.sin.clone() * &to.sin;
        let tan = length.clone() / scale * (sum.clone() / cross) / (dot.lit(1) + dot);
        let tan_squared = tan.square();
        let secant = (tan.lit(1) + &tan_squared).sqrt();
        // z(η) = 1 − 1/sec η
        let versine = tan_squared / (secant.clone() * (secant.lit(1) + &secant));
        let mean = sum.over(2) * scale;
        let sine = mean.clone() * &secant;
        Arc {
            centre: length.clone().over(2) + mean * (secant.clone() * &versine),
            cosine: (from.cos.clone() + &to.cos).over(2) * &secant * scale,
            unit: scale.clone().inv().square(),
            powers: versine_integrals(&versine, &(tan / secant)),
            sine,
        }
    }

    /// ∫ ((r − c)/h)ᵏ dr/√(x² − r²) for k = 0, 1, 2.
    pub(super) fn weighted(&self) -> [R; 3] {
        let [i0, i1, i2, ..] = &self.powers;
        let (c, e) = (self.sine.square(), self.cosine.square());
        let sin_squared = i1.clone().times(2) - i2;
        [i0.clone(), -(self.sine.clone() * i1), e * sin_squared + c * i2].map(|half| half.times(2))
    }

    /// ∫ ((r − c)/h)ᵏ √(x² − r²) dr/x² for k = 0, 1, 2.
    pub(super) fn lifted(&self) -> [R; 3] {
        let [i0, i1, i2, i3, i4] = &self.powers;
        let (c, e) = (self.sine.square(), self.cosine.square());
        let combine = |terms: &[(&R, i64)]| terms.iter().fold(i0.lit(0), |sum, (i, k)| sum + (*i).clone().times(*k));
        // Each line: an integral over z of the polynomial in the comment, which is positive.
        let cos2 = combine(&[(i0, 1), (i1, -2), (i2, 1)]); // (1−z)²
        let sin2 = combine(&[(i1, 2), (i2, -1)]); // z(2−z)
        let e_first = combine(&[(i1, 5), (i2, -8), (i3, 3)]); // z(1−z)(5−3z)
        let c_first = combine(&[(i2, 2), (i3, -1)]); // z²(2−z)
        let ee = combine(&[(i1, 2), (i2, -5), (i3, 4), (i4, -1)]); // z(2−z)(1−z)²
        let ec = combine(&[(i2, 13), (i3, -18), (i4, 6)]); // z²(13−18z+6z²)
        let cc = combine(&[(i3, 2), (i4, -1)]); // z³(2−z)
        let m0 = e.clone() * cos2 + c.clone() * sin2;
        let m1 = e.clone() * e_first + c.clone() * c_first;
        let m2 = e.clone() * (e.clone() * ee + c.clone() * ec) + c.square() * cc;
        [m0, -(self.sine.clone() * m1), m2].map(|half| half.times(2) * &self.unit)
    }
}

/// I₀ … I₄ from z = 1 − cos η ≤ 1 − cos 45° and sin η.
///
/// With Iₖ = ιₖ zᵏ sin η, integration by parts gives (2k−1) ιₖ₋₁ = 1 + k z ιₖ: unstable upwards, downwards a Horner
/// scheme of positive terms in which the error of the start decreases by z/2 per step. Started at ι_K = 1/(2K+1), the
/// relative error is below (z/2)^(K−3). ι_K lies between 1/(2K+1) and 1/(2K+1)/(1 − z/2), and its derivative between 0
/// and 1/(2K+1): an enclosure starts with these bounds, for any K, and so does its slope. A wide enclosure may extend
/// far beyond the possible z, and so may its midpoint: then no number of steps would refine it.
fn versine_integrals<R: Real>(z: &R, sin: &R) -> [R; 5] {
    let middle = z.approx();
    let steps = if middle < 0.5 {
        (f64::from(z.precision()) / (1.0 - middle.max(f64::MIN_POSITIVE).log2())).ceil() as i64
    } else {
        0
    };
    let start = z.lit(1).over(2 * steps + 11);
    let mut iota = start.clone().inflate_with_slope(&(start * z));
    let mut next = |k: i64| {
        iota = (iota.clone() * z).times(k) + z.lit(1);
        iota = iota.clone().over(2 * k - 1);
        iota.clone()
    };
    for k in (6..=5 + steps).rev() {
        next(k);
    }
    let [i4, i3, i2, i1, i0] = from_fn(|k| next(5 - k as i64));
    let mut power = sin.clone();
    [i0, i1, i2, i3, i4].map(|iota| {
        let integral = iota * &power;
        power *= z;
        integral
    })
}

#[cfg(all(test, feature = "mp"))]
mod tests {
    use mdr_core::number::{Interval, Precision};
    use rug::Float;

    use super::*;

    /// Enclosures of z as wide as those over a cell of radii: the representative point is not a possible z.
    #[test]
    fn a_wide_enclosure_holds_what_every_z_gives() {
        let precision = Precision::new(200);
        let number = |value: f64| Float::with_val(precision.bits(), value);
        let one = Interval::from_int(precision, 1);
        for middle in [0.15, 0.5, 1.9, 1.999_999, 2.0, 2.000_001, 2.1, 40.0, 1e300] {
            let wide = versine_integrals(&Interval::new(number(0.01), number(2.0 * middle - 0.01)), &one);
            for z in [0.01, 0.1, 0.28] {
                let narrow = versine_integrals(&Interval::point(number(z)), &one);
                for (power, (wide, narrow)) in wide.iter().zip(&narrow).enumerate() {
                    let holds = wide.lower() <= narrow.lower() && narrow.upper() <= wide.upper();
                    assert!(holds, "I{power}({z}) around {middle}: {wide} {narrow}");
                }
            }
        }
    }
}
