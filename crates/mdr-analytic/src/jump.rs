//! Energy dissipated in jumps under controlled indentation, in J.

use mdr_core::contact::{Error, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::contact::PowerLawContact;
use crate::range::{product, representable};

impl<R: Real> PowerLawContact<R> {
    /// a₀, the equilibrium radius at d = 0: (2πw/(E*κ²C²))^{1/(2n−1)}. Stable for n > 1/2, unstable for n < 1/2.
    ///
    /// # Errors
    /// [`Error::Domain`] at n = 1/2; [`Error::OutOfRange`].
    pub fn radius_at_zero_indentation(&self) -> Result<R> {
        self.require_length_scale()?;
        // d = ((λ−2n)/n)√(Ba) vanishes for λ = 2n.
        self.length_scale(&self.profile().exponent().clone().times(2))
    }

    /// The energy dissipated when the contact breaks under fixed grips: n(2n−1)/((n+1)(2n+1)) · πa_c²w. Paraboloid:
    /// 2/5.
    ///
    /// # Errors
    /// [`Error::Domain`] for n ≤ 1/2: the jump to complete contact has no final state on an infinite surface;
    /// [`Error::OutOfRange`].
    pub fn energy_lost_at_pull_off(&self) -> Result<R> {
        self.require(&[Regime::PullOff], "above 1/2 for a contact that breaks")?;
        let n = self.profile().exponent();
        let next = n.lit(1) + n;
        self.released_work(&n.lit(1), &(n.clone() / next))
    }

    /// The energy dissipated when approaching surfaces jump into contact at d = 0: (2n−1)/(2n+1) · πa₀²w. Paraboloid:
    /// 3/5.
    ///
    /// # Errors
    /// [`Error::Domain`] for n ≤ 1/2: a point contact does not grow spontaneously; [`Error::OutOfRange`].
    pub fn energy_lost_at_jump_in(&self) -> Result<R> {
        self.require(&[Regime::PullOff], "above 1/2 for a contact that jumps in")?;
        let n = self.profile().exponent();
        self.released_work(&n.clone().times(2), &n.lit(1))
    }

    /// The energy barrier between no contact and complete contact at d = 0 for n < 1/2: (1−2n)/(1+2n) · πa₀²w, the
    /// energy of the unstable equilibrium.
    ///
    /// # Errors
    /// [`Error::Domain`] for n ≥ 1/2: there is none; [`Error::OutOfRange`].
    pub fn barrier_to_complete_contact(&self) -> Result<R> {
        self.require(&[Regime::CompleteContact], "below 1/2 for a barrier before complete contact")?;
        let n = self.profile().exponent();
        self.released_work(&n.clone().times(2), &n.lit(-1))
    }

    /// (2n−1)/(2n+1) · πa²w · factor at the radius where N a^{n−1/2} = λ√B.
    fn released_work(&self, critical_ratio: &R, factor: &R) -> Result<R> {
        let excess = self.profile().excess();
        let work = self.material().work_of_adhesion();
        let share = excess.clone() / (excess.clone() + excess.lit(2)) * excess.pi() * factor;
        let ln = || share.abs().ln() + self.ln_length_scale(critical_ratio).times(2) + work.ln();
        match self.length_scale(critical_ratio) {
            Ok(a) => representable(Quantity::Energy, product([&share, &a, &a, work]), ln),
            Err(Error::OutOfRange { .. }) => representable(Quantity::Energy, ln().exp(), ln),
            Err(error) => Err(error),
        }
    }
}
