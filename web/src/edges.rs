//! A contact with two works of adhesion: an edge that advances, one that recedes, and one that is pinned between the two.

use std::sync::Arc;

use mdr::ContactError;
use mdr::prelude::*;
use mdr_core::contact::{Edge, Equilibrium, Quantity, Transform};
use mdr_numeric::admissible::{Admissibility, NOT_SEARCHED, search_range};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{ContactState, Dissipation, EdgeEnergies, Edges, Event, EventKind, Path};

/// The results of a search.
type Result<T> = std::result::Result<T, ContactError>;

/// The branches of equilibria of both edges.
pub(crate) struct BothEdges {
    contact: Contact<f64>,
    advancing: SearchedBranches<f64>,
    receding: SearchedBranches<f64>,
}

impl BothEdges {
    /// From a contact with two works of adhesion; `flat` is g of the same profile on a half-space, if it has one.
    pub(crate) fn new(contact: Contact<f64>, flat: Option<&Arc<dyn Transform<f64>>>) -> Result<Self> {
        let branches = |edge| {
            let branches = SearchedBranches::new(contact.at(edge))?;
            let judged = admissibility(&branches, flat);
            Ok(branches.with_admissibility(Arc::new(judged)))
        };
        let (advancing, receding) = (branches(Edge::Advancing)?, branches(Edge::Receding)?);
        Ok(BothEdges { contact, advancing, receding })
    }

    /// a, d, F, kind of the folds of the advancing edge (0 minimum, 1 maximum).
    pub(crate) fn advancing_folds(&self) -> impl Iterator<Item = [f64; 4]> {
        let finite = self.advancing.folds().iter().filter(|fold| fold.indentation.is_finite());
        finite.map(|fold| {
            let kind = f64::from(u8::from(fold.kind == FoldKind::Maximum));
            [self.contact.medium().contact_radius(&fold.contact_radius), fold.indentation, fold.force, kind]
        })
    }

    /// The curve of equilibria of the advancing edge: rows of a, g, Δl, d, F, stable.
    pub(crate) fn advancing_curve(&self, radii: &[f64]) -> Result<Vec<[f64; 6]>> {
        let curve = self.advancing.curve();
        let row = |a: &f64| {
            let size = curve.medium().size_within(a)?;
            let (d, force) = curve.state(&size)?;
            let g = curve.transform().g(&size)?;
            let branch = self.advancing.folds().partition_point(|fold| fold.contact_radius < size);
            let stable = f64::from(u8::from(self.advancing.is_stable(branch) != Some(false)));
            Ok([*a, g, g - d, d, force, stable])
        };
        // Radii outside of the profile have no state.
        let known = |found: Result<[f64; 6]>| match found {
            Err(ContactError::Domain { .. }) => None,
            found => Some(found),
        };
        radii.iter().filter_map(|a| known(row(a))).collect()
    }

    /// The equilibria of the advancing edge at a value of the control: rows of a, d, F, stability.
    pub(crate) fn advancing_at(&self, value: f64) -> Result<Vec<[f64; 4]>> {
        let found = self.advancing.equilibria(&value)?.into_iter().map(|state| {
            let sign = if state.stability == Stability::Unstable { -1.0 } else { 1.0 };
            let [a, d, force] = self.numbers(&state, value);
            [a, d, force, sign]
        });
        Ok(found.collect())
    }

    /// d and F of an edge that is pinned at a radius while the control is held at a value.
    pub(crate) fn pinned(&self, a: f64, value: f64) -> Result<[f64; 2]> {
        self.contact.control().check_value(&value)?;
        let size = self.size(a)?;
        let state = self.edges().pinned(&size, &value)?;
        Ok([state.indentation, state.force])
    }

    /// The events on the way from one value of the control to another: rows of kind, value, a, d, F before, a, d, F after, the
    /// energy lost in the jump and that lost by the receding edge.
    pub(crate) fn advance(&self, start: &Start<f64>, way: [f64; 2]) -> Result<Vec<[f64; 10]>> {
        let start = match start {
            Start::Nearest(a) => Start::Nearest(self.size(*a)?),
            start => start.clone(),
        };
        let path = Path::follow_edges(&self.edges(), &start, &way, None)?;
        let energies = EdgeEnergies::new(&self.advancing, &self.receding);
        let losses = energies.by_jumps(&path).into_iter().zip(energies.by_receding(&path));
        let row = |(event, (jump, receded)): (&Event<f64>, (Result<_>, Result<f64>))| {
            let lost = match jump {
                _ if !super::engine::changes(event.kind) => 0.0,
                Ok(Dissipation::Finite(lost)) => lost.value,
                Ok(Dissipation::Unbounded) => f64::INFINITY,
                Err(_) => f64::NAN,
            };
            let [[a, d, force], [to_a, to_d, to_force]] =
                [&event.before, &event.after].map(|s| self.state(s, event.value));
            let kind = super::engine::number(event.kind);
            [kind, event.value, a, d, force, to_a, to_d, to_force, lost, receded.unwrap_or(f64::NAN)]
        };
        let events = path.events.iter().zip(losses);
        Ok(events.filter(|(event, _)| event.kind != EventKind::Start).map(row).collect())
    }

    fn edges(&self) -> Edges<'_, f64, SearchedBranches<f64>> {
        Edges::new(&self.contact, &self.advancing, &self.receding)
    }

    fn size(&self, a: f64) -> Result<f64> {
        let a = ContactError::require_positive(Quantity::ContactRadius, a)?;
        self.contact.medium().size_within(&a)
    }

    fn numbers(&self, state: &Equilibrium<f64>, value: f64) -> [f64; 3] {
        let state = state.clone().controlled(self.contact.control(), value);
        [self.contact.medium().contact_radius(&state.contact_radius), state.indentation, state.force]
    }

    fn state(&self, state: &ContactState<f64>, value: f64) -> [f64; 3] {
        match state {
            ContactState::Contact(rest) => self.numbers(rest, value),
            ContactState::Detached if *self.contact.control() == Control::Force => [0.0, f64::NAN, 0.0],
            ContactState::Detached => [0.0, value, 0.0],
            ContactState::Complete => [f64::NAN; 3],
        }
    }
}

/// Which states of an edge are admissible: as `mdr solve` decides it.
fn admissibility(branches: &SearchedBranches<f64>, flat: Option<&Arc<dyn Transform<f64>>>) -> Admissibility {
    let curve = branches.curve();
    let radii: Vec<f64> = branches.folds().iter().map(|fold| fold.contact_radius).collect();
    let range = search_range(curve.material_length(), &radii);
    if curve.medium().is_half_space() {
        return Admissibility::new(Arc::clone(curve.shared_transform()), range);
    }
    if curve.transform().rises() {
        return Admissibility::of_rising();
    }
    let unknown = Admissibility::unknown(NOT_SEARCHED);
    match flat {
        Some(flat) => unknown.touching_as(&Admissibility::new(Arc::clone(flat), range)),
        None => unknown.touching_as(Admissibility::rising()),
    }
}
