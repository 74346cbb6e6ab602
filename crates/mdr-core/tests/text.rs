use mdr_core::text::{QUOTED, excerpt, printable};
use proptest::prelude::*;

proptest! {
    /// Whatever the text: nothing that steers a terminal, no line break, no more than is stated, and the beginning as it is.
    #[test]
    fn excerpts_are_short_and_printable(text in "(?s).{0,600}") {
        let shown = excerpt(&text).to_string();
        let whole = printable(&text).to_string();
        prop_assert!(!shown.contains(char::is_control) && !whole.contains(char::is_control));
        prop_assert!(shown.chars().count() <= QUOTED + "… (600 characters)".chars().count());
        prop_assert!(shown == whole || whole.starts_with(shown.split_once('…').map_or("", |(start, _)| start)));
        prop_assert_eq!(printable(&whole).to_string(), whole);
    }

    #[test]
    fn plain_text_stays(text in "[ -~µ°ξ²–]{0,200}") {
        prop_assert_eq!(excerpt(&text).to_string(), text);
    }
}

#[test]
fn one_character_too_many_is_cut() {
    let [exact, longer] = [QUOTED, QUOTED + 1].map(|count| "é".repeat(count));
    assert_eq!(excerpt(&exact).to_string(), exact);
    assert_eq!(excerpt(&longer).to_string(), format!("{exact}… (201 characters)"));
    assert_eq!(excerpt(&"\u{202e}".repeat(300)).to_string(), format!("{}… (300 characters)", "\\u{202e}".repeat(25)));
}
