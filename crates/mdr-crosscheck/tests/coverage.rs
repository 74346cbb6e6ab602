//! Every public closed form of mdr-analytic has a row, or a reason why not.

#![allow(clippy::unwrap_used, reason = "the sources of the workspace are there")]

mod sources;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use mdr_crosscheck::ladders::functions;
use mdr_crosscheck::{check_names, subjects};
use sources::{public_functions, sources};

/// Public functions that are no closed forms of the theory.
const EXEMPT: &[(&str, &str)] = &[
    ("closed_form", "chooses among the constructors of profiles, each of which has a row"),
    ("PowerLaw::new", "a validating constructor"),
    ("PowerLaw::with_kappa", "a validating constructor"),
    ("PowerLaw::exponent", "an accessor"),
    ("PowerLaw::coefficient", "an accessor"),
    ("PowerLaw::kappa", "an accessor; κ_n itself has its rows"),
    ("PowerLaw::regime", "a comparison of n with 1/2"),
    ("PowerLawContact::new", "a constructor"),
    ("PowerLawContact::profile", "an accessor"),
    ("PowerLawContact::material", "an accessor"),
    ("PowerLawContact::regime", "a comparison of n with 1/2"),
    ("Equilibria::as_slice", "an accessor"),
    ("Equilibria::stable", "an accessor"),
    ("free_cache", "frees memory; no number comes out"),
    ("double::Inverse::new", "a constructor"),
    ("double::Inverse::stable", "half of double::Inverse::branches, with which a test compares it bit for bit"),
    ("double::Inverse::with_instructions", "a choice; the row of double::Inverse::branches runs all there are"),
    ("double::InstructionSet::available", "which instructions the processor has"),
    ("double::InstructionSet::avx2", "which instructions the processor has"),
    ("double::InstructionSet::avx512", "which instructions the processor has"),
    ("double::InstructionSet::baseline", "which instructions the processor has"),
    ("double::InstructionSet::fastest", "which instructions the processor has"),
    ("double::critical_states_on", "what double::critical_states calls; its row runs all instructions there are"),
    ("double::fate", "an answer, not a number; double-precision demands it"),
    ("Question::new", "checks its inputs"),
    ("Question::enclosures", "what Question::answer rounds to decimals, which have their rows"),
    ("Question::effective_modulus", "an accessor; (1.3) has its row"),
    ("Sum::g", "the sum of its terms; the library has a sum"),
    ("Sum::slope", "the sum of its terms; the library has a sum"),
    ("Sum::integral", "the sum of its terms; the library has a sum"),
    ("FlatPunch::new", "g = 0 has no factor to be wrong; the row of the flat punch runs its contact"),
    ("PowerLawContact::detachment_elongation", "calls detachment_elongation"),
    ("Question::curve", "a constructor; see Curve"),
    ("Question::exact_indentation", "a rational of two inputs; certified-range demands where d is 0"),
    ("Question::is_fold_of_force", "a comparison of two rationals"),
    ("GradedHalfSpace::new", "a validating constructor"),
    ("GradedHalfSpace::winkler", "a validating constructor; its contacts are among those of graded-states"),
    ("GradedHalfSpace::grading", "an accessor"),
    ("GradedHalfSpace::coefficient", "an accessor"),
    ("GradedHalfSpace::work_of_adhesion", "an accessor"),
    ("GradedContact::new", "a constructor"),
    ("GradedContact::with_kappa", "a constructor"),
    ("GradedContact::profile", "an accessor"),
    ("GradedContact::medium", "an accessor"),
    ("GradedContact::threshold_exponent", "(1 - k)/2; its threshold of C has its row"),
    ("GradedContact::regime", "a comparison of n with (1 - k)/2"),
    ("LineContact::new", "a constructor"),
    ("LineContact::cylinder", "a constructor; line-kernel compares its forces"),
    ("LineContact::regime", "a comparison of n with 1/2"),
    ("JohnsonWave::of_alpha", "a constructor"),
    ("JohnsonWave::alpha", "an accessor; the row of JohnsonWave::new has it"),
    ("JohnsonWave::amplitude", "an accessor"),
    ("JohnsonWave::wavelength", "an accessor"),
    ("JohnsonWave::material", "an accessor"),
];

/// Types whose functions are compared with closed forms that have rows, elsewhere.
const COMPARED: &[(&str, &str)] = &[
    ("Curve::", "states in logarithms: crates/mdr-analytic/tests/curve.rs has them beside those of PowerLawContact"),
    ("CertifiedPoint::", "accessors of such a state"),
    ("EnergySum::", "sums of the energies of such states, which the balance of a path of a power law prints"),
    ("PathPoint::", "accessors of a state on a path"),
    ("Scaled::", "sums and signs of enclosures with an exponent of their own"),
];

#[test]
fn the_parser_sees_functions_and_methods() {
    let source = "pub fn free() {}\nimpl<R: A<B>> Ball<R> {\n    pub fn method(&self) {}\n    fn private() {}\n}\n\
                  impl<R: Real> Transform<R> for Cone<R> {\n}\npub fn last() {}\n";
    let expected = ["free", "Ball::method", "Cone::g", "Cone::slope", "Cone::integral", "last"];
    assert_eq!(public_functions(source), expected);
}

#[test]
fn every_public_closed_form_has_a_row() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mdr-analytic/src");
    let files = sources(&root);
    let found: BTreeSet<String> = files
        .iter()
        .filter(|path| path.file_name().is_some_and(|name| name != "tests.rs"))
        .flat_map(|path| {
            let names = public_functions(&fs::read_to_string(path).unwrap());
            // The functions for f64 have the names of the generic ones.
            let module = if path.iter().any(|part| part == "double") { "double::" } else { "" };
            names.into_iter().map(move |name| format!("{module}{name}"))
        })
        .collect();
    assert!(found.len() > 20, "the sources of mdr-analytic were not found: {found:?}");
    let covered: BTreeSet<&str> =
        subjects().iter().map(|subject| subject.function).chain(EXEMPT.iter().map(|(name, _)| *name)).collect();
    let compared = |name: &String| COMPARED.iter().any(|(prefix, _)| name.starts_with(prefix));
    let missing: Vec<_> = found.iter().filter(|name| !covered.contains(name.as_str()) && !compared(name)).collect();
    assert!(missing.is_empty(), "without a row: {missing:#?}");
    let stale: Vec<_> = covered.iter().filter(|name| !found.contains(**name)).collect();
    assert!(stale.is_empty(), "covered, but not there: {stale:#?}");
}

/// A fault reaches a function for f64 by its name: one that is no subject would never be faulty.
#[test]
fn every_function_of_double_with_a_ladder_is_a_subject() {
    let subjects: BTreeSet<&str> = subjects().iter().map(|subject| subject.function).collect();
    let functions = functions();
    let double: Vec<_> = functions.iter().filter(|name| name.starts_with("double::")).collect();
    assert!(double.len() > 20, "{double:?}");
    let missing: Vec<_> = double.iter().filter(|name| !subjects.contains(name.as_str())).collect();
    assert!(missing.is_empty(), "no subjects: {missing:?}");
}

/// A line that cannot be read, and a check without a line, would be left out in silence.
#[test]
fn every_line_of_the_table_is_a_check_and_every_check_has_a_line() {
    let lines = include_str!("../data/checks.tsv").lines().filter(|line| !line.starts_with('#'));
    assert_eq!(check_names(), lines.map(|line| line.split('\t').next().unwrap()).collect::<Vec<_>>());
    let run = include_str!("../src/checks/mod.rs").lines().filter_map(|line| line.strip_prefix("    (\""));
    let run: BTreeSet<_> = run.filter_map(|line| Some(line.split_once("\", ")?.0)).collect();
    assert_eq!(run, check_names().into_iter().collect());
}
