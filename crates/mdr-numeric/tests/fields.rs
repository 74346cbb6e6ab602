//! Pressure, displacement and gap: against each other, against (1.6), and against Johnson, Kendall and Roberts (1971).

use std::sync::Arc;

use mdr_core::calculus::quadrature::tanh_sinh;
use mdr_core::contact::{Control, Error, Flank, Material, Profile, Result, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::fields::Fields;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

/// Relative error of a quadrature of f64 quadratures: 32 u from the rule and as much again from the integrand.
const QUADRATURE: f64 = 64.0 * f64::EPSILON;

#[test]
fn jkr_pressure() -> Result<()> {
    let (radius, e, w, a) = (2.0, 3.0, 1e-3, 0.3);
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius }])?);
    let material = Material::new(e, w)?;
    let fields = Fields::new(Contact::half_space(&ball, &material, &Control::Indentation), a)?;
    for r in [0.0, 1e-6, 0.1, 0.2, 0.29, 0.29999] {
        let leg = ((a - r) * (a + r)).sqrt();
        let hertz = 2.0 * e / (std::f64::consts::PI * radius) * leg;
        let edge = (2.0 * e * w * a / std::f64::consts::PI).sqrt() / leg;
        let p = fields.pressure(&r)?;
        assert!((p - (hertz - edge)).abs() <= QUADRATURE * (hertz + edge), "r = {r}: {p} against {}", hertz - edge);
    }
    Ok(())
}

/// ∫ 2πr p dr over 0 < r < a, with r = a sin θ to remove the singularity of p at the edge.
fn force_of_pressure(fields: &Fields<f64>, a: f64, kinks: &[f64]) -> Result<f64> {
    let mut total = 0.0;
    let mut from = 0.0;
    for to in kinks.iter().map(|kink| (kink / a).asin()).chain([std::f64::consts::FRAC_PI_2]) {
        let ring = |theta: &f64| {
            let r = a * theta.sin();
            // The last nodes round to the edge; their contribution is in the tolerance.
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
    let wavy = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }])?);
    let punch = Arc::new(Quadrature::of([Shape::RoundedPunch { radius: 1.0, flat: 0.05 }])?);
    let curves = [
        (Contact::half_space(&wavy, &material, &Control::Indentation), 0.09, vec![]),
        (Contact::half_space(&punch, &material, &Control::Indentation), 0.09, vec![0.05]),
    ];
    for (curve, a, kinks) in curves {
        let fields = Fields::new(curve.clone(), a)?;
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
    let profile = Heights::new([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }])?;
    let wavy = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }])?);
    let fields = Fields::new(Contact::half_space(&wavy, &material, &Control::Indentation), 0.09)?;
    for r in [0.0900001, 0.095, 0.13, 0.5, 3.0] {
        let apart = profile.height(&r) - fields.indentation() + fields.displacement(&r)?;
        let scale = profile.height(&r).abs() + 2.0 * fields.indentation().abs();
        assert!((fields.gap(&r)? - apart).abs() <= 2.0 * QUADRATURE * scale, "r = {r}");
    }
    Ok(())
}

#[test]
fn stiffness_is_the_slope_of_force_against_indentation() -> Result<()> {
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?);
    let material = Material::new(1.0, 1e-3)?;
    let curve = Contact::half_space(&ball, &material, &Control::Indentation);
    let (a, step) = (0.2, 1e-5);
    let change = |f: &dyn Fn(&f64) -> Result<f64>| -> Result<f64> { Ok(f(&(a + step))? - f(&(a - step))?) };
    let difference = change(&|a| curve.force(a))? / change(&|a| curve.indentation(a))?;
    // The relative error of a central difference is (h/a)², plus rounding u a/h.
    assert!((Fields::new(curve.clone(), a)?.stiffness()? / difference - 1.0).abs() < 1e-7);
    assert!(
        Fields::new(curve.clone(), a)?.pressure(&0.3).is_err() && Fields::new(curve.clone(), a)?.gap(&0.1).is_err()
    );
    Ok(())
}

/// The paraboloid of curvature radius R, g = x²/R, without squares.
struct Ball(f64);

impl Transform<f64> for Ball {
    fn g(&self, x: &f64) -> Result<f64> {
        Ok(x / self.0 * x)
    }
    fn slope(&self, x: &f64) -> Result<f64> {
        Ok(x / self.0 * 2.0)
    }
    fn integral(&self, x: &f64) -> Result<f64> {
        Ok(self.mean(x)? * x)
    }
    fn mean(&self, x: &f64) -> Result<f64> {
        Ok(self.g(x)? / 3.0)
    }
}

/// Another unit of length changes nothing: if it is a power of two, not even a rounding.
#[test]
fn fields_do_not_depend_on_the_unit_of_length() -> Result<()> {
    let ask = |unit: f64| -> Result<[f64; 6]> {
        let (ball, material) = (Arc::new(Ball(unit)), Material::new(1.0, 1e-4 * unit)?);
        let fields = Fields::new(Contact::half_space(&ball, &material, &Control::Indentation), 0.1 * unit)?;
        let pressure = |r: f64| fields.pressure(&(r * unit));
        let length = |value: Result<f64>| Ok(value? / unit);
        let (near, far) = (0.2 * unit, 30.0 * unit);
        assert!(fields.gap(&f64::INFINITY).is_err() && fields.displacement(&f64::INFINITY).is_err());
        Ok([
            pressure(0.0)?,
            pressure(0.05)?,
            length(fields.gap(&near))?,
            length(fields.gap(&far))?,
            length(fields.displacement(&near))?,
            length(fields.displacement(&far))?,
        ])
    };
    let expected = ask(1.0)?;
    for (value, known) in expected.iter().zip([0.038431, f64::NAN, 0.0174644, f64::NAN, -0.00046226, f64::NAN]) {
        assert!(known.is_nan() || (value / known - 1.0).abs() < 2e-5, "{value} {known}");
    }
    for exponent in [-1000, -666, -530, -300, 300, 530, 666, 1000] {
        assert_eq!(ask(2f64.powi(exponent))?, expected, "2^{exponent}");
    }
    let (ball, material) = (Arc::new(Ball(1.0)), Material::new(1e308, 1e300)?);
    let fields = Fields::new(Contact::half_space(&ball, &material, &Control::Indentation), 100.0)?;
    let Err(Error::OutOfRange { log10, .. }) = fields.pressure(&0.0) else { panic!("an infinite pressure") };
    // (2/π)E*a/R, independent of adhesion.
    assert!((log10 - 310.0 - (2.0 / std::f64::consts::PI).log10()).abs() < 1e-4, "{log10}");
    Ok(())
}

/// A cone of slope 1 with a flat face: g = x arccos(b/x) outside.
struct FlatCone;

impl FlatCone {
    const FLAT: f64 = 0.2;

    fn outside(x: f64, value: impl Fn(f64, f64) -> f64) -> Result<f64> {
        let b = Self::FLAT;
        Ok(if x > b { value((b / x).acos(), ((x - b) * (x + b)).sqrt()) } else { 0.0 })
    }
}

impl Transform<f64> for FlatCone {
    fn g(&self, x: &f64) -> Result<f64> {
        Self::outside(*x, |angle, _| x * angle)
    }
    fn slope(&self, x: &f64) -> Result<f64> {
        Self::outside(*x, |angle, leg| angle + Self::FLAT / leg)
    }
    fn integral(&self, x: &f64) -> Result<f64> {
        Self::outside(*x, |angle, leg| (x * x * angle - Self::FLAT * leg) / 2.0)
    }
    fn kinks(&self) -> Vec<f64> {
        vec![Self::FLAT]
    }
}

/// Inside a flat face g' = tan θ (arccos(b/x) + b/√(x² − b²)) begins with an inverse root at its edge b. In x = b + (a − b)s² and
/// s = v³(10 − 15v + 6v²) the integrand is smooth with vanishing ends, and 400 midpoints give it to 10⁻¹⁰.
#[test]
fn the_pressure_inside_a_flat_face() {
    let (b, a): (f64, f64) = (FlatCone::FLAT, 0.4);
    let material = Material::new(1.0, 0.05).unwrap();
    let curve = Contact::half_space(&Arc::new(FlatCone), &material, &Control::Indentation);
    let fields = Fields::new(curve.clone(), a).unwrap();
    let elongation = (2.0 * std::f64::consts::PI * a * 0.05f64).sqrt();
    for r in [0.0f64, 0.1, 0.19] {
        // x = b + (a − b)s², by the midpoint rule in s after s = φ(v) with vanishing derivatives at both ends.
        let panels = 400;
        let term = |i: i32| {
            let v = (f64::from(i) + 0.5) / f64::from(panels);
            let (s, weight) = (v.powi(3) * (10.0 - 15.0 * v + 6.0 * v * v), 30.0 * (v * (1.0 - v)).powi(2));
            let above = (a - b) * s * s;
            let x = b + above;
            // s times the inverse root, without the cancellation of x − b.
            let root = b / (x + b).sqrt() / (a - b).sqrt();
            ((b / x).acos() * s + root) * 2.0 * (a - b) * weight / ((x - r) * (x + r)).sqrt()
        };
        let bulk: f64 = (0..panels).map(term).sum::<f64>() / f64::from(panels);
        let expected = (bulk - elongation / ((a - r) * (a + r)).sqrt()) / std::f64::consts::PI;
        let pressure = fields.pressure(&r).unwrap();
        assert!((pressure - expected).abs() < 1e-10 * bulk, "{r}: {pressure} {expected}");
    }
    // At the edge of the face it is infinite.
    assert!(matches!(fields.pressure(&b), Err(Error::Domain { .. })));
}

/// Just outside the edge of a truncated cone, where the pressure grows like a logarithm of the distance; the values for these
/// doubles were computed by other means (mpmath, 40 digits).
#[test]
fn the_pressure_just_outside_an_edge() -> Result<()> {
    let known = [
        (1e-3, 0.6219272964775535),
        (1e-5, 0.9149440562607886),
        (1e-7, 1.208115267789552),
        (1e-9, 1.5012894573366176),
        (1e-11, 1.7944633429013914),
        (1e-13, 2.0876888450605504),
        (1e-15, 2.374155625862772),
    ];
    let cone = Arc::new(Quadrature::of([Shape::TruncatedCone { flank: Flank::Slope(0.2), flat: 0.1 }])?);
    let material = Material::new(2.0, 1e-3)?;
    let fields = Fields::new(Contact::half_space(&cone, &material, &Control::Indentation), 0.3)?;
    // Of the edge, which is subtracted.
    let edge = (2.0 * 2.0 * 1e-3 * 0.3 / std::f64::consts::PI).sqrt() / 0.08_f64.sqrt();
    for (distance, expected) in known {
        let p = fields.pressure(&(0.1 * (1.0 + distance)))?;
        assert!((p - expected).abs() <= QUADRATURE * (expected + edge), "{distance:e}: {p} against {expected}");
    }
    assert!(matches!(fields.pressure(&0.1), Err(Error::Domain { .. })));
    Ok(())
}
