//! Histories between two works of adhesion.

use mdr_core::contact::{Control, Edge, Error, Result};
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{EdgeEnergies, Edges, Path, Start};

use super::history::{Event, History, LoadingPath};
use super::{ContactColumns, States};
use crate::outputs::path::is_arrival;
use crate::run::{Stop, lack};
use crate::scene::Scene;

/// A contact between two works of adhesion, of an edge that advances and of one that recedes, in f64: its histories in columns. States
/// without a history are those of one of the edges, which [`ContactColumns`] have.
///
/// ```
/// use mdr::columns::EdgeColumns;
/// use mdr::prelude::*;
/// let text = "material = { e_star = 1, work_of_adhesion = { advancing = 0.01, receding = 0.04 } }\n\
///             profile = { kind = \"paraboloid\", radius = 1 }\ncontrol = { kind = \"indentation\" }\noutput = { want = [\"folds\"] }";
/// let ball = EdgeColumns::new(&Scene::from_toml(text, "ball.toml", &mdr::no_files)?)?;
/// let pressed = ball.follow(&Control::Indentation, &[-0.1, 0.1, 0.05, -0.2], &Start::Detached)?;
/// let radii = &pressed.states.contact_radius;
/// // The edge is pinned when the motion turns, and has come off at last.
/// assert!(radii[0] == 0.0 && radii[1] == radii[2] && radii[3] == 0.0);
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone)]
pub struct EdgeColumns {
    advancing: ContactColumns,
    receding: ContactColumns,
}

impl EdgeColumns {
    /// The contact of a scene; the outputs and the control of the scene are not used. With one work of adhesion both edges have it.
    ///
    /// # Errors
    /// A number that no double holds; a parameter out of its domain.
    pub fn new(scene: &Scene) -> crate::Result<Self> {
        scene.places.require_doubles("ask for certified digits")?;
        scene.check_profile_on_medium()?;
        let contact = scene.assembled::<f64>(())?;
        let [advancing, receding] =
            [Edge::Advancing, Edge::Receding].map(|edge| ContactColumns::assembled(scene, contact.at(edge)));
        Ok(EdgeColumns { advancing, receding })
    }

    /// The contact at the work of adhesion of one edge alone.
    pub fn at(&self, edge: Edge) -> &ContactColumns {
        match edge {
            Edge::Advancing => &self.advancing,
            Edge::Receding => &self.receding,
        }
    }

    /// This contact, with questions that end when they are stopped, as [`ContactColumns::until`].
    #[must_use]
    pub fn until(&self, stop: &Stop) -> Self {
        EdgeColumns { advancing: self.advancing.until(stop), receding: self.receding.until(stop) }
    }

    /// A state for each value, in their order; the edge may be pinned from a start at a radius.
    ///
    /// # Errors
    /// No value, or one that is not finite; no stable equilibrium at the first; a stiffness that is not positive; errors of the
    /// transform; [`Error::Stopped`].
    pub fn follow(&self, control: &Control<f64>, values: &[f64], start: &Start<f64>) -> Result<History> {
        let start = &self.receding.start(start)?;
        self.between(control, |edges, branches| {
            let path = Path::follow_edges(edges, start, values, None)?;
            let mut states = States::with_capacity(values.len());
            self.receding.arrivals(&mut states, &path, control, [0, values.len()]);
            let mut jumps = Vec::new();
            if path.events.iter().any(|event| !is_arrival(event.kind)) {
                jumps = self.events(&path, branches, control)?;
                jumps.retain(|event| !is_arrival(event.kind));
            }
            Ok(History { states, jumps })
        })
    }

    /// The events along way points, with the energy of each event, and `between` states between each two.
    ///
    /// # Errors
    /// No way point, or one that is not finite; no stable equilibrium at the first; a stiffness that is not positive; errors of
    /// the transform; [`Error::Stopped`].
    pub fn path(&self, control: &Control<f64>, way: &[f64], start: &Start<f64>, between: usize) -> Result<LoadingPath> {
        let start = &self.receding.start(start)?;
        self.between(control, |edges, [advancing, receding]| {
            let path = Path::follow_edges(edges, start, way, None)?;
            let balance = lack(EdgeEnergies::new(advancing, receding).balance(&path))?;
            let balance = balance.map_or(Some([f64::NAN; 3]), |balance| {
                balance.map(|balance| [balance.work, balance.dissipated + balance.hysteresis, balance.stored])
            });
            let events = self.events(&path, [advancing, receding], control)?;
            let curve = |grows| if grows { advancing.curve() } else { receding.curve() };
            let curve = self.receding.curve_between(curve, &events, between)?;
            Ok(LoadingPath { events, curve, balance })
        })
    }

    /// The events of a path, with what is lost in each jump and by a receding edge.
    fn events(
        &self,
        path: &Path<f64>,
        [advancing, receding]: [&SearchedBranches<f64>; 2],
        control: &Control<f64>,
    ) -> Result<Vec<Event>> {
        let energies = EdgeEnergies::new(advancing, receding);
        let mut events = self.receding.events(path, &energies.by_jumps(path), control)?;
        for (event, lost) in events.iter_mut().zip(energies.by_receding(path)) {
            event.hysteresis = match lost {
                Err(Error::Stopped) => return Err(Error::Stopped),
                lost => lost.unwrap_or(f64::NAN),
            };
            event.dissipated += event.hysteresis;
        }
        Ok(events)
    }

    /// The result of `ask` on both edges under a control, and on their branches.
    fn between<T>(
        &self,
        control: &Control<f64>,
        ask: impl FnOnce(&Edges<'_, f64, SearchedBranches<f64>>, [&SearchedBranches<f64>; 2]) -> Result<T>,
    ) -> Result<T> {
        self.advancing.branched(control, true, |advancing| {
            self.receding.branched(control, true, |receding| {
                ask(&Edges::new(receding.curve(), advancing, receding), [advancing, receding])
            })
        })
    }
}
