//! The closed forms under test, reached through one type so that a deliberate fault can be put into any of them.

use mdr_analytic::certified::Question;
use mdr_analytic::{Contact, Critical, Fate, Kappa, PowerLaw};
use mdr_core::contact::{Control, Instability, Material, Result, Transform};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Precision, Real, Special};
use rug::{Float, Rational};

use crate::faults::Fault;
use crate::library::Shape;

mod inverse;

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
    UniversalIndentation,
    UniversalForce,
    EquilibriumRadius,
    EquilibriumIndentation,
    EquilibriumForce,
    DistanceRadius,
    DistanceIndentation,
    DistanceForce,
    ZeroIndentationRadius,
    PullOffLoss,
    JumpInLoss,
    CompleteContactBarrier,
    LemniscateConstant,
    Threshold,
    ScaleFreeRatio,
    ScaleFreeIndentation,
    ScaleFreeForce,
    Fate,
    FlatPunchIndentation,
    FlatPunchForce,
    FlatPunchLimit,
    ParaboloidProfile,
    ConeProfile,
    ConeAngleProfile,
    KappaEnclosure,
    CertifiedKappa,
    CertifiedRadius,
    CertifiedIndentation,
    CertifiedForce,
    CertifiedThreshold,
    CertifiedRatio,
    Library(Shape, Part),
    Double(&'static str),
}

/// The functions of `mdr_analytic::double` that give numbers.
pub(crate) const DOUBLE: [&str; 27] = [
    "double::critical",
    "double::kappa",
    "double::g",
    "double::g_slope",
    "double::g_integral",
    "double::detachment_elongation",
    "double::indentation",
    "double::force",
    "double::indentation_slope",
    "double::force_slope",
    "double::energy",
    "double::universal_indentation",
    "double::universal_force",
    "double::radius_at_zero_indentation",
    "double::energy_lost_at_pull_off",
    "double::energy_lost_at_jump_in",
    "double::barrier_to_complete_contact",
    "double::flat_punch_pull_off",
    "double::machine_folds",
    "double::equilibria",
    "double::equilibria_at_distance",
    "double::Inverse::equilibria",
    "double::Inverse::branches",
    "double::scale_free_state",
    "double::ratio",
    "double::threshold",
    "double::critical_states",
];

/// One of the three closed forms of a profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Part {
    /// g.
    G,
    /// g'.
    Slope,
    /// (1/x)∫₀ˣ g.
    Mean,
}

/// A certified decimal, and a float that holds its digits.
pub(crate) struct Digits {
    pub(crate) decimal: Decimal,
    pub(crate) value: Float,
}

/// A certified answer.
pub(crate) struct Certified {
    pub(crate) kappa: Digits,
    pub(crate) critical: Option<Critical<Digits>>,
    pub(crate) threshold: Option<Digits>,
    pub(crate) ratio: Option<Digits>,
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

    pub(crate) fn universal_indentation<R: Real>(&self, n: &R, scaled: &R) -> Result<R> {
        Ok(self.bend(Form::UniversalIndentation, mdr_analytic::universal_indentation(n, scaled)?, &[scaled]))
    }

    pub(crate) fn universal_force<R: Real>(&self, n: &R, scaled: &R) -> Result<R> {
        Ok(self.bend(Form::UniversalForce, mdr_analytic::universal_force(n, scaled)?, &[scaled]))
    }

    pub(crate) fn radius_at_zero_indentation<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(Form::ZeroIndentationRadius, contact.radius_at_zero_indentation()?, &given(contact)))
    }

    pub(crate) fn energy_lost_at_pull_off<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(Form::PullOffLoss, contact.energy_lost_at_pull_off()?, &given(contact)))
    }

    pub(crate) fn energy_lost_at_jump_in<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(Form::JumpInLoss, contact.energy_lost_at_jump_in()?, &given(contact)))
    }

    pub(crate) fn barrier_to_complete_contact<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(Form::CompleteContactBarrier, contact.barrier_to_complete_contact()?, &given(contact)))
    }

    pub(crate) fn lemniscate_constant<R: Real>(&self, like: &R) -> R {
        self.bend(Form::LemniscateConstant, mdr_analytic::lemniscate_constant(like), &[])
    }

    pub(crate) fn threshold<R: Real>(&self, material: &Material<R>, control: &Control<R>) -> Result<R> {
        let inputs = [material.effective_modulus(), material.work_of_adhesion()];
        Ok(self.bend(Form::Threshold, mdr_analytic::threshold(material, control)?, &inputs))
    }

    pub(crate) fn ratio<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(Form::ScaleFreeRatio, contact.ratio()?, &given(contact)))
    }

    pub(crate) fn scale_free_state<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<Critical<R>> {
        let Critical { contact_radius, indentation, force } = contact.scale_free_state(a)?;
        let inputs = along(contact, a);
        Ok(Critical {
            contact_radius,
            indentation: self.bend(Form::ScaleFreeIndentation, indentation, &inputs),
            force: self.bend(Form::ScaleFreeForce, force, &inputs),
        })
    }

    /// The fate as +1 (shrinks), −1 (complete contact) or 0.
    pub(crate) fn fate<R: Real>(&self, contact: &Contact<R>, control: &Control<R>) -> Result<R> {
        let sign = match contact.fate(control)? {
            Fate::Shrinks => 1,
            Fate::CompleteContact => -1,
            Fate::Indifferent => 0,
        };
        Ok(self.bend(Form::Fate, contact.profile().exponent().lit(sign), &[]))
    }

    pub(crate) fn flat_punch_pull_off<R: Real>(&self, radius: &R, material: &Material<R>) -> Result<Critical<R>> {
        let state = mdr_analytic::flat_punch_pull_off(radius, material)?;
        let inputs = [radius, material.effective_modulus(), material.work_of_adhesion()];
        Ok(Critical {
            contact_radius: state.contact_radius,
            indentation: self.bend(Form::FlatPunchIndentation, state.indentation, &inputs),
            force: self.bend(Form::FlatPunchForce, state.force, &inputs),
        })
    }

    pub(crate) fn flat_punch_limit<R: Real>(&self, contact: &Contact<R>) -> Result<R> {
        Ok(self.bend(
            Form::FlatPunchLimit,
            contact.flat_punch_limit()?.contact_radius,
            &[contact.profile().coefficient()],
        ))
    }

    pub(crate) fn paraboloid<R: Kappa>(&self, radius: &R, x: &R) -> Result<R> {
        Ok(self.bend(Form::ParaboloidProfile, PowerLaw::paraboloid(radius.clone())?.g(x)?, &[radius]))
    }

    pub(crate) fn cone<R: Kappa>(&self, slope: &R, x: &R) -> Result<R> {
        Ok(self.bend(Form::ConeProfile, PowerLaw::cone(slope.clone())?.g(x)?, &[slope]))
    }

    pub(crate) fn cone_with_half_angle<R: Kappa + Special>(&self, angle: &R, x: &R) -> Result<R> {
        Ok(self.bend(Form::ConeAngleProfile, PowerLaw::cone_with_half_angle(angle.clone())?.g(x)?, &[angle]))
    }

    /// A value of the profile library at radius x.
    pub(crate) fn profile<R: Real>(&self, shape: Shape, part: Part, value: R, x: &R) -> R {
        self.bend(Form::Library(shape, part), value, &[x])
    }

    /// A result of the function of that name in `mdr_analytic::double`.
    pub(crate) fn double(&self, name: &'static str, value: f64) -> f64 {
        self.bend(Form::Double(name), value, &[])
    }

    /// Middle and radius of the enclosure of κ_n.
    pub(crate) fn kappa_enclosure(&self, precision: Precision, n: &Rational) -> (Float, Float) {
        let enclosure = mdr_analytic::kappa_enclosure(precision, n);
        (self.bend(Form::KappaEnclosure, enclosure.mid(), &[]), enclosure.radius())
    }

    pub(crate) fn certified(&self, question: &Question, digits: u32) -> Result<Certified> {
        let answer = question.answer(digits)?;
        let bits = Precision::from_digits(digits).bits() + 96;
        let number = |form, decimal: Decimal| {
            let parsed = Float::parse(decimal.to_string()).map(|text| Float::with_val(bits, text));
            let value = self.bend(form, parsed.unwrap_or_else(|_| Float::with_val(bits, f64::NAN)), &[]);
            Digits { decimal, value }
        };
        Ok(Certified {
            kappa: number(Form::CertifiedKappa, answer.kappa),
            critical: answer.critical.map(|state| Critical {
                contact_radius: number(Form::CertifiedRadius, state.contact_radius),
                indentation: number(Form::CertifiedIndentation, state.indentation),
                force: number(Form::CertifiedForce, state.force),
            }),
            threshold: answer.threshold.map(|x| number(Form::CertifiedThreshold, x)),
            ratio: answer.ratio.map(|x| number(Form::CertifiedRatio, x)),
        })
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
