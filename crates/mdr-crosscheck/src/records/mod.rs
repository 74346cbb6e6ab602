//! Generation of the certified records of `mdr-reference`.
//!
//! Every value is enclosed to fifty digits by a rigorous method and confirmed by a second one that shares no formula with
//! the first. [`generate`] gives the files of the release, bit for bit the same on every machine.

mod condition;
mod confirm;
mod contacts;
mod draft;
mod edges;
mod equilibria;
mod folds;
mod library;
mod list;
mod load;
mod machine;
mod power;
mod shapes;
mod states;
mod worst;

use mdr_analytic::certified::{Elasticity, Question};
use mdr_core::contact::{Control, Error};
use mdr_reference::Record;
use rayon::prelude::*;
use thiserror::Error as ThisError;

use load::Load;
use power::Power;

/// Why a record cannot be certified.
#[derive(Clone, Debug, PartialEq, ThisError)]
#[error("{case}: {what}")]
pub struct RecordError {
    case: String,
    what: String,
}

impl RecordError {
    fn of(case: &str, error: Error) -> Self {
        RecordError { case: case.to_owned(), what: error.to_string() }
    }

    fn missing(case: &str, what: &str) -> Self {
        RecordError { case: case.to_owned(), what: format!("there is no {what}") }
    }

    /// An error unless the second method agrees.
    fn unless(case: &str, what: &str, agrees: mdr_core::contact::Result<bool>) -> Result<(), Self> {
        match agrees {
            Ok(true) => Ok(()),
            Ok(false) => Err(RecordError {
                case: case.to_owned(),
                what: format!("the second method has another value of {what}"),
            }),
            Err(error) => {
                Err(RecordError { case: case.to_owned(), what: format!("{what}, by the second method: {error}") })
            }
        }
    }
}

/// A question, or a few that are answered together, and the file that its records belong to.
pub struct RecordCase {
    file: &'static str,
    build: Box<dyn Fn() -> Result<Vec<Record>, RecordError> + Send + Sync>,
}

impl RecordCase {
    fn new(
        file: &'static str,
        build: impl Fn() -> Result<Vec<Record>, RecordError> + Send + Sync + 'static,
    ) -> RecordCase {
        RecordCase { file, build: Box::new(build) }
    }

    /// The name of the file, without a folder.
    pub fn file(&self) -> &'static str {
        self.file
    }

    /// Certifies and confirms its records.
    ///
    /// # Errors
    /// Where a digit cannot be decided, or the second method disagrees.
    pub fn records(&self) -> Result<Vec<Record>, RecordError> {
        (self.build)()
    }
}

/// All cases in the order of their records.
pub fn record_cases() -> Vec<RecordCase> {
    let mut cases = critical_cases();
    cases.extend(equilibria_cases());
    cases.extend(profile_cases());
    cases.extend(edge_cases());
    cases.extend(each("worst.jsonl", worst::questions(), |question| question.records()));
    cases
}

/// A case for each of several things.
fn each<T: Send + Sync + 'static>(
    file: &'static str,
    things: impl IntoIterator<Item = T>,
    build: impl Fn(&T) -> Result<Vec<Record>, RecordError> + Clone + Send + Sync + 'static,
) -> impl Iterator<Item = RecordCase> {
    things.into_iter().map(move |thing| {
        let build = build.clone();
        RecordCase::new(file, move || build(&thing))
    })
}

/// Power laws: where they lose their equilibrium.
fn critical_cases() -> Vec<RecordCase> {
    const FILE: &str = "critical.jsonl";
    let mut cases = Vec::new();
    cases.extend(each(FILE, list::all(), critical));
    cases.extend(each(FILE, list::scale_free(), machine::thresholds));
    cases.extend(each(FILE, list::jumps(), |(law, jump)| Ok(vec![machine::jump(law, *jump)?])));
    cases.extend(each(FILE, list::machines(), |(law, stiffness)| machine::folds(law, stiffness)));
    cases
}

/// Power laws: the states at a given load, of which there are two, one or none.
fn equilibria_cases() -> Vec<RecordCase> {
    const FILE: &str = "equilibria.jsonl";
    let mut cases = Vec::new();
    cases.extend(each(FILE, list::equilibria(), |equilibrium| equilibrium.records()));
    cases.extend(each(FILE, list::double_roots(), |fold| fold.double_root()));
    cases.extend(each(FILE, list::past_folds(), |equilibrium| equilibrium.none()));
    cases
}

/// All other profiles.
fn profile_cases() -> Vec<RecordCase> {
    const FILE: &str = "profiles.jsonl";
    let mut cases = Vec::new();
    for (profile, radii) in shapes::LIBRARY {
        cases.extend(each(FILE, radii, move |x| profile.at(x)));
    }
    for scene in shapes::SCENES {
        cases.extend(each(FILE, [Load::Indentation, Load::Force], move |load| scene.records(*load)));
    }
    cases.extend(each(FILE, shapes::machines(), |(scene, stiffness)| {
        scene.records(Load::Machine(stiffness)).map(of_second_release)
    }));
    cases.extend(each(FILE, shapes::contacts(), |contacts| contacts.records().map(of_second_release)));
    for (scene, radii) in shapes::states() {
        cases.extend(each(FILE, radii, move |a| scene.state(a).map(of_second_release)));
    }
    cases.extend(each(FILE, shapes::PUNCHES, |punch| punch.pull_off().map(of_second_release)));
    cases
}

/// Questions without a number for an answer.
fn edge_cases() -> Vec<RecordCase> {
    const FILE: &str = "edges.jsonl";
    let mut cases = Vec::new();
    cases.extend(each(FILE, list::outside(), edges::no_question));
    cases.extend(each(FILE, shapes::BEYOND, |(profile, x)| edges::beyond(profile, x)));
    cases.extend(each(FILE, shapes::INSIDE, |a| edges::interpenetrating(a)));
    cases
}

/// These records belong to the second release.
fn of_second_release(mut records: Vec<Record>) -> Vec<Record> {
    records.iter_mut().for_each(|record| record.release = 2);
    records
}

fn critical(law: &Power) -> Result<Vec<Record>, RecordError> {
    // Contacts of the same exponent share their kappa.
    let mut records = Vec::new();
    if !law.flags.iter().any(|flag| ["si", "extreme-scale"].contains(flag)) && !law.name.ends_with("-loaded") {
        records.push(law.kappa()?);
    }
    for held in &law.held {
        records.extend(law.critical(*held)?);
    }
    Ok(records)
}

/// The files of the release: name and content.
///
/// # Errors
/// The first case that cannot be certified.
pub fn generate() -> Result<Vec<(&'static str, String)>, RecordError> {
    let cases = record_cases();
    let records: Vec<_> = cases.par_iter().map(RecordCase::records).collect();
    let mut files: Vec<(&'static str, String)> = Vec::new();
    for (case, records) in cases.iter().zip(records) {
        if files.last().is_none_or(|(name, _)| *name != case.file) {
            files.push((case.file, String::new()));
        }
        if let Some((_, content)) = files.last_mut() {
            content.extend(records?.iter().map(|record| record.to_json() + "\n"));
        }
    }
    Ok(files)
}

/// Questions whose cost is measured.
#[derive(Clone, Copy, Debug)]
pub enum Specimen {
    /// The critical state of a sphere under a dead load.
    Critical,
    /// Its stable equilibrium at 15/16 of the critical indentation.
    Equilibrium,
    /// g, g' and ∫g of a paraboloid with waves, at a point.
    Transform,
    /// All folds of such a contact under fixed grips: three.
    Folds,
}

impl Specimen {
    /// All of them.
    pub const ALL: [Specimen; 4] = [Specimen::Critical, Specimen::Equilibrium, Specimen::Transform, Specimen::Folds];

    /// Certifies it to so many digits.
    ///
    /// # Errors
    /// Where a digit cannot be decided.
    pub fn certify(self, digits: u32) -> Result<(), RecordError> {
        self.answer(digits).map_err(|error| RecordError::of(&format!("{self:?}"), error))
    }

    fn answer(self, digits: u32) -> mdr_core::contact::Result<()> {
        let law = Power::new("sphere", ["2", "0.5", "1", "1"], &[]);
        let waves = shapes::named("figure-4");
        match self {
            Specimen::Critical => {
                let [n, c, e_star, work] = law.texts().map(|text| draft::literal(text));
                let elasticity = Elasticity::Effective(e_star);
                Question::new(&n, &c, &elasticity, &work, &Control::Force)?.answer(digits)?;
            }
            Specimen::Equilibrium => {
                let target = equilibria::Target::Share("0.0625".to_owned());
                let (held, side, label) = (power::Held::Indentation, equilibria::Side::Outer, String::new());
                equilibria::Equilibrium { law, held, target, side, label }.certified(digits)?;
            }
            Specimen::Transform => {
                waves.profile.certified("0.0645", digits)?;
            }
            Specimen::Folds => {
                for fold in waves.proved(Load::Indentation)?.folds {
                    waves.certified(&fold, Load::Indentation, digits)?;
                }
            }
        }
        Ok(())
    }
}
