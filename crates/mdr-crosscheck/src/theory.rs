//! The closed forms under test, reached through one type so that a deliberate fault can be put into any of them.

use mdr_analytic::{Contact, Critical, Kappa, PowerLaw};
use mdr_core::contact::{Control, Instability, Material, Result, Transform};
use mdr_core::number::Real;

use crate::faults::Fault;

/// The closed forms of mdr-analytic, as they are or with one deliberate fault.
///
/// Every method is the closed form of the same name; its result passes through the fault, if it is the one meant.
#[derive(Clone, Debug, Default)]
pub struct Theory {
    fault: Option<Fault>,
}

/// A number among the results of a closed form of mdr-analytic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "named after the function and its result")]
#[non_exhaustive]
pub enum Form {
    Kappa,
    Transform,
    TransformSlope,
    TransformIntegral,
    DetachmentElongation,
    Indentation,
    IndentationSlope,
    Force,
    ForceSlope,
    Energy,
    CriticalRadius,
    CriticalIndentation,
    CriticalForce,
    LnCriticalRadius,
    LnCriticalIndentation,
    LnCriticalForce,
    MachineFoldRadius,
    MachineFoldIndentation,
    MachineFoldForce,
}

impl Theory {
    /// The closed forms with one fault.
    pub fn with(fault: Fault) -> Self {
        Theory { fault: Some(fault) }
    }

    /// `value`, changed if `form` is the faulty one. `inputs` are those named in the table of faults.
    fn bend<R: Real>(&self, form: Form, value: R, inputs: &[&R]) -> R {
        match &self.fault {
            Some(fault) if fault.form == form => fault.apply(value, inputs),
            _ => value,
        }
    }

    pub(crate) fn kappa<R: Kappa>(&self, n: &R) -> Result<R> {
        Ok(self.bend(Form::Kappa, mdr_analytic::kappa(n)?, &[n]))
    }

    pub(crate) fn g<R: Real>(&self, profile: &PowerLaw<R>, x: &R) -> Result<R> {
        Ok(self.bend(Form::Transform, profile.g(x)?, &[x, profile.coefficient()]))
    }

    pub(crate) fn slope<R: Real>(&self, profile: &PowerLaw<R>, x: &R) -> Result<R> {
        Ok(self.bend(Form::TransformSlope, profile.slope(x)?, &[x, profile.coefficient()]))
    }

    pub(crate) fn integral<R: Real>(&self, profile: &PowerLaw<R>, x: &R) -> Result<R> {
        Ok(self.bend(Form::TransformIntegral, profile.integral(x)?, &[x, profile.coefficient()]))
    }

    pub(crate) fn detachment_elongation<R: Real>(&self, material: &Material<R>, a: &R) -> Result<R> {
        let value = mdr_analytic::detachment_elongation(material, a)?;
        let inputs = [a, material.effective_modulus(), material.work_of_adhesion()];
        Ok(self.bend(Form::DetachmentElongation, value, &inputs))
    }

    pub(crate) fn indentation<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        Ok(self.bend(Form::Indentation, contact.indentation(a)?, &along(contact, a)))
    }

    pub(crate) fn indentation_slope<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        Ok(self.bend(Form::IndentationSlope, contact.indentation_slope(a)?, &along(contact, a)))
    }

    pub(crate) fn force<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        Ok(self.bend(Form::Force, contact.force(a)?, &along(contact, a)))
    }

    pub(crate) fn force_slope<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        Ok(self.bend(Form::ForceSlope, contact.force_slope(a)?, &along(contact, a)))
    }

    pub(crate) fn energy<R: Real>(&self, contact: &Contact<R>, a: &R, d: &R) -> Result<R> {
        Ok(self.bend(Form::Energy, contact.energy(a, d)?, &along(contact, a)))
    }

    pub(crate) fn critical<R: Real>(&self, contact: &Contact<R>, control: &Control<R>) -> Result<Critical<R>> {
        let Critical { contact_radius, indentation, force } = contact.critical(control)?;
        let inputs = given(contact);
        Ok(Critical {
            contact_radius: self.bend(Form::CriticalRadius, contact_radius, &inputs),
            indentation: self.bend(Form::CriticalIndentation, indentation, &inputs),
            force: self.bend(Form::CriticalForce, force, &inputs),
        })
    }

    pub(crate) fn ln_critical<R: Real>(&self, contact: &Contact<R>, control: &Control<R>) -> Result<Critical<R>> {
        let Critical { contact_radius, indentation, force } = contact.ln_critical(control)?;
        let inputs = given(contact);
        Ok(Critical {
            contact_radius: self.bend(Form::LnCriticalRadius, contact_radius, &inputs),
            indentation: self.bend(Form::LnCriticalIndentation, indentation, &inputs),
            force: self.bend(Form::LnCriticalForce, force, &inputs),
        })
    }

    pub(crate) fn machine_folds<R: Real>(&self, contact: &Contact<R>, stiffness: &R) -> Result<Vec<Instability<R>>> {
        let inputs = given(contact);
        let bent = |fold: Instability<R>| Instability {
            contact_radius: self.bend(Form::MachineFoldRadius, fold.contact_radius, &inputs),
            indentation: self.bend(Form::MachineFoldIndentation, fold.indentation, &inputs),
            force: self.bend(Form::MachineFoldForce, fold.force, &inputs),
            kind: fold.kind,
        };
        Ok(contact.machine_folds(stiffness)?.into_iter().map(bent).collect())
    }
}

/// C, E*, w: what a critical state depends on beside n.
fn given<R: Real>(contact: &Contact<R>) -> [&R; 3] {
    let (profile, material) = (contact.profile(), contact.material());
    [profile.coefficient(), material.effective_modulus(), material.work_of_adhesion()]
}

/// a, C, E*, w: what a state along the equilibria depends on beside n.
fn along<'a, R: Real>(contact: &'a Contact<R>, a: &'a R) -> [&'a R; 4] {
    let [c, e_star, work] = given(contact);
    [a, c, e_star, work]
}
