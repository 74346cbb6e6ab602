//! The roots of Φ(v) = τ as doubles, for the arithmetic of the caller to refine.
//!
//! With μ = m − 1 and D = (e^{μv} − 1)/μ, Φ = e^v D − (e^v − 1) and z = 1 − Φ = e^v(1 − D), so that μ → 0 costs no digits.
//! Near the fold Halley's iteration is for Φ = τ; far from it for v + ln|1 − D| = ln|z|, where nothing overflows. Two
//! evaluations a root suffice as a rule, five at scales of 10^±50.

/// A point of the family, in `f64`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seed {
    /// m − 1 > 0.
    pub(crate) mu: f64,
    /// τ > 0.
    pub(crate) tau: f64,
    /// z = 1 − τ.
    pub(crate) z: f64,
    /// ln|z|, also where z is out of range.
    pub(crate) ln_z: f64,
}

/// Below this value of m√(2τ/m) the formula to start from is right to twice as many digits.
const CLOSE: f64 = 1e-4;

/// Steps below this, relative to the scale of v, leave an error of their cube.
const LAST_STEP: f64 = 1.0 / 2048.0;

/// More than enough: the iterations are monotone after the first step.
const MOST_STEPS: usize = 60;

impl Seed {
    /// v > 0.
    #[inline]
    pub(crate) fn larger(&self) -> f64 {
        let m = 1.0 + self.mu;
        let t = (2.0 * self.tau / m).sqrt();
        // e^{mv} = 1 + mt + m(2m−1)t²/6 + … near the fold, and of this order far from it.
        let power = m * t * (1.0 + t * (2.0 * m - 1.0) / 6.0);
        let mut v =
            if power.is_finite() { pxfm::f_log1p(power) / m } else { (self.ln_z + ((2.0 * m - 1.0) / 3.0).ln()) / m };
        if m * t < CLOSE {
            return v;
        }
        for _ in 0..MOST_STEPS {
            let step = if self.z > -1.0 { self.step(v) } else { self.log_step(v) };
            v = if step < v { v - step } else { v / 2.0 };
            if !(m * step.abs() > LAST_STEP * (m * v).min(1.0)) {
                break;
            }
        }
        v
    }

    /// v < 0, for τ < 1.
    #[inline]
    pub(crate) fn smaller(&self) -> f64 {
        let m = 1.0 + self.mu;
        let root = self.tau.sqrt();
        let t = (2.0 / m).sqrt() * root;
        // z e^{−v} = 1 + t + (2−m)t²/3 + … near the fold, and m/μ far from it.
        let second = (2.0 - m) / 3.0;
        let last = (m / self.mu - 1.0 - t / root - second * 2.0 / m).min(3.0);
        let denominator = 1.0 + t + second * t * t + last * self.tau * root;
        let mut v = self.ln_z - pxfm::f_log(denominator);
        if m * t < CLOSE {
            return -t - (m + 1.0) * t * t / 6.0;
        }
        v = v.min(-t / 2.0);
        for _ in 0..MOST_STEPS {
            let step = if v > -0.5 { self.step(v) } else { self.log_step(v) };
            v = if -step < -v { v - step } else { v / 2.0 };
            if !(step.abs() > LAST_STEP * (-v).min(1.0)) {
                break;
            }
        }
        v
    }

    /// Halley's step of Φ − τ.
    #[inline]
    fn step(&self, v: f64) -> f64 {
        let m = 1.0 + self.mu;
        let d = self.growth(v);
        let less_one = pxfm::f_expm1(v);
        let power = 1.0 + less_one;
        halley(power * d - less_one - self.tau, m * power * d, m * power * (1.0 + m * d))
    }

    /// Halley's step of v + ln|1 − D| − ln|z|.
    #[inline]
    fn log_step(&self, v: f64) -> f64 {
        let m = 1.0 + self.mu;
        let d = self.growth(v);
        if !d.is_finite() {
            // D is e^{μv}/μ and more.
            return (m * v - self.mu.ln() - self.ln_z) / m;
        }
        let rest = 1.0 - d;
        let slope = -m * d / rest;
        halley(v + pxfm::f_log(rest.abs()) - self.ln_z, slope, -m * (1.0 + self.mu * d) / (rest * rest))
    }

    /// D.
    #[inline]
    fn growth(&self, v: f64) -> f64 {
        pxfm::f_expm1(self.mu * v) / self.mu
    }
}

/// f/f' · 1/(1 − ff''/2f'²).
#[inline]
fn halley(value: f64, slope: f64, curvature: f64) -> f64 {
    let newton = value / slope;
    newton / (1.0 - 0.5 * newton * curvature / slope)
}
