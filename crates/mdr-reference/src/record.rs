//! A certified value with its question, condition and provenance.

use std::str::FromStr;

use crate::decimal::Decimal;
use crate::difficulty::Difficulty;
use crate::hexadecimal;
use crate::named::named;
use crate::text::excerpt;

/// The unit roundoff of a double, 2⁻⁵³.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

named! {
    /// The status of a value.
    #[non_exhaustive]
    pub enum Status {
        /// A number.
        Ok = "ok",
        /// No state satisfies the equations.
        NoEquilibrium = "no-equilibrium",
        /// The state is the fold itself.
        Fold = "fold",
        /// A number beyond the largest double.
        Overflow = "overflow",
        /// A number below the smallest normal double.
        Underflow = "underflow",
        /// An input is outside its domain.
        DomainError = "domain-error",
        /// The surfaces would interpenetrate outside the assumed simply connected contact.
        NotAdmissible = "not-admissible",
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
    /// Its name; docs/reference/README.md describes it.
    pub name: String,
    /// Whether it encloses the value, so that every digit of it is proved.
    pub rigorous: bool,
}

/// A certified value: the number lies within `rad` of `mid`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certified {
    /// The number correctly rounded to `digits` significant decimal digits, or exactly zero.
    pub mid: String,
    /// Half a unit of the last digit, even if the number has no more digits; 0 for an exact zero.
    pub rad: String,
    /// Significant decimal digits.
    pub digits: u32,
}

impl Certified {
    /// The first significant digits of the number, with an ellipsis where there are more.
    pub fn abridged(&self, digits: usize) -> String {
        let (mantissa, exponent) = self.mid.split_at(self.mid.find('e').unwrap_or(self.mid.len()));
        match mantissa.char_indices().nth(digits + 2) {
            Some((end, _)) => format!("{}…{exponent}", &mantissa[..end]),
            None => self.mid.clone(),
        }
    }
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
    /// The quantity: `contact_radius`, `indentation`, `force`, `kappa`, ….
    pub quantity: String,
    /// Its unit; `1` for a number without one.
    pub unit: String,
    /// The controlled quantity: `indentation`, `force` or `machine`; `None` if the question has no control.
    pub control: Option<String>,
    /// The status that a careful program reports in `f64`.
    pub status: Status,
    /// The number, if there is one.
    pub value: Option<Certified>,
    /// log₁₀ of the magnitude; `None` for zero and without a number.
    pub log10: Option<f64>,
    /// If the value is 0: the magnitude of the terms that cancel, relative to which errors are measured.
    pub scale: Option<String>,
    /// |d ln value/d ln input| for each input; relative to `scale` if the value is 0.
    pub condition: Vec<(String, f64)>,
    /// The difficulty of the question for `f64`.
    pub difficulty: Difficulty,
    /// At least two if there is a number, the first rigorous.
    pub methods: Vec<Method>,
    /// Steps of the derivations on which the value rests.
    pub proof: Vec<String>,
    /// Remarks for filters: `exact-zero`, `near-half`, `near-fold`, `si`, `extreme-scale`, ….
    pub flags: Vec<String>,
    /// Equations and literature.
    pub refs: Vec<String>,
}

impl Record {
    /// Whether the contact is a real one in SI units, such as the tip of a force microscope, a PDMS bead, the spatula of a gecko,
    /// a grain of glass or a wheel on a rail: published as the flag `si`, and for filters also `physical`.
    pub fn is_physical(&self) -> bool {
        self.flags.iter().any(|flag| flag == "si")
    }

    /// The text of an input.
    pub fn input(&self, name: &str) -> Option<&str> {
        self.inputs.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// The double nearest to an input; `None` if there is none with that name.
    pub fn input_f64(&self, name: &str) -> Option<f64> {
        self.input(name)?.parse().ok()
    }

    /// The value as a decimal.
    pub fn decimal(&self) -> Option<Decimal> {
        self.value.as_ref().and_then(|value| value.mid.parse().ok())
    }

    /// The bound of the difference between the number and [`Record::decimal`].
    pub(crate) fn radius(&self) -> Option<Decimal> {
        self.value.as_ref().and_then(|value| value.rad.parse().ok())
    }

    /// The nearest double; ±∞ or ±0 if the number is out of range, NaN if there is none.
    pub fn nearest(&self) -> f64 {
        self.decimal().map_or(f64::NAN, |value| value.nearest())
    }

    /// The value as the unevaluated sum of two doubles, the nearest one and the one nearest to the remainder: to 31
    /// digits if the magnitude is above 10⁻²⁹⁰. Below, the remainder is a subnormal double or 0, and at 10⁻³⁰⁸ only the
    /// nearest double is left. (±∞, 0) beyond the largest double, (NaN, 0) if there is no number.
    pub fn pair(&self) -> (f64, f64) {
        let Some(value) = self.decimal() else { return (f64::NAN, 0.0) };
        let high = value.nearest();
        let rest = Decimal::from_double(high).map_or(0.0, |high| (&value - &high).nearest());
        (high, rest)
    }

    /// The nearest double in hexadecimal, in the `%a` format of C; `None` if the number is not a normal double.
    pub fn hexadecimal(&self) -> Option<String> {
        (self.value.is_some() && matches!(self.status, Status::Ok | Status::Fold))
            .then(|| hexadecimal::write(self.nearest()))
    }

    /// The total condition Σ|d ln value/d ln input|: the effect of relative errors of one unit in the inputs; 0 if
    /// there is no number.
    ///
    /// An integer exponent n is excluded: no program rounds the 2 of a sphere, and the derivative with respect to n
    /// would depend on the unit of length.
    pub fn total_condition(&self) -> f64 {
        let counts = |name: &str| name != "n" || !self.has_whole(name);
        // Not `sum`, which gives −0 for an empty list.
        self.condition.iter().filter(|(name, _)| counts(name)).fold(0.0, |total, (_, condition)| total + condition)
    }

    /// Whether an input is an integer.
    fn has_whole(&self, name: &str) -> bool {
        self.input(name).and_then(|text| text.parse::<Decimal>().ok()).is_some_and(|value| value.is_whole())
    }

    /// A relative error that a good double-precision program can achieve: four roundings, 4u·max(1, condition).
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
