//! Pictures of contacts under every control.

use mdr_analytic::PowerLaw;
use mdr_analytic::profiles::WavyParaboloid;
use mdr_core::contact::{Material, Transform};
use mdr_numeric::curve::Curve;
use mdr_numeric::equilibrium::Branches;
use mdr_numeric::path::{EventKind, Path, Start};

use super::*;
use crate::picture::{crowded, svg};

/// The data of a contact that follows a path.
fn follow(
    transform: &dyn Transform<f64>,
    material: (f64, f64),
    control: &Control<f64>,
    start: &Start<f64>,
    way: &[f64],
) -> Diagram {
    let material = Material::new(material.0, material.1).unwrap();
    let branches = Branches::new(Curve::new(transform, &material, control)).unwrap();
    let events = if way.is_empty() { Vec::new() } else { Path::follow(&branches, start, way).unwrap().events };
    Diagram::new(&branches, &events, &[]).unwrap()
}

/// The picture is drawn twice the same, and written where a reader may look at it when `MDR_PICTURES` names a directory.
fn drawn(name: &str, data: &Diagram) -> String {
    let picture = picture("test", data);
    let text = svg(&picture).unwrap();
    assert_eq!(text, svg(&super::picture("test", data)).unwrap());
    roxmltree::Document::parse(&text).unwrap();
    if let Some(directory) = std::env::var_os("MDR_PICTURES") {
        std::fs::write(std::path::Path::new(&directory).join(format!("{name}.svg")), &text).unwrap();
    }
    assert_eq!(crowded(&picture), [""; 0], "{name}: labels cover something");
    in_sheet(&text);
    text
}

/// No line, mark or text begins outside the sheet.
fn in_sheet(text: &str) {
    let document = roxmltree::Document::parse(text).unwrap();
    let sheet: Vec<f64> =
        document.root_element().attribute("viewBox").unwrap().split(' ').map(|side| side.parse().unwrap()).collect();
    for node in document.descendants() {
        let number = |name: &str| node.attribute(name).map(|text| text.parse::<f64>().unwrap());
        let mut spots: Vec<(f64, f64)> =
            number("x").zip(number("y")).into_iter().chain(number("cx").zip(number("cy"))).collect();
        for pair in node.attribute("points").unwrap_or_default().split_whitespace() {
            let (x, y) = pair.split_once(',').unwrap();
            spots.push((x.parse().unwrap(), y.parse().unwrap()));
        }
        for (x, y) in spots {
            assert!((0.0..=sheet[2]).contains(&x) && (0.0..=sheet[3]).contains(&y), "{x}, {y} in {node:?}");
        }
    }
}

/// An AFM tip of 50 nm on mica: E* = 50 GPa, w = 0.1 J/m².
fn tip() -> (PowerLaw<f64>, (f64, f64)) {
    (PowerLaw::paraboloid(50e-9).unwrap(), (5e10, 0.1))
}

#[test]
fn a_cycle_of_a_sphere_under_fixed_grips() {
    let (profile, material) = tip();
    let data = follow(&profile, material, &Control::Indentation, &Start::Detached, &[-3e-10, 3e-10, -3e-10]);
    let text = drawn("cycle", &data);
    assert!(text.contains("(nm)") && text.contains("work lost in the cycle"));
    assert!(text.contains("jump-in") && text.contains("detached"));
}

#[test]
fn a_sphere_under_a_dead_load_and_on_a_machine() {
    let (profile, material) = tip();
    let data = follow(&profile, material, &Control::Force, &Start::Largest, &[0.0, -1e-6]);
    let pull_off = data.path.iter().find(|event| event.kind == EventKind::Detached).unwrap().before.unwrap();
    // Johnson, Kendall and Roberts: −(3/2)πwR.
    assert!((pull_off.force / (-1.5 * std::f64::consts::PI * 0.1 * 50e-9) - 1.0).abs() < 1e-12);
    drawn("force", &data);
    let machine = Control::machine(500.0).unwrap();
    drawn("machine", &follow(&profile, material, &machine, &Start::Largest, &[0.0, -1e-7]));
}

#[test]
fn folds_decades_apart_have_a_logarithmic_axis() {
    let profile = PowerLaw::new(0.6, 2.4829).unwrap();
    let data = follow(&profile, (1.0, 1.0), &Control::machine(1.0).unwrap(), &Start::Largest, &[0.0, -1e4]);
    assert_eq!(data.folds.len(), 3);
    assert!(drawn("multistable", &data).contains("10<tspan"));
}

#[test]
fn jumps_from_crest_to_crest() {
    let profile = WavyParaboloid::new(1.0, 2e-4, 0.03).unwrap();
    let data = follow(&profile, (1e6, 100.0), &Control::Indentation, &Start::Largest, &[0.0, -0.01, 0.001]);
    drawn("wavy", &data);
    let stable = data.branches.iter().map(|branch| branch.stable);
    assert!(
        stable.clone().zip(stable.skip(1)).all(|(one, next)| one != next),
        "stable and unstable branches alternate"
    );
}

/// Thousands of branches stay a picture that can be read and sent.
#[test]
fn thousands_of_folds() {
    let profile = WavyParaboloid::new(1.0, 1e-6, 2e-4).unwrap();
    let data = follow(&profile, (1e6, 100.0), &Control::Indentation, &Start::Largest, &[0.0, -0.01]);
    assert!(data.folds.len() > 500, "{}", data.folds.len());
    let text = drawn("thousands", &data);
    assert!(text.len() < 1_500_000, "{} bytes", text.len());
}

#[test]
fn a_sharp_tip_to_complete_contact() {
    let profile = PowerLaw::new(0.25, 1e-6).unwrap();
    let data = follow(&profile, (1e9, 0.05), &Control::Indentation, &Start::Smallest, &[1e-8, 3e-8]);
    drawn("sharp", &data);
    assert!(data.path.iter().any(|event| event.kind == EventKind::CompleteContact));
}
