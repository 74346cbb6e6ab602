//! The curve of a leg: of one work of adhesion, or of an edge that advances, recedes, or is pinned.
//!
//! With w₁ ≤ w₂ an edge that has advanced to the radius a where the record turns stays there, while the depth falls from g(a) − Δl₁(a) to
//! g(a) − Δl₂(a): force is linear in depth, with the slope 2E*a. Then it recedes on the curve of w₂, or breaks where that is not stable.

use mdr_core::contact::{Edge, Result};

use super::arcs::{self, Arc};
use super::contact::{Contact, Numbers, Tip};
use super::foot::Foot;
use super::observation::Observation;
use super::problem::Kind;

/// The arcs of a leg, with the numbers that it has.
pub(super) struct Sheet {
    /// With the work of adhesion of the leg.
    pub(super) numbers: Numbers<f64>,
    /// Where each direction has its own.
    pub(super) direction: Option<Edge>,
    pub(super) pin: Option<Pin>,
    /// The innermost first.
    pub(super) arcs: Vec<Arc>,
}

/// Where the edge of the contact is pinned when a record turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pin {
    pub(super) radius: f64,
    /// X, without drift, where the edge stopped, with its time.
    pub(super) turn: [f64; 2],
    /// Whether the record turns before the contact has come to a fold of the curve of w₁, where it is then pinned.
    pub(super) is_at_end: bool,
}

impl Sheet {
    pub(super) fn contact<'t>(&self, tip: &'t Tip<f64>, observation: Observation) -> Contact<'t, f64> {
        let mut contact = Contact::new(tip, self.numbers.clone(), observation);
        contact.direction = self.direction;
        if let Some(pin) = self.pin {
            (contact.edge, contact.pinned) = (Some(pin.radius), Some(Vec::new()));
        }
        contact
    }

    /// The arc of a level.
    pub(super) fn arc(&self, level: u32) -> Option<&Arc> {
        arc(&self.arcs, level)
    }

    /// Whether the edge is pinned at a foot.
    pub(super) fn is_pinned(&self, foot: &Foot) -> bool {
        self.pin.is_some_and(|pin| foot.s > pin.radius || (foot.is_end && foot.s == pin.radius))
    }

    /// The parameter of the fold where the contact breaks: of the inner ends of arcs, that with the smallest X.
    pub(super) fn last_fold(&self) -> Option<f64> {
        let ends = self.arcs.iter().filter_map(Arc::inner_fold);
        ends.min_by(|one, other| one.at[0].total_cmp(&other.at[0])).map(|end| end.s)
    }
}

/// The arc of a level; none of level 0, where there is no contact.
pub(super) fn arc(arcs: &[Arc], level: u32) -> Option<&Arc> {
    arcs.get(level.checked_sub(1)? as usize)
}

/// The radius at which an edge that advances is where the record turns.
///
/// # Errors
/// Errors of the transform.
pub(super) fn pinned(
    advancing: &Contact<'_, f64>,
    arcs: &[Arc],
    level: Option<u32>,
    turn: [f64; 2],
) -> Result<Option<Pin>> {
    let Some(arc) = level.and_then(|level| arc(arcs, level)).or(arcs.last()) else { return Ok(None) };
    let [lower, upper] = arc.ends();
    let is_at_end = !(turn[0] > lower.at[0]);
    let radius = match turn[0] {
        x if x <= lower.at[0] => lower.s,
        x if x >= upper.at[0] => upper.s,
        x => arc.parameter(advancing, x)?,
    };
    // A vertical edge of the tip is where the contact stays anyhow.
    let is_inside = advancing.edge.is_none_or(|edge| radius < edge);
    Ok(is_inside.then_some(Pin { radius, turn, is_at_end }))
}

/// How the radius of a pinned edge moves with each number: X of the advancing edge stays where the record turns.
///
/// # Errors
/// Errors of the transform.
pub(super) fn speeds(advancing: &Contact<'_, f64>, pin: &Pin, kinds: &[Kind]) -> Result<Vec<(Kind, f64)>> {
    let point = advancing.point(&pin.radius)?;
    let speed = |kind: &Kind| -> Result<(Kind, f64)> {
        let speed = if pin.is_at_end {
            arcs::end_speed(advancing, *kind, &point)?
        } else {
            let drift = if *kind == Kind::PositionDrift { pin.turn[1] } else { 0.0 };
            -(advancing.partial(*kind, &point)?[0] + drift) / point.tangent[0]
        };
        Ok((*kind, speed))
    };
    kinds.iter().map(speed).collect()
}
