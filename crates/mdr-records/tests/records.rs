//! The records of the release are what is generated now.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_records::generate;

/// As `mdr reference --generate` does it: the whole set costs some thirty seconds of one processor.
#[test]
fn the_records_are_regenerated_bit_for_bit() {
    let files = generate().unwrap();
    let generated: Vec<&str> = files.iter().flat_map(|(_, content)| content.lines()).collect();
    let published: Vec<&str> = mdr_reference::lines().collect();
    for (generated, published) in generated.iter().zip(&published) {
        assert_eq!(generated, published);
    }
    assert_eq!(generated.len(), published.len());
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
