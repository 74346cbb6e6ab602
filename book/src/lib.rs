//! The theory, equation by equation, as a static site: every formula, number and verdict is computed when it is made.
//!
//! Prose is in `book/text`, one file an entry; derivations come from `mdr-symbolic`, their verdicts from `mdr-crosscheck`, values
//! from `mdr-reference`, and the documents of `docs/` become pages. The result needs no server and loads nothing from elsewhere.

#![forbid(unsafe_code)]

mod bibliography;
mod book;
mod chapters;
mod conformance;
mod entry;
mod error;
mod figures;
mod fits;
mod links;
mod markdown;
mod moving;
mod references;
mod shell;
mod spine;
mod tex;
mod text;
mod values;

pub use book::{BookFiles, build};
pub use error::{Error, Result};
