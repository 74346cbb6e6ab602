//! The path between two works of adhesion over enclosures: every digit and every decision proved, and its energies on a half-space.

use mdr_core::contact::{Edge, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Precision};
use mdr_numeric::contact::Contact;
use mdr_numeric::path::Path;
use mdr_numeric::proof::ProvedBranches;

use super::proof::{checked, set_exact, started};
use super::{Energies, LoadingPath, PathNumbers, edges, edges_energies, events};
use crate::answer::record::Numbers;
use crate::answer::{Completeness, Number, Promise};
use crate::solve::certified::Certified;
use crate::solve::digits::{MOST_OF_INTEGRALS, decide_within, start};
use crate::solve::proof::{Enclosed, FoldProof, decided, reached};

/// The contact at the works of adhesion of an advancing and of a receding edge, each with all its folds.
pub(crate) struct Pair<'a, 's> {
    pub(crate) edges: [&'a Certified<'s>; 2],
    pub(crate) folds: [&'a FoldProof; 2],
}

/// What `use_them` makes of the contact of each edge over enclosures, its branches, and the path between them, of which every decision is
/// certain.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform, see [`Path::follow_edges`]; [`Error::Unproved`] if more bits
/// do not help; errors of `use_them`.
///
/// [`Error::Unproved`]: mdr_core::contact::Error::Unproved
pub(crate) fn with_path<T>(
    pair: &Pair<'_, '_>,
    precision: Precision,
    use_them: impl FnOnce([&Enclosed; 2], [&ProvedBranches; 2], Path<Interval>) -> Result<T>,
) -> Result<T> {
    let receding = pair.edges[1];
    let of = |edge: usize| {
        let enclosed = Enclosed::new(pair.edges[edge], precision)?;
        let branches = ProvedBranches::new(enclosed.curve(), &pair.folds[edge].proved)?;
        Ok((branches.with_admissibility(receding.admissibility()?), enclosed))
    };
    let [(outer, advancing), (inner, enclosed)] = [of(0)?, of(1)?];
    let path = edges::follow(&enclosed.value, [&outer, &inner], receding.scene);
    let path = started(path, enclosed.value.control())?;
    checked(&path, [&outer, &inner], receding)?;
    use_them([&advancing, &enclosed], [&outer, &inner], path)
}

/// A path that was followed over enclosures.
pub(super) struct Followed {
    path: Path<Interval>,
    contact: Contact<Interval>,
    bits: u32,
}

impl Followed {
    /// Every decision on the path is certain.
    ///
    /// # Errors
    /// No stable equilibrium at the first way point; errors of the transform, see [`Path::follow_edges`]; [`Error::Unproved`] if
    /// more bits do not help.
    fn new(pair: &Pair<'_, '_>, precision: Precision) -> Result<Self> {
        with_path(pair, precision, |enclosed, _, path| {
            Ok(Followed { path, contact: enclosed[1].value.contact(), bits: precision.bits() })
        })
    }

    /// Its energies over enclosures, each of them proved; `None` if one cannot be.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn proved_energy(&mut self, pair: &Pair<'_, '_>) -> Result<Option<PathNumbers<Number>>> {
        let certified = pair.edges[1];
        let scene = certified.scene;
        if !certified.encloses_energies()? || scene.medium.is_periodic() {
            return Ok(None);
        }
        reached(decide_within(MOST_OF_INTEGRALS, start(certified.digits), certified.digits, |precision| {
            if self.bits < precision.bits() {
                *self = Followed::new(pair, precision)?;
            }
            let contact = certified.model::<Interval>(precision)?.at(Edge::Advancing).contact();
            // The states are known to more bits than integrals of few digits need.
            let path = self.path.map(|number| number.rounded(precision));
            certified.with_energy(&contact, |energy| edges_energies::of_path(&path, &scene.path, &contact, energy))
        }))
    }
}

/// The path without its energy, every decision of it proved; `None` if one cannot be proved.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform. See [`Path::follow_edges`].
pub(super) fn path(pair: &Pair<'_, '_>, energies: Energies) -> Result<Option<(LoadingPath, Followed)>> {
    let receding = pair.edges[1];
    let scene = receding.scene;
    let precision = energies.precision_of_states(receding.digits);
    let mut last = None;
    let items = receding.decide_from(precision, |precision| {
        let followed = last.insert(Followed::new(pair, precision)?);
        let events = events::of_contact(&followed.contact, &followed.path, &*receding.admissibility()?);
        let mut events = events.convert(Enclosure::from);
        set_exact(&mut events, &followed.path, scene);
        Ok(events)
    });
    let why = "every decision on the path is certain, and the folds of both edges are proved to be all";
    let complete = Completeness { why: why.to_owned(), ..pair.folds[1].complete.clone() };
    let path = |events| LoadingPath::new(Promise::Certified, PathNumbers { events, balance: None }, complete);
    Ok(decided(items)?.map(path).zip(last))
}
