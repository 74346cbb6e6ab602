//! `mdr figures`: the figures of the paper, computed.

use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_plot::Picture;
use mdr_plot::figures::FIGURES;
use serde::Serialize;

use crate::error::{Failure, Result};
use crate::output::{Format, Output};
use crate::plot;
use crate::table::{Tone, cell, render, table};

const EXAMPLES: &str = "\
Examples:
  Figures 1 to 4 of the paper, each with its data, into the directory figures:
    mdr figures

  Into another one, which is made when it is not there:
    mdr figures --out /tmp/popov

  For a talk on a dark background, and as PNG by a program that draws SVG:
    mdr figures --theme dark
    rsvg-convert -w 1600 figures/figure-4.svg -o figure-4.png

  The caption of each figure, with the computed numbers:
    mdr figures --format json

Each figure is an SVG file with its caption inside, in colours for light, dark and print, and
beside it a CSV file of the curves, states and arrows in it. The same files come out of every run.
Arithmetic: f64.
JSON: schema mdr.figures/1, one line a figure.
Exit status: 0 all files are written, 2 bad input or a file that cannot be written.";

/// The figures of the paper, computed: curves, equilibria, directions of change, critical states and jumps.
///
/// Figure 1a and 1b: equilibrium of a paraboloid, and the last one; 2: a stable and an unstable equilibrium; 3: the sharp
/// tip r^(1/4) that jumps to complete contact; 4: a wavy paraboloid that jumps from crest to crest.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Figures {
    /// Directory of the files
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,

    /// Colours of the figures
    #[arg(long, value_enum, default_value_t)]
    theme: plot::Colours,

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
        let directory = || self.out.display().to_string();
        std::fs::create_dir_all(&self.out).map_err(|error| Failure::file(format!("--out {}", directory()), error))?;
        let style = ProgressStyle::with_template("{bar:40.green} {pos} of {len}  {msg}");
        let bar =
            ProgressBar::new(FIGURES.len() as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let mut written = Vec::with_capacity(FIGURES.len());
        for (figure, compute) in FIGURES {
            bar.set_message(figure);
            written.push(write(figure, compute()?, self.theme, &self.out)?);
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
                        cell(&figure.svg, Tone::Good),
                        cell(&figure.csv, Tone::Plain),
                        cell(&figure.title, Tone::Plain),
                    ]);
                }
                out.text(render(&files))
            }
        }
    }
}

/// Writes one figure and its data.
fn write(figure: &'static str, picture: Picture, colours: plot::Colours, directory: &Path) -> Result<Written> {
    let path = |extension: &str| directory.join(format!("{figure}.{extension}"));
    let svg = path("svg");
    plot::write(&picture, colours, &svg, "")?;
    Ok(Written {
        schema: "mdr.figures/1",
        figure,
        title: picture.title,
        caption: picture.description,
        svg: svg.display().to_string(),
        csv: path("csv").display().to_string(),
    })
}
