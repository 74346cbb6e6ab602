//! Admissibility by enclosures: g that is proved to fall nowhere, and gaps that are proved to be open or closed.

use std::sync::Arc;

use mdr_core::number::{Interval, Real};

use super::{Admissibility, FirstTouch, GapVerdict};
use crate::proof::EnclosedGaps;

/// A radius just inside of another.
const INSIDE: f64 = 1.0 - 1e-6;

impl Admissibility {
    /// For a transform whose g falls nowhere, which is proved by enclosures: every state is admissible on any medium.
    pub fn of_proved_rise() -> Self {
        Admissibility { is_rising: true, ..Self::of_rising() }
    }

    /// With enclosures of the gap, by which each state is [decided](Admissibility::decided) with a proof.
    #[must_use]
    pub fn with_gaps(&self, gaps: EnclosedGaps) -> Self {
        Admissibility { gaps: Some(Arc::new(gaps)), ..self.clone() }
    }

    /// Whether a contact of radius a at the indentation d, both enclosed, is admissible. With [gaps](Admissibility::with_gaps) the
    /// verdict is proved. The search in doubles says where to look first; of a formula it costs more than a proof, and is not made: there
    /// the ring on which f is lowest comes first.
    pub fn decided(&self, a: &Interval, d: &Interval) -> GapVerdict {
        let searched = || self.of(a.approx(), d.approx());
        let Some(gaps) = &self.gaps else { return searched() };
        let known = match &self.touch {
            Some(FirstTouch::Ring(ring)) => {
                let [radius, _] = ring.at::<f64>(());
                gaps.overlap(a, d, radius).map(|gap| GapVerdict::Interpenetrating { radius, gap })
            }
            Some(FirstTouch::Tip | FirstTouch::OfShape(_) | FirstTouch::Open { .. }) => None,
            // The rim of a dimple is the end of the profile.
            None => Some(searched()).filter(|verdict| match verdict {
                GapVerdict::Interpenetrating { radius, .. } => {
                    [*radius, radius * INSIDE].into_iter().any(|radius| gaps.is_closed(a, d, radius))
                }
                GapVerdict::Admissible | GapVerdict::Undecided(_) => false,
            }),
        };
        known.unwrap_or_else(|| gaps.verdict(a, d))
    }
}
