//! `mdr solve`: whatever a scene asks for, and nothing else.

mod explain;
pub(crate) mod render;

use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr::prelude::*;
use mdr::{Cost, Result as Solved};

use crate::error::{Failure, Result};
use crate::flags::{ArithmeticFlags, StyleFlags};
use crate::output::{Format, Output as Out};
use crate::plot;

const EXAMPLES: &str = "\
Examples:
  All instabilities of a wavy sphere, 20 digits, each proved:
    mdr solve examples/scenes/figure-4.toml

  For another program, or in hardware arithmetic:
    mdr solve examples/scenes/figure-4.toml --format json
    mdr solve examples/scenes/figure-4.toml --f64

  What was evaluated, how often and how long it took, on standard error:
    mdr solve examples/scenes/figure-4.toml --explain

  With a picture of the branches, the path and its jumps, and the data of the picture as CSV:
    mdr solve examples/scenes/figure-4.toml --plot figure-4.svg

  For a spreadsheet, one file an output, in nanometres and nanonewtons:
    mdr solve examples/scenes/force-curve.toml --out curve --units nm,nN

A scene is a TOML file with the tables [profile] and [output], and with [material] and [control]
where what is wanted needs them; examples/scenes has one for every kind of profile and control.
Numbers are exact as written, as text or not: 0.3, \"1e-9\", \"1/3\".
Every output names its promise: certified (each digit proved), mp (two precisions agree), or f64.
Profiles with a table of measured rows are computed in f64 unless digits are asked for.
JSON: schema mdr.solve/1, one key for each output that is wanted.
Exit status: 0 answered, 2 bad input.";

/// What hardware arithmetic is good for here: less than for single closed forms.
const IN_F64: &str =
    "Hardware arithmetic instead: fast, to some roundings times the condition of what is asked; nothing is proved";

/// Solve a scene: transform, equilibria, folds, loading path, curve, pressure, gap, displacement and energy of a contact.
///
/// What is wanted, for which profile, material and control, is written in a TOML file. Nothing else is computed.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, mut_arg("f64", |flag| flag.help(IN_F64)))]
pub(crate) struct Solve {
    /// The scene, a TOML file; - is standard input
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,

    #[command(flatten)]
    arithmetic: ArithmeticFlags,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,

    /// Draw the contact, its branches and its path as SVG, and write the data as CSV beside it; in f64
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

    /// Colours of the picture
    #[arg(long, value_enum, default_value_t)]
    theme: plot::Colours,

    /// Write one CSV file an output into a folder, with units in the headers and a column an input
    #[arg(long, value_name = "DIR", conflicts_with = "format")]
    out: Option<PathBuf>,

    #[command(flatten)]
    style: StyleFlags,

    /// Tell on standard error what each output cost: evaluations of g, its slope and its integral, and time
    #[arg(long)]
    explain: bool,
}

impl Solve {
    /// Answers on `out`.
    pub(crate) fn run(&self, out: &mut Out<impl std::io::Write>) -> Result<()> {
        self.plot.as_deref().map_or(Ok(()), plot::check)?;
        let style = self.style.style(self.out.is_some() || self.format == Format::Table)?;
        let scene = open(&self.scene)?.in_arithmetic(self.arithmetic.given()?);
        if self.plot.is_some() && !scene.has_material() {
            let why = "a picture shows equilibria, and needs [material] in the scene".to_owned();
            return Err(Failure::Flag { flag: "--plot", why, got: None });
        }
        let mut progress = Progress::default();
        let mut answer = scene.solve_with(&mut Run::new(&mut progress, Stop::default()))?;
        answer.notes.extend(scene.unused(self.plot.is_some()));
        match &self.out {
            Some(folder) => render::write_files(&scene, &answer, folder, &style, out)?,
            None => render::write(&answer, self.format, &style, out)?,
        }
        if let Some(file) = &self.plot {
            draw(&scene, &self.scene, file, self.theme).map_err(not_drawn)?;
        }
        if self.explain { explain::write(&progress.costs) } else { Ok(()) }
    }
}

/// The file, or standard input for `-`.
fn open(path: &Path) -> Solved<Scene> {
    if path != Path::new("-") {
        return Scene::open(path);
    }
    let mut text = String::new();
    let read = std::io::stdin().read_to_string(&mut text);
    read.map_err(|source| Error::Io { name: "standard input".to_owned(), source })?;
    let files = |file: &str| std::fs::read(file);
    match text.trim_start().starts_with('{') {
        true => Scene::from_json(&text, "<stdin>", &files),
        false => Scene::from_toml(&text, "<stdin>", &files),
    }
}

/// Draws the scene that was read from the file `from` to the SVG file `to`, and its data to a CSV file beside it.
fn draw(scene: &Scene, from: &Path, to: &Path, colours: plot::Colours) -> Result<()> {
    let name =
        from.file_stem().filter(|stem| *stem != "-").map_or_else(String::new, |stem| format!(": {}", stem.display()));
    let title = format!("{} under controlled {}{name}", scene.profile().name(), scene.controlled().kind().name());
    plot::write(&mdr_plot::scene(&title, &scene.diagram()?), colours, to, "--plot ")
}

/// A picture that cannot be drawn names its flag.
fn not_drawn(failure: Failure) -> Failure {
    match failure {
        failure @ (Failure::Scene(Error::Scene { .. } | Error::Io { .. }) | Failure::File { .. }) => failure,
        failure => {
            let why = format!("the picture is drawn in f64: {failure}");
            Failure::Flag { flag: "--plot", why, got: None }
        }
    }
}

/// What is being computed, on a terminal and when it takes long; and what each output cost.
#[derive(Default)]
struct Progress {
    running: Option<(ProgressBar, Instant)>,
    costs: Vec<(Cost, Duration)>,
}

impl Observer for Progress {
    fn begin(&mut self, want: &Want) {
        let bar = ProgressBar::new_spinner();
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message(want.name());
        bar.enable_steady_tick(Duration::from_millis(200));
        self.running = Some((bar, Instant::now()));
    }

    fn output(&mut self, _: &Output, cost: &Cost) {
        if let Some((bar, begin)) = self.running.take() {
            bar.finish_and_clear();
            self.costs.push((cost.clone(), begin.elapsed()));
        }
    }
}

/// An output that fails leaves no spinner behind.
impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((bar, _)) = &self.running {
            bar.finish_and_clear();
        }
    }
}
