//! Exponents whose equation is quadratic, where thousands of values may be compared with its roots in MPFR: JKR under a dead load, and the
//! cone and n = 1/4 at given depths.

use mdr_analytic::double::grid::InstructionSet;
use mdr_analytic::double::{self, BranchSlices};
use mdr_core::contact::{Control, Material, Quantity, Status};
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};
use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;

use crate::common::mpfr::{ln_kappa, ulps};

const BITS: u32 = 240;
const VALUES: usize = 512;

fn float(x: f64) -> Float {
    Float::with_val(BITS, x)
}

struct Case {
    n: f64,
    c: f64,
    material: Material<f64>,
    control: Control<f64>,
}

impl Case {
    fn random(random: &mut SmallRng, n: f64, control: Control<f64>) -> Self {
        let mut draw = |from: f64, to: f64| 10f64.powf(random.random_range(from..to));
        let (c, e_star, work) = (draw(-3.0, 6.0), draw(2.0, 12.0), draw(-4.0, 1.0));
        Case { n, c, material: Material::new(e_star, work).unwrap(), control }
    }

    /// Values from close to the fold on, to both sides of zero where the stable branch extends there.
    fn values(&self, random: &mut SmallRng) -> Vec<f64> {
        let fold = double::critical(self.n, self.c, &self.material, &self.control).unwrap();
        let held = if self.control == Control::Force { fold.force } else { fold.indentation };
        let at_fold = held.value(Quantity::Force).unwrap();
        let mut place = |index: usize| {
            let share: f64 = random.random_range(0.0..1.0);
            match index % 3 {
                0 => 1.0 - 10f64.powf(-11.5 * share),
                1 => share,
                _ if self.n > 0.5 => -10f64.powf(16.0 * share - 6.0),
                _ => 10f64.powf(-9.0 * share),
            }
        };
        (0..VALUES).map(|index| at_fold * place(index)).collect()
    }

    /// a, and d or F, of the stable state: y with A y² − B y = x is √a³ or, at a given depth, √a or √a of n = 1/4, of whose roots
    /// that of the depth A√y − B√a… is asked in √a.
    fn exact(&self, x: f64) -> [Float; 2] {
        let [n, c, e, w] =
            [self.n, self.c, *self.material.effective_modulus(), *self.material.work_of_adhesion()].map(float);
        let x = float(x);
        let pi = Float::with_val(BITS, Constant::Pi);
        let kc = ln_kappa(&n).exp() * &c;
        let tension = (Float::with_val(BITS, 2u32) * &pi * &w / &e).sqrt();
        if self.control == Control::Force {
            // F = (8/3)E*C·2·a³/2 − √(8πwE*)·√a³ with κ = 2.
            let leading = float(8.0) * &e * &c / 3u32;
            let middle = (float(8.0) * &pi * &w * &e).sqrt();
            let root = larger_root(&leading, &middle, &x);
            let a = root.square().cbrt();
            let d = kc * Float::with_val(BITS, a.square_ref()) - tension * Float::with_val(BITS, a.sqrt_ref());
            return [a, d];
        }
        let a = if self.n == 1.0 {
            larger_root(&kc, &tension, &x).square()
        } else {
            // d = κC q − T q² with q = a^(1/4): the smaller root q of T q² − κC q + d = 0, without cancellation.
            let discriminant = Float::with_val(BITS, kc.square_ref()) - float(4.0) * &tension * &x;
            (Float::with_val(BITS, &x * 2u32) / (kc.clone() + discriminant.sqrt())).pow(4u32)
        };
        let mean = kc * Float::with_val(BITS, a.clone().pow(&n)) / (n + 1u32);
        let f = float(2.0) * &e * &a * (x - mean);
        [a, f]
    }
}

/// The larger root of A y² − B y − x.
fn larger_root(a: &Float, b: &Float, x: &Float) -> Float {
    let discriminant = Float::with_val(BITS, b.square_ref()) + float(4.0) * a * x;
    (discriminant.sqrt() + b) / a / 2u32
}

/// Every value within an ulp, with all instructions, and none of them in extended precision.
#[test]
fn roots_of_quadratic_equations() {
    let random = &mut SmallRng::seed_from_u64(36);
    let laws = [(2.0, Control::Force), (1.0, Control::Indentation), (0.25, Control::Indentation)];
    for (n, control) in laws.iter().cycle().take(24) {
        let case = Case::random(random, *n, control.clone());
        let values = case.values(random);
        let exact: Vec<[Float; 2]> = values.iter().map(|value| case.exact(*value)).collect();
        for path in InstructionSet::available() {
            let inverse =
                double::Inverse::new(case.n, case.c, &case.material, control).unwrap().with_instructions(path);
            let ([mut a, mut other], mut status) = ([[0.0; VALUES]; 2], [Status::Undecided; VALUES]);
            let found = &mut BranchSlices { contact_radius: &mut a, uncontrolled: &mut other };
            let report = inverse.stable(&values, found, &mut status).unwrap();
            assert_eq!((report.passed_on, report.without_value), (0, 0), "n = {n} by {path}");
            for (i, exact) in exact.iter().enumerate() {
                let worst = ulps(a[i], &exact[0]).max(ulps(other[i], &exact[1]));
                assert!(worst <= 0.5 + 1e-4, "{worst} ulp: n = {n} at {:e} by {path}", values[i]);
            }
        }
    }
}
