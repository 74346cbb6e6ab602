//! The records of the release are what is generated now.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_crosscheck::records::record_cases;

/// A sample, a different part for each file; the whole is `mdr reference --generate`.
#[test]
fn a_sample_is_regenerated_bit_for_bit() {
    const STEP: usize = 9;
    let mut published = std::collections::HashMap::new();
    for line in mdr_reference::lines() {
        let id = mdr_reference::Record::from_json(line).unwrap().id;
        published.insert(id, line);
    }
    let mut compared = 0;
    for case in record_cases().iter().skip(4).step_by(STEP) {
        for record in case.records().unwrap() {
            assert_eq!(Some(&record.to_json().as_str()), published.get(&record.id), "{}", record.id);
            compared += 1;
        }
    }
    assert!(compared > 40, "{compared}");
}

/// What a record names as its proof is a derivation of which every step holds.
#[test]
fn proofs_are_derivations() {
    let mut named: Vec<_> = mdr_reference::records().iter().flat_map(|record| &record.proof).collect();
    named.sort();
    named.dedup();
    assert!(named.len() > 10, "{named:?}");
    for id in named {
        let entry = mdr_symbolic::derivations::entry(id).unwrap_or_else(|| panic!("no derivation {id}"));
        assert!(entry.steps.iter().all(|step| step.holds().unwrap()), "{id}");
    }
}
