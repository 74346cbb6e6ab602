//! Reading a scene: its tables `[profile]`, `[medium]`, `[material]`, `[control]` and `[output]`.

use std::io;
use std::path::Path;

use mdr_core::contact::{Body, Control, ControlKind};
use mdr_core::number::Literal;
use mdr_core::units::SiUnit;

use super::medium::ExactMedium;
use super::place::Places;
use super::profile::Profile;
use super::tree::{Files, InputValue, Section};
use super::want::{Arithmetic, DEFAULT_DIGITS, MAX_DIGITS, MOST_WAY_POINTS};
use super::{Scene, Start, material, parse};
use crate::answer::OutputKind;
use crate::error::Result;
use crate::outputs::key::Keys;

/// Why a scene with a table is answered in hardware arithmetic.
const DOUBLES_OF_TABLES: &str = "measured rows are computed in f64 unless more is asked for: `digits` or \
                                 `arithmetic = \"certified\"` in [output], or --digits";

impl Scene {
    /// Reads a `.toml` or `.json` file; tables of measured rows are read from files beside it.
    ///
    /// # Errors
    /// With file, line and key.
    pub fn open(file: impl AsRef<Path>) -> Result<Scene> {
        parse::open(file.as_ref(), read)
    }

    /// Reads a scene as TOML. `name` stands in complaints; `files` reads what the scene names.
    ///
    /// # Errors
    /// With name, line and key.
    pub fn from_toml(text: &str, name: &str, files: Files<'_>) -> Result<Scene> {
        parse::toml(text, name, files, read)
    }

    /// Reads a scene as JSON, with the keys of a TOML scene.
    ///
    /// # Errors
    /// A text that is no JSON or is nested too deep; a key or a number that is refused, with file, line and key.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let scene = r#"{"profile": {"kind": "cone", "slope": "1/10"}, "material": {"e_star": 1e6, "work_of_adhesion": 0.05},
    ///                 "output": {"want": ["folds"], "arithmetic": "f64"}}"#;
    /// let answer = Scene::from_json(scene, "cone.json", &mdr::no_files)?.solve()?;
    /// assert_eq!(answer.folds().expect("wanted").items.len(), 1);
    /// # Ok::<(), mdr::Error>(())
    /// ```
    #[cfg(feature = "serde")]
    pub fn from_json(text: &str, name: &str, files: Files<'_>) -> Result<Scene> {
        parse::json(text, name, files, read)
    }

    /// The scene with an arithmetic that takes precedence over that of the file.
    #[must_use]
    pub fn in_arithmetic(mut self, asked: Option<Arithmetic>) -> Self {
        if let Some(arithmetic) = asked {
            self.arithmetic = arithmetic;
            self.notes.retain(|note| note != DOUBLES_OF_TABLES);
        }
        self
    }
}

/// Reads no files: for scenes without tables of measured rows.
///
/// # Errors
/// Always [`NotFound`](io::ErrorKind::NotFound).
pub fn no_files(file: &str) -> io::Result<Vec<u8>> {
    Err(io::Error::new(io::ErrorKind::NotFound, format!("no file {file} is at hand")))
}

fn read(top: &Section<'_>) -> Result<Scene> {
    let numbers = &top.document.numbers;
    let pressed = top.optional_section("medium")?;
    let medium = pressed.as_ref().map(ExactMedium::read).transpose()?.unwrap_or_default();
    let moduli = top.optional_section("material")?;
    let material_of = |section: &Section<'_>| material_of(section, &medium);
    let (modulus, work, range, works) = moduli.as_ref().map_or(Ok((1.into(), 1.into(), None, None)), material_of)?;
    let shape = top.section("profile")?;
    let before = numbers.borrow().len();
    let profile = Profile::read(&shape)?;
    let parameters = before..numbers.borrow().len();
    if let Profile::Table(measured) = &profile {
        measured.require_rising(&shape.place())?;
    }
    let places = Places { read: vec![("profile", shape.place())], numbers: Vec::new(), parameters };
    let mut scene = Scene::blank(profile, modulus, work, places).on(medium);
    (scene.has_material, scene.range_of_adhesion, scene.works) = (moduli.is_some(), range, works);
    let read = &mut scene.places.read;
    if let Some(section) = &moduli {
        read.push(("material.e_star", section.place_of(&["e_star", "body"])));
        read.push(("material.work_of_adhesion", section.place_of(&["work_of_adhesion"])));
    }
    if let Some(section) = &pressed {
        read.push(("medium", section.place()));
    }
    if let Some(section) = &top.optional_section("control")? {
        scene.take_control(section)?;
    }
    let outputs = top.section("output");
    top.finish()?;
    let stated = scene.take_output(&outputs?)?;
    scene.places.numbers = numbers.take();
    scene.check_medium()?;
    let tables = scene.profile.tables();
    scene.notes.extend(tables.iter().flat_map(|table| table.notes()));
    if let Some(arithmetic) = stated {
        scene.arithmetic = arithmetic;
    } else if !tables.is_empty() && scene.places.require_doubles("").is_ok() {
        scene.arithmetic = Arithmetic::F64;
        scene.notes.push(DOUBLES_OF_TABLES.to_owned());
    }
    Ok(scene)
}

/// One work of adhesion, or two: w₂, and both if they differ.
fn works_of(value: &InputValue<'_>) -> Result<(Literal, Works)> {
    if !value.is_table() {
        return Ok((value.positive(SiUnit::JoulePerSquareMetre)?, None));
    }
    let section = value.section()?;
    let (advancing, receding) = (section.required("advancing")?, section.required("receding")?);
    let work = receding.positive(SiUnit::JoulePerSquareMetre)?;
    let works = material::works(advancing.number(SiUnit::JoulePerSquareMetre)?, work.clone(), &advancing.place())?;
    section.finish()?;
    Ok((work, works))
}

/// w₁ and w₂ if they differ.
type Works = Option<Box<[Literal; 2]>>;

/// The table `[material]`: E*, w or w₂, the range of adhesion, and both works of adhesion if there are two.
fn material_of(section: &Section<'_>, medium: &ExactMedium) -> Result<(Literal, Literal, Option<Literal>, Works)> {
    let (work, works) = works_of(&section.required("work_of_adhesion")?)?;
    let given = section.optional("e_star").is_some() || section.optional("body").is_some();
    let modulus = match section.one_of(&["e_star", "body"]) {
        // The medium has its own.
        Err(_) if !given && !medium.needs_modulus() => 1.into(),
        found => modulus_of(found?)?,
    };
    let range = section.optional("range_of_adhesion").map(|range| range.positive(SiUnit::Metre)).transpose()?;
    section.finish()?;
    Ok((modulus, work, range, works))
}

/// E* by one of its keys.
fn modulus_of(given: (usize, InputValue<'_>)) -> Result<Literal> {
    Ok(match given {
        (0, e_star) => e_star.positive(SiUnit::Pascal)?,
        (_, list) => {
            let bodies: Vec<Body<Literal>> = list.list()?.iter().map(body).collect::<Result<_>>()?;
            let bodies = <[Body<Literal>; 2]>::try_from(bodies)
                .map_err(|bodies| list.refuse(format!("expected two bodies, got {}", bodies.len())))?;
            material::combined(&bodies).ok_or_else(|| list.refuse("E* has more digits than can be meant"))?
        }
    })
}

/// A table with `e` and `nu`.
pub(super) fn body(value: &InputValue<'_>) -> Result<Body<Literal>> {
    let section = value.section()?;
    let youngs_modulus = section.required("e")?.positive(SiUnit::Pascal)?;
    let nu = section.required("nu")?;
    let poissons_ratio = nu.number(SiUnit::One)?;
    if let Some(why) = material::refused_ratio(&poissons_ratio) {
        return Err(nu.refuse(why));
    }
    section.finish()?;
    Ok(Body { youngs_modulus, poissons_ratio })
}

fn start_of(value: &InputValue<'_>) -> Result<Start> {
    match value.text() {
        Ok("largest") => Ok(Start::Largest),
        Ok("smallest") => Ok(Start::Smallest),
        Ok("detached") => Ok(Start::Detached),
        _ => value.positive(SiUnit::Metre).map(Start::Nearest).map_err(|_| {
            let expected = "expected \"largest\", \"smallest\", \"detached\" or a positive contact radius";
            value.refused_unit(SiUnit::Metre).unwrap_or_else(|| value.refuse(expected))
        }),
    }
}

/// What shortens a path.
pub(super) const FEWER_WAY_POINTS: &str = "leave out those on the way to others, or follow it in parts with `start`";

impl Scene {
    /// The table `[control]`.
    fn take_control(&mut self, section: &Section<'_>) -> Result<()> {
        let kind = section.required("kind")?.choice("control", &ControlKind::ALL.map(|kind| (kind.name(), kind)))?;
        self.control = match (kind, section.optional("stiffness")) {
            (ControlKind::Machine, _) => Control::Machine {
                stiffness: section.required("stiffness")?.positive(self.medium.unit_of_stiffness())?,
            },
            (_, Some(stiffness)) => return Err(stiffness.refuse("only a machine has a stiffness: kind = \"machine\"")),
            (ControlKind::Indentation, None) => Control::Indentation,
            (ControlKind::Force, None) => Control::Force,
        };
        self.has_control = true;
        if let Some(path) = section.optional("path") {
            self.places.read.push(("control.path", path.place()));
            let points = path.list_of(MOST_WAY_POINTS, FEWER_WAY_POINTS)?;
            self.path = points.iter().map(|point| point.number(self.medium.unit_of(kind))).collect::<Result<_>>()?;
            self.given.extend((!self.path.is_empty()).then(|| "[control] path".to_owned()));
        }
        if let Some(start) = section.optional("start") {
            self.start = start_of(&start)?;
            self.given.push("[control] start".to_owned());
            self.places.read.push(("control.start", start.place()));
        }
        section.finish()?;
        let stiffness = ("control.stiffness", section.place_of(&["stiffness"]));
        self.places.read.extend([stiffness, ("control", section.place())]);
        Ok(())
    }

    /// The table `[output]`, and the arithmetic where it names one.
    fn take_output(&mut self, section: &Section<'_>) -> Result<Option<Arithmetic>> {
        let list = section.required("want")?;
        self.places.read.push(("output.want", list.place()));
        let kinds = kinds(&list)?;
        let stated = arithmetic(section)?;
        let mut keys = Keys::read(section, self.medium.unit_of(self.control.kind()))?;
        self.given.append(&mut keys.given);
        self.wants = kinds.into_iter().map(|kind| kind.question(&keys)).collect();
        if let Some((range, place)) = keys.range {
            self.range = Some(range);
            self.places.read.push(("output.folds.range", place));
        }
        self.values = keys.values;
        self.energies = section
            .optional("energies")
            .map(|energies| energies.choice("answer", &[("yes", true), ("no", false)]))
            .transpose()?;
        self.check_needs()?;
        if let Some(range) = section.optional("range_of_adhesion") {
            match &self.range_of_adhesion {
                _ if !self.has_material => {
                    return Err(range.refuse("needs a material: [material] e_star, work_of_adhesion"));
                }
                Some(_) => return Err(range.refuse("is given in [material], too")),
                None => self.range_of_adhesion = Some(range.positive(SiUnit::Metre)?),
            }
        }
        section.finish()?;
        Ok(stated)
    }
}

fn kinds(list: &InputValue<'_>) -> Result<Vec<OutputKind>> {
    let mut kinds = Vec::new();
    for value in list.list()? {
        let kind = value.choice("output", &OutputKind::ALL.map(|kind| (kind.name(), kind)))?;
        if kinds.contains(&kind) {
            return Err(value.refuse(format!("`{}` is wanted twice", kind.name())));
        }
        kinds.push(kind);
    }
    if kinds.is_empty() {
        let all = OutputKind::ALL.map(OutputKind::name).join("`, `");
        return Err(list.refuse(format!("nothing is wanted; there are `{all}`")));
    }
    Ok(kinds)
}

fn arithmetic(section: &Section<'_>) -> Result<Option<Arithmetic>> {
    match (section.optional("digits"), section.optional("arithmetic")) {
        (Some(_), Some(arithmetic)) => Err(arithmetic.refuse("cannot be given together with `digits`")),
        (Some(digits), None) => Ok(Some(Arithmetic::Certified { digits: digits.whole(1, MAX_DIGITS)? })),
        (None, Some(arithmetic)) => {
            let certified = Arithmetic::Certified { digits: DEFAULT_DIGITS };
            arithmetic.choice("arithmetic", &[("f64", Arithmetic::F64), ("certified", certified)]).map(Some)
        }
        (None, None) => Ok(None),
    }
}
