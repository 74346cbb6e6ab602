//! One contact in f64 at arrays of values: all equilibria, the stable ones, and histories.
//!
//! It may be on any medium. Contact radii are half-widths of strips, and forces are per length on a half-plane and per area on a
//! periodic one; without a reference a line contact has no depth, and its column is NaN.
//!
//! Answers are columns. Where there is no state at a value its numbers are NaN and a status says why; an error concerns the
//! whole question.

mod edges;
mod equilibria;
mod held;
mod history;
mod tables;

use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use mdr_analytic::double::Inverse;
use mdr_core::contact::{
    Control, CountingTransform, Equilibrium, Error, Fold, Material, Quantity, Result, Status, Transform,
};
use mdr_core::number::Literal;
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::{self, Folds, SearchQuality};

use crate::answer::Field;
use crate::run::Stop;
use crate::scene::{ExactMedium, Profile, Scene};
use crate::solve;

pub use edges::EdgeColumns;
pub use held::EnergyBalance;
pub use history::{Event, History, LoadingPath, State};

/// States as columns of one length, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct States {
    /// a.
    pub contact_radius: Vec<f64>,
    /// d.
    pub indentation: Vec<f64>,
    /// F.
    pub force: Vec<f64>,
    /// Whether there is a state. One with the status `NotAdmissible` has numbers, but the theory does not hold for it.
    pub status: Vec<Status>,
}

/// All equilibria at some values, one branch of the curve of equilibria after the other, by increasing radius.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Equilibria {
    /// Whether the states of each branch are stable.
    pub stable: Vec<bool>,
    /// a on the first branch at every value, then on the second, and so on.
    pub contact_radius: Vec<f64>,
    /// d, in the order of `contact_radius`.
    pub indentation: Vec<f64>,
    /// F, in the order of `contact_radius`.
    pub force: Vec<f64>,
    /// Whether the surfaces of the state are proved or found to stay apart outside of the contact, in the order of
    /// `contact_radius`; false if there is no state, and if that is not decided, as for a formula that may have narrow dips.
    pub admissible: Vec<bool>,
    /// The status of each value.
    pub status: Vec<Status>,
}

/// Which of several stable equilibria is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// The one with the largest contact radius.
    Largest,
    /// The one with the smallest.
    Smallest,
}

/// A contact in f64 that answers in columns. Copies are cheap, share what has been found, and can be used from several threads.
///
/// ```
/// use mdr::columns::{Choice, ContactColumns};
/// use mdr::prelude::*;
/// let ball = Scene::new(Shape::Paraboloid { radius: "1e-6" }, Elasticity::effective("1e6")?, "0.05")?;
/// let ball = ContactColumns::new(&ball)?;
/// // The stable equilibria under three dead loads; the first pulls harder than −3/2 πwR.
/// let states = ball.states(&Control::Force, &[-3e-7, -2e-7, 0.0], Choice::Largest)?;
/// assert_eq!(states.status, [Status::NoEquilibrium, Status::Ok, Status::Ok]);
/// assert!(states.contact_radius[0].is_nan() && states.contact_radius[1] < states.contact_radius[2]);
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone)]
pub struct ContactColumns {
    parts: Arc<Parts>,
    stop: Stop,
}

/// The contact, and what has been found of it.
struct Parts {
    /// Its control is not used.
    contact: contact::Contact<f64>,
    profile: Profile,
    medium: ExactMedium,
    /// n and C of a power law on a half-space.
    law: Option<[f64; 2]>,
    /// Its closed forms under fixed grips and under a dead load, once they have been needed.
    inverses: [OnceLock<Inverse>; 2],
    /// The results of the search under the last control: a search takes longer than many equilibria.
    known: Mutex<Option<Arc<Known>>>,
}

/// The results of the search for a contact under one control.
struct Known {
    control: Control<f64>,
    folds: Folds<f64>,
    /// Once it has been needed.
    admissibility: OnceLock<Arc<Admissibility>>,
}

impl ContactColumns {
    /// The contact of a scene; the outputs and the control of the scene are not used.
    ///
    /// # Errors
    /// A number that no double holds; a parameter out of its domain.
    pub fn new(scene: &Scene) -> crate::Result<Self> {
        scene.places.require_doubles("ask for certified digits")?;
        if scene.has_two_works() {
            let why = "states in columns are those of one work of adhesion: give the one of the edge that is meant, or ask \
                       EdgeColumns for a history between the two";
            return Err(scene.places.of("material.work_of_adhesion").refuse(why));
        }
        scene.check_profile_on_medium()?;
        Ok(Self::assembled(scene, scene.assembled::<f64>(())?))
    }

    /// From the contact of a scene.
    fn assembled(scene: &Scene, contact: contact::Contact<f64>) -> Self {
        let contact = contact.with_control(Control::Indentation);
        let law = scene.profile.power_law(Literal::nearest_f64, |radius| 0.5 / radius);
        let parts = Parts {
            law: law.filter(|_| scene.medium.is_half_space()),
            contact,
            profile: scene.profile.clone(),
            medium: scene.medium.clone(),
            inverses: Default::default(),
            known: Mutex::default(),
        };
        ContactColumns { parts: Arc::new(parts), stop: Stop::default() }
    }

    /// This contact, with questions that end when they are stopped, from any thread, with [`Error::Stopped`].
    ///
    /// ```
    /// use mdr::columns::{Choice, ContactColumns};
    /// use mdr::prelude::*;
    /// let scene = Scene::new(Shape::Cone { flank: Flank::Slope("0.1") }, Elasticity::effective("1e6")?, "0.05")?;
    /// let (cone, stop) = (ContactColumns::new(&scene)?, Stop::default());
    /// let stoppable = cone.until(&stop);
    /// stop.stop();
    /// assert_eq!(stoppable.curve(&[1e-3]), Err(mdr::ContactError::Stopped));
    /// assert!(cone.curve(&[1e-3]).is_ok());
    /// # Ok::<(), mdr::Error>(())
    /// ```
    #[must_use]
    pub fn until(&self, stop: &Stop) -> Self {
        ContactColumns { parts: Arc::clone(&self.parts), stop: stop.clone() }
    }

    /// Whether states under a control are in closed form, or what a search has found is at hand: then one more takes microseconds.
    pub fn is_prepared(&self, control: &Control<f64>) -> bool {
        let is_known = |known: &Arc<Known>| known.control == *control && known.admissibility.get().is_some();
        matches!(self.inverse(control), Ok(Some(_))) || self.last_known().as_ref().is_some_and(is_known)
    }

    /// g, g' and ∫₀ˣ g at radii, in this order; NaN outside of the profile.
    ///
    /// # Errors
    /// A quadrature that does not converge; [`Error::Stopped`].
    pub fn transform(&self, radii: &[f64]) -> Result<[Vec<f64>; 3]> {
        let counted = self.counted(&Control::Indentation);
        let at = |part: fn(&dyn Transform<f64>, &f64) -> Result<f64>| {
            radii
                .iter()
                .map(|x| within(self.size(*x).and_then(|x| part(counted.transform(), &x))))
                .collect::<Result<Vec<_>>>()
        };
        Ok([at(|t, x| t.g(x))?, at(|t, x| t.slope(x))?, at(|t, x| t.integral(x))?])
    }

    /// The equilibrium with each contact radius, stable or not; `DomainError` outside of the profile.
    ///
    /// # Errors
    /// A quadrature that does not converge; [`Error::Stopped`].
    pub fn curve(&self, radii: &[f64]) -> Result<States> {
        let curve = self.counted(&Control::Indentation);
        let mut states = States::with_capacity(radii.len());
        for a in radii {
            match self.size_of_contact(*a).and_then(|a| curve.state(&a)) {
                Ok((d, force)) => states.push([*a, self.depth(d), force], Status::Ok),
                Err(error) => states.push([f64::NAN; 3], status_of(error)?),
            }
        }
        Ok(states)
    }

    /// A field of the equilibrium with a contact radius, at radii: the pressure within the contact, in Pa, or the gap or the
    /// displacement of the surface outside of it, in m. NaN where it is not defined or infinite.
    ///
    /// # Errors
    /// A contact radius that is not positive, or outside of the profile; a quadrature that does not converge; [`Error::Stopped`].
    pub fn field(&self, field: Field, contact_radius: f64, radii: &[f64]) -> Result<Vec<f64>> {
        let size = self.size_of_contact(contact_radius)?;
        let fields = Fields::new(self.counted(&Control::Indentation), size)?;
        let at = |r: &f64| match field {
            Field::Pressure => fields.pressure(r),
            Field::Gap => fields.gap(r),
            Field::Displacement => fields.displacement(r),
        };
        radii.iter().map(|r| within(at(r))).collect()
    }

    /// All folds, by increasing radius.
    ///
    /// # Errors
    /// A stiffness that is not positive; a quadrature that does not converge; a fold beyond the range of f64; [`Error::Stopped`].
    pub fn folds(&self, control: &Control<f64>) -> Result<Vec<Fold<f64>>> {
        self.branched(control, false, |branches| {
            let finite = branches.folds().iter().filter(|fold| fold.indentation.is_finite()).cloned();
            Ok(finite.map(|fold| self.shown(fold)).collect())
        })
    }

    /// A state by its contact radius, and without a depth where the medium has none.
    fn shown_state(&self, state: Equilibrium<f64>) -> Equilibrium<f64> {
        Equilibrium {
            contact_radius: self.parts.contact.medium().contact_radius(&state.contact_radius),
            indentation: self.depth(state.indentation),
            ..state
        }
    }

    /// A fold by its contact radius, and without a depth where the medium has none.
    fn shown(&self, fold: Fold<f64>) -> Fold<f64> {
        Fold {
            contact_radius: self.parts.contact.medium().contact_radius(&fold.contact_radius),
            indentation: self.depth(fold.indentation),
            ..fold
        }
    }

    /// a, d and F of a state that was found at a value; the controlled quantity has that value.
    fn numbers(&self, state: &Equilibrium<f64>, control: &Control<f64>, value: f64) -> [f64; 3] {
        let state = self.shown_state(state.clone().controlled(control, value));
        [state.contact_radius, state.indentation, state.force]
    }

    /// A depth; NaN on a medium that has none.
    fn depth(&self, indentation: f64) -> f64 {
        if self.parts.contact.medium().has_depth() { indentation } else { f64::NAN }
    }

    /// The size of a contact with this contact radius; see [`contact::Contact`].
    fn size_of_contact(&self, contact_radius: f64) -> Result<f64> {
        self.size(Error::require_positive(Quantity::ContactRadius, contact_radius)?)
    }

    /// The size of a contact with a contact radius or half-width that is not negative.
    fn size(&self, contact_radius: f64) -> Result<f64> {
        self.parts.contact.medium().size_within(&contact_radius)
    }

    /// Refuses a control by depths on a medium that has none.
    fn check(&self, control: &Control<f64>) -> Result<()> {
        control.check()?;
        if *control == Control::Force || self.parts.contact.medium().has_depth() {
            return Ok(());
        }
        Err(Error::Domain {
            quantity: Quantity::Indentation,
            value: "that of a line contact without a reference".to_owned(),
            requirement: "measured against a point of the surface, reference = its distance; or control the force per length",
        })
    }

    /// The contact under a control, with its evaluations counted.
    fn counted(&self, control: &Control<f64>) -> contact::Contact<f64> {
        let counted = CountingTransform::sharing(Arc::clone(self.parts.contact.shared_transform()), &self.stop.tally());
        self.parts.contact.with_transform(Arc::new(counted)).with_control(control.clone())
    }

    /// The result of `ask` on the branches under a control, with the admissibility of their states if `judged`.
    fn branched<T>(
        &self,
        control: &Control<f64>,
        judged: bool,
        ask: impl FnOnce(&SearchedBranches<f64>) -> Result<T>,
    ) -> Result<T> {
        self.check(control)?;
        let curve = self.counted(control);
        let last = self.last_known().clone().filter(|last| last.control == *control);
        let known = match last {
            Some(known) => known,
            None => {
                let folds = folds::find(&curve)?;
                Arc::new(Known { control: control.clone(), folds, admissibility: OnceLock::new() })
            }
        };
        *self.last_known() = Some(Arc::clone(&known));
        if let Some(fold) = known.folds.out_of_range.first() {
            return Err(fold.error.clone());
        }
        let branches = SearchedBranches::cut_at(curve, known.folds.clone());
        if !judged {
            return ask(&branches);
        }
        let search = || {
            let radii: Vec<f64> = branches.folds().iter().map(|fold| fold.contact_radius).collect();
            let length = branches.curve().material_length();
            let transform = Arc::clone(self.parts.contact.shared_transform());
            Arc::new(solve::on_medium(&self.parts.profile, &self.parts.medium, transform, length, &radii))
        };
        let admissibility = Arc::clone(known.admissibility.get_or_init(search));
        ask(&branches.with_admissibility(admissibility)).map_err(|error| match error {
            Error::NoEquilibrium { quantity, .. } if known.folds.completeness == SearchQuality::Doubtful => {
                solve::unresolved(quantity)
            }
            error => error,
        })
    }

    /// The results of the last search. A thread that panicked has left them whole: they are replaced at once.
    fn last_known(&self) -> MutexGuard<'_, Option<Arc<Known>>> {
        self.parts.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Closed forms for many values at once, where there are such: of a power law under fixed grips or a dead load.
    fn inverse(&self, control: &Control<f64>) -> Result<Option<&Inverse>> {
        let Some([n, c]) = self.parts.law.filter(|[n, _]| *n != 0.5) else { return Ok(None) };
        let known = match control {
            Control::Indentation => &self.parts.inverses[0],
            Control::Force => &self.parts.inverses[1],
            Control::Machine { .. } => return Ok(None),
        };
        if let Some(inverse) = known.get() {
            return Ok(Some(inverse));
        }
        let material = Material::new(*self.parts.contact.modulus(), *self.parts.contact.adhesion().work())?;
        let inverse = Inverse::new(n, c, &material, control)?;
        Ok(Some(known.get_or_init(|| inverse)))
    }
}

impl States {
    fn with_capacity(len: usize) -> Self {
        let [contact_radius, indentation, force] = [(); 3].map(|()| Vec::with_capacity(len));
        States { contact_radius, indentation, force, status: Vec::with_capacity(len) }
    }

    /// So many states, to be overwritten.
    fn resize(&mut self, len: usize) {
        for column in [&mut self.contact_radius, &mut self.indentation, &mut self.force] {
            column.resize(len, f64::NAN);
        }
        self.status.resize(len, Status::Undecided);
    }

    fn clear(&mut self) {
        self.resize(0);
    }

    /// Appends the rows of others.
    fn extend(&mut self, others: &States) {
        self.contact_radius.extend_from_slice(&others.contact_radius);
        self.indentation.extend_from_slice(&others.indentation);
        self.force.extend_from_slice(&others.force);
        self.status.extend_from_slice(&others.status);
    }

    fn push(&mut self, [contact_radius, indentation, force]: [f64; 3], status: Status) {
        self.contact_radius.push(contact_radius);
        self.indentation.push(indentation);
        self.force.push(force);
        self.status.push(status);
    }
}

/// NaN outside of the domain.
fn within(value: Result<f64>) -> Result<f64> {
    match value {
        Err(Error::Domain { .. }) => Ok(f64::NAN),
        value => value,
    }
}

/// The status of an error at one value, for a column of statuses.
///
/// # Errors
/// The error, where it concerns the whole question.
fn status_of(error: Error) -> Result<Status> {
    match error {
        Error::Domain { .. } => Ok(Status::DomainError),
        Error::OutOfRange { log10, .. } => Ok(if log10 > 0.0 { Status::Overflow } else { Status::Underflow }),
        Error::NoConvergence { .. } | Error::Undecided { .. } | Error::BudgetSpent { .. } => Ok(Status::Undecided),
        error => Err(error),
    }
}
