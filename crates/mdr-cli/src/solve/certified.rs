//! A scene in certified digits: enclosures where g is a closed form, two precisions elsewhere.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::contact::Result;
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use rug::Float;

use super::answer::{Complete, Output, Promise};
use super::contact::{Arithmetic, Contact, Tally};
use super::digits::{estimated, proved};
use super::double::{Double, not_proved};
use super::record::Record;
use super::states::{States, polished};
use super::{exact, outputs};
use crate::number::Number;
use crate::scene::{Scene, Want};

/// The contact in certified digits; f64 tells where to look.
pub(crate) struct Certified<'s> {
    pub(super) scene: &'s Scene,
    pub(super) digits: u32,
    pub(super) tally: Arc<Tally>,
    rough: OnceCell<Double<'s>>,
}

impl<'s> Certified<'s> {
    pub(crate) fn new(scene: &'s Scene, digits: u32, tally: &Arc<Tally>) -> Self {
        Certified { scene, digits, tally: Arc::clone(tally), rough: OnceCell::new() }
    }

    /// # Errors
    /// Those of the transform, of the quadratures and of the proofs.
    pub(crate) fn output(&self, want: Want) -> Result<Output> {
        let (promise, complete, records) = match want {
            Want::Transform => self.along(want, &self.scene.output.transform)?,
            Want::Curve => self.along(want, &self.rough_or_given_radii()?)?,
            Want::Folds => self.folds()?,
            Want::Equilibria => {
                let values = &self.scene.output.values;
                let records = self.estimated(|states| states.equilibria(values))?;
                (Promise::Estimated, Some(self.searched()?), records)
            }
            Want::Path => {
                let records = self.estimated(|states| states.path(&self.scene.held))?;
                (Promise::Estimated, Some(self.searched()?), records)
            }
            Want::Pressure | Want::Gap | Want::Energy => {
                (Promise::Estimated, None, self.estimated(|states| states.fields(self.scene, want))?)
            }
        };
        Ok(Output { want, promise, exceptions: Vec::new(), complete, records })
    }

    /// The same contact in f64.
    ///
    /// # Errors
    /// As [`Contact::new`].
    pub(super) fn rough(&self) -> Result<&Double<'s>> {
        if let Some(rough) = self.rough.get() {
            return Ok(rough);
        }
        let rough = Double::new(self.scene, &self.tally)?;
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
    fn along(&self, want: Want, radii: &[Literal]) -> Result<Answered> {
        Ok(if self.scene.profile.is_closed() {
            let enclosed = |precision: Precision| {
                let records = read(&self.contact::<Interval>(precision)?, want, radii)?;
                Ok(records.into_iter().map(|record| record.convert(Enclosure::from)).collect())
            };
            (Promise::Certified, None, proved(self.digits, enclosed)?)
        } else {
            let records = estimated(self.digits, |precision| read(&self.contact::<Float>(precision)?, want, radii))?;
            (Promise::Estimated, None, records)
        })
    }

    /// All folds: proved where g is closed.
    fn folds(&self) -> Result<Answered> {
        if self.scene.profile.is_closed() {
            return exact::folds(self);
        }
        let records = |precision| {
            let contact = self.contact::<Float>(precision)?;
            Ok(polished(&contact, self.rough()?.folds()?)?.folds.into_iter().map(outputs::fold).collect())
        };
        Ok((Promise::Estimated, Some(self.searched()?), estimated(self.digits, records)?))
    }

    /// What is computed at states that f64 has found.
    fn estimated(
        &self,
        compute: impl Fn(&States<'_, Float>) -> Result<Vec<Record<Float>>>,
    ) -> Result<Vec<Record<Number>>> {
        let rough = self.rough()?;
        let folds = rough.folds()?;
        estimated(self.digits, |precision| {
            let contact = self.contact::<Float>(precision)?;
            let folds = polished(&contact, folds)?;
            compute(&States::new(&contact, rough.contact(), folds))
        })
    }

    fn searched(&self) -> Result<Complete> {
        let search = self.rough()?.completeness()?;
        Ok(not_proved(&format!("{}; found in f64, then sharpened", search.why)))
    }
}

/// A promise, what is known about completeness, and the records.
pub(super) type Answered = (Promise, Option<Complete>, Vec<Record<Number>>);

fn read<R: Arithmetic>(contact: &Contact<R>, want: Want, radii: &[Literal]) -> Result<Vec<Record<R>>> {
    match want {
        Want::Transform => outputs::transform(contact, radii),
        _ => outputs::curve(contact, radii),
    }
}
