//! The values of flags: numbers as they were typed, checked against their domain, with messages that name the flag.

use std::io::IsTerminal;
use std::num::IntErrorKind;

use mdr::answer::{Notation, NumberStyle};
use mdr::prelude::{Arithmetic, Literal};
use mdr::scene::MAX_DIGITS;
use mdr_core::units::{NumberError, SiUnit};

use crate::error::{Failure, Result};

/// A flag and its value as typed.
#[derive(Clone, Copy)]
pub(crate) struct Flag<'a> {
    /// With its dashes.
    pub(crate) name: &'static str,
    /// The value as typed.
    pub(crate) text: &'a str,
}

impl<'a> Flag<'a> {
    pub(crate) fn new(name: &'static str, text: &'a str) -> Self {
        Flag { name, text }
    }

    /// A flag that may be left out.
    pub(crate) fn given(name: &'static str, text: &'a Option<String>) -> Option<Self> {
        text.as_deref().map(|text| Flag { name, text })
    }

    /// This value is refused.
    pub(crate) fn refuse(self, why: impl std::fmt::Display) -> Failure {
        Failure::flag(self.name, why, self.text)
    }

    /// An exact number in the unit of the flag, plain or with one of the same dimension: `0.3nm`.
    pub(crate) fn number(self, unit: SiUnit) -> Result<Literal> {
        unit.read(self.text).map_err(|error| match error {
            // The message repeats the value.
            NumberError::Dimension { .. } => Failure::refused(self.name, error),
            error => self.refuse(error),
        })
    }

    /// A positive number in the unit of the flag.
    pub(crate) fn positive(self, unit: SiUnit) -> Result<Literal> {
        self.require_positive(self.number(unit)?)
    }

    fn require_positive(self, value: Literal) -> Result<Literal> {
        let positive = !value.is_zero() && !value.is_negative();
        if positive { Ok(value) } else { Err(self.refuse("must be positive and finite")) }
    }

    /// A Poisson's ratio: within (−1, 1/2].
    pub(crate) fn poissons_ratio(self) -> Result<Literal> {
        let value = self.number(SiUnit::One)?;
        let above = value.compare(&Literal::from(-1)).is_gt();
        let within = above && "1/2".parse().is_ok_and(|half: Literal| value.compare(&half).is_le());
        if within { Ok(value) } else { Err(self.refuse("must be within (-1, 1/2]")) }
    }

    /// A whole number from `least` to `most`.
    pub(crate) fn whole(self, least: u32, most: u32) -> Result<u32> {
        let value = self.text.trim().parse().ok().filter(|value| (least..=most).contains(value));
        value.ok_or_else(|| self.refuse(format_args!("must be a whole number from {least} to {most}")))
    }

    /// A number of decimal digits.
    pub(crate) fn digits(self) -> Result<u32> {
        self.whole(1, MAX_DIGITS)
    }

    /// A seed: any whole number of 64 bits.
    pub(crate) fn seed(self) -> Result<u64> {
        self.text.trim().parse().map_err(|error: std::num::ParseIntError| {
            self.refuse(match error.kind() {
                IntErrorKind::PosOverflow => "must be below 2^64",
                _ => "must be a whole number, 0 or larger",
            })
        })
    }
}

/// `--digits D` or `--f64`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArithmeticFlags {
    /// Certified: D significant decimal digits, each proved, correctly rounded [default: 20]
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    digits: Option<String>,

    /// Hardware arithmetic instead: fast, accurate to 2 units in the last place
    #[arg(long)]
    f64: bool,
}

impl ArithmeticFlags {
    /// As given, if one is.
    pub(crate) fn given(&self) -> Result<Option<Arithmetic>> {
        match (Flag::given("--digits", &self.digits), self.f64) {
            (Some(flag), true) => Err(flag.refuse("cannot be combined with --f64")),
            (Some(flag), false) => Ok(Some(Arithmetic::Certified { digits: flag.digits()? })),
            (None, true) => Ok(Some(Arithmetic::F64)),
            (None, false) => Ok(None),
        }
    }
}

/// How a table writes its numbers.
#[derive(Debug, clap::Args)]
pub(crate) struct StyleFlags {
    /// Units of tables in place of SI units, such as nm,nN: m, N, Pa, J and N/m with prefixes
    #[arg(long, value_name = "UNITS")]
    units: Option<String>,

    /// Notation of tables; powers of a thousand on a terminal and with --units, else plain
    #[arg(long, value_parser = ["plain", "engineering", "scientific"])]
    notation: Option<String>,
}

impl StyleFlags {
    /// The writer of numbers. Other formats than tables are for programs, and their units are fixed.
    pub(crate) fn style(&self, has_units: bool) -> Result<NumberStyle> {
        let units = Flag::given("--units", &self.units);
        if let Some(flag) = units.filter(|_| !has_units) {
            return Err(flag.refuse("JSON and CSV for programs are in SI units; drop the flag or --format"));
        }
        let notation = match self.notation.as_deref() {
            Some("engineering") => Notation::Engineering,
            Some("scientific") => Notation::Scientific,
            None if units.is_some() || std::io::stdout().is_terminal() => Notation::Engineering,
            _ => Notation::Plain,
        };
        let units = units.map(|flag| flag.text.parse().map_err(|error| flag.refuse(error))).transpose()?;
        Ok(NumberStyle { notation, units: units.unwrap_or_default() })
    }
}

/// The known name that is most like one that is not known, and whether it is a likely slip; for "did you mean".
pub(crate) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<(&'a str, bool)> {
    /// Names that share so much are meant for each other.
    const ALIKE: f64 = 0.6;
    /// A longer name is no slip, and the distance takes memory as the product of the lengths.
    const LONGEST: usize = 100;
    let name = if name.len() > LONGEST { "" } else { name };
    let likeness = |known: &str| strsim::normalized_damerau_levenshtein(name, known);
    let best = known.into_iter().max_by(|one, other| likeness(one).total_cmp(&likeness(other)))?;
    Some((best, likeness(best) >= ALIKE))
}
