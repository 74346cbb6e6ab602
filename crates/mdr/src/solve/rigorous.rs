//! Energies and fields of states that are proved, as enclosures: every digit proved.

use std::collections::BTreeMap;

use mdr_core::contact::{
    Breaks, Control, Edge, Equilibrium, Error, Expression, ExpressionError, Quantity, Result, Stability,
};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::path::{ContactState, Edges, Path};
use mdr_numeric::proof::{Continuation, EnclosedEnergy, EnclosedFields, ProvedBranches};
use mdr_numeric::table::Table;

use super::certified::Certified;
use super::digits::{MOST_OF_INTEGRALS, as_far_as_known, decide_within, start};
use super::is_open;
use super::model::Model;
use super::proof::{Enclosed, controlled_exactly, reached};
use crate::answer::record::Numbers;
use crate::answer::{AtValue, Number, PlainState};
use crate::outputs::path;
use crate::scene::{Profile, Scene};

/// The profile as formulas and splines.
pub(crate) struct Formulas(Vec<Term>);

/// A term of a profile.
enum Term {
    /// With the values of its parameters, and its kinks.
    Formula(Expression, BTreeMap<String, Literal>, Box<Breaks>),
    Table(Table),
}

impl Formulas {
    /// `None` for a profile that is no sum of formulas and tables.
    ///
    /// # Errors
    /// A parameter without a value; kinks without number towards the axis.
    pub(crate) fn of(profile: &Profile) -> Result<Option<Self>> {
        let mut terms = Vec::new();
        Ok(collect(profile, &mut terms).map_err(without_formula)?.then_some(Formulas(terms)))
    }

    /// The profile over sets of numbers.
    ///
    /// # Errors
    /// A parameter without a value; a table that the precision does not hold; [`Error::Undecided`] if the order of their kinks is not known.
    pub(crate) fn continued(&self, precision: Precision) -> Result<Continuation> {
        let of = |term: &Term| match term {
            Term::Formula(formula, values, breaks) => {
                formula.enclosed(values, breaks, precision).map_err(without_formula)
            }
            Term::Table(table) => Ok(table.profile::<Interval>(precision)?.enclosed()),
        };
        let terms = self.0.iter().map(of).collect::<Result<_>>()?;
        let (quantity, bits, what) = (Quantity::Radius, precision.bits(), "the order of two kinks");
        Continuation::new(terms).ok_or(Error::Undecided { quantity, bits, what })
    }
}

fn collect(profile: &Profile, terms: &mut Vec<Term>) -> std::result::Result<bool, ExpressionError> {
    match profile {
        Profile::Formula(formula) => {
            let (parameters, breaks) = (formula.parameters.clone(), formula.breaks.clone());
            terms.push(Term::Formula(formula.expression.clone(), parameters, Box::new(breaks)));
        }
        Profile::Shape(shape) => {
            let (formula, values) = shape.formula_to_pole()?;
            let breaks = formula.breaks(&values)?;
            terms.push(Term::Formula(formula, values, Box::new(breaks)));
        }
        Profile::Table(measured) => terms.push(Term::Table(measured.table.clone())),
        Profile::Sum(others) => {
            for other in others {
                if !collect(other, terms)? {
                    return Ok(false);
                }
            }
        }
        Profile::Function(_) | Profile::Wave(_) => return Ok(false),
    }
    Ok(true)
}

fn without_formula(error: ExpressionError) -> Error {
    Error::Unproved {
        quantity: Quantity::Parameter("the formula of the profile"),
        from: error.to_string(),
        to: "its end".to_owned(),
        remedy: "energies and fields are not enclosed",
    }
}

/// Of a profile that has neither formulas nor tables nor closed forms.
pub(crate) fn without_energies() -> Error {
    let (quantity, remedy) = (Quantity::Energy, "energies are not enclosed");
    Error::Unproved { quantity, from: "the profile".to_owned(), to: "the profile".to_owned(), remedy }
}

/// What `ask` finds out with the energies of a contact: by integrals over its profile, or without one by closed forms.
///
/// # Errors
/// Errors of `ask`.
pub(crate) fn with_energies<T>(
    contact: &Contact<Interval>,
    profile: Option<&Continuation>,
    ask: impl FnOnce(&EnclosedEnergy<'_>) -> Result<T>,
) -> Result<T> {
    match profile {
        Some(profile) => ask(&EnclosedEnergy::new(contact, profile)?),
        None => ask(&EnclosedEnergy::closed(contact)),
    }
}

/// A contact over enclosures, with what is asked of a state that is proved.
pub(crate) struct Proved<'m> {
    pub(crate) model: &'m Model<Interval>,
    /// At the work of adhesion of the edge of the state.
    contact: Contact<Interval>,
    /// On the medium, where there are formulas of it and its energies have no closed form.
    profile: Option<Continuation>,
    /// With two works of adhesion, the edge that is in equilibrium.
    pub(crate) edge: Option<Edge>,
    /// Whether the path runs between two works of adhesion.
    is_between: bool,
}

impl<'m> Proved<'m> {
    /// Of states in equilibrium at the work of adhesion of the scene, which may be that of one edge.
    fn new(certified: &Certified<'_>, model: &'m Model<Interval>, precision: Precision) -> Result<Self> {
        let (contact, is_closed) = (model.contact(), certified.scene.has_closed_energies());
        let formulas = if is_closed { None } else { certified.formulas()? };
        let profile = formulas.map(|formulas| formulas.continued(precision)).transpose()?;
        let profile = profile.and_then(|profile| profile.on(contact.medium()));
        Ok(Proved { contact, model, profile, edge: certified.scene.edge, is_between: false })
    }

    /// Of a state between two works of adhesion: at one edge, or pinned.
    fn between(self, edge: Option<Edge>) -> Self {
        let contact = edge.map_or_else(|| self.model.contact(), |edge| self.model.at(edge).contact());
        Proved { contact, edge, is_between: true, ..self }
    }

    /// The fields of a state.
    ///
    /// # Errors
    /// A profile that has no formulas, or another medium than a half-space; see [`EnclosedFields::new`].
    pub(crate) fn fields(&self, state: &Equilibrium<Interval>) -> Result<EnclosedFields<'_>> {
        let profile = self.profile.as_ref().ok_or_else(without_energies)?;
        match (self.is_between, self.edge) {
            (true, None) => EnclosedFields::pinned(&self.contact, profile, state),
            _ => EnclosedFields::new(&self.contact, profile, state),
        }
    }

    /// The energy of a state: between two works of adhesion what is stored, with the smaller one.
    ///
    /// # Errors
    /// [`EnclosedEnergy::potential`].
    pub(crate) fn potential(&self, state: &Equilibrium<Interval>) -> Result<Interval> {
        let of = |contact: &Contact<Interval>| {
            with_energies(contact, self.profile.as_ref(), |energy| {
                energy.potential(&state.contact_radius, &state.indentation)
            })
        };
        if self.is_between { of(&self.contact.at(Edge::Advancing)) } else { of(&self.contact) }
    }

    /// dF/dd along the equilibria, or of an edge that is pinned at its radius.
    ///
    /// # Errors
    /// [`EnclosedEnergy::stiffness`].
    pub(crate) fn stiffness(&self, radius: &Interval) -> Result<Interval> {
        match (self.is_between, self.edge) {
            (true, None) => Ok(self.contact.stiffness(radius)),
            _ => with_energies(&self.contact, self.profile.as_ref(), |energy| energy.stiffness(radius)),
        }
    }
}

/// Records at values, as they are printed.
type Printed<T> = Vec<AtValue<<T as Numbers<Enclosure>>::With<Number>>>;

/// What is proved of the states at values.
pub(crate) struct Described<T: Numbers<Enclosure>> {
    /// The records, where all is proved.
    pub(crate) all: Option<Printed<T>>,
    /// Otherwise those of which only a part is.
    pub(crate) some: Option<Printed<T>>,
}

/// The record of every equilibrium at the values, of the state in which the path starts without values; `None` if not all of it
/// can be proved, or if what `describe` asks for cannot be enclosed.
///
/// # Errors
/// Errors of the transform; a value out of its domain.
pub(crate) fn described<T: Numbers<Enclosure> + Clone>(
    certified: &Certified<'_>,
    is_enclosed: bool,
    values: &[Literal],
    describe: impl Fn(&Proved<'_>, &Equilibrium<Interval>, PlainState<Enclosure>) -> Result<T>,
) -> Result<Option<Printed<T>>>
where
    Vec<AtValue<T>>: Numbers<Enclosure, With<Number> = Vec<AtValue<T::With<Number>>>>,
{
    let none = |_: &Proved<'_>, _: &Equilibrium<Interval>, _, error: &Error| Err(error.clone());
    Ok(described_in_part(certified, is_enclosed, values, describe, none)?.all)
}

/// The records of [`described`], or of the states that are proved where what `describe` asks for is not known of each: `open` is the record of
/// one of which it is not.
///
/// # Errors
/// Errors of the transform; a value out of its domain.
pub(crate) fn described_in_part<T: Numbers<Enclosure>>(
    certified: &Certified<'_>,
    is_enclosed: bool,
    values: &[Literal],
    describe: impl Fn(&Proved<'_>, &Equilibrium<Interval>, PlainState<Enclosure>) -> Result<T>,
    open: impl Fn(&Proved<'_>, &Equilibrium<Interval>, PlainState<Enclosure>, &Error) -> Result<T>,
) -> Result<Described<T>>
where
    Vec<AtValue<T>>: Numbers<Enclosure, With<Number> = Vec<AtValue<T::With<Number>>>>,
{
    let scene = certified.scene;
    let of = |all| Described { all, some: None };
    // Within a range that the scene names not all equilibria need be listed.
    if scene.range.is_some() || !is_enclosed {
        return Ok(of(None));
    }
    if scene.has_two_works() {
        return between_edges(certified, values, describe).map(of);
    }
    let Some(folds) = certified.fold_proof()? else { return Ok(of(None)) };
    let mut part: Option<(usize, Vec<AtValue<T>>)> = None;
    let all = reached(decide_within(MOST_OF_INTEGRALS, start(certified.digits), certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = ProvedBranches::new(enclosed.curve(), &folds.proved)?;
        let branches = branches.with_admissibility(certified.admissibility()?);
        let proved = Proved::new(certified, &enclosed.value, precision)?;
        let mut left_open = Vec::new();
        let mut one = |state: Equilibrium<Interval>, literal: &Literal| {
            let record = plain(&proved, state.clone(), literal, &scene.control);
            describe(&proved, &state, record.clone()).or_else(|error| {
                let record = if is_open(&error) { open(&proved, &state, record, &error)? } else { return Err(error) };
                left_open.push(error);
                Ok(record)
            })
        };
        let mut records = Vec::new();
        for literal in values.iter().chain(scene.path.first().filter(|_| values.is_empty())) {
            let states = states_at(&enclosed.value, &branches, scene, values, literal)?;
            let states = states.into_iter().map(|state| one(state, literal));
            records.push(AtValue::new(literal, states.collect::<Result<_>>()?));
        }
        let Some(error) = left_open.first().cloned() else { return Ok(records) };
        if part.as_ref().is_none_or(|(open, _)| *open >= left_open.len()) {
            part = Some((left_open.len(), records));
        }
        Err(error)
    }));
    let Some((_, records)) = part else { return all.map(of) };
    let all = match all {
        Err(Error::BudgetSpent { .. }) => None,
        all => all?,
    };
    let some = all.is_none().then(|| as_far_as_known(certified.digits, records));
    Ok(Described { all, some })
}

/// The states at one of the values, or without values that in which the path starts.
fn states_at(
    model: &Model<Interval>,
    branches: &ProvedBranches,
    scene: &Scene,
    values: &[Literal],
    literal: &Literal,
) -> Result<Vec<Equilibrium<Interval>>> {
    let value = model.number(literal);
    match values {
        [] => Ok(first(model, branches, scene, &value)?.into_iter().collect()),
        _ => branches.equilibria(&value),
    }
}

/// The equilibrium in which the path starts; `None` if the surfaces are apart.
fn first(
    model: &Model<Interval>,
    branches: &ProvedBranches,
    scene: &Scene,
    value: &Interval,
) -> Result<Option<Equilibrium<Interval>>> {
    let path = match Path::follow(branches, &model.start(&scene.start)?, std::slice::from_ref(value)) {
        Err(Error::NoEquilibrium { .. }) => {
            let what = "whether there is an equilibrium outside the radii of the proof";
            return Err(Error::undecided(Quantity::ContactRadius, value, what));
        }
        path => path?,
    };
    branches.check(&path)?;
    Ok(path.events.first().and_then(|event| touching(&event.after)))
}

/// A contact that is no point.
fn touching(state: &ContactState<Interval>) -> Option<Equilibrium<Interval>> {
    state.contact().filter(|rest| !rest.contact_radius.upper().is_zero()).cloned()
}

/// The record of the state in which a path between two works of adhesion starts; `None` if it cannot be proved, or with values.
///
/// # Errors
/// Errors of the transform; a value out of its domain.
fn between_edges<T: Numbers<Enclosure>>(
    certified: &Certified<'_>,
    values: &[Literal],
    describe: impl Fn(&Proved<'_>, &Equilibrium<Interval>, PlainState<Enclosure>) -> Result<T>,
) -> Result<Option<Printed<T>>>
where
    Vec<AtValue<T>>: Numbers<Enclosure, With<Number> = Vec<AtValue<T::With<Number>>>>,
{
    let (scene, digits) = (certified.scene, certified.digits);
    let start_of_path = scene.path.first().filter(|_| values.is_empty() && !scene.medium.is_periodic());
    let Some(literal) = start_of_path else { return Ok(None) };
    path::with_pair(certified, |pair| {
        reached(decide_within(MOST_OF_INTEGRALS, start(digits), digits, |precision| {
            path::with_path_between(pair, precision, |enclosed, branches, _| {
                let model = &enclosed[1].value;
                let edges = Edges::new(&model.contact(), branches[0], branches[1]);
                let (edge, state) = edges.first(&model.start(&scene.start)?, &model.number(literal))?;
                let record = touching(&state).map(|state| {
                    let proved = Proved::new(pair.edges[1], model, precision)?.between(edge);
                    let record = plain(&proved, state.clone(), literal, &scene.control);
                    describe(&proved, &state, record)
                });
                Ok(vec![AtValue::new(literal, record.transpose()?.into_iter().collect())])
            })
        }))
    })
}

/// A state with the exact value of the controlled quantity, which at a fold is that of the fold.
fn plain(
    proved: &Proved<'_>,
    state: Equilibrium<Interval>,
    literal: &Literal,
    control: &Control<Literal>,
) -> PlainState<Enclosure> {
    let is_fold = state.stability == Stability::Neutral;
    let mut record = proved.model.plain(state).convert(Enclosure::from);
    if !is_fold {
        controlled_exactly(control, literal, &mut record.indentation, &mut record.force);
    }
    record
}
