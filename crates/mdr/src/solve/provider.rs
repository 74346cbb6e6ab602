//! Who can answer a request, in the order in which they are asked.

#[cfg(feature = "mp")]
use mdr_core::contact::Error;
use mdr_core::contact::Result;

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
    /// Two precisions that agree.
    #[cfg(feature = "mp")]
    Estimate(&'a Certified<'s>),
    /// A search in f64.
    Search(&'a Search<'s>),
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
            Provider::Proof(certified) => room.proved(certified),
            #[cfg(feature = "mp")]
            Provider::Estimate(certified) => match (certified.take_kept(), room.estimated(certified)) {
                // A part that is proved is more than a whole that is open.
                (Some(kept), Err(error)) if super::is_open(&error) => Ok(Some(kept)),
                (Some(kept), Ok(output)) if room.has_open_numbers(&output) => Ok(Some(kept)),
                (_, output) => output.map(Some),
            },
            // What f64 does not hold is left to those with more digits.
            #[cfg(feature = "mp")]
            Provider::Search(search) => match room.searched(search) {
                Err(Error::OutOfRange { .. }) => Ok(None),
                output => output.map(|output| Some(output).filter(|output| !room.lost_numbers(output))),
            },
            #[cfg(not(feature = "mp"))]
            Provider::Search(search) => room.searched(search).map(Some),
        }
    }
}
