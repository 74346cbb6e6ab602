//! Certificates of the records about folds on graded half-spaces, of line contacts and of waves.

use std::collections::BTreeMap;

use mdr::no_files;
use mdr::prelude::Scene;
use serde_json::json;

use crate::cases::read;
use crate::media::{FILES, Held, Question};
use crate::{DIGITS, Failure, Result};

/// The contacts as scenes, by the names of their formulas.
const SCENES: &str = include_str!("../data/media_scenes.toml");

/// By the name of a formula, the tables of a scene.
type Scenes = BTreeMap<String, BTreeMap<String, BTreeMap<String, String>>>;

/// A question for each contact whose folds are records.
pub(crate) fn contacts() -> Result<Vec<&'static Question>> {
    let scenes: Scenes = read(SCENES)?;
    let mut contacts: Vec<&'static Question> = Vec::new();
    let all = FILES.iter().flat_map(|(_, questions)| questions.iter().copied().flatten());
    for question in all.filter(|question| scenes.contains_key(question.formula)) {
        let contact = |one: &Question| (one.formula, one.held, one.inputs);
        if !contacts.iter().any(|known| contact(known) == contact(question)) {
            contacts.push(question);
        }
    }
    Ok(contacts)
}

impl Question {
    /// The certificate of all folds of its contact.
    pub(crate) fn certificate(&self) -> Result<String> {
        let scene = self.scene()?;
        Ok(scene.certificate(&scene.solve()?)?)
    }

    /// The contact as a scene that asks for its folds.
    fn scene(&self) -> Result<Scene> {
        let mut scenes: Scenes = read(SCENES)?;
        let mut scene =
            scenes.remove(self.formula).ok_or_else(|| Failure::Data(format!("no scene of {}", self.formula)))?;
        for value in scene.values_mut().flat_map(BTreeMap::values_mut) {
            if let Some((_, input)) = self.inputs.iter().find(|(name, _)| name == value) {
                (*input).clone_into(value);
            }
        }
        let mut control = json!({"kind": self.held.unwrap_or(Held::Indentation).name()});
        if let Some((_, stiffness)) = self.inputs.iter().find(|(name, _)| *name == "k") {
            control["stiffness"] = json!(stiffness);
        }
        let mut scene = json!(scene);
        scene["control"] = control;
        scene["output"] = json!({"want": ["folds"], "digits": DIGITS});
        Ok(Scene::from_json(&scene.to_string(), self.name, &no_files)?)
    }
}
