//! Energy dissipated in the jumps of the wave of Johnson (1995), per area over p*h₀.

use mdr_core::contact::{Error, FoldKind, Quantity, Result};
use mdr_core::number::Special;

use super::wave::{JohnsonWave, WaveState, log_tail};
use super::wave_folds::{WaveControl, WaveFold};

const ALPHA: Quantity = Quantity::Parameter("α of the wave");

impl<R: Special> JohnsonWave<R> {
    /// The energy of the contact and of the spring over p*h₀, Π + κP²/2; under a dead load of P = 0 the energy itself.
    fn stored(&self, state: &WaveState<R>, control: &WaveControl<R>) -> R {
        match control {
            WaveControl::Load => state.load_potential(),
            WaveControl::Approach { compliance } => state.energy() + (state.pressure.square() * compliance).over(2),
        }
    }

    /// The energy lost when surfaces touch at P = 0 (load) or D = 0 (approach) and jump into contact.
    ///
    /// # Errors
    /// [`Error::Domain`] where they jump to complete contact; [`Error::Undecided`].
    pub fn energy_lost_at_touch(&self, control: &WaveControl<R>) -> Result<R> {
        let none =
            || Error::domain(ALPHA, &self.alpha, "such that surfaces that touch do not jump to complete contact");
        Ok(-self.stored(&self.touching(control)?.ok_or_else(none)?, control))
    }

    /// The energy lost when the contact breaks, with the approach controlled through a compliance κ ≥ 0.
    ///
    /// # Errors
    /// [`Error::Domain`] without a fold, or unless κ ≥ 0 is finite; [`Error::Undecided`].
    pub fn energy_lost_at_pull_off(&self, compliance: &R) -> Result<R> {
        let control = WaveControl::Approach { compliance: compliance.clone() };
        Ok(self.stored(&self.fold(&control, FoldKind::Minimum)?.state, &control))
    }

    /// The energy lost in the jump to complete contact under a dead load. With ε = cos²ψ at the fold it is
    /// ε³(−10 + 47ε/4 + 2ε² − 4ε³) − ½P² Σ_{j≥3} εʲ/j + α² arccot t: the difference of the potentials without its terms below ε³, which cancel.
    ///
    /// # Errors
    /// [`Error::Domain`] without a fold, α ≥ α₁; [`Error::Undecided`].
    pub fn energy_lost_at_complete_contact(&self) -> Result<R> {
        let state = self.fold(&WaveControl::Load, FoldKind::Maximum)?.state;
        let e = &state.rest;
        let quartic = e.ratio(47, 4) + (e.lit(2) - e.clone().times(4)) * e;
        let polynomial = e.powi(3) * (quartic * e - e.lit(10));
        let tail = (state.pressure.square() * log_tail(e, 3)).over(2);
        Ok(polynomial - tail + self.alpha.square() * state.tangent.clone().inv().atan())
    }

    fn fold(&self, control: &WaveControl<R>, kind: FoldKind) -> Result<WaveFold<R>> {
        let none = || Error::domain(ALPHA, &self.alpha, "below the threshold at which the folds merge");
        self.folds(control)?.into_iter().find(|fold| fold.kind == kind).ok_or_else(none)
    }
}
