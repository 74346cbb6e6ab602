//! A scene in certified digits: enclosures where g is a closed form, two precisions elsewhere.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal};
use mdr_numeric::admissible::Admissibility;
use rug::Float;

use super::answer::{Complete, Output, Promise};
use super::contact::{Arithmetic, Contact, Tally};
use super::digits::{estimated, proved, rounded, start};
use super::double::{Double, not_proved};
use super::enclosed::{self, Isolated};
use super::outputs;
use super::record::{Field, Record};
use super::states::{States, polished};
use crate::number::Number;
use crate::scene::{Scene, Want};

/// Up to this many rows the folds of a table are proved, within some seconds: the cost grows with the square of the rows.
const PROVED_ROWS: usize = 100;

/// The contact in certified digits; f64 tells where to look.
pub(crate) struct Certified<'s> {
    pub(super) scene: &'s Scene,
    pub(super) digits: u32,
    pub(super) tally: Arc<Tally>,
    rough: OnceCell<Double<'s>>,
    isolated: OnceCell<Option<Isolated>>,
    admissibility: OnceCell<Arc<Admissibility<'static>>>,
}

impl<'s> Certified<'s> {
    pub(crate) fn new(scene: &'s Scene, digits: u32, tally: &Arc<Tally>) -> Self {
        let (rough, isolated, admissibility) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Certified { scene, digits, tally: Arc::clone(tally), rough, isolated, admissibility }
    }

    /// Which states are admissible: by the form of the profile, else in f64.
    ///
    /// # Errors
    /// As [`Contact::new`], and as [`Certified::rough`].
    pub(super) fn admissibility(&self) -> Result<Arc<Admissibility<'static>>> {
        if let Some(known) = self.admissibility.get() {
            return Ok(Arc::clone(known));
        }
        let rises = self.contact::<Float>(start(self.digits))?.transform().rises();
        let found = if rises { Arc::new(Admissibility::of_rising()) } else { self.rough()?.admissibility() };
        Ok(Arc::clone(self.admissibility.get_or_init(|| found)))
    }

    /// # Errors
    /// Those of the transform, of the quadratures and of the proofs.
    pub(crate) fn output(&self, want: Want) -> Result<Output> {
        match want {
            Want::Transform => self.along(want, &self.scene.output.transform),
            Want::Curve => self.along(want, &self.rough_or_given_radii()?),
            Want::Folds => self.folds(),
            Want::Equilibria => self.equilibria(),
            Want::Path => self.path(),
            Want::Pressure | Want::Gap | Want::Displacement | Want::Energy => {
                let fields = |states: &States<'_, Float>, values: &[Literal]| states.fields(self.scene, values, want);
                let records = self.estimated_at(&self.scene.output.values, "states", &fields)?;
                Ok(Output::new(want, Promise::Estimated, records))
            }
        }
    }

    /// The same contact in f64.
    ///
    /// # Errors
    /// As [`Contact::new`].
    pub(super) fn rough(&self) -> Result<&Double<'s>> {
        if let Some(rough) = self.rough.get() {
            return Ok(rough);
        }
        let rough = Double::rough(self.scene, &self.tally)?;
        Ok(self.rough.get_or_init(|| rough))
    }

    /// The same contact in another arithmetic.
    pub(super) fn contact<R: Arithmetic>(&self, ctx: R::Ctx) -> Result<Contact<R>> {
        Contact::new(self.scene, ctx, &self.tally)
    }

    fn rough_or_given_radii(&self) -> Result<Vec<Literal>> {
        let given = &self.scene.output.curve;
        if given.is_empty() { self.rough()?.radii() } else { Ok(given.clone()) }
    }

    /// What is read off the curve at given radii: proved where g is closed.
    fn along(&self, want: Want, radii: &[Literal]) -> Result<Output> {
        if !self.scene.profile.is_closed() {
            let read = |precision| Ok(rounded(self.read(&self.contact::<Float>(precision)?, want, radii)?));
            let records = estimated(self.digits, read)?;
            return Ok(Output::new(want, Promise::Estimated, records));
        }
        let records = proved(self.digits, |precision| {
            let records = self.read(&self.contact::<Interval>(precision)?, want, radii)?;
            Ok(records.into_iter().map(|record| record.convert(Enclosure::from)).collect())
        })?;
        Ok(Output::new(want, Promise::Certified, records))
    }

    /// All folds: proved where that can be.
    fn folds(&self) -> Result<Output> {
        if let Some(isolated) = self.isolated()? {
            return enclosed::folds(self, isolated);
        }
        let records = estimated(self.digits, |precision| {
            let contact = self.contact::<Float>(precision)?;
            let admissibility = self.admissibility()?;
            let folds = polished(&contact, self.rough()?.folds()?)?.folds.into_iter();
            Ok(rounded(folds.map(|fold| outputs::fold(fold, &admissibility)).collect()))
        })?;
        Ok(Output::new(Want::Folds, Promise::Estimated, records).complete(self.searched()?))
    }

    /// All equilibria: proved where the folds are.
    fn equilibria(&self) -> Result<Output> {
        if let Some(isolated) = self.isolated()? {
            if let Some(output) = enclosed::equilibria(self, isolated)? {
                return Ok(output);
            }
            if isolated.is_complete() && self.scene.output.values.len() > 1 {
                return self.equilibria_one_by_one(isolated);
            }
        }
        let records = self.estimated_equilibria(&self.scene.output.values)?;
        Ok(Output::new(Want::Equilibria, Promise::Estimated, records).complete(self.searched()?))
    }

    fn estimated_equilibria(&self, values: &[Literal]) -> Result<Vec<Record<Number>>> {
        self.estimated_at(values, "equilibria", &|states, values| states.equilibria(values))
    }

    /// What belongs to values, under `key`, at two precisions; where these do not agree, each value for itself.
    fn estimated_at(
        &self,
        values: &[Literal],
        key: &'static str,
        compute: &impl Fn(&States<'_, Float>, &[Literal]) -> Result<Vec<Record<Estimate<Float>>>>,
    ) -> Result<Vec<Record<Number>>> {
        match (self.estimated(|states| compute(states, values)), values) {
            (Err(error @ Error::Undecided { .. }), [value]) => {
                Ok(vec![outputs::at_value(value, key, Vec::new()).open(&error)])
            }
            (Err(Error::Undecided { .. }), [_, _, ..]) => {
                let each = values.iter().map(|value| self.estimated_at(std::slice::from_ref(value), key, compute));
                Ok(each.collect::<Result<Vec<_>>>()?.concat())
            }
            (records, _) => records,
        }
    }

    /// Each value for itself: proved where that can be, and whether it is.
    fn equilibria_one_by_one(&self, isolated: &Isolated) -> Result<Output> {
        let at = |value: &Literal| {
            let values = std::slice::from_ref(value);
            let proved = enclosed::equilibria_at(self, isolated, values)?;
            let flag = Field::Flag(proved.is_some());
            let records = proved.map_or_else(|| self.estimated_equilibria(values), Ok)?;
            Ok(records.into_iter().map(|record| record.with("proved", flag.clone())).collect::<Vec<_>>())
        };
        let records = self.scene.output.values.iter().map(at).collect::<Result<Vec<_>>>()?.concat();
        let mut searched = self.searched()?;
        searched.why = format!("at the values that are not marked as proved {}", searched.why);
        Ok(Output::new(Want::Equilibria, Promise::Estimated, records).complete(searched))
    }

    /// The path: proved where the folds are, except for the energy.
    fn path(&self) -> Result<Output> {
        let isolated = self.isolated()?;
        let output = |records| Output::path(Promise::Estimated, records);
        if let Some(isolated) = isolated
            && let Some((proved, followed)) = enclosed::path(self, isolated)?
        {
            return Ok(match followed.with_energy(self, isolated) {
                Ok(records) => proved.with_energy_of(output(records)),
                Err(error) => proved.without_energy(&error.to_string()),
            });
        }
        let estimated = output(self.estimated(|states| states.path(&self.scene.held))?);
        let mut searched = self.searched()?;
        if let Some(Complete { proved: true, from, to, .. }) = isolated.map(Isolated::complete) {
            let [from, to] = [from, to].map(|end| end.as_deref().unwrap_or("infinity").to_owned());
            searched.why += &format!("; not every state of the path is proved within radii from {from} to {to} m");
        }
        Ok(estimated.complete(searched))
    }

    /// The folds on which proofs rest: of closed forms, and of tables that are short and leave nothing undecided. A longer or
    /// a rougher table is better searched.
    fn isolated(&self) -> Result<Option<&Isolated>> {
        if let Some(isolated) = self.isolated.get() {
            return Ok(isolated.as_ref());
        }
        let profile = &self.scene.profile;
        let isolated = match profile.rows() {
            None if profile.is_closed() => Some(Isolated::new(self)?),
            Some(rows) if rows <= PROVED_ROWS => Some(Isolated::new(self)?).filter(Isolated::is_complete),
            _ => None,
        };
        Ok(self.isolated.get_or_init(|| isolated).as_ref())
    }

    /// What is computed at states that f64 has found.
    fn estimated(
        &self,
        compute: impl Fn(&States<'_, Float>) -> Result<Vec<Record<Estimate<Float>>>>,
    ) -> Result<Vec<Record<Number>>> {
        let rough = self.rough()?;
        let folds = rough.folds()?;
        estimated(self.digits, |precision| {
            let contact = self.contact::<Float>(precision)?;
            let folds = polished(&contact, folds)?;
            compute(&States::new(&contact, folds, self.admissibility()?))
        })
    }

    fn read<R: Arithmetic>(&self, contact: &Contact<R>, want: Want, radii: &[Literal]) -> Result<Vec<Record<R>>> {
        match want {
            Want::Transform => outputs::transform(contact, radii),
            _ => outputs::curve(contact, radii, &*self.admissibility()?),
        }
    }

    fn searched(&self) -> Result<Complete> {
        let search = self.rough()?.completeness()?;
        let long = match self.scene.profile.rows() {
            Some(rows) if rows > PROVED_ROWS => {
                format!("; tables are proved up to {PROVED_ROWS} rows, this has {rows}")
            }
            _ => String::new(),
        };
        Ok(not_proved(&format!("{}; found in f64, then sharpened{long}", search.why)))
    }
}
