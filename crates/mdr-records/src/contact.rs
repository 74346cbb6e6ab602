//! A contact of the records: a scene, and the same in other arithmetics.

use std::sync::Arc;

use mdr::prelude::{Arithmetic, Elasticity, Literal, Profile, Scene, Shape, Want};
use mdr::{Answer, critical};
use mdr_analytic::profiles::{ClosedReal, closed_form};
use mdr_analytic::{Kappa, PowerLaw, PowerLawContact as Law};
use mdr_core::contact::{self, Control, Error, Material, Quantity, Transform};
use mdr_core::number::{Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::transform::Quadrature;
use rug::Float;

use crate::{DIGITS, Failure, Result};

/// Profile, material and control, exactly as the cases have them.
#[derive(Clone, Debug)]
pub(crate) struct CaseContact {
    /// The profile, or the terms of a sum.
    pub(crate) terms: Vec<Shape<Literal>>,
    pub(crate) e_star: Literal,
    pub(crate) work_of_adhesion: Literal,
    pub(crate) control: Control<Literal>,
    /// The radii between which all folds are proved.
    pub(crate) range: Option<[Literal; 2]>,
}

/// Profile, material and control in one arithmetic.
pub(crate) struct Model<R> {
    pub(crate) terms: Vec<Shape<R>>,
    pub(crate) material: Material<R>,
    pub(crate) control: Control<R>,
}

/// The symbol of a stiffness among the inputs.
const STIFFNESS: &str = "k";

impl CaseContact {
    /// Whether profile, material, control and range are equal, number by number.
    pub(crate) fn is_same(&self, other: &CaseContact) -> bool {
        let all = |contact: &CaseContact| {
            let numbers: Vec<_> = contact.inputs().into_iter().map(|(key, number)| (key, number.clone())).collect();
            (contact.profile_name(), numbers, contact.symbol(), contact.range.clone())
        };
        all(self) == all(other)
    }

    /// As scenes name it.
    pub(crate) fn profile_name(&self) -> &'static str {
        match self.terms.as_slice() {
            [shape] => shape.name(),
            _ => "sum",
        }
    }

    /// The parameters of the profile by the names that they have in records.
    pub(crate) fn parameters(&self) -> Vec<(&'static str, &Literal)> {
        let parameters = self.terms.iter().flat_map(Shape::parameters);
        parameters.map(|(name, number)| (if name == "c" { "C" } else { name }, number)).collect()
    }

    /// The parameters, E*, w and, on a machine, k.
    pub(crate) fn inputs(&self) -> Vec<(&'static str, &Literal)> {
        let mut inputs = self.parameters();
        inputs.extend([("E*", &self.e_star), ("w", &self.work_of_adhesion)]);
        inputs.extend(self.stiffness().map(|stiffness| (STIFFNESS, stiffness)));
        inputs
    }

    pub(crate) fn stiffness(&self) -> Option<&Literal> {
        match &self.control {
            Control::Machine { stiffness } => Some(stiffness),
            _ => None,
        }
    }

    /// The symbol of the controlled quantity.
    pub(crate) fn symbol(&self) -> &'static str {
        match self.control {
            Control::Indentation => "d",
            Control::Force => "F",
            Control::Machine { .. } => "D",
        }
    }

    /// The scene, in certified digits.
    pub(crate) fn scene(&self) -> Result<Scene> {
        let mut terms: Vec<_> = self.terms.iter().cloned().map(Profile::Shape).collect();
        let profile = if terms.len() == 1 { terms.remove(0) } else { Profile::Sum(terms) };
        let elasticity = Elasticity::Effective(self.e_star.clone());
        let scene = Scene::new(profile, elasticity, &self.work_of_adhesion)?;
        Ok(scene.control(self.control.clone()).arithmetic(Arithmetic::Certified { digits: DIGITS }))
    }

    /// All folds, in the range where there is one.
    pub(crate) fn all_folds(&self) -> Want {
        Want::Folds { range: self.range.clone() }
    }

    /// The answer to wants.
    pub(crate) fn answer(&self, wants: impl IntoIterator<Item = Want>) -> Result<Answer> {
        Ok(wants.into_iter().fold(self.scene()?, Scene::want).solve()?)
    }

    /// The critical state of a power law, or the threshold of C.
    pub(crate) fn critical(&self) -> Result<critical::CriticalAnswer> {
        let [Shape::Power { n, c }] = self.terms.as_slice() else { return Err(Failure::Missing("power law")) };
        let law = critical::PowerLaw {
            n: n.clone(),
            c: c.clone(),
            elasticity: Elasticity::Effective(self.e_star.clone()),
            work_of_adhesion: self.work_of_adhesion.clone(),
            control: self.control.clone(),
        };
        Ok(critical::critical(&law, Arithmetic::Certified { digits: DIGITS })?)
    }

    /// Its numbers in an arithmetic; `number` gets them in the order of [`CaseContact::inputs`].
    pub(crate) fn model<R: Real>(&self, mut number: impl FnMut(&Literal) -> R) -> contact::Result<Model<R>> {
        let terms = self.terms.iter().map(|shape| shape.map(|_, literal| number(literal))).collect();
        let material = Material::new(number(&self.e_star), number(&self.work_of_adhesion))?;
        let control = self.control.try_map(|stiffness| Ok::<_, Error>(number(stiffness)))?;
        Ok(Model { terms, material, control })
    }

    /// In arbitrary precision.
    pub(crate) fn float(&self, ctx: Precision) -> contact::Result<Model<Float>> {
        self.model(|literal| Float::from_literal(ctx, literal))
    }
}

impl<R: Real> Model<R> {
    /// The result of `f` for the curve of equilibria of the closed form.
    pub(crate) fn closed<T>(self, f: impl FnOnce(&Contact<R>) -> contact::Result<T>) -> contact::Result<T>
    where
        R: ClosedReal,
    {
        let terms = self.terms.into_iter().map(closed_form).collect::<contact::Result<_>>()?;
        let sum: Arc<dyn Transform<R>> = Arc::from(R::sum(terms));
        f(&Contact::half_space(&sum, &self.material, &self.control))
    }

    /// The power law.
    ///
    /// # Errors
    /// [`Error::Domain`] for another profile.
    pub(crate) fn law(self) -> contact::Result<Law<R>>
    where
        R: Kappa,
    {
        match self.terms.into_iter().next() {
            Some(Shape::Power { n, c }) => Ok(Law::new(PowerLaw::new(n, c)?, self.material)),
            other => Err(Error::Domain {
                quantity: Quantity::Parameter("the profile"),
                value: other.map_or("", |shape| shape.name()).to_owned(),
                requirement: "a power law",
            }),
        }
    }
}

impl Model<Float> {
    /// The result of `f` for the curve of equilibria by quadrature of the heights.
    pub(crate) fn integrated<T>(self, f: impl FnOnce(&Contact<Float>) -> contact::Result<T>) -> contact::Result<T> {
        f(&Contact::half_space(&Arc::new(Quadrature::of(self.terms)?), &self.material, &self.control))
    }
}
