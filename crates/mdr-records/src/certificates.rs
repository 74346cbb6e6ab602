//! Certificates of the records about folds and equilibria, one for each contact, for a reader that is no part of this program.

use mdr::prelude::{Literal, Want};
use rayon::prelude::*;

use crate::cases::{self, Case};
use crate::{RecordError, Result, media_certificates};

/// The kinds of cases whose questions are folds, or equilibria at a value that is a decimal.
const KINDS: [&str; 6] = ["critical", "machine-folds", "folds", "equilibrium", "equilibria", "past"];

/// A contact of the records with the values of the controlled quantity at which equilibria are records.
struct Question<'a> {
    case: &'a Case,
    values: Vec<Literal>,
}

/// The certificates as lines of JSON, and for each contact without one the reason.
///
/// # Errors
/// [`RecordError`] for data without a meaning.
pub fn certificates() -> std::result::Result<(String, Vec<String>), RecordError> {
    let all = cases::all()?;
    let mut questions: Vec<Question<'_>> = Vec::new();
    for (_, case) in all.iter().filter(|(_, case)| KINDS.contains(&case.kind())) {
        let known = questions.iter().position(|known| known.case.contact.is_same(&case.contact));
        let place = known.unwrap_or_else(|| {
            questions.push(Question { case, values: Vec::new() });
            questions.len() - 1
        });
        let value = case.value().ok().filter(|_| !matches!(case.kind(), "critical" | "machine-folds" | "folds"));
        if let Some(value) = value.filter(|value| !questions[place].values.contains(value)) {
            questions[place].values.push(value);
        }
    }
    let (mut lines, mut without) = (String::new(), Vec::new());
    let of_cases = questions.par_iter().map(|question| (question.case.name.as_str(), question.certificate()));
    let of_media = media_certificates::contacts()
        .map_err(|source| RecordError { case: "media_scenes.toml".to_owned(), source })?;
    let of_media = of_media.par_iter().map(|question| (question.name, question.certificate()));
    for (name, certificate) in of_cases.chain(of_media).collect::<Vec<_>>() {
        match certificate {
            Ok(certificate) => lines.push_str(&(certificate + "\n")),
            Err(why) => without.push(format!("{name}: {why}")),
        }
    }
    Ok((lines, without))
}

impl Question<'_> {
    fn certificate(&self) -> Result<String> {
        let contact = &self.case.contact;
        let scene = contact.scene()?.want(contact.all_folds());
        let scene =
            if self.values.is_empty() { scene } else { scene.want(Want::Equilibria { at: self.values.clone() }) };
        Ok(scene.certificate(&scene.solve()?)?)
    }
}
