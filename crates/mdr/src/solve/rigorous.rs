//! Energies and fields of states that are proved, as enclosures: every digit proved.

use std::collections::BTreeMap;

use mdr_core::contact::{
    Breaks, Control, Equilibrium, Error, Expression, ExpressionError, Quantity, Result, Stability,
};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::path::{ContactState, Path};
use mdr_numeric::proof::{Continuation, EnclosedEnergy, ProvedBranches};

use super::certified::Certified;
use super::digits::{MOST_OF_INTEGRALS, decide_within, start};
use super::proof::{Enclosed, FoldProof, controlled_exactly, reached};
use crate::answer::record::Numbers;
use crate::answer::{AtValue, Number, PlainState};
use crate::scene::Profile;

/// The profile as formulas, with the values of their parameters and their kinks.
pub(crate) struct Formulas(Vec<(Expression, BTreeMap<String, Literal>, Breaks)>);

impl Formulas {
    /// `None` for a profile that is no sum of formulas.
    ///
    /// # Errors
    /// A parameter without a value; kinks without number towards the axis.
    pub(crate) fn of(profile: &Profile) -> Result<Option<Self>> {
        let mut formulas = Vec::new();
        Ok(collect(profile, &mut formulas).map_err(without_formula)?.then_some(Formulas(formulas)))
    }

    /// The formulas over sets of numbers.
    ///
    /// # Errors
    /// A parameter without a value; [`Error::Undecided`] if the order of their kinks is not known.
    pub(crate) fn continued(&self, precision: Precision) -> Result<Continuation> {
        let terms = self.0.iter().map(|(formula, values, breaks)| formula.enclosed(values, breaks, precision));
        let terms = terms.collect::<std::result::Result<_, _>>().map_err(without_formula)?;
        let (quantity, bits, what) = (Quantity::Radius, precision.bits(), "the order of two kinks");
        Continuation::new(terms).ok_or(Error::Undecided { quantity, bits, what })
    }
}

fn collect(
    profile: &Profile,
    formulas: &mut Vec<(Expression, BTreeMap<String, Literal>, Breaks)>,
) -> std::result::Result<bool, ExpressionError> {
    match profile {
        Profile::Formula(formula) => {
            formulas.push((formula.expression.clone(), formula.parameters.clone(), formula.breaks.clone()));
        }
        Profile::Shape(shape) => {
            let (formula, values) = shape.formula()?;
            let breaks = formula.breaks(&values)?;
            formulas.push((formula, values, breaks));
        }
        Profile::Sum(terms) => {
            for term in terms {
                if !collect(term, formulas)? {
                    return Ok(false);
                }
            }
        }
        Profile::Table(_) | Profile::Function(_) | Profile::Wave(_) => return Ok(false),
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

/// Of a profile that has neither formulas nor closed forms.
pub(crate) fn without_energies() -> Error {
    let (quantity, remedy) = (Quantity::Energy, "energies are not enclosed");
    Error::Unproved { quantity, from: "the profile".to_owned(), to: "the profile".to_owned(), remedy }
}

/// The contact over enclosures, with all that is proved about its states.
pub(crate) struct Proved {
    pub(crate) enclosed: Enclosed,
    pub(crate) contact: mdr_numeric::contact::Contact<Interval>,
    /// Where there are formulas of it, on a half-space.
    profile: Option<Continuation>,
    branches: ProvedBranches,
}

impl Proved {
    fn new(certified: &Certified<'_>, folds: &FoldProof, precision: Precision) -> Result<Self> {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = ProvedBranches::new(enclosed.curve(), &folds.proved)?;
        let branches = branches.with_admissibility(certified.admissibility()?);
        let formulas = certified.formulas()?.filter(|_| certified.scene.medium.is_half_space());
        let profile = formulas.map(|formulas| formulas.continued(precision)).transpose()?;
        Ok(Proved { contact: enclosed.value.contact(), enclosed, profile, branches })
    }

    /// The profile over sets of radii.
    ///
    /// # Errors
    /// A profile that has no formulas, or another medium than a half-space.
    pub(crate) fn profile(&self) -> Result<&Continuation> {
        self.profile.as_ref().ok_or_else(without_energies)
    }

    /// What `ask` finds out with the energies of the contact.
    ///
    /// # Errors
    /// Errors of `ask`.
    pub(crate) fn with_energy<T>(&self, ask: impl FnOnce(&EnclosedEnergy<'_>) -> Result<T>) -> Result<T> {
        match &self.profile {
            Some(profile) => ask(&EnclosedEnergy::new(&self.contact, profile)?),
            None => ask(&EnclosedEnergy::closed(&self.contact)),
        }
    }

    /// The equilibrium in which the path starts; `None` if the surfaces are apart.
    fn first(&self, certified: &Certified<'_>, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let start = self.enclosed.value.start(&certified.scene.start)?;
        let path = match Path::follow(&self.branches, &start, std::slice::from_ref(value)) {
            Err(Error::NoEquilibrium { .. }) => {
                return Err(self.open("whether there is an equilibrium outside the radii of the proof"));
            }
            path => path?,
        };
        self.branches.check(&path)?;
        Ok(match path.events.first().map(|event| &event.after) {
            Some(ContactState::Contact(rest)) if !rest.contact_radius.upper().is_zero() => Some(rest.clone()),
            _ => None,
        })
    }

    fn open(&self, what: &'static str) -> Error {
        Error::undecided(Quantity::ContactRadius, self.contact.modulus(), what)
    }
}

/// Records at values, as they are printed.
type Described<T> = Vec<AtValue<<T as Numbers<Enclosure>>::With<Number>>>;

/// The record of every equilibrium at the values, of the state in which the path starts without values; `None` if not all of it
/// can be proved, or if what `describe` asks for cannot be enclosed.
///
/// # Errors
/// Errors of the transform; a value out of its domain.
pub(crate) fn described<T: Numbers<Enclosure>>(
    certified: &Certified<'_>,
    is_enclosed: bool,
    values: &[Literal],
    describe: impl Fn(&Proved, &Equilibrium<Interval>, PlainState<Enclosure>) -> Result<T>,
) -> Result<Option<Described<T>>>
where
    Vec<AtValue<T>>: Numbers<Enclosure, With<Number> = Vec<AtValue<T::With<Number>>>>,
{
    let scene = certified.scene;
    // Within a range that the scene names not all equilibria need be listed.
    if scene.range.is_some() || scene.has_two_works() || !is_enclosed {
        return Ok(None);
    }
    let Some(folds) = certified.fold_proof()? else { return Ok(None) };
    reached(decide_within(MOST_OF_INTEGRALS, start(certified.digits), certified.digits, |precision| {
        let proved = Proved::new(certified, folds, precision)?;
        let one = |state: Equilibrium<Interval>, literal: &Literal| {
            let record = plain(&proved, state.clone(), literal, &scene.control);
            describe(&proved, &state, record)
        };
        let at = |literal: &Literal| {
            let value = proved.enclosed.value.number(literal);
            let states = match values {
                [] => proved.first(certified, &value)?.into_iter().collect(),
                _ => proved.branches.equilibria(&value)?,
            };
            let records = states.into_iter().map(|state| one(state, literal)).collect::<Result<Vec<_>>>()?;
            Ok(AtValue::new(literal, records))
        };
        let start = scene.path.first().filter(|_| values.is_empty());
        values.iter().chain(start).map(at).collect::<Result<Vec<_>>>()
    }))
}

/// A state with the exact value of the controlled quantity, which at a fold is that of the fold.
fn plain(
    proved: &Proved,
    state: Equilibrium<Interval>,
    literal: &Literal,
    control: &Control<Literal>,
) -> PlainState<Enclosure> {
    let is_fold = state.stability == Stability::Neutral;
    let mut record = proved.enclosed.value.plain(state).convert(Enclosure::from);
    if !is_fold {
        controlled_exactly(control, literal, &mut record.indentation, &mut record.force);
    }
    record
}
