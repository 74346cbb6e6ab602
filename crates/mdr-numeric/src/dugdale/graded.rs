//! The Maugis–Dugdale theory on a power-law graded half-space.
//!
//! The surfaces attract each other with the constant stress σ₀ in the ring a < r < c₀. With k of the grading, c its coefficient,
//! Q = 2σ₀cos(πk/2)c₀^(1−k)/(c(1−k)) and θ = arccos(a/c₀), where the pressure is continuous at r = a,
//!
//! * d = g(a) − Q sin^(1−k)θ,
//! * w/σ₀ = (2cos(πk/2)/π)∫₀^θ cotᵏφ [g(c₀cosφ) − g(a) + Q(sin^(1−k)θ − sin^(1−k)φ)] dφ, the gap at c₀,
//! * F = S(a)(d − mean of g) − 2cQc₀^(1+k)∫₀^θ cosᵏφ sin^(2−k)φ dφ.
//!
//! k = 0 is the half-space of the [module above](super).

use mdr_core::calculus::quadrature::tanh_sinh_pieces;
use mdr_core::calculus::{Tolerance, roots};
use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Special;

use super::CohesiveState;
use crate::contact::Contact;

/// The stress of attraction, for errors.
const STRESS: Quantity = Quantity::Parameter("the stress of attraction");

/// The state with the contact radius `a` on a half-space, graded or not, whose surfaces attract each other with the constant
/// `stress` σ₀, in Pa, up to where the work of adhesion is spent: to the separation w/σ₀. The control of the contact is not used.
///
/// ```
/// use mdr_core::contact::Control;
/// use mdr_numeric::contact::Contact;
/// use mdr_numeric::dugdale::state_on_graded;
/// use mdr_numeric::medium::{Adhesion, Medium};
/// use mdr_numeric::transform::{Powers, graded_kappa};
/// let k = 0.3;
/// let square = Powers::new([[2.0, graded_kappa(&2.0, &k), (1.0 + k) / (3.0 + k)]])?;
/// let contact = Contact::new(square, Medium::graded(1.0, k)?, Adhesion::new(0.01)?, Control::Force);
/// let state = state_on_graded(&contact, &1.0, &0.3)?;
/// assert!((state.force / -0.025910427927081933 - 1.0).abs() < 1e-10);
/// // A stronger attraction of the same work acts in a narrower ring.
/// assert!(state_on_graded(&contact, &2.0, &0.3)?.outer_radius < state.outer_radius);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless a and σ₀ are positive and finite, and on a Winkler foundation, a half-plane and a periodic medium;
/// errors of the transform and of the quadrature, and if the ring would reach beyond the profile; [`Error::OutOfRange`] if the
/// force is not representable.
pub fn state_on_graded<R: Special>(curve: &Contact<R>, stress: &R, a: &R) -> Result<CohesiveState<R>> {
    let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
    let stress = Error::require_positive(STRESS, stress.clone())?;
    let Some(k) = curve.medium().exponent(&a) else {
        let requirement = "left out: the theory of a finite range is available on a half-space, graded or not";
        return Err(Error::domain(STRESS, &stress, requirement));
    };
    let (order, half_of_pi) = (a.lit(1) - &k, a.pi().over(2));
    let cosine = (half_of_pi.clone() * &k).cos();
    let transform = curve.transform();
    let edge = transform.g(&a)?;
    let separation = curve.adhesion().work().clone() / &stress;
    // θ and c₀ for a ring as wide as a·share.
    let ring = |share: &R| {
        let angle = (share.clone() * (share.lit(2) + share)).sqrt().atan();
        (angle, (share.lit(1) + share) * &a)
    };
    let strength =
        |outer: &R| (stress.clone() * &cosine).times(2) * outer.pow(&order) / (curve.modulus().clone() * &order);
    let tolerance = || Tolerance::of_cancelling(&a).or_finest_below(a.unit_roundoff().sqrt().times(16));
    // In v = φ^(1−k), in which cotᵏφ dφ is (φ cotφ)ᵏ dv/(1 − k).
    let gap = |share: &R| {
        let (angle, outer) = ring(share);
        let (pull, top) = (strength(&outer), angle.sin().pow(&order));
        let breaks: Vec<R> = transform
            .kinks()
            .into_iter()
            .filter(|kink| *kink > a && *kink < outer)
            .map(|kink| (kink / &outer).acos().pow(&order))
            .collect();
        let whole = tanh_sinh_pieces(&a.lit(0), &angle.pow(&order), &breaks, tolerance(), |v| {
            let phi = v.pow(&order.clone().inv()).lesser(&angle);
            let (sine, cosine) = phi.sin_and_cos();
            let shape = if sine > a.lit(0) { (cosine.clone() / &sine * &phi).pow(&k) } else { a.lit(1) };
            let rise = transform.g(&(cosine * &outer).greater(&a))? - &edge;
            Ok((rise + (top.clone() - sine.pow(&order)) * &pull) * shape)
        })?;
        Ok(whole.value * &cosine / &half_of_pi / &order - &separation)
    };
    let bracket = roots::bracket_geometric(&a.ratio(1, 64), gap)?;
    let bracket = bracket.ok_or_else(|| Error::no_equilibrium(Quantity::ContactRadius, &a))?;
    let share = roots::refine(bracket, &a.unit_roundoff(), gap)?.value;
    let (angle, outer) = ring(&share);
    let pull = strength(&outer);
    let indentation = edge - angle.sin().pow(&order) * &pull;
    let load = tanh_sinh_pieces(&a.lit(0), &angle, &[], tolerance(), |phi| {
        Ok(phi.cos().pow(&k) * phi.sin().pow(&(order.clone() + order.lit(1))))
    })?;
    let ring_force = curve.modulus().clone().times(2) * pull * outer.pow(&(k.lit(1) + &k)) * load.value;
    let force = curve.force_of(&a, &(indentation.clone() - transform.mean(&a)?))? - ring_force;
    Ok(CohesiveState { contact_radius: a, outer_radius: outer, indentation, force })
}
