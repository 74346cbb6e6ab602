//! Equilibria at many values of the controlled quantity.

use std::cmp::Ordering;

use mdr_analytic::double::{BranchSlices, Inverse, InverseBatch as Rows};
use mdr_core::contact::{Control, Equilibrium, Error, Quantity, Result, Stability, Status};
use mdr_numeric::admissible::{Basis, GapVerdict};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::SearchQuality;
#[cfg(doc)]
use mdr_numeric::tabulated::TabulatedBranch;

use super::tables::{Found, Tables};
use super::{Choice, ContactColumns, Equilibria, States, status_of};

impl ContactColumns {
    /// All equilibria at each value of the controlled quantity.
    ///
    /// At a fold both branches that end there hold the double root, and the status is `Fold`.
    ///
    /// # Errors
    /// A stiffness that is not positive; errors of the transform; a fold beyond the range of f64;
    /// [`Stopped`](crate::ContactError::Stopped).
    pub fn equilibria(&self, control: &Control<f64>, values: &[f64]) -> Result<Equilibria> {
        if let Some(inverse) = self.inverse(control)? {
            return by_closed_form(inverse, self.has_large_branch(), control, values);
        }
        self.branched(control, true, |branches| self.searched(branches, values))
    }

    /// All equilibria at one value by increasing radius, admissible or not, by search along every branch: as a scene in f64 is
    /// answered, and without the code of the closed forms, which a web page need not load.
    ///
    /// # Errors
    /// A value out of its domain; a stiffness that is not positive; errors of the transform; a fold beyond the range of f64;
    /// [`Stopped`](crate::ContactError::Stopped).
    pub fn equilibria_at(&self, control: &Control<f64>, value: f64) -> Result<Vec<Equilibrium<f64>>> {
        self.branched(control, false, |branches| {
            let found = branches.equilibria(&value)?.into_iter();
            Ok(found.map(|state| self.shown_state(state)).collect())
        })
    }

    /// The stable equilibrium at each value of the controlled quantity, independent of the other values.
    ///
    /// For a thousand values and more the stable branches are [tabulated](TabulatedBranch) where that takes fewer evaluations than
    /// the searches: the states are those of a search up to the rounding of g and Δl, to 4 ulp of them.
    ///
    /// # Errors
    /// A stiffness that is not positive; errors of the transform; a fold beyond the range of f64;
    /// [`Stopped`](crate::ContactError::Stopped).
    pub fn states(&self, control: &Control<f64>, values: &[f64], choice: Choice) -> Result<States> {
        let mut states = States::with_capacity(values.len());
        self.states_by_blocks(control, values, choice, |block| states.extend(block))?;
        Ok(states)
    }

    /// The states that [`ContactColumns::states`] finds, one block after the other, for columns that are kept elsewhere.
    ///
    /// # Errors
    /// Errors of [`ContactColumns::states`], after which there are no more blocks.
    pub fn states_by_blocks(
        &self,
        control: &Control<f64>,
        values: &[f64],
        choice: Choice,
        take: impl FnMut(&States),
    ) -> Result<()> {
        if let Some(inverse) = self.inverse(control)? {
            return stable_by_closed_form(inverse, control, values, take);
        }
        self.branched(control, true, |branches| self.stable_by_search(branches, values, choice, take))
    }

    /// The stable states by tables of the branches, or by search on each.
    fn stable_by_search(
        &self,
        branches: &SearchedBranches<f64>,
        values: &[f64],
        choice: Choice,
        mut take: impl FnMut(&States),
    ) -> Result<()> {
        let mut order: Vec<usize> = (0..=branches.folds().len()).collect();
        order.retain(|branch| branches.is_stable(*branch) != Some(false));
        if choice == Choice::Largest {
            order.reverse();
        }
        let tables = Tables::new(branches, values);
        let mut states = States::with_capacity(values.len().min(BLOCK));
        for block in values.chunks(BLOCK) {
            states.clear();
            let mut enter = |value: f64, tabulated: Found| {
                let found = match tabulated {
                    Found::State(state, status) => Ok(Some((state, status))),
                    Found::Nothing => Ok(None),
                    Found::Open => stable(branches, &order, &value),
                };
                let (numbers, status) = match found {
                    Ok(Some((state, status))) => (self.numbers(&state, branches.control(), value), status),
                    Ok(None) => ([f64::NAN; 3], nothing(branches)),
                    Err(error) => ([f64::NAN; 3], status_of(error)?),
                };
                states.push(numbers, status);
                Ok(())
            };
            match &tables {
                Some(tables) => tables.first_of_each(&order, block, enter)?,
                None => block.iter().try_for_each(|value| enter(*value, Found::Open))?,
            }
            take(&states);
        }
        Ok(())
    }

    /// All equilibria by search on each branch.
    fn searched(&self, branches: &SearchedBranches<f64>, values: &[f64]) -> Result<Equilibria> {
        let (len, control) = (values.len(), branches.control());
        let count = branches.folds().len() + 1;
        let mut stable: Vec<Option<bool>> = (0..count).map(|branch| branches.is_stable(branch)).collect();
        let [mut contact_radius, mut indentation, mut force] = [(); 3].map(|()| vec![f64::NAN; count * len]);
        let mut admissible = vec![false; count * len];
        let mut statuses = Vec::with_capacity(len);
        let admissibility = branches.admissibility();
        let decided = admissibility.is_known() && !matches!(admissibility.basis(), Basis::Unproved { .. });
        for (i, value) in values.iter().enumerate() {
            let mut enter = |branch: usize, state: &Equilibrium<f64>, status: Status| {
                let known = *stable[branch].get_or_insert(state.stability == Stability::Stable);
                if known == (state.stability == Stability::Unstable) {
                    let what = "on which branch a state is: folds are missing";
                    return Err(Error::undecided(Quantity::ContactRadius, value, what));
                }
                let at = branch * len + i;
                [contact_radius[at], indentation[at], force[at]] = self.numbers(state, control, *value);
                admissible[at] = decided && status != Status::NotAdmissible;
                Ok(())
            };
            let found = control.check_value(value).and_then(|()| {
                let mut whole = None;
                for branch in 0..count {
                    if let Some((state, status)) = on_branch(branches, branch, value)? {
                        enter(branch, &state, status)?;
                        whole = Some(if status == Status::Fold { status } else { whole.unwrap_or(Status::Ok) });
                    }
                }
                Ok(whole.unwrap_or_else(|| nothing(branches)))
            });
            if found.is_err() {
                for at in (i..count * len).step_by(len) {
                    [contact_radius[at], indentation[at], force[at]] = [f64::NAN; 3];
                    admissible[at] = false;
                }
            }
            statuses.push(found.or_else(status_of)?);
        }
        let stable = stable.into_iter().map(|known| known.unwrap_or(false)).collect();
        Ok(Equilibria { stable, contact_radius, indentation, force, admissible, status: statuses })
    }

    /// Whether the branch with the larger radii is the stable one of a power law: n > 1/2.
    fn has_large_branch(&self) -> bool {
        self.parts.law.is_some_and(|[n, _]| n > 0.5)
    }
}

/// The state of a branch at a value: an equilibrium on it, or the fold at one of its ends.
fn on_branch(
    branches: &SearchedBranches<f64>,
    branch: usize,
    value: &f64,
) -> Result<Option<(Equilibrium<f64>, Status)>> {
    if let Some(state) = branches.on_branch(branch, value)? {
        let status = match branches.admissibility().of(state.contact_radius, state.indentation) {
            GapVerdict::Interpenetrating { .. } => Status::NotAdmissible,
            _ => Status::Ok,
        };
        return Ok(Some((state, status)));
    }
    let ends = [branch.checked_sub(1), Some(branch)];
    for fold in ends.into_iter().flatten().filter_map(|index| branches.folds().get(index)) {
        if branches.compare(value, fold)? == Ordering::Equal {
            return Ok(Some((fold.clone().into(), Status::Fold)));
        }
    }
    Ok(None)
}

/// The first state that is not unstable on the branches in their order.
fn stable(
    branches: &SearchedBranches<f64>,
    order: &[usize],
    value: &f64,
) -> Result<Option<(Equilibrium<f64>, Status)>> {
    branches.control().check_value(value)?;
    for branch in order {
        let found = on_branch(branches, *branch, value)?;
        if found.as_ref().is_some_and(|(state, _)| state.stability != Stability::Unstable) {
            return Ok(found);
        }
    }
    Ok(None)
}

/// The status of a value without a state.
fn nothing(branches: &SearchedBranches<f64>) -> Status {
    match branches.completeness() {
        SearchQuality::Doubtful => Status::Undecided,
        _ => Status::NoEquilibrium,
    }
}

/// Values at a time, so that their intermediate results stay within the cache.
const BLOCK: usize = 1024;

/// Both branches of a power law, whose states are all admissible.
fn by_closed_form(inverse: &Inverse, large: bool, control: &Control<f64>, values: &[f64]) -> Result<Equilibria> {
    let len = values.len();
    let [mut contact_radius, mut uncontrolled, mut held] = [(); 3].map(|()| vec![0.0; 2 * len]);
    let mut admissible = vec![false; 2 * len];
    let mut status = vec![Status::Ok; len];
    for (index, block) in values.chunks(BLOCK).enumerate() {
        let rows = index * BLOCK..index * BLOCK + block.len();
        let (a0, a1) = contact_radius.split_at_mut(len);
        let (x0, x1) = uncontrolled.split_at_mut(len);
        let smaller = BranchSlices { contact_radius: &mut a0[rows.clone()], uncontrolled: &mut x0[rows.clone()] };
        let larger = BranchSlices { contact_radius: &mut a1[rows.clone()], uncontrolled: &mut x1[rows.clone()] };
        inverse.branches(block, &mut Rows { smaller, larger, status: &mut status[rows.clone()] })?;
        for branch in [rows.clone(), rows.start + len..rows.end + len] {
            let states = block.iter().zip(&contact_radius[branch.clone()]);
            let filled = held[branch.clone()].iter_mut().zip(&mut admissible[branch]);
            for ((value, a), (held, admissible)) in states.zip(filled) {
                (*held, *admissible) = (where_known(*value, *a), !a.is_nan());
            }
        }
    }
    let (indentation, force) = if *control == Control::Force { (uncontrolled, held) } else { (held, uncontrolled) };
    Ok(Equilibria { stable: vec![!large, large], contact_radius, indentation, force, admissible, status })
}

/// The stable branch of a power law alone.
fn stable_by_closed_form(
    inverse: &Inverse,
    control: &Control<f64>,
    values: &[f64],
    mut take: impl FnMut(&States),
) -> Result<()> {
    let mut states = States::default();
    for block in values.chunks(BLOCK) {
        states.resize(block.len());
        let States { contact_radius, indentation, force, status } = &mut states;
        let (held, uncontrolled) = if *control == Control::Force { (force, indentation) } else { (indentation, force) };
        inverse.stable(block, &mut BranchSlices { contact_radius, uncontrolled }, status)?;
        for ((held, value), a) in held.iter_mut().zip(block).zip(contact_radius.iter()) {
            *held = where_known(*value, *a);
        }
        take(&states);
    }
    Ok(())
}

/// The value that is held, unless there is no state.
fn where_known(value: f64, a: f64) -> f64 {
    if a.is_nan() { f64::NAN } else { value }
}
