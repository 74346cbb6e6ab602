//! Adhesion of finite range of a paraboloid: Tabor's number (D. Tabor, J. Colloid Interface Sci. 58 (1977) 2) and the closed
//! equations of D. Maugis, J. Colloid Interface Sci. 150 (1992) 243, in which the surfaces attract each other with the
//! constant stress σ₀ = w/h₀ in a ring a < r < c around the contact.

use mdr_core::contact::{Error, Material, Quantity, Result};
use mdr_core::number::Special;

/// The range of adhesion, for errors.
const RANGE: Quantity = Quantity::Parameter("the range of adhesion");

/// Tabor's number μ = (Rw²/(E*²z₀³))^(1/3) of a paraboloid with the radius of curvature R and the range z₀ of adhesion, in m:
/// the elongation of the edge over the range, up to a factor. Above 5 the theory of short range holds (JKR), below 0.1 that
/// of long range (DMT).
///
/// ```
/// use mdr_core::contact::Material;
/// // A bead of 10 µm on soft rubber, and a tip of 10 nm on a polymer, z₀ = 0.3 nm.
/// assert!(mdr_analytic::tabor_number(&10e-6, &Material::new(1e6, 0.05)?, &0.3e-9)? > 900.0);
/// assert!(mdr_analytic::tabor_number(&10e-9, &Material::new(5e9, 0.05)?, &0.3e-9)? < 0.4);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless R and z₀ are positive and finite.
pub fn tabor_number<R: Special>(radius: &R, material: &Material<R>, range: &R) -> Result<R> {
    let radius = Error::require_positive(Quantity::Radius, radius.clone())?;
    let range = Error::require_positive(RANGE, range.clone())?;
    let length = material.work_of_adhesion().clone() / material.effective_modulus();
    Ok(cube_root(&((length / &range).square() * (radius / range))))
}

/// A contact of a paraboloid with a ring of attraction.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MaugisState<R> {
    /// The gap at the end of the ring over h₀: 1 in equilibrium.
    pub balance: R,
    /// d, in m.
    pub indentation: R,
    /// F, in N.
    pub force: R,
}

/// The state of a paraboloid of radius of curvature R with the contact radius `a`, attraction up to the radius `c`, and the
/// separation h₀ up to which the surfaces attract each other, all in m. With K = 4E*/3, m = c/a, t = √(m² − 1) and θ = arctan t,
///
/// * λ = 2σ₀ (R/(πwK²))^(1/3), ã = a (K/(πwR²))^(1/3),
/// * (λã²/2)[t + (m² − 2)θ] + (4λ²ã/3)[tθ − m + 1] = gap/h₀, the `balance`,
/// * F = πwR {ã³ − λã²[t + m²θ]} and d = (π²w²R/K²)^(1/3) {ã² − (4/3)λã t}.
///
/// The balance loses 1/(m − 1) where the ring is thin.
///
/// ```
/// use mdr_core::contact::Material;
/// // c is not that of an equilibrium: the gap at it is only 56 % of the separation.
/// let state = mdr_analytic::maugis_state(&1.0, &Material::new(1.0, 1e-6)?, &1e-4, &0.0125, &0.015)?;
/// assert!(0.3 < state.balance && state.balance < 0.7);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless all lengths are positive and finite and c > a.
pub fn maugis_state<R: Special>(
    radius: &R,
    material: &Material<R>,
    separation: &R,
    a: &R,
    c: &R,
) -> Result<MaugisState<R>> {
    let radius = Error::require_positive(Quantity::Radius, radius.clone())?;
    let separation = Error::require_positive(RANGE, separation.clone())?;
    let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
    let width = Error::require_positive(Quantity::Parameter("c - a, the width of the ring"), c.clone() - &a)?;
    let (one, ratio) = (a.lit(1), c.clone() / &a);
    let leg = (width / &a * (ratio.clone() + &one)).sqrt();
    let angle = leg.atan();
    let modulus = material.effective_modulus().clone().times(4).over(3);
    let adhesion = material.work_of_adhesion().clone() * a.pi();
    // Lengths over R: (πw/KR)^(1/3) is that of the contact, its square that of the indentation.
    let unit = cube_root(&(adhesion.clone() / &modulus / &radius));
    let strength = material.work_of_adhesion().clone() / &separation / &modulus;
    let lambda = (strength / &unit).times(2);
    let reduced = a / &radius / &unit;
    let opening = leg.clone() + (ratio.square() - one.clone().times(2)) * &angle;
    let elastic = leg.clone() * &angle - &ratio + &one;
    let pulled = lambda.clone() * &reduced;
    let balance = (pulled.clone() * &reduced * opening).over(2) + (pulled.clone() * &lambda * elastic).times(4).over(3);
    let attraction = pulled.clone() * &reduced * (leg.clone() + ratio.square() * angle);
    Ok(MaugisState {
        balance,
        indentation: (reduced.square() - (pulled * leg).times(4).over(3)) * unit.square() * &radius,
        force: (reduced.powi(3) - attraction) * adhesion * radius,
    })
}

fn cube_root<R: Special>(x: &R) -> R {
    x.pow(&x.ratio(1, 3))
}
