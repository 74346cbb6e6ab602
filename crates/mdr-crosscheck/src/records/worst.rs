//! The worst inputs of the [stability ladders](crate::ladders) as records: those of functions that answer a question of the
//! records.
//!
//! Doubles are exact decimals, if long ones. Inputs beyond 10^±30 are given by their shortest decimals, which stand for
//! the same doubles.

use mdr_core::number::Precision;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::equilibria::{Equilibrium, Side, Target};
use super::library::Profile;
use super::list;
use super::machine::{self, Jump};
use super::power::{Held, Power};
use super::shapes;
use crate::ladders::{Worst, worst_inputs};
use crate::library::Shape;

/// A question with its place in the identifiers.
#[derive(Clone, Debug)]
pub(super) struct Question {
    /// worst/function/direction.
    id: String,
    ask: Ask,
    quantity: &'static str,
    inputs: Vec<String>,
}

#[derive(Clone, Copy, Debug)]
enum Ask {
    Kappa,
    Critical(Held),
    Jump(Jump),
    Equilibrium(Held, Side),
    Transform(Shape),
}

/// All of them, in the order of the list.
pub(super) fn questions() -> Vec<Question> {
    let kept = worst_inputs().unwrap_or_else(|error| unreachable!("{error}"));
    let mut found: Vec<Question> = Vec::new();
    for Worst { function, family, inputs, .. } in kept {
        let Some((name, ask, quantity)) = question(&function) else { continue };
        let place = format!("worst/{name}/{family}");
        let before = found.iter().filter(|question| question.place() == place).count();
        let id = if before == 0 { place } else { format!("{place}+{before}") };
        let question = Question { id, ask, quantity, inputs: inputs.into_iter().map(decimal).collect() };
        if question.is_within_reach(&family) {
            found.push(question);
        }
    }
    found
}

/// What a function of the ladders is called in identifiers, and what it is asked for.
fn question(function: &str) -> Option<(String, Ask, &'static str)> {
    let jump = |jump: Jump| Some((jump.name().to_owned(), Ask::Jump(jump), "energy"));
    match function {
        "double::kappa" => return Some(("kappa".to_owned(), Ask::Kappa, "kappa")),
        "double::energy_lost_at_pull_off" => return jump(Jump::PullOff),
        "double::energy_lost_at_jump_in" => return jump(Jump::Approach),
        "double::barrier_to_complete_contact" => return jump(Jump::Barrier),
        _ => {}
    }
    if let Some((shape, part)) = function.split_once("::") {
        let shape = Shape::ALL.into_iter().find(|known| format!("{known:?}") == shape);
        let part = ["g", "slope", "integral"].into_iter().find(|known| *known == part);
        if let (Some(shape), Some(part)) = (shape, part) {
            return Some((format!("{}.{part}", shape.name()), Ask::Transform(shape), part));
        }
    }
    let mut words = function.split(", ");
    let [what, held, part] = [words.next()?, words.next()?, words.next()?];
    let held = match held {
        "fixed grips" => Held::Indentation,
        "dead load" => Held::Force,
        _ => return None,
    };
    let (side, symbol) = part.split_once(' ').unwrap_or(("", part));
    let quantity = match symbol {
        "a" => "contact_radius",
        "d" => "indentation",
        "F" => "force",
        _ => return None,
    };
    let ask = match (what, side) {
        ("double::critical" | "folds", "") => Ask::Critical(held),
        ("equilibria", "inner") => Ask::Equilibrium(held, Side::Inner),
        ("equilibria", "outer") => Ask::Equilibrium(held, Side::Outer),
        _ => return None,
    };
    let name = what.trim_start_matches("double::");
    let side = if side.is_empty() { String::new() } else { format!(".{side}") };
    Some((format!("{name}.{}{side}.{quantity}", held.name()), ask, quantity))
}

/// A double as a decimal: exactly where that is not too long.
fn decimal(x: f64) -> String {
    /// Decimal exponents of doubles that are written out.
    const LONGEST: f64 = 30.0;
    if x != 0.0 && x.abs().log10().abs() > LONGEST {
        return format!("{x:e}");
    }
    // No double of this size has more digits.
    let exact = format!("{x:.160}");
    let short = exact.trim_end_matches('0').trim_end_matches('.');
    short.to_owned()
}

impl Question {
    /// Without the number among those of one place.
    fn place(&self) -> &str {
        self.id.split('+').next().unwrap_or(&self.id)
    }

    /// Whether the second method can follow: exponents as those of the other records, and an answer that arbitrary precision
    /// holds, where a critical radius near n = 1/2 has up to 10¹⁵ digits before its point; of a transform no ratios of
    /// lengths beyond 10³⁰, heights at all radii, and not too many waves; of an equilibrium a critical state that is a record.
    fn is_within_reach(&self, family: &str) -> bool {
        /// |ln a| of what it holds with its powers.
        const REACH: f64 = 1e8;
        const FAR: f64 = 1e30;
        /// What a quadrature takes upon itself.
        const MOST_WAVES: f64 = 500.0;
        const EXPONENTS: std::ops::RangeInclusive<f64> = 1e-6..=1e3;
        let input = |index: usize| self.inputs.get(index).and_then(|text| text.parse().ok()).unwrap_or(f64::NAN);
        let last = input(self.inputs.len() - 1);
        match self.ask {
            // Its height is known inside of its edge.
            Ask::Transform(Shape::EllipticalDimple) if last > input(1) => return false,
            Ask::Transform(Shape::WavyParaboloid) if last > MOST_WAVES * input(2) => return false,
            Ask::Transform(_) => return !(family == "far" && last > FAR),
            // The distance to the fold is read off the record of the critical state.
            Ask::Equilibrium(..) => return list::all().iter().any(|law| law.texts() == self.law().texts()),
            _ => {}
        }
        let critical = |held: Held| {
            let contact = self.law().contact::<Float>(Precision::new(128))?;
            contact.ln_critical(&held.control()).map(|state| state.contact_radius.to_f64())
        };
        let holds = match self.ask {
            Ask::Critical(held) => critical(held).is_ok_and(|ln| ln.abs() < REACH),
            _ => true,
        };
        holds && EXPONENTS.contains(&input(0))
    }

    /// The power law of the first four inputs; where it has fewer, the others are 1.
    fn law(&self) -> Power {
        let at = |index: usize| self.inputs.get(index).map_or("1", String::as_str);
        Power::new(&self.id, [at(0), at(1), at(2), at(3)], &[])
    }

    /// The record.
    pub(super) fn records(&self) -> Result<Vec<Record>, RecordError> {
        let missing = || RecordError::missing(&self.id, self.quantity);
        let records = match self.ask {
            Ask::Kappa => vec![self.law().kappa()?],
            Ask::Critical(held) => self.law().critical(held)?,
            Ask::Jump(jump) => vec![machine::jump(&self.law(), jump)?],
            Ask::Equilibrium(held, side) => {
                let target = Target::Value(self.inputs.last().ok_or_else(missing)?.clone());
                Equilibrium { law: self.law(), held, target, side, label: self.id.clone() }.records()?
            }
            Ask::Transform(shape) => {
                let (x, parameters) = self.inputs.split_last().ok_or_else(missing)?;
                let parameters: Vec<_> = shapes::parameters(shape).zip(parameters.iter().map(String::as_str)).collect();
                Profile { shape, parameters: &parameters }.at(x)?
            }
        };
        let mut records: Vec<_> = records.into_iter().filter(|record| record.quantity == self.quantity).collect();
        for record in &mut records {
            record.id.clone_from(&self.id);
            record.flags.push("worst".to_owned());
        }
        if records.is_empty() { Err(missing()) } else { Ok(super::of_second_release(records)) }
    }
}
