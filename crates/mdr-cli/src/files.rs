//! Files that flags name: one way to open them, to write them and to make their folder.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use crate::error::{Failure, Result};
use crate::output::Output;

/// The file, or standard input for `-`.
pub(crate) fn open(path: &Path) -> Result<Box<dyn BufRead>> {
    if path == Path::new("-") {
        return Ok(Box::new(BufReader::new(io::stdin())));
    }
    let file = File::open(path).map_err(|error| Failure::file(path.display().to_string(), error))?;
    Ok(Box::new(BufReader::new(file)))
}

/// Writes a file; a complaint names it after the `flag` that asked for it.
pub(crate) fn write(flag: &str, path: &Path, content: impl AsRef<[u8]>) -> Result<()> {
    fs::write(path, content).map_err(|error| of_flag(flag, path, error))
}

/// A file to be filled, which replaces one of its name.
pub(crate) fn create(flag: &str, path: &Path) -> Result<Output<File>> {
    File::create(path).map(Output::new).map_err(|error| of_flag(flag, path, error))
}

/// Makes a folder where there is none.
pub(crate) fn make_folder(flag: &str, path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|error| of_flag(flag, path, error))
}

/// A file that a flag names, and that cannot be used.
pub(crate) fn of_flag(flag: &str, path: &Path, error: io::Error) -> Failure {
    Failure::file(format!("{flag} {}", path.display()).trim_start(), error)
}
