//! The functions of an edge radius b: √(x² − b²), arccos(b/x), and the combinations that cancel when written naively.

use mdr_core::number::Special;

/// The quantities that all profiles with an edge at b need at a radius x > b.
pub(super) struct Edge<R> {
    /// q = √(x² − b²).
    pub(super) leg: R,
    /// θ = arccos(b/x) = arctan(q/b), computed from q so that it is accurate as x → b.
    pub(super) angle: R,
}

impl<R: Special> Edge<R> {
    /// `None` if x is not certainly outside b.
    pub(super) fn at(x: &R, b: &R) -> Option<Edge<R>> {
        if x <= b {
            return None;
        }
        let leg = (x.clone() - b).sqrt() * (x.clone() + b).sqrt();
        let angle = (leg.clone() / b).atan();
        Some(Edge { leg, angle })
    }

    /// All radii between b and b(1 + margin) at once: over enclosures an enclosure of them.
    pub(super) fn beside(b: &R, margin: &R) -> Edge<R> {
        let half = Self::reach(b, margin).over(2);
        let leg = half.clone().inflate(&half);
        let angle = (leg.clone() / b).atan();
        Edge { leg, angle }
    }

    /// √(x² − b²) at x = b(1 + margin).
    pub(super) fn reach(b: &R, margin: &R) -> R {
        ((margin.lit(2) + margin) * margin).sqrt() * b
    }

    /// ½(x²θ − bq)/x = ½[q²θ − b²(tan θ − θ)]/x: the mean of x arccos(b/x).
    pub(super) fn cone_mean(&self, x: &R, b: &R) -> R {
        let excess = tangent_excess(&(self.leg.clone() / b), &self.angle);
        (self.leg.clone() / x * &self.leg * &self.angle - b.clone() / x * excess * b).over(2)
    }

    /// [q³/3 − ½b(x²θ − bq)]/Rx: the mean of x(q − bθ)/R, which starts with q⁵/15b²Rx.
    pub(super) fn rounded_mean(&self, x: &R, b: &R, radius: &R) -> R {
        let t = self.leg.clone() / b;
        // b³[t³/3 − ½((1 + t²) arctan t − t)] = bq² Σ_{k≥1} (−1)^{k+1} t^{2k+1}/((2k+1)(2k+3))
        match odd_series(&t, -1, |k| (1, (2 * k + 1) * (2 * k + 3))) {
            Some(series) => series * t.square() * t * (self.leg.clone() / x) * &self.leg * (b.clone() / radius),
            None => {
                let punch = self.leg.clone() / radius * (self.leg.clone() / x) * self.leg.clone().over(3);
                punch - self.cone_mean(x, b) * (b.clone() / radius)
            }
        }
    }
}

/// An enclosure of the radii between b(1 − margin) and b(1 + margin).
pub(super) fn around<R: Special>(b: &R, margin: &R) -> R {
    b.clone().inflate(&(margin.clone() * b))
}

/// [t − (1 − t²) artanh t]/t² = Σ_{k≥1} 2 t^{2k−1}/((2k−1)(2k+1)), 0 < t < 1. Divided by t², it is in range wherever t
/// is.
pub(super) fn atanh_moment<R: Special>(t: &R) -> R {
    match odd_series(t, 1, |k| (2, (2 * k - 1) * (2 * k + 1))) {
        Some(series) => series * t,
        None => (t.clone() - (t.lit(1) - t) * (t.lit(1) + t) * t.atanh()) / t.square(),
    }
}

/// [(1 + t²) arctan t − t]/t² = Σ_{k≥1} (−1)^{k+1} 2 t^{2k−1}/((2k−1)(2k+1)), t > 0.
pub(super) fn atan_moment<R: Special>(t: &R) -> R {
    match odd_series(t, -1, |k| (2, (2 * k - 1) * (2 * k + 1))) {
        Some(series) => series * t,
        None => {
            // The square of 1/t stays in range.
            let inverse = t.clone().inv();
            t.atan() * (inverse.square() + t.lit(1)) - inverse
        }
    }
}

/// tan θ − θ = t − arctan t = Σ_{k≥1} (−1)^{k+1} t^{2k+1}/(2k+1), t = tan θ > 0.
pub(super) fn tangent_excess<R: Special>(t: &R, angle: &R) -> R {
    match odd_series(t, -1, |k| (1, 2 * k + 1)) {
        Some(series) => series * t * t.square(),
        None => t.clone() - angle,
    }
}

/// (artanh t − t)/t³ = Σ_{k≥1} t^{2k−2}/(2k+1), 0 < t < 1.
pub(super) fn atanh_excess<R: Special>(t: &R) -> R {
    odd_series(t, 1, |k| (1, 2 * k + 1)).unwrap_or_else(|| (t.atanh() - t) / (t.square() * t))
}

/// Σ_{k≥1} s^{k+1} c_k t^{2k−2} for t < 1/2, where the closed forms above lose two bits and more to cancellation;
/// `None` for other t. The coefficients c_k = p/q decrease with k, so the remainder after a term is below 1/3 of that
/// term; and 2k c_{k+1} < 3/2 (2k−2) c_k, so the remainder of the derivatives is below 3/5 of the last one. For second
/// derivatives of terms from the fourth on it is below 9/10; a sum of two or three terms has a tiny t.
fn odd_series<R: Special>(t: &R, sign: i64, coefficient: impl Fn(i64) -> (i64, i64)) -> Option<R> {
    if !(*t < t.ratio(1, 2)) {
        return None;
    }
    let square = t.square().times(sign);
    let term = |power: &R, k: i64| {
        let (numerator, denominator) = coefficient(k);
        power.clone().times(numerator).over(denominator)
    };
    let mut power = t.lit(1);
    let mut sum = term(&power, 1);
    let negligible = sum.abs().midpoint() * t.unit_roundoff();
    let mut k = 1;
    loop {
        k += 1;
        power *= &square;
        let last = term(&power, k);
        sum += &last;
        if !(last.abs().midpoint() > negligible) {
            // Of any sign, and so are its derivatives: ±1 is a constant.
            let sign = t.lit(-1).either(&t.lit(1));
            return Some(sum + last * &sign);
        }
    }
}
