//! The questions of which closed forms are asked for ever more digits, and who answers.

use mdr_analytic::certified::{self, Elasticity};
use mdr_analytic::{Contact, PowerLaw, kappa, kappa_enclosure};
use mdr_core::contact::{Control, Error, Material, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision, Real};
use rug::{Float, Rational};
use serde_json::{Map, Value};

use super::found::Found;
use super::{Arithmetic, truth, working};
use crate::contest::outside::question;

/// One question with all that is known of it.
pub(in super::super) struct Question {
    /// The end of the name of its diagram.
    pub(in super::super) id: &'static str,
    /// What is asked.
    pub(in super::super) title: String,
    /// Where the truth comes from.
    pub(in super::super) source: &'static str,
    /// Enclosures of the numbers that are asked for.
    pub(in super::super) truths: Vec<Interval>,
    /// Contestants; the first gives enclosures.
    pub(in super::super) entries: Vec<Entry>,
    /// What others are asked, but for the digits and who they are.
    pub(in super::super) fields: Map<String, Value>,
    /// Who of Arb is asked.
    pub(in super::super) arb: &'static [Other],
}

/// A contestant of another project: the name in the diagram, and in the script.
pub(in super::super) type Other = (&'static str, &'static str);

/// An answer, ready to be computed.
pub(in super::super) type Solver = Box<dyn Fn() -> Result<Vec<Found>>>;

/// One contestant: what it does for a number of digits, up to the most that it is asked for.
pub(in super::super) struct Entry {
    /// As in the legend.
    pub(in super::super) name: &'static str,
    /// Its promise.
    pub(in super::super) arithmetic: Arithmetic,
    /// The most digits that it is asked for.
    pub(in super::super) most: u32,
    /// Prepares its answer.
    pub(in super::super) solver: Box<dyn Fn(u32) -> Result<Solver>>,
}

/// MPFR's Γ takes 45 s for its first value of 10 000 digits.
const MOST_OF_GAMMA: u32 = 2000;

/// p/q.
pub(in super::super) type Fraction = (i64, i64);

/// The exponent of the rational questions, 3/10.
pub(in super::super) const EXPONENT: Fraction = (3, 10);

/// C, E* and w of the critical state.
const SCALES: [&str; 3] = ["1.5", "1e6", "0.05"];

/// All questions, with their truths in so many bits.
pub(in super::super) fn questions(precision: Precision) -> Vec<Question> {
    let irrational = Question {
        id: "kappa-irrational",
        title: "κ_n for n = √2/5".to_owned(),
        source: SERIES,
        truths: vec![truth::kappa_of(&irrational(Precision::new(precision.bits() + 64)))],
        entries: irrational_kappa(),
        fields: question! { "ask": "kappa", "n": "sqrt(2)/5" },
        arb: &[("Γ of a ball", "arb")],
    };
    vec![Question::kappa(EXPONENT, precision), irrational, Question::critical(EXPONENT, precision)]
}

const SERIES: &str = "the hypergeometric series of positive terms over intervals; contestants have another series or Γ";

impl Question {
    /// What is asked, without the values of what does not matter for the time.
    pub(in super::super) fn short(&self) -> String {
        self.title.split_once(", C = ").map_or(&*self.title, |(short, _)| short).to_owned()
    }

    /// κ_{p/q}, for 0 < p ≤ 2q.
    pub(in super::super) fn kappa((p, q): Fraction, precision: Precision) -> Self {
        Question {
            id: "kappa-rational",
            title: format!("κ_n for n = {}", written((p, q))),
            source: SERIES,
            truths: vec![truth::kappa_of_fraction(precision, p, q)],
            entries: rational_kappa((p, q)),
            fields: question! { "ask": "kappa", "n": format!("{p}/{q}") },
            arb: &[("Γ of a rational", "arb, rational argument"), ("Γ of a ball", "arb")],
        }
    }

    /// The critical state for n = p/q, 0 < p ≤ 2q.
    pub(in super::super) fn critical((p, q): Fraction, precision: Precision) -> Self {
        let [c, e, w] = SCALES;
        Question {
            id: "critical",
            title: format!(
                "κ, a, d and F under fixed grips for n = {}, C = 1.5, E* = 1 MPa, w = 0.05 J/m²; the worst of the four counts",
                written((p, q))
            ),
            source: "the tangency in logarithms, then (1.13) and (1.16), over intervals; contestants have (1.15) and (1.17)",
            truths: critical((p, q), precision).unwrap_or_default(),
            entries: critical_states((p, q)),
            fields: question! { "ask": "critical", "n": format!("{p}/{q}"), "c": c, "e": e, "w": w },
            arb: &[("with Γ of a rational", "arb, rational argument"), ("with Γ of a ball", "arb")],
        }
    }
}

/// p/q, or p.
fn written((p, q): Fraction) -> String {
    if q == 1 { p.to_string() } else { format!("{p}/{q}") }
}

fn critical((p, q): Fraction, precision: Precision) -> Result<Vec<Interval>> {
    let kappa = truth::kappa_of_fraction(precision, p, q);
    let [c, e, w] = SCALES.map(literal);
    let scales = [c?, e?, w?].map(|value| Interval::from_literal(kappa.ctx(), &value));
    Ok(truth::critical(&kappa.ratio(p, q), kappa, scales))
}

/// √2/5.
pub(super) fn irrational<R: Real<Ctx = Precision>>(ctx: Precision) -> R {
    R::from_int(ctx, 2).sqrt().over(5)
}

fn rational(text: &str) -> Result<Rational> {
    Ok(literal(text)?.to_rational())
}

fn literal(text: &str) -> Result<Literal> {
    let quantity = Quantity::Parameter("a decimal");
    text.parse().map_err(|_| Error::Domain { quantity, value: text.to_owned(), requirement: "a decimal" })
}

/// √π Γ(1+n/2)/Γ((n+1)/2) as a textbook has it.
fn by_gamma(n: &Float) -> Float {
    let (above, below) = (n.clone() / 2_u32 + 1_u32, (n.clone() + 1_u32) / 2_u32);
    above.gamma() / below.gamma() * n.pi().sqrt()
}

impl Entry {
    fn new(name: &'static str, arithmetic: Arithmetic, solver: impl Fn(u32) -> Result<Solver> + 'static) -> Self {
        Entry { name, arithmetic, most: u32::MAX, solver: Box::new(solver) }
    }

    fn up_to(self, most: u32) -> Self {
        Entry { most, ..self }
    }
}

fn rational_kappa((p, q): Fraction) -> Vec<Entry> {
    let float = move |digits| Float::with_val(working(digits).bits(), Rational::from((p, q)));
    vec![
        Entry::new("certified, as an enclosure", Arithmetic::Certified, move |digits| {
            let n = Rational::from((p, q));
            Ok(Box::new(move || Ok(vec![Found::Enclosure(kappa_enclosure(working(digits), &n))])))
        }),
        Entry::new("certified, in decimals", Arithmetic::Certified, move |digits| {
            let n = literal(&format!("{p}/{q}"))?;
            Ok(Box::new(move || Ok(vec![Found::Decimal(certified::kappa(&n, digits + 1)?)])))
        }),
        Entry::new("mp", Arithmetic::Mp, move |digits| {
            let n = float(digits);
            Ok(Box::new(move || Ok(vec![Found::Number(kappa(&n)?)])))
        }),
        Entry::new("MPFR's Γ", Arithmetic::Mp, move |digits| {
            let n = float(digits);
            Ok(Box::new(move || Ok(vec![Found::Number(by_gamma(&n))])))
        })
        .up_to(MOST_OF_GAMMA),
    ]
}

fn irrational_kappa() -> Vec<Entry> {
    vec![
        Entry::new("certified, as an enclosure", Arithmetic::Certified, |digits| {
            let n: Interval = irrational(working(digits));
            Ok(Box::new(move || Ok(vec![Found::Enclosure(kappa(&n)?)])))
        }),
        Entry::new("mp", Arithmetic::Mp, |digits| {
            let n: Float = irrational(working(digits));
            Ok(Box::new(move || Ok(vec![Found::Number(kappa(&n)?)])))
        }),
        Entry::new("MPFR's Γ", Arithmetic::Mp, |digits| {
            let n: Float = irrational(working(digits));
            Ok(Box::new(move || Ok(vec![Found::Number(by_gamma(&n))])))
        })
        .up_to(MOST_OF_GAMMA),
    ]
}

/// κ, a, d, F of a contact over any numbers.
fn state<R: Real>(n: R, kappa: R, [c, e, w]: [R; 3]) -> Result<[R; 4]> {
    let contact = Contact::new(PowerLaw::with_kappa(n, c, kappa.clone())?, Material::new(e, w)?);
    let critical = contact.critical(&Control::Indentation)?;
    Ok([kappa, critical.contact_radius, critical.indentation, critical.force])
}

/// The critical state that is asked for.
fn asked((p, q): Fraction) -> Result<certified::Question> {
    let [c, e, w] = SCALES.map(literal);
    let (n, elasticity) = (literal(&format!("{p}/{q}"))?, Elasticity::Effective(e?));
    certified::Question::new(&n, &c?, &elasticity, &w?, &Control::Indentation)
}

/// Numbers of this size have a value or are exact; nothing is known of a logarithm.
fn interval(number: Enclosure, precision: Precision) -> Interval {
    match number {
        Enclosure::Value(value) => value,
        Enclosure::Exact(value) => Interval::from_rational(precision, &value),
        Enclosure::Log { .. } => Interval::entire(precision),
    }
}

fn critical_states(n: Fraction) -> Vec<Entry> {
    let with = move |kappa: fn(&Float) -> Result<Float>| {
        move |digits| -> Result<Solver> {
            let float = |value: Rational| Float::with_val(working(digits).bits(), value);
            let n = float(Rational::from(n));
            let [c, e, w] = SCALES.map(rational);
            let scales = [float(c?), float(e?), float(w?)];
            Ok(Box::new(move || Ok(state(n.clone(), kappa(&n)?, scales.clone())?.map(Found::Number).into())))
        }
    };
    vec![
        Entry::new("certified, as enclosures", Arithmetic::Certified, move |digits| {
            let question = asked(n)?;
            Ok(Box::new(move || {
                let precision = working(digits);
                let found = question.enclosures(precision)?;
                Ok(found.map(|number| Found::Enclosure(interval(number, precision))).into())
            }))
        }),
        Entry::new("certified, in decimals", Arithmetic::Certified, move |digits| {
            let question = asked(n)?;
            Ok(Box::new(move || {
                let answer = question.answer(digits + 1)?;
                let state = answer.critical.into_iter();
                let numbers = state.flat_map(|state| [state.contact_radius, state.indentation, state.force]);
                Ok(std::iter::once(answer.kappa).chain(numbers).map(Found::Decimal).collect())
            }))
        }),
        Entry::new("mp", Arithmetic::Mp, with(kappa)),
        Entry::new("mp, MPFR's Γ", Arithmetic::Mp, with(|n| Ok(by_gamma(n)))).up_to(MOST_OF_GAMMA),
    ]
}
