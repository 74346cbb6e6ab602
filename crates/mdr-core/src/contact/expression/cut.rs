//! A formula cut at a radius, for integrals over what lies far inside of another radius.

use super::enclosed::{EnclosedFormula, FormulaPart};
use super::{Node, Operator};
use crate::calculus::enclose::BOUND_BITS;
use crate::number::{Euler, Interval, Precision, Real};

/// A formula f cut at a radius c, with a parabola P = α + βr² that touches it there within roundings, or another one.
#[derive(Clone, Debug)]
pub struct CutFormula {
    /// α, a number.
    pub height: Interval,
    /// β, a number.
    pub bend: Interval,
    /// The step of f − P at c.
    pub step: Interval,
    /// Zero up to c and f − P from there on, but for the step: f' and f'' jump at c.
    pub beyond: EnclosedFormula,
}

impl EnclosedFormula {
    /// The formula before its first break, cut at a radius c > 0 where a parabola touches it; `None` where it is not known there.
    pub fn cut_at(&self, c: &Interval) -> Option<CutFormula> {
        let f = self.part(0)?.at(&Euler::variable(c, 2))?;
        let bend = f.derivative(1) / c.square().times(2);
        let height = f.value().clone() - f.derivative(1).over(2);
        self.cut_with(c, &f, height.midpoint(), bend.midpoint())
    }

    /// The formula cut at c with any parabola: with a step there, and one of its slope.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let (formula, none): (Expression, _) = ("r^4".parse()?, Default::default());
    /// let number = |value| Interval::from_f64(Precision::new(64), value);
    /// let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, Precision::new(64))?;
    /// let cut = enclosed.cut_along(&number(2.0), number(1.0), number(3.0)).expect("smooth");
    /// // 16 − 1 − 12, and beyond it r⁴ − 1 − 3r².
    /// assert!(cut.step == number(3.0));
    /// let beyond = cut.beyond.part(1).and_then(|part| part.at(&number(3.0))).expect("smooth");
    /// assert!(beyond.contains(number(53.0).lower()));
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn cut_along(&self, c: &Interval, height: Interval, bend: Interval) -> Option<CutFormula> {
        self.cut_with(c, &self.part(0)?.at(&Euler::variable(c, 2))?, height, bend)
    }

    /// From the derivatives of the formula at c.
    fn cut_with(&self, c: &Interval, f: &Euler<Interval>, height: Interval, bend: Interval) -> Option<CutFormula> {
        let part = self.part(0)?;
        let of_square = c.square() * &bend;
        let step = f.value().clone() - &height - &of_square;
        let [first, second] = [(1, 2), (2, 4)].map(|(k, times)| f.derivative(k) - of_square.clone().times(times));
        let jumps = vec![c.lit(0), first, second];
        let nothing = FormulaPart {
            trees: [(); 2].map(|()| Node::Constant(c.lit(0))),
            rooted: None,
            cleared: None,
            far_out: None,
        };
        let beyond = EnclosedFormula {
            parts: vec![Some(nothing), Some(part.less_parabola(&height, &bend))],
            breaks: vec![c.clone()],
            jumps: vec![Some(jumps)],
            outer: self.outer.clone(),
            known_to: self.known_to.clone(),
            onsets: None,
        };
        Some(CutFormula { height, bend, step, beyond })
    }
}

impl FormulaPart {
    /// f − α − βr².
    fn less_parabola(&self, height: &Interval, bend: &Interval) -> FormulaPart {
        let [height_in_few, bend_in_few] = [height, bend].map(|value| value.rounded(Precision::new(BOUND_BITS)));
        let less = |tree: &Node<Interval>, height: &Interval, bend: &Interval| {
            let [height, bend] = [height, bend].map(|value| Box::new(Node::Constant(value.clone())));
            let square = Box::new(Node::Power(Box::new(Node::Variable), 2));
            let bent = Box::new(Node::Operation(Operator::Multiply, bend, square));
            let parabola = Box::new(Node::Operation(Operator::Add, height, bent));
            Node::Operation(Operator::Subtract, Box::new(tree.clone()), parabola)
        };
        let [in_few, in_all] = &self.trees;
        FormulaPart {
            trees: [less(in_few, &height_in_few, &bend_in_few), less(in_all, height, bend)],
            rooted: None,
            cleared: self.cleared.clone(),
            far_out: None,
        }
    }
}
