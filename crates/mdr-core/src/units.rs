//! The units of numbers: a key has one unit of the SI, and a text may give another of its dimension, as in `5 um`. Prefixes are powers
//! of ten, applied to the exact decimal, so that `5 um` is `5e-6` in every digit.

use std::fmt;

use crate::number::{Literal, LiteralError};
use crate::text::excerpt;

/// The unit of the SI in which the number of a key is meant.
///
/// ```
/// use mdr_core::units::SiUnit;
/// assert_eq!(SiUnit::Metre.read("5 um")?.to_string(), "5e-6");
/// assert_eq!(SiUnit::Metre.read("1/3 µm")?.to_string(), "1/3000000");
/// assert_eq!(SiUnit::JoulePerSquareMetre.read("50mJ/m^2")?.to_string(), "50e-3");
/// assert_eq!(SiUnit::Metre.read("5e-6")?.to_string(), "5e-6");
/// let refused = SiUnit::NewtonPerMetre.read("0.3 nm").unwrap_err().of("stiffness");
/// assert!(refused.starts_with("stiffness is in N/m; got \"0.3 nm\""));
/// # Ok::<(), mdr_core::units::NumberError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SiUnit {
    /// A pure number, such as a slope.
    One,
    /// m, of radii, depths and heights.
    Metre,
    /// N, of forces.
    Newton,
    /// Pa, of moduli.
    Pascal,
    /// J, of energies.
    Joule,
    /// N/m, of the stiffness of a machine.
    NewtonPerMetre,
    /// Pa/m, of the modulus of a Winkler foundation and of stiffnesses per area.
    PascalPerMetre,
    /// J/m², of the work of adhesion.
    JoulePerSquareMetre,
    /// Degrees of an angle.
    Degree,
    /// m^(1−n), of the coefficient C of a power law: always without a unit.
    Coefficient,
    /// Some unit of the SI, of a parameter of a formula.
    Unstated,
}

/// Powers of newton, metre and degree.
type Dimension = [i64; 3];

/// Units that take prefixes.
const BASES: [(&str, Dimension); 4] = [("m", [0, 1, 0]), ("N", [1, 0, 0]), ("J", [1, 1, 0]), ("Pa", [1, -2, 0])];

/// Units without prefixes, each 10^k of the SI unit of its dimension.
const PLAIN: [(&str, Dimension, i64); 9] = [
    ("\u{c5}", [0, 1, 0], -10),
    ("\u{212b}", [0, 1, 0], -10),
    ("A\u{30a}", [0, 1, 0], -10),
    ("angstrom", [0, 1, 0], -10),
    ("Angstrom", [0, 1, 0], -10),
    ("°", [0, 0, 1], 0),
    ("deg", [0, 0, 1], 0),
    ("degree", [0, 0, 1], 0),
    ("degrees", [0, 0, 1], 0),
];

/// Prefixes and their powers of ten; µ in both of its code points, and as `u`.
const PREFIXES: [(&str, i64); 26] = [
    ("q", -30),
    ("r", -27),
    ("y", -24),
    ("z", -21),
    ("a", -18),
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("", 0),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("P", 15),
    ("E", 18),
    ("Z", 21),
    ("Y", 24),
    ("R", 27),
    ("Q", 30),
];

/// 10^power of the SI unit of a dimension.
#[derive(Clone, Copy)]
struct Scale {
    dimension: Dimension,
    power: i64,
}

impl Scale {
    /// The scale of a product or quotient of powers of units: `nm`, `mJ/m^2`, `N/mm²`, `mJ m-2`.
    fn of(unit: &str) -> Option<Scale> {
        let mut whole = Scale { dimension: [0; 3], power: 0 };
        for (index, part) in unit.split('/').enumerate() {
            let sign = if index == 0 { 1 } else { -1 };
            let mut factors = part.split(['*', '·', ' ']).filter(|factor| !factor.is_empty()).peekable();
            factors.peek()?;
            for factor in factors {
                let (scale, exponent) = Scale::of_factor(factor)?;
                whole.power += sign * exponent * scale.power;
                for (sum, own) in whole.dimension.iter_mut().zip(scale.dimension) {
                    *sum += sign * exponent * own;
                }
            }
        }
        Some(whole)
    }

    /// The scale of one unit, and its exponent: `m`, `m2`, `m^2`, `m²`, `m^-2`.
    fn of_factor(factor: &str) -> Option<(Scale, i64)> {
        let end = factor.find(|c: char| c.is_ascii_digit() || "^-²³".contains(c)).unwrap_or(factor.len());
        let (name, exponent) = factor.split_at(end);
        let exponent = match exponent {
            "" => 1,
            "²" => 2,
            "³" => 3,
            digits => digits.strip_prefix('^').unwrap_or(digits).parse().ok().filter(|k: &i64| (-9..=9).contains(k))?,
        };
        let plain = |(base, dimension, power): &(&str, Dimension, i64)| {
            (name == *base).then_some(Scale { dimension: *dimension, power: *power })
        };
        let prefixed = |(base, dimension): &(&str, Dimension)| {
            let prefix = name.strip_suffix(base)?;
            let (_, power) = PREFIXES.iter().find(|(known, _)| *known == prefix)?;
            Some(Scale { dimension: *dimension, power: *power })
        };
        let found = BASES.iter().find_map(prefixed).or_else(|| PLAIN.iter().find_map(plain));
        found.map(|scale| (scale, exponent))
    }
}

impl SiUnit {
    /// As tables and spreadsheets write it; empty for a pure number.
    pub fn symbol(self) -> &'static str {
        match self {
            SiUnit::One | SiUnit::Unstated => "",
            SiUnit::Metre => "m",
            SiUnit::Newton => "N",
            SiUnit::Pascal => "Pa",
            SiUnit::Joule => "J",
            SiUnit::NewtonPerMetre => "N/m",
            SiUnit::PascalPerMetre => "Pa/m",
            SiUnit::JoulePerSquareMetre => "J/m²",
            SiUnit::Degree => "°",
            SiUnit::Coefficient => "m^(1-n)",
        }
    }

    /// The power of ten by which a `unit` of its dimension exceeds it; none of another dimension, or where the unit is unknown.
    pub fn power_of(self, unit: &str) -> Option<i64> {
        Scale::of(unit).filter(|scale| self.dimension() == Some(scale.dimension)).map(|scale| scale.power)
    }

    /// A number in this unit, from a text without a unit or with one of the same dimension.
    ///
    /// # Errors
    /// [`NumberError`] for what is no number, an unknown unit, and one of another dimension.
    pub fn read(self, text: &str) -> Result<Literal, NumberError> {
        let (number, unit) = split(text.trim());
        let scale = match unit {
            "" => return Ok(text.parse()?),
            unit => Scale::of(unit),
        };
        match scale {
            Some(scale) if self.takes(scale) => Ok(scaled(number, scale.power).parse()?),
            Some(_) => Err(NumberError::Dimension { unit: self, text: text.to_owned() }),
            None if matches!(self, SiUnit::One | SiUnit::Coefficient) => Ok(text.parse()?),
            None => Err(NumberError::Unknown { unit: self, name: unit.to_owned() }),
        }
    }

    fn dimension(self) -> Option<Dimension> {
        Some(match self {
            SiUnit::Metre => [0, 1, 0],
            SiUnit::Newton => [1, 0, 0],
            SiUnit::Pascal => [1, -2, 0],
            SiUnit::Joule => [1, 1, 0],
            SiUnit::NewtonPerMetre | SiUnit::JoulePerSquareMetre => [1, -1, 0],
            SiUnit::PascalPerMetre => [1, -3, 0],
            SiUnit::Degree => [0, 0, 1],
            SiUnit::One | SiUnit::Coefficient | SiUnit::Unstated => return None,
        })
    }

    /// Whether a number may be given so. The functions of formulas take radians, which are no decimals of degrees.
    fn takes(self, scale: Scale) -> bool {
        match self {
            SiUnit::Unstated => scale.dimension[2] == 0,
            unit => unit.dimension() == Some(scale.dimension),
        }
    }

    /// Usual units of its dimension, this one first.
    fn usual(self) -> &'static [&'static str] {
        match self {
            SiUnit::One | SiUnit::Coefficient => &[],
            SiUnit::Metre => &["m", "mm", "um", "nm", "pm"],
            SiUnit::Newton => &["N", "mN", "uN", "nN", "pN"],
            SiUnit::Pascal => &["Pa", "kPa", "MPa", "GPa"],
            SiUnit::Joule => &["J", "nJ", "pJ", "fJ", "aJ"],
            SiUnit::NewtonPerMetre => &["N/m", "mN/m", "nN/nm", "pN/nm"],
            SiUnit::PascalPerMetre => &["Pa/m", "kPa/m", "MPa/m", "GPa/m", "N/m^3"],
            SiUnit::JoulePerSquareMetre => &["J/m^2", "mJ/m^2", "N/m", "mN/m"],
            SiUnit::Degree => &["deg", "degrees"],
            SiUnit::Unstated => &["m", "um", "nm", "N", "nN", "Pa", "kPa", "MPa", "GPa", "N/m", "J/m^2", "mJ/m^2"],
        }
    }

    /// The usual unit from which a name differs by a slip of the finger.
    fn nearest(self, name: &str) -> Option<&'static str> {
        /// A longer name is no slip.
        const LONGEST: usize = 20;
        let usual = self.usual().iter().copied();
        let same = usual.clone().find(|known| known.eq_ignore_ascii_case(name));
        let close = |known: &&str| name.chars().count() > 1 && strsim::damerau_levenshtein(name, known) == 1;
        same.or_else(|| usual.filter(|_| name.len() <= LONGEST).find(close))
    }
}

/// Why a text is no number in the unit of a key.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NumberError {
    /// It is no number.
    Literal(LiteralError),
    /// Its unit is of another dimension.
    Dimension {
        /// The unit of the key.
        unit: SiUnit,
        /// What was given.
        text: String,
    },
    /// Its unit is unknown.
    Unknown {
        /// The unit of the key.
        unit: SiUnit,
        /// The unknown unit.
        name: String,
    },
}

impl NumberError {
    /// The complaint with the name of the key where the unit is of another dimension: `stiffness is in N/m; got "0.3 nm"`.
    pub fn of(&self, key: &str) -> String {
        match self {
            NumberError::Dimension { .. } => format!("{} {self}", excerpt(key)),
            _ => self.to_string(),
        }
    }
}

impl fmt::Display for NumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NumberError::Literal(error) => error.fmt(f),
            NumberError::Dimension { unit: SiUnit::One, text } => {
                write!(f, "is a pure number without a unit; got \"{}\"", excerpt(text))
            }
            NumberError::Dimension { unit: SiUnit::Coefficient, text } => {
                write!(f, "is in m^(1-n), and is written without a unit; got \"{}\"", excerpt(text))
            }
            NumberError::Dimension { unit: SiUnit::Unstated, text } => {
                write!(f, "is in SI units, and angles are in radians without a unit; got \"{}\"", excerpt(text))
            }
            NumberError::Dimension { unit, text } => {
                let [first, others @ ..] = unit.usual() else { return Ok(()) };
                write!(f, "is in {first}; got \"{}\" ({} would do, too)", excerpt(text), others.join(", "))
            }
            NumberError::Unknown { unit, name } => {
                write!(f, "not a number in a known unit: unknown unit `{}`; ", excerpt(name))?;
                match unit.nearest(name) {
                    Some(near) => write!(f, "did you mean `{near}`?"),
                    None => write!(f, "expected one such as {}", unit.usual().join(", ")),
                }
            }
        }
    }
}

impl std::error::Error for NumberError {}

impl From<LiteralError> for NumberError {
    fn from(error: LiteralError) -> Self {
        NumberError::Literal(error)
    }
}

/// A unit in a table without the brackets around it: `nm` of `[nm]`.
pub fn bare(unit: &str) -> &str {
    unit.trim_matches(['[', ']', '(', ')', ' '])
}

/// A number and the unit behind it, which begins with a letter; without one the whole text and nothing.
fn split(text: &str) -> (&str, &str) {
    let digits = |from: usize| from + text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let starts = |from: usize, marks: &[char]| text[from..].starts_with(marks);
    let mut end = digits(usize::from(starts(0, &['+', '-'])));
    let mut is_whole = true;
    if starts(end, &['.']) {
        (end, is_whole) = (digits(end + 1), false);
    }
    if starts(end, &['e', 'E']) {
        let exponent = end + 1 + usize::from(starts(end + 1, &['+', '-']));
        if digits(exponent) > exponent {
            (end, is_whole) = (digits(exponent), false);
        }
    }
    if is_whole && starts(end, &['/']) && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    let (number, unit) = text.split_at(end);
    let unit = unit.trim_start();
    let is_unit = unit.starts_with(|c: char| c.is_alphabetic() || c == '°');
    if is_unit && number.ends_with(|c: char| c.is_ascii_digit() || c == '.') { (number, unit) } else { (text, "") }
}

/// The text of a literal times 10^power, exactly: the exponent of a decimal is shifted, an integer of a fraction gets zeros.
pub fn scaled(text: &str, power: i64) -> String {
    let zeros = |count: i64| "0".repeat(count.max(0) as usize);
    if power == 0 {
        text.to_owned()
    } else if let Some((numerator, denominator)) = text.split_once('/') {
        format!("{numerator}{}/{denominator}{}", zeros(power), zeros(-power))
    } else {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        match exponent.parse::<i64>().ok().and_then(|exponent| exponent.checked_add(power)) {
            Some(0) => mantissa.to_owned(),
            Some(exponent) => format!("{mantissa}e{exponent}"),
            // More than any literal may have, which its reader says.
            None => text.to_owned(),
        }
    }
}
