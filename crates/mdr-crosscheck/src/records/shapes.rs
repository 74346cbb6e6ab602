//! The profiles of the library in the records.

use super::folds::Scene;
use super::library::Profile;
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
