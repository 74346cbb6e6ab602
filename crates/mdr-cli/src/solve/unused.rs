//! What a scene says that none of its outputs uses.

use super::power_law;
use crate::flags::Arithmetic;
use crate::scene::{Scene, Want};

/// A note for each key that nothing uses. A scene that is `drawn` has use for its way points and values, wanted or not.
pub(super) fn notes(scene: &Scene, drawn: bool) -> Vec<String> {
    let (held, output) = (&scene.held, &scene.output);
    let wants = |want: Want| output.wants(|other| other == want);
    let fields = output.wants(Want::is_of_states);
    let moves = drawn || wants(Want::Path) || fields && output.values.is_empty();
    let no_path = (!moves).then_some("neither a path nor fields at its start are wanted");
    let no_states = (!drawn && !fields && !wants(Want::Equilibria)).then_some("no states are wanted");
    let alone = |want: Want| (!wants(want)).then_some("it is not wanted");
    [
        ("[control] path", !held.path.is_empty(), no_path),
        ("[control] start", held.start_place.is_some(), no_path),
        ("[output.transform]", !output.transform.is_empty(), alone(Want::Transform)),
        ("[output.equilibria]", !output.values.is_empty(), no_states),
        ("[output.curve]", !output.curve.is_empty(), alone(Want::Curve)),
        ("[output.pressure]", !output.pressure.is_empty(), alone(Want::Pressure)),
        ("[output.gap]", !output.gap.is_empty(), alone(Want::Gap)),
        ("[output.displacement]", !output.displacement.is_empty(), alone(Want::Displacement)),
        ("[output.folds] range", output.range.is_some(), no_range(scene)),
    ]
    .into_iter()
    .filter(|(_, given, _)| *given)
    .filter_map(|(key, _, why)| Some(format!("{key} is not used: {}", why?)))
    .collect()
}

/// Why a range of contact radii for the proof of folds is of no use, where it is of none.
fn no_range(scene: &Scene) -> Option<&'static str> {
    let moves = scene.output.wants(|want| matches!(want, Want::Equilibria | Want::Path));
    if !moves && !scene.output.wants(|want| want == Want::Folds) {
        Some("neither folds nor equilibria nor a path are wanted")
    } else if scene.output.arithmetic == Arithmetic::Double {
        Some("nothing is proved in f64")
    } else if power_law::is_power_law(&scene.profile) {
        Some("the folds of a power law are a closed form, on all radii")
    } else {
        let searched = !scene.profile.is_closed() && scene.profile.rows().is_none();
        searched.then_some("folds of a formula are searched, not proved")
    }
}
