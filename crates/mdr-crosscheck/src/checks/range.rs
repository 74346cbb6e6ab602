//! Certified digits over the whole range of exponents, 10⁻³⁰⁰ to 10³⁰⁰, up to thousands of digits.
//!
//! The rules for an expansion (how many terms, how many bits for each) must hold even where doubles overflow. So κ_n is
//! computed again with none of its code, by the series of positive terms where n is small beside the bits, else by ln Γ of
//! MPFR, and a, d and F from it by logarithms, all over intervals.

use mdr_analytic::PowerLaw;
use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::certify::{Decimal, Enclosure};
use mdr_core::number::{Interval, Precision, Real};
use rug::{Float, Integer, Rational};

use super::certified::Exact;
use super::common::literal;
use super::kappa::{by_series, ln_kappa};
use crate::grid::Scene;
use crate::trial::Trial;

impl Exact {
    /// Exponents go round six families, the ends of the range first.
    fn draw_widely(trial: &mut Trial<'_>) -> Result<Self> {
        let turn = trial.index / 6;
        let sign = ["-", ""][trial.below(2) as usize];
        let places = 1 + trial.below([3, 20, 200][turn % 3]);
        // As close to a fraction as 10⁻²⁰⁰: a decimal of so many places.
        let beside = |p: u64, q: u64| {
            let offset = rational(&format!("{sign}1e-{places}"))?;
            Ok((Rational::from((p, q)) + offset).abs())
        };
        let n = match trial.index % 6 {
            0 if turn < 2 => rational(["1e300", "1e-300"][turn])?,
            0 => rational(&format!("1e{}", trial.between(-300, 300)))?,
            1 => trial.decimal(-300, 299)?,
            2 => beside(1, 2)?,
            3 => beside(1 + trial.below(300), 1)?,
            4 => beside(1 + trial.below(200), 1 + trial.below(12))?,
            _ => Rational::from((1 + 2 * trial.below(100), 1 + 2 * trial.below(10))),
        };
        let n = if n == 0 || n == 0.5 { n + 1u32 } else { n };
        let mut scale = || trial.decimal(-30, 30);
        let scene = Scene { n, c: scale()?, e_star: scale()?, work: scale()? };
        let held = trial.held();
        let Scene { n, c, e_star, work } = scene.map(|input| Float::with_val(60, input).to_string_radix(10, Some(15)));
        trial.describe(format_args!("n ≈ {n}, C = {c}, E* = {e_star}, w = {work}, {held}"));
        Ok(Exact { scene, held })
    }

    /// ln κ, ln a, ln|d| and ln|F| from (1.15) and (1.17); `None` for d if it is 0.
    fn logarithms(&self, bits: u32) -> [Option<Interval>; 4] {
        let enclose = |x: &Rational| Interval::from_rational(Precision::new(bits), x);
        let ln = |x: &Rational| enclose(x).ln();
        let Scene { n, c, e_star, work } = &self.scene;
        let tension = Rational::from(self.held.lambda() as i64);
        let kappa = kappa(n, bits).ln();
        let [twice, next] = [Rational::from(n * 2u32), Rational::from(n + 1u32)];
        let edge = enclose(n).pi().ln() + ln(&(Rational::from(work / e_star) / 2u32));
        let slope = kappa.clone() + ln(&Rational::from(n * c));
        let radius = (edge.clone() + (ln(&tension) - slope).times(2)) / enclose(&(twice.clone() - 1u32));
        let root = (edge + &radius).over(2);
        let depth = (Rational::from(&tension - &twice) / n).abs();
        let force = (tension - Rational::from(&next * 2u32)) * 2u32 / next * e_star;
        let force = ln(&force.abs()) + &radius + &root;
        let depth = (!depth.is_zero()).then(|| ln(&depth) + root);
        [Some(kappa), Some(radius), depth, Some(force)]
    }

    /// Whether d and F are negative.
    fn signs(&self) -> [bool; 2] {
        let (n, tension) = (&self.scene.n, self.held.lambda());
        [Rational::from(n * 2u32) > tension, Rational::from(n + 1u32) * 2u32 > tension]
    }

    /// Bits that the results lose: by the size of n, and by its distance from 1/2.
    fn magnification(&self) -> u32 {
        let n = &self.scene.n;
        let excess = (Rational::from(n * 2u32) - 1u32).abs();
        let size = |x: &Integer| x.significant_bits();
        2 * size(excess.denom()).saturating_sub(size(excess.numer())) + size(n.numer()).abs_diff(size(n.denom()))
    }
}

impl Trial<'_> {
    /// An integer from 0 to count − 1.
    fn below(&mut self, count: u64) -> u64 {
        self.uniform(0.0, count as f64) as u64
    }

    fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as u64) as i64
    }

    /// A decimal of 1 to 30 digits with an exponent between two.
    fn decimal(&mut self, low: i64, high: i64) -> Result<Rational> {
        let digits: String = (0..self.below(30)).map(|_| char::from(b'0' + self.below(10) as u8)).collect();
        rational(&format!("{}.{digits}e{}", 1 + self.below(9), self.between(low, high)))
    }

    /// From 20 to 3000 digits, the larger numbers seldom: they take most of the time.
    fn many_digits(&self) -> u32 {
        const DIGITS: [u32; 12] = [1000, 340, 20, 480, 100, 3000, 50, 700, 200, 33, 500, 340];
        DIGITS[(self.index / 6) % DIGITS.len()]
    }
}

fn rational(text: &str) -> Result<Rational> {
    literal(text).map(|literal| literal.to_rational())
}

/// κ_n to about so many bits.
fn kappa(n: &Rational, bits: u32) -> Interval {
    let working = |bits: u32| Interval::from_rational(Precision::new(bits), n);
    if *n < bits {
        return by_series(&working(bits + 64));
    }
    // Γ(1+x)/Γ(x+1/2), x = n/2: ln Γ is of the size of n ln n.
    let size = n.numer().significant_bits().saturating_sub(n.denom().significant_bits());
    ln_kappa(&working(bits + size + 64)).exp()
}

/// Digits against the second algorithm, in units of the last decimal: half of one, and the uncertainty of the reference.
pub(super) fn digits(trial: &mut Trial<'_>) -> Result<()> {
    /// The uncertainty that the reference may have, in units of the last digit.
    const SHARP: f64 = 1e-12;
    let exact = Exact::draw_widely(trial)?;
    let digits = trial.many_digits();
    trial.describe_also(format_args!("{digits} digits"));
    let answer = exact.question()?.answer(digits)?;
    let Some(state) = &answer.critical else { return Ok(()) };
    let found = [&answer.kappa, &state.contact_radius, &state.indentation, &state.force];
    trial.demand("the sign of d", found[2].is_zero() || found[2].is_negative() == exact.signs()[0]);
    trial.demand("the sign of F", found[3].is_negative() == exact.signs()[1]);
    let mut bits = Precision::from_digits(digits).bits() + 128 + exact.magnification();
    let errors = loop {
        let expected = exact.logarithms(bits);
        let errors = [0, 1, 2, 3].map(|i| Some(units(found[i], expected[i].as_ref()?)));
        let sharp = |error: &Option<Interval>| error.as_ref().is_none_or(|error| error.radius() < SHARP);
        if errors.iter().all(sharp) {
            break errors;
        }
        bits *= 2;
        if bits > 1 << 20 {
            return Err(Error::Undecided {
                quantity: Quantity::Kappa,
                bits,
                what: "the digits by the second algorithm",
            });
        }
    };
    trial.demand("d is 0", errors[2].is_some() != found[2].is_zero());
    for (name, error) in ["κ", "a", "d", "F"].iter().zip(errors) {
        let Some(error) = error else { continue };
        trial.enter(*name, error.abs().upper().to_f64(), 0.5 + 2.0 * SHARP);
    }
    Ok(())
}

/// e^ln less the magnitude of a decimal, in units of its last digit.
fn units(decimal: &Decimal, ln: &Interval) -> Interval {
    let digits = Interval::from_rational(ln.ctx(), &decimal.digits().parse::<Rational>().unwrap_or_default());
    let places = decimal.exponent() + 1u32 - decimal.digits().len() as u32;
    let scale = ln.lit(10).ln() * Interval::from_rational(ln.ctx(), &Rational::from(places));
    (ln.clone() - digits.ln() - scale).exp_m1() * digits
}

/// An enclosure as an interval, that of the logarithm where it has only that.
fn interval(enclosure: &Enclosure) -> Interval {
    match enclosure {
        Enclosure::Value(interval) | Enclosure::Log { ln_magnitude: interval, .. } => interval.clone(),
        Enclosure::Exact(value) => Interval::from_rational(Precision::new(64), value),
    }
}

/// Enclosures at p bits and at 2p bits, and that of κ_n against the second algorithm.
pub(super) fn enclosures(trial: &mut Trial<'_>) -> Result<()> {
    /// Bits that an enclosure may lose beside those of the condition.
    const LOST: i64 = 24;
    let exact = Exact::draw_widely(trial)?;
    let bits = Precision::from_digits(trial.many_digits()).bits();
    trial.describe_also(format_args!("{bits} and {} bits", 2 * bits));
    let question = exact.question()?;
    let Scene { n, c, .. } = &exact.scene;
    let lost = LOST + i64::from(exact.magnification());
    let precision = |bits| Precision::new(bits + exact.magnification());
    let at = |bits: u32| -> Result<Vec<Enclosure>> {
        let enclose = |x: &Rational| Interval::from_rational(precision(bits), x);
        let profile = PowerLaw::new(enclose(n), enclose(c))?;
        let mut found = question.enclosures(precision(bits))?.to_vec();
        // g(1) = κC, and κ with n for an interval.
        found.push((profile.g(&profile.kappa().lit(1))? / profile.coefficient()).into());
        found.push(mdr_analytic::kappa_enclosure(precision(bits), n).into());
        Ok(found)
    };
    let (short, long) = (at(bits)?, at(2 * bits)?);
    let reference = kappa(n, 2 * bits + 128);
    for (i, name) in ["κ", "a", "d", "F", "g(1)/C", "κ_n"].iter().enumerate() {
        let is_tight =
            |found: &Enclosure, bits: u32| found.accuracy_bits().is_some_and(|sharp| sharp >= i64::from(bits) - lost);
        let tight = is_tight(&short[i], bits) && is_tight(&long[i], 2 * bits);
        let [short, long] = [&short[i], &long[i]].map(interval);
        trial.demand(format!("{name} agrees"), short.overlaps(&long));
        trial.demand(format!("{name} is tight"), tight);
        if [0, 4, 5].contains(&i) {
            trial.demand(format!("{name} is κ"), short.overlaps(&reference) && long.overlaps(&reference));
        }
    }
    Ok(())
}
