//! Critical states of many points at once: κ, a, d and F within 2 ulp, at a few nanoseconds a point.
//!
//! [`critical_states`] takes slices and fills slices. Ordinary points are evaluated by a kernel of doubles and pairs of
//! doubles without branches, several points per instruction; the instruction set is chosen at run time ([`InstructionSet`]).
//! Ordinary means: n between 2⁻³⁰ and 512 and not within 2⁻³⁷ of 1/2, E* and w between 10⁻²⁴ and 10²⁴ of their units, C
//! between 10⁻¹¹⁷ and 10¹¹⁷, and a between 10⁻⁸⁶ and 10⁸⁶ m. All other points, and every point under a machine, are
//! passed on to [`double::critical`](super::critical), within 1 ulp at some hundred nanoseconds; [`BatchReport::passed_on`]
//! counts them.
//!
//! Every point gets a [`Status`]. A quantity without a value is NaN, and then the status is not `Ok`:
//!
//! | status | meaning |
//! |---|---|
//! | `Ok` | all four are values |
//! | `Overflow`, `Underflow` | a, d or F leaves the range of `f64` (the first of them that does); the others are values. [`double::critical`](super::critical) gives its log₁₀ |
//! | `DomainError` | an input is not positive and finite, or n = 1/2, where no length is singled out; κ is a value if n is positive and finite |
//! | `Undecided` | 256 bits do not decide, see [the module above](super#errors) |
//!
//! ```
//! use mdr_analytic::double::grid::{Materials, Points, States, critical_states};
//! use mdr_core::contact::{Control, Material, Status};
//! let rubber = Material::new(1e6, 0.05)?;
//! let points = Points {
//!     exponent: &[1.0, 2.0, 0.25, 0.5],
//!     coefficient: &[0.1, 500.0, 1.0, 1.0],
//!     material: Materials::One(&rubber),
//! };
//! let [mut kappa, mut contact_radius, mut indentation, mut force] = [[0.0; 4]; 4];
//! let mut status = [Status::Ok; 4];
//! let tally = critical_states(&points, &Control::Indentation, &mut States {
//!     kappa: &mut kappa,
//!     contact_radius: &mut contact_radius,
//!     indentation: &mut indentation,
//!     force: &mut force,
//!     status: &mut status,
//! })?;
//! assert_eq!(kappa[1], 2.0);
//! assert!((indentation[2] / 603.9026733142962 - 1.0).abs() < 1e-15);
//! // n = 1/2 has no critical state; its status reports that.
//! assert_eq!(status, [Status::Ok, Status::Ok, Status::Ok, Status::DomainError]);
//! assert_eq!((tally.passed_on, tally.without_value), (1, 1));
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```

mod kernel;
mod path;
#[path = "../../../data/grid.rs"]
mod table;

use mdr_core::contact::{Control, Error, Material, Quantity, Ranged, Result, Status};

use self::kernel::{Edge, EdgeRows, Kernel, LEN, Pairs, Results, Row};
pub use self::path::InstructionSet;
pub(super) use self::path::Work;
use crate::double::pair::Arithmetic;

/// Power laws on materials, all slices of one length.
#[derive(Clone, Copy, Debug)]
pub struct Points<'a> {
    /// n.
    pub exponent: &'a [f64],
    /// C, in m^(1−n).
    pub coefficient: &'a [f64],
    /// E* and w.
    pub material: Materials<'a>,
}

/// One material for all points, or one for each.
#[derive(Clone, Copy, Debug)]
pub enum Materials<'a> {
    /// One material for all points.
    One(&'a Material<f64>),
    /// One for each point.
    Each {
        /// E*, in Pa.
        effective_modulus: &'a [f64],
        /// w, in J/m².
        work_of_adhesion: &'a [f64],
    },
}

/// The results, all slices as long as those of the points.
#[derive(Debug)]
pub struct States<'a> {
    /// κ_n.
    pub kappa: &'a mut [f64],
    /// a, in m.
    pub contact_radius: &'a mut [f64],
    /// d, in m; positive when pressed in.
    pub indentation: &'a mut [f64],
    /// F, in N; positive when compressive.
    pub force: &'a mut [f64],
    /// Whether all of them are values, or why not.
    pub status: &'a mut [Status],
}

/// The number of points that were not ordinary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BatchReport {
    /// Points computed in extended precision, one by one.
    pub passed_on: usize,
    /// Points whose status is not `Ok`.
    pub without_value: usize,
}

/// κ, a, d and F of the critical state at every point, each within 2 ulp of the true value for the doubles given.
///
/// # Errors
/// [`Error::Length`] when slices differ in length, [`Error::Domain`] for a machine whose stiffness is not positive and
/// finite. Failures at a point are reported by its status.
pub fn critical_states(points: &Points<'_>, control: &Control<f64>, states: &mut States<'_>) -> Result<BatchReport> {
    critical_states_on(InstructionSet::fastest(), points, control, states)
}

/// [`critical_states`] with the instructions of `path`.
///
/// # Errors
/// [`Error::Length`] when slices differ in length, [`Error::Domain`] for a machine whose stiffness is not positive and
/// finite. Failures at a point are reported by its status.
pub fn critical_states_on(
    path: InstructionSet,
    points: &Points<'_>,
    control: &Control<f64>,
    states: &mut States<'_>,
) -> Result<BatchReport> {
    require_one_length(points, states)?;
    let critical_ratio = match control {
        Control::Indentation => 1.0,
        Control::Force => 3.0,
        Control::Machine { stiffness } => {
            super::positive(Quantity::Stiffness, *stiffness)?;
            let mut tally = BatchReport::default();
            (0..points.exponent.len()).for_each(|i| pass_on(points, control, i, states, &mut tally));
            return Ok(tally);
        }
    };
    let mut grid = Grid { points, control, critical_ratio, states, tally: BatchReport::default() };
    path.run(&mut grid);
    Ok(grid.tally)
}

fn require_one_length(points: &Points<'_>, states: &States<'_>) -> Result<()> {
    let expected = points.exponent.len();
    let (modulus, work) = match points.material {
        Materials::One(_) => (expected, expected),
        Materials::Each { effective_modulus, work_of_adhesion } => (effective_modulus.len(), work_of_adhesion.len()),
    };
    let lengths = [
        (Quantity::Coefficient, points.coefficient.len()),
        (Quantity::EffectiveModulus, modulus),
        (Quantity::WorkOfAdhesion, work),
        (Quantity::Kappa, states.kappa.len()),
        (Quantity::ContactRadius, states.contact_radius.len()),
        (Quantity::Indentation, states.indentation.len()),
        (Quantity::Force, states.force.len()),
        (Quantity::Parameter("the status"), states.status.len()),
    ];
    Error::require_length(expected, lengths)
}

/// The data of one call.
struct Grid<'g, 's> {
    points: &'g Points<'g>,
    control: &'g Control<f64>,
    critical_ratio: f64,
    states: &'g mut States<'s>,
    tally: BatchReport,
}

impl Work for &mut Grid<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Arithmetic>(self, arithmetic: A) {
        self.states.status.fill(Status::Ok);
        match self.points.material {
            Materials::One(material) => {
                let edge = Edge::new(arithmetic, *material.effective_modulus(), *material.work_of_adhesion());
                self.rows(
                    arithmetic,
                    #[inline(always)]
                    move |_, kernel, n, c, results| kernel.run(n, c, edge, results),
                );
            }
            Materials::Each { effective_modulus, work_of_adhesion } => {
                let (mut length, mut root) = (Pairs::new(), Pairs::new());
                let mut pad = [[1.0; LEN]; 2];
                self.rows(
                    arithmetic,
                    #[inline(always)]
                    |start, kernel, n, c, results| {
                        let [pad_modulus, pad_work] = &mut pad;
                        let modulus = row(effective_modulus, start, pad_modulus);
                        let work = row(work_of_adhesion, start, pad_work);
                        kernel::edges(arithmetic, modulus, work, &mut length, &mut root);
                        let edges = EdgeRows { length: &length, root: &root, modulus };
                        kernel.run(n, c, edges, results)
                    },
                );
            }
        }
    }
}

impl Grid<'_, '_> {
    /// Row by row. A short last row is padded with ones and its results are copied.
    #[inline(always)]
    fn rows<A: Arithmetic>(
        &mut self,
        arithmetic: A,
        mut run: impl FnMut(usize, &mut Kernel<A>, &Row, &Row, &mut Results<'_>) -> bool,
    ) {
        let mut kernel = Kernel::new(arithmetic, self.critical_ratio);
        let mut pad = [[1.0; LEN]; 6];
        let len = self.points.exponent.len();
        for start in (0..len).step_by(LEN) {
            let [pad_n, pad_c, kappa, radius, indentation, force] = &mut pad;
            let n = row(self.points.exponent, start, pad_n);
            let c = row(self.points.coefficient, start, pad_c);
            let States { kappa: k, contact_radius: a, indentation: d, force: f, .. } = &mut *self.states;
            let mut results = Results {
                kappa: row_mut(k, start).unwrap_or(kappa),
                radius: row_mut(a, start).unwrap_or(radius),
                indentation: row_mut(d, start).unwrap_or(indentation),
                force: row_mut(f, start).unwrap_or(force),
            };
            let any_hard = run(start, &mut kernel, n, c, &mut results);
            let here = LEN.min(len - start);
            if here < LEN {
                k[start..].copy_from_slice(&kappa[..here]);
                a[start..].copy_from_slice(&radius[..here]);
                d[start..].copy_from_slice(&indentation[..here]);
                f[start..].copy_from_slice(&force[..here]);
            }
            if any_hard {
                for (i, _) in kernel.hard[..here].iter().enumerate().filter(|(_, hard)| **hard != 0.0) {
                    pass_on(self.points, self.control, start + i, self.states, &mut self.tally);
                }
            }
        }
    }
}

/// The row that begins at `start`, or the remainder, in `pad`.
#[inline(always)]
fn row<'a>(slice: &'a [f64], start: usize, pad: &'a mut Row) -> &'a Row {
    let rest = &slice[start..];
    match rest.first_chunk() {
        Some(row) => row,
        None => {
            pad[..rest.len()].copy_from_slice(rest);
            pad
        }
    }
}

#[inline(always)]
fn row_mut(slice: &mut [f64], start: usize) -> Option<&mut Row> {
    slice[start..].first_chunk_mut()
}

/// One point in extended precision.
#[cold]
#[inline(never)]
fn pass_on(points: &Points<'_>, control: &Control<f64>, i: usize, states: &mut States<'_>, tally: &mut BatchReport) {
    let (n, c) = (points.exponent[i], points.coefficient[i]);
    let critical = match points.material {
        Materials::One(material) => super::critical(n, c, material, control),
        Materials::Each { effective_modulus, work_of_adhesion } => {
            Material::new(effective_modulus[i], work_of_adhesion[i])
                .and_then(|material| super::critical(n, c, &material, control))
        }
    };
    states.kappa[i] = super::kappa(n).unwrap_or(f64::NAN);
    let ([a, d, f], status) = match critical {
        Ok(state) => {
            let all = [state.contact_radius, state.indentation, state.force];
            let first = all.iter().map(Ranged::status).find(|&status| status != Status::Ok);
            (all.map(|x| x.value(Quantity::ContactRadius).unwrap_or(f64::NAN)), first.unwrap_or(Status::Ok))
        }
        Err(Error::Domain { .. }) => ([f64::NAN; 3], Status::DomainError),
        Err(_) => ([f64::NAN; 3], Status::Undecided),
    };
    (states.contact_radius[i], states.indentation[i], states.force[i]) = (a, d, f);
    states.status[i] = status;
    tally.passed_on += 1;
    tally.without_value += usize::from(status != Status::Ok);
}
