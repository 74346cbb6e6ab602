//! What an addition costs: how many source files name one profile shape, output, medium, check or family of records.
//!
//! docs/contributing.md has the recipe of each. A source file is one of Rust, Python or JavaScript, or a table that declares what is
//! counted (`checks.tsv` of the checks, `contacts.toml` of the formulas of records). Not counted are comments, tests, benches,
//! examples, documents, and data that ask questions (cases of records, stability ladders). A file is counted when its code has the
//! name as a word (`RoundedPunch`) or in quotes (`"rounded-punch"`).

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A file from the folder of the repository.
fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A source file: its path from the folder of the repository, and its code without comments and tests.
struct Source {
    path: String,
    code: String,
}

/// All source files.
fn sources() -> Vec<Source> {
    let mut found = Vec::new();
    let mut folders: Vec<PathBuf> = ["crates", "book", "web"].map(|name| root().join(name)).into();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let path = entry.path();
            let name = entry.file_name().into_string().unwrap();
            if path.is_dir() {
                let left_out = ["target", "tests", "benches", "examples", "data", "node_modules"];
                if !left_out.contains(&name.as_str()) && !name.starts_with('.') {
                    folders.push(path);
                }
            } else if let Some((_, "rs" | "py" | "pyi" | "js")) = name.rsplit_once('.') {
                found.push(source(path.strip_prefix(root()).unwrap().to_str().unwrap()));
            }
        }
    }
    found.push(source(CHECKS));
    assert!(found.len() > 300, "only {} sources", found.len());
    found
}

fn source(path: &str) -> Source {
    let text = read(path);
    let tested = if path.ends_with(".rs") { text.split("#[cfg(test)]").next().unwrap() } else { &text };
    let marks: &[&str] = if path.ends_with("rs") || path.ends_with("js") { &["//", "*", "/*"] } else { &["#"] };
    let comment = |line: &&str| !marks.iter().any(|mark| line.trim_start().starts_with(mark));
    Source { path: path.replace('\\', "/"), code: tested.lines().filter(comment).collect::<Vec<_>>().join("\n") }
}

/// Whether code has this word, not as a part of a longer one. Quotes are parts of the word.
fn names(code: &str, word: &str) -> bool {
    let part = |letter: char| letter.is_alphanumeric() || letter == '_';
    code.match_indices(word).any(|(at, _)| {
        let (before, after) = (code[..at].chars().next_back(), code[at + word.len()..].chars().next());
        word.starts_with(['"', '\'']) || !(before.is_some_and(part) || after.is_some_and(part))
    })
}

/// The files that name something: by the words, or by the key in quotes.
fn files<'a>(sources: &'a [Source], words: &[&str], key: &str) -> Vec<&'a str> {
    let quoted = [format!("\"{key}\""), format!("'{key}'")];
    let named =
        |code: &str| words.iter().copied().chain(quoted.iter().map(String::as_str)).any(|word| names(code, word));
    sources.iter().filter(|source| named(&source.code)).map(|source| source.path.as_str()).collect()
}

/// What is named in more files than an addition of its kind may cost, or nowhere.
fn dear(most: usize, what: &str, files: &[&str]) -> Option<String> {
    let wrong = files.is_empty() || files.len() > most;
    wrong.then(|| format!("{what} is named in {} source files, at most {most} allowed: {files:#?}", files.len()))
}

/// Fails with all that is too dear.
fn verdict(dear: Vec<String>) {
    assert!(dear.is_empty(), "an addition costs more than docs/contributing.md says:\n{}", dear.join("\n"));
}

/// Shapes that stand for a contact in general, in flags, figures, checks and measurements.
const EVERYDAY: [&str; 2] = ["power", "paraboloid"];

/// Shapes that such places name as well, or that are a sum of powers: in so many files by now. A new shape costs five.
const NAMED_IN_EXAMPLES: [(&str, usize); 6] =
    [("cone", 13), ("sphere", 15), ("ellipsoid", 7), ("flat-punch", 8), ("rounded-punch", 6), ("wavy-paraboloid", 15)];

/// The shapes as their declaration lists them: variant and key.
fn shapes() -> Vec<(String, String)> {
    let text = read("crates/mdr-core/src/contact/shape.rs");
    let declared = text.lines().filter_map(|line| line.trim().strip_suffix("\" {")?.split_once(" = \""));
    declared.map(|(variant, key)| (variant.to_owned(), key.to_owned())).collect()
}

/// The declaration, its heights f(r), its closed form g(x), the class of Python, and its subject in the cross-check.
#[test]
fn a_shape_costs_five_files() {
    let (sources, shapes) = (sources(), shapes());
    assert!(shapes.len() >= 16 && EVERYDAY.iter().all(|name| shapes.iter().any(|(_, key)| key == name)));
    let counted = shapes.iter().filter(|(_, key)| !EVERYDAY.contains(&key.as_str()));
    let most = |key: &str| NAMED_IN_EXAMPLES.iter().find(|(name, _)| *name == key).map_or(5, |(_, most)| *most);
    verdict(counted.filter_map(|(variant, key)| dear(most(key), key, &files(&sources, &[variant], key))).collect());
}

/// Outputs that other outputs, the control of a scene and records of states also name.
const OUTPUTS_NAMED_ELSEWHERE: [&str; 4] = ["equilibria", "folds", "path", "gap"];

/// What an output costs where it is more than 3: fields share one more file.
const COSTS_OF_OUTPUTS: [(&str, usize); 2] = [("pressure", 4), ("displacement", 4)];

/// The outputs as the library lists them: room, variant and key.
fn outputs() -> Vec<(String, String, String)> {
    let text = read("crates/mdr/src/outputs/mod.rs");
    let declared = text.lines().filter_map(|line| {
        let (room, rest) = line.trim().split_once(": ")?;
        let (variant, rest) = rest.split_once(" = \"")?;
        let (key, _) = rest.split_once('"')?;
        Some((room.to_owned(), variant.to_owned(), key.to_owned()))
    });
    declared.collect()
}

/// The room, which may be a folder; the list; and a section of docs/scenes.md. Counted in the library, without what is no scene:
/// `critical`, and arrays of doubles.
#[test]
fn an_output_costs_what_is_listed() {
    let (sources, outputs, page) = (sources(), outputs(), read("docs/scenes.md"));
    assert!(outputs.len() >= 10, "{outputs:?}");
    let library = |path: &&str| {
        let inside = path.strip_prefix("crates/mdr/src/");
        inside.is_some_and(|inside| !inside.starts_with("columns/") && !inside.starts_with("critical/"))
    };
    let counted = outputs.iter().filter(|(.., key)| !OUTPUTS_NAMED_ELSEWHERE.contains(&key.as_str()));
    let cost = |(room, variant, key): &(String, String, String)| {
        let words = ["OutputKind", "Output", "Want", "Field"].map(|kind| format!("{kind}::{variant}"));
        let mut found = files(&sources, &words.each_ref().map(String::as_str), key);
        found.retain(library);
        let folder = format!("crates/mdr/src/outputs/{room}");
        found.retain(|path| !path.starts_with(&folder));
        found.push(&folder);
        found.extend(page.contains(&format!("`{key}`")).then_some("docs/scenes.md"));
        let most = COSTS_OF_OUTPUTS.iter().find(|(output, _)| output == key).map_or(3, |(_, most)| *most);
        dear(most, key, &found)
    };
    verdict(counted.filter_map(cost).collect());
}

/// What media cost that have no records of their own, so that a file more is seen; a periodic one has a figure.
const COSTS_OF_MEDIA: [(&str, usize); 3] = [("winkler", 6), ("plane", 5), ("periodic", 6)];

/// S(a), A(a) and g in `medium.rs` and its folder, its fields, its keys in a scene, its numbers in one arithmetic, its class of
/// Python, and records or figures of its own; without its closed forms and its transform, which are modules of their own, and
/// without the explorer and its figures in the book, which show a choice of media.
#[test]
fn a_medium_costs_seven_files() {
    let sources = sources();
    let text = read("crates/mdr-numeric/src/medium.rs");
    let (_, declared) = text.split_once("pub enum Medium<R> {").unwrap();
    let variants = declared
        .lines()
        .take_while(|line| *line != "}")
        .filter_map(|line| line.strip_prefix("    ")?.strip_suffix(" {"));
    let variants: Vec<_> = variants.filter(|variant| *variant != "HalfSpace").collect();
    assert!(variants.len() >= 4, "{variants:?}");
    let cost = |variant: &str| {
        let key = variant.to_lowercase();
        let mut found = files(
            &sources,
            &["Medium", "ExactMedium"].map(|name| format!("{name}::{variant}")).each_ref().map(String::as_str),
            &key,
        );
        let left_out = ["crates/mdr-numeric/src/medium/", "web/", "book/src/spine.rs"];
        found.retain(|path| !left_out.iter().any(|start| path.starts_with(start)));
        let most = COSTS_OF_MEDIA.iter().find(|(name, _)| *name == key).map_or(7, |(_, most)| *most);
        dear(most, &key, &found)
    };
    verdict(variants.into_iter().filter_map(cost).collect());
}

/// Checks whose name also is a shape, a function of Python or the derivation that they check.
const CHECKS_NAMED_ELSEWHERE: [&str; 7] = [
    "kappa-series",
    "critical-indentation",
    "critical-force",
    "critical-machine",
    "universal-curves",
    "jkr",
    "flat-punch",
];

const CHECKS: &str = "crates/mdr-crosscheck/data/checks.tsv";

/// The description, the list of functions, and the module that has the function.
#[test]
fn a_check_costs_three_files() {
    let (sources, list) = (sources(), read("crates/mdr-crosscheck/src/checks/mod.rs"));
    let table = read(CHECKS);
    let checks: Vec<_> =
        table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').next().unwrap()).collect();
    assert!(checks.len() > 40 && CHECKS_NAMED_ELSEWHERE.iter().all(|name| checks.contains(name)), "{checks:?}");
    verdict(
        checks
            .into_iter()
            .filter(|check| !CHECKS_NAMED_ELSEWHERE.contains(check))
            .filter_map(|check| {
                let (_, run) =
                    list.split_once(&format!("(\"{check}\", ")).unwrap_or_else(|| panic!("{check} is not run"));
                let words = run.split(|letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == ':'));
                let module = words.filter_map(|word| word.split_once("::")).map(|(module, _)| module).next().unwrap();
                let module = format!("crates/mdr-crosscheck/src/checks/{module}.rs");
                assert!(sources.iter().any(|source| source.path == module), "{check}: {module}");
                let mut files = files(&sources, &[], check);
                files.retain(|path| *path != module);
                files.extend([CHECKS, &module]);
                dear(3, check, &files)
            })
            .collect(),
    );
}

const FORMULAS: &str = "crates/mdr-records/data/contacts.toml";

/// Families whose name also is a key of scenes and answers, a chapter of the book or a quantity, or which the judge knows to explain
/// answers by a mistaken convention.
const FAMILIES_NAMED_ELSEWHERE: [&str; 12] = [
    "kappa",
    "transform",
    "state",
    "flat-punch-pull-off",
    "critical",
    "machine-folds",
    "folds",
    "equilibrium",
    "equilibrium-share",
    "equilibria",
    "energy",
    "threshold",
];

/// What is published with the family, the list of functions, the module that has the function, and its title in the book.
#[test]
fn a_family_of_records_costs_four_files() {
    let (sources, list) = (sources(), read("crates/mdr-records/src/lib.rs"));
    let (_, kinds) = list.split_once("const KINDS:").unwrap();
    let rows = kinds.lines().skip(1).take_while(|line| line.starts_with("    (\""));
    let rows: Vec<_> = rows.map(|line| line.trim().trim_matches(['(', ')', ',']).split_once(", ").unwrap()).collect();
    assert!(rows.len() >= 18, "{rows:?}");
    let counted = rows
        .into_iter()
        .map(|(kind, function)| (kind.trim_matches('"'), function))
        .filter(|(kind, _)| !FAMILIES_NAMED_ELSEWHERE.contains(kind));
    verdict(
        counted
            .filter_map(|(kind, function)| {
                let module = format!("crates/mdr-records/src/{}.rs", function.split_once("::").unwrap().0);
                let mut files = files(&sources, &[], kind);
                files.retain(|path| *path != module && *path != FORMULAS);
                files.extend([FORMULAS, &module]);
                dear(4, kind, &files)
            })
            .collect(),
    );
}

#[test]
fn words_are_counted_as_words() {
    assert!(names("Shape::Cone { flank }", "Cone") && names("kind == \"cone\"", "\"cone\""));
    assert!(!names("TruncatedCone::new()", "Cone") && !names("let cone = 1;", "\"cone\""));
    let file = |path: &str, code: &str| Source { path: path.to_owned(), code: code.to_owned() };
    let sources = [file("a", "Cone"), file("b", "'cone'"), file("c", "cone"), file("d", "ConeCap")];
    assert_eq!(files(&sources, &["Cone"], "cone"), ["a", "b"]);
    assert!(
        dear(1, "cone", &["a", "b"]).is_some()
            && dear(2, "cone", &["a", "b"]).is_none()
            && dear(2, "cone", &[]).is_some()
    );
}
