//! A formula cut at a radius, for integrals over what lies far inside of another radius.

use super::enclosed::{EnclosedFormula, FormulaPart};
use super::{Node, Operator};
use crate::number::{Euler, Interval, Precision, Real};

/// A formula f cut at a radius c, where the parabola P = α + βr² touches it.
#[derive(Clone, Debug)]
pub struct CutFormula {
    /// α.
    pub height: Interval,
    /// β.
    pub bend: Interval,
    /// Zero up to c and f − P from there on: f'' jumps at c.
    pub beyond: EnclosedFormula,
}

impl EnclosedFormula {
    /// The formula before its first break, cut at a radius c > 0 where a parabola touches it; `None` where it is not known there.
    pub fn cut_at(&self, c: &Interval) -> Option<CutFormula> {
        let part = self.part(0)?;
        let f = part.at(&Euler::variable(c, 2))?;
        let [height, rise] = [f.value().clone(), f.derivative(1)];
        let bend = rise.clone() / c.square().times(2);
        let height = height - rise.clone().over(2);
        let zero = c.lit(0);
        let jump = vec![zero.clone(), zero.clone(), f.derivative(2) - rise.times(2)];
        let nothing = FormulaPart {
            trees: part.trees.each_ref().map(|tree| Node::Constant(tree.any_constant().lit(0))),
            rooted: None,
            cleared: None,
        };
        let beyond = EnclosedFormula {
            parts: vec![Some(nothing), Some(part.less_parabola(&height, &bend))],
            breaks: vec![c.clone()],
            jumps: vec![Some(jump)],
            outer: self.outer.clone(),
            known_to: self.known_to.clone(),
            onsets: None,
        };
        Some(CutFormula { height, bend, beyond })
    }
}

impl FormulaPart {
    /// f − α − βr².
    fn less_parabola(&self, height: &Interval, bend: &Interval) -> FormulaPart {
        let less = |tree: &Node<Interval>| {
            let precision = Precision::new(tree.any_constant().precision());
            let [height, bend] = [height, bend].map(|value| Box::new(Node::Constant(value.rounded(precision))));
            let square = Box::new(Node::Power(Box::new(Node::Variable), 2));
            let bent = Box::new(Node::Operation(Operator::Multiply, bend, square));
            let parabola = Box::new(Node::Operation(Operator::Add, height, bent));
            Node::Operation(Operator::Subtract, Box::new(tree.clone()), parabola)
        };
        FormulaPart { trees: self.trees.each_ref().map(less), rooted: None, cleared: self.cleared.clone() }
    }
}
