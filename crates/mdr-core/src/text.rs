//! Text of others in messages: the text of a file or an argument is never printed unchanged.

use std::fmt::{self, Write};

/// The most characters with which a message repeats an input.
pub const QUOTED: usize = 200;

/// A text in a message: on one line, every character that is not printed escaped, and cut after at most [`QUOTED`] characters,
/// escapes included. A text that is cut ends in `… (N characters)`, with the number of its characters.
///
/// ```
/// use mdr_core::text::excerpt;
/// assert_eq!(excerpt("1e-9").to_string(), "1e-9");
/// assert_eq!(excerpt("\u{1b}[31m\n").to_string(), "\\u{1b}[31m\\n");
/// assert!(excerpt(&"7".repeat(1_000_000)).to_string().ends_with("7… (1000000 characters)"));
/// ```
pub fn excerpt(text: &str) -> Excerpt<'_> {
    Excerpt(text)
}

/// A text as [`excerpt`] shows it.
#[derive(Clone, Copy, Debug)]
pub struct Excerpt<'a>(&'a str);

impl fmt::Display for Excerpt<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut written = 0;
        for (start, letter) in self.0.char_indices() {
            written += escaped(letter).count();
            if written > QUOTED {
                let shown = &self.0[..start];
                return write!(f, "{}… ({} characters)", printable(shown), self.0.chars().count());
            }
        }
        printable(self.0).fmt(f)
    }
}

/// A whole message on one line: every character that is not printed is escaped, such as those that steer a terminal. Quotation
/// marks and backslashes stay, so that a message which has passed once stays what it is.
///
/// ```
/// use mdr_core::text::printable;
/// let once = printable("µ \"5\u{7}\"").to_string();
/// assert_eq!(once, "µ \"5\\u{7}\"");
/// assert_eq!(printable(&once).to_string(), once);
/// ```
pub fn printable(text: &str) -> Printable<'_> {
    Printable(text)
}

/// A text as [`printable`] shows it.
#[derive(Clone, Copy, Debug)]
pub struct Printable<'a>(&'a str);

impl fmt::Display for Printable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().flat_map(escaped).try_for_each(|letter| f.write_char(letter))
    }
}

/// A character as it is shown.
fn escaped(letter: char) -> impl Iterator<Item = char> {
    let plain = matches!(letter, '"' | '\'' | '\\').then_some(letter);
    plain.into_iter().chain(letter.escape_debug().filter(move |_| plain.is_none()))
}
