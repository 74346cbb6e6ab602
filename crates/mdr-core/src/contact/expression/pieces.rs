//! Polynomials one after the other, as a spline has them, over sets of numbers.

use super::enclosed::{EnclosedFormula, FormulaPart};
use super::{Node, Operator};
use crate::calculus::enclose::BOUND_BITS;
use crate::number::{Interval, Precision, Real};

/// A polynomial Σ cₖ sᵏ in s = (r − start)/width.
#[derive(Clone, Debug)]
pub struct LocalPolynomial {
    /// Where s = 0.
    pub start: Interval,
    /// The length over which s grows by 1; not zero.
    pub width: Interval,
    /// c₀, c₁, ….
    pub coefficients: Vec<Interval>,
}

impl EnclosedFormula {
    /// A profile of polynomials, each from its `start` to that of the next one, the last up to `end`. The first starts at the axis, and
    /// neighbours are taken to have a common height where they meet. What else jumps there is not known.
    ///
    /// ```
    /// use mdr_core::contact::{EnclosedFormula, LocalPolynomial};
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let number = |n: i64| Interval::from_int(Precision::new(100), n);
    /// let of = |start: i64, coefficients: &[i64]| {
    ///     let coefficients = coefficients.iter().map(|c| number(*c)).collect();
    ///     LocalPolynomial { start: number(start), width: number(2), coefficients }
    /// };
    /// // r² up to 2, 4 + (r − 2) from there on.
    /// let profile = EnclosedFormula::piecewise(&[of(0, &[0, 0, 4]), of(2, &[4, 2])], number(4));
    /// let height = profile.part(1).and_then(|part| part.at(&number(3))).expect("a polynomial");
    /// assert!(profile.breaks().len() == 1 && height.contains(number(5).lower()));
    /// ```
    pub fn piecewise(polynomials: &[LocalPolynomial], end: Interval) -> Self {
        let parts = polynomials.iter().map(|polynomial| Some(polynomial.part())).collect();
        let breaks: Vec<Interval> = polynomials.iter().skip(1).map(|polynomial| polynomial.start.clone()).collect();
        let jumps = vec![None; breaks.len()];
        EnclosedFormula { parts, breaks, jumps, outer: Some(end), known_to: None, onsets: None }
    }
}

impl LocalPolynomial {
    fn part(&self) -> FormulaPart {
        let bits = self.width.precision();
        FormulaPart {
            trees: [BOUND_BITS, bits].map(|bits| self.tree(Precision::new(bits))),
            rooted: None,
            cleared: None,
            far_out: None,
        }
    }

    /// By Horner, in a precision.
    fn tree(&self, precision: Precision) -> Node<Interval> {
        let number = |value: &Interval| Node::Constant(value.rounded(precision));
        let of = |operator, a: Node<Interval>, b: Node<Interval>| Node::Operation(operator, Box::new(a), Box::new(b));
        let from_start = if self.start == self.start.lit(0) {
            Node::Variable
        } else {
            of(Operator::Subtract, Node::Variable, number(&self.start))
        };
        let s =
            of(Operator::Multiply, Node::Constant((self.width.lit(1) / &self.width).rounded(precision)), from_start);
        let mut coefficients = self.coefficients.iter().rev();
        let highest = coefficients.next().map_or_else(|| number(&self.width.lit(0)), number);
        coefficients.fold(highest, |sum, next| {
            let product = of(Operator::Multiply, sum, s.clone());
            if *next == next.lit(0) { product } else { of(Operator::Add, product, number(next)) }
        })
    }
}
