//! The path over enclosures: every digit and every decision proved, except for its energies.

use mdr_core::contact::{Control, Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::path::{Event, EventKind, Path};
use mdr_numeric::proof::ProvedBranches;

use super::{Energies, LoadingPath, PathEvent, PathNumbers, energies, events, follow, is_arrival};
use crate::answer::record::Numbers;
use crate::answer::{Completeness, Number, Promise, Value};
use crate::scene::Scene;
use crate::solve::certified::Certified;
use crate::solve::digits::{MOST_OF_INTEGRALS, decide_within, start};
use crate::solve::proof::{Enclosed, FoldProof, decided, exactly, reached};

/// How many times the bits of the digits are tried to show that no fold lies outside the range of the proof.
const ENOUGH: u32 = 16;

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
    /// No stable equilibrium at the first way point; errors of the transform, see [`Path::follow`]; [`Error::Unproved`] if more
    /// bits do not help.
    fn new(certified: &Certified<'_>, folds: &FoldProof, precision: Precision) -> Result<Self> {
        with_path(certified, folds, precision, |enclosed, _, path| {
            Ok(Followed { path, contact: enclosed.value.contact(), bits: precision.bits() })
        })
    }
}

/// What `use_them` makes of the contact over enclosures, its branches, and the path between them, of which every decision is certain.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform, see [`Path::follow`]; [`Error::Unproved`] if more bits do not
/// help; errors of `use_them`.
pub(crate) fn with_path<T>(
    certified: &Certified<'_>,
    folds: &FoldProof,
    precision: Precision,
    use_them: impl FnOnce(&Enclosed, &ProvedBranches, Path<Interval>) -> Result<T>,
) -> Result<T> {
    let enclosed = Enclosed::new(certified, precision)?;
    let branches = ProvedBranches::new(enclosed.curve(), &folds.proved)?;
    let branches = surrounded(branches, certified, precision)?;
    let path = started(follow(&enclosed.value, &branches, certified.scene), enclosed.value.control())?;
    checked(&path, [&branches], certified)?;
    use_them(&enclosed, &branches, path)
}

/// A path that starts in the range of the proof.
///
/// # Errors
/// [`Error::Unproved`] where there is no equilibrium in that range, whatever the precision.
pub(super) fn started(path: Result<Path<Interval>>, control: &Control<Interval>) -> Result<Path<Interval>> {
    match path {
        Err(Error::NoEquilibrium { .. }) => Err(unproved(control)),
        path => path,
    }
}

/// Checks that a path uses proved results only.
///
/// # Errors
/// [`Error::Undecided`] where more bits may decide it, else [`Error::Unproved`]; see [`ProvedBranches::check`].
pub(super) fn checked<'b>(
    path: &Path<Interval>,
    branches: impl IntoIterator<Item = &'b ProvedBranches>,
    certified: &Certified<'_>,
) -> Result<()> {
    let asked_for = start(certified.digits).bits();
    branches.into_iter().try_for_each(|branches| {
        branches.check(path).map_err(|error| match error {
            // The rest of the radii is long, and not a matter of bits.
            Error::Undecided { bits, .. } if bits >= ENOUGH * asked_for => unproved(branches.control()),
            error => error,
        })
    })
}

fn unproved(control: &Control<Interval>) -> Error {
    let (from, to) = ("0".to_owned(), "infinity".to_owned());
    Error::Unproved { quantity: control.quantity(), from, to, remedy: "name a wider range of radii" }
}

/// Branches with what is known of their surroundings: which states are admissible, and the profile where one may not be.
fn surrounded(branches: ProvedBranches, certified: &Certified<'_>, precision: Precision) -> Result<ProvedBranches> {
    let admissibility = certified.admissibility()?;
    let rises = admissibility.holds_by_form();
    let branches = branches.with_admissibility(admissibility);
    Ok(match certified.formulas()? {
        Some(formulas) if !rises => branches.with_profile(formulas.continued(precision)?),
        _ => branches,
    })
}

impl Followed {
    /// Its energies over enclosures, each of them proved; `None` if one cannot be.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn proved_energy(
        &mut self,
        certified: &Certified<'_>,
        folds: &FoldProof,
    ) -> Result<Option<PathNumbers<Number>>> {
        let scene = certified.scene;
        let begin = start(certified.digits);
        if !certified.encloses_energies()? {
            let falls = energies::of_falls(&self.path, self.contact.control());
            let of_falls = |falls: PathNumbers<Enclosure>| {
                reached(decide_within(MOST_OF_INTEGRALS, begin, certified.digits, |_| Ok(falls.clone())))
            };
            return falls.map_or(Ok(None), of_falls);
        }
        reached(decide_within(MOST_OF_INTEGRALS, begin, certified.digits, |precision| {
            if self.bits < precision.bits() {
                *self = Followed::new(certified, folds, precision)?;
            }
            let contact = certified.model::<Interval>(precision)?.contact();
            // The states are known to more bits than integrals of few digits need.
            let path = self.path.map(|number| number.rounded(precision));
            certified.with_energy(&contact, |energy| energies::of_path(&path, &scene.path, &contact, energy))
        }))
    }
}

/// The path without its energy, every decision of it proved; `None` if one cannot be proved.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform. See [`Path::follow`].
pub(super) fn path(
    certified: &Certified<'_>,
    folds: &FoldProof,
    energies: Energies,
) -> Result<Option<(LoadingPath, Followed)>> {
    let scene = certified.scene;
    let precision = energies.precision_of_states(certified.digits);
    let mut last = None;
    let items = certified.decide_from(precision, |precision| {
        let followed = last.insert(Followed::new(certified, folds, precision)?);
        let events = events::of_contact(&followed.contact, &followed.path, &*certified.admissibility()?);
        let mut events = events.convert(Enclosure::from);
        set_exact(&mut events, &followed.path, scene);
        Ok(events)
    });
    let why = if folds.is_apart {
        "every decision on the path is certain: the surfaces stay apart until they first touch, on a ring"
    } else {
        "every decision on the path is certain, and its folds are proved to be all"
    };
    let complete = Completeness { why: why.to_owned(), ..folds.complete.clone() };
    let path = |events| LoadingPath::new(Promise::Certified, PathNumbers { events, balance: None }, complete);
    Ok(decided(items)?.map(path).zip(last))
}

/// Whether the fold from which the contact jumps or breaks in an event is at the depth 0, exactly.
pub(crate) fn breaks_at_zero_depth(scene: &Scene, event: &Event<Interval>) -> bool {
    let fold = event.fold.and(event.before.contact());
    fold.is_some_and(|fold| scene.breaks_at_zero_depth(&fold.contact_radius))
}

/// The value of the controlled quantity in each event as the way points state it; `None` in between. An edge stops at the way point at
/// which the controlled quantity turns.
pub(crate) fn written<'w>(way: &'w [Literal], path: &Path<Interval>) -> Vec<Option<&'w Literal>> {
    let mut way = way.iter();
    let mut last = None;
    let of_event = |event: &Event<Interval>| {
        if is_arrival(event.kind) {
            last = way.next();
        }
        last.filter(|_| is_arrival(event.kind) || event.kind == EventKind::Pinned)
    };
    path.events.iter().map(of_event).collect()
}

/// Gives the events the exact value of the controlled quantity where the way points state it, and the depth 0 where a contact breaks at it.
/// Surfaces apart carry no load, whatever is applied.
pub(super) fn set_exact(records: &mut [PathEvent<Enclosure>], path: &Path<Interval>, scene: &Scene) {
    let written = written(&scene.path, path);
    for ((record, event), literal) in records.iter_mut().zip(&path.events).zip(written) {
        if breaks_at_zero_depth(scene, event) {
            record.indentation = Some(exactly(&0.into()));
        }
        let value = match scene.control {
            Control::Indentation => &mut record.indentation,
            Control::Force if event.before.contact().is_none() => continue,
            Control::Force => &mut record.force,
            Control::Machine { .. } => &mut record.position.0,
        };
        if let (Some(literal), Some(Value::Known(_))) = (literal, &value) {
            *value = Some(exactly(literal));
        }
    }
}
