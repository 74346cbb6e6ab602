//! `Real` for `f64`: elementary functions and the Gamma family from `pxfm` (worst error below one ulp), √x and |x| from
//! the standard library.

use super::{Gamma, Literal, Real, Special};

/// Functions of one number, each with its name in `pxfm`.
macro_rules! functions {
    ($($name:ident: $function:ident),*) => {$(
        #[inline]
        fn $name(&self) -> f64 {
            pxfm::$function(*self)
        }
    )*};
}

impl Real for f64 {
    type Ctx = ();

    #[inline]
    fn ctx(&self) {}
    #[inline]
    fn from_int((): (), value: i64) -> f64 {
        value as f64
    }
    #[inline]
    fn from_f64((): (), value: f64) -> f64 {
        value
    }
    #[inline]
    fn from_literal((): (), literal: &Literal) -> f64 {
        literal.nearest_f64()
    }
    #[inline]
    fn pi(&self) -> f64 {
        std::f64::consts::PI
    }
    #[inline]
    fn times(self, k: i64) -> f64 {
        self * k as f64
    }
    #[inline]
    fn over(self, k: i64) -> f64 {
        self / k as f64
    }
    #[inline]
    fn abs(&self) -> f64 {
        f64::abs(*self)
    }
    #[inline]
    fn square(&self) -> f64 {
        self * self
    }
    #[inline]
    fn sqrt(&self) -> f64 {
        f64::sqrt(*self)
    }
    functions!(exp: f_exp, exp_m1: f_expm1, ln: f_log, ln_1p: f_log1p);
    #[inline]
    fn pow(&self, exponent: &f64) -> f64 {
        pxfm::f_pow(*self, *exponent)
    }
    #[inline]
    fn powi(&self, exponent: i64) -> f64 {
        pxfm::f_pow(*self, exponent as f64)
    }
    #[inline]
    fn precision(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }
    #[inline]
    fn unit_roundoff(&self) -> f64 {
        f64::EPSILON / 2.0
    }
    #[inline]
    fn approx(&self) -> f64 {
        *self
    }
    #[inline]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
}

impl Special for f64 {
    functions!(sin: f_sin, cos: f_cos, atan: f_atan, asin: f_asin, acos: f_acos);
    #[inline]
    fn sin_and_cos(&self) -> (f64, f64) {
        pxfm::f_sincos(*self)
    }
    functions!(sinh: f_sinh, cosh: f_cosh, tanh: f_tanh, atanh: f_atanh, log10: f_log10);
}

impl Gamma for f64 {
    functions!(gamma: f_tgamma, ln_gamma: f_lgamma, digamma: f_digamma);
}
