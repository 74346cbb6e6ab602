//! Power laws by their own closed forms: folds, equilibria, paths and energies, all proved, on all radii and at any scale.

use mdr_analytic::certified::{Curve, Elasticity, Point, Question};
use mdr_core::contact::{self, Control, ControlKind, Error, FoldKind, Quantity, Regime, Result, Stability};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Literal, Precision};
use mdr_numeric::admissible::Verdict;
use rug::Rational;

use super::digits::decide;
use super::law_path;
use super::out_of_range;
use crate::answer::record::Numbers;
use crate::answer::types::PathNumbers;
use crate::answer::{
    Admission, AtValue, Completeness, EnergyState, Equilibrium, Fold, List, LoadingPath, Number, Output, Promise, Value,
};
use crate::scene::{Arithmetic, Scene, Want, exactly};

/// A power law with rational constants, how it is held, and the numbers of its scene in the arithmetic of the answer: as they
/// are written, or the doubles nearest to them.
pub(super) struct PowerLaw<'s> {
    pub(super) scene: &'s Scene,
    pub(super) question: Question,
    pub(super) digits: u32,
}

impl<'s> PowerLaw<'s> {
    /// `None` if the profile or the medium is another one.
    ///
    /// # Errors
    /// An input out of its domain; see [`Question::new`].
    pub(super) fn of(scene: &'s Scene) -> Result<Option<Self>> {
        if !scene.medium.is_half_space() {
            return Ok(None);
        }
        let as_meant = |literal: &Literal| number(scene, literal);
        let Some([exponent, coefficient]) = scene.profile.exact_power_law(as_meant) else { return Ok(None) };
        let literal = |input: &Literal| exactly(&as_meant(input)).unwrap_or_else(|| input.clone());
        let Ok(control) = scene.control.try_map(|stiffness| Ok::<_, std::convert::Infallible>(literal(stiffness)));
        let elasticity = Elasticity::Effective(literal(&scene.effective_modulus));
        let question =
            Question::new(&exponent, &coefficient, &elasticity, &literal(&scene.work_of_adhesion), &control)?;
        let digits = match scene.arithmetic {
            Arithmetic::Certified { digits } => digits,
            Arithmetic::Double => out_of_range::DIGITS,
        };
        Ok(Some(PowerLaw { scene, question, digits }))
    }

    /// The output by closed forms; `None` for outputs at given radii.
    ///
    /// # Errors
    /// A decision that no precision makes; see [`Question::answer`], [`Question::curve`] and [`law_path::events`].
    pub(super) fn output(&self, want: &Want) -> Result<Option<Output>> {
        const PROVED: Promise = Promise::Certified;
        let output = match want {
            Want::Folds { .. } => Output::Folds(List::new(PROVED, self.folds()?).complete(complete())),
            Want::Equilibria { at } => Output::Equilibria(List::new(PROVED, self.equilibria(at)?).complete(complete())),
            Want::Path => Output::Path(Box::new(LoadingPath::new(PROVED, self.path()?, complete()))),
            Want::Energy { states } => Output::Energy(List::new(PROVED, self.energies(states)?)),
            Want::Transform { .. }
            | Want::ForceCurve { .. }
            | Want::Curve { .. }
            | Want::Pressure { .. }
            | Want::Gap { .. }
            | Want::Displacement { .. } => return Ok(None),
        };
        Ok(Some(match self.scene.arithmetic {
            Arithmetic::Certified { .. } => output,
            Arithmetic::Double => out_of_range::in_doubles(output),
        }))
    }

    /// A number of the scene.
    pub(super) fn number(&self, literal: &Literal) -> Rational {
        number(self.scene, literal)
    }

    /// The equilibria; in f64 a double next to the value of a fold is that of the fold.
    fn curve(&self, precision: Precision) -> Result<Curve> {
        let curve = self.question.curve(precision)?;
        Ok(match self.scene.arithmetic {
            Arithmetic::Certified { .. } => curve,
            Arithmetic::Double => curve.with_folds_rounded(|value| {
                let nearest = value.enclosure().round(out_of_range::DIGITS)?.to_f64();
                Rational::from_f64(nearest).filter(|_| nearest.is_normal())
            }),
        })
    }

    /// Correctly rounded folds.
    fn folds(&self) -> Result<Vec<Fold>> {
        let answer = self.question.answer(self.digits)?;
        let kind = match answer.regime {
            Regime::CompleteContact => FoldKind::Maximum,
            _ => FoldKind::Minimum,
        };
        let folds = match &self.scene.control {
            Control::Machine { .. } => answer.folds,
            _ => answer
                .critical
                .map(|c| contact::Fold {
                    contact_radius: c.contact_radius,
                    indentation: c.indentation,
                    force: c.force,
                    kind,
                })
                .into_iter()
                .collect(),
        };
        let written = |fold| Fold::new(fold, Verdict::Admissible).convert(Number::Certified);
        Ok(folds.into_iter().map(written).collect())
    }

    fn equilibria(&self, values: &[Literal]) -> Result<Vec<AtValue<Equilibrium>>> {
        self.at_values(values, |curve, point, value| {
            Ok(Equilibrium::new(self.state(curve, point, Some(value)), Verdict::Admissible))
        })
    }

    /// Π and dF/dd of each equilibrium at the values, else of that in which the path starts.
    fn energies(&self, values: &[Literal]) -> Result<Vec<AtValue<EnergyState>>> {
        match (values, self.scene.path.first()) {
            ([], Some(first)) => decide(self.digits, |precision| {
                let (curve, value) = (self.curve(precision)?, self.number(first));
                let start = law_path::start(self, &curve, first)?;
                let states = start.iter().map(|point| self.energy(&curve, point, &value));
                Ok(vec![AtValue::new(first, states.collect::<Result<_>>()?)])
            }),
            _ => self.at_values(values, |curve, point, value| self.energy(curve, point, value)),
        }
    }

    fn energy(&self, curve: &Curve, point: &Point, value: &Rational) -> Result<EnergyState<Enclosure>> {
        let at_fold = || {
            let requirement = "off the fold of the indentation";
            Error::domain(Quantity::ContactRadius, &point.radius().interval(), requirement)
        };
        let stationary = self.scene.control == Control::Indentation && self.question.is_fold_of_force(value);
        let stiffness = match curve.stiffness(point) {
            Some(_) if stationary => Ok(Rational::new().into()),
            stiffness => stiffness.map(|stiffness| stiffness.enclosure()).ok_or_else(at_fold),
        };
        Ok(EnergyState {
            state: self.state(curve, point, Some(value)).into(),
            energy: Value::Known(curve.energy(point).enclosure()),
            stiffness: Value::from_result(stiffness)?,
            admissible: Admission::Admissible,
        })
    }

    /// The records of every equilibrium at values.
    fn at_values<T: Numbers<Enclosure>>(
        &self,
        values: &[Literal],
        describe: impl Fn(&Curve, &Point, &Rational) -> Result<T>,
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

    /// Fields of states that were searched in f64: where these are not all there are, the value says so.
    ///
    /// # Errors
    /// A decision that no precision makes; see [`PowerLaw::output`].
    pub(super) fn checked(&self, output: Output, values: &[Literal]) -> Result<Output> {
        let Output::Field(field, mut list) = output else { return Ok(output) };
        let known = PowerLaw { digits: 1, question: self.question.clone(), ..*self }.energies(values)?;
        let what = "the contact radius of a state, which is beyond the range of f64, where states are searched";
        let error = Error::Undecided { quantity: Quantity::ContactRadius, bits: f64::MANTISSA_DIGITS, what };
        for (item, known) in list.items.iter_mut().zip(known) {
            if item.items.len() != known.items.len() {
                *item = AtValue::open(&known.value, &error);
            }
        }
        Ok(Output::Field(field, list))
    }

    /// A start of the path that f64 does not find exists where the closed forms have it.
    pub(super) fn doubted(&self, error: Error) -> Error {
        let Error::NoEquilibrium { quantity, .. } = error else { return error };
        let start = |first: &Literal| law_path::start(self, &self.curve(super::digits::start(self.digits))?, first);
        match self.scene.path.first().map(start) {
            Some(Ok(None)) | None => error,
            Some(_) => {
                let what = "where the curve begins: the contact radius of that state is beyond the range of f64, in which the \
                            curve is searched; path has its events";
                Error::Undecided { quantity, bits: f64::MANTISSA_DIGITS, what }
            }
        }
    }

    fn path(&self) -> Result<PathNumbers<Number>> {
        decide(self.digits, |precision| law_path::events(self, &self.curve(precision)?))
    }

    /// The numbers of a state, of which the one that is controlled is exactly `value`, and that of a cone at its fold is exact.
    pub(super) fn state(
        &self,
        curve: &Curve,
        point: &Point,
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
fn complete() -> Completeness {
    Completeness { proved: true, from: Some("0".to_owned()), to: None, why: "closed form of a power law".to_owned() }
}

/// A number of a scene in the arithmetic of its answer.
fn number(scene: &Scene, literal: &Literal) -> Rational {
    match scene.arithmetic {
        Arithmetic::Certified { .. } => literal.to_rational(),
        Arithmetic::Double => Rational::from_f64(literal.nearest_f64()).unwrap_or_else(|| literal.to_rational()),
    }
}
