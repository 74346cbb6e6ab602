//! Where a picture is sampled, and the gap between the surfaces to the accuracy of a picture.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use mdr_core::contact::{Error, Quantity, Result};

/// The most samples of one picture.
pub(crate) const MOST: u32 = 10_000;

/// `count` radii from `low` to `high`, evenly spaced in a^(1/power), or in ln a for power 0.
///
/// # Errors
/// Unless 0 ≤ `low` ≤ `high`, both finite, `power` is 0 or positive and finite, and `count` at most [`MOST`].
pub(crate) fn radii(low: f64, high: f64, count: u32, power: f64) -> Result<Vec<f64>> {
    let within = |valid: bool, quantity, value: f64, requirement| {
        if valid { Ok(()) } else { Err(Error::domain(quantity, &value, requirement)) }
    };
    within(
        low >= 0.0 && low.is_finite(),
        Quantity::Parameter("the smallest radius"),
        low,
        "0 or positive, and finite",
    )?;
    let wide = high >= low && high.is_finite();
    within(wide, Quantity::Parameter("the largest radius"), high, "finite and no smaller than the smallest radius")?;
    within(power >= 0.0 && power.is_finite(), Quantity::Parameter("power"), power, "0 or positive, and finite")?;
    within(count <= MOST, Quantity::Parameter("count"), f64::from(count), "at most 10000")?;
    let at = |i: u32| {
        let t = f64::from(i) / f64::from(count.max(2) - 1);
        if power == 0.0 {
            return (low.ln() * (1.0 - t) + high.ln() * t).exp();
        }
        let [from, to] = [low, high].map(|a| a.powf(power.recip()));
        (from + (to - from) * t).powf(power).max(low).min(high)
    };
    Ok((0..count).map(at).collect())
}

/// A function at radii that are evenly spaced in √r, and between them along straight lines.
pub(crate) struct Sampled {
    high: f64,
    values: Vec<f64>,
}

impl Sampled {
    const COUNT: u32 = 600;

    /// The radii at which the function is sampled.
    ///
    /// # Errors
    /// Unless `high` is finite and not negative.
    pub(crate) fn radii(high: f64) -> Result<Vec<f64>> {
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

    /// NaN where nothing is known.
    pub(crate) fn at(&self, r: f64) -> f64 {
        let last = self.values.len().saturating_sub(1);
        let place = (r / self.high).sqrt().clamp(0.0, 1.0) * last as f64;
        let below = (place as usize).min(last.saturating_sub(1));
        let share = place - below as f64;
        match self.values.get(below..below + 2) {
            Some([before, after]) => before * (1.0 - share) + after * share,
            _ => f64::NAN,
        }
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

/// How the surface comes down outside of a contact.
#[derive(Clone, Copy)]
pub(crate) enum Surface {
    /// A half-space with E ∝ zᵏ; k = 0 is the homogeneous one.
    HalfSpace(f64),
    /// Springs that do not act on each other: it does not.
    Springs,
    /// A half-plane with a strip in contact in each period.
    Strips(f64),
}

impl Surface {
    /// The gap at r > a between the undeformed height f and the surface.
    pub(crate) fn gap(self, [a, d, r]: [f64; 3], height: f64, g: &impl Fn(f64) -> f64) -> f64 {
        match self {
            Surface::HalfSpace(k) => beside_disc(k, a, d, r, g),
            Surface::Springs => height - d,
            Surface::Strips(period) => beside_strip(period, a, d, r, g),
        }
    }
}

/// (2 cos(πk/2)/π) ∫ cotᵏφ (g(r cos φ) − d) dφ from 0 to arccos(a/r), over s = φ^(1 − k), in which nothing is singular.
fn beside_disc(k: f64, a: f64, d: f64, r: f64, g: &impl Fn(f64) -> f64) -> f64 {
    let half = (a / r).min(1.0).acos().powf(1.0 - k) / 2.0;
    let at = |s: f64| {
        let phi = s.powf((1.0 - k).recip());
        (phi / phi.tan()).powf(k) * (g(r * phi.cos()) - d)
    };
    let sum: f64 = RULE.iter().map(|[x, weight]| weight * (at(half * (1.0 - x)) + at(half * (1.0 + x)))).sum();
    FRAC_2_PI * (FRAC_PI_2 * k).cos() * half * sum / (1.0 - k)
}

/// G(r, a)(g(a) − d) + ∫ G(r, x) dg(x) from a to r, where a flat strip of half-width x that is pressed in by 1 leaves the gap
/// G(r, x) = arcosh(sin(πr/λ)/sin(πx/λ))/ln(1/sin(πx/λ)).
fn beside_strip(period: f64, a: f64, d: f64, r: f64, g: &impl Fn(f64) -> f64) -> f64 {
    let sine = |x: f64| (PI * x / period).sin();
    let of_strip = |x: f64| (sine(r) / sine(x)).max(1.0).acosh() / -sine(x).ln();
    let steps = 40;
    let place = |i: u32| a + (r - a) * f64::from(i) / f64::from(steps);
    let grown = |i: u32| of_strip((place(i) + place(i + 1)) / 2.0) * (g(place(i + 1)) - g(place(i)));
    of_strip(a) * (g(a) - d) + (0..steps).map(grown).sum::<f64>()
}
