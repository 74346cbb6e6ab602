//! Every deliberate fault in every closed form makes a row fail.

#![allow(clippy::print_stdout, reason = "the count of faults is part of the result")]

use std::collections::BTreeSet;

use mdr_crosscheck::{ClosedForms, Fault, Level, Options, VerifyReport, checks_of, faults, run_against, subjects};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// A row that claims to watch over a subject, over a few cases.
fn watched(closed: &ClosedForms, row: &str, cases: usize) -> VerifyReport {
    let only = vec![row.to_owned()];
    run_against(closed, &Options { only, limit: Some(cases), ..Options::at(Level::Quick) }, &|_| ())
}

/// The row that catches a fault, and in how many cases: most faults show in the first, some only in few of the cases.
fn caught(fault: Fault) -> Option<(&'static str, usize)> {
    let closed = ClosedForms::with(fault);
    let mut rows =
        [1, 2, 16].into_iter().flat_map(|cases| checks_of(fault.id).into_iter().map(move |row| (row, cases)));
    rows.find(|&(row, cases)| !watched(&closed, row, cases).passed())
}

/// Each row that catches a fault passes without it over the same cases.
#[test]
fn every_fault_is_caught() {
    let faults: Vec<Fault> = faults().collect();
    println!("{} faults in {} subjects", faults.len(), subjects().len());
    let caught: Vec<_> = faults.par_iter().map(|&fault| (fault, caught(fault))).collect();
    let missed: Vec<&Fault> = caught.iter().filter(|(_, row)| row.is_none()).map(|(fault, _)| fault).collect();
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    let rows: BTreeSet<_> = caught.iter().filter_map(|(_, row)| *row).collect();
    rows.par_iter().for_each(|&(row, cases)| {
        assert!(watched(&ClosedForms::default(), row, cases).passed(), "{row} fails without a fault");
    });
}

#[test]
fn every_subject_is_in_the_table_and_watched() {
    for subject in subjects() {
        assert!(!checks_of(subject.id).is_empty(), "{:?} has no check", subject.id);
    }
    let distinct: BTreeSet<_> = subjects().iter().map(|subject| subject.id).collect();
    assert_eq!(distinct.len(), subjects().len(), "a subject is in the table twice");
}
