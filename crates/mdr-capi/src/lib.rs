//! The C interface of the library `mdr`: a scene as text in, columns of numbers or JSON out. C includes
//! [`mdr.h`](../include/mdr.h), whose comments are the reference for callers; this crate says why each piece of it is sound.
//!
//! Handles are opaque, never changed once they are made, and shared by any number of threads. No panic crosses the border: it becomes
//! an error, and errors are texts of the calling thread. Whoever gets a handle or a text from here frees it here.
//!
//! This is the only crate of the workspace with unsafe code; each piece has its reason beside it.

mod border;
mod contact;
mod scene;

use std::ffi::{CStr, c_char, c_int};

use mdr::prelude::Status;

pub use contact::{
    ContactHandle, mdr_contact_free, mdr_contact_new, mdr_curve, mdr_folds, mdr_follow, mdr_pull_off, mdr_stability,
    mdr_states,
};
pub use scene::{Scene, mdr_scene_free, mdr_scene_open, mdr_scene_read, mdr_scene_solve, mdr_text_free};

/// What is returned where something went wrong.
const FAILED: c_int = -1;

/// What is returned where all went well.
const DONE: c_int = 0;

/// The statuses by their numbers in `mdr.h`, with their names.
const STATUSES: [(Status, &CStr); 8] = [
    (Status::Ok, c"ok"),
    (Status::Fold, c"fold"),
    (Status::NoEquilibrium, c"no-equilibrium"),
    (Status::Overflow, c"overflow"),
    (Status::Underflow, c"underflow"),
    (Status::DomainError, c"domain-error"),
    (Status::NotAdmissible, c"not-admissible"),
    (Status::Undecided, c"undecided"),
];

/// The number of a status.
fn code(status: Status) -> c_int {
    let place = STATUSES.iter().position(|(known, _)| *known == status);
    place.map_or(FAILED, |place| c_int::try_from(place).unwrap_or(FAILED))
}

/// The version of the library.
#[unsafe(no_mangle)]
pub extern "C" fn mdr_version() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}

/// 1 if the library has certified digits, else 0.
#[unsafe(no_mangle)]
pub extern "C" fn mdr_certified() -> c_int {
    c_int::from(cfg!(feature = "mp"))
}

/// The error of the last call on this thread; an empty text if there was none. It lives until the next call on this thread.
#[unsafe(no_mangle)]
pub extern "C" fn mdr_error() -> *const c_char {
    border::last_error()
}

/// The name of a status, `unknown` of another number.
#[unsafe(no_mangle)]
pub extern "C" fn mdr_status_name(status: c_int) -> *const c_char {
    let place = usize::try_from(status).ok();
    place.and_then(|place| STATUSES.get(place)).map_or(c"unknown", |(_, name)| name).as_ptr()
}

/// Frees what this thread keeps of arbitrary precision. A thread that has solved scenes calls it before it ends.
#[unsafe(no_mangle)]
pub extern "C" fn mdr_thread_end() {
    border::guarded((), || {
        mdr::free_thread_cache();
        Ok(())
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_status_has_its_number_and_name() {
        for (number, (status, name)) in (0..).zip(STATUSES) {
            assert_eq!(code(status), number);
            assert_eq!(name.to_str(), Ok(status.name()));
        }
        assert_eq!(Status::ALL.len(), STATUSES.len());
    }
}
