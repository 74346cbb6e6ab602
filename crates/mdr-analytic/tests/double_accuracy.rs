//! The `f64` closed forms against an independent computation in MPFR, with its own Γ.
//!
//! The limit is the guaranteed 1 ulp, or 0.625 ulp where the error bound of one word is known to be below 2⁻⁵⁶.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

use mdr_analytic::{State, double};
use mdr_core::contact::{Control, Material, Ranged};
use proptest::prelude::*;
use rug::Float;
use rug::float::Constant;

use crate::common::coefficient_for;
use crate::common::mpfr::{ln_kappa, ulps};

const BITS: u32 = 700;

fn float(value: f64) -> Float {
    Float::with_val(BITS, value)
}

/// A sign and the logarithm of a magnitude, which may be far beyond the range of any arithmetic.
struct Truth {
    sign: i32,
    ln: Float,
}

impl Truth {
    /// factor · e^ln.
    fn new(factor: Float, ln: Float) -> Self {
        let sign = factor.cmp0().map_or(0, |order| order as i32);
        Truth { sign, ln: if sign == 0 { ln } else { ln + factor.abs().ln() } }
    }

    /// The error in units in the last place of the truth.
    fn ulps(&self, value: f64) -> f64 {
        ulps(value, &(self.ln.clone().exp() * self.sign))
    }

    #[track_caller]
    fn check(&self, answer: Ranged<f64>, allowed: f64, what: &str) {
        let ln_10 = float(10.0).ln();
        match answer {
            Ranged::Value(value) if self.sign == 0 => assert_eq!(value, 0.0, "{what}"),
            Ranged::Value(value) => {
                assert!(self.ulps(value) <= allowed, "{what} = {value:e} is {} ulp off", self.ulps(value));
            }
            Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => {
                let truth = Float::with_val(BITS, &self.ln / ln_10).to_f64();
                assert!((log10 / truth - 1.0).abs() < 1e-12, "{what}: log10 {log10} against {truth}");
                let (low, high) = (-1075.0 * 2f64.log10(), 1024.0 * 2f64.log10());
                let beyond = matches!(answer, Ranged::Overflow { .. });
                assert!(if beyond { truth > high - 1e-12 } else { truth < low + 1e-12 }, "{what}: {truth} is in range");
            }
        }
    }
}

/// The critical state for λ = 1 (indentation) or 3 (force).
fn critical(n: f64, c: f64, e: f64, w: f64, critical_ratio: u32) -> State<Truth> {
    let n = float(n);
    let ln_edge = (Float::with_val(BITS, Constant::Pi) / 2u32).ln() + float(w).ln() - float(e).ln();
    let ln_slope = ln_kappa(&n) + float(c).ln() + n.clone().ln();
    let excess = Float::with_val(BITS, &n * 2u32) - 1u32;
    let ln_a = (ln_edge.clone() + (float(critical_ratio.into()).ln() - ln_slope) * 2u32) / excess;
    let ln_root = (ln_edge + &ln_a) / 2u32;
    let next = Float::with_val(BITS, &n + 1u32);
    let d_factor = (critical_ratio - Float::with_val(BITS, &n * 2u32)) / &n;
    let f_factor = (critical_ratio - Float::with_val(BITS, &next * 2u32)) * 2u32 / next;
    State {
        indentation: Truth::new(d_factor, ln_root.clone()),
        force: Truth::new(f_factor, ln_root + &ln_a + float(e).ln()),
        contact_radius: Truth { sign: 1, ln: ln_a },
    }
}

#[track_caller]
fn check(n: f64, c: f64, e: f64, w: f64, allowed: f64) {
    let material = Material::new(e, w).unwrap();
    for (control, critical_ratio) in [(Control::Indentation, 1), (Control::Force, 3)] {
        let truth = critical(n, c, e, w, critical_ratio);
        let answer = double::critical(n, c, &material, &control).unwrap();
        let what = |name| format!("{name} under {control:?} at n = {n:e}, C = {c:e}, E* = {e:e}, w = {w:e}");
        truth.contact_radius.check(answer.contact_radius, allowed, &what("a"));
        truth.indentation.check(answer.indentation, allowed, &what("d"));
        truth.force.check(answer.force, allowed, &what("F"));
    }
}

#[test]
fn kappa_over_all_magnitudes() {
    let mut worst: f64 = 0.0;
    let tiny = [5e-324, 1e-300, 1e-17, 1e-6];
    let dense = (1..3000).map(|i| f64::from(i) * 0.023);
    let near_half = (1..=53).flat_map(|k| [0.5 + 2f64.powi(-k), 0.5 - 2f64.powi(-k - 1)]);
    let edges = (0..7).flat_map(|b| [-1.0, 0.0, 1.0].map(|ulp| 2f64.powi(b) * (1.0 + ulp * f64::EPSILON) - 1.0));
    let large = (0..30).map(|k| 60.0 * 3.7f64.powi(k)).chain([1e16, 1e100, f64::MAX]);
    for n in tiny.into_iter().chain(dense).chain(near_half).chain(edges).chain(large).filter(|&n| n > 0.0) {
        // Beyond 10¹⁰⁰ the two logarithms cancel too much, and κ = √(πn/2)(1 + 1/(4n) + …).
        let ln =
            if n < 1e99 { ln_kappa(&float(n)) } else { (Float::with_val(BITS, Constant::Pi) * n / 2u32).ln() / 2u32 };
        let kappa = double::kappa(n).unwrap();
        assert!(kappa.is_finite(), "n = {n}");
        worst = worst.max(Truth { sign: 1, ln }.ulps(kappa));
    }
    // 2⁻⁵³ of rounding and 6 units of 2⁻⁶⁴.
    assert!(worst <= 0.51, "{worst} ulp");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 400 / 256))]

    #[test]
    fn ordinary_points(n in 0.05..4.0f64, e in 3.0..11.0f64, w in -3.0..0.0f64, a in -8.0..-1.0f64) {
        let (e, w) = (10f64.powf(e), 10f64.powf(w));
        // One word has a bound of 256 units here: |ln a| < 19 and 1/|2n−1| < 3.
        let allowed = if (n - 0.5).abs() > 0.17 { 0.625 } else { 1.0 };
        check(n, coefficient_for(10f64.powf(a), n, e, w, 1.0), e, w, allowed);
    }

    #[test]
    fn any_scales(n in -7.0..16.0f64, c in -200.0..200.0f64, e in -200.0..200.0f64, w in -100.0..100.0f64) {
        check(10f64.powf(n), 10f64.powf(c), 10f64.powf(e), 10f64.powf(w), 1.0);
    }

    #[test]
    fn any_representable_radius(n in 0.01..30.0f64, e in -150.0..150.0f64, w in -30.0..30.0f64, scale in -150.0..150.0f64) {
        // C scales as a^(1/2−n) and must stay a double itself.
        let a = (scale / (n - 0.5).abs()).clamp(-320.0, 300.0);
        let (e, w) = (10f64.powf(e), 10f64.powf(w));
        check(n, coefficient_for(10f64.powf(a), n, e, w, 1.0), e, w, 1.0);
    }

    #[test]
    fn curves(n in 0.02..5.0f64, a in -9.0..3.0f64, e in -3.0..12.0f64, c in -4.0..4.0f64, ratio in 0.5..2.0f64) {
        let (a, e, c) = (10f64.powf(a), 10f64.powf(e), 10f64.powf(c));
        curves_at(n, c, e, 0.05, a);
        // Near the zero of d(a), as close to it as doubles allow.
        let zero = (2.0 / (n * 2.0)).powf(-1.0 / (n - 0.5)) * critical(n, c, e, 0.05, 1).contact_radius.ln.to_f64().exp();
        prop_assume!(zero.is_normal());
        for a in [zero * ratio, zero, zero * (1.0 + f64::EPSILON)] {
            curves_at(n, c, e, 0.05, a);
        }
    }
}

/// d(a) and F(a) with their cancellation.
fn curves_at(n: f64, c: f64, e: f64, w: f64, a: f64) {
    let material = Material::new(e, w).unwrap();
    let elongation = (Float::with_val(BITS, Constant::Pi) * 2u32 * w / e * a).sqrt();
    let g = (ln_kappa(&float(n)) + float(a).ln() * n).exp() * c;
    let next = float(n) + 1u32;
    let truth = |value: Float| Truth::new(value, float(0.0));
    let d = Float::with_val(BITS, &g - &elongation);
    let f = (Float::with_val(BITS, &g * n) / &next - &elongation) * 2u32 * e * a;
    let what = |name| format!("{name} at n = {n:e}, C = {c:e}, E* = {e:e}, a = {a:e}");
    truth(d).check(double::indentation(n, c, &material, a).unwrap(), 1.0, &what("d"));
    truth(f).check(double::force(n, c, &material, a).unwrap(), 1.0, &what("F"));
    truth(g.clone()).check(double::g(n, c, a).unwrap(), 1.0, &what("g"));
    truth(g.clone() * n / a).check(double::g_slope(n, c, a).unwrap(), 1.0, &what("g'"));
    truth(g * a / next).check(double::g_integral(n, c, a).unwrap(), 1.0, &what("G"));
    truth(elongation).check(double::detachment_elongation(&material, a).unwrap(), 1.0, &what("Δl"));
}

/// n = 1/2 ± 2⁻ᵏ. C is the double nearest to √B a^{1/2−n}/(nκ), whose rounding alone moves a by a factor e^{±2ᵏ⁻⁵³}: in
/// range down to k = 50 and beyond. (Below |2n−1| = 2⁻⁴⁹ a far exponent leaves 2⁶², see the module.)
#[test]
fn ladder_towards_one_half() {
    let (mut representable, mut all) = (0, 0);
    for k in 2..=53 {
        for n in [0.5 + 2f64.powi(-k), 0.5 - 2f64.powi(-k)] {
            for (e, w, a) in [(1e6, 0.05, 1e-3), (1e200, 1e-100, 1e-40), (3e-180, 7e90, 1e50), (1.0, 1.0, 1.0)] {
                let c = coefficient_for(a, n, e, w, 1.0);
                check(n, c, e, w, 1.0);
                let answer = double::critical(n, c, &Material::new(e, w).unwrap(), &Control::Indentation).unwrap();
                representable += u32::from(matches!(answer.contact_radius, Ranged::Value(_)));
                all += 1;
                // Far from the threshold: beyond the range, with a logarithm.
                check(n, 3.0 * c, e, w, 1.0);
                if k <= 50 {
                    check(n, 1e150 * c, e, w, 1.0);
                }
            }
        }
    }
    assert!(representable > 3 * all / 4, "{representable} of {all} are representable");
}

#[test]
fn extreme_scales_and_exponents() {
    for n in [1e-300, 1e-17, 1e-6, 0.3, 0.4999, 0.51, 1.0, 2.0, 7.5, 1e3, 1e6, 1e16] {
        for (c, e, w) in [
            (1e200, 1e200, 1e-100),
            (1e-200, 1e-200, 1e100),
            (5e-324, f64::MAX, 5e-324),
            (1e300, 1e-300, 1e300),
            (1.0, 1.0, 1.0),
        ] {
            check(n, c, e, w, 1.0);
        }
    }
}

#[test]
fn subnormal_results() {
    // a from the largest subnormal down to the smallest and below, for a cone: a = B/N².
    let mut subnormal = 0;
    for k in 0..60 {
        let (e, w) = (1.7e300, 1.3e-5 * 0.37f64.powi(k));
        check(1.0, 1.1e4, e, w, 1.0);
        check(2.0, 3.3e250 * 0.7f64.powi(k), e, w, 1.0);
        let answer = double::critical(1.0, 1.1e4, &Material::new(e, w).unwrap(), &Control::Force).unwrap();
        subnormal += u32::from(matches!(answer.contact_radius, Ranged::Value(a) if a.is_subnormal()));
    }
    assert!(subnormal > 20, "{subnormal}");
}

#[test]
fn universal_curves_with_cancellation() {
    for n in [0.02, 0.25, 0.5 - 2f64.powi(-30), 0.5 + 2f64.powi(-50), 0.75, 1.0, 2.0, 3.3, 40.0] {
        for ratio in [1e-12, 0.9, 1.0 + f64::EPSILON, 1.7, 4.0, 16.0, 16.0 - 4.0 * f64::EPSILON, 1e5] {
            let (power, excess) =
                (float(ratio).ln() * (float(n) - 0.5f64), Float::with_val(BITS, float(n) * 2u32) - 1u32);
            let root = float(ratio).sqrt();
            let d = (power.clone().exp() - 1u32 - &excess) * &root / excess.clone().abs();
            let f = (power.exp() - 2u32 - float(n) * 2u32) * root * ratio / (excess + 2u32);
            let what = format!("n = {n:e}, ã = {ratio:e}");
            Truth::new(d, float(0.0)).check(double::universal_indentation(n, ratio).unwrap(), 1.0, &what);
            Truth::new(f, float(0.0)).check(double::universal_force(n, ratio).unwrap(), 1.0, &what);
        }
    }
}
