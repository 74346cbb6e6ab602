//! The frame of every page: contents, search, theme, previous and next.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use mdr_symbolic::derivations::Entry;

use crate::chapters::{CHAPTERS, Chapter};
use crate::links::is_equation;
use crate::references::linked;

/// A page of the book before it has its surroundings.
pub(crate) struct Sheet {
    /// The name of its file, without `.html`.
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) main: Markup,
    /// Words for the search.
    pub(crate) words: String,
    /// The entry, for tests and scripts: its id and verdict.
    pub(crate) entry: Option<(String, String)>,
}

/// A link of the contents: the page and its title.
type Link = (String, String);

/// The contents, the same on every page.
pub(crate) struct Contents {
    pub(crate) spine: Vec<Link>,
    pub(crate) front: Vec<Link>,
    pub(crate) numbers: Vec<Link>,
    pub(crate) program: Vec<Link>,
    /// The version of the program.
    pub(crate) version: &'static str,
}

impl Contents {
    fn entry(&self, entry: &Entry, here: &str) -> Markup {
        html! { li { a href={ (entry.id) ".html" } aria-current=[(entry.id == here).then_some("page")] {
            span.no { @if is_equation(entry) { (entry.id) } } span { (entry.title) }
        } } }
    }

    fn chapter(&self, number: usize, chapter: &Chapter, here: &str) -> Markup {
        let entries = chapter.entries();
        let open = chapter.page == here || entries.iter().any(|entry| entry.id == here);
        html! { li.chapter {
            a href={ (chapter.page) ".html" } aria-current=[(chapter.page == here).then_some("page")] { span.no { (number) } span { (chapter.title) } }
            @if !entries.is_empty() && open { ol { @for entry in entries { (self.entry(entry, here)) } } }
        } }
    }

    fn list(&self, title: &str, links: &[Link], here: &str) -> Markup {
        html! { h2 { (title) } ol { @for (page, title) in links {
            li { a href={ (page) ".html" } aria-current=[(page == here).then_some("page")] { span.no {} span { (title) } } }
        } } }
    }

    fn nav(&self, here: &str) -> Markup {
        html! {
            details.nav open { summary { "Contents" }
                nav aria-label="Contents" {
                    a.brand href="index.html" { b { "Adhesion instabilities" } }
                    div.tools {
                        input #search type="search" placeholder="Search" aria-label="Search the book" autocomplete="off";
                        button #theme type="button" hidden aria-label="Light, dark or as the system" { "◐" }
                    }
                    ol #results hidden {}
                    (self.list("Start", &self.spine, here))
                    h2 { "The theory" } ol { @for (i, chapter) in CHAPTERS.iter().enumerate() { (self.chapter(i + 1, chapter, here)) } }
                    (self.list("Reference", &self.front, here))
                    (self.list("The numbers", &self.numbers, here))
                    (self.list("The program", &self.program, here))
                }
            }
        }
    }

    /// A whole page. `around` are the pages before and after it.
    pub(crate) fn page(&self, sheet: &Sheet, around: [Option<&Sheet>; 2]) -> String {
        let (entry, verdict) = sheet.entry.clone().unzip();
        let page = html! { (DOCTYPE) html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (sheet.title) " · Adhesion instabilities" }
                link rel="stylesheet" href="book.css";
                script src="theme.js" {}
            }
            body {
                a.skip href="#main" { "Skip to the text" }
                (self.nav(&sheet.name))
                main #main data-entry=[entry] data-verdict=[verdict] data-version=(self.version) {
                    (sheet.main)
                    footer.pager {
                        @if let Some(before) = around[0] { a rel="prev" href={ (before.name) ".html" } { "← " (before.title) } }
                        @if let Some(after) = around[1] { a rel="next" href={ (after.name) ".html" } { (after.title) " →" } }
                    }
                    p.colophon { "mdr " (self.version) ". " a href="cite.html" { "How to cite" } ", with the address of this page: " code { (sheet.name) ".html" } }
                }
                script src="explorer-here.js" {}
                script src="book.js" {}
            }
        } };
        linked(&page.into_string(), &sheet.name)
    }
}

/// Markup from a text that is HTML already.
pub(crate) fn raw(html: impl Into<String>) -> PreEscaped<String> {
    PreEscaped(html.into())
}
