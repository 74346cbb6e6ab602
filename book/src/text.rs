//! The hand-written part of an entry: `book/text/ID.md`, in sections.

use std::path::Path;

use crate::error::{Error, Result};

/// The sections of a text. Formulas stand between dollars.
#[derive(Debug, Default)]
pub(crate) struct Text {
    /// The equation as the paper has it, in the paper's symbols; errors are red.
    pub(crate) printed: Option<String>,
    /// The equation, corrected; corrections are green.
    pub(crate) corrected: Option<String>,
    /// A result beyond the paper.
    pub(crate) result: Option<String>,
    /// The argument in words.
    pub(crate) why: String,
    /// Records whose certified values are shown.
    pub(crate) numbers: Vec<String>,
}

impl Text {
    /// Reads the text of an entry.
    pub(crate) fn read(root: &Path, id: &str) -> Result<Self> {
        let file = format!("book/text/{id}.md");
        let source = read(root, &file)?;
        let mut text = Text::default();
        for section in source.split("\n# ").map(|part| part.trim_start_matches("# ")) {
            let (name, body) = section.split_once('\n').unwrap_or((section, ""));
            let body = body.trim().to_owned();
            match name.trim() {
                "printed" => text.printed = Some(body),
                "corrected" => text.corrected = Some(body),
                "result" => text.result = Some(body),
                "why" => text.why = body,
                "numbers" => text.numbers = body.lines().map(str::to_owned).collect(),
                other => return Err(Error::page(file, format!("no section is called {other:?}"))),
            }
        }
        if text.why.is_empty() || (text.printed.is_none() && text.result.is_none()) {
            return Err(Error::page(file, "an entry needs `# why`, and `# printed` or `# result`"));
        }
        Ok(text)
    }
}

/// A file of the project.
pub(crate) fn read(root: &Path, file: &str) -> Result<String> {
    std::fs::read_to_string(root.join(file)).map_err(|source| Error::Io { file: file.to_owned(), source })
}
