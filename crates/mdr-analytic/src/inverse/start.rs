//! The roots of Φ(v) = τ as doubles, to be refined in the arithmetic of the caller.
//!
//! With μ = m − 1 and D = (e^{μv} − 1)/μ, Φ = e^v D − (e^v − 1) and z = 1 − Φ = e^v(1 − D), so that μ → 0 costs no
//! digits. Halley's iteration is applied to Φ = τ near the fold, and far from it to v + ln|1 − D| = ln|z|, where
//! nothing overflows. Two evaluations per root usually suffice, five at scales of 10^±50.

/// The initial guess from τ alone, accurate to second order at the fold and to first order far from it. With t =
/// √(2τ/m):
///
/// * v > 0, from P = e^{mv} = 1 + μτ + m(E − 1): E − 1 = e^v − 1 = t + (2−m)t²/6 + (2m−1)(m−2)t³/72 + … near the fold,
///   with a denominator that keeps it bounded, because μτ dominates far from it.
/// * v < 0: ze^{−v} = 1 + t + (2−m)t²/3 + … near the fold, and m/μ far from it.
///
/// The error of v, over 2/(m + 1/|v|), is below a tenth for m from 1.5 to 16, and below one from 1.02 to 40.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InitialGuess {
    m: f64,
    mu: f64,
    /// t/√τ.
    width: f64,
    /// (e^v − 1)/t ≈ (1 + upper·t)/(1 + lower·t).
    upper: f64,
    lower: f64,
    /// The coefficients of τ and of τ√τ.
    second: f64,
    third: f64,
}

impl InitialGuess {
    #[inline]
    pub(crate) fn new(mu: f64) -> Self {
        let m = 1.0 + mu;
        let width = (2.0 / m).sqrt();
        // For m < 2, a quarter of the third-order coefficient is better for all t.
        let lower = if m < 2.0 { (2.0 * m - 1.0) / 48.0 } else { (m - 2.0) / 6.0 };
        let upper = lower + (2.0 - m) / 6.0;
        let second = (2.0 - m) / 3.0 * (2.0 / m);
        let third = (m / mu - 1.0 - width - second).min(3.0);
        InitialGuess { m, mu, width, upper, lower, second, third }
    }

    /// e^{mv} − 1 on the larger branch.
    #[inline(always)]
    pub(crate) fn growth(&self, tau: f64) -> f64 {
        let t = self.width * tau.sqrt();
        self.mu * tau + self.m * t * (1.0 + self.upper * t) / (1.0 + self.lower * t)
    }

    /// ze^{−v} on the smaller branch.
    #[inline(always)]
    pub(crate) fn quotient(&self, tau: f64) -> f64 {
        let root = tau.sqrt();
        1.0 + root * (self.width + root * (self.second + root * self.third))
    }
}

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

/// Below this value of m√(2τ/m) the initial formula is accurate to twice as many digits.
const CLOSE: f64 = 1e-4;

/// A step below this, relative to the scale of v, leaves an error of its cube.
const LAST_STEP: f64 = 1.0 / 2048.0;

/// More than enough: the iterations are monotone after the first step.
const MOST_STEPS: usize = 60;

impl Seed {
    /// v > 0.
    #[inline]
    pub(crate) fn larger(&self) -> f64 {
        let m = 1.0 + self.mu;
        let t = (2.0 * self.tau / m).sqrt();
        if m * t < CLOSE {
            return t - (m + 1.0) * t * t / 6.0;
        }
        let growth = InitialGuess::new(self.mu).growth(self.tau);
        let mut v = if growth.is_finite() { pxfm::f_log1p(growth) / m } else { (self.ln_z + self.mu.ln()) / m };
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
        let t = (2.0 * self.tau / m).sqrt();
        if m * t < CLOSE {
            return -t - (m + 1.0) * t * t / 6.0;
        }
        let mut v = self.ln_z - pxfm::f_log(InitialGuess::new(self.mu).quotient(self.tau));
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
