//! Scenes with measured profiles: where the tip is, what noise does, and what smoothing does about it.

use serde_json::Value;

use super::{mdr, number, solved};

/// Rows in nanometres, as they are written to a file.
fn table(name: &str, rows: impl IntoIterator<Item = (f64, String)>) -> String {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let rows: String = rows.into_iter().map(|(r, f)| format!("{r},{f}\n")).collect();
    std::fs::write(&file, format!("r,f\nnm,nm\n{rows}")).unwrap();
    file.display().to_string()
}

/// A scene of a table on rubber, w/E* = 0.1 nm, under a dead load.
fn scene(file: &str, keys: &str, output: &str) -> String {
    format!(
        "material = {{ e_star = 1e9, work_of_adhesion = 0.1 }}\n\
         profile = {{ kind = \"table\", file = \"{file}\"{keys} }}\n\
         control = {{ kind = \"force\", path = [0, -1e-6] }}\noutput = {{ {output} }}\n"
    )
}

fn refusal(scene: &str) -> String {
    let assert = mdr("solve -").stdin(scene).assert().code(2);
    String::from_utf8(assert.get_output().stderr.clone()).unwrap()
}

/// What the notes of an answer say, in one text.
fn notes(answer: &Value) -> String {
    answer["notes"]
        .as_array()
        .map_or_else(String::new, |notes| notes.iter().map(|note| note.as_str().unwrap()).collect())
}

/// The lowest force among the folds.
fn pull_off(answer: &Value) -> f64 {
    answer["folds"].as_array().unwrap().iter().map(|fold| number(&fold["force"])).fold(0.0, f64::min)
}

/// A name and f(r), both in nanometres.
type Tip = (&'static str, fn(f64) -> f64);

/// Tips of some 20 nm.
const TIPS: [Tip; 6] = [
    ("sphere", |r| r * r / 40.0),
    ("hyperboloid", |r| 2.75 * ((r * r + 55.0 * 55.0).sqrt() - 55.0)),
    ("cone with a cap", |r| if r < 4.0 { r * r / 16.0 } else { 0.5 * r - 1.0 }),
    ("cone", |r| 0.3 * r),
    ("flat", |r| if r < 6.0 { 0.0 } else { (r * r - 36.0) / 40.0 }),
    ("waves", |r| r * r / 40.0 + 0.05 * (1.0 - (std::f64::consts::TAU * r / 6.0).cos())),
];

/// A repeatable normal deviate: the sum of twelve uniform ones.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    let mut uniform = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    move || (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

/// Heights that do not come to zero at the axis have another tip than (0, 0), and are refused with the key that mends them.
#[test]
fn a_table_that_does_not_begin_at_its_tip() {
    let folds = "want = [\"folds\"], digits = 12";
    for (name, f) in TIPS {
        let rows = |offset: f64| (1..=45).map(move |i| (f64::from(i), format!("{}", f(f64::from(i)) + offset)));
        let exact = solved(&scene(&table("from-its-tip.csv", rows(0.0)), "", folds), "");
        assert!(!notes(&exact).contains("tip"), "{name}: {exact}");
        let file = table("beside-its-tip.csv", rows(3.0));
        let message = refusal(&scene(&file, "", folds));
        assert!(message.contains("line 3, column f") && message.contains("offset = \"3."), "{name}: {message}");
        // Twelve digits of doubles that were moved by 3.
        let mended = solved(&scene(&file, ", offset = \"3 nm\"", folds), "");
        assert!((pull_off(&mended) / pull_off(&exact) - 1.0).abs() < 1e-9, "{name}: {mended}");
        let insisted = solved(&scene(&file, ", offset = 0", folds), "");
        assert_ne!(pull_off(&insisted), pull_off(&mended), "{name}");
    }
    let raised = table("raised-at-its-tip.csv", (0..=9).map(|i| (f64::from(i), format!("{}", 1.5 + f64::from(i * i)))));
    let message = refusal(&scene(&raised, "", folds));
    assert!(message.contains("f(0) = 1.5; subtract 1.5") && message.contains("offset = \"1.5 nm\""), "{message}");
    solved(&scene(&raised, ", offset = 1.5e-9", folds), "");
}

#[test]
fn heights_that_fall_outward() {
    let folds = "want = [\"folds\"]";
    for (name, f) in TIPS {
        let file = table("upside-down.csv", (0..=40).map(|i| (f64::from(i), format!("{}", -f(f64::from(i))))));
        let message = refusal(&scene(&file, "", folds));
        assert!(message.contains("fall outward") && message.contains("change the sign"), "{name}: {message}");
        // Beside another profile a dimple is one.
        let sum = scene(&file, "", folds)
            .replace("profile = {", "profile = { kind = \"sum\", term = [{ kind = \"paraboloid\", radius = 1e-8 }, {");
        solved(&sum.replace(" }\ncontrol", " }] }\ncontrol"), "");
    }
}

/// Rows have few digits: they are computed in f64, which is said, unless digits are asked for.
#[test]
fn tables_are_computed_in_f64() {
    let file = table("in-f64.csv", (0..=20).map(|i| (f64::from(i), format!("{}", f64::from(i * i) / 40.0))));
    let said = |output: &str, flags: &str| {
        let answer = solved(&scene(&file, "", output), flags);
        (answer["arithmetic"].as_str().unwrap().to_owned(), notes(&answer).contains("computed in f64"))
    };
    assert_eq!(said("want = [\"folds\"]", ""), ("f64".to_owned(), true));
    assert_eq!(said("want = [\"folds\"]", "--f64"), ("f64".to_owned(), false));
    assert_eq!(said("want = [\"folds\"]", "--digits 9"), ("certified".to_owned(), false));
    assert_eq!(said("want = [\"folds\"], digits = 9", ""), ("certified".to_owned(), false));
    assert_eq!(said("want = [\"folds\"], arithmetic = \"certified\"", ""), ("certified".to_owned(), false));
}

/// Nothing is left between the range of a proof and the tip, where a table is one polynomial.
#[test]
fn pull_off_of_a_table_is_proved() {
    for (name, f) in TIPS {
        let file = table("proved.csv", (0..=15).map(|i| (3.0 * f64::from(i), format!("{:.6}", f(3.0 * f64::from(i))))));
        let answer = solved(&scene(&file, "", "want = [\"path\"]"), "--digits 8");
        assert_eq!(answer["promise"]["path"], "certified", "{name}: {answer}");
        assert_eq!(answer["complete"]["path"]["proved"], true, "{name}: {answer}");
    }
}

/// The cubic through rows of a paraboloid is the paraboloid: what is proved of a sum with such a table is what is proved of the sum of shapes,
/// to the last digit.
#[test]
fn a_sum_with_a_table_is_proved() {
    let file = table("paraboloid.csv", (0..=30).map(|i| (f64::from(i), format!("{}", f64::from(i * i) / 40.0))));
    let of = |first: &str| {
        let scene = format!(
            "material = {{ e_star = 1e9, work_of_adhesion = 0.1 }}\n\
             control = {{ kind = \"force\", path = [0, -1e-6] }}\n\
             [profile]\nkind = \"sum\"\nterm = [{{ {first} }}, {{ kind = \"wavy-paraboloid\", radius = \"1 um\", \
             amplitude = \"0.2 nm\", wavelength = \"7 nm\" }}]\n\
             [output]\nwant = [\"folds\", \"path\", \"transform\", \"curve\"]\ndigits = 12\n\
             transform.at = [\"3.5e-9\", \"12.3e-9\"]\ncurve.at = [\"6.5e-9\"]\n"
        );
        solved(&scene, "")
    };
    let (tables, shapes) =
        (of(&format!("kind = \"table\", file = \"{file}\"")), of("kind = \"paraboloid\", radius = \"20 nm\""));
    for answer in [&tables, &shapes] {
        let promises = answer["promise"].as_object().unwrap();
        assert!(promises.len() == 5 && promises.values().all(|promise| promise == "certified"), "{promises:?}");
    }
    let within = |fold: &&Value| number(&fold["contact_radius"]) < 30e-9;
    let [some, all] =
        [&tables, &shapes].map(|answer| answer["folds"].as_array().unwrap().iter().filter(within).collect::<Vec<_>>());
    assert!(!some.is_empty() && some == all, "{some:?} {all:?}");
    for output in ["path", "transform", "curve"] {
        assert_eq!(tables[output], shapes[output], "{output}");
    }
    // At a row the transform is that of doubles.
    let at_row = scene(&file, "", "want = [\"transform\"], digits = 12, transform.at = [\"4e-9\"]");
    let answer = solved(&at_row, "");
    assert_eq!(answer["promise"]["transform"], "f64");
    // Three roundings of the heights, of g and of the decimals.
    assert!((number(&answer["transform"][0]["g"]) / 8e-10 - 1.0).abs() < 3.0 * f64::EPSILON, "{answer}");
}

/// Noise makes rings that adhere: that is said, with the forces that smoothing leads to, and a stated length leads to the
/// ideal one.
#[test]
fn noise_is_no_shape() {
    let row = |i: i32| 0.15 * f64::from(i);
    let (name, f) = TIPS[1];
    let folds = "want = [\"folds\"]";
    let ideal = pull_off(&solved(
        &scene(&table("ideal.csv", (0..=300).map(|i| (row(i), format!("{}", f(row(i)))))), "", folds),
        "",
    ));
    for seed in 0..4 {
        let mut noise = noise(seed);
        let rows: Vec<f64> = (0..=300).map(|i| f(row(i)) + 0.1 * noise()).collect();
        let file = table(
            &format!("noisy-{seed}.csv"),
            (0..=300).map(|i| (row(i), format!("{:.4}", rows[i as usize] - rows[0]))),
        );
        let raw = solved(&scene(&file, "", folds), "");
        assert!(pull_off(&raw) < 2.0 * ideal, "{name}: {raw}");
        let said = notes(&raw);
        assert!(said.contains("scatter by about") && said.contains("folds come from that"), "{said}");
        let smooth = solved(&scene(&file, ", smooth = \"2 nm\"", folds), "");
        assert!((pull_off(&smooth) / ideal - 1.0).abs() < 0.1, "{ideal} {smooth}");
        let said = notes(&smooth);
        assert!(said.contains("smoothed over 2e-9 m") && said.matches(" N smoothed over").count() == 3, "{said}");
    }
}

/// What the rows resolve is taken as it is, without a word.
#[test]
fn tables_without_noise_have_no_warning() {
    for (name, f) in TIPS {
        for rows in [20, 60, 300, 1000] {
            let r = |i: i32| 45.0 * f64::from(i) / f64::from(rows);
            let file = table("without-noise.csv", (0..=rows).map(|i| (r(i), format!("{}", f(r(i))))));
            let answer = solved(&scene(&file, "", "want = [\"folds\"]"), "--f64");
            assert!(!notes(&answer).contains("scatter"), "{name}, {rows} rows: {answer}");
        }
    }
}

/// Three digits of a height are enough for few rows, and make rings of many: the warning says where they come from.
#[test]
fn rounded_heights() {
    let three = |f: f64| {
        format!(
            "{:.*}",
            if f < 1.0 {
                3
            } else if f < 10.0 {
                2
            } else {
                1
            },
            f
        )
    };
    let said = |rows: i32| {
        let r = |i: i32| 45.0 * f64::from(i) / f64::from(rows);
        let file = table("rounded.csv", (0..=rows).map(|i| (r(i), three(TIPS[0].1(r(i))))));
        notes(&solved(&scene(&file, "", "want = [\"folds\"]"), "--f64"))
    };
    assert!(!said(20).contains("scatter"), "{}", said(20));
    let many = said(800);
    assert!(
        many.contains("as the rounding of their last digit does") && many.contains("folds come from that"),
        "{many}"
    );
}

#[test]
fn lengths_of_smoothing() {
    let file = table("to-smooth.csv", (0..=20).map(|i| (f64::from(i), format!("{}", f64::from(i * i) / 40.0))));
    let refused = |keys: &str| refusal(&scene(&file, keys, "want = [\"folds\"]"));
    assert!(
        refused(", smooth = \"0.9 nm\"").contains("must be longer than 1.000e-9"),
        "{}",
        refused(", smooth = \"0.9 nm\"")
    );
    assert!(refused(", smooth = 2").contains("must be shorter than the profile, which ends at 2e-8"));
    assert!(refused(", smooth = 0").contains("must be positive"));
    assert!(refused(", smooth = \"2 V\"").contains("unknown unit `V`"));
    assert!(refused(", smooth = \"2 nN\"").contains("smooth is in m; got \"2 nN\""));
    assert!(refused(", smooth = \"2 nm\", offset = 0").contains("cannot be given together with `offset`"));
    // A paraboloid is smooth already.
    let force = |keys: &str| pull_off(&solved(&scene(&file, keys, "want = [\"folds\"]"), ""));
    assert!((force(", smooth = 2e-9") / force("") - 1.0).abs() < 1e-10);
}
