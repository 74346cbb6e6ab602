//! A run is a pure function of its options; shards partition it.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use mdr_crosscheck::{CheckVerdict, Level, MergeError, Options, Shard, VerifyReport, run};

fn few(shard: Shard) -> Options {
    Options { shard, limit: Some(3), ..Options::at(Level::Quick) }
}

/// A few cases of every check, and how often progress was told.
static WHOLE: LazyLock<(VerifyReport, usize)> = LazyLock::new(|| {
    let told = AtomicUsize::new(0);
    let report = run(&few(Shard::WHOLE), &|progress| {
        assert!(progress.done <= progress.total);
        told.fetch_add(1, Ordering::Relaxed);
    });
    (report, told.into_inner())
});

/// A control of `fault_detection.rs`; `mdr verify` runs many more cases.
#[test]
fn without_a_fault_every_check_passes() {
    for row in &WHOLE.0.rows {
        assert_eq!(row.verdict, CheckVerdict::Pass, "{}", row.check);
    }
    assert!(WHOLE.0.failures.is_empty());
}

#[test]
fn shards_make_the_whole_bit_for_bit() {
    // In reverse order: the order of the lines must not matter.
    let lines: String = (1..=3).rev().map(|i| run(&few(Shard::new(i, 3).unwrap()), &|_| ()).to_json_lines()).collect();
    assert_eq!(VerifyReport::from_json_lines(&lines).unwrap(), WHOLE.0);
}

#[test]
fn lines_read_back_as_the_report() {
    assert_eq!(VerifyReport::from_json_lines(&WHOLE.0.to_json_lines()).unwrap(), WHOLE.0);
}

#[test]
fn a_missing_a_repeated_and_a_foreign_shard_are_told() {
    let only = || vec!["jkr".to_owned(), "kappa-gamma".to_owned()];
    let part = |i, n| run(&Options { only: only(), ..few(Shard::new(i, n).unwrap()) }, &|_| ()).to_json_lines();
    let merged = |lines: String| VerifyReport::from_json_lines(&lines);
    assert!(matches!(merged(part(1, 2)), Err(MergeError::Incomplete { got: 1, count: 2, .. })));
    assert!(matches!(merged(part(1, 2) + &part(1, 2)), Err(MergeError::Repeated { .. })));
    assert!(matches!(merged(part(1, 2) + &part(2, 3)), Err(MergeError::Mixed { .. })));
    assert!(matches!(merged("{}".into()), Err(MergeError::Line { line: 1, .. })));
    assert!(matches!(merged(String::new()), Err(MergeError::Empty)));
}

#[test]
fn the_seed_and_nothing_else_decides() {
    let options = few(Shard::WHOLE);
    let again = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap().install(|| run(&options, &|_| ()));
    assert_eq!(WHOLE.0, again);
    let only = vec!["jkr".to_owned()];
    let [one, other] = [0, 1].map(|seed| run(&Options { seed, only: only.clone(), ..options.clone() }, &|_| ()));
    assert_ne!(other.rows, one.rows);
}

#[test]
fn a_check_without_cases_is_skipped() {
    let report = run(&Options { limit: Some(0), ..Options::default() }, &|_| ());
    assert!(report.rows.iter().all(|row| row.verdict == CheckVerdict::Skipped && row.median().is_none()));
    assert!(report.passed());
}

#[test]
fn progress_counts_every_case() {
    let (report, told) = &*WHOLE;
    assert_eq!(*told, report.rows.iter().map(|row| row.cases + row.skipped).sum::<usize>());
}
