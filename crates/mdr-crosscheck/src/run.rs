//! Runs the checks, in parallel, case by case.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::checks::{Check, registry};
use crate::options::Options;
use crate::report::{Grid, VerifyReport};
use crate::subject::closed::ClosedForms;
use crate::trial::Trial;

/// How far a run has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Cases done.
    pub done: usize,
    /// Cases in all.
    pub total: usize,
    /// The check of the case done last.
    pub check: &'static str,
}

/// Compares the closed forms with the numerical route over the grid of `options`.
///
/// `progress` is called after every case, from any thread. The report is a pure function of the options: neither the
/// number of threads nor the time matters.
///
/// ```no_run
/// use mdr_crosscheck::{Level, Options, run};
/// let report = run(&Options::at(Level::Quick), &|_| ());
/// assert!(report.passed());
/// ```
pub fn run(options: &Options, progress: &(dyn Fn(Progress) + Sync)) -> VerifyReport {
    run_against(&ClosedForms::default(), options, progress)
}

/// Runs the checks like [`run`], with `closed` in the place of the closed forms, so that deliberate faults can be put in.
pub fn run_against(closed: &ClosedForms, options: &Options, progress: &(dyn Fn(Progress) + Sync)) -> VerifyReport {
    let asked = |check: &&Check| options.only.is_empty() || options.only.contains(&check.row.check);
    let checks: Vec<&Check> = registry().iter().filter(asked).collect();
    let indices = |check: &Check| {
        let (budget, shard) = (check.cases[options.level as usize], options.shard);
        (0..budget.min(options.limit.unwrap_or(budget))).filter(move |index| shard.holds(*index))
    };
    let cases: Vec<(&Check, usize)> =
        checks.iter().flat_map(|check| indices(check).map(|index| (*check, index))).collect();
    let done = AtomicUsize::new(0);
    let results: Vec<_> = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(check, index)| {
            let case = Trial::new(closed, options.precision(), options.seed, &check.row.check, index).run(check.case);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(Progress { done, total: cases.len(), check: &check.row.check });
            case
        })
        .collect();
    let Options { level, digits, seed, shard, limit, .. } = *options;
    let mut report =
        VerifyReport { grid: Grid { level, digits, seed, limit }, shard, rows: Vec::new(), failures: Vec::new() };
    let mut results = results.into_iter();
    for check in checks {
        report.enter(check.row.clone(), results.by_ref().take(indices(check).count()));
    }
    report
}
