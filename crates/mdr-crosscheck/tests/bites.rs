//! The checks bite: every deliberate fault in every closed form makes a row fail.

#![allow(clippy::print_stdout, reason = "the count of faults is part of the result")]

use std::collections::BTreeSet;

use mdr_crosscheck::{Level, Options, Report, Theory, Verdict, checks_of, faults, forms, run, run_against};

/// A row that claims to watch over a form, over a few cases.
fn watched(theory: &Theory, row: &str, cases: usize) -> Report {
    let only = vec![row.to_owned()];
    run_against(theory, &Options { only, limit: Some(cases), ..Options::at(Level::Quick) }, &|_| ())
}

#[test]
fn every_fault_is_caught() {
    let mut missed = Vec::new();
    let mut count = 0;
    for fault in faults() {
        count += 1;
        let names = checks_of(fault.form);
        let theory = Theory::with(fault);
        // Most faults show at once; some only in few of the cases.
        let caught = [2, 16].iter().any(|&cases| names.iter().any(|name| !watched(&theory, name, cases).passed()));
        if !caught {
            missed.push(fault.to_string());
        }
    }
    println!("{count} faults in {} closed forms", forms().len());
    assert!(missed.is_empty(), "not caught: {missed:#?}");
}

#[test]
fn every_form_is_in_the_table_and_watched() {
    for entry in forms() {
        assert!(!checks_of(entry.form).is_empty(), "{:?} has no check", entry.form);
    }
    let distinct: BTreeSet<_> = forms().iter().map(|entry| entry.form).collect();
    assert_eq!(distinct.len(), forms().len(), "a form is in the table twice");
}

#[test]
fn without_a_fault_the_quick_level_passes() {
    let report = run(&Options::at(Level::Quick), &|_| ());
    for row in &report.rows {
        assert_eq!(row.verdict, Verdict::Pass, "{}", row.check);
    }
    assert!(report.failures.is_empty());
}
