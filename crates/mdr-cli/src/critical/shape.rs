//! Which power law: by exponent and coefficient, several at once, or by the name of a body.

use clap::Args;
use mdr::critical::PowerLaw;
use mdr::prelude::{Arithmetic, Literal};
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use crate::error::{Failure, Result};
use crate::flags::Flag;

/// The flags of a profile.
#[derive(Debug, Args)]
pub(super) struct ShapeFlags {
    /// Exponent n > 0 of the profile f(r) = C r^n; several as 1,2,3 or FIRST:LAST:STEP
    #[arg(long, value_name = "N", allow_hyphen_values = true, required_unless_present_any = ["sphere", "paraboloid", "cone", "batch"], conflicts_with_all = ["sphere", "paraboloid", "cone"])]
    n: Option<String>,

    /// Coefficient C > 0 of the profile, in m^(1-n)
    #[arg(long, value_name = "C", allow_hyphen_values = true, required_unless_present_any = ["sphere", "paraboloid", "cone", "batch"], conflicts_with_all = ["sphere", "paraboloid", "cone"])]
    c: Option<String>,

    /// A sphere of radius R, in m or with a unit (5um), as in JKR's theory, f = r²/2R (for the true sphere write a scene)
    #[arg(long, value_name = "R", allow_hyphen_values = true, conflicts_with_all = ["paraboloid", "cone"])]
    sphere: Option<String>,

    /// A paraboloid of radius of curvature R, in m or with a unit, f = r²/2R
    #[arg(long, value_name = "R", allow_hyphen_values = true, conflicts_with = "cone")]
    paraboloid: Option<String>,

    /// A cone of half angle DEG at its apex, f = r cot(DEG)
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    cone: Option<String>,
}

/// So many exponents at once.
const MOST: usize = 100_000;

impl ShapeFlags {
    /// n and C of every power law.
    pub(super) fn laws(&self, arithmetic: Arithmetic) -> Result<Vec<[Literal; 2]>> {
        let round = [("--sphere", &self.sphere), ("--paraboloid", &self.paraboloid)];
        if let Some((name, Some(radius))) = round.into_iter().find(|(_, radius)| radius.is_some()) {
            let flag = Flag::new(name, radius);
            let law = PowerLaw::paraboloid(&flag.positive(SiUnit::Metre)?);
            return law.map(|law| vec![law]).ok_or_else(|| flag.refuse("has too many digits"));
        }
        if let Some(angle) = &self.cone {
            let flag = Flag::new("--cone", angle);
            let degrees = flag.positive(SiUnit::Degree)?;
            if degrees.compare(&Literal::from(90)).is_ge() {
                return Err(flag.refuse("must be below 90 degrees"));
            }
            let law = PowerLaw::cone(&degrees, arithmetic);
            let why = "the slope of this cone cannot be rounded";
            return law.map(|law| vec![law]).ok_or_else(|| Failure::refused(flag.name, why));
        }
        let c = Flag::new("--c", self.c.as_deref().unwrap_or_default()).positive(SiUnit::Coefficient)?;
        let exponents = exponents(Flag::new("--n", self.n.as_deref().unwrap_or_default()))?;
        Ok(exponents.into_iter().map(|n| [n, c.clone()]).collect())
    }
}

/// One exponent, a list of them, or a range with its step, exactly.
fn exponents(flag: Flag<'_>) -> Result<Vec<Literal>> {
    let is_whole = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    if let Some((first, last)) = flag.text.split_once(',')
        && is_whole(first)
        && is_whole(last)
    {
        let [one, two] = [format!("{first}.{last}"), format!("{first}.0,{last}")];
        let why = "not a number, and two whole numbers may be one with a decimal comma";
        return Err(flag.refuse(format!("{why}: write {}, or {} for two", excerpt(&one), excerpt(&two))));
    }
    let mut all = Vec::new();
    for part in flag.text.split(',') {
        let ends: Vec<&str> = part.split(':').collect();
        match ends[..] {
            [one] => all.push(Flag::new(flag.name, one).positive(SiUnit::One)?),
            [first, last, step] => {
                let part = |name: &str, text: &str| {
                    Flag::new(flag.name, text).positive(SiUnit::One).map_err(|failure| match failure {
                        Failure::Flag { why, .. } => {
                            flag.refuse(format!("the {name} of the range {why}, it is {}", excerpt(text)))
                        }
                        other => other,
                    })
                };
                let [first, last, step] = [part("first", first)?, part("last", last)?, part("step", step)?];
                let (mut n, last, step) = (first.to_rational(), last.to_rational(), step.to_rational());
                while n <= last {
                    if all.len() == MOST {
                        return Err(flag.refuse(format!("at most {MOST} exponents")));
                    }
                    all.push(
                        mdr::scene::decimal(&n)
                            .ok_or_else(|| flag.refuse("a number of the range has too many digits"))?,
                    );
                    n += &step;
                }
            }
            _ => return Err(flag.refuse("a range is FIRST:LAST:STEP")),
        }
    }
    if all.is_empty() { Err(flag.refuse("an empty range")) } else { Ok(all) }
}
