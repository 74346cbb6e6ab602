//! What an output of a scene has to say for itself: its question, who can answer it, and what its answer holds.

use mdr_core::contact::{Control, Error, Result, Status};
use mdr_core::number::Literal;

use super::key::{Key, Keys};
use super::{Output, OutputKind, Want};
use crate::answer::record::{Numbers, Row};
use crate::answer::{AtValue, Column, Completeness, List, Number, NumberStyle, Promise, Value};
use crate::scene::Scene;
use crate::solve::search::{Search, not_proved};
#[cfg(feature = "mp")]
use crate::solve::{certified::Certified, power_law::PowerLaw};

/// What is true of every output of a kind.
pub(crate) struct Facts {
    pub(crate) of: Subject,
    /// The key of `[output]` that no other output has.
    pub(crate) key: Option<Key>,
    /// The question, by the keys of a scene.
    pub(crate) question: fn(&Keys, OutputKind) -> Want,
    /// Why its key is of no use for a scene, which may be drawn; by default, because the output is not wanted.
    pub(crate) unused: fn(&Scene, OutputKind, bool) -> Option<&'static str>,
}

/// What an output describes, and hence what a scene must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    /// The profile alone.
    Profile,
    /// The curve of equilibria.
    Contact,
    /// Single states: the equilibria at values of the controlled quantity, or the start of the path.
    States,
    /// The loading path.
    Path,
}

/// Why the key of an output is of no use: the output is not wanted.
pub(crate) fn not_wanted(scene: &Scene, kind: OutputKind, _drawn: bool) -> Option<&'static str> {
    (!scene.has(|other| other == kind)).then_some("it is not wanted")
}

/// The question of one requested output. Whoever reads a scene needs this alone, and no computation.
pub(crate) trait Request<'w> {
    /// The values of the controlled quantity at which it is requested.
    fn values(&self) -> &'w [Literal] {
        &[]
    }

    /// The contact radii between which all folds are to be proved.
    fn range(&self) -> Option<&'w [Literal; 2]> {
        None
    }

    /// The least number of rows of the output.
    fn rows(&self) -> usize {
        self.values().len().max(1)
    }

    /// The input that its question lacks.
    fn missing(&self) -> Option<&'static str> {
        None
    }

    /// Whether a scene is refused in which its path cannot start.
    fn needs_start(&self) -> bool {
        false
    }
}

/// One requested output, and who can answer it.
pub(crate) trait Room<'w>: Request<'w> {
    /// The outputs at the work of adhesion of an advancing and of a receding edge as one, where it is made of the two.
    fn of_edges(&self, _: [Output; 2]) -> Option<Output> {
        None
    }

    /// The contact radii to which it leads, as far as a search finds them: the proof of folds covers these.
    #[cfg(feature = "mp")]
    fn visited(&self, _: &Search<'_>) -> Vec<f64> {
        Vec::new()
    }

    /// The output by the closed forms of a power law; `None` if there are none for it.
    ///
    /// # Errors
    /// A decision that no precision makes.
    #[cfg(feature = "mp")]
    fn by_law(&self, _: &PowerLaw<'_>) -> Result<Option<Output>> {
        Ok(None)
    }

    /// The output over enclosures; `None` if it cannot be proved.
    ///
    /// # Errors
    /// Errors of the transform and of the proofs.
    #[cfg(feature = "mp")]
    fn proved(&self, _: &Certified<'_>) -> Result<Option<Output>> {
        Ok(None)
    }

    /// The output in f64.
    ///
    /// # Errors
    /// Errors of the transform and of the quadratures.
    fn searched(&self, search: &Search<'_>) -> Result<Output>;

    /// Whether an output in f64 has lost numbers to the ends of the range.
    #[cfg(feature = "mp")]
    fn lost_numbers(&self, _: &Output) -> bool {
        false
    }

    /// Whether an output in f64 has numbers that no quadrature reached, which enclosures may have.
    #[cfg(feature = "mp")]
    fn has_open_numbers(&self, _: &Output) -> bool {
        false
    }

    /// The output of [`searched`](Room::searched), compared with the closed forms of a power law.
    ///
    /// # Errors
    /// A decision that no precision makes.
    #[cfg(feature = "mp")]
    fn confirmed(&self, output: Output, _: &PowerLaw<'_>) -> Result<Output> {
        Ok(output)
    }

    /// The output without numbers, for a reason.
    fn undecided(&self, open: &Open<'_>) -> Output;
}

/// An output that could not be computed.
pub(crate) struct Open<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) error: &'a Error,
    why: String,
}

impl<'a> Open<'a> {
    pub(crate) fn new(scene: &'a Scene, error: &'a Error) -> Self {
        Open { scene, error, why: error.to_string() }
    }

    /// No number.
    pub(crate) fn value<N>(&self) -> Value<N> {
        Value::unknown(Status::Undecided, self.why.as_str())
    }

    /// Of a list in which anything may be missing.
    pub(crate) fn completeness(&self) -> Completeness {
        Completeness { undecided: true, ..not_proved(&format!("undecided: {}", self.why)) }
    }

    /// Each value without states; the start of the path where there is no value.
    pub(crate) fn at_values<T>(&self, values: &[Literal]) -> List<AtValue<T>> {
        let start = self.scene.path.first().into_iter().filter(|_| values.is_empty());
        let items = values.iter().chain(start).map(|value| AtValue::open(value, self.error));
        List::new(Promise::F64, items.collect())
    }

    /// The value that is controlled where the path starts.
    pub(crate) fn start(&self) -> Option<Value> {
        self.scene.path.first().cloned().map(Value::Given)
    }

    pub(crate) fn control(&self) -> &Control<Literal> {
        &self.scene.control
    }
}

/// What an output holds: a list of records, and what stands beside it.
pub(crate) trait Content {
    fn list(&self) -> &dyn Table;

    /// The single records beside the list, by their keys in an answer.
    fn beside(&self) -> Vec<(&'static str, Vec<Row<'_>>)> {
        Vec::new()
    }

    /// The parts with a promise of their own, by their keys.
    fn exceptions(&self) -> Vec<(&'static str, Promise)> {
        Vec::new()
    }

    /// What is beside the list, in a sentence each.
    fn sentences(&self, _: &NumberStyle) -> Vec<String> {
        Vec::new()
    }

    /// Changes every number by `f`, and the promise.
    #[cfg(feature = "mp")]
    fn resolve(&mut self, promise: Promise, f: fn(Number) -> Value);
}

/// A list of records as a table.
pub(crate) trait Table {
    fn promise(&self) -> Promise;

    /// Whether it is complete; `None` if that is not meaningful.
    fn complete(&self) -> Option<&Completeness>;

    /// A row for each record.
    fn rows(&self) -> Vec<Row<'_>>;

    /// The columns that the rows may have.
    fn columns(&self) -> Vec<Column>;
}

impl<T: Numbers<Number>> Table for List<T> {
    fn promise(&self) -> Promise {
        self.promise
    }

    fn complete(&self) -> Option<&Completeness> {
        self.complete.as_ref()
    }

    fn rows(&self) -> Vec<Row<'_>> {
        self.items.rows()
    }

    fn columns(&self) -> Vec<Column> {
        T::columns()
    }
}

impl<T: Numbers<Number, With<Number> = T>> Content for List<T> {
    fn list(&self) -> &dyn Table {
        self
    }

    #[cfg(feature = "mp")]
    fn resolve(&mut self, promise: Promise, f: fn(Number) -> Value) {
        self.items = std::mem::take(&mut self.items).resolve(f);
        self.promise = promise;
    }
}
