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
    for part in ["1. refuted for", "proved for n > 1/2", "the dimensions are", "Erratum", "all refuted."] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert_eq!(output("derive (1.15)"), text);
}

#[test]
fn shapes() {
    let markdown = output("derive critical-force --format markdown");
    assert!(markdown.starts_with("# The instability under controlled force (critical-force)\n"), "{markdown}");
    assert_eq!(markdown.matches("```").count() % 2, 0, "{markdown}");
    let latex = output("derive --format latex");
    assert!(latex.starts_with(r"\documentclass") && latex.ends_with("\\end{document}\n"), "{latex}");
    assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{latex}");
    // Beyond Latin letters everything is TeX.
    assert!(latex.chars().all(|c| (c as u32) < 0x180), "{latex}");
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
