//! The stable arcs of an observed curve between the folds of X.

use mdr_core::contact::{Control, FoldKind, Result};
use mdr_numeric::folds;

use super::contact::{Contact, Point};
use super::foot::Foot;
use super::observation::Observation;
use super::problem::Kind;

/// How many points an arc is drawn with; a search begins with so many, or with more between them.
const SAMPLES: usize = 48;

/// The smallest radius of these points after the first, against the largest.
const NARROWEST: f64 = 1e-9;

/// A part of the curve along which X grows with the contact radius.
#[derive(Debug)]
pub(super) struct Arc {
    /// Whether the lower and the upper end are folds, where the arc ends.
    folds: [bool; 2],
    /// Points from the lower to the upper end, or until X is beyond all rows.
    pub(super) samples: Vec<Sample>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) s: f64,
    pub(super) at: [f64; 2],
    pub(super) tangent: [f64; 2],
}

/// Where a curve turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) s: f64,
    pub(super) kind: FoldKind,
    /// Whether it is a fold with a state, not a pole of g.
    is_fold: bool,
}

/// The folds of X(a), by increasing radius.
///
/// # Errors
/// A material out of its domain; errors of the transform at a fold. See [`folds::find`].
pub(super) fn turns(contact: &Contact<'_, f64>) -> Result<Vec<Turn>> {
    let control = match (contact.observation, contact.numbers.stiffness) {
        (Observation::ForceOfRadius, _) => return Ok(Vec::new()),
        (Observation::ForceOfIndentation, _) => Control::Indentation,
        (Observation::IndentationOfForce | Observation::RadiusOfForce, _) => Control::Force,
        (_, Some(stiffness)) => Control::Machine { stiffness },
        (_, None) => Control::Indentation,
    };
    let found = folds::find(&contact.tip.on([contact.numbers.e_star, contact.numbers.work], control)?)?;
    let turn = |is_fold: bool| {
        move |fold: &mdr_core::contact::Fold<f64>| Turn { s: fold.contact_radius, kind: fold.kind, is_fold }
    };
    let mut turns: Vec<Turn> = found.folds.iter().map(turn(true)).chain(found.poles.iter().map(turn(false))).collect();
    turns.sort_by(|one, other| one.s.total_cmp(&other.s));
    Ok(turns)
}

/// Follows folds to nearby numbers of the problem; none when one of them cannot be followed.
pub(super) fn followed(contact: &Contact<'_, f64>, turns: &[Turn]) -> Option<Vec<Turn>> {
    let follow = |turn: &Turn| {
        if !turn.is_fold || contact.tip.transform.kinks().contains(&turn.s) || contact.edge == Some(turn.s) {
            return None;
        }
        let mut s = turn.s;
        for _ in 0..30 {
            let point = contact.point(&s).ok()?;
            let step = point.tangent[0] / contact.curvature(&point).ok()?[0];
            let next = s - step;
            if !(next > 0.5 * turn.s && next < 2.0 * turn.s) {
                return None;
            }
            let done = step.abs() <= 1e-14 * s;
            s = next;
            if done || (step.abs() <= 1e-9 * s) {
                let [curvature, _] = contact.curvature(&contact.point(&s).ok()?).ok()?;
                return ((curvature > 0.0) == (turn.kind == FoldKind::Minimum)).then_some(Turn { s, ..*turn });
            }
        }
        None
    };
    let followed: Vec<Turn> = turns.iter().map(follow).collect::<Option<_>>()?;
    followed.windows(2).all(|pair| pair[0].s < pair[1].s).then_some(followed)
}

/// The arcs that reach into the range of X, the innermost first, with `fineness` segments from one point that is drawn to the next.
///
/// # Errors
/// Errors of the transform.
pub(super) fn arcs(contact: &Contact<'_, f64>, turns: &[Turn], x: [f64; 2], fineness: usize) -> Result<Vec<Arc>> {
    let mut arcs: Vec<Arc> = Vec::new();
    let mut lower: Option<&Turn> = None;
    let rises_first = match turns.first() {
        Some(turn) => turn.kind == FoldKind::Maximum,
        None => contact.point(&scale(contact))?.tangent[0] > 0.0,
    };
    let mut open = rises_first;
    for turn in turns {
        match turn.kind {
            FoldKind::Minimum => (lower, open) = (Some(turn), true),
            FoldKind::Maximum if open => {
                arcs.push(Arc::sampled(contact, [lower, Some(turn)], x, fineness)?);
                (lower, open) = (None, false);
            }
            FoldKind::Maximum => {}
        }
        // Arcs further out begin beyond all rows.
        if arcs.len() > 1 && arcs[arcs.len() - 1].samples[0].at[0] > x[1] {
            arcs.pop();
            return Ok(arcs);
        }
    }
    if open {
        arcs.push(Arc::sampled(contact, [lower, None], x, fineness)?);
    }
    if arcs.len() > 1 && arcs[arcs.len() - 1].samples[0].at[0] > x[1] {
        arcs.pop();
    }
    Ok(arcs)
}

/// The turns of a contact whose edge is pinned: those inside, and the edge itself where the contact is set free on a branch that falls.
///
/// # Errors
/// Errors of the transform.
pub(super) fn up_to_edge(contact: &Contact<'_, f64>, turns: &[Turn]) -> Result<Vec<Turn>> {
    let Some(edge) = contact.edge.filter(|_| contact.pinned.is_some()) else { return Ok(turns.to_vec()) };
    let mut inside: Vec<Turn> = turns.iter().copied().filter(|turn| turn.s < edge).collect();
    if contact.point(&edge)?.tangent[0] <= 0.0 {
        inside.push(Turn { s: edge, kind: FoldKind::Minimum, is_fold: true });
    }
    Ok(inside)
}

/// A length of the contact: where Δl is a as a sphere of that radius would have it.
fn scale(contact: &Contact<'_, f64>) -> f64 {
    let length = contact.tip.length_of_work(contact.numbers.work / contact.numbers.e_star);
    let length = contact.edge.map_or(length, |edge| (0.5 * edge).min(length));
    contact.tip.transform.outer_radius().map_or(length, |outer| (0.5 * outer).min(length))
}

impl Arc {
    fn sampled(
        contact: &Contact<'_, f64>,
        [lower, upper]: [Option<&Turn>; 2],
        x: [f64; 2],
        fineness: usize,
    ) -> Result<Arc> {
        // A pole and the end of a profile have no value.
        let inner = |turn: &Turn| if turn.is_fold { turn.s } else { turn.s * (1.0 + 1e-12) };
        let outer = |turn: &Turn| if turn.is_fold { turn.s } else { turn.s * (1.0 - 1e-12) };
        let end =
            contact.tip.transform.outer_radius().filter(|_| contact.edge.is_none()).map(|end| end * (1.0 - 1e-12));
        let last = match (upper.map(outer), end) {
            (Some(upper), Some(end)) => Some(upper.min(end)),
            (upper, end) => upper.or(end),
        };
        let first = match lower {
            Some(turn) => inner(turn),
            None => smallest(contact, last, x),
        };
        let last = grown(contact, first, last, x[1])?;
        let folds = [lower.is_some_and(|turn| turn.is_fold), upper.is_some_and(|turn| turn.is_fold && last == turn.s)];
        // Of a fold that is as good as the tip, with next to no adhesion, the rest of the arc is sampled.
        let from = first.max(NARROWEST * last);
        let segments = fineness * (SAMPLES - 1);
        let ratio = (last / from).ln() / segments as f64;
        let sample = |index: usize| {
            let s = match index {
                0 => first,
                index if index == segments => last,
                index => from * (ratio * index as f64).exp(),
            };
            let Point { at, mut tangent, .. } = contact.point(&s)?;
            if index == 0 && tangent[0] < 0.0 {
                tangent = contact.point(&(s * (1.0 + 1e-9)))?.tangent;
            }
            Ok(Sample { s, at, tangent })
        };
        Ok(Arc { folds, samples: (0..=segments).map(sample).collect::<Result<_>>()? })
    }

    pub(super) fn ends(&self) -> [&Sample; 2] {
        [&self.samples[0], &self.samples[self.samples.len() - 1]]
    }

    /// The points that are drawn.
    pub(super) fn drawn(&self) -> impl Iterator<Item = &Sample> {
        self.samples.iter().step_by((self.samples.len() - 1) / (SAMPLES - 1))
    }

    /// Its inner end, where it is a fold.
    pub(super) fn inner_fold(&self) -> Option<&Sample> {
        self.folds[0].then(|| &self.samples[0])
    }

    /// How the place of the foot moves with a number of the problem: at a fixed parameter, and with the end where it is one.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn partial(
        &self,
        contact: &Contact<'_, f64>,
        kind: Kind,
        foot: &Foot,
        point: &Point<f64>,
    ) -> Result<[f64; 2]> {
        let mut partial = contact.partial(kind, point)?;
        if foot.is_end && self.is_fold(foot.s) {
            let speed = end_speed(contact, kind, point)?;
            partial[0] += point.tangent[0] * speed;
            partial[1] += point.tangent[1] * speed;
        }
        Ok(partial)
    }

    /// Whether a parameter is that of an end which is a fold.
    pub(super) fn is_fold(&self, s: f64) -> bool {
        let [lower, upper] = self.ends();
        (self.folds[0] && lower.s == s) || (self.folds[1] && upper.s == s)
    }
}

/// How fast a fold moves along the curve with a number of the problem: −∂X'/X''; or with a kink or a vertical edge that it is at.
///
/// # Errors
/// Errors of the transform.
pub(super) fn end_speed(contact: &Contact<'_, f64>, kind: Kind, point: &Point<f64>) -> Result<f64> {
    if contact.edge == Some(point.a) {
        // At the edge the partial derivatives are at a fixed contact radius; the edge moves with the number that is its radius.
        let moved = contact.edge_partial(kind);
        return Ok(moved);
    }
    let kinks = contact.tip.transform.kinks();
    if kinks.contains(&point.a) {
        return Ok(contact.kink_partial(kind, &point.a));
    }
    Ok(-contact.x_slope_partial(kind, point)? / contact.curvature(point)?[0])
}

/// A radius below all rows, for an arc that begins at the tip.
fn smallest(contact: &Contact<'_, f64>, last: Option<f64>, x: [f64; 2]) -> f64 {
    let mut s = last.unwrap_or_else(|| scale(contact));
    if contact.observation == Observation::ForceOfRadius {
        return 0.5 * x[0].max(1e-6 * x[1]);
    }
    for _ in 0..60 {
        s *= 0.5;
        if contact.point(&s).is_ok_and(|point| point.at[0] <= x[0]) {
            break;
        }
    }
    s
}

/// The radius at which X is beyond all rows, or the end of the arc.
fn grown(contact: &Contact<'_, f64>, first: f64, last: Option<f64>, x: f64) -> Result<f64> {
    let (mut s, mut step) = (first, 0.02);
    loop {
        let next = s * (1.0 + step);
        match last {
            Some(last) if next >= last => return Ok(last),
            _ => s = next,
        }
        if contact.point(&s)?.at[0] > x || s > 1e40 * first.max(x.abs()) {
            return Ok(s);
        }
        step *= 1.5;
    }
}
