//! From a certified decimal to a record.

use mdr_core::number::{Decimal, Literal, Real};
use mdr_reference::{Certified, DifficultyInputs, Method, Record, Status};
use rug::{Float, Rational};

use crate::DIGITS;
use crate::cases::Case;
use crate::sensitivity::Conditions;

/// The quantities of an equilibrium, with their units.
pub(crate) const STATE: [(&str, &str); 3] = [("contact_radius", "m"), ("indentation", "m"), ("force", "N")];

/// Makes the records of one question.
#[derive(Clone)]
pub(crate) struct RecordBuilder<'a> {
    case: &'a Case,
    /// The identifier as far as it is the same for all.
    id: String,
    inputs: Vec<(&'static str, Literal)>,
    flags: Vec<&'a str>,
    fold_distance: f64,
}

impl<'a> RecordBuilder<'a> {
    /// A question about these inputs.
    pub(crate) fn new(case: &'a Case, inputs: Vec<(&'static str, &Literal)>) -> Self {
        let machine = case.contact.stiffness().map_or_else(String::new, |stiffness| format!("/k={stiffness}"));
        RecordBuilder {
            case,
            id: format!("{}/{}{machine}", case.formula.id.as_deref().unwrap_or_default(), case.name),
            inputs: inputs.into_iter().map(|(name, number)| (name, number.clone())).collect(),
            flags: case.flags.iter().map(String::as_str).collect(),
            fold_distance: f64::INFINITY,
        }
    }

    /// With another part of the identifier.
    pub(crate) fn part(mut self, text: impl std::fmt::Display) -> Self {
        self.id += &format!("/{text}");
        self
    }

    /// With another input.
    pub(crate) fn input(mut self, name: &'static str, number: impl Into<Literal>) -> Self {
        self.inputs.push((name, number.into()));
        self
    }

    /// With a remark.
    pub(crate) fn flag(mut self, flag: &'a str) -> Self {
        self.flags.push(flag);
        self
    }

    /// At this relative distance to a fold.
    pub(crate) fn fold_distance(self, fold_distance: f64) -> Self {
        RecordBuilder { fold_distance, ..self }
    }

    /// The records of a, d and F.
    pub(crate) fn state(
        &self,
        values: &[Decimal; 3],
        conditions: [Conditions; 3],
        scale: Option<&Float>,
    ) -> Vec<Record> {
        let answers = STATE.into_iter().zip(values).zip(conditions);
        answers.map(|((quantity, value), condition)| self.number(quantity, value, condition, scale)).collect()
    }

    /// The records of those of a, d and F that are not controlled.
    pub(crate) fn uncontrolled(
        &self,
        values: &[Decimal; 3],
        conditions: [Conditions; 3],
    ) -> impl Iterator<Item = Record> + use<> {
        let controlled = self.case.contact.control.kind().name();
        self.state(values, conditions, None).into_iter().filter(move |record| record.quantity != controlled)
    }

    /// The record of a quantity, in its unit, with the conditions of its inputs. Zero needs the size of the terms that
    /// cancel.
    pub(crate) fn number(
        &self,
        (quantity, unit): (&str, &str),
        value: &Decimal,
        condition: Conditions,
        scale: Option<&Float>,
    ) -> Record {
        let is_input = |(name, _): &(&str, f64)| self.inputs.iter().any(|(input, _)| input == name);
        let condition = condition.into_iter().filter(is_input).map(|(name, x)| (name.to_owned(), three_digits(x)));
        let log10 = (!value.is_zero()).then(|| (value.log10_f64() * 1e9).round() / 1e9);
        let mut record = Record {
            value: Some(certified(value)),
            log10,
            scale: scale.filter(|_| value.is_zero()).map(|scale| scale.to_string_radix(10, Some(17))),
            condition: condition.collect(),
            ..self.without_number(quantity, unit, status(value))
        };
        record.flags.extend(value.is_zero().then(|| "exact-zero".to_owned()));
        let decades = self.decades().max(log10.unwrap_or(0.0).abs());
        let hardness =
            DifficultyInputs { condition: record.total_condition(), decades, is_number: true, ..self.hardness() };
        Record { difficulty: hardness.difficulty(), ..record }
    }

    /// The record of a question without a number.
    pub(crate) fn without_number(&self, quantity: &str, unit: &str, status: Status) -> Record {
        let Case { formula, contact, has_control, .. } = self.case;
        let control = has_control.then(|| contact.control.kind().name());
        let place = control.map_or_else(String::new, |control| format!("{control}/"));
        let method = |(index, name): (usize, &String)| Method { name: name.clone(), rigorous: index == 0 };
        Record {
            id: format!("{}/{place}{quantity}", self.id),
            release: 1,
            profile: contact.profile_name().to_owned(),
            formula: formula.name.clone().unwrap_or_default(),
            inputs: self.inputs.iter().map(|(name, value)| ((*name).to_owned(), value.to_string())).collect(),
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            control: control.map(str::to_owned),
            status,
            value: None,
            log10: None,
            scale: None,
            condition: Vec::new(),
            difficulty: DifficultyInputs { is_number: false, ..self.hardness() }.difficulty(),
            methods: formula.methods.iter().enumerate().map(method).collect(),
            proof: formula.proof.clone(),
            flags: self.flags.iter().map(|flag| (*flag).to_owned()).collect(),
            refs: formula.refs.clone(),
        }
    }

    fn hardness(&self) -> DifficultyInputs {
        let exponent = self.inputs.iter().find(|(name, _)| *name == "n").map(|(_, n)| n.to_rational());
        let from_half = exponent.map(|n| (n - Rational::from((1, 2))).abs()).filter(|distance| !distance.is_zero());
        DifficultyInputs {
            fold_distance: self.fold_distance,
            decades: self.decades(),
            from_half: from_half.map_or(f64::INFINITY, |distance| distance.to_f64()),
            ..DifficultyInputs::default()
        }
    }

    /// The largest |log₁₀| of the inputs.
    fn decades(&self) -> f64 {
        let sizes = self.inputs.iter().map(|(_, number)| Float::with_val(64, number.to_rational()).abs());
        sizes.filter(|size| !size.is_zero()).map(|size| size.log10().approx().abs()).fold(0.0, f64::max)
    }
}

/// Whether a double can represent this number.
pub(crate) fn status(value: &Decimal) -> Status {
    match value.to_f64().abs() {
        f64::INFINITY => Status::Overflow,
        size if size < f64::MIN_POSITIVE && !value.is_zero() => Status::Underflow,
        _ => Status::Ok,
    }
}

/// The correctly rounded decimal with half a unit of its last digit.
pub(crate) fn certified(value: &Decimal) -> Certified {
    let last = value.exponent() - (value.digits().len() as u32);
    let rad = if value.is_zero() { "0".to_owned() } else { format!("5e{last}") };
    Certified { mid: value.to_string(), rad, digits: DIGITS }
}

/// Conditions are orders of magnitude: three digits.
pub(crate) fn three_digits(x: f64) -> f64 {
    /// A condition below this is zero, up to rounding.
    const NOTHING: f64 = 1e-30;
    if x.abs() < NOTHING { 0.0 } else { format!("{:.2e}", x.abs()).parse().unwrap_or(x) }
}
