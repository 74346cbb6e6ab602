//! Folds of power laws on a graded half-space and on a Winkler foundation.
//!
//! With s = S/K the condition d'(K + S) = S'Δl of a machine reads N a^{n−(1−k)/2} = λ√B, λ = (1−k) + 2(1+k)s/(1+s): 1 − k
//! at fixed grips and 3 + k under a dead load. In u = ln s it is a balance μu + L − ln(1+βp) with p = s/(1+s) as on the
//! half-space (see `machine`), with μ = (2n−1+k)/(2(1+k)) and β = 2(1+k)/(1−k). Its bound on μ for three folds is
//! n < (5−k)/2 − √((1−k)(3+k)). On a Winkler foundation, k = 1 and λ = 4p: there are two folds or none for n < 2, else one.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Error, Fold, FoldKind, Quantity, Regime, Result};
use mdr_core::number::{Gamma, Real};

use super::graded::{GRADING, GradedContact, GradedHalfSpace, graded_kappa};
use crate::kappa::Kappa;
use crate::machine::Balance;
use crate::newton::{self, tolerance, undecided};
use crate::range::{ordinary, product, representable};
use crate::state::State;

/// The coefficient C at n = (1−k)/2 that separates contacts that shrink from those that spread over the whole surface, in
/// m^(1−n): √(2πw/c)/κ(n, k) at fixed grips, (3+k)/(1−k) times that under a dead load. On a machine it is that of fixed grips.
///
/// ```
/// use mdr_analytic::media::{GradedHalfSpace, graded_threshold};
/// use mdr_core::contact::Control;
/// let medium = GradedHalfSpace::new(0.0, 1.0, 0.5 / std::f64::consts::PI)?;
/// assert!((graded_threshold(&medium, &Control::Indentation)? - 0.762759763501813).abs() < 1e-15);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] for a Winkler foundation, where every power law breaks; [`Error::OutOfRange`].
pub fn graded_threshold<R: Kappa + Gamma>(medium: &GradedHalfSpace<R>, control: &Control<R>) -> Result<R> {
    let rest = medium.rest();
    if !(rest > rest.lit(0)) {
        return Err(Error::domain(GRADING, medium.grading(), "below 1 for a threshold: every power law breaks"));
    }
    let kappa = graded_kappa(&rest.clone().over(2), medium.grading())?;
    let factor = match control {
        Control::Indentation | Control::Machine { .. } => rest.lit(2),
        Control::Force => (medium.whole() + rest.lit(2)).times(2) / &rest,
    };
    let threshold = medium.edge_root() * &factor / &kappa;
    representable(Quantity::Coefficient, threshold, || medium.ln_edge().over(2) + (factor / kappa).ln())
}

impl<R: Real> GradedContact<R> {
    /// The critical state under the given control: N a^{n−(1−k)/2} = λ√B with λ = 1 − k under fixed grips, 3 + k under a dead
    /// load, and
    ///
    /// d = (λ/n − 2)√B a^{(1−k)/2},  F = 2c√B a^{(3+k)/2}(λ − 2(n+1+k))/((1+k)(n+1+k)).
    ///
    /// For n > (1−k)/2 the contact breaks there, else it spreads over the whole surface. On a machine it is the fold of the
    /// largest radius.
    ///
    /// # Errors
    /// [`Error::Domain`] at n = (1−k)/2, which has no length scale ([`graded_threshold`]), and for a Winkler foundation under
    /// fixed grips, where the contact shrinks to a point; [`Error::OutOfRange`].
    pub fn critical(&self, control: &Control<R>) -> Result<State<R>> {
        if let Some(contact) = &self.homogeneous {
            return contact.critical(control);
        }
        let rest = self.medium.rest();
        match control {
            Control::Indentation if !(rest > rest.lit(0)) => {
                let requirement = "below 1 for a fold under fixed grips: on a Winkler foundation the contact shrinks to a \
                                   point at d = -√(2πw/c)";
                Err(Error::domain(GRADING, self.medium.grading(), requirement))
            }
            Control::Indentation => self.tangency(&rest),
            Control::Force => self.tangency(&(self.medium.whole() + rest.lit(2))),
            Control::Machine { stiffness } => {
                let none = || Error::domain(Quantity::Stiffness, stiffness, "such that there is a fold");
                let Fold { contact_radius, indentation, force, .. } =
                    self.machine_folds(stiffness)?.pop().ok_or_else(none)?;
                Ok(State { contact_radius, indentation, force })
            }
        }
    }

    /// All folds on a machine of stiffness K (N/m), by increasing radius: one, or three for some machines when
    /// (1−k)/2 < n < (5−k)/2 − √((1−k)(3+k)); one or none at n = (1−k)/2; on a Winkler foundation two or none for n < 2, one
    /// for n > 2.
    ///
    /// ```
    /// use mdr_analytic::media::{GradedContact, GradedHalfSpace};
    /// let foundation = GradedHalfSpace::winkler(1.0, 0.01)?;
    /// let cone = GradedContact::new(1.0, 1.0, foundation)?;
    /// assert_eq!((cone.machine_folds(&1.0)?.len(), cone.machine_folds(&0.01)?.len()), (0, 2));
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless K is positive and finite; [`Error::Undecided`] if an interval does not decide their number;
    /// [`Error::OutOfRange`].
    pub fn machine_folds(&self, stiffness: &R) -> Result<Vec<Fold<R>>> {
        let stiffness = Error::require_positive(Quantity::Stiffness, stiffness.clone())?;
        if let Some(contact) = &self.homogeneous {
            return contact.machine_folds(&stiffness);
        }
        let roots = if self.regime()? == Regime::ScaleFree {
            self.scale_free_root()?.into_iter().map(|u| (u, FoldKind::Maximum)).collect()
        } else if self.medium.rest() > stiffness.lit(0) {
            let balance = self.balance(&stiffness);
            let root = |piece: &_| Ok((balance.root(piece)?, piece.kind));
            balance.pieces()?.iter().map(root).collect::<Result<Vec<_>>>()?
        } else {
            self.foundation(&stiffness).roots()?
        };
        let fold = |(u, kind): (R, FoldKind)| {
            let ln_radius = (u.clone() - self.ln_unit_stiffness(&stiffness)) / self.medium.whole();
            let lambda = self.medium.rest() + self.medium.whole().times(2) * Balance::share(&u);
            let state = self.tangent_state(ln_radius.exp(), &lambda, || ln_radius.clone())?;
            let State { contact_radius, indentation, force } = state;
            Ok(Fold { contact_radius, indentation, force, kind })
        };
        roots.into_iter().map(fold).collect()
    }

    /// ln 2c/((1+k)K): u = ln s is this and (1+k) ln a.
    fn ln_unit_stiffness(&self, stiffness: &R) -> R {
        (self.medium.coefficient().clone().times(2) / self.medium.whole()).ln() - stiffness.ln()
    }

    /// ln N/√B.
    fn ln_slope(&self) -> R {
        let profile = &self.profile;
        profile.kappa().ln() + profile.coefficient().ln() + profile.exponent().ln() - self.medium.ln_edge().over(2)
    }

    /// μ.
    fn steepness(&self) -> R {
        self.excess() / self.medium.whole().times(2)
    }

    fn balance(&self, stiffness: &R) -> Balance<R> {
        let (slope, rest) = (self.steepness(), self.medium.rest());
        let offset = self.ln_slope() - rest.ln() - slope.clone() * self.ln_unit_stiffness(stiffness);
        Balance { growth: self.medium.whole().times(2) / rest, slope, offset }
    }

    fn foundation(&self, stiffness: &R) -> Foundation<R> {
        let slope = self.steepness();
        let offset = self.ln_slope() - slope.lit(4).ln() - slope.clone() * self.ln_unit_stiffness(stiffness);
        Foundation { slope, offset }
    }

    /// u at n = (1−k)/2, where λ = N/√B: a maximum for 1 − k < λ < 3 + k.
    fn scale_free_root(&self) -> Result<Option<R>> {
        let lambda = self.ln_slope().exp();
        let (low, high) = (lambda.clone() - self.medium.rest(), self.medium.whole() + lambda.lit(2) - &lambda);
        let zero = lambda.lit(0);
        if low <= zero || high <= zero {
            return Ok(None);
        }
        if !(low > zero && high > zero) {
            return Err(undecided(&lambda, "whether C is between the two thresholds"));
        }
        Ok(Some((low / high).ln()))
    }

    /// The state with N a^{n−(1−k)/2} = λ√B.
    fn tangency(&self, lambda: &R) -> Result<State<R>> {
        let requirement = "other than (1 - k)/2 for a critical state; there the ratio of C to a threshold decides";
        if self.regime()? == Regime::ScaleFree {
            return Err(Error::domain(Quantity::Exponent, self.exponent(), requirement));
        }
        let ln_radius = || (lambda.ln() - self.ln_slope()).times(2) / self.excess();
        // One power of one quotient: near n = (1−k)/2 only its rounding is magnified.
        let slope = self.profile.strength() * self.exponent();
        let quotient = (self.medium.edge_root() * lambda / slope).square();
        let radius = if ordinary(&quotient) { quotient.pow(&self.excess().inv()) } else { ln_radius().exp() };
        let a = representable(Quantity::ContactRadius, radius, ln_radius)?;
        self.tangent_state(a, lambda, ln_radius)
    }

    fn tangent_state(&self, a: R, lambda: &R, ln_radius: impl Fn() -> R) -> Result<State<R>> {
        let a = representable(Quantity::ContactRadius, a, &ln_radius)?;
        let (n, sum) = (self.exponent(), self.sum());
        let depth = lambda.clone() / n - a.lit(2);
        let load = (lambda.clone() - sum.clone().times(2)) / &sum;
        let (half, stiffness) = (self.medium.elongation(&a).over(2), self.medium.stiffness(&a));
        let ln_half = || (self.medium.ln_edge() + ln_radius() * self.medium.rest()).over(2);
        let ln_stiffness = || {
            (self.medium.coefficient().clone().times(2) / self.medium.whole()).ln() + ln_radius() * self.medium.whole()
        };
        let zero = a.lit(0);
        let indentation = depth.clone() * &half;
        let indentation = if depth == zero {
            depth
        } else {
            representable(Quantity::Indentation, indentation, || depth.abs().ln() + ln_half())?
        };
        let force = if load == zero {
            load
        } else {
            let ln = || load.abs().ln() + ln_half() + ln_stiffness();
            representable(Quantity::Force, product([&load, &half, &stiffness]), ln)?
        };
        Ok(State { contact_radius: a, indentation, force })
    }
}

/// The balance on a Winkler foundation: φ(u) = μu + L − ln p with p = s/(1+s), μ = n/2.
struct Foundation<R> {
    slope: R,
    offset: R,
}

impl<R: Real> Foundation<R> {
    fn value(&self, u: &R) -> R {
        // −ln p = ln(1 + e^−u), by the exponential that does not overflow.
        let zero = u.lit(0);
        let grown = if *u < zero { u.exp().ln_1p() - u } else { (-u.clone()).exp().ln_1p() };
        u.clone() * &self.slope + &self.offset + grown
    }

    fn derivative(&self, u: &R) -> R {
        self.slope.clone() - Balance::share(&-u.clone())
    }

    /// The roots with their kinds, by increasing u. φ is convex: it is least at s = 1/μ − 1 for μ < 1, and rises for μ ≥ 1.
    fn roots(&self) -> Result<Vec<(R, FoldKind)>> {
        let (zero, one) = (self.slope.lit(0), self.slope.lit(1));
        let open = || undecided(&self.slope, "whether two folds exist or have just merged");
        match self.slope.partial_cmp(&one).ok_or_else(open)? {
            Ordering::Greater => Ok(vec![(self.root(None, true)?, FoldKind::Minimum)]),
            // φ = L + ln(1 + s), which rises from L.
            Ordering::Equal => match self.offset.partial_cmp(&zero).ok_or_else(open)? {
                Ordering::Less => Ok(vec![((-self.offset.clone()).exp_m1().ln(), FoldKind::Minimum)]),
                _ => Ok(Vec::new()),
            },
            Ordering::Less => {
                let least = (self.slope.clone().inv() - one).ln();
                match self.value(&least).partial_cmp(&zero).ok_or_else(open)? {
                    Ordering::Less => {
                        let (first, last) = (self.root(Some(&least), false)?, self.root(Some(&least), true)?);
                        Ok(vec![(first, FoldKind::Maximum), (last, FoldKind::Minimum)])
                    }
                    _ => Ok(Vec::new()),
                }
            }
        }
    }

    /// The root right (where φ rises) or left of the least value, or the only one.
    fn root(&self, least: Option<&R>, rising: bool) -> Result<R> {
        let centred = Foundation { slope: self.slope.midpoint(), offset: self.offset.midpoint() };
        let zero = self.slope.lit(0);
        let walk = |from: R, outwards: bool, positive: bool| {
            let mut step = from.lit(if outwards { 1 } else { -1 });
            for _ in 0..from.precision() + 64 {
                let next = from.clone() + &step;
                if (centred.value(&next) > zero) == positive {
                    return Ok(next);
                }
                step = step.times(2);
            }
            Err(undecided(&from, "where the fold lies"))
        };
        let (low, high) = match least.map(R::midpoint) {
            Some(least) if rising => (least.clone(), walk(least, true, true)?),
            Some(least) => (walk(least.clone(), false, true)?, least),
            None => (walk(zero.clone(), false, false)?, walk(zero.clone(), true, true)?),
        };
        let guess = newton::within(low, high, rising, |u| (centred.value(u), centred.derivative(u)));
        let residual = self.value(&guess) / self.derivative(&guess);
        let radius = residual.abs().midpoint().times(4) + tolerance(&guess).times(8);
        newton::enclosed(&guess, radius, rising, "where exactly the fold lies", |u, around| {
            let slope = self.derivative(around);
            Ok((u.clone() - self.value(u) / &slope, slope))
        })
    }
}
