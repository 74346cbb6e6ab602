//! Certified digits: right to half a unit of the last one, and the beginning of every longer answer.

use mdr_analytic::PowerLawContact;
use mdr_analytic::certified::{Elasticity, Question};
use mdr_core::contact::{Regime, Result};
use mdr_core::number::certify::Decimal;
use mdr_core::number::{Literal, Precision, Real};
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

use super::common::{literal, rational};
use crate::grid::{Exponent, Family, Held, Scene};
use crate::subject::closed::numbers;
use crate::trial::Trial;

/// A question with exact inputs.
pub(super) struct Exact {
    pub(super) scene: Scene<Rational>,
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
        Exact { scene: Scene { n: fraction(exponent), ..scene.map(|x| rational(*x)) }, held }
    }

    pub(super) fn question(&self) -> Result<Question> {
        let Scene { n, c, e_star, work } = self.scene.map(|input| literal(&input.to_string()));
        Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &self.held.control())
    }

    /// The closed forms at the given precision.
    fn contact(&self, precision: Precision) -> Result<PowerLawContact<Float>> {
        self.scene.map(|x| Float::with_val(precision.bits(), x)).contact()
    }
}

/// The exponent as a fraction: p/q itself, where it is one, and not the double nearest to it.
fn fraction(exponent: Exponent) -> Rational {
    match exponent {
        Exponent::Fraction(p, q) => Rational::from((p, q)),
        _ => rational(exponent.value::<f64>(())),
    }
}

/// From one digit to two hundred.
fn digits(trial: &Trial<'_>) -> u32 {
    [20, 1, 50, 5, 17, 100, 200][trial.index % 7]
}

/// Certified decimals against the closed forms in arbitrary precision, in units of the last decimal: half of one, for a
/// correctly rounded decimal, and the 2⁻⁴⁰ that the reference may be off.
pub(super) fn rounding(trial: &mut Trial<'_>) -> Result<()> {
    let exact = Exact::draw(trial);
    let digits = digits(trial);
    trial.describe_also(format_args!("{digits} digits"));
    // 2⁻⁵⁰ magnified, ln a below 2⁷ and 64 bits to spare.
    let precision = Precision::new(Precision::from_digits(digits).bits() + 50 + 8 + 64);
    let (contact, control) = (exact.contact(precision)?, exact.held.control());
    let mut expected = vec![contact.profile().kappa().clone()];
    if contact.regime()? == Regime::ScaleFree {
        let threshold = mdr_analytic::threshold(contact.material(), &control)?;
        let ratio = contact.profile().coefficient().clone() / &threshold;
        expected.extend([threshold, ratio]);
    } else {
        let state = contact.critical(&control)?;
        expected.extend([state.contact_radius, state.indentation, state.force]);
    }
    for ((name, decimal, found), expected) in trial.closed.certified(&exact.question()?, digits)?.zip(expected) {
        if decimal.is_zero() {
            continue;
        }
        let place = decimal.exponent() - (digits - 1);
        let place = Float::with_val(precision.bits(), 10).powi(place.to_i64().unwrap_or(i64::MAX));
        trial.enter(name, ((found - expected) / place).abs().approx(), 0.5 + 1e-12);
    }
    Ok(())
}

/// D digits against 2D digits of the same question: the longer answer, rounded, is the shorter.
pub(super) fn prefix(trial: &mut Trial<'_>) -> Result<()> {
    let exact = Exact::draw(trial);
    let digits = digits(trial);
    trial.describe_also(format_args!("{digits} and {} digits", 2 * digits));
    let question = exact.question()?;
    let both = numbers(question.answer(digits)?).zip(numbers(question.answer(2 * digits)?));
    for ((_, name, short), (.., long)) in both.filter(|((_, name, _), _)| *name != "ratio") {
        trial.demand(name, agree(&short, &long, digits));
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

/// The enclosure of κ_n for rational n contains κ_n by Γ and is a few units wide.
pub(super) fn enclosure(trial: &mut Trial<'_>) -> Result<()> {
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
