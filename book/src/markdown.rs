//! Markdown to HTML: formulas, headings that can be linked to, tables that scroll, links within the book.

use std::collections::HashMap;

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use crate::error::{Error, Result};
use crate::links::Links;
use crate::tex::Tex;

/// How formulas are marked in a text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Math {
    /// As GitHub does: `` $`…`$ `` in a line, a fence ```` ```math ```` alone. A dollar alone is a dollar.
    Fences,
    /// `$…$` in a line, `$$…$$` alone.
    Dollars,
}

/// A page made of Markdown.
pub(crate) struct Page {
    /// The text of its first heading.
    pub(crate) title: String,
    /// Everything after that heading.
    pub(crate) html: String,
    /// The words, for the search.
    pub(crate) words: String,
}

/// A place for a formula, which Markdown leaves alone: a private character, a number, a private character.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// Formulas that have been taken out of a text.
struct Formulas(Vec<String>);

impl Formulas {
    fn hold(&mut self, math: String) -> String {
        self.0.push(math);
        format!("{OPEN}{}{CLOSE}", self.0.len() - 1)
    }

    /// The page with each formula at its place; one that is alone needs no paragraph.
    fn put_back(self, page: &str) -> String {
        let mut out = page.to_owned();
        for (i, math) in self.0.iter().enumerate() {
            let token = format!("{OPEN}{i}{CLOSE}");
            out = out.replace(&format!("<p>{token}</p>"), math).replace(&token, math);
        }
        out
    }
}

/// Text with its formulas replaced by tokens.
fn take_out(text: &str, math: Math, tex: &Tex) -> Result<(String, Formulas)> {
    let mut found = Formulas(Vec::new());
    let text = match math {
        Math::Fences => between(text, "```math\n", "```", |source| Ok(found.hold(tex.display(source.trim())?)))?,
        Math::Dollars => between(text, "$$", "$$", |source| Ok(found.hold(tex.display(source.trim())?)))?,
    };
    let (open, close) = if math == Math::Fences { ("$`", "`$") } else { ("$", "$") };
    let text = between(&text, open, close, |source| Ok(found.hold(tex.inline(source)?)))?;
    Ok((text, found))
}

/// Text in which everything between two marks is replaced.
fn between(text: &str, open: &str, close: &str, mut with: impl FnMut(&str) -> Result<String>) -> Result<String> {
    let (mut out, mut rest) = (String::new(), text);
    while let Some((before, after)) = rest.split_once(open) {
        let (inside, after) = after
            .split_once(close)
            .ok_or_else(|| Error::page("a text", format!("{open} without {close}: {after:.60}")))?;
        out += before;
        out += &with(inside)?;
        rest = after;
    }
    Ok(out + rest)
}

/// A whole page.
pub(crate) fn page(text: &str, math: Math, tex: &Tex, links: &mut Links<'_>) -> Result<Page> {
    let (text, formulas) = take_out(text, math, tex)?;
    let mut reader = Reader { links, used: HashMap::new(), title: None, words: String::new() };
    let events = reader.events(&text)?;
    let mut body = String::new();
    html::push_html(&mut body, events.into_iter());
    let title = reader.title.take().unwrap_or_default();
    Ok(Page { title: plain(&title), html: formulas.put_back(&body), words: plain(&reader.words) })
}

/// A line of text, without a paragraph around it.
pub(crate) fn line(text: &str, math: Math, tex: &Tex, links: &mut Links<'_>) -> Result<String> {
    let html = page(text, math, tex, links)?.html;
    let html = html.trim();
    let inner = html.strip_prefix("<p>").and_then(|rest| rest.strip_suffix("</p>"));
    Ok(inner.filter(|inner| !inner.contains("<p>")).unwrap_or(html).to_owned())
}

/// Words without tokens.
fn plain(text: &str) -> String {
    let mut inside = false;
    text.chars()
        .filter(|c| {
            inside = (inside || *c == OPEN) && *c != CLOSE;
            !inside && *c != CLOSE
        })
        .collect()
}

/// The anchor that GitHub gives to a heading.
pub(crate) fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

struct Reader<'a, 'b> {
    links: &'a mut Links<'b>,
    used: HashMap<String, usize>,
    title: Option<String>,
    words: String,
}

impl Reader<'_, '_> {
    fn events<'t>(&mut self, text: &'t str) -> Result<Vec<Event<'t>>> {
        let parser = Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES);
        let mut out = Vec::new();
        let mut heading: Option<(HeadingLevel, Vec<Event<'t>>, String)> = None;
        let mut open = Vec::new();
        for event in parser {
            if let Event::Text(text) | Event::Code(text) = &event {
                self.words += text;
                self.words.push(' ');
                if let Some((_, _, words)) = &mut heading {
                    *words += text;
                }
            }
            match event {
                Event::Start(Tag::Heading { level, .. }) => heading = Some((level, Vec::new(), String::new())),
                Event::End(TagEnd::Heading(_)) => {
                    if let Some((level, inner, words)) = heading.take() {
                        out.extend(self.heading(level, inner, &words));
                    }
                }
                other => {
                    let events = self.element(other, &mut open)?;
                    match &mut heading {
                        Some((_, inner, _)) => inner.extend(events),
                        None => out.extend(events),
                    }
                }
            }
        }
        Ok(out)
    }

    /// The first heading is the title; the others can be linked to.
    fn heading<'t>(&mut self, level: HeadingLevel, inner: Vec<Event<'t>>, words: &str) -> Vec<Event<'t>> {
        if level == HeadingLevel::H1 && self.title.is_none() {
            self.title = Some(words.to_owned());
            return Vec::new();
        }
        let name = anchor(&plain(words));
        let count = self.used.entry(name.clone()).or_default();
        let id = if *count == 0 { name } else { format!("{name}-{count}") };
        *count += 1;
        let start = format!("<{level} id=\"{id}\">");
        let end = format!("<a class=\"perma\" href=\"#{id}\" aria-label=\"Link to this section\">¶</a></{level}>\n");
        let html = |text: String| Event::Html(CowStr::from(text));
        [html(start)].into_iter().chain(inner).chain([html(end)]).collect()
    }

    /// Converts an event that is no heading. `open` holds the links that are open, and whether they lead somewhere.
    fn element<'t>(&mut self, event: Event<'t>, open: &mut Vec<bool>) -> Result<Vec<Event<'t>>> {
        let html = |text: &'static str| Event::Html(CowStr::from(text));
        Ok(match event {
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                let target = self.links.resolve(&dest_url)?;
                open.push(target.is_some());
                let link = |url: String| Event::Start(Tag::Link { link_type, dest_url: url.into(), title, id });
                target.map(link).into_iter().collect()
            }
            Event::End(TagEnd::Link) if open.pop() == Some(false) => Vec::new(),
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => {
                let source = self.links.resolve(&dest_url)?;
                let source = source.ok_or_else(|| Error::page(self.links.name(), format!("no picture {dest_url}")))?;
                vec![Event::Start(Tag::Image { link_type, dest_url: source.into(), title, id })]
            }
            Event::Start(Tag::Table(alignment)) => vec![html(TABLE), Event::Start(Tag::Table(alignment))],
            Event::End(TagEnd::Table) => vec![Event::End(TagEnd::Table), html("</div>\n")],
            Event::Start(Tag::CodeBlock(_)) => vec![html("<pre tabindex=\"0\"><code>")],
            Event::End(TagEnd::CodeBlock) => vec![html("</code></pre>\n")],
            Event::Code(text) => match self.links.source(&text)? {
                Some(target) if open.is_empty() => {
                    let link = format!("<a href=\"{target}\"><code>{}</code></a>", escaped(&text));
                    vec![Event::InlineHtml(link.into())]
                }
                _ => vec![Event::Code(text)],
            },
            other => vec![other],
        })
    }
}

/// A table scrolls in a box of its own, by keys too, as a block of code does.
const TABLE: &str = "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"Table\">\n";

/// Text as HTML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
