//! Measured profiles: the rows of a file, the zero of their heights, and the length over which they are smoothed.

use mdr_core::number::Literal;
use mdr_core::units::SiUnit;
use mdr_numeric::table::{Table, TableError};

use super::place::Location;
use super::tree::{InputValue, Section};
use crate::error::{Error, Result};

/// Measured rows of radius and height, with the zero of their heights and the length over which they are smoothed.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The table with which the contact is computed.
    pub(crate) table: Table,
    /// The rows as they are, with heights from the tip.
    raw: Table,
    /// As they stand in the file.
    pub(crate) file: Table,
    smoothing: Option<Smoothing>,
}

/// How rows were smoothed.
#[derive(Clone, Copy, Debug)]
struct Smoothing {
    length: f64,
    /// The height of the smooth tip among the rows.
    tip: f64,
}

impl Measured {
    /// From CSV with the columns radius and height, in metres or in the units of a header, with f = 0 at r = 0.
    ///
    /// # Errors
    /// A row that cannot be read, and its line; heights that do not begin at a tip.
    pub fn from_csv(csv: &str) -> Result<Measured> {
        let refuse = |why: String| Location::built("profile.file").refuse(why);
        let table = Table::from_csv(csv.as_bytes()).map_err(|error| refuse(error.to_string()))?;
        let measured = Measured::as_given(table.clone(), table);
        measured.require_rising(&Location::built("profile.file"))?;
        measured.checked(refuse)
    }

    /// From radii and heights in metres, with f = 0 at r = 0.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let tip = Measured::from_rows(&[0.0, 1e-8, 2e-8, 3e-8], &[0.0, 5e-9, 2e-8, 4.5e-8])?;
    /// let scene = Scene::new(Profile::Table(tip), Elasticity::effective("1e9")?, "0.05")?;
    /// assert!(Measured::from_rows(&[0.0, 1e-8], &[0.0]).is_err());
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// Slices of different lengths; a number that is not finite, with its index; a row that is not accepted, with its line, which
    /// is the index of the row plus one; heights that do not begin at a tip.
    pub fn from_rows(radii: &[f64], heights: &[f64]) -> Result<Measured> {
        let refuse = |why: String| Err(Location::built("profile.file").refuse(why));
        if radii.len() != heights.len() {
            return refuse(format!("as many heights as radii are needed, got {} and {}", heights.len(), radii.len()));
        }
        let mut csv = String::with_capacity(40 * radii.len());
        for (index, (radius, height)) in radii.iter().zip(heights).enumerate() {
            if !(radius.is_finite() && height.is_finite()) {
                return refuse(format!("row {index} must be finite, got {radius}, {height}"));
            }
            csv.push_str(&format!("{radius:e},{height:e}\n"));
        }
        Measured::from_csv(&csv)
    }

    fn as_given(raw: Table, file: Table) -> Self {
        Measured { table: raw.clone(), raw, file, smoothing: None }
    }

    /// Rejects a table with a slope between rows that is no double.
    fn checked(self, refuse: impl FnOnce(String) -> Error) -> Result<Self> {
        match too_steep(&self.table) {
            Some(line) => Err(refuse(format!("line {line}: the slope from the row before is out of the range of f64"))),
            None => Ok(self),
        }
    }

    pub(super) fn read(section: &Section<'_>) -> Result<Measured> {
        let file = section.required("file")?;
        if let Some(columns) = section.optional("columns")
            && columns.text()? != "r,f"
        {
            return Err(columns.refuse("the columns of a table are \"r,f\": radius, height"));
        }
        let name = file.text()?;
        let refuse = |why: &dyn std::fmt::Display| file.refuse_file(name, why);
        let table = Table::from_csv_above_any_zero(file.bytes(name)?.as_slice()).map_err(|error| refuse(&error))?;
        let offset = section.optional("offset").map(|value| value.number(SiUnit::Metre)).transpose()?;
        let smooth = section.optional("smooth");
        if let (Some(smooth), Some(_)) = (&smooth, &offset) {
            return Err(
                smooth.refuse("cannot be given together with `offset`: smoothed heights count from their own tip")
            );
        }
        let measured = match (&smooth, &offset) {
            (Some(smooth), _) => Measured::from_smooth_tip(table, smooth)?,
            (None, Some(offset)) => {
                let raw = lowered(&table, offset);
                if raw.rows()[0].radius.is_zero() {
                    raw.check_tip().map_err(|error| refuse(&error))?;
                }
                Measured::as_given(raw, table)
            }
            (None, None) => {
                table.check_tip().map_err(|error| refuse(&with_remedy(&error, &table)))?;
                Measured::as_given(table.clone(), table)
            }
        };
        measured.checked(|why| refuse(&why))
    }

    fn from_smooth_tip(file: Table, smooth: &InputValue<'_>) -> Result<Measured> {
        let length = smooth.positive(SiUnit::Metre)?.nearest_f64();
        let (table, tip) = file.smoothed(length).map_err(|error| smooth.refuse(error.to_string()))?;
        let first = &file.rows()[0];
        let zero = if first.radius.is_zero() { Ok(first.height.clone()) } else { Literal::try_from(tip) };
        let raw = zero.map_or_else(|_| file.clone(), |zero| lowered(&file, &zero));
        Ok(Measured { table, raw, file, smoothing: Some(Smoothing { length, tip }) })
    }

    /// The mean distance of the rows of the file, in m.
    pub fn spacing(&self) -> f64 {
        let rows = self.file.rows();
        rows.last().map_or(0.0, |row| row.radius.nearest_f64()) / rows.len() as f64
    }

    /// The length that it is smoothed over.
    pub fn length(&self) -> Option<f64> {
        self.smoothing.map(|smoothing| smoothing.length)
    }

    /// The rows smoothed over another length, or as they are.
    pub fn smoothed(&self, length: Option<f64>) -> Option<Measured> {
        let table = match length {
            Some(length) => self.file.smoothed(length).ok()?.0,
            None => self.raw.clone(),
        };
        Some(Measured { table, ..self.clone() })
    }

    /// Refuses heights that are measured the wrong way.
    ///
    /// # Errors
    /// Heights that fall outward from the tip.
    pub fn require_rising(&self, place: &Location) -> Result<()> {
        if !self.table.falls_outward() {
            return Ok(());
        }
        let last = self.file.rows().last().map_or(0, |row| row.line);
        Err(place.refuse(format!(
            "the heights of the table fall outward from the tip, to the lowest on line {last}, so that nothing there can touch \
             first at the tip; f counts from the tip towards the body and grows outward: change the sign of every f"
        )))
    }

    /// How it was read.
    pub(super) fn notes(&self) -> Vec<String> {
        let units = self.file.units().map(|[r, f]| {
            format!(
                "the table has r in {r} and f in {f}, which were converted to metres; all other numbers are taken as SI"
            )
        });
        let smoothed = self.smoothing.map(|Smoothing { length, tip }| {
            format!(
                "the table is smoothed over {length:e} m by local regression, and its heights count from its smooth tip, \
                 which is at {tip:.3e} m among the rows"
            )
        });
        units.into_iter().chain(smoothed).collect()
    }
}

/// The rows with heights above another zero: exactly, or in doubles in a build without the feature `mp`.
fn lowered(table: &Table, zero: &Literal) -> Table {
    #[cfg(feature = "mp")]
    let difference = |height: &Literal| super::exactly(&(height.to_rational() - zero.to_rational()));
    #[cfg(not(feature = "mp"))]
    let difference = |height: &Literal| Literal::try_from(height.nearest_f64() - zero.nearest_f64()).ok();
    table.with_heights(table.rows().iter().map(|row| difference(&row.height).unwrap_or_else(|| row.height.clone())))
}

/// The fault of the tip, and the key that mends it.
fn with_remedy(error: &TableError, table: &Table) -> String {
    let unit = table.units().map_or_else(String::new, |[_, f]| format!(" {f}"));
    match error {
        TableError::TipNotZero { height, .. } => format!("{error}, or say offset = \"{height}{unit}\" in [profile]"),
        TableError::TipElsewhere { tip, .. } => format!(
            "{error}, or say it in [profile]: offset = \"{tip}{unit}\"; offset = \"0\" takes the heights as they are"
        ),
        error => error.to_string(),
    }
}

/// The line of the first row to which the slope from the row before, or from the tip, is no double.
fn too_steep(table: &Table) -> Option<usize> {
    let mut last = [0.0, 0.0];
    for row in table.rows() {
        let next = [&row.radius, &row.height].map(Literal::nearest_f64);
        let slope = (next[1] - last[1]) / (next[0] - last[0]);
        // A row at the tip is not after another one.
        if !slope.is_finite() && next[0] != 0.0 {
            return Some(row.line);
        }
        last = next;
    }
    None
}
