//! Long computations: without the GIL, on a thread of their own, and stopped by a signal such as Ctrl-C.

use std::any::Any;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use mdr::Stop;
use pyo3::prelude::*;

use crate::errors::raise;

/// How long a signal may wait.
const PERIOD: Duration = Duration::from_millis(50);

/// As much as a main thread has.
const STACK: usize = 8 << 20;

/// The result of `work`, which ends soon after its stop is asked for.
///
/// # Errors
/// The exception of a signal handler, `KeyboardInterrupt`. A panic of the work is an `InternalError`.
pub(crate) fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop::default();
    py.detach(|| {
        thread::scope(|scope| {
            // Dropped when the work ends, in whatever way.
            let (working, ended) = mpsc::channel::<()>();
            let run = || {
                let _working = working;
                let result = work(&stop);
                mdr::free_thread_cache();
                result
            };
            let worker = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run)?;
            let mut interrupted = Ok(());
            while interrupted.is_ok() && ended.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                interrupted = Python::attach(|py| py.check_signals());
            }
            if interrupted.is_err() {
                stop.stop();
            }
            let result = worker.join();
            interrupted?;
            result.map_err(|panic| internal(&*panic))
        })
    })
}

/// The result of `work` that cannot be stopped: after a signal it is left to end by itself.
///
/// # Errors
/// The exception of a signal handler, `KeyboardInterrupt`. A panic of the work is an `InternalError`.
pub(crate) fn abandonable<T: Send + 'static>(py: Python<'_>, work: impl FnOnce() -> T + Send + 'static) -> PyResult<T> {
    let (done, result) = mpsc::channel();
    let run = move || {
        let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(work));
        mdr::free_thread_cache();
        // After a signal nobody waits for it.
        let _ = done.send(result);
    };
    py.detach(move || {
        thread::Builder::new().stack_size(STACK).spawn(run)?;
        loop {
            match result.recv_timeout(PERIOD) {
                Ok(result) => return result.map_err(|panic| internal(&*panic)),
                Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
                Err(RecvTimeoutError::Disconnected) => return Err(internal(&"a thread without a result")),
            }
        }
    })
}

/// The result of short work without the GIL.
///
/// # Errors
/// A panic is an `InternalError`.
pub(crate) fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let work = std::panic::AssertUnwindSafe(work);
    // The whole value is moved, not the field alone.
    let work = || std::panic::catch_unwind(move || { work }.0());
    py.detach(work).map_err(|panic| internal(&*panic))
}

fn internal(panic: &(dyn Any + Send)) -> PyErr {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    raise("InternalError", (format!("please report this: {}", text.unwrap_or("a panic without a message")),))
}
