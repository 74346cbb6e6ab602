//! `mdr-book [OUT]`: makes the book, into `target/book` if nothing else is said.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use mdr_book::{Error, Result, build};

fn main() -> ExitCode {
    let out = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("target/book"), PathBuf::from);
    match write(&out) {
        Ok(pages) => {
            eprintln!("{pages} pages: {}", out.join("index.html").display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Writes the book of the project in which the program was built. What the explorer has put there stays.
fn write(out: &Path) -> Result<usize> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files = build(&root, out.join("explorer.html").is_file())?;
    for (name, bytes) in &files {
        let path = out.join(name);
        let io = |source| Error::Io { file: path.display().to_string(), source };
        std::fs::create_dir_all(path.parent().unwrap_or(out)).map_err(io)?;
        std::fs::write(&path, bytes).map_err(io)?;
    }
    Ok(files.keys().filter(|name| name.ends_with(".html")).count())
}
