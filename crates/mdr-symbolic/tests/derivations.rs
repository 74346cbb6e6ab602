//! Every derivation is correct, and no statement remains provable after a mutation.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::BTreeSet;

use mdr_symbolic::derivations::{Claim, Entry, Step, Verdict, entries, entry};
use mdr_symbolic::{Decision, Domain};

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

/// No mutant is proved, nearly all are refuted by normal forms, and only refuted or cited statements have none.
#[test]
fn no_mutant_is_proved() {
    let (mut refuted, mut undecided) = (0, 0);
    for entry in entries() {
        for step in entry.steps {
            let mutants = step.mutants().unwrap();
            let without = matches!(step.claim, Claim::Refuted | Claim::Cited);
            assert_eq!(mutants.is_empty(), without, "{}: {:?}", entry.id, step.statement);
            let distinct: BTreeSet<_> = mutants.iter().map(|mutant| format!("{mutant:?}")).collect();
            assert_eq!(distinct.len(), mutants.len(), "{}: {:?}", entry.id, step.statement);
            for mutant in mutants {
                for domain in step.domains {
                    match mutant.decide(*domain) {
                        Decision::Proved { .. } => panic!("{}: {}", entry.id, mutant.text()),
                        Decision::Refuted { .. } => refuted += 1,
                        Decision::Undecided(_) => undecided += 1,
                    }
                }
            }
        }
    }
    assert!(refuted > 1900 && undecided < refuted / 5, "{refuted} refuted, {undecided} undecided");
}

/// Each step has what its claim requires, and an entry claims no more than its steps show.
#[test]
fn claims_fit_their_steps() {
    for entry in entries() {
        let claims: BTreeSet<_> = entry.steps.iter().map(|step| step.claim).collect();
        assert_eq!(entry.refuted, claims.contains(&Claim::Refuted) && entry.id == "1.15", "{}", entry.id);
        // No step that counts is weaker than the entry, unless a theorem carries it.
        let weaker = entry.steps.iter().map(Step::verdict).any(|verdict| verdict > entry.verdict());
        assert!(!weaker || matches!(entry.verdict(), Verdict::Theorem | Verdict::Refuted), "{}", entry.id);
        let shown = entry.erratum.map_or(&[][..], |erratum| erratum.shown_by);
        assert!(shown.iter().all(|index| *index < entry.steps.len()), "{}", entry.id);
        for step in entry.steps {
            assert_eq!(step.statement.is_none(), step.claim == Claim::Cited, "{}: {}", entry.id, step.why);
            assert!(step.claim == Claim::Cited || !step.domains.is_empty(), "{}: {}", entry.id, step.why);
        }
    }
}

/// What only repeats a definition is called that, and carries no verdict.
#[test]
fn definitions_do_not_count() {
    let repeats: Vec<_> =
        entries().iter().flat_map(|entry| entry.steps).filter(|step| step.verdict() == Verdict::Definition).collect();
    let statements: Vec<_> = repeats.iter().filter_map(|step| step.statement).collect();
    let expected = ["at(d_g, g,", "kappa(n) = sqrt(π)", "at(C_ρ, ρ, 1)"];
    for begin in expected {
        assert!(statements.iter().any(|statement| statement.starts_with(begin)), "{begin}: {statements:?}");
    }
    assert_eq!(statements.len(), expected.len(), "{statements:?}");
    static ONLY: [Step; 1] = [Step {
        claim: Claim::Proved,
        domains: &[Domain::Positive],
        statement: Some("N = n*κ*C"),
        point: &[],
        why: "",
    }];
    let probe = Entry {
        id: "probe",
        title: "",
        refuted: false,
        assumptions: &[],
        steps: &ONLY,
        erratum: None,
        references: &[],
    };
    assert_eq!(probe.verdict(), Verdict::Definition);
}

/// Energy and stability are tied under every control, and (1.9) covers tension, compression and relaxed springs.
#[test]
fn steps_that_must_be_there() {
    let has = |id: &str, begin: &str| {
        let steps = entry(id).unwrap().steps.iter().filter_map(|step| step.statement);
        assert!(steps.clone().any(|statement| statement.starts_with(begin)), "{id}: {begin}");
    };
    has("critical-machine", "at(diff(E*(((k*δ + 2*E*G)/(k + 2*E*a) - g)^2 - Δl^2), a), δ,");
    has("critical-force", "at(diff(E*(((F + 2*E*G)/(2*E*a) - g)^2 - Δl^2), a), F,");
    has("1.16", "2*E*(a*d_n - int(κ*C*x^n, x, a)) = F_n");
    for begin in ["at(at(diff(U, a), d, g - y), w,", "at(at(diff(U, a), d, g + y), w,", "at(diff(U, a), d, g) <"] {
        has("1.9", begin);
    }
}

const CONFORMANCE: &str = include_str!("../../../docs/conformance.md");

/// The tables of conformance contain every equation, with the verdict of its entry (for a corrected one, that of the
/// correction), and every other entry too.
#[test]
fn the_tables_of_conformance_have_these_verdicts() {
    let (paper, beyond) = CONFORMANCE.split_once("\n## Beyond the paper\n").unwrap();
    let mut found = equations_with_their_verdict(paper);
    let (beyond, _) = beyond.split_once("\n## ").unwrap();
    let rows: Vec<Vec<_>> = beyond.lines().filter(|line| line.starts_with('|')).map(cells).collect();
    assert_eq!(rows[0], ["what", "verdict", "function", "checks", "tests", "physics"]);
    for row in &rows[2..] {
        found.extend(entries_with_their_verdict(row));
    }
    for entry in entries() {
        assert!(found.contains(entry.id), "{}", entry.id);
    }
}

fn cells(row: &str) -> Vec<&str> {
    row.trim_matches('|').split('|').map(str::trim).collect()
}

/// Rows that begin with the numbers of equations; returns the ids found.
fn equations_with_their_verdict(table: &str) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    for row in table.lines().filter(|line| line.starts_with("| (1.")) {
        let cells = cells(row);
        for id in cells[0].split('(').skip(1).filter_map(|rest| rest.split_once(')')).map(|(id, _)| id) {
            let entry = entry(id).unwrap();
            let corrected = cells[0].ends_with('†') && entry.refuted;
            let verdict = if corrected { Verdict::Theorem } else { entry.verdict() };
            assert!(!corrected || entry.theorems().next().is_some(), "{row}");
            assert_eq!(cells[2], verdict.word(), "{row}");
            found.insert(id);
        }
    }
    found
}

/// A row that gives verdicts with their entries, or states by what it is tested; returns the ids found.
fn entries_with_their_verdict<'a>(row: &[&'a str]) -> Vec<&'a str> {
    let &[_, verdicts, _, checks, tests, ..] = row else { panic!("{row:?}") };
    if verdicts == "tested" {
        assert!(tests.contains(".rs`"), "{row:?}: {checks}");
        return Vec::new();
    }
    let mut found = Vec::new();
    for part in verdicts.split(';') {
        let (word, ids) = part.trim().split_once(' ').unwrap_or_else(|| panic!("{row:?}: no entry"));
        for id in ids.split(' ') {
            let id =
                id.strip_prefix('`').and_then(|id| id.strip_suffix('`')).unwrap_or_else(|| panic!("{row:?}: {id}"));
            let entry = entry(id).unwrap_or_else(|| panic!("{row:?}: no entry {id}"));
            assert_eq!(word, entry.verdict().word(), "{row:?}: {id}");
            found.push(id);
        }
    }
    found
}

/// What is meant as a formula in a text is one: between backquotes in the grammar of the algebra, between dollars in TeX.
#[test]
fn no_formula_is_typed_as_text() {
    let typed = |c: char| "^_=<>√∫∞≤≥≠≈·πκλμθφδεΔΓΛΠΣ₀₁₂²³⁴ⁿᵏ⁻".contains(c);
    for entry in entries() {
        let texts = entry.steps.iter().map(|step| step.why).chain(entry.assumptions.iter().copied());
        for text in texts.chain(entry.erratum.map(|erratum| erratum.text)) {
            for (i, part) in text.split('`').enumerate() {
                if i % 2 == 1 {
                    let statement = part.parse::<mdr_symbolic::Statement>().is_ok();
                    assert!(statement || part.parse::<mdr_symbolic::Formula>().is_ok(), "{}: {part}", entry.id);
                    continue;
                }
                let words: String = part.split('$').step_by(2).collect();
                assert!(!words.contains(typed), "{}: {words}", entry.id);
            }
            assert_eq!(text.matches('$').count() % 2, 0, "{}: {text}", entry.id);
        }
    }
}
