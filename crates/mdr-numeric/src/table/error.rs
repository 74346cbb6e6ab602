//! Why a file is not a measured profile.

use mdr_core::named;
use mdr_core::number::LiteralError;
use mdr_core::text::excerpt;
use thiserror::Error;

use super::MINIMUM_ROWS;

named! {
    /// The two columns of a table.
    pub enum TableColumn {
        /// `r`, the distance from the axis.
        Radius = "r",
        /// `f`, the height above the tip.
        Height = "f",
    }
}

/// The reason why a table is rejected. Every message states the line, the column, the text there and the remedy; numbers are
/// quoted as in the file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableError {
    /// The file cannot be read.
    #[error("the table cannot be read: {0}")]
    Read(#[from] std::io::Error),
    /// It is not text with separated columns, or not UTF-8.
    #[error("line {line}: not a row of UTF-8 text with separated columns: {}", excerpt(reason))]
    Malformed {
        /// The line.
        line: usize,
        /// The message of the CSV reader.
        reason: String,
    },
    /// The header has no column of that name.
    #[error(
        "line {line}: no column `{column}` among `{}`; the header must name the columns `r` and `f`",
        excerpt(found)
    )]
    MissingColumn {
        /// The line of the header.
        line: usize,
        /// The missing column.
        column: TableColumn,
        /// The columns that are present.
        found: String,
    },
    /// A row whose number of fields differs from the number of columns.
    #[error(
        "line {line}: {found} fields where {expected} are expected; columns are separated by a comma, a semicolon or \
         a tab, decimals are written with a point, and a table without header has the two columns r and f"
    )]
    Width {
        /// The line.
        line: usize,
        /// Fields found.
        found: usize,
        /// Fields expected.
        expected: usize,
    },
    /// A unit that is not a length.
    #[error(
        "line {line}, column {column}: unknown unit `{}`; expected m, alone or with an SI prefix: nm, um, mm",
        excerpt(unit)
    )]
    UnknownUnit {
        /// The line of the units.
        line: usize,
        /// The column.
        column: TableColumn,
        /// The unit as written.
        unit: String,
    },
    /// A field that is not a finite number.
    #[error("line {line}, column {column}: `{}` is {reason}", excerpt(text))]
    NotANumber {
        /// The line.
        line: usize,
        /// The column.
        column: TableColumn,
        /// The field as written.
        text: String,
        /// The reason.
        reason: LiteralError,
    },
    /// A radius below zero.
    #[error(
        "line {line}, column r: the radius {} is negative; fold the trace at the tip, so that r ≥ 0 is the \
         distance from the axis",
        excerpt(radius)
    )]
    NegativeRadius {
        /// The line.
        line: usize,
        /// The radius as written.
        radius: String,
    },
    /// A radius smaller than the previous one.
    #[error(
        "line {line}, column r: the radius {} is smaller than {} on line {previous_line}; sort the rows \
         by increasing r",
        excerpt(radius),
        excerpt(previous)
    )]
    Unsorted {
        /// The line.
        line: usize,
        /// The radius as written.
        radius: String,
        /// The previous radius.
        previous: String,
        /// The line of the previous radius.
        previous_line: usize,
    },
    /// A radius that equals the previous one as a double.
    #[error(
        "line {line}, column r: the radius {} was already given on line {previous_line}; keep one of the two \
         rows, or their mean",
        excerpt(radius)
    )]
    Repeated {
        /// The line.
        line: usize,
        /// The radius as written.
        radius: String,
        /// The line of the first.
        previous_line: usize,
    },
    /// f(0) ≠ 0.
    #[error(
        "line {line}, column f: the profile is not zero at the tip, f(0) = {0}; subtract {0} from every f",
        excerpt(height)
    )]
    TipNotZero {
        /// The line.
        line: usize,
        /// f(0) as written.
        height: String,
    },
    /// Heights that do not extrapolate to f(0) = 0.
    #[error(
        "line {line}, column f: the rows begin with {} at r = {} and do not lead to f(0) = 0, but to about \
         {}; heights are measured from the tip: subtract the height of the tip from every f",
        excerpt(height),
        excerpt(radius),
        excerpt(tip)
    )]
    TipElsewhere {
        /// The line.
        line: usize,
        /// The first height.
        height: String,
        /// Its radius.
        radius: String,
        /// The height at which the parabola through the first two rows meets the axis.
        tip: String,
    },
    /// A length that is unsuitable for smoothing.
    #[error("cannot be smoothed over {length:e}: {why}")]
    Smoothing {
        /// The length.
        length: f64,
        /// The reason.
        why: String,
    },
    /// A line that no row needs, or more of them than a table may have.
    #[error("{what}; {remedy}")]
    TooLarge {
        /// The quantity that is too large, and its size.
        what: String,
        /// A possible remedy.
        remedy: &'static str,
    },
    /// Not enough rows.
    #[error(
        "{rows} rows of numbers; at least {MINIMUM_ROWS} are needed, because with fewer the slopes of the interpolant \
         follow from its end conditions and not from the data"
    )]
    TooFewRows {
        /// Rows found.
        rows: usize,
    },
}
