//! Closed forms against the independent route, over parameter grids, with derived error bounds.
//!
//! [`run`] takes [`Options`] and gives a [`VerifyReport`]: one [`CheckRow`] a check, with the worst error found, the error allowed
//! for that case, and the case itself. A check compares two routes that share no formula. What it allows is derived from
//! the error bounds of both routes and the condition of the question (module `tolerance`), never from the results.
//!
//! ```
//! use mdr_crosscheck::{Level, Options, run};
//! // Four cases of one check: the paraboloid against the formulas of Johnson, Kendall and Roberts.
//! let options = Options { only: vec!["jkr".to_owned()], limit: Some(4), ..Options::at(Level::Quick) };
//! let report = run(&options, &|_progress| ());
//! assert!(report.passed() && report.cases() == 4);
//! ```
//!
//! A run is a pure function of level, digits, seed and shard. Case k of a check is the same at every level and in every
//! shard; [`VerifyReport::from_json_lines`] merges the lines of all shards into the report of the whole.
//!
//! * [`faults`] are mistakes put into the closed forms on purpose; each must be found by a check.
//! * [`derivations`] evaluates the statements of `mdr-symbolic` in rigorous intervals.
//! * [`work_precision`] has the data of error against run time.
//! * [`ladders`] lead each function in double precision to where its question becomes hard.
//! * [`findings`] puts both on one page.

#![forbid(unsafe_code)]
#![cfg_attr(test, allow(dead_code, unused_imports, unused_macros, reason = "tests within the library run no check"))]

mod arithmetic;
mod checks;
pub mod derivations;
pub mod findings;
mod grid;
pub mod ladders;
mod merge;
mod options;
mod report;
mod run;
mod short;
mod subject;
mod tolerance;
mod trial;
pub mod work_precision;

pub use checks::{check_names, checks_of};
pub use findings::Findings;
pub use merge::MergeError;
pub use options::{Level, Options, Shard, ShardError};
pub use report::{CheckRow, CheckVerdict, ErrorUnit, Failure, Finding, Grid, VerifyReport};
pub use run::{Progress, run, run_against};
pub use subject::closed::ClosedForms;
pub use subject::mutation::{Fault, Mutation, faults};
pub use subject::{Part, Subject, SubjectId, subjects};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
