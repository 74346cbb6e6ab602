//! The contact of a scene in doubles: columns of states.

use std::ffi::c_int;

use mdr::columns::{Choice, ContactColumns, States};
use mdr::prelude::{Control, FoldKind, Stability, Start};

use crate::border::{Result, behind, free, guarded, handle, values, write};
use crate::scene::Scene;
use crate::{DONE, FAILED, code};

/// Profile and material of a scene in doubles.
pub struct ContactHandle(ContactColumns);

const _: fn() = || {
    fn shared<T: Send + Sync>() {}
    shared::<ContactHandle>();
    shared::<Scene>();
};

/// The contact of a scene. Null, with an error, if it has a number that no double holds.
///
/// # Safety
/// `scene` is null, or a scene that is not freed meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_contact_new(scene: *const Scene) -> *mut ContactHandle {
    guarded(std::ptr::null_mut(), || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let Scene(scene) = unsafe { behind(scene, "scene") }?;
        ContactColumns::new(scene).map(|contact| handle(ContactHandle(contact))).map_err(|error| error.to_string())
    })
}

/// Frees a contact; null is nothing.
///
/// # Safety
/// `contact` is null, or from [`mdr_contact_new`], not yet freed, and not in use.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_contact_free(contact: *mut ContactHandle) {
    // SAFETY: by the contract of this function.
    unsafe { free(contact) };
}

/// Three columns and their statuses, each with room for all values or null.
#[derive(Clone, Copy)]
struct Columns {
    contact_radius: *mut f64,
    indentation: *mut f64,
    force: *mut f64,
    status: *mut c_int,
}

impl Columns {
    /// # Safety
    /// Each column is null, or has room for the states.
    unsafe fn fill(self, states: &States) {
        let codes: Vec<c_int> = states.status.iter().map(|status| code(*status)).collect();
        // SAFETY: by the contract of this function.
        unsafe { write(&states.contact_radius, self.contact_radius) };
        // SAFETY: by the contract of this function.
        unsafe { write(&states.indentation, self.indentation) };
        // SAFETY: by the contract of this function.
        unsafe { write(&states.force, self.force) };
        // SAFETY: by the contract of this function.
        unsafe { write(&codes, self.status) };
    }

    /// Fills the columns with a state for each of the values. 0, or -1 with an error.
    ///
    /// # Safety
    /// `contact` is null, or a contact that is not freed meanwhile; `values` points to `count` numbers; each column is null, or has
    /// room for `count`.
    unsafe fn answer(
        self,
        contact: *const ContactHandle,
        values: *const f64,
        count: usize,
        ask: impl FnOnce(&ContactColumns, &[f64]) -> Result<States>,
    ) -> c_int {
        guarded(FAILED, || {
            // SAFETY: by the contract of this function, for as long as it runs.
            let ContactHandle(contact) = unsafe { behind(contact, "contact") }?;
            // SAFETY: by the contract of this function, until the columns are written.
            let values = unsafe { self::values(values, count, "values") }?;
            let states = ask(contact, values)?;
            // SAFETY: by the contract of this function.
            unsafe { self.fill(&states) };
            Ok(DONE)
        })
    }
}

/// The control by its number in `mdr.h`.
fn control_of(kind: c_int, stiffness: f64) -> Result<Control<f64>> {
    match kind {
        0 => Ok(Control::Indentation),
        1 => Ok(Control::Force),
        2 => Control::machine(stiffness).map_err(|error| error.to_string()),
        _ => Err(format!("control {kind} is none of 0 (indentation), 1 (force), 2 (machine)")),
    }
}

/// The stable equilibrium at each value of the controlled quantity: d, F, or D = d + F/k of a machine. `choice` is 0 for the largest
/// contact radius and 1 for the smallest. 0, or -1 with an error; a value without a state has NaN and its status.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; `values` points to `count` numbers; each column is null, or has room
/// for `count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_states(
    contact: *const ContactHandle,
    control: c_int,
    stiffness: f64,
    choice: c_int,
    values: *const f64,
    count: usize,
    contact_radius: *mut f64,
    indentation: *mut f64,
    force: *mut f64,
    status: *mut c_int,
) -> c_int {
    let ask = |contact: &ContactColumns, values: &[f64]| {
        let choice = match choice {
            0 => Choice::Largest,
            1 => Choice::Smallest,
            _ => return Err(format!("choice {choice} is none of 0 (largest), 1 (smallest)")),
        };
        let control = control_of(control, stiffness)?;
        contact.states(&control, values, choice).map_err(|error| error.to_string())
    };
    let columns = Columns { contact_radius, indentation, force, status };
    // SAFETY: by the contract of this function.
    unsafe { columns.answer(contact, values, count, ask) }
}

/// The state at each of the values that the controlled quantity takes one after the other, slowly. `start` is 0 for the largest
/// stable contact radius at the first value, 1 for the smallest, 2 for surfaces that are apart. 0, or -1 with an error.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; `values` points to `count` numbers; each column is null, or has room
/// for `count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_follow(
    contact: *const ContactHandle,
    control: c_int,
    stiffness: f64,
    start: c_int,
    values: *const f64,
    count: usize,
    contact_radius: *mut f64,
    indentation: *mut f64,
    force: *mut f64,
    status: *mut c_int,
) -> c_int {
    let ask = |contact: &ContactColumns, values: &[f64]| {
        let start = match start {
            0 => Start::Largest,
            1 => Start::Smallest,
            2 => Start::Detached,
            _ => return Err(format!("start {start} is none of 0 (largest), 1 (smallest), 2 (detached)")),
        };
        let control = control_of(control, stiffness)?;
        let history = contact.follow(&control, values, &start).map_err(|error| error.to_string())?;
        Ok(history.states)
    };
    let columns = Columns { contact_radius, indentation, force, status };
    // SAFETY: by the contract of this function.
    unsafe { columns.answer(contact, values, count, ask) }
}

/// d and F of the equilibrium with each contact radius, stable or not. 0, or -1 with an error.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; `radii` points to `count` numbers; each column is null, or has room
/// for `count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_curve(
    contact: *const ContactHandle,
    radii: *const f64,
    count: usize,
    indentation: *mut f64,
    force: *mut f64,
    status: *mut c_int,
) -> c_int {
    guarded(FAILED, || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let ContactHandle(contact) = unsafe { behind(contact, "contact") }?;
        // SAFETY: by the contract of this function, until the columns are written.
        let radii = unsafe { values(radii, count, "radii") }?;
        let states = contact.curve(radii).map_err(|error| error.to_string())?;
        let contact_radius = std::ptr::null_mut();
        // SAFETY: by the contract of this function.
        unsafe { Columns { contact_radius, indentation, force, status }.fill(&states) };
        Ok(DONE)
    })
}

/// Whether the equilibrium with each contact radius is stable under a control: 1 stable, 0 neutral, -1 unstable, -2 outside of the
/// profile. 0, or -1 with an error.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; `radii` points to `count` numbers; `stable` is null, or has room for
/// `count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_stability(
    contact: *const ContactHandle,
    control: c_int,
    stiffness: f64,
    radii: *const f64,
    count: usize,
    stable: *mut c_int,
) -> c_int {
    guarded(FAILED, || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let ContactHandle(contact) = unsafe { behind(contact, "contact") }?;
        // SAFETY: by the contract of this function, until the column is written.
        let radii = unsafe { values(radii, count, "radii") }?;
        let control = control_of(control, stiffness)?;
        let found = contact.stability(&control, radii).map_err(|error| error.to_string())?;
        let found = found.iter().map(|stability| match stability {
            Some(Stability::Stable) => 1,
            Some(Stability::Neutral) => 0,
            Some(Stability::Unstable) => -1,
            None => -2,
        });
        let found: Vec<c_int> = found.collect();
        // SAFETY: by the contract of this function.
        unsafe { write(&found, stable) };
        Ok(DONE)
    })
}

/// The number of folds under a control; the first `capacity` of them, by increasing radius, go to the columns. `kind` is 0 where the
/// controlled quantity has a minimum, 1 where it has a maximum. -1 with an error.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; each column is null, or has room for `capacity`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_folds(
    contact: *const ContactHandle,
    control: c_int,
    stiffness: f64,
    capacity: usize,
    contact_radius: *mut f64,
    indentation: *mut f64,
    force: *mut f64,
    kind: *mut c_int,
) -> isize {
    guarded(-1, || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let ContactHandle(contact) = unsafe { behind(contact, "contact") }?;
        let control = control_of(control, stiffness)?;
        let folds = contact.folds(&control).map_err(|error| error.to_string())?;
        let shown = &folds[..folds.len().min(capacity)];
        let radii: Vec<f64> = shown.iter().map(|fold| fold.contact_radius).collect();
        let depths: Vec<f64> = shown.iter().map(|fold| fold.indentation).collect();
        let forces: Vec<f64> = shown.iter().map(|fold| fold.force).collect();
        let kinds: Vec<c_int> = shown.iter().map(|fold| c_int::from(fold.kind == FoldKind::Maximum)).collect();
        // SAFETY: by the contract of this function.
        unsafe { write(&radii, contact_radius) };
        // SAFETY: by the contract of this function.
        unsafe { write(&depths, indentation) };
        // SAFETY: by the contract of this function.
        unsafe { write(&forces, force) };
        // SAFETY: by the contract of this function.
        unsafe { write(&kinds, kind) };
        isize::try_from(folds.len()).map_err(|error| error.to_string())
    })
}

/// a, d and F of the state from which the contact comes off, drawn back from zero. 0, or -1 with an error.
///
/// # Safety
/// `contact` is null, or a contact that is not freed meanwhile; each pointer is null, or has room for one number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mdr_pull_off(
    contact: *const ContactHandle,
    control: c_int,
    stiffness: f64,
    contact_radius: *mut f64,
    indentation: *mut f64,
    force: *mut f64,
) -> c_int {
    guarded(FAILED, || {
        // SAFETY: by the contract of this function, for as long as it runs.
        let ContactHandle(contact) = unsafe { behind(contact, "contact") }?;
        let control = control_of(control, stiffness)?;
        let state = contact.pull_off(&control).map_err(|error| error.to_string())?;
        // SAFETY: by the contract of this function.
        unsafe { write(&[state.contact_radius], contact_radius) };
        // SAFETY: by the contract of this function.
        unsafe { write(&[state.indentation], indentation) };
        // SAFETY: by the contract of this function.
        unsafe { write(&[state.force], force) };
        Ok(DONE)
    })
}
