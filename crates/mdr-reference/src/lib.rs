//! Certified reference values of adhesive contact mechanics, for the tests of other programs.
//!
//! These records are for adhesive contact what the Statistical Reference Datasets of NIST are for statistics: numbers
//! with every digit proved, from easy to hard. A [`Record`] has a question (exact decimal inputs), fifty certified
//! digits, the nearest double, the condition of the question with respect to each input, and a difficulty with
//! published thresholds ([`DifficultyInputs`]). The judge marks answers and separates the error of an algorithm from the
//! condition of the question. Where wrong answers follow a mistaken convention, such as γ for w, it names that
//! ([`Explanation`]). A [`Table`] is a few dozen rows to copy.
//! A [`DataSet`] is a measured curve whose fit is certified.
//!
//! The crate is data and a judge, without dependencies and without numerical methods of its own. As a dev-dependency:
//!
//! ```
//! use mdr_reference::{Answer, Filter, judge};
//! // Pull-off force of a power law f = C rⁿ under a dead load; here only the paraboloid, by the formula of JKR.
//! let questions: Filter = "formula=critical control=force quantity=force status=ok".parse()?;
//! let report = judge(questions.select(), |question| {
//!     let (c, w) = (question.input_f64("C")?, question.input_f64("w")?);
//!     (question.input("n") == Some("2")).then(|| Answer::from(-0.75 * std::f64::consts::PI * w / c))
//! });
//! assert!(report.passed(), "{report}");
//! # Ok::<(), mdr_reference::FilterError>(())
//! ```
//!
//! Programs in other languages read the files of `data/`, one JSON object per line, or `mdr reference --export`, write
//! one answer per line, and run `mdr judge`.

#![forbid(unsafe_code)]

mod catalogue;
mod data_set;
mod decimal;
mod difficulty;
mod fraction;
mod hexadecimal;
mod json;
mod judge;
mod measure;
mod named;
mod number;
mod record;
mod table;
mod text;
mod write;

pub use catalogue::{Family, Filter, FilterError, families, lines, record, records};
pub use data_set::{DataSet, data_sets};
pub use decimal::{Decimal, DecimalError};
pub use difficulty::{Difficulty, DifficultyInputs};
pub use judge::{
    Answer, Claim, ClaimError, Class, Explanation, Judge, Judged, Limits, Mark, Range, Refused, Report, Rules, Verdict,
    judge, mark,
};
pub use record::{Certified, Method, Record, Status, UNIT_ROUNDOFF};
pub use table::{Table, TableFormat};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
