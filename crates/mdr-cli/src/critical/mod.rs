//! `mdr critical`: the critical state of a power-law contact.

mod batch;
mod render;
mod shape;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use mdr::critical::PowerLaw;
use mdr::prelude::{Arithmetic, Body, Control, Elasticity, Literal};
use mdr_core::units::SiUnit;

use crate::error::{Failure, Result};
use crate::flags::{ArithmeticFlags, Flag, StyleFlags};
use crate::output::{Format, Output};

/// Critical contact radius, indentation depth and force of the profile f(r) = C r^n.
///
/// The state at which the equilibrium is lost: by pull-off when n > 1/2, by a jump to complete contact when n < 1/2.
/// At n = 1/2 there is no such state but a threshold of C. Every certified digit is proved.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/critical.txt"))]
pub(crate) struct Critical {
    #[command(flatten)]
    shape: shape::ShapeFlags,

    /// Effective modulus E* > 0, in Pa or with a unit (1GPa); or give two bodies
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

    /// Work of adhesion w > 0 per area, in J/m² or with a unit (50mJ/m^2): the full work of separation
    #[arg(long, value_name = "W", allow_hyphen_values = true, required_unless_present = "batch")]
    work: Option<String>,

    /// Controlled quantity while the contact finds its radius [default: indentation]
    #[arg(long, value_enum)]
    control: Option<ControlKind>,

    /// Stiffness k > 0 of the machine, in N/m or with a unit (40mN/m); with --control machine
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
        let arithmetic = self.arithmetic.given()?.unwrap_or_default();
        let style = self.style.style(self.format == Format::Table && self.batch.is_none())?;
        if let Some(file) = &self.batch {
            return batch::answer(file, arithmetic, out);
        }
        let laws = self.laws(arithmetic)?;
        let range = Flag::given("--range-of-adhesion", &self.range_of_adhesion)
            .map(|flag| flag.positive(SiUnit::Metre))
            .transpose()?;
        let answer = |law: &PowerLaw| {
            let answer = mdr::critical(law, arithmetic)?;
            range.as_ref().map_or(Ok(answer.clone()), |range| answer.with_range(range))
        };
        let answers = laws.iter().map(answer).collect::<mdr::Result<Vec<_>>>().map_err(Failure::of_flag)?;
        let sibling = match (self.format, &answers[..]) {
            (Format::Table, [one]) => one.sibling().map_err(Failure::of_flag)?,
            _ => None,
        };
        render::write(&answers, sibling.as_ref(), self.control.is_none(), self.format, &style, out).map(|()| true)
    }

    fn laws(&self, arithmetic: Arithmetic) -> Result<Vec<PowerLaw>> {
        let work = self.work.as_deref().unwrap_or_default();
        let work_of_adhesion = Flag::new("--work", work).positive(SiUnit::JoulePerSquareMetre)?;
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
            .map(|(name, text)| Flag::given(name, text).ok_or(name));
        let given = bodies.iter().flatten().next();
        match (&self.e_star, given) {
            (Some(e_star), None) => Ok(Elasticity::Effective(Flag::new("--e-star", e_star).positive(SiUnit::Pascal)?)),
            (Some(e_star), Some(body)) => Err(Flag::new("--e-star", e_star)
                .refuse(format!("give E* or two bodies, not both (got also {} {})", body.name, body.text))),
            (None, None) => Err(Failure::missing("--e-star", "give E*, or two bodies with --e1 --nu1 --e2 --nu2")),
            (None, Some(body)) => {
                let given = format!("two bodies need --e1 --nu1 --e2 --nu2 ({} {} is given)", body.name, body.text);
                let [e1, nu1, e2, nu2] = bodies.map(|flag| flag.map_err(|name| Failure::missing(name, &given)));
                let body = |e: Flag<'_>, nu: Flag<'_>| -> Result<Body<Literal>> {
                    Ok(Body { youngs_modulus: e.positive(SiUnit::Pascal)?, poissons_ratio: nu.poissons_ratio()? })
                };
                Ok(Elasticity::bodies(body(e1?, nu1?)?, body(e2?, nu2?)?))
            }
        }
    }

    fn controlled(&self) -> Result<Control<Literal>> {
        match (self.control.unwrap_or(ControlKind::Indentation), Flag::given("--stiffness", &self.stiffness)) {
            (ControlKind::Machine, Some(flag)) => {
                Ok(Control::Machine { stiffness: flag.positive(SiUnit::NewtonPerMetre)? })
            }
            (ControlKind::Machine, None) => {
                Err(Failure::missing("--stiffness", "--control machine needs the stiffness of the machine, in N/m"))
            }
            (_, Some(flag)) => Err(flag.refuse("only with --control machine")),
            (ControlKind::Indentation, None) => Ok(Control::Indentation),
            (ControlKind::Force, None) => Ok(Control::Force),
        }
    }
}
