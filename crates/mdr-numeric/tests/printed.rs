//! The heights that the documentation prints are those that the program computes.

use std::fs;
use std::path::Path;

use mdr_core::contact::{Expression, Flank, Profile, Shape};
use mdr_core::number::Literal;
use mdr_numeric::profiles::Heights;

/// A row of the table of docs/scenes.md: the kind, its keys with the letters that stand for them, and f(r).
struct Row {
    kind: String,
    letters: Vec<(String, String)>,
    formula: String,
}

fn document(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The rows of shapes; rows of sums, formulas and tables print no formula.
fn rows() -> Vec<Row> {
    let text = document("docs/scenes.md");
    let quoted = |cell: &str| cell.split('`').nth(1).map(str::to_owned);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split('|').collect();
        let [_, kind, keys, f, _] = cells[..] else { return None };
        let kind = quoted(kind)?;
        Shape::by_name(&kind)?;
        let letters = keys.split(',').map(|key| {
            let key = key.trim();
            let (name, letter) = key.split_once(' ').unwrap_or((key, key.trim_matches('`')));
            (name.trim_matches('`').to_owned(), letter.trim_matches('`').to_owned())
        });
        Some(Row { letters: letters.collect(), formula: quoted(f)?, kind })
    };
    text.lines().filter_map(row).collect()
}

/// A shape with numbers, that every letter has another one: its heights, and the printed formula with these numbers.
fn heights(row: &Row) -> (Heights<f64>, Expression, Vec<(String, f64)>) {
    let number = |key: &str| match key {
        "n" => 1.7,
        "slope" => 0.35,
        "amplitude" => 0.03,
        "flat" | "offset" | "cap" => 0.8,
        "depth" => 0.2,
        "height" => 1.3,
        "wavelength" => 0.6,
        _ => 2.25,
    };
    let blank = Shape::by_name(&row.kind).expect("a shape");
    let names: Vec<&str> = blank.parameters().into_iter().map(|(key, ())| key).collect();
    assert_eq!(row.letters.iter().map(|(key, _)| key.as_str()).collect::<Vec<_>>(), names, "keys of {}", row.kind);
    let shape = blank.map(|key, ()| number(key));
    let values = row.letters.iter().map(|(key, letter)| (letter.clone(), number(key))).collect();
    let formula = row.formula.parse().unwrap_or_else(|error| panic!("{}: {error}", row.formula));
    (Heights::new([shape]).expect("in the domain"), formula, values)
}

#[test]
fn every_shape_has_its_row_and_f_as_printed_is_what_the_program_computes() {
    let rows = rows();
    let kinds: Vec<&str> = rows.iter().map(|row| row.kind.as_str()).collect();
    assert_eq!(kinds.len(), 16, "{kinds:?}");
    for row in &rows {
        let (heights, formula, values) = heights(row);
        let used: Vec<String> = formula.parameters().collect();
        let given = values.iter().filter(|(letter, _)| used.contains(letter));
        let given =
            given.map(|(letter, value)| (letter.clone(), value.to_string().parse::<Literal>().expect("a decimal")));
        let printed = formula.bind::<f64>((), &given.collect()).expect("every letter is a key");
        let end = Profile::<f64>::outer_radius(&heights).unwrap_or(7.0);
        for share in [0.0, 1e-6, 0.01, 0.1, 0.3, 0.5, 0.77, 0.9, 0.999] {
            let r: f64 = share * end;
            let [f, expected]: [f64; 2] = [heights.height(&r), printed.height(&r)];
            // Ten operations on terms no larger than the parameters: the printed formulas cancel near the tip.
            let allowed = 32.0 * f64::EPSILON * (10.0 + expected.abs());
            assert!((f - expected).abs() <= allowed, "{}: f({r}) = {f}, printed {expected}", row.kind);
            assert!(share > 0.0 || f == 0.0, "{}: f(0) = {f}", row.kind);
        }
    }
}

/// A cone has a name for its slope in Rust, and no other parameter.
#[test]
fn the_slope_is_that_of_the_flank() {
    let cone = Heights::new([Shape::Cone { flank: Flank::Slope(0.35) }]).expect("in the domain");
    assert_eq!(cone.height(&2.0), 0.7);
}

#[test]
fn rust_and_python_print_the_formulas_of_the_table() {
    let python = document("crates/mdr-python/python/mdr/_profiles.py");
    for Row { kind, formula, letters } in rows() {
        let shape = Shape::by_name(&kind).expect("a shape");
        assert_eq!(shape.text(), formula, "f of {kind}");
        assert!(letters.iter().map(|(_, letter)| letter).eq(shape.symbols()), "letters of {kind}: {letters:?}");
        // In Python between the class and its kind.
        let above = python.split_once(&format!("] = \"{kind}\"")).expect("a class").0;
        let own = above.rsplit_once("class ").map_or(above, |(_, own)| own);
        assert!(own.contains(&format!("``{formula}``")), "the class of {kind} lacks ``{formula}``");
    }
}
