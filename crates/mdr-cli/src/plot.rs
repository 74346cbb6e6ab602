//! A picture as a file, with its data beside it: the flag `--plot`.

use std::fs::File;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use mdr_plot::{Picture, Theme};

use crate::error::{Failure, Result};
use crate::files;

/// The flags of a command that draws its answer; the help of each command describes the picture.
#[derive(Debug, Args)]
pub(crate) struct PictureFlags {
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

    /// Colours of the picture
    #[arg(long, value_parser = theme(), default_value = THEMES[0].0)]
    theme: Theme,
}

impl PictureFlags {
    /// Whether a picture is asked for, into a file that may be written.
    ///
    /// # Errors
    /// Errors of [`check`] for a file that cannot or must not be written.
    pub(crate) fn wanted(&self) -> Result<bool> {
        self.plot.as_deref().map_or(Ok(()), check)?;
        Ok(self.plot.is_some())
    }

    /// Draws the picture if one is wanted, and computes it only then.
    ///
    /// # Errors
    /// When a file cannot be written, or nothing can be drawn.
    pub(crate) fn draw(&self, picture: impl FnOnce() -> Result<Picture>) -> Result<()> {
        self.plot.as_deref().map_or(Ok(()), |to| write(&picture()?, self.theme, to, "--plot"))
    }
}

/// The values of the flag `--theme`, each with its purpose.
const THEMES: [(&str, Theme, &str); 4] = [
    ("auto", Theme::Auto, "Light or dark as the reader's system is"),
    ("light", Theme::Light, "For a light page"),
    ("dark", Theme::Dark, "For a dark page"),
    ("paper", Theme::Paper, "Black and grey, for print"),
];

/// Reads the flag `--theme`.
pub(crate) fn theme() -> impl TypedValueParser<Value = Theme> {
    let values = THEMES.map(|(name, _, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(values)
        .map(|given| THEMES.into_iter().find(|(name, ..)| *name == given).map_or(Theme::Auto, |(_, theme, _)| theme))
}

/// Refuses a file whose name would be that of its own data, or whose data would take the place of another file.
///
/// # Errors
/// Unless the name ends in `.svg`, both files can be made in their folder, and the CSV file beside it is not there, or is the data of a picture.
fn check(to: &Path) -> Result<()> {
    let refuse = |why: &str| Err(Failure::flag("--plot", why, &to.display().to_string()));
    if !to.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg")) {
        return refuse("must be the name of an .svg file");
    }
    let beside = to.with_extension("csv");
    // A pipe of this name is not opened: it may never be written to.
    if beside.is_file() && File::open(&beside).is_ok_and(|file| !mdr_plot::is_data(file)) {
        return refuse(&format!(
            "the data of the picture would replace {}, which was not written with a picture: choose another name",
            beside.display()
        ));
    }
    [to, &beside].into_iter().try_for_each(|file| files::check("--plot", file))
}

/// Writes the SVG file `to`, and a CSV file of the data beside it; names in complaints follow the `flag` that asked for it.
///
/// # Errors
/// When a file cannot be written.
pub(crate) fn write(picture: &Picture, theme: Theme, to: &Path, flag: &str) -> Result<()> {
    files::write(flag, to, mdr_provenance::svg(&picture.svg_in(theme)).as_bytes())?;
    files::write(flag, &to.with_extension("csv"), mdr_provenance::csv(&picture.csv()))
}
