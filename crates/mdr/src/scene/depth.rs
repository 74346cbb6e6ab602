//! How deep a text in TOML is nested, before its reader builds a tree: readers of trees and their destructors recurse.

use super::tree::DEEPEST;

/// The first byte of a text in TOML that is nested deeper than [`DEEPEST`] levels, by its brackets and the dots of its keys outside
/// of strings and comments. A text that is no TOML may have any answer: its reader refuses it.
pub(super) fn too_deep(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    // Levels of the header of the table, of each open bracket, and of the key that is being read or has been read last.
    let (mut header, mut open, mut key) = (0, Vec::new(), 1);
    let (mut depth, mut begins_line, mut at) = (0, true, 0);
    while at < bytes.len() {
        let byte = bytes[at];
        match byte {
            b'"' | b'\'' => at = end_of_string(bytes, at),
            b'#' => {
                at = bytes[at..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |length| at + length - 1)
            }
            b'[' if begins_line && open.is_empty() => {
                let line = bytes[at..].split(|byte| *byte == b'\n').next().unwrap_or_default();
                header = line.iter().filter(|byte| matches!(byte, b'.' | b'[')).count();
                at += line.len().saturating_sub(1);
                key = 0;
            }
            b'[' | b'{' => {
                open.push(key);
                depth += key;
                key = 1;
            }
            b']' | b'}' => {
                depth -= open.pop().unwrap_or(0);
                key = 1;
            }
            b'.' => key += 1,
            b',' => key = 1,
            b'\n' if open.is_empty() => key = 1,
            _ => {}
        }
        if header + depth + key > DEEPEST {
            return Some(text.floor_char_boundary(at.min(bytes.len() - 1)));
        }
        begins_line = byte == b'\n' || begins_line && byte.is_ascii_whitespace();
        // The dots of a number are none of a key.
        if byte == b'=' {
            let value = bytes[at + 1..]
                .iter()
                .position(|byte| !matches!(byte, b' ' | b'\t'))
                .map_or(bytes.len(), |gap| at + 1 + gap);
            if bytes.get(value).is_some_and(|byte| !matches!(byte, b'[' | b'{')) {
                key = 1;
            }
        }
        at += 1;
    }
    None
}

/// The last byte of the string that begins at a quotation mark.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let quote = bytes[start];
    let long = bytes[start..].starts_with(&[quote; 3]);
    let mut at = start + if long { 3 } else { 1 };
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if quote == b'"' => at += 1,
            b'\n' if !long => return at,
            byte if byte == quote && !long => return at,
            byte if byte == quote && bytes[at..].starts_with(&[quote; 3]) => return at + 2,
            _ => {}
        }
        at += 1;
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_those_of_keys_and_brackets() {
        let dots = |count: usize| vec!["a"; count].join(".");
        for (text, refused) in [
            (format!("{} = 1", dots(64)), false),
            (format!("{} = 1", dots(65)), true),
            (format!("[{}]\nb = 1", dots(63)), false),
            (format!("[{}]\nb.c = 1", dots(63)), true),
            (format!("x = {}1{}", "[".repeat(63), "]".repeat(63)), false),
            (format!("x = {}1{}", "[".repeat(64), "]".repeat(64)), true),
            (format!("x = {}1{}", "{a.a.a.a = ".repeat(17), "}".repeat(17)), true),
            (format!("x = \"{}\" # {}", "[".repeat(99), "[".repeat(99)), false),
            (format!("x = '''\n{}'''", "[".repeat(99)), false),
            (format!("x = [{}]", vec!["1.5"; 999].join(", ")), false),
            (vec!["x.y = 1.5"; 999].join("\n"), false),
            (vec!["[a.b]"; 999].join("\n"), false),
            (format!("formula = \"{}\"", "a.b\\\"[".repeat(99)), false),
        ] {
            assert_eq!(too_deep(&text).is_some(), refused, "{text}");
        }
    }

    /// No text makes it panic, and it ends.
    #[test]
    fn any_text_has_an_answer() {
        let marks = ["[", "]", "{", "}", "\"", "'", "\\", "#", "\n", ".", "=", ",", "a", "\u{e9}"];
        let mut state = 1_u64;
        for _ in 0..20_000 {
            let text: String = (0..12)
                .map(|_| {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    marks[(state >> 40) as usize % marks.len()]
                })
                .collect();
            let _ = too_deep(&text);
        }
    }
}
