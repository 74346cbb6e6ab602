//! What proofs of equilibria claim, in few bits and where they are delicate, against a truth of 400 bits.

#![cfg(all(feature = "mp", feature = "toml"))]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr::contact::{EquilibriumBranches, SearchedBranches};
use mdr::{Scene, no_files};
use mdr_core::contact::{Equilibrium, FoldKind, Stability};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::proof::{EnclosedCurve, ProvedBranches};
use rug::Float;

const TRUTH: u32 = 400;

fn scene(profile: &str, control: &str) -> Scene {
    adhering(profile, control, "1e-3")
}

fn adhering(profile: &str, control: &str, work: &str) -> Scene {
    let text = format!(
        "material = {{ e_star = 1, work_of_adhesion = \"{work}\" }}\nprofile = {{ {profile} }}\ncontrol.kind = \"{control}\"\n\
         output = {{ want = [\"folds\"] }}"
    );
    Scene::from_toml(&text, "a test", &no_files).unwrap()
}

/// The branches with proved folds at radii from 10⁻³ to 2, in so many bits.
fn branches(scene: &Scene, bits: u32) -> ProvedBranches {
    let precision = Precision::new(bits);
    let contact = scene.contact_in::<Interval>(precision).unwrap();
    let curve = EnclosedCurve::new(contact, scene.contact_in::<Dual<Interval>>(precision).unwrap());
    let [from, to] = [1e-3, 2.0].map(|radius| Float::with_val(bits, radius));
    let proved = curve.folds(&from, &to, 100_000).unwrap();
    assert!(proved.is_complete(), "{:?}", proved.undecided);
    ProvedBranches::new(curve, &proved).unwrap()
}

fn number(text: &str, bits: u32) -> Interval {
    Interval::from_literal(Precision::new(bits), &text.parse().unwrap())
}

/// Radius, indentation and force of each state contain those of the truth.
fn contain(few: &[Equilibrium<Interval>], truth: &[Equilibrium<Interval>], what: &str) {
    assert_eq!(few.len(), truth.len(), "{what}");
    let numbers =
        |state: &Equilibrium<Interval>| [&state.contact_radius, &state.indentation, &state.force].map(Interval::clone);
    for (state, exact) in few.iter().zip(truth) {
        assert_eq!(state.stability, exact.stability, "{what}");
        for (own, exact) in numbers(state).iter().zip(&numbers(exact)) {
            let is_inside = own.lower() <= exact.lower() && exact.upper() <= own.upper();
            assert!(is_inside, "{what}: {own:?} does not contain {exact:?}");
        }
    }
}

/// A number near the state is no proof of it: the enclosures hold states of more bits.
#[test]
fn equilibria_of_few_bits_contain_the_truth() {
    for profile in [
        "kind = \"sphere\", radius = 3",
        "kind = \"hyperboloid\", slope = \"0.3\", lateral = \"0.1\"",
        "kind = \"cone-parabolic-cap\", slope = \"0.3\", cap = \"0.2\"",
        "kind = \"wavy-paraboloid\", radius = 1, amplitude = \"1e-3\", wavelength = \"0.5\"",
    ] {
        for (control, values) in [("indentation", ["0.01", "0.1", "0.17"]), ("force", ["-0.001", "0.01", "0.2"])] {
            let scene = scene(profile, control);
            let truth = branches(&scene, TRUTH);
            for bits in [60, 75, 100] {
                let few = branches(&scene, bits);
                for value in values {
                    let what = format!("{profile}, {control} {value}, {bits} bits");
                    let [few, truth] = [(&few, bits), (&truth, TRUTH)]
                        .map(|(branches, bits)| branches.equilibria(&number(value, bits)).unwrap());
                    assert!(!few.is_empty(), "{what}");
                    contain(&few, &truth, &what);
                }
            }
        }
    }
}

/// Closer to the equator of a sphere than numbers of few bits are: the mean of g up to there is bounded, not known. Without a load d
/// is the mean itself, and the elongation of 80 radii draws the edge to 1 − a/R = 10⁻⁶⁹.
#[test]
fn equilibria_before_an_equator_contain_the_truth() {
    let scene = adhering("kind = \"sphere\", radius = 1", "force", "1000");
    let truth = branches(&scene, TRUTH);
    for bits in [64, 72, 80, 100] {
        let few = branches(&scene, bits);
        for value in ["0", "0.01", "-0.01"] {
            let few = few.equilibria(&number(value, bits)).unwrap();
            contain(&few, &truth.equilibria(&number(value, TRUTH)).unwrap(), &format!("{value}, {bits} bits"));
        }
    }
}

/// C falls where the slope of the heights jumps down: a maximum of what is controlled, at the kink itself.
#[test]
fn a_maximum_at_a_kink_is_a_fold() {
    let branches =
        branches(&scene("kind = \"expression\", formula = \"r^2/2 - 0.1*max(0, r - 0.5)\"", "indentation"), 100);
    let kinds: Vec<_> = branches.folds().iter().map(|fold| fold.kind).collect();
    assert_eq!(kinds, [FoldKind::Minimum, FoldKind::Maximum, FoldKind::Minimum]);
    assert!(branches.folds()[1].contact_radius.contains(&Float::with_val(100, 0.5)));
}

/// At the very value of a fold the two branches beside it have no other state there.
#[test]
fn at_the_value_of_a_fold_there_is_the_fold() {
    for control in ["indentation", "force"] {
        let wavy = "kind = \"wavy-paraboloid\", radius = 1, amplitude = \"5e-3\", wavelength = \"0.5\"";
        for profile in ["kind = \"sphere\", radius = 3", wavy] {
            let contact = scene(profile, control).contact_in::<f64>(()).unwrap();
            let branches = SearchedBranches::new(contact).unwrap();
            assert!(!branches.folds().is_empty());
            for (index, fold) in branches.folds().iter().enumerate() {
                let value = if control == "force" { fold.force } else { fold.indentation };
                let what = format!("{profile}, {control}, fold {index}");
                let beside = |branch: usize| branches.on_branch(branch, &value).unwrap();
                assert!(beside(index).is_none() && beside(index + 1).is_none(), "{what}");
                let states = branches.equilibria(&value).unwrap();
                let neutral: Vec<_> = states.iter().filter(|state| state.stability == Stability::Neutral).collect();
                assert_eq!(neutral.len(), 1, "{what}");
                assert_eq!(neutral[0].contact_radius, fold.contact_radius, "{what}");
            }
        }
    }
}
