//! Quantities along the surface of states: what the outputs `pressure`, `gap` and `displacement` have in common.

use mdr_core::contact::{Edge, Equilibrium, Result};
#[cfg(feature = "mp")]
use mdr_core::contact::{Error, Quantity, Status};
use mdr_core::named;
use mdr_core::number::{Literal, Real};
use mdr_numeric::fields::Fields;

use super::Output;
use super::path::edges::{self, Held};
use super::room::{Open, Request, Room};
use crate::answer::record::{Numbers, Part, Row};
use crate::answer::{Admission, AtValue, Cell, Column, List, Number, PlainState, Promise, Value};
use crate::solve::search::{self, Search};
use crate::solve::states::States;
#[cfg(feature = "mp")]
use crate::solve::verdict;
#[cfg(feature = "mp")]
use crate::{
    solve::rigorous::{self, Proved},
    solve::{certified::Certified, power_law::PowerLaw},
};
#[cfg(feature = "mp")]
use {
    mdr_core::number::Interval, mdr_core::number::certify::Enclosure, mdr_numeric::admissible::GapVerdict,
    mdr_numeric::proof::EnclosedFields, rug::Rational,
};

/// About so many radii of a field the program chooses itself.
const CHOSEN_RADII: usize = 41;
/// Radii of a gap or displacement over the contact radius, when the scene names none.
pub(super) const OUTSIDE: [(i64, i64); 6] = [(101, 100), (11, 10), (5, 4), (3, 2), (2, 1), (4, 1)];

named! {
    /// A quantity along the surface of a state.
    pub enum Field {
        /// The normal pressure within the contact, tension negative.
        Pressure = "pressure",
        /// The distance of the surfaces outside the contact.
        Gap = "gap",
        /// The normal displacement of the surface outside the contact.
        Displacement = "displacement",
    }
}

/// A field at a radius.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldSample<N = Number> {
    /// The radius, as the scene gives it, or chosen by the program.
    pub r: Value<N>,
    /// The value of the field, in pascals or metres.
    pub value: Value<N>,
    /// The promise of the value, where it is not that of the list.
    pub promise: Option<Promise>,
}

impl<N> FieldSample<N> {
    fn row(&self, name: &'static str) -> Row<'_, N> {
        let mut row = Row::new().with("r", &self.r).with(name, &self.value);
        row.cells.extend(self.promise.map(|promise| ("promise", Cell::Word(promise.name()))));
        row
    }
}

/// A field along the surface of a state.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldState<N = Number> {
    /// The state.
    pub state: PlainState<N>,
    /// The kind of field.
    pub field: Field,
    /// The samples, by the radii of the scene.
    pub samples: Vec<FieldSample<N>>,
    /// Whether the state is admissible.
    pub admissible: Admission<N>,
    /// With two works of adhesion, the edge that is in equilibrium; missing where it is pinned.
    pub edge: Option<Edge>,
}

impl<N> Numbers<N> for FieldState<N> {
    type With<M> = FieldState<M>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> FieldState<M> {
        let FieldState { state, field, samples, admissible, edge } = self;
        let state = state.map_part(f);
        let sample = |FieldSample { r, value, promise }| FieldSample { r: f(r), value: f(value), promise };
        let samples = samples.into_iter().map(sample).collect();
        FieldState { state, field, samples, admissible: admissible.map_part(f), edge }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let name = self.field.name();
        let samples = self.samples.iter();
        let samples = samples.map(|sample| sample.row(name)).collect();
        let mut row = Row::new().with("", &self.state);
        row.cells.push((name, Cell::Rows(samples)));
        vec![row.with("", &self.admissible).with("edge", &self.edge)]
    }

    fn columns() -> Vec<Column> {
        let unit = |field| if field == Field::Pressure { "Pa" } else { "m" };
        let of_field = |field: Field| Column::new(field.name()).titled(field.name(), unit(field));
        let own = [Column::new("r").titled("r", "m")].into_iter().chain(Field::ALL.map(of_field));
        let own = own.chain([Column::new("promise")]);
        <PlainState<N> as Numbers<N>>::columns().into_iter().chain(own).collect()
    }
}

/// An output that is a field of states.
pub(super) trait FieldRoom<'w> {
    const FIELD: Field;
    const OUTPUT: fn(List<AtValue<FieldState>>) -> Output;
    /// Radii over the contact radius, when the scene names none.
    const FRACTIONS: [(i64, i64); 6];

    /// The values of the controlled quantity, and the radii.
    fn question(&self) -> [&'w [Literal]; 2];

    /// The field at a radius, in f64.
    ///
    /// # Errors
    /// A radius where it is not defined; errors of the quadratures.
    fn value(fields: &Fields<f64>, r: &f64) -> Result<f64>;

    /// The field of a state that is proved, at a radius.
    ///
    /// # Errors
    /// A radius where it is not defined; an integral that cannot be enclosed.
    #[cfg(feature = "mp")]
    fn enclosed(fields: &EnclosedFields<'_>, r: &Interval) -> Result<Interval>;

    /// Whether the field of a state is not enclosed at a radius, and has to be taken from f64 there.
    #[cfg(feature = "mp")]
    fn is_in_doubles(_: &EnclosedFields<'_>, _: &Interval) -> bool {
        false
    }

    /// Whether a state that is proved is admissible.
    ///
    /// # Errors
    /// Errors that concern the whole computation, not one state.
    #[cfg(feature = "mp")]
    fn proved_admission(verdict: GapVerdict, _: &EnclosedFields<'_>) -> Result<Admission<Enclosure>> {
        Ok(Admission::of(verdict))
    }

    /// Whether a state is admissible.
    ///
    /// # Errors
    /// Errors that concern the whole computation, not one state.
    fn admission(states: &States<'_, f64>, _: &Fields<f64>, state: &Equilibrium<f64>) -> Result<Admission<f64>> {
        Ok(Admission::of(states.verdict(state)))
    }
}

impl<'w, F: FieldRoom<'w>> Request<'w> for F {
    fn values(&self) -> &'w [Literal] {
        let [states, _] = self.question();
        states
    }

    fn rows(&self) -> usize {
        let [states, at] = self.question();
        states.len().max(1).saturating_mul(if at.is_empty() { CHOSEN_RADII } else { at.len() })
    }
}

impl<'w, F: FieldRoom<'w>> Room<'w> for F {
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let [states, at] = self.question();
        let is_enclosed = certified.scene.medium.is_half_space() && certified.formulas()?.is_some();
        let items = rigorous::described(certified, is_enclosed, states, |proved, state, record| {
            let fields = proved.fields(state)?;
            let verdict = verdict(&*certified.admissibility()?, &state.contact_radius, &state.indentation);
            Ok(FieldState {
                samples: proved_samples::<F>(proved, &fields, at, &state.contact_radius)?,
                admissible: F::proved_admission(verdict, &fields)?,
                state: record,
                field: F::FIELD,
                edge: proved.edge,
            })
        })?;
        let Some(mut items) = items else { return Ok(None) };
        if samples_of(&mut items).any(|sample| sample.promise.is_some()) {
            match certified.plain().and_then(|search| self.searched(search)) {
                Ok(searched) => insert_doubles(&mut items, searched),
                // The other samples are there.
                Err(
                    Error::BudgetSpent { .. }
                    | Error::Undecided { .. }
                    | Error::NoConvergence { .. }
                    | Error::OutOfRange { .. },
                ) => {
                    samples_of(&mut items).for_each(|sample| sample.promise = None);
                }
                Err(error) => return Err(error),
            }
        }
        Ok(Some(F::OUTPUT(List::new(Promise::Certified, items))))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let [states, at] = self.question();
        let items = if search.scene.has_two_works() {
            edges::with_both(search, |edges, _| edges::first(edges, |states, held| of_state::<F>(states, held, at)))?
        } else {
            described::<F>(&search.states()?, states, at)?
        };
        Ok(F::OUTPUT(search::list(items)))
    }

    fn of_edges(&self, outputs: [Output; 2]) -> Option<Output> {
        let list = |output| match output {
            Output::Pressure(list) | Output::Gap(list) | Output::Displacement(list) => Some(list),
            _ => None,
        };
        let [advancing, receding] = outputs.map(list);
        Some(F::OUTPUT(advancing?.with(receding?)))
    }

    /// Where the states that were searched in f64 are not all there are, the value says so.
    #[cfg(feature = "mp")]
    fn confirmed(&self, mut output: Output, law: &PowerLaw<'_>) -> Result<Output> {
        let (Output::Pressure(list) | Output::Gap(list) | Output::Displacement(list)) = &mut output else {
            return Ok(output);
        };
        let what = "the contact radius of a state, which is beyond the range of f64, where states are searched";
        let error = Error::Undecided { quantity: Quantity::ContactRadius, bits: f64::MANTISSA_DIGITS, what };
        for (item, (value, count)) in list.items.iter_mut().zip(law.counts_at(self.values())?) {
            if item.items.len() != count {
                *item = AtValue::open(&value, &error);
            }
        }
        Ok(output)
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        F::OUTPUT(open.at_values(self.values()))
    }
}

/// All samples of the states.
#[cfg(feature = "mp")]
fn samples_of(items: &mut [AtValue<FieldState>]) -> impl Iterator<Item = &mut FieldSample> {
    items.iter_mut().flat_map(|at| &mut at.items).flat_map(|state| &mut state.samples)
}

/// Gives the samples that are not enclosed their values in f64. Where these are of other states, they stay undecided.
#[cfg(feature = "mp")]
fn insert_doubles(items: &mut [AtValue<FieldState>], searched: Output) {
    let (Output::Pressure(list) | Output::Gap(list) | Output::Displacement(list)) = searched else { return };
    for (at, other) in items.iter_mut().zip(list.items) {
        if at.items.len() != other.items.len() {
            continue;
        }
        let states = at.items.iter_mut().zip(other.items);
        let samples = states.flat_map(|(state, other)| state.samples.iter_mut().zip(other.samples));
        for (sample, other) in samples.filter(|(sample, _)| sample.promise.is_some()) {
            sample.value = other.value;
            // Only a number has a promise.
            sample.promise = sample.value.promise();
        }
    }
}

/// The field of every equilibrium at the values, or at the start of the path.
///
/// # Errors
/// Errors that concern more than one value.
fn described<'w, F: FieldRoom<'w>>(
    states: &States<'_, f64>,
    values: &[Literal],
    radii: &[Literal],
) -> Result<Vec<AtValue<FieldState<f64>>>> {
    states.described(values, |state| of_state::<F>(states, Held::on_edge(state, states.scene.edge), radii))
}

/// The field of one state.
///
/// # Errors
/// Errors that concern more than one value.
fn of_state<'w, F: FieldRoom<'w>>(
    states: &States<'_, f64>,
    held: Held<f64>,
    radii: &[Literal],
) -> Result<FieldState<f64>> {
    let fields = held.fields(states.model.contact())?;
    let Held { state, edge, .. } = held;
    Ok(FieldState {
        samples: samples::<F>(states, &fields, radii, &states.model.contact_radius(&state.contact_radius))?,
        admissible: F::admission(states, &fields, &state)?,
        state: states.model.plain(state),
        field: F::FIELD,
        edge,
    })
}

/// A field at the radii of the scene, else at fractions of the contact radius.
fn samples<'w, F: FieldRoom<'w>>(
    states: &States<'_, f64>,
    fields: &Fields<f64>,
    radii: &[Literal],
    a: &f64,
) -> Result<Vec<FieldSample<f64>>> {
    let chosen = F::FRACTIONS.iter().filter(|_| radii.is_empty()).map(|&(numerator, denominator)| {
        let r = a.times(numerator).over(denominator);
        (Value::Known(r), r)
    });
    let given = radii.iter().map(|literal| (Value::Given(literal.clone()), states.model.number(literal)));
    let sample =
        |(r, at): (_, f64)| Ok(FieldSample { r, value: Value::from_result(F::value(fields, &at))?, promise: None });
    chosen.chain(given).map(sample).collect()
}

/// The field of a state that is proved, at the radii of the scene, else at fractions of the contact radius.
#[cfg(feature = "mp")]
fn proved_samples<'w, F: FieldRoom<'w>>(
    proved: &Proved<'_>,
    fields: &EnclosedFields<'_>,
    radii: &[Literal],
    a: &Interval,
) -> Result<Vec<FieldSample<Enclosure>>> {
    let chosen = F::FRACTIONS.iter().filter(|_| radii.is_empty()).map(|&(numerator, denominator)| {
        let r = if numerator == 0 { a.lit(0) } else { a.clone().times(numerator).over(denominator) };
        let shown = if numerator == 0 { Rational::new().into() } else { Enclosure::from(r.clone()) };
        (Value::Known(shown), r)
    });
    let given = radii.iter().map(|literal| (Value::Given(literal.clone()), proved.model.number(literal)));
    let sample = |(r, at): (_, Interval)| {
        let (value, promise) = match F::enclosed(fields, &at) {
            Err(error @ Error::Unproved { .. }) if F::is_in_doubles(fields, &at) => {
                (Value::unknown(Status::Undecided, error.to_string()), Some(Promise::F64))
            }
            value => (Value::from_result(value.map(Enclosure::from))?, None),
        };
        Ok(FieldSample { r, value, promise })
    };
    chosen.chain(given).map(sample).collect()
}
