//! The derivations hold, and the judge can say no.

use mdr_crosscheck::derivations::{judge, judge_all};
use mdr_symbolic::Domain;
use mdr_symbolic::derivations::{Claim, Entry, Step};

#[test]
fn every_entry_holds() {
    for judgement in judge_all() {
        for step in &judgement.steps {
            let survivors: Vec<_> = step.survivors.iter().map(|mutant| mutant.text()).collect();
            assert!(
                step.holds(),
                "{}: {:?}: {:?} {survivors:?}",
                judgement.entry.id,
                step.step.statement,
                step.failure
            );
        }
    }
}

const fn step(claim: Claim, statement: &'static str) -> Step {
    Step { claim, domains: &[Domain::Above], statement: Some(statement), point: &[], why: "" }
}

/// False claims of every kind.
static FALSE: [Step; 8] = [
    step(Claim::Proved, "a_c = (B/N^2)^(1/(1 - 2*n))"),
    step(Claim::Proved, "F_c > 0"),
    step(Claim::Proved, "C*a ~ a"),
    step(Claim::Refuted, "4^n = 2^(2*n)"),
    step(Claim::Enclosed, "turn(sinθ) = 1.01"),
    step(Claim::Enclosed, "turn(sinθ^(n + 1)) > 1"),
    step(Claim::Enclosed, "agm(1, sqrt(2)) = π/2"),
    step(Claim::Enclosed, "Γ(-n) = 1"),
];

#[test]
fn false_claims_fail() {
    static ENTRY: Entry = Entry {
        id: "false",
        title: "",
        verdict: Claim::Proved,
        assumptions: &[],
        steps: &FALSE,
        erratum: None,
        references: &[],
    };
    let judgement = judge(&ENTRY);
    let first = judgement.steps[0].failure.as_deref().unwrap_or_default();
    assert!(first.starts_with("for n > 1/2 normal forms say refuted: left minus right is "), "{first}");
    for step in judgement.steps {
        assert!(step.failure.is_some(), "{:?}", step.step.statement);
    }
}
