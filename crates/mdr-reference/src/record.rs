//! One certified value and all that is known about it.

use std::fmt;
use std::str::FromStr;

use crate::decimal::Decimal;
use crate::difficulty::Difficulty;
use crate::hexadecimal;
use crate::text::excerpt;

/// The unit roundoff of a double, 2⁻⁵³.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// How a number is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Status {
    /// A number.
    Ok,
    /// No state satisfies the equations.
    NoEquilibrium,
    /// The double root itself.
    Fold,
    /// A number beyond the largest double.
    Overflow,
    /// A number below the smallest normal double.
    Underflow,
    /// The question is outside its domain.
    DomainError,
    /// The assumed simply connected contact would interpenetrate.
    NotAdmissible,
}

impl Status {
    /// All of them.
    pub const ALL: [Status; 7] = [
        Status::Ok,
        Status::NoEquilibrium,
        Status::Fold,
        Status::Overflow,
        Status::Underflow,
        Status::DomainError,
        Status::NotAdmissible,
    ];

    /// As it stands in the records.
    pub const fn name(self) -> &'static str {
        match self {
            Status::Ok => "ok",
            Status::NoEquilibrium => "no-equilibrium",
            Status::Fold => "fold",
            Status::Overflow => "overflow",
            Status::Underflow => "underflow",
            Status::DomainError => "domain-error",
            Status::NotAdmissible => "not-admissible",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Status {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Status::ALL.into_iter().find(|status| status.name() == text);
        let names = || Status::ALL.map(Status::name).join(", ");
        found.ok_or_else(|| format!("status must be one of {}, got {}", names(), excerpt(text)))
    }
}

/// A way in which a value was computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Method {
    /// Its name; docs/reference/README.md says what it does.
    pub name: String,
    /// Whether it encloses the value, so that every digit of it is proved.
    pub rigorous: bool,
}

/// A certified value: the number lies within `rad` of `mid`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certified {
    /// The number correctly rounded to `digits` significant decimal digits, or exactly zero.
    pub mid: String,
    /// Half a unit of the last digit, also where the number has no more digits; 0 for an exact zero.
    pub rad: String,
    /// Significant decimal digits.
    pub digits: u32,
}

/// A certified value of one quantity for one set of inputs, or the certain absence of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Stable and readable: family/case/control/quantity.
    pub id: String,
    /// The release of the records in which this value was last changed.
    pub release: u32,
    /// The kind of profile, as in scenes: `power`, `sphere`, `wavy-paraboloid`, ….
    pub profile: String,
    /// The question; docs/reference/README.md lists the formula of each.
    pub formula: String,
    /// Names and exact decimals, in SI units.
    pub inputs: Vec<(String, String)>,
    /// What is asked for: `contact_radius`, `indentation`, `force`, `kappa`, ….
    pub quantity: String,
    /// Its unit; `1` for a number without one.
    pub unit: String,
    /// What is controlled: `indentation`, `force` or `machine`; none where the question knows no control.
    pub control: Option<String>,
    /// What a careful program should say in `f64`.
    pub status: Status,
    /// The number; none where there is none.
    pub value: Option<Certified>,
    /// log₁₀ of the magnitude; none for zero and where there is no number.
    pub log10: Option<f64>,
    /// Where the value is 0: the size of the terms that cancel, to which errors are compared.
    pub scale: Option<String>,
    /// |d ln value/d ln input| for each input; relative to `scale` where the value is 0.
    pub condition: Vec<(String, f64)>,
    /// How hard the question is for `f64`.
    pub difficulty: Difficulty,
    /// At least two where there is a number, the first rigorous.
    pub methods: Vec<Method>,
    /// Steps of the derivations on which the value rests.
    pub proof: Vec<String>,
    /// Remarks for filters: `exact-zero`, `near-half`, `near-fold`, `si`, `extreme-scale`, ….
    pub flags: Vec<String>,
    /// Equations and literature.
    pub refs: Vec<String>,
}

impl Record {
    /// The text of an input.
    pub fn input(&self, name: &str) -> Option<&str> {
        self.inputs.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// The double nearest to an input; none where there is none of that name.
    pub fn input_f64(&self, name: &str) -> Option<f64> {
        self.input(name)?.parse().ok()
    }

    /// The value as a decimal.
    pub fn decimal(&self) -> Option<Decimal> {
        self.value.as_ref().and_then(|value| value.mid.parse().ok())
    }

    /// How far the number may be from [`Record::decimal`].
    pub(crate) fn radius(&self) -> Option<Decimal> {
        self.value.as_ref().and_then(|value| value.rad.parse().ok())
    }

    /// The nearest double; ±∞ or ±0 where the number is out of range, NaN where there is none.
    pub fn nearest(&self) -> f64 {
        self.decimal().map_or(f64::NAN, |value| value.nearest())
    }

    /// The value as the unevaluated sum of two doubles, the nearest one and the one nearest to the rest: to 31 digits where
    /// the magnitude is above 10⁻²⁹⁰. Below, the rest is a subnormal double or 0, and the nearest double is all there is at
    /// 10⁻³⁰⁸. (±∞, 0) beyond the largest double, (NaN, 0) where there is no number.
    pub fn pair(&self) -> (f64, f64) {
        let Some(value) = self.decimal() else { return (f64::NAN, 0.0) };
        let high = value.nearest();
        let rest = Decimal::from_double(high).map_or(0.0, |high| (&value - &high).nearest());
        (high, rest)
    }

    /// The nearest double in hexadecimal, as C writes it with `%a`; none where the number is no normal double.
    pub fn hexadecimal(&self) -> Option<String> {
        (self.value.is_some() && matches!(self.status, Status::Ok | Status::Fold))
            .then(|| hexadecimal::write(self.nearest()))
    }

    /// The total condition Σ|d ln value/d ln input|: what relative errors of one unit in the inputs cost; 0 where there
    /// is no number.
    ///
    /// An exponent n that is a whole number has no part in it: no program rounds the 2 of a sphere, and the derivative
    /// with respect to n would depend on the unit of length.
    pub fn total_condition(&self) -> f64 {
        let counts = |name: &str| name != "n" || !self.has_whole(name);
        // Not `sum`, which gives −0 for an empty list.
        self.condition.iter().filter(|(name, _)| counts(name)).fold(0.0, |total, (_, condition)| total + condition)
    }

    /// Whether an input is a whole number.
    fn has_whole(&self, name: &str) -> bool {
        self.input(name).and_then(|text| text.parse::<Decimal>().ok()).is_some_and(|value| value.is_whole())
    }

    /// A relative error that a good double-precision program can keep: four roundings, 4u·max(1, condition).
    ///
    /// ```
    /// use approx::assert_relative_eq;
    /// let record = mdr_reference::record("critical/jkr-unit/force/force").expect("a record");
    /// let pull_off = -1.5 * std::f64::consts::PI; // −(3/2)πwR with w = R = 1
    /// assert_relative_eq!(pull_off, record.nearest(), max_relative = record.tolerance());
    /// ```
    pub fn tolerance(&self) -> f64 {
        4.0 * UNIT_ROUNDOFF * self.total_condition().max(1.0)
    }
}
