//! A contact as doubles, and its equilibria over MPFR by bisection.

use mdr_analytic::{PowerLaw, PowerLawContact, double};
use mdr_core::contact::{Control, Material};
use rug::Float;
use rug::float::Constant;

use crate::common::coefficient_for;
use crate::common::mpfr::ln_kappa;

pub(crate) const BITS: u32 = 400;

pub(crate) fn float(value: f64) -> Float {
    Float::with_val(BITS, value)
}

/// A contact as doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    pub(crate) n: f64,
    pub(crate) c: f64,
    pub(crate) e: f64,
    pub(crate) w: f64,
    /// Whether the force is held and not the indentation depth.
    pub(crate) by_force: bool,
}

impl Scene {
    /// The contact whose fold is near the radius a.
    pub(crate) fn with_fold(n: f64, a: f64, e: f64, w: f64, by_force: bool) -> Self {
        let c = coefficient_for(a, n, e, w, if by_force { 3.0 } else { 1.0 });
        Scene { n, c, e, w, by_force }
    }

    pub(crate) fn control<R>(&self) -> Control<R> {
        if self.by_force { Control::Force } else { Control::Indentation }
    }

    pub(crate) fn material(&self) -> Material<f64> {
        Material::new(self.e, self.w).unwrap()
    }

    pub(crate) fn contact<R: mdr_analytic::Kappa>(&self, ctx: R::Ctx) -> PowerLawContact<R> {
        let number = |x| R::from_f64(ctx, x);
        let profile = PowerLaw::new(number(self.n), number(self.c)).unwrap();
        PowerLawContact::new(profile, Material::new(number(self.e), number(self.w)).unwrap())
    }

    pub(crate) fn inverse(&self) -> double::Inverse {
        double::Inverse::new(self.n, self.c, &self.material(), &self.control()).unwrap()
    }

    pub(crate) fn truth(self) -> Truth {
        let ln_factor = ln_kappa(&float(self.n)) + float(self.c).ln();
        let critical_ratio = float(if self.by_force { 3.0 } else { 1.0 });
        let ln_edge = (Float::with_val(BITS, Constant::Pi) / 2u32 * self.w / self.e).ln();
        let ln_slope = ln_factor.clone() + float(self.n).ln();
        let ln_fold = (ln_edge + (critical_ratio.ln() - ln_slope) * 2u32) / (float(self.n) * 2u32 - 1u32);
        Truth { scene: self, ln_factor, ln_fold }
    }
}

/// A contact over MPFR.
pub(crate) struct Truth {
    pub(crate) scene: Scene,
    /// ln κC.
    ln_factor: Float,
    /// ln of the radius of the fold.
    pub(crate) ln_fold: Float,
}

impl Truth {
    /// g, Δl and a at e^ln_a.
    pub(crate) fn terms(&self, ln_a: &Float) -> [Float; 3] {
        let Scene { n, e, w, .. } = self.scene;
        let g = (self.ln_factor.clone() + ln_a.clone() * n).exp();
        let a = ln_a.clone().exp();
        let elongation = (Float::with_val(BITS, Constant::Pi) * 2u32 * w / e * &a).sqrt();
        [g, elongation, a]
    }

    /// d and F at e^ln_a.
    pub(crate) fn state(&self, ln_a: &Float) -> [Float; 2] {
        let [g, elongation, a] = self.terms(ln_a);
        let pressed = g.clone() * self.scene.n / (float(self.scene.n) + 1u32);
        [g - &elongation, (pressed - elongation) * 2u32 * self.scene.e * a]
    }

    pub(crate) fn held(&self, ln_a: &Float) -> Float {
        let [d, f] = self.state(ln_a);
        if self.scene.by_force { f } else { d }
    }

    /// dx/d ln a.
    pub(crate) fn slope(&self, ln_a: &Float) -> Float {
        let [g, elongation, a] = self.terms(ln_a);
        let pressed = g * self.scene.n;
        if self.scene.by_force {
            (pressed - elongation * 1.5f64) * 2u32 * self.scene.e * a
        } else {
            pressed - elongation / 2u32
        }
    }

    pub(crate) fn at_fold(&self) -> f64 {
        self.held(&self.ln_fold).to_f64()
    }

    /// ln a of the equilibria, by increasing radius: a bracket on either side of the fold, halved, and Newton's method.
    pub(crate) fn equilibria(&self, value: f64) -> Vec<Float> {
        let below = self.held(&self.ln_fold) < value;
        let side = |outwards: i32| {
            let (mut near, mut far) = (self.ln_fold.clone(), self.ln_fold.clone() + outwards);
            let mut step = outwards;
            while (self.held(&far) < value) == below {
                step *= 2;
                far += step;
                if step.abs() > 1 << 20 {
                    return None;
                }
            }
            for _ in 0..60 {
                let middle = Float::with_val(BITS, &near + &far) / 2u32;
                if (self.held(&middle) < value) == below {
                    near = middle;
                } else {
                    far = middle;
                }
            }
            for _ in 0..8 {
                let step = (self.held(&far) - value) / self.slope(&far);
                far -= step;
            }
            Some(far)
        };
        [-1, 1].into_iter().filter_map(side).collect()
    }
}
