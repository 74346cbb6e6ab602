//! Cube roots of pairs.

use mdr_core::number::{Extended, Real};

use super::*;
use crate::double::pair::{Fused, Separate};

/// Over all significands of ten bits with three exponents modulo 3, and far from 1.
fn check<A: Arithmetic>(arithmetic: A) {
    for exponent in [0, 1, 2, -1, -400, 401, 399] {
        for k in 0..1024 {
            let hi = (1.0 + f64::from(k) / 1024.0) * 2f64.powi(exponent);
            let x = Pair { hi, lo: hi * 2f64.powi(-54) / 3.0 };
            let root = cube_root(arithmetic, x);
            let wide = |x: Pair| Extended::<2>::from(x.hi) + Extended::from(x.lo);
            let (root, x) = (wide(root), wide(x));
            let error = ((root * root * root - x) / x / x.lit(3)).approx().abs();
            assert!(error < PAIR, "{} of {:e}", error / PAIR, x.approx());
        }
    }
}

#[test]
fn a_cube_root_is_as_good_as_a_pair() {
    check(Fused);
    check(Separate);
}
