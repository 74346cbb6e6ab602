//! Formulas in texts: `*a*` is slanted, `_{c}` below and `^{1/4}` above the line.

/// The size of all text in points, and of an index relative to that of its line.
pub(crate) const SIZE: f64 = 11.0;
const INDEX: f64 = 0.72;

/// How far below the line an index stands, in sizes of the text.
const BELOW: f64 = 0.22;
const ABOVE: f64 = -0.36;

/// A run of characters of one kind.
struct Run {
    slanted: bool,
    /// How far below the line; 0 is on it.
    shift: f64,
    text: String,
}

/// Cuts a text into runs.
fn runs(text: &str) -> Vec<Run> {
    let (mut slanted, mut shift) = (false, 0.0);
    let mut runs: Vec<Run> = Vec::new();
    let mut rest = text.chars().peekable();
    while let Some(letter) = rest.next() {
        match letter {
            '*' => slanted = !slanted,
            '_' | '^' if rest.next_if_eq(&'{').is_some() => shift = if letter == '_' { BELOW } else { ABOVE },
            '}' if shift != 0.0 => shift = 0.0,
            _ => match runs.last_mut() {
                Some(run) if run.slanted == slanted && run.shift == shift => run.text.push(letter),
                _ => runs.push(Run { slanted, shift, text: letter.to_string() }),
            },
        }
    }
    runs
}

/// The text without its markup.
pub(crate) fn plain(text: &str) -> String {
    let plain = |run: Run| match run.shift {
        BELOW => format!("_{}", run.text),
        ABOVE => format!("^{}", run.text),
        _ => run.text,
    };
    runs(text).into_iter().map(plain).collect()
}

/// About the width of a text in points. No font is at hand: this is the width in a wide one.
pub(crate) fn width(text: &str) -> f64 {
    let em = |run: &Run| 0.6 * run.text.chars().count() as f64 * if run.shift == 0.0 { 1.0 } else { INDEX };
    SIZE * runs(text).iter().map(em).sum::<f64>()
}

/// A text in lines no wider than `room`, broken between words, but not after a number; one line where it is empty.
pub(crate) fn lines(text: &str, room: f64) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match words.last_mut() {
            Some(number) if number.ends_with(|letter: char| letter.is_ascii_digit()) => {
                number.push(' ');
                number.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    let mut lines = vec![String::new()];
    for word in words {
        let last = lines.last_mut().expect("never empty");
        let longer = if last.is_empty() { word.clone() } else { format!("{last} {word}") };
        if last.is_empty() || width(&longer) <= room {
            *last = longer;
        } else {
            lines.push(word);
        }
    }
    lines
}

/// The text as content of an SVG element `text`.
pub(crate) fn tspans(text: &str) -> String {
    let (mut svg, mut last) = (String::new(), 0.0);
    for Run { slanted, shift, text } in runs(text) {
        let (down, text) = ((shift - last) * SIZE, escaped(&text));
        last = shift;
        let mut attributes = String::new();
        if down != 0.0 {
            attributes.push_str(&format!(" dy=\"{down:.1}\""));
        }
        if slanted {
            attributes.push_str(" font-style=\"italic\"");
        }
        if shift != 0.0 {
            attributes.push_str(&format!(" font-size=\"{:.1}\"", INDEX * SIZE));
        }
        match attributes.is_empty() {
            true => svg.push_str(&text),
            false => svg.push_str(&format!("<tspan{attributes}>{text}</tspan>")),
        }
    }
    svg
}

/// The text with the special characters of XML escaped.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_becomes_tspans_and_plain_letters() {
        assert_eq!(plain("*a*_{c} ∝ *r*^{1/4}"), "a_c ∝ r^1/4");
        assert_eq!(
            tspans("*a*_{c} < 1"),
            "<tspan font-style=\"italic\">a</tspan><tspan dy=\"2.4\" font-size=\"7.9\">c</tspan><tspan dy=\"-2.4\"> &lt; 1</tspan>"
        );
        assert_eq!(plain("a_b ^2 }"), "a_b ^2 }", "what is no markup stays");
        assert_eq!(lines("the first on pulling", 80.0), ["the first on", "pulling"]);
        assert_eq!(lines("", 80.0), [""]);
        assert_eq!(lines("at *d* = −9.725 nm", 90.0), ["at *d* =", "−9.725 nm"], "a unit stays with its number");
    }
}
