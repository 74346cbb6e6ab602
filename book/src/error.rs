//! Why the book cannot be made.

use std::io;

/// A fault in a source of the book.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file cannot be read or written.
    #[error("cannot read or write {file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// Why.
        source: io::Error,
    },
    /// A formula is no TeX that can be set.
    #[error("cannot set the formula {tex}: {why}")]
    Formula {
        /// Its source.
        tex: String,
        /// Why.
        why: String,
    },
    /// A page is not as the book needs it.
    #[error("{file}: {why}")]
    Page {
        /// The file.
        file: String,
        /// The missing or wrong part.
        why: String,
    },
}

impl Error {
    pub(crate) fn page(file: impl Into<String>, why: impl Into<String>) -> Self {
        Error::Page { file: file.into(), why: why.into() }
    }
}

/// The result of making a part of the book.
pub type Result<T> = std::result::Result<T, Error>;
