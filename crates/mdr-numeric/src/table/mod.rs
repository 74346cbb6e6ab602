//! Measured profiles: a table (r, f) of an AFM tip or a profilometer trace, and its exact transform.
//!
//! [`Table`] contains the measured rows as exact decimals. [`MeasuredProfile`] is the shape-preserving cubic through
//! them in some arithmetic. Its MDR transform is exact: each cubic piece has closed moments, and nothing is sampled. Those on other media are
//! sums of rules that are exact to rounding ([`MeasuredOnMedium`]).
//! The choices:
//!
//! * **The tip.** f(0) = 0 defines the height, so (0, 0) is a point of every profile, measured or not. A profile is
//!   even in r, so its slope there is 0. When the first measured radius is positive, the interval to the tip is filled
//!   by the first cubic: slope 0 at the tip, the measured height and the slope of the data at the first radius.
//! * **The slopes** are those of the parabola through three neighbouring points, limited to at most three times the
//!   smaller neighbouring difference quotient, and 0 where these differ in sign (de Boor & Swartz 1977; Fritsch &
//!   Carlson 1980). The interpolant is monotone wherever the data are, and it has no extremum except at data.
//! * **Exactly reproduced**: the paraboloid f = c r², from any radii. A smooth profile gives g with an error of order
//!   h^5/2 in the spacing h, a cone (which is not smooth at its tip) of order h³ away from the tip and h at it.
//!
//! ```
//! use mdr_core::contact::Transform;
//! use mdr_numeric::table::Table;
//!
//! let text = "# a paraboloid of radius 1 µm\nr,f\num,nm\n0,0\n0.1,5\n0.25,31.25\n0.3,45\n";
//! let tip = Table::from_csv(text.as_bytes())?.profile::<f64>(())?;
//! let g = tip.g(&0.2e-6)?; // x²/R
//! assert!((g - 40e-9).abs() < 1e-15 * 40e-9);
//! assert!(tip.g(&0.4e-6).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arc;
mod error;
mod far;
mod hermite;
mod medium;
pub mod periodic;
mod read;
mod rough;
mod series;
mod smooth;
mod tip;
mod transform;

pub use error::{TableColumn, TableError};
pub use medium::MeasuredOnMedium;
pub use read::{Line, separated};
pub use rough::Scatter;

use far::FarField;
use hermite::Piece;
#[cfg(feature = "mp")]
use mdr_core::contact::EnclosedFormula;
use mdr_core::contact::{Error, Quantity, Result};
#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::{Literal, Special};
use mdr_core::units::scaled;
use read::metre_power;
use series::Series;

/// The fewest rows of a table. With four, two radii have slopes from data on both sides.
pub const MINIMUM_ROWS: usize = 4;

/// The most rows of a table. Each takes about 1.3 kB while a contact is computed.
pub const MAXIMUM_ROWS: usize = 100_000;

/// One row of a table, in metres, with the line it was read from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableRow {
    /// The line in the file, from 1.
    pub line: usize,
    /// r ≥ 0.
    pub radius: Literal,
    /// f(r).
    pub height: Literal,
}

/// A measured profile as exact decimals: at least four rows, radii ascending, f(0) = 0 if r = 0 is given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    rows: Vec<TableRow>,
    units: Option<[String; 2]>,
}

impl Table {
    /// The rows, by increasing radius.
    pub fn rows(&self) -> &[TableRow] {
        &self.rows
    }

    /// The units of r and f as given; `None` if both are metres or not given.
    pub fn units(&self) -> Option<&[String; 2]> {
        self.units.as_ref()
    }

    /// A number of metres in the unit of a column, in the notation of the table.
    fn written(&self, column: TableColumn, metres: &str) -> String {
        let unit = self.units().and_then(|units| metre_power(&units[column as usize]));
        unit.map_or_else(|| metres.to_owned(), |power| scaled(metres, -power))
    }

    /// A table with these rows and other heights, one per row.
    pub fn with_heights(&self, heights: impl IntoIterator<Item = Literal>) -> Table {
        let row = |(row, height): (&TableRow, Literal)| TableRow { height, ..row.clone() };
        Table { rows: self.rows.iter().zip(heights).map(row).collect(), units: self.units.clone() }
    }

    /// Radii and heights in hardware numbers.
    fn points(&self) -> Vec<(f64, f64)> {
        self.rows.iter().map(|row| (row.radius.nearest_f64(), row.height.nearest_f64())).collect()
    }

    /// The profile through the rows, in the arithmetic of `ctx`: every decimal is rounded once.
    ///
    /// # Errors
    /// If the arithmetic cannot represent the table: a radius or height overflows, or two radii round to the same
    /// number.
    pub fn profile<R: Special>(&self, ctx: R::Ctx) -> Result<MeasuredProfile<R>> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        MeasuredProfile::new(self.rows.iter().map(|row| (number(&row.radius), number(&row.height))).collect())
    }

    /// The profile through the rows from a crest at r = 0 to the trough at half of the wavelength, which is even around both.
    /// Rows beyond the trough only have to agree with it: see [`periodic`].
    ///
    /// # Errors
    /// Rows that end before the trough, or that contradict the wavelength; see also [`Table::profile`].
    pub fn periodic_profile<R: Special>(&self, ctx: R::Ctx, wavelength: &R) -> Result<MeasuredProfile<R>> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        let points = self.rows.iter().map(|row| (number(&row.radius), number(&row.height))).collect();
        MeasuredProfile::new(periodic::mirrored(points, wavelength)?)
    }
}

/// The shape-preserving cubic through measured points, with its exact MDR transform, in any arithmetic.
///
/// With u the unit roundoff, L = 16 + 2 log₂(rows) and M(x) = Σᵢ |Δfᵢ/Δrᵢ| Δθᵢ (θ = arcsin(r/x); x M is g itself for a
/// profile that is straight between rows), rounding errors are below L u x M for g and L u x² M for G, however close x
/// is to a row. That of g' is below 4L u Σᵢ (1 + rᵢ₊₁/Δrᵢ) |Δfᵢ/Δrᵢ| Δθᵢ: f'' is a second difference of the data, and
/// with the limited slopes |f'| is up to three times, |Δrᵢ f''| up to twelve times |Δfᵢ/Δrᵢ|. An evaluation costs O(log
/// rows) in f64, and with up to 512 bits after the first few, which sum over all rows with an additional rounding error of at worst
/// (rows) u, as all do above 512 bits. Over intervals the result is an enclosure for every table within the enclosures of the decimals; radii that
/// straddle a row are rejected, and [`Transform::kink`](mdr_core::contact::Transform::kink) gives the bounds there.
#[derive(Clone, Debug)]
pub struct MeasuredProfile<R> {
    pieces: Vec<Piece<R>>,
    end: R,
    far: Option<FarField<R>>,
    series: Series<R>,
}

impl<R: Special> MeasuredProfile<R> {
    /// The profile through `points` (r, f); the tip (0, 0) is added when it is not among them.
    ///
    /// # Errors
    /// [`Domain`](Error::Domain): fewer than [`MINIMUM_ROWS`] points, radii that are not ascending from r ≥ 0, numbers
    /// that are not finite, f(0) ≠ 0, or neighbours so close or far in height that their difference quotient overflows.
    pub fn new(mut points: Vec<(R, R)>) -> Result<Self> {
        let [(first, tip), _, _, _, ..] = points.as_slice() else {
            let (value, requirement) = (points.len().to_string(), "at least 4");
            return Err(Error::Domain { quantity: Quantity::Parameter("rows of the table"), value, requirement });
        };
        let zero = first.lit(0);
        if *first == zero && *tip != zero {
            return Err(Error::domain(Quantity::Parameter("f(0)"), tip, "0: heights are measured from the tip"));
        }
        if *first != zero {
            points.insert(0, (zero.clone(), zero));
        }
        let pieces = hermite::pieces(&points)?;
        let far = FarField::new(&pieces)?;
        let (end, _) = points.swap_remove(points.len() - 1);
        Ok(MeasuredProfile { pieces, end, far, series: Series::default() })
    }
}

#[cfg(feature = "mp")]
impl MeasuredProfile<Interval> {
    /// f over sets of radii, cubic by cubic.
    ///
    /// ```
    /// use mdr_core::number::{Interval, Precision, Real};
    /// use mdr_numeric::table::Table;
    /// let table = Table::from_csv("r,f\n0,0\n1,0.5\n2,2\n3,4.5\n".as_bytes())?;
    /// let precision = Precision::new(100);
    /// let profile = table.profile::<Interval>(precision)?.enclosed();
    /// // r²/2 at r = 3/2.
    /// let height = profile.part(1).and_then(|part| part.at(&Interval::from_int(precision, 3).over(2)));
    /// assert!(height.expect("a cubic").contains(Interval::from_int(precision, 9).over(8).lower()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn enclosed(&self) -> EnclosedFormula {
        let polynomials: Vec<_> = self.pieces.iter().map(Piece::polynomial).collect();
        EnclosedFormula::piecewise(&polynomials, self.end.clone())
    }
}
