//! Derivatives in `f64`; `number_dual.rs` checks them in arbitrary precision.

use mdr_core::number::{Dual, Real, Special};
use num_traits::Inv;

/// First derivatives against their closed forms as written in a table. Both sides take at most four roundings of an
/// ulp, and 1 − x² at x = 0.6 amplifies that by x²/(1 − x²) < 1: 8 units in the last place at most.
#[test]
fn closed_forms_in_f64() {
    let x = 0.6_f64;
    let r = Dual::variable(x);
    let root = (1.0 - x * x).sqrt();
    for (name, f, derivative) in [
        ("square", r.square(), 1.2),
        ("sqrt", r.sqrt(), 0.5 / x.sqrt()),
        ("exp", r.exp(), x.exp()),
        ("exp_m1", r.exp_m1(), x.exp()),
        ("ln", r.ln(), 1.0 / x),
        ("ln_1p", r.ln_1p(), 1.0 / (1.0 + x)),
        ("powi", r.powi(5), 5.0 * x.powi(4)),
        ("pow", r.pow(&r.ratio(1, 4)), 0.25 * x.powf(-0.75)),
        ("power of x", r.lit(2).pow(&r), 2_f64.ln() * 2_f64.powf(x)),
        ("x^x", r.pow(&r), (x.ln() + 1.0) * x.powf(x)),
        ("inv", r.clone().inv(), -1.0 / (x * x)),
        ("quotient", r.exp() / &r, x.exp() * (x - 1.0) / (x * x)),
        ("abs", (-r.clone()).abs(), 1.0),
        ("times, over", r.clone().times(7).over(-2), -3.5),
        ("sin", r.sin(), x.cos()),
        ("cos", r.cos(), -x.sin()),
        ("atan", r.atan(), 1.0 / (1.0 + x * x)),
        ("asin", r.asin(), 1.0 / root),
        ("acos", r.acos(), -1.0 / root),
        ("atanh", r.atanh(), 1.0 / (1.0 - x * x)),
        ("sinh", r.sinh(), x.cosh()),
        ("cosh", r.cosh(), x.sinh()),
        ("tanh", r.tanh(), 1.0 / (x.cosh() * x.cosh())),
        ("log10", r.log10(), 1.0 / (x * 10_f64.ln())),
    ] {
        approx::assert_relative_eq!(f.slope, derivative, max_relative = 8.0 * f64::EPSILON);
        assert!(f.value.is_finite(), "{name}");
    }
}

#[test]
fn constants_have_no_slope() {
    let r = Dual::variable(2.0);
    for constant in [r.lit(3), r.pi(), r.ratio(1, 3), r.powi(0), r.unit_roundoff(), r.midpoint()] {
        assert_eq!(constant.slope, 0.0);
    }
}

/// Both at once are the two numbers that each gives by itself, at tiny and huge arguments too, and so are their slopes of two orders.
#[test]
fn sine_and_cosine_at_once_are_those_alone() {
    let large = (0..2000).map(|i| 0.37 * 1.02_f64.powi(i - 1000));
    for x in large.flat_map(|x| [x, -x]).chain([0.0, -0.0, 5e-324, f64::MAX]) {
        let (sin, cos) = x.sin_and_cos();
        assert_eq!([sin, cos].map(f64::to_bits), [Special::sin(&x), Special::cos(&x)].map(f64::to_bits), "{x}");
        let twice = Dual::variable(Dual::variable(x));
        let parts = |f: Dual<Dual<f64>>| [f.value.value, f.value.slope, f.slope.value, f.slope.slope].map(f64::to_bits);
        let (sin, cos) = twice.sin_and_cos();
        assert_eq!([sin, cos].map(parts), [twice.sin(), twice.cos()].map(parts), "{x}");
    }
}
