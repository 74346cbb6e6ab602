//! Reading a scene: its tables `[profile]`, `[material]`, `[control]` and `[output]`.

use std::cmp::Ordering;
use std::io;
use std::path::Path;

use mdr_core::contact::{Body, Control};
use mdr_core::number::Literal;

use super::place::{Location, Places};
use super::profile::Profile;
use super::tree::{Document, Files, Node, Section, Value};
use super::want::{Arithmetic, DEFAULT_DIGITS, MAX_DIGITS, POINTS, Want};
use super::{Measured, Scene, Start, material, parse};
use crate::answer::OutputKind;
use crate::error::{Error, Result};

/// Why a scene with a table is answered in hardware arithmetic.
const DOUBLES_OF_TABLES: &str = "measured rows are computed in f64 unless more is asked for: `digits` or \
                                 `arithmetic = \"certified\"` in [output], or --digits";

impl Scene {
    /// Reads a `.toml` or `.json` file; tables of measured rows are read from files beside it.
    ///
    /// # Errors
    /// With file, line and key.
    pub fn open(file: impl AsRef<Path>) -> Result<Scene> {
        let path = file.as_ref();
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|source| Error::Io { name: name.clone(), source })?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let files = |file: &str| std::fs::read(folder.join(file));
        match path.extension() {
            #[cfg(feature = "serde")]
            Some(extension) if extension.eq_ignore_ascii_case("json") => Scene::from_json(&text, &name, &files),
            _ => Scene::from_toml(&text, &name, &files),
        }
    }

    /// Reads a scene as TOML. `name` stands in complaints; `files` reads what the scene names.
    ///
    /// # Errors
    /// With name, line and key.
    #[cfg(feature = "toml")]
    pub fn from_toml(text: &str, name: &str, files: Files<'_>) -> Result<Scene> {
        let document = Document::new(name, text, "TOML", files);
        let root = parse::toml(&document)?;
        read(&document, &root)
    }

    /// Without the feature `toml` no TOML is read.
    ///
    /// # Errors
    /// Always.
    #[cfg(not(feature = "toml"))]
    pub fn from_toml(_: &str, name: &str, _: Files<'_>) -> Result<Scene> {
        let source = io::Error::new(io::ErrorKind::Unsupported, "this build is without the feature `toml`");
        Err(Error::Io { name: name.to_owned(), source })
    }

    /// Reads a scene as JSON, with the keys of a TOML scene.
    ///
    /// # Errors
    /// As [`Scene::from_toml`].
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
        let document = Document::new(name, text, "JSON", files);
        let root = parse::json(&document)?;
        read(&document, &root)
    }

    /// The same with an arithmetic that takes precedence over that of the file.
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

fn read(document: &Document<'_>, root: &Node) -> Result<Scene> {
    let top = Section::top(document, root)?;
    let moduli = top.optional_section("material")?;
    let given = moduli.as_ref().map(material_of).transpose()?;
    let shape = top.section("profile")?;
    let before = document.numbers_read();
    let profile = Profile::read(&shape)?;
    let parameters = before..document.numbers_read();
    if let Profile::Table(measured) = &profile {
        measured.require_rising(&shape.place())?;
    }
    let control = top.optional_section("control")?;
    let held = control.as_ref().map(control_of).transpose()?;
    let outputs = top.section("output");
    top.finish()?;
    let (held, start_place) = held.unwrap_or_else(|| (Held::default(), None));
    let wanted = Wanted::read(&outputs?, &held, given.as_ref())?;
    let place_of = |section: &Option<Section<'_>>, keys: &[&'static str]| {
        section.as_ref().map_or_else(|| top.place(), |section| section.place_of(keys))
    };
    let places = Places {
        modulus: place_of(&moduli, &["e_star", "body"]),
        work: place_of(&moduli, &["work_of_adhesion"]),
        stiffness: place_of(&control, &["stiffness"]),
        control: place_of(&control, &[]),
        start: start_place.clone(),
        want: wanted.place,
        range: wanted.range_place.unwrap_or_else(|| top.place()),
        profile: shape.place(),
        numbers: document.take_numbers(),
        parameters,
    };
    let mut notes: Vec<String> = profile.tables().into_iter().flat_map(Measured::notes).collect();
    let mut arithmetic = wanted.stated.unwrap_or_default();
    if wanted.stated.is_none() && !profile.tables().is_empty() && places.require_doubles("").is_ok() {
        arithmetic = Arithmetic::Double;
        notes.push(DOUBLES_OF_TABLES.to_owned());
    }
    let (has_material, has_control) = (given.is_some(), control.is_some());
    let (effective_modulus, work_of_adhesion, range_of_adhesion) = given.unwrap_or_else(|| (1.into(), 1.into(), None));
    let Held { control, path, start } = held;
    let mut keys = wanted.keys;
    keys.extend((!path.is_empty()).then_some("[control] path"));
    keys.extend(start_place.map(|_| "[control] start"));
    Ok(Scene {
        effective_modulus,
        work_of_adhesion,
        range_of_adhesion: range_of_adhesion.or(wanted.range_of_adhesion),
        has_material,
        has_control,
        profile,
        control,
        path,
        start,
        wants: wanted.wants,
        values: wanted.values,
        range: wanted.range,
        arithmetic,
        notes,
        given: keys,
        places,
    })
}

/// E*, w and the range of adhesion.
type Contacting = (Literal, Literal, Option<Literal>);

/// The table `[material]`.
fn material_of(section: &Section<'_>) -> Result<Contacting> {
    let work = section.required("work_of_adhesion")?.positive()?;
    let modulus = match section.one_of(&["e_star", "body"])? {
        (0, e_star) => e_star.positive()?,
        (_, list) => {
            let bodies: Vec<Body<Literal>> = list.list()?.iter().map(body).collect::<Result<_>>()?;
            let bodies = <[Body<Literal>; 2]>::try_from(bodies)
                .map_err(|bodies| list.refuse(format!("expected two bodies, got {}", bodies.len())))?;
            material::combined(&bodies).ok_or_else(|| list.refuse("E* has more digits than can be meant"))?
        }
    };
    let range = section.optional("range_of_adhesion").map(|range| range.positive_length()).transpose()?;
    section.finish()?;
    Ok((modulus, work, range))
}

fn body(value: &Value<'_>) -> Result<Body<Literal>> {
    let section = value.section()?;
    let youngs_modulus = section.required("e")?.positive()?;
    let nu = section.required("nu")?;
    let poissons_ratio = nu.number()?;
    if let Some(why) = material::refused_ratio(&poissons_ratio) {
        return Err(nu.refuse(why));
    }
    section.finish()?;
    Ok(Body { youngs_modulus, poissons_ratio })
}

/// The table `[control]`.
struct Held {
    control: Control<Literal>,
    path: Vec<Literal>,
    start: Start,
}

impl Default for Held {
    fn default() -> Self {
        Held { control: Control::Indentation, path: Vec::new(), start: Start::Largest }
    }
}

/// With the place of `start`, where it is given.
fn control_of(section: &Section<'_>) -> Result<(Held, Option<Location>)> {
    let kinds = [("indentation", 0), ("force", 1), ("machine", 2)];
    let kind = section.required("kind")?.choice("control", &kinds)?;
    let control = match (kind, section.optional("stiffness")) {
        (2, _) => Control::Machine { stiffness: section.required("stiffness")?.positive()? },
        (_, Some(stiffness)) => return Err(stiffness.refuse("only a machine has a stiffness: kind = \"machine\"")),
        (0, None) => Control::Indentation,
        (_, None) => Control::Force,
    };
    let path = section.optional("path").map_or(Ok(Vec::new()), |path| path.numbers(Value::number))?;
    let start = section.optional("start");
    let place = start.as_ref().map(Value::place);
    let start = start.map_or(Ok(Start::Largest), |start| start_of(&start))?;
    section.finish()?;
    Ok((Held { control, path, start }, place))
}

fn start_of(value: &Value<'_>) -> Result<Start> {
    match value.text() {
        Ok("largest") => Ok(Start::Largest),
        Ok("smallest") => Ok(Start::Smallest),
        Ok("detached") => Ok(Start::Detached),
        _ => value
            .positive()
            .map(Start::Nearest)
            .map_err(|_| value.refuse("expected \"largest\", \"smallest\", \"detached\" or a positive contact radius")),
    }
}

/// The table `[output]`.
struct Wanted {
    wants: Vec<Want>,
    values: Vec<Literal>,
    range: Option<[Literal; 2]>,
    stated: Option<Arithmetic>,
    /// The keys that are given, of those that may be of no use.
    keys: Vec<&'static str>,
    place: Location,
    range_place: Option<Location>,
    range_of_adhesion: Option<Literal>,
}

impl Wanted {
    fn read(section: &Section<'_>, held: &Held, material: Option<&Contacting>) -> Result<Wanted> {
        let has_material = material.is_some();
        let list = section.required("want")?;
        let kinds = kinds(&list)?;
        let stated = arithmetic(section)?;
        let transform = at(section, "transform", Value::positive)?;
        let values = at(section, "equilibria", Value::number)?;
        let curve = at(section, "curve", Value::positive)?;
        let pressure = at(section, "pressure", Value::not_negative)?;
        let gap = at(section, "gap", Value::positive)?;
        let displacement = at(section, "displacement", Value::positive)?;
        let (range, range_place) = range(section)?.unzip();
        let points = section.optional("points").map(|points| points.whole(2, 1_000_000)).transpose()?;
        let given = [
            ("[output.transform]", !transform.is_empty()),
            ("[output.equilibria]", !values.is_empty()),
            ("[output.curve]", !curve.is_empty()),
            ("[output.pressure]", !pressure.is_empty()),
            ("[output.gap]", !gap.is_empty()),
            ("[output.displacement]", !displacement.is_empty()),
            ("[output.folds] range", range.is_some()),
            ("[output] points", points.is_some()),
        ];
        let states = || values.clone();
        let want = |kind: &OutputKind| match kind {
            OutputKind::Transform => Want::Transform { at: transform.clone() },
            OutputKind::Equilibria => Want::Equilibria { at: states() },
            OutputKind::Folds => Want::Folds { range: range.clone() },
            OutputKind::Path => Want::Path,
            OutputKind::Curve => Want::Curve { at: curve.clone() },
            OutputKind::Pressure => Want::Pressure { states: states(), at: pressure.clone() },
            OutputKind::Gap => Want::Gap { states: states(), at: gap.clone() },
            OutputKind::Displacement => Want::Displacement { states: states(), at: displacement.clone() },
            OutputKind::Energy => Want::Energy { states: states() },
            OutputKind::ForceCurve => Want::ForceCurve { points: points.unwrap_or(POINTS) },
        };
        let wants: Vec<Want> = kinds.iter().map(want).collect();
        for want in &wants {
            if let Some(missing) = want.missing(has_material, &held.path) {
                return Err(list.refuse(format!("`{}` needs {missing}", want.name())));
            }
        }
        let range_of_adhesion = section.optional("range_of_adhesion");
        match (&range_of_adhesion, material) {
            (Some(range), None) => return Err(range.refuse("needs a material: [material] e_star, work_of_adhesion")),
            (Some(range), Some((.., Some(_)))) => return Err(range.refuse("is given in [material], too")),
            _ => {}
        }
        let range_of_adhesion = range_of_adhesion.map(|range| range.positive_length()).transpose()?;
        section.finish()?;
        let keys = given.into_iter().filter_map(|(key, is_given)| is_given.then_some(key)).collect();
        Ok(Wanted { wants, values, range, stated, keys, place: list.place(), range_place, range_of_adhesion })
    }
}

fn kinds(list: &Value<'_>) -> Result<Vec<OutputKind>> {
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
            arithmetic.choice("arithmetic", &[("f64", Arithmetic::Double), ("certified", certified)]).map(Some)
        }
        (None, None) => Ok(None),
    }
}

/// The list `at` of a sub-table of `[output]`.
fn at<'a>(section: &Section<'a>, key: &'static str, read: fn(&Value<'a>) -> Result<Literal>) -> Result<Vec<Literal>> {
    let Some(value) = section.optional(key) else {
        return Ok(Vec::new());
    };
    let inner = value.section()?;
    let list = inner.required("at")?.numbers(read);
    inner.finish()?;
    list
}

/// The key `range` of [output.folds], with its place.
fn range(section: &Section<'_>) -> Result<Option<([Literal; 2], Location)>> {
    let Some(value) = section.optional("folds") else {
        return Ok(None);
    };
    let inner = value.section()?;
    let list = inner.required("range")?;
    let ends = list.numbers(Value::positive)?;
    inner.finish()?;
    let [lower, upper] = <[Literal; 2]>::try_from(ends)
        .map_err(|ends| list.refuse(format!("expected two contact radii, got {}", ends.len())))?;
    if lower.compare(&upper) != Ordering::Less {
        return Err(list.refuse(format!("the range must ascend, got {lower} to {upper}")));
    }
    Ok(Some(([lower, upper], list.place())))
}
