//! `mdr figures`: the figures of the paper, their data, and the page that shows them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::{mdr, output, without_program};

const FIGURES: [&str; 6] = ["figure-1a", "figure-1b", "figure-2", "figure-3", "figure-4", "figure-5"];

/// An empty directory of this test.
fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // It may be there from an earlier run.
    let _ = std::fs::remove_dir_all(&path);
    path
}

/// All files of `mdr figures` by name.
fn files(name: &str) -> BTreeMap<String, String> {
    let path = directory(name);
    output(&format!("figures --out {}", path.display()));
    let entries = std::fs::read_dir(&path).unwrap().map(Result::unwrap);
    let read = |entry: std::fs::DirEntry| without_program(&std::fs::read_to_string(entry.path()).unwrap());
    entries.map(|entry| (entry.file_name().into_string().unwrap(), read(entry))).collect()
}

/// The points of one series, in the order of the file.
fn series(csv: &str, panel: &str, element: &str, name: &str) -> Vec<[f64; 2]> {
    let rows = csv.lines().skip(1).map(fields);
    let wanted = rows.filter(|row| row[0] == panel && row[1] == element && row[2] == name);
    let points: Vec<_> = wanted.map(|row| [row[5].parse().unwrap(), row[7].parse().unwrap()]).collect();
    assert!(!points.is_empty(), "no {element} {name:?} in panel {panel}");
    points
}

/// The fields of a line; only names are quoted here, and none holds a quotation mark.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            _ => fields.last_mut().unwrap().push(letter),
        }
    }
    fields
}

#[test]
fn each_figure_is_written_with_its_data_and_the_same_every_time() {
    let (first, second) = (files("figures-first"), files("figures-second"));
    let mut names: Vec<_> = FIGURES.iter().flat_map(|name| [format!("{name}.csv"), format!("{name}.svg")]).collect();
    names.sort();
    assert_eq!(first.keys().cloned().collect::<Vec<_>>(), names);
    assert!(first == second, "two runs differ");
}

/// A theme fixes the colours of every command that draws; without one they follow the reader's screen.
#[test]
fn a_theme_fixes_the_colours() {
    let folder = directory("themes");
    std::fs::create_dir(&folder).unwrap();
    let drawn = folder.join("drawn.svg");
    for (theme, page) in
        [("light", Some("#ffffff")), ("dark", Some("#1a1e23")), ("paper", Some("#ffffff")), ("auto", None)]
    {
        output(&format!("figures --theme {theme} --out {}", folder.display()));
        output(&format!("solve docs/figures/cycle.toml --theme {theme} --plot {}", drawn.display()));
        for file in ["figure-1a.svg", "drawn.svg"] {
            let svg = std::fs::read_to_string(folder.join(file)).unwrap();
            assert_eq!(svg.contains("@media screen and (prefers-color-scheme:dark)"), page.is_none(), "{theme} {file}");
            assert!(page.is_none_or(|colour| svg.contains(&format!(".page{{fill:{colour}}}"))), "{theme} {file}");
        }
        let _ = std::fs::remove_file(drawn.with_extension("csv"));
    }
}

/// The pictures in docs/figures are those of this program.
#[test]
fn the_figures_of_the_documents_are_current() {
    let shown = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/figures");
    for (name, drawn) in files("figures-current") {
        if name.ends_with(".svg") {
            let checked_in = std::fs::read_to_string(shown.join(&name)).unwrap_or_default();
            assert!(
                checked_in == drawn,
                "docs/figures/{name} is stale: cargo run -p mdr-cli -- figures --out docs/figures; rm docs/figures/*.csv"
            );
        }
    }
}

#[test]
fn the_page_of_figures_shows_them_all() {
    let page = include_str!("../../docs/figures.md");
    for name in FIGURES {
        assert!(page.contains(&format!("](figures/{name}.svg)")), "{name}");
    }
}

/// Well-formed, with a title and a caption; every text 11 points high but for indices; colours only from the style sheet, where
/// those of a dark screen come second and print never sees them.
#[test]
fn a_figure_can_be_printed() {
    for (name, svg) in files("figures-print").into_iter().filter(|(name, _)| name.ends_with(".svg")) {
        let document = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{name}: {error}"));
        let root = document.root_element();
        let points = |value: &str| value.trim_end_matches("pt").parse::<f64>().unwrap();
        let size: Vec<_> = root.attribute("viewBox").unwrap().split(' ').map(points).collect();
        let scale = points(root.attribute("width").unwrap()) / size[2];
        let child =
            |tag: &str| root.children().find(|node| node.has_tag_name(tag)).and_then(|node| node.text()).unwrap();
        for tag in ["title", "desc"] {
            assert!(child(tag).len() > 10, "{name}: {tag}");
        }
        let height = points(root.attribute("font-size").unwrap()) * scale;
        assert!(height >= 10.999, "{name}: {height} points");
        let (light, dark) = child("style").split_once("@media screen and (prefers-color-scheme:dark)").unwrap();
        assert!(light.contains(".page{fill:#ffffff}") && dark.contains(".page{fill:#1a1e23}"), "{name}");
        for node in document.descendants() {
            let own = ["fill", "stroke", "style"].into_iter().find(|name| node.attribute(*name).is_some());
            assert!(own.is_none(), "{name}: {own:?} in {node:?}");
            assert!(!node.has_tag_name("text") || node.attribute("font-size").is_none(), "{name}: a size in {node:?}");
        }
    }
}

/// Half a unit of the tenth digit, which is the last one printed, and a little for the computation itself.
const PRINTED: f64 = 5.01e-10;

/// The points of a curve are those of y = factor·aᵖ − d, up to the rounding of both coordinates.
fn assert_power(points: &[[f64; 2]], (factor, power, d): (f64, f64, f64), what: &str) {
    for [a, y] in points {
        let rising = factor * a.powf(power);
        let allowed = PRINTED * (power * rising + y.abs()) + 4.0 * f64::EPSILON * (rising + d.abs());
        assert!((y - (rising - d)).abs() <= allowed, "{what}: {y} at {a}, expected {}", rising - d);
    }
}

/// In units of the critical state, Δl = 2n√ã/|2n−1| and g = ãⁿ/|2n−1|: the universal curves, written out.
#[test]
fn the_curves_are_the_closed_forms() {
    let files = files("figures-curves");
    for (name, panel, curve, n, d) in [
        ("figure-1a", "1", "g(a)", 2.0, 0.0),
        ("figure-1b", "1", "g(a) − d, d > 0", 2.0, 1.0),
        ("figure-1b", "1", "g(a) − d, d = d_c", 2.0, -1.0),
        ("figure-2", "1", "g(a) − d", 2.0, -0.8),
        ("figure-3", "1", "g(a) − d, d = 0", 0.25, 0.0),
        ("figure-3", "2", "g(a) − d, d = d_c", 0.25, 1.0),
    ] {
        let csv = &files[&format!("{name}.csv")];
        let width = (2.0 * n - 1.0_f64).abs();
        assert_power(&series(csv, panel, "curve", curve), (1.0 / width, n, d), name);
        assert_power(&series(csv, panel, "curve", "Δl(a)"), (2.0 * n / width, 0.5, 0.0), name);
    }
}

#[test]
fn marks_are_where_theory_puts_them() {
    let files = files("figures-marks");
    let marked = |name: &str, panel: &str, mark: &str| {
        let [found] = series(&files[&format!("{name}.csv")], panel, "mark", mark)[..] else { panic!("{name}: {mark}") };
        found
    };
    for (name, panel, mark, expected) in [
        ("figure-1a", "1", "O", [4f64.powf(2.0 / 3.0), 4f64.powf(4.0 / 3.0) / 3.0]),
        ("figure-1b", "1", "P", [1.0, 4.0 / 3.0]),
        ("figure-3", "1", "O", [16.0, 4.0]),
        ("figure-3", "2", "P", [1.0, 1.0]),
    ] {
        for (found, expected) in marked(name, panel, mark).into_iter().zip(expected) {
            assert!((found - expected).abs() <= PRINTED * expected, "{name}, {mark}: {found}, expected {expected}");
        }
    }
    // d = 0.8 d_c: ã² − 4√ã + 2.4 = 0, the error of ã times the slope of that.
    for mark in ["P_1", "P_2"] {
        let [a, _] = marked("figure-2", "1", mark);
        let allowed = PRINTED * (2.0 * a * a - 2.0 * a.sqrt()).abs();
        assert!((a * a - 4.0 * a.sqrt() + 2.4).abs() <= allowed, "{mark} at {a}");
    }
}

/// Towards a stable equilibrium, away from an unstable one.
#[test]
fn arrows_show_the_direction_of_change() {
    let files = files("figures-arrows");
    for (name, panel, equilibria, expected) in [
        ("figure-1a", "1", vec![2.52], vec![1.0, -1.0]),
        ("figure-2", "1", vec![0.41, 1.66], vec![-1.0, 1.0, -1.0]),
        ("figure-3", "1", vec![16.0], vec![-1.0, 1.0]),
        ("figure-3", "2", vec![0.22, 3.0], vec![1.0, -1.0, 1.0]),
    ] {
        for arrow in ["grows (1.9)", "shrinks (1.8)"] {
            for ends in series(&files[&format!("{name}.csv")], panel, "arrow", arrow).chunks(2) {
                let between = equilibria.iter().filter(|radius| ends[0][0] > **radius).count();
                assert_eq!((ends[1][0] - ends[0][0]).signum(), expected[between], "{name}, {arrow} at {:?}", ends[0]);
            }
        }
    }
}

/// Radii and indentations of figure 4, computed elsewhere, in the caption; the arrows lead from one to the other.
#[test]
fn the_wavy_contact_jumps_where_it_should() {
    let files = files("figures-jumps");
    let svg = &files["figure-4.svg"];
    let caption = roxmltree::Document::parse(svg).unwrap();
    let caption = caption.descendants().find(|node| node.has_tag_name("desc")).unwrap().text().unwrap().to_owned();
    for number in ["a_0 = 0.0926", "a = 0.064459", "d = -0.001848", "jumps to 0.047378", "a = 0.01894", "d = -0.002488"]
    {
        assert!(caption.contains(number), "{number} in {caption}");
    }
    let csv = &files["figure-4.csv"];
    let arrows = series(csv, "1", "arrow", "jump");
    // Three digits were published here.
    let expected = [0.0645, 0.0474, 0.0189, 0.0];
    for (arrow, expected) in arrows.iter().zip(expected) {
        assert!((arrow[0] - expected).abs() <= 5e-5, "{arrow:?}, expected {expected}");
    }
    assert_eq!((arrows.len(), series(csv, "2", "arrow", "jump").len()), (4, 6));
}

#[test]
fn a_directory_that_cannot_be_made_is_named() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/figures");
    let result = mdr(&format!("figures --out {file}")).assert().code(2).stdout_eq("");
    let error = String::from_utf8(result.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with(&format!("error: --out {file}: ")), "{error}");
}

#[test]
fn the_list_of_files_in_json() {
    let path = directory("figures-json");
    let lines = output(&format!("figures --format json --out {}", path.display()));
    let figures: Vec<serde_json::Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(figures.len(), FIGURES.len());
    for (figure, name) in figures.iter().zip(FIGURES) {
        assert_eq!((&figure["schema"], &figure["figure"]), (&"mdr.figures/1".into(), &name.into()));
        assert!(Path::new(figure["svg"].as_str().unwrap()).is_file());
    }
}
