//! Pictures of contacts under every control, and the figures.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use mdr::diagram::Diagram;
use mdr::prelude::*;
use mdr_plot::figures::FIGURES;
use mdr_plot::{
    Axis, Colour, ComparedMethod, ComparedQuestion, Layer, Mark, Panel, Picture, Sheet, Side, Stroke, Theme, Unit,
    comparison, scene,
};
use roxmltree::{Document, Node};

/// What is drawn of a contact that follows a path.
fn diagram(
    tip: Shape<f64>,
    [modulus, work]: [&str; 2],
    control: Control<Literal>,
    path: &[&str],
    start: Start,
) -> Diagram {
    let scene = Scene::new(tip, Elasticity::effective(modulus).unwrap(), work).unwrap().control(control);
    scene.path(path.iter().copied()).unwrap().start(start).arithmetic(Arithmetic::F64).diagram().unwrap()
}

/// An AFM tip of 50 nm on mica.
fn afm(control: Control<Literal>, path: &[&str], start: Start) -> Diagram {
    diagram(Shape::Paraboloid { radius: 50e-9 }, ["5e10", "0.1"], control, path, start)
}

/// The texts of a picture that is drawn the same twice, well-formed, and within its sheet.
fn texts(picture: &Picture) -> Vec<String> {
    let svg = picture.svg();
    assert_eq!(svg, picture.svg());
    let document = Document::parse(&svg).unwrap();
    let root = document.root_element();
    let child = |tag: &str| root.children().find(|node| node.has_tag_name(tag)).and_then(|node| node.text()).unwrap();
    assert_eq!((child("title"), child("desc")), (&*picture.title, &*picture.description));
    let sheet: Vec<f64> = root.attribute("viewBox").unwrap().split(' ').map(|side| side.parse().unwrap()).collect();
    let number = |node: &Node<'_, '_>, name: &str| node.attribute(name).map(|text| text.parse::<f64>().unwrap());
    for node in document.descendants() {
        let (Some(x), Some(y)) =
            (number(&node, "x").or(number(&node, "cx")), number(&node, "y").or(number(&node, "cy")))
        else {
            continue;
        };
        let moved = node.ancestors().find_map(|outer| outer.attribute("transform")).unwrap();
        let moved: Vec<f64> =
            moved["translate(".len()..moved.len() - 1].split(' ').map(|x| x.parse().unwrap()).collect();
        let (x, y) = (x + moved[0], y + moved[1]);
        assert!((0.0..=sheet[2]).contains(&x) && (0.0..=sheet[3]).contains(&y), "{x}, {y} in {node:?}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "a place that is no number");
    apart(&document, &sheet);
    framed(&document, EM);
    let content =
        |node: Node<'_, '_>| node.descendants().filter(Node::is_text).filter_map(|part| part.text()).collect();
    document.descendants().filter(|node| node.has_tag_name("text")).map(content).collect()
}

/// An em of a narrow and of a wide font, by which texts are measured.
const EM: f64 = 0.46 * 11.0;
const WIDE_EM: f64 = 0.6 * 11.0;

/// The number of words and of arrow heads in the frames of the panels: each is whole within its frame.
fn framed(document: &Document<'_>, em: f64) -> [usize; 2] {
    let mut count = [0; 2];
    let class = |node: &Node<'_, '_>, name: &str| {
        node.attribute("class").is_some_and(|class| class.split(' ').any(|part| part == name))
    };
    for panel in document.descendants().filter(|node| class(node, "panel")) {
        let frame = panel.children().find(|node| class(node, "frame")).unwrap();
        let [width, height] =
            ["width", "height"].map(|side| frame.attribute(side).unwrap().parse::<f64>().unwrap() + 0.5);
        for node in panel.children().filter(|node| class(node, "label")) {
            let text: String = node.descendants().filter(Node::is_text).filter_map(|part| part.text()).collect();
            let [x, y] = ["x", "y"].map(|place| node.attribute(place).unwrap().parse::<f64>().unwrap());
            let half = 0.5 * em * text.chars().count() as f64;
            assert!(x - half >= 0.0 && x + half <= width, "{text} leaves its frame at {x}, half as wide as {half}");
            assert!(y >= 8.0 && y <= height, "{text} leaves its frame at height {y}");
            count[0] += 1;
        }
        for tip in panel.children().filter(|node| class(node, "tip")) {
            let path = tip.attribute("d").unwrap().replace(['M', 'L', 'Z'], " ");
            let places: Vec<f64> = path.split_whitespace().map(|place| place.parse().unwrap()).collect();
            for at in places.chunks(2) {
                let inside = (0.0..=width).contains(&at[0]) && (0.0..=height).contains(&at[1]);
                assert!(inside, "an arrow head leaves its frame at {at:?}");
            }
            count[1] += 1;
        }
    }
    count
}

/// Of all scenes of the examples, and of the figures: every word and every arrow is whole within its frame, and what is named
/// is named beside it.
#[test]
fn words_and_arrows_of_all_examples_stay_in_their_frames() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let files =
        ["scenes", "media"].into_iter().flat_map(|folder| std::fs::read_dir(format!("{root}/{folder}")).unwrap());
    let files =
        files.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|end| end == "toml"));
    let mut pictures: Vec<Picture> = FIGURES.iter().map(|(_, compute)| compute().unwrap()).collect();
    for file in files {
        let scene = Scene::open(&file).unwrap().arithmetic(Arithmetic::F64);
        match scene.diagram() {
            Ok(diagram) => pictures.push(mdr_plot::scene(&file.display().to_string(), &diagram)),
            Err(error) => assert!(error.to_string().contains("needs [material]"), "{error}"),
        }
    }
    assert!(pictures.len() > 30, "{}", pictures.len());
    let mut arrows = 0;
    for picture in &pictures {
        texts(picture);
        for sheet in [Sheet::default(), Sheet { width: Some(241.0), font: 8.0, ..Sheet::default() }] {
            let svg = picture.svg_on(&sheet);
            let document = Document::parse(&svg).unwrap();
            let [words, tips] = framed(&document, WIDE_EM);
            assert!(words > 2, "{}: {words} words", picture.title);
            arrows += tips;
            let written: Vec<String> = document
                .descendants()
                .filter(|node| node.attribute("class").is_some_and(|class| class.starts_with("label")))
                .map(|node| node.descendants().filter(Node::is_text).filter_map(|part| part.text()).collect())
                .collect();
            let named = ["Δl", "Δl(a)"].iter().any(|name| written.iter().any(|text| text == name));
            assert!(named, "{}: {written:?}", picture.title);
        }
    }
    assert!(arrows > 2 * pictures.len(), "{arrows} arrow heads");
}

/// A jump that leads out of a picture ends at its frame with its head, and says how far it goes.
#[test]
fn a_jump_beyond_the_frame_keeps_its_arrow() {
    for name in ["force-curve", "machine"] {
        let file = format!("{}/../../examples/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let diagram = Scene::open(&file).unwrap().arithmetic(Arithmetic::F64).diagram().unwrap();
        let picture = scene(name, &diagram);
        let headings: Vec<_> = picture.panels.iter().map(|panel| &panel.heading[..3]).collect();
        assert_eq!(headings, ["(a)", "(b)", "(c)", "(d)"], "a machine has force against position");
        let b = picture.only(['b']).unwrap();
        let pull_off = b.panels[0].layers.iter().find(|layer| layer.name == "detached").unwrap();
        assert!(b.panels[0].x.fraction(pull_off.points[1][0]) < 0.0, "{name} is no test of this");
        assert!(texts(&b).iter().any(|text| text.starts_with("pull-off, to d = −")), "{:?}", texts(&b));
        let d = picture.only(['d']).unwrap();
        let pull_off = d.panels[0].layers.iter().find(|layer| layer.name == "detached").unwrap();
        assert_eq!(pull_off.points[0][0].to_bits(), pull_off.points[1][0].to_bits(), "{name}: the position is held");
        assert!((0.0..=1.0).contains(&d.panels[0].x.fraction(pull_off.points[1][0])), "{name}");
    }
}

/// A narrow sheet has its panels below each other, text of its size, and its width.
#[test]
fn a_sheet_has_its_size() {
    let picture = scene("cycle", &afm(Control::Indentation, &["-3e-10", "3e-10", "-3e-10"], Start::Detached));
    let size = |sheet: &Sheet| {
        let svg = picture.svg_on(sheet);
        let document = Document::parse(&svg).unwrap();
        let root = document.root_element();
        let points = |side: &str| root.attribute(side).unwrap().trim_end_matches("pt").parse::<f64>().unwrap();
        let sides: Vec<f64> = root.attribute("viewBox").unwrap().split(' ').map(|side| side.parse().unwrap()).collect();
        (points("width"), points("height"), points("width") / sides[2])
    };
    let (wide, low, _) = size(&Sheet::default());
    assert!(wide > 2.0 * low, "three panels beside each other: {wide} by {low}");
    let (width, height, scale) = size(&Sheet { width: Some(241.0), font: 8.0, ..Sheet::default() });
    assert!((width - 241.0).abs() < 0.1 && height > 2.0 * width, "{width} by {height}");
    assert!((scale - 8.0 / 11.0).abs() < 0.01, "{scale}");
    assert!(picture.svg().contains("max-width:700px") && picture.svg().contains("max-width:100%"));
}

/// All texts are within the sheet and beside each other, in a narrow font; a wide one is what their places are chosen for.
fn apart(document: &Document<'_>, sheet: &[f64]) {
    let boxes: Vec<_> = document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| {
            let text: String = node.descendants().filter(Node::is_text).filter_map(|part| part.text()).collect();
            let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
            let moved = node.ancestors().find_map(|outer| outer.attribute("transform")).unwrap();
            let moved: Vec<f64> =
                moved["translate(".len()..moved.len() - 1].split(' ').map(|x| x.parse().unwrap()).collect();
            let class = node.attribute("class").unwrap_or_default();
            let width = EM * text.chars().count() as f64;
            let shift = if class.contains("middle") { 0.5 } else { f64::from(u8::from(class.contains("end"))) };
            let left = number("x") + moved[0] - shift * width;
            (left, left + width, number("y") + moved[1], text)
        })
        .collect();
    for (i, (left, right, y, text)) in boxes.iter().enumerate() {
        assert!(*left >= -0.5 && *right <= sheet[2] + 0.5 && (8.0..=sheet[3]).contains(y), "{text} leaves the sheet");
        for (other_left, other_right, other_y, other) in &boxes[..i] {
            let overlap = left < other_right && other_left < right && (y - other_y).abs() < 8.0;
            assert!(!overlap, "{text:?} and {other:?} overlap at {left:.0}, {y:.0}");
        }
    }
}

/// How often a text is in a picture.
fn count(picture: &Picture, text: &str) -> usize {
    texts(picture).iter().filter(|found| *found == text).count()
}

#[test]
fn a_cycle_of_a_sphere_under_fixed_grips() {
    let picture = scene("cycle", &afm(Control::Indentation, &["-3e-10", "3e-10", "-3e-10"], Start::Detached));
    assert_eq!(count(&picture, "work lost in the cycle"), 1);
    assert_eq!(count(&picture, "contact radius a (nm)"), 2);
    assert!(picture.description.contains("jump-in") && picture.description.contains("detached"));
}

#[test]
fn a_sphere_under_a_dead_load_and_on_a_machine() {
    let data = afm(Control::Force, &["0", "-1e-6"], Start::Largest);
    let pull_off = data.path.iter().find(|event| event.kind == EventKind::Detached).unwrap().before.unwrap();
    // Johnson, Kendall and Roberts: −(3/2)πwR.
    assert!((pull_off.force / (-1.5 * std::f64::consts::PI * 0.1 * 50e-9) - 1.0).abs() < 1e-12);
    assert_eq!(count(&scene("force", &data), "pull-off"), 2);
    let machine = Control::Machine { stiffness: "500".exact().unwrap() };
    let texts = texts(&scene("machine", &afm(machine, &["0", "-1e-7"], Start::Largest)));
    assert_eq!(texts.iter().filter(|text| text.starts_with("pull-off")).count(), 3, "{texts:?}");
}

#[test]
fn a_jump_goes_through_states_that_its_control_leaves() {
    // The force (1.6) of a paraboloid: 2E*(a d − a³/3R).
    let force = |a: f64, d: f64| 2.0 * 5e10 * (a * d - a.powi(3) / (3.0 * 50e-9));
    let near = |left: f64, right: f64| (left - right).abs() <= 1e-12 * (left.abs() + right.abs());
    let held = |spot: &mdr::diagram::State, control: &Control<f64>| match control {
        Control::Indentation => spot.indentation,
        Control::Force => spot.force,
        Control::Machine { stiffness } => spot.indentation + spot.force / stiffness,
    };
    let machine = Control::Machine { stiffness: "30".exact().unwrap() };
    for (control, ends) in [(Control::Indentation, ["1e-10", "-2e-10"]), (machine, ["1e-9", "-2e-9"])] {
        let diagram = afm(control, &ends, Start::Largest);
        let event = diagram.path.iter().find(|event| event.kind == EventKind::Detached).unwrap();
        let jump = diagram.jump(event).unwrap();
        assert!(jump.len() > 20, "{}", jump.len());
        for spot in &jump[1..jump.len() - 1] {
            assert!(near(spot.force, force(spot.contact_radius, spot.indentation)), "{spot:?}");
            assert!(near(held(spot, &diagram.control), event.value), "{spot:?}");
        }
        assert!(jump.windows(2).all(|pair| pair[0].contact_radius > pair[1].contact_radius));
    }
}

#[test]
fn a_long_heading_stays_over_its_panel() {
    let question = |title| {
        let methods = vec![ComparedMethod { name: "quadrature", textbook: false, answers: vec![(1e-6, Some(3.0))] }];
        ComparedQuestion { title, attainable: Some(15.5), methods }
    };
    let radius = "contact radius at the instability of a wavy paraboloid, the first on pulling";
    let depth = "indentation depth at the instability of a wavy paraboloid, the first on pulling";
    let texts = texts(&comparison("two methods", &[question(radius), question(depth)]));
    assert!(texts.contains(&"contact radius at the instability of a wavy".to_owned()), "{texts:?}");
}

#[test]
fn folds_decades_apart_have_a_logarithmic_axis() {
    let machine = Control::Machine { stiffness: 1.exact().unwrap() };
    let data = diagram(Shape::Power { n: 0.6, c: 2.4829 }, ["1", "1"], machine, &["0", "-1e4"], Start::Largest);
    assert_eq!(data.folds.len(), 3);
    assert!(texts(&scene("multistable", &data)).iter().any(|text| text.starts_with("10−")));
}

#[test]
fn jumps_from_crest_to_crest() {
    let tip = Shape::WavyParaboloid { radius: 1.0, amplitude: 2e-4, wavelength: 0.03 };
    let data = diagram(tip, ["1e6", "100"], Control::Indentation, &["0", "-0.01", "0.001"], Start::Largest);
    assert_eq!(count(&scene("wavy", &data), "jump"), 2);
    let stable = data.branches.iter().map(|branch| branch.stable);
    let alternate = stable.clone().zip(stable.skip(1)).all(|(one, next)| one != next);
    assert!(alternate, "stable and unstable branches alternate");
}

/// More branches than can be told apart stay a picture that can be read and sent.
#[test]
fn a_crowd_of_folds() {
    let tip = Shape::WavyParaboloid { radius: 1.0, amplitude: 6e-5, wavelength: 2.2e-3 };
    let data = diagram(tip, ["1e6", "100"], Control::Indentation, &[], Start::Largest);
    assert!(data.folds.len() > 60, "{}", data.folds.len());
    let picture = scene("crowd", &data);
    let texts = texts(&picture);
    assert!(texts.iter().any(|text| text.contains("branches")), "{texts:?}");
    assert!(picture.svg().len() < 1_000_000, "{} bytes", picture.svg().len());
}

#[test]
fn a_sharp_tip_to_complete_contact() {
    let tip = Shape::Power { n: 0.25, c: 1e-6 };
    let data = diagram(tip, ["1e9", "0.05"], Control::Indentation, &["1e-8", "3e-8"], Start::Smallest);
    assert!(data.path.iter().any(|event| event.kind == EventKind::CompleteContact));
    assert_eq!(
        count(&scene("sharp", &data), "complete-contact"),
        1,
        "where the contact spreads to is seen by radius only"
    );
}

#[test]
fn the_figures_have_their_letters() {
    let letters: [&[&str]; 6] =
        [&["O", "a1", "a2", "aO"], &["P"], &["P1", "P2"], &["O", "P"], &["a0", "a1", "a4"], &["P", "P1", "P2"]];
    for ((name, compute), letters) in FIGURES.into_iter().zip(letters) {
        let texts = texts(&compute().unwrap());
        for letter in letters {
            assert!(texts.iter().any(|text| text == letter), "{name}: {letter} in {texts:?}");
        }
    }
}

fn panel(layers: Vec<Layer>) -> Picture {
    let [x, y] = ["x", "y"].map(|name| Axis::linear(name, Unit::One, 0.0, 1.0));
    let panels = vec![Panel { layers, ..Panel::new("", x, y) }];
    Picture { title: "A & B".to_owned(), description: "x < 1".to_owned(), panels }
}

/// A curve is named beside it where there is room, else from afar by a line; never twice, and there is no legend.
#[test]
fn curves_are_named_beside_them() {
    let line = |height: f64, text: &str| {
        Layer::curve(text, vec![[0.0, height], [0.5, height], [1.0, height]], Stroke::Solid).meaning(text)
    };
    let picture = panel(vec![line(0.2, "below"), line(0.8, "above")]);
    assert!(!picture.svg().contains("class=\"leader\""));
    for name in ["below", "above"] {
        assert_eq!(count(&picture, name), 1);
    }
    // Lines near each other leave no room beside the inner ones.
    let names = ["one", "two", "three", "four"];
    let comb = panel(names.iter().zip(0..).map(|(name, i)| line(0.5 + 0.03 * f64::from(i), name)).collect());
    assert!(comb.svg().contains("class=\"leader\""));
    for name in names {
        assert_eq!(count(&comb, name), 1);
    }
}

#[test]
fn themes_fix_the_colours() {
    let picture = panel(vec![Layer::curve("a", vec![[0.0, 0.0], [1.0, 1.0]], Stroke::Solid).coloured(Colour::Blue)]);
    let blue = |theme| picture.svg_in(theme).split_once(".blue{color:").unwrap().1[..7].to_owned();
    assert_eq!(
        [Theme::Auto, Theme::Light, Theme::Dark, Theme::Paper].map(blue),
        ["#0b62a8", "#0b62a8", "#62b5f5", "#000000"]
    );
    for theme in [Theme::Light, Theme::Dark, Theme::Paper] {
        assert!(!picture.svg_in(theme).contains("prefers-color-scheme"), "{theme:?}");
    }
    assert_eq!(picture.svg(), picture.svg_in(Theme::Auto));
}

#[test]
fn labels_at_one_point_stand_on_different_sides() {
    let label = |text: &str| Layer::label(text, vec![[0.5, 0.5]], Side::Right);
    let svg = panel(["one", "two", "six"].map(label).to_vec()).svg();
    let document = Document::parse(&svg).unwrap();
    let labels = document.descendants().filter(|node| node.attribute("class") == Some("label middle ink"));
    let places: std::collections::BTreeSet<_> = labels.map(|node| (node.attribute("x"), node.attribute("y"))).collect();
    assert_eq!(places.len(), 3);
}

/// The data are what is drawn; a line with its marks has one name.
#[test]
fn a_series_is_drawn_named_and_written() {
    let mut picture = panel(Vec::new());
    picture.panels[0].series("a, \"b\"", vec![[0.25, 0.5], [0.75, 2.0]], Mark::Open, Colour::Blue);
    assert_eq!(count(&picture, "a, \"b\""), 1);
    let rows: Vec<String> = picture.csv().lines().map(str::to_owned).collect();
    assert_eq!(rows[1], "1,curve,\"a, \"\"b\"\"\",solid,x,2.500000000e-1,y,5.000000000e-1,1; 1");
    assert_eq!(rows.len(), 5);
    let circles = picture.svg().matches("<circle").count();
    assert_eq!(circles, 1, "of the points one is beyond the frame");
}
