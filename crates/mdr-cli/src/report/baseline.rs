//! The baseline of digits and evaluations: compared, and written anew.

use std::io::Write;
use std::path::Path;

use mdr_crosscheck::contest::Baseline;

use crate::error::{Failure, Result};
use crate::output::Output;

/// Tells what got worse; whether nothing did.
pub(super) fn check(path: &Path, out: &mut Output<impl Write>) -> Result<bool> {
    let name = || format!("--check {}", path.display());
    let text = std::fs::read_to_string(path).map_err(|error| Failure::file(name(), error))?;
    let old = Baseline::from_json_lines(&text).map_err(|error| Failure::file(name(), error))?;
    let now = Baseline::now();
    let regressions = old.regressions(&now);
    for regression in &regressions {
        out.text(regression)?;
    }
    out.text(format_args!("{} settings compared, {} worse or unknown", now.len(), regressions.len()))?;
    Ok(regressions.is_empty())
}

/// Writes what is reached now.
pub(super) fn renew(path: &Path, out: &mut Output<impl Write>) -> Result<()> {
    let name = || format!("--renew {}", path.display());
    let now = Baseline::now();
    let text = now.to_json_lines().map_err(|error| Failure::file(name(), error))?;
    std::fs::write(path, text).map_err(|error| Failure::file(name(), error))?;
    out.text(format_args!("{} settings in {}", now.len(), path.display()))
}
