//! Records of media other than the half-space: graded half-spaces, line contact, the wave of Johnson (1995); and of
//! [loops](crate::loops) with two works of adhesion.
//!
//! Their values are closed forms of `mdr-analytic` over intervals; the second method has the heights f and the kernel of the
//! medium or the weight of its transform, by quadrature. Conditions are differences that a small change of each input makes.

use mdr_analytic::media::{
    GradedContact, GradedHalfSpace, JohnsonWave, LineContact, WaveControl, graded_threshold,
    least_compliance_for_complete_contact, line_threshold, wave_energy_threshold, wave_load_threshold,
    wave_touch_threshold,
};
use mdr_core::contact::{self, Control, Error, FoldKind, Material, Quantity};
use mdr_core::number::certify::{Enclosure, certify};
use mdr_core::number::{Decimal, Interval, Literal, Precision, Real};
use mdr_reference::{DifficultyInputs, Method, Record};
use rayon::prelude::*;
use rug::Float;

use crate::builder::{certified, status, three_digits};
use crate::confirm;
use crate::media_confirm as second;
use crate::{DIGITS, Failure, RecordError, Result, float, loops, loops_confirm};

/// The release in which these records appeared.
const RELEASE: u32 = 4;

/// Bits beyond those of the digits.
const GUARD: u32 = 60;

/// The quantities of a state.
const STATE: [&str; 3] = ["contact_radius", "indentation", "force"];

/// The controlled quantity, with one of its folds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Held {
    Indentation,
    Force,
    /// Through a spring, whose stiffness is the last input.
    Machine,
}

impl Held {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Held::Indentation => "indentation",
            Held::Force => "force",
            Held::Machine => "machine",
        }
    }
}

/// A question.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Question {
    pub(crate) formula: &'static str,
    pub(crate) profile: &'static str,
    pub(crate) name: &'static str,
    pub(crate) held: Option<Held>,
    /// Names and decimals.
    pub(crate) inputs: &'static [(&'static str, &'static str)],
    /// Quantities with their units.
    pub(crate) quantities: &'static [(&'static str, &'static str)],
    /// Which fold, of the wave.
    pub(crate) kind: FoldKind,
    pub(crate) flags: &'static [&'static str],
}

pub(crate) const LENGTHS: &[(&str, &str)] = &[("contact_radius", "m"), ("indentation", "m"), ("force", "N")];
const LINE: &[(&str, &str)] = &[("contact_radius", "m"), ("force", "N/m")];
const WAVE: &[(&str, &str)] = &[("contact_radius", "m"), ("indentation", "m"), ("force", "Pa")];

macro_rules! question {
    ($formula:literal $profile:literal $name:literal $held:expr, $quantities:expr, $kind:ident, [$($flag:literal)*], $($input:literal = $value:literal)*) => {
        $crate::media::Question {
            formula: $formula,
            profile: $profile,
            name: $name,
            held: $held,
            inputs: &[$(($input, $value)),*],
            quantities: $quantities,
            kind: ::mdr_core::contact::FoldKind::$kind,
            flags: &[$($flag),*],
        }
    };
}
pub(crate) use question;

/// Both controls of a power law on a graded half-space.
macro_rules! graded {
    ($($name:literal: $n:literal $c:literal $chi:literal $coefficient:literal $w:literal [$($flag:literal)*];)*) => {
        &[$(
            question!("graded-critical" "power" $name Some(Held::Indentation), LENGTHS, Minimum, [$($flag)*],
                "n" = $n "C" = $c "chi" = $chi "c" = $coefficient "w" = $w),
            question!("graded-critical" "power" $name Some(Held::Force), LENGTHS, Minimum, [$($flag)*],
                "n" = $n "C" = $c "chi" = $chi "c" = $coefficient "w" = $w),
        )*]
    };
}

const GRADED: &[Question] = graded! {
    "paraboloid": "2" "1" "0.3" "1" "0.01" [];
    "softening": "2" "0.5" "-0.5" "1" "1" [];
    "cone": "1" "1" "0.5" "1" "1" [];
    "blunt": "4" "1" "0.75" "2" "0.1" [];
    "cusp": "0.125" "1" "0.5" "1" "0.01" [];
    "near-threshold": "0.36" "1" "0.3" "1" "0.01" [];
    "near-winkler": "2" "1" "0.99" "1" "0.01" [];
    "soil": "2" "0.5" "0.6" "2e7" "0.02" ["si"];
};

const THRESHOLDS: &[Question] = &[
    question!("graded-threshold" "power" "chi=0.5" Some(Held::Indentation), &[("threshold_c", "m^(1-n)")], Minimum, [],
        "chi" = "0.5" "c" = "1" "w" = "0.01"),
    question!("graded-threshold" "power" "chi=0.5" Some(Held::Force), &[("threshold_c", "m^(1-n)")], Minimum, [],
        "chi" = "0.5" "c" = "1" "w" = "0.01"),
];

const LINES: &[Question] = &[
    question!("line-critical" "power" "wedge" Some(Held::Force), LINE, Minimum, [], "n" = "1" "C" = "1" "E*" = "1" "w" = "0.01"),
    question!("line-critical" "power" "n=2" Some(Held::Force), LINE, Minimum, [], "n" = "2" "C" = "1" "E*" = "1" "w" = "0.01"),
    question!("line-critical" "power" "cylinder" Some(Held::Force), LINE, Minimum, [], "n" = "2" "C" = "0.5" "E*" = "1" "w" = "0.01"),
    question!("line-critical" "power" "n=0.25" Some(Held::Force), LINE, Maximum, [], "n" = "0.25" "C" = "1" "E*" = "1" "w" = "0.01"),
    question!("line-critical" "power" "n=6" Some(Held::Force), LINE, Minimum, [], "n" = "6" "C" = "1" "E*" = "1" "w" = "0.01"),
    question!("line-critical" "power" "n=0.75" Some(Held::Force), LINE, Minimum, [], "n" = "0.75" "C" = "1" "E*" = "1" "w" = "1"),
    question!("line-critical" "power" "fibre" Some(Held::Force), LINE, Minimum, ["si"], "n" = "2" "C" = "1e5" "E*" = "2e9" "w" = "0.05"),
    question!("line-threshold" "power" "half" Some(Held::Force), &[("threshold_c", "m^(1/2)")], Minimum, [], "E*" = "1" "w" = "0.01"),
];

/// Folds of the wave h₀ = λ = E* = 1.
macro_rules! waves {
    ($($name:literal: $held:ident $kind:ident, $($more:literal = $value:literal)*;)*) => {
        &[$(
            question!("wave-fold" "wave" $name Some(Held::$held), WAVE, $kind, [],
                "h0" = "1" "lambda" = "1" "E*" = "1" $($more = $value)*),
        )*]
    };
}

const WAVES: &[Question] = waves! {
    "alpha-0.3": Force Minimum, "w" = "0.45";
    "alpha-0.3": Force Maximum, "w" = "0.45";
    "alpha-1": Force Minimum, "w" = "4.9";
    "alpha-1": Force Maximum, "w" = "4.9";
    "alpha-1.06": Force Minimum, "w" = "5.59";
    "alpha-1.06": Force Maximum, "w" = "5.59";
    "alpha-1e-3": Force Minimum, "w" = "5e-6";
    "alpha-1e-3": Force Maximum, "w" = "5e-6";
    "alpha-1e-9": Force Minimum, "w" = "5e-18";
    "alpha-1e-9": Force Maximum, "w" = "5e-18";
    "alpha-0.3": Indentation Minimum, "w" = "0.45";
    "alpha-2": Indentation Minimum, "w" = "20";
    "alpha-0.3": Machine Minimum, "w" = "0.45" "k" = "2";
    "alpha-0.3": Machine Maximum, "w" = "0.45" "k" = "2";
    "alpha-2": Machine Minimum, "w" = "20" "k" = "2";
    "alpha-2": Machine Maximum, "w" = "20" "k" = "2";
    "alpha-0.3": Machine Minimum, "w" = "0.45" "k" = "0.5";
    "alpha-0.3": Machine Maximum, "w" = "0.45" "k" = "0.5";
};

const ROUGH: &[Question] = &[
    question!("wave-fold" "wave" "rubber" Some(Held::Force), WAVE, Minimum, ["si"], "h0" = "1e-6" "lambda" = "1e-4" "E*" = "1e6" "w" = "0.01"),
    question!("wave-fold" "wave" "rubber" Some(Held::Force), WAVE, Maximum, ["si"], "h0" = "1e-6" "lambda" = "1e-4" "E*" = "1e6" "w" = "0.01"),
    question!("wave-threshold-load" "wave" "unit" None, &[("threshold_w", "J/m^2")], Maximum, [], "h0" = "1" "lambda" = "1" "E*" = "1"),
    question!("wave-threshold-touch" "wave" "unit" None, &[("threshold_w", "J/m^2")], Maximum, [], "h0" = "1" "lambda" = "1" "E*" = "1"),
    question!("wave-threshold-energy" "wave" "unit" None, &[("threshold_w", "J/m^2")], Maximum, [], "h0" = "1" "lambda" = "1" "E*" = "1"),
    question!("wave-threshold-compliance" "wave" "unit" None, &[("threshold_k", "Pa/m")], Maximum, [], "lambda" = "1" "E*" = "1"),
];

/// The files of the release, with the questions of each.
pub(crate) const FILES: [(&str, &[&[Question]]); 4] = [
    ("graded.jsonl", &[GRADED, THRESHOLDS]),
    ("line.jsonl", &[LINES]),
    ("wave.jsonl", &[WAVES, ROUGH]),
    ("loop.jsonl", &[loops::LOOPS]),
];

/// The records of a file.
pub(crate) fn records(questions: &[&[Question]]) -> std::result::Result<Vec<Record>, RecordError> {
    let all: Vec<&Question> = questions.iter().copied().flatten().collect();
    let found: Vec<_> = all.par_iter().map(|question| question.records()).collect();
    let mut records = Vec::new();
    for (question, found) in all.into_iter().zip(found) {
        let case = format!("{} of {}", question.formula, question.name);
        records.extend(found.map_err(|source| RecordError { case, source })?);
    }
    Ok(records)
}

impl Question {
    fn records(&self) -> Result<Vec<Record>> {
        let digits: Vec<Decimal> =
            (0..self.quantities.len()).map(|place| self.decimal(place)).collect::<Result<_>>()?;
        let ctx = confirm::precision(&[]);
        let values: Vec<Float> = digits.iter().map(|digits| float(ctx, digits)).collect();
        let numbers = self.numbers::<Float>(ctx);
        let agrees = match self.formula.starts_with("loop") {
            true => loops_confirm::agrees(self.formula, self.held == Some(Held::Force), &numbers, &values)?,
            false => second::agrees(self, &numbers, &values)?,
        };
        Failure::unless("the medium or the loop", agrees)?;
        (0..digits.len()).map(|place| self.record(place, &digits[place])).collect()
    }

    /// The fifty digits of a quantity.
    fn decimal(&self, place: usize) -> Result<Decimal> {
        let start = Precision::new(Precision::from_digits(DIGITS).bits() + GUARD);
        let [decimal] = certify([Quantity::Parameter("a number of a record")], DIGITS, start, |precision| {
            Ok([Enclosure::from(self.values(&self.numbers(precision))?.swap_remove(place))])
        })?;
        Ok(decimal)
    }

    fn numbers<R: Real<Ctx = Precision>>(&self, precision: Precision) -> Vec<R> {
        self.literals().map(|(_, literal)| R::from_literal(precision, &literal)).collect()
    }

    fn literals(&self) -> impl Iterator<Item = (&'static str, Literal)> {
        self.inputs.iter().filter_map(|(name, text)| Some((*name, text.parse().ok()?)))
    }

    pub(crate) fn formula(&self) -> &'static str {
        self.formula
    }

    pub(crate) fn held(&self) -> Option<Held> {
        self.held
    }

    /// The values of the quantities, enclosed.
    fn values(&self, x: &[Interval]) -> contact::Result<Vec<Interval>> {
        if self.formula.starts_with("loop") {
            return loops::values(self.formula, self.held, x);
        }
        let control = if self.held == Some(Held::Force) { Control::Force } else { Control::Indentation };
        let square = |h: &Interval| h.square() * h.pi().square() / h.lit(2);
        Ok(match self.formula {
            "graded-critical" => {
                let medium = GradedHalfSpace::new(x[2].clone(), x[3].clone(), x[4].clone())?;
                let state = GradedContact::new(x[0].clone(), x[1].clone(), medium)?.critical(&control)?;
                vec![state.contact_radius, state.indentation, state.force]
            }
            "graded-threshold" => {
                vec![graded_threshold(&GradedHalfSpace::new(x[0].clone(), x[1].clone(), x[2].clone())?, &control)?]
            }
            "line-critical" => {
                let material = Material::new(x[2].clone(), x[3].clone())?;
                let (half_width, force) = LineContact::new(x[0].clone(), x[1].clone(), material)?.critical()?;
                vec![half_width, force]
            }
            "line-threshold" => vec![line_threshold(&Material::new(x[0].clone(), x[1].clone())?)?],
            // α² π² h₀² E*/(2λ).
            "wave-threshold-load" => vec![wave_load_threshold(&x[0]).square() * square(&x[0]) * &x[2] / &x[1]],
            "wave-threshold-touch" => vec![wave_touch_threshold(&x[0]).square() * square(&x[0]) * &x[2] / &x[1]],
            "wave-threshold-energy" => vec![wave_energy_threshold(&x[0]).square() * square(&x[0]) * &x[2] / &x[1]],
            // κ = πE*/(Kλ) = 3 − ln 4.
            "wave-threshold-compliance" => {
                vec![x[0].pi() * &x[1] / &x[0] / least_compliance_for_complete_contact(&x[0])]
            }
            _ => self.fold_of_wave(x)?,
        })
    }

    fn fold_of_wave(&self, x: &[Interval]) -> contact::Result<Vec<Interval>> {
        let wave = JohnsonWave::new(x[0].clone(), x[1].clone(), Material::new(x[2].clone(), x[3].clone())?)?;
        let control = match self.held {
            Some(Held::Indentation) => WaveControl::Approach { compliance: x[0].lit(0) },
            Some(Held::Machine) => WaveControl::Approach { compliance: wave.compliance(&x[4])? },
            _ => WaveControl::Load,
        };
        let fold = wave.folds(&control)?.into_iter().find(|fold| fold.kind == self.kind);
        let state = fold.ok_or_else(|| Error::no_equilibrium(Quantity::Force, &x[0]))?.state;
        let approach = (state.mean_gap.lit(1) - &state.mean_gap) * wave.amplitude();
        let half_width = state.angle.clone() * wave.wavelength() / state.angle.pi();
        Ok(vec![half_width, approach, state.pressure * wave.closing_pressure()])
    }

    /// |d ln value/d ln input| by the difference that an input larger by 2⁻²⁰⁰ makes.
    fn condition(&self, place: usize) -> Result<Vec<(String, f64)>> {
        let precision = Precision::new(900);
        let numbers = self.numbers::<Interval>(precision);
        let value = self.values(&numbers)?.swap_remove(place);
        let step = value.lit(2).powi(-200);
        let slope = |(input, (name, _)): (usize, &(&str, &str))| {
            let mut moved = numbers.clone();
            moved[input] += &(numbers[input].clone() * &step);
            let change = self.values(&moved)?.swap_remove(place) - &value;
            Ok(((*name).to_owned(), three_digits((change / &value / &step).approx().abs())))
        };
        self.inputs.iter().enumerate().map(slope).collect()
    }

    fn record(&self, place: usize, value: &Decimal) -> Result<Record> {
        let (quantity, unit) = self.quantities[place];
        let held = self.held.map(Held::name);
        let part = held.map_or_else(String::new, |held| format!("{held}/"));
        let fold = match self.kind {
            FoldKind::Minimum if self.formula == "wave-fold" => "pull-off/",
            FoldKind::Maximum if self.formula == "wave-fold" => "pull-in/",
            _ => "",
        };
        let given = self.literals().filter(|(name, _)| ["k", "turn", "d", "F"].contains(name));
        let given: String = given.map(|(name, value)| format!("{name}={value}/")).collect();
        let log10 = (value.log10_f64() * 1e9).round() / 1e9;
        let methods = [("closed-form/interval", true), (self.second_method(), false)];
        let mut record = Record {
            id: format!("{}/{}/{given}{fold}{part}{quantity}", self.formula.replacen('-', "/", 1), self.name),
            release: RELEASE,
            profile: self.profile.to_owned(),
            formula: self.formula.to_owned(),
            inputs: self.literals().map(|(name, number)| (name.to_owned(), number.to_string())).collect(),
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            control: held.map(str::to_owned),
            status: status(value),
            value: Some(certified(value)),
            log10: Some(log10),
            scale: None,
            condition: self.condition(place)?,
            difficulty: DifficultyInputs::default().difficulty(),
            methods: methods
                .iter()
                .map(|(name, rigorous)| Method { name: (*name).to_owned(), rigorous: *rigorous })
                .collect(),
            proof: vec![self.proof().to_owned()],
            flags: self.flags.iter().map(|flag| (*flag).to_owned()).collect(),
            refs: vec![self.reference().to_owned()],
        };
        if !fold.is_empty() {
            record.flags.push(fold.trim_end_matches('/').to_owned());
        }
        let half = record.input_f64("n").map_or(f64::INFINITY, |n| (n - 0.5).abs());
        let measures = DifficultyInputs {
            condition: record.total_condition(),
            decades: record.decades(),
            from_half: half,
            is_number: true,
            ..DifficultyInputs::default()
        };
        record.difficulty = measures.difficulty();
        debug_assert!(STATE.contains(&quantity) || quantity.starts_with("threshold") || quantity == "energy");
        Ok(record)
    }

    fn second_method(&self) -> &'static str {
        let is_loop = self.formula.starts_with("loop");
        if is_loop { loops_confirm::name(self.formula) } else { second::name(self.formula) }
    }

    /// The entry of `mdr derive` on which the value rests.
    fn proof(&self) -> &'static str {
        match (self.formula.split('-').next(), self.held) {
            (Some("graded"), _) => "graded",
            (Some("line"), _) => "line-contact",
            (Some("loop"), _) => "hysteresis",
            (_, Some(Held::Indentation | Held::Machine)) => "wave-approach",
            _ => "wave",
        }
    }

    fn reference(&self) -> &'static str {
        match self.formula.split('-').next() {
            Some("graded") => "Giannakopoulos Pallot 2000",
            Some("line") => "Maugis 2000",
            Some("loop") => "Popov (1.8)",
            _ => "Johnson 1995",
        }
    }
}
