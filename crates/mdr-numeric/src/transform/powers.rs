//! Sums of powers, whose transform on a medium is again a sum of powers.

use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::{Gamma, Real};

/// The transform of a profile f = Σ C rⁿ on a medium: g = Σ G xⁿ, with means G·m·xⁿ.
///
/// ```
/// use mdr_core::contact::Transform;
/// use mdr_numeric::transform::Powers;
/// // A paraboloid of radius 1 on a graded half-space, k = 0.3, and on a Winkler foundation, where g = f.
/// let graded = Powers::graded([(2.0, 0.5)], &0.3)?;
/// assert!((graded.g(&1.0)? - 1.0 / 1.3).abs() < 1e-14); // x²/(R(1 + k))
/// assert_eq!(Powers::winkler([(2.0, 0.5)])?.g(&1.0)?, 0.5);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Powers<R> {
    terms: Vec<Term<R>>,
}

/// One power.
#[derive(Clone, Debug)]
struct Term<R> {
    /// n.
    exponent: R,
    /// G of g = G xⁿ.
    factor: R,
    /// The mean of g over g.
    mean: R,
}

/// κ(n, k) = Γ(1 + n/2)Γ((1 + k)/2)/Γ((n + 1 + k)/2): the factor between C rⁿ and its transform on a medium graded as zᵏ.
///
/// ```
/// use mdr_numeric::transform::graded_kappa;
/// assert!((graded_kappa(&2.0, &0.0) - 2.0).abs() < 1e-14); // the half-space: g = x²/R of x²/2R
/// assert!((graded_kappa(&2.0, &1.0) - 1.0).abs() < 1e-14); // the Winkler foundation: g = f
/// ```
pub fn graded_kappa<R: Gamma>(n: &R, k: &R) -> R {
    let half = |x: R| x.over(2);
    let (one, sum) = (n.lit(1), n.clone() + k + n.lit(1));
    let [top, grade, bottom] = [half(n.clone()) + &one, half(one + k), half(sum)];
    let quotient = top.gamma() / bottom.gamma();
    if quotient.is_finite() && quotient > quotient.lit(0) {
        return quotient * grade.gamma();
    }
    (top.ln_gamma() - bottom.ln_gamma()).exp() * grade.gamma()
}

/// c_n = (√π/2) n Γ((n + 1)/2)/Γ(1 + n/2): the factor between C xⁿ and N of a line contact.
///
/// ```
/// use mdr_numeric::transform::line_factor;
/// assert!((line_factor(&2.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-14); // N = πb²/4R of x²/2R
/// ```
pub fn line_factor<R: Gamma>(n: &R) -> R {
    n.pi() * n / graded_kappa(n, &n.lit(0)).times(2)
}

impl<R: Real> Powers<R> {
    /// From exponents n, with G and the mean of g over g of each.
    ///
    /// # Errors
    /// [`Error::Domain`] unless every exponent is positive and every number finite.
    pub fn new(terms: impl IntoIterator<Item = [R; 3]>) -> Result<Self> {
        let term = |[exponent, factor, mean]: [R; 3]| {
            Error::require_finite(Quantity::Coefficient, &factor)?;
            Ok(Term { exponent: Error::require_positive(Quantity::Exponent, exponent)?, factor, mean })
        };
        Ok(Powers { terms: terms.into_iter().map(term).collect::<Result<_>>()? })
    }

    /// Of pairs (n, C) on a Winkler foundation: g = f, with the mean 2f/(n + 2).
    ///
    /// # Errors
    /// [`Error::Domain`] unless every n is positive and every C finite.
    pub fn winkler(terms: impl IntoIterator<Item = (R, R)>) -> Result<Self> {
        Self::new(terms.into_iter().map(|(n, c)| {
            let mean = n.lit(2) / (n.clone() + n.lit(2));
            [n, c, mean]
        }))
    }

    /// Whether every term has a positive factor.
    fn all_rise(&self) -> bool {
        self.terms.iter().all(|term| term.factor >= term.factor.lit(0))
    }

    /// Σ factor(term) x^(n − lower).
    fn sum(&self, x: &R, lower: i64, mut factor: impl FnMut(&Term<R>) -> R) -> Result<R> {
        let x = Error::require_positive(Quantity::Radius, x.clone())?;
        let mut sum = x.lit(0);
        for term in &self.terms {
            let power = x.pow(&(term.exponent.clone() - x.lit(lower)));
            let value = factor(term) * power;
            let lost = value == x.lit(0) && term.factor != x.lit(0);
            if lost || !value.is_finite() {
                let log = x.ln() * (term.exponent.clone() - x.lit(lower)) + term.factor.abs().ln();
                let log10 = log.approx() / std::f64::consts::LN_10;
                return Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 });
            }
            sum += &value;
        }
        Ok(sum)
    }

    /// ∫₀ᵇ N(c)/(c√(1 − c²/L²)) dc, with c = L sinφ that of G Lⁿ sinⁿ⁻¹φ dφ: by powers of b/L, and beyond L/√2
    /// of the distance from L. Not finite over an enclosure of b that is too wide for either.
    pub(super) fn against_reference(&self, b: &R, reference: &R) -> Result<R> {
        let share = (b.clone() / reference).square();
        let room = (reference.clone() - b) / reference * ((reference.clone() + b) / reference);
        let near = share.midpoint() <= share.ratio(1, 2);
        let shares = self.terms.iter().map(|term| if near { term.near(&share) } else { term.far(&share, &room) });
        let shares: Vec<R> = shares.collect();
        if !shares.iter().all(R::is_finite) {
            return Ok(share.lit(1).over(0));
        }
        let mut shares = shares.into_iter();
        self.sum(b, 0, |term| shares.next().map_or_else(|| share.lit(0), |share| term.factor.clone() * share))
    }
}

impl<R: Real> Term<R> {
    /// Σ_j (2j choose j)/4ʲ sʲ/(n + 2j) at s = b²/L², all terms of one sign. The ratio of consecutive terms is below s, which bounds
    /// the remainder.
    fn near(&self, share: &R) -> R {
        let mut coefficient = share.lit(1);
        let mut sum = self.exponent.clone().inv();
        let room = share.lit(1) - share;
        for j in 1..most_terms(share) {
            coefficient = (coefficient * share).times(2 * j - 1).over(2 * j);
            let next = coefficient.clone() / (self.exponent.clone() + share.lit(2 * j));
            sum += &next;
            let rest = next * share / &room;
            if rest.approx() <= sum.approx() * sum.unit_roundoff().approx() {
                return sum.inflate(&rest);
            }
        }
        sum.lit(1).over(0)
    }

    /// From the two parts on either side of L/√2, in units of bⁿ.
    fn far(&self, share: &R, room: &R) -> R {
        let (half, order) = (share.ratio(1, 2), self.exponent.clone().over(2));
        let whole = self.near(&half) * half.pow(&order) + self.outside(&half);
        (whole - self.outside(room)) / share.pow(&order)
    }

    /// ∫sinⁿ⁻¹φ dφ up to π/2 from where cos²φ = r: √r Σ_j (m)ⱼ/j! rʲ/(2j + 1), m = 1 − n/2. From j = |m| on the ratio of
    /// consecutive terms is at most r.
    fn outside(&self, room: &R) -> R {
        let m = room.lit(1) - self.exponent.clone().over(2);
        let mut coefficient = room.lit(1);
        let mut sum = coefficient.clone();
        for j in 1..most_terms(room) {
            coefficient = (coefficient * room * (m.clone() + m.lit(j - 1))).over(j);
            let next = coefficient.clone().over(2 * j + 1);
            sum += &next;
            let rest = next.abs() * room / (room.lit(1) - room);
            let settled = j as f64 > m.approx().abs();
            if settled && rest.approx() <= sum.approx().abs() * sum.unit_roundoff().approx() {
                return sum.inflate(&rest) * room.sqrt();
            }
        }
        sum.lit(1).over(0)
    }
}

/// The most terms of a series against a reference, whose terms fall at least by half.
fn most_terms<R: Real>(like: &R) -> i64 {
    2 * i64::from(like.precision()) + 64
}

impl<R: Gamma> Powers<R> {
    /// Of pairs (n, C) on a half-space graded as zᵏ: g = κ(n, k) C xⁿ, with the mean (1 + k)g/(n + 1 + k).
    ///
    /// # Errors
    /// [`Error::Domain`] unless every n is positive and every C finite.
    pub fn graded(terms: impl IntoIterator<Item = (R, R)>, k: &R) -> Result<Self> {
        Self::new(terms.into_iter().map(|(n, c)| {
            let order = k.lit(1) + k;
            let mean = order.clone() / (n.clone() + order);
            let factor = graded_kappa(&n, k) * c;
            [n, factor, mean]
        }))
    }

    /// Of pairs (n, C) in line contact: N = c_n C bⁿ.
    ///
    /// # Errors
    /// [`Error::Domain`] unless every n is positive and every C finite.
    pub fn line(terms: impl IntoIterator<Item = (R, R)>) -> Result<Self> {
        Self::new(terms.into_iter().map(|(n, c)| {
            let factor = line_factor(&n) * c;
            let nothing = n.lit(0);
            [n, factor, nothing]
        }))
    }
}

impl<R: Real> Transform<R> for Powers<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.sum(x, 0, |term| term.factor.clone())
    }

    fn slope(&self, x: &R) -> Result<R> {
        self.sum(x, 1, |term| term.factor.clone() * &term.exponent)
    }

    /// x times the mean.
    fn integral(&self, x: &R) -> Result<R> {
        Ok(self.mean(x)? * x)
    }

    fn mean(&self, x: &R) -> Result<R> {
        if self.terms.iter().all(|term| term.mean == x.lit(0)) {
            return Ok(x.lit(0));
        }
        self.sum(x, 0, |term| term.factor.clone() * &term.mean)
    }

    fn above_mean(&self, x: &R) -> Result<R> {
        self.sum(x, 0, |term| term.factor.clone() * (term.mean.lit(1) - &term.mean))
    }

    /// Where the mean of xⁿ is m xⁿ, m = q/(n + q) with the order q of the stiffness, that of xⁿxˡ is xⁿ⁺ˡ/(1/m + 1/m' − 1). In line
    /// contact, m = 0, there is none.
    fn mean_square(&self, x: &R) -> Option<Result<R>> {
        if self.terms.iter().any(|term| term.mean == x.lit(0)) {
            return None;
        }
        let height = |term: &Term<R>| Powers { terms: vec![term.clone()] }.g(x);
        let heights: Result<Vec<R>> = self.terms.iter().map(height).collect();
        Some(heights.map(|heights| {
            let rows = self.terms.iter().zip(&heights);
            let pairs = rows.clone().flat_map(|one| rows.clone().map(move |other| (one, other)));
            pairs.fold(x.lit(0), |sum, ((one, height), (other, another))| {
                let share = (one.mean.clone().inv() + other.mean.clone().inv() - x.lit(1)).inv();
                sum + share * height * another
            })
        }))
    }

    fn rises(&self) -> bool {
        self.all_rise()
    }
}
