//! Inputs of a scene that none of its outputs uses.

use crate::answer::OutputKind;
use crate::scene::{Arithmetic, LISTS, Scene};

/// A note for each of the given keys that nothing uses. A scene that is `drawn` has use for its way points and values, wanted or
/// not.
pub(crate) fn unused(scene: &Scene, given: &[String], drawn: bool) -> Vec<String> {
    let is_given = |key: &str| given.iter().any(|known| known == key);
    let wants = |kind: OutputKind| scene.has(|other| other == kind);
    let fields = scene.has(OutputKind::is_of_states);
    let moves =
        drawn || wants(OutputKind::Path) || wants(OutputKind::ForceCurve) || fields && !is_given("[output.equilibria]");
    let no_path = (!moves).then_some("neither a path nor fields at its start are wanted");
    let no_states = (!drawn && !fields && !wants(OutputKind::Equilibria)).then_some("no states are wanted");
    let alone = |kind: OutputKind| (!wants(kind)).then_some("it is not wanted");
    let list = |(kind, _): (OutputKind, _)| {
        (format!("[output.{}]", kind.name()), if kind == OutputKind::Equilibria { no_states } else { alone(kind) })
    };
    let of_control = ["[control] path", "[control] start"].map(|key| (key.to_owned(), no_path));
    let others = [("[output.folds] range", no_range(scene)), ("[output] points", alone(OutputKind::ForceCurve))];
    let keys = of_control.into_iter().chain(LISTS.map(list)).chain(others.map(|(key, why)| (key.to_owned(), why)));
    keys.filter(|(key, _)| is_given(key))
        .filter_map(|(key, why)| Some(format!("{key} is not used: {}", why?)))
        .collect()
}

/// Why a range of contact radii for the proof of folds is of no use, where it is of none.
fn no_range(scene: &Scene) -> Option<&'static str> {
    let moves = scene.has(|kind| matches!(kind, OutputKind::Equilibria | OutputKind::Path));
    if !moves && !scene.has(|kind| kind == OutputKind::Folds) {
        return Some("neither folds nor equilibria nor a path are wanted");
    }
    if scene.arithmetic == Arithmetic::Double {
        return Some("nothing is proved in f64");
    }
    #[cfg(feature = "mp")]
    if scene.medium.is_half_space() && scene.profile.exact_power_law(mdr_core::number::Literal::to_rational).is_some() {
        return Some("the folds of a power law are a closed form, on all radii");
    }
    let searched = !scene.is_closed() && scene.profile.rows().is_none();
    searched.then_some("folds of a formula are searched, not proved")
}
