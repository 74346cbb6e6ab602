//! Prose with formulas: between backquotes in the grammar of the algebra, between dollars in TeX.

use mdr_symbolic::{Formula, Statement};

/// The text with words and formulas rendered; `math` gets a formula as a line of text and in TeX.
pub(super) fn render(text: &str, words: impl Fn(&str) -> String, math: impl Fn(&str, &str) -> String) -> String {
    // What the grammar does not have is typed in TeX.
    let typed = |part: &str| {
        let pieces = part.split('$').enumerate();
        pieces.map(|(i, piece)| if i % 2 == 1 { math(&plain(piece), piece) } else { words(piece) }).collect::<String>()
    };
    let parts = text.split('`').enumerate();
    parts
        .map(|(i, part)| match (i % 2, part.parse::<Statement>(), part.parse::<Formula>()) {
            (1, Ok(statement), _) => math(&statement.text(), &statement.tex()),
            (1, _, Ok(formula)) => math(&formula.text(), &formula.tex()),
            _ => typed(part),
        })
        .collect()
}

/// A row of `data/signs.tsv`; missing parts are empty.
pub(super) struct Sign {
    /// In prose.
    pub(super) character: &'static str,
    /// The character in a document of TeX.
    pub(super) tex: &'static str,
    /// The command of TeX in a formula.
    command: &'static str,
    /// The replacement of the command in a line of text.
    text: &'static str,
}

/// The signs that TeX and a line of text write in different ways.
pub(super) fn signs() -> impl Iterator<Item = Sign> {
    include_str!("../../../data/signs.tsv").lines().filter(|line| !line.starts_with("# ")).filter_map(|line| {
        let [character, tex, command, text]: [&str; 4] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        Some(Sign { character, tex, command, text })
    })
}

/// TeX as a line of text: fractions on a line, commands as signs, without braces.
fn plain(tex: &str) -> String {
    let mut text = tex.replace(r"\,", "").replace(r"\text", "").replace(r"\mathbf", "").replace("{}_2", "₂");
    for digits in ["12", "13", "14", "32", "34", "38", "52"] {
        let (above, below) = digits.split_at(1);
        for command in [r"\tfrac", r"\frac"] {
            text = text.replace(&format!("{command}{digits}"), &format!("{above}/{below}"));
        }
    }
    let text_of = |part: &str| if part.chars().count() == 1 { part.to_owned() } else { format!("({part})") };
    while let Some((before, rest)) = text.split_once(r"\frac{")
        && let Some((above, rest)) = rest.split_once("}{")
        && let Some((below, after)) = rest.split_once('}')
    {
        text = format!("{before}{}/{}{after}", text_of(above), text_of(below));
    }
    for Sign { command, text: sign, .. } in signs().filter(|sign| !sign.command.is_empty()) {
        let before_equals = (format!("{command} ="), format!("{sign} ="));
        text = text
            .replace(&before_equals.0, &before_equals.1)
            .replace(&format!("{command} "), sign)
            .replace(command, sign);
    }
    let text = text.replace("^{", "^(").replace("_{", "_(").replace("√{", "√(");
    // Braces of an exponent or index become brackets if they hold more than a sign.
    let mut out = String::new();
    let mut open = Vec::new();
    for c in text.chars() {
        match c {
            '{' => open.push('{'),
            '(' => {
                open.push('(');
                out.push('(');
            }
            '}' => {
                if open.pop() == Some('(') {
                    out.push(')');
                }
            }
            ')' => {
                open.pop();
                out.push(')');
            }
            c => out.push(if c == '-' { '−' } else { c }),
        }
    }
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No command of TeX is left in the text for a terminal.
    #[test]
    fn every_text_is_plain_on_a_terminal() {
        for entry in mdr_symbolic::derivations::entries() {
            let texts = entry.steps.iter().map(|step| step.why).chain(entry.assumptions.iter().copied());
            for text in texts.chain(entry.erratum.map(|erratum| erratum.text)) {
                let shown = render(text, str::to_owned, |text, _| text.to_owned());
                assert!(!shown.contains(['\\', '{', '}', '$', '`']), "{}: {shown}", entry.id);
            }
        }
    }

    #[test]
    fn tex_becomes_a_line_of_text() {
        for (tex, text) in [
            (r"\kappa_n = \int_0^1 dx/\sqrt{1 - x^{2/n}}", "κ_n = ∫_0^1 dx/√(1 − x^(2/n))"),
            (r"f(b,c) = 1 + \frac{b}{2c} f(b+1,c+1)", "f(b,c) = 1 + b/(2c) f(b+1,c+1)"),
            (r"\tfrac12 \lt n \ne \tfrac34", "1/2 < n ≠ 3/4"),
        ] {
            assert_eq!(plain(tex), text);
        }
    }
}
