//! Admissibility by enclosures: extrema of g that are proved to be all, and gaps that are proved to be open or closed.

use std::sync::Arc;

use mdr_core::contact::Transform;
use mdr_core::number::{Interval, Real};

use super::extrema::Terrain;
use super::{Admissibility, GapVerdict};
use crate::proof::EnclosedGaps;

/// Why nothing is said of a state whose gap is not enclosed closely enough.
const NOT_DECIDED: &str = "enclosures of the gap outside the contact do not decide it";

impl Admissibility {
    /// For a transform whose g falls nowhere, which is proved by enclosures: every state is admissible on any medium.
    pub fn of_proved_rise() -> Self {
        Admissibility { isolated: true, ..Self::of_rising() }
    }

    /// For a transform whose extrema between two radii are proved to be all, g rising beyond; what is known of the first touch
    /// stays. The gap between them is computed in doubles.
    #[must_use]
    pub fn with_extrema(&self, transform: Arc<dyn Transform<f64>>, extrema: &[f64], range: [f64; 2]) -> Self {
        let terrain = Some(Arc::new(Terrain::of_extrema(transform, extrema, range)));
        Admissibility { terrain, isolated: true, unknown: None, ..self.clone() }
    }

    /// With enclosures of the gap, by which each state is [decided](Admissibility::decided) with a proof.
    #[must_use]
    pub fn with_gaps(&self, gaps: EnclosedGaps) -> Self {
        Admissibility { gaps: Some(Arc::new(gaps)), ..self.clone() }
    }

    /// Whether a contact of radius a at the indentation d, both enclosed, is admissible. With [gaps](Admissibility::with_gaps) the
    /// verdict in doubles says only where to look: it stands if enclosures prove it, and otherwise nothing is said.
    pub fn decided(&self, a: &Interval, d: &Interval) -> GapVerdict {
        let rough = self.of(a.approx(), d.approx());
        let Some(gaps) = &self.gaps else { return rough };
        match rough {
            GapVerdict::Interpenetrating { radius, .. } if gaps.is_closed(a, d, radius) => rough,
            GapVerdict::Interpenetrating { .. } => GapVerdict::Undecided(NOT_DECIDED),
            GapVerdict::Admissible | GapVerdict::Undecided(_) if gaps.are_open(a, d) => GapVerdict::Admissible,
            GapVerdict::Admissible => GapVerdict::Undecided(NOT_DECIDED),
            GapVerdict::Undecided(why) => GapVerdict::Undecided(why),
        }
    }
}
