//! Every derivation holds, and no statement survives a mistake.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::BTreeSet;

use mdr_symbolic::derivations::{Claim, entries, entry};

#[test]
fn ids_are_unique_and_every_equation_is_there() {
    let ids: BTreeSet<_> = entries().iter().map(|entry| entry.id).collect();
    assert_eq!(ids.len(), entries().len());
    for number in 1..=19 {
        assert!(entry(&format!("1.{number}")).is_some(), "(1.{number})");
    }
}

#[test]
fn normal_forms_say_what_each_step_claims() {
    for entry in entries() {
        for step in entry.steps {
            assert!(step.holds().unwrap(), "{}: {:?}\n{:#?}", entry.id, step.statement, step.check().unwrap());
        }
    }
}

#[test]
fn every_mutant_is_refuted() {
    let (mut total, mut survivors) = (0, Vec::new());
    for entry in entries() {
        for step in entry.steps {
            let (count, surviving) = step.surviving_mutants().unwrap();
            total += count;
            survivors.extend(surviving.into_iter().map(|mutant| format!("{}: {}", entry.id, mutant.text())));
        }
    }
    assert!(total > 500, "{total}");
    assert!(survivors.is_empty(), "{} of {total}: {survivors:#?}", survivors.len());
}

/// Each step has what its claim needs, and an entry claims no more than its steps show.
#[test]
fn claims_fit_their_steps() {
    for entry in entries() {
        let claims: BTreeSet<_> = entry.steps.iter().map(|step| step.claim).collect();
        assert_eq!(
            entry.verdict == Claim::Refuted,
            claims.contains(&Claim::Refuted) && entry.id == "1.15",
            "{}",
            entry.id
        );
        assert!(claims.contains(&entry.verdict), "{}", entry.id);
        if entry.verdict == Claim::Proved {
            let cited = entry.steps.iter().filter(|step| step.claim == Claim::Cited).count();
            assert!(cited <= 1, "{} leans on the literature", entry.id);
        }
        let shown = entry.erratum.map_or(&[][..], |erratum| erratum.shown_by);
        assert!(shown.iter().all(|index| *index < entry.steps.len()), "{}", entry.id);
        for step in entry.steps {
            assert_eq!(step.statement.is_none(), step.claim == Claim::Cited, "{}: {}", entry.id, step.why);
            assert!(step.claim == Claim::Cited || !step.domains.is_empty(), "{}: {}", entry.id, step.why);
        }
    }
}
