//! Waves near complete contact.

use super::{LOAD, PERIODIC, scene, solve};
use mdr::prelude::*;

/// Stability and contact radius of the states at each value.
fn listed(text: &str) -> Vec<Vec<(Stability, f64)>> {
    let answer = solve(text);
    let values = &answer.equilibria().expect("wanted").items;
    let state = |items: &[mdr::answer::Equilibrium]| {
        items.iter().map(|state| (state.stability, state.contact_radius.to_f64().expect("a number"))).collect()
    };
    values.iter().map(|at| state(&at.items)).collect()
}

/// Beyond the last fold a contact grows until it is complete, which is no state of a rim: rounding makes none either, where g, its mean and
/// d tend to one height. The lists of f64 are the proved ones.
#[test]
fn doubles_list_no_state_at_complete_contact() {
    let machine = "kind = \"machine\"\nstiffness = 2";
    for (amplitude, control, at) in [
        ("1", LOAD, ["0.05", "1", "2.5", "1e3"]),
        ("20", LOAD, ["-0.5", "30", "3e3", "1e4"]),
        ("1", machine, ["0.2", "1", "1.5", "1e3"]),
        ("20", machine, ["0.2", "5", "30", "1e4"]),
    ] {
        let wave = format!("kind = \"wave\"\namplitude = \"{amplitude}\"");
        let text = |digits: &str| {
            scene(PERIODIC, &wave, control, &format!("want = [\"equilibria\"]\nequilibria.at = {at:?}\n{digits}"))
        };
        let [found, proved] = ["arithmetic = \"f64\"", "digits = 17"].map(|digits| listed(&text(digits)));
        assert!(
            proved.iter().any(Vec::is_empty) && proved.iter().any(|at| !at.is_empty()),
            "{wave} {control}: {proved:?}"
        );
        for (found, proved) in found.iter().zip(&proved) {
            let same = found.len() == proved.len()
                && found
                    .iter()
                    .zip(proved)
                    .all(|(one, other)| one.0 == other.0 && (one.1 / other.1 - 1.0).abs() < 1e-9);
            assert!(same, "{wave} {control}: {found:?} {proved:?}");
        }
    }
}
