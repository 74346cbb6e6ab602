//! Scenes: what is pressed, how it is held, and what is wanted, as a TOML file.

mod measured;
mod output;
mod places;
mod profile;
mod reader;

use std::path::Path;

use mdr_core::number::Literal;
use rug::Rational;

pub(crate) use measured::Measured;
pub(crate) use output::{Want, Wanted};
use places::Places;
pub(crate) use places::double;
pub(crate) use profile::{Shape, Slope};
pub(crate) use reader::Place;
use reader::{Document, Section, Value};

use crate::error::Result;
use crate::flags::Arithmetic;

/// Why a scene with a table is answered in hardware arithmetic.
const DOUBLES_OF_TABLES: &str = "measured rows are computed in f64 unless more is asked for: `digits` or \
                                 `arithmetic = \"certified\"` in [output], or --digits";

/// A whole scene, checked as far as text can be checked.
#[derive(Debug)]
pub(crate) struct Scene {
    /// E*, exactly: as given, or of the two bodies. One where there is no material, and nothing wanted depends on it.
    pub(crate) effective_modulus: Literal,
    /// w, likewise.
    pub(crate) work_of_adhesion: Literal,
    /// Whether the scene has a material.
    pub(crate) has_material: bool,
    /// Whether it says how the contact is held.
    pub(crate) has_control: bool,
    pub(crate) profile: Shape,
    pub(crate) held: Held,
    pub(crate) output: Wanted,
    /// How it was read, where that may surprise.
    pub(crate) notes: Vec<String>,
    /// For complaints about the contact.
    pub(crate) places: Places,
}

/// How the contact is held, and moved.
#[derive(Debug)]
pub(crate) struct Held {
    /// The indentation, where the scene does not say.
    pub(crate) by: HeldBy,
    /// Way points of the controlled quantity; empty when there is no path.
    pub(crate) path: Vec<Literal>,
    pub(crate) start: Start,
    /// For complaints about the start; none where the scene does not name it.
    pub(crate) start_place: Option<Place>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum HeldBy {
    Indentation,
    Force,
    Machine { stiffness: Literal },
}

impl HeldBy {
    /// As in a scene.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            HeldBy::Indentation => "indentation",
            HeldBy::Force => "force",
            HeldBy::Machine { .. } => "machine",
        }
    }

    /// The symbol of the controlled quantity.
    pub(crate) fn quantity(&self) -> &'static str {
        match self {
            HeldBy::Indentation => "d",
            HeldBy::Force => "F",
            HeldBy::Machine { .. } => "D = d + F/k",
        }
    }
}

/// The state at the first way point.
#[derive(Debug, PartialEq)]
pub(crate) enum Start {
    /// The stable equilibrium with the largest contact radius.
    Largest,
    /// The one with the smallest.
    Smallest,
    /// The stable equilibrium nearest to this radius.
    Radius(Literal),
    /// Not in contact yet.
    Detached,
}

impl Scene {
    /// Reads the file, or standard input for `-`. An arithmetic `asked` for elsewhere takes precedence.
    ///
    /// # Errors
    /// With file, line and key.
    pub(crate) fn open(path: &Path, asked: Option<Arithmetic>) -> Result<Scene> {
        Scene::read(&Document::open(path)?, asked)
    }

    fn read(document: &Document, asked: Option<Arithmetic>) -> Result<Scene> {
        let table = document.parse()?;
        let top = Section::top(document, &table);
        let moduli = top.optional_section("material")?;
        let given = moduli.as_ref().map(material).transpose()?;
        let shape = top.section("profile")?;
        let before = document.numbers_read();
        let profile = Shape::read(&shape)?;
        let parameters = before..document.numbers_read();
        if let Shape::Table(measured) = &profile {
            measured.require_rising(&shape.place())?;
        }
        let control = top.optional_section("control")?;
        let held = match &control {
            Some(control) => held(control)?,
            None => Held { by: HeldBy::Indentation, path: Vec::new(), start: Start::Largest, start_place: None },
        };
        let outputs = top.section("output");
        top.finish()?;
        let mut output = Wanted::read(&outputs?, &held, given.is_some())?;
        let stated = asked.or(output.stated);
        let place_of = |section: &Option<Section<'_>>, keys: &[&'static str]| {
            section.as_ref().map_or_else(|| top.place(), |section| section.place_of(keys))
        };
        let places = Places {
            modulus: place_of(&moduli, &["e_star", "body"]),
            work: place_of(&moduli, &["work_of_adhesion"]),
            stiffness: place_of(&control, &["stiffness"]),
            control: place_of(&control, &[]),
            profile: shape.place(),
            numbers: document.take_numbers(),
            parameters,
        };
        let mut notes: Vec<String> = profile.tables().into_iter().flat_map(Measured::notes).collect();
        output.arithmetic = stated.unwrap_or(output.arithmetic);
        if stated.is_none() && !profile.tables().is_empty() && places.require_doubles("").is_ok() {
            output.arithmetic = Arithmetic::Double;
            notes.push(DOUBLES_OF_TABLES.to_owned());
        }
        if output.arithmetic == Arithmetic::Double {
            places.require_doubles("ask for certified digits")?;
        }
        let (has_material, has_control) = (given.is_some(), control.is_some());
        let (effective_modulus, work_of_adhesion) = given.unwrap_or_else(|| (1.into(), 1.into()));
        Ok(Scene {
            effective_modulus,
            work_of_adhesion,
            has_material,
            has_control,
            profile,
            held,
            output,
            notes,
            places,
        })
    }
}

fn material(section: &Section<'_>) -> Result<(Literal, Literal)> {
    let work = section.required("work_of_adhesion")?.positive()?;
    let modulus = match section.one_of(&["e_star", "body"])? {
        (0, e_star) => e_star.positive()?,
        (_, list) => {
            let bodies: Vec<Rational> = list.list()?.iter().map(compliance).collect::<Result<_>>()?;
            let [first, second] = <[Rational; 2]>::try_from(bodies)
                .map_err(|bodies| list.refuse(format!("expected two bodies, got {}", bodies.len())))?;
            exactly(&(first + second).recip()).ok_or_else(|| list.refuse("E* has more digits than can be meant"))?
        }
    };
    section.finish()?;
    Ok((modulus, work))
}

/// (1 − ν²)/E of one body (1.3).
fn compliance(value: &Value<'_>) -> Result<Rational> {
    let section = value.section()?;
    let e = section.required("e")?.positive()?;
    let nu = section.required("nu")?;
    let given = nu.number()?;
    let ratio = given.to_rational();
    if !(ratio > -1 && ratio <= 0.5) {
        return Err(nu.refuse(format!("Poisson's ratio must be within (-1, 1/2], got {given}")));
    }
    section.finish()?;
    Ok((Rational::from(1) - ratio.square()) / e.to_rational())
}

/// A rational number as a literal; none for one of absurd length.
pub(crate) fn exactly(value: &Rational) -> Option<Literal> {
    value.to_string().parse().ok()
}

fn held(section: &Section<'_>) -> Result<Held> {
    let kinds = [("indentation", 0), ("force", 1), ("machine", 2)];
    let kind = section.required("kind")?.choice("control", &kinds)?;
    let stiffness = section.optional("stiffness");
    let by = match (kind, stiffness) {
        (2, _) => HeldBy::Machine { stiffness: section.required("stiffness")?.positive()? },
        (_, Some(stiffness)) => return Err(stiffness.refuse("only a machine has a stiffness: kind = \"machine\"")),
        (0, None) => HeldBy::Indentation,
        (_, None) => HeldBy::Force,
    };
    let path = section.optional("path").map_or(Ok(Vec::new()), |path| path.numbers(Value::number))?;
    let start = section.optional("start");
    let start_place = start.as_ref().map(Value::place);
    let start = start.map_or(Ok(Start::Largest), |start| start_of(&start))?;
    section.finish()?;
    Ok(Held { by, path, start, start_place })
}

fn start_of(value: &Value<'_>) -> Result<Start> {
    match value.text() {
        Ok("largest") => Ok(Start::Largest),
        Ok("smallest") => Ok(Start::Smallest),
        Ok("detached") => Ok(Start::Detached),
        _ => value
            .positive()
            .map(Start::Radius)
            .map_err(|_| value.refuse("expected \"largest\", \"smallest\", \"detached\" or a positive contact radius")),
    }
}

#[cfg(test)]
mod tests;
