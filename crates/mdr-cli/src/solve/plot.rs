//! `--plot`: the picture of a scene.

use std::path::Path;
use std::sync::Arc;

use super::contact::{Contact, Tally};
use super::states::branches;
use super::{Solver, complaint, path};
use crate::error::Result;
use crate::picture::scene::SceneData;
use crate::picture::{self, Picture};
use crate::scene::{Scene, Want};

/// How many octaves from the folds a picture can show equilibria.
const REACH: i64 = 40;

/// Draws the scene that was read from the file `from` and has been solved to the SVG file `to`, and its data to a CSV file
/// beside it.
///
/// # Errors
/// When the contact cannot be computed in f64 or a file cannot be written.
pub(crate) fn write(scene: &Scene, solver: &Solver<'_>, from: &Path, to: &Path) -> Result<()> {
    picture::file::write(&drawing(scene, solver, from)?, to)
}

/// What is seen of a scene.
fn drawing(scene: &Scene, solver: &Solver<'_>, from: &Path) -> Result<Picture> {
    scene.places.require_doubles("--plot draws in f64")?;
    let contact: Contact<f64> = Contact::new(scene, (), &Arc::new(Tally::default()))?;
    let branches = branches(&contact, solver.folds(&contact)?, REACH);
    let events = if scene.held.path.is_empty() {
        Vec::new()
    } else {
        let path = path::follow(&contact, &branches, &scene.held);
        path.map_err(|error| complaint(scene, Want::Path, error, solver))?.events
    };
    let values: Vec<f64> = scene.output.values.iter().map(|literal| contact.number(literal)).collect();
    let name =
        from.file_stem().filter(|stem| *stem != "-").map_or_else(String::new, |stem| format!(": {}", stem.display()));
    let title = format!("{} under controlled {}{name}", scene.profile.name(), scene.held.by.name());
    Ok(picture::scene::picture(&SceneData::new(title, &branches, &events, &values)?))
}
