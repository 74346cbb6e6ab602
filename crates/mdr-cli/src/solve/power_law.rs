//! Power laws by their own closed forms: folds, equilibria, paths and energies, all proved, on all radii and at any scale.

use mdr_analytic::certified::{Curve, Elasticity, Point, Question};
use mdr_core::contact::{Control, Equilibrium, Error, FoldKind, Instability, Quantity, Regime, Result, Stability};
use mdr_core::number::certify::{Decimal, Enclosure};
use mdr_core::number::{Literal, Precision};
use mdr_numeric::admissible::Verdict;
use rug::Rational;

use super::answer::{Complete, Output, Promise};
use super::beyond;
use super::digits::proved;
use super::law_path;
use super::outputs;
use super::record::{Field, Record};
use crate::flags::Arithmetic;
use crate::number::Number;
use crate::scene::{HeldBy, Scene, Shape, Slope, Want, exactly};

/// A power law with rational constants, how it is held, and the numbers of its scene in the arithmetic of the answer: as they
/// are written, or the doubles nearest to them.
pub(super) struct PowerLaw<'s> {
    pub(super) scene: &'s Scene,
    pub(super) question: Question,
    pub(super) digits: u32,
}

impl<'s> PowerLaw<'s> {
    /// None where the profile is another one.
    ///
    /// # Errors
    /// As [`Question::new`].
    pub(super) fn of(scene: &'s Scene) -> Result<Option<Self>> {
        let as_meant = |literal: &Literal| number(scene, literal);
        let Some([exponent, coefficient]) = power_law(&scene.profile, as_meant) else { return Ok(None) };
        let literal = |input: &Literal| exactly(&as_meant(input)).unwrap_or_else(|| input.clone());
        let control = match &scene.held.by {
            HeldBy::Indentation => Control::Indentation,
            HeldBy::Force => Control::Force,
            HeldBy::Machine { stiffness } => Control::Machine { stiffness: literal(stiffness) },
        };
        let elasticity = Elasticity::Effective(literal(&scene.effective_modulus));
        let question =
            Question::new(&exponent, &coefficient, &elasticity, &literal(&scene.work_of_adhesion), &control)?;
        let digits = match scene.output.arithmetic {
            Arithmetic::Certified { digits } => digits,
            Arithmetic::Double => beyond::DIGITS,
        };
        Ok(Some(PowerLaw { scene, question, digits }))
    }

    /// What the closed forms answer; none for what is read off at given radii.
    ///
    /// # Errors
    /// As [`Question::answer`], [`Question::curve`] and [`law_path::events`].
    pub(super) fn output(&self, want: Want) -> Result<Option<Output>> {
        let output = match want {
            Want::Folds => Output::new(want, Promise::Certified, self.folds()?).complete(complete()),
            Want::Equilibria => Output::new(want, Promise::Certified, self.equilibria()?).complete(complete()),
            Want::Path => Output::path(Promise::Certified, self.path()?).complete(complete()),
            Want::Energy => Output::new(want, Promise::Certified, self.energies()?),
            Want::Transform | Want::Curve | Want::Pressure | Want::Gap | Want::Displacement => return Ok(None),
        };
        Ok(Some(match self.scene.output.arithmetic {
            Arithmetic::Certified { .. } => output,
            Arithmetic::Double => beyond::in_doubles(output),
        }))
    }

    /// A number of the scene.
    pub(super) fn number(&self, literal: &Literal) -> Rational {
        number(self.scene, literal)
    }

    /// The equilibria; in f64 a double next to the value of a fold is that of the fold.
    fn curve(&self, precision: Precision) -> Result<Curve> {
        let curve = self.question.curve(precision)?;
        Ok(match self.scene.output.arithmetic {
            Arithmetic::Certified { .. } => curve,
            Arithmetic::Double => curve.with_folds_rounded(|value| {
                let nearest = value.enclosure().round(beyond::DIGITS)?.to_f64();
                Rational::from_f64(nearest).filter(|_| nearest.is_normal())
            }),
        })
    }

    /// Correctly rounded folds.
    fn folds(&self) -> Result<Vec<Record<Number>>> {
        let answer = self.question.answer(self.digits)?;
        let kind = match answer.regime {
            Regime::CompleteContact => FoldKind::Maximum,
            _ => FoldKind::Minimum,
        };
        let folds = match &self.scene.held.by {
            HeldBy::Machine { .. } => answer.folds,
            _ => answer
                .critical
                .map(|c| Instability {
                    contact_radius: c.contact_radius,
                    indentation: c.indentation,
                    force: c.force,
                    kind,
                })
                .into_iter()
                .collect(),
        };
        let written = |decimal: Decimal| Number::Decimal(decimal.to_string());
        Ok(folds.into_iter().map(|fold| outputs::fold_of(fold).judged(Verdict::Admissible).convert(written)).collect())
    }

    fn equilibria(&self) -> Result<Vec<Record<Number>>> {
        self.at_values("equilibria", |curve, point, value| {
            Ok(outputs::equilibrium_of(self.state(curve, point, Some(value))).judged(Verdict::Admissible))
        })
    }

    /// Π and dF/dd of each equilibrium at the values of the scene, else of that in which its path starts.
    fn energies(&self) -> Result<Vec<Record<Number>>> {
        match (self.scene.output.values.as_slice(), self.scene.held.path.first()) {
            ([], Some(first)) => proved(self.digits, |precision| {
                let (curve, value) = (self.curve(precision)?, self.number(first));
                let start = law_path::start(self, &curve, first)?;
                let told = start.iter().map(|point| self.energy(&curve, point, &value));
                Ok(vec![outputs::at_value(first, "states", told.collect::<Result<_>>()?)])
            }),
            _ => self.at_values("states", |curve, point, value| self.energy(curve, point, value)),
        }
    }

    fn energy(&self, curve: &Curve, point: &Point, value: &Rational) -> Result<Record<Enclosure>> {
        let at_fold = || {
            let requirement = "off the fold of the indentation";
            Error::domain(Quantity::ContactRadius, &point.radius().interval(), requirement)
        };
        let stationary = self.scene.held.by == HeldBy::Indentation && self.question.is_fold_of_force(value);
        let stiffness = match curve.stiffness(point) {
            Some(_) if stationary => Ok(Rational::new().into()),
            stiffness => stiffness.map(|stiffness| stiffness.enclosure()).ok_or_else(at_fold),
        };
        let state = outputs::equilibrium_of(self.state(curve, point, Some(value))).judged(Verdict::Admissible);
        state.with("energy", Field::Number(curve.energy(point).enclosure())).number("stiffness", stiffness)
    }

    /// A record for each value of the scene, with what is told of every equilibrium at it.
    fn at_values(
        &self,
        key: &'static str,
        tell: impl Fn(&Curve, &Point, &Rational) -> Result<Record<Enclosure>>,
    ) -> Result<Vec<Record<Number>>> {
        let at = |literal: &Literal| {
            let value = self.number(literal);
            let records = proved(self.digits, |precision| {
                let curve = self.curve(precision)?;
                let told = curve.equilibria(&value)?;
                let told = told.iter().map(|point| tell(&curve, point, &value));
                Ok(vec![outputs::at_value(literal, key, told.collect::<Result<_>>()?)])
            });
            match records {
                Err(error @ Error::Undecided { .. }) => {
                    Ok(vec![outputs::at_value(literal, key, Vec::new()).open(&error)])
                }
                records => records,
            }
        };
        Ok(self.scene.output.values.iter().map(at).collect::<Result<Vec<_>>>()?.concat())
    }

    /// Fields of states that were searched in f64: where these are not all there are, the record says so.
    ///
    /// # Errors
    /// As [`PowerLaw::output`].
    pub(super) fn checked(&self, output: Output) -> Result<Output> {
        let states = |record: &Record<Number>, key| record.clone().into_records(key).len();
        let known = PowerLaw { digits: 1, question: self.question.clone(), ..*self }.energies()?;
        let what = "the contact radius of a state, which is beyond the range of f64, where states are searched";
        let error = Error::Undecided { quantity: Quantity::ContactRadius, bits: f64::MANTISSA_DIGITS, what };
        let check = |(record, known): (Record<Number>, Record<Number>)| {
            if states(&record, "states") == states(&known, "states") {
                record
            } else {
                known.emptied("states").open(&error)
            }
        };
        Ok(Output { records: output.records.into_iter().zip(known).map(check).collect(), ..output })
    }

    fn path(&self) -> Result<Vec<Record<Number>>> {
        proved(self.digits, |precision| law_path::events(self, &self.curve(precision)?))
    }

    /// The numbers of a state, of which the one that is held at `value` is exact, and that of a cone at its fold.
    pub(super) fn state(&self, curve: &Curve, point: &Point, value: Option<&Rational>) -> Equilibrium<Enclosure> {
        let held = |is_held: bool, number: Enclosure| match value {
            Some(value) if is_held => Enclosure::Exact(value.clone()),
            _ => number,
        };
        let indentation = match self.question.exact_indentation() {
            Some(exact) if point.stability == Stability::Neutral => Enclosure::Exact(exact),
            _ => point.indentation().enclosure(),
        };
        Equilibrium {
            contact_radius: point.radius().enclosure(),
            indentation: held(self.scene.held.by == HeldBy::Indentation, indentation),
            force: held(self.scene.held.by == HeldBy::Force, curve.force(point).enclosure()),
            stability: point.stability,
        }
    }
}

/// All, on all radii.
fn complete() -> Complete {
    Complete { proved: true, from: Some("0".to_owned()), to: None, why: "closed form of a power law".to_owned() }
}

/// A number of a scene in the arithmetic of its answer.
fn number(scene: &Scene, literal: &Literal) -> Rational {
    match scene.output.arithmetic {
        Arithmetic::Certified { .. } => literal.to_rational(),
        Arithmetic::Double => Rational::from_f64(literal.nearest_f64()).unwrap_or_else(|| literal.to_rational()),
    }
}

/// Whether a profile is a power law with rational constants.
pub(super) fn is_power_law(shape: &Shape) -> bool {
    power_law(shape, Literal::to_rational).is_some()
}

/// n and C of f = C rⁿ where the profile is one with rational constants.
fn power_law(shape: &Shape, number: impl Fn(&Literal) -> Rational) -> Option<[Literal; 2]> {
    let law = match shape {
        Shape::Power { n, c } => [number(n), number(c)],
        Shape::Cone { slope: Slope::Tangent(slope) } => [Rational::from(1), number(slope)],
        Shape::Paraboloid { radius } => [Rational::from(2), (number(radius) * 2u32).recip()],
        _ => return None,
    };
    let [n, c] = law.each_ref().map(exactly);
    Some([n?, c?])
}
