//! Numbers as questions write them: a decimal, or a fraction of two of them.

use crate::decimal::Decimal;

/// An exact fraction. Equal fractions are equal numbers: 3/2 is 1.5.
#[derive(Clone, Debug)]
pub(crate) struct Fraction {
    numerator: Decimal,
    denominator: Decimal,
}

impl Fraction {
    /// `None` unless the text is a decimal or a fraction of two, the second one not zero.
    pub(crate) fn of(text: &str) -> Option<Self> {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let [numerator, denominator] = [numerator.parse::<Decimal>().ok()?, denominator.parse::<Decimal>().ok()?];
        (!denominator.is_zero()).then_some(Fraction { numerator, denominator })
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        &self.numerator * &other.denominator == &other.numerator * &self.denominator
    }
}

#[cfg(test)]
mod tests {
    use super::Fraction;

    #[test]
    fn fractions_are_compared_by_their_values() {
        let equal = |one, other| Fraction::of(one).is_some_and(|one| Some(one) == Fraction::of(other));
        for (one, other) in
            [("3/2", "1.5"), ("-3/2", "-15e-1"), ("1/3", "2/6"), ("-1/-3", "7/21"), ("0/7", "-0"), ("1e3/8", "125")]
        {
            assert!(equal(one, other), "{one} = {other}");
        }
        for (one, other) in [("1/3", "0.3333333333333333"), ("3/2", "-1.5"), ("1/3", "1/4"), ("0", "1/7")] {
            assert!(!equal(one, other), "{one} != {other}");
        }
        assert!(["1/0", "0/0", "1/", "/2", "1/2/3", "n"].into_iter().all(|text| Fraction::of(text).is_none()));
    }
}
