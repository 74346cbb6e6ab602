//! Equilibria at a given indentation depth or force.

use mdr_core::contact::{Control, Equilibrium, Error, Material, Quantity, Ranged, Regime, Result};
use mdr_core::number::Wide;

use super::ready::Ready;
use super::ziv::{Round, decide, settle, undecided};
use super::{contact, lifted_control};
use crate::contact::Contact;
use crate::inverse::{Equilibria, Fold, Held};

/// The equilibria at a given indentation depth or force, with their stability; see
/// [`Contact::equilibria`](crate::Contact::equilibria).
///
/// # Errors
/// See the [module](super).
pub fn equilibria(
    n: f64,
    c: f64,
    material: &Material<f64>,
    control: &Control<f64>,
    value: f64,
) -> Result<Equilibria<Ranged<f64>>> {
    Inverse::new(n, c, material, control)?.equilibria(value)
}

/// The equilibria at x_fold(1 − τ); see
/// [`Contact::equilibria_at_distance`](crate::Contact::equilibria_at_distance).
///
/// # Errors
/// See the [module](super).
pub fn equilibria_at_distance(
    n: f64,
    c: f64,
    material: &Material<f64>,
    control: &Control<f64>,
    distance: f64,
) -> Result<Equilibria<Ranged<f64>>> {
    decide!(Quantity::ContactRadius, W => {
        contact::<W>(n, c, material)?.equilibria_at_distance(&lifted_control(control)?, &finite(distance)?.into())
    })
}

/// A contact under one control, ready to be asked for its equilibria at many values.
///
/// ```
/// use mdr_analytic::double::Inverse;
/// use mdr_core::contact::{Control, Material, Ranged};
/// // r²/2R with R = 1: at d = 0 the radius is (2πwR²/E*)^(1/3).
/// let ball = Inverse::new(2.0, 0.5, &Material::new(1.0, 1.0)?, &Control::Indentation)?;
/// let touching = ball.equilibria(0.0)?;
/// assert_eq!(touching.as_slice()[0].contact_radius, Ranged::Value(1.8452701486440284)); // (2π)^(1/3)
/// assert_eq!(ball.equilibria(-1.0)?.as_slice().len(), 2);
/// assert_eq!(ball.equilibria(-2.0)?.as_slice().len(), 0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Inverse {
    n: f64,
    c: f64,
    material: Material<f64>,
    held: Held,
    /// What one word knows, unless n = 1/2 or it knows too little.
    word: Option<(Contact<Wide<1>>, Fold<Wide<1>>)>,
    ready: Option<Ready>,
}

impl Inverse {
    /// The contact of f = C rⁿ under controlled indentation or force.
    ///
    /// # Errors
    /// See the [module](super); [`Error::Domain`] for a machine of finite stiffness.
    #[inline]
    pub fn new(n: f64, c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Self> {
        let held = Held::of(control)?;
        let contact = contact::<Wide<1>>(n, c, material)?;
        let word = if n == 0.5 { None } else { Fold::new(&contact, held).ok().map(|fold| (contact, fold)) };
        let ready = word.as_ref().and_then(|(contact, fold)| Ready::new(contact, fold));
        Ok(Inverse { n, c, material: material.clone(), held, word, ready })
    }

    /// The equilibria at a value of the controlled quantity.
    ///
    /// # Errors
    /// See the [module](super).
    #[inline]
    pub fn equilibria(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        finite(value)?;
        if let Some(found) = self.ready.as_ref().and_then(|ready| ready.equilibria(value)) {
            return Ok(found);
        }
        if let Some((contact, fold)) = &self.word
            && let Some(settled) = settle(|| fold.at_value(contact, &value.into()))
        {
            return settled;
        }
        self.with_more_words(value)
    }

    #[cold]
    fn with_more_words(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        decide!(Quantity::ContactRadius, W => {
            let contact = contact::<W>(self.n, self.c, &self.material)?;
            let value = value.into();
            let by_fold = match contact.regime()? {
                Regime::ScaleFree => None,
                _ => Fold::new(&contact, self.held).and_then(|fold| fold.at_value(&contact, &value)).ok(),
            };
            // At n = 1/2 there is no fold, and next to it it is beyond all range.
            match by_fold {
                Some(found) => Ok(found),
                None => contact.equilibria(&self.held.control(), &value),
            }
        })
    }
}

#[inline]
fn finite(value: f64) -> Result<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(Error::domain(Quantity::Parameter("the given value"), &value, "finite"))
}

impl<const N: usize> Round for Equilibria<Wide<N>> {
    type Rounded = Equilibria<Ranged<f64>>;

    #[inline(always)]
    fn round(&self) -> Option<Self::Rounded> {
        self.transform(|state| {
            Some(Equilibrium {
                contact_radius: state.contact_radius.round()?,
                indentation: state.indentation.round()?,
                force: state.force.round()?,
                stability: state.stability,
            })
        })
    }
}
