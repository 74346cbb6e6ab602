//! The book as it would be published, read without a browser.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::OnceLock;

use mdr_book::{BookFiles, build};
use mdr_symbolic::derivations::{entries, entry};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn book() -> &'static BookFiles {
    static BOOK: OnceLock<BookFiles> = OnceLock::new();
    BOOK.get_or_init(|| build(root(), false).unwrap())
}

/// The pages, as text.
fn pages() -> impl Iterator<Item = (&'static str, &'static str)> {
    let pages = book().iter().filter(|(name, _)| name.ends_with(".html"));
    pages.map(|(name, bytes)| (name.as_str(), std::str::from_utf8(bytes).unwrap()))
}

/// The values of an attribute in the order of a page.
fn attributes<'a>(page: &'a str, name: &str) -> impl Iterator<Item = &'a str> {
    let open = format!(" {name}=\"");
    page.split('<').filter_map(move |tag| {
        let (tag, _) = tag.split_once('>')?;
        let (_, rest) = tag.split_once(&open)?;
        rest.split_once('"').map(|(value, _)| value)
    })
}

/// What a reader sees of a page: without tags, sources of formulas and code.
fn words(page: &str) -> String {
    let mut text = page.to_owned();
    for (open, close) in [("<math", "</math>"), ("<code", "</code>"), ("<pre", "</pre>"), ("<script", "</script>")] {
        while let Some((before, rest)) = text.split_once(open) {
            text = format!("{before} {}", rest.split_once(close).unwrap().1);
        }
    }
    text.split('<').map(|part| part.split_once('>').map_or(part, |(_, words)| words)).collect()
}

/// The part of a page between two marks.
fn part<'a>(page: &'a str, open: &str, close: &str) -> &'a str {
    page.split_once(open).and_then(|(_, rest)| rest.split_once(close)).map_or("", |(part, _)| part)
}

#[test]
fn every_link_leads_somewhere() {
    let mut seen = 0;
    for (name, page) in pages() {
        let here: BTreeSet<_> = attributes(page, "id").collect();
        for link in attributes(page, "href").chain(attributes(page, "src")) {
            if link.starts_with("https://") || link.starts_with("http://") {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() {
                page
            } else {
                assert!(book().contains_key(file), "{name}: {link}");
                std::str::from_utf8(&book()[file]).unwrap_or("")
            };
            let found = anchor.is_empty()
                || (file.is_empty() && here.contains(anchor))
                || attributes(target, "id").any(|id| id == anchor);
            assert!(found, "{name}: {link}");
            seen += 1;
        }
    }
    assert!(seen > 5000, "{seen} links");
}

#[test]
fn an_identifier_occurs_once() {
    for (name, page) in pages() {
        let mut seen = BTreeSet::new();
        for id in attributes(page, "id") {
            assert!(seen.insert(id), "{name}: two of {id}");
        }
    }
}

#[test]
fn nothing_is_asked_from_anywhere() {
    for (name, page) in pages() {
        for source in attributes(page, "src") {
            assert!(!source.contains("//"), "{name}: {source}");
        }
        for tag in page.split("<link").skip(1) {
            assert!(!tag.split_once('>').unwrap().0.contains("//"), "{name}: a style from elsewhere");
        }
    }
    for name in ["book.css", "book.js", "theme.js"] {
        let text = std::str::from_utf8(&book()[name]).unwrap();
        assert!(!text.contains("http://") && !text.contains("https://") && !text.contains("@import"), "{name}");
    }
}

#[test]
fn every_entry_has_its_page_with_its_anchors_and_prose() {
    for entry in entries() {
        let page = std::str::from_utf8(&book()[&format!("{}.html", entry.id)]).unwrap();
        assert!(page.contains(&format!("data-entry=\"{}\"", entry.id)), "{}", entry.id);
        let ids: BTreeSet<_> = attributes(page, "id").collect();
        for anchor in ["why", "proof", "numbers", "code"] {
            assert!(ids.contains(anchor), "{}: no {anchor}", entry.id);
        }
        assert!(ids.contains("printed") != ids.contains("result"), "{}", entry.id);
        assert!(!entry.refuted || ids.contains("corrected"), "{}", entry.id);
        for step in 1..=entry.steps.len() {
            assert!(ids.contains(format!("step-{step}").as_str()), "{}: no step {step}", entry.id);
        }
        let why = words(part(page, "<section id=\"why\">", "</section>"));
        assert!(why.split_whitespace().count() > 30, "{}: too few words: {why}", entry.id);
    }
}

/// In units in which Δl = √a and g = a², an equilibrium solves a² − √a = d, and the contact breaks at d = −3/4^{4/3}.
#[test]
fn the_picture_that_moves_goes_through_equilibria() {
    let page = pages().find(|(name, _)| *name == "index.html").unwrap().1;
    let frames = part(page, "data-frames=\"[[", "]]\"");
    let frames: Vec<Vec<f64>> =
        frames.split("],[").map(|frame| frame.split(',').map(|number| number.parse().unwrap()).collect()).collect();
    assert_eq!(frames.len(), 121);
    let breaks = -3.0 / 4_f64.powf(4.0 / 3.0);
    for (i, frame) in frames.iter().enumerate() {
        let (d, a) = (frame[0], frame[1]);
        // Brought near, the surfaces touch at d = 0; pulled, they hold on.
        let touching = if i <= 60 { d >= 0.0 } else { d > breaks };
        assert_eq!(a > 0.0, touching, "{frame:?}");
        if touching {
            assert!((a * a - a.sqrt() - d).abs() < 3e-4, "{frame:?}");
        }
    }
}

#[test]
fn every_formula_is_set() {
    let mut formulas = 0;
    for (name, page) in pages() {
        formulas += page.matches("<math").count();
        let text = words(page);
        for mark in ["$`", "`$", "$$", "\\frac", "\\sqrt", "\u{e000}", "\u{e001}", "```"] {
            assert!(!text.contains(mark), "{name}: {mark} in {text}");
        }
    }
    assert!(formulas > 1000, "{formulas} formulas");
}

/// Mathematics beside typeset formulas looks broken; what is meant as a formula is one.
#[test]
fn no_formula_is_typed_as_text_on_the_page_of_an_entry() {
    for entry in entries() {
        let page = std::str::from_utf8(&book()[&format!("{}.html", entry.id)]).unwrap();
        for part in [
            part(page, "<section id=\"why\">", "</section>"),
            part(page, "<section id=\"proof\">", "</section>"),
            part(page, "<section id=\"refutation\">", "</section>"),
        ] {
            let text = words(part);
            let typed = ['^', '√', '∫', '_', '²', 'ⁿ', '₀'];
            assert!(!text.contains(typed), "{}: {text}", entry.id);
        }
    }
}

#[test]
fn theory_and_validity_are_typeset() {
    for name in ["theory.html", "validity.html", "figures.html"] {
        let page = std::str::from_utf8(&book()[name]).unwrap();
        let text = words(part(page, "<main", "</main>"));
        for typed in ["^", "√", "∫", "_"] {
            assert!(!text.contains(typed), "{name}: {typed} in {text}");
        }
    }
}

#[test]
fn a_correction_is_marked_on_both_forms() {
    for id in ["1.15", "1.17"] {
        let page = std::str::from_utf8(&book()[&format!("{id}.html")]).unwrap();
        assert!(part(page, "id=\"printed\"", "</figure>").contains("class=\"wrong\""), "{id}");
        assert!(part(page, "id=\"corrected\"", "</figure>").contains("class=\"right\""), "{id}");
        assert!(entry(id).unwrap().erratum.is_some());
    }
}

#[test]
fn certified_values_have_all_their_digits() {
    let page = std::str::from_utf8(&book()["1.17.html"]).unwrap();
    let record = mdr_reference::record("critical/jkr-unit/indentation/force").unwrap();
    let digits = record.value.as_ref().unwrap().mid.trim_start_matches('-');
    assert!(digits.len() > 50 && page.contains(digits), "{digits}");
    let shown: usize = mdr_reference::records()
        .iter()
        .filter(|record| {
            let id = format!("id=\"{}\"", record.id);
            pages().any(|(name, page)| name.starts_with("values-") && page.contains(&id))
        })
        .count();
    assert_eq!(shown, mdr_reference::records().len());
}

/// An image keeps the proportions of its file, unless the page says which others it may take.
#[test]
fn pictures_of_several_panels_say_how_they_stack() {
    for name in ["hysteresis.html", "wavy.html", "figures.html", "report.html"] {
        let page = std::str::from_utf8(&book()[name]).unwrap();
        assert!(attributes(page, "style").any(|style| style.starts_with("--stacked:")), "{name}");
    }
}

#[test]
fn pages_are_small() {
    let total: usize = book().values().map(Vec::len).sum();
    // The sources to which pages lead are four of these.
    assert!(total < 11_000_000, "{total} bytes");
    for (name, page) in pages() {
        assert!(page.len() < 320_000, "{name}: {} bytes", page.len());
    }
}

#[test]
fn the_book_is_the_same_twice_and_one_script_says_where_the_explorer_is() {
    let again = build(root(), true).unwrap();
    assert_eq!(again.keys().collect::<Vec<_>>(), book().keys().collect::<Vec<_>>());
    for (name, bytes) in &again {
        assert_eq!(bytes != &book()[name], name == "explorer-here.js", "{name}");
        assert!(
            !name.ends_with(".html") || String::from_utf8_lossy(bytes).contains("src=\"explorer-here.js\""),
            "{name}"
        );
    }
}

/// Eight pages before the reference, each with one picture, one question and less than 300 words; one leads to the next.
#[test]
fn the_spine_is_short_and_leads_into_the_reference() {
    let mut name = "ball.html".to_owned();
    for _ in 0..8 {
        let page = std::str::from_utf8(&book()[&name]).unwrap();
        let main = part(page, "<div class=\"spine\">", "<footer");
        let count = words(main).split_whitespace().count();
        assert!((120..300).contains(&count), "{name}: {count} words");
        for one in ["<figure class=\"live\"", "<details class=\"question\""] {
            assert_eq!(main.matches(one).count(), 1, "{name}: {one}");
        }
        name = part(page, "<a rel=\"next\" href=\"", "\"").to_owned();
    }
    assert_eq!(name, "method.html");
}

/// A number of an equation leads to it wherever it stands in prose, but for its own page.
#[test]
fn equations_are_links_in_prose() {
    let mut links = 0;
    for (name, page) in pages() {
        links += page.matches("<a class=\"ref\"").count();
        let mut text = part(page, "<main", "</main>").to_owned();
        for (open, close) in [("<a ", "</a>"), ("<h1", "</h1>"), ("<h2", "</h2>"), ("<h3", "</h3>"), ("<svg", "</svg>")]
        {
            while let Some((before, rest)) = text.split_once(open) {
                text = format!("{before} {}", rest.split_once(close).unwrap().1);
            }
        }
        let text = words(&text);
        for entry in entries().iter().filter(|entry| entry.id.starts_with("1.")) {
            let own = name == format!("{}.html", entry.id);
            assert!(own || !text.contains(&format!("({})", entry.id)), "{name}: ({}) is no link", entry.id);
        }
    }
    assert!(links > 150, "{links} links");
}

/// Over a step that is only sampled, an entry is not called a theorem.
#[test]
fn the_verdict_on_an_entry_is_that_of_its_weakest_step() {
    for entry in entries() {
        let page = std::str::from_utf8(&book()[&format!("{}.html", entry.id)]).unwrap();
        let shown = part(page, "data-verdict=\"", "\"");
        let weak =
            ["sampled", "cited"].into_iter().find(|word| entry.steps.iter().any(|step| step.verdict().word() == *word));
        if let (Some(_), false) = (weak, entry.refuted) {
            assert!(["sampled", "cited"].contains(&shown), "{}: {shown}", entry.id);
            assert!(page.contains(&format!("class=\"badge {shown}\"")), "{}", entry.id);
        }
    }
}

#[test]
fn a_missing_source_is_named() {
    let error = build(Path::new("nowhere"), false).unwrap_err().to_string();
    assert!(error.contains("docs/conformance.md"), "{error}");
}
