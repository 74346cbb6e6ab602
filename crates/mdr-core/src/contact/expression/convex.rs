//! A formula that rises by its form: convex in ln r.
//!
//! With s = ln r, (r f')' ≥ 0 says that f is convex in s, and then g falls nowhere. Powers of r are exponentials of s. A positive
//! function whose logarithm is convex in s stays one in sums, products, positive powers and under `exp`, `sinh` and `cosh`; its
//! logarithm is convex, and so are sums and maxima of convex functions, and powers from the first on of those that are not negative. These are
//! the rules of log-convex programming. Unlike enclosures they reach to all radii, where the terms of (r f')' may cancel, as those of ln(1 + r²) do.

use super::{Constant, Function, Node, Operator};
use crate::number::{Interval, Precision, Real};

/// Bits in which the sign of a constant is decided.
const BITS: u32 = 192;

/// What the form of a term says of it as a function of s = ln r.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// A constant, of this sign; without one its sign is not known.
    Constant(Option<i32>),
    /// Positive, and its logarithm is linear in s.
    Monomial,
    /// Positive, and its logarithm is convex.
    LogConvex,
    /// Convex, and nowhere negative.
    NonNegative,
    Convex,
}

impl Node<Constant> {
    /// Whether the formula is convex in ln r by its form; if not, it may be or not.
    pub(super) fn is_convex_by_form(&self) -> bool {
        self.form().is_some()
    }

    /// `None` where no rule says anything.
    fn form(&self) -> Option<Form> {
        if self.is_constant() {
            return Some(Form::Constant(self.sign()));
        }
        match self {
            Node::Variable => Some(Form::Monomial),
            Node::Constant(_) | Node::Negative(_) => None,
            Node::Power(base, n) => raised(base.form()?, n.signum() as i32, *n >= 1),
            Node::Function(function, inner) => of_function(*function, inner.form()?),
            Node::Operation(Operator::Power, base, exponent) if exponent.is_constant() => {
                raised(base.form()?, exponent.sign()?, exponent.is_from_one())
            }
            Node::Operation(operator, a, b) => combined(*operator, a.form()?, b.form()?),
        }
    }

    fn constant(&self) -> Interval {
        let precision = Precision::new(BITS);
        self.bound::<Interval>(precision).value(&Interval::from_int(precision, 1))
    }

    /// Whether a constant is certainly 1 or more.
    fn is_from_one(&self) -> bool {
        *self.constant().lower() >= 1
    }

    /// The sign of a constant, if enclosures tell it.
    fn sign(&self) -> Option<i32> {
        let value = self.constant();
        let zero = value.lit(0);
        match (value > zero, value < zero, value == zero) {
            (true, ..) => Some(1),
            (_, true, _) => Some(-1),
            (.., true) => Some(0),
            _ => None,
        }
    }
}

/// A positive constant is a monomial.
fn positive(form: Form) -> Form {
    if form == Form::Constant(Some(1)) { Form::Monomial } else { form }
}

/// A power whose exponent has this sign, and is 1 or more or not.
fn raised(base: Form, exponent: i32, is_from_one: bool) -> Option<Form> {
    match (base, exponent) {
        (Form::NonNegative, _) if is_from_one => Some(Form::NonNegative),
        (Form::Monomial, _) => Some(Form::Monomial),
        (Form::LogConvex, 1) => Some(Form::LogConvex),
        _ => None,
    }
}

fn of_function(function: Function, inner: Form) -> Option<Form> {
    let is_positive = matches!(inner, Form::Monomial | Form::LogConvex);
    match function {
        Function::Abs if is_positive => Some(inner),
        Function::Sqrt if is_positive => Some(inner),
        Function::Exp => Some(Form::LogConvex),
        // Their series have positive coefficients.
        Function::Sinh | Function::Cosh if is_positive => Some(Form::LogConvex),
        Function::Ln | Function::Log10 if is_positive => Some(Form::Convex),
        _ => None,
    }
}

fn combined(operator: Operator, a: Form, b: Form) -> Option<Form> {
    use Form::{Constant, Convex, LogConvex, Monomial, NonNegative};
    let is_positive = |form: Form| matches!(form, Monomial | LogConvex);
    let is_nonnegative = |form: Form| is_positive(form) || matches!(form, NonNegative | Constant(Some(0)));
    let (first, second) = (positive(a), positive(b));
    match operator {
        Operator::Add | Operator::Maximum if is_positive(first) && is_positive(second) => Some(LogConvex),
        Operator::Add if is_nonnegative(first) && is_nonnegative(second) => Some(NonNegative),
        Operator::Maximum if is_nonnegative(first) || is_nonnegative(second) => Some(NonNegative),
        Operator::Add | Operator::Maximum => Some(Convex),
        // Less a constant, of any sign.
        Operator::Subtract if matches!(b, Constant(_)) => Some(Convex),
        Operator::Multiply => match (first, second) {
            (Monomial, Monomial) => Some(Monomial),
            (first, second) if is_positive(first) && is_positive(second) => Some(LogConvex),
            (convex @ (Convex | NonNegative), _) if b == Constant(Some(1)) => Some(convex),
            (_, convex @ (Convex | NonNegative)) if a == Constant(Some(1)) => Some(convex),
            _ => None,
        },
        Operator::Divide => match (first, second) {
            (Monomial, Monomial) => Some(Monomial),
            (LogConvex, Monomial) => Some(LogConvex),
            (convex @ (Convex | NonNegative), _) if b == Constant(Some(1)) => Some(convex),
            _ => None,
        },
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::Expression;

    fn is_convex(text: &str) -> bool {
        let formula: Expression = text.parse().expect("a formula");
        formula.with_values(&BTreeMap::new()).expect("no parameters").is_convex_by_form()
    }

    #[test]
    fn sums_of_powers_logarithms_and_roots_rise_by_their_form() {
        for text in [
            "ln(1+r^2)",
            "2*ln(1+r^2+r^0.5)/3",
            "sqrt(1+r^2) - 1",
            "ln(cosh(r))",
            "(cosh(r) - 1)/2",
            "exp(r^2) - 1",
            "max(r, r^2/3) + 0.2*r",
            "r^2*exp(r)/4",
            "r*(1 + r^2)^(1/3)",
            "r^2/2 + 0.1*max(0, r - 0.1)^1.5",
            "max(r^2 - 2, 0)^2/3 + r",
            "(max(0, ln(r)) + r^2)^(4/3)",
        ] {
            assert!(is_convex(text), "{text}");
        }
    }

    #[test]
    fn of_others_the_form_says_nothing() {
        for text in [
            "1 - cos(r)",
            "r - tanh(r)",
            "r^2 - r",
            "-r",
            "r - r^2",
            "min(r, 1)",
            "ln(1 + r^2)*r",
            "r/(1 + r)",
            "(r^2 - 1)*(r - 2)",
            "ln(r^2 - 1)",
            "(ln(r) + 1)^2",
            "sqrt(ln(1 + r^2))",
            "abs(r - 1)",
            "max(0, r - 1)^0.9",
            "(r - 1)^2",
            "r*max(0, ln(r))",
            "(-2)*ln(1 + r)",
            "exp(-r)",
            "(r^2 - 3)/2*(0 - 1)",
        ] {
            assert!(!is_convex(text), "{text}");
        }
    }
}
