//! Equilibria at a given value of the controlled quantity.
//!
//! Between two folds the controlled quantity is monotone along the curve of equilibria, so each branch contains at most
//! one equilibrium. Its stability follows from the direction of change, (1.8) and (1.9), on both sides.

mod ends;

use std::cmp::Ordering;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Control, Equilibrium, Error, Fold, FoldKind, Material, Result, Stability, Transform};
use mdr_core::number::{Real, order};

use crate::admissible::{self, Admissibility, Ring, Touch};
use crate::branch::{End, EquilibriumBranches, FirstContact, Towards, end, onset, unordered};
use crate::contact::Contact;
use crate::folds::{self, Folds, SearchQuality};
use crate::{equator, survey};
use ends::is_pole;

/// The branches of a contact under one control: the curve of equilibria cut at its folds.
pub struct SearchedBranches<R: Real> {
    curve: Contact<R>,
    /// Includes poles.
    folds: Vec<Fold<R>>,
    completeness: SearchQuality,
    /// The radii of the search, if it is limited.
    reach: Option<[R; 2]>,
    /// The outer radius where g diverges: a growing contact comes to equilibrium before it.
    equator: Option<R>,
    admissibility: OnceLock<Arc<Admissibility>>,
}

/// All equilibria at `value` of the controlled quantity (d, F, or D = d + F/k), by increasing radius; the list may be
/// empty. At a fold the double root is one equilibrium, [`Neutral`](Stability::Neutral).
///
/// Accuracy: the residual is at the rounding level of g and Δl; the error of the radius is that times its condition,
/// which near a fold at relative distance ε grows as 1/√ε: half the digits are lost at ε = u.
///
/// ```
/// use mdr_core::contact::{Control, Material, Shape, Stability};
/// use mdr_numeric::{equilibrium::equilibria, transform::Quadrature};
/// use std::sync::Arc;
/// let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?);
/// let glue = Material::new(1.0, 1e-3)?;
/// let pulled = equilibria(&ball, &glue, &Control::Indentation, &-0.01)?;
/// assert_eq!(pulled.len(), 2);
/// assert_eq!(pulled[1].stability, Stability::Stable);
/// assert!(equilibria(&ball, &glue, &Control::Indentation, &-1.0)?.is_empty());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Errors of the transform; [`OutOfRange`](Error::OutOfRange) if a force is not representable in this arithmetic.
pub fn equilibria<R, T>(
    transform: &Arc<T>,
    material: &Material<R>,
    control: &Control<R>,
    value: &R,
) -> Result<Equilibria<R>>
where
    R: Real,
    T: Transform<R> + ?Sized + 'static,
{
    SearchedBranches::new(Contact::half_space(transform, material, control))?.search(value)
}

/// The equilibria at one value, and the quality of the search.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibria<R> {
    /// The equilibria, by increasing radius.
    pub equilibria: Vec<Equilibrium<R>>,
    /// [`Doubtful`](SearchQuality::Doubtful) if there may be more: on branches between folds that were not found, or at
    /// radii outside the searched range.
    pub completeness: SearchQuality,
}

/// The equilibria that were found.
impl<R> Deref for Equilibria<R> {
    type Target = [Equilibrium<R>];

    fn deref(&self) -> &[Equilibrium<R>] {
        &self.equilibria
    }
}

impl<R: Real> SearchedBranches<R> {
    /// Finds the folds of the curve. Call it once for many values.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Domain`] unless the stiffness of a machine is positive and finite; [`Error::Undecided`]
    /// at a threshold of n = 1/2; [`Error::OutOfRange`] if the force of a fold is not representable. See [`folds::folds`].
    pub fn new(curve: Contact<R>) -> Result<Self> {
        let folds = folds::find(&curve)?;
        match folds.out_of_range.first() {
            Some(fold) => Err(fold.error.clone()),
            None => Ok(Self::cut_at(curve, folds)),
        }
    }

    /// The curve cut at given folds: all folds of the same contact under the same control, each with a state.
    pub fn cut_at(curve: Contact<R>, folds: Folds<R>) -> Self {
        let Folds { mut folds, poles, completeness, .. } = folds;
        folds.extend(poles);
        folds.sort_by(|one, other| order(&one.contact_radius, &other.contact_radius));
        let equator = curve.equator().unwrap_or_default();
        SearchedBranches { curve, folds, completeness, reach: None, equator, admissibility: OnceLock::new() }
    }

    /// Sets the admissibility, which is otherwise searched when needed.
    pub fn with_admissibility(self, admissibility: Arc<Admissibility>) -> Self {
        SearchedBranches { admissibility: OnceLock::from(admissibility), ..self }
    }

    /// Restricts the search to these radii; by default it covers those searched for folds, up to 10^±455000 times w/E*.
    pub fn within(self, lower: R, upper: R) -> Self {
        SearchedBranches { reach: Some([lower, upper]), ..self }
    }

    /// The curve.
    pub fn curve(&self) -> &Contact<R> {
        &self.curve
    }

    /// Whether there may be folds, and with them branches, that were not found.
    pub fn completeness(&self) -> SearchQuality {
        self.completeness
    }

    /// All equilibria at `value`, by increasing radius, and whether there may be more.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the value is finite; errors of the transform; [`Error::OutOfRange`] if a force is not
    /// representable.
    pub fn search(&self, value: &R) -> Result<Equilibria<R>> {
        let equilibria = self.equilibria(value)?;
        let found = |outwards: &dyn Fn(&Equilibrium<R>) -> bool| equilibria.iter().any(outwards);
        let first = self.folds.first().is_some_and(|fold| found(&|rest| rest.contact_radius < fold.contact_radius));
        let last = self.folds.last().is_some_and(|fold| found(&|rest| rest.contact_radius > fold.contact_radius));
        let hidden = match self.folds.as_slice() {
            [] => equilibria.is_empty() && (self.is_open_inwards(value)? || self.is_open_outwards(value)?),
            _ => !first && self.is_open_inwards(value)? || !last && self.is_open_outwards(value)?,
        };
        let completeness = if hidden { SearchQuality::Doubtful } else { self.completeness };
        Ok(Equilibria { equilibria, completeness })
    }

    /// Whether `value` equals that of the fold, up to the rounding of g, Δl and the mean of g.
    ///
    /// Up to some roundings beyond the fold it counts as equal. On the side of the two equilibria they are
    /// distinguished as soon as the roundings of d and Δl allow: taking both for the fold would cost their distance
    /// from it, which grows as the root of that of the value.
    fn is_at(&self, fold: &Fold<R>, value: &R) -> bool {
        if is_pole(fold) {
            return false;
        }
        let control = self.curve.control();
        let a = &fold.contact_radius;
        let beyond = value.clone() - control.controlled(&fold.indentation, &fold.force);
        let beyond = match fold.kind {
            FoldKind::Minimum => -beyond,
            FoldKind::Maximum => beyond,
        };
        let (lengths, roundings) = if beyond > value.lit(0) { (2, 8) } else { (1, 2) };
        let displacement = fold.indentation.abs() + self.curve.elongation(a).times(lengths);
        // The force is S(a) times a difference of lengths of this magnitude.
        let force = match self.curve.force_at(a, &displacement) {
            Ok(force) => force.abs() + fold.force.abs(),
            Err(_) => fold.force.abs(),
        };
        let scale = control.controlled(&displacement, &force);
        beyond.abs() <= scale * value.unit_roundoff().times(roundings)
    }

    /// The state at a vertical edge, if the contact edge is there at `value`.
    fn at_vertical_edge(&self, value: &R) -> Result<Option<Equilibrium<R>>> {
        let Some(outer_edge) = self.curve.vertical_edge() else { return Ok(None) };
        let grows = match self.folds.last().filter(|fold| fold.contact_radius == outer_edge) {
            Some(fold) => !self.is_at(fold, value) && self.curve.direction_at(&outer_edge, value)? < value.lit(0),
            None => self.curve.direction_at(&outer_edge, value)? < value.lit(0),
        };
        if !grows {
            return Ok(None);
        }
        let (indentation, force) = self.curve.equilibrium_at(&outer_edge, value)?;
        Ok(Some(Equilibrium { contact_radius: outer_edge, indentation, force, stability: Stability::Stable }))
    }

    /// The sign change of the direction of change on a branch, away from poles.
    fn change(&self, branch: usize, value: &R) -> Result<Option<Change<R>>> {
        let below = branch.checked_sub(1).and_then(|index| self.folds.get(index));
        let above = self.folds.get(branch);
        let Some(mut change) = self.change_between([below, above], value)? else { return Ok(None) };
        if let Some(pole) = below.filter(|end| is_pole(end) && change.lower == end.contact_radius) {
            change.lower = self.beside_pole(pole, &change.upper, change.below, value)?;
        }
        if let Some(pole) = above.filter(|end| is_pole(end) && change.upper == end.contact_radius) {
            change.upper = self.beside_pole(pole, &change.lower, change.below.reverse(), value)?;
        }
        Ok(Some(change))
    }

    fn change_between(&self, ends: [Option<&Fold<R>>; 2], value: &R) -> Result<Option<Change<R>>> {
        match ends.into() {
            (Some(below), Some(above)) => {
                let signs = (self.beside(below, value)?, self.beside(above, value)?);
                let (lower, upper) = (below.contact_radius.clone(), above.contact_radius.clone());
                Ok((signs.0 != signs.1).then_some(Change { lower, upper, below: signs.0 }))
            }
            (Some(fold), None) => self.walk(&fold.contact_radius, self.beside(fold, value)?, Towards::Larger, value),
            (None, Some(fold)) => self.walk(&fold.contact_radius, self.beside(fold, value)?, Towards::Smaller, value),
            (None, None) => {
                let start = self.start();
                let from = sign(&self.curve.direction_at(&start, value)?);
                let down = self.walk(&start, from, Towards::Smaller, value)?;
                if down.is_some() { Ok(down) } else { self.walk(&start, from, Towards::Larger, value) }
            }
        }
    }

    /// The direction of change on the branch beside a fold. At the value of the fold it is the same on both sides.
    fn beside(&self, fold: &Fold<R>, value: &R) -> Result<Ordering> {
        if is_pole(fold) {
            return Ok(match fold.kind {
                FoldKind::Minimum => Ordering::Less,
                FoldKind::Maximum => Ordering::Greater,
            });
        }
        if self.is_at(fold, value) {
            return Ok(match fold.kind {
                FoldKind::Minimum => Ordering::Greater,
                FoldKind::Maximum => Ordering::Less,
            });
        }
        Ok(sign(&self.curve.direction_at(&fold.contact_radius, value)?))
    }

    /// A start radius if there is no fold: the length w/E*, or half the outer radius if that is smaller.
    fn start(&self) -> R {
        let length = self.curve.material_length();
        match self.curve.transform().outer_radius().map(|outer| outer.over(2)) {
            Some(half) if half < length => half,
            _ => length,
        }
    }

    /// Searches from `start` to the end of the range of radii in steps that double in ln a, and halve at the end, until
    /// the direction of change differs from `from`.
    fn walk(&self, start: &R, from: Ordering, way: Towards, value: &R) -> Result<Option<Change<R>>> {
        let mut last = start.clone();
        let mut octaves: i64 = 1;
        let mut growing = true;
        while octaves > 0 {
            let power = match way {
                Towards::Larger => octaves,
                Towards::Smaller => -octaves,
            };
            match self.turn(last.lit(2).powi(power) * &last, value)? {
                Some((next, turn)) if turn != from => {
                    return Ok(Some(match way {
                        Towards::Larger => Change { lower: last, upper: next, below: from },
                        Towards::Smaller => Change { lower: next, upper: last, below: turn },
                    }));
                }
                Some((next, _)) => last = next,
                None => growing = false,
            }
            octaves = if growing { octaves * 2 } else { octaves / 2 };
        }
        match (way, self.curve.transform().outer_radius()) {
            (Towards::Larger, Some(outer)) => self.approach(last, &outer, from, value),
            _ => Ok(None),
        }
    }

    /// The last part of a search towards the outer radius: ever closer, and up to a vertical edge or an equator itself.
    fn approach(&self, mut last: R, outer: &R, from: Ordering, value: &R) -> Result<Option<Change<R>>> {
        for step in equator::approaches(outer).chain(self.curve.vertical_edge()) {
            if !(step > last) {
                continue;
            }
            match self.turn(step, value)? {
                Some((upper, turn)) if turn != from => return Ok(Some(Change { lower: last, upper, below: from })),
                Some((step, _)) => last = step,
                None => return Ok(None),
            }
        }
        let at_rim = self.equator.clone().filter(|_| from == Ordering::Less);
        Ok(at_rim.map(|upper| Change { lower: last, upper, below: from }))
    }

    /// Whether a radius is in the range of radii and of the arithmetic, and among those searched for folds: the exponents of arbitrary
    /// precision reach to 10^±3·10⁸.
    fn is_within_reach(&self, a: &R) -> bool {
        let normal = a.is_finite() && a.clone() * a.unit_roundoff() > a.lit(0);
        let within = self.reach.as_ref().is_none_or(|[lower, upper]| a >= lower && a <= upper);
        normal && within && (a.ln() - self.curve.material_length().ln()).abs().approx() <= survey::REACH
    }

    /// The direction of change at a radius; `None` outside the range of radii or of the arithmetic, or where g cannot
    /// be computed: the search ends there. The search for folds met the same radii and reported
    /// [`SearchQuality::Doubtful`].
    fn turn(&self, a: R, value: &R) -> Result<Option<(R, Ordering)>> {
        if !self.is_within_reach(&a) {
            return Ok(None);
        }
        match self.curve.direction_at(&a, value) {
            Ok(change) => Ok(change.is_finite().then(|| (a, sign(&change)))),
            Err(Error::OutOfRange { .. } | Error::Domain { .. } | Error::NoConvergence { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

impl<R: Real> EquilibriumBranches<R> for SearchedBranches<R> {
    fn control(&self) -> &Control<R> {
        self.curve.control()
    }

    fn tip_value(&self, like: &R) -> R {
        self.curve.tip_value(like)
    }

    fn is_pushed_back(&self, radius: &R, value: &R) -> Result<bool> {
        self.curve.is_pushed_back(radius, value)
    }

    fn admissibility(&self) -> &Admissibility {
        let search = || Arc::new(Admissibility::rounded(&self.curve, &self.folds));
        self.admissibility.get_or_init(search)
    }

    fn first_touch(&self) -> Result<Option<Touch<R>>> {
        admissible::first_touch(&self.curve, self.admissibility())
    }

    fn last_admissible(&self, radii: [&R; 2]) -> Result<Option<(Equilibrium<R>, Ring<R>)>> {
        admissible::last_admissible(&self.curve, self.admissibility(), radii)
    }

    fn folds(&self) -> &[Fold<R>] {
        &self.folds
    }

    fn on_branch(&self, branch: usize, value: &R) -> Result<Option<Equilibrium<R>>> {
        self.control().check_value(value)?;
        if branch > self.folds.len() {
            return Ok(None);
        }
        if branch == self.folds.len()
            && let Some(rest) = self.at_vertical_edge(value)?
        {
            return Ok(Some(rest));
        }
        let Some(Change { lower, upper, below }) = self.change(branch, value)? else { return Ok(None) };
        let equator = self.equator.as_ref();
        if equator == Some(&upper) {
            let (indentation, force) = self.curve.state_before_equator(&lower, &upper, value)?;
            let stability = Stability::Stable;
            return Ok(Some(Equilibrium { contact_radius: lower, indentation, force, stability }));
        }
        let direction = |a: &R| self.curve.direction_at(a, value);
        let Some(bracket) = Bracket::new(&lower, &upper, direction)? else { return Ok(None) };
        let contact_radius = roots::refine(bracket, &lower.unit_roundoff(), direction)?.value;
        let (indentation, force) = if equator.is_some_and(|equator| equator::is_near(&contact_radius, equator)) {
            self.curve.equilibrium_at(&contact_radius, value)?
        } else {
            self.curve.state_at(&contact_radius, value)?
        };
        // The contact grows below and shrinks above, back to the equilibrium.
        let stability = if below == Ordering::Less { Stability::Stable } else { Stability::Unstable };
        Ok(Some(Equilibrium { contact_radius, indentation, force, stability }))
    }

    fn onset(&self) -> Result<FirstContact> {
        onset(&self.curve, self.folds.first())
    }

    fn end(&self) -> Result<End<R>> {
        let end = end(&self.curve)?;
        Ok(if end == End::Open && self.is_lost_outwards()? { End::Unknown } else { end })
    }

    fn compare(&self, value: &R, fold: &Fold<R>) -> Result<Ordering> {
        let at_fold = self.control().controlled(&fold.indentation, &fold.force);
        match value.partial_cmp(&at_fold) {
            Some(_) if self.is_at(fold, value) => Ok(Ordering::Equal),
            order => order.ok_or_else(|| unordered(self.control(), value)),
        }
    }
}

/// Two radii between which the direction of change changes its sign, and its sign below.
struct Change<R> {
    lower: R,
    upper: R,
    below: Ordering,
}

/// The sign of a direction of change; an exact zero counts as shrinking on both sides.
fn sign<R: Real>(change: &R) -> Ordering {
    if *change < change.lit(0) { Ordering::Less } else { Ordering::Greater }
}
