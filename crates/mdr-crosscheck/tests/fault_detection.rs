//! Every deliberate fault in every closed form makes a row fail.

#![allow(clippy::print_stdout, reason = "the count of faults is part of the result")]

use std::collections::BTreeSet;

use mdr_crosscheck::{
    CheckVerdict, ClosedForms, Fault, Level, Options, VerifyReport, checks_of, faults, run, run_against, subjects,
};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A row that claims to watch over a subject, over a few cases.
fn watched(closed: &ClosedForms, row: &str, cases: usize) -> VerifyReport {
    let only = vec![row.to_owned()];
    run_against(closed, &Options { only, limit: Some(cases), ..Options::at(Level::Quick) }, &|_| ())
}

/// Most faults show in the first case; some only in few of the cases.
fn is_caught(fault: Fault) -> bool {
    let closed = ClosedForms::with(fault);
    [1, 2, 16].iter().any(|&cases| checks_of(fault.id).iter().any(|name| !watched(&closed, name, cases).passed()))
}

#[test]
fn every_fault_is_caught() {
    let faults: Vec<Fault> = faults().collect();
    println!("{} faults in {} subjects", faults.len(), subjects().len());
    let missed: Vec<&Fault> = faults.par_iter().filter(|&&fault| !is_caught(fault)).collect();
    assert!(missed.is_empty(), "not caught: {missed:#?}");
}

#[test]
fn every_subject_is_in_the_table_and_watched() {
    for subject in subjects() {
        assert!(!checks_of(subject.id).is_empty(), "{:?} has no check", subject.id);
    }
    let distinct: BTreeSet<_> = subjects().iter().map(|subject| subject.id).collect();
    assert_eq!(distinct.len(), subjects().len(), "a subject is in the table twice");
}

/// As many cases as a fault is looked for in; `mdr verify --quick` has them all.
#[test]
fn without_a_fault_every_check_passes() {
    let report = run(&Options { limit: Some(16), ..Options::at(Level::Quick) }, &|_| ());
    for row in &report.rows {
        assert_eq!(row.verdict, CheckVerdict::Pass, "{}", row.check);
    }
    assert!(report.failures.is_empty());
}
