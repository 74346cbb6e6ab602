//! The closed forms of a power law for the outputs that have one: all proved, on all radii and at any scale.

use mdr_analytic::certified::{CertifiedPoint, Curve, Elasticity, Question};
use mdr_core::contact::{self, ControlKind, Edge, Error, Result, Stability};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use mdr_numeric::path::{ContactState, Path, Start};
use rug::Rational;

use super::digits::decide;
use super::law_branches::LawBranches;
use super::out_of_range;
use crate::answer::record::Numbers;
use crate::answer::{AtValue, Completeness, Number, PlainState};
use crate::scene::{Arithmetic, Scene, exactly};

/// A power law with rational constants, how it is held, and the numbers of its scene in the arithmetic of the answer: as they
/// are written, or the doubles nearest to them.
pub(crate) struct PowerLaw<'s> {
    pub(crate) scene: &'s Scene,
    pub(crate) question: Question,
    pub(crate) digits: u32,
}

impl<'s> PowerLaw<'s> {
    /// `None` if the profile or the medium is another one, with two works of adhesion, and for an edge without adhesion.
    ///
    /// # Errors
    /// An input out of its domain; see [`Question::new`].
    pub(crate) fn of(scene: &'s Scene) -> Result<Option<Self>> {
        let no_adhesion =
            scene.edge == Some(Edge::Advancing) && scene.works.as_ref().is_some_and(|works| works[0].is_zero());
        if !scene.pressed_into().is_half_space() || scene.has_two_works() || no_adhesion {
            return Ok(None);
        }
        let as_meant = |literal: &Literal| number(scene, literal);
        let Some([exponent, coefficient]) = scene.profile.exact_power_law(as_meant) else { return Ok(None) };
        let literal = |input: &Literal| exactly(&as_meant(input)).unwrap_or_else(|| input.clone());
        let control = scene.control.map(literal);
        let elasticity = Elasticity::Effective(literal(&scene.effective_modulus));
        let question =
            Question::new(&exponent, &coefficient, &elasticity, &literal(&scene.work_of_adhesion), &control)?;
        let digits = match scene.arithmetic {
            Arithmetic::Certified { digits } => digits,
            Arithmetic::F64 => out_of_range::DIGITS,
        };
        Ok(Some(PowerLaw { scene, question, digits }))
    }

    /// A number of the scene.
    pub(crate) fn number(&self, literal: &Literal) -> Rational {
        number(self.scene, literal)
    }

    /// The equilibria; in f64 a double next to the value of a fold is that of the fold.
    ///
    /// # Errors
    /// See [`Question::curve`].
    pub(crate) fn curve(&self, precision: Precision) -> Result<Curve> {
        let curve = self.question.curve(precision)?;
        Ok(match self.scene.arithmetic {
            Arithmetic::Certified { .. } => curve,
            Arithmetic::F64 => curve.with_folds_rounded(|value| {
                let nearest = value.enclosure().round(out_of_range::DIGITS)?.to_f64();
                Rational::from_f64(nearest).filter(|_| nearest.is_normal())
            }),
        })
    }

    /// The record of every equilibrium at the values; without values, of that in which the path starts.
    ///
    /// # Errors
    /// A decision on the start that no precision makes.
    pub(crate) fn described<T: Numbers<Enclosure>>(
        &self,
        values: &[Literal],
        describe: impl Fn(&Curve, &CertifiedPoint, &Rational) -> Result<T>,
    ) -> Result<Vec<AtValue<T::With<Number>>>> {
        match (values, self.scene.path.first()) {
            ([], Some(first)) => decide(self.digits, |precision| {
                let (curve, value) = (self.curve(precision)?, self.number(first));
                let start = self.start(&curve, first)?;
                let states = start.iter().map(|point| describe(&curve, point, &value));
                Ok(vec![AtValue::new(first, states.collect::<Result<_>>()?)])
            }),
            _ => self.at_values(values, describe),
        }
    }

    /// The record of every equilibrium at values; a value at which they stay open is undecided.
    ///
    /// # Errors
    /// Errors of the closed forms.
    pub(crate) fn at_values<T: Numbers<Enclosure>>(
        &self,
        values: &[Literal],
        describe: impl Fn(&Curve, &CertifiedPoint, &Rational) -> Result<T>,
    ) -> Result<Vec<AtValue<T::With<Number>>>> {
        let at = |literal: &Literal| {
            let value = self.number(literal);
            let item = decide(self.digits, |precision| {
                let curve = self.curve(precision)?;
                let states = curve.equilibria(&value)?;
                let states = states.iter().map(|point| describe(&curve, point, &value));
                Ok(AtValue::new(literal, states.collect::<Result<_>>()?))
            });
            match item {
                Err(error @ Error::Undecided { .. }) => Ok(AtValue::open(literal, &error)),
                item => item,
            }
        };
        values.iter().map(at).collect()
    }

    /// Which state a path takes at its first way point.
    pub(crate) fn begin(&self, branches: &LawBranches<'_>) -> Start<Interval> {
        self.scene.start.map(|radius| branches.enclose(&self.number(radius)))
    }

    /// The equilibrium in which a path starts; `None` if it cannot start, or if the surfaces are apart.
    fn start(&self, curve: &Curve, first: &Literal) -> Result<Option<CertifiedPoint>> {
        let value = self.number(first);
        let branches = LawBranches::new(curve, vec![value.clone()]);
        match Path::first(&branches, &self.begin(&branches), &branches.enclose(&value)) {
            Ok(ContactState::Contact(rest)) => Ok(Some(branches.at(&value, &rest)?.point().clone())),
            Ok(_) | Err(Error::NoEquilibrium { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// How many equilibria there are at each value; without values, at the start of the path.
    ///
    /// # Errors
    /// A decision on the start that no precision makes.
    pub(crate) fn counts_at(&self, values: &[Literal]) -> Result<Vec<(Literal, usize)>> {
        let roughly = PowerLaw { digits: 1, question: self.question.clone(), ..*self };
        let known = roughly
            .described(values, |curve, point, value| Ok(PlainState::from(roughly.state(curve, point, Some(value)))))?;
        Ok(known.into_iter().map(|at| (at.value, at.items.len())).collect())
    }

    /// A start of the path that f64 does not find exists where the closed forms have it.
    pub(crate) fn doubted(&self, error: Error) -> Error {
        let Error::NoEquilibrium { quantity, .. } = error else { return error };
        let start = |first: &Literal| self.start(&self.curve(super::digits::start(self.digits))?, first);
        match self.scene.path.first().map(start) {
            Some(Ok(None)) | None => error,
            Some(_) => {
                let what = "where the curve begins: the contact radius of that state is beyond the range of f64, in which the \
                            curve is searched; path has its events";
                Error::Undecided { quantity, bits: f64::MANTISSA_DIGITS, what }
            }
        }
    }

    /// The numbers of a state, of which the one that is controlled is exactly `value`, and that of a cone at its fold is exact.
    pub(crate) fn state(
        &self,
        curve: &Curve,
        point: &CertifiedPoint,
        value: Option<&Rational>,
    ) -> contact::Equilibrium<Enclosure> {
        let controlled = |kind: ControlKind, number: Enclosure| match value {
            Some(value) if self.scene.control.kind() == kind => Enclosure::Exact(value.clone()),
            _ => number,
        };
        let indentation = match self.question.exact_indentation() {
            Some(exact) if point.stability == Stability::Neutral => Enclosure::Exact(exact),
            _ => point.indentation().enclosure(),
        };
        contact::Equilibrium {
            contact_radius: point.radius().enclosure(),
            indentation: controlled(ControlKind::Indentation, indentation),
            force: controlled(ControlKind::Force, curve.force(point).enclosure()),
            stability: point.stability,
        }
    }
}

/// All, on all radii.
pub(crate) fn complete() -> Completeness {
    let (from, why) = (Some("0".to_owned()), "closed form of a power law".to_owned());
    Completeness { proved: true, from, to: None, why, undecided: false }
}

/// A number of a scene in the arithmetic of its answer.
pub(crate) fn number(scene: &Scene, literal: &Literal) -> Rational {
    match scene.arithmetic {
        Arithmetic::Certified { .. } => literal.to_rational(),
        Arithmetic::F64 => Rational::from_f64(literal.nearest_f64()).unwrap_or_else(|| literal.to_rational()),
    }
}
