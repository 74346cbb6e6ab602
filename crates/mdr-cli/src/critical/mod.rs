//! `mdr critical`: the critical state of a power-law contact.

mod batch;
mod render;
mod shape;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use mdr::critical::{CriticalAnswer, PowerLaw};
use mdr::prelude::{Arithmetic, Body, Control, Elasticity, Literal};

use crate::error::{Failure, Result};
use crate::flags::{ArithmeticFlags, Flag, StyleFlags};
use crate::output::{Format, Output};

const EXAMPLES: &str = "\
Examples:
  A sphere of 1 cm radius in JKR's theory, f = r²/2R, pulled off under a dead load:
    mdr critical --sphere 0.01 --e-star 1e6 --work 0.05 --control force

  The same as a power law, f = C r^n:
    mdr critical --n 2 --c 50 --e-star 1e6 --work 0.05 --control force

  A cone of 85 degrees half angle; five exponents at once:
    mdr critical --cone 85 --e-star 1e6 --work 0.05
    mdr critical --n 0.5:1.5:0.25 --c 1 --e-star 1e6 --work 0.05

  50 certified digits of a sharp tip that jumps to complete contact, for another program:
    mdr critical --n 0.25 --c 1e-6 --e-star 1e9 --work 0.05 --digits 50 --format json

  A steel cone on rubber, given as two bodies, in hardware arithmetic:
    mdr critical --n 1 --c 0.1 --e1 1e6 --nu1 0.5 --e2 2.1e11 --nu2 0.3 --work 0.05 --f64

  Does the theory hold for a tip of 10 nm whose adhesion has a range of 0.3 nm?
    mdr critical --sphere 1e-8 --e-star 5e9 --work 0.05 --control force --range-of-adhesion 0.3nm

  All instabilities on a machine of finite stiffness (N/m):
    mdr critical --n 0.6 --c 2.4829 --e-star 1 --work 1 --control machine --stiffness 1

  The pull-off of a force microscope's tip of 20 nm, in nanometres and nanonewtons:
    mdr critical --sphere 20e-9 --e-star 1e9 --work 0.05 --control force --units nm,nN

  Many questions in hardware arithmetic, CSV or JSON lines in and the same out:
    mdr critical --batch examples/questions.csv --f64

A batch has the columns (or keys) n, c, e_star, work and, where needed, control and stiffness.
Numbers are exact as typed: 0.3, 1e-9 or 1/3. Quantities are in SI units; so is C, in m^(1-n).
JSON: schema mdr.critical/1; numbers are strings in certified answers and JSON numbers with --f64.
Exit status: 0 answered, 1 a line of a batch has no answer, 2 bad input.";

/// Critical contact radius, indentation depth and force of the profile f(r) = C r^n.
///
/// The state at which the equilibrium is lost: by pull-off when n > 1/2, by a jump to complete contact when n < 1/2.
/// At n = 1/2 there is no such state but a threshold of C. Every certified digit is proved.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Critical {
    #[command(flatten)]
    shape: shape::ShapeFlags,

    /// Effective modulus E* > 0, in Pa; or give two bodies
    #[arg(long, value_name = "E*", allow_hyphen_values = true)]
    e_star: Option<String>,

    /// Young's modulus of the first body, in Pa
    #[arg(long, value_name = "E1", allow_hyphen_values = true)]
    e1: Option<String>,

    /// Poisson's ratio of the first body, within (-1, 1/2]
    #[arg(long, value_name = "NU1", allow_hyphen_values = true)]
    nu1: Option<String>,

    /// Young's modulus of the second body, in Pa
    #[arg(long, value_name = "E2", allow_hyphen_values = true)]
    e2: Option<String>,

    /// Poisson's ratio of the second body, within (-1, 1/2]
    #[arg(long, value_name = "NU2", allow_hyphen_values = true)]
    nu2: Option<String>,

    /// Work of adhesion w > 0 per area, in J/m² (the full work of separation)
    #[arg(long, value_name = "W", allow_hyphen_values = true, required_unless_present = "batch")]
    work: Option<String>,

    /// What is held while the contact finds its radius
    #[arg(long, value_enum, default_value_t = ControlKind::Indentation)]
    control: ControlKind,

    /// Stiffness k > 0 of the machine, in N/m; with --control machine
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    stiffness: Option<String>,

    /// Range z0 > 0 of the adhesion, in m or with a unit (0.3nm): says whether the theory holds
    #[arg(long, value_name = "Z0", allow_hyphen_values = true, conflicts_with = "batch")]
    range_of_adhesion: Option<String>,

    #[command(flatten)]
    arithmetic: ArithmeticFlags,

    /// Answer the questions of a file, CSV or JSON lines, one a line; - is standard input
    #[arg(long, value_name = "FILE", conflicts_with_all = ["n", "c", "sphere", "paraboloid", "cone", "work", "e_star", "e1"])]
    batch: Option<PathBuf>,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,

    #[command(flatten)]
    style: StyleFlags,
}

/// The controlled quantity, by its name on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ControlKind {
    /// The indentation depth d: fixed grips
    Indentation,
    /// The normal force F: a dead load
    Force,
    /// The position d + F/k of a machine of stiffness k
    Machine,
}

impl Critical {
    /// Answers on `out`; whether every question has an answer.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        let arithmetic = self.arithmetic.chosen()?;
        let style = self.style.style(self.format == Format::Table && self.batch.is_none())?;
        if let Some(file) = &self.batch {
            return batch::answer(file, arithmetic, out);
        }
        let laws = self.laws(arithmetic)?;
        let range = self
            .range_of_adhesion
            .as_deref()
            .map(|text| Flag::new("--range-of-adhesion", text).length())
            .transpose()?;
        let answer = |law: &PowerLaw| {
            let answer = mdr::critical(law, arithmetic).map_err(Failure::of_flag)?;
            match &range {
                Some(range) => answer.with_range(range).map_err(Failure::of_flag),
                None => Ok(answer),
            }
        };
        let answers = laws.iter().map(answer).collect::<Result<Vec<_>>>()?;
        match &answers[..] {
            [one] => render::write(one, self.sibling(one)?.as_ref(), self.format, &style, out)?,
            all => render::write_all(all, self.format, &style, out)?,
        }
        Ok(true)
    }

    /// The same under the other of the two controls of a test by hand: fixed grips and a dead load.
    fn sibling(&self, answer: &CriticalAnswer) -> Result<Option<CriticalAnswer>> {
        let control = match answer.law.control {
            Control::Indentation => Control::Force,
            Control::Force => Control::Indentation,
            Control::Machine { .. } => return Ok(None),
        };
        if self.format != Format::Table || answer.state.is_none() {
            return Ok(None);
        }
        let law = PowerLaw { control, ..answer.law.clone() };
        mdr::critical(&law, answer.arithmetic).map(Some).map_err(Failure::of_flag)
    }

    fn laws(&self, arithmetic: Arithmetic) -> Result<Vec<PowerLaw>> {
        let work = self.work.as_deref().unwrap_or_default();
        let work_of_adhesion = Flag::new("--work", work).positive()?;
        let (elasticity, control) = (self.elasticity()?, self.controlled()?);
        let law = |[n, c]: [Literal; 2]| PowerLaw {
            n,
            c,
            elasticity: elasticity.clone(),
            work_of_adhesion: work_of_adhesion.clone(),
            control: control.clone(),
        };
        Ok(self.shape.laws(arithmetic)?.into_iter().map(law).collect())
    }

    fn elasticity(&self) -> Result<Elasticity> {
        let bodies = [("--e1", &self.e1), ("--nu1", &self.nu1), ("--e2", &self.e2), ("--nu2", &self.nu2)]
            .map(|(name, text)| text.as_deref().map(|text| Flag::new(name, text)).ok_or(name));
        let given = bodies.iter().flatten().next();
        match (&self.e_star, given) {
            (Some(e_star), None) => Ok(Elasticity::Effective(Flag::new("--e-star", e_star).positive()?)),
            (Some(e_star), Some(body)) => Err(Flag::new("--e-star", e_star)
                .refuse(format!("give E* or two bodies, not both ({} {} is given, too)", body.name, body.text))),
            (None, None) => Err(Failure::missing("--e-star", "give E*, or two bodies with --e1 --nu1 --e2 --nu2")),
            (None, Some(body)) => {
                let given = format!("two bodies need --e1 --nu1 --e2 --nu2 ({} {} is given)", body.name, body.text);
                let [e1, nu1, e2, nu2] = bodies.map(|flag| flag.map_err(|name| Failure::missing(name, &given)));
                let body = |e: Flag<'_>, nu: Flag<'_>| -> Result<Body<Literal>> {
                    Ok(Body { youngs_modulus: e.positive()?, poissons_ratio: nu.poissons_ratio()? })
                };
                Ok(Elasticity::bodies(body(e1?, nu1?)?, body(e2?, nu2?)?))
            }
        }
    }

    fn controlled(&self) -> Result<Control<Literal>> {
        match (self.control, self.stiffness.as_deref().map(|text| Flag::new("--stiffness", text))) {
            (ControlKind::Machine, Some(flag)) => Ok(Control::Machine { stiffness: flag.positive()? }),
            (ControlKind::Machine, None) => {
                Err(Failure::missing("--stiffness", "--control machine needs the stiffness of the machine, in N/m"))
            }
            (_, Some(flag)) => Err(flag.refuse("only with --control machine")),
            (ControlKind::Indentation, None) => Ok(Control::Indentation),
            (ControlKind::Force, None) => Ok(Control::Force),
        }
    }
}
