//! The profiles that a scene can name.

use std::collections::BTreeMap;

#[cfg(feature = "mp")]
use mdr_core::contact::Breaks;
use mdr_core::contact::{Expression, Flank, Shape};
use mdr_core::number::{Exact, Literal};
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;
use mdr_numeric::function::Function;

use super::Location;
use super::measured::Measured;
use super::tip::zero_at_the_tip;
use super::tree::{Section, unknown_name};
use crate::error::Result;

/// A profile f(r).
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Profile {
    /// One of the library, whose g is a closed form.
    Shape(Shape<Literal>),
    /// The sum of several.
    Sum(Vec<Profile>),
    /// A formula, whose g is a quadrature.
    Formula(Formula),
    /// Measured rows, whose g is a sum over them.
    Table(Measured),
    /// A function of a Rust program in f64, whose g is a quadrature. Scenes with one are answered in f64 alone.
    Function(Function),
    /// A wave h₀(1 − cos 2πx/λ) on a periodic medium, which has λ: h₀, in m.
    Wave(Literal),
}

/// A formula for f(r) with the values of its parameters.
#[derive(Clone, Debug)]
pub struct Formula {
    /// As it was written.
    #[cfg(all(feature = "mp", feature = "serde"))]
    pub(crate) text: String,
    pub(crate) expression: Expression,
    pub(crate) parameters: BTreeMap<String, Literal>,
    #[cfg(feature = "mp")]
    pub(crate) breaks: Breaks,
    /// The radii below which doubles of it are [lost](mdr_numeric::transform::lost_below) to terms that cancel.
    #[cfg(feature = "mp")]
    pub(crate) lost: [f64; 4],
}

/// A type that can be the profile of a scene: a [`Profile`], or a [`Shape`] whose parameters are [exact](Exact).
pub trait IntoProfile {
    /// The profile.
    ///
    /// # Errors
    /// A parameter that is no number.
    fn into_profile(self) -> Result<Profile>;
}

impl IntoProfile for Profile {
    fn into_profile(self) -> Result<Profile> {
        Ok(self)
    }
}

impl IntoProfile for Formula {
    fn into_profile(self) -> Result<Profile> {
        Ok(Profile::Formula(self))
    }
}

impl IntoProfile for Measured {
    fn into_profile(self) -> Result<Profile> {
        Ok(Profile::Table(self))
    }
}

impl IntoProfile for Function {
    fn into_profile(self) -> Result<Profile> {
        Ok(Profile::Function(self))
    }
}

impl<X: Exact + Clone> IntoProfile for Shape<X> {
    fn into_profile(self) -> Result<Profile> {
        let exact = |key: &str, number: &X| {
            let place = Location::built(&format!("profile.{key}"));
            let literal = number.clone().exact().map_err(|error| place.refuse(error.to_string()))?;
            // Waves may begin with a trough.
            if key == "amplitude" { Ok(literal) } else { place.require_positive(literal) }
        };
        Ok(Profile::Shape(self.try_map(exact)?))
    }
}

impl Formula {
    /// From a formula such as `"r^2/(2*R) + A*(1 - cos(2*pi*r/L))"`, with f(0) = 0, and its parameters by name.
    ///
    /// # Errors
    /// Where it cannot be read, at which column; a parameter without a value; f(0) ≠ 0.
    pub fn new(text: &str, parameters: BTreeMap<String, Literal>) -> Result<Formula> {
        Formula::with(text, parameters).map_err(|why| Location::built("profile.formula").refuse(why))
    }

    /// Whether it has no `abs`, `min` or `max`, so that its derivatives do not jump.
    pub fn is_smooth(&self) -> bool {
        self.expression.is_smooth()
    }

    fn with(text: &str, parameters: BTreeMap<String, Literal>) -> std::result::Result<Formula, String> {
        let refused = |error: mdr_core::contact::ExpressionError| error.to_string();
        let expression: Expression = text.parse().map_err(refused)?;
        expression.bind::<f64>((), &parameters).map_err(refused)?;
        zero_at_the_tip(&expression, &parameters)?;
        #[cfg(feature = "mp")]
        let breaks = expression.breaks(&parameters).map_err(refused)?;
        #[cfg(not(feature = "mp"))]
        if !expression.is_smooth() {
            return Err(
                "kinks of `abs`, `min` and `max` are isolated with the feature `mp`, which this build is without"
                    .to_owned(),
            );
        }
        #[cfg(feature = "mp")]
        let lost = {
            let doubles = expression.bind::<f64>((), &parameters).map_err(refused)?;
            let enclosures = expression.bind(mdr_core::number::Precision::new(256), &parameters).map_err(refused)?;
            mdr_numeric::transform::lost_below(&doubles, &enclosures)
        };
        Ok(Formula {
            #[cfg(all(feature = "mp", feature = "serde"))]
            text: text.to_owned(),
            expression,
            parameters,
            #[cfg(feature = "mp")]
            breaks,
            #[cfg(feature = "mp")]
            lost,
        })
    }
}

impl Profile {
    /// The name of the kind in a scene.
    pub fn name(&self) -> &'static str {
        match self {
            Profile::Shape(shape) => shape.name(),
            Profile::Sum(_) => "sum",
            Profile::Formula(_) => "expression",
            Profile::Table(_) => "table",
            Profile::Function(_) => "function",
            Profile::Wave(_) => "wave",
        }
    }

    /// n and C where the profile is a power law f = C rⁿ with rational constants. `number` takes a parameter to its arithmetic,
    /// and `coefficient` the radius R of a paraboloid to C = 1/2R.
    pub(crate) fn power_law<N>(
        &self,
        number: impl Fn(&Literal) -> N,
        coefficient: impl FnOnce(N) -> N,
    ) -> Option<[N; 2]> {
        let Profile::Shape(shape) = self else { return None };
        Some(match shape {
            Shape::Power { n, c } => [number(n), number(c)],
            Shape::Cone { flank: Flank::Slope(slope) } => [number(&Literal::from(1)), number(slope)],
            Shape::Paraboloid { radius } => [number(&Literal::from(2)), coefficient(number(radius))],
            _ => return None,
        })
    }

    /// n and C of a power law, exactly, from the numbers in an arithmetic; `None` for another profile, and for numbers of absurd
    /// length.
    #[cfg(feature = "mp")]
    pub(crate) fn exact_power_law(&self, number: impl Fn(&Literal) -> rug::Rational) -> Option<[Literal; 2]> {
        let [n, c] = self.power_law(number, |radius| (radius * 2u32).recip())?;
        Some([super::exactly(&n)?, super::exactly(&c)?])
    }

    /// Whether g is a closed form; otherwise it is a quadrature or measured.
    pub(crate) fn is_closed(&self) -> bool {
        match self {
            Profile::Shape(_) | Profile::Wave(_) => true,
            Profile::Sum(terms) => terms.iter().all(Profile::is_closed),
            Profile::Formula(_) | Profile::Table(_) | Profile::Function(_) => false,
        }
    }

    /// Whether g can be enclosed: a closed form, rigorous integrals of a formula, or a sum of these.
    pub(crate) fn is_enclosed(&self) -> bool {
        match self {
            Profile::Shape(_) | Profile::Formula(_) | Profile::Wave(_) => true,
            Profile::Sum(terms) => terms.iter().all(Profile::is_enclosed),
            Profile::Table(_) | Profile::Function(_) => false,
        }
    }

    /// Whether it is a function of a program, or a sum with one.
    pub(crate) fn has_function(&self) -> bool {
        match self {
            Profile::Sum(terms) => terms.iter().any(Profile::has_function),
            other => matches!(other, Profile::Function(_)),
        }
    }

    /// The terms of a sum, or the profile itself.
    #[cfg(feature = "mp")]
    pub(crate) fn terms(&self) -> Vec<&Profile> {
        match self {
            Profile::Sum(terms) => terms.iter().flat_map(Profile::terms).collect(),
            one => vec![one],
        }
    }

    /// Whether it is a formula, or a sum with one.
    pub fn has_formula(&self) -> bool {
        match self {
            Profile::Sum(terms) => terms.iter().any(Profile::has_formula),
            Profile::Formula(_) => true,
            Profile::Shape(_) | Profile::Table(_) | Profile::Function(_) | Profile::Wave(_) => false,
        }
    }

    /// The rows of a table, or of all tables in a sum whose other terms can be enclosed.
    pub fn rows(&self) -> Option<usize> {
        match self {
            Profile::Table(measured) => Some(measured.table.rows().len()),
            Profile::Sum(terms) if terms.iter().all(|term| term.is_enclosed() || term.rows().is_some()) => {
                terms.iter().filter_map(Profile::rows).reduce(|sum, rows| sum + rows)
            }
            _ => None,
        }
    }

    /// The tables in it.
    pub fn tables(&self) -> Vec<&Measured> {
        match self {
            Profile::Sum(terms) => terms.iter().flat_map(Profile::tables).collect(),
            Profile::Table(measured) => vec![measured],
            _ => Vec::new(),
        }
    }

    /// The profile with other tables; `None` if one of them cannot be made.
    pub fn with_tables(&self, change: &impl Fn(&Measured) -> Option<Measured>) -> Option<Profile> {
        Some(match self {
            Profile::Sum(terms) => {
                Profile::Sum(terms.iter().map(|term| term.with_tables(change)).collect::<Option<_>>()?)
            }
            Profile::Table(measured) => Profile::Table(change(measured)?),
            other => other.clone(),
        })
    }

    /// Its numbers, with the keys they have in a scene.
    pub fn numbers(&self) -> Vec<(Literal, Location)> {
        let at = |(key, number): (&str, &Literal)| (number.clone(), Location::built(&format!("profile.{key}")));
        match self {
            Profile::Shape(shape) => shape.parameters().into_iter().map(at).collect(),
            Profile::Sum(terms) => terms.iter().flat_map(Profile::numbers).collect(),
            Profile::Formula(formula) => {
                formula.parameters.iter().map(|(name, number)| at((&format!("parameters.{name}"), number))).collect()
            }
            Profile::Table(_) | Profile::Function(_) => Vec::new(),
            Profile::Wave(amplitude) => vec![at(("amplitude", amplitude))],
        }
    }

    /// The units of its numbers, in the order of [`Profile::numbers`].
    pub fn units(&self) -> Vec<SiUnit> {
        match self {
            Profile::Shape(shape) => shape.units().into_iter().map(|(_, unit)| unit).collect(),
            Profile::Sum(terms) => terms.iter().flat_map(Profile::units).collect(),
            Profile::Formula(formula) => formula.parameters.keys().map(|_| SiUnit::Unstated).collect(),
            Profile::Table(_) | Profile::Function(_) => Vec::new(),
            Profile::Wave(_) => vec![SiUnit::Metre],
        }
    }

    /// The profile with other numbers, in the order of [`Profile::numbers`]; numbers that are not given stay.
    pub fn with_numbers(&self, numbers: &mut impl Iterator<Item = Literal>) -> Profile {
        match self {
            Profile::Shape(shape) => {
                Profile::Shape(shape.map(|_, number| numbers.next().unwrap_or_else(|| number.clone())))
            }
            Profile::Sum(terms) => Profile::Sum(terms.iter().map(|term| term.with_numbers(numbers)).collect()),
            Profile::Formula(formula) => {
                let mut formula = formula.clone();
                formula.parameters.values_mut().zip(numbers).for_each(|(number, other)| *number = other);
                Profile::Formula(formula)
            }
            Profile::Table(_) | Profile::Function(_) => self.clone(),
            Profile::Wave(amplitude) => Profile::Wave(numbers.next().unwrap_or_else(|| amplitude.clone())),
        }
    }

    /// Reads the table `[profile]` of a document.
    ///
    /// # Errors
    /// A kind that is none, a key that is missing or unknown, a number out of its domain, with their places.
    pub fn read(section: &Section<'_>) -> Result<Profile> {
        /// The kinds that are no shapes of the library.
        const OTHERS: [&str; 4] = ["sum", "expression", "table", "wave"];
        let kind = section.required("kind")?;
        let profile = match (kind.text()?, Shape::by_name(kind.text()?)) {
            (_, Some(blank)) => shape(section, blank.clone())?,
            ("sum", None) => sum(section)?,
            ("expression", None) => formula(section)?,
            ("table", None) => Profile::Table(Measured::read(section)?),
            ("wave", None) => Profile::Wave(section.required("amplitude")?.positive(SiUnit::Metre)?),
            (other, None) => {
                let known: Vec<&str> = Shape::names().chain(OTHERS).collect();
                return Err(kind.refuse(unknown_name("profile", other, &known)));
            }
        };
        section.finish()?;
        Ok(profile)
    }
}

/// A shape of the library; all parameters but an amplitude are positive.
fn shape(section: &Section<'_>, mut blank: Shape<()>) -> Result<Profile> {
    if let Some(flank) = blank.flank_mut()
        && section.one_of(&["slope", "half_angle_degrees"])?.0 == 1
    {
        *flank = Flank::HalfAngleDegrees(());
    }
    let shape = blank.try_map(|key, ()| {
        let (value, unit) = (section.required(key)?, blank.unit_of(key));
        let number = if key == "amplitude" { value.number(unit) } else { value.positive(unit) }?;
        if key == "half_angle_degrees" && number.compare(&Literal::from(90)).is_ge() {
            return Err(value.refuse(format!("must be below 90 degrees, got {}", excerpt(&number.to_string()))));
        }
        Ok(number)
    })?;
    Ok(Profile::Shape(shape))
}

/// The most terms of a sum.
const MOST_TERMS: usize = 1000;

fn sum(section: &Section<'_>) -> Result<Profile> {
    let list = section.required("term")?;
    let terms: Vec<Profile> = list
        .list_of(MOST_TERMS, "add up terms of one kind")?
        .iter()
        .map(|term| Profile::read(&term.section()?))
        .collect::<Result<_>>()?;
    if terms.is_empty() {
        return Err(list.refuse("a sum needs at least one [[profile.term]]"));
    }
    Ok(Profile::Sum(terms))
}

fn formula(section: &Section<'_>) -> Result<Profile> {
    let text = section.required("formula")?;
    let parameters: BTreeMap<String, Literal> = match section.optional("parameters") {
        None => BTreeMap::new(),
        Some(table) => {
            let section = table.section()?;
            section.entries().map(|(name, value)| Ok((name, value.number(SiUnit::Unstated)?))).collect::<Result<_>>()?
        }
    };
    let formula = Formula::with(text.text()?, parameters).map_err(|why| text.refuse(why))?;
    let names: Vec<String> = formula.expression.parameters().collect();
    if let Some(unused) = formula.parameters.keys().find(|name| !names.contains(name)) {
        let known = if names.is_empty() {
            "none".to_owned()
        } else {
            excerpt(&format!("`{}`", names.join("`, `"))).to_string()
        };
        let place = section.optional("parameters").map_or_else(|| section.place(), |value| value.place());
        return Err(place.refuse(format!("the formula has no parameter `{}`; it has {known}", excerpt(unused))));
    }
    Ok(Profile::Formula(formula))
}
