//! Pressure, gap, displacement and energy of states, for any arithmetic that is not an enclosure.

use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Control, Equilibrium, Error, Instability, Quantity, Result, Stability, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, Verdict};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::{Branches, Equilibria};
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::{Completeness, Folds, pole};
use mdr_numeric::path::{Path, State};

use super::contact::{Arithmetic, Contact};
use super::digits::exact;
use super::outputs::{at_value, equilibrium, equilibrium_of};
use super::path;
use super::record::{Field, Record};
use super::sample::decimal;
use crate::scene::{Held, Scene, Want};

/// Radii of `pressure` over the contact radius, when the scene names none.
const INSIDE: [(i64, i64); 6] = [(0, 1), (1, 4), (1, 2), (3, 4), (9, 10), (99, 100)];
/// Radii of `gap` and `displacement` over the contact radius, when the scene names none.
const OUTSIDE: [(i64, i64); 6] = [(101, 100), (11, 10), (5, 4), (3, 2), (2, 1), (4, 1)];
/// How many octaves from the folds equilibria are looked for.
const REACH: i64 = 1000;

/// A contact and its folds.
pub(crate) struct States<'a, R: Arithmetic> {
    contact: &'a Contact<R>,
    branches: Branches<'a, R>,
}

impl<'a, R: Arithmetic> States<'a, R> {
    pub(crate) fn new(contact: &'a Contact<R>, folds: Folds<R>, admissibility: Arc<Admissibility<'static>>) -> Self {
        States { contact, branches: branches(contact, folds, REACH).with_admissibility(admissibility) }
    }

    fn verdict(&self, state: &Equilibrium<R>) -> Verdict {
        self.branches.admissibility().of(state.contact_radius.approx(), state.indentation.approx())
    }

    /// All equilibria at a value of the controlled quantity, which they have exactly, and how they were searched.
    fn at(&self, literal: &Literal) -> Result<(Vec<Equilibrium<R>>, Completeness)> {
        let value = self.contact.number(literal);
        let Equilibria { equilibria, completeness } = self.branches.search(&value)?;
        Ok((equilibria.into_iter().map(|state| self.held_at(state, &value)).collect(), completeness))
    }

    /// A state with the exact value of what is controlled, which at a fold is that of the fold.
    fn held_at(&self, mut state: Equilibrium<R>, value: &R) -> Equilibrium<R> {
        match self.contact.control() {
            _ if state.stability == Stability::Neutral => {}
            Control::Indentation => state.indentation = value.clone(),
            Control::Force => state.force = value.clone(),
            Control::Machine { .. } => {}
        }
        state
    }

    /// A record for a value, with what is told of each state at it. Where the states cannot be had it says so, and the other
    /// values have theirs all the same.
    fn record_at(
        &self,
        literal: &Literal,
        key: &'static str,
        tell: impl Fn(Equilibrium<R>) -> Result<Record<Estimate<R>>>,
    ) -> Result<Record<Estimate<R>>> {
        match self.at(literal) {
            Ok((states, completeness)) => {
                let records = states.into_iter().map(tell).collect::<Result<_>>()?;
                Ok(searched(at_value(literal, key, records), completeness))
            }
            Err(error @ (Error::Undecided { .. } | Error::NoConvergence { .. })) => {
                Ok(at_value(literal, key, Vec::new()).open(&error))
            }
            Err(error) => Err(error),
        }
    }

    /// All equilibria at the values that the scene asks for.
    ///
    /// # Errors
    /// As [`Branches::search`], of what concerns more than one value.
    pub(crate) fn equilibria(&self, values: &[Literal]) -> Result<Vec<Record<Estimate<R>>>> {
        let tell = |state| Ok(equilibrium(state, self.branches.admissibility()).convert(exact));
        values.iter().map(|literal| self.record_at(literal, "equilibria", tell)).collect()
    }

    /// The contact radii of the path, if there is one, and of the equilibria at the values, as far as they are found.
    pub(crate) fn visited(&self, held: Option<&Held>, values: &[Literal]) -> Vec<f64> {
        let path = held.and_then(|held| path::follow(self.contact, &self.branches, held).ok());
        let events = path.into_iter().flat_map(|path| path.events);
        let on_path = events
            .flat_map(|event| [event.before, event.after])
            .filter_map(|state| Some(state.contact()?.contact_radius.approx()).filter(|radius| *radius > 0.0));
        let at_values =
            values.iter().flat_map(|value| self.at(value).map_or_else(|_| Vec::new(), |(states, _)| states));
        on_path.chain(at_values.map(|state| state.contact_radius.approx())).filter(|a| a.is_finite()).collect()
    }

    /// One record with the `events` of the path and the `balance` of its energy.
    ///
    /// # Errors
    /// As [`path::follow`] and [`path::with_energy`].
    pub(crate) fn path(&self, held: &Held) -> Result<Vec<Record<Estimate<R>>>> {
        path::with_energy(&path::follow(self.contact, &self.branches, held)?, held, &self.branches)
    }

    /// Pressure, gap, displacement or energy: at every equilibrium of the values, without any at the start of its path.
    ///
    /// # Errors
    /// As [`States::equilibria`].
    pub(crate) fn fields(&self, scene: &Scene, values: &[Literal], want: Want) -> Result<Vec<Record<Estimate<R>>>> {
        let describe = |state| self.describe(scene, want, state);
        match (values, scene.held.path.first()) {
            ([], Some(first)) => {
                let state = self.started(&scene.held, first)?;
                Ok(vec![at_value(first, "states", state.into_iter().map(describe).collect::<Result<_>>()?)])
            }
            (values, _) => values.iter().map(|literal| self.record_at(literal, "states", describe)).collect(),
        }
    }

    /// The equilibrium in which the path starts; none where it cannot, or where the surfaces are apart.
    fn started(&self, held: &Held, first: &Literal) -> Result<Option<Equilibrium<R>>> {
        let value = self.contact.number(first);
        match Path::first(&self.branches, &path::start(self.contact, held), &value) {
            Ok(State::Contact(state)) => Ok(Some(self.held_at(state, &value))),
            Ok(_) | Err(Error::NoEquilibrium { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    fn describe(&self, scene: &Scene, want: Want, state: Equilibrium<R>) -> Result<Record<Estimate<R>>> {
        let fields = Fields::of(self.contact.curve(), &state)?;
        match want {
            Want::Pressure => self.pressure(&scene.output.pressure, &fields, state),
            Want::Gap => self.gap(&scene.output.gap, &fields, state),
            Want::Displacement => self.displacement(&scene.output.displacement, &fields, state),
            _ => self.energy(&fields, state),
        }
    }

    fn pressure(
        &self,
        radii: &[Literal],
        fields: &Fields<'_, R>,
        state: Equilibrium<R>,
    ) -> Result<Record<Estimate<R>>> {
        let pressure = |r: &R| estimate(fields.pressure_estimate(r), || fields.pressure(r));
        let points = self.points(radii, &INSIDE, &state.contact_radius, "pressure", pressure)?;
        let verdict = self.verdict(&state);
        Ok(equilibrium_of(state).convert(exact).with("pressure", Field::Records(points)).judged(verdict))
    }

    fn gap(&self, radii: &[Literal], fields: &Fields<'_, R>, state: Equilibrium<R>) -> Result<Record<Estimate<R>>> {
        let gap = |r: &R| estimate(fields.gap_estimate(r), || fields.gap(r));
        let points = self.points(radii, &OUTSIDE, &state.contact_radius, "gap", gap)?;
        let verdict = self.verdict(&state);
        let record = equilibrium_of(state).convert(exact).with("gap", Field::Records(points));
        let Verdict::Interpenetrating { radius, .. } = verdict else { return Ok(record.judged(verdict)) };
        // As short as it may be: any radius with a negative gap is as good as another.
        for digits in 3..=17 {
            let literal = decimal(radius, digits)?;
            let gap = fields.gap(&self.contact.number(&literal));
            if gap.as_ref().is_ok_and(|gap| *gap < gap.lit(0)) {
                let point = Record::new().with("r", Field::Given(literal)).number("gap", gap.map(exact))?;
                return Ok(record.overlapping(Some(point)));
            }
        }
        Ok(record.judged(verdict))
    }

    fn displacement(
        &self,
        radii: &[Literal],
        fields: &Fields<'_, R>,
        state: Equilibrium<R>,
    ) -> Result<Record<Estimate<R>>> {
        let displacement = |r: &R| estimate(fields.displacement_estimate(r), || fields.displacement(r));
        let points = self.points(radii, &OUTSIDE, &state.contact_radius, "displacement", displacement)?;
        let verdict = self.verdict(&state);
        Ok(equilibrium_of(state).convert(exact).with("displacement", Field::Records(points)).judged(verdict))
    }

    fn energy(&self, fields: &Fields<'_, R>, state: Equilibrium<R>) -> Result<Record<Estimate<R>>> {
        let energy = Energy::new(self.contact.transform(), self.contact.material())?;
        let potential = energy.potential(&state.contact_radius, &state.indentation);
        let verdict = self.verdict(&state);
        let record = equilibrium_of(state).number("energy", potential)?.number("stiffness", fields.stiffness())?;
        Ok(record.convert(exact).judged(verdict))
    }

    /// A field at the radii of the scene, else at fractions of the contact radius.
    fn points(
        &self,
        radii: &[Literal],
        fractions: &[(i64, i64)],
        a: &R,
        key: &'static str,
        field: impl Fn(&R) -> Result<Estimate<R>>,
    ) -> Result<Vec<Record<Estimate<R>>>> {
        if radii.is_empty() {
            let at = |&(numerator, denominator): &(i64, i64)| {
                let r = a.clone().times(numerator).over(denominator);
                let value = field(&r);
                Record::new().with("r", Field::Number(exact(r))).number(key, value)
            };
            return fractions.iter().map(at).collect();
        }
        let at = |literal: &Literal| {
            let value = field(&self.contact.number(literal));
            Record::new().with("r", Field::Given(literal.clone())).number(key, value)
        };
        radii.iter().map(at).collect()
    }
}

/// A field with its error where digits are decided by it, which those of doubles are not.
fn estimate<R: Arithmetic>(estimate: Result<Estimate<R>>, settled: impl FnOnce() -> Result<R>) -> Result<Estimate<R>> {
    if R::INDEX == f64::INDEX { settled().map(exact) } else { estimate }
}

/// A record without states is undecided where the search was doubtful.
fn searched<R>(record: Record<R>, completeness: Completeness) -> Record<R> {
    let doubtful = completeness == Completeness::Doubtful;
    if doubtful && record.status() == Status::NoEquilibrium { record.marked(Status::Undecided) } else { record }
}

/// The branches between radii that many octaves below the folds and above; around w/E* where there is no fold.
pub(crate) fn branches<R: Arithmetic>(contact: &Contact<R>, folds: Folds<R>, octaves: i64) -> Branches<'_, R> {
    let length = contact.curve().material_length();
    let first = folds.folds.first().map_or(&length, |fold| &fold.contact_radius);
    let last = folds.folds.last().map_or(&length, |fold| &fold.contact_radius);
    let [lower, upper] = [length.lit(2).powi(-octaves) * first, length.lit(2).powi(octaves) * last];
    Branches::cut_at(contact.curve(), folds).within(lower, upper)
}

/// Folds that are known in f64, in another arithmetic: each is looked for near the radius that is known.
///
/// # Errors
/// Those of the transform; [`Error::NoConvergence`] when a fold is not found again.
pub(crate) fn polished<R: Arithmetic>(contact: &Contact<R>, rough: &Folds<f64>) -> Result<Folds<R>> {
    let curve = contact.curve();
    let folds = rough.folds.iter().map(|fold| polish(contact, &curve, fold)).collect::<Result<_>>()?;
    let kinks = contact.transform().kinks();
    let at = |radius: f64| kinks.iter().find(|kink| kink.approx() == radius).cloned();
    let poles = rough.poles.iter().filter_map(|rough| Some(pole(at(rough.contact_radius)?, rough.kind))).collect();
    Ok(Folds { folds, poles, beyond: Vec::new(), completeness: rough.completeness })
}

fn polish<R: Arithmetic>(
    contact: &Contact<R>,
    curve: &Curve<'_, R>,
    rough: &Instability<f64>,
) -> Result<Instability<R>> {
    let centre = contact.double(rough.contact_radius);
    if let Some(wall) = curve.wall().filter(|wall| wall.approx() == rough.contact_radius) {
        let (indentation, force) = curve.state(&wall)?;
        return Ok(Instability { contact_radius: wall, indentation, force, kind: rough.kind });
    }
    let excess = |a: &R| Ok(curve.tangency(a)? - curve.threshold(a)?);
    for halvings in [44, 36, 28, 20, 12] {
        let margin = centre.lit(2).powi(-halvings) * &centre;
        let (lower, mut upper) = (centre.clone() - &margin, centre.clone() + &margin);
        if let Some(outer) = curve.transform().outer_radius().filter(|outer| upper >= *outer) {
            upper = (centre.clone() + outer).over(2);
        }
        let Some(bracket) = Bracket::new(&lower, &upper, excess)? else { continue };
        let contact_radius = roots::refine(bracket, &centre.unit_roundoff(), excess)?.value;
        let (indentation, force) = curve.state(&contact_radius)?;
        return Ok(Instability { contact_radius, indentation, force, kind: rough.kind });
    }
    Err(Error::NoConvergence { quantity: Quantity::ContactRadius, evaluations: 10, error: 2f64.powi(-12) })
}
