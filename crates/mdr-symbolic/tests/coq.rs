//! The statements in Coq are those of the program.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_symbolic::derivations::{Claim, entries, statements_in_coq, theorems};

const PROOFS: &str = include_str!("../../../docs/proofs/Steps.v");
const BY_THEOREM: &str = include_str!("../../../docs/proofs/StepTheorems.v");
const STATEMENTS: &str = include_str!("../../../docs/proofs/Statements.v");

/// Regenerate with `mdr derive --format coq > docs/proofs/Statements.v`, or with MDR_GOLDENS=overwrite.
#[test]
fn the_statements_in_coq_are_those_of_the_steps() {
    let written = statements_in_coq(entries());
    if std::env::var("MDR_GOLDENS").as_deref() == Ok("overwrite") {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/proofs/Statements.v");
        std::fs::write(path, &written).unwrap();
        return;
    }
    assert!(written == STATEMENTS, "docs/proofs/Statements.v is stale");
    let steps = entries().iter().flat_map(|entry| entry.steps).filter(|step| step.statement.is_some()).count();
    assert_eq!(STATEMENTS.matches("\nDefinition step_").count(), steps);
}

/// What the pages call proved in Coq has a proof there, under the statement of that name; what has none is listed.
#[test]
fn proved_steps_have_proofs() {
    let has = |proofs: &str, name: &str| proofs.contains(&format!("Lemma prove_{name} : {name}.\nProof."));
    let steps: Vec<_> = entries()
        .iter()
        .flat_map(|entry| entry.steps.iter().enumerate().map(move |(i, step)| (entry.step_in_coq(i), step)))
        .collect();
    for (name, step) in &steps {
        assert_eq!(step.proved_in_coq().is_some(), has(PROOFS, name) || has(BY_THEOREM, name), "{name}");
        assert!(step.claim == Claim::Proved || !has(PROOFS, name), "{name}");
        assert_eq!(step.by_theorem().is_some(), has(BY_THEOREM, name), "{name}");
        assert!(
            step.by_theorem().is_none_or(|by| by.is_empty() || theorems().any(|theorem| theorem.name == by)),
            "{name}"
        );
    }
    let count = steps.iter().filter(|(_, step)| step.proved_in_coq().is_some()).count();
    assert!(count > 125, "{count}");
    assert!(
        !["Admitted", "admit", "Abort", "Axiom"].iter().any(|word| PROOFS.contains(word) || BY_THEOREM.contains(word))
    );
}
