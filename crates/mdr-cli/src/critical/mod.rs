//! `mdr critical`: the critical state of a power-law contact.

mod render;

use clap::{Args, ValueEnum};
use mdr::critical::PowerLaw;
use mdr::prelude::{Body, Control, Elasticity, Literal};

use crate::error::{Failure, Result};
use crate::flags::{ArithmeticFlags, Flag};
use crate::output::{Format, Output};

const EXAMPLES: &str = "\
Examples:
  The JKR sphere of 1 cm radius, f = r²/2R, pulled off under a dead load (-3/2 pi w R):
    mdr critical --n 2 --c 50 --e-star 1e6 --work 0.05 --control force

  50 certified digits of a sharp tip that jumps to complete contact, for another program:
    mdr critical --n 0.25 --c 1e-6 --e-star 1e9 --work 0.05 --digits 50 --format json

  A steel cone on rubber, given as two bodies, in hardware arithmetic:
    mdr critical --n 1 --c 0.1 --e1 1e6 --nu1 0.5 --e2 2.1e11 --nu2 0.3 --work 0.05 --f64

  All instabilities on a machine of finite stiffness (N/m):
    mdr critical --n 0.6 --c 2.4829 --e-star 1 --work 1 --control machine --stiffness 1

Numbers are exact as typed: 0.3, 1e-9 or 1/3. Quantities are in SI units; so is C, in m^(1-n).
JSON: schema mdr.critical/1; numbers are strings in certified answers and JSON numbers with --f64.
Exit status: 0 answered, 2 bad input.";

/// Critical contact radius, indentation depth and force of the profile f(r) = C r^n.
///
/// The state at which the equilibrium is lost: by pull-off when n > 1/2, by a jump to complete contact when n < 1/2.
/// At n = 1/2 there is no such state but a threshold of C. Every certified digit is proved.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Critical {
    /// Exponent n > 0 of the profile f(r) = C r^n
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    n: String,

    /// Coefficient C > 0 of the profile, in m^(1-n)
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    c: String,

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
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    work: String,

    /// What is held while the contact finds its radius
    #[arg(long, value_enum, default_value_t = ControlKind::Indentation)]
    control: ControlKind,

    /// Stiffness k > 0 of the machine, in N/m; with --control machine
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    stiffness: Option<String>,

    #[command(flatten)]
    arithmetic: ArithmeticFlags,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
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
    /// Answers on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<()> {
        let answer = mdr::critical(&self.law()?, self.arithmetic.chosen()?).map_err(Failure::of_flag)?;
        render::write(&answer, self.format, out)
    }

    fn law(&self) -> Result<PowerLaw> {
        Ok(PowerLaw {
            n: Flag::new("--n", &self.n).positive()?,
            c: Flag::new("--c", &self.c).positive()?,
            elasticity: self.elasticity()?,
            work_of_adhesion: Flag::new("--work", &self.work).positive()?,
            control: self.controlled()?,
        })
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
