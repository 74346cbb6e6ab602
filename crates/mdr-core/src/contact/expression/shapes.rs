//! The profiles of the library as formulas.

use std::collections::BTreeMap;

use super::Expression;
use crate::contact::{Flank, Shape};
use crate::number::Literal;

/// The slope of a cone by half the angle at its apex, in degrees.
const SLOPE: &str = "(cos(pi*t/180)/sin(pi*t/180))";

impl Shape<Literal> {
    /// The profile as a formula, with the values of its parameters.
    ///
    /// ```
    /// use mdr_core::contact::{Profile, Shape};
    /// use mdr_core::number::Literal;
    /// let tip = Shape::RoundedPunch { radius: 2, flat: 1 }.map(|_, length| Literal::from(*length));
    /// let (formula, values) = tip.formula();
    /// assert_eq!(formula.bind::<f64>((), &values).expect("all have values").height(&3.0), 1.0);
    /// ```
    pub fn formula(&self) -> (Expression, BTreeMap<String, Literal>) {
        let (text, given): (&str, Vec<(&str, &Literal)>) = match self {
            Shape::Power { n, c } => match n.small_integer() {
                // Of any base.
                Some(power) => return with_slope(None, &format!("C*r^{power}"), vec![("C", c)]),
                None => ("C*r^n", vec![("n", n), ("C", c)]),
            },
            Shape::Paraboloid { radius } => ("r^2/(2*R)", vec![("R", radius)]),
            Shape::Cone { .. } => ("t*r", vec![]),
            Shape::Sphere { radius } => ("R - sqrt(R^2 - r^2)", vec![("R", radius)]),
            Shape::Ellipsoid { lateral, height } => ("h*(1 - sqrt(1 - r^2/b^2))", vec![("b", lateral), ("h", height)]),
            Shape::FlatPunch { .. } => ("0*r", vec![]),
            Shape::TruncatedCone { flat, .. } => ("t*max(r - b, 0)", vec![("b", flat)]),
            Shape::TruncatedParaboloid { radius, flat } => {
                ("max(r^2 - b^2, 0)/(2*R)", vec![("R", radius), ("b", flat)])
            }
            Shape::ConeParabolicCap { cap, .. } => ("t*min(r, b)^2/(2*b) + t*max(r - b, 0)", vec![("b", cap)]),
            Shape::ConeSphericalCap { radius, .. } => {
                ("R - sqrt(R^2 - min(r, R*t/sqrt(1 + t^2))^2) + t*max(r - R*t/sqrt(1 + t^2), 0)", vec![("R", radius)])
            }
            Shape::Hyperboloid { lateral, .. } => ("t*(sqrt(r^2 + b^2) - b)", vec![("b", lateral)]),
            Shape::RoundedPunch { radius, flat } => ("max(r - b, 0)^2/(2*R)", vec![("R", radius), ("b", flat)]),
            Shape::DisplacedParaboloid { radius, offset } => {
                ("(r^2 - 2*b*r)/(2*R)", vec![("R", radius), ("b", offset)])
            }
            Shape::ParabolicDimple { depth, radius } => ("-h*min(r, b)^2/b^2", vec![("h", depth), ("b", radius)]),
            Shape::EllipticalDimple { depth, radius } => {
                ("h*(sqrt(1 - min(r, b)^2/b^2) - 1)", vec![("h", depth), ("b", radius)])
            }
            Shape::WavyParaboloid { radius, amplitude, wavelength } => {
                ("r^2/(2*R) + A*(1 - cos(2*pi*r/L))", vec![("R", radius), ("A", amplitude), ("L", wavelength)])
            }
        };
        with_slope(self.flank(), text, given)
    }

    fn flank(&self) -> Option<&Flank<Literal>> {
        match self {
            Shape::Cone { flank }
            | Shape::TruncatedCone { flank, .. }
            | Shape::ConeParabolicCap { flank, .. }
            | Shape::ConeSphericalCap { flank, .. }
            | Shape::Hyperboloid { flank, .. } => Some(flank),
            _ => None,
        }
    }
}

/// A formula in which t is the slope of a cone.
fn with_slope<'a>(
    flank: Option<&'a Flank<Literal>>,
    text: &str,
    mut given: Vec<(&'a str, &'a Literal)>,
) -> (Expression, BTreeMap<String, Literal>) {
    let text = match flank {
        Some(Flank::HalfAngleDegrees(_)) => replaced(text),
        _ => text.to_owned(),
    };
    given.extend(flank.map(|flank| ("t", flank.parameter().1)));
    // Every text above is a formula: a test reads them all.
    let formula = text.parse().unwrap_or(Expression { root: super::Node::Variable });
    (formula, given.into_iter().map(|(name, value)| (name.to_owned(), value.clone())).collect())
}

/// A formula with the slope by an angle for each t that stands alone.
fn replaced(text: &str) -> String {
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    let mut before = None;
    let mut out = String::new();
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        if c == 't' && !is_letter(before) && !is_letter(rest.peek().copied()) {
            out.push_str(SLOPE);
        } else {
            out.push(c);
        }
        before = Some(c);
    }
    out
}
