//! The profiles of the library in the records.

use super::contacts::{At, Contacts};
use super::folds::Scene;
use super::library::Profile;
use super::load::Load;
use super::states::Punch;
use crate::library::Shape;

/// The profiles of the library, and the radii at which they are transformed.
pub(super) const LIBRARY: [(Profile<'static>, &[&str]); 16] = [
    (Profile { shape: Shape::Cone, parameters: &[("slope", "0.2")] }, &["0.3", "1e-9"]),
    (Profile { shape: Shape::Paraboloid, parameters: &[("radius", "0.01")] }, &["0.0001", "2e-12"]),
    (Profile { shape: Shape::Sphere, parameters: &[("radius", "1")] }, &["1e-8", "0.3", "0.9", "0.999999"]),
    (Profile { shape: Shape::Ellipsoid, parameters: &[("lateral", "2"), ("height", "0.5")] }, &["0.01", "1.5"]),
    (
        Profile { shape: Shape::Hyperboloid, parameters: &[("slope", "0.7"), ("lateral", "0.1")] },
        &["1e-7", "0.05", "30"],
    ),
    (
        Profile { shape: Shape::TruncatedCone, parameters: &[("slope", "0.5"), ("flat", "1")] },
        &["1.0001", "1.5", "100"],
    ),
    (Profile { shape: Shape::TruncatedParaboloid, parameters: &[("radius", "5"), ("flat", "1")] }, &["1.0001", "2"]),
    (Profile { shape: Shape::RoundedPunch, parameters: &[("radius", "5"), ("flat", "1")] }, &["1.0001", "1.5", "1000"]),
    (Profile { shape: Shape::ParabolicCapCone, parameters: &[("slope", "0.5"), ("cap", "1")] }, &["0.5", "1.001", "4"]),
    (
        Profile { shape: Shape::SphericalCapCone, parameters: &[("slope", "0.75"), ("radius", "1")] },
        &["0.3", "0.61", "3"],
    ),
    (
        Profile { shape: Shape::DisplacedParaboloid, parameters: &[("radius", "2"), ("offset", "0.5")] },
        &["0.1", "0.785", "3"],
    ),
    (
        Profile { shape: Shape::ParabolicDimple, parameters: &[("depth", "0.1"), ("radius", "1")] },
        &["0.5", "1.001", "20"],
    ),
    (
        Profile { shape: Shape::EllipticalDimple, parameters: &[("depth", "0.1"), ("radius", "1")] },
        &["0.01", "0.5", "0.999"],
    ),
    (
        Profile {
            shape: Shape::WavyParaboloid,
            parameters: &[("radius", "1"), ("amplitude", "0.0005"), ("wavelength", "0.1")],
        },
        &["0.001", "0.0645", "0.5"],
    ),
    (Profile { shape: Shape::Sum, parameters: &[("radius", "1"), ("slope", "0.1")] }, &["0.05", "10"]),
    (
        Profile {
            shape: Shape::WavyParaboloid,
            parameters: &[("radius", "1"), ("amplitude", "-0.001"), ("wavelength", "0.25")],
        },
        &["0.11"],
    ),
];

/// Contacts of the library whose folds are records.
pub(super) const SCENES: [Scene; 9] = [
    scene("ball", Shape::Sphere, &[("radius", "1")], ("1", "0.001"), (1e-6, 0.999)),
    scene("large-ball-contact", Shape::Sphere, &[("radius", "1")], ("1", "0.5"), (1e-6, 0.999)),
    scene("oblate", Shape::Ellipsoid, &[("lateral", "2"), ("height", "0.5")], ("1", "0.01"), (1e-6, 1.999)),
    scene("hyperboloid", Shape::Hyperboloid, &[("slope", "0.7"), ("lateral", "0.1")], ("1", "0.01"), (1e-6, 1e3)),
    scene("rounded-punch", Shape::RoundedPunch, &[("radius", "1"), ("flat", "0.1")], ("1", "0.1"), (1e-6, 1e3)),
    scene("capped-cone", Shape::ParabolicCapCone, &[("slope", "0.5"), ("cap", "0.01")], ("1", "0.1"), (1e-6, 1e3)),
    scene("ridge", Shape::DisplacedParaboloid, &[("radius", "1"), ("offset", "0.1")], ("1", "0.1"), (1e-6, 1e3)),
    scene("bearing-and-spike", Shape::Sum, &[("radius", "1"), ("slope", "0.1")], ("1", "0.001"), (1e-6, 1e3)),
    scene(
        "figure-4",
        Shape::WavyParaboloid,
        &[("radius", "1"), ("amplitude", "0.0005"), ("wavelength", "0.1")],
        ("1", "0.0001"),
        (1e-6, 1e3),
    ),
];

/// Contacts whose folds on machines are records, and stiffnesses in N/m.
const MACHINES: [(&str, &str); 6] = [
    ("ball", "0.1"),
    ("hyperboloid", "0.05"),
    ("rounded-punch", "1"),
    ("bearing-and-spike", "0.1"),
    ("figure-4", "0.01"),
    ("figure-4", "1"),
];

pub(super) fn machines() -> impl Iterator<Item = (Scene, &'static str)> {
    MACHINES.into_iter().map(|(name, stiffness)| (named(name), stiffness))
}

/// Contacts whose equilibria are records, and the values of what is held.
const EQUILIBRIA: [(&str, Load, &str); 19] = [
    ("ball", Load::Indentation, "-0.01"),
    ("ball", Load::Indentation, "0.25"),
    ("ball", Load::Force, "-0.004"),
    ("ball", Load::Machine("0.1"), "-0.02"),
    ("large-ball-contact", Load::Indentation, "-0.5"),
    ("oblate", Load::Force, "-0.3"),
    ("hyperboloid", Load::Indentation, "-0.03"),
    ("hyperboloid", Load::Force, "1"),
    ("hyperboloid", Load::Machine("0.05"), "-0.1"),
    ("rounded-punch", Load::Indentation, "-0.25"),
    ("rounded-punch", Load::Force, "-0.5"),
    ("capped-cone", Load::Indentation, "-0.1"),
    ("ridge", Load::Indentation, "-0.2"),
    ("ridge", Load::Force, "0.5"),
    ("bearing-and-spike", Load::Force, "-0.002"),
    ("figure-4", Load::Indentation, "-0.00183"),
    ("figure-4", Load::Indentation, "0.01"),
    ("figure-4", Load::Force, "-0.0005"),
    ("figure-4", Load::Machine("1"), "-0.002"),
];

/// Jumps that end in another contact, by the number of their fold.
const JUMPS: [(&str, Load, usize); 4] = [
    ("figure-4", Load::Indentation, 2),
    ("figure-4", Load::Indentation, 3),
    ("figure-4", Load::Machine("1"), 2),
    ("figure-4", Load::Machine("1"), 3),
];

pub(super) fn contacts() -> impl Iterator<Item = Contacts> {
    let values = EQUILIBRIA.into_iter().map(|(name, load, value)| (name, load, At::Value(value)));
    let jumps = JUMPS.into_iter().map(|(name, load, fold)| (name, load, At::Fold(fold)));
    values.chain(jumps).map(|(name, load, at)| Contacts { scene: named(name), load, at })
}

/// Contacts of which states are records, and their contact radii.
const STATES: [(&str, &[&str]); 6] = [
    ("ball", &["0.001", "0.2", "0.9"]),
    ("hyperboloid", &["0.01", "5"]),
    ("rounded-punch", &["0.11", "0.8"]),
    ("capped-cone", &["0.005", "0.3"]),
    ("ridge", &["0.15", "1"]),
    ("bearing-and-spike", &["0.02", "1"]),
];

pub(super) fn states() -> impl Iterator<Item = (Scene, &'static [&'static str])> {
    STATES.into_iter().map(|(name, radii)| (named(name), radii))
}

/// The scene of a name of the lists above.
pub(super) fn named(name: &str) -> Scene {
    SCENES.into_iter().find(|scene| scene.name == name).unwrap_or_else(|| unreachable!("{name}"))
}

/// Flat punches: of unit size, a flattened tip of an atomic force microscope, and a pillar of silicone.
pub(super) const PUNCHES: [Punch; 3] = [
    Punch { name: "unit", radius: "1", e_star: "1", work: "1" },
    Punch { name: "afm-tip", radius: "1e-8", e_star: "7e10", work: "0.1" },
    Punch { name: "pdms-pillar", radius: "5e-4", e_star: "2e6", work: "0.05" },
];

const fn scene(
    name: &'static str,
    shape: Shape,
    parameters: &'static [(&'static str, &'static str)],
    (e_star, work): (&'static str, &'static str),
    range: (f64, f64),
) -> Scene {
    Scene { name, profile: Profile { shape, parameters }, e_star, work, range }
}

/// Radii beyond the end of a profile, or on its singular edge.
pub(super) const BEYOND: [(Profile<'static>, &str); 4] = [
    (Profile { shape: Shape::Sphere, parameters: &[("radius", "1")] }, "1.5"),
    (Profile { shape: Shape::Sphere, parameters: &[("radius", "1")] }, "-0.1"),
    (Profile { shape: Shape::Ellipsoid, parameters: &[("lateral", "2"), ("height", "0.5")] }, "2"),
    (Profile { shape: Shape::EllipticalDimple, parameters: &[("depth", "0.1"), ("radius", "1")] }, "1"),
];

/// A ridge that is touched inside of its crest.
pub(super) const RIDGE: Profile =
    Profile { shape: Shape::DisplacedParaboloid, parameters: &[("radius", "1"), ("offset", "0.5")] };

/// Its material.
pub(super) const RIDGE_MATERIAL: [(&str, &str); 2] = [("E*", "1"), ("w", "1e-6")];

/// Contact radii inside of the crest.
pub(super) const INSIDE: [&str; 3] = ["0.001", "0.05", "0.2"];

/// The names of the parameters of a shape of the library.
pub(super) fn parameters(shape: Shape) -> impl Iterator<Item = &'static str> {
    let known = LIBRARY.into_iter().find(|(profile, _)| profile.shape == shape);
    known.into_iter().flat_map(|(profile, _)| profile.parameters.iter().map(|(name, _)| *name))
}
