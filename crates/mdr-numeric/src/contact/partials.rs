//! How states and folds move with the numbers of a contact.

use mdr_core::contact::{Result, Transform};
use mdr_core::number::{Dual, Real};

use super::Contact;

/// A number of a contact, on whose logarithm derivatives are taken.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub enum Input<'t, R: Real> {
    /// The modulus of the medium: E* of a half-space.
    Modulus,
    /// The work of adhesion.
    WorkOfAdhesion,
    /// A number of the profile, by the transform over dual numbers that carry the derivatives with respect to its logarithm.
    Profile(&'t dyn Transform<Dual<R>>),
}

impl<R: Real> Input<'_, R> {
    /// ∂d/∂ln x and ∂F/∂ln x at a fixed contact radius, by the stiffness S, the edge elongation Δl and the force of the state there.
    /// [`Contact::partials`] has the formulas.
    ///
    /// # Errors
    /// Errors of the transform at a.
    pub fn partials(&self, a: &R, stiffness: &R, elongation: &R, force: &R) -> Result<[R; 2]> {
        let half = elongation.clone().over(2);
        let lever = stiffness.clone() * &half;
        Ok(match self {
            Input::Modulus => [half, lever + force],
            Input::WorkOfAdhesion => [-half, -lever],
            Input::Profile(seeded) => {
                let fixed = Dual::constant(a.clone());
                let depth = seeded.g(&fixed)?.slope;
                let force = (depth.clone() - &seeded.mean(&fixed)?.slope) * stiffness;
                [depth, force]
            }
        })
    }
}

impl<R: Real> Contact<R> {
    /// ∂d/∂ln x and ∂F/∂ln x of the equilibrium with the contact radius a, which is fixed, for an input x.
    ///
    /// With (1.5) and (1.6), d = g − Δl and F = S(d − mean of g), where S grows with the modulus and Δl with the root of the work
    /// of adhesion over it: (Δl/2, F + SΔl/2) for the modulus, (−Δl/2, −SΔl/2) for the work of adhesion, and (∂g, S(∂g − mean of
    /// ∂g)) for a number of the profile.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Shape};
    /// use mdr_core::number::Dual;
    /// use mdr_numeric::contact::{Contact, Input};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::transform::Quadrature;
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1e-6 }])?;
    /// let contact = Contact::new(ball, Medium::half_space(1e6)?, Adhesion::new(0.05)?, Control::Force);
    /// // R with the derivative with respect to ln R, which is R: g = a²/R falls by itself.
    /// let seeded = Quadrature::of([Shape::Paraboloid { radius: Dual { value: 1e-6, slope: 1e-6 } }])?;
    /// let a = 5e-7;
    /// let [d, _] = contact.partials(&a, Input::Profile(&seeded))?;
    /// assert!((d / -contact.transform().g(&a)? - 1.0).abs() < 1e-12);
    /// let [_, force] = contact.partials(&a, Input::Modulus)?;
    /// let [_, other] = contact.partials(&a, Input::WorkOfAdhesion)?;
    /// // F has the dimension of both: it doubles with them.
    /// assert!(((force + other) / contact.force(&a)? - 1.0).abs() < 1e-12);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::g`].
    pub fn partials(&self, a: &R, input: Input<'_, R>) -> Result<[R; 2]> {
        input.partials(a, &self.stiffness(a), &self.elongation(a), &self.force(a)?)
    }
}

impl<R: Real> Contact<Dual<R>> {
    /// A contact radius with its derivative with respect to the input that the numbers of this contact carry, where a residual
    /// stays zero while the input changes: a fold, or an equilibrium at a fixed force. By the implicit function theorem.
    ///
    /// Both derivatives of the residual are with respect to logarithms, so that their difference keeps its digits at any scale.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Shape};
    /// use mdr_core::number::Dual;
    /// use mdr_numeric::contact::Contact;
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::transform::Quadrature;
    /// // JKR's pull-off at a³ = 9πwR²/8E*, here with the derivative with respect to ln w: a grows with the cube root of w.
    /// let [one, w] = [Dual::constant(1.0), Dual { value: 0.01, slope: 0.01 }];
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: one.clone() }])?;
    /// let contact = Contact::new(ball, Medium::half_space(one)?, Adhesion::new(w)?, Control::Force);
    /// let a = (9.0 * std::f64::consts::PI * 0.01 / 8.0).cbrt();
    /// let fold = contact.moved(&a, |a| Ok(contact.tangency(a)? - contact.critical_ratio(a)?))?;
    /// assert!((fold.slope / fold.value - 1.0 / 3.0).abs() < 1e-12);
    /// // F = −3/2 πwR is proportional to w.
    /// let force = contact.force(&fold)?;
    /// assert!((force.slope / force.value - 1.0).abs() < 1e-12);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the residual.
    pub fn moved(&self, a: &R, residual: impl Fn(&Dual<R>) -> Result<Dual<R>>) -> Result<Dual<R>> {
        let along = residual(&Dual::constant(a.clone()))?.slope;
        let total = residual(&Dual { value: a.clone(), slope: a.clone() })?.slope;
        let across = total - &along;
        Ok(Dual { value: a.clone(), slope: -along / across * a })
    }
}
