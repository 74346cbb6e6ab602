//! `Real` for `f64`: elementary functions and the Gamma family from `pxfm` (worst error below one ulp), √x and |x| from
//! the standard library.

use super::{Gamma, Literal, Real, Special};

impl Real for f64 {
    type Ctx = ();

    fn ctx(&self) {}
    fn from_int((): (), value: i64) -> f64 {
        value as f64
    }
    fn from_f64((): (), value: f64) -> f64 {
        value
    }
    fn from_literal((): (), literal: &Literal) -> f64 {
        literal.nearest_f64()
    }
    fn pi(&self) -> f64 {
        std::f64::consts::PI
    }
    fn times(self, k: i64) -> f64 {
        self * k as f64
    }
    fn over(self, k: i64) -> f64 {
        self / k as f64
    }
    fn abs(&self) -> f64 {
        f64::abs(*self)
    }
    fn square(&self) -> f64 {
        self * self
    }
    fn sqrt(&self) -> f64 {
        f64::sqrt(*self)
    }
    fn exp(&self) -> f64 {
        pxfm::f_exp(*self)
    }
    fn exp_m1(&self) -> f64 {
        pxfm::f_expm1(*self)
    }
    fn ln(&self) -> f64 {
        pxfm::f_log(*self)
    }
    fn ln_1p(&self) -> f64 {
        pxfm::f_log1p(*self)
    }
    fn pow(&self, exponent: &f64) -> f64 {
        pxfm::f_pow(*self, *exponent)
    }
    fn powi(&self, exponent: i64) -> f64 {
        pxfm::f_pow(*self, exponent as f64)
    }
    fn precision(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }
    fn unit_roundoff(&self) -> f64 {
        f64::EPSILON / 2.0
    }
    fn approx(&self) -> f64 {
        *self
    }
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
}

impl Special for f64 {
    fn sin(&self) -> f64 {
        pxfm::f_sin(*self)
    }
    fn cos(&self) -> f64 {
        pxfm::f_cos(*self)
    }
    fn atan(&self) -> f64 {
        pxfm::f_atan(*self)
    }
    fn asin(&self) -> f64 {
        pxfm::f_asin(*self)
    }
    fn acos(&self) -> f64 {
        pxfm::f_acos(*self)
    }
    fn sinh(&self) -> f64 {
        pxfm::f_sinh(*self)
    }
    fn cosh(&self) -> f64 {
        pxfm::f_cosh(*self)
    }
    fn tanh(&self) -> f64 {
        pxfm::f_tanh(*self)
    }
    fn log10(&self) -> f64 {
        pxfm::f_log10(*self)
    }
    fn atanh(&self) -> f64 {
        pxfm::f_atanh(*self)
    }
}

impl Gamma for f64 {
    fn gamma(&self) -> f64 {
        pxfm::f_tgamma(*self)
    }
    fn ln_gamma(&self) -> f64 {
        pxfm::f_lgamma(*self)
    }
    fn digamma(&self) -> f64 {
        pxfm::f_digamma(*self)
    }
}
