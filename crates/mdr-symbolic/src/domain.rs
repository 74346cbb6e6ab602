//! The domain in n of a statement.

use rug::Rational;

/// The values of n for which a statement is made. Every other symbol is positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Domain {
    /// n > 0.
    Positive,
    /// n > 1/2: the contact breaks.
    Above,
    /// 0 < n < 1/2: the contact becomes complete.
    Below,
    /// n = 1/2: the problem has no length scale.
    Half,
}

impl Domain {
    /// As text.
    pub fn text(self) -> &'static str {
        match self {
            Domain::Positive => "n > 0",
            Domain::Above => "n > 1/2",
            Domain::Below => "0 < n < 1/2",
            Domain::Half => "n = 1/2",
        }
    }

    /// Whether a value of n lies in the domain.
    ///
    /// ```
    /// use mdr_symbolic::Domain;
    /// assert!(Domain::Below.contains(&(1, 4).into()) && !Domain::Below.contains(&(1, 2).into()));
    /// ```
    pub fn contains(self, n: &Rational) -> bool {
        match self.bounds() {
            (lower, Some(upper)) if self.is_point() => lower <= *n && *n <= upper,
            (lower, upper) => lower < *n && upper.is_none_or(|upper| *n < upper),
        }
    }

    /// Whether n is a single number.
    pub(crate) fn is_point(self) -> bool {
        self == Domain::Half
    }

    /// The ends of the interval; without an upper end the domain contains all larger numbers.
    pub(crate) fn bounds(self) -> (Rational, Option<Rational>) {
        let half = || Rational::from((1, 2));
        match self {
            Domain::Positive => (Rational::new(), None),
            Domain::Above => (half(), None),
            Domain::Below => (Rational::new(), Some(half())),
            Domain::Half => (half(), Some(half())),
        }
    }

    /// Some number of the domain.
    pub(crate) fn sample(self) -> Rational {
        match self {
            Domain::Positive | Domain::Above => Rational::from(1),
            Domain::Below => Rational::from((1, 4)),
            Domain::Half => Rational::from((1, 2)),
        }
    }
}
