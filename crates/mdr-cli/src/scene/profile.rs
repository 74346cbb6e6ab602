//! The profiles a scene can name.

use std::collections::BTreeMap;

use mdr_core::contact::{Breaks, Expression, Profile};
use mdr_core::number::{Interval, Literal, Precision, Real};

use super::measured::Measured;
use super::reader::{Section, Value};
use crate::error::Result;

/// The steepness of a flank, as it was given.
#[derive(Clone, Debug)]
pub(crate) enum Slope {
    /// tan θ, the rise of the flank.
    Tangent(Literal),
    /// The half opening angle at the apex, in degrees: the slope is its cotangent.
    HalfAngleDegrees(Literal),
}

/// A profile as a scene gives it.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Power { n: Literal, c: Literal },
    Paraboloid { radius: Literal },
    Cone { slope: Slope },
    Sphere { radius: Literal },
    Ellipsoid { lateral: Literal, height: Literal },
    FlatPunch { radius: Literal },
    TruncatedCone { slope: Slope, flat: Literal },
    TruncatedParaboloid { radius: Literal, flat: Literal },
    ConeParabolicCap { slope: Slope, cap: Literal },
    ConeSphericalCap { slope: Slope, radius: Literal },
    Hyperboloid { slope: Slope, lateral: Literal },
    RoundedPunch { radius: Literal, flat: Literal },
    DisplacedParaboloid { radius: Literal, offset: Literal },
    ParabolicDimple { depth: Literal, radius: Literal },
    EllipticalDimple { depth: Literal, radius: Literal },
    WavyParaboloid { radius: Literal, amplitude: Literal, wavelength: Literal },
    Sum(Vec<Shape>),
    Expression { formula: Expression, values: BTreeMap<String, Literal>, breaks: Breaks },
    Table(Measured),
}

type Reader = fn(&Section<'_>) -> Result<Shape>;

/// Every kind by its name in a scene.
const KINDS: [(&str, Reader); 19] = [
    ("power", |s| Ok(Shape::Power { n: length(s, "n")?, c: length(s, "c")? })),
    ("paraboloid", |s| Ok(Shape::Paraboloid { radius: length(s, "radius")? })),
    ("cone", |s| Ok(Shape::Cone { slope: slope(s)? })),
    ("sphere", |s| Ok(Shape::Sphere { radius: length(s, "radius")? })),
    ("ellipsoid", |s| Ok(Shape::Ellipsoid { lateral: length(s, "lateral")?, height: length(s, "height")? })),
    ("flat-punch", |s| Ok(Shape::FlatPunch { radius: length(s, "radius")? })),
    ("truncated-cone", |s| Ok(Shape::TruncatedCone { slope: slope(s)?, flat: length(s, "flat")? })),
    ("truncated-paraboloid", |s| {
        Ok(Shape::TruncatedParaboloid { radius: length(s, "radius")?, flat: length(s, "flat")? })
    }),
    ("cone-parabolic-cap", |s| Ok(Shape::ConeParabolicCap { slope: slope(s)?, cap: length(s, "cap")? })),
    ("cone-spherical-cap", |s| Ok(Shape::ConeSphericalCap { slope: slope(s)?, radius: length(s, "radius")? })),
    ("hyperboloid", |s| Ok(Shape::Hyperboloid { slope: slope(s)?, lateral: length(s, "lateral")? })),
    ("rounded-punch", |s| Ok(Shape::RoundedPunch { radius: length(s, "radius")?, flat: length(s, "flat")? })),
    ("displaced-paraboloid", |s| {
        Ok(Shape::DisplacedParaboloid { radius: length(s, "radius")?, offset: length(s, "offset")? })
    }),
    ("parabolic-dimple", |s| Ok(Shape::ParabolicDimple { depth: length(s, "depth")?, radius: length(s, "radius")? })),
    ("elliptical-dimple", |s| Ok(Shape::EllipticalDimple { depth: length(s, "depth")?, radius: length(s, "radius")? })),
    ("wavy-paraboloid", |s| {
        Ok(Shape::WavyParaboloid {
            radius: length(s, "radius")?,
            amplitude: s.required("amplitude")?.number()?,
            wavelength: length(s, "wavelength")?,
        })
    }),
    ("sum", sum),
    ("expression", expression),
    ("table", |s| Ok(Shape::Table(Measured::read(s)?))),
];

impl Shape {
    /// The name of the kind in a scene.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Shape::Power { .. } => "power",
            Shape::Paraboloid { .. } => "paraboloid",
            Shape::Cone { .. } => "cone",
            Shape::Sphere { .. } => "sphere",
            Shape::Ellipsoid { .. } => "ellipsoid",
            Shape::FlatPunch { .. } => "flat-punch",
            Shape::TruncatedCone { .. } => "truncated-cone",
            Shape::TruncatedParaboloid { .. } => "truncated-paraboloid",
            Shape::ConeParabolicCap { .. } => "cone-parabolic-cap",
            Shape::ConeSphericalCap { .. } => "cone-spherical-cap",
            Shape::Hyperboloid { .. } => "hyperboloid",
            Shape::RoundedPunch { .. } => "rounded-punch",
            Shape::DisplacedParaboloid { .. } => "displaced-paraboloid",
            Shape::ParabolicDimple { .. } => "parabolic-dimple",
            Shape::EllipticalDimple { .. } => "elliptical-dimple",
            Shape::WavyParaboloid { .. } => "wavy-paraboloid",
            Shape::Sum(_) => "sum",
            Shape::Expression { .. } => "expression",
            Shape::Table(_) => "table",
        }
    }

    /// Whether g is a closed form; otherwise it is a quadrature or measured.
    pub(crate) fn is_closed(&self) -> bool {
        match self {
            Shape::Sum(terms) => terms.iter().all(Shape::is_closed),
            Shape::Expression { .. } | Shape::Table(_) => false,
            _ => true,
        }
    }

    /// The rows of a table.
    pub(crate) fn rows(&self) -> Option<usize> {
        if let Shape::Table(measured) = self { Some(measured.table().rows().len()) } else { None }
    }

    /// The tables in it.
    pub(crate) fn tables(&self) -> Vec<&Measured> {
        match self {
            Shape::Sum(terms) => terms.iter().flat_map(Shape::tables).collect(),
            Shape::Table(measured) => vec![measured],
            _ => Vec::new(),
        }
    }

    /// The same with other tables; none where one cannot be had.
    pub(crate) fn with_tables(&self, change: &impl Fn(&Measured) -> Option<Measured>) -> Option<Shape> {
        Some(match self {
            Shape::Sum(terms) => Shape::Sum(terms.iter().map(|term| term.with_tables(change)).collect::<Option<_>>()?),
            Shape::Table(measured) => Shape::Table(change(measured)?),
            other => other.clone(),
        })
    }

    pub(super) fn read(section: &Section<'_>) -> Result<Shape> {
        let read = section.required("kind")?.choice("profile", &KINDS)?;
        let shape = read(section)?;
        section.finish()?;
        Ok(shape)
    }
}

/// A positive parameter.
fn length(section: &Section<'_>, key: &'static str) -> Result<Literal> {
    section.required(key)?.positive()
}

fn slope(section: &Section<'_>) -> Result<Slope> {
    match section.one_of(&["slope", "half_angle_degrees"])? {
        (0, value) => Ok(Slope::Tangent(value.positive()?)),
        (_, value) => {
            let angle = value.positive()?;
            if angle.to_rational() >= 90 {
                return Err(value.refuse(format!("must be below 90 degrees, got {angle}")));
            }
            Ok(Slope::HalfAngleDegrees(angle))
        }
    }
}

fn sum(section: &Section<'_>) -> Result<Shape> {
    let list = section.required("term")?;
    let terms: Vec<Shape> = list.list()?.iter().map(|term| Shape::read(&term.section()?)).collect::<Result<_>>()?;
    if terms.is_empty() {
        return Err(list.refuse("a sum needs at least one [[profile.term]]"));
    }
    Ok(Shape::Sum(terms))
}

fn expression(section: &Section<'_>) -> Result<Shape> {
    let text = section.required("formula")?;
    let formula: Expression = text.text()?.parse().map_err(|error| text.refuse(format!("{error}")))?;
    let values: BTreeMap<String, Literal> = match section.optional("parameters") {
        None => BTreeMap::new(),
        Some(table) => {
            let section = table.section()?;
            section.entries().map(|(name, value)| Ok((name, value.number()?))).collect::<Result<_>>()?
        }
    };
    formula.bind::<f64>((), &values).map_err(|error| text.refuse(format!("{error}")))?;
    zero_at_the_tip(&text, &formula, &values)?;
    let names: Vec<String> = formula.parameters().collect();
    if let Some(unused) = values.keys().find(|name| !names.contains(name)) {
        return Err(unused_parameter(section, unused, &names));
    }
    let breaks = formula.breaks(&values).map_err(|error| text.refuse(error.to_string()))?;
    Ok(Shape::Expression { formula, values, breaks })
}

/// Refuses a formula with f(0) ≠ 0, decided exactly. Where it is not defined at 0 itself, such as r ln(1 + 1/r), it must fall
/// on the way there.
fn zero_at_the_tip(text: &Value<'_>, formula: &Expression, values: &BTreeMap<String, Literal>) -> Result<()> {
    let precision = Precision::new(128);
    let profile = formula.bind::<Interval>(precision, values).map_err(|error| text.refuse(error.to_string()))?;
    let tip = profile.height(&Interval::from_int(precision, 0));
    if tip.is_finite() {
        if tip.contains_zero() {
            return Ok(());
        }
        let height = tip.approx();
        return Err(
            text.refuse(format!("the profile is not zero at the tip, f(0) = {height}; subtract {height} from it"))
        );
    }
    let [near, nearer] = [-1000, -10_000].map(|k| profile.height(&Interval::from_int(precision, 10).powi(k)).abs());
    if nearer.times(2) < near {
        return Ok(());
    }
    Err(text.refuse("the profile does not tend to 0 at the tip, r → 0; heights are measured from there"))
}

fn unused_parameter(section: &Section<'_>, name: &str, known: &[String]) -> crate::error::Failure {
    let why = match known {
        [] => format!("the formula has no parameter `{name}`; it has none"),
        known => format!("the formula has no parameter `{name}`; it has `{}`", known.join("`, `")),
    };
    section.optional("parameters").map_or_else(|| section.place(), |value: Value<'_>| value.place()).refuse(why)
}
