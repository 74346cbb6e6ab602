//! The drawing of a scene: its equilibria as polylines, its folds, and the events of its path, in f64 and SI units, for any
//! canvas.

mod sampling;

use mdr_core::contact::{self, Control, Fold};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::Medium;
use mdr_numeric::path::{self, ContactState, EventKind};

pub use mdr_core::contact::Equilibrium;
pub use mdr_numeric::folds::SearchQuality;

/// A state in the planes of the pictures: contact radius, indentation depth, force.
pub use crate::columns::State;
pub use sampling::CurveSample;

use sampling::samples;

use crate::error::Result;
use crate::outputs::path::{edges, follow};
use crate::scene::Scene;
use crate::solve;

/// The curve of equilibria between two folds.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Whether its states are stable.
    pub stable: bool,
    /// The samples, by increasing contact radius.
    pub samples: Vec<CurveSample>,
}

/// Something that happens on a path.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct DiagramEvent {
    /// The kind of event.
    pub kind: EventKind,
    /// The controlled quantity.
    pub value: f64,
    /// The state in which the event begins: a = F = 0 if detached, `None` if the surfaces touch everywhere.
    pub before: Option<State>,
    /// The state in which the event ends: a = F = 0 if detached, `None` if the surfaces touch everywhere.
    pub after: Option<State>,
}

/// The diagram (g − d, Δl) while the controlled quantity is held.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct HeldCurve {
    /// The controlled quantity.
    pub value: f64,
    /// Radius and g(a) − d, with the d that the control holds there.
    pub shifted: Vec<[f64; 2]>,
    /// The equilibria.
    pub equilibria: Vec<Equilibrium<f64>>,
}

/// All that is drawn of a scene.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The control.
    pub control: Control<f64>,
    /// E*.
    pub effective_modulus: f64,
    /// The medium, with its stiffness at a fixed contact radius.
    medium: Medium<f64>,
    /// The unit of forces: N, or per length N/m, or per area Pa.
    pub force_unit: &'static str,
    /// The unit of stiffnesses: N/m, or per length Pa, or per area Pa/m.
    pub stiffness_unit: &'static str,
    /// The branches, by increasing radius; neighbours share the point of their fold.
    pub branches: Vec<Branch>,
    /// With two works of adhesion, the branches of an advancing edge: `branches` and all else are those of a receding one.
    pub advancing: Vec<Branch>,
    /// The states in which the contact edge stays at a vertical edge: from the first state on, along a straight line.
    pub vertical_edge: Option<[State; 2]>,
    /// The folds within the range of radii.
    pub folds: Vec<State>,
    /// The curves at fixed values of the controlled quantity.
    pub held: Vec<HeldCurve>,
    /// The events of its path.
    pub path: Vec<DiagramEvent>,
    /// Whether there may be folds that were not found.
    pub completeness: SearchQuality,
}

/// At how many values of the controlled quantity the upper panel shows g − d.
const MOST_HELD: usize = 3;

impl DiagramEvent {
    /// The state before it, or after it where contact begins; none while the surfaces are apart.
    pub fn in_contact(&self) -> Option<State> {
        [self.before, self.after].into_iter().flatten().find(|state| state.contact_radius > 0.0)
    }
}

/// How many octaves from the folds equilibria are drawn.
const REACH: i64 = 40;

impl Scene {
    /// The drawing of the scene: its branches, folds, and the events of its path, in f64. The range of radii and at most three
    /// values of the controlled quantity are chosen from the path and the folds.
    ///
    /// # Errors
    /// A number of the scene out of the range of doubles; errors of the transform; a path that cannot start.
    pub fn diagram(&self) -> Result<Diagram> {
        self.shown(None)
    }

    /// The drawing of the scene for contact radii up to `radius`, in metres, and at all values: those of the instabilities on its
    /// path; without a path those of the scene, or of its folds.
    ///
    /// # Errors
    /// A number of the scene out of the range of doubles; errors of the transform; a path that cannot start.
    pub fn diagram_up_to(&self, radius: f64) -> Result<Diagram> {
        self.shown(Some(radius))
    }

    fn shown(&self, radius: Option<f64>) -> Result<Diagram> {
        self.places.require_doubles("a drawing is made in f64")?;
        if !self.has_material() {
            return Err(self
                .places
                .of("profile")
                .refuse("a drawing shows equilibria, and needs [material] in the scene"));
        }
        let values = |model: &solve::model::Model<f64>| -> Vec<f64> {
            self.values.iter().map(|literal| model.number(literal)).collect()
        };
        if self.has_two_works() {
            return solve::drawn_between(self, REACH, |model, [advancing, receding]| {
                let radius = radius.map(|radius| receding.curve().medium().size_within(&radius)).transpose()?;
                let follow = || edges::follow(model, [advancing, receding], self);
                let events = if self.path.is_empty() { Vec::new() } else { follow()?.events };
                let mut diagram = Diagram::new(receding, &events, &values(model), radius)?;
                let largest = diagram.samples().next_back().map(|sample| sample.contact_radius);
                diagram.advancing = Diagram::new(advancing, &[], &[], largest)?.branches;
                Ok(diagram.by_radius(self))
            });
        }
        solve::drawn(self, REACH, |model, branches| {
            let events = if self.path.is_empty() { Vec::new() } else { follow(model, branches, self)?.events };
            let radius = radius.map(|radius| branches.curve().medium().size_within(&radius)).transpose()?;
            Ok(Diagram::new(branches, &events, &values(model), radius)?.by_radius(self))
        })
    }
}

impl Diagram {
    /// The diagram by contact radii, where the sizes of contacts are others, and with the units of its medium. A line contact
    /// without a reference has no depths: the depth of its states is F/E*.
    fn by_radius(mut self, scene: &Scene) -> Self {
        self.force_unit = scene.medium.force_unit();
        self.stiffness_unit = scene.medium.unit_of_stiffness().symbol();
        if self.medium.period().is_none() {
            return self;
        }
        let medium = self.medium.clone();
        let shown = |radius: &mut f64| *radius = medium.contact_radius(radius);
        let branches = self.branches.iter_mut().chain(&mut self.advancing);
        branches.flat_map(|branch| &mut branch.samples).for_each(|sample| shown(&mut sample.contact_radius));
        self.folds
            .iter_mut()
            .chain(self.vertical_edge.iter_mut().flatten())
            .for_each(|state| shown(&mut state.contact_radius));
        for held in &mut self.held {
            held.shifted.iter_mut().for_each(|[radius, _]| shown(radius));
            held.equilibria.iter_mut().for_each(|state| shown(&mut state.contact_radius));
        }
        let states = self.path.iter_mut().flat_map(|event| [&mut event.before, &mut event.after]);
        states.flatten().for_each(|state| shown(&mut state.contact_radius));
        self
    }

    /// Δl at a contact radius, from that of a sample: how it grows is a matter of the medium alone.
    pub fn elongation_at(&self, contact_radius: f64) -> f64 {
        let of_unit_work = |radius: &f64| self.medium.elongation(&1.0, &self.medium.size(radius));
        let ratio = |sample: &CurveSample| of_unit_work(&contact_radius) / of_unit_work(&sample.contact_radius);
        self.samples().next_back().map_or(f64::NAN, |sample| sample.elongation * ratio(sample))
    }

    /// The points of the curve of equilibria by increasing radius; the radius of a fold comes twice, once on each branch.
    pub fn samples(&self) -> impl DoubleEndedIterator<Item = &CurveSample> {
        self.branches.iter().flat_map(|branch| &branch.samples)
    }

    /// The points of the curve on which an edge moves from one radius to another.
    pub fn samples_between(&self, from: f64, to: f64) -> impl DoubleEndedIterator<Item = &CurveSample> {
        let advances = to > from && !self.advancing.is_empty();
        let branches = if advances { &self.advancing } else { &self.branches };
        let (lower, upper) = (from.min(to), from.max(to));
        let samples = branches.iter().flat_map(|branch| &branch.samples);
        samples.filter(move |sample| sample.contact_radius > lower && sample.contact_radius < upper)
    }

    /// The states between the two ends of a jump, out of equilibrium: at each contact radius, the indentation depth and the force
    /// (1.6), 2E*(a d − ∫g), that the control leaves. `None` if the surfaces touch everywhere.
    pub fn jump(&self, event: &DiagramEvent) -> Option<Vec<State>> {
        let (from, to) = (event.before?, event.after?);
        let (lower, upper) = (from.contact_radius.min(to.contact_radius), from.contact_radius.max(to.contact_radius));
        let between = self.samples().filter(|sample| sample.contact_radius > lower && sample.contact_radius < upper);
        let mut states: Vec<State> = between.map(|sample| self.out_of_equilibrium(sample, event.value)).collect();
        if from.contact_radius > to.contact_radius {
            states.reverse();
        }
        Some([from].into_iter().chain(states).chain([to]).collect())
    }

    /// The state at the contact radius of an equilibrium, with the controlled quantity at `value`.
    fn out_of_equilibrium(&self, sample: &CurveSample, value: f64) -> State {
        let CurveSample { contact_radius, indentation: depth, force: rest, .. } = *sample;
        let slope = self.medium.stiffness(&self.medium.size(&contact_radius));
        let indentation = match &self.control {
            Control::Indentation => value,
            Control::Force => depth + (value - rest) / slope,
            Control::Machine { stiffness } => (stiffness * value - rest + slope * depth) / (slope + stiffness),
        };
        State { contact_radius, indentation, force: rest + slope * (indentation - depth) }
    }

    /// The diagram of a contact with the events of its path, if it has one, and its equilibria at some values of the controlled
    /// quantity, up to a contact radius or where it is worth a look.
    fn new(
        branches: &SearchedBranches<f64>,
        events: &[path::Event<f64>],
        values: &[f64],
        radius: Option<f64>,
    ) -> contact::Result<Self> {
        let curve = branches.curve();
        let path: Vec<_> = events.iter().map(|event| happening(event, curve)).collect();
        let values = shown_values(branches, &path, values, if radius.is_some() { usize::MAX } else { MOST_HELD });
        let mut states = Vec::new();
        for value in &values {
            states.push(branches.equilibria(value)?);
        }
        let reached = path.iter().flat_map(|event| [event.before, event.after]).flatten();
        let mut radii: Vec<f64> = reached.map(|state| state.contact_radius).filter(|radius| *radius > 0.0).collect();
        if radii.is_empty() {
            radii = states.iter().flatten().map(|state| state.contact_radius).collect();
        }
        let upper = radius.unwrap_or_else(|| upper_end(branches, radii.into_iter()));
        let lower = lower_end(branches, upper);
        let folds: Vec<_> =
            branches.folds().iter().filter(|fold| (lower..=upper).contains(&fold.contact_radius)).collect();
        let nodes: Vec<_> = folds.iter().map(|fold| fold.contact_radius).collect();
        let all = samples(curve, lower, upper, &nodes)?;
        let held = values
            .iter()
            .zip(states)
            .map(|(value, equilibria)| held(curve, &all, *value, equilibria))
            .collect::<contact::Result<_>>()?;
        Ok(Diagram {
            control: curve.control().clone(),
            effective_modulus: *curve.modulus(),
            medium: curve.medium().clone(),
            force_unit: "N",
            stiffness_unit: "N/m",
            branches: cut(branches, &nodes, &all),
            advancing: Vec::new(),
            vertical_edge: vertical_edge(curve, upper)?,
            folds: folds.into_iter().filter(|fold| fold.indentation.is_finite()).map(at_fold).collect(),
            held,
            path,
            completeness: branches.completeness(),
        })
    }
}

/// The values of the upper panel: at the beginning of the path and at the instabilities it passes; else the requested values;
/// else the values of the folds.
fn shown_values(branches: &SearchedBranches<f64>, path: &[DiagramEvent], asked: &[f64], most: usize) -> Vec<f64> {
    let turns = |event: &&DiagramEvent| match event.kind {
        EventKind::JumpIn | EventKind::Jump | EventKind::Detached | EventKind::CompleteContact => true,
        EventKind::Start => event.in_contact().is_some(),
        _ => false,
    };
    let mut values: Vec<f64> = path.iter().filter(turns).map(|event| event.value).collect();
    if values.is_empty() {
        values = asked.to_vec();
    }
    if values.is_empty() {
        let value = |fold: &Fold<f64>| branches.control().controlled(&fold.indentation, &fold.force);
        values = branches.folds().iter().map(value).filter(|value| value.is_finite()).collect();
    }
    let mut shown: Vec<f64> = Vec::new();
    for value in values {
        if shown.len() < most && !shown.contains(&value) {
            shown.push(value);
        }
    }
    shown
}

/// The largest radius to show: all that are reached are below, or else the folds.
fn upper_end(branches: &SearchedBranches<f64>, reached: impl Iterator<Item = f64>) -> f64 {
    const ROOM: f64 = 1.25;
    let curve = branches.curve();
    let largest = reached.fold(0.0, f64::max);
    let folds = || branches.folds().iter().map(|fold| fold.contact_radius);
    let largest = if largest > 0.0 { largest } else { folds().fold(0.0, f64::max) };
    let outer = curve.transform().outer_radius();
    let largest = match (largest > 0.0, outer) {
        (true, _) => largest,
        (false, Some(outer)) => outer / 2.0,
        (false, None) => curve.material_length(),
    };
    // At a vertical edge the profile itself ends.
    let equator =
        outer.map_or(f64::INFINITY, |outer| if curve.vertical_edge().is_some() { outer } else { 0.999 * outer });
    (ROOM * largest).min(equator)
}

/// The smallest radius to show, below all folds.
fn lower_end(branches: &SearchedBranches<f64>, upper: f64) -> f64 {
    let folds = branches.folds().iter().map(|fold| fold.contact_radius);
    // A fold at a radius that is too small to be seen on a linear axis makes the axis logarithmic.
    let smallest = folds.filter(|fold| *fold < upper).fold(upper, f64::min);
    if smallest < upper / DECADES { smallest / 10.0 } else { 1e-6 * upper }
}

/// The ratio of radii from which on an axis is logarithmic.
pub const DECADES: f64 = 300.0;

fn held(
    curve: &Contact<f64>,
    samples: &[CurveSample],
    value: f64,
    equilibria: Vec<Equilibrium<f64>>,
) -> contact::Result<HeldCurve> {
    // The direction of change is g − Δl − d(held).
    let at = |sample: &CurveSample| {
        Ok([sample.contact_radius, curve.direction(&sample.contact_radius, &value)? + sample.elongation])
    };
    Ok(HeldCurve { value, shifted: samples.iter().map(at).collect::<contact::Result<_>>()?, equilibria })
}

/// The samples cut at the folds.
fn cut(branches: &SearchedBranches<f64>, nodes: &[f64], all: &[CurveSample]) -> Vec<Branch> {
    let skipped =
        branches.folds().iter().filter(|fold| nodes.first().is_none_or(|first| fold.contact_radius < *first)).count();
    let mut parts: Vec<Branch> = Vec::new();
    let mut rest = all;
    for (index, node) in nodes.iter().map(Some).chain([None]).enumerate() {
        let end = node.map_or(rest.len(), |node| rest.partition_point(|sample| sample.contact_radius <= *node));
        let stable = branches.is_stable(skipped * usize::from(!nodes.is_empty()) + index);
        parts.push(Branch {
            stable: stable.unwrap_or_else(|| rising(branches.curve(), rest)),
            samples: rest[..end].to_vec(),
        });
        rest = &rest[end.saturating_sub(1)..];
    }
    parts.retain(|branch| branch.samples.len() > 1);
    parts
}

/// Whether a curve without folds is stable.
fn rising(curve: &Contact<f64>, samples: &[CurveSample]) -> bool {
    let middle = samples[samples.len() / 2].contact_radius;
    matches!((curve.tangency(&middle), curve.critical_ratio(&middle)), (Ok(ratio), Ok(threshold)) if ratio > threshold)
}

/// The states at a vertical edge: the radius stays and the force is 2E*b times the indentation that is added.
fn vertical_edge(curve: &Contact<f64>, upper: f64) -> contact::Result<Option<[State; 2]>> {
    let Some(radius) = curve.vertical_edge().filter(|radius| *radius <= upper) else { return Ok(None) };
    let (indentation, force) = curve.state(&radius)?;
    let added = 2.0 * curve.detachment_elongation(&radius)? + indentation.abs();
    let first = State { contact_radius: radius, indentation, force };
    let force = force + curve.stiffness(&radius) * added;
    Ok(Some([first, State { contact_radius: radius, indentation: indentation + added, force }]))
}

fn at_fold(fold: &Fold<f64>) -> State {
    State { contact_radius: fold.contact_radius, indentation: fold.indentation, force: fold.force }
}

fn happening(event: &path::Event<f64>, curve: &Contact<f64>) -> DiagramEvent {
    let numbers = |state: &ContactState<f64>| match state {
        ContactState::Contact(rest) => {
            Some(State { contact_radius: rest.contact_radius, indentation: rest.indentation, force: rest.force })
        }
        // Apart, nothing but the control itself is known: the force it applies, or where it holds the body.
        ContactState::Detached if *curve.control() == Control::Force => {
            Some(State { contact_radius: 0.0, indentation: f64::NAN, force: event.value })
        }
        ContactState::Detached => Some(State { contact_radius: 0.0, indentation: event.value, force: 0.0 }),
        ContactState::Complete => None,
    };
    DiagramEvent { kind: event.kind, value: event.value, before: numbers(&event.before), after: numbers(&event.after) }
}
