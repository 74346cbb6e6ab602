//! Equilibria of power laws on both sides of a fold: by interval Newton on the closed forms, confirmed by the direction of
//! change from quadratures.
//!
//! The controlled quantity has one extremum along the equilibria, at the critical radius, and is monotone on both sides of
//! it. So a zero that is proved to lie on one side is the only one there.

use mdr_analytic::{Contact, Kappa};
use mdr_core::calculus::verify::verify;
use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_reference::{Record, Status};
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, largest, push};
use super::confirm;
use super::draft::{DIGITS, Draft, literal};
use super::power::{Held, NAMES, Power};

/// Bits for conditions.
const BITS: u32 = 256;

/// Bits beyond the digits.
const GUARD: u32 = 88;

/// Enough for Newton's method to converge from there, also at a relative distance of 2⁻⁵² to the fold, which is 2⁻²⁶ in the
/// radius.
const BISECTIONS: u32 = 96;

/// On which side of the critical radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Inner,
    Outer,
}

impl Side {
    pub(super) const ALL: [Side; 2] = [Side::Inner, Side::Outer];

    fn name(self) -> &'static str {
        match self {
            Side::Inner => "inner",
            Side::Outer => "outer",
        }
    }
}

/// At which value of the controlled quantity.
#[derive(Clone, Debug)]
pub(super) enum Target {
    /// The critical value times 1 − τ.
    Share(String),
    /// The value itself.
    Value(String),
}

/// An equilibrium that is asked for.
#[derive(Clone, Debug)]
pub(super) struct Equilibrium {
    pub(super) law: Power,
    pub(super) held: Held,
    pub(super) target: Target,
    pub(super) side: Side,
    /// The part of the identifier that tells the target.
    pub(super) label: String,
}

impl Equilibrium {
    /// The contact radius, and the quantity that is not controlled.
    pub(super) fn records(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(&self.label, error);
        let values = self.certified(DIGITS).map_err(wrong)?;
        let conditions = self.conditions().map_err(wrong)?;
        RecordError::unless(&self.label, "the equilibrium", self.confirmed(&values, largest(&conditions)))?;
        let draft = self.draft().map_err(wrong)?;
        let quantities = [("contact_radius", "m"), self.conjugate()];
        Ok(draft.records(quantities, values, conditions).collect())
    }

    /// At the fold itself the two equilibria are one: the critical state, as the answer to a question about equilibria.
    pub(super) fn double_root(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(&self.label, error);
        let critical = self.law.critical(self.held)?;
        let draft = self.draft().map_err(wrong)?;
        let (quantity, _) = self.conjugate();
        let wanted =
            critical.into_iter().filter(|record| [quantity, "contact_radius"].contains(&record.quantity.as_str()));
        Ok(wanted
            .map(|record| {
                let mut question = draft.without_number(&record.quantity, &record.unit, Status::Fold);
                question.value = record.value;
                question.log10 = record.log10;
                question.condition = record.condition;
                question.methods = record.methods;
                question
            })
            .collect())
    }

    /// The certain absence of an equilibrium.
    pub(super) fn none(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(&self.label, error);
        let beyond = || -> Result<bool> {
            let contact = self.law.contact::<Interval>(Precision::new(BITS))?;
            let (target, fold) = (self.target(&contact)?, self.fold(&contact)?.1);
            // A minimum of d and F above n = 1/2, a maximum below.
            let half = fold.ratio(1, 2);
            Ok(if *contact.profile().exponent() > half { target < fold } else { target > fold })
        };
        if !beyond().map_err(wrong)? {
            return Err(RecordError::missing(&self.label, "proof that there is no equilibrium"));
        }
        let mut draft = self.draft().map_err(wrong)?;
        draft.methods = ["closed-form/interval", "quadrature-tangency/mp"];
        Ok(vec![draft.without_number("contact_radius", "m", Status::NoEquilibrium)])
    }

    fn conjugate(&self) -> (&'static str, &'static str) {
        match self.held {
            Held::Indentation => ("force", "N"),
            Held::Force => ("indentation", "m"),
        }
    }

    fn draft(&self) -> Result<Draft> {
        let contact = self.law.contact::<Interval>(Precision::new(BITS))?;
        let fold = self.fold(&contact)?.1;
        let share = (self.target(&contact)? / &fold - fold.lit(1)).approx().abs();
        let (formula, input) = match &self.target {
            Target::Share(tau) => ("equilibrium-share", ("tau", tau.clone())),
            Target::Value(value) => ("equilibrium", (self.held.symbol(), value.clone())),
        };
        let draft = self.law.draft("equilibrium");
        let mut flags = draft.flags.clone();
        flags.push(self.side.name());
        flags.extend((share <= 1e-2).then_some("near-fold"));
        Ok(Draft {
            id: format!("{}/{}/{}", draft.id, self.label, self.side.name()),
            formula,
            control: Some(self.held.name()),
            inputs: draft.inputs.iter().cloned().chain([input]).collect(),
            methods: ["interval-newton", "quadrature-direction/mp"],
            proof: vec!["1.13", "1.16"],
            refs: vec!["Popov (1.5)", "Popov (1.6)", "Popov (1.13)", "Popov (1.16)"],
            fold_distance: Some(share),
            flags,
            ..draft
        })
    }

    /// The critical radius and the critical value of the controlled quantity.
    fn fold<R: Kappa>(&self, contact: &Contact<R>) -> Result<(R, R)> {
        let state = contact.critical(&self.held.control())?;
        let value = match self.held {
            Held::Indentation => state.indentation,
            Held::Force => state.force,
        };
        Ok((state.contact_radius, value))
    }

    fn target<R: Kappa>(&self, contact: &Contact<R>) -> Result<R> {
        let like = contact.profile().exponent();
        self.target_with(contact, R::from_literal(like.ctx(), &literal(self.input())))
    }

    /// The same with the last input given.
    fn target_with<R: Kappa>(&self, contact: &Contact<R>, input: R) -> Result<R> {
        match &self.target {
            Target::Share(_) => Ok((input.lit(1) - &input) * self.fold(contact)?.1),
            Target::Value(_) => Ok(input),
        }
    }

    fn input(&self) -> &str {
        match &self.target {
            Target::Share(text) | Target::Value(text) => text,
        }
    }

    fn controlled<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        match self.held {
            Held::Indentation => contact.indentation(a),
            Held::Force => contact.force(a),
        }
    }

    fn slope<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        match self.held {
            Held::Indentation => contact.indentation_slope(a),
            Held::Force => contact.force_slope(a),
        }
    }

    fn other<R: Real>(&self, contact: &Contact<R>, a: &R) -> Result<R> {
        match self.held {
            Held::Indentation => contact.force(a),
            Held::Force => contact.indentation(a),
        }
    }

    /// The radius and the quantity that is not controlled.
    pub(super) fn certified(&self, digits: u32) -> Result<[Decimal; 2]> {
        let conjugate = if self.held == Held::Indentation { Quantity::Force } else { Quantity::Indentation };
        let start = Precision::new(Precision::from_digits(digits).bits() + GUARD);
        certify([Quantity::ContactRadius, conjugate], digits, start, |precision| {
            let contact = self.law.contact::<Interval>(precision)?;
            let a = self.radius(&contact)?;
            let other = self.other(&contact, &a)?;
            Ok([a, other].map(Enclosure::from))
        })
    }

    /// The radius with a proof.
    fn radius(&self, contact: &Contact<Interval>) -> Result<Interval> {
        let target = self.target(contact)?;
        let (fold, _) = self.fold(contact)?;
        let excess = |a: &Interval| Ok(self.controlled(contact, a)? - &target);
        let undecided = |what| Error::Undecided { quantity: Quantity::ContactRadius, bits: fold.precision(), what };
        let candidate = self.approximate(contact, &fold, excess)?;
        let zero = verify(&candidate, excess, |a| self.slope(contact, a))?;
        let zero = zero.ok_or_else(|| undecided("where exactly the equilibrium lies"))?;
        let beside = match self.side {
            Side::Inner => zero < fold,
            Side::Outer => zero > fold,
        };
        if beside { Ok(zero) } else { Err(undecided("on which side of the fold the equilibrium lies")) }
    }

    /// By doubling away from the fold until the sign changes, bisection, and Newton's method.
    fn approximate(
        &self,
        contact: &Contact<Interval>,
        fold: &Interval,
        excess: impl Fn(&Interval) -> Result<Interval>,
    ) -> Result<Float> {
        let fold = fold.mid();
        let bits = fold.prec();
        let at = |t: &Float| Interval::point(Float::with_val(bits, &fold * t.clone().exp()));
        let rising = |t: &Float| Ok::<_, Error>(excess(&at(t))?.mid().is_sign_positive());
        let sign = if self.side == Side::Outer { 1 } else { -1 };
        // t = ln(a/a_c); beside the fold the sign is that of its value less the target.
        let beside = Float::with_val(bits, sign) >> (bits / 2);
        let here = rising(&beside)?;
        let (mut near, mut far) = (beside, Float::with_val(bits, sign) >> 20u32);
        while rising(&far)? == here {
            near = far.clone();
            far *= 2u32;
        }
        for _ in 0..BISECTIONS {
            let middle = Float::with_val(bits, &near + &far) / 2u32;
            if rising(&middle)? == here {
                near = middle;
            } else {
                far = middle;
            }
        }
        let mut a = at(&far);
        for _ in 0..=bits.ilog2() {
            a = (a.clone() - excess(&a)? / self.slope(contact, &a)?).steer();
        }
        Ok(a.mid())
    }

    /// By the implicit function theorem: the slope of the radius is that of the residual at fixed radius over −d'(a), or
    /// −F'(a); the other quantity follows by the chain rule.
    fn conditions(&self) -> Result<[Named; 2]> {
        let ctx = Precision::new(BITS);
        let still = self.law.contact::<Interval>(ctx)?;
        let a = self.radius(&still)?;
        let slope = self.slope(&still, &a)?;
        let last = match &self.target {
            Target::Share(_) => "tau",
            Target::Value(_) => self.held.symbol(),
        };
        let mut conditions: [Named; 2] = Default::default();
        for (index, name) in NAMES.into_iter().chain([last]).enumerate() {
            let contact = self.law.moving::<Interval>(ctx, index)?;
            let value = input(ctx, &literal(self.input()), index == NAMES.len());
            let target = self.target_with(&contact, value)?;
            let residual = self.controlled(&contact, &Dual::constant(a.clone()))? - target;
            let radius = Dual { value: a.clone(), slope: -residual.slope / &slope };
            let other = self.other(&contact, &radius)?;
            push(&mut conditions, name, [radius, other]);
        }
        Ok(conditions)
    }

    /// By quadratures: the direction of change turns at this radius, and the other quantity is on the curve.
    fn confirmed(&self, [a, other]: &[Decimal; 2], condition: f64) -> Result<bool> {
        let ctx = confirm::precision(condition);
        let (transform, material) = confirm::power(&self.law, ctx)?;
        let control = self.held.control();
        let curve = mdr_numeric::curve::Curve::new(&transform, &material, &control);
        let target = self.target(&self.law.contact::<Interval>(ctx)?)?.mid();
        let [a, other] = [a, other].map(|value| confirm::float(ctx, value));
        let turns = confirm::changes_sign(&a, |a| curve.direction(a, &target))?;
        let state = match self.held {
            Held::Indentation => [&a, &target, &other],
            Held::Force => [&a, &other, &target],
        };
        Ok(turns && confirm::on_curve(&curve, state)?)
    }
}
