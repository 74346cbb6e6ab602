//! Admissibility by enclosures: extrema of g that are proved to be all, and gaps that are proved to be open or closed.

use std::sync::Arc;

use mdr_core::contact::Transform;
use mdr_core::number::{Interval, Real};

use super::extrema::Terrain;
use super::{Admissibility, FirstTouch, GapVerdict, LazyTerrain};
use crate::proof::EnclosedGaps;

impl Admissibility {
    /// For a transform whose g falls nowhere, which is proved by enclosures: every state is admissible on any medium.
    pub fn of_proved_rise() -> Self {
        Admissibility { isolated: true, ..Self::of_rising() }
    }

    /// For a transform whose extrema between two radii are proved to be all, g rising beyond; what is known of the first touch
    /// stays. The gap between them is computed in doubles.
    #[must_use]
    pub fn with_extrema(&self, transform: Arc<dyn Transform<f64>>, extrema: &[f64], range: [f64; 2]) -> Self {
        let searched = Terrain::of_extrema(Arc::clone(&transform), extrema, range).into();
        let terrain = Some(Arc::new(LazyTerrain { transform, radii: range, searched }));
        Admissibility { terrain, isolated: true, unknown: None, ..self.clone() }
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
        match &self.touch {
            Some(FirstTouch::Ring(ring)) => {
                let [radius, _] = ring.at::<f64>(());
                if let Some(gap) = gaps.overlap(a, d, radius) {
                    return GapVerdict::Interpenetrating { radius, gap };
                }
            }
            Some(_) => {}
            None => {
                let verdict = searched();
                if matches!(verdict, GapVerdict::Interpenetrating { radius, .. } if gaps.is_closed(a, d, radius)) {
                    return verdict;
                }
            }
        }
        gaps.verdict(a, d)
    }
}
