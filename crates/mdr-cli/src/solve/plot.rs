//! `--plot`: the picture of a scene.

use std::path::Path;
use std::sync::Arc;

use mdr_core::contact::{Error, Result as Computed};
use mdr_numeric::equilibrium::Branches;

use super::contact::{Contact, Tally};
use super::path;
use crate::error::{Failure, Result};
use crate::picture::scene::SceneData;
use crate::picture::{self, Picture};
use crate::scene::Scene;

/// Draws the scene that was read from the file `from` to the SVG file `to`, and its data to a CSV file beside it.
///
/// # Errors
/// When the contact cannot be computed in f64 or a file cannot be written.
pub(crate) fn write(scene: &Scene, from: &Path, to: &Path) -> Result<()> {
    let picture = drawing(scene, from).map_err(Failure::Contact)?;
    let failed = |file: &Path| {
        let name = format!("--plot {}", file.display());
        move |error: std::io::Error| Failure::file(name, error)
    };
    std::fs::write(to, picture::svg(&picture)?).map_err(failed(to))?;
    let csv = to.with_extension("csv");
    let mut data = Vec::new();
    picture::write_csv(&picture, &csv.display().to_string(), &mut data)?;
    std::fs::write(&csv, data).map_err(failed(&csv))
}

/// What is seen of a scene.
fn drawing(scene: &Scene, from: &Path) -> Computed<Picture> {
    let contact: Contact<f64> = Contact::new(scene, (), &Arc::new(Tally::default()))?;
    let branches = Branches::new(contact.curve())?;
    let events = if scene.held.path.is_empty() {
        Vec::new()
    } else {
        match path::follow(&contact, &branches, &scene.held) {
            // A path that has no beginning is told by the output that asks for it.
            Err(Error::NoEquilibrium { .. }) => Vec::new(),
            path => path?.events,
        }
    };
    let values: Vec<f64> = scene.output.values.iter().map(|literal| contact.number(literal)).collect();
    let name =
        from.file_stem().filter(|stem| *stem != "-").map_or_else(String::new, |stem| format!(": {}", stem.display()));
    let title = format!("{} under controlled {}{name}", scene.profile.name(), scene.held.by.name());
    Ok(picture::scene::picture(&SceneData::new(title, &branches, &events, &values)?))
}
