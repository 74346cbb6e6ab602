//! The pages of the book, from the sources of the project.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::LazyLock;

use maud::{Markup, html};
use mdr_crosscheck::derivations::{Judgement, judge_all};
use mdr_symbolic::Symbol;
use mdr_symbolic::derivations::Verdict;
use mdr_symbolic::formula::Definition;

use crate::bibliography::Bibliography;
use crate::chapters::{CHAPTERS, Chapter, order};
use crate::conformance::{self, Row};
use crate::entry::{badges, standing, title};
use crate::error::{Error, Result};
use crate::figures::{self, Figures};
use crate::fits;
use crate::links::{DOCUMENTS, Links, Shelf, heading, is_equation, is_picture, published};
use crate::markdown::{self, Math, Page, escaped};
use crate::moving;
use crate::references::cards;
use crate::shell::{Contents, Sheet, raw};
use crate::spine::{self, SPINE};
use crate::tex::Tex;
use crate::text::{Text, read};
use crate::values;

/// The data and tools that every page needs.
pub(crate) struct Book<'a> {
    pub(crate) root: &'a Path,
    pub(crate) tex: Tex,
    pub(crate) conformance: Vec<Row>,
    pub(crate) figures: Figures,
    bibliography: Bibliography,
    /// BookFiles of the project to which some page leads.
    wanted: BTreeSet<String>,
}

/// The derivations with their verdicts, judged once for all books of a process: that is half of the work.
static JUDGED: LazyLock<Vec<Judgement>> = LazyLock::new(judge_all);

/// The script that says whether the explorer stands beside the book.
const HERE: &str = "explorer-here.js";

/// The files of the book by name.
pub type BookFiles = BTreeMap<String, Vec<u8>>;

/// Makes the book from the project at `root`. `explorer`: whether the explorer stands beside it, at `explorer.html`.
///
/// # Errors
/// A source that is missing or is not as the book needs it.
pub fn build(root: &Path, explorer: bool) -> Result<BookFiles> {
    let mut book = Book {
        root,
        tex: Tex::new()?,
        conformance: conformance::rows(&read(root, "docs/conformance.md")?),
        figures: Figures::read(root)?,
        bibliography: Bibliography::read(root)?,
        wanted: BTreeSet::new(),
    };
    let sheets = book.sheets()?;
    let contents = contents(&sheets);
    let mut files = assets(root)?;
    for (i, sheet) in sheets.iter().enumerate() {
        let around = [i.checked_sub(1).and_then(|before| sheets.get(before)), sheets.get(i + 1)];
        files.insert(format!("{}.html", sheet.name), contents.page(sheet, around).into_bytes());
    }
    files.insert("search.js".to_owned(), index(&sheets).into_bytes());
    files.insert("cards.js".to_owned(), cards(root, &book.tex)?.into_bytes());
    // Written again by what builds the explorer, whichever of both comes first.
    files.insert(HERE.to_owned(), format!("window.EXPLORER={explorer};\n").into_bytes());
    book.sources(&contents, &mut files)?;
    figures::stack(&mut files);
    Ok(files)
}

impl Book<'_> {
    /// Markdown as HTML; `name` is the file it is from, against which its links are resolved.
    pub(crate) fn markdown(&mut self, name: &str, text: &str, math: Math) -> Result<Page> {
        let mut links = Links::new(self.root, name, &mut self.wanted);
        markdown::page(text, math, &self.tex, &mut links)
    }

    /// A line of Markdown as HTML.
    pub(crate) fn line(&mut self, name: &str, text: &str) -> Result<String> {
        let mut links = Links::new(self.root, name, &mut self.wanted);
        markdown::line(text, Math::Fences, &self.tex, &mut links)
    }

    /// The page of a file of the project.
    pub(crate) fn source(&mut self, path: &str) -> Result<String> {
        let mut links = Links::new(self.root, path, &mut self.wanted);
        links.source(path)?.ok_or_else(|| Error::page(path, "there is no such file"))
    }

    /// A reference, with a link to the bibliography if it is there.
    pub(crate) fn reference(&self, text: &str) -> Result<String> {
        let key =
            self.bibliography.key(text).ok_or_else(|| Error::page("book/bibliography.tsv", format!("lacks {text}")))?;
        Ok(format!("{} <a href=\"bibliography.html#{key}\">[{key}]</a>", escaped(text)))
    }

    /// All pages, in the order in which they are read.
    fn sheets(&mut self) -> Result<Vec<Sheet>> {
        let judgements = &**JUDGED;
        let mut sheets = vec![self.written("index", judgements)?];
        for name in SPINE {
            sheets.push(self.spine(name)?);
        }
        for chapter in &CHAPTERS {
            sheets.push(self.chapter(chapter, judgements)?);
            for entry in chapter.entries() {
                let found = judgements.iter().find(|judgement| judgement.entry.id == entry.id);
                let judgement = found.ok_or_else(|| Error::page(entry.id, "it was not judged"))?;
                sheets.push(self.entry_sheet(judgement)?);
            }
        }
        sheets.extend(self.documents(Shelf::Front)?);
        sheets.push(self.written("notation", judgements)?);
        sheets.push(self.written("verdicts", judgements)?);
        sheets.push(self.written("contents", judgements)?);
        sheets.push(plain("values", "Certified values", values::index()));
        for (family, title) in values::FAMILIES {
            sheets.push(plain(&format!("values-{family}"), title, values::family_page(family)));
        }
        for set in mdr_reference::data_sets() {
            sheets.push(plain(&format!("fit-{}", set.name), &format!("Data set {}", set.name), fits::page(set)?));
        }
        sheets.extend(self.documents(Shelf::Numbers)?);
        sheets.extend(self.documents(Shelf::Program)?);
        sheets.push(plain("bibliography", "Bibliography", self.bibliography.page()));
        sheets.push(self.written("cite", judgements)?);
        Ok(sheets)
    }

    /// A page of the spine: its text, with the figure where the text has a line of its own for it.
    fn spine(&mut self, name: &str) -> Result<Sheet> {
        let file = format!("book/text/spine-{name}.md");
        let page = self.markdown(&file, &read(self.root, &file)?, Math::Dollars)?;
        let figure = spine::figure(name)?.into_string();
        if !page.html.contains(FIGURE) {
            return Err(Error::page(file, "there is no line for the figure"));
        }
        let html = page.html.replace(FIGURE, &figure);
        let main = html! { h1 { (page.title) } div.spine { (raw(html)) } };
        Ok(Sheet { name: name.to_owned(), title: page.title, main, words: page.words, entry: None })
    }

    fn entry_sheet(&mut self, judgement: &Judgement) -> Result<Sheet> {
        let main = self.entry(judgement)?;
        let entry = judgement.entry;
        let words: Vec<_> = entry.steps.iter().map(|step| step.why).collect();
        let why = Text::read(self.root, entry.id)?.why;
        let verdict = if entry.refuted { entry.verdict() } else { standing(entry) }.word().to_owned();
        Ok(Sheet {
            name: entry.id.to_owned(),
            title: title(judgement),
            main,
            words: format!("{} {why} {}", entry.id, words.join(" ")),
            entry: Some((entry.id.to_owned(), verdict)),
        })
    }

    /// A chapter: its text, and its entries, each with its formula.
    fn chapter(&mut self, chapter: &Chapter, judgements: &[Judgement]) -> Result<Sheet> {
        let name = format!("book/text/chapter-{}.md", chapter.page);
        let page = self.markdown(&name, &read(self.root, &name)?, Math::Dollars)?;
        let mut entries = Vec::new();
        for entry in chapter.entries() {
            let text = Text::read(self.root, entry.id)?;
            let formula = text.corrected.or(text.printed).or(text.result).unwrap_or_default();
            let judgement = judgements.iter().find(|judgement| judgement.entry.id == entry.id);
            entries.push((entry, self.tex.display(&formula)?, judgement.map(badges)));
        }
        let main = html! {
            h1 { (chapter.title) }
            (raw(page.html))
            @for (entry, formula, badges) in entries { section.item {
                h2 id={ "entry-" (entry.id) } { a href={ (entry.id) ".html" } { (heading(entry)) } }
                (raw(formula))
                @if let Some(badges) = badges { p.badges { (badges) a href={ (entry.id) ".html#proof" } { "why, proof, numbers" } } }
            } }
        };
        Ok(Sheet {
            name: chapter.page.to_owned(),
            title: chapter.title.to_owned(),
            main,
            words: page.words,
            entry: None,
        })
    }

    /// The documents of a shelf that are there.
    fn documents(&mut self, shelf: Shelf) -> Result<Vec<Sheet>> {
        let mut sheets = Vec::new();
        for (file, name, of) in DOCUMENTS {
            if of != shelf || !self.root.join(file).is_file() {
                continue;
            }
            let text = read(self.root, file)?;
            let page = self.markdown(file, &for_readers(name, &text), Math::Fences)?;
            let extra = match name {
                "conformance" => {
                    html! { p { input type="search" data-filter="document" placeholder="Filter: 1.15, kappa, certified …" aria-label="Filter the tables"; } }
                }
                "errata" => html! { (self.errata()?) (citation()) },
                "validity" => validity(),
                _ => html! {},
            };
            let main = html! { h1 { (page.title) } (extra) div #document { (raw(page.html)) } };
            sheets.push(Sheet { name: name.to_owned(), title: page.title, main, words: page.words, entry: None });
        }
        Ok(sheets)
    }

    /// The corrections at a glance.
    fn errata(&self) -> Result<Markup> {
        let mut rows = Vec::new();
        for entry in order() {
            if let Some(erratum) = entry.erratum {
                rows.push((entry, self.prose(erratum.text)?));
            }
        }
        Ok(html! {
            div.table tabindex="0" role="group" aria-label="Errata" { table.errata {
                thead { tr { th { "where" } th { "what" } th { "the correction" } } }
                tbody { @for (entry, text) in rows { tr {
                    td { a href={ (entry.id) ".html" } { @if is_equation(entry) { "(" (entry.id) ")" } @else { (entry.id) } } }
                    td { (entry.title) } td { (raw(text)) }
                } } }
            } }
        })
    }

    /// A page whose text is in `book/text`, with the additions of the build.
    fn written(&mut self, name: &str, judgements: &[Judgement]) -> Result<Sheet> {
        let file = format!("book/text/{name}.md");
        let page = self.markdown(&file, &read(self.root, &file)?, Math::Dollars)?;
        let extra = match name {
            "index" => html! { (moving::picture()?) (overview(judgements)) },
            "notation" => self.symbols()?,
            "contents" => table(judgements),
            "cite" => html! { pre tabindex="0" { (read(self.root, "CITATION.cff")?) } },
            _ => html! {},
        };
        let main = html! { h1 { (page.title) } (raw(page.html)) (extra) };
        Ok(Sheet { name: name.to_owned(), title: page.title, main, words: page.words, entry: None })
    }

    /// The symbols and definitions of the derivations.
    fn symbols(&self) -> Result<Markup> {
        let mut rows = Vec::new();
        for symbol in Symbol::all() {
            rows.push((self.tex.inline(symbol.tex())?, escaped(symbol.meaning())));
        }
        let mut definitions = Vec::new();
        for definition in Definition::all() {
            let formula = definition.formula().map_err(|error| Error::page(definition.text(), error.to_string()))?;
            definitions.push(self.tex.display(&format!("{} = {}", definition.tex(), formula.tex()))?);
        }
        Ok(html! {
            h2 #symbols { "Symbols of the derivations" }
            div.table { table { tbody { @for (symbol, meaning) in rows { tr { td { (raw(symbol)) } td { (raw(meaning)) } } } } } }
            h2 #definitions { "Abbreviations of the derivations" }
            @for definition in definitions { (raw(definition)) }
        })
    }

    /// The files to which some page leads, as pages or as they are.
    fn sources(&mut self, contents: &Contents, files: &mut BookFiles) -> Result<()> {
        for path in &self.wanted {
            let bytes =
                std::fs::read(self.root.join(path)).map_err(|source| Error::Io { file: path.clone(), source })?;
            let page = format!("{}.html", published(path));
            match String::from_utf8(bytes) {
                Ok(text) if !is_picture(path) && text.len() < 250_000 => {
                    let sheet = plain(page.trim_end_matches(".html"), path, source_page(path, &text));
                    files.insert(page, contents.page(&sheet, [None, None]).into_bytes());
                }
                Ok(text) => drop(files.insert(published(path), text.into_bytes())),
                Err(error) => drop(files.insert(published(path), error.into_bytes())),
            }
        }
        Ok(())
    }
}

/// A file with the numbers of its lines, and a theorem of Coq by its name.
fn source_page(path: &str, text: &str) -> Markup {
    let theorem = |line: &str| {
        let rest = ["Theorem ", "Lemma ", "Corollary "].iter().find_map(|word| line.strip_prefix(word));
        rest.map(|rest| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_' || *c == '\'').collect::<String>())
    };
    html! { h1.path { (path) } div.table tabindex="0" role="group" aria-label="Source" { pre.source { @for (i, line) in text.lines().enumerate() {
        @match theorem(line) {
            Some(name) => { span.theorem id=(name) { span id={ "L" (i + 1) } { (line) } } }
            None => { span id={ "L" (i + 1) } { (line) } }
        }
        "\n"
    } } } }
}

/// A page that is made of records or of other markup.
fn plain(name: &str, title: &str, main: Markup) -> Sheet {
    Sheet {
        name: name.to_owned(),
        title: title.to_owned(),
        main: html! { @if !name.starts_with("source-") { h1 { (title) } } (main) },
        words: String::new(),
        entry: None,
    }
}

/// The line of a text of the spine at which its figure stands.
const FIGURE: &str = "<p>FIGURE</p>";

/// A document without what is for those who write it.
fn for_readers(name: &str, text: &str) -> String {
    let own = |line: &&str| !(name == "errata" && line.contains("This page is written by"));
    text.lines().filter(own).map(|line| format!("{line}\n")).collect()
}

/// Before its formulas, the limits of the theory by hand: Tabor's number, and what to check.
fn validity() -> Markup {
    let step = |x: f64| 10f64.powf(x);
    html! {
        figure.tabor data-low=(step(-2.0)) data-high=(step(2.0)) {
            svg viewBox="0 0 640 96" role="img" aria-label="Tabor's number on a logarithmic axis from 0.01 to 100: below 0.1 DMT, above 5 JKR, between them neither" {
                rect.dmt x="20" y="30" width="150" height="26" {}
                rect.between x="170" y="30" width="255" height="26" {}
                rect.jkr x="425" y="30" width="195" height="26" {}
                text x="95" y="48" text-anchor="middle" { "DMT" }
                text x="297" y="48" text-anchor="middle" { "transition" }
                text x="522" y="48" text-anchor="middle" { "JKR: this theory" }
                @for (x, label) in [(20, "0.01"), (170, "0.1"), (320, "1"), (425, "5"), (470, "10"), (620, "100")] {
                    text x=(x) y="76" text-anchor="middle" { (label) }
                }
                path.here d="M320 22l-7 -12h14z" {}
            }
            p.controls {
                label for="tabor" { "Tabor’s number μ" }
                input #tabor type="range" min="-2" max="2" step="0.01" value="0" hidden;
                output for="tabor" {}
            }
            figcaption { "μ compares how far the edge of the contact opens with the range of the adhesion. For a ball, μ = (" i { "Rw" } "²/(" i { "E" } "*²" i { "z" } "₀³))" sup { "1/3" } "." }
        }
        ul.checklist {
            li { "The adhesion is of short range against the opening of the edge: μ above 5." }
            li { "The contact is small against the bodies, and their slopes in it are small." }
            li { "The bodies are elastic: no creep, no yield, no layer that is thin against the contact." }
            li { "The contact is one disc: no roughness that keeps the surfaces apart." }
            li { "No friction, or a normal force alone on bodies that are alike." }
        }
    }
}

/// How to cite the errata.
fn citation() -> Markup {
    html! { p.cite { "To cite: the mdr developers, " i { "Errata of V. L. Popov, Surface profiles with zero and finite adhesion force and adhesion instabilities" }
    ", mdr " (env!("CARGO_PKG_VERSION")) ", errata.html." } }
}

/// The entries in a table.
fn table(judgements: &[Judgement]) -> Markup {
    html! {
        div.table tabindex="0" role="group" aria-label="Entries" { table {
            thead { tr { th { "entry" } th { "what" } th { "verdict" } th { "steps" } th { "mutants" } } }
            tbody { @for entry in order() { @if let Some(judgement) = judgements.iter().find(|judgement| judgement.entry.id == entry.id) { tr {
                td { a href={ (entry.id) ".html" } { (entry.id) } } td { (entry.title) } td { (badges(judgement)) } td { (judgement.steps.len()) } td { (judgement.mutants().len()) }
            } } } }
        } }
    }
}

/// The contents of the book, in numbers.
fn overview(judgements: &[Judgement]) -> Markup {
    let steps = || judgements.iter().flat_map(|judgement| &judgement.steps);
    let count = |verdict: Verdict| steps().filter(|step| step.step.verdict() == verdict).count();
    let theorems: usize = judgements.iter().map(|judgement| judgement.entry.theorems().count()).sum();
    html! {
        ul.facts {
            li { b { (judgements.iter().filter(|judgement| is_equation(judgement.entry)).count()) } " equations of the paper and "
                b { (judgements.iter().filter(|judgement| !is_equation(judgement.entry)).count()) } " results beyond it" }
            li { b { (steps().count()) } " steps: " (count(Verdict::Proved)) " by exact algebra, " (count(Verdict::Enclosed) + count(Verdict::Agrees)) " by enclosures of numbers" }
            li { b { (theorems) } " theorems that the kernel of Coq has checked" }
            li { b { (judgements.iter().filter(|judgement| judgement.entry.erratum.is_some()).count()) } " errata" }
            li { b { (mdr_reference::records().len()) } " certified values" }
        }
        h2 #chapters { "Chapters" }
        ol.toc { @for chapter in &CHAPTERS { li { a href={ (chapter.page) ".html" } { (chapter.title) }
            span { @for entry in chapter.entries() { @if is_equation(entry) { a.no href={ (entry.id) ".html" } { "(" (entry.id) ")" } " " } } } } } }
    }
}

fn contents(sheets: &[Sheet]) -> Contents {
    let find = |name: &str| {
        sheets.iter().find(|sheet| sheet.name == name).map(|sheet| (sheet.name.clone(), sheet.title.clone()))
    };
    let shelf =
        |shelf: Shelf| DOCUMENTS.iter().filter(move |(_, _, of)| *of == shelf).filter_map(|(_, name, _)| find(name));
    Contents {
        spine: ["index"].into_iter().chain(SPINE).filter_map(find).collect(),
        front: shelf(Shelf::Front).chain(["notation", "verdicts", "contents"].into_iter().filter_map(find)).collect(),
        numbers: find("values").into_iter().chain(shelf(Shelf::Numbers)).collect(),
        program: shelf(Shelf::Program).chain(["bibliography", "cite"].into_iter().filter_map(find)).collect(),
        version: env!("CARGO_PKG_VERSION"),
    }
}

/// The index of the search: a script, since a page that is opened as a file may not fetch.
fn index(sheets: &[Sheet]) -> String {
    let quoted = |text: &str| {
        let text: String = text.chars().filter(|c| !c.is_control() && !['\u{e000}', '\u{e001}'].contains(c)).collect();
        format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"").replace("</", "<\\/"))
    };
    let row = |sheet: &Sheet| {
        let words: String = sheet.words.chars().take(3000).collect();
        format!(
            "{{\"u\":{},\"t\":{},\"w\":{}}}",
            quoted(&format!("{}.html", sheet.name)),
            quoted(&sheet.title),
            quoted(&words)
        )
    };
    format!("window.BOOK=[{}];\n", sheets.iter().map(row).collect::<Vec<_>>().join(",\n"))
}

/// Style sheet, scripts and fonts.
fn assets(root: &Path) -> Result<BookFiles> {
    let mut files = BookFiles::new();
    for folder in ["", "fonts/", "live/"] {
        let directory = root.join("book/assets").join(folder);
        let io = |source| Error::Io { file: directory.display().to_string(), source };
        for file in std::fs::read_dir(&directory).map_err(io)? {
            let file = file.map_err(io)?.path();
            if let Some(name) = file.file_name().and_then(|name| name.to_str()).filter(|_| file.is_file()) {
                files.insert(format!("{folder}{name}"), std::fs::read(&file).map_err(io)?);
            }
        }
    }
    Ok(files)
}
