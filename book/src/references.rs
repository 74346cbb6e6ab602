//! Equation numbers in prose, such as (1.7), as links to their pages, with what a card says of them.

use mdr_symbolic::derivations::{Entry, entries};

use crate::error::Result;
use crate::links::is_equation;
use crate::tex::Tex;
use crate::text::Text;

/// Elements whose text is left alone: links, headings, formulas, code, pictures.
const CLOSED: [&str; 13] =
    ["a", "math", "code", "pre", "svg", "script", "style", "h1", "h2", "h3", "option", "button", "title"];

/// The equation whose number begins a text, "1.7)…", and the length of the number.
fn equation(text: &str) -> Option<(&'static Entry, usize)> {
    let (number, _) = text.split_once(')')?;
    let found = entries().iter().find(|entry| is_equation(entry) && entry.id == number)?;
    Some((found, number.len()))
}

/// A page in which each number of an equation leads to it, but for those of the page itself.
pub(crate) fn linked(html: &str, here: &str) -> String {
    let mut out = String::with_capacity(html.len() + html.len() / 8);
    let mut closed: Vec<&str> = Vec::new();
    for (i, part) in html.split('<').enumerate() {
        let (tag, text) = match part.split_once('>') {
            Some((tag, text)) if i > 0 => (Some(tag), text),
            _ => (None, part),
        };
        if let Some(tag) = tag {
            out.push('<');
            out.push_str(tag);
            out.push('>');
            let name = tag.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap_or_default();
            match CLOSED.iter().find(|closed| **closed == name) {
                Some(_) if tag.starts_with('/') => drop(closed.pop()),
                Some(name) if !tag.ends_with('/') => closed.push(name),
                _ => {}
            }
        }
        if closed.is_empty() {
            with_links(text, here, &mut out);
        } else {
            out.push_str(text);
        }
    }
    out
}

/// Text with its links.
fn with_links(text: &str, here: &str, out: &mut String) {
    let mut parts = text.split('(');
    out.push_str(parts.next().unwrap_or_default());
    for part in parts {
        match equation(part).filter(|(entry, _)| entry.id != here) {
            Some((entry, length)) => {
                let (number, rest) = part.split_at(length);
                out.push_str(&format!("<a class=\"ref\" href=\"{}.html\">({number})</a>", entry.id));
                out.push_str(rest.trim_start_matches(')'));
            }
            None => {
                out.push('(');
                out.push_str(part);
            }
        }
    }
}

/// What the card of each equation says: a script, since a page that is opened as a file may not fetch.
///
/// # Errors
/// A text that cannot be read or set.
pub(crate) fn cards(root: &std::path::Path, tex: &Tex) -> Result<String> {
    let mut rows = Vec::new();
    for entry in entries().iter().filter(|entry| is_equation(entry)) {
        let text = Text::read(root, entry.id)?;
        let formula = tex.display(&text.corrected.or(text.printed).or(text.result).unwrap_or_default())?;
        let quoted =
            |text: &str| text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', " ").replace("</", "<\\/");
        rows.push(format!("\"{}\":[\"{}\",\"{}\"]", entry.id, quoted(entry.title), quoted(&formula)));
    }
    Ok(format!("window.CARDS={{{}}};\n", rows.join(",\n")))
}

#[cfg(test)]
mod tests {
    use super::linked;

    #[test]
    fn numbers_of_equations_become_links_in_prose_alone() {
        let page = "<h2>As (1.7)</h2><p>By (1.7), (1.99) and (n), not <a href=\"x\">(1.8)</a> or <code>(1.9)</code>; (1.1).</p>";
        let found = linked(page, "1.1");
        let link = "<a class=\"ref\" href=\"1.7.html\">(1.7)</a>";
        assert_eq!(found, page.replace("By (1.7)", &format!("By {link}")));
    }
}
