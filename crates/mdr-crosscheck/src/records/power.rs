//! Critical states of power laws: by closed forms over intervals, confirmed by tangency of quadratures.

use mdr_analytic::certified::{self, Elasticity, Question};
use mdr_analytic::{Contact, Kappa, PowerLaw};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, largest};
use super::confirm;
use super::draft::{Answered, DIGITS, Draft, STATE, literal};

/// A power-law contact, as exact decimals.
#[derive(Clone, Debug)]
pub(super) struct Power {
    pub(super) name: String,
    pub(super) n: String,
    pub(super) c: String,
    pub(super) e_star: String,
    pub(super) work: String,
    pub(super) flags: Vec<&'static str>,
    /// The controls under which its critical state is a record.
    pub(super) held: Vec<Held>,
}

/// The names of the inputs of a power-law contact.
pub(super) const NAMES: [&str; 4] = ["n", "C", "E*", "w"];

/// Bits for conditions and scales.
const BITS: u32 = 192;

impl Power {
    pub(super) fn new(name: &str, [n, c, e_star, work]: [&str; 4], flags: &[&'static str]) -> Self {
        let [n, c, e_star, work] = [n, c, e_star, work].map(str::to_owned);
        Power { name: name.to_owned(), n, c, e_star, work, flags: flags.to_vec(), held: Held::ALL.to_vec() }
    }

    pub(super) fn texts(&self) -> [&String; 4] {
        [&self.n, &self.c, &self.e_star, &self.work]
    }

    pub(super) fn inputs(&self) -> Vec<(&'static str, String)> {
        NAMES.into_iter().zip(self.texts().map(String::clone)).collect()
    }

    pub(super) fn draft(&self, family: &str) -> Draft {
        Draft {
            id: format!("{family}/{}", self.name),
            profile: "power",
            inputs: self.inputs(),
            flags: self.flags.clone(),
            ..Draft::default()
        }
    }

    /// The contact in an arithmetic.
    pub(super) fn contact<R: Kappa>(&self, ctx: R::Ctx) -> Result<Contact<R>> {
        assemble(self.texts().map(|text| R::from_literal(ctx, &literal(text))))
    }

    /// The contact with a derivative with respect to the logarithm of input number `moving`.
    pub(super) fn moving<R: Kappa>(&self, ctx: R::Ctx, moving: usize) -> Result<Contact<Dual<R>>> {
        let mut index = 0;
        assemble(self.texts().map(|text| {
            index += 1;
            input(ctx, &literal(text), index == moving + 1)
        }))
    }

    pub(super) fn question(&self, control: &Control<Literal>) -> std::result::Result<Question, RecordError> {
        let [n, c, e_star, work] = self.texts().map(|text| literal(text));
        Question::new(&n, &c, &Elasticity::Effective(e_star), &work, control)
            .map_err(|error| RecordError::of(&self.name, error))
    }

    /// a, d and F at the critical state under fixed grips or a dead load.
    pub(super) fn critical(&self, held: Held) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(&self.name, error);
        let answer = self.question(&held.control())?.answer(DIGITS).map_err(wrong)?;
        let state = answer.critical.ok_or_else(|| RecordError::missing(&self.name, "critical state"))?;
        let values = [state.contact_radius, state.indentation, state.force];
        let (conditions, scale) = self.critical_conditions(held, &values).map_err(wrong)?;
        confirm::fold(self, &held.control(), &values, largest(&conditions))?;
        let draft = Draft {
            formula: "critical",
            control: Some(held.name()),
            methods: ["closed-form/interval", "quadrature-tangency/mp"],
            proof: held.proof(),
            refs: held.refs(),
            ..self.draft("critical")
        };
        let records = STATE.into_iter().zip(values).zip(conditions);
        Ok(records
            .map(|(((quantity, unit), value), condition)| {
                let scale = Some(scale.clone());
                draft.record(Answered { quantity, unit, value, condition, scale })
            })
            .collect())
    }

    /// d ln a, d ln|d| and d ln|F| with respect to the logarithm of every input, and Δl(a), to which d = 0 is compared.
    fn critical_conditions(&self, held: Held, values: &[Decimal; 3]) -> Result<([Named; 3], Float)> {
        let ctx = Precision::new(BITS);
        let mut conditions: [Named; 3] = Default::default();
        let mut scale = Float::new(BITS);
        for (index, name) in NAMES.into_iter().enumerate() {
            let contact = self.moving::<Interval>(ctx, index)?;
            let slopes = if values[1].is_zero() {
                let state = contact.critical(&held.control())?;
                let elongation = contact.detachment_elongation(&state.contact_radius)?.value;
                scale = elongation.mid();
                let relative = |x: Dual<Interval>| x.slope / x.value;
                let (a, f) = (relative(state.contact_radius), relative(state.force));
                [a, state.indentation.slope / elongation, f]
            } else {
                let ln = contact.ln_critical(&held.control())?;
                [ln.contact_radius.slope, ln.indentation.slope, ln.force.slope]
            };
            for (list, slope) in conditions.iter_mut().zip(slopes) {
                list.push((name.to_owned(), slope.approx().abs()));
            }
        }
        Ok((conditions, scale))
    }

    /// κ_n.
    pub(super) fn kappa(&self) -> std::result::Result<Record, RecordError> {
        let wrong = |error| RecordError::of(&self.name, error);
        let value = certified::kappa(&literal(&self.n), DIGITS).map_err(wrong)?;
        confirm::kappa(self, &value)?;
        let n = Interval::from_literal(Precision::new(BITS), &literal(&self.n));
        let condition = (Interval::ln_kappa_derivative(&n, 1) * &n).approx().abs();
        let near_half = self.flags.contains(&"near-half");
        let draft = Draft {
            id: if near_half { format!("kappa/{}", self.name) } else { format!("kappa/n={}", self.n) },
            profile: "power",
            formula: "kappa",
            inputs: vec![("n", self.n.clone())],
            methods: ["hypergeometric-series/interval", "quadrature/mp"],
            proof: vec!["1.12", "kappa-series"],
            refs: vec!["Popov (1.12)", "Hess 2011"],
            flags: near_half.then_some("near-half").into_iter().collect(),
            ..Draft::default()
        };
        let condition = vec![("n".to_owned(), condition)];
        Ok(draft.record(Answered { quantity: "kappa", unit: "1", value, condition, scale: None }))
    }
}

fn assemble<R: Kappa>([n, c, e_star, work]: [R; 4]) -> Result<Contact<R>> {
    Ok(Contact::new(PowerLaw::new(n, c)?, Material::new(e_star, work)?))
}

/// Fixed grips or a dead load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    Indentation,
    Force,
}

impl Held {
    pub(super) const ALL: [Held; 2] = [Held::Indentation, Held::Force];

    pub(super) fn name(self) -> &'static str {
        match self {
            Held::Indentation => "indentation",
            Held::Force => "force",
        }
    }

    pub(super) fn control<R>(self) -> Control<R> {
        match self {
            Held::Indentation => Control::Indentation,
            Held::Force => Control::Force,
        }
    }

    /// The symbol of the controlled quantity.
    pub(super) fn symbol(self) -> &'static str {
        match self {
            Held::Indentation => "d",
            Held::Force => "F",
        }
    }

    /// The steps of the derivations from which its critical state follows.
    fn proof(self) -> Vec<&'static str> {
        match self {
            Held::Indentation => vec!["1.13", "1.15", "1.17", "critical-indentation"],
            Held::Force => vec!["1.13", "1.16", "critical-force"],
        }
    }

    fn refs(self) -> Vec<&'static str> {
        match self {
            Held::Indentation => vec!["Popov (1.15) corrected", "Popov (1.17)"],
            Held::Force => vec!["Popov (1.5)", "Popov (1.6)", "tangency g' = 3 Delta l'"],
        }
    }
}
