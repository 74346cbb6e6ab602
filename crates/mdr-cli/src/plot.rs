//! A picture as a file, with its data beside it: the flag `--plot`.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use clap::ValueEnum;
use mdr_plot::{CSV_HEADER, Picture, Theme};

use crate::error::{Failure, Result};

/// The colours of a picture: the flag `--theme`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Colours {
    /// Light or dark as the reader's system is
    #[default]
    Auto,
    /// For a light page
    Light,
    /// For a dark page
    Dark,
    /// Black and grey, for print
    Paper,
}

impl From<Colours> for Theme {
    fn from(colours: Colours) -> Self {
        match colours {
            Colours::Auto => Theme::Auto,
            Colours::Light => Theme::Light,
            Colours::Dark => Theme::Dark,
            Colours::Paper => Theme::Paper,
        }
    }
}

/// Refuses a file whose name would be that of its own data, or whose data would take the place of another file.
///
/// # Errors
/// Unless the name ends in `.svg`, and the CSV file beside it is not there, or is the data of a picture.
pub(crate) fn check(to: &Path) -> Result<()> {
    let refuse = |why: &str| Err(Failure::flag("--plot", why, &to.display().to_string()));
    if !to.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg")) {
        return refuse("must be the name of an .svg file");
    }
    let beside = to.with_extension("csv");
    if File::open(&beside).is_ok_and(|file| !is_data(file)) {
        return refuse(&format!(
            "the data of the picture would replace {}, which was not written with a picture: choose another name",
            beside.display()
        ));
    }
    Ok(())
}

/// Whether this begins as the data of a picture do.
fn is_data(file: impl Read) -> bool {
    let mut start = Vec::new();
    let read = file.take(CSV_HEADER.len() as u64).read_to_end(&mut start);
    read.is_ok() && start == CSV_HEADER.as_bytes()
}

/// Writes the SVG file `to`, and a CSV file of the data beside it; names in complaints follow `flag`.
///
/// # Errors
/// When a file cannot be written.
pub(crate) fn write(picture: &Picture, colours: Colours, to: &Path, flag: &str) -> Result<()> {
    for (file, text) in [(to.to_owned(), picture.svg_in(colours.into())), (to.with_extension("csv"), picture.csv())] {
        std::fs::write(&file, text).map_err(|error| Failure::file(format!("{flag}{}", file.display()), error))?;
    }
    Ok(())
}
