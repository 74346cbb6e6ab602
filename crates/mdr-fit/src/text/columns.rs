//! Which columns of a text are x, y, the leg and standard deviations: by name, by number, by unit, or the first two.

use mdr_core::text::excerpt;

use super::CurveColumn;
use super::layout::{Heading, Layout, is_unit, power};
use crate::data::Columns;

/// The columns of a table, and what a file of a fit says of them.
pub(super) struct Choice<'c> {
    headings: Option<&'c [Heading]>,
    /// Of each column.
    units: Vec<Option<String>>,
    stated: Option<&'c [String; 2]>,
    bases: [&'c str; 2],
}

impl<'c> Choice<'c> {
    /// Units of the columns: from the header or from the row of units.
    ///
    /// # Errors
    /// A header and a row of units that contradict each other.
    pub(super) fn new(layout: &'c Layout, columns: &'c Columns, bases: [&'c str; 2]) -> Result<Self, String> {
        let headings = layout.headings.as_deref();
        let row = layout.units.as_deref().unwrap_or_default();
        let count = headings.map_or(0, <[Heading]>::len).max(row.len());
        let mut units = Vec::with_capacity(count);
        for place in 0..count {
            let below = row.get(place).filter(|unit| !unit.is_empty());
            let beside = headings.and_then(|headings| headings.get(place)?.unit.as_ref());
            if let (Some(below), Some(beside)) = (below, beside)
                && bases.iter().any(|base| power(below, base) != power(beside, base))
            {
                let [beside, below] = [beside, below].map(|unit| excerpt(unit));
                return Err(format!(
                    "column {} is in `{beside}` by its name and in `{below}` by the row of units",
                    place + 1
                ));
            }
            units.push(below.or(beside).cloned());
        }
        Ok(Choice { headings, units, stated: columns.units.as_ref(), bases })
    }

    /// The places of x and y: as they are asked for, the first two, or where the first two are of other units the only ones in the
    /// units of the observation.
    ///
    /// # Errors
    /// A name that the header lacks or has twice; several columns that it may be.
    pub(super) fn pair(&self, columns: &Columns) -> Result<[usize; 2], String> {
        let asked = |name: &Option<String>| name.as_ref().map(|name| self.named(name)).transpose();
        match [asked(&columns.x)?, asked(&columns.y)?] {
            [Some(x), Some(y)] => Ok([x, y]),
            [x, y] => {
                let first = [x.unwrap_or(0), y.unwrap_or(1)];
                let fits = |axis: usize| self.is_of(first[axis], self.bases[axis]);
                let has_units = self.stated.is_none() && self.units.iter().any(Option::is_some);
                if first[0] == first[1] && !has_units {
                    return Err(format!("x and y are both column {}: name both in `columns`", first[0] + 1));
                }
                if !has_units || first[0] != first[1] && fits(0) && fits(1) {
                    self.check_twice(first, [x, y])?;
                    return Ok(first);
                }
                self.by_units(x, y)
            }
        }
    }

    /// Refuses a column that was not asked for and has the name of another one.
    fn check_twice(&self, places: [usize; 2], asked: [Option<usize>; 2]) -> Result<(), String> {
        for axis in 0..2 {
            let heading = self.headings.and_then(|headings| headings.get(places[axis]));
            if let (None, Some(heading)) = (asked[axis], heading) {
                let alike = self.all(|_, other| !other.name.is_empty() && other.name == heading.name);
                if alike.len() > 1 {
                    return Err(self.ambiguous(&heading.name, &alike));
                }
            }
        }
        Ok(())
    }

    /// The columns in the units of X and Y, where there is one of each.
    fn by_units(&self, x: Option<usize>, y: Option<usize>) -> Result<[usize; 2], String> {
        let of = |base: &str, taken: Option<usize>| -> Vec<usize> {
            (0..self.units.len()).filter(|place| Some(*place) != taken && self.is_of(*place, base)).collect()
        };
        let one = |axis: usize, given: Option<usize>, other: Option<usize>| match given {
            Some(place) => Ok(place),
            None => match of(self.bases[axis], other).as_slice() {
                [one] => Ok(*one),
                [] => Err(self.no_unit(axis)),
                several => Err(self.ambiguous(self.bases[axis], several)),
            },
        };
        if self.bases[0] == self.bases[1] && x.is_none() && y.is_none() {
            return match of(self.bases[0], None).as_slice() {
                [x, y] => Ok([*x, *y]),
                [] | [_] => Err(self.no_unit(1)),
                several => Err(self.ambiguous(self.bases[0], several)),
            };
        }
        Ok([one(0, x, y)?, one(1, y, x)?])
    }

    /// The complaint that no column is in the unit of X or Y.
    fn no_unit(&self, axis: usize) -> String {
        let what = if self.bases[axis] == "N" { "force" } else { "length" };
        let own = self.units.get(axis).and_then(Option::as_deref);
        match own.filter(|unit| power(unit, self.bases[axis]).is_none()) {
            Some(unit) => format!(
                "`{}` is no unit of {what}, and no other column is in one: units are those of the header or of the row after it",
                excerpt(unit)
            ),
            None => format!("no column is in a unit of {what}, which {} must be", ["x", "y"][axis]),
        }
    }

    /// The place of a column by its name, its name and unit, its unit, or its number.
    ///
    /// # Errors
    /// No such column, or several.
    pub(super) fn named(&self, name: &str) -> Result<usize, String> {
        let wanted = Heading::of(name);
        let same = |one: &Heading| one.name == wanted.name && alike(one.unit.as_deref(), wanted.unit.as_deref());
        let number = || name.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
        let ways = [
            self.all(|_, heading| heading.whole == name),
            self.all(|place, heading| match wanted.unit {
                None => heading.name == wanted.name,
                Some(_) => {
                    same(heading) || heading.name == wanted.name && alike(self.unit(place), wanted.unit.as_deref())
                }
            }),
            (0..self.units.len()).filter(|place| is_unit(name) && alike(self.unit(*place), Some(name))).collect(),
        ];
        match ways.iter().find(|found| !found.is_empty()).map(Vec::as_slice) {
            Some([one]) => Ok(*one),
            Some(several) => Err(self.ambiguous(name, several)),
            None => match (number(), self.headings) {
                (Some(place), _) => Ok(place),
                (None, None) => Err(format!("there is no header that names the column `{}`", excerpt(name))),
                (None, Some(headings)) => {
                    let known: Vec<&str> = headings.iter().map(|heading| heading.name.as_str()).collect();
                    Err(mdr::reading::unknown_name_of_input("column", name, &known))
                }
            },
        }
    }

    fn all(&self, is: impl Fn(usize, &Heading) -> bool) -> Vec<usize> {
        let headings = self.headings.unwrap_or_default().iter().enumerate();
        headings.filter(|(place, heading)| is(*place, heading)).map(|(place, _)| place).collect()
    }

    /// The complaint about several columns of one name or unit.
    fn ambiguous(&self, name: &str, places: &[usize]) -> String {
        let listed: Vec<String> =
            places.iter().map(|place| format!("{} (`{}`)", place + 1, self.title(*place))).collect();
        format!(
            "`{}` is ambiguous, since several columns are it: {}; choose by name or by number, such as columns = {{ x = \"{}\", y = … }}",
            excerpt(name),
            excerpt(&listed.join(", ")),
            places[0] + 1
        )
    }

    /// The name of a column, with its unit where it has one.
    fn title(&self, place: usize) -> String {
        let heading = self.headings.and_then(|headings| headings.get(place));
        let name = heading.map_or("", |heading| heading.name.as_str());
        match self.unit(place) {
            Some(unit) => format!("{name} [{unit}]").trim().to_owned(),
            None => name.to_owned(),
        }
    }

    pub(super) fn unit(&self, place: usize) -> Option<&str> {
        self.units.get(place)?.as_deref()
    }

    fn is_of(&self, place: usize, base: &str) -> bool {
        self.unit(place).is_some_and(|unit| power(unit, base).is_some())
    }

    /// A column that holds numbers in the unit of an axis, for the answer.
    ///
    /// # Errors
    /// No unit, or one of another quantity.
    pub(super) fn column(&self, place: usize, axis: usize) -> Result<CurveColumn, String> {
        let stated = self.stated.map(|units| units[axis].as_str());
        let Some(unit) = stated.or_else(|| self.unit(place)) else {
            return Err(format!(
                "no units: the row after the header must name them, such as `{}`, or the header, such as `z [nm]`, or `units` in [data]",
                self.bases.join(",")
            ));
        };
        if power(unit, self.bases[axis]).is_none() {
            let what = if self.bases[axis] == "N" { "force" } else { "length" };
            return Err(format!("`{}` is no unit of {what}", excerpt(unit)));
        }
        Ok(CurveColumn { unit: Some(unit.trim().to_owned()), ..self.bare(place) })
    }

    /// A column without its unit, for the answer.
    pub(super) fn bare(&self, place: usize) -> CurveColumn {
        let name = self.headings.and_then(|headings| headings.get(place)).map(|heading| heading.name.clone());
        CurveColumn { number: place + 1, name, unit: None }
    }

    /// Columns of the unit of an axis that were neither asked for nor taken.
    pub(super) fn others(&self, columns: &Columns, places: [usize; 2]) -> Option<String> {
        if self.stated.is_some() || columns.x.is_some() && columns.y.is_some() {
            return None;
        }
        let is_other =
            |place: &usize| !places.contains(place) && self.bases.iter().any(|base| self.is_of(*place, base));
        let other = (0..self.units.len()).find(is_other)?;
        Some(format!(
            "x and y are the columns {} and {}; the file has others in the same units, such as `{}`: choose with `columns`",
            places[0] + 1,
            places[1] + 1,
            excerpt(&self.title(other))
        ))
    }
}

/// Whether two units are one: `um`, `µm` and `[um]`.
fn alike(one: Option<&str>, other: Option<&str>) -> bool {
    let powers = |unit: &str| ["m", "N"].map(|base| power(unit, base));
    match (one, other) {
        (Some(one), Some(other)) => one == other || is_unit(one) && powers(one) == powers(other),
        (one, other) => one == other,
    }
}
