//! A formula over sets of numbers, cut where it is not smooth: what a rigorous integral of it needs.

use std::collections::BTreeMap;
use std::sync::Arc;

use rug::Float;

use super::breaks::Breaks;
use super::onset::Onsets;
use super::switch::{Switch, is_positive};
use super::{Constant, Expression, ExpressionError, Function, Node, Operator};
use crate::calculus::enclose::BOUND_BITS;
use crate::number::{Analytic, Dual, Euler, Interval, Literal, Precision, Real};

/// Bits beyond those of the precision in which breaks are located.
const BEYOND: u32 = 8;
/// Bits in which the signs of the arguments of `abs`, `min` and `max` are decided, at least.
const SIGN_BITS: u32 = 256;
/// and in so many more than those of the precision.
const BEYOND_SIGNS: u32 = 64;
/// Relative bits to which breaks are located before they are proved,
const COARSE: u32 = 45;
/// and at which the signs beside them are taken.
const BESIDE: u32 = 38;

/// A formula with values, analytic between its breaks: each part without `abs`, `min` and `max`, by the signs of their
/// arguments there.
///
/// ```
/// use mdr_core::contact::Expression;
/// use mdr_core::number::{Interval, Precision, Real, Rectangle};
/// let formula: Expression = "r^2/2 - max(0, r - 1)".parse()?;
/// let none = Default::default();
/// let precision = Precision::new(100);
/// let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
/// assert!(enclosed.breaks().len() == 1 && enclosed.breaks()[0].accuracy_bits() >= 96);
/// // Beyond its end each part has its analytic continuation: r²/2 − (r − 1) at r = 0.
/// let outer = enclosed.part(1).expect("the signs are decided");
/// let value = outer.at(&Interval::from_int(precision, 0)).expect("defined");
/// assert!(value.contains(Interval::from_int(precision, 1).lower()));
/// # Ok::<(), mdr_core::contact::ExpressionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct EnclosedFormula {
    pub(super) parts: Vec<Option<FormulaPart>>,
    pub(super) breaks: Vec<Interval>,
    pub(super) jumps: Vec<Option<Vec<Interval>>>,
    pub(super) outer: Option<Interval>,
    pub(super) known_to: Option<Float>,
    pub(super) onsets: Option<Arc<Onsets>>,
}

/// A formula between two breaks, and its analytic continuation.
#[derive(Clone, Debug)]
pub struct FormulaPart {
    /// In the precision of bounds, and in that of values.
    pub(super) trees: [Node<Interval>; 2],
    /// Likewise in q = r^(1/k), with k.
    pub(super) rooted: Option<(u32, [Node<Interval>; 2])>,
    /// The formula without its divisions by powers of r, if it has any.
    pub(super) cleared: Option<Arc<FormulaPart>>,
    /// The formula for radii far out, in the precision of bounds, if it is another there.
    pub(super) far_out: Option<Arc<Node<Interval>>>,
}

impl Expression {
    /// The formula over sets of numbers with these values of its parameters, of which the breaks are known.
    ///
    /// # Errors
    /// A parameter without a value, at its column.
    pub fn enclosed(
        &self,
        values: &BTreeMap<String, Literal>,
        breaks: &Breaks,
        precision: Precision,
    ) -> Result<EnclosedFormula, ExpressionError> {
        let root = self.with_values(values)?.without_cancelled();
        Ok(EnclosedFormula::new(&root, breaks, precision))
    }
}

impl EnclosedFormula {
    pub(super) fn new(root: &Node<Constant>, breaks: &Breaks, precision: Precision) -> Self {
        let bits = precision.bits();
        let fine = Precision::new((bits + BEYOND_SIGNS).max(SIGN_BITS));
        let tree: Node<Interval> = root.bound(fine);
        let places = breaks.places(bits + BEYOND);
        let outer = breaks.outer_radius(bits + BEYOND).map(|radius| around(&radius, bits));
        let samples = samples(&places, outer.as_ref(), fine);
        let bound = |root: &Node<Constant>| [BOUND_BITS, bits].map(|bits| root.bound::<Interval>(Precision::new(bits)));
        let trees = bound(root);
        // Only next to the axis, and with a tree that needs no signs of its parts.
        let folded = |root: &Node<Constant>| bound(root).map(|tree| tree.folded());
        let at_axis = if root.is_smooth() && places.is_empty() { Some((root, root.in_root())) } else { None };
        let cleared = at_axis.as_ref().and_then(|(root, in_root)| {
            let (trees, rooted) = match in_root {
                Some((k, root)) => (trees.clone(), Some((*k, folded(&root.cleared()?)))),
                None => (folded(&root.cleared()?), None),
            };
            Some(Arc::new(FormulaPart { trees, rooted, cleared: None, far_out: None }))
        });
        let far_out = at_axis.as_ref().map(|(root, _)| root.far_out()).filter(|far_out| far_out != root);
        let far_out = far_out.map(|root| Arc::new(root.bound(Precision::new(BOUND_BITS)).folded()));
        let rooted = at_axis.and_then(|(_, in_root)| in_root).map(|(k, root)| (k, folded(&root)));
        let part = |radius: &Option<Interval>| {
            let [low, high] = trees.each_ref().map(|own| own.resolved(&tree, radius.as_ref()?));
            Some(FormulaPart {
                trees: [low?.folded(), high?.folded()],
                rooted: rooted.clone(),
                cleared: cleared.clone(),
                far_out: far_out.clone(),
            })
        };
        let parts = samples.iter().map(part).collect();
        let (mut located, mut jumps) = (Vec::new(), Vec::new());
        for ((radius, within), beside) in places.iter().zip(samples.windows(2)) {
            let [tight, cell] = [around(radius, bits), around(radius, COARSE)].map(|place| place.rounded(fine));
            let switch = Switch::at(root, &tree, &cell, beside).filter(|switch| switch.is_only_within(&cell, &tight));
            located.push(match &switch {
                Some(_) => around(radius, bits),
                None => cell.hull(&within.rounded(fine)).rounded(precision),
            });
            // The zeros of different arguments need not be the same.
            let switch = switch.filter(|switch| switch.is_at_one_radius(&tight));
            let jump = switch.and_then(|switch| tree.sides(&Euler::variable(&tight, 2), &switch)?.jump());
            jumps.push(jump);
        }
        let known_to = breaks.known_to();
        let whole = EnclosedFormula { parts, breaks: located, jumps, outer, known_to, onsets: None };
        let onsets = breaks.split().and_then(|split| split.enclosed(&whole, precision)).map(Arc::new);
        EnclosedFormula { onsets, ..whole }
    }

    /// Enclosures of the radii where the formula is not smooth, ascending.
    pub fn breaks(&self) -> &[Interval] {
        &self.breaks
    }

    /// The part before the break with this index, or after the last; `None` if it is not decided.
    pub fn part(&self, index: usize) -> Option<&FormulaPart> {
        self.parts.get(index)?.as_ref()
    }

    /// The jumps of f (zero), of Df and of D²f at a break, D = r d/dr; exactly zero where f' does not jump. `None` if they
    /// are not known.
    pub fn jump(&self, index: usize) -> Option<&[Interval]> {
        self.jumps.get(index)?.as_deref()
    }

    /// The formula as if it had only the breaks before one with this index.
    #[must_use]
    pub fn up_to(&self, index: usize) -> Self {
        let mut fewer = self.clone();
        fewer.breaks.truncate(index);
        fewer.jumps.truncate(index);
        fewer.parts.truncate(index + 1);
        fewer
    }

    /// The formula of a profile whose f' is known to be continuous, as where a cone is tangent to its cap: no jump of Df is left, where
    /// enclosures of both sides cannot tell that they are the same.
    #[must_use]
    pub fn without_corners(mut self) -> Self {
        for jump in self.jumps.iter_mut().flatten() {
            jump[1] = jump[1].lit(0);
        }
        self
    }

    /// The formula as a sum of powers that begin at radii, such as max(0, r − b)^1.5, and of a rest; `None` without such powers, or if one
    /// stands elsewhere than in a sum.
    pub fn onsets(&self) -> Option<&Onsets> {
        self.onsets.as_deref()
    }

    /// The radius where the formula ends.
    pub fn outer_radius(&self) -> Option<&Interval> {
        self.outer.as_ref()
    }

    /// The radius up to which all breaks are known; `None` if that is everywhere.
    pub fn known_to(&self) -> Option<&Float> {
        self.known_to.as_ref()
    }
}

impl FormulaPart {
    /// f over a set of radii.
    pub fn at<T: Analytic>(&self, r: &T) -> Option<T> {
        let tree = if r.bits() <= BOUND_BITS { &self.trees[0] } else { &self.trees[1] };
        tree.analytic(r)
    }

    /// f over an interval of radii that may reach far out, where quotients of sums of powers are taken over the highest power of their divisor.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let (formula, none): (Expression, _) = ("r^2/(1 + r^2)".parse()?, Default::default());
    /// let precision = Precision::new(64);
    /// let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
    /// let part = enclosed.part(0).expect("smooth");
    /// let far = Interval::from_int(precision, 10).hull(&Interval::from_f64(precision, 1e100));
    /// assert!(part.at(&far).is_none_or(|f| f.lower().to_f64() < 1e-100));
    /// assert!(part.far_out(&far).is_some_and(|f| f.lower().to_f64() > 0.99 && f.upper().to_f64() < 1.01));
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn far_out(&self, r: &Interval) -> Option<Interval> {
        match (self.at(r), self.far_out.as_ref().and_then(|far_out| far_out.analytic(r))) {
            (Some(one), Some(other)) => one.intersect(&other),
            (one, other) => one.or(other),
        }
    }

    /// k, if the formula is analytic at the axis as a function of r^(1/k) and not of r: see [`FormulaPart::at_root`].
    pub fn root(&self) -> Option<u32> {
        self.rooted.as_ref().map(|(k, _)| *k)
    }

    /// f over a set of roots q = r^(1/k) of radii, with the k of [`FormulaPart::root`]; `None` without one, too.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let formula: Expression = "sqrt(r + r^2)".parse()?;
    /// let none = Default::default();
    /// let precision = Precision::new(64);
    /// let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
    /// let part = enclosed.part(0).expect("no signs to decide");
    /// // √(q² + q⁴) at q = 2: r = 4.
    /// let value = part.at_root(&Interval::from_int(precision, 2)).expect("defined");
    /// assert!(part.root() == Some(2) && value.overlaps(&part.at(&Interval::from_int(precision, 4)).unwrap()));
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn at_root<T: Analytic>(&self, q: &T) -> Option<T> {
        let (_, trees) = self.rooted.as_ref()?;
        trees[usize::from(q.bits() > BOUND_BITS)].analytic(q)
    }

    /// (r f')' = f' + r f'' over a cell of radii, which may begin at 0; `None` where it is not bounded.
    pub fn stretch(&self, r: &Interval) -> Option<Interval> {
        let [_, slope, bend] = self.derivatives(r);
        let stretch = slope + bend * r;
        stretch.is_finite().then_some(stretch)
    }

    /// f, f' and f'' over a cell of radii; `None` where one is not bounded.
    pub fn slopes(&self, r: &Interval) -> Option<[Interval; 3]> {
        let all = self.derivatives(r);
        all.iter().all(Real::is_finite).then_some(all)
    }

    fn derivatives(&self, r: &Interval) -> [Interval; 3] {
        let tree = if r.precision() <= BOUND_BITS { &self.trees[0] } else { &self.trees[1] };
        let f = tree.value(&Dual::variable(Dual::variable(r.clone())));
        [f.value.value, f.value.slope, f.slope.slope]
    }
}

/// A radius to a relative 2^−bits.
fn around(radius: &Float, bits: u32) -> Interval {
    let bits = bits + 2;
    let width = Float::with_val(bits, radius) >> (bits - 1);
    Interval::point(Float::with_val(bits, radius)).inflate(&Interval::point(width)).rounded(Precision::new(bits - 2))
}

/// A radius in each part; `None` where two breaks are too close to each other.
fn samples(places: &[(Float, Interval)], outer: Option<&Interval>, precision: Precision) -> Vec<Option<Interval>> {
    let bits = precision.bits();
    let beside = |radius: &Float, direction: i32| {
        let radius = Float::with_val(bits, radius);
        radius.clone() + (radius >> BESIDE) * direction
    };
    let mut lower = Float::new(bits);
    let mut samples = Vec::new();
    for (radius, _) in places {
        let upper = beside(radius, -1);
        samples.push((lower < upper).then(|| Interval::point((lower + upper) / 2u32)));
        lower = beside(radius, 1);
    }
    let last = match outer {
        Some(outer) => Float::with_val(bits, outer.lower()),
        None if lower.is_zero() => Float::with_val(bits, 1),
        None => lower.clone() * 2u32,
    };
    samples.push((lower < last).then(|| Interval::point((lower + last) / 2u32)));
    samples
}

impl Node<Interval> {
    /// The formula without switches, by the signs of their arguments in a twin with more bits at a radius; `None` if one is
    /// not certain.
    fn resolved(&self, twin: &Node<Interval>, radius: &Interval) -> Option<Node<Interval>> {
        if let Some(argument) = twin.switch() {
            let positive = is_positive(&argument, radius)?;
            return self.switched(positive).resolved(&twin.switched(positive), radius);
        }
        let inner = |node: &Node<Interval>, twin: &Node<Interval>| node.resolved(twin, radius).map(Box::new);
        Some(match (self, twin) {
            (Node::Negative(x), Node::Negative(y)) => Node::Negative(inner(x, y)?),
            (Node::Power(x, n), Node::Power(y, _)) => Node::Power(inner(x, y)?, *n),
            (Node::Function(function, x), Node::Function(_, y)) => Node::Function(*function, inner(x, y)?),
            (Node::Operation(operator, a, b), Node::Operation(_, c, d)) => {
                Node::Operation(*operator, inner(a, c)?, inner(b, d)?)
            }
            (leaf, _) => leaf.clone(),
        })
    }

    /// The formula with its constant parts evaluated.
    pub(super) fn folded(&self) -> Node<Interval> {
        if self.is_constant() {
            let any = self.any_constant();
            return Node::Constant(self.value(&any));
        }
        self.with_inner(Node::folded)
    }

    /// A constant in it, for its precision.
    pub(super) fn any_constant(&self) -> Interval {
        match self {
            Node::Constant(constant) => constant.clone(),
            Node::Variable => Interval::from_int(Precision::new(BOUND_BITS), 0),
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => x.any_constant(),
            Node::Operation(_, a, _) => a.any_constant(),
        }
    }

    /// The value over a set; `None` where it is not defined or not analytic, as where a switch is left.
    pub(super) fn analytic<T: Analytic>(&self, r: &T) -> Option<T> {
        if let Some(departure) = self.departure() {
            return departure.analytic(r);
        }
        if let Some((a, growing)) = self.over_growing() {
            return growing.under(&a.analytic(r)?, r);
        }
        Some(match self {
            Node::Variable => r.clone(),
            Node::Constant(constant) => r.constant(constant),
            Node::Operation(Operator::Multiply, a, b) => match (&**a, &**b) {
                (Node::Constant(factor), x) | (x, Node::Constant(factor)) => x.analytic(r)?.scaled(factor),
                (a, b) => a.analytic(r)?.product(&b.analytic(r)?),
            },
            Node::Operation(Operator::Power, base, exponent) if exponent.is_constant() => {
                self.unary(&base.analytic(r)?)?
            }
            Node::Operation(operator, a, b) => combined(*operator, &a.analytic(r)?, &b.analytic(r)?)?,
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => self.unary(&x.analytic(r)?)?,
        })
    }

    /// The outermost operation on a value.
    pub(super) fn unary<T: Analytic>(&self, x: &T) -> Option<T> {
        match self {
            Node::Negative(_) => Some(x.negated()),
            Node::Power(_, 2) => Some(x.squared()),
            Node::Power(_, n) => x.raised(*n),
            Node::Function(function, _) => function.analytic(x),
            Node::Operation(Operator::Power, _, exponent) => x.power(&exponent.value(&exponent.any_constant())),
            Node::Operation(..) | Node::Variable | Node::Constant(_) => None,
        }
    }
}

pub(super) fn combined<T: Analytic>(operator: Operator, a: &T, b: &T) -> Option<T> {
    Some(match operator {
        Operator::Add => a.plus(b),
        Operator::Subtract => a.minus(b),
        Operator::Multiply => a.product(b),
        Operator::Divide => a.quotient(b)?,
        Operator::Power => b.product(&a.ln()?).exp(),
        Operator::Minimum | Operator::Maximum => return None,
    })
}

impl Function {
    /// The function over a set.
    fn analytic<T: Analytic>(self, x: &T) -> Option<T> {
        let number = |value: i64| Interval::from_int(Precision::new(x.bits()), value);
        Some(match self {
            Function::Sqrt => x.sqrt()?,
            Function::Exp => x.exp(),
            Function::Ln => x.ln()?,
            Function::Log10 => x.ln()?.scaled(&(number(1) / Real::ln(&number(10)))),
            Function::Sin => x.sin_cos().0,
            Function::Cos => x.sin_cos().1,
            Function::Atan => x.atan()?,
            Function::Asin => x.asin()?,
            Function::Acos => x.constant(&Real::over(number(1).pi(), 2)).minus(&x.asin()?),
            Function::Sinh => x.sinh_cosh().0,
            Function::Cosh => x.sinh_cosh().1,
            Function::Tanh => x.tanh()?,
            Function::Atanh => x.atanh()?,
            Function::Abs => return None,
        })
    }
}
