//! `mdr figures`: the figures of the paper, computed.

use std::path::{Path, PathBuf};

use clap::Args;
use mdr_core::text::printable;
use mdr_plot::figures::FIGURES;
use mdr_plot::{Picture, Sheet};
use serde::Serialize;

use crate::error::Result;
use crate::output::{Format, Output};
use crate::table::{CellStyle, cell, render, table};
use crate::{files, plot, progress};

/// The figures of the paper, computed: curves, equilibria, directions of change, critical states and jumps.
///
/// Figure 1a and 1b: equilibrium of a paraboloid, and the last one; 2: a stable and an unstable equilibrium; 3: the sharp
/// tip r^(1/4) that jumps to complete contact; 4: a wavy paraboloid that jumps from crest to crest.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/figures.txt"))]
pub(crate) struct Figures {
    /// Directory of the files
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,

    #[command(flatten)]
    sheet: plot::SheetFlags,

    /// Shape of the list of files
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// A figure that has been written.
#[derive(Serialize)]
struct Written {
    schema: &'static str,
    figure: &'static str,
    title: String,
    caption: String,
    svg: String,
    csv: String,
}

impl Figures {
    /// Writes the files, and their list on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<()> {
        let sheet = self.sheet.sheet()?;
        files::make_folder("--out", &self.out)?;
        let bar = progress::bar(FIGURES.len());
        let mut written = Vec::with_capacity(FIGURES.len());
        for (figure, compute) in FIGURES {
            bar.set_message(figure);
            written.push(write(figure, compute()?, &sheet, &self.out)?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        self.list(&written, out)
    }

    fn list(&self, written: &[Written], out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json => written.iter().try_for_each(|figure| out.json(figure)),
            Format::Csv => out.csv(
                &["figure", "title", "svg", "csv"],
                written.iter().map(|figure| {
                    [figure.figure.to_owned(), figure.title.clone(), figure.svg.clone(), figure.csv.clone()]
                }),
            ),
            Format::Table => {
                let mut files = table(&["file", "data", "what it shows"]);
                for figure in written {
                    files.add_row([
                        cell(printable(&figure.svg), CellStyle::Good),
                        cell(printable(&figure.csv), CellStyle::Plain),
                        cell(&figure.title, CellStyle::Plain),
                    ]);
                }
                out.text(render(&files))
            }
        }
    }
}

/// Writes one figure and its data.
fn write(figure: &'static str, picture: Picture, sheet: &Sheet, directory: &Path) -> Result<Written> {
    let path = |extension: &str| directory.join(format!("{figure}.{extension}"));
    let svg = path("svg");
    plot::write(&picture, &picture.csv(), sheet, &svg, "")?;
    Ok(Written {
        schema: "mdr.figures/1",
        figure,
        title: picture.title,
        caption: picture.description,
        svg: svg.display().to_string(),
        csv: path("csv").display().to_string(),
    })
}
