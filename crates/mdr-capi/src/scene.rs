//! Scenes from text, and their answers as JSON.

use std::ffi::{c_char, c_int};

use mdr::prelude::Arithmetic;
use mdr::{Run, Stop};

use crate::border::{Result, behind, free, free_text, given, guarded, handle, text};

/// A scene that has been read.
pub struct Scene(pub(crate) mdr::Scene);

/// Reads a scene: TOML, or JSON if the text begins with a brace. Files that it names are looked for from the current folder. Null, with
/// an error, if it is no scene.
///
/// # Safety
/// `text` is null, or ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_scene_read(text: *const c_char) -> *mut Scene {
    guarded(std::ptr::null_mut(), || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let text = unsafe { self::text(text, "text") }?;
        let json = text.trim_start().starts_with('{');
        let scene =
            if json { mdr::Scene::from_json } else { mdr::Scene::from_toml }(text, "", &|name| mdr::files::named(name));
        scene.map(|scene| handle(Scene(scene))).map_err(|error| error.to_string())
    })
}

/// Reads a scene from a file. Null, with an error that names the line, if it is no scene.
///
/// # Safety
/// `path` is null, or ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_scene_open(path: *const c_char) -> *mut Scene {
    guarded(std::ptr::null_mut(), || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let path = unsafe { text(path, "path") }?;
        mdr::Scene::open(path).map(|scene| handle(Scene(scene))).map_err(|error| error.to_string())
    })
}

/// Frees a scene; null is nothing.
///
/// # Safety
/// `scene` is null, or from [`mdr_scene_read`] or [`mdr_scene_open`], not yet freed, and not in use.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_scene_free(scene: *mut Scene) {
    // SAFETY: by the contract of this function.
    unsafe { free(scene) };
}

/// The answer to a scene as JSON, `mdr.solve/1`, which the caller frees by [`mdr_text_free`]: in certified digits if `digits` is
/// positive, in doubles if it is negative, as the scene says if it is 0. Null, with an error, if it has none.
///
/// # Safety
/// `scene` is null, or a scene that is not freed meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_scene_solve(scene: *const Scene, digits: c_int) -> *mut c_char {
    guarded(std::ptr::null_mut(), || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let Scene(scene) = unsafe { behind(scene, "scene") }?;
        solved(scene, digits).map(|answer| given(&answer))
    })
}

/// The answer with the notes that a reader gets.
fn solved(scene: &mdr::Scene, digits: c_int) -> Result<String> {
    let arithmetic = match u32::try_from(digits) {
        Ok(0) => None,
        Ok(digits) => Some(Arithmetic::Certified { digits }),
        Err(_) => Some(Arithmetic::F64),
    };
    let scene = scene.clone().in_arithmetic(arithmetic);
    let answer = scene.solve_with(&mut Run::new(&mut (), Stop::default()));
    let mut answer = answer.map_err(|error| error.to_string())?;
    answer.notes.extend(scene.unused(false));
    Ok(answer.to_json())
}

/// Frees a text that [`mdr_scene_solve`] has returned; null is nothing.
///
/// # Safety
/// `text` is null, or such a text, not yet freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_text_free(text: *mut c_char) {
    // SAFETY: by the contract of this function.
    unsafe { free_text(text) };
}
