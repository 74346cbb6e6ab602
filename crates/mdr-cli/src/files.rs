//! Files that flags name: one way to open them, to write them and to make their folder.

use std::fs::{self, File, Metadata};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

use mdr_core::text::printable;

use crate::error::{Failure, Result};
use crate::output::Output;

/// The most bytes that are read line by line: 256 MiB.
const MOST_STREAMED: u64 = 256 << 20;

/// The file, or standard input for `-`, to be read line by line.
pub(crate) fn open(path: &Path) -> Result<Box<dyn BufRead>> {
    if path == Path::new("-") {
        return Ok(Box::new(BufReader::new(Bounded { from: io::stdin(), left: MOST_STREAMED })));
    }
    let file = File::open(path).map_err(|error| Failure::file(path.display().to_string(), error))?;
    Ok(Box::new(BufReader::new(Bounded { from: file, left: MOST_STREAMED })))
}

/// A reader that ends with an error where there is more than may be read.
struct Bounded<R> {
    from: R,
    left: u64,
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let read = self.from.read(bytes)?;
        self.left = self.left.checked_sub(read as u64).ok_or_else(|| {
            let why = format!("goes on; at most {MOST_STREAMED} bytes (256 MiB) are read: take it in parts");
            io::Error::new(ErrorKind::FileTooLarge, why)
        })?;
        Ok(read)
    }
}

/// Writes a file; a complaint names it after the `flag` that asked for it. The file is there with its whole content, or as it
/// was before.
pub(crate) fn write(flag: &str, path: &Path, content: impl AsRef<[u8]>) -> Result<()> {
    replace(path, content.as_ref()).map_err(|error| of_flag(flag, path, error))
}

/// A file that `fill` fills, written as [`write`] does.
pub(crate) fn create(
    flag: &str,
    path: &Path,
    fill: impl FnOnce(&mut Output<&mut Vec<u8>>) -> Result<()>,
) -> Result<()> {
    let mut content = Vec::new();
    fill(&mut Output::new(&mut content))?;
    write(flag, path, content)
}

/// A CSV file that `fill` fills, below a comment that names the program.
pub(crate) fn create_csv(
    flag: &str,
    path: &Path,
    fill: impl FnOnce(&mut Output<&mut Vec<u8>>) -> Result<()>,
) -> Result<()> {
    create(flag, path, |out| {
        out.text(mdr_provenance::csv("").trim_end())?;
        fill(out)
    })
}

/// Writes beside the file first, and takes its place then. What is no regular file, such as a pipe, is written to as it is.
fn replace(path: &Path, content: &[u8]) -> io::Result<()> {
    // The file that a link leads to is written, and the link stays.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let before = fs::metadata(&path).ok();
    if before.as_ref().is_some_and(|before| !before.is_file()) {
        return fs::write(path, content);
    }
    let part = part_in(folder_of(&path));
    let written = fill(&part, content, before.as_ref()).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // What could not be written is worth nothing, and why is said.
        drop(fs::remove_file(part));
    }
    written
}

fn fill(part: &Path, content: &[u8], before: Option<&Metadata>) -> io::Result<()> {
    let mut file = File::create_new(part)?;
    file.write_all(content)?;
    before.map_or(Ok(()), |before| file.set_permissions(before.permissions()))
}

/// The name of a file in `folder` that nobody else has.
fn part_in(folder: &Path) -> PathBuf {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    folder.join(format!(".mdr-{}-{}.part", process::id(), COUNT.fetch_add(1, Ordering::Relaxed)))
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."))
}

/// Refuses a file that could not be written when its content is known.
///
/// # Errors
/// A folder of this name; a folder that is not there, or in which no file can be made.
pub(crate) fn check(flag: &str, path: &Path) -> Result<()> {
    if path.is_dir() {
        return Err(of_flag(flag, path, ErrorKind::IsADirectory.into()));
    }
    probe(folder_of(path)).map_err(|error| of_flag(flag, path, error))
}

/// Refuses a folder that could not be made or written to when the content of its files is known.
///
/// # Errors
/// The last folder on the way that is there is a file, or nothing can be made in it.
pub(crate) fn check_folder(flag: &str, path: &Path) -> Result<()> {
    let there = path.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("."));
    probe(there).map_err(|error| of_flag(flag, path, error))
}

/// Makes a file and removes it.
fn probe(folder: &Path) -> io::Result<()> {
    let part = part_in(folder);
    File::create_new(&part).and_then(|_| fs::remove_file(part))
}

/// Makes a folder where there is none.
pub(crate) fn make_folder(flag: &str, path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|error| of_flag(flag, path, error))
}

/// The name of a file or a folder in a message: on one line, every character that is not printed escaped.
pub(crate) fn shown(path: &Path) -> String {
    printable(&path.display().to_string()).to_string()
}

/// A file that a flag names, and that cannot be used.
pub(crate) fn of_flag(flag: &str, path: &Path, error: io::Error) -> Failure {
    Failure::file(format!("{flag} {}", path.display()).trim_start(), error)
}
