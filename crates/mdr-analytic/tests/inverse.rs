//! Equilibria at a value against bisection of (1.13) and (1.16), which are written down here a second time over MPFR with its
//! own Γ; against the closed forms that the family has for m = 2; and what physics demands.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

use mdr_analytic::double::grid::{Path, Tally};
use mdr_analytic::double::{Branches, Side};
use mdr_analytic::{Contact, Equilibria, PowerLaw, double};
use mdr_core::contact::{Control, Equilibrium, Error, Material, Quantity, Ranged, Stability, Status};
use mdr_core::number::{Dual, Interval, Precision, Real};
use proptest::prelude::*;
use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;

const BITS: u32 = 400;

fn float(value: f64) -> Float {
    Float::with_val(BITS, value)
}

/// A contact as doubles.
#[derive(Clone, Copy, Debug)]
struct Scene {
    n: f64,
    c: f64,
    e: f64,
    w: f64,
    /// Whether the force is held and not the indentation depth.
    by_force: bool,
}

impl Scene {
    /// The contact whose fold is near the radius a.
    fn with_fold(n: f64, a: f64, e: f64, w: f64, by_force: bool) -> Self {
        let tension = if by_force { 3.0 } else { 1.0 };
        let edge = (std::f64::consts::PI * w / (2.0 * e)).sqrt();
        let c = tension * edge * a.powf(0.5 - n) / (n * double::kappa(n).unwrap());
        Scene { n, c, e, w, by_force }
    }

    fn control<R>(&self) -> Control<R> {
        if self.by_force { Control::Force } else { Control::Indentation }
    }

    fn material(&self) -> Material<f64> {
        Material::new(self.e, self.w).unwrap()
    }

    fn contact<R: mdr_analytic::Kappa>(&self, ctx: R::Ctx) -> Contact<R> {
        let number = |x| R::from_f64(ctx, x);
        let profile = PowerLaw::new(number(self.n), number(self.c)).unwrap();
        Contact::new(profile, Material::new(number(self.e), number(self.w)).unwrap())
    }

    fn inverse(&self) -> double::Inverse {
        double::Inverse::new(self.n, self.c, &self.material(), &self.control()).unwrap()
    }

    fn ln_transform_factor(&self) -> Float {
        let half = float(self.n) / 2u32;
        let ln_root_pi = Float::with_val(BITS, Constant::Pi).ln() / 2u32;
        ln_root_pi + (half.clone() + 1u32).ln_gamma() - (half + 0.5f64).ln_gamma() + float(self.c).ln()
    }

    fn truth(self) -> Truth {
        let ln_factor = self.ln_transform_factor();
        let tension = float(if self.by_force { 3.0 } else { 1.0 });
        let ln_edge = (Float::with_val(BITS, Constant::Pi) / 2u32 * self.w / self.e).ln();
        let ln_slope = ln_factor.clone() + float(self.n).ln();
        let ln_fold = (ln_edge + (tension.ln() - ln_slope) * 2u32) / (float(self.n) * 2u32 - 1u32);
        Truth { scene: self, ln_factor, ln_fold }
    }
}

/// A contact over MPFR.
struct Truth {
    scene: Scene,
    /// ln κC.
    ln_factor: Float,
    /// ln of the radius of the fold.
    ln_fold: Float,
}

impl Truth {
    /// g, Δl and a at e^ln_a.
    fn terms(&self, ln_a: &Float) -> [Float; 3] {
        let Scene { n, e, w, .. } = self.scene;
        let g = (self.ln_factor.clone() + ln_a.clone() * n).exp();
        let a = ln_a.clone().exp();
        let elongation = (Float::with_val(BITS, Constant::Pi) * 2u32 * w / e * &a).sqrt();
        [g, elongation, a]
    }

    /// d and F at e^ln_a.
    fn state(&self, ln_a: &Float) -> [Float; 2] {
        let [g, elongation, a] = self.terms(ln_a);
        let pressed = g.clone() * self.scene.n / (float(self.scene.n) + 1u32);
        [g - &elongation, (pressed - elongation) * 2u32 * self.scene.e * a]
    }

    fn held(&self, ln_a: &Float) -> Float {
        let [d, f] = self.state(ln_a);
        if self.scene.by_force { f } else { d }
    }

    /// dx/d ln a.
    fn slope(&self, ln_a: &Float) -> Float {
        let [g, elongation, a] = self.terms(ln_a);
        let pressed = g * self.scene.n;
        if self.scene.by_force {
            (pressed - elongation * 1.5f64) * 2u32 * self.scene.e * a
        } else {
            pressed - elongation / 2u32
        }
    }

    fn at_fold(&self) -> f64 {
        self.held(&self.ln_fold).to_f64()
    }

    /// ln a of the equilibria, by increasing radius: a bracket on either side of the fold, halved, and Newton's method.
    fn equilibria(&self, value: f64) -> Vec<Float> {
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

fn ulps(found: f64, truth: &Float) -> f64 {
    let exponent = truth.get_exp().unwrap_or(0).max(-1021);
    ((float(found) - truth) / (float(1.0) << (exponent - 53))).abs().to_f64()
}

/// The answers of [`double::Inverse::branches`]: a and d or F of the smaller and of the larger equilibrium.
struct Many {
    sides: [[Vec<f64>; 2]; 2],
    status: Vec<Status>,
    tally: Tally,
}

impl Many {
    fn of(inverse: &double::Inverse, values: &[f64]) -> Self {
        let new = || vec![0.0; values.len()];
        let mut sides = [[new(), new()], [new(), new()]];
        let mut status = vec![Status::Undecided; values.len()];
        let [[a0, x0], [a1, x1]] = &mut sides;
        let mut found = Branches {
            smaller: Side { contact_radius: a0, uncontrolled: x0 },
            larger: Side { contact_radius: a1, uncontrolled: x1 },
            status: &mut status,
        };
        let tally = inverse.branches(values, &mut found).unwrap();
        Many { sides, status, tally }
    }

    fn at(&self, i: usize) -> [f64; 4] {
        let [smaller, larger] = &self.sides;
        [smaller[0][i], smaller[1][i], larger[0][i], larger[1][i]]
    }
}

/// The functions for f64 against bisection: every quantity within an ulp, or beyond the range with its logarithm.
#[track_caller]
fn check_double(scene: Scene, value: f64) {
    let found = double::equilibria(scene.n, scene.c, &scene.material(), &scene.control(), value).unwrap();
    let truth = scene.truth();
    let radii = truth.equilibria(value);
    assert_eq!(found.as_slice().len(), radii.len(), "{scene:?} at {value:e}");
    let ready = scene.inverse();
    for path in Path::available() {
        check_many(&Many::of(&ready.clone().with_instructions(path), &[value]), 0, &truth, value, &radii);
    }
    for (state, ln_a) in found.as_slice().iter().zip(&radii) {
        let [d, f] = truth.state(ln_a);
        let (held, other) = if scene.by_force { (state.force, d) } else { (state.indentation, f) };
        assert_eq!(held, Ranged::Value(value));
        let found = if scene.by_force { state.indentation } else { state.force };
        for (what, found, exact) in [("a", state.contact_radius, ln_a.clone().exp()), ("d or F", found, other)] {
            match found {
                Ranged::Value(found) => {
                    let ulps = ulps(found, &exact);
                    assert!(ulps <= 1.0, "{what} = {found:e} is {ulps} ulp off: {scene:?} at {value:e}");
                }
                Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => {
                    let exact = exact.abs().log10().to_f64();
                    assert!((log10 / exact - 1.0).abs() < 1e-12 && exact.abs() > 307.0, "{what}: {log10}, {exact}");
                }
            }
        }
        let larger = *ln_a > truth.ln_fold;
        let expected = if larger == (scene.n > 0.5) { Stability::Stable } else { Stability::Unstable };
        assert_eq!(state.stability, expected, "{scene:?} at {value:e}");
    }
}

/// Answer i of many against bisection: every value within an ulp, and the others NaN.
#[track_caller]
fn check_many(many: &Many, i: usize, truth: &Truth, value: f64, radii: &[Float]) {
    let by_force = truth.scene.by_force;
    let expected = |ln_a: &Float| [ln_a.clone().exp(), truth.state(ln_a)[usize::from(!by_force)].clone()];
    let (smaller, larger) = match radii {
        [] => (None, None),
        [only] => (None, Some(expected(only))),
        [smaller, larger] => (Some(expected(smaller)), Some(expected(larger))),
        _ => panic!("more than two"),
    };
    let mut status = if larger.is_some() { Status::Ok } else { Status::NoEquilibrium };
    let exact = [smaller, larger].map(|side| side.map_or([None, None], |side| side.map(Some)));
    for (found, exact) in many.at(i).into_iter().zip(exact.iter().flatten()) {
        match exact {
            Some(exact) if found.is_nan() => {
                let log10 = exact.clone().abs().log10().to_f64();
                assert!(log10.abs() > 307.0, "{log10}: {:?} at {value:e}", truth.scene);
                let beyond = if log10 > 0.0 { Status::Overflow } else { Status::Underflow };
                status = if status == Status::Ok { beyond } else { status };
            }
            Some(exact) => {
                let ulps = ulps(found, exact);
                assert!(ulps <= 1.0, "{found:e} is {ulps} ulp off: {:?} at {value:e}", truth.scene);
            }
            None => assert!(found.is_nan(), "{found:e}: {:?} at {value:e}", truth.scene),
        }
    }
    assert_eq!(many.status[i], status, "{:?} at {value:e}", truth.scene);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn doubles_between_the_fold_and_zero(
        n in 0.05..6.0f64, a in -9.0..0.0f64, e in 3.0..11.0f64, w in -3.0..0.0f64, k in 0..52i32, f in 0.5..1.0f64,
        by_force in any::<bool>(),
    ) {
        prop_assume!((n - 0.5).abs() > 1e-3);
        let scene = Scene::with_fold(n, 10f64.powf(a), 10f64.powf(e), 10f64.powf(w), by_force);
        let at_fold = scene.truth().at_fold();
        check_double(scene, at_fold * (1.0 - f * 2f64.powi(-k)));
        check_double(scene, at_fold * f * 2f64.powi(-k));
    }

    #[test]
    fn doubles_of_the_other_sign(
        n in 0.05..6.0f64, a in -9.0..0.0f64, e in 3.0..11.0f64, w in -3.0..0.0f64, far in -12.0..12.0f64,
        by_force in any::<bool>(),
    ) {
        prop_assume!((n - 0.5).abs() > 1e-3);
        let scene = Scene::with_fold(n, 10f64.powf(a), 10f64.powf(e), 10f64.powf(w), by_force);
        let at_fold = scene.truth().at_fold();
        check_double(scene, -at_fold * 10f64.powf(far));
        check_double(scene, 0.0);
    }

    /// 1/2 ± 2⁻ᵏ, and exponents and scales far out.
    #[test]
    fn doubles_near_one_half_and_far(
        k in 2..40i32, above in any::<bool>(), n in -4.0..4.0f64, f in 0.01..0.99f64, scale in -40.0..40.0f64,
        by_force in any::<bool>(),
    ) {
        let near = if above { 0.5 + 2f64.powi(-k) } else { 0.5 - 2f64.powi(-k) };
        for n in [near, 10f64.powf(n)] {
            let scene = Scene::with_fold(n, 10f64.powf(scale / (n + 1.0)), 1e6, 0.05, by_force);
            prop_assume!(scene.c.is_normal());
            let at_fold = scene.truth().at_fold();
            prop_assume!(at_fold.is_normal());
            for factor in [f, 1.0 - 1e-9 * f, -f, -1e30] {
                check_double(scene, at_fold * factor);
            }
        }
    }

    /// Every arithmetic: intervals contain the truth and are narrow, 200 bits and f64 have a residual at rounding level.
    #[test]
    fn every_arithmetic_agrees(n in 0.05..6.0f64, f in 0.01..0.999f64, other in any::<bool>(), by_force in any::<bool>()) {
        prop_assume!((n - 0.5).abs() > 1e-2);
        let scene = Scene::with_fold(n, 1e-6, 1e7, 0.05, by_force);
        let value = scene.truth().at_fold() * if other { -1.0 / f } else { f };
        let truth = scene.truth();
        let radii = truth.equilibria(value);
        let precision = Precision::new(200);
        let intervals = scene.contact::<Interval>(precision);
        let enclosed = intervals.equilibria(&scene.control(), &Interval::from_f64(precision, value)).unwrap();
        let floats = scene.contact::<Float>(precision);
        let floats = floats.equilibria(&scene.control(), &Float::with_val(200, value)).unwrap();
        let doubles = scene.contact::<f64>(()).equilibria(&scene.control(), &value).unwrap();
        prop_assert_eq!(enclosed.as_slice().len(), radii.len());
        prop_assert_eq!(floats.as_slice().len(), radii.len());
        prop_assert_eq!(doubles.as_slice().len(), radii.len());
        for (i, ln_a) in radii.iter().enumerate() {
            let (a, [_, force]) = (ln_a.clone().exp(), truth.state(ln_a));
            let state = &enclosed.as_slice()[i];
            prop_assert!(state.contact_radius.contains(&a) && state.force.contains(&Float::with_val(200, &force)) | by_force);
            prop_assert!(state.contact_radius.accuracy_bits() > 160, "{}", state.contact_radius.accuracy_bits());
            // Terms over slope: what a relative rounding of a term does to ln a.
            let [g, elongation, _] = truth.terms(ln_a);
            let terms = (g + elongation) * if by_force { a.clone() * 2u32 * scene.e } else { float(1.0) };
            let condition = (terms / truth.slope(ln_a)).abs().to_f64() + 1.0;
            let error = |found: &Float| (Float::with_val(BITS, found - &a) / &a).abs().to_f64();
            // κ and powers err by up to 40 roundings and |n ln a| ones.
            let allowed = (60.0 + 2.0 * (n + 1.0) * ln_a.to_f64().abs()) * condition;
            let mp = error(&floats.as_slice()[i].contact_radius);
            prop_assert!(mp <= allowed * 2f64.powi(-200), "{} of {}", mp * 2f64.powi(200), allowed);
            let double = error(&float(doubles.as_slice()[i].contact_radius));
            prop_assert!(double <= allowed * 2f64.powi(-53), "{} of {}", double * 2f64.powi(53), allowed);
        }
    }

    /// The stable equilibrium is the lower in energy, d'(a) or F'(a) has the sign of stability, and da/dx = 1/x'(a).
    #[test]
    fn stability_energy_and_slope(n in 0.05..6.0f64, f in 0.05..0.95f64, by_force in any::<bool>()) {
        prop_assume!((n - 0.5).abs() > 1e-2);
        let scene = Scene::with_fold(n, 1e-6, 1e7, 0.05, by_force);
        let value = scene.truth().at_fold() * f;
        let contact = scene.contact::<f64>(());
        let found = contact.equilibria(&scene.control(), &value).unwrap();
        let Equilibria::Two(states) = &found else { panic!("two equilibria") };
        let slope = |state: &Equilibrium<f64>| {
            let a = &state.contact_radius;
            if by_force { contact.force_slope(a).unwrap() } else { contact.indentation_slope(a).unwrap() }
        };
        for state in states {
            prop_assert_eq!(slope(state) > 0.0, state.stability == Stability::Stable);
        }
        // Under a dead load the energy of the load counts, too.
        let energy = |state: &Equilibrium<f64>| {
            let elastic = contact.energy(&state.contact_radius, &state.indentation).unwrap();
            if by_force { elastic - value * state.indentation } else { elastic }
        };
        let stable = found.stable().unwrap();
        let unstable = states.iter().find(|state| state.stability == Stability::Unstable).unwrap();
        prop_assert!(energy(stable) < energy(unstable));

        let constant = Dual::constant;
        let profile = PowerLaw::new(constant(scene.n), constant(scene.c)).unwrap();
        let dual = Contact::new(profile, Material::new(constant(scene.e), constant(scene.w)).unwrap());
        let control = if by_force { Control::Force } else { Control::Indentation };
        let moved = dual.equilibria(&control, &Dual::variable(value)).unwrap();
        for (state, moved) in states.iter().zip(moved.as_slice()) {
            prop_assert!((moved.contact_radius.slope * slope(state) - 1.0).abs() < 1e-6);
        }
    }

    /// m = 2: a = a_c(1 ± √τ)² for the cone and a_c(1 ± √τ)⁴ for n = 1/4, at any distance from the fold.
    #[test]
    fn the_family_of_the_cone(ln_distance in -600.0..-1e-3f64, c in 0.1..10.0f64, quarter in any::<bool>()) {
        let distance = ln_distance.exp();
        let (n, power) = if quarter { (0.25, 4) } else { (1.0, 2) };
        let material = Material::new(1e6, 0.05).unwrap();
        let control = Control::Indentation;
        let found = double::equilibria_at_distance(n, c, &material, &control, distance).unwrap();
        let wide = Scene { n, c, e: 1e6, w: 0.05, by_force: false };
        let fold = wide.truth().ln_fold.exp();
        prop_assert_eq!(found.as_slice().len(), 2);
        for (state, sign) in found.as_slice().iter().zip([-1, 1]) {
            let truth = Float::with_val(BITS, float(distance).sqrt() * sign + 1u32).pow(power) * &fold;
            let Ranged::Value(a) = state.contact_radius else { panic!("in range") };
            prop_assert!(ulps(a, &truth) <= 1.0);
        }
        // In plain f64 the radius is as good as that of the fold: κ, powers and |ln a| of roundings.
        let plain = wide.contact::<f64>(()).equilibria_at_distance(&control, &distance).unwrap();
        for (state, sign) in plain.as_slice().iter().zip([-1, 1]) {
            let truth = Float::with_val(BITS, float(distance).sqrt() * sign + 1u32).pow(power) * &fold;
            let allowed = 200.0 / (1.0 - distance.sqrt());
            prop_assert!(ulps(state.contact_radius, &truth) <= allowed, "{}", ulps(state.contact_radius, &truth));
        }
    }

    /// n = 1/2: one equilibrium or none.
    #[test]
    fn scale_free(factor in 0.2..5.0f64, value in -1e-3..1e-3f64, by_force in any::<bool>()) {
        prop_assume!((factor - 1.0).abs() > 1e-6 && value != 0.0);
        let material = Material::new(1e6, 0.05).unwrap();
        let control = if by_force { Control::Force } else { Control::Indentation };
        let c = factor * mdr_analytic::threshold(&material, &control).unwrap();
        let contact = Contact::new(PowerLaw::new(0.5, c).unwrap(), material.clone());
        let found = contact.equilibria(&control, &value).unwrap();
        prop_assert_eq!(found.as_slice().len(), usize::from((factor > 1.0) == (value > 0.0)));
        let doubles = double::equilibria(0.5, c, &material, &control, value).unwrap();
        prop_assert_eq!(doubles.as_slice().len(), found.as_slice().len());
        for (state, double) in found.as_slice().iter().zip(doubles.as_slice()) {
            prop_assert_eq!(state.stability, if factor > 1.0 { Stability::Stable } else { Stability::Unstable });
            let a = &state.contact_radius;
            let (d, f) = (contact.indentation(a).unwrap(), contact.force(a).unwrap());
            // The difference ρ − 1 or ρ/3 − 1 has lost a part of its digits.
            let allowed = 200.0 * f64::EPSILON / (factor - 1.0).abs();
            // d vanishes at ρ = 1 and F at ρ = 3: both on the scale of their terms.
            let terms = contact.detachment_elongation(a).unwrap() * (1.0 + factor * 3.0);
            prop_assert!((d - state.indentation).abs() < allowed * terms);
            prop_assert!((f - state.force).abs() < allowed * terms * 2e6 * a);
            let Ranged::Value(double) = double.contact_radius else { panic!("in range") };
            prop_assert!((double / a - 1.0).abs() < allowed * (1.0 + factor));
        }
    }
}

#[test]
fn the_fold_itself_and_beyond() {
    // A cone with w = E* = C = 1 has d_c = −1 exactly, and the double root there is a_c = 2/π.
    let unit = Material::new(1.0, 1.0).unwrap();
    let ask = |d: f64| double::equilibria(1.0, 1.0, &unit, &Control::Indentation, d).unwrap();
    let Equilibria::One(fold) = ask(-1.0) else { panic!("the double root") };
    assert_eq!(fold.stability, Stability::Neutral);
    assert_eq!(fold.contact_radius, Ranged::Value(std::f64::consts::FRAC_2_PI));
    assert_eq!(ask(-1.0 - f64::EPSILON), Equilibria::None);
    assert_eq!(ask(-1.0 + f64::EPSILON / 2.0).as_slice().len(), 2);
    let ball = Contact::new(PowerLaw::new(2.0, 0.5).unwrap(), unit.clone());
    for control in [Control::Indentation, Control::Force] {
        let fold = ball.equilibria_at_distance(&control, &0.0).unwrap();
        assert_eq!(fold.as_slice()[0].contact_radius, ball.critical(&control).unwrap().contact_radius);
        assert_eq!(fold.as_slice()[0].stability, Stability::Neutral);
        assert_eq!(ball.equilibria_at_distance(&control, &-1e-300).unwrap(), Equilibria::None);
        assert_eq!(ball.equilibria_at_distance(&control, &1.0).unwrap().as_slice().len(), 1);
    }
}

#[test]
fn what_is_refused() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let machine = Control::Machine { stiffness: 1.0 };
    for (n, control, value) in [
        (2.0, Control::Indentation, f64::NAN),
        (2.0, Control::Force, f64::INFINITY),
        (2.0, machine.clone(), 0.0),
        (-1.0, Control::Indentation, 0.0),
    ] {
        let refused = double::equilibria(n, 1.0, &unit, &control, value);
        assert!(matches!(refused, Err(Error::Domain { .. })), "{n}, {control:?}, {value}");
        let refused = double::equilibria_at_distance(n, 1.0, &unit, &control, value);
        assert!(matches!(refused, Err(Error::Domain { .. })), "{n}, {control:?}, {value}");
    }
    let scale_free = double::equilibria_at_distance(0.5, 1.0, &unit, &Control::Indentation, 0.5);
    assert!(matches!(scale_free, Err(Error::Domain { .. })));
}

/// A ready contact answers as a fresh one, and radii beyond the range of f64 come with their logarithm.
#[test]
fn out_of_range() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let ready = double::Inverse::new(2.0, 0.5, &unit, &Control::Indentation).unwrap();
    for d in [-1e-200, -1e-3, -1.0, 0.0, 1.0, 1e300] {
        let fresh = double::equilibria(2.0, 0.5, &unit, &Control::Indentation, d).unwrap();
        assert_eq!(ready.equilibria(d).unwrap(), fresh);
    }
    // a = d²/(2π) at d = −10⁻²⁰⁰.
    let Equilibria::Two([tiny, _]) = ready.equilibria(-1e-200).unwrap() else { panic!("two equilibria") };
    let expected = -400.0 - (2.0 * std::f64::consts::PI).log10();
    assert!(matches!(tiny.contact_radius, Ranged::Underflow { log10 } if (log10 - expected).abs() < 1e-10));
    let plain = Contact::new(PowerLaw::new(2.0, 0.5).unwrap(), unit);
    let refused = plain.equilibria(&Control::Indentation, &-1e-200);
    assert!(matches!(refused, Err(Error::OutOfRange { .. })), "{refused:?}");
}

/// Near n = 1/2 the fold of an ordinary contact is beyond all range, and the equilibria at ordinary values are not: at a(1 ± 2u)
/// the residual has its two signs.
#[test]
fn ordinary_equilibria_far_from_a_fold_out_of_range() {
    let mut answered = 0;
    for (k, above) in (6..=52).flat_map(|k| [(k, true), (k, false)]) {
        let n = 0.5 + if above { 2f64.powi(-k) } else { -2f64.powi(-k) };
        for (c, value, by_force) in [(2.0, 0.5, false), (0.1, -0.5, false), (5.0, 0.5, true), (0.1, -0.5, true)] {
            let scene = Scene { n, c, e: 2.0, w: 1.0, by_force };
            let truth = scene.truth();
            let found = double::equilibria(n, c, &scene.material(), &scene.control(), value).unwrap();
            for state in found.as_slice() {
                let Ranged::Value(a) = state.contact_radius else { continue };
                let residual = |factor: f64| {
                    let [d, f] = truth.state(&(float(a) * factor).ln());
                    if by_force { f - value } else { d - value }
                };
                let [below, above] = [1.0 - f64::EPSILON, 1.0 + f64::EPSILON].map(residual);
                assert!(below * above < 0, "{scene:?} at {value}: {a:e}");
                answered += 1;
            }
        }
    }
    assert!(answered >= 4 * 2 * 47, "{answered}");
}

/// From close to the fold to far on both sides of zero, and where there is no equilibrium.
fn values(at_fold: f64, count: usize) -> Vec<f64> {
    let share = |i: usize| (i as f64 + 0.5) / count as f64;
    let near = (0..count).map(|i| 1.0 - 10f64.powf(-7.0 * share(i)));
    let towards_zero = (0..count).map(|i| 10f64.powf(-9.0 * share(i)));
    let far = (0..count).map(|i| -10f64.powf(18.0 * share(i) - 9.0));
    near.chain(towards_zero).chain(far).chain([0.0, 1.0 + 1e-7, 2.0, 1e6]).map(|z| at_fold * z).collect()
}

/// Rows of values against bisection, most of them without help of extended precision: far from n = 1/2 all of them.
#[test]
fn many_values_of_one_contact() {
    for (n, all_fast) in [
        (0.1, true),
        (0.25, true),
        (0.3, true),
        (0.75, true),
        (1.0, true),
        (1.7, true),
        (2.0, true),
        (4.0, true),
        (30.0, false),
        (0.45, false),
        (0.52, false),
    ] {
        for by_force in [false, true] {
            let scene = Scene::with_fold(n, 1e-6, 1e6, 0.05, by_force);
            let truth = scene.truth();
            let values = values(truth.at_fold(), 12);
            let radii: Vec<_> = values.iter().map(|&value| truth.equilibria(value)).collect();
            for path in Path::available() {
                let many = Many::of(&scene.inverse().with_instructions(path), &values);
                for (i, radii) in radii.iter().enumerate() {
                    check_many(&many, i, &truth, values[i], radii);
                }
                assert_eq!(many.tally.without_value, 3);
                let passed_on = many.tally.passed_on;
                assert!(passed_on <= if all_fast { 0 } else { values.len() / 2 }, "{passed_on}: {scene:?} by {path}");
            }
        }
    }
}

/// A value's answer depends neither on its place nor on the width of the vectors.
#[test]
fn place_and_width_do_not_matter() {
    for (n, by_force) in [(0.3, false), (1.05, true), (2.0, false)] {
        let scene = Scene::with_fold(n, 1e-6, 1e6, 0.05, by_force);
        let values = values(scene.truth().at_fold(), 60);
        let bits = |many: &Many, i: usize| many.at(i).map(f64::to_bits);
        for path in Path::available() {
            let inverse = scene.inverse().with_instructions(path);
            let whole = Many::of(&inverse, &values);
            for start in [1, 37, 64] {
                let part = Many::of(&inverse, &values[start..]);
                assert!((start..values.len()).all(|i| bits(&part, i - start) == bits(&whole, i)), "{start} by {path}");
            }
            // One by one, with the same constants now that they have been needed.
            for (i, &value) in values.iter().enumerate() {
                let found = inverse.equilibria(value).unwrap();
                for (state, side) in found.as_slice().iter().rev().zip(whole.sides.iter().rev()) {
                    assert_eq!(state.contact_radius, Ranged::Value(side[0][i]));
                    assert_eq!(if by_force { state.indentation } else { state.force }, Ranged::Value(side[1][i]));
                }
            }
        }
        if let (Some(four), Some(eight)) = (Path::avx2(), Path::avx512()) {
            let [four, eight] = [four, eight].map(|path| Many::of(&scene.inverse().with_instructions(path), &values));
            assert!((0..values.len()).all(|i| bits(&four, i) == bits(&eight, i)));
        }
    }
}

#[test]
fn what_many_values_may_be() {
    // A cone with w = E* = C = 1 has d_c = −1 exactly, and the double root there is a_c = 2/π.
    let unit = Material::new(1.0, 1.0).unwrap();
    let cone = double::Inverse::new(1.0, 1.0, &unit, &Control::Indentation).unwrap();
    let many = Many::of(&cone, &[-1.0, f64::NAN, f64::NEG_INFINITY, -1.5, 1e308, -1e-200]);
    let expected = [
        Status::Fold,
        Status::DomainError,
        Status::DomainError,
        Status::NoEquilibrium,
        Status::Overflow,
        Status::Underflow,
    ];
    assert_eq!(many.status, expected);
    assert_eq!([many.at(0)[0], many.at(0)[2]], [std::f64::consts::FRAC_2_PI; 2]);
    assert_eq!(many.at(0)[1], many.at(0)[3]);
    assert!((1..4).all(|i| many.at(i).iter().all(|x| x.is_nan())));
    // F is beyond the range and a is not; of the smaller one a is below it, of the larger one both are values.
    assert!(many.at(4)[2] > 1e307 && many.at(4)[3].is_nan());
    assert!(many.at(5)[0].is_nan() && many.at(5)[2] > 0.1 && many.at(5)[3] < 0.0);
    assert_eq!(many.tally, Tally { passed_on: 5, without_value: 5 });
    // n = 1/2 has at most one equilibrium, which is called the larger.
    let threshold = mdr_analytic::threshold(&unit, &Control::Indentation).unwrap();
    let above = double::Inverse::new(0.5, 2.0 * threshold, &unit, &Control::Indentation).unwrap();
    let many = Many::of(&above, &[-1.0, 1.0]);
    assert_eq!(many.status, [Status::NoEquilibrium, Status::Ok]);
    assert!(many.at(1)[0].is_nan() && many.at(1)[2] > 0.0);
}

#[test]
fn slices_of_different_lengths_are_refused() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let ball = double::Inverse::new(2.0, 0.5, &unit, &Control::Force).unwrap();
    let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::ContactRadius, Quantity::Indentation];
    for (wrong, quantity) in quantities.into_iter().chain([Quantity::Parameter("the status")]).enumerate() {
        let len = |i: usize| if i == wrong { 8 } else { 9 };
        let ([mut a0, mut x0, mut a1, mut x1], mut status) = ([[0.0; 9]; 4], [Status::Ok; 9]);
        let mut found = Branches {
            smaller: Side { contact_radius: &mut a0[..len(0)], uncontrolled: &mut x0[..len(1)] },
            larger: Side { contact_radius: &mut a1[..len(2)], uncontrolled: &mut x1[..len(3)] },
            status: &mut status[..len(4)],
        };
        assert_eq!(ball.branches(&[0.0; 9], &mut found), Err(Error::Length { quantity, len: 8, expected: 9 }));
    }
}
