//! Certified decimals of the closed forms, from intervals.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Error, Fold, FoldKind, Quantity, Regime, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify, require_digits};
use mdr_core::number::{Interval, Literal, Precision, Real};
use rug::{Integer, Rational};

use super::{Answer, Question, exact};
use crate::contact::PowerLawContact;
use crate::newton::undecided;
use crate::state::State;
use crate::threshold::threshold;

/// Bits beyond those of the digits: for rounding errors, and the small chance that the digits end close to a tie.
const GUARD: u32 = 40;

/// The most bits that may be lost to an exponent close to 1/2: |2n−1| down to about 10⁻²⁰⁰⁰⁰.
const MOST_MAGNIFICATION: f64 = 65_536.0;

/// κ_n to the given number of significant digits, correctly rounded.
///
/// ```
/// let third = "1/3".parse()?;
/// assert_eq!(mdr_analytic::certified::kappa(&third, 30)?.to_string(), "1.21432532394379080590997084489");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n is positive and the digits are within 1 to 10⁶.
pub fn kappa(n: &Literal, digits: u32) -> Result<Decimal> {
    if n.is_zero() || n.is_negative() {
        let value = n.to_string();
        return Err(Error::Domain { quantity: Quantity::Exponent, value, requirement: "positive and finite" });
    }
    let n = n.to_rational();
    let start = bits_for(digits)?;
    let [kappa] = certify([Quantity::Kappa], digits, start, |precision| Ok([kappa_result(precision, &n)]))?;
    Ok(kappa)
}

impl Question {
    /// All answers, each correctly rounded to the given number of significant digits (ties to even).
    ///
    /// # Errors
    /// [`Error::Domain`] for digits outside 1 to 10⁶. [`Error::Undecided`] for |2n−1| below about 10⁻²⁰⁰⁰⁰, for a tie
    /// that number theory does not exclude, or for two folds so close to merging that no precision up to the limit
    /// separates them.
    pub fn answer(&self, digits: u32) -> Result<Answer> {
        let start = self.starting_precision(digits)?;
        let regime = self.regime();
        if let Control::Machine { .. } = self.control {
            return self.machine_answer(regime, digits, start);
        }
        if regime == Regime::ScaleFree {
            return self.scale_free_answer(digits, start);
        }
        let quantities = [Quantity::Kappa, Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
        let [kappa, a, d, f] = certify(quantities, digits, start, |precision| self.critical(precision))?;
        let critical = Some(State { contact_radius: a, indentation: d, force: f });
        Ok(Answer { regime, kappa, critical, folds: Vec::new(), threshold: None, ratio: None })
    }

    fn regime(&self) -> Regime {
        match self.exponent.partial_cmp(&0.5) {
            Some(Ordering::Greater) => Regime::PullOff,
            Some(Ordering::Less) => Regime::CompleteContact,
            _ => Regime::ScaleFree,
        }
    }

    fn scale_free_answer(&self, digits: u32, start: Precision) -> Result<Answer> {
        let quantities =
            [Quantity::Kappa, Quantity::Coefficient, Quantity::Parameter("the ratio of C to its threshold")];
        let [kappa, threshold, ratio] = certify(quantities, digits, start, |precision| {
            let contact = self.contact(precision)?;
            let threshold = threshold(contact.material(), &self.control(precision))?;
            let ratio = contact.profile().coefficient().clone() / &threshold;
            Ok([self.kappa_of(&contact), threshold.into(), ratio.into()])
        })?;
        let (threshold, ratio) = (Some(threshold), Some(ratio));
        Ok(Answer { regime: Regime::ScaleFree, kappa, critical: None, folds: Vec::new(), threshold, ratio })
    }

    fn machine_answer(&self, regime: Regime, digits: u32, start: Precision) -> Result<Answer> {
        let mut kinds = Vec::new();
        // An exact result of one digit: it certifies the number of folds.
        certify([Quantity::ContactRadius], 1, Precision::new(96), |precision| {
            kinds = self.folds(&self.contact(precision)?)?.into_iter().map(|(kind, _)| kind).collect();
            Ok([Rational::from(kinds.len()).into()])
        })?;
        let folds = match kinds.len() {
            0 => Vec::new(),
            1 => self.certified_folds::<3>(&kinds, digits, start)?,
            _ => self.certified_folds::<9>(&kinds, digits, start)?,
        };
        let first = if regime == Regime::PullOff { folds.last() } else { folds.first() };
        let critical = first.map(|Fold { contact_radius, indentation, force, .. }| State {
            contact_radius: contact_radius.clone(),
            indentation: indentation.clone(),
            force: force.clone(),
        });
        if regime == Regime::ScaleFree {
            return Ok(Answer { critical, folds, ..self.scale_free_answer(digits, start)? });
        }
        let [kappa] = certify([Quantity::Kappa], digits, start, |p| Ok([kappa_result(p, &self.exponent)]))?;
        Ok(Answer { regime, kappa, critical, folds, threshold: None, ratio: None })
    }

    /// Three decimals for each fold: K is three times their number.
    fn certified_folds<const K: usize>(
        &self,
        kinds: &[FoldKind],
        digits: u32,
        start: Precision,
    ) -> Result<Vec<Fold<Decimal>>> {
        const STATE: [Quantity; 3] = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
        let decimals = certify(std::array::from_fn(|i| STATE[i % 3]), digits, start, |precision| {
            let enclosures: Vec<Enclosure> =
                self.folds(&self.contact(precision)?)?.into_iter().flat_map(|(_, state)| state).collect();
            let like = Interval::from_int(precision, 1);
            <[Enclosure; K]>::try_from(enclosures).map_err(|_| undecided(&like, "the number of folds"))
        })?;
        let fold = |(kind, state): (&FoldKind, &[Decimal])| Fold {
            contact_radius: state[0].clone(),
            indentation: state[1].clone(),
            force: state[2].clone(),
            kind: *kind,
        };
        Ok(kinds.iter().zip(decimals.chunks(3)).map(fold).collect())
    }

    /// κ_n, a, d and F of the critical state as enclosures at the given precision, not rounded to decimals. Their width
    /// is a few units in the last place, times the condition of the question.
    ///
    /// ```
    /// use mdr_analytic::certified::{Elasticity, Question};
    /// use mdr_core::contact::Control;
    /// use mdr_core::number::{Precision, certify::Enclosure};
    /// let [n, c, e_star, work] = ["0.3", "1", "1e6", "0.05"].map(|text| text.parse());
    /// let question = Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &Control::Indentation)?;
    /// let [_, a, _, _] = question.enclosures(Precision::new(200))?;
    /// assert!(matches!(a, Enclosure::Value(a) if a.accuracy_bits() > 190));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] on a machine, where there may be several such states, and at n = 1/2, where there is none;
    /// [`Error::Undecided`] if the precision does not distinguish n from 1/2.
    pub fn enclosures(&self, precision: Precision) -> Result<[Enclosure; 4]> {
        if let Control::Machine { stiffness } = &self.control {
            let requirement = "absent: on a machine there may be several critical states";
            return Err(Error::Domain { quantity: Quantity::Stiffness, value: stiffness.to_string(), requirement });
        }
        self.critical(precision)
    }

    /// κ_n, a, d and F of the critical state, by counted roundings if possible and by intervals otherwise.
    fn critical(&self, precision: Precision) -> Result<[Enclosure; 4]> {
        match self.counted(precision) {
            Some([kappa, a, d, f]) => {
                let kappa = exact::kappa(&self.exponent).map_or(kappa.into(), Enclosure::Exact);
                let d = exact::indentation(self, &self.control).map_or(d.into(), Enclosure::Exact);
                Ok([kappa, a.into(), d, f.into()])
            }
            None => self.general_critical(precision),
        }
    }

    /// κ_n, a, d and F at the fold of a control that has one.
    pub(super) fn general_critical(&self, precision: Precision) -> Result<[Enclosure; 4]> {
        let contact = self.contact(precision)?;
        let fold = self.folds(&contact)?.into_iter().next();
        let (_, [a, d, f]) = fold.ok_or_else(|| undecided(contact.profile().exponent(), "the number of folds"))?;
        Ok([self.kappa_of(&contact), a, exact::indentation(self, &self.control).map_or(d, Enclosure::Exact), f])
    }

    /// a, d and F at each fold: by the closed forms over intervals; on the curve, which computes in logarithms, where a number
    /// may be zero or leaves the range of MPFR.
    fn folds(&self, contact: &PowerLawContact<Interval>) -> Result<Vec<(FoldKind, [Enclosure; 3])>> {
        let only = if self.regime() == Regime::PullOff { FoldKind::Minimum } else { FoldKind::Maximum };
        let by_value = |fold: Fold<Interval>| (fold.kind, [fold.contact_radius, fold.indentation, fold.force]);
        let found: Result<Vec<(FoldKind, [Interval; 3])>> = match self.control(contact.profile().exponent().ctx()) {
            Control::Machine { stiffness } => {
                contact.machine_folds(&stiffness).map(|folds| folds.into_iter().map(by_value).collect())
            }
            control => contact
                .critical(&control)
                .map(|state| vec![(only, [state.contact_radius, state.indentation, state.force])]),
        };
        match found {
            Ok(folds) if !folds.iter().any(|(_, state)| state.iter().any(Interval::contains_zero)) => {
                Ok(folds.into_iter().map(|(kind, state)| (kind, state.map(Enclosure::from))).collect())
            }
            Ok(_) | Err(Error::OutOfRange { .. }) => Ok(self.curve_of(contact)?.states().collect()),
            Err(error) => Err(error),
        }
    }

    /// κ_n of the contact, exact where it is rational.
    fn kappa_of(&self, contact: &PowerLawContact<Interval>) -> Enclosure {
        let enclosed = || contact.profile().kappa().clone().into();
        exact::kappa(&self.exponent).map_or_else(enclosed, Enclosure::Exact)
    }

    /// Enough bits for the digits except in rare cases, from the sensitivity of exp(ln(B/N²)/(2n−1)) to its argument.
    fn starting_precision(&self, digits: u32) -> Result<Precision> {
        let bits = |integer: &Integer| f64::from(integer.significant_bits());
        let log2 = |value: &Rational| bits(value.numer()) - bits(value.denom());
        let ln_quotient = log2(&self.work_of_adhesion)
            - log2(&self.effective_modulus)
            - 2.0 * (log2(&self.coefficient) + log2(&self.exponent));
        let excess = Rational::from(&self.exponent * 2u32) - 1u32;
        let magnified = if excess.is_zero() { 0.0 } else { (ln_quotient.abs() + 1.0).log2() - log2(&excess) };
        let bits = bits_for(digits)?.bits();
        if magnified > MOST_MAGNIFICATION {
            return Err(Error::Undecided {
                quantity: Quantity::ContactRadius,
                bits,
                what: "an exponent this close to 1/2 would need far more",
            });
        }
        Ok(Precision::new(bits + magnified.max(0.0) as u32))
    }
}

/// The bits for this number of digits, with the guard.
fn bits_for(digits: u32) -> Result<Precision> {
    Ok(Precision::new(Precision::from_digits(require_digits(digits)?).bits() + GUARD))
}

fn kappa_result(precision: Precision, n: &Rational) -> Enclosure {
    exact::kappa(n).map_or_else(|| exact::kappa_interval(precision, n).into(), Enclosure::Exact)
}
