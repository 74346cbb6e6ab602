//! What enclosures prove of the shape of a formula, without an integral: whether its transform g falls nowhere, and where
//! f is lowest.
//!
//! With r = x sin θ the transform is g(x) = x ∫ f'(r) dθ over (0, π/2), and g'(x) = ∫ (r f')' dθ. So g falls nowhere where
//! r f' does not: f' + r f'' ≥ 0 on cells that cover all radii, and f' jumps upwards at every kink; some formulas
//! tell it by their form. Separated surfaces
//! first touch at min f, which is isolated by bisection with f, f' and f'' on each cell. Where terms of f
//! cancel next to the axis, as those of exp(r²) − 1 − r² do, derivatives of higher orders decide there.

use std::collections::BTreeMap;

use rug::Float;
use rug::float::Round;

use super::breaks::SEARCHED;
use super::jet::Jet;
use super::{Breaks, Constant, Expression, ExpressionError, Node};
use crate::number::{Dual, Interval, Literal, Precision, Real};

/// Bits of the enclosures.
const BITS: u32 = 192;
/// The most cells that are evaluated for each of the two proofs,
const BUDGET: usize = 12_000;
/// and the most [operations](Expression::operations) on them: some seconds.
const OPERATIONS: u64 = 1_200_000;
/// A minimum that is sharpened costs as much as so many cells.
const MINIMUM: usize = 40;
/// Cells are not halved below this many bits of their radius; closer to the outer radius none is looked at.
const FINEST: u32 = 120;

/// What is proved of the shape of a formula.
#[derive(Clone, Debug)]
pub struct FormulaShape {
    /// Whether g falls nowhere, so that every state of a contact is admissible. If not, it may fall or not.
    pub rises: bool,
    /// The lowest point of f.
    pub lowest: Lowest,
}

/// The lowest point of a profile with f(0) = 0.
#[derive(Clone, Debug)]
pub enum Lowest {
    /// f ≥ 0: the tip.
    Tip,
    /// One ring, where f < 0.
    Ring(LowestRing),
    /// It is not known where.
    Open {
        /// A bound: f is nowhere smaller; −∞ if there is none.
        at_least: f64,
    },
}

/// The ring on which a formula has its least value.
#[derive(Clone, Debug)]
pub struct LowestRing {
    root: Node<Constant>,
    /// The only minimum between these radii.
    within: (Float, Float),
}

impl Expression {
    /// The shape of the formula with these values of its parameters, of which the breaks are known: for radii from
    /// 10^−301 to 10^301, or to the outer radius.
    ///
    /// # Errors
    /// A name without a value, or a value without a name: see [`Expression::bind`].
    pub fn shape(&self, values: &BTreeMap<String, Literal>, breaks: &Breaks) -> Result<FormulaShape, ExpressionError> {
        let root = self.with_values(values)?;
        let outer = breaks.outer_radius(BITS);
        let end = outer.clone().unwrap_or_else(|| Float::with_val(BITS, SEARCHED.1));
        let cells = self.cells(&root, end, outer.is_some());
        let rises = cells.rise(&root);
        // r f' does not fall and begins at zero, so f rises from the tip.
        let lowest = if rises { Lowest::Tip } else { cells.lowest(&root) };
        Ok(FormulaShape { rises, lowest })
    }

    /// Whether r f' is proved not to fall up to a radius within the profile, so that g falls nowhere up to there. If not, it may fall or
    /// not.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use rug::Float;
    /// // (r f')' = 4r − 16r³
    /// let (formula, none): (Expression, _) = ("r^2 - r^4".parse()?, Default::default());
    /// assert!(formula.rises_up_to(&none, &Float::with_val(53, 0.49))?);
    /// assert!(!formula.rises_up_to(&none, &Float::with_val(53, 0.51))?);
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    ///
    /// # Errors
    /// A name without a value, or a value without a name: see [`Expression::bind`].
    pub fn rises_up_to(&self, values: &BTreeMap<String, Literal>, radius: &Float) -> Result<bool, ExpressionError> {
        let root = self.with_values(values)?;
        Ok(self.cells(&root, Float::with_val_round(BITS, radius, Round::Up).0, false).rise(&root))
    }

    /// All radii up to an end.
    fn cells(&self, root: &Node<Constant>, end: Float, bounded: bool) -> Cells {
        let budget = BUDGET.min((OPERATIONS / self.operations().max(1)) as usize);
        Cells { root: root.bound(Precision::new(BITS)), end, bounded, budget }
    }
}

impl LowestRing {
    /// Enclosures of the radius and of the height of the ring.
    pub fn enclosed(&self, precision: Precision) -> [Interval; 2] {
        let bits = precision.bits().saturating_add(64).max(BITS);
        let node: Node<Interval> = self.root.bound(Precision::new(bits));
        let within = [&self.within.0, &self.within.1].map(|end| Float::with_val(bits, end));
        let [lower, upper] = sharpened(&node, within, bits - 16);
        let radius = Interval::new(lower, upper);
        let height = Jet::at(&node, &radius).mean_value(&node, &radius);
        [radius, height].map(|number| number.rounded(precision))
    }

    /// The radius and the height of the ring, rounded to the arithmetic.
    pub fn at<R: Real>(&self, ctx: R::Ctx) -> [R; 2] {
        let bits = R::from_int(ctx, 1).precision().saturating_add(64).max(BITS);
        let node: Node<Interval> = self.root.bound(Precision::new(bits));
        let within = [&self.within.0, &self.within.1].map(|end| Float::with_val(bits, end));
        let [lower, upper] = sharpened(&node, within, bits - 16);
        let radius = (lower + upper) / 2u32;
        let height: Node<Float> = self.root.bound(Precision::new(2 * bits));
        let height = height.value(&Float::with_val(2 * bits, &radius));
        [radius, height].map(|number| {
            let decimal = number.to_string_radix(10, Some(bits as usize / 3));
            decimal.parse().map_or_else(|_| R::from_f64(ctx, number.to_f64()), |literal| R::from_literal(ctx, &literal))
        })
    }
}

/// A minimum of a formula between two radii, the derivative negative at the lower one and positive at the upper one, to
/// so many bits.
fn sharpened(node: &Node<Interval>, [mut lower, mut upper]: [Float; 2], bits: u32) -> [Float; 2] {
    let fine = |lower: &Float, upper: &Float| Float::with_val(lower.prec(), upper - lower) <= upper.clone() >> bits;
    while !fine(&lower, &upper) {
        let middle = Float::with_val(lower.prec(), &lower + &upper) / 2u32;
        let slope = Jet::at(node, &Interval::point(middle.clone())).slope;
        if *slope.upper() < 0 {
            lower = middle;
        } else if *slope.lower() > 0 {
            upper = middle;
        } else {
            break;
        }
    }
    [lower, upper]
}

/// A formula on all radii.
struct Cells {
    root: Node<Interval>,
    end: Float,
    /// Whether the profile ends there.
    bounded: bool,
    /// The most cells.
    budget: usize,
}

/// What is known of the least value on a cell.
enum Found {
    /// It is not less than at the tip, at a point that was evaluated, or on a neighbour.
    Nothing,
    /// A minimum inside, and the only one.
    Minimum,
    /// A smaller cell may tell.
    Halve,
    /// The profile falls to its end: a smaller cell shows no more.
    Open,
}

impl Cells {
    fn all(&self) -> Vec<(Float, Float)> {
        vec![(Float::with_val(BITS, SEARCHED.0), self.end.clone())]
    }

    /// Two halves of a cell; none of one that is as fine as cells become.
    fn halves(&self, (lower, upper): &(Float, Float)) -> Option<[(Float, Float); 2]> {
        let width = Float::with_val(BITS, upper - lower);
        if width <= upper.clone() >> FINEST {
            return None;
        }
        let middle = if *upper > lower.clone() * 4u32 {
            lower.clone().sqrt() * upper.clone().sqrt()
        } else {
            // Off the middle, so that an extremum at a round number is not at the end of a cell.
            lower.clone() + width * 0.492_613f64
        };
        Some([(middle.clone(), upper.clone()), (lower.clone(), middle)])
    }

    /// A radius up to which r f' is proved not to fall, where terms of the formula cancel next to the axis: with
    /// E = (r f')' = f' + r f'' it is enough that E and E' are not negative at 0, and E'' = 3f''' + r f'''' nowhere up to there.
    fn rising_tip(&self, root: &Node<Constant>) -> Option<Float> {
        /// Halvings of the radius, from 1 m on.
        const HALVINGS: usize = 100;
        if !root.is_smooth() {
            return None;
        }
        let root: Node<Dual<Dual<Interval>>> = root.bound(Precision::new(BITS));
        // From the first on.
        let derivatives = |r: Interval| {
            let f = root.value(&Dual::variable(Dual::variable(Dual::variable(Dual::variable(r)))));
            [f.value.value.value.slope, f.value.value.slope.slope, f.value.slope.slope.slope, f.slope.slope.slope.slope]
        };
        let zero = Interval::from_int(Precision::new(BITS), 0);
        let is_not_negative = |value: &Interval| *value.lower() >= 0;
        let [first, second, ..] = derivatives(zero.clone());
        if !(is_not_negative(&first) && is_not_negative(&second)) {
            return None;
        }
        let ends = (0..HALVINGS).step_by(2).map(|k| Float::with_val(BITS, 1) >> k as u32);
        ends.filter(|end| *end < self.end).find(|end| {
            let r = zero.hull(&Interval::point(end.clone()));
            let [.., third, fourth] = derivatives(r.clone());
            is_not_negative(&(third.times(3) + fourth * r))
        })
    }

    /// Whether r f' of a formula is proved not to fall on any of them.
    fn rise(&self, root: &Node<Constant>) -> bool {
        root.is_convex_by_form()
            || self.rise_from(Float::with_val(BITS, SEARCHED.0))
            || self.rising_tip(root).is_some_and(|tip| self.rise_from(tip))
    }

    /// Whether r f' is proved not to fall beyond a radius.
    fn rise_from(&self, tip: Float) -> bool {
        let mut cells = vec![(tip, self.end.clone())];
        for _ in 0..self.budget {
            let Some(cell) = cells.pop() else { return true };
            let r = Interval::new(cell.0.clone(), cell.1.clone());
            // (r f')'; an operation outside of its domain leaves the entire line, whose lower end is −∞.
            let change_of = |jet: &Jet, r: &Interval| jet.slope.clone() + jet.curvature.clone() * r;
            let jet = Jet::at(&self.root, &r);
            let change = change_of(&jet, &r);
            if *change.lower() >= 0 && jet.bend.is_upward() {
                continue;
            }
            let middle = r.midpoint();
            let at_middle = Jet::at(&self.root, &middle);
            let change = change_of(&at_middle, &middle);
            if *change.upper() < 0 {
                return false;
            }
            match self.halves(&cell) {
                Some(halves) => cells.extend(halves),
                // Only the last piece before the outer radius is left out.
                None if self.bounded && cell.1 == self.end => {}
                None => return false,
            }
        }
        false
    }

    fn lowest(&self, root: &Node<Constant>) -> Lowest {
        let mut least = Float::new(BITS);
        let mut open: Vec<Float> = Vec::new();
        let mut minima: Vec<([Float; 2], Interval)> = Vec::new();
        let mut cells = self.all();
        let mut budget = self.budget;
        while let Some(cell) = cells.pop() {
            if budget == 0 {
                return Lowest::Open { at_least: f64::NEG_INFINITY };
            }
            budget -= 1;
            let (found, height) = self.cell(&cell, &mut least);
            match found {
                Found::Nothing => {}
                Found::Open => open.push(height.lower().clone()),
                Found::Halve => match self.halves(&cell) {
                    Some(halves) => cells.extend(halves),
                    None => open.push(height.lower().clone()),
                },
                Found::Minimum => {
                    budget = budget.saturating_sub(MINIMUM);
                    let [lower, upper] = sharpened(&self.root, [cell.0, cell.1], FINEST);
                    let r = Interval::new(lower.clone(), upper.clone());
                    let height = Jet::at(&self.root, &r).mean_value(&self.root, &r);
                    let at_middle = Jet::at(&self.root, &r.midpoint()).height;
                    least.min_mut(at_middle.upper());
                    minima.push(([lower, upper], height));
                }
            }
        }
        open.retain(|height| *height <= least);
        minima.retain(|(_, height)| *height.lower() <= least && *height.lower() < 0);
        match (open.as_slice(), minima.as_slice()) {
            ([], []) => Lowest::Tip,
            ([], [([lower, upper], _)]) if least < 0 => {
                Lowest::Ring(LowestRing { root: root.clone(), within: (lower.clone(), upper.clone()) })
            }
            _ => {
                let lower = minima.iter().map(|(_, height)| height.lower()).chain(&open);
                let at_least = lower.fold(f64::INFINITY, |least, height| least.min(height.to_f64()));
                // The next double below.
                Lowest::Open { at_least: if at_least.is_finite() { at_least.next_down() } else { f64::NEG_INFINITY } }
            }
        }
    }

    /// What is known of the least value on a cell, and an enclosure of f there; `least` is a value that f attains or
    /// exceeds somewhere.
    fn cell(&self, (lower, upper): &(Float, Float), least: &mut Float) -> (Found, Interval) {
        let r = Interval::new(lower.clone(), upper.clone());
        let jet = Jet::at(&self.root, &r);
        let at_middle = Jet::at(&self.root, &r.midpoint()).height;
        if at_middle.is_finite() {
            least.min_mut(at_middle.upper());
        }
        let height = jet.mean_value(&self.root, &r);
        // A value at the end of all radii has no neighbour.
        let last = *upper == self.end;
        let found = if *height.lower() >= 0 || *height.lower() > *least || *jet.slope.lower() > 0 {
            Found::Nothing
        } else if *jet.slope.upper() < 0 {
            if last { Found::Open } else { Found::Nothing }
        } else {
            let convex = jet.curvature.is_finite() && *jet.curvature.lower() > 0 && jet.bend.is_upward();
            let at_kink = jet.bend.is_upward() && self.halves(&(lower.clone(), upper.clone())).is_none();
            if convex || at_kink {
                let [first, end] = [lower, upper].map(|r| Jet::at(&self.root, &Interval::point(r.clone())).slope);
                let rises = *first.lower() > 0;
                match (*first.upper() < 0, *end.lower() > 0) {
                    (true, true) => Found::Minimum,
                    _ if rises || *end.upper() < 0 && !last => Found::Nothing,
                    _ => Found::Halve,
                }
            } else {
                Found::Halve
            }
        };
        (found, height)
    }
}
