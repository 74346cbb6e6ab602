//! `mdr solve`: the outputs that a scene wants, and nothing else.

mod explain;
pub(crate) mod render;

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::ProgressBar;
use mdr::prelude::*;
use mdr::{BUDGET, Cost};
use mdr_core::units::SiUnit;
use mdr_plot::Picture;

use crate::error::{Failure, Result};
use crate::flags::{ArithmeticFlags, Flag, StyleFlags};
use crate::output::{Format, Output as Out};
use crate::plot::PictureFlags;
use crate::{files, progress};

/// The help of `--f64`: hardware arithmetic achieves less here than for single closed forms.
const IN_F64: &str =
    "Hardware arithmetic instead: fast, to some roundings times the condition of the question; nothing is proved";

/// The help of `--plot`.
const PICTURE: &str = "Draw the contact, its branches and its path as SVG, PNG or PDF by the name of the file, and write the data as CSV beside it; in f64";

/// Solve a scene: transform, equilibria, folds, loading path, curve, pressure, gap, displacement and energy of a contact.
///
/// A TOML file names the outputs wanted, the profile, the material and the control. Nothing else is computed.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/solve.txt"), mut_arg("f64", |flag| flag.help(IN_F64)), mut_arg("plot", |flag| flag.help(PICTURE)))]
pub(crate) struct Solve {
    /// The scene, a TOML file; - is standard input
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,

    #[command(flatten)]
    arithmetic: ArithmeticFlags,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,

    #[command(flatten)]
    picture: PictureFlags,

    /// Write one CSV file an output into a folder, with units in the headers and a column an input
    #[arg(long, value_name = "DIR", conflicts_with = "format")]
    out: Option<PathBuf>,

    #[command(flatten)]
    style: StyleFlags,

    /// Write a certificate of the folds, equilibria and path: boxes and cells for a small program to check (JSON)
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,

    /// Work for the scene, in seconds of a fast machine (counted, not timed); what it does not suffice for is undecided
    #[arg(long, value_name = "SECONDS", default_value_t = BUDGET.to_string())]
    budget: String,

    /// Tell on standard error what each output cost: evaluations of g, its slope and its integral, and time
    #[arg(long)]
    explain: bool,
}

impl Solve {
    /// Answers on `out`.
    pub(crate) fn run(&self, out: &mut Out<impl io::Write>) -> Result<()> {
        let drawn = self.picture.wanted()?;
        let style = self.style.style(self.out.is_some() || self.format == Format::Table)?;
        self.out.as_deref().map_or(Ok(()), |folder| files::check_folder("--out", folder))?;
        let scene = open(&self.scene)?.in_arithmetic(self.arithmetic.given()?);
        if drawn && !scene.has_material() {
            let why = "a picture shows equilibria, and needs [material] in the scene";
            return Err(Failure::refused("--plot", why));
        }
        let budget = Flag::new("--budget", &self.budget).positive(SiUnit::One)?.nearest_f64();
        let mut progress = Progress::default();
        let mut answer = scene.solve_with(&mut Run::new(&mut progress, Stop::default()).within(budget))?;
        answer.notes.extend(scene.unused(drawn));
        match &self.out {
            Some(folder) => render::write_files(&scene, &answer, folder, &style, out)?,
            None => render::write(&answer, self.format, &style, out)?,
        }
        if let Some(file) = &self.certificate {
            let certificate = scene.certificate(&answer)?;
            files::write("--certificate", file, mdr_provenance::json(&certificate).into_owned() + "\n")?;
        }
        self.picture.draw(|| picture(&scene, &self.scene)).map_err(not_drawn)?;
        if self.explain { explain::write(&progress.costs) } else { Ok(()) }
    }
}

/// The file, or standard input for `-`.
fn open(path: &Path) -> Result<Scene> {
    if path != Path::new("-") {
        return Ok(Scene::open(path)?);
    }
    let text = mdr::files::bounded(io::stdin()).and_then(mdr::files::text);
    let text = text.map_err(|error| Failure::file("standard input", error))?;
    let files = |file: &str| mdr::files::named(file);
    Ok(match text.trim_start().starts_with('{') {
        true => Scene::from_json(&text, "<stdin>", &files),
        false => Scene::from_toml(&text, "<stdin>", &files),
    }?)
}

/// The picture of the scene that was read from the file `from`.
fn picture(scene: &Scene, from: &Path) -> Result<Picture> {
    let name = from
        .file_stem()
        .filter(|stem| *stem != "-")
        .map_or_else(String::new, |stem| format!(": {}", files::shown(stem.as_ref())));
    let title = format!("{} under controlled {}{name}", scene.profile().name(), scene.controlled().kind().name());
    Ok(mdr_plot::scene(&title, &scene.diagram()?))
}

/// A picture that cannot be drawn names its flag.
fn not_drawn(failure: Failure) -> Failure {
    match failure {
        failure @ (Failure::Answer(Error::Scene { .. } | Error::Io { .. })
        | Failure::File { .. }
        | Failure::Flag { .. }) => failure,
        failure => Failure::refused("--plot", format_args!("the picture is drawn in f64: {failure}")),
    }
}

/// Shows the running output on a terminal when it takes long, and collects the cost of each output.
#[derive(Default)]
struct Progress {
    running: Option<(ProgressBar, Instant)>,
    costs: Vec<(Cost, Duration)>,
}

impl Observer for Progress {
    fn begin(&mut self, want: &Want) {
        self.running = Some((progress::spinner(want.name()), Instant::now()));
    }

    fn output(&mut self, _: &Output, cost: &Cost) {
        if let Some((bar, begin)) = self.running.take() {
            bar.finish_and_clear();
            self.costs.push((cost.clone(), begin.elapsed()));
        }
    }
}
