//! The subjects of the checks: every number that a public function of mdr-analytic gives, in one table.
//!
//! * [`SubjectId`] names a number, [`subjects`] lists all of them with the function each comes from.
//! * `ClosedForms` (module `closed`) evaluates them, with at most one [`Mutation`](mutation::Mutation) of one of them.
//! * `Routine` (module `routine`) is a function of doubles with its exact forms and the formula of textbooks. The check
//!   *double-precision* and the stability ladders take their functions from the modules `double`, `profiles` and
//!   `numerical`.

pub(crate) mod closed;
pub(crate) mod double;
pub(crate) mod mutation;
pub(crate) mod numerical;
pub(crate) mod profiles;
pub(crate) mod routine;
pub(crate) mod textbook;

use self::routine::Routine;
use crate::library::NAMES;

/// A number that a function of mdr-analytic gives.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// Which.
    pub id: SubjectId,
    /// The public function of mdr-analytic, with its type if it is a method.
    pub function: &'static str,
    /// The inputs whose powers a fault may change, in the order in which [`ClosedForms`](crate::ClosedForms) passes them.
    pub inputs: &'static [&'static str],
}

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

/// The ids and the table: a line for each number with a name, and the functions for f64.
macro_rules! subjects {
    (
        named { $($id:ident: $function:literal $inputs:expr;)* }
        double { $($double:literal)* }
    ) => {
        /// A number among the results of a function of mdr-analytic.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[expect(missing_docs, reason = "named after the function and its result")]
        #[non_exhaustive]
        pub enum SubjectId {
            $($id,)*
            Library(&'static str, Part),
            Double(&'static str),
        }

        const NAMED: &[Subject] = &[$(Subject { id: SubjectId::$id, function: $function, inputs: $inputs }),*];

        /// The functions of `mdr_analytic::double` that give numbers.
        pub(crate) const DOUBLE_IDS: &[SubjectId] = &[$(SubjectId::Double(concat!("double::", $double))),*];
    };
}

const GIVEN: &[&str] = &["C", "E*", "w"];
const ALONG: &[&str] = &["a", "C", "E*", "w"];

const MAUGIS: &[&str] = &["R", "E*", "w", "h0", "a", "c"];

subjects! {
    named {
        Kappa: "kappa" &["n"];
        Transform: "PowerLaw::g" &["x", "C"];
        TransformSlope: "PowerLaw::slope" &["x", "C"];
        TransformIntegral: "PowerLaw::integral" &["x", "C"];
        DetachmentElongation: "detachment_elongation" &["a", "E*", "w"];
        Indentation: "Contact::indentation" ALONG;
        IndentationSlope: "Contact::indentation_slope" ALONG;
        Force: "Contact::force" ALONG;
        ForceSlope: "Contact::force_slope" ALONG;
        Energy: "Contact::energy" ALONG;
        CriticalRadius: "Contact::critical" GIVEN;
        CriticalIndentation: "Contact::critical" GIVEN;
        CriticalForce: "Contact::critical" GIVEN;
        LnCriticalRadius: "Contact::ln_critical" GIVEN;
        LnCriticalIndentation: "Contact::ln_critical" GIVEN;
        LnCriticalForce: "Contact::ln_critical" GIVEN;
        MachineFoldRadius: "Contact::machine_folds" GIVEN;
        MachineFoldIndentation: "Contact::machine_folds" GIVEN;
        MachineFoldForce: "Contact::machine_folds" GIVEN;
        UniversalIndentation: "universal_indentation" &["a/a_c"];
        UniversalForce: "universal_force" &["a/a_c"];
        EquilibriumRadius: "Contact::equilibria" GIVEN;
        EquilibriumIndentation: "Contact::equilibria" GIVEN;
        EquilibriumForce: "Contact::equilibria" GIVEN;
        DistanceRadius: "Contact::equilibria_at_distance" GIVEN;
        DistanceIndentation: "Contact::equilibria_at_distance" GIVEN;
        DistanceForce: "Contact::equilibria_at_distance" GIVEN;
        ZeroIndentationRadius: "Contact::radius_at_zero_indentation" GIVEN;
        PullOffLoss: "Contact::energy_lost_at_pull_off" GIVEN;
        JumpInLoss: "Contact::energy_lost_at_jump_in" GIVEN;
        CompleteContactBarrier: "Contact::barrier_to_complete_contact" GIVEN;
        LemniscateConstant: "lemniscate_constant" &[];
        Threshold: "threshold" &["E*", "w"];
        ScaleFreeRatio: "Contact::ratio" GIVEN;
        ScaleFreeIndentation: "Contact::scale_free_state" ALONG;
        ScaleFreeForce: "Contact::scale_free_state" ALONG;
        Fate: "Contact::fate" &[];
        FlatPunchIndentation: "flat_punch_pull_off" &["b", "E*", "w"];
        FlatPunchForce: "flat_punch_pull_off" &["b", "E*", "w"];
        FlatPunchLimit: "Contact::flat_punch_limit" &["C"];
        TaborNumber: "tabor_number" &["R", "E*", "w", "z0"];
        MaugisBalance: "maugis_state" MAUGIS;
        MaugisIndentation: "maugis_state" MAUGIS;
        MaugisForce: "maugis_state" MAUGIS;
        ParaboloidProfile: "PowerLaw::paraboloid" &["R"];
        ConeProfile: "PowerLaw::cone" &["tan θ"];
        ConeAngleProfile: "PowerLaw::cone_with_half_angle" &["α"];
        KappaEnclosure: "kappa_enclosure" &[];
        CertifiedKappa: "Question::answer" &[];
        CertifiedRadius: "Question::answer" &[];
        CertifiedIndentation: "Question::answer" &[];
        CertifiedForce: "Question::answer" &[];
        CertifiedThreshold: "Question::answer" &[];
        CertifiedRatio: "Question::answer" &[];
    }
    double {
        "critical" "kappa" "g" "g_slope" "g_integral" "detachment_elongation" "indentation" "force" "indentation_slope"
        "force_slope" "energy" "universal_indentation" "universal_force" "radius_at_zero_indentation"
        "energy_lost_at_pull_off" "energy_lost_at_jump_in" "barrier_to_complete_contact" "flat_punch_pull_off"
        "machine_folds" "equilibria" "equilibria_at_distance" "Inverse::equilibria" "Inverse::branches"
        "scale_free_state" "ratio" "threshold" "critical_states"
    }
}

const PARTS: [Part; 3] = [Part::G, Part::Slope, Part::Mean];

/// Every part of every profile of the library.
pub(crate) const LIBRARY_IDS: &[SubjectId] = {
    const IDS: [SubjectId; PARTS.len() * NAMES.len()] = {
        let mut ids = [SubjectId::Library("", Part::G); PARTS.len() * NAMES.len()];
        let mut i = 0;
        while i < ids.len() {
            ids[i] = SubjectId::Library(NAMES[i / PARTS.len()], PARTS[i % PARTS.len()]);
            i += 1;
        }
        ids
    };
    &IDS
};

impl SubjectId {
    /// Those of a word of `data/checks.tsv`: one by its name, or all of the library or of the functions for f64.
    pub(crate) fn named(word: &str) -> Option<Vec<SubjectId>> {
        match word {
            "Library" => Some(LIBRARY_IDS.to_vec()),
            "Double" => Some(DOUBLE_IDS.to_vec()),
            name => NAMED.iter().find(|subject| format!("{:?}", subject.id) == name).map(|subject| vec![subject.id]),
        }
    }
}

/// All subjects. The constructor of a profile stands for its three parts.
pub fn subjects() -> Vec<Subject> {
    let grouped = LIBRARY_IDS.iter().chain(DOUBLE_IDS).filter_map(|&id| match id {
        SubjectId::Library(name, _) => {
            let profile = profiles::PROFILES.iter().find(|profile| profile.name == name)?;
            Some(Subject { id, function: profile.constructor, inputs: &["x"] })
        }
        SubjectId::Double(function) => Some(Subject { id, function, inputs: &[] }),
        _ => None,
    });
    NAMED.iter().copied().chain(grouped).collect()
}

/// All functions of doubles, those of mdr-analytic first.
pub(crate) fn routines() -> Vec<Routine> {
    let critical: [&[Routine]; 2] = [&double::CRITICAL_INDENTATION, &double::CRITICAL_FORCE];
    let profiles = profiles::PROFILES.each_ref().map(|profile| &profile.routines[..]);
    let quadratures = profiles::QUADRATURES.each_ref().map(|parts| &parts[..]);
    let searches: [&[Routine]; 2] = [&numerical::FOLDS, &numerical::EQUILIBRIA];
    let groups =
        [&critical, double::ROUTINES, &profiles, profiles::ROUTINES, &quadratures, &searches, numerical::ROUTINES];
    groups.concat().concat()
}
