//! A picture as a file, with its data beside it: the flag `--plot`.

use std::path::Path;

use super::{Picture, svg, write_csv};
use crate::error::{Failure, Result};

/// Refuses a file whose name would be that of its own data.
///
/// # Errors
/// Unless the name ends in `.svg`.
pub(crate) fn check(to: &Path) -> Result<()> {
    if to.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg")) {
        return Ok(());
    }
    Err(Failure::flag("--plot", "must be the name of an .svg file", &to.display().to_string()))
}

/// Writes the SVG file `to`, and a CSV file of the data beside it.
///
/// # Errors
/// When a file cannot be written.
pub(crate) fn write(picture: &Picture, to: &Path) -> Result<()> {
    let failed = |file: &Path| {
        let name = format!("--plot {}", file.display());
        move |error: std::io::Error| Failure::file(name, error)
    };
    std::fs::write(to, svg(picture)?).map_err(failed(to))?;
    let csv = to.with_extension("csv");
    let mut data = Vec::new();
    write_csv(picture, &csv.display().to_string(), &mut data)?;
    std::fs::write(&csv, data).map_err(failed(&csv))
}
