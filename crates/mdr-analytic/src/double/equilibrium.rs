//! Equilibria and the transformed profile.

use mdr_core::contact::{Error, Material, Quantity, Ranged, Result, Transform};
use mdr_core::number::Wide;

use super::ziv::{decide, settle, undecided};
use super::{contact, lifted, positive, power_law};

/// g(x) = κ_n C xⁿ (1.12), in m.
///
/// # Errors
/// See the [module](super).
pub fn g(n: f64, c: f64, x: f64) -> Result<Ranged<f64>> {
    positive(Quantity::Radius, x)?;
    decide!(Quantity::TransformedProfile, W => power_law::<W>(n, c)?.g(&x.into()))
}

/// g'(x) = nκ_n C xⁿ⁻¹.
///
/// # Errors
/// See the [module](super).
pub fn g_slope(n: f64, c: f64, x: f64) -> Result<Ranged<f64>> {
    positive(Quantity::Radius, x)?;
    decide!(Quantity::TransformedProfile, W => power_law::<W>(n, c)?.slope(&x.into()))
}

/// G(x) = κ_n C xⁿ⁺¹/(n+1), in m².
///
/// # Errors
/// See the [module](super).
pub fn g_integral(n: f64, c: f64, x: f64) -> Result<Ranged<f64>> {
    positive(Quantity::Radius, x)?;
    decide!(Quantity::TransformedProfile, W => power_law::<W>(n, c)?.integral(&x.into()))
}

/// Δl(a) = √(2πaw/E*) (1.4), in m.
///
/// # Errors
/// See the [module](super).
pub fn detachment_elongation(material: &Material<f64>, a: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Indentation, W => crate::detachment_elongation(&lifted::<W>(material)?, &a.into()))
}

/// d(a) (1.5), (1.13), in m.
///
/// # Errors
/// See the [module](super).
pub fn indentation(n: f64, c: f64, material: &Material<f64>, a: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Indentation, W => contact::<W>(n, c, material)?.indentation(&a.into()))
}

/// F(a) (1.6), (1.16), in N.
///
/// # Errors
/// See the [module](super).
pub fn force(n: f64, c: f64, material: &Material<f64>, a: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Force, W => contact::<W>(n, c, material)?.force(&a.into()))
}

/// d'(a) along the equilibria (1.10).
///
/// # Errors
/// See the [module](super).
pub fn indentation_slope(n: f64, c: f64, material: &Material<f64>, a: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Indentation, W => contact::<W>(n, c, material)?.indentation_slope(&a.into()))
}

/// F'(a) along the equilibria, in N/m.
///
/// # Errors
/// See the [module](super).
pub fn force_slope(n: f64, c: f64, material: &Material<f64>, a: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Force, W => contact::<W>(n, c, material)?.force_slope(&a.into()))
}

/// Π(a, d), the potential energy of any state, in J.
///
/// # Errors
/// See the [module](super).
pub fn energy(n: f64, c: f64, material: &Material<f64>, a: f64, d: f64) -> Result<Ranged<f64>> {
    positive(Quantity::ContactRadius, a)?;
    if !d.is_finite() {
        return Err(Error::domain(Quantity::Indentation, &d, "finite"));
    }
    decide!(Quantity::Energy, W => contact::<W>(n, c, material)?.energy(&a.into(), &d.into()))
}

/// d/|d_c| as a function of ã = a/a_c.
///
/// # Errors
/// See the [module](super).
pub fn universal_indentation(n: f64, scaled_radius: f64) -> Result<Ranged<f64>> {
    positive(Quantity::Exponent, n)?;
    positive(Quantity::ContactRadius, scaled_radius)?;
    decide!(Quantity::Indentation, W => crate::universal_indentation::<W>(&n.into(), &scaled_radius.into()))
}

/// F/|F_c| as a function of ã = a/a_c.
///
/// # Errors
/// See the [module](super).
pub fn universal_force(n: f64, scaled_radius: f64) -> Result<Ranged<f64>> {
    positive(Quantity::Exponent, n)?;
    positive(Quantity::ContactRadius, scaled_radius)?;
    decide!(Quantity::Force, W => crate::universal_force::<W>(&n.into(), &scaled_radius.into()))
}
