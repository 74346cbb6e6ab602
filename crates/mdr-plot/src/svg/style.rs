//! The colours of pictures, and their style sheet.

use crate::chart::{Colour, Theme};

/// Class, colour of lines and marks on white, of words on white, of both in the dark. Words need more contrast than lines.
const PALETTE: [(Colour, &str, &str, &str, &str); 8] = [
    (Colour::Ink, "ink", "#1c2127", "#1c2127", "#e9ecef"),
    (Colour::Blue, "blue", "#0b62a8", "#0b62a8", "#62b5f5"),
    (Colour::Orange, "orange", "#b8480b", "#b8480b", "#ff9d57"),
    (Colour::Purple, "purple", "#ca75ba", "#96418a", "#d292cb"),
    (Colour::Green, "green", "#1f6b4a", "#1f6b4a", "#6fd0a3"),
    (Colour::Grey, "grey", "#7f8a93", "#59636e", "#a0aab4"),
    (Colour::Sky, "sky", "#56b4e9", "#1b6d99", "#8fd0f5"),
    (Colour::Amber, "amber", "#c98b00", "#835a00", "#e6b84a"),
];

/// All that does not depend on light and dark, a rule a line. Halos keep words legible on lines.
const STYLE: &str = include_str!("style.css");

/// The colours that depend on light and dark: name, light, dark.
const SHADES: [(&str, &str, &str); 5] = [
    ("var-page", "#ffffff", "#1a1e23"),
    ("var-text", "#1c2127", "#e9ecef"),
    ("var-muted", "#59636e", "#a0aab4"),
    ("var-grid", "#e8e6e0", "#2c343c"),
    ("var-zero", "#a8a69f", "#59636e"),
];

/// The style sheet. Colours are written out, since some programs that print SVG do not support variables; every rule holds
/// within a picture alone, since pictures stand in pages.
pub(super) fn sheet(theme: Theme) -> String {
    match theme {
        Theme::Auto => format!("{}@media screen and (prefers-color-scheme:dark){{{}}}", shaded(false), shaded(true)),
        Theme::Light => shaded(false),
        Theme::Dark => shaded(true),
        Theme::Paper => PALETTE.iter().fold(shaded(false), |style, (_, class, line, word, _)| {
            // Lines of a black and white print differ by their strokes.
            let black = if matches!(*class, "purple" | "grey" | "sky" | "amber") { "#6a6a6a" } else { "#000000" };
            let style = style.replace(&format!(".{class}{{color:{line}}}"), &format!(".{class}{{color:{black}}}"));
            style.replace(&format!(".{class}{{color:{word}}}"), &format!(".{class}{{color:#000000}}"))
        }),
    }
}

fn shaded(dark: bool) -> String {
    let mut rules = String::new();
    for (_, class, line, word, night) in PALETTE {
        let [line, word] = if dark { [night; 2] } else { [line, word] };
        rules.push_str(&format!(".mdr .{class}{{color:{line}}}"));
        if word != line {
            rules.push_str(&format!(".mdr .label.{class}{{color:{word}}}"));
        }
    }
    rules
        + &SHADES.iter().fold(STYLE.replace('\n', ""), |rules, (name, light, night)| {
            rules.replace(name, if dark { night } else { light })
        })
}

/// The class of a colour.
pub(super) fn class(colour: Colour) -> &'static str {
    PALETTE.iter().find(|(other, ..)| *other == colour).map_or("ink", |(_, class, ..)| class)
}
