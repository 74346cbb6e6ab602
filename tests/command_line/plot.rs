//! `mdr solve --plot`: the picture of a scene.

use std::path::{Path, PathBuf};

use crate::{mdr, without_program};

/// A file of this test.
fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Runs `mdr solve` on a scene with a picture; the text of the picture and of its data.
fn plotted(name: &str, control: &str) -> (String, String) {
    let (scene, svg) = (file(&format!("{name}.toml")), file(&format!("{name}.svg")));
    let text = format!(
        "[material]\ne_star = \"5e10\"\nwork_of_adhesion = \"0.1\"\n[profile]\nkind = \"paraboloid\"\nradius = \"50e-9\"\n\
         {control}\n[output]\nwant = [\"folds\"]\narithmetic = \"f64\"\n"
    );
    std::fs::write(&scene, text).unwrap();
    mdr(&format!("solve {} --plot {}", scene.display(), svg.display())).assert().success().stderr_eq("");
    let read = |path: PathBuf| std::fs::read_to_string(path).unwrap();
    (read(svg.clone()), read(svg.with_extension("csv")))
}

/// The numbers in one column of the rows of a series.
fn column(csv: &str, series: &str, column: usize) -> Vec<f64> {
    let rows = csv.lines().filter(|line| line.split(',').nth(2) == Some(series));
    rows.map(|line| line.split(',').nth(column).unwrap().parse().unwrap()).collect()
}

/// An AFM tip is pulled off: nanometres at the axes, the pull-off force of Johnson, Kendall and Roberts where it breaks.
#[test]
fn a_picture_and_its_data() {
    let control = "[control]\nkind = \"force\"\npath = [\"0\", \"-1e-7\"]";
    let (svg, csv) = plotted("plot-force", control);
    let picture = roxmltree::Document::parse(&svg).unwrap();
    let title = picture.root_element().children().find(|node| node.has_tag_name("title")).unwrap();
    assert_eq!(title.text(), Some("paraboloid under controlled force: plot-force"));
    let texts: String = picture.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
    assert!(texts.contains("(nm)") && texts.contains("(nN)"), "{texts}");
    let pull_off = -1.5 * std::f64::consts::PI * 0.1 * 50e-9;
    let forces = column(&csv, "detached", 7);
    assert!(!forces.is_empty() && forces.iter().all(|force| (force / pull_off - 1.0).abs() < 1e-9), "{forces:?}");
    assert_eq!(plotted("plot-force", control), (svg, csv), "two runs differ");
}

/// Branches in the picture are those of d = a²/R − Δl, F = 4E*a³/3R − √(8πa³E*w).
#[test]
fn branches_are_the_closed_forms() {
    let (_, csv) = plotted("plot-branches", "[control]\nkind = \"indentation\"\npath = [\"0\", \"-1e-9\"]");
    let (e, w, r) = (5e10_f64, 0.1, 50e-9);
    let (mut states, mut panels) = (0, [0; 2]);
    for line in csv.lines().filter(|line| line.starts_with("2,curve") || line.starts_with("3,curve")) {
        let fields: Vec<_> = line.split(',').collect();
        panels[usize::from(fields[0] == "3")] += 1;
        let force: f64 = fields[7].parse().unwrap();
        if fields[0] == "3" {
            let a: f64 = fields[5].parse().unwrap();
            let (pressed, pulled) =
                (4.0 * e * a.powi(3) / (3.0 * r), (8.0 * std::f64::consts::PI * a.powi(3) * e * w).sqrt());
            // Ten digits of a and of F.
            assert!(
                (force - (pressed - pulled)).abs() <= 5.1e-10 * (3.0 * pressed + 1.5 * pulled + force.abs()),
                "{line}"
            );
            states += 1;
        }
    }
    assert!(states > 50 && panels[0] == panels[1]);
}

/// The shaded area is the work lost in both jumps: (3/5)πa₀²w at jump-in from d = 0, where a₀³ = 2πwR²/E*, and (2/5)πa_c²w
/// at pull-off, where a_c³ = a₀³/16.
#[test]
fn the_shaded_area_is_the_work_lost() {
    let control = "[control]\nkind = \"indentation\"\npath = [\"-2e-10\", \"2e-10\", \"-2e-10\"]\nstart = \"detached\"";
    let (_, csv) = plotted("plot-cycle", control);
    let points: Vec<_> = column(&csv, "hysteresis", 5).into_iter().zip(column(&csv, "hysteresis", 7)).collect();
    let next = points.iter().cycle().skip(1);
    let area = points.iter().zip(next).map(|((x, y), (u, v))| (x * v - u * y) / 2.0).sum::<f64>().abs();
    let pi = std::f64::consts::PI;
    let cube: f64 = 2.0 * pi * 0.1 * 50e-9_f64.powi(2) / 5e10;
    let lost = pi * 0.1 * (0.6 * cube.powf(2.0 / 3.0) + 0.4 * (cube / 16.0).powf(2.0 / 3.0));
    // The polyline keeps to 1.5·10⁻⁴ of the ranges of d and of F, which contain a few times the area.
    assert!((area / lost - 1.0).abs() < 1e-3, "{area} J, expected {lost} J");
}

#[test]
fn a_picture_that_cannot_be_written_is_named() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/figure-4.toml");
    let place = file("no-such-directory/out.svg");
    let result = mdr(&format!("solve {scene} --f64 --plot {}", place.display())).assert().code(2);
    let error = String::from_utf8(result.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with(&format!("error: --plot {}: ", place.display())), "{error}");
}

/// The picture of a scene in the documents is that of this program.
#[test]
fn the_picture_of_the_documents_is_current() {
    let shown = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/figures");
    for (name, scene) in [("cycle", "cycle.toml"), ("hysteresis", "../../examples/scenes/hysteresis.toml")] {
        let (place, svg) = (format!("{name}.svg"), file(&format!("{name}.svg")));
        mdr(&format!("solve {} --plot {}", shown.join(scene).display(), svg.display())).assert().success();
        let [checked_in, drawn] =
            [shown.join(&place), svg].map(|path| std::fs::read_to_string(path).unwrap_or_default());
        assert!(
            without_program(&checked_in) == without_program(&drawn),
            "docs/figures/{place} is stale: mdr solve {scene} --plot docs/figures/{place}, and remove the CSV beside it"
        );
        assert!(drawn.contains("work lost in the cycle"), "{name}");
    }
}

/// The text of an error, of a command that stops with status 2.
fn refused(arguments: &str) -> String {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/force-curve.toml");
    let result = mdr(&format!("solve {scene} --f64 {arguments}")).assert().code(2);
    String::from_utf8(result.get_output().stderr.clone()).unwrap()
}

#[test]
fn a_picture_has_a_name_that_tells_its_kind() {
    let error = refused("--plot out.jpg");
    assert_eq!(error, "error: --plot: must be the name of an .svg, .png or .pdf file, got out.jpg\n");
}

/// One panel, its size and that of its text; the data stay those of all panels.
#[test]
fn a_panel_for_a_column_of_a_journal() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/force-curve.toml");
    let svg = file("plot-panel.svg");
    let flags = format!("--plot {} --panel b --size 85mm --font 8pt", svg.display());
    mdr(&format!("solve {scene} --f64 {flags}")).assert().success().stderr_eq("");
    let text = std::fs::read_to_string(&svg).unwrap();
    assert!(text.contains("width=\"240.9pt\"") && text.contains("(b)  force"), "{text}");
    assert!(!text.contains("(a)  ") && !text.contains("(c)  "));
    assert!(
        std::fs::read_to_string(svg.with_extension("csv")).unwrap().lines().any(|line| line.starts_with("4,arrow,"))
    );
}

#[test]
fn flags_of_a_picture_that_make_none_are_named() {
    let svg = file("plot-refused.svg");
    let plot = format!("--plot {}", svg.display());
    for (flags, why) in [
        (format!("{plot} --panel z"), "error: --panel: the picture has the panels a, b, c, d, got z\n"),
        ("--panel a".to_owned(), "error: --panel: there is no picture without --plot\n"),
        (
            format!("{plot} --size 20mm"),
            "error: --size: must be between 67mm, with text of 11.0pt, and 2000mm, got 20.0mm\n",
        ),
        (format!("{plot} --font 1pt"), "error: --font: must be between 4pt and 72pt, got 1.0pt\n"),
    ] {
        assert_eq!(refused(&flags), why);
    }
    assert!(refused(&format!("{plot} --size 85")).contains("must be a length above 0 with its unit, such as 85mm"));
}

/// PNG and PDF are made where rsvg-convert is there; else it is named.
#[test]
fn a_picture_for_a_talk_or_a_page() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/force-curve.toml");
    let there = std::process::Command::new("rsvg-convert").arg("--version").output().is_ok();
    for (end, head) in [("png", &b"\x89PNG"[..]), ("pdf", b"%PDF")] {
        let picture = file(&format!("plot-made.{end}"));
        let command = format!("solve {scene} --f64 --plot {}", picture.display());
        if there {
            mdr(&command).assert().success().stderr_eq("");
            assert!(std::fs::read(&picture).unwrap().starts_with(head), "{end}");
        }
        let missing = mdr(&command).env("PATH", "/nowhere").assert().code(2).stdout_eq("");
        let error = String::from_utf8(missing.get_output().stderr.clone()).unwrap();
        assert!(error.starts_with("error: --plot: PNG and PDF are made by the program rsvg-convert"), "{error}");
    }
}
