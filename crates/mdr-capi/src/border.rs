//! The border to C: nothing unwinds across it, errors are texts of the thread, and memory is read and written here alone.

use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

thread_local! {
    /// What went wrong last on this thread.
    static ERROR: RefCell<CString> = RefCell::default();
}

/// What went wrong, in words for a reader.
pub(crate) type Result<T> = std::result::Result<T, String>;

/// The result of `work`, or `failure` after the error has been kept for [`last_error`]. A panic is an error.
///
/// A handle that a panic has passed through can be used again: handles are never changed, and what they remember of the last
/// search is replaced as a whole.
pub(crate) fn guarded<T>(failure: T, work: impl FnOnce() -> Result<T>) -> T {
    let result = catch_unwind(AssertUnwindSafe(work));
    let error = match result {
        Ok(Ok(value)) => {
            keep("");
            return value;
        }
        Ok(Err(error)) => error,
        Err(panic) => format!("internal error, please report it: {}", message(&*panic)),
    };
    keep(&error);
    failure
}

fn message(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or(panic.downcast_ref::<&str>().copied()).unwrap_or("a panic without a message")
}

fn keep(error: &str) {
    ERROR.with_borrow_mut(|kept| *kept = terminated(error));
}

/// The error of the last call on this thread, or an empty text.
pub(crate) fn last_error() -> *const c_char {
    ERROR.with_borrow(|kept| kept.as_ptr())
}

/// A text with its end marked; a zero within it, which would end it, is left out.
fn terminated(text: &str) -> CString {
    let bytes: Vec<u8> = text.bytes().filter(|byte| *byte != 0).collect();
    CString::new(bytes).unwrap_or_default()
}

/// A text that C owns, to be given to [`free_text`].
pub(crate) fn given(text: &str) -> *mut c_char {
    terminated(text).into_raw()
}

/// Frees a text of [`given`]; null is nothing.
///
/// # Safety
/// `text` is null, or from [`given`] and not yet freed.
pub(crate) unsafe fn free_text(text: *mut c_char) {
    if !text.is_null() {
        // SAFETY: by the contract of this function it is the pointer of `CString::into_raw`, once.
        drop(unsafe { CString::from_raw(text) });
    }
}

/// A text of C, as it is.
///
/// # Errors
/// Null, or bytes that are not UTF-8.
///
/// # Safety
/// `text` is null, or ends with a zero, and does not change while the result is used.
pub(crate) unsafe fn text<'a>(text: *const c_char, name: &str) -> Result<&'a str> {
    if text.is_null() {
        return Err(format!("{name} is a null pointer"));
    }
    // SAFETY: it is not null, and by the contract of this function ends with a zero and does not change.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|error| format!("{name} is not UTF-8: {error}"))
}

/// What a handle stands for.
///
/// # Errors
/// Null.
///
/// # Safety
/// `handle` is null, or from [`handle`] and not freed while the result is used.
pub(crate) unsafe fn behind<'a, T>(handle: *const T, name: &str) -> Result<&'a T> {
    // SAFETY: by the contract of this function it is null, which gives none, or points to a value that lives.
    unsafe { handle.as_ref() }.ok_or_else(|| format!("{name} is a null pointer"))
}

/// A handle that C owns, to be given to [`free`].
pub(crate) fn handle<T>(value: T) -> *mut T {
    Box::into_raw(Box::new(value))
}

/// Frees a handle; null is nothing.
///
/// # Safety
/// `handle` is null, or from [`handle`] and not yet freed, and no other thread uses it.
pub(crate) unsafe fn free<T>(handle: *mut T) {
    if !handle.is_null() {
        // SAFETY: by the contract of this function it is the pointer of `Box::into_raw`, once.
        drop(unsafe { Box::from_raw(handle) });
    }
}

/// `count` numbers of C. None need no pointer.
///
/// # Errors
/// Null, though there are some; more than there can be in memory.
///
/// # Safety
/// `values` is null, or points to `count` numbers that do not change while the result is used.
pub(crate) unsafe fn values<'a>(values: *const f64, count: usize, name: &str) -> Result<&'a [f64]> {
    if count == 0 {
        return Ok(&[]);
    }
    if values.is_null() {
        return Err(format!("{name} is a null pointer"));
    }
    if count > isize::MAX as usize / size_of::<f64>() {
        return Err(format!("{name}: {count} numbers are more than there can be"));
    }
    // SAFETY: not null, not too many, and by the contract of this function `count` numbers that do not change.
    Ok(unsafe { std::slice::from_raw_parts(values, count) })
}

/// Writes a column; a column that is null is not wanted.
///
/// # Safety
/// `column` is null, or has room for `items`.
pub(crate) unsafe fn write<T: Copy>(items: &[T], column: *mut T) {
    if !column.is_null() {
        // SAFETY: by the contract of this function there is room; `items` is memory of this library, which C has no pointer to.
        unsafe { std::ptr::copy_nonoverlapping(items.as_ptr(), column, items.len()) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error() -> String {
        // SAFETY: the text lives until the next call on this thread, and is copied before it.
        unsafe { text(last_error(), "error") }.expect("a text").to_owned()
    }

    #[test]
    fn errors_and_panics_stay_on_their_side_and_thread() {
        assert_eq!(guarded(-1, || Err("no \0 scene".to_owned())), -1);
        assert_eq!(error(), "no  scene");
        assert_eq!(guarded(-1, || panic!("at {}", 7)), -1);
        assert_eq!(error(), "internal error, please report it: at 7");
        let elsewhere = std::thread::spawn(error).join().expect("no panic");
        assert_eq!(elsewhere, "");
        assert_eq!(guarded(-1, || Ok(0)), 0);
        assert_eq!(error(), "");
    }

    #[test]
    fn null_pointers_are_errors_and_unwanted_columns() {
        // SAFETY: null is allowed.
        assert!(unsafe { text(std::ptr::null(), "text") }.is_err());
        // SAFETY: null is allowed.
        assert!(unsafe { behind::<i32>(std::ptr::null(), "handle") }.is_err());
        // SAFETY: null is allowed.
        assert!(unsafe { values(std::ptr::null(), 1, "values") }.is_err());
        // SAFETY: null is allowed.
        assert_eq!(unsafe { values(std::ptr::null(), 0, "values") }, Ok(&[][..]));
        // SAFETY: null is allowed.
        unsafe { write(&[1.0], std::ptr::null_mut()) };
        // SAFETY: null is allowed.
        unsafe { free::<i32>(std::ptr::null_mut()) };
        // SAFETY: null is allowed.
        unsafe { free_text(std::ptr::null_mut()) };
    }
}
