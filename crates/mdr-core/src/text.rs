//! Text of others in messages: what a file or an argument says is never printed as it is.

use std::fmt::{self, Write};

/// The most characters of an input that a message repeats.
pub const QUOTED: usize = 200;

/// A text in a message: at most [`QUOTED`] characters of it, on one line, and every character that is not printed escaped. A
/// longer text ends in `… (N characters)`.
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
        match self.0.char_indices().nth(QUOTED) {
            None => printable(self.0).fmt(f),
            Some((end, _)) => write!(f, "{}… ({} characters)", printable(&self.0[..end]), self.0.chars().count()),
        }
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
        self.0.chars().try_for_each(|letter| match letter {
            '"' | '\'' | '\\' => f.write_char(letter),
            letter => write!(f, "{}", letter.escape_debug()),
        })
    }
}
