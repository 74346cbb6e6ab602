//! Files of scenes, fits and arguments, each of which is read up to a limit.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The most bytes of a file: 64 MiB.
pub const MOST_BYTES: u64 = 64 << 20;

/// The bytes of a file that a scene or a fit names. A device, or a pipe that nobody may ever write to, is not opened.
///
/// # Errors
/// A file that cannot be read, is no regular file, or has more than [`MOST_BYTES`].
pub fn named(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    let found = fs::metadata(path.as_ref())?;
    if !found.is_file() {
        let what = if found.is_dir() { "a folder" } else { "a device or a pipe" };
        let why = format!("is {what}: a scene or a fit may name regular files only");
        return Err(io::Error::new(ErrorKind::InvalidInput, why));
    }
    argument(path)
}

/// The bytes of a file that is an argument of a program, which may be a pipe.
///
/// # Errors
/// A file that cannot be read, or has more than [`MOST_BYTES`].
pub fn argument(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    match file.metadata()?.len() {
        bytes if bytes > MOST_BYTES => Err(too_large(&format!("has {bytes} bytes"))),
        _ => bounded(file),
    }
}

/// All that can be read, to its end.
///
/// # Errors
/// Errors of reading; more than [`MOST_BYTES`].
pub fn bounded(from: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_BYTES { Err(too_large("goes on")) } else { Ok(bytes) }
}

/// Bytes as text, without a byte order mark.
///
/// # Errors
/// The line on which they are not UTF-8.
pub fn text(bytes: Vec<u8>) -> io::Result<String> {
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + valid.iter().filter(|byte| **byte == b'\n').count();
        io::Error::new(ErrorKind::InvalidData, format!("is no text: line {line} is not UTF-8"))
    })?;
    if text.starts_with('\u{feff}') {
        text.drain(..'\u{feff}'.len_utf8());
    }
    Ok(text)
}

fn too_large(what: &str) -> io::Error {
    io::Error::new(ErrorKind::FileTooLarge, format!("{what}; at most {MOST_BYTES} bytes (64 MiB) are read"))
}
