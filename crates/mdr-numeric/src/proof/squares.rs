//! The mean of g² over the springs as an enclosure: (1/a)∫₀ᵃ g² dx on a half-space, and by other weights on other media.

use mdr_core::calculus::enclose::Sampled;
use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::{Analytic, Ends, Interval, Real, Rectangle};
use rug::Float;

use super::continuation::Continuation;
use super::energy::{SAMPLES, aiming_at, located, over_unit_interval, relative_aim, unproved};
use super::stretch::{Stretch, leg, up};
use crate::contact::Contact;
use crate::transform::is_moderate;

/// The integral of g², piece by piece between the kinks.
pub(super) struct SquareIntegral<'a> {
    pub(super) contact: &'a Contact<Interval>,
    pub(super) profile: &'a Continuation,
}

impl SquareIntegral<'_> {
    /// The mean of g² over the springs of a contact of each radius, in their order.
    ///
    /// # Errors
    /// A radius that is not positive; errors of the transform; [`Error::Unproved`] where an integral takes too many pieces, and beyond a
    /// kink on other media than a half-space.
    pub(super) fn means(&self, radii: &[Interval]) -> Result<Vec<Interval>> {
        let order = self.contact.medium().order_of_discs().filter(|order| *order != order.lit(1));
        let Some(order) = order else {
            return Ok(self.up_to(radii)?.into_iter().zip(radii).map(|(square, a)| square / a).collect());
        };
        let root = if order == order.lit(2) { None } else { Some(order.lit(1) / order) };
        let mean = |a: &Interval| {
            Error::require_positive(Quantity::ContactRadius, a.clone())?;
            if !self.profile.reaches(a) || self.profile.breaks().iter().any(|b| b.lower() <= a.upper()) {
                return Err(unproved(a));
            }
            let mean =
                SpringMean { transform: self.contact.transform(), profile: self.profile, a, root: root.as_ref() };
            over_unit_interval(&mean, a.precision()).map_err(|error| located(error, a))
        };
        radii.iter().map(mean).collect()
    }

    /// ∫₀ᵃ g² dx for each a, in their order.
    ///
    /// # Errors
    /// A radius that is not positive; errors of the transform; [`Error::Unproved`] where an integral takes too many pieces.
    pub(super) fn up_to(&self, radii: &[Interval]) -> Result<Vec<Interval>> {
        let places: Vec<(usize, Interval)> = radii.iter().map(|a| self.place(a)).collect();
        let mut order: Vec<usize> = (0..radii.len()).collect();
        order.sort_by(|&i, &j| places[i].1.mid().total_cmp(&places[j].1.mid()));
        let mut squares = vec![None; radii.len()];
        let Some(first) = radii.first() else { return Ok(Vec::new()) };
        let (mut total, mut from, mut beyond) = (first.lit(0), first.lit(0), 0);
        for index in order {
            Error::require_positive(Quantity::ContactRadius, radii[index].clone())?;
            let (end, to) = &places[index];
            if !self.profile.reaches(to) {
                return Err(unproved(to));
            }
            let aim = self.aim([&from, to], end - beyond, &total);
            while beyond < *end {
                let kink = self.profile.breaks()[beyond].rounded(to.ctx());
                if !from.is_same(&kink) {
                    total += &self.square_between([&from, &kink], beyond, aim.as_ref())?;
                }
                (from, beyond) = (kink, beyond + 1);
            }
            if !from.is_same(to) {
                total += &self.square_between([&from, to], beyond, aim.as_ref())?;
                from = to.clone();
            }
            squares[index] = Some(total.clone() + self.rest(&radii[index], to)?);
        }
        Ok(squares.into_iter().flatten().collect())
    }

    /// How many kinks lie before a radius, and the radius; a kink itself where it may be on either side of it.
    fn place(&self, a: &Interval) -> (usize, Interval) {
        let breaks = self.profile.breaks();
        let before = breaks.partition_point(|b| b.upper() < a.lower());
        match breaks.get(before) {
            Some(b) if b.lower() <= a.upper() => (before, b.rounded(a.ctx())),
            _ => (before, a.clone()),
        }
    }

    /// ∫ g² from a kink to a radius that is not told apart from it.
    fn rest(&self, a: &Interval, place: &Interval) -> Result<Interval> {
        if a.is_same(place) {
            return Ok(a.lit(0));
        }
        let g = self.profile.range(&a.hull(place)).ok_or_else(|| unproved(a))?;
        // The range has few bits, its width has less.
        Ok((a.clone() - place) * g.square())
    }

    /// The error to aim at on each stretch between two radii with so many kinks between them: a share of the whole integral, with its total
    /// up to the first, so that stretches from the axis need not be known beyond what they add. `None` where its size is not known.
    fn aim(&self, [from, to]: [&Interval; 2], kinks: usize, total: &Interval) -> Option<Float> {
        let length = to.clone() - from;
        let mut size = up(total.upper());
        for t in SAMPLES {
            let g = self.profile.range(&(length.clone() * Interval::from_f64(to.ctx(), t) + from))?;
            size += up((g.square() * &length).upper()) / SAMPLES.len() as u32;
        }
        let is_size = size.is_finite() && !size.is_zero();
        is_size.then(|| size / (kinks + 1) as u32 * relative_aim(to.precision()))
    }

    /// ∫ g² between two radii that have so many kinks before them, and none between them, with an error to aim at, or beside its own
    /// size.
    fn square_between(&self, [from, to]: [&Interval; 2], beyond: usize, aim: Option<&Float>) -> Result<Interval> {
        let base = beyond.checked_sub(1).map(|last| self.profile.breaks()[last].rounded(to.ctx()));
        let along = |x: &Interval| base.as_ref().map_or_else(|| x.clone(), |b| leg(x, b));
        if let (None, Some(k), true) = (&base, self.profile.root(), from.upper().is_zero()) {
            let square = RootedSquare { transform: self.contact.transform(), profile: self.profile, to, k };
            return integral(&square, to, aim);
        }
        let start = along(from);
        let length = along(to) - &start;
        let stretch = Stretch { profile: self.profile, beyond, base, from: start, length };
        integral(&Square { transform: self.contact.transform(), stretch }, to, aim)
    }
}

/// The integral from 0 to 1 that ends at a radius, with an error to aim at, or beside its own size.
fn integral(square: &impl Sampled, to: &Interval, aim: Option<&Float>) -> Result<Interval> {
    let found = match aim {
        Some(aim) => aiming_at(square, to.precision(), vec![aim.clone()]).map(|mut all| all.swap_remove(0)),
        None => over_unit_interval(square, to.precision()),
    };
    found.map_err(|error| located(error, to))
}

/// g² dx/dt.
struct Square<'a> {
    transform: &'a dyn Transform<Interval>,
    stretch: Stretch<'a>,
}

impl Square<'_> {
    fn of<T: Analytic>(&self, g: &T, [v, x]: &[T; 2]) -> Option<Vec<T>> {
        let square = g.squared().scaled(&self.stretch.length);
        Some(vec![if self.stretch.base.is_some() { square.product(v).quotient(x)? } else { square }])
    }
}

impl Sampled for Square<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        let Some(place) = self.stretch.at(t) else { return Ok(None) };
        Ok(self.of(&self.transform.g(&place[1])?, &place))
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        let place = self.stretch.at(t)?;
        let Stretch { profile, beyond, base, .. } = &self.stretch;
        let legs = profile.legs(&place[1], *beyond, base.as_ref().map(|_| &place[0]))?;
        self.of(&profile.g(&place[1], &legs)?, &place)
    }

    fn is_moderate(&self) -> bool {
        self.stretch.is_moderate()
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        let place = self.stretch.over(t)?;
        self.of(&self.stretch.profile.range(&place[1])?, &place)
    }
}

/// g² dx/dt up to a radius x₁ from the axis, where g is analytic as a function of q = x^(1/k) alone: x = x₁tᵏ.
struct RootedSquare<'a> {
    transform: &'a dyn Transform<Interval>,
    profile: &'a Continuation,
    to: &'a Interval,
    k: u32,
}

impl RootedSquare<'_> {
    fn of<T: Analytic>(&self, g: &T, t: &T) -> Option<Vec<T>> {
        let slope = t.raised(i64::from(self.k) - 1)?.product(&t.integer(i64::from(self.k)));
        Some(vec![g.squared().product(&slope).scaled(self.to)])
    }

    /// From the formula.
    fn by_formula<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        let order = self.to.lit(1).over(i64::from(self.k));
        self.of(&self.profile.g_at_root(&t.scaled(&self.to.pow(&order)))?, t)
    }
}

impl Sampled for RootedSquare<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        Ok(self.of(&self.transform.g(&(t.powi(i64::from(self.k)) * self.to))?, t))
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        self.by_formula(t)
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        self.by_formula(t)
    }

    fn is_moderate(&self) -> bool {
        is_moderate(self.to)
    }
}

/// The mean of g² over springs whose stiffness up to x is as x^q: ∫₀¹ g(a y^(1/q))² dy, and where q is 2 also 2∫₀¹ t g(at)² dt, which is analytic at
/// the axis.
struct SpringMean<'a> {
    transform: &'a dyn Transform<Interval>,
    profile: &'a Continuation,
    a: &'a Interval,
    /// 1/q; `None` where q is 2.
    root: Option<&'a Interval>,
}

impl SpringMean<'_> {
    fn place<T: Analytic>(&self, t: &T) -> Option<T> {
        let share = match self.root {
            Some(root) => t.power(root)?,
            None => t.clone(),
        };
        Some(share.scaled(self.a))
    }

    fn of<T: Analytic>(&self, g: &T, t: &T) -> Vec<T> {
        let square = g.squared();
        vec![if self.root.is_some() { square } else { square.product(&t.plus(t)) }]
    }
}

impl Sampled for SpringMean<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        let Some(x) = self.place(t) else { return Ok(None) };
        Ok(Some(self.of(&self.transform.g(&x)?, t)))
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        let x = self.place(t)?;
        Some(self.of(&self.profile.g(&x, &self.profile.legs(&x, 0, None)?)?, t))
    }

    fn is_moderate(&self) -> bool {
        is_moderate(self.a)
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        let x = self.place(t)?.nonnegative()?;
        Some(self.of(&self.profile.range(&x)?, t))
    }
}

#[cfg(test)]
#[path = "../../tests/private/rigorous.rs"]
pub(super) mod tests;
