//! The engine of the explorer page: one contact of the library `mdr` in f64, behind a plain C ABI.
//!
//! A contact comes in as the text of a scene, the same that `mdr solve` reads, so that the page shows the numbers of the program.
//! Numbers go in as arguments. Results come out as rows of doubles in one buffer, [`out`], and every function returns how many
//! rows there are, or a negative [`Failure`], of which [`message`] says more. No other thing crosses the border: no objects, no
//! generated glue. Whatever comes in, a call returns: a panic would end the instance, of which the page then makes a new one.

mod edges;
mod engine;
mod picture;

use std::cell::RefCell;

use engine::Engine;

thread_local! {
    static ENGINE: RefCell<Option<Engine>> = const { RefCell::new(None) };
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUT: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
    static MESSAGE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// The meaning of a negative number of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Failure {
    /// The scene is refused, or a number is outside of its domain.
    Refused = -1,
    /// Every radius is an equilibrium, or none: n = 1/2 at the threshold (1.19).
    Undecided = -2,
    /// No contact is open.
    Empty = -3,
    /// No stable state to start from, out of range, no convergence.
    Unanswered = -4,
}

/// The kind of failure; its words are kept as the message.
fn failure(error: &mdr::Error) -> Failure {
    MESSAGE.set(error.to_string());
    match error {
        mdr::Error::Contact(mdr::ContactError::Domain { .. }) | mdr::Error::Scene { .. } => Failure::Refused,
        mdr::Error::Contact(mdr::ContactError::Undecided { .. }) => Failure::Undecided,
        _ => Failure::Unanswered,
    }
}

/// Fills the buffer of results; the number of rows.
fn rows<const N: usize>(found: Result<Vec<[f64; N]>, mdr::Error>) -> i32 {
    match found {
        Ok(found) => OUT.with_borrow_mut(|out| {
            out.clear();
            out.extend(found.as_flattened());
            i32::try_from(found.len()).unwrap_or(i32::MAX)
        }),
        Err(error) => failure(&error) as i32,
    }
}

/// Fills the buffer with the answer to a question about the contact that is open; the number of rows.
fn ask<const N: usize>(question: impl FnOnce(&Engine) -> Result<Vec<[f64; N]>, mdr::Error>) -> i32 {
    ENGINE.with_borrow(|engine| match engine {
        Some(engine) => rows(question(engine)),
        None => {
            MESSAGE.set("no contact is open".to_owned());
            Failure::Empty as i32
        }
    })
}

/// Where the rows are.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn out() -> *const f64 {
    OUT.with_borrow(|out| out.as_ptr())
}

/// Where the words of the last failure are, in UTF-8; [`message_length`] says how many bytes.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn message() -> *const u8 {
    MESSAGE.with_borrow(|message| message.as_ptr())
}

/// The bytes of [`message`].
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn message_length() -> usize {
    MESSAGE.with_borrow(String::len)
}

/// The most bytes of a scene and its table.
pub const MOST_BYTES: usize = 1 << 23;

/// Room for `length` bytes of text, to be written before [`contact`]; null, with words in [`message`], where `length` is more
/// than [`MOST_BYTES`].
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|input| {
        input.clear();
        if length > MOST_BYTES {
            MESSAGE.set(format!("a scene and its table may have {MOST_BYTES} bytes, got {length}"));
            return std::ptr::null_mut();
        }
        input.resize(length, 0);
        input.as_mut_ptr()
    })
}

/// The first numbers of the buffer of results, for a caller in Rust: a page reads the memory itself.
pub fn read(length: usize) -> Vec<f64> {
    OUT.with_borrow(|out| out[..length.min(out.len())].to_vec())
}

/// Fills the room for text, for a caller in Rust.
pub fn write(text: &[u8]) {
    INPUT.with_borrow_mut(|input| text.clone_into(input));
}

/// Opens a contact and finds its folds: rows of a, d, F, kind (0 minimum, 1 maximum; of an advancing edge with a work of adhesion
/// of its own 2 and 3). The input is a scene as TOML of `scene`
/// bytes, and after it the table of a measured profile as CSV, if the scene names one.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn contact(scene: usize) -> i32 {
    let opened = INPUT.with_borrow(|input| {
        let (scene, table) = input.split_at(scene.min(input.len()));
        Engine::open(&String::from_utf8_lossy(scene), table)
    });
    let opened = opened.and_then(|engine| Ok((engine.folds()?, engine)));
    rows(opened.map(|(folds, engine)| {
        ENGINE.set(Some(engine));
        folds
    }))
}

/// κ_n (1.12): g = κ_n C xⁿ of a power law; NaN where n is not positive.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn kappa(n: f64) -> f64 {
    engine::kappa(n).unwrap_or(f64::NAN)
}

/// The outer radius of the profile; infinite where it has none.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn outer_radius() -> f64 {
    ENGINE.with_borrow(|engine| engine.as_ref().map_or(f64::NAN, Engine::outer_radius))
}

/// The curve of equilibria: rows of a, g, Δl, d, F, stable. Radii where g is not known are left out; which they are, and which
/// are refused, as in [`balance`].
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn curve(low: f64, high: f64, count: u32, power: f64) -> i32 {
    ask(|engine| engine.curve(&picture::radii(low, high, count, power)?))
}

/// The balance at the edge while the control is held at `value`: rows of a, g − d, Δl, and d. The radii are evenly spaced in
/// a^(1/power), or in ln a for power 0. [`Failure::Refused`] unless 0 ≤ low ≤ high, all finite, power ≥ 0, count ≤ 10 000.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn balance(value: f64, low: f64, high: f64, count: u32, power: f64) -> i32 {
    ask(|engine| engine.balance(value, &picture::radii(low, high, count, power)?))
}

/// All equilibria at a value of the control: rows of a, d, F, stability (1 stable, −1 unstable), by increasing radius.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn equilibria(value: f64) -> i32 {
    ask(|engine| engine.equilibria(value))
}

/// The curve of equilibria of an advancing edge, where there are two works of adhesion: rows as those of [`curve`], which then
/// has those of the receding edge. No rows where there is one work.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn advancing_curve(low: f64, high: f64, count: u32, power: f64) -> i32 {
    ask(|engine| engine.advancing_curve(&picture::radii(low, high, count, power)?))
}

/// All equilibria of an advancing edge, where there are two works of adhesion: rows as those of [`equilibria`].
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn advancing_equilibria(value: f64) -> i32 {
    ask(|engine| engine.advancing_at(value))
}

/// An edge that is pinned at the radius `a` between two works of adhesion while the control is held at `value`: a row of d, F.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn pinned(a: f64, value: f64) -> i32 {
    ask(|engine| engine.pinned(a, value))
}

/// Moves the control from `from` to `to`, starting at the equilibrium next to the radius `a`, or detached for a < 0: rows of
/// kind, value, a, d, F before, a, d, F after, the energy lost in a jump, infinite where it has no bound, and what a receding edge
/// has lost since the row before. With two works of adhesion it starts with an edge that is pinned at `a`, where it can be.
///
/// Kinds: 1 touch, 2 jump-in, 3 jump, 4 detached, 5 complete contact, 6 end of the profile, 7 undecided, 8 not admissible, 11
/// pinned, 12 depinned; 10, the last row, is the arrival at `to`, if the path gets there. Surfaces that are apart have a = 0, and those that touch
/// everywhere NaN.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn advance(a: f64, from: f64, to: f64) -> i32 {
    ask(|engine| engine.advance(a, from, to))
}

/// The profile and the gap outside of a contact of radius `a` at indentation `d`, in equilibrium or not: rows of r, f(r) and the
/// gap, which is 0 within the contact and where `a` is not positive.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn surface(a: f64, d: f64, high: f64, count: u32) -> i32 {
    ask(|engine| engine.surface(a, d, high, count))
}

/// Two routes that share no formula, at one radius: a row of g by the closed form, g by quadrature of (1.1) over the heights,
/// and their relative difference.
#[allow(unsafe_code, reason = "an exported name")]
#[unsafe(no_mangle)]
pub extern "C" fn verify(a: f64) -> i32 {
    ask(|engine| engine.verify(a).map(|row| vec![row]))
}
