//! The closed forms in `f64`, within one ulp wherever the result is representable.
//!
//! Each function evaluates the generic formula of this crate in extended precision ([`Extended`](mdr_core::number::Extended)),
//! first with one word, whose error bound suffices for ordinary inputs, then, if it does not, with two and four words:
//! near n = 1/2, near the zero of d(a) or F(a), at extreme ratios of scales. So no digits are lost near n = 1/2, no
//! intermediate result overflows, and every result is within one ulp of the true value for the given doubles (0.6 ulp
//! is a typical worst case of many), including subnormal results. A result beyond the range of `f64` is
//! [`Overflow`](mdr_core::contact::Ranged::Overflow) or [`Underflow`](mdr_core::contact::Ranged::Underflow) with its
//! log₁₀. An exact zero is 0.
//!
//! ```
//! use mdr_analytic::double;
//! use mdr_core::contact::{Control, Material, Ranged};
//! let gel = Material::new(1e4, 0.05)?;
//! let ball = double::critical(2.0, 500.0, &gel, &Control::Force)?; // R = 1 mm
//! assert_eq!(ball.force, Ranged::Value(-2.356194490192345e-4)); // −(3/2)πwR
//! // n = 1/2 + 2⁻³⁰: lengths of (B/N²)^(2²⁹).
//! let near = double::critical(0.5 + 2f64.powi(-30), 1.0, &gel, &Control::Indentation)?;
//! assert!(matches!(near.contact_radius, Ranged::Underflow { log10 } if log10 < -1e9));
//! // The universal curve of the cone returns to F = 0 at ã = 16, exactly.
//! assert_eq!(double::universal_force(1.0, 16.0)?, Ranged::Value(0.0));
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```
//!
//! Many points at once are faster with [`grid`], at 2 ulp, and equilibria at many values with [`Inverse::branches`].
//!
//! # Errors
//! All functions: [`Error::Domain`] for arguments outside the domain of the generic function of the same name, NaN and
//! ∞ included; [`Error::Undecided`] if 256 bits do not suffice, which requires specially constructed inputs, or if a
//! binary exponent exceeds 2⁶², which requires |2n−1| < 2⁻⁴⁹ and extreme scales.

mod exponential;
mod functions;
pub mod grid;
mod inverse;
mod kappa;
#[path = "../../data/kappa.rs"]
mod kappa_table;
mod pair;
#[path = "../../data/powers.rs"]
mod powers;
mod ziv;

use mdr_core::contact::{Control, Error, Material, Quantity, Result};

pub use self::functions::*;
pub use self::inverse::*;
use crate::contact::PowerLawContact;
use crate::kappa::Kappa;
use crate::power_law::PowerLaw;

/// κ_n (1.12), within 0.51 ulp.
///
/// # Errors
/// [`Error::Domain`] unless n is positive and finite.
pub fn kappa(n: f64) -> Result<f64> {
    crate::kappa(&n)
}

/// Rejects a value with the double itself in the message.
#[inline(always)]
fn positive(quantity: Quantity, value: f64) -> Result<()> {
    Error::require_positive(quantity, value).map(|_| ())
}

#[inline(always)]
fn power_law<R: Kappa + From<f64>>(n: f64, c: f64) -> Result<PowerLaw<R>> {
    positive(Quantity::Exponent, n)?;
    positive(Quantity::Coefficient, c)?;
    PowerLaw::new(n.into(), c.into())
}

#[inline(always)]
fn lifted<R: Kappa + From<f64>>(material: &Material<f64>) -> Result<Material<R>> {
    Material::new((*material.effective_modulus()).into(), (*material.work_of_adhesion()).into())
}

#[inline(always)]
fn contact<R: Kappa + From<f64>>(n: f64, c: f64, material: &Material<f64>) -> Result<PowerLawContact<R>> {
    Ok(PowerLawContact::new(power_law(n, c)?, lifted(material)?))
}

#[inline(always)]
fn lifted_control<R: From<f64>>(control: &Control<f64>) -> Result<Control<R>> {
    control.try_map(|stiffness| {
        positive(Quantity::Stiffness, *stiffness)?;
        Ok((*stiffness).into())
    })
}
