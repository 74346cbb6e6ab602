//! Reading a fit: the tables `[profile]`, `[material]`, `[control]`, `[data]`, `[fit]`, `[events]` and `[output]`.

use std::path::Path;

use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use super::data::{self, Columns};
use super::observation::{Leg, Loss, Observation};
use super::problem::{DataRow, Problem, WORK};
use super::text::{self, Record};
use mdr::files;
use mdr::reading::Location;
use mdr::reading::{self, InputValue, Section};
use mdr::scene::ExactMedium;
use mdr::scene::Files;
use mdr::scene::{MAX_DIGITS, Profile};
use mdr::{Error, Result};

impl Problem {
    /// Reads a `.toml` or `.json` file; the data are read from a file beside it, or are in it.
    ///
    /// # Errors
    /// A file that cannot be read, or is no fit, with file, line and key.
    pub fn open(file: impl AsRef<Path>) -> Result<Problem> {
        reading::open(file.as_ref(), |top| read(top, None))
    }

    /// Reads a fit like [`Problem::open`], with another curve in place of its data.
    ///
    /// # Errors
    /// A file that cannot be read, or is no fit, with file, line and key.
    pub fn open_for(file: impl AsRef<Path>, curve: impl AsRef<Path>) -> Result<Problem> {
        Problem::opener(file)?(curve.as_ref())
    }

    /// A function that opens a fit for one curve after the other. The fit is read once, so that it may be a pipe; so may each
    /// curve.
    ///
    /// # Errors
    /// A fit that cannot be read. For each curve: a file that cannot be read, or is no fit, with file, line and key.
    pub fn opener(file: impl AsRef<Path>) -> Result<impl Fn(&Path) -> Result<Problem> + Sync> {
        let source = reading::Source::open(file.as_ref())?;
        Ok(move |curve: &Path| {
            let name = curve.display().to_string();
            let bytes = files::argument(curve).map_err(|source| Error::Io { name: name.clone(), source })?;
            source.read(|top| read(top, Some(Curve::File { name: &name, bytes: &bytes })))
        })
    }

    /// Reads a fit as TOML. `name` stands in complaints; `files` reads the files that the fit names.
    ///
    /// # Errors
    /// A text that is no fit, with name, line and key.
    pub fn from_toml(text: &str, name: &str, files: Files<'_>) -> Result<Problem> {
        reading::toml(text, name, files, |top| read(top, None))
    }

    /// Reads a fit as JSON, with the keys of a TOML file.
    ///
    /// # Errors
    /// A text that is no fit, with name, line and key.
    #[cfg(feature = "serde")]
    pub fn from_json(text: &str, name: &str, files: Files<'_>) -> Result<Problem> {
        reading::json(text, name, files, |top| read(top, None))
    }

    /// Reads a fit as JSON, as [`Problem::from_json`] does, of rows that are at hand, in SI units: `[data]` names neither rows nor a file.
    /// The legs are those of the rows, or end where x turns. Rows with NaN are skipped where `missing` says so.
    ///
    /// # Errors
    /// A text that is no fit, with name, line and key; columns that are not of one length.
    #[cfg(feature = "serde")]
    pub fn from_json_with_rows(
        text: &str,
        name: &str,
        files: Files<'_>,
        [x, y]: [&[f64]; 2],
        legs: Option<&[Leg]>,
    ) -> Result<Problem> {
        reading::json(text, name, files, |top| read(top, Some(Curve::Rows { x, y, legs })))
    }
}

/// The largest number of a column.
const MOST_COLUMNS: u32 = 100_000;

/// A curve in place of the data of a fit.
#[derive(Clone, Copy)]
enum Curve<'c> {
    /// A file, with its name.
    File { name: &'c str, bytes: &'c [u8] },
    /// Rows in SI units.
    #[cfg(feature = "serde")]
    Rows { x: &'c [f64], y: &'c [f64], legs: Option<&'c [Leg]> },
}

fn read(top: &Section<'_>, curve: Option<Curve<'_>>) -> Result<Problem> {
    let medium = top.optional_section("medium")?;
    let shape = top.section("profile")?;
    let profile = Profile::read(&shape)?;
    if let Profile::Table(measured) = &profile {
        measured.require_rising(&shape.place())?;
    }
    let data = top.section("data")?;
    let observation = data.required("observation")?.choice("observation", &Observation::NAMES)?;
    let pressed = medium.as_ref().map(ExactMedium::read).transpose()?.unwrap_or_default();
    let (mask, saturation) = (data.optional("rows").filter(InputValue::is_table), data.optional("saturation"));
    let (record, sigma) = rows_of(&data, observation.units_on(&pressed), curve, mask.is_some())?;
    let times = times(&data, &record)?;
    let mut problem = Problem::with(profile, observation, record.rows, data.place())?;
    if let Some(section) = &medium {
        problem = problem.medium(pressed).map_err(|error| at(error, section.place()))?;
    }
    (problem.sigma, problem.read) = (sigma, record.text);
    problem.selection.missing = record.missing.len();
    if let Some(times) = times {
        problem = problem.times(&times)?;
    }
    problem = picked(problem, &data, mask)?;
    if let Some(ends) = saturation {
        let range = pair(&ends, data::si_unit(problem.units()[1]))?;
        problem = problem.saturation(range).map_err(|error| at(error, ends.place()))?;
    }
    data.finish()?;
    if let Some(material) = top.optional_section("material")? {
        let known =
            if problem.has_modulus_of_medium() { &["work_of_adhesion"][..] } else { &["e_star", "work_of_adhesion"] };
        for key in known {
            if let Some(value) = material.optional(key) {
                if value.is_table() {
                    problem = each(problem, Some(value), WORK, Problem::fixed)?;
                    continue;
                }
                let number = number(&value, problem.unit_of(key))?;
                problem = problem.fixed(key, number).map_err(|error| at(error, value.place()))?;
            }
        }
        material.finish()?;
    }
    problem = control(problem, top.optional_section("control")?)?;
    let fit = top.section("fit")?;
    problem = picked(problem, &fit, fit.optional("rows"))?;
    problem = unknowns(problem, &fit)?;
    if let Some(events) = top.optional_section("events")? {
        let unit = data::si_unit(problem.units()[0]);
        let [place, sigma] = [number(&events.required("pull_off")?, unit)?, number(&events.required("sigma")?, unit)?];
        problem = problem.pull_off(place, sigma).map_err(|error| at(error, events.place()))?;
        events.finish()?;
    }
    if let Some(output) = top.optional_section("output")? {
        problem.digits = output.optional("digits").map(|digits| digits.whole(1, MAX_DIGITS)).transpose()?;
        if let Some(intervals) = output.optional("intervals") {
            problem.profile_likelihood =
                intervals.choice("intervals", &[("standard-errors", false), ("profile-likelihood", true)])?;
        }
        let range = output.optional("range_of_adhesion").map(|range| range.positive(SiUnit::Metre)).transpose()?;
        problem.range_of_adhesion = range.map(|range| range.nearest_f64());
        output.finish()?;
    }
    top.finish()?;
    Ok(problem)
}

/// The keys of `[data]`, or of `[fit]`, that say which rows count: `legs`, and `rows` where it is a table.
fn picked(mut problem: Problem, section: &Section<'_>, rows: Option<InputValue<'_>>) -> Result<Problem> {
    let units = problem.units().map(data::si_unit);
    if let Some(legs) = section.optional("legs") {
        let one = |leg: Leg| (leg.name(), Some(leg));
        if let Some(leg) = legs.choice("legs", &[("both", None), one(Leg::Approach), one(Leg::Retract)])? {
            problem = problem.only(leg);
        }
    }
    if let Some(rows) = rows {
        let table = rows.section()?;
        let mut within = [None; 2];
        for ((key, unit), within) in ["x", "y"].into_iter().zip(units).zip(&mut within) {
            *within = table.optional(key).map(|ends| pair(&ends, unit)).transpose()?;
        }
        table.finish()?;
        problem = problem.within(within[0], within[1]).map_err(|error| at(error, rows.place()))?;
    }
    Ok(problem)
}

/// Two numbers.
fn pair(value: &InputValue<'_>, unit: SiUnit) -> Result<[f64; 2]> {
    let ends: Vec<f64> = value.list()?.iter().map(|end| number(end, unit)).collect::<Result<_>>()?;
    <[f64; 2]>::try_from(ends).map_err(|ends| value.refuse(format!("expected two numbers, got {}", ends.len())))
}

/// The time of each row that has numbers: of a column, or of a list.
fn times(data: &Section<'_>, record: &Record) -> Result<Option<Vec<f64>>> {
    let Some(value) = data.optional("time") else {
        return Ok(record.has_times.then(|| record.rows.iter().map(|row| row.time).collect()));
    };
    let list = value.list_of(data::MOST_ROWS, data::FEWER_ROWS)?;
    let list: Vec<f64> = list.iter().map(|time| number(time, SiUnit::One)).collect::<Result<_>>()?;
    let count = record.rows.len() + record.missing.len();
    if list.len() != count {
        return Err(value.refuse(format!("{} times are given for {count} rows", list.len())));
    }
    let kept = list.into_iter().enumerate().filter(|(index, _)| record.missing.binary_search(index).is_err());
    Ok(Some(kept.map(|(_, time)| time).collect()))
}

/// The table `[data]`: rows in a file beside it, or of the `curve` instead, or in it; and their standard deviations.
fn rows_of(
    data: &Section<'_>,
    bases: [&'static str; 2],
    curve: Option<Curve<'_>>,
    has_mask: bool,
) -> Result<(Record, [Option<f64>; 2])> {
    let mut columns = Columns::default();
    if let Some(value) = data.optional("columns") {
        let names = value.section()?;
        let name = |key| {
            let name = |value: InputValue<'_>| match value.whole(1, MOST_COLUMNS) {
                Ok(number) => Ok(number.to_string()),
                Err(_) => value.text().map(str::to_owned),
            };
            names.optional(key).map(name).transpose()
        };
        (columns.x, columns.y, columns.leg, columns.time) = (name("x")?, name("y")?, name("leg")?, name("time")?);
        names.finish()?;
    }
    if let Some(missing) = data.optional("missing") {
        columns.skips_missing = missing.choice("missing", &[("refuse", false), ("skip", true)])?;
    }
    columns.units = data.optional("units").map(|units| pair_of_units(&units)).transpose()?;
    let mut sigma = [None; 2];
    if let Some(value) = data.optional("sigma") {
        let section = value.section()?;
        for (axis, key) in ["x", "y"].into_iter().enumerate() {
            let Some(value) = section.optional(key) else { continue };
            match value.text().ok().filter(|text| text.starts_with(|c: char| c.is_alphabetic())) {
                Some(name) => columns.sigma[axis] = Some(name.to_owned()),
                None => sigma[axis] = Some(value.not_negative(data::si_unit(bases[axis]))?.nearest_f64()),
            }
        }
        section.finish()?;
        // Zero says that nothing is known of it; σ_X = 0 asks for vertical distances.
        sigma[1] = sigma[1].filter(|sigma| *sigma > 0.0);
    }
    #[cfg(feature = "serde")]
    if let Some(Curve::Rows { x, y, legs }) = curve {
        require_no_names(data, &columns)?;
        let (rows, missing) = at_hand([x, y], legs, columns.skips_missing)?;
        return Ok((Record { rows, text: None, missing, has_times: false }, sigma));
    }
    let (which, value) = if has_mask { data.one_of(&["file", "x"])? } else { data.one_of(&["file", "rows", "x"])? };
    if which != 0 {
        require_no_names(data, &columns)?;
    }
    let (rows, missing) = match (which, has_mask) {
        (0, _) => {
            let record = match curve {
                Some(Curve::File { name, bytes }) => text::read(bytes, &columns, bases)
                    .map_err(|why| value.refuse(format!("{}: {why}", excerpt(name))))?,
                _ => text::read(&value.bytes(value.text()?)?, &columns, bases)
                    .map_err(|why| value.refuse_file(value.text().unwrap_or_default(), &why))?,
            };
            return Ok((record, sigma));
        }
        (1, false) => inline(&value, &columns, bases)?,
        _ => {
            let list = |value: &InputValue<'_>, axis: usize| -> Result<Vec<f64>> {
                let list = value.list_of(data::MOST_ROWS, data::FEWER_ROWS)?;
                list.iter().map(|item| in_si(item, &columns, axis, bases)).collect()
            };
            (data::rows(&list(&value, 0)?, &list(&data.required("y")?, 1)?, None)?, Vec::new())
        }
    };
    Ok((Record { rows, text: None, missing, has_times: false }, sigma))
}

/// Rows at hand, and the indices of those without numbers, where these are skipped.
#[cfg(feature = "serde")]
fn at_hand([x, y]: [&[f64]; 2], legs: Option<&[Leg]>, skips_missing: bool) -> Result<(Vec<DataRow>, Vec<usize>)> {
    let refuse = |why: String| Err(Location::built("data").refuse(why));
    if x.len() > data::MOST_ROWS {
        return refuse(format!("{} rows are more than {}: {}", x.len(), data::MOST_ROWS, data::FEWER_ROWS));
    }
    if let Some(legs) = legs.filter(|legs| legs.len() != x.len()) {
        return refuse(format!("{} legs are given for {} rows", legs.len(), x.len()));
    }
    let is_missing = |index: &usize| skips_missing && !(x[*index].is_finite() && y[*index].is_finite());
    let missing: Vec<usize> = (0..x.len().min(y.len())).filter(is_missing).collect();
    if missing.is_empty() {
        return Ok((data::rows(x, y, legs)?, missing));
    }
    let kept = |index: &usize| missing.binary_search(index).is_err();
    let of = |column: &[f64]| (0..column.len()).filter(kept).map(|index| column[index]).collect::<Vec<f64>>();
    let legs: Option<Vec<Leg>> = legs.map(|legs| (0..legs.len()).filter(kept).map(|index| legs[index]).collect());
    Ok((data::rows(&of(x), &of(y), legs.as_deref())?, missing))
}

/// Rows that are no file have no columns, so that a name tells nothing: it would be passed over in silence.
fn require_no_names(data: &Section<'_>, columns: &Columns) -> Result<()> {
    let Columns { x, y, leg, time, sigma, .. } = columns;
    let keys = [
        ("columns", x.as_ref().or(y.as_ref()).or(leg.as_ref()).or(time.as_ref())),
        ("sigma", sigma[0].as_ref().or(sigma[1].as_ref())),
    ];
    for (key, name) in keys {
        if let (Some(value), Some(name)) = (data.optional(key), name) {
            let name = excerpt(name);
            return Err(value
                .refuse(format!("names a column, {name}, and rows that are not in a file have none: give numbers")));
        }
    }
    Ok(())
}

/// Rows `[[x, y], …]`, or with their leg `[x, y, "approach"]`.
fn inline(value: &InputValue<'_>, columns: &Columns, bases: [&str; 2]) -> Result<(Vec<DataRow>, Vec<usize>)> {
    let (mut points, mut legs, mut missing) = (Vec::new(), Vec::new(), Vec::new());
    for row in value.list_of(data::MOST_ROWS, data::FEWER_ROWS)? {
        let items = row.list()?;
        let [x, y, rest @ ..] = items.as_slice() else {
            return Err(row.refuse(format!("a row is [x, y], got {} numbers", items.len())));
        };
        let is_missing = |value: &InputValue<'_>| value.text().is_ok_and(data::is_no_number);
        if columns.skips_missing && (is_missing(x) || is_missing(y)) {
            missing.push(points.len() + missing.len());
            continue;
        }
        points.push([in_si(x, columns, 0, bases)?, in_si(y, columns, 1, bases)?]);
        if let [leg] = rest {
            legs.push(Leg::named(leg.text()?).ok_or_else(|| leg.refuse("a leg is `approach` or `retract`"))?);
        }
    }
    let axis = |axis: usize| points.iter().map(|point| point[axis]).collect::<Vec<f64>>();
    let rows = data::rows(&axis(0), &axis(1), Some(legs.as_slice()).filter(|legs| legs.len() == points.len()))?;
    Ok((rows, missing))
}

/// A number of the data, in SI.
fn in_si(value: &InputValue<'_>, columns: &Columns, axis: usize, bases: [&str; 2]) -> Result<f64> {
    let si = || value.row_number(data::si_unit(bases[axis])).map(|literal| literal.nearest_f64());
    match (&columns.units, value.row_number(SiUnit::One)) {
        // A unit of its own counts more than that of the column.
        (None, _) | (Some(_), Err(_)) => si(),
        (Some(units), Ok(literal)) => data::si(&literal.to_string(), &units[axis], bases[axis])
            .ok_or_else(|| value.refuse(format!("`{}` is no unit of it", excerpt(&units[axis])))),
    }
}

/// `units = ["nm", "nN"]` or `units = { x = "nm", y = "nN" }`.
fn pair_of_units(value: &InputValue<'_>) -> Result<[String; 2]> {
    if let Ok(section) = value.section() {
        let pair = [section.required("x")?.text()?.to_owned(), section.required("y")?.text()?.to_owned()];
        section.finish()?;
        return Ok(pair);
    }
    let units: Vec<String> = value.list()?.iter().map(|unit| unit.text().map(str::to_owned)).collect::<Result<_>>()?;
    <[String; 2]>::try_from(units).map_err(|units| value.refuse(format!("expected two units, got {}", units.len())))
}

/// The table `[control]`, which has the stiffness of the machine.
fn control(problem: Problem, section: Option<Section<'_>>) -> Result<Problem> {
    let Some(section) = section else { return Ok(problem) };
    let kinds = [("indentation", false), ("force", false), ("machine", true)];
    let has_machine = match section.optional("kind") {
        Some(kind) => kind.choice("control", &kinds)?,
        None => problem.observation().has_machine(),
    };
    let stiffness = section.optional("stiffness");
    section.finish()?;
    match stiffness {
        Some(stiffness) if has_machine && problem.observation().has_machine() => {
            let value = stiffness.positive(SiUnit::NewtonPerMetre)?.nearest_f64();
            problem.fixed("stiffness", value)
        }
        Some(stiffness) => {
            let name = problem.observation().name();
            Err(stiffness.refuse(format!("only a machine has a stiffness: `{name}` is not seen through one")))
        }
        None => Ok(problem),
    }
}

/// The table `[fit]`.
fn unknowns(mut problem: Problem, section: &Section<'_>) -> Result<Problem> {
    let free = section.required("free")?;
    for name in free.list()? {
        problem = problem.free([name.text()?]).map_err(|error| at(error, name.place()))?;
    }
    problem = each(problem, section.optional("fixed"), "", Problem::fixed)?;
    problem = each(problem, section.optional("start"), "", Problem::start)?;
    if let Some(priors) = section.optional("prior") {
        for (name, value) in priors.section()?.entries() {
            let (prior, unit) = (value.section()?, problem.unit_of(&name));
            let [mean, sd] = [number(&prior.required("mean")?, unit)?, number(&prior.required("sd")?, unit)?];
            prior.finish()?;
            problem = problem.prior(&name, mean, sd).map_err(|error| at(error, value.place()))?;
        }
    }
    if let Some(bounds) = section.optional("bounds") {
        for (name, value) in bounds.section()?.entries() {
            let ends = pair(&value, problem.unit_of(&name))?;
            problem = problem.bounds(&name, ends).map_err(|error| at(error, value.place()))?;
        }
    }
    if let Some(loss) = section.optional("loss") {
        let losses = [("least-squares", Loss::LeastSquares), ("huber", Loss::Huber)];
        problem = problem.loss(loss.choice("loss", &losses)?);
    }
    section.finish()?;
    Ok(problem)
}

/// A number for each name of a table; two for `work_of_adhesion` where it is a table itself. The names have this prefix.
fn each(
    mut problem: Problem,
    table: Option<InputValue<'_>>,
    prefix: &str,
    set: fn(Problem, &str, f64) -> Result<Problem>,
) -> Result<Problem> {
    let Some(table) = table else { return Ok(problem) };
    for (name, value) in table.section()?.entries() {
        let name = format!("{prefix}{name}");
        if name == "work_of_adhesion" && value.is_table() {
            problem = each(problem, Some(value), WORK, set)?;
            continue;
        }
        let number = number(&value, problem.unit_of(&name))?;
        problem = set(problem, &name, number).map_err(|error| at(error, value.place()))?;
    }
    Ok(problem)
}

fn number(value: &InputValue<'_>, unit: SiUnit) -> Result<f64> {
    Ok(value.number(unit)?.nearest_f64())
}

/// Moves a complaint to a place.
fn at(error: Error, place: Location) -> Error {
    match error {
        Error::Scene { why, .. } => place.refuse(why),
        error => error,
    }
}
