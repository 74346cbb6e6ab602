//! Certificates of the records about folds on graded half-spaces, of line contacts and of waves.

use mdr::prelude::Want;

use crate::Result;
use crate::media::{FILES, Question};

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
}
