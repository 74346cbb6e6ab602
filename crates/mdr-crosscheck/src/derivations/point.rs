//! Random rational points, and formulas evaluated there in rigorous intervals.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use mdr_core::number::{Interval, Precision, Real, Special};
use mdr_symbolic::formula::{Evaluator, Function};
use mdr_symbolic::{Domain, Formula, Symbol};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};
use rug::Rational;

use super::{BITS, functions, turn};

/// Exact values for n and for every symbol. Formulas are evaluated there in intervals.
#[derive(Clone, Debug)]
pub struct SamplePoint {
    n: Rational,
    values: BTreeMap<Symbol, Rational>,
    /// Symbols that are known as intervals only.
    enclosed: BTreeMap<Symbol, Interval>,
    /// Whether a formula evaluated here has certainly no value.
    undefined: Cell<bool>,
}

impl SamplePoint {
    /// The value of n.
    pub fn exponent(&self) -> &Rational {
        &self.n
    }

    /// The value of a symbol of this name; 1 when there is none.
    pub fn value(&self, name: &str) -> Rational {
        let value = Symbol::named(name).and_then(|symbol| self.values.get(&symbol));
        value.cloned().unwrap_or_else(|| Rational::from(1))
    }

    /// This point with an enclosed value for the symbol of this name.
    pub fn with(&self, name: &str, value: &Interval) -> Self {
        let mut point = self.clone();
        point.enclosed.extend(Symbol::named(name).map(|symbol| (symbol, value.clone())));
        point
    }

    /// Whether a formula that was evaluated here divides by 0 or takes a root of a negative number.
    pub fn is_undefined(&self) -> bool {
        self.undefined.get()
    }

    /// Notes that an operation has certainly no value.
    pub(super) fn note(&self, undefined: bool) {
        self.undefined.set(self.undefined.get() || undefined);
    }

    /// An interval of the precision used here.
    pub fn interval(value: &Rational) -> Interval {
        Interval::from_rational(Precision::new(BITS), value)
    }
}

/// The binary octaves from which n is drawn: it lies between 2^-10 and 2^10.
pub const OCTAVES: std::ops::RangeInclusive<i32> = -10..=9;

/// Random points of a domain, without end. The same words give the same points.
///
/// n is drawn with equal chance from each of the octaves between 2^-10 and 2^10, as are n − 1/2 for n > 1/2, and for n < 1/2,
/// with equal chance, n itself or 1/2 − n between 2^-10 and 1/2. All symbols lie between 0.1 and 10, but
/// for the angle θ < π/2, its sine and its cosine.
#[derive(Debug)]
pub struct SamplePoints {
    random: Xoshiro256PlusPlus,
    domain: Domain,
    fixed: &'static [(&'static str, &'static str)],
}

impl SamplePoints {
    /// SamplePoints for a statement on a domain, some values of which may be fixed.
    pub fn new(words: &str, domain: Domain, fixed: &'static [(&'static str, &'static str)]) -> Self {
        let mut hasher = DefaultHasher::new();
        words.hash(&mut hasher);
        SamplePoints { random: Xoshiro256PlusPlus::seed_from_u64(hasher.finish()), domain, fixed }
    }

    fn fraction(&mut self, numerators: std::ops::RangeInclusive<i64>, denominator: i64) -> Rational {
        Rational::from((self.random.random_range(numerators), denominator))
    }

    fn exponent(&mut self) -> Rational {
        match self.domain {
            Domain::Half => Rational::from((1, 2)),
            Domain::Positive => self.spread(OCTAVES),
            Domain::Above => self.spread(OCTAVES) + Rational::from((1, 2)),
            Domain::Below => {
                let n = self.spread(*OCTAVES.start()..=-2);
                if self.random.random_range(0..2) == 0 { n } else { Rational::from((1, 2)) - n }
            }
        }
    }

    /// A number of one of the octaves.
    fn spread(&mut self, octaves: std::ops::RangeInclusive<i32>) -> Rational {
        self.fraction(97..=193, 97) << self.random.random_range(octaves)
    }
}

/// Makes θ an angle below π/2, and gives its sine and cosine.
fn one_angle(values: &mut BTreeMap<Symbol, Rational>) -> BTreeMap<Symbol, Interval> {
    let angle = Symbol::named("θ").and_then(|symbol| values.get_mut(&symbol));
    // Symbols are below 10.
    let angle = angle.map(|value| std::mem::take(value) * Rational::from((3, 20)));
    let functions =
        angle.iter().map(SamplePoint::interval).flat_map(|angle| [("sinθ", angle.sin()), ("cosθ", angle.cos())]);
    let enclosed = functions.filter_map(|(name, value)| Some((Symbol::named(name)?, value))).collect();
    values.extend(Symbol::named("θ").zip(angle));
    enclosed
}

impl Iterator for SamplePoints {
    type Item = SamplePoint;

    fn next(&mut self) -> Option<SamplePoint> {
        let mut n = self.exponent();
        let mut values: BTreeMap<_, _> = Symbol::all().map(|symbol| (symbol, self.fraction(11..=997, 101))).collect();
        for (name, text) in self.fixed {
            let value = text.parse::<mdr_core::number::Literal>().ok()?.to_rational();
            match Symbol::named(name) {
                Some(symbol) => drop(values.insert(symbol, value)),
                None => n = value,
            }
        }
        let enclosed = one_angle(&mut values);
        Some(SamplePoint { n, values, enclosed, undefined: Cell::new(false) })
    }
}

impl Evaluator for SamplePoint {
    type Value = Interval;

    fn rational(&self, value: &Rational) -> Interval {
        Self::interval(value)
    }
    fn pi(&self) -> Interval {
        Self::interval(&self.n).pi()
    }
    fn n(&self) -> Interval {
        Self::interval(&self.n)
    }
    /// κ and the Gamma functions have their true values.
    fn symbol(&self, symbol: Symbol) -> Interval {
        let of = |value: Rational| Self::interval(&value);
        if let Some(value) = self.enclosed.get(&symbol) {
            return value.clone();
        }
        let n = of(self.n.clone());
        match symbol {
            Symbol::KAPPA => functions::kappa(&n),
            Symbol::GAMMA_LOWER => functions::gamma(&n.over(2)),
            Symbol::GAMMA_UPPER => functions::gamma(&(n.lit(1) + &n).over(2)),
            Symbol::GAMMA_THREE_QUARTERS => functions::gamma(&of(Rational::from((3, 4)))),
            symbol => of(self.value(symbol.name())),
        }
    }
    fn add(&self, left: &Interval, right: &Interval) -> Interval {
        left.clone() + right
    }
    fn multiply(&self, left: &Interval, right: &Interval) -> Interval {
        left.clone() * right
    }
    fn divide(&self, left: &Interval, right: &Interval) -> Interval {
        self.note(right.is_point() && right.contains_zero());
        left.clone() / right
    }
    fn integer_power(&self, base: &Interval, exponent: i32) -> Interval {
        base.powi(i64::from(exponent))
    }
    fn power(&self, base: &Interval, exponent: &Interval) -> Interval {
        self.note(*base < base.lit(0));
        base.pow(exponent)
    }
    fn function(&self, function: Function, arguments: &[Interval]) -> Interval {
        self.note(function == Function::Agm && arguments.iter().any(|argument| *argument < argument.lit(0)));
        functions::value(function, arguments)
    }
    fn quarter_turn(&self, integrand: &Formula) -> Interval {
        turn::quarter_turn(integrand, self)
    }
}
