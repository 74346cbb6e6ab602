//! `mdr solve`: whatever a scene asks for, and nothing else.

mod answer;
mod beyond;
mod certified;
mod contact;
mod digits;
mod double;
mod enclosed;
mod explain;
mod law_path;
mod library;
mod outputs;
mod path;
mod plot;
mod power_law;
mod record;
mod render;
mod roughness;
mod sample;
mod states;
mod unused;

pub(crate) use path::name as event_name;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_core::contact::Error;
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::folds::Folds;

use self::answer::{Answer, Output as Solved};
use self::certified::Certified;
use self::contact::{Contact, Tally};
use self::double::Double;
use self::explain::Cost;
use self::power_law::PowerLaw;
use crate::error::{Failure, Result};
use crate::flags::{Arithmetic, ArithmeticFlags};
use crate::output::{Format, Output};
use crate::scene::{Held, Scene, Start, Want};

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

    /// Tell on standard error what each output cost: evaluations of g, its slope and its integral, and time
    #[arg(long)]
    explain: bool,
}

impl Solve {
    /// Answers on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<()> {
        self.plot.as_deref().map_or(Ok(()), crate::picture::file::check)?;
        let scene = Scene::open(&self.scene, self.arithmetic.given()?)?;
        if self.plot.is_some() && !scene.has_material {
            let why = "a picture shows equilibria, and needs [material] in the scene".to_owned();
            return Err(Failure::Flag { flag: "--plot", why, got: None });
        }
        let tally = Arc::new(Tally::default());
        let solver = Solver::new(&scene, &tally).map_err(|error| scene.places.complaint_about_profile(error))?;
        solver.check_range(&scene)?;
        let (mut answer, costs) = solve(&scene, &solver, &tally)?;
        answer.notes.extend(unused::notes(&scene, self.plot.is_some()));
        render::write(&answer, self.format, out)?;
        if let Some(file) = &self.plot {
            plot::write(&scene, &solver, &self.scene, file).map_err(not_drawn)?;
        }
        if self.explain { explain::write(&costs) } else { Ok(()) }
    }
}

/// A picture that cannot be drawn names its flag.
fn not_drawn(failure: Failure) -> Failure {
    match failure {
        failure @ (Failure::Scene { .. } | Failure::File { .. }) => failure,
        failure => {
            let why = format!("the picture is drawn in f64: {failure}");
            Failure::Flag { flag: "--plot", why, got: None }
        }
    }
}

/// The answer, and what each output cost.
fn solve(scene: &Scene, solver: &Solver<'_>, tally: &Arc<Tally>) -> Result<(Answer, Vec<Cost>)> {
    let mut outputs = Vec::new();
    let mut costs = Vec::new();
    for &want in &scene.output.want {
        let (before, begin) = (tally.read(), Instant::now());
        let bar = spinner(want);
        let output = solver.output(scene, want, tally);
        bar.finish_and_clear();
        let output = output.map_err(|error| complaint(scene, want, error, solver))?;
        costs.push(Cost::new(want, before, tally.read(), begin.elapsed()));
        outputs.push(output);
    }
    let digits = match scene.output.arithmetic {
        Arithmetic::Certified { digits } => Some(digits),
        Arithmetic::Double => None,
    };
    let profile = scene.profile.name();
    let has_states = scene.output.wants(|want| !want.is_of_profile());
    let control = (scene.has_control || has_states).then(|| scene.held.by.name());
    let mut notes = scene.notes.clone();
    notes.extend(roughness::note(scene, solver));
    let admissibility = if has_states { solver.admissibility().map(|known| known.basis()) } else { None };
    Ok((Answer { digits, profile, control, notes, outputs, admissibility }, costs))
}

/// What is wrong with the scene when it has no answer.
fn complaint(scene: &Scene, want: Want, error: Error, solver: &Solver<'_>) -> Failure {
    match error {
        Error::NoEquilibrium { .. } if want == Want::Path => {
            scene.held.start_place.as_ref().unwrap_or(&scene.places.control).refuse(no_start(&scene.held, solver))
        }
        // All that is left to do in certified digits was done.
        Error::OutOfRange { quantity, log10 } => scene.places.complaint_about_profile(Error::Domain {
            quantity,
            value: format!("10^{log10:.6}"),
            requirement: "within the range of f64, where the search for states begins: take units of length in which the \
                          contact is nearer to 1",
        }),
        error => scene.places.complaint(error),
    }
}

/// Why a path cannot start at its first way point.
fn no_start(held: &Held, solver: &Solver<'_>) -> String {
    let (quantity, first) = (held.by.quantity(), &held.path[0]);
    let apart = first.is_negative() || first.is_zero();
    match held.start {
        Start::Detached => {
            let touch = solver.admissibility().and_then(|admissibility| admissibility.first_touch());
            let place = touch.map_or_else(String::new, |[radius, height]| {
                format!(
                    "; they first touch at the indentation depth {height:.6e} m, on a ring of radius {radius:.6e} m"
                )
            });
            format!("the path cannot start there: the surfaces are not apart at {quantity} = {first}{place}")
        }
        _ if apart => format!(
            "the path cannot start there: no stable equilibrium at {quantity} = {first}; where the surfaces are apart, \
             start = \"detached\""
        ),
        _ => format!("the path cannot start there: no stable equilibrium at {quantity} = {first}"),
    }
}

/// A scene in the arithmetic that it asks for.
enum Solver<'s> {
    Double(Double<'s>),
    Certified(Box<Certified<'s>>),
}

impl<'s> Solver<'s> {
    fn new(scene: &'s Scene, tally: &Arc<Tally>) -> std::result::Result<Self, Error> {
        Ok(match scene.output.arithmetic {
            Arithmetic::Double => Solver::Double(Double::new(scene, tally)?),
            Arithmetic::Certified { digits } => Solver::Certified(Box::new(Certified::new(scene, digits, tally))),
        })
    }

    fn output(&self, scene: &Scene, want: Want, tally: &Arc<Tally>) -> std::result::Result<Solved, Error> {
        let law = if want.is_of_profile() { None } else { PowerLaw::of(scene)? };
        if let Some(output) = law.as_ref().map_or(Ok(None), |law| law.output(want))? {
            return Ok(output);
        }
        let output = match self {
            Solver::Double(double) => match double.output(want) {
                Err(Error::OutOfRange { .. }) => beyond::output(scene, want, tally),
                Ok(output) if beyond::lost_numbers(&output) => beyond::output(scene, want, tally),
                output => output,
            },
            Solver::Certified(certified) => certified.output(want),
        }?;
        match law {
            Some(law) if matches!(want, Want::Pressure | Want::Gap | Want::Displacement) => law.checked(output),
            _ => Ok(output),
        }
    }

    /// The contact in f64.
    fn rough(&self) -> std::result::Result<&Double<'s>, Error> {
        match self {
            Solver::Double(double) => Ok(double),
            Solver::Certified(certified) => certified.rough(),
        }
    }

    /// Which states are admissible; none where that cannot be had.
    fn admissibility(&self) -> Option<Arc<Admissibility<'static>>> {
        match self {
            Solver::Double(double) => Some(double.admissibility()),
            Solver::Certified(certified) => certified.admissibility().ok(),
        }
    }

    /// Refuses a range of contact radii for the proof of folds that begins where the profile has ended.
    fn check_range(&self, scene: &Scene) -> Result<()> {
        let Some(range) = &scene.output.range else { return Ok(()) };
        let rough = self.rough().map_err(|error| scene.places.complaint(error))?;
        let lower = &range.ends[0];
        match rough.contact().transform().outer_radius() {
            Some(outer) if lower.to_rational() >= outer => {
                let why =
                    format!("the range must begin within the profile, whose outer radius is {outer}, got {lower}");
                Err(range.place.refuse(why))
            }
            _ => Ok(()),
        }
    }

    /// The folds of the same contact in f64, as far as they are known already.
    fn folds(&self, contact: &Contact<f64>) -> std::result::Result<Folds<f64>, Error> {
        match self {
            Solver::Double(double) => double.folds().cloned(),
            Solver::Certified(certified) => states::polished(contact, certified.rough()?.folds()?),
        }
    }
}

/// What is being computed, on a terminal and when it takes long.
fn spinner(want: Want) -> ProgressBar {
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    bar.set_message(want.name());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
