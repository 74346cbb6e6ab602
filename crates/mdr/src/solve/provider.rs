//! Who can answer a request, in the order in which they are asked.

#[cfg(feature = "mp")]
use mdr_core::contact::Error;
use mdr_core::contact::Result;

#[cfg(feature = "mp")]
use super::Route;
use super::search::Search;
#[cfg(feature = "mp")]
use super::{certified::Certified, power_law::PowerLaw};
use crate::answer::Output;
use crate::outputs::room::Room;

/// One way to an output.
#[derive(Clone, Copy)]
pub(super) enum Provider<'a, 's> {
    /// Closed forms.
    #[cfg(feature = "mp")]
    Law(&'a PowerLaw<'s>),
    /// Enclosures.
    #[cfg(feature = "mp")]
    Proof(&'a Certified<'s>),
    /// A search in f64, which leaves what f64 does not hold to the next provider.
    Search(&'a Search<'s>),
    /// The search in f64 with all that it has.
    #[cfg(feature = "mp")]
    Last(&'a Route<'s>),
}

impl Provider<'_, '_> {
    /// The output; `None` leaves it to the next provider.
    ///
    /// # Errors
    /// Errors of the transform, of the quadratures and of the proofs; a decision that no precision makes.
    pub(super) fn output(&self, room: &dyn Room<'_>) -> Result<Option<Output>> {
        match self {
            #[cfg(feature = "mp")]
            Provider::Law(law) => room.by_law(law),
            #[cfg(feature = "mp")]
            // What f64 has found before is left.
            Provider::Proof(certified) => match room.proved(certified) {
                Err(Error::BudgetSpent { .. }) => Ok(None),
                output => output,
            },
            #[cfg(feature = "mp")]
            Provider::Search(search) => match room.searched(search) {
                Err(Error::OutOfRange { .. }) => Ok(None),
                output => output.map(|output| Some(output).filter(|output| !room.lost_numbers(output))),
            },
            #[cfg(feature = "mp")]
            Provider::Last(route) => {
                let output = match route.search().and_then(|search| room.searched(search)) {
                    Err(Error::OutOfRange { quantity, .. }) => {
                        let what = "a number beyond the range of f64: take units in which the contact is nearer to 1";
                        Err(Error::Undecided { quantity, bits: f64::MANTISSA_DIGITS, what })
                    }
                    output => output,
                };
                match (route.kept(), output) {
                    // A part that is proved is more than a whole that is open.
                    (Some(kept), Err(error)) if super::is_open(&error) => Ok(Some(kept)),
                    (Some(kept), Ok(output)) if room.has_open_numbers(&output) => Ok(Some(kept)),
                    (_, output) => output.map(Some),
                }
            }
            #[cfg(not(feature = "mp"))]
            Provider::Search(search) => room.searched(search).map(Some),
        }
    }
}
