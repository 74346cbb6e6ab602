//! Pressure, displacement and gap: against each other, against (1.6), and against Johnson, Kendall and Roberts (1971).

use mdr_core::calculus::quadrature::tanh_sinh;
use mdr_core::contact::{Control, Material, Profile, Result};
use mdr_numeric::curve::Curve;
use mdr_numeric::fields::Fields;
use mdr_numeric::profiles::{Paraboloid, RoundedPunch, WavyParaboloid};
use mdr_numeric::transform::Quadrature;

/// Relative error of a quadrature of f64 quadratures: 32 u from the rule and as much again from the integrand.
const QUADRATURE: f64 = 64.0 * f64::EPSILON;

#[test]
fn jkr_pressure() -> Result<()> {
    let (radius, e, w, a) = (2.0, 3.0, 1e-3, 0.3);
    let ball = Quadrature::new(Paraboloid::new(radius)?);
    let material = Material::new(e, w)?;
    let fields = Fields::new(Curve::new(&ball, &material, &Control::Indentation), a)?;
    for r in [0.0, 1e-6, 0.1, 0.2, 0.29, 0.29999] {
        let leg = ((a - r) * (a + r)).sqrt();
        let hertz = 2.0 * e / (std::f64::consts::PI * radius) * leg;
        let edge = (2.0 * e * w * a / std::f64::consts::PI).sqrt() / leg;
        let p = fields.pressure(&r)?;
        assert!((p - (hertz - edge)).abs() <= QUADRATURE * (hertz + edge), "r = {r}: {p} against {}", hertz - edge);
    }
    Ok(())
}

/// ∫ 2πr p dr over 0 < r < a, with r = a sin θ to take out the singularity of p at the edge.
fn force_of_pressure(fields: &Fields<'_, f64>, a: f64, kinks: &[f64]) -> Result<f64> {
    let mut total = 0.0;
    let mut from = 0.0;
    for to in kinks.iter().map(|kink| (kink / a).asin()).chain([std::f64::consts::FRAC_PI_2]) {
        let ring = |theta: &f64| {
            let r = a * theta.sin();
            // The last nodes round to the edge; what they weigh is counted in the tolerance.
            let p = if r < a { fields.pressure(&r)? } else { 0.0 };
            Ok(2.0 * std::f64::consts::PI * r * p * a * theta.cos())
        };
        total += tanh_sinh(&from, &to, &1e-6, ring)?.value;
        from = to;
    }
    Ok(total)
}

#[test]
fn the_pressure_adds_up_to_the_force() -> Result<()> {
    let material = Material::new(1.0, 1e-4)?;
    let wavy = Quadrature::new(WavyParaboloid::new(1.0, 5e-4, 0.1)?);
    let punch = Quadrature::new(RoundedPunch::new(1.0, 0.05)?);
    let curves = [
        (Curve::new(&wavy, &material, &Control::Indentation), 0.09, vec![]),
        (Curve::new(&punch, &material, &Control::Indentation), 0.09, vec![0.05]),
    ];
    for (curve, a, kinks) in curves {
        let fields = Fields::new(curve, a)?;
        let force = force_of_pressure(&fields, a, &kinks)?;
        // The edge term alone is −4√(πE*wa³/2)·…: its scale bounds what can cancel. r = a sin θ rounds at √u from π/2.
        let scale = (8.0 * std::f64::consts::PI * 1e-4 * a.powi(3)).sqrt();
        assert!((force - curve.force(&a)?).abs() < 1e-5 * scale, "{force} {}", curve.force(&a)?);
    }
    Ok(())
}

#[test]
fn the_gap_is_what_profile_and_displacement_leave() -> Result<()> {
    let material = Material::new(1.0, 1e-4)?;
    let profile = WavyParaboloid::new(1.0, 5e-4, 0.1)?;
    let wavy = Quadrature::new(WavyParaboloid::new(1.0, 5e-4, 0.1)?);
    let fields = Fields::new(Curve::new(&wavy, &material, &Control::Indentation), 0.09)?;
    for r in [0.0900001, 0.095, 0.13, 0.5, 3.0] {
        let apart = profile.height(&r) - fields.indentation() + fields.displacement(&r)?;
        let scale = profile.height(&r).abs() + 2.0 * fields.indentation().abs();
        assert!((fields.gap(&r)? - apart).abs() <= 2.0 * QUADRATURE * scale, "r = {r}");
    }
    Ok(())
}

#[test]
fn a_deep_wave_touches_again_outside() -> Result<()> {
    let material = Material::new(1.0, 1e-6)?;
    // Waves of 10 mm on a paraboloid of 1 m: contact on the first crest alone, pressed deep, cannot be simply connected.
    let wavy = Quadrature::new(WavyParaboloid::new(1.0, 1e-2, 0.1)?);
    let curve = Curve::new(&wavy, &material, &Control::Indentation);
    for (a, admissible) in [(0.01, true), (0.03, false), (0.045, false), (0.06, false), (0.11, true)] {
        let state = Fields::new(curve, a)?;
        let radius = state.interpenetration(&0.5)?;
        assert_eq!(radius.is_none(), admissible, "a = {a}: {radius:?}");
        if let Some(radius) = radius {
            assert!(radius > a && state.gap(&(radius * 1.001))? < 0.0, "a = {a}: {radius}");
        }
    }
    Ok(())
}

#[test]
fn stiffness_is_the_slope_of_force_against_indentation() -> Result<()> {
    let ball = Quadrature::new(Paraboloid::new(1.0)?);
    let material = Material::new(1.0, 1e-3)?;
    let curve = Curve::new(&ball, &material, &Control::Indentation);
    let (a, step) = (0.2, 1e-5);
    let change = |f: &dyn Fn(&f64) -> Result<f64>| -> Result<f64> { Ok(f(&(a + step))? - f(&(a - step))?) };
    let difference = change(&|a| curve.force(a))? / change(&|a| curve.indentation(a))?;
    // A central difference is off by (h/a)² of its value, and by rounding u a/h of it.
    assert!((Fields::new(curve, a)?.stiffness()? / difference - 1.0).abs() < 1e-7);
    assert!(Fields::new(curve, a)?.pressure(&0.3).is_err() && Fields::new(curve, a)?.gap(&0.1).is_err());
    Ok(())
}
