//! Text: a small markup for formulas, its width, and its translation to SVG.
//!
//! `*a*` is slanted, `_{c}` below and `^{1/4}` above the line.

/// The size of all text, in points.
pub(crate) const POINTS: f64 = 11.0;

/// The size of an index relative to that of its line.
const INDEX: f64 = 0.72;

/// Families to look for; all have Greek letters and the minus sign.
pub(crate) const FAMILY: &str = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// A run of characters of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Style {
    slanted: bool,
    level: Level,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Level {
    Line,
    Below,
    Above,
}

/// Cuts a text into runs.
fn runs(text: &str) -> Vec<(Style, String)> {
    let mut style = Style { slanted: false, level: Level::Line };
    let mut runs: Vec<(Style, String)> = Vec::new();
    let mut rest = text.chars().peekable();
    while let Some(letter) = rest.next() {
        match letter {
            '*' => style.slanted = !style.slanted,
            '_' | '^' if rest.peek() == Some(&'{') => {
                rest.next();
                style.level = if letter == '_' { Level::Below } else { Level::Above };
            }
            '}' if style.level != Level::Line => style.level = Level::Line,
            _ => match runs.last_mut() {
                Some((last, run)) if *last == style => run.push(letter),
                _ => runs.push((style, letter.to_string())),
            },
        }
    }
    runs
}

/// The text without its markup.
pub(crate) fn plain(text: &str) -> String {
    runs(text)
        .into_iter()
        .map(|(style, run)| match style.level {
            Level::Line => run,
            Level::Below => format!("_{run}"),
            Level::Above => format!("^{run}"),
        })
        .collect()
}

/// The width of a text in points. No font is at hand: these are the widths of a wide one, so that there is room for all.
pub(crate) fn width(text: &str) -> f64 {
    let em = |letter: char| match letter {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | 'I' => 0.33,
        ' ' | '(' | ')' | '/' | 'f' | 't' | 'r' => 0.40,
        'm' | 'w' | 'M' | 'W' | '→' => 0.95,
        '−' | '=' | '<' | '>' | '+' | '×' | '≈' => 0.80,
        'A'..='Z' | 'Δ' | 'Π' => 0.70,
        _ => 0.62,
    };
    let size = |style: Style| if style.level == Level::Line { 1.0 } else { INDEX };
    POINTS * runs(text).iter().map(|(style, run)| size(*style) * run.chars().map(em).sum::<f64>()).sum::<f64>()
}

/// The height of a line of text in points, with room for indices.
pub(crate) fn height() -> f64 {
    1.25 * POINTS
}

/// The text as content of an SVG element `text`. Characters that mean something to XML must have been escaped.
pub(crate) fn tspans(escaped: &str) -> String {
    let mut svg = String::new();
    let mut level = Level::Line;
    for (style, run) in runs(escaped) {
        let shift = offset(style.level) - offset(level);
        level = style.level;
        if style == (Style { slanted: false, level: Level::Line }) && shift == 0.0 {
            svg.push_str(&run);
            continue;
        }
        svg.push_str("<tspan");
        if shift != 0.0 {
            // Points are tens of the units of the canvas.
            svg.push_str(&format!(" dy=\"{:.0}\"", shift * POINTS * super::canvas::PER_POINT));
        }
        if style.slanted {
            svg.push_str(" font-style=\"italic\"");
        }
        if style.level != Level::Line {
            svg.push_str(&format!(" font-size=\"{:.0}\"", INDEX * POINTS * super::canvas::PER_POINT));
        }
        svg.push_str(&format!(">{run}</tspan>"));
    }
    svg
}

/// How far below the line, in sizes of the text.
fn offset(level: Level) -> f64 {
    match level {
        Level::Line => 0.0,
        Level::Below => 0.22,
        Level::Above => -0.36,
    }
}

/// Characters that mean something to XML, escaped.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup() {
        assert_eq!(plain("*a*_{c} ∝ *r*^{1/4}"), "a_c ∝ r^1/4");
        assert_eq!(tspans("x"), "x");
        let text = tspans("*a*_{c} = 1");
        assert_eq!(
            text,
            "<tspan font-style=\"italic\">a</tspan><tspan dy=\"24\" font-size=\"79\">c</tspan><tspan dy=\"-24\"> = 1</tspan>"
        );
    }

    #[test]
    fn an_index_is_narrower_than_its_line() {
        assert!(width("a_{c}") < width("ac"));
        assert_eq!(width("*a*"), width("a"));
    }

    #[test]
    fn what_is_no_markup_stays() {
        assert_eq!(plain("a_b ^2 }"), "a_b ^2 }");
        assert_eq!(escaped("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
    }
}
