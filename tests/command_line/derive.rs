//! `mdr derive`: the derivations and their verdicts.

use crate::{mdr, output};

const DERIVATIONS: &str = include_str!("../../docs/derivations.md");
const ERRATA: &str = include_str!("../../docs/errata.md");

/// Regenerate with `mdr derive --format markdown > docs/derivations.md`.
#[test]
fn the_page_of_derivations_is_up_to_date() {
    assert!(output("derive --format markdown") == DERIVATIONS, "docs/derivations.md is stale");
    for number in 1..=19 {
        assert!(DERIVATIONS.contains(&format!("\n## (1.{number}) ")), "(1.{number})");
    }
}

/// Regenerate with `mdr derive --errata --format markdown > docs/errata.md`.
#[test]
fn the_page_of_errata_is_up_to_date() {
    assert!(output("derive --errata --format markdown") == ERRATA, "docs/errata.md is stale");
}

#[test]
fn one_entry_shows_its_steps() {
    let text = output("derive 1.15");
    assert!(text.starts_with("(1.15) The critical contact radius: refuted\n"), "{text}");
    for part in ["1. refuted for", "proved for n > 1/2", "the dimensions are", "Erratum", "refuted by normal forms"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert_eq!(output("derive (1.15)"), text);
}

/// A word that is no id lists the entries that speak of it, a single one in full.
#[test]
fn a_word_is_searched_for() {
    let text = output("derive KENDALL");
    assert!(text.contains("kendall") && !text.contains("kappa-elliptic"), "{text}");
    // In whatever case; nothing is checked for Coq.
    assert_eq!(output("derive KENDALL --format coq"), output("derive Kendall --format coq"));
    let coq = output("derive machine --format coq");
    assert!(coq.contains("machine") && coq.len() < output("derive --format coq").len());
}

/// Every mutant has its fate told, what is meaningless is named, and none is undecided.
#[test]
fn mutants_are_counted_as_what_they_are() {
    let line = DERIVATIONS.lines().find(|line| line.contains(" distinct mutants: ")).unwrap();
    let (_, mutants) = line.split_once(". ").unwrap();
    let numbers: Vec<usize> =
        mutants.split(|c: char| !c.is_ascii_digit()).filter_map(|part| part.parse().ok()).collect();
    assert_eq!(numbers[0], numbers[1..].iter().sum::<usize>(), "{mutants}");
    assert!(mutants.ends_with(" meaningless, 0 undecided."), "{mutants}");
    let named = DERIVATIONS.lines().filter(|line| line.starts_with("Meaningless mutants: "));
    assert_eq!(named.map(|line| line.matches("$`").count()).sum::<usize>(), numbers[numbers.len() - 2]);
    assert!(!DERIVATIONS.contains("Undecided mutants: "));
    let text = output("derive kappa-elliptic");
    assert_eq!(text.matches("\n  meaningless: ").count(), 6, "{text}");
}

/// Figures 1 to 4 stand where they belong.
#[test]
fn the_page_of_derivations_shows_the_figures() {
    for (heading, file) in
        [("(1.9)", "1a"), ("(1.10)", "1b"), ("(1.10)", "2"), ("(1.11)", "3"), ("A paraboloid with", "4")]
    {
        let section = DERIVATIONS.split("\n## ").find(|section| section.starts_with(heading)).unwrap();
        let path = format!("figures/figure-{file}.svg");
        assert!(section.contains(&format!("]({path})")), "{heading}: {path}");
        assert!(crate::root().join("docs").join(&path).is_file(), "{path}");
    }
}

#[test]
fn shapes() {
    let markdown = output("derive critical-force --format markdown");
    assert!(markdown.starts_with("# The instability under controlled force (critical-force)\n"), "{markdown}");
    assert_eq!(markdown.matches("```").count() % 2, 0, "{markdown}");
    let latex = output("derive critical-force --format latex");
    assert!(latex.starts_with(r"\documentclass") && latex.ends_with("\\end{document}\n"), "{latex}");
}

/// The statements for Coq: of all entries those that are checked in, of one those of its steps.
#[test]
fn statements_for_coq() {
    let all = output("derive --format coq");
    assert!(all == include_str!("../../docs/proofs/Statements.v"), "docs/proofs/Statements.v is stale");
    let one = output("derive 1.4 --format coq");
    assert!(one.contains("\nDefinition step_1_4_2 : Prop :=\n  forall (E w a d : R) (g g1 G Q : R -> R), "), "{one}");
    assert!(!one.contains("step_1_5_1"), "{one}");
    assert!(output("derive 1.4").contains("2. proved for n > 0, in Coq step_1_4_2\n"));
}

#[test]
fn an_unknown_id_has_a_nearest_one() {
    let cases = [("1.99", "1.19"), ("kendal", "kendall"), ("machine-fold", "machine-folds")];
    for (id, nearest) in cases {
        let assert = mdr("derive").arg(id).assert().code(2).stdout_eq("");
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(message.starts_with("error: ID: no such derivation; the nearest is "), "{message}");
        assert!(message.contains(&format!("nearest is {nearest}")), "{message}");
    }
    mdr("derive 1.15 --errata").assert().code(2).stdout_eq("");
}

/// The short names of theories find them, as their authors do.
#[test]
fn a_theory_is_found_by_the_letters_of_its_authors() {
    let found = output("derive jkr");
    assert!(found.contains("1.15"), "{found}");
    assert_eq!(output("derive JKR --format coq"), output("derive jkr --format coq"));
}
