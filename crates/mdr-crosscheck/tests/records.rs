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
