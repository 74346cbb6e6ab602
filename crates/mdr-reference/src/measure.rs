//! Measures of the difficulty of a question, computed from the records.

use crate::catalogue::records;
use crate::decimal::Decimal;
use crate::record::Record;

impl Record {
    /// The largest |log₁₀| of the inputs and the value, zeros excluded.
    ///
    /// ```
    /// let tip = mdr_reference::record("critical/afm-tip/force/force").expect("a record");
    /// assert_eq!(tip.decades().floor(), 10.0, "E* = 7·10¹⁰ Pa");
    /// ```
    pub fn decades(&self) -> f64 {
        let inputs = self.inputs.iter().filter_map(|(_, text)| text.parse().ok());
        let sizes = inputs.chain(self.decimal()).filter(|value: &Decimal| !value.is_zero());
        sizes.map(|value| value.log10().abs()).fold(0.0, f64::max)
    }

    /// The relative distance |q/q* − 1| of the controlled quantity q of a question about equilibria of a power law from
    /// its critical value q*, 0 at the fold itself; `None` for other questions. q* is the certified value of the
    /// critical state of the same contact, itself a record.
    ///
    /// ```
    /// let near = mdr_reference::record("equilibrium/jkr-unit/near=2^-12/outer/indentation/contact_radius");
    /// let distance = near.and_then(|record| record.fold_distance()).expect("a question about an equilibrium");
    /// assert!((distance * 4096.0 - 1.0).abs() < 1e-9);
    /// ```
    pub fn fold_distance(&self) -> Option<f64> {
        if let Some(tau) = self.input("tau") {
            return tau.parse().ok();
        }
        let (held, quantity) = match self.control.as_deref()? {
            "indentation" => ("d", "indentation"),
            "force" => ("F", "force"),
            _ => return None,
        };
        let value: Decimal = self.input(held)?.parse().ok()?;
        let critical = records().iter().find(|record| {
            record.formula == "critical"
                && record.quantity == quantity
                && record.control == self.control
                && record.inputs.iter().all(|(name, text)| self.input(name) == Some(text))
        })?;
        let critical = critical.decimal()?;
        Some(10_f64.powf((&value - &critical).abs().log10() - critical.log10()))
    }
}
