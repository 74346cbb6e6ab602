//! Profiles written as formulas: `r^2/(2*R) + A*(1 - cos(2*pi*r/L))`.

#[cfg(feature = "mp")]
mod axis;
#[cfg(feature = "mp")]
mod breaks;
#[cfg(feature = "mp")]
mod convex;
#[cfg(feature = "mp")]
mod cut;
#[cfg(feature = "mp")]
mod enclosed;
#[cfg(feature = "mp")]
mod jet;
#[cfg(feature = "mp")]
mod lowest;
#[cfg(feature = "mp")]
mod onset;
mod parse;
#[cfg(feature = "mp")]
mod pieces;
#[cfg(feature = "mp")]
mod powers;
#[cfg(feature = "mp")]
mod rooted;
mod shapes;
mod steady;
#[cfg(feature = "mp")]
mod switch;

#[cfg(feature = "mp")]
pub use breaks::Breaks;
#[cfg(feature = "mp")]
pub use cut::CutFormula;
#[cfg(feature = "mp")]
pub use enclosed::{EnclosedFormula, FormulaPart};
#[cfg(feature = "mp")]
pub use lowest::{FormulaShape, Lowest, LowestRing};
#[cfg(feature = "mp")]
pub use onset::{Onset, Onsets};
#[cfg(feature = "mp")]
pub use pieces::LocalPolynomial;

use std::collections::BTreeMap;

use thiserror::Error;

use super::Profile;
use crate::number::{Lift, Literal, Real, Special};
use crate::text::excerpt;

/// Why a formula cannot be used, and the column at fault.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("column {column}: {reason}")]
pub struct ExpressionError {
    /// The position in the formula, counted in characters from 1.
    pub column: usize,
    /// The fault at that position, and the expected form.
    pub reason: String,
}

/// A formula for a profile f(r), parsed, independent of an arithmetic.
///
/// The grammar has the variable `r`, parameters by name, exact decimal literals, `pi`, the operators `+ - * / ^` (with
/// `^` binding tighter than a sign on its left and associating to the right), parentheses, and the functions `sqrt`,
/// `exp`, `ln`, `log10`, `sin`, `cos`, `atan`, `asin`, `acos`, `sinh`, `cosh`, `tanh`, `atanh`, `abs`, `min`, `max`.
///
/// ```
/// use mdr_core::contact::{Expression, Profile};
/// use mdr_core::number::Dual;
/// let formula: Expression = "r^2/(2*R) + A*(1 - cos(k*r))".parse()?;
/// assert_eq!(formula.parameters().collect::<Vec<_>>(), ["A", "R", "k"]);
/// let values = [("R", "2"), ("A", "0.25"), ("k", "1")].map(|(name, value)| (name.to_owned(), value.parse().unwrap()));
/// let profile = formula.bind::<f64>((), &values.into())?;
/// let f = profile.height(&Dual::variable(1.0));
/// assert!((f.slope - (0.5 + 0.25 * 1f64.sin())).abs() < 1e-15);
///
/// let error = "r^2/(2*R".parse::<Expression>().unwrap_err();
/// assert_eq!(error.to_string(), "column 9: expected `)` to close the `(` of column 5");
/// # Ok::<(), mdr_core::contact::ExpressionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    root: Node<Constant>,
}

/// A constant before an arithmetic is chosen.
#[derive(Clone, Debug, PartialEq)]
enum Constant {
    Literal(Literal),
    Pi,
    Parameter { name: String, column: usize },
}

/// The cost of a function, in operations.
const FUNCTION: u64 = 20;

/// A formula whose constants are of type `C`.
#[derive(Clone, Debug, PartialEq)]
enum Node<C> {
    Variable,
    Constant(C),
    Negative(Box<Node<C>>),
    Operation(Operator, Box<Node<C>>, Box<Node<C>>),
    /// An integer power, which is defined for any base.
    Power(Box<Node<C>>, i64),
    Function(Function, Box<Node<C>>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Minimum,
    Maximum,
}

/// Declares the functions of formulas, each a function of numbers with the same name.
macro_rules! functions {
    ($($name:ident => $function:ident,)*) => {
        #[derive(Clone, Copy, Debug, PartialEq)]
        enum Function {
            $($function),*
        }

        impl Function {
            const ALL: &[(&str, Function)] = &[$((stringify!($name), Function::$function)),*];

            fn apply<S: Special>(self, x: &S) -> S {
                match self {
                    $(Function::$function => x.$name(),)*
                }
            }
        }
    };
}

functions! {
    sqrt => Sqrt, exp => Exp, ln => Ln, sin => Sin, cos => Cos, atan => Atan, asin => Asin, acos => Acos, atanh => Atanh,
    sinh => Sinh, cosh => Cosh, tanh => Tanh, log10 => Log10, abs => Abs,
}

/// The names of the operators that are written as functions.
const EXTREMES: [(&str, Operator); 2] = [("min", Operator::Minimum), ("max", Operator::Maximum)];

impl<C: Clone> Node<C> {
    /// The formula with what its outermost operation acts on replaced.
    #[cfg(feature = "mp")]
    fn with_inner(&self, replace: impl Fn(&Node<C>) -> Node<C>) -> Node<C> {
        let inner = |x: &Node<C>| Box::new(replace(x));
        match self {
            Node::Negative(x) => Node::Negative(inner(x)),
            Node::Power(x, n) => Node::Power(inner(x), *n),
            Node::Function(function, x) => Node::Function(*function, inner(x)),
            Node::Operation(operator, a, b) => Node::Operation(*operator, inner(a), inner(b)),
            Node::Variable | Node::Constant(_) => self.clone(),
        }
    }
}

impl<C> Node<C> {
    /// The formula with every constant replaced.
    fn map<D, E>(&self, replace: &mut impl FnMut(&C) -> Result<D, E>) -> Result<Node<D>, E> {
        Ok(match self {
            Node::Variable => Node::Variable,
            Node::Constant(constant) => Node::Constant(replace(constant)?),
            Node::Negative(x) => Node::Negative(Box::new(x.map(replace)?)),
            Node::Operation(op, a, b) => Node::Operation(*op, Box::new(a.map(replace)?), Box::new(b.map(replace)?)),
            Node::Power(x, n) => Node::Power(Box::new(x.map(replace)?), *n),
            Node::Function(function, x) => Node::Function(*function, Box::new(x.map(replace)?)),
        })
    }
}

impl<R: Special> Node<R> {
    /// The largest term that contributes to the value: its rounding error remains when terms cancel.
    fn largest_term(&self, r: &R) -> R {
        let through = |x: &Node<R>, value: R| {
            let inner = x.value(r).abs();
            if inner == inner.lit(0) {
                // As on a flat of max(0, …): not by rounding.
                return value.abs();
            }
            let amplified = x.largest_term(r) / inner;
            if amplified > amplified.lit(1) { value.abs() * amplified } else { value.abs() }
        };
        if let Some(departure) = self.departure() {
            return through(departure.argument(), self.value(r));
        }
        match self {
            Node::Variable => r.abs(),
            Node::Constant(constant) => constant.abs(),
            Node::Negative(x) => x.largest_term(r),
            Node::Power(x, _) | Node::Function(_, x) => through(x, self.value(r)),
            Node::Operation(operator, a, b) => match operator {
                Operator::Multiply => a.largest_term(r) * b.largest_term(r),
                Operator::Divide => a.largest_term(r) / b.value(r).abs(),
                Operator::Power => through(a, self.value(r)),
                _ => a.largest_term(r).greater(&b.largest_term(r)),
            },
        }
    }

    /// Whether it is a minimum or a maximum that is the constant 0 next to a radius, from its value there: as `max(0, x)` where x is below 0.
    fn is_flat_at<S: Lift<R>>(&self, value: &S) -> bool {
        matches!(self, Node::Operation(Operator::Minimum | Operator::Maximum, ..)) && value.value_of().is_integer(0)
    }

    fn value<S: Lift<R>>(&self, r: &S) -> S {
        if let Some(departure) = self.departure() {
            return departure.value(r);
        }
        if let Some(quotient) = self.over_large_exponential(r) {
            return quotient;
        }
        match self {
            Node::Variable => r.clone(),
            Node::Constant(constant) => S::lift(constant),
            Node::Negative(x) => -x.value(r),
            Node::Power(x, n) => x.value(r).powi(*n),
            Node::Function(function, x) => {
                let value = x.value(r);
                if *function == Function::Sqrt && x.is_flat_at(&value) { value } else { function.apply(&value) }
            }
            Node::Operation(operator, base, b) => {
                let (a, b) = (base.value(r), b.value(r));
                match operator {
                    Operator::Power if base.is_flat_at(&a) && b.value_of() > b.value_of().lit(0) => a,
                    Operator::Add => a + b,
                    Operator::Subtract => a - b,
                    Operator::Multiply => a * b,
                    Operator::Divide => a / b,
                    Operator::Power => a.pow(&b),
                    Operator::Minimum => a.lesser(&b),
                    Operator::Maximum => a.greater(&b),
                }
            }
        }
    }
}

impl Expression {
    /// The names of the parameters, sorted, each once.
    pub fn parameters(&self) -> impl Iterator<Item = String> + use<> {
        let mut names = std::collections::BTreeSet::new();
        let collected: Result<Node<()>, std::convert::Infallible> = self.root.map(&mut |constant| {
            if let Constant::Parameter { name, .. } = constant {
                names.insert(name.clone());
            }
            Ok(())
        });
        debug_assert!(collected.is_ok());
        names.into_iter()
    }

    /// The formula with the values of its parameters, in an arithmetic of the given context. The profile counts as
    /// smooth until its [kinks are set](ExpressionProfile::broken_at).
    ///
    /// # Errors
    /// A parameter without a value, at its column.
    pub fn bind<R: Special>(
        &self,
        ctx: R::Ctx,
        values: &BTreeMap<String, Literal>,
    ) -> Result<ExpressionProfile<R>, ExpressionError> {
        let root = self.with_values(values)?.bound(ctx);
        Ok(ExpressionProfile { root, kinks: Vec::new(), outer: None, known_to: None })
    }

    /// The formula with parameter values in the arithmetic of the result, such as dual numbers of an unknown. For values as
    /// literals see [`Expression::bind`].
    ///
    /// # Errors
    /// A parameter without a value, at its column.
    pub fn bind_numbers<R: Special>(
        &self,
        ctx: R::Ctx,
        values: &BTreeMap<String, R>,
    ) -> Result<ExpressionProfile<R>, ExpressionError> {
        let root = self.root.map(&mut |constant| match constant {
            Constant::Literal(literal) => Ok(R::from_literal(ctx, literal)),
            Constant::Pi => Ok(R::from_int(ctx, 1).pi()),
            Constant::Parameter { name, column } => values
                .get(name)
                .cloned()
                .ok_or_else(|| ExpressionError { column: *column, reason: unknown_name(name, values.keys()) }),
        })?;
        Ok(ExpressionProfile { root, kinks: Vec::new(), outer: None, known_to: None })
    }

    /// Whether it is free of `abs`, `min` and `max`, which have kinks where their arguments change sign or order.
    pub fn is_smooth(&self) -> bool {
        self.root.is_smooth()
    }

    /// The number of operations of a height, a function or a power counted as twenty: what it costs.
    pub fn operations(&self) -> u64 {
        self.root.operations(&|_| FUNCTION)
    }

    /// The number of operations of a height over a complex set, a function counted as twenty, a logarithm or a power as forty, and an
    /// inverse function as a hundred: what it costs there.
    pub fn complex_operations(&self) -> u64 {
        self.root.operations(&|function| match function {
            None | Some(Function::Ln | Function::Log10) => 2 * FUNCTION,
            Some(Function::Atan | Function::Asin | Function::Acos | Function::Atanh) => 5 * FUNCTION,
            Some(_) => FUNCTION,
        })
    }

    /// The formula without parameters.
    fn with_values(&self, values: &BTreeMap<String, Literal>) -> Result<Node<Constant>, ExpressionError> {
        self.root.map(&mut |constant| match constant {
            Constant::Parameter { name, column } => match values.get(name) {
                Some(value) => Ok(Constant::Literal(value.clone())),
                None => Err(ExpressionError { column: *column, reason: unknown_name(name, values.keys()) }),
            },
            constant => Ok(constant.clone()),
        })
    }
}

impl<C> Node<C> {
    /// The number of operations, with the `cost` of each function, and of a power for `None`.
    fn operations(&self, cost: &dyn Fn(Option<Function>) -> u64) -> u64 {
        let of = |node: &Node<C>| node.operations(cost);
        match self {
            Node::Variable | Node::Constant(_) => 1,
            Node::Operation(Operator::Power, base, exponent) => cost(None) + of(base) + of(exponent),
            Node::Operation(_, left, right) => 1 + of(left) + of(right),
            Node::Negative(inner) | Node::Power(inner, _) | Node::Function(Function::Abs, inner) => 1 + of(inner),
            Node::Function(function, inner) => cost(Some(*function)) + of(inner),
        }
    }

    fn is_smooth(&self) -> bool {
        match self {
            Node::Variable | Node::Constant(_) => true,
            Node::Operation(Operator::Minimum | Operator::Maximum, ..) | Node::Function(Function::Abs, _) => false,
            Node::Operation(_, left, right) => left.is_smooth() && right.is_smooth(),
            Node::Negative(inner) | Node::Power(inner, _) | Node::Function(_, inner) => inner.is_smooth(),
        }
    }
}

impl Node<Constant> {
    /// A whole number.
    #[cfg(feature = "mp")]
    fn whole(value: i64) -> Self {
        Node::Constant(Constant::Literal(value.into()))
    }

    /// The formula in an arithmetic. All parameters have been replaced; a remaining one would become NaN.
    fn bound<R: Real>(&self, ctx: R::Ctx) -> Node<R> {
        let number = |constant: &Constant| match constant {
            Constant::Literal(literal) => R::from_literal(ctx, literal),
            Constant::Pi => R::from_int(ctx, 1).pi(),
            Constant::Parameter { .. } => R::from_int(ctx, 0).over(0),
        };
        let Ok(node) = self.map(&mut |constant| Ok::<R, std::convert::Infallible>(number(constant)));
        node
    }
}

/// The message for a name that has no meaning, with the known names.
fn unknown_name<'a>(name: &str, parameters: impl Iterator<Item = &'a String>) -> String {
    let known: Vec<&str> = ["r", "pi"].into_iter().chain(parameters.map(String::as_str)).collect();
    format!("unknown name `{}`; known here: {}", excerpt(name), excerpt(&known.join(", ")))
}

/// A formula with values, as a profile.
#[derive(Clone, Debug)]
pub struct ExpressionProfile<R> {
    root: Node<R>,
    kinks: Vec<R>,
    outer: Option<R>,
    known_to: Option<R>,
}

impl<R: Special> Profile<R> for ExpressionProfile<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        self.root.value(r)
    }

    fn largest_term(&self, r: &R) -> Option<R> {
        Some(self.root.largest_term(r))
    }

    fn kinks(&self) -> Vec<R> {
        self.kinks.clone()
    }

    fn outer_radius(&self) -> Option<R> {
        self.outer.clone()
    }

    fn kinks_known_to(&self) -> Option<R> {
        self.known_to.clone()
    }
}
