//! Certificates of the records about folds on graded half-spaces, of line contacts and of waves.

use mdr::prelude::{Arithmetic, Elasticity, ExactMedium, Grading, Literal, Profile, Scene, Shape, Want};
use mdr_core::contact::Control;

use crate::media::{FILES, Held, Question};
use crate::{DIGITS, Failure, Result};

/// The formulas whose questions are folds.
const FOLDS: [&str; 3] = ["graded-critical", "line-critical", "wave-fold"];

/// A question for each contact whose folds are records.
pub(crate) fn contacts() -> Vec<&'static Question> {
    let mut contacts: Vec<&'static Question> = Vec::new();
    let all = FILES.iter().flat_map(|(_, questions)| questions.iter().copied().flatten());
    for question in all.filter(|question| FOLDS.contains(&question.formula)) {
        let contact = |one: &Question| (one.formula, one.held, one.inputs);
        if !contacts.iter().any(|known| contact(known) == contact(question)) {
            contacts.push(question);
        }
    }
    contacts
}

impl Question {
    /// The certificate of all folds of its contact.
    pub(crate) fn certificate(&self) -> Result<String> {
        let scene = self.scene()?.want(Want::Folds { range: None });
        Ok(scene.certificate(&scene.solve()?)?)
    }

    fn scene(&self) -> Result<Scene> {
        let (profile, medium) = match self.formula {
            "graded-critical" => {
                let stiffness = Grading::Coefficient(self.given("c")?);
                (self.power()?, ExactMedium::Graded { exponent: self.given("chi")?, stiffness })
            }
            "line-critical" => (self.power()?, ExactMedium::Plane { reference: None }),
            _ => {
                let wavelength = self.given("lambda")?;
                (Profile::Wave(self.given("h0")?), ExactMedium::Periodic { wavelength, flaw: None })
            }
        };
        let control = match self.held {
            Some(Held::Machine) => Control::Machine { stiffness: self.given("k")? },
            Some(Held::Force) => Control::Force,
            _ => Control::Indentation,
        };
        // Unused on a graded half-space.
        let modulus = self.given("E*").unwrap_or_else(|_| 1.into());
        let scene = Scene::new(profile, Elasticity::Effective(modulus), &self.given("w")?)?.medium(medium)?;
        Ok(scene.control(control).arithmetic(Arithmetic::Certified { digits: DIGITS }))
    }

    fn power(&self) -> Result<Profile> {
        Ok(Profile::Shape(Shape::Power { n: self.given("n")?, c: self.given("C")? }))
    }

    /// An input.
    fn given(&self, key: &'static str) -> Result<Literal> {
        let found = self.literals().find(|(name, _)| *name == key);
        found.map(|(_, literal)| literal).ok_or(Failure::Missing(key))
    }
}
