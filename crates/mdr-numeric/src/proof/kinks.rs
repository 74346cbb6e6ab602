//! Kinks of g, the vertical edge, and the intervals around them between the cells on either side.

use std::cmp::Ordering;

use mdr_core::contact::{Fold, FoldKind, Kink, Result, Transform};
use mdr_core::number::{Ends, Interval, Real};
use rug::Float;
use rug::float::Special;

use super::condition::signs;
use super::{EnclosedCurve, ProvedCell, ProvedFolds, Trend};
use crate::contact::Contact;

/// Relative distances 2^−k from a kink at which the range may be cut, in the order in which they are tried.
pub(super) const MARGINS: [u32; 4] = [6, 12, 24, FINEST];
/// The smallest of them. Kinks that are closer than twice that distance are left undecided.
pub(super) const FINEST: u32 = 40;

/// An interval around a kink or a vertical edge, with the proved sign of the fold condition on each side.
pub(super) struct Gap {
    pub(super) before: Float,
    pub(super) after: Float,
    radius: Interval,
    known: Option<Known>,
}

/// What is known beside the kink with an index, to a relative distance on both sides.
struct Known {
    index: usize,
    margin: u32,
    /// The sign of the condition below and above; above is `None` at a vertical edge.
    signs: (Ordering, Option<Ordering>),
}

/// The kinks, followed by the vertical edge if there is one.
struct Radii {
    all: Vec<Interval>,
    /// The number of kinks, which is the index of the vertical edge.
    kinks: usize,
}

impl Radii {
    fn is_vertical_edge(&self, index: usize) -> bool {
        index == self.kinks
    }
}

impl EnclosedCurve {
    /// The intervals around all kinks in (lower, upper), and around the vertical edge if it is there.
    pub(super) fn gaps(&self, lower: &Float, upper: &Float) -> Result<Vec<Gap>> {
        let radii = self.radii();
        let mut gaps: Vec<Gap> = Vec::new();
        for (index, kink) in radii.all.iter().enumerate() {
            let repeated = gaps.last().is_some_and(|gap| gap.radius == *kink);
            let from = gaps.last().map_or(lower, |gap| &gap.after);
            let next = radii.all[index + 1..].iter().find(|next| *next != kink).map(Interval::lower);
            let to = next.filter(|next| *next < upper).unwrap_or(upper);
            if !repeated && let Some(gap) = self.neighbourhood(&radii, index, from, to)? {
                gaps.push(gap);
            }
        }
        Ok(gaps)
    }

    /// The ends of a range, each moved beyond the kink that is there: g' has no value at it, and a fold may be there.
    pub(super) fn beyond_kinks(&self, lower: &Float, upper: &Float) -> (Float, Float) {
        let (mut from, mut to) = (lower.clone(), upper.clone());
        for kink in self.plain.transform().kinks() {
            let [before, after] = [shifted(kink.lower(), -1, FINEST), shifted(kink.upper(), 1, FINEST)];
            let holds = |end: &Float| before <= *end && *end <= after;
            if holds(lower) {
                from = shifted(kink.lower(), -1, FINEST - 1);
            }
            if holds(upper) {
                to = shifted(kink.upper(), 1, FINEST - 1);
            }
        }
        (from, to)
    }

    fn radii(&self) -> Radii {
        let mut all = self.plain.transform().kinks();
        let kinks = all.len();
        all.extend(self.plain.vertical_edge());
        Radii { all, kinks }
    }

    /// The widest neighbourhood within (from, to) on which both signs are certain, or else the narrowest. `None` if the
    /// kink itself is not there.
    fn neighbourhood(&self, radii: &Radii, index: usize, from: &Float, to: &Float) -> Result<Option<Gap>> {
        let (kink, is_edge) = (&radii.all[index], radii.is_vertical_edge(index));
        let mut narrowest = None;
        for margin in MARGINS {
            let before = shifted(kink.lower(), -1, margin);
            let after = if is_edge { kink.upper().clone() } else { shifted(kink.upper(), 1, margin) };
            let reached = if is_edge { before < *to } else { after < *to };
            if !(before > *from && reached) {
                continue;
            }
            let known = self.known(radii, index, margin)?;
            let decided = known.is_some();
            narrowest = Some(Gap { before, after, radius: kink.clone(), known });
            if decided {
                break;
            }
        }
        Ok(narrowest)
    }

    /// What is known beside a kink, if the signs of the condition on both sides of it are certain: in doubles, if they tell enough.
    fn known(&self, radii: &Radii, index: usize, margin: u32) -> Result<Option<Known>> {
        let radius = &radii.all[index];
        let around = radius.clone().inflate(&(share(radius, margin) * radius));
        let known = |[below, above]: [Option<Ordering>; 2]| {
            let above = if radii.is_vertical_edge(index) { None } else { Some(above?) };
            Some(Known { index, margin, signs: (below?, above) })
        };
        let in_doubles = self.ask_doubles(|doubles| doubles.signs_beside_kink(index, &around, margin))?;
        if let Some(decided) = in_doubles.and_then(known) {
            return Ok(Some(decided));
        }
        let Some(kink) = self.kink(index, margin)? else { return Ok(None) };
        let [below, above] = signs(&self.plain, &around, &kink);
        Ok(known([below, above.or_else(|| self.rises_beyond_flat(&kink))]))
    }

    fn kink(&self, index: usize, margin: u32) -> Result<Option<Kink<Interval>>> {
        self.plain.transform().kink(index, &share(self.plain.modulus(), margin))
    }

    /// g and its mean at a kink beside which something is known.
    fn value_at(&self, known: &Known) -> Result<Option<(Interval, Interval)>> {
        Ok(self.kink(known.index, known.margin)?.and_then(|kink| kink.value))
    }

    /// Where folds are at g' = 0, contact is held beyond the end of a flat wherever g does not fall, also where g' begins with 0.
    fn rises_beyond_flat(&self, kink: &Kink<Interval>) -> Option<Ordering> {
        let flat = kink.inside.greatest.as_ref().is_some_and(|greatest| *greatest == greatest.lit(0));
        let rises = flat && self.folds_where_level() && self.plain.transform().rises();
        rises.then_some(Ordering::Greater)
    }

    /// Records the result for an interval: a fold at the kink, a pole, nothing, or an undecided part.
    pub(super) fn gap(&self, gap: Gap, found: &mut ProvedFolds) -> Result<()> {
        let Some(known) = &gap.known else {
            found.undecided.push((gap.before, gap.after));
            return Ok(());
        };
        found.cells.push(known.cell(&gap.before, &gap.after));
        let Some(kind) = known.fold() else { return Ok(()) };
        match self.value_at(known)? {
            Some((g, mean)) => found.folds.push(self.state_at_kink(&gap.radius, &g, &mean, kind)),
            None => found.poles.push(pole(Interval::new(gap.before, gap.after), kind)),
        }
        Ok(())
    }

    /// The state of the fold in this precision, if it is at a kink or at the vertical edge.
    pub(super) fn fold_at_kink(&self, fold: &Fold<Interval>) -> Result<Option<Fold<Interval>>> {
        let radii = self.radii();
        for (index, radius) in radii.all.iter().enumerate() {
            if !radius.overlaps(&fold.contact_radius) {
                continue;
            }
            for margin in MARGINS {
                let Some(known) = self.known(&radii, index, margin)? else { continue };
                if let Some(kind) = known.fold()
                    && let Some((g, mean)) = self.value_at(&known)?
                {
                    return Ok(Some(self.state_at_kink(radius, &g, &mean, kind)));
                }
            }
        }
        Ok(None)
    }

    /// The state at a kink, from g and its mean there.
    pub(super) fn state_at_kink(&self, a: &Interval, g: &Interval, mean: &Interval, kind: FoldKind) -> Fold<Interval> {
        let indentation = g.clone() - self.plain.elongation(a);
        let force = self.plain.stiffness(a) * (indentation.clone() - mean);
        Fold { contact_radius: a.clone(), indentation, force, kind }
    }
}

/// A kink or a vertical edge that cannot be told apart from a radius, with g and its mean there, which the transform has at numbers
/// beside it only.
pub(super) fn at_edge(contact: &Contact<Interval>, a: &Interval) -> Result<Option<[Interval; 3]>> {
    let edges = contact.transform().kinks().into_iter().chain(contact.vertical_edge()).enumerate();
    for (index, edge) in edges.filter(|(_, edge)| edge.overlaps(a)) {
        let margin = edge.lit(2).powi(-i64::from(FINEST));
        if let Some((g, mean)) = contact.transform().kink(index, &margin)?.and_then(|kink| kink.value) {
            return Ok(Some([edge, g, mean]));
        }
    }
    Ok(None)
}

impl Known {
    /// The interval around the kink; it ends at a vertical edge, where the controlled quantity increases at last.
    fn cell(&self, from: &Float, to: &Float) -> ProvedCell {
        let (below, above) = self.signs;
        ProvedCell {
            from: from.clone(),
            to: to.clone(),
            trend: Trend::between(below, above.unwrap_or(Ordering::Greater)),
        }
    }

    /// Whether the controlled quantity has an extremum there. At a vertical edge the contact has a branch of its own,
    /// on which the controlled quantity increases.
    fn fold(&self) -> Option<FoldKind> {
        match self.signs {
            (Ordering::Less, Some(Ordering::Greater) | None) => Some(FoldKind::Minimum),
            (Ordering::Greater, Some(Ordering::Less)) => Some(FoldKind::Maximum),
            _ => None,
        }
    }
}

/// A fold with infinite indentation and force, somewhere in an enclosure of radii.
fn pole(radius: Interval, kind: FoldKind) -> Fold<Interval> {
    let bits = radius.precision();
    let mut largest = Float::with_val(bits, Special::Infinity);
    largest.next_down();
    let infinite = Interval::new(largest, Float::with_val(bits, Special::Infinity));
    let value = if kind == FoldKind::Maximum { infinite } else { -infinite };
    Fold { contact_radius: radius, indentation: value.clone(), force: value, kind }
}

/// 2^−margin.
pub(super) fn share<R: Real>(like: &R, margin: u32) -> R {
    like.lit(2).powi(-i64::from(margin))
}

/// radius·(1 ± 2^−margin).
pub(super) fn shifted(radius: &Float, direction: i32, margin: u32) -> Float {
    let step = Float::with_val(radius.prec(), radius >> margin) * direction;
    Float::with_val(radius.prec().max(margin + FINEST), radius + step)
}

/// The least and the greatest g on a cell that holds one kink, from g there and the slopes on both sides.
pub(super) fn beside<I: Ends>(
    transform: &dyn Transform<I>,
    index: usize,
    kink: &I,
    cell: &I,
) -> Option<[Option<I>; 2]> {
    let [before, after] = cell.ends().map(|end| (end - kink).abs());
    let [_, margin] = (before.greater(&after) / kink).ends();
    let Kink { value, inside, outside } = transform.kink(index, &margin).ok()??;
    let (g, _) = value?;
    let zero = g.lit(0);
    let least = inside.greatest.zip(outside.least).map(|(inside, outside)| {
        let inside = g.clone() - inside.greater(&zero) * &before;
        inside.lesser(&(g.clone() + outside.lesser(&zero) * &after))
    });
    let greatest = inside.least.zip(outside.greatest).map(|(inside, outside)| {
        let inside = g.clone() - inside.lesser(&zero) * &before;
        inside.greater(&(g.clone() + outside.greater(&zero) * &after))
    });
    Some([least, greatest])
}
