//! Formulas around the axis, where quotients such as (1 − cos r)/r are analytic and are not seen to be, and logarithms have no value.

use super::enclosed::FormulaPart;
use super::{Constant, Node, Operator};
use crate::number::{Analytic, Euler, Interval, NearZero, Real};

impl FormulaPart {
    /// f with its Euler derivatives up to an order over a set of radii that may hold the axis, where [`FormulaPart::at`] knows nothing of
    /// quotients such as (1 − cos r)/r and of logarithms. The formula must tend to 0 there, as a profile does.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::{Euler, Interval, Precision, Real};
    /// let precision = Precision::new(64);
    /// let radii = Interval::from_int(precision, 0).hull(&Interval::from_f64(precision, 0.1));
    /// let none = Default::default();
    /// for text in ["(1 - cos(r))/r", "r^2*ln(1/r)"] {
    ///     let formula: Expression = text.parse()?;
    ///     let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
    ///     let part = enclosed.part(0).expect("smooth");
    ///     assert!(part.at(&Euler::variable(&radii, 1)).is_none());
    ///     let f = part.derivatives_at(&radii, 1).expect("bounded");
    ///     assert!(f.value().contains_zero() && f.derivative(1).upper().to_f64() < 0.3);
    /// }
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn derivatives_at<T: Analytic>(&self, r: &T, order: usize) -> Option<Euler<T>> {
        self.derivatives_over(r, 1, order)
    }

    /// Likewise over a set of roots q = r^(1/k) of radii, with the k of [`FormulaPart::root`]; `None` without one, too.
    pub fn derivatives_at_root<T: Analytic>(&self, q: &T, order: usize) -> Option<Euler<T>> {
        self.derivatives_over(q, self.root()?, order)
    }

    /// The derivatives over a set of r for k = 1, or of q.
    fn derivatives_over<T: Analytic>(&self, place: &T, k: u32, order: usize) -> Option<Euler<T>> {
        let plain = self.plain_derivatives(place, k, order);
        if plain.is_some() {
            return plain;
        }
        // Without the divisions it is analytic, with them too but for a pole at the axis; and there it tends to 0.
        let cleared = || {
            let cleared = self.cleared.as_deref()?;
            let bounded = |set: &T::Complex| cleared.plain_derivatives(set, k, order).filter(Analytic::is_bounded);
            place.by_boundary(
                |set| bounded(set).is_some(),
                |set| Some(self.plain_derivatives(set, k, order)?.derivatives()),
            )
        };
        let beside = || self.derivatives_near(&place.beside_zero()?, k, order);
        cleared().and_then(Euler::from_derivatives).or_else(beside)
    }

    /// Likewise over all x s with 0 < s ≤ ε, for real or complex x and a number ε < 1.
    pub fn derivatives_along<T: Analytic>(&self, x: &T, end: &Interval, order: usize) -> Option<Euler<T>> {
        let all = end.lit(0).hull(end);
        let near = || self.derivatives_near(&NearZero::up_to(x, end)?, 1, order);
        self.derivatives_at(&x.scaled(&all), order).or_else(near)
    }

    fn derivatives_near<T: Analytic>(&self, near: &NearZero<T>, k: u32, order: usize) -> Option<Euler<T>> {
        let derivatives = self.plain_derivatives(near, k, order)?.derivatives();
        Euler::from_derivatives(derivatives.iter().map(NearZero::range).collect::<Option<_>>()?)
    }

    /// Where all steps of the formula are defined.
    fn plain_derivatives<T: Analytic>(&self, place: &T, k: u32, order: usize) -> Option<Euler<T>> {
        let variable = Euler::root(place, k, order);
        if k == 1 { self.at(&variable) } else { self.at_root(&variable) }
    }
}

impl Node<Constant> {
    /// The formula without its divisions by powers of r; `None` if there are none.
    ///
    /// Only sums and products lead to them. Where this formula is analytic, the one with the divisions is too but for r = 0, where it has
    /// a pole, or none; it has none if it tends to 0 there, as every profile does.
    pub(super) fn cleared(&self) -> Option<Node<Constant>> {
        let both = |operator: Operator, a: &Node<Constant>, b: &Node<Constant>| {
            let cleared = [a.cleared(), b.cleared()];
            if cleared.iter().all(Option::is_none) {
                return None;
            }
            let [left, right] = cleared;
            let part = |cleared: Option<Node<Constant>>, plain: &Node<Constant>| {
                Box::new(cleared.unwrap_or_else(|| plain.clone()))
            };
            Some(Node::Operation(operator, part(left, a), part(right, b)))
        };
        match self {
            Node::Power(base, n) if *n < 0 && **base == Node::Variable => Some(Node::whole(1)),
            Node::Power(base, n) if *n > 0 => Some(Node::Power(Box::new(base.cleared()?), *n)),
            Node::Negative(inner) => Some(Node::Negative(Box::new(inner.cleared()?))),
            Node::Operation(Operator::Divide, a, b) if b.is_power_of_radius() => {
                Some(a.cleared().unwrap_or_else(|| (**a).clone()))
            }
            Node::Operation(Operator::Divide, a, b) => {
                Some(Node::Operation(Operator::Divide, Box::new(a.cleared()?), b.clone()))
            }
            Node::Operation(operator @ (Operator::Add | Operator::Subtract | Operator::Multiply), a, b) => {
                both(*operator, a, b)
            }
            _ => None,
        }
    }

    /// Whether it is a positive integer power of r, times a number.
    fn is_power_of_radius(&self) -> bool {
        let sum = self.powers().unwrap_or_default();
        sum.len() == 1 && sum.keys().all(|n| *n > 0 && n.is_integer())
    }
}
