//! From a certified decimal to a record.

use mdr_core::number::certify::Decimal;
use mdr_core::number::{Literal, Real};
use mdr_reference::{Certified, Hardness, Method, Record, Status};
use rug::Float;

use super::condition::Named;

/// The number of the release in which the values were last changed.
const RELEASE: u32 = 1;

/// The significant digits of every record.
pub(super) const DIGITS: u32 = 50;

/// What the records of one question have in common.
#[derive(Clone, Debug, Default)]
pub(super) struct Draft {
    /// family/case, the beginning of the identifiers.
    pub(super) id: String,
    pub(super) profile: &'static str,
    pub(super) formula: &'static str,
    pub(super) inputs: Vec<(&'static str, String)>,
    pub(super) control: Option<&'static str>,
    /// The rigorous one first; the second is empty where the first is a definition.
    pub(super) methods: [&'static str; 2],
    pub(super) proof: Vec<&'static str>,
    pub(super) flags: Vec<&'static str>,
    pub(super) refs: Vec<&'static str>,
    /// The relative distance to a fold, where it plays a part.
    pub(super) fold_distance: Option<f64>,
}

/// A quantity of an answer.
pub(super) struct Answered {
    pub(super) quantity: &'static str,
    pub(super) unit: &'static str,
    pub(super) value: Decimal,
    /// By the names of the inputs.
    pub(super) condition: Named,
    /// Needed where the value is zero.
    pub(super) scale: Option<Float>,
}

/// The quantities of an equilibrium, with their units.
pub(super) const STATE: [(&str, &str); 3] = [("contact_radius", "m"), ("indentation", "m"), ("force", "N")];

impl Draft {
    /// The records of several quantities, none of which is 0, with their units.
    pub(super) fn records<const N: usize>(
        &self,
        quantities: [(&'static str, &'static str); N],
        values: [Decimal; N],
        conditions: [Named; N],
    ) -> impl Iterator<Item = Record> {
        let answers = quantities.into_iter().zip(values).zip(conditions);
        answers.map(|(((quantity, unit), value), condition)| {
            self.record(Answered { quantity, unit, value, condition, scale: None })
        })
    }

    /// The record of a quantity.
    pub(super) fn record(&self, answered: Answered) -> Record {
        let Answered { quantity, unit, value, condition, scale } = answered;
        let condition: Vec<_> = condition.into_iter().map(|(name, x)| (name, three_digits(x))).collect();
        let log10 = (!value.is_zero()).then(|| (value.log10_f64() * 1e9).round() / 1e9);
        let mut flags = self.flags.clone();
        flags.extend(value.is_zero().then_some("exact-zero"));
        let record = Record {
            id: self.identifier(quantity),
            status: status(&value),
            value: Some(certified(&value)),
            log10,
            scale: scale.filter(|_| value.is_zero()).map(|scale| scale.to_string_radix(10, Some(17))),
            condition,
            methods: self.method_list(),
            flags: owned(&flags),
            ..self.bare(quantity, unit)
        };
        let hardness = Hardness {
            condition: record.total_condition(),
            fold_distance: self.fold_distance.unwrap_or(f64::INFINITY),
            decades: self.input_decades().chain(log10).map(f64::abs).fold(0.0, f64::max),
            from_half: self.half_distance(),
            is_number: true,
        };
        Record { difficulty: hardness.difficulty(), ..record }
    }

    /// The record of a question without a number.
    pub(super) fn without_number(&self, quantity: &str, unit: &str, status: Status) -> Record {
        let hardness = Hardness {
            fold_distance: self.fold_distance.unwrap_or(f64::INFINITY),
            decades: self.input_decades().map(f64::abs).fold(0.0, f64::max),
            from_half: self.half_distance(),
            is_number: false,
            ..Hardness::default()
        };
        let methods = self.method_list();
        Record { status, difficulty: hardness.difficulty(), methods, ..self.bare(quantity, unit) }
    }

    fn bare(&self, quantity: &str, unit: &str) -> Record {
        Record {
            id: self.identifier(quantity),
            release: RELEASE,
            profile: self.profile.to_owned(),
            formula: self.formula.to_owned(),
            inputs: self.inputs.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect(),
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            control: self.control.map(str::to_owned),
            status: Status::Ok,
            value: None,
            log10: None,
            scale: None,
            condition: Vec::new(),
            difficulty: Hardness::default().difficulty(),
            methods: Vec::new(),
            proof: owned(&self.proof),
            flags: owned(&self.flags),
            refs: owned(&self.refs),
        }
    }

    fn identifier(&self, quantity: &str) -> String {
        match self.control {
            Some(control) => format!("{}/{control}/{quantity}", self.id),
            None => format!("{}/{quantity}", self.id),
        }
    }

    fn method_list(&self) -> Vec<Method> {
        let method = |(index, name): (usize, &&str)| Method { name: (*name).to_owned(), rigorous: index == 0 };
        self.methods.iter().enumerate().filter(|(_, name)| !name.is_empty()).map(method).collect()
    }

    /// log₁₀ of the inputs.
    fn input_decades(&self) -> impl Iterator<Item = f64> {
        self.inputs.iter().filter_map(|(_, text)| {
            let value = Float::with_val(64, literal(text).to_rational()).abs();
            (!value.is_zero()).then(|| value.log10().approx())
        })
    }

    /// |n − 1/2| of a power law.
    fn half_distance(&self) -> f64 {
        let n = self.inputs.iter().find(|(name, _)| *name == "n");
        let distance = n.map(|(_, text)| (literal(text).to_rational() - rug::Rational::from((1, 2))).abs());
        match distance {
            Some(distance) if !distance.is_zero() => distance.to_f64(),
            _ => f64::INFINITY,
        }
    }
}

/// The exact number of an input. The inputs are written in this crate, and a test reads them all.
pub(super) fn literal(text: &str) -> Literal {
    text.parse().unwrap_or_else(|error| unreachable!("{text}: {error}"))
}

fn owned(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| (*text).to_owned()).collect()
}

/// What a double can say of this number.
fn status(value: &Decimal) -> Status {
    let nearest = value.to_f64();
    match nearest.abs() {
        f64::INFINITY => Status::Overflow,
        size if size < f64::MIN_POSITIVE && !value.is_zero() => Status::Underflow,
        _ => Status::Ok,
    }
}

/// The correctly rounded decimal with half a unit of its last digit.
fn certified(value: &Decimal) -> Certified {
    let rad = if value.is_zero() {
        "0".to_owned()
    } else {
        let last = value.exponent().clone() - (value.digits().len() as u32);
        format!("5e{last}")
    };
    Certified { mid: value.to_string(), rad, digits: DIGITS }
}

/// What rounding leaves of a condition that is zero is below this.
const NOTHING: f64 = 1e-30;

/// Conditions are orders of magnitude: three digits.
fn three_digits(x: f64) -> f64 {
    if x.abs() < NOTHING {
        return 0.0;
    }
    format!("{:.2e}", x.abs()).parse().unwrap_or(x)
}
