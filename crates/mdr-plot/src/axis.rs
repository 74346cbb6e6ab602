//! Axes: which quantity, over which range, in which unit, with which ticks.

/// The unit of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A ratio.
    One,
    /// An SI unit, which takes the prefix that makes the numbers of a linear axis legible.
    Si(&'static str),
}

impl Unit {
    /// The unit without a prefix.
    pub(crate) fn base(self) -> &'static str {
        match self {
            Unit::One => "1",
            Unit::Si(unit) => unit,
        }
    }
}

/// One axis of a panel. Values on it are in the base unit.
#[derive(Clone, Debug)]
pub struct Axis {
    /// With [markup](crate#markup).
    pub(crate) quantity: String,
    pub(crate) unit: Unit,
    /// Equal distances are equal ratios, not equal differences.
    logarithmic: bool,
    lower: f64,
    upper: f64,
    /// What stands in the rows of the axis, from above; empty for numbers.
    names: Vec<String>,
}

/// A tick: where, and the number beside it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// From 0 at the lower end of the axis to 1.
    pub(crate) fraction: f64,
    /// With markup.
    pub(crate) text: String,
}

impl Axis {
    /// An axis from `lower` to `upper` with equal differences; a range without length is widened.
    pub fn linear(quantity: impl Into<String>, unit: Unit, lower: f64, upper: f64) -> Self {
        let half = match upper > lower {
            true => 0.0,
            false if lower == 0.0 => 1.0,
            false => lower.abs() / 10.0,
        };
        Axis {
            quantity: quantity.into(),
            unit,
            logarithmic: false,
            lower: lower - half,
            upper: upper + half,
            names: Vec::new(),
        }
    }

    /// An axis from `lower` > 0 to `upper` with equal ratios; a range without length is widened.
    pub fn log(quantity: impl Into<String>, unit: Unit, lower: f64, upper: f64) -> Self {
        let factor = if upper > lower { 1.0 } else { 10.0 };
        let (lower, upper) = (lower / factor, upper * factor);
        Axis { quantity: quantity.into(), unit, logarithmic: true, lower, upper, names: Vec::new() }
    }

    /// A vertical axis of rows with names, with [markup](crate#markup), from above. See [`row`](Axis::row).
    pub fn rows(quantity: impl Into<String>, names: Vec<String>) -> Self {
        Axis { upper: names.len() as f64 + 0.5, lower: 0.5, names, ..Self::linear(quantity, Unit::One, 0.0, 1.0) }
    }

    /// Where the row of a number, from 0 above, is on an axis of rows.
    pub fn row(&self, number: usize) -> f64 {
        self.names.len() as f64 - number as f64
    }

    /// The names of the rows; none of an axis of numbers.
    pub(crate) fn names(&self) -> &[String] {
        &self.names
    }

    /// A linear axis that shows zero and all of `values`, with a margin.
    pub fn around(quantity: impl Into<String>, unit: Unit, values: impl IntoIterator<Item = f64>) -> Self {
        let finite = values.into_iter().filter(|value| value.is_finite());
        let (lower, upper) = finite.fold((0.0, 0.0), |(lower, upper), value| (value.min(lower), value.max(upper)));
        let margin = 0.1 * (upper - lower);
        Self::linear(quantity, unit, lower - margin, upper + margin)
    }

    /// The lower and the upper end.
    pub fn range(&self) -> (f64, f64) {
        (self.lower, self.upper)
    }

    /// The value at a fraction of the axis.
    pub fn at(&self, fraction: f64) -> f64 {
        match self.logarithmic {
            false => self.lower + fraction * (self.upper - self.lower),
            true => self.lower * (self.upper / self.lower).powf(fraction),
        }
    }

    /// Where on the axis a value is: 0 at the lower end, 1 at the upper.
    pub fn fraction(&self, value: f64) -> f64 {
        match self.logarithmic {
            false => (value - self.lower) / (self.upper - self.lower),
            true => (value / self.lower).ln() / (self.upper / self.lower).ln(),
        }
    }

    /// Quantity and unit, for the end of the axis.
    pub(crate) fn title(&self) -> String {
        match self.scaled_unit() {
            (_, unit) if unit.is_empty() => self.quantity.clone(),
            (_, unit) => format!("{} ({unit})", self.quantity),
        }
    }

    /// The power of ten that the numbers at the ticks are multiples of, and the unit that has it as its prefix.
    pub(crate) fn scaled_unit(&self) -> (i32, String) {
        let power = self.power();
        let ten = power_of_ten(power);
        let unit = match self.unit {
            Unit::One if power == 0 => String::new(),
            Unit::One => ten,
            Unit::Si(unit) => match prefix(power) {
                Some(prefix) => format!("{prefix}{unit}"),
                None => format!("{ten} {unit}"),
            },
        };
        (power, unit)
    }

    /// A multiple of three, for numbers from 1 to 999 at the larger end.
    fn power(&self) -> i32 {
        let largest = self.lower.abs().max(self.upper.abs());
        if self.logarithmic || (self.unit == Unit::One && (0.01..1e4).contains(&largest)) {
            return 0;
        }
        3 * (largest.log10() / 3.0).floor() as i32
    }

    /// At most `most` ticks at round numbers.
    pub(crate) fn ticks(&self, most: usize) -> Vec<Tick> {
        if !self.names.is_empty() {
            let tick = |(number, name): (usize, &String)| Tick {
                fraction: self.fraction(self.row(number)),
                text: name.clone(),
            };
            return self.names.iter().enumerate().map(tick).collect();
        }
        if self.logarithmic {
            let (lower, upper) = (self.lower.log10(), self.upper.log10());
            let step = round_step(upper - lower, most).max(1.0);
            let tick = |exponent: f64| Tick {
                fraction: (exponent - lower) / (upper - lower),
                text: power_of_ten(exponent as i32),
            };
            return multiples(lower, upper, step).map(tick).collect();
        }
        let unit = 10f64.powi(self.power());
        let (lower, upper) = (self.lower / unit, self.upper / unit);
        let step = round_step(upper - lower, most);
        let decimals = (-(step * 1.001).log10().floor()).clamp(0.0, 9.0) as usize;
        // Adding zero takes the sign from a zero.
        let text = |value: f64| typographic(&format!("{:.decimals$}", value + 0.0));
        let tick = |value: f64| Tick { fraction: (value - lower) / (upper - lower), text: text(value) };
        multiples(lower, upper, step).map(tick).collect()
    }
}

/// The smallest of 1, 2 and 5 times a power of ten of which a range holds at most `most`.
fn round_step(range: f64, most: usize) -> f64 {
    let least = range / most.max(1) as f64;
    let ten = 10f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * ten).find(|step| *step >= least).unwrap_or(10.0 * ten)
}

/// The multiples of `step` from `lower` to `upper`.
fn multiples(lower: f64, upper: f64, step: f64) -> impl Iterator<Item = f64> {
    // Ends that are multiples but for rounding count.
    let (first, last) = ((lower / step - 1e-9).ceil(), (upper / step + 1e-9).floor());
    (0..=(last - first).clamp(-1.0, 1e3) as i64).map(move |index| (first + index as f64) * step)
}

fn power_of_ten(exponent: i32) -> String {
    format!("10^{{{}}}", typographic(&exponent.to_string()))
}

/// A number with a minus sign instead of a hyphen.
pub fn typographic(number: &str) -> String {
    number.replace('-', "\u{2212}")
}

/// The SI prefix of a power of ten.
fn prefix(power: i32) -> Option<&'static str> {
    const PREFIXES: [&str; 13] = ["a", "f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P", "E"];
    let index = usize::try_from(power / 3 + 6).ok()?;
    PREFIXES.get(index).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis, most: usize) -> Vec<String> {
        axis.ticks(most).into_iter().map(|tick| tick.text).collect()
    }

    #[test]
    fn ticks_are_round_and_share_their_decimals_at_every_scale() {
        assert_eq!(texts(&Axis::linear("x", Unit::One, -1.0, 1.0), 5), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(texts(&Axis::linear("x", Unit::One, 0.0, 23.0), 6), ["0", "5", "10", "15", "20"]);
        assert_eq!(texts(&Axis::log("e", Unit::One, 1e-18, 1.0), 6), ["10^{−15}", "10^{−10}", "10^{−5}", "10^{0}"]);
        for power in [-60, -3, 3, 60] {
            let unit = 10f64.powi(power);
            let axis = Axis::linear("a", Unit::Si("m"), -2.0 * unit, 7.0 * unit);
            assert_eq!(texts(&axis, 6), ["−2", "0", "2", "4", "6"], "10^{power}");
        }
    }

    #[test]
    fn the_unit_takes_the_prefix_that_suits_the_range() {
        for (upper, title) in [(3e-9, "a (nm)"), (4e-6, "a (µm)"), (2.0, "a (m)"), (3e-31, "a (10^{−33} m)")] {
            assert_eq!(Axis::linear("a", Unit::Si("m"), 0.0, upper).title(), title);
        }
    }

    #[test]
    fn a_range_without_length_is_widened() {
        for axis in [
            Axis::linear("a", Unit::One, 3.0, 3.0),
            Axis::log("a", Unit::One, 3.0, 3.0),
            Axis::around("a", Unit::One, []),
        ] {
            assert!(axis.range().0 < axis.range().1 && !axis.ticks(5).is_empty(), "{axis:?}");
        }
    }
}
