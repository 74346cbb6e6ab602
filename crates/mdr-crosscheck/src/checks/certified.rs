//! Certified digits: right to half a unit of the last one, and the beginning of every longer answer.

use mdr_analytic::certified::{Elasticity, Question};
use mdr_analytic::{Contact, PowerLaw};
use mdr_core::contact::{Error, Material, Quantity, Result};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Literal, Precision, Real};
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

use super::Run;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::subject::closed::Digits;
use crate::trial::Trial;

/// Certified decimals against the closed forms in arbitrary precision, in units of the last decimal: half of one, for a
/// correctly rounded decimal, and the 2⁻⁴⁰ that the reference may be off.
pub(super) const ROUNDING: Run = ("certified-rounding", rounding);

/// D digits against 2D digits of the same question: the longer answer, rounded, is the shorter.
pub(super) const PREFIX: Run = ("certified-prefix", prefix);

/// The enclosure of κ_n for rational n contains κ_n by Γ and is a few units wide.
pub(super) const ENCLOSURE: Run = ("kappa-enclosure", enclosure);

/// A question with exact inputs: n, C, E* and w.
pub(super) struct Exact {
    pub(super) inputs: [Rational; 4],
    pub(super) held: Held,
}

impl Exact {
    /// Every sixth question is about n = 1/2.
    fn draw(trial: &mut Trial<'_>) -> Self {
        let (round, held) = (trial.index / 2, trial.held());
        let scale_free = trial.index % 6 == 5;
        let exponent = if scale_free { Exponent::Fraction(1, 2) } else { trial.exponent(round, Family::up_to(50)) };
        let scene: Scene<f64> = trial.scene(round, exponent, held.lambda(), ());
        trial.describe_also(format_args!("{held}"));
        let [c, e_star, work] = [scene.c, scene.e_star, scene.work].map(rational);
        Exact { inputs: [fraction(exponent), c, e_star, work], held }
    }

    pub(super) fn question(&self) -> Result<Question> {
        let [n, c, e_star, work] = self.inputs.each_ref().map(|input| literal(&input.to_string()));
        Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &self.held.control())
    }

    /// The closed forms at the given precision.
    fn contact(&self, precision: Precision) -> Result<Contact<Float>> {
        let [n, c, e_star, work] = self.inputs.each_ref().map(|x| Float::with_val(precision.bits(), x));
        Ok(Contact::new(PowerLaw::new(n, c)?, Material::new(e_star, work)?))
    }
}

/// A double as a fraction.
pub(super) fn rational(x: f64) -> Rational {
    Rational::from_f64(x).unwrap_or_default()
}

/// The exponent as a fraction: p/q itself, where it is one, and not the double nearest to it.
fn fraction(exponent: Exponent) -> Rational {
    match exponent {
        Exponent::Fraction(p, q) => Rational::from((p, q)),
        _ => rational(exponent.value::<f64>(())),
    }
}

/// The number that is written.
pub(crate) fn literal(text: &str) -> Result<Literal> {
    let quantity = Quantity::Parameter("an input of the grid");
    text.parse().map_err(|_| Error::Domain { quantity, value: text.to_owned(), requirement: "a number" })
}

/// From one digit to two hundred.
fn digits(trial: &Trial<'_>) -> u32 {
    [20, 1, 50, 5, 17, 100, 200][trial.index % 7]
}

fn rounding(trial: &mut Trial<'_>) -> Result<()> {
    let exact = Exact::draw(trial);
    let digits = digits(trial);
    trial.describe_also(format_args!("{digits} digits"));
    let answer = trial.closed.certified(&exact.question()?, digits)?;
    // 2⁻⁵⁰ magnified, ln a below 2⁷ and 64 bits to spare.
    let precision = Precision::new(Precision::from_digits(digits).bits() + 50 + 8 + 64);
    let contact = exact.contact(precision)?;
    let mut compare = |name: &str, found: &Digits, expected: &Float| {
        if found.decimal.is_zero() {
            return;
        }
        let place = found.decimal.exponent() - (digits - 1);
        let place = Float::with_val(precision.bits(), 10).powi(place.to_i64().unwrap_or(i64::MAX));
        let error = ((found.value.clone() - expected) / place).abs().approx();
        trial.enter(name, error, 0.5 + 1e-12);
    };
    compare("κ", &answer.kappa, contact.profile().kappa());
    if let Some(state) = &answer.critical {
        let expected = contact.critical(&exact.held.control())?;
        compare("a", &state.contact_radius, &expected.contact_radius);
        compare("d", &state.indentation, &expected.indentation);
        compare("F", &state.force, &expected.force);
    }
    if let (Some(threshold), Some(ratio)) = (&answer.threshold, &answer.ratio) {
        let expected = mdr_analytic::threshold(contact.material(), &exact.held.control())?;
        compare("threshold", threshold, &expected);
        compare("ratio", ratio, &(contact.profile().coefficient().clone() / &expected));
    }
    Ok(())
}

fn prefix(trial: &mut Trial<'_>) -> Result<()> {
    let exact = Exact::draw(trial);
    let digits = digits(trial);
    trial.describe_also(format_args!("{digits} and {} digits", 2 * digits));
    let question = exact.question()?;
    let (short, long) = (question.answer(digits)?, question.answer(2 * digits)?);
    let mut demand = |name: &str, short: &Decimal, long: &Decimal| {
        trial.demand(name, agree(short, long, digits));
    };
    demand("κ", &short.kappa, &long.kappa);
    if let (Some(short), Some(long)) = (&short.critical, &long.critical) {
        demand("a", &short.contact_radius, &long.contact_radius);
        demand("d", &short.indentation, &long.indentation);
        demand("F", &short.force, &long.force);
    }
    if let (Some(short), Some(long)) = (&short.threshold, &long.threshold) {
        demand("threshold", short, long);
    }
    Ok(())
}

/// Whether the shorter decimal is within half a unit of its last digit of the longer one. The borders between its
/// values are decimals of the longer grid, which rounding does not cross; equality is a tie of the longer one.
fn agree(short: &Decimal, long: &Decimal, digits: u32) -> bool {
    let exact = |decimal: &Decimal| decimal.to_string().parse().map(|text: Literal| text.to_rational());
    let (Ok(short_value), Ok(long)) = (exact(short), exact(long)) else { return false };
    let place: i32 = (short.exponent() + 1u32 - digits).to_i32().unwrap_or(i32::MAX);
    let ten = Rational::from(10);
    short.digits().trim_end_matches('0').len() <= digits as usize && (short_value - long).abs() * 2u32 <= ten.pow(place)
}

fn enclosure(trial: &mut Trial<'_>) -> Result<()> {
    let round = trial.index;
    let exponent = trial.exponent(round, Family::up_to(50));
    let bits = [53, 64, 167, 400, 1000][round % 5];
    trial.describe(format_args!("n = {exponent}, {bits} bits"));
    let n = fraction(exponent);
    let (mid, radius) = trial.closed.kappa_enclosure(Precision::new(bits), &n);
    let reference = super::kappa::by_gamma(&Float::with_val(bits + 32, &n));
    trial.demand(
        "contains κ",
        (mid.clone() - &reference).abs() <= radius.clone() + reference.clone() / (Integer::from(1) << (bits + 24)),
    );
    trial.demand("is tight", radius < mid / (Integer::from(1) << (bits - 5)));
    Ok(())
}
