//! Where a picture is sampled, and the gap between the surfaces to the accuracy of a picture.

use std::f64::consts::FRAC_2_PI;

/// `count` radii from `low` to `high`, evenly spaced in a^(1/power), or in ln a for power 0.
pub(crate) fn radii(low: f64, high: f64, count: u32, power: f64) -> Vec<f64> {
    let at = |i: u32| {
        let t = f64::from(i) / f64::from(count.max(2) - 1);
        if power == 0.0 {
            return (low.ln() * (1.0 - t) + high.ln() * t).exp();
        }
        let [from, to] = [low, high].map(|a| a.powf(power.recip()));
        (from + (to - from) * t).powf(power).clamp(low, high)
    };
    (0..count).map(at).collect()
}

/// A function at radii that are evenly spaced in √r, and between them along straight lines.
pub(crate) struct Sampled {
    high: f64,
    values: Vec<f64>,
}

impl Sampled {
    const COUNT: u32 = 600;

    /// Where it is to be known.
    pub(crate) fn radii(high: f64) -> Vec<f64> {
        // Not at the tip itself, which is no radius.
        radii(1e-12 * high, high, Self::COUNT, 2.0)
    }

    /// With the values at these radii.
    pub(crate) fn new(high: f64, values: Vec<f64>) -> Self {
        Sampled { high, values }
    }

    pub(crate) fn high(&self) -> f64 {
        self.high
    }

    pub(crate) fn at(&self, r: f64) -> f64 {
        let last = self.values.len() - 1;
        let place = (r / self.high).sqrt().clamp(0.0, 1.0) * last as f64;
        let below = (place as usize).min(last - 1);
        let share = place - below as f64;
        self.values[below] * (1.0 - share) + self.values[below + 1] * share
    }
}

/// Nodes and weights of Gauss's rule of 16 points, those on one side.
const RULE: [[f64; 2]; 8] = [
    [0.095_012_509_837_637_44, 0.189_450_610_455_068_5],
    [0.281_603_550_779_258_9, 0.182_603_415_044_923_6],
    [0.458_016_777_657_227_4, 0.169_156_519_395_002_54],
    [0.617_876_244_402_643_7, 0.149_595_988_816_576_73],
    [0.755_404_408_355_003, 0.124_628_971_255_533_87],
    [0.865_631_202_387_831_7, 0.095_158_511_682_492_78],
    [0.944_575_023_073_232_6, 0.062_253_523_938_647_9],
    [0.989_400_934_991_649_9, 0.027_152_459_411_754_095],
];

/// The gap at r ≥ a: (2/π) ∫ (g(r cos φ) − d) dφ from 0 to arccos(a/r).
pub(crate) fn gap(a: f64, d: f64, r: f64, g: &impl Fn(f64) -> f64) -> f64 {
    let half = (a / r).min(1.0).acos() / 2.0;
    let at = |phi: f64| g(r * phi.cos()) - d;
    let sum: f64 = RULE.iter().map(|[x, weight]| weight * (at(half * (1.0 - x)) + at(half * (1.0 + x)))).sum();
    FRAC_2_PI * half * sum
}
