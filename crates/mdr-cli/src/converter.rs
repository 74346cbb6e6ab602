//! From SVG to PNG and PDF, by the program rsvg-convert of the system.
//!
//! The libraries that could do it (docs/dependencies.md) are half as many crates again as all others together, for pictures that
//! few ask for.

use std::io::Write;
use std::process::{Command, Stdio};
use std::thread;

use crate::error::{Failure, Result};

const PROGRAM: &str = "rsvg-convert";

/// Pixels of an inch of a PNG, as journals ask for.
const DOTS: &str = "300";

/// Whether the program is there.
///
/// # Errors
/// Its name, and where it comes from, where it is not.
pub(crate) fn check() -> Result<()> {
    let mut asked = Command::new(PROGRAM);
    match asked.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status() {
        Ok(status) if status.success() => Ok(()),
        _ => Err(missing("it is not there")),
    }
}

/// The bytes of the picture in `format`, png or pdf.
///
/// # Errors
/// What the program complains of.
pub(crate) fn convert(svg: &str, format: &str) -> Result<Vec<u8>> {
    let mut convert = Command::new(PROGRAM);
    convert.args(["--format", format]);
    if format == "png" {
        convert.args(["--dpi-x", DOTS, "--dpi-y", DOTS]);
    }
    let child = convert.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = child.map_err(|error| missing(&error.to_string()))?;
    let mut to = child.stdin.take();
    let svg = svg.to_owned();
    // It may write before it has read all.
    let writer = thread::spawn(move || to.as_mut().map(|to| to.write_all(svg.as_bytes())));
    let done = child.wait_with_output().map_err(|error| missing(&error.to_string()))?;
    // A program that stops reading says why itself.
    drop(writer.join());
    match done.status.success() && !done.stdout.is_empty() {
        true => Ok(done.stdout),
        false => Err(missing(String::from_utf8_lossy(&done.stderr).trim())),
    }
}

fn missing(why: &str) -> Failure {
    Failure::refused(
        "--plot",
        format_args!(
            "PNG and PDF are made by the program {PROGRAM} ({why}): install librsvg2-bin (Debian, Ubuntu), librsvg2-tools (Fedora) or \
             librsvg (Homebrew), or write an .svg file"
        ),
    )
}
