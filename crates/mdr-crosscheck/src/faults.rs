//! Deliberate faults: what a mistake in a closed form would look like.

use std::fmt;

use mdr_core::number::Real;

use crate::library::Shape;
use crate::theory::{DOUBLE, Form, Part};

/// One mistake in one closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// Where.
    pub form: Form,
    /// What.
    pub mistake: Mistake,
}

/// A kind of mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Mistake {
    /// The opposite sign.
    Sign,
    /// A factor p/q too much.
    Factor(i64, i64),
    /// A factor 1 + 2⁻ᵏ too much: what double precision can just see.
    Slight(i64),
    /// The power of the named input is wrong by p/q.
    Exponent {
        /// Its place among the inputs of the form.
        input: usize,
        /// Its name.
        name: &'static str,
        /// p.
        p: i64,
        /// q.
        q: i64,
    },
}

impl Fault {
    /// The wrong value in the place of the right one.
    pub(crate) fn apply<R: Real>(&self, value: R, inputs: &[&R]) -> R {
        match self.mistake {
            Mistake::Sign => -value,
            Mistake::Factor(p, q) => value.times(p).over(q),
            Mistake::Slight(k) => value.lit(2).powi(-k) * &value + &value,
            Mistake::Exponent { input, p, q, .. } => value.clone() * inputs[input].pow(&value.ratio(p, q)),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: ", self.form)?;
        match self.mistake {
            Mistake::Sign => f.write_str("wrong sign"),
            Mistake::Factor(p, q) => write!(f, "factor {p}/{q}"),
            Mistake::Slight(k) => write!(f, "factor 1 + 2^-{k}"),
            Mistake::Exponent { name, p, q, .. } => write!(f, "power of {name} wrong by {p}/{q}"),
        }
    }
}

/// A closed form with the public function it comes from and the names of its inputs, in the order of
/// [`Theory`](crate::Theory).
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Which.
    pub form: Form,
    /// The public function of mdr-analytic, with its type if it is a method.
    pub function: &'static str,
    /// What it depends on.
    pub inputs: &'static [&'static str],
}

const fn entry(form: Form, function: &'static str, inputs: &'static [&'static str]) -> Entry {
    Entry { form, function, inputs }
}

const GIVEN: &[&str] = &["C", "E*", "w"];
const ALONG: &[&str] = &["a", "C", "E*", "w"];

/// The parts of a profile of the library, which its constructor stands for.
fn library(shape: Shape, function: &'static str) -> impl Iterator<Item = Entry> {
    [Part::G, Part::Slope, Part::Mean].into_iter().map(move |part| entry(Form::Library(shape, part), function, &["x"]))
}

/// All closed forms under test.
pub fn forms() -> Vec<Entry> {
    let library = LIBRARY.iter().flat_map(|&(shape, function)| library(shape, function));
    let double = DOUBLE.iter().map(|&name| entry(Form::Double(name), name, &[]));
    FORMS.iter().copied().chain(library).chain(double).collect()
}

const LIBRARY: [(Shape, &str); 15] = [
    (Shape::Cone, "Cone::new"),
    (Shape::Paraboloid, "Paraboloid::new"),
    (Shape::Sphere, "Sphere::new"),
    (Shape::Ellipsoid, "Ellipsoid::new"),
    (Shape::Hyperboloid, "Hyperboloid::new"),
    (Shape::TruncatedCone, "TruncatedCone::new"),
    (Shape::TruncatedParaboloid, "TruncatedParaboloid::new"),
    (Shape::RoundedPunch, "RoundedPunch::new"),
    (Shape::ParabolicCapCone, "ParabolicCapCone::new"),
    (Shape::SphericalCapCone, "SphericalCapCone::new"),
    (Shape::DisplacedParaboloid, "DisplacedParaboloid::new"),
    (Shape::ParabolicDimple, "ParabolicDimple::new"),
    (Shape::EllipticalDimple, "EllipticalDimple::new"),
    (Shape::WavyParaboloid, "WavyParaboloid::new"),
    (Shape::Sum, "Sum::new"),
];

/// Those with a name of their own.
const FORMS: &[Entry] = &[
    entry(Form::Kappa, "kappa", &["n"]),
    entry(Form::Transform, "PowerLaw::g", &["x", "C"]),
    entry(Form::TransformSlope, "PowerLaw::slope", &["x", "C"]),
    entry(Form::TransformIntegral, "PowerLaw::integral", &["x", "C"]),
    entry(Form::DetachmentElongation, "detachment_elongation", &["a", "E*", "w"]),
    entry(Form::Indentation, "Contact::indentation", ALONG),
    entry(Form::IndentationSlope, "Contact::indentation_slope", ALONG),
    entry(Form::Force, "Contact::force", ALONG),
    entry(Form::ForceSlope, "Contact::force_slope", ALONG),
    entry(Form::Energy, "Contact::energy", ALONG),
    entry(Form::CriticalRadius, "Contact::critical", GIVEN),
    entry(Form::CriticalIndentation, "Contact::critical", GIVEN),
    entry(Form::CriticalForce, "Contact::critical", GIVEN),
    entry(Form::LnCriticalRadius, "Contact::ln_critical", GIVEN),
    entry(Form::LnCriticalIndentation, "Contact::ln_critical", GIVEN),
    entry(Form::LnCriticalForce, "Contact::ln_critical", GIVEN),
    entry(Form::MachineFoldRadius, "Contact::machine_folds", GIVEN),
    entry(Form::MachineFoldIndentation, "Contact::machine_folds", GIVEN),
    entry(Form::MachineFoldForce, "Contact::machine_folds", GIVEN),
    entry(Form::UniversalIndentation, "universal_indentation", &["a/a_c"]),
    entry(Form::UniversalForce, "universal_force", &["a/a_c"]),
    entry(Form::EquilibriumRadius, "Contact::equilibria", GIVEN),
    entry(Form::EquilibriumIndentation, "Contact::equilibria", GIVEN),
    entry(Form::EquilibriumForce, "Contact::equilibria", GIVEN),
    entry(Form::DistanceRadius, "Contact::equilibria_at_distance", GIVEN),
    entry(Form::DistanceIndentation, "Contact::equilibria_at_distance", GIVEN),
    entry(Form::DistanceForce, "Contact::equilibria_at_distance", GIVEN),
    entry(Form::ZeroIndentationRadius, "Contact::radius_at_zero_indentation", GIVEN),
    entry(Form::PullOffLoss, "Contact::energy_lost_at_pull_off", GIVEN),
    entry(Form::JumpInLoss, "Contact::energy_lost_at_jump_in", GIVEN),
    entry(Form::CompleteContactBarrier, "Contact::barrier_to_complete_contact", GIVEN),
    entry(Form::LemniscateConstant, "lemniscate_constant", &[]),
    entry(Form::Threshold, "threshold", &["E*", "w"]),
    entry(Form::ScaleFreeRatio, "Contact::ratio", GIVEN),
    entry(Form::ScaleFreeIndentation, "Contact::scale_free_state", ALONG),
    entry(Form::ScaleFreeForce, "Contact::scale_free_state", ALONG),
    entry(Form::Fate, "Contact::fate", &[]),
    entry(Form::FlatPunchIndentation, "flat_punch_pull_off", &["b", "E*", "w"]),
    entry(Form::FlatPunchForce, "flat_punch_pull_off", &["b", "E*", "w"]),
    entry(Form::FlatPunchLimit, "Contact::flat_punch_limit", &["C"]),
    entry(Form::ParaboloidProfile, "PowerLaw::paraboloid", &["R"]),
    entry(Form::ConeProfile, "PowerLaw::cone", &["tan θ"]),
    entry(Form::KappaEnclosure, "kappa_enclosure", &[]),
    entry(Form::CertifiedKappa, "Question::answer", &[]),
    entry(Form::CertifiedRadius, "Question::answer", &[]),
    entry(Form::CertifiedIndentation, "Question::answer", &[]),
    entry(Form::CertifiedForce, "Question::answer", &[]),
    entry(Form::CertifiedThreshold, "Question::answer", &[]),
    entry(Form::CertifiedRatio, "Question::answer", &[]),
    entry(Form::ConeAngleProfile, "PowerLaw::cone_with_half_angle", &["α"]),
];

/// The mistakes that every closed form must be caught with.
pub fn faults() -> impl Iterator<Item = Fault> {
    forms().into_iter().flat_map(|Entry { form, inputs, .. }| {
        let general = [Mistake::Sign, Mistake::Factor(3, 2), Mistake::Factor(1, 2), Mistake::Slight(36)];
        let powers = inputs
            .iter()
            .enumerate()
            .flat_map(|(input, &name)| [(1, 2), (-1, 1)].map(|(p, q)| Mistake::Exponent { input, name, p, q }));
        general.into_iter().chain(powers).map(move |mistake| Fault { form, mistake })
    })
}
