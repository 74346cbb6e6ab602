//! Sums of profiles: g is linear in f.

use std::cmp::Ordering;

use mdr_core::contact::{Error, Kink, Quantity, Result, Slopes, Transform};
use mdr_core::number::{Special, order};

/// The profile f₁ + f₂ + …, whose g, g' and G are the sums of those of its terms. It ends where its first term ends.
pub struct Sum<R> {
    terms: Vec<Box<dyn Transform<R>>>,
}

impl<R: Special> Sum<R> {
    /// The sum of `terms`; an empty sum is the flat half-space, g = 0.
    pub fn new(terms: Vec<Box<dyn Transform<R>>>) -> Self {
        Sum { terms }
    }

    fn total(&self, x: &R, part: impl Fn(&dyn Transform<R>) -> Result<R>) -> Result<R> {
        if self.terms.is_empty() {
            Error::require_positive(Quantity::Radius, x.clone())?;
        }
        let sum = self.terms.iter().try_fold(x.lit(0), |sum, term| Ok(sum + part(term.as_ref())?));
        match sum {
            Ok(sum) if sum.is_finite() => Ok(sum),
            Ok(_) => self.beyond(x, Quantity::TransformedProfile, part),
            Err(Error::OutOfRange { quantity, .. }) => self.beyond(x, quantity, part),
            error => error,
        }
    }

    /// The sum if a term is out of range: that of the others if they outweigh it, else [`Error::OutOfRange`]. Its log₁₀
    /// is known if one term outweighs all others, and infinite otherwise, because a term out of range has an unknown
    /// sign. Where a term is not bounded neither is the sum; but a number with a slope may have a value in spite of that, which is
    /// the sum of all values.
    #[cold]
    fn beyond(&self, x: &R, quantity: Quantity, part: impl Fn(&dyn Transform<R>) -> Result<R>) -> Result<R> {
        /// The decades by which a term must exceed the others to equal the sum in double precision.
        const AHEAD: f64 = 17.0;
        let mut sum = x.lit(0);
        let mut is_bounded = true;
        let (mut most, mut next) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        for term in &self.terms {
            match part(term.as_ref()) {
                Ok(value) => {
                    is_bounded &= value.is_finite();
                    sum += &value;
                }
                Err(Error::OutOfRange { log10, .. }) => (most, next) = (most.max(log10), next.max(most.min(log10))),
                Err(error) => return Err(error),
            }
        }
        if !is_bounded {
            let is_known = most == f64::NEG_INFINITY;
            return if is_known { Ok(sum) } else { Err(Error::OutOfRange { quantity, log10: f64::INFINITY }) };
        }
        let log10 = sum.abs().ln().approx() / std::f64::consts::LN_10;
        let ahead = f64::from(x.precision()) * std::f64::consts::LOG10_2;
        if sum.is_finite() && log10 > most + ahead {
            // An enclosure must include the omitted terms.
            let rest = (sum.clone() * x.unit_roundoff()).times(self.terms.len() as i64);
            return Ok(sum.inflate(&rest));
        }
        (most, next) = (most.max(log10), next.max(most.min(log10)));
        let log10 = if most > next + AHEAD { most } else { f64::INFINITY.copysign(most) };
        Err(Error::OutOfRange { quantity, log10 })
    }
}

impl<R: Special> Transform<R> for Sum<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.g(x))
    }
    fn slope(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.slope(x))
    }
    fn integral(&self, x: &R) -> Result<R> {
        match self.total(x, |term| term.integral(x)) {
            // The mean may still be a number, with its sign.
            Err(Error::OutOfRange { quantity, log10 }) if log10 == f64::INFINITY => {
                let log10 = match self.mean(x) {
                    Ok(mean) => (mean.abs().ln().approx() + x.ln().approx()) / std::f64::consts::LN_10,
                    _ => log10,
                };
                Err(Error::OutOfRange { quantity, log10 })
            }
            integral => integral,
        }
    }
    fn mean(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.mean(x))
    }
    fn above_mean(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.above_mean(x))
    }
    fn g_within(&self, x: &R, needed: &R) -> Result<R> {
        self.total(x, |term| term.g_within(x, needed))
    }
    fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
        self.total(x, |term| term.mean_within(x, needed))
    }
    fn outer_radius(&self) -> Option<R> {
        let ends = self.terms.iter().filter_map(|term| term.outer_radius());
        ends.reduce(|a, b| if b < a { b } else { a })
    }
    fn vertical_edge(&self) -> bool {
        let Some(end) = self.outer_radius() else { return false };
        let mut last = self.terms.iter().filter(|term| term.outer_radius().is_some_and(|outer| !(outer > end)));
        last.all(|term| term.vertical_edge())
    }
    fn kinks(&self) -> Vec<R> {
        self.edges().into_iter().map(|edge| edge.radius).collect()
    }
    fn work(&self) -> u64 {
        self.terms.iter().map(|term| term.work()).sum()
    }

    fn rises(&self) -> bool {
        self.terms.iter().all(|term| term.rises())
    }
    fn rises_beyond(&self, x: &R) -> bool {
        self.terms.iter().all(|term| term.rises_beyond(x))
    }
    fn kink(&self, index: usize, margin: &R) -> Result<Option<Kink<R>>> {
        let Some(edge) = self.edges().into_iter().nth(index).or_else(|| self.end()) else { return Ok(None) };
        let mut sum: Option<Kink<R>> = None;
        for (i, term) in self.terms.iter().enumerate() {
            let share = if i == edge.term {
                term.kink(edge.index, margin)?
            } else {
                share(term.as_ref(), &edge.radius, margin)?
            };
            let Some(share) = share else { return Ok(None) };
            sum = Some(match sum {
                Some(sum) => sum.plus(share),
                None => share,
            });
        }
        Ok(sum)
    }
}

/// A kink, or the end, of one of the terms.
struct EdgeOf<R> {
    radius: R,
    term: usize,
    index: usize,
}

impl<R: Special> Sum<R> {
    /// The kinks of all terms, ascending, up to where the first term ends.
    fn edges(&self) -> Vec<EdgeOf<R>> {
        let end = self.outer_radius();
        let mut edges = Vec::new();
        for (term, profile) in self.terms.iter().enumerate() {
            let kinks = profile.kinks().into_iter().enumerate();
            edges.extend(kinks.map(|(index, radius)| EdgeOf { radius, term, index }));
        }
        edges.retain(|edge: &EdgeOf<R>| end.as_ref().is_none_or(|end| edge.radius < *end));
        edges.sort_by(|a, b| order(&a.radius, &b.radius));
        edges
    }

    /// The first radius at which a term ends.
    fn end(&self) -> Option<EdgeOf<R>> {
        let ends = self.terms.iter().enumerate().filter_map(|(term, profile)| {
            Some(EdgeOf { radius: profile.outer_radius()?, term, index: profile.kinks().len() })
        });
        ends.reduce(|a, b| if b.radius < a.radius { b } else { a })
    }
}

/// The contribution of a term at the kink of another one: a kink that certainly coincides, or smooth values.
fn share<R: Special>(term: &dyn Transform<R>, radius: &R, margin: &R) -> Result<Option<Kink<R>>> {
    let near = radius.clone().inflate(&(margin.clone() * radius));
    let ends = term.outer_radius().filter(|_| !term.vertical_edge());
    for (index, kink) in term.kinks().iter().chain(&ends).enumerate() {
        if kink == radius {
            return term.kink(index, margin);
        }
        if !kink.partial_cmp(&near).is_some_and(Ordering::is_ne) {
            return Ok(None);
        }
    }
    let known = || {
        let slope = term.slope(&near)?;
        Ok(Kink {
            value: Some((term.g(radius)?, term.mean(radius)?)),
            inside: Slopes::within(slope.clone()),
            outside: Slopes::within(slope),
        })
    };
    match known() {
        Err(Error::Domain { .. }) => Ok(None),
        kink => kink.map(Some),
    }
}
