//! Numbers with units in scenes: every key answers as its SI number does, and a unit of another dimension is refused.
#![cfg(all(feature = "mp", feature = "toml", feature = "serde"))]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr::no_files;
use mdr::prelude::*;

/// A profile of each kind with numbers in SI, and with units.
const PROFILES: [(&str, [&str; 2]); 16] = [
    ("power", ["n = 2\nc = 1e5", "n = \"2\"\nc = \"1e5\""]),
    ("paraboloid", ["radius = 5e-6", "radius = \"5 um\""]),
    ("cone", ["half_angle_degrees = 70", "half_angle_degrees = \"70 deg\""]),
    ("sphere", ["radius = 5e-6", "radius = \"5um\""]),
    ("ellipsoid", ["lateral = 5e-6\nheight = 2e-6", "lateral = \"5 µm\"\nheight = \"2000 nm\""]),
    ("flat-punch", ["radius = 5e-6", "radius = \"5 μm\""]),
    ("truncated-cone", ["slope = 0.1\nflat = 1e-7", "slope = \"1/10\"\nflat = \"0.1 um\""]),
    ("truncated-paraboloid", ["radius = 5e-6\nflat = 1e-7", "radius = \"5 um\"\nflat = \"100 nm\""]),
    ("cone-parabolic-cap", ["slope = 0.1\ncap = 1e-7", "slope = 0.1\ncap = \"100nm\""]),
    ("cone-spherical-cap", ["slope = 0.1\nradius = 1e-7", "slope = 0.1\nradius = \"100nm\""]),
    ("hyperboloid", ["slope = 0.1\nlateral = 1e-7", "slope = 0.1\nlateral = \"100 nm\""]),
    ("rounded-punch", ["radius = 5e-6\nflat = 1e-7", "radius = \"5 um\"\nflat = \"1e-1 um\""]),
    ("displaced-paraboloid", ["radius = 5e-6\noffset = 1e-7", "radius = \"5 um\"\noffset = \"100 nm\""]),
    ("parabolic-dimple", ["depth = 1e-9\nradius = 5e-6", "depth = \"1 nm\"\nradius = \"5 um\""]),
    ("elliptical-dimple", ["depth = 1e-9\nradius = 5e-6", "depth = \"10 Å\"\nradius = \"0.005 mm\""]),
    (
        "wavy-paraboloid",
        [
            "radius = 5e-6\namplitude = -1e-12\nwavelength = 1e-6",
            "radius = \"5 um\"\namplitude = \"-1 pm\"\nwavelength = \"1 um\"",
        ],
    ),
];

const FORMULA: [&str; 2] = [
    "kind = \"expression\"\nformula = \"r^2/(2*R)\"\nparameters = { R = 5e-6 }",
    "kind = \"expression\"\nformula = \"r^2/(2*R)\"\nparameters = { R = \"5 um\" }",
];

/// A scene in which every other key has a number, in SI and with units.
const SCENES: [[&str; 2]; 3] = [
    [
        "[material]\ne_star = 1e9\nwork_of_adhesion = 0.05\nrange_of_adhesion = 3e-10\n[control]\nkind = \"machine\"\nstiffness = 0.3\n\
         path = [0, -5e-10]\nstart = 1e-7\n[output]\nwant = [\"folds\", \"equilibria\", \"pressure\", \"gap\", \"displacement\"]\n\
         equilibria.at = [1e-9]\npressure.at = [1e-8]\ngap.at = [1e-5]\ndisplacement.at = [1e-5]\nfolds.range = [1e-9, 1e-6]",
        "[material]\ne_star = \"1 GPa\"\nwork_of_adhesion = \"50 mJ/m^2\"\nrange_of_adhesion = \"0.3 nm\"\n[control]\n\
         kind = \"machine\"\nstiffness = \"300 mN/m\"\npath = [\"0 nm\", \"-0.5nm\"]\nstart = \"100 nm\"\n[output]\n\
         want = [\"folds\", \"equilibria\", \"pressure\", \"gap\", \"displacement\"]\nequilibria.at = [\"1 nm\"]\n\
         pressure.at = [\"10 nm\"]\ngap.at = [\"10 um\"]\ndisplacement.at = [\"0.01 mm\"]\nfolds.range = [\"1 nm\", \"1 um\"]",
    ],
    [
        "[material]\nbody = [{ e = 1e9, nu = 0.3 }, { e = 2e11, nu = 0.3 }]\nwork_of_adhesion = 0.05\n[control]\nkind = \"force\"\n\
         [output]\nwant = [\"equilibria\", \"curve\"]\nrange_of_adhesion = 3e-10\nequilibria.at = [1e-9, 2e-12, 3e-8]\ncurve.at = [1e-7]",
        "[material]\nbody = [{ e = \"1 GPa\", nu = 0.3 }, { e = \"2e5 MPa\", nu = 0.3 }]\nwork_of_adhesion = \"50 mN/m\"\n[control]\n\
         kind = \"force\"\n[output]\nwant = [\"equilibria\", \"curve\"]\nrange_of_adhesion = \"3 Å\"\n\
         equilibria.at = [\"1 nN\", \"2pN\", \"0.03 uN\"]\ncurve.at = [\"100 nm\"]",
    ],
    [
        "[output]\nwant = [\"transform\"]\ntransform.at = [1e-7, 3e-7]",
        "[output]\nwant = [\"transform\"]\ntransform.at = [\"100 nm\", \"0.3 um\"]",
    ],
];

fn scene(profile: &str, rest: &str) -> String {
    format!("[profile]\n{profile}\n{rest}")
}

/// The answer, with every input in one notation.
fn answer(text: &str) -> String {
    let scene = Scene::from_toml(text, "scene.toml", &no_files).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let answer = scene.solve().unwrap_or_else(|error| panic!("{error}\n{text}")).to_json();
    let mut answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
    one_notation(&mut answer);
    answer.to_string()
}

/// Numbers as fractions, so that 1e-7 and 100e-9 are one.
fn one_notation(value: &mut serde_json::Value) {
    match value {
        serde_json::Value::String(text) => {
            if let Ok(number) = text.parse::<Literal>() {
                *text = number.to_rational().to_string();
            }
        }
        serde_json::Value::Array(items) => items.iter_mut().for_each(one_notation),
        serde_json::Value::Object(entries) => entries.values_mut().for_each(one_notation),
        _ => {}
    }
}

#[test]
fn every_parameter_of_a_shape_may_have_its_unit() {
    assert!(PROFILES.iter().map(|(name, _)| *name).eq(Shape::names()), "each shape has a row");
    for (name, both) in PROFILES {
        let [si, units] = both.map(|keys| answer(&scene(&format!("kind = \"{name}\"\n{keys}"), SCENES[2][0])));
        assert_eq!(si, units, "{name}");
    }
    let [si, units] = FORMULA.map(|profile| answer(&scene(profile, SCENES[2][0])));
    assert_eq!(si, units);
}

#[test]
fn every_other_key_may_have_its_unit() {
    for both in SCENES {
        let [si, units] = both.map(|rest| answer(&scene("kind = \"paraboloid\"\nradius = \"5 um\"", rest)));
        assert_eq!(si, units);
    }
}

#[test]
fn a_unit_of_another_dimension_is_refused() {
    let whole = scene("kind = \"paraboloid\"\nradius = \"5 um\"", SCENES[0][1]);
    for (from, to, parts) in [
        ("\"300 mN/m\"", "\"0.3 nm\"", &["control.stiffness: stiffness is in N/m; got \"0.3 nm\"", "nN/nm"][..]),
        ("\"5 um\"", "\"5 kPa\"", &["profile.radius: radius is in m; got \"5 kPa\"", "um"]),
        ("\"5 um\"", "\"-5 um\"", &["profile.radius: must be positive"]),
        ("\"1 GPa\"", "\"1 gpa\"", &["material.e_star", "unknown unit `gpa`; did you mean `GPa`?"]),
        ("\"50 mJ/m^2\"", "\"50 mJ\"", &["work_of_adhesion is in J/m^2; got \"50 mJ\"", "mJ/m^2"]),
        ("\"-0.5nm\"", "\"-0.5nN\"", &["control.path", "path is in m; got \"-0.5nN\""]),
        ("\"100 nm\"\n[output]", "\"100 nN\"\n[output]", &["control.start", "start is in m"]),
        ("[\"1 nm\"]", "[\"1 nN\"]", &["equilibria.at", "is in m; got \"1 nN\""]),
        ("[\"10 um\"]", "[\"10 deg\"]", &["gap.at", "is in m"]),
    ] {
        assert!(whole.contains(from), "{from}");
        let error = Scene::from_toml(&whole.replace(from, to), "scene.toml", &no_files).expect_err(to).to_string();
        for part in parts {
            assert!(error.contains(part), "{to}: {error}");
        }
    }
}
