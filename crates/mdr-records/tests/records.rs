//! The records of the release are what is generated now.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_records::generate;
use mdr_reference::{Decimal, data_sets};
use serde_json::Value as Json;

/// As `mdr reference --generate` does it: the whole set costs one to two minutes of one processor.
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

/// Seven data sets were fitted by another program, in sixty digits of which twenty are printed.
#[test]
fn fits_are_those_of_another_program() {
    let other: Json = serde_json::from_str(include_str!("../../mdr-fit/tests/fits/public.json")).unwrap();
    let mut compared = 0;
    for set in data_sets() {
        let same = |other: &&Json| other["id"].as_str().unwrap().eq_ignore_ascii_case(set.name);
        let Some(other) = other["sets"].as_array().unwrap().iter().find(same) else { continue };
        let certified = &other["certified"];
        for record in set.records() {
            let name = record.quantity.trim_end_matches("_stderr");
            let published = match other["free"].as_array().unwrap().iter().position(|free| free == name) {
                None => &certified["rss"],
                Some(place) if name == record.quantity => &certified["estimate"][place],
                Some(place) => &certified["sd_scaled"][place],
            };
            let published: Decimal = published.as_str().unwrap().parse().unwrap();
            let value = record.decimal().unwrap();
            // Half a unit of the twentieth digit.
            let error = (&published - &value).abs();
            assert!(error.is_zero() || error.log10() < value.log10() - 19.0, "{}: {published:?}", record.id);
            compared += 1;
        }
    }
    assert_eq!(compared, 5 + 9 + 9 + 7 + 7 + 7 + 9);
}

/// Those on every medium, and those whose radii no double holds.
#[test]
fn every_contact_with_folds_has_a_certificate() {
    let (lines, without) = mdr_records::certificates().unwrap();
    assert_eq!(without, Vec::<String>::new());
    for (kind, count) in [("graded", 16), ("plane", 7), ("periodic", 11)] {
        let named = format!(r#""kind":"{kind}""#);
        assert_eq!(lines.lines().filter(|line| line.contains(&named)).count(), count, "{kind}");
    }
    assert_eq!(lines.lines().count(), 245);
}
