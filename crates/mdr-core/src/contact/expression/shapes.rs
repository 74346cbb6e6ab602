//! The profiles of the library as formulas.

use std::collections::BTreeMap;

use super::{Expression, ExpressionError};
use crate::contact::{Flank, Shape};
use crate::number::Literal;

/// The slope of a cone by t, half the angle at its apex, in degrees.
const SLOPE: &str = "(cos(pi*t/180)/sin(pi*t/180))";

impl Shape<Literal> {
    /// The profile as a formula, with the values of its parameters by their symbols.
    ///
    /// # Errors
    /// The text is no formula.
    ///
    /// ```
    /// use mdr_core::contact::{Profile, Shape};
    /// use mdr_core::number::Literal;
    /// let tip = Shape::RoundedPunch { radius: 2, flat: 1 }.map(|_, length| Literal::from(*length));
    /// let (formula, values) = tip.formula()?;
    /// assert_eq!(formula.bind::<f64>((), &values)?.height(&3.0), 1.0);
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn formula(&self) -> Result<(Expression, BTreeMap<String, Literal>), ExpressionError> {
        self.written(self.text())
    }

    /// The profile as a formula up to where its transform g diverges, which is the edge of an elliptical dimple: there the formula of all of
    /// it has two kinks at one radius, whose order no enclosure tells. All of it for other shapes.
    ///
    /// # Errors
    /// The text is no formula.
    ///
    /// ```
    /// use mdr_core::contact::{Profile, Shape};
    /// use mdr_core::number::Literal;
    /// let dimple = Shape::EllipticalDimple { depth: 1, radius: 5 }.map(|_, length| Literal::from(*length));
    /// let (formula, values) = dimple.formula_to_pole()?;
    /// let inside = formula.bind::<f64>((), &values)?.broken_at((), &formula.breaks(&values)?);
    /// assert!((inside.height(&3.0) + 0.2).abs() < 1e-15);
    /// assert_eq!(inside.outer_radius(), Some(5.0));
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn formula_to_pole(&self) -> Result<(Expression, BTreeMap<String, Literal>), ExpressionError> {
        self.written(self.text_to_pole())
    }

    fn written(&self, text: &str) -> Result<(Expression, BTreeMap<String, Literal>), ExpressionError> {
        let integer = match self {
            Shape::Power { n, .. } => n.small_integer(),
            _ => None,
        };
        let text = match (integer, self.flank()) {
            // Written as a number it is an integer power, which is one of any base.
            (Some(n), _) => with(text, 'n', &n.to_string()),
            (_, Some(Flank::HalfAngleDegrees(_))) => with(text, 't', SLOPE),
            _ => text.to_owned(),
        };
        let values = self.symbols().iter().zip(self.parameters());
        Ok((text.parse()?, values.map(|(symbol, (_, value))| ((*symbol).to_owned(), value.clone())).collect()))
    }
}

/// A formula with a text for each symbol that stands alone.
fn with(formula: &str, symbol: char, text: &str) -> String {
    let part = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    let mut before = None;
    let mut out = String::new();
    let mut rest = formula.chars().peekable();
    while let Some(c) = rest.next() {
        if c == symbol && !part(before) && !part(rest.peek().copied()) {
            out.push_str(text);
        } else {
            out.push(c);
        }
        before = Some(c);
    }
    out
}
