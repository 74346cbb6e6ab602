//! Gaps outside contacts on a half-space, open or closed, over enclosures: a proof for each state that is asked for.

use mdr_core::contact::Result;
use mdr_core::number::Interval;

use super::continuation::Continuation;
use super::overlap::{Outside, Place};
use crate::contact::Contact;

/// A contact on a half-space, with its profile as formulas, from which the gap outside any state is enclosed. Without them it is
/// known where g rises.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Expression, Material};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::{contact::Contact, proof::{Continuation, EnclosedGaps}, transform::Enclosed};
/// // Waves of 10 mm on a paraboloid of 1 m: a contact on the first crest reaches the next crest when it is pressed deep.
/// let formula: Expression = "r^2/2 + 0.01*(1 - cos(20*pi*r))".parse()?;
/// let (none, precision) = (Default::default(), Precision::new(64));
/// let formula = || formula.enclosed(&none, &formula.breaks(&none)?, precision);
/// let transform = Arc::new(Enclosed::new(formula()?, precision));
/// let number = |x: f64| Interval::from_f64(precision, x);
/// let contact = Contact::half_space(&transform, &Material::new(number(1.0), number(1e-6))?, &Control::Indentation);
/// let gaps = EnclosedGaps::new(contact.clone(), Continuation::new(vec![formula()?]))?;
/// let [shallow, deep] = [number(0.01), number(0.03)];
/// assert!(gaps.are_open(&shallow, &contact.indentation(&shallow)?));
/// assert!(gaps.is_closed(&deep, &contact.indentation(&deep)?, 0.1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EnclosedGaps {
    contact: Contact<Interval>,
    profile: Option<Continuation>,
}

impl EnclosedGaps {
    /// # Errors
    /// [`Error::Domain`](mdr_core::contact::Error::Domain) on another medium than a half-space.
    pub fn new(contact: Contact<Interval>, profile: Option<Continuation>) -> Result<Self> {
        super::check_half_space(&contact)?;
        Ok(EnclosedGaps { contact, profile })
    }

    /// Whether it is proved that no gap outside a contact of radius a at the indentation d is negative, up to the end of the
    /// profile.
    pub fn are_open(&self, a: &Interval, d: &Interval) -> bool {
        let transform = self.contact.transform();
        if transform.rises_beyond(a) && transform.g(a).is_ok_and(|g| g.lower() >= d.upper()) {
            return true;
        }
        self.at(a, d).is_some_and(|(outside, place)| outside.check_everywhere(&place).is_ok())
    }

    /// Whether it is proved that the gap at a radius is negative, so that the surfaces overlap there.
    pub fn is_closed(&self, a: &Interval, d: &Interval, r: f64) -> bool {
        self.at(a, d).is_some_and(|(outside, place)| outside.is_closed(&place, r).is_ok_and(|closed| closed))
    }

    fn at(&self, a: &Interval, d: &Interval) -> Option<(Outside<'_>, Place)> {
        let place = Place { a: a.clone(), d: d.clone() };
        Some((Outside { contact: &self.contact, profile: self.profile.as_ref()? }, place.rough()))
    }
}
