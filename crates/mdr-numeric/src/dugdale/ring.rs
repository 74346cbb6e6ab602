//! The ring of attraction around a contact, and integrals over it of functions that are singular at kinks of the profile.

use mdr_core::calculus::quadrature::{Node, tanh_sinh, tanh_sinh_near_ends};
use mdr_core::calculus::{Estimate, Tolerance};
use mdr_core::contact::{Error, Result};
use mdr_core::number::Special;

use super::Dugdale;
use crate::transform::strides::strides;

/// The ring of attraction: its width y = c − a, which may be far below a.
#[derive(Clone)]
pub(crate) struct Ring<R> {
    pub(crate) a: R,
    pub(crate) width: R,
    pub(crate) c: R,
    /// q.
    pub(crate) leg: R,
    /// θ.
    pub(crate) angle: R,
}

impl<R: Special> Dugdale<R> {
    /// s, for enclosures.
    #[cfg(feature = "mp")]
    pub(crate) fn strength(&self) -> &R {
        &self.strength
    }

    /// (π/2) h₀.
    pub(crate) fn needed_opening(&self) -> R {
        (self.separation.clone() * self.separation.pi()).over(2)
    }

    /// s (q θ − (c − a)), what the attraction in a ring adds to the gap at its end, times π/2.
    pub(crate) fn opening(&self, ring: &Ring<R>) -> R {
        self.strength.clone() * ring.opening()
    }

    /// s (c²θ²/a + c − a), where the force is stationary the integral of x g' over the ring.
    pub(crate) fn pull(&self, ring: &Ring<R>) -> R {
        let Ring { a, c, angle, width, .. } = ring;
        (c.clone() / a * angle * (c.clone() * angle) + width) * &self.strength
    }
}

/// The part of a ring between two neighbouring kinks, or between one of them and an edge of the ring.
struct Piece<'a, R> {
    ring: &'a Ring<R>,
    /// Its ends.
    from: &'a R,
    to: &'a R,
    /// The length of the piece, stored because the difference of its ends would cancel where it is narrow.
    length: R,
    /// c less the outer end, 0 at the edge of the ring.
    beyond: R,
    /// The nearest kink that is not outside of it: its inner end, or one under the contact.
    inner: Option<&'a R>,
    /// The kink at its outer end.
    outer: Option<&'a R>,
}

/// The most strides of an integral that one rule cannot take: each takes up to about forty waves.
const STRIDES: i64 = 64;

impl<R: Special> Ring<R> {
    pub(crate) fn new(a: &R, width: &R) -> Self {
        let leg = width.sqrt() * (a.clone().times(2) + width).sqrt();
        Ring { a: a.clone(), width: width.clone(), c: a.clone() + width, angle: (leg.clone() / a).atan(), leg }
    }

    /// q θ − (c − a).
    pub(crate) fn opening(&self) -> R {
        self.leg.clone() * &self.angle - &self.width
    }

    /// ∫ₐᶜ f(x)/√(c² − x²) dx = ∫₀^θ f(c cos φ) dφ, where f or its derivatives are singular at `kinks`, ascending.
    ///
    /// Without a kink in the ring, or under the contact and nearer to it than the ring is wide, the integrand in φ is smooth.
    /// Otherwise the integral is cut there. The distance δ from a kink is known to the integrand where x is rounded, and an
    /// f with up to an inverse root of δ is taken as the smooth f √δ at the rounded x over the root of the exact δ: the
    /// rounding of x is then the same small change in f √δ everywhere.
    pub(crate) fn integral(
        &self,
        kinks: &[R],
        tolerance: &Tolerance<R>,
        mut f: impl FnMut(&R) -> Result<R>,
    ) -> Result<Estimate<R>> {
        let pieces = self.pieces(kinks);
        if pieces.is_empty() {
            return patient(&self.a.lit(0), &self.angle, |from, to| {
                tanh_sinh(from, to, tolerance.clone(), |angle| f(&self.on(angle)))
            });
        }
        let mut total = Estimate::exact(self.a.lit(0));
        for piece in pieces {
            total += &piece.integral(tolerance, &mut f)?;
        }
        Ok(total)
    }

    /// The error of ∫ₐᶜ f(x)/√(c² − x²) dx of a continuous f that changes in one direction between kinks, as x is rounded: over
    /// a piece from p to q it is u c |f(q) − f(p)|/(q − p) times ∫ dx/√(c² − x²) < 2 √((q − p)/(c + p)), twice for an f that
    /// begins with a root of the distance. The largest of all pieces; 0 where there is one piece, over which f is smooth.
    pub(crate) fn rounding(&self, kinks: &[R], mut f: impl FnMut(&R) -> Result<R>) -> Result<R> {
        let mut largest = self.a.lit(0);
        for piece in self.pieces(kinks) {
            let zero = self.a.lit(0);
            let ends = [piece.radius(&zero, &piece.length), piece.radius(&piece.length, &zero)];
            let [inner, outer] = ends.map(|x| f(&x));
            let angle = (piece.length.clone() / (piece.from.clone() + &self.c)).sqrt().times(2);
            let share = self.c.clone() / &piece.length * angle * self.c.unit_roundoff();
            largest = largest.greater(&((outer? - inner?).abs().times(2) * share));
        }
        Ok(largest)
    }

    /// The ring, cut at the kinks within; nothing where the integrand is smooth.
    fn pieces<'a>(&'a self, kinks: &'a [R]) -> Vec<Piece<'a, R>> {
        let mut inner = kinks.iter().rfind(|kink| **kink <= self.a && self.a.clone() - *kink < self.width);
        let within = |kink: &&R| **kink > self.a && **kink < self.c && (*kink).clone() - &self.a < self.width;
        let cuts: Vec<&R> = kinks.iter().filter(within).collect();
        if inner.is_none() && cuts.is_empty() {
            return Vec::new();
        }
        let mut from = &self.a;
        let mut pieces = Vec::with_capacity(cuts.len() + 1);
        for outer in cuts.into_iter().map(Some).chain([None]) {
            pieces.push(Piece::new(self, from, inner, outer));
            (from, inner) = (outer.unwrap_or(&self.c), outer);
        }
        pieces
    }

    /// c cos φ, within the ring.
    fn on(&self, angle: &R) -> R {
        (angle.cos() * &self.c).greater(&self.a).lesser(&self.c)
    }
}

impl<'a, R: Special> Piece<'a, R> {
    fn new(ring: &'a Ring<R>, from: &'a R, inner: Option<&'a R>, outer: Option<&'a R>) -> Self {
        // c less a radius, from the width of the ring.
        let rest = |x: &R| ring.width.clone() - (x.clone() - &ring.a);
        let (to, length, beyond) = match outer {
            Some(kink) => (kink, kink.clone() - from, rest(kink)),
            None => (&ring.c, rest(from), from.lit(0)),
        };
        Piece { ring, from, to, length, beyond, inner, outer }
    }

    fn integral(&self, tolerance: &Tolerance<R>, f: &mut impl FnMut(&R) -> Result<R>) -> Result<Estimate<R>> {
        let mut rule = |from: &R, to: &R| {
            let after = self.length.clone() - to;
            tanh_sinh_near_ends(from, to, tolerance.clone(), |node: &Node<R>| {
                self.at(&(node.from_lower.clone() + from), &(node.from_upper.clone() + &after), f)
            })
        };
        let zero = self.length.lit(0);
        // No profile has waves within the root of the rounding.
        let narrow = self.length < self.to.unit_roundoff().sqrt() * self.to;
        if narrow { rule(&zero, &self.length) } else { patient(&zero, &self.length, rule) }
    }

    /// The integrand at the distances from both ends.
    fn at(&self, from_lower: &R, from_upper: &R, f: &mut impl FnMut(&R) -> Result<R>) -> Result<R> {
        let x = self.radius(from_lower, from_upper);
        let mut value = f(&x)?;
        if let Some(kink) = self.inner {
            let distance = self.from.clone() - kink + from_lower;
            value *= &((x.clone() - kink) / distance).sqrt();
        }
        if let Some(kink) = self.outer {
            value *= &((kink.clone() - &x) / from_upper).sqrt();
        }
        Ok(value / (self.beyond.clone() + from_upper).sqrt() / (x + &self.ring.c).sqrt())
    }

    /// x from the nearer end, rounded to the correct side of the kinks.
    fn radius(&self, from_lower: &R, from_upper: &R) -> R {
        let x = if from_lower < from_upper { self.from.clone() + from_lower } else { self.to.clone() - from_upper };
        let x = self.outer.map_or_else(|| x.lesser(self.to), |kink| x.lesser(&beside(kink, -1)));
        self.inner.map_or_else(|| x.greater(self.from), |kink| x.greater(&beside(kink, 1)))
    }
}

/// A radius one or two floating-point numbers above a kink or below it.
fn beside<R: Special>(kink: &R, side: i64) -> R {
    kink.unit_roundoff().times(2 * side) * kink + kink
}

/// An integral by one rule, or in [strides] if it has too many waves for one.
fn patient<R: Special>(
    lower: &R,
    upper: &R,
    mut rule: impl FnMut(&R, &R) -> Result<Estimate<R>>,
) -> Result<Estimate<R>> {
    match rule(lower, upper) {
        Err(Error::NoConvergence { .. }) => strides(lower, upper, STRIDES, rule),
        result => result,
    }
}
