//! Profiles with many waves: the transform by quadrature against the closed form with Struve functions, and the search for
//! folds against the proved list.

#[path = "../crates/mdr-crosscheck/benches/waves/mod.rs"]
mod waves;

use std::sync::Arc;

use mdr_analytic::profiles::WavyParaboloid as Closed;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Control, FoldKind, Material, Result, Shape, Transform};
use mdr_core::number::{Literal, Precision, Real, Special};
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::{SearchQuality, find};
use mdr_numeric::path::{Path, PathEnergy, Start};
use mdr_numeric::transform::Quadrature;
use rug::Float;

fn number<R: Real>(ctx: R::Ctx, text: &str) -> R {
    R::from_literal(ctx, &text.parse::<Literal>().expect("a number"))
}

/// g, xg' and the mean at a number of waves from the tip: within the errors that the quadrature states, which are those of
/// the phase, 2π times the number of waves in roundings, times a margin of 64.
fn compare<R: Struve + Special>(ctx: R::Ctx, waves: &[&str]) -> Result<()> {
    let [radius, amplitude, wavelength] = ["1", "5e-4", "1e-3"].map(|text| number::<R>(ctx, text));
    let closed = Closed::new(radius.clone(), amplitude.clone(), wavelength.clone())?;
    let numeric = Quadrature::of([Shape::WavyParaboloid {
        radius,
        amplitude: amplitude.clone(),
        wavelength: wavelength.clone(),
    }])?
    .with_waves(20_000);
    for waves in waves {
        let x = number::<R>(ctx, waves) * &wavelength;
        let phase = x.pi().times(2) * &x / &wavelength + x.lit(1);
        let pairs = [
            ("g", numeric.g_estimate(&x)?, closed.g(&x)?, x.lit(1)),
            ("slope", numeric.slope_estimate(&x)?, closed.slope(&x)?, phase.clone() / &x),
            ("mean", numeric.mean_estimate(&x)?, closed.mean(&x)?, phase.clone().inv()),
        ];
        for (name, found, truth, derivative) in pairs {
            let error = (found.value.clone() - &truth).abs();
            // The closed form has the error of its own phase.
            let size = (amplitude.clone() * &phase + x.square()) * derivative;
            let rounding = size * phase.clone() * x.unit_roundoff();
            assert!(error <= found.error.clone() + rounding.clone().times(4), "{name} at {waves} waves: {error:?}");
            assert!(found.error <= rounding.times(64), "{name} at {waves} waves claims {:?}", found.error);
        }
    }
    Ok(())
}

#[test]
fn many_waves_in_f64() -> Result<()> {
    compare::<f64>((), &["0.3", "3.1", "31.7", "99.9", "131.3", "300", "1234.5", "10000"])
}

#[test]
fn many_waves_to_fifty_digits() -> Result<()> {
    compare::<Float>(Precision::from_digits(50), &["30.3", "500.7"])
}

#[test]
#[ignore = "some ten seconds without optimisation"]
fn ten_thousand_waves_to_fifty_digits() -> Result<()> {
    compare::<Float>(Precision::from_digits(50), &["10000.3"])
}

/// Waves of 1 cm on a paraboloid of 1 m, w/E* = 10⁻⁴ m, that beat its slope up to N/2 of them: g' = 2x/R + (π/2)Ak(…) has
/// an amplitude of √(π/2) Ak √(kx), so A = √(8N)/(k²R) leaves about N folds.
fn folds_of_waves(count: f64) -> Result<(usize, SearchQuality)> {
    let wavelength = 0.01;
    let k = 2.0 * std::f64::consts::PI / wavelength;
    let waves = Arc::new(Closed::new(1.0, (8.0 * count).sqrt() / (k * k), wavelength)?);
    let material = Material::new(1.0, 1e-4)?;
    let found = find(&Contact::half_space(&waves, &material, &Control::Indentation))?;
    assert!(found.folds.windows(2).all(|pair| pair[0].contact_radius < pair[1].contact_radius));
    assert!(found.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind), "a fold is missing");
    assert!(found.folds.first().is_none_or(|fold| fold.kind == FoldKind::Minimum));
    Ok((found.folds.len(), found.completeness))
}

#[test]
fn folds_by_the_thousand() -> Result<()> {
    for count in [30.0, 300.0, 3000.0, 10_000.0] {
        let (found, completeness) = folds_of_waves(count)?;
        // The estimate is of first order in 1/kx, and the last waves come close to it; an odd number ends in a minimum.
        assert!(found as f64 > 0.995 * count && found as f64 <= count + 3.0, "{found} of {count}");
        assert_eq!((found % 2, completeness), (1, SearchQuality::Resolved));
    }
    Ok(())
}

/// The contact of the benches of folds: the numbers are those proved by enclosures on radii from 10⁻⁶ to 10³.
#[test]
fn as_many_folds_as_are_proved() -> Result<()> {
    for (count, proved) in waves::CASES {
        let waves = Arc::new(waves::waves::<f64>((), count)?);
        let material = Material::new(1.0, 1e-4)?;
        let found = find(&Contact::half_space(&waves, &material, &Control::Indentation))?;
        assert_eq!((found.folds.len(), found.completeness), (proved, SearchQuality::Resolved));
    }
    Ok(())
}

/// The books of a path over hundreds of jumps are closed: all energies are integrated piece by piece between the folds.
#[test]
fn the_energy_of_many_jumps_is_balanced() -> Result<()> {
    for (count, folds) in &waves::CASES[..3] {
        let (waves, control) = (Arc::new(waves::waves::<f64>((), *count)?), Control::Indentation);
        let material = Material::new(1.0, 1e-4)?;
        let branches = SearchedBranches::new(Contact::half_space(&waves, &material, &control))?;
        let path = Path::follow(&branches, &Start::Largest, &[0.0, -1.0])?;
        let balance = PathEnergy::new(&path, &branches)?.balance(&path, &branches)?.expect("nothing unbounded");
        assert!(balance.residual.abs() <= balance.bound, "{balance:?}");
        // What one rounding of g is against a wave grows with their number.
        assert!(balance.bound <= 1e-12 * *folds as f64 * balance.work, "{balance:?}");
    }
    Ok(())
}
