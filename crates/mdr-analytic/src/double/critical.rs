//! Critical states, folds, jumps and the scale-free case.

use mdr_core::contact::{Control, Instability, Material, Quantity, Ranged, Result};
use mdr_core::number::Wide;

use super::ziv::{decide, settle, undecided};
use super::{contact, lifted, lifted_control, positive};
use crate::critical::Critical;
use crate::threshold::Fate;

/// The critical state: (1.15) corrected and (1.17), or the first fold of a machine. There is none at n = 1/2.
///
/// # Errors
/// See the [module](super).
pub fn critical(n: f64, c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Critical<Ranged<f64>>> {
    decide!(Quantity::ContactRadius, W => contact::<W>(n, c, material)?.critical(&lifted_control(control)?))
}

/// All folds on a machine of stiffness k, by increasing radius.
///
/// # Errors
/// See the [module](super).
pub fn machine_folds(
    n: f64,
    c: f64,
    material: &Material<f64>,
    stiffness: f64,
) -> Result<Vec<Instability<Ranged<f64>>>> {
    positive(Quantity::Stiffness, stiffness)?;
    decide!(Quantity::ContactRadius, W => contact::<W>(n, c, material)?.machine_folds(&stiffness.into()))
}

/// a₀, the equilibrium radius at d = 0, in m.
///
/// # Errors
/// See the [module](super).
pub fn radius_at_zero_indentation(n: f64, c: f64, material: &Material<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::ContactRadius, W => contact::<W>(n, c, material)?.radius_at_zero_indentation())
}

/// The energy dissipated when the contact breaks under fixed grips, in J; n > 1/2.
///
/// # Errors
/// See the [module](super).
pub fn energy_lost_at_pull_off(n: f64, c: f64, material: &Material<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::Energy, W => contact::<W>(n, c, material)?.energy_lost_at_pull_off())
}

/// The energy dissipated when the surfaces jump into contact at d = 0, in J; n > 1/2.
///
/// # Errors
/// See the [module](super).
pub fn energy_lost_at_jump_in(n: f64, c: f64, material: &Material<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::Energy, W => contact::<W>(n, c, material)?.energy_lost_at_jump_in())
}

/// The energy barrier before complete contact at d = 0, in J; n < 1/2.
///
/// # Errors
/// See the [module](super).
pub fn barrier_to_complete_contact(n: f64, c: f64, material: &Material<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::Energy, W => contact::<W>(n, c, material)?.barrier_to_complete_contact())
}

/// The C at n = 1/2 that separates the two outcomes (1.19), in √m.
///
/// # Errors
/// See the [module](super).
pub fn threshold(material: &Material<f64>, control: &Control<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::Coefficient, W => crate::threshold::<W>(&lifted(material)?, &lifted_control(control)?))
}

/// ρ = κ_{1/2}C/√(2πw/E*) at n = 1/2.
///
/// # Errors
/// See the [module](super).
pub fn ratio(c: f64, material: &Material<f64>) -> Result<Ranged<f64>> {
    decide!(Quantity::Coefficient, W => contact::<W>(0.5, c, material)?.ratio())
}

/// The outcome of the contact at n = 1/2 (1.19).
///
/// # Errors
/// See the [module](super).
pub fn fate(c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Fate> {
    decide!(Quantity::Coefficient, W => contact::<W>(0.5, c, material)?.fate(&lifted_control(control)?))
}

/// The equilibrium of radius a at n = 1/2.
///
/// # Errors
/// See the [module](super).
pub fn scale_free_state(c: f64, material: &Material<f64>, a: f64) -> Result<Critical<Ranged<f64>>> {
    positive(Quantity::ContactRadius, a)?;
    decide!(Quantity::Indentation, W => contact::<W>(0.5, c, material)?.scale_free_state(&a.into()))
}

/// Kendall's flat punch of the given radius at pull-off.
///
/// # Errors
/// See the [module](super).
pub fn flat_punch_pull_off(radius: f64, material: &Material<f64>) -> Result<Critical<Ranged<f64>>> {
    positive(Quantity::Radius, radius)?;
    decide!(Quantity::Force, W => crate::flat_punch_pull_off::<W>(&radius.into(), &lifted(material)?))
}
