//! Tables for a reader: units, notation, digits in groups; one file an output for a spreadsheet.

use crate::{mdr, output};

const TIP: &str = "critical --sphere 20e-9 --e-star 1e9 --work 0.05 --control force";

/// −(3/2)πwR of a tip of 20 nm at 50 mJ/m² is −1.5π nN: 4.712388980384689857693965… by mpmath.
#[test]
fn nanometres_and_nanonewtons() {
    let table = output(&format!("{TIP} --units nm,nN"));
    let force = table.lines().find(|line| line.starts_with(" normal force F ")).unwrap();
    assert!(force.contains("  -4.71238 89803 84689 8577  ") && force.ends_with(" nN"), "{table}");
    assert!(table.contains("At fixed grips: F = -2.61799 38779 91494 3654 nN at d = -0.59267 66898"), "{table}");
    let several = output("critical --n 1,2.5 --c 50 --e-star 1e9 --work 0.05 --units nm,nN --digits 8");
    let titles: Vec<_> = several.lines().next().unwrap().split("  ").filter(|title| !title.is_empty()).collect();
    let titles: Vec<_> = titles.iter().map(|title| title.trim()).collect();
    assert_eq!(titles[..5], ["n", "kappa_n", "contact radius, nm", "indentation, nm", "force, nN"]);
    assert!(several.contains(" -0.00100 00000 "), "{several}");
    let refused = mdr(&format!("{TIP} --units nm,s")).assert().code(2);
    assert!(refused.get_output().stderr.starts_with(b"error: --units: `s` is no unit of m, N, Pa, J or N/m"));
    for program in ["--format json", "--format csv"] {
        mdr(&format!("{TIP} --units nm {program}")).assert().code(2);
    }
}

/// One number in each notation; in a pipe the digits are plain, to be copied, unless a notation is given.
#[test]
fn notations() {
    for (notation, force) in [
        ("", "-4.7123889803846898577e-9"),
        ("--notation plain", "-4.7123889803846898577e-9"),
        ("--notation engineering", "-4.71238 89803 84689 8577e-9"),
        ("--notation scientific", "-4.71238 89803 84689 8577e-9"),
    ] {
        let table = output(&format!("{TIP} {notation}"));
        assert!(table.contains(force), "{notation}: {table}");
    }
    assert!(output(&format!("{TIP} --notation engineering")).contains("-284.92923 37485 80162 90e-12"));
    mdr(&format!("{TIP} --notation roman")).assert().code(2);
}

#[test]
fn a_scene_in_units() {
    let table = output("solve examples/scenes/figure-4.toml --digits 6 --units um,uN,nJ");
    for part in ["contact radius, um", "18944.7", "-106.943", "dissipated, nJ", "dissipated 43.1693 nJ"] {
        assert!(table.contains(part), "{part} in\n{table}");
    }
}

/// A file an output: the inputs, a column each, then the columns of the output with their units.
#[test]
fn a_file_an_output() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("files-of-a-scene");
    let flags = format!("--out {} --units nm,nN", folder.display());
    let list = output(&format!("solve examples/scenes/force-curve.toml {flags}"));
    let lines: Vec<_> = list.lines().map(|line| line.rsplit('/').next().unwrap()).collect();
    let [curve_file, summary, folds_file] = lines[..] else { panic!("{list}") };
    assert_eq!((curve_file, folds_file), ("force-curve.csv", "folds.csv"));
    assert!(summary.starts_with("Summary: pull-off force -4.7052316953261593825 nN, "), "{summary}");
    let mut folds = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(folder.join("folds.csv")).unwrap();
    let header: Vec<_> = folds.headers().unwrap().iter().map(str::to_owned).collect();
    let inputs =
        ["profile", "radius (nm)", "e_star (Pa)", "work_of_adhesion (J/m²)", "control", "machine_stiffness (N/m)"];
    assert_eq!(header[..6], inputs);
    assert_eq!(header[6..], ["contact_radius (nm)", "indentation (nm)", "force (nN)", "kind", "status"]);
    let row = folds.records().next().unwrap().unwrap();
    assert_eq!((&row[1], &row[8]), ("20", "-4.7052316953261593825"));
    let curve = std::fs::read_to_string(folder.join("force-curve.csv")).unwrap();
    assert!(curve.lines().count() > 40 && curve.contains(",retract,"), "{curve}");
    mdr("solve examples/scenes/cone.toml --out target --format csv").assert().code(2);
}

/// What no double holds is told by log10 in the unit of its column.
#[test]
fn magnitudes_are_in_the_unit_of_their_column() {
    let contact = "critical --n 1.2 --c 1e-300 --e-star 1e-300 --work 1e300 --f64";
    let log10 = |table: &str| -> f64 {
        let (_, rest) = table.split_once("contact radius a     overflow: about 10^").unwrap();
        rest.split_whitespace().next().unwrap().parse().unwrap()
    };
    let [si, nanometres] = ["", " --units nm"].map(|flag| log10(&output(&format!("{contact}{flag}"))));
    assert!((nanometres - si - 9.0).abs() < 1e-5, "{si} {nanometres}");
    let scene = "profile = { kind = \"power\", n = 1.2, c = 1e-300 }\n\
                 material = { e_star = 1e-300, work_of_adhesion = 1e300 }\n\
                 output = { want = [\"folds\"], arithmetic = \"f64\" }\n";
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("out-of-range");
    let flags = format!("solve - --out {} --units nm", folder.display());
    mdr(&flags).stdin(scene).assert().success();
    let mut folds = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(folder.join("folds.csv")).unwrap();
    let column = folds.headers().unwrap().iter().position(|title| title == "log10_contact_radius (nm)").unwrap();
    let found: f64 = folds.records().next().unwrap().unwrap()[column].parse().unwrap();
    assert!((found - nanometres).abs() < 1e-5, "{found} {nanometres}");
}
