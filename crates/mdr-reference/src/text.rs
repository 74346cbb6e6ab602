//! Quotation of external text in messages.

/// The most characters of a quoted text.
const QUOTED: usize = 80;

/// At most 80 characters, on one line, without control characters, in quotation marks.
pub(crate) fn excerpt(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{:?}… ({} characters)", &text[..end], text.chars().count()),
        None => format!("{text:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_strange_texts_are_cut_and_escaped() {
        assert_eq!(excerpt("no/such"), "\"no/such\"");
        assert_eq!(excerpt("\u{1b}[31m\n"), "\"\\u{1b}[31m\\n\"");
        let long = excerpt(&"ö".repeat(900_000));
        assert!(long.chars().count() < 110 && long.ends_with("… (900000 characters)"), "{long}");
    }
}
