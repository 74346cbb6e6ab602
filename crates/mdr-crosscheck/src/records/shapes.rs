//! The profiles of the library in the records.

use super::folds::Scene;
use super::library::Profile;

/// The profiles of the library, and the radii at which they are transformed.
pub(super) const LIBRARY: [(Profile, &[&str]); 16] = [
    (Profile { kind: "cone", parameters: &[("slope", "0.2")] }, &["0.3", "1e-9"]),
    (Profile { kind: "paraboloid", parameters: &[("radius", "0.01")] }, &["0.0001", "2e-12"]),
    (Profile { kind: "sphere", parameters: &[("radius", "1")] }, &["1e-8", "0.3", "0.9", "0.999999"]),
    (Profile { kind: "ellipsoid", parameters: &[("lateral", "2"), ("height", "0.5")] }, &["0.01", "1.5"]),
    (Profile { kind: "hyperboloid", parameters: &[("slope", "0.7"), ("lateral", "0.1")] }, &["1e-7", "0.05", "30"]),
    (Profile { kind: "truncated-cone", parameters: &[("slope", "0.5"), ("flat", "1")] }, &["1.0001", "1.5", "100"]),
    (Profile { kind: "truncated-paraboloid", parameters: &[("radius", "5"), ("flat", "1")] }, &["1.0001", "2"]),
    (Profile { kind: "rounded-punch", parameters: &[("radius", "5"), ("flat", "1")] }, &["1.0001", "1.5", "1000"]),
    (Profile { kind: "cone-parabolic-cap", parameters: &[("slope", "0.5"), ("cap", "1")] }, &["0.5", "1.001", "4"]),
    (Profile { kind: "cone-spherical-cap", parameters: &[("slope", "0.75"), ("radius", "1")] }, &["0.3", "0.61", "3"]),
    (
        Profile { kind: "displaced-paraboloid", parameters: &[("radius", "2"), ("offset", "0.5")] },
        &["0.1", "0.785", "3"],
    ),
    (Profile { kind: "parabolic-dimple", parameters: &[("depth", "0.1"), ("radius", "1")] }, &["0.5", "1.001", "20"]),
    (
        Profile { kind: "elliptical-dimple", parameters: &[("depth", "0.1"), ("radius", "1")] },
        &["0.01", "0.5", "0.999"],
    ),
    (
        Profile {
            kind: "wavy-paraboloid",
            parameters: &[("radius", "1"), ("amplitude", "0.0005"), ("wavelength", "0.1")],
        },
        &["0.001", "0.0645", "0.5"],
    ),
    (Profile { kind: "sum", parameters: &[("radius", "1"), ("slope", "0.1")] }, &["0.05", "10"]),
    (
        Profile {
            kind: "wavy-paraboloid",
            parameters: &[("radius", "1"), ("amplitude", "-0.001"), ("wavelength", "0.25")],
        },
        &["0.11"],
    ),
];

/// Contacts of the library whose folds are records.
pub(super) const SCENES: [Scene; 9] = [
    scene("ball", "sphere", &[("radius", "1")], ("1", "0.001"), (1e-6, 0.999)),
    scene("large-ball-contact", "sphere", &[("radius", "1")], ("1", "0.5"), (1e-6, 0.999)),
    scene("oblate", "ellipsoid", &[("lateral", "2"), ("height", "0.5")], ("1", "0.01"), (1e-6, 1.999)),
    scene("hyperboloid", "hyperboloid", &[("slope", "0.7"), ("lateral", "0.1")], ("1", "0.01"), (1e-6, 1e3)),
    scene("rounded-punch", "rounded-punch", &[("radius", "1"), ("flat", "0.1")], ("1", "0.1"), (1e-6, 1e3)),
    scene("capped-cone", "cone-parabolic-cap", &[("slope", "0.5"), ("cap", "0.01")], ("1", "0.1"), (1e-6, 1e3)),
    scene("ridge", "displaced-paraboloid", &[("radius", "1"), ("offset", "0.1")], ("1", "0.1"), (1e-6, 1e3)),
    scene("bearing-and-spike", "sum", &[("radius", "1"), ("slope", "0.1")], ("1", "0.001"), (1e-6, 1e3)),
    scene(
        "figure-4",
        "wavy-paraboloid",
        &[("radius", "1"), ("amplitude", "0.0005"), ("wavelength", "0.1")],
        ("1", "0.0001"),
        (1e-6, 1e3),
    ),
];

const fn scene(
    name: &'static str,
    kind: &'static str,
    parameters: &'static [(&'static str, &'static str)],
    (e_star, work): (&'static str, &'static str),
    range: (f64, f64),
) -> Scene {
    Scene { name, profile: Profile { kind, parameters }, e_star, work, range }
}

/// Radii beyond the end of a profile, or on its singular edge.
pub(super) const BEYOND: [(Profile, &str); 4] = [
    (Profile { kind: "sphere", parameters: &[("radius", "1")] }, "1.5"),
    (Profile { kind: "sphere", parameters: &[("radius", "1")] }, "-0.1"),
    (Profile { kind: "ellipsoid", parameters: &[("lateral", "2"), ("height", "0.5")] }, "2"),
    (Profile { kind: "elliptical-dimple", parameters: &[("depth", "0.1"), ("radius", "1")] }, "1"),
];

/// A ridge that is touched inside of its crest.
pub(super) const RIDGE: Profile =
    Profile { kind: "displaced-paraboloid", parameters: &[("radius", "1"), ("offset", "0.5")] };

/// Its material.
pub(super) const RIDGE_MATERIAL: [(&str, &str); 2] = [("E*", "1"), ("w", "1e-6")];

/// Contact radii inside of the crest.
pub(super) const INSIDE: [&str; 3] = ["0.001", "0.05", "0.2"];
