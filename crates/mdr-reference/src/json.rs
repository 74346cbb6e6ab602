//! JSON in which numbers keep their text. Answers of other programs may contain values that are not JSON, such as what
//! C prints for a number: `-nan`, `inf`, `0x1.8p-3`, `5.`.
//!
//! A number is never converted to `f64` before it is judged: the digits beyond the seventeenth matter.

use std::borrow::Cow;
use std::fmt;

/// A value; texts without escapes are borrowed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Json<'a> {
    Null,
    Bool(bool),
    /// The text of the number.
    Number(Cow<'a, str>),
    Text(Cow<'a, str>),
    List(Vec<Json<'a>>),
    Object(Vec<(Cow<'a, str>, Json<'a>)>),
}

impl<'a> Json<'a> {
    /// The value under a key; the last one if there are several, as in most readers.
    pub(crate) fn get(&self, key: &str) -> Option<&Json<'a>> {
        let Json::Object(entries) = self else { return None };
        entries.iter().rev().find(|(name, _)| name == key).map(|(_, value)| value)
    }

    /// A text, or the text of a number.
    pub(crate) fn as_text(&self) -> Option<&str> {
        match self {
            Json::Text(text) | Json::Number(text) => Some(text),
            _ => None,
        }
    }
}

/// Without blanks.
impl fmt::Display for Json<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Json::Null => f.write_str("null"),
            Json::Bool(truth) => truth.fmt(f),
            Json::Number(text) => f.write_str(text),
            Json::Text(text) => f.write_str(&quoted(text)),
            Json::List(values) => {
                write!(f, "[{}]", values.iter().map(Json::to_string).collect::<Vec<_>>().join(","))
            }
            Json::Object(entries) => {
                let entries = entries.iter().map(|(key, value)| format!("{}:{value}", quoted(key)));
                write!(f, "{{{}}}", entries.collect::<Vec<_>>().join(","))
            }
        }
    }
}

/// A text.
pub(crate) fn text(text: &str) -> Json<'_> {
    Json::Text(text.into())
}

/// A list of texts.
pub(crate) fn texts(texts: &[String]) -> Json<'_> {
    Json::List(texts.iter().map(|item| text(item)).collect())
}

/// A number or a truth value in its notation.
pub(crate) fn notation(value: impl ToString) -> Json<'static> {
    Json::Number(value.to_string().into())
}

/// An object with these entries.
pub(crate) fn object<'a>(entries: impl IntoIterator<Item = (&'a str, Json<'a>)>) -> Json<'a> {
    Json::Object(entries.into_iter().map(|(name, value)| (name.into(), value)).collect())
}

/// The deepest nesting that is accepted.
const DEPTH: usize = 32;

/// Reads one value.
///
/// # Errors
/// A message with the expected text and the byte, counted from 1.
pub(crate) fn read(text: &str) -> Result<Json<'_>, String> {
    Reader { text, at: 0, strict: true }.whole()
}

/// Reads one value, where any word without quotation marks is read as a number of that text.
///
/// # Errors
/// A message with the expected text and the byte, counted from 1.
pub(crate) fn read_tolerant(text: &str) -> Result<Json<'_>, String> {
    Reader { text, at: 0, strict: false }.whole()
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    strict: bool,
}

impl<'a> Reader<'a> {
    fn whole(mut self) -> Result<Json<'a>, String> {
        let value = self.value(0)?;
        self.blanks();
        if self.at == self.text.len() { Ok(value) } else { Err(self.expected("the end of the line")) }
    }

    fn expected(&self, what: &str) -> String {
        format!("byte {}: expected {what}", self.at + 1)
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn next(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\n']).len();
    }

    /// Consumes `word` if the text continues with it; returns whether it does.
    fn takes(&mut self, word: &str) -> bool {
        let found = self.rest().starts_with(word);
        self.at += if found { word.len() } else { 0 };
        found
    }

    fn value(&mut self, depth: usize) -> Result<Json<'a>, String> {
        self.blanks();
        match self.next() {
            Some(b'"') => self.text().map(Json::Text),
            Some(b'[' | b'{') if depth == DEPTH => Err(self.expected("less nesting")),
            Some(b'[') => self.list(depth),
            Some(b'{') => self.object(depth),
            Some(b'-' | b'0'..=b'9') if self.strict => self.number(),
            _ => self.word(),
        }
    }

    /// `null`, `true`, `false`; or, unless strict, a number in a non-JSON notation.
    fn word(&mut self) -> Result<Json<'a>, String> {
        let rest = self.rest();
        let end = rest.find(|letter: char| letter.is_ascii_whitespace() || ",:[]{}\"".contains(letter));
        let word = &rest[..end.unwrap_or(rest.len())];
        let value = match word {
            "null" => Json::Null,
            "true" => Json::Bool(true),
            "false" => Json::Bool(false),
            "" => return Err(self.expected("a value")),
            _ if self.strict => return Err(self.expected("a value")),
            number => Json::Number(number.into()),
        };
        self.at += word.len();
        Ok(value)
    }

    fn list(&mut self, depth: usize) -> Result<Json<'a>, String> {
        let mut values = Vec::new();
        self.members(b']', |reader| {
            values.push(reader.value(depth + 1)?);
            Ok(())
        })?;
        Ok(Json::List(values))
    }

    fn object(&mut self, depth: usize) -> Result<Json<'a>, String> {
        let mut entries = Vec::new();
        self.members(b'}', |reader| {
            let key = reader.text()?;
            reader.blanks();
            if !reader.takes(":") {
                return Err(reader.expected("a colon"));
            }
            entries.push((key, reader.value(depth + 1)?));
            Ok(())
        })?;
        Ok(Json::Object(entries))
    }

    /// Members separated by commas up to `end`; the opening bracket is next.
    fn members(&mut self, end: u8, mut member: impl FnMut(&mut Self) -> Result<(), String>) -> Result<(), String> {
        self.at += 1;
        self.blanks();
        if self.next() == Some(end) {
            self.at += 1;
            return Ok(());
        }
        loop {
            self.blanks();
            member(self)?;
            self.blanks();
            if self.next() == Some(end) {
                self.at += 1;
                return Ok(());
            }
            if !self.takes(",") {
                return Err(self.expected("a comma or the closing bracket"));
            }
        }
    }

    /// -?(0|[1-9][0-9]*)(.[0-9]+)?([eE][+-]?[0-9]+)?
    fn number(&mut self) -> Result<Json<'a>, String> {
        let start = self.at;
        self.takes("-");
        if !self.takes("0") {
            self.digits()?;
        }
        if self.takes(".") {
            self.digits()?;
        }
        if self.takes("e") || self.takes("E") {
            let _sign = self.takes("+") || self.takes("-");
            self.digits()?;
        }
        Ok(Json::Number(self.text[start..self.at].into()))
    }

    fn digits(&mut self) -> Result<(), String> {
        let count = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        self.at += count;
        if count == 0 { Err(self.expected("a digit")) } else { Ok(()) }
    }

    fn text(&mut self) -> Result<Cow<'a, str>, String> {
        if !self.takes("\"") {
            return Err(self.expected("a text in quotation marks"));
        }
        let plain = self.plain();
        if self.takes("\"") {
            return Ok(Cow::Borrowed(plain));
        }
        let mut text = plain.to_owned();
        while !self.takes("\"") {
            text.push(self.escape()?);
            text.push_str(self.plain());
        }
        Ok(Cow::Owned(text))
    }

    /// Up to the next quotation mark, backslash or control character.
    fn plain(&mut self) -> &'a str {
        let rest = self.rest();
        let end = rest.bytes().position(|byte| byte == b'"' || byte == b'\\' || byte < b' ').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn escape(&mut self) -> Result<char, String> {
        const SIMPLE: [(&str, char); 8] = [
            ("\\\"", '"'),
            ("\\\\", '\\'),
            ("\\/", '/'),
            ("\\b", '\u{8}'),
            ("\\f", '\u{c}'),
            ("\\n", '\n'),
            ("\\r", '\r'),
            ("\\t", '\t'),
        ];
        if let Some((_, letter)) = SIMPLE.iter().find(|(escape, _)| self.takes(escape)) {
            return Ok(*letter);
        }
        let high = self.code_unit()?;
        let code = if (0xD800..0xDC00).contains(&high) {
            let low = self.code_unit()?.wrapping_sub(0xDC00);
            if low < 0x400 { 0x10000 + ((high - 0xD800) << 10) + low } else { high }
        } else {
            high
        };
        char::from_u32(code).ok_or_else(|| self.expected("a pair of surrogates"))
    }

    fn code_unit(&mut self) -> Result<u32, String> {
        if !self.takes("\\u") {
            return Err(self.expected("an escape, or the closing quotation mark"));
        }
        let digits = self.rest().get(..4).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()));
        let code = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        self.at += if code.is_some() { 4 } else { 0 };
        code.ok_or_else(|| self.expected("four hexadecimal digits"))
    }
}

/// A text with its quotation marks.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            control if control < ' ' => quoted.push_str(&format!("\\u{:04x}", control as u32)),
            letter => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
#[path = "../tests/private/json.rs"]
mod tests;
