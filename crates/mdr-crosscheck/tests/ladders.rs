//! Stability ladders: nothing wrong in silence, and no more than one digit lost beyond what the question costs.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

mod sources;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use mdr_crosscheck::Level;
use mdr_crosscheck::ladders::{Family, Found, Ladder, MOST_EXCESS, functions, ladders, worst_inputs};
use sources::{public_functions, sources};

static LADDERS: LazyLock<Vec<Ladder>> = LazyLock::new(|| ladders(Level::Quick));

#[test]
fn every_ladder_is_accepted() {
    for ladder in LADDERS.iter() {
        assert!(ladder.accepted(), "{} | {}: {:?}", ladder.function, ladder.toward, ladder.worst().unwrap());
    }
}

/// The closed forms in f64 have no open case: each is within an ulp or says what it cannot hold.
#[test]
fn the_functions_of_double_are_right_to_an_ulp() {
    let mut asked = 0;
    for ladder in LADDERS.iter().filter(|ladder| ladder.function.starts_with("double::")) {
        for rung in &ladder.rungs {
            asked += 1;
            let right = match rung.found {
                Found::Number { ulp, .. } => ulp <= 1.0,
                Found::Beyond { .. } | Found::Refused => true,
                _ => false,
            };
            assert!(right, "{} | {}: {rung:?}", ladder.function, ladder.toward);
        }
    }
    assert!(asked > 1000, "{asked}");
}

/// What the ladders are for: the formulas of textbooks do not pass them.
#[test]
fn naive_formulas_are_caught() {
    let loses = |function: &str, family: Family| {
        let ladder = |ladder: &&Ladder| ladder.function == function && ladder.family == family;
        LADDERS.iter().filter(ladder).filter_map(Ladder::worst_naive).fold(0.0, f64::max)
    };
    for (function, family) in [
        ("double::kappa", Family::LargeExponent),
        ("double::critical, fixed grips, d", Family::Half),
        ("double::universal_indentation", Family::Half),
        ("Sphere::g", Family::Tip),
        ("Sphere::integral", Family::Tip),
        ("TruncatedParaboloid::g", Family::Scale),
        ("RoundedPunch::g", Family::Edge),
        ("ParabolicDimple::g", Family::Far),
        ("WavyParaboloid::g", Family::Wavelength),
    ] {
        let ulp = loses(function, family);
        assert!(ulp > 1e3, "{function}, {family:?}: {ulp}");
    }
}

#[test]
fn the_worst_inputs_are_no_worse_than_they_were() {
    /// The excess is kept to two digits.
    const ROUNDING: f64 = 0.01;
    let kept = worst_inputs().unwrap();
    assert!(kept.len() > 50, "{}", kept.len());
    for worst in kept {
        let rung = worst.ask().unwrap_or_else(|| panic!("no function {}", worst.function));
        let excess = rung.excess().unwrap_or_else(|| panic!("{worst:?}: {:?}", rung.found));
        assert!(excess <= worst.excess.max(MOST_EXCESS) + ROUNDING, "{worst:?}: {:?}", rung.found);
    }
}

/// Functions of f64 without a ladder.
const EXEMPT: &[(&str, &str)] = &[
    ("double::fate", "an answer, not a number"),
    ("double::InstructionSet::available", "which instructions the processor has"),
    ("double::InstructionSet::avx2", "which instructions the processor has"),
    ("double::InstructionSet::avx512", "which instructions the processor has"),
    ("double::InstructionSet::baseline", "which instructions the processor has"),
    ("double::InstructionSet::fastest", "which instructions the processor has"),
    ("double::critical_states", "the tests of mdr-analytic compare it with 128 bits over its whole domain"),
    ("double::critical_states_on", "as double::critical_states"),
    ("double::equilibria", "a row of the cross-check compares it with the branches of the numerical route"),
    ("double::equilibria_at_distance", "as double::equilibria"),
    ("double::Inverse::new", "a validating constructor"),
    ("double::Inverse::equilibria", "as double::equilibria"),
    ("double::Inverse::branches", "as double::equilibria"),
    ("double::Inverse::stable", "as double::equilibria"),
    ("double::Inverse::with_instructions", "a choice, not a number"),
];

#[test]
fn every_public_function_of_f64_has_a_ladder() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mdr-analytic/src");
    let in_folder = |folder: &str| -> BTreeSet<String> {
        let files = sources(&root.join(folder));
        files.iter().flat_map(|file| public_functions(&fs::read_to_string(file).unwrap())).collect()
    };
    let double = in_folder("double").into_iter().map(|name| format!("double::{name}"));
    let profiles = in_folder("profiles");
    let profiles = profiles.iter().filter_map(|name| name.strip_suffix("::new"));
    let parts = profiles.flat_map(|profile| ["g", "slope", "integral"].map(|part| format!("{profile}::{part}")));
    let wanted: BTreeSet<String> = double.chain(parts).collect();
    assert!(wanted.len() > 60, "{wanted:?}");
    let mut had: BTreeSet<String> = functions().into_iter().collect();
    had.extend(EXEMPT.iter().map(|(name, _)| (*name).to_owned()));
    let missing: Vec<_> = wanted.difference(&had).collect();
    assert!(missing.is_empty(), "without a ladder: {missing:#?}");
}
