//! What an evaluation costs: an estimate of its time, as a function of the question alone.

use mdr_core::contact::Shape;

use crate::scene::{ExactMedium, Profile};

/// The work of one value of g, or of one height of its quadrature, in nanoseconds of a machine of 2024: for an arithmetic by its
/// [place](crate::run::ARITHMETICS) and so many bits. Measured, to within a factor of three, from 53 to 3500 bits.
pub(crate) fn weight(profile: &Profile, arithmetic: usize, bits: u32) -> u64 {
    let costs = Costs::of(arithmetic, u64::from(bits));
    costs.of_profile(profile)
}

/// The work of one value of g, or of one height of its quadrature, on a medium: off the half-space doubles count the heights of a table,
/// each of which sees two rows, and no integrals over all.
pub(crate) fn weight_on(profile: &Profile, medium: &ExactMedium, arithmetic: usize, bits: u32) -> u64 {
    let costs = Costs::of(arithmetic, u64::from(bits));
    if arithmetic > 0 || medium.is_half_space() {
        return costs.of_profile(profile);
    }
    Costs { row: 0, ..costs }.of_profile(profile)
}

/// The work of one value of g over intervals of doubles, in nanoseconds.
#[cfg(feature = "mp")]
pub(crate) fn weight_in_doubles(profile: &Profile) -> u64 {
    INTERVAL * weight(profile, 0, f64::MANTISSA_DIGITS)
}

/// An operation on intervals of doubles counts as so many on doubles.
#[cfg(feature = "mp")]
const INTERVAL: u64 = 20;

/// The work of one height of a profile within a bound of the gap, in nanoseconds: that of a shape is a few operations where g may be
/// a special function.
#[cfg(feature = "mp")]
pub(crate) fn weight_of_height(profile: &Profile, arithmetic: usize, bits: u32) -> u64 {
    match profile {
        Profile::Shape(_) => HEIGHT * Costs::of(arithmetic, u64::from(bits)).operation,
        profile => weight(profile, arithmetic, bits),
    }
}

/// A height of a shape counts as so many operations of a formula.
#[cfg(feature = "mp")]
const HEIGHT: u64 = 8;

/// A function of a program counts as so many operations of a formula.
const OPERATIONS: u64 = 30;

/// Times of what profiles are made of.
struct Costs {
    /// One closed form.
    form: u64,
    /// An operation of a formula; a function is twenty.
    operation: u64,
    /// A wave on a paraboloid, which has Bessel functions beside a square.
    wavy: u64,
    /// Whether integrals over it are bounded on complex sets.
    is_complex: bool,
    /// The share of one row in an integral over a table.
    row: u64,
    /// Whether the rows far from the radius count together.
    clustered: bool,
}

impl Costs {
    fn of(arithmetic: usize, bits: u64) -> Self {
        // Enclosures are twice as dear as numbers of the same bits, those with a slope three times.
        let times = match arithmetic {
            0 => return Costs { form: 150, operation: 8, wavy: 650, is_complex: false, row: 20, clustered: true },
            1 => 2,
            _ => 3,
        };
        let size = bits * bits / 8000;
        let form = times * (1500 + 25 * bits + 10 * size);
        Costs {
            form,
            wavy: 3 * form / 2,
            operation: times * (60 + bits / 5 + size),
            is_complex: true,
            row: times * (1000 + 3 * bits),
            clustered: bits <= 512,
        }
    }

    fn of_profile(&self, profile: &Profile) -> u64 {
        match profile {
            Profile::Shape(Shape::WavyParaboloid { .. }) => self.wavy,
            Profile::Shape(_) | Profile::Wave(_) => self.form,
            Profile::Sum(terms) => terms.iter().map(|term| self.of_profile(term)).sum(),
            Profile::Formula(formula) => {
                let expression = &formula.expression;
                self.operation * if self.is_complex { expression.complex_operations() } else { expression.operations() }
            }
            Profile::Function(_) => self.operation * OPERATIONS,
            Profile::Table(_) => self.form + self.row * self.rows(profile.rows().unwrap_or(1) as u64),
        }
    }

    /// The rows whose shares take as long as those of a table of `rows`: the near ones, and some for each level of clusters.
    fn rows(&self, rows: u64) -> u64 {
        if self.clustered { rows.min(24 + 5 * u64::from(rows.max(1).ilog2())) } else { rows }
    }
}

#[cfg(test)]
mod tests {
    use mdr_core::contact::Shape;

    use super::*;

    /// Measured: Bessel functions are dear in doubles, and over enclosures a wave takes as long as one and a half of other forms.
    #[test]
    fn a_wave_weighs_what_it_takes() {
        let [one, length] = [1, 2].map(mdr_core::number::Literal::from);
        let wave =
            Profile::Shape(Shape::WavyParaboloid { radius: one.clone(), amplitude: one.clone(), wavelength: length });
        let ball = Profile::Shape(Shape::Paraboloid { radius: one });
        for (arithmetic, bits, least, most) in [(0, 53, 4.0, 5.0), (1, 64, 1.4, 1.6), (2, 128, 1.4, 1.6)] {
            let ratio = weight(&wave, arithmetic, bits) as f64 / weight(&ball, arithmetic, bits) as f64;
            assert!(ratio > least && ratio < most, "{arithmetic}: {ratio}");
        }
    }
}
