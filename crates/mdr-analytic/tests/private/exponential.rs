//! What is private in `mdr_analytic::double::exponential`.

use mdr_core::number::{Extended, Real};

use super::*;
use crate::double::pair::{Fused, Separate};

fn wide(x: Pair) -> Extended<4> {
    Extended::from(x.hi) + Extended::from(x.lo)
}

fn relative(found: Extended<4>, truth: Extended<4>) -> f64 {
    ((found - truth) / truth).approx().abs()
}

#[test]
fn the_table_and_the_step() {
    let ln_2 = Extended::<4>::from(2.0).ln();
    assert!(relative(wide(STEP), ln_2.over(64)) < 2f64.powi(-90));
    for j in 0..64 {
        let truth = ln_2.times(j as i64).over(64).exp();
        assert!(relative(wide(Pair { hi: HIGH[j], lo: LOW[j] }), truth) < 2f64.powi(-105), "{j}");
    }
}

/// Between and at the ends of the steps; the errors reach an eighth of the bound.
fn worst<A: Arithmetic>(arithmetic: A) -> [f64; 3] {
    let mut worst = [0.0f64; 3];
    for i in 0..20_000 {
        let hi = (f64::from(i) * 0.618_033_988_749_894_9 + 0.25).fract() * [2.0, 0.01, 1300.0][i as usize % 3];
        let hi = hi - [1.0, 0.005, 650.0][i as usize % 3];
        let x = Pair { hi, lo: hi * 2f64.powi(-54) * f64::from(i % 16 - 8) / 8.0 };
        let truth = wide(x).exp();
        worst[0] = worst[0].max(relative(wide(exponential(arithmetic, x)), truth));
        let truth = Extended::<4>::from(hi).exp();
        let rough = relative(Extended::from(rough_exponential::<A>(hi)), truth) / (2.0 + hi.abs());
        worst[1] = worst[1].max(rough);
        let x = (hi / 2.0).exp();
        let truth = Extended::<4>::from(x).ln();
        worst[2] = worst[2].max(relative(Extended::from(rough_logarithm::<A>(x)), truth));
    }
    worst
}

#[test]
fn errors_stay_within_the_bounds() {
    for [precise, rough, logarithm] in [worst(Fused), worst(Separate)] {
        assert!(precise < ERROR && precise > ERROR / 8.0, "2^{}", precise.log2());
        assert!(rough < f64::EPSILON / 2.0, "{rough:e}");
        assert!(logarithm < 1e-7, "{logarithm:e}");
    }
}

/// Within 6 roundings up to the end of a step, where the last term is as large as that.
#[test]
fn no_term_of_the_cubic_is_missing() {
    let end = std::f64::consts::LN_2 / 128.0;
    for i in 0..2000 {
        let r = end * (1.0 - f64::from(i) / 20_000.0) * f64::from(1 - i % 2 * 2);
        let square = r * r;
        let wide_r = Extended::<4>::from(r);
        let truth = wide_r.exp_m1() - wide_r - wide_r.square().over(2);
        for found in [cubic::<Fused>(r, square), cubic::<Separate>(r, square)] {
            assert!(relative(Extended::from(found), truth) < 3.0 * f64::EPSILON, "{r}");
        }
    }
}
