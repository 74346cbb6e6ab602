//! Critical states under controlled indentation and controlled force: (1.14), (1.15) corrected, (1.17).

use mdr_core::contact::{Control, Error, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::contact::{PowerLawContact, ln_edge_length};
use crate::machine::CriticalRatio;
use crate::range::{ordinary, product, representable};
use crate::state::State;

impl<R: Real> PowerLawContact<R> {
    /// The critical state under the given control.
    ///
    /// | control | a | d | F |
    /// |---|---|---|---|
    /// | indentation | (B/N²)^{1/(2n−1)} | ((1−2n)/n)√(Ba) | −(2(2n+1)/(n+1))E*a√(Ba) |
    /// | force | (9B/N²)^{1/(2n−1)} | ((3−2n)/n)√(Ba) | (2(1−2n)/(n+1))E*a√(Ba) |
    ///
    /// with B = πw/(2E*), N = nκ_nC: (1.15) with its exponent corrected, and (1.17). For n > 1/2 the contact breaks
    /// there, for n < 1/2 it spreads over the whole surface. No terms cancel in these forms. On a machine it is the
    /// first fold when leaving the stable branch, see [`PowerLawContact::machine_folds`].
    ///
    /// # Errors
    /// [`Error::Domain`] at n = 1/2, where the problem has no length scale (see [`threshold`](crate::threshold()));
    /// [`Error::OutOfRange`] with the log10 of a result that the arithmetic cannot represent.
    #[inline(always)]
    pub fn critical(&self, control: &Control<R>) -> Result<State<R>> {
        match control {
            Control::Indentation => self.tangency(1),
            Control::Force => self.tangency(3),
            Control::Machine { stiffness } => {
                self.require_length_scale()?;
                self.machine_state(stiffness, &self.first_machine_tangency(stiffness)?)
            }
        }
    }

    /// ln a, ln|d| and ln|F| of the critical state, also if the quantities themselves are out of range. Not finite for
    /// d = 0 (n = 3/2 under force).
    ///
    /// # Errors
    /// [`Error::Domain`] at n = 1/2.
    pub fn ln_critical(&self, control: &Control<R>) -> Result<State<R>> {
        self.require_length_scale()?;
        let (ln_radius, critical_ratio) = match control {
            Control::Machine { stiffness } => {
                let fold = self.first_machine_tangency(stiffness)?;
                (self.ln_machine_length(stiffness) + &fold.ln_s, fold.critical_ratio)
            }
            Control::Indentation | Control::Force => {
                let limit = if matches!(control, Control::Force) { 3 } else { 1 };
                let critical_ratio = CriticalRatio::limit(limit, self.profile().exponent());
                (self.ln_length_scale(&critical_ratio.value()), critical_ratio)
            }
        };
        Ok(self.ln_state(&ln_radius, &critical_ratio))
    }

    /// The state with N a^{n−1/2} = λ√B for an integer λ.
    #[inline(always)]
    fn tangency(&self, critical_ratio: i64) -> Result<State<R>> {
        self.require_length_scale()?;
        let critical_ratio = CriticalRatio::limit(critical_ratio, self.profile().exponent());
        let radius = self.length_scale(&critical_ratio.value())?;
        self.tangent_state(radius, &critical_ratio, || self.ln_length_scale(&critical_ratio.value()))
    }

    /// (λ²B/N²)^{1/(2n−1)}, the radius at which N a^{n−1/2} = λ√B, in m.
    #[inline(always)]
    pub(crate) fn length_scale(&self, critical_ratio: &R) -> Result<R> {
        let slope = self.slope_coefficient();
        // One power of one quotient: near n = 1/2 only its rounding is magnified by 1/(2n−1).
        let (square, excess) = (slope.square(), self.profile().excess());
        let quotient = critical_ratio.square() * &self.edge_length / &square;
        let radius = if ordinary(&quotient) && ordinary(&square) && ordinary(&self.edge_length) {
            quotient.pow(&excess.inv())
        } else {
            self.distant_length_scale(critical_ratio, &slope, &excess)
        };
        representable(Quantity::ContactRadius, radius, || self.ln_length_scale(critical_ratio))
    }

    /// The [length scale](PowerLawContact::length_scale) where a square is out of range: a power of the root of the quotient, or
    /// of its two parts, or from the logarithm.
    #[cold]
    fn distant_length_scale(&self, critical_ratio: &R, slope: &R, excess: &R) -> R {
        let (edge, power) = (self.edge_root.clone() * critical_ratio, excess.lit(2) / excess);
        let root = edge.clone() / slope;
        if ordinary(&edge) && ordinary(slope) {
            if ordinary(&root) {
                return root.pow(&power);
            }
            let (edge, slope) = (edge.pow(&power), slope.pow(&power));
            if ordinary(&edge) && ordinary(&slope) {
                return edge / slope;
            }
        }
        self.ln_length_scale(critical_ratio).exp()
    }

    /// ln of [`PowerLawContact::length_scale`], with intermediate results in range.
    pub(crate) fn ln_length_scale(&self, critical_ratio: &R) -> R {
        let ln_slope = self.profile().kappa().ln() + self.profile().coefficient().ln() + self.profile().exponent().ln();
        (ln_edge_length(self.material()) + (critical_ratio.ln() - &ln_slope).times(2)) / self.profile().excess()
    }

    /// d = ((λ−2n)/n)√(Ba) and F = (2(λ−2(n+1))/(n+1)) E*a√(Ba), where g' = N aⁿ⁻¹ = λ√(B/a). `ln_radius` is evaluated
    /// only if a is out of range or subnormal, or d or F is out of range.
    #[inline(always)]
    pub(crate) fn tangent_state(
        &self,
        a: R,
        critical_ratio: &CriticalRatio<R>,
        ln_radius: impl Fn() -> R,
    ) -> Result<State<R>> {
        let (d_factor, f_factor) = self.tangent_factors(critical_ratio);
        let ln_state = || self.ln_state(&ln_radius(), critical_ratio);
        // 0 is a result if the factor is 0, and an underflow otherwise.
        let checked = |quantity, factor: &R, value: R, ln: &dyn Fn() -> R| {
            if *factor == factor.lit(0) { Ok(value) } else { representable(quantity, value, ln) }
        };
        let (indentation, force) = if ordinary(&a) {
            let (edge, root) = (&self.edge_root, a.sqrt());
            let force = product([&f_factor, self.material().effective_modulus(), edge, &root, &a]);
            (product([&d_factor, edge, &root]), force)
        } else {
            // d and F may be accurate where a is subnormal.
            let (ln, zero) = (ln_state(), a.lit(0));
            let with_sign = |factor: &R, size: R| if *factor < zero { -size } else { size };
            (with_sign(&d_factor, ln.indentation.exp()), with_sign(&f_factor, ln.force.exp()))
        };
        let indentation = checked(Quantity::Indentation, &d_factor, indentation, &|| ln_state().indentation)?;
        let force = checked(Quantity::Force, &f_factor, force, &|| ln_state().force)?;
        Ok(State { contact_radius: a, indentation, force })
    }

    /// Logarithms of a, |d| and |F| of a tangent state.
    pub(crate) fn ln_state(&self, ln_radius: &R, critical_ratio: &CriticalRatio<R>) -> State<R> {
        let (d_factor, f_factor) = self.tangent_factors(critical_ratio);
        let ln_root = (ln_edge_length(self.material()) + ln_radius).over(2);
        let ln_modulus = self.material().effective_modulus().ln();
        State {
            contact_radius: ln_radius.clone(),
            indentation: d_factor.abs().ln() + &ln_root,
            force: f_factor.abs().ln() + &ln_modulus + &ln_root + ln_radius,
        }
    }

    /// (λ−2n)/n and 2(λ−2(n+1))/(n+1).
    #[inline(always)]
    pub(crate) fn tangent_factors(&self, critical_ratio: &CriticalRatio<R>) -> (R, R) {
        let (n, excess) = (self.profile().exponent(), self.profile().excess());
        let next = n.lit(1) + n;
        (critical_ratio.less(1, &excess) / n, critical_ratio.less(3, &excess).times(2) / &next)
    }

    #[inline(always)]
    pub(crate) fn require_length_scale(&self) -> Result<()> {
        const REQUIREMENT: &str = "other than 1/2 for a critical state; there the ratio of C to a threshold decides";
        self.require(&[Regime::PullOff, Regime::CompleteContact], REQUIREMENT)
    }

    /// Refuses an exponent outside of some regimes.
    #[inline(always)]
    pub(crate) fn require(&self, regimes: &[Regime], requirement: &'static str) -> Result<()> {
        if regimes.contains(&self.regime()?) {
            return Ok(());
        }
        Err(Error::domain(Quantity::Exponent, self.profile().exponent(), requirement))
    }
}
