//! The grid: exponents and scales of the cases.
//!
//! Exponents go round four families: log-uniform on [10⁻³, 10³] with both ends; 1/2 ± 2⁻ᵏ; small fractions; uniform in
//! the range of real bodies. Scales go round two: E*, w and the critical radius independent over sixty decades, and real
//! pairs of bodies. C follows from the critical radius, so that near n = 1/2, where a_c changes by hundreds of decades
//! with the last digit of C, the questions still have an answer. A case that f64 could not hold is not drawn for f64.

use std::fmt;

use mdr_analytic::{Kappa, PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::Real;
use rug::Float;

use crate::arithmetic::Arithmetic;
use crate::checks::ln_kappa;
use crate::tolerance::Tangent;
use crate::trial::Trial;

/// An exponent n, the same number in every arithmetic that can hold it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Exponent {
    /// p/q.
    Fraction(i64, i64),
    /// 1/2 ± 2^−k.
    NearHalf { above: bool, k: i64 },
    /// A double.
    Double(f64),
}

impl Exponent {
    /// n in the arithmetic of `ctx`.
    pub(crate) fn value<R: Real>(&self, ctx: R::Ctx) -> R {
        match *self {
            Exponent::Fraction(p, q) => R::from_int(ctx, p).over(q),
            Exponent::NearHalf { above, k } => {
                let offset = R::from_int(ctx, 2).powi(-k);
                let half = R::from_int(ctx, 1).over(2);
                if above { half + &offset } else { half - &offset }
            }
            Exponent::Double(n) => R::from_f64(ctx, n),
        }
    }
}

impl fmt::Display for Exponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Exponent::Fraction(p, 1) => write!(f, "{p}"),
            Exponent::Fraction(p, q) => write!(f, "{p}/{q}"),
            Exponent::NearHalf { above, k } => write!(f, "1/2{}2^-{k}", if *above { '+' } else { '-' }),
            Exponent::Double(n) => write!(f, "{n:e}"),
        }
    }
}

/// Small fractions: the profiles with a name, and both sides of every special exponent.
const FRACTIONS: [(i64, i64); 12] =
    [(2, 1), (1, 4), (1, 1), (3, 2), (1, 3), (3, 1), (3, 4), (2, 5), (4, 1), (1, 10), (6, 1), (5, 2)];

/// Which exponents a check can take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    /// The smallest n.
    pub(crate) least: f64,
    /// The largest n.
    pub(crate) most: f64,
    /// The largest k of 1/2 ± 2^−k.
    pub(crate) nearest: i64,
}

impl Family {
    /// All of the grid, up to 1/2 ± 2^−k.
    pub(crate) const fn up_to(nearest: i64) -> Self {
        Family { least: 1e-3, most: 1e3, nearest }
    }
}

impl Trial<'_> {
    /// The exponent of the given round of the grid, never 1/2 itself.
    pub(crate) fn exponent(&mut self, round: usize, family: Family) -> Exponent {
        let Family { least, most, nearest } = family;
        let turn = round / 4;
        let drawn = match round % 4 {
            0 if turn == 0 => Exponent::Double(least),
            0 if turn == 1 => Exponent::Double(most),
            0 => Exponent::Double(self.uniform(least.ln(), most.ln()).exp()),
            // 7 steps a turn reach every k, small and large ones early.
            1 => Exponent::NearHalf {
                above: turn.is_multiple_of(2),
                k: 2 + (7 * (turn as i64 / 2)) % (nearest - 1).max(1),
            },
            2 => {
                let (p, q) = FRACTIONS[turn % FRACTIONS.len()];
                Exponent::Fraction(p, q)
            }
            _ => Exponent::Double(self.uniform(0.1, 4.0)),
        };
        let n: f64 = drawn.value(());
        if n == 0.5 || n < least || n > most {
            Exponent::Double(self.uniform(least.ln(), most.ln()).exp())
        } else {
            drawn
        }
    }
}

/// E* in Pa, w in J/m² and a radius in m of real contacts.
const BODIES: [(&str, f64, f64, f64); 6] = [
    ("PDMS bead", 1.3e6, 0.05, 1e-5),
    ("AFM tip", 7e10, 0.1, 2e-9),
    ("gecko spatula", 2e9, 0.05, 1e-7),
    ("tyre tread", 5e6, 0.06, 1e-4),
    ("gelatine", 3e3, 0.02, 1e-3),
    ("asperity of steel", 1.1e11, 1.0, 1e-8),
];

/// The widest scales of the grid: 10^±DECADES.
const DECADES: f64 = 30.0;

/// The decades of aⁿ that an f64 case may span: N², E*√B a^{3/2} and quadrature nodes then stay in range.
const F64_DECADES: f64 = 60.0;

/// A power-law contact of the grid, in one arithmetic.
#[derive(Clone, Debug)]
pub(crate) struct Scene<R> {
    /// n.
    pub(crate) n: R,
    /// C, in m^(1−n).
    pub(crate) c: R,
    /// E*, in Pa.
    pub(crate) e_star: R,
    /// w, in J/m².
    pub(crate) work: R,
}

/// E*, w and a radius, in SI units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    /// E*, in Pa.
    pub(crate) e_star: f64,
    /// w, in J/m².
    pub(crate) work: f64,
    /// Where the contact shall be critical, in m.
    pub(crate) radius: f64,
}

impl Trial<'_> {
    /// The scales of the given round of the grid, for an exponent and an arithmetic.
    pub(crate) fn scales<R: Arithmetic>(&mut self, round: usize, exponent: Exponent) -> Scales {
        let n = exponent.value::<f64>(());
        let decades = if R::NAME == f64::NAME { DECADES.min(F64_DECADES / (n + 1.0)) } else { DECADES };
        if round % 3 == 2 {
            let (_, e_star, work, radius) = BODIES[round / 3 % BODIES.len()];
            // A radius in nanometres to the power 1000 is out of the range of f64.
            Scales { e_star, work, radius: radius.max(10_f64.powf(-decades)) }
        } else {
            let mut draw = |decades: f64| 10_f64.powf(self.uniform(-decades, decades));
            Scales { e_star: draw(DECADES), work: draw(DECADES), radius: draw(decades) }
        }
    }

    /// The contact with the given exponent and scales whose state of tangency λ (1 is the critical state under fixed
    /// grips, 3 under a dead load) is near the radius of the scales. Writes its inputs down.
    pub(crate) fn planted<R: Arithmetic>(
        &mut self,
        exponent: Exponent,
        lambda: f64,
        scales: Scales,
        ctx: R::Ctx,
    ) -> Scene<R> {
        let c = planted_coefficient(exponent, lambda, scales);
        let Scales { e_star, work, .. } = scales;
        let digits = c.to_string_radix(10, Some(17));
        let name = R::NAME;
        self.describe(format_args!("n = {exponent}, C = {digits}, E* = {e_star:e}, w = {work:e} ({name})"));
        Scene {
            n: exponent.value(ctx),
            c: R::round(ctx, &c),
            e_star: R::from_f64(ctx, e_star),
            work: R::from_f64(ctx, work),
        }
    }

    /// A contact of the given round of the grid.
    ///
    /// C is such that the state with tangency λ is near a drawn radius: towards n = 1/2 the critical radii of the two
    /// controls are more decades apart than f64 has.
    pub(crate) fn scene<R: Arithmetic>(
        &mut self,
        round: usize,
        exponent: Exponent,
        lambda: f64,
        ctx: R::Ctx,
    ) -> Scene<R> {
        let scales = self.scales::<R>(round, exponent);
        self.planted(exponent, lambda, scales, ctx)
    }
}

/// C = λ√(πw/(2E*)) a^{1/2−n}/(nκ_n), rounded to 53 bits.
fn planted_coefficient(exponent: Exponent, lambda: f64, scales: Scales) -> Float {
    let Scales { e_star, work, radius } = scales;
    let number = |x: f64| Float::with_val(WORKING_BITS, x);
    let n: Float = exponent.value(number(1.0).ctx());
    let edge = n.pi() * number(work) / (number(e_star) * 2_u32);
    let ln_c = edge.ln().over(2) + number(radius).ln() * (n.ratio(1, 2) - &n) - ln_kappa(&n) - n.ln();
    Float::with_val(f64::MANTISSA_DIGITS, ln_c.exp() * lambda)
}

/// Enough for 1/2 ± 2⁻⁶⁰ and for powers of radii over tens of thousands of decades.
const WORKING_BITS: u32 = 192;

impl<R> Scene<R> {
    /// Converts the contact to another arithmetic.
    pub(crate) fn map<S>(&self, convert: impl Fn(&R) -> S) -> Scene<S> {
        let [n, c, e_star, work] = [&self.n, &self.c, &self.e_star, &self.work].map(convert);
        Scene { n, c, e_star, work }
    }
}

impl<R: Kappa> Scene<R> {
    /// The closed forms of this contact.
    pub(crate) fn contact(&self) -> Result<PowerLawContact<R>> {
        Ok(PowerLawContact::new(PowerLaw::new(self.n.clone(), self.c.clone())?, self.material()?))
    }

    /// Its material.
    pub(crate) fn material(&self) -> Result<Material<R>> {
        Material::new(self.e_star.clone(), self.work.clone())
    }

    /// The contact in a unit of length s times smaller, the unit of force kept; `s_to_one_minus_n` is s^(1−n).
    pub(crate) fn in_smaller_unit(&self, s: &R, s_to_one_minus_n: &R) -> Self {
        let Scene { n, c, e_star, work } = self.clone();
        Scene { n, c: c * s_to_one_minus_n, e_star: e_star / s.square(), work: work / s }
    }

    /// Where the conditions of a state with tangency λ and radius `a` are taken.
    pub(crate) fn tangent(&self, lambda: f64, a: &R) -> Tangent {
        Tangent { n: self.n.approx(), lambda, ln_a: a.ln().approx() }
    }
}

/// A control with a critical state in closed form, and its tangency λ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Held {
    /// Fixed grips.
    Indentation,
    /// Dead load.
    Force,
}

impl Held {
    /// Both.
    pub(crate) const BOTH: [Held; 2] = [Held::Indentation, Held::Force];

    /// The one that belongs to this control, of two.
    pub(crate) fn of<T>(self, [indentation, force]: [T; 2]) -> T {
        match self {
            Held::Indentation => indentation,
            Held::Force => force,
        }
    }

    /// The control.
    pub(crate) fn control<R>(self) -> Control<R> {
        self.of([Control::Indentation, Control::Force])
    }

    /// λ of its critical state.
    pub(crate) fn lambda(self) -> f64 {
        self.of([1.0, 3.0])
    }
}

impl Trial<'_> {
    /// One of the two controls.
    pub(crate) fn held(&mut self) -> Held {
        if self.uniform(0.0, 1.0) < 0.5 { Held::Indentation } else { Held::Force }
    }
}

impl fmt::Display for Held {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.of(["indentation", "force"]))
    }
}
