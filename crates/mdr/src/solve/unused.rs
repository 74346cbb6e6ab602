//! Inputs of a scene that none of its outputs uses.

use crate::answer::OutputKind;
use crate::outputs::key::{Key, keyed};
use crate::scene::Scene;

/// A note for each of the given keys that nothing uses. A scene that is `drawn` has use for its way points and values, wanted or
/// not.
pub(crate) fn unused(scene: &Scene, given: &[String], drawn: bool) -> Vec<String> {
    let is_given = |key: &str| given.iter().any(|known| known == key);
    let values = keyed().into_iter().find(|(_, key)| matches!(key, Key::Values));
    let at_values = values.is_some_and(|(kind, key)| is_given(&key.label(kind)));
    let moves = drawn || scene.has(OutputKind::moves) || scene.has(OutputKind::is_of_states) && !at_values;
    let no_path = (!moves).then_some("neither a path nor fields at its start are wanted");
    let of_control = ["[control] path", "[control] start"].map(|key| (key.to_owned(), no_path));
    let of_outputs = keyed().into_iter().map(|(kind, key)| (key.label(kind), kind.unused(scene, drawn)));
    let keys = of_control.into_iter().chain(of_outputs);
    keys.filter(|(key, _)| is_given(key))
        .filter_map(|(key, why)| Some(format!("{key} is not used: {}", why?)))
        .collect()
}
