//! The encoding of a text file: UTF-8, UTF-16 with its byte order mark, or Latin-1.

use std::borrow::Cow;

/// The text of a file without its byte order mark, and the name of its encoding. Bytes that are not UTF-8 are Latin-1.
///
/// # Errors
/// The line with a character that no text has, as in binary files of instruments, or with half a character of UTF-16.
pub(super) fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, &'static str), String> {
    let (text, encoding) = match bytes {
        [0xff, 0xfe, rest @ ..] => (Cow::Owned(utf_16(rest, u16::from_le_bytes)?), "utf-16le"),
        [0xfe, 0xff, rest @ ..] => (Cow::Owned(utf_16(rest, u16::from_be_bytes)?), "utf-16be"),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            match std::str::from_utf8(bytes) {
                Ok(text) => (Cow::Borrowed(text), "utf-8"),
                Err(_) => (Cow::Owned(bytes.iter().copied().map(char::from).collect()), "latin-1"),
            }
        }
    };
    match text.find(|letter: char| matches!(letter, '\0'..='\u{8}' | '\u{e}'..='\u{1f}')) {
        None => Ok((text, encoding)),
        Some(place) => Err(format!(
            "line {} has the character {:#04x}, which no text has: text is UTF-8, Latin-1, or UTF-16 with a byte order mark; for files of \
             instruments there is from_afmformats in Python",
            line_of(&text[..place]),
            u32::from(text[place..].chars().next().unwrap_or_default())
        )),
    }
}

/// The number of the line that begins or goes on after a text.
fn line_of(before: &str) -> usize {
    1 + super::layout::breaks(before)
}

fn utf_16(bytes: &[u8], order: fn([u8; 2]) -> u16) -> Result<String, String> {
    let (pairs, odd) = bytes.as_chunks::<2>();
    let mut text = String::with_capacity(pairs.len());
    for letter in char::decode_utf16(pairs.iter().map(|pair| order(*pair))) {
        match letter {
            Ok(letter) => text.push(letter),
            Err(half) => {
                let unit = half.unpaired_surrogate();
                return Err(format!("line {} has half a character of UTF-16, {unit:#06x}", line_of(&text)));
            }
        }
    }
    if odd.is_empty() {
        Ok(text)
    } else {
        Err(format!("line {} ends in half of the two bytes of UTF-16", line_of(&text)))
    }
}
