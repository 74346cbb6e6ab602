//! Runs the checks, in parallel, case by case.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::checks::{Check, registry};
use crate::options::Options;
use crate::report::{Report, Row, Verdict};
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
pub fn run(options: &Options, progress: &(dyn Fn(Progress) + Sync)) -> Report {
    run_against(&ClosedForms::default(), options, progress)
}

/// As [`run`], with `closed` in the place of the closed forms: how deliberate faults are put in.
pub fn run_against(closed: &ClosedForms, options: &Options, progress: &(dyn Fn(Progress) + Sync)) -> Report {
    let checks: Vec<&Check> = registry().iter().filter(|check| asked(check, options)).collect();
    let cases: Vec<(&Check, usize)> =
        checks.iter().flat_map(|check| indices(check, options).map(|index| (*check, index))).collect();
    let done = AtomicUsize::new(0);
    let results: Vec<_> = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(check, index)| {
            let case = Trial::new(closed, options.precision(), options.seed, check.name, index).run(check.case);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(Progress { done, total: cases.len(), check: check.name });
            case
        })
        .collect();
    let mut report = Report::new(options);
    let mut results = results.into_iter();
    for check in checks {
        let count = indices(check, options).count();
        report.enter(blank(check), results.by_ref().take(count).collect());
    }
    report
}

fn asked(check: &Check, options: &Options) -> bool {
    options.only.is_empty() || options.only.iter().any(|name| name == check.name)
}

/// The indices of the cases of a check that are in the shard.
fn indices(check: &Check, options: &Options) -> impl Iterator<Item = usize> + use<> {
    let budget = check.budget(options.level);
    let shard = options.shard;
    (0..options.limit.map_or(budget, |limit| budget.min(limit))).filter(move |index| shard.holds(*index))
}

fn blank(check: &Check) -> Row {
    Row {
        check: check.name.to_owned(),
        claim: check.claim.to_owned(),
        equations: check.equations.iter().map(|&equation| equation.to_owned()).collect(),
        unit: check.unit,
        cases: 0,
        skipped: 0,
        failed: 0,
        worst: None,
        tightest: None,
        verdict: Verdict::Skipped,
        errors: Vec::new(),
    }
}
