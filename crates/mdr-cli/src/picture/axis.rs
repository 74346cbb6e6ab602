//! Axes: which quantity, over which range, in which unit, with which ticks.

use plotters::coord::ranged1d::Ranged;

/// What a quantity is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    /// A ratio.
    One,
    /// An SI unit, which takes the prefix that makes the numbers of the axis legible.
    Si(&'static str),
}

/// Equal distances are equal differences or equal ratios.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scale {
    Linear,
    Log,
}

/// One axis of a diagram.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// With the markup of [`super::typeset`].
    pub(crate) quantity: String,
    unit: Unit,
    scale: Scale,
    lower: f64,
    upper: f64,
}

/// A tick: where, and the number beside it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// From 0 at the lower end of the axis to 1.
    pub(crate) fraction: f64,
    /// With the markup of [`super::typeset`].
    pub(crate) text: String,
}

impl Axis {
    /// An axis from `lower` to `upper` with equal differences; a range without length is widened.
    pub(crate) fn linear(quantity: impl Into<String>, unit: Unit, lower: f64, upper: f64) -> Self {
        let half = if upper > lower {
            0.0
        } else if lower == 0.0 {
            1.0
        } else {
            lower.abs() / 10.0
        };
        Axis { quantity: quantity.into(), unit, scale: Scale::Linear, lower: lower - half, upper: upper + half }
    }

    /// An axis from `lower` > 0 to `upper` with equal ratios.
    pub(crate) fn log(quantity: impl Into<String>, unit: Unit, lower: f64, upper: f64) -> Self {
        let factor = if upper > lower { 1.0 } else { 10.0 };
        Axis { quantity: quantity.into(), unit, scale: Scale::Log, lower: lower / factor, upper: upper * factor }
    }

    /// A linear axis that shows all of `values`, with a margin, and zero where `zero` asks for it.
    pub(crate) fn around(
        quantity: impl Into<String>,
        unit: Unit,
        values: impl IntoIterator<Item = f64>,
        zero: bool,
    ) -> Self {
        let start = if zero { (0.0, 0.0) } else { (f64::INFINITY, f64::NEG_INFINITY) };
        let finite = values.into_iter().filter(|value| value.is_finite());
        let (lower, upper) = finite.fold(start, |(lower, upper), value| (value.min(lower), value.max(upper)));
        let margin = 0.1 * (upper - lower);
        if lower > upper {
            Self::linear(quantity, unit, 0.0, 1.0)
        } else {
            Self::linear(quantity, unit, lower - margin, upper + margin)
        }
    }

    /// The lower and the upper end.
    pub(crate) fn range(&self) -> (f64, f64) {
        (self.lower, self.upper)
    }

    /// The value at a fraction of the axis.
    pub(crate) fn at(&self, fraction: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.lower + fraction * (self.upper - self.lower),
            Scale::Log => self.lower * (self.upper / self.lower).powf(fraction),
        }
    }

    /// Where on the axis a value is: 0 at the lower end, 1 at the upper.
    pub(crate) fn fraction(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.lower) / (self.upper - self.lower),
            Scale::Log => (value / self.lower).ln() / (self.upper / self.lower).ln(),
        }
    }

    /// Quantity and unit, for the side of the axis.
    pub(crate) fn title(&self) -> String {
        match self.scaled_unit() {
            (_, unit) if unit.is_empty() => self.quantity.clone(),
            (_, unit) => format!("{} ({unit})", self.quantity),
        }
    }

    /// The power of ten that the numbers of the axis are multiples of, and the unit that has it as its prefix.
    pub(crate) fn scaled_unit(&self) -> (i32, String) {
        let power = self.power();
        let ten = format!("10^{{{}}}", typographic(&power.to_string()));
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

    /// Quantity and base unit in plain letters, for a table.
    pub(crate) fn column(&self) -> (String, &'static str) {
        let unit = match self.unit {
            Unit::One => "1",
            Unit::Si(unit) => unit,
        };
        (super::typeset::plain(&self.quantity), unit)
    }

    /// The power of ten, a multiple of three, that the numbers at the ticks are to be multiplied with.
    fn power(&self) -> i32 {
        let largest = self.lower.abs().max(self.upper.abs());
        let thousands = (largest.log10() / 3.0).floor();
        match self.scale {
            Scale::Log => 0,
            Scale::Linear if self.unit == Unit::One && (0.01..1e4).contains(&largest) => 0,
            // A largest number of 1.2 is better told as 1200 of the next smaller unit only when ticks would need it.
            Scale::Linear => 3 * thousands as i32,
        }
    }

    /// At most `most` ticks at round numbers.
    pub(crate) fn ticks(&self, most: usize) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => self.linear_ticks(most),
            Scale::Log => self.decades(most),
        }
    }

    fn linear_ticks(&self, most: usize) -> Vec<Tick> {
        let unit = 10f64.powi(self.power());
        let points = round_numbers(self.lower / unit, self.upper / unit, most);
        let step = points.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let decimals = if step.is_finite() { (-(step * 1.001).log10().floor()).clamp(0.0, 9.0) as usize } else { 0 };
        let tick = |value: f64| {
            let text = format!("{value:.decimals$}");
            // No sign for a zero.
            let text = if text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.')) {
                text.trim_start_matches('-').to_owned()
            } else {
                text
            };
            Tick { fraction: self.fraction(value * unit), text: typographic(&text) }
        };
        points.into_iter().map(tick).filter(|tick| (-1e-9..=1.0 + 1e-9).contains(&tick.fraction)).collect()
    }

    fn decades(&self, most: usize) -> Vec<Tick> {
        let (lower, upper) = (self.lower.log10(), self.upper.log10());
        let exponents = round_numbers(lower, upper, most);
        let tick = |exponent: f64| Tick {
            fraction: (exponent - lower) / (upper - lower),
            text: format!("10^{{{}}}", typographic(&exponent.to_string())),
        };
        exponents.into_iter().filter(|exponent| exponent.fract() == 0.0).map(tick).collect()
    }
}

/// Round numbers from `lower` to `upper`, equally spaced.
fn round_numbers(lower: f64, upper: f64, most: usize) -> Vec<f64> {
    let coordinate: plotters::coord::types::RangedCoordf64 = (lower..upper).into();
    coordinate.key_points(most)
}

/// With a minus sign instead of a hyphen.
pub(crate) fn typographic(number: &str) -> String {
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
    fn ticks_are_round_and_share_their_decimals() {
        assert_eq!(texts(&Axis::linear("x", Unit::One, -1.0, 1.0), 5), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(texts(&Axis::linear("x", Unit::One, 0.0, 23.0), 6), ["0", "5", "10", "15", "20"]);
    }

    #[test]
    fn the_unit_takes_the_prefix_that_suits_the_range() {
        for (upper, title, first) in [
            (3e-9, "a (nm)", "3"),
            (2.5e-7, "a (nm)", "200"),
            (4e-6, "a (µm)", "4"),
            (0.09, "a (mm)", "80"),
            (2.0, "a (m)", "2.0"),
            (3e-31, "a (10^{−33} m)", "300"),
        ] {
            let axis = Axis::linear("a", Unit::Si("m"), 0.0, upper);
            assert_eq!(axis.title(), title);
            assert_eq!(texts(&axis, 6).last().unwrap(), first, "{title}");
        }
    }

    #[test]
    fn the_same_ticks_at_every_scale() {
        for power in [-60, -3, 3, 60] {
            let unit = 10f64.powi(power);
            let axis = Axis::linear("a", Unit::Si("m"), -2.0 * unit, 7.0 * unit);
            assert_eq!(texts(&axis, 6), ["−2", "0", "2", "4", "6"], "10^{power}");
        }
    }

    #[test]
    fn decades() {
        assert_eq!(texts(&Axis::log("e", Unit::One, 1e-18, 1.0), 7), ["10^{−15}", "10^{−10}", "10^{−5}", "10^{0}"]);
    }

    #[test]
    fn a_range_without_length_is_widened() {
        let axis = Axis::around("a", Unit::One, [3.0], false);
        assert!(axis.range().0 < 3.0 && axis.range().1 > 3.0);
        assert!(!axis.ticks(5).is_empty());
        assert_eq!(Axis::around("a", Unit::One, [], false).range(), (0.0, 1.0));
    }
}
