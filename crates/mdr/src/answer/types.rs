//! What the records of an answer have in common. Lengths in metres, forces in newtons, energies in joules, pressures in pascals.

use mdr_core::contact::{self, Stability, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::GapVerdict;

use super::column::Column;
use super::record::{Cell, Numbers, Part, Row, record};
use super::value::{Number, Promise, Value};

/// Whether a state is admissible: whether the surfaces are apart everywhere outside the contact.
#[derive(Clone, Debug, PartialEq)]
pub enum Admission<N = Number> {
    /// The surfaces are apart everywhere outside the contact.
    Admissible,
    /// They would overlap: the contact is not simply connected, and the theory does not hold.
    Interpenetrating {
        /// A radius where they do, with the gap there, and why a path ends for that.
        at: Option<Overlap<N>>,
        /// A possible remedy.
        why: Option<String>,
    },
    /// It could not be decided.
    Unknown {
        /// The reason.
        why: &'static str,
    },
}

impl<N> Admission<N> {
    /// From the verdict of the search, with its radius and gap as short decimals.
    pub(crate) fn of(verdict: GapVerdict) -> Self {
        match verdict {
            GapVerdict::Admissible => Admission::Admissible,
            GapVerdict::Interpenetrating { radius, gap } => Admission::overlapping(Overlap::near(radius, gap)),
            GapVerdict::Undecided(why) => Admission::Unknown { why },
        }
    }

    pub(crate) fn overlapping(at: Option<Overlap<N>>) -> Self {
        Admission::Interpenetrating { at, why: None }
    }
}

/// A number that has its key only where it is there: the position of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Optional<N = Number>(pub Option<Value<N>>);

impl<N> Part<N> for Optional<N> {
    type With<M> = Optional<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Optional<M> {
        Optional(self.0.map(f))
    }

    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>) {
        if let Some(value) = &self.0 {
            value.put(key, row);
        }
    }
}

record! {
    /// Where the surfaces of a state that is not admissible touch or overlap.
    Overlap {
        /// The radius.
        r: Value<N> = "r" in "m",
        /// The gap there, not above zero.
        gap: Value<N> = "gap" in "m",
    }

    /// The numbers of an equilibrium in a record that says more of it.
    PlainState {
        /// a.
        contact_radius: Value<N> = "contact radius" in "m",
        /// d.
        indentation: Value<N> = "indentation" in "m",
        /// F.
        force: Value<N> = "force" in "N",
        /// Neutral at a fold.
        stability: Stability,
    }
}

impl<N> Overlap<N> {
    /// A ring that was found in f64, rounded to six digits without a zero at the end.
    fn near(radius: f64, gap: f64) -> Option<Self> {
        let short = |x: f64| {
            let rounded = format!("{x:.5e}").parse::<f64>().ok()?;
            let text = if rounded == 0.0 { "0".to_owned() } else { format!("{rounded:e}") };
            text.parse().ok().map(Value::Given)
        };
        Some(Overlap { r: short(radius)?, gap: short(gap)? })
    }
}

impl<N> From<contact::Equilibrium<N>> for PlainState<N> {
    fn from(state: contact::Equilibrium<N>) -> Self {
        let contact::Equilibrium { contact_radius, indentation, force, stability } = state;
        PlainState {
            contact_radius: Value::Known(contact_radius),
            indentation: Value::Known(indentation),
            force: Value::Known(force),
            stability,
        }
    }
}

/// The results at one value of the controlled quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct AtValue<T> {
    /// The value, as it was given.
    pub value: Literal,
    /// The states at it, by increasing contact radius.
    pub items: Vec<T>,
    /// Whether it is proved that these are all, where that is not the same for every value.
    pub proved: Option<bool>,
    /// [`Status::NoEquilibrium`], or [`Status::Undecided`] where the states could not be computed.
    pub status: Status,
    /// The reason for the status.
    pub why: Option<String>,
}

impl<T> AtValue<T> {
    pub(crate) fn new(value: &Literal, items: Vec<T>) -> Self {
        let status = if items.is_empty() { Status::NoEquilibrium } else { Status::Ok };
        AtValue { value: value.clone(), items, proved: None, status, why: None }
    }

    /// The result of a search that was not resolved everywhere: where it found nothing, there may be something.
    pub(crate) fn doubted(self) -> Self {
        if self.status != Status::NoEquilibrium {
            return self;
        }
        let why = "whether there is an equilibrium: the search for folds was not resolved everywhere";
        AtValue { status: Status::Undecided, why: Some(why.to_owned()), ..self }
    }

    /// The items at the value of two results, and the weaker status.
    pub(crate) fn and(mut self, other: Self) -> Self {
        self.items.extend(other.items);
        self.proved = self.proved.zip(other.proved).map(|(one, other)| one && other).or(self.proved).or(other.proved);
        if other.status == Status::Undecided || self.status == Status::NoEquilibrium {
            (self.status, self.why) = (other.status, other.why);
        }
        self
    }

    /// The states could not be computed, for the reason that the error gives.
    pub(crate) fn open(value: &Literal, error: &contact::Error) -> Self {
        AtValue { status: Status::Undecided, why: Some(error.to_string()), ..AtValue::new(value, Vec::new()) }
    }
}

impl<N, T: Numbers<N>> Numbers<N> for AtValue<T> {
    type With<M> = AtValue<T::With<M>>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        let AtValue { value, items, proved, status, why } = self;
        AtValue { value, items: items.map_values(f), proved, status, why }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let mut row = Row::new().with("value", &self.value);
        row.cells.push((T::KEY, Cell::Rows(self.items.rows())));
        row.cells.extend(self.proved.map(|proved| ("proved", Cell::Flag(proved))));
        row.mark = (self.status != Status::Ok).then_some(self.status);
        row.why = self.why.as_deref();
        vec![row]
    }

    fn columns() -> Vec<Column> {
        [Column::controlled("value")].into_iter().chain(T::columns()).chain([Column::new("proved")]).collect()
    }
}

/// The completeness of a list.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Completeness {
    /// Whether it is proved that nothing is missing within the range.
    pub proved: bool,
    /// The smallest contact radius of the range; `None` if it is not limited.
    pub from: Option<String>,
    /// The largest contact radius of the range; `None` if it is not limited.
    pub to: Option<String>,
    /// The basis of the proof, or the reason why there is none.
    pub why: String,
    /// Whether it was left undecided if anything is missing, at the contact radii that `why` names or everywhere.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "std::ops::Not::not"))]
    pub undecided: bool,
}

/// The items of an output.
#[derive(Clone, Debug, PartialEq)]
pub struct List<T> {
    /// The items, in their order.
    pub items: Vec<T>,
    /// How far the numbers of the items can be trusted.
    pub promise: Promise,
    /// Whether the list is complete; `None` if not meaningful.
    pub complete: Option<Completeness>,
}

impl<T> List<T> {
    pub(crate) fn new(promise: Promise, items: Vec<T>) -> Self {
        List { items, promise, complete: None }
    }

    pub(crate) fn complete(self, complete: Completeness) -> Self {
        List { complete: Some(complete), ..self }
    }

    /// Every item changed.
    pub(crate) fn map<S>(self, f: impl FnMut(T) -> S) -> List<S> {
        List { items: self.items.into_iter().map(f).collect(), promise: self.promise, complete: self.complete }
    }

    /// The items of another list after those of this one, with the weaker promise and the weaker claim of completeness.
    pub(crate) fn and(mut self, other: Self) -> Self {
        self.items.extend(other.items);
        if self.promise == Promise::Certified || other.promise == Promise::F64 {
            self.promise = other.promise;
        }
        if self.complete.as_ref().is_none_or(|complete| complete.proved) {
            self.complete = other.complete;
        }
        self
    }
}

impl<T> List<AtValue<T>> {
    /// The items of another list at the same values, after those of this one at each.
    pub(crate) fn with(mut self, other: Self) -> Self {
        let List { items, promise, complete } = other;
        self.items =
            std::mem::take(&mut self.items).into_iter().zip(items).map(|(one, other)| one.and(other)).collect();
        self.and(List { items: Vec::new(), promise, complete })
    }
}
