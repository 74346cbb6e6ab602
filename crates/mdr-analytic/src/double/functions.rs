//! The functions of one point: states, critical states, jumps, the transformed profile and the scale-free case.

use mdr_core::contact::{Control, Error, Fold, Material, Quantity, Ranged, Result, Transform};
use mdr_core::number::Extended;

use super::ziv::{decide, settle, undecided};
use super::{contact, lifted, lifted_control, positive, power_law};
use crate::state::State;
use crate::threshold::ScaleFreeOutcome;

/// Functions whose formula, generic in the arithmetic `W`, is decided by more and more words. The arguments after the
/// semicolon are positive numbers of the quantities named; the quantity before the formula is that of an undecided result.
macro_rules! decided {
    ($(
        $(#[$doc:meta])*
        $access:vis fn $name:ident($($given:ident: $type:ty),*; $($number:ident: $quantity:ident),*) -> $result:ty =
            $of:ident $formula:expr;
    )*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// See the [module](super).
        $access fn $name($($given: $type,)* $($number: f64),*) -> Result<$result> {
            $(positive(Quantity::$quantity, $number)?;)*
            decide!(Quantity::$of, W => $formula)
        }
    )*};
}

decided! {
    /// g(x) = κ_n C xⁿ (1.12), in m.
    pub fn g(n: f64, c: f64; x: Radius) -> Ranged<f64> = TransformedProfile power_law::<W>(n, c)?.g(&x.into());

    /// g'(x) = nκ_n C xⁿ⁻¹.
    pub fn g_slope(n: f64, c: f64; x: Radius) -> Ranged<f64> = TransformedProfile power_law::<W>(n, c)?.slope(&x.into());

    /// G(x) = κ_n C xⁿ⁺¹/(n+1), in m².
    pub fn g_integral(n: f64, c: f64; x: Radius) -> Ranged<f64> =
        TransformedProfile power_law::<W>(n, c)?.integral(&x.into());

    /// Δl(a) = √(2πaw/E*) (1.4), in m.
    pub fn detachment_elongation(material: &Material<f64>; a: ContactRadius) -> Ranged<f64> =
        Indentation crate::detachment_elongation(&lifted::<W>(material)?, &a.into());

    /// d(a) (1.5), (1.13), in m.
    pub fn indentation(n: f64, c: f64, material: &Material<f64>; a: ContactRadius) -> Ranged<f64> =
        Indentation contact::<W>(n, c, material)?.indentation(&a.into());

    /// F(a) (1.6), (1.16), in N.
    pub fn force(n: f64, c: f64, material: &Material<f64>; a: ContactRadius) -> Ranged<f64> =
        Force contact::<W>(n, c, material)?.force(&a.into());

    /// d'(a) along the equilibria (1.10).
    pub fn indentation_slope(n: f64, c: f64, material: &Material<f64>; a: ContactRadius) -> Ranged<f64> =
        Indentation contact::<W>(n, c, material)?.indentation_slope(&a.into());

    /// F'(a) along the equilibria, in N/m.
    pub fn force_slope(n: f64, c: f64, material: &Material<f64>; a: ContactRadius) -> Ranged<f64> =
        Force contact::<W>(n, c, material)?.force_slope(&a.into());

    /// d/|d_c| as a function of ã = a/a_c.
    pub fn universal_indentation(; n: Exponent, scaled_radius: ContactRadius) -> Ranged<f64> =
        Indentation crate::universal_indentation::<W>(&n.into(), &scaled_radius.into());

    /// F/|F_c| as a function of ã = a/a_c.
    pub fn universal_force(; n: Exponent, scaled_radius: ContactRadius) -> Ranged<f64> =
        Force crate::universal_force::<W>(&n.into(), &scaled_radius.into());

    /// The critical state: (1.15) corrected and (1.17), or the first fold of a machine. There is none at n = 1/2.
    pub fn critical(n: f64, c: f64, material: &Material<f64>, control: &Control<f64>;) -> State<Ranged<f64>> =
        ContactRadius contact::<W>(n, c, material)?.critical(&lifted_control(control)?);

    /// All folds on a machine of stiffness k, by increasing radius.
    pub fn machine_folds(n: f64, c: f64, material: &Material<f64>; stiffness: Stiffness) -> Vec<Fold<Ranged<f64>>> =
        ContactRadius contact::<W>(n, c, material)?.machine_folds(&stiffness.into());

    /// a₀, the equilibrium radius at d = 0, in m.
    pub fn radius_at_zero_indentation(n: f64, c: f64, material: &Material<f64>;) -> Ranged<f64> =
        ContactRadius contact::<W>(n, c, material)?.radius_at_zero_indentation();

    /// The energy dissipated when the contact breaks under fixed grips, in J; n > 1/2.
    pub fn energy_lost_at_pull_off(n: f64, c: f64, material: &Material<f64>;) -> Ranged<f64> =
        Energy contact::<W>(n, c, material)?.energy_lost_at_pull_off();

    /// The energy dissipated when the surfaces jump into contact at d = 0, in J; n > 1/2.
    pub fn energy_lost_at_jump_in(n: f64, c: f64, material: &Material<f64>;) -> Ranged<f64> =
        Energy contact::<W>(n, c, material)?.energy_lost_at_jump_in();

    /// The energy barrier before complete contact at d = 0, in J; n < 1/2.
    pub fn barrier_to_complete_contact(n: f64, c: f64, material: &Material<f64>;) -> Ranged<f64> =
        Energy contact::<W>(n, c, material)?.barrier_to_complete_contact();

    /// The C at n = 1/2 that separates the two outcomes (1.19), in √m.
    pub fn threshold(material: &Material<f64>, control: &Control<f64>;) -> Ranged<f64> =
        Coefficient crate::threshold::<W>(&lifted(material)?, &lifted_control(control)?);

    /// ρ = κ_{1/2}C/√(2πw/E*) at n = 1/2.
    pub fn ratio(c: f64, material: &Material<f64>;) -> Ranged<f64> = Coefficient contact::<W>(0.5, c, material)?.ratio();

    /// The outcome of the contact at n = 1/2 (1.19).
    pub fn fate(c: f64, material: &Material<f64>, control: &Control<f64>;) -> ScaleFreeOutcome =
        Coefficient contact::<W>(0.5, c, material)?.fate(&lifted_control(control)?);

    /// The equilibrium of radius a at n = 1/2.
    pub fn scale_free_state(c: f64, material: &Material<f64>; a: ContactRadius) -> State<Ranged<f64>> =
        Indentation contact::<W>(0.5, c, material)?.scale_free_state(&a.into());
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

/// Kendall's flat punch of the given radius at pull-off.
///
/// # Errors
/// See the [module](super).
pub fn flat_punch_pull_off(radius: f64, material: &Material<f64>) -> Result<State<Ranged<f64>>> {
    positive(Quantity::Radius, radius)?;
    decide!(Quantity::Force, W => crate::flat_punch_pull_off::<W>(&radius.into(), &lifted(material)?))
}
