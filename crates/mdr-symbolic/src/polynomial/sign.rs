//! The sign of a polynomial on a whole interval, by Sturm's theorem.

use std::cmp::Ordering;

use super::Polynomial;
use crate::domain::Domain;

impl Polynomial {
    /// The sign of the polynomial at every n of the domain; `None` when it changes or vanishes there.
    ///
    /// ```
    /// use mdr_symbolic::{Domain, Polynomial};
    /// let excess = Polynomial::linear(2, -1); // 2n − 1
    /// assert_eq!(excess.sign_on(Domain::Above), Some(std::cmp::Ordering::Greater));
    /// assert_eq!(excess.sign_on(Domain::Below), Some(std::cmp::Ordering::Less));
    /// assert_eq!(excess.sign_on(Domain::Positive), None);
    /// ```
    pub fn sign_on(&self, domain: Domain) -> Option<Ordering> {
        let inside = self.evaluate(&domain.sample()).cmp0();
        let constant = self.degree() == 0 || domain.is_point();
        (constant || self.roots_in(domain) == 0).then_some(inside)
    }

    /// The number of distinct roots in the open interval.
    fn roots_in(&self, domain: Domain) -> usize {
        let (lower, upper) = domain.bounds();
        let chain = self.sturm_chain();
        let below = sign_changes(chain.iter().map(|p| p.evaluate(&lower).cmp0()));
        let (above, at_end) = match &upper {
            Some(upper) => {
                (sign_changes(chain.iter().map(|p| p.evaluate(upper).cmp0())), self.evaluate(upper).is_zero())
            }
            None => (sign_changes(chain.iter().map(|p| p.leading().cmp0())), false),
        };
        // The theorem counts the roots in (lower, upper].
        below - above - usize::from(at_end)
    }

    /// Sturm's chain of the square-free part.
    fn sturm_chain(&self) -> Vec<Polynomial> {
        let common = self.gcd(&self.derivative());
        let first = self.exact_quotient(&common).unwrap_or_default();
        let mut chain = vec![first.clone(), first.derivative()];
        while let [.., before, last] = &chain[..] {
            match before.divide(last) {
                Ok((_, rest)) if !rest.is_zero() => chain.push(-&rest),
                _ => break,
            }
        }
        chain
    }
}

/// The number of sign changes in a sequence, ignoring zeros.
fn sign_changes(signs: impl Iterator<Item = Ordering>) -> usize {
    let signs: Vec<_> = signs.filter(|sign| sign.is_ne()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;

    #[test]
    fn roots_at_the_ends_and_inside() {
        // (2n − 1)(n − 1)²(n² + 1)
        let p = &(&Polynomial::linear(2, -1) * &Polynomial::linear(1, -1).power(2))
            * &Polynomial::from_integers(&[1, 0, 1]);
        assert_eq!(p.sign_on(Domain::Below), Some(Ordering::Less));
        assert_eq!(p.sign_on(Domain::Above), None);
        assert_eq!(p.sign_on(Domain::Half), Some(Ordering::Equal));
        assert_eq!(Polynomial::constant(Rational::from(-3)).sign_on(Domain::Positive), Some(Ordering::Less));
    }
}
