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

pub use self::closed::SubjectId;
use self::closed::{DOUBLE_IDS, NAMED};
use self::profiles::NAMES;
use self::routine::Routine;

/// A number that a function of mdr-analytic gives.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
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

const PARTS: [Part; 3] = [Part::G, Part::Slope, Part::Mean];

/// Every part of every profile of the library.
fn library_ids() -> impl Iterator<Item = SubjectId> {
    NAMES.into_iter().flat_map(|name| PARTS.map(|part| SubjectId::Library(name, part)))
}

impl SubjectId {
    /// The subjects of a word of `data/checks.tsv`: one by its name, or all of the library or of the functions for f64.
    pub(crate) fn named(word: &str) -> Option<Vec<SubjectId>> {
        match word {
            "Library" => Some(library_ids().collect()),
            "Double" => Some(DOUBLE_IDS.to_vec()),
            name => NAMED.iter().find(|subject| format!("{:?}", subject.id) == name).map(|subject| vec![subject.id]),
        }
    }
}

/// All subjects. The constructor of a profile stands for its three parts.
pub fn subjects() -> Vec<Subject> {
    let grouped = library_ids().chain(DOUBLE_IDS.iter().copied()).filter_map(|id| match id {
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
