//! Checks that heights are measured from the tip, outward.

use super::{Table, TableColumn, TableError};

/// The relative agreement of extrapolations through two, three and four rows that locates the tip.
const AGREEMENT: f64 = 0.02;

impl Table {
    /// Checks that the rows extrapolate to f(0) = 0. Without a row at the axis they certainly do not if the first
    /// height is steeper above the tip than twice the steepest of the next rows, or if even polynomials through the
    /// first two, three and four rows meet the axis at one height, which is a considerable fraction of the first.
    ///
    /// # Errors
    /// [`TableError::TipNotZero`], [`TableError::TipElsewhere`].
    pub fn check_tip(&self) -> Result<(), TableError> {
        let (first, points) = (&self.rows[0], self.points());
        let (line, height) = (first.line, self.written(TableColumn::Height, &first.height.to_string()));
        if first.radius.is_zero() {
            return if first.height.is_zero() { Ok(()) } else { Err(TableError::TipNotZero { line, height }) };
        }
        let [two, three, four] = [2, 3, 4].map(|rows| at_axis(&points[..rows]));
        let (r, f) = points[0];
        let slope = |pair: &[(f64, f64)]| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs();
        let steepest = points[..4].windows(2).map(slope).fold(0.0, f64::max);
        let agree = |other: f64| (other - two).abs() <= AGREEMENT * two.abs();
        let elsewhere = two.abs() > 0.1 * f.abs() && agree(three) && agree(four);
        if f.abs() / r > 2.0 * steepest || elsewhere {
            let radius = self.written(TableColumn::Radius, &first.radius.to_string());
            let tip = self.written(TableColumn::Height, &format!("{two:.4e}"));
            return Err(TableError::TipElsewhere { line, height, radius, tip });
        }
        Ok(())
    }

    /// Whether heights fall outward from the tip: the last is the lowest, and the highest is not a tenth as far above
    /// the tip.
    pub fn falls_outward(&self) -> bool {
        let heights = || self.points().into_iter().map(|(_, f)| f);
        let [highest, lowest] = [heights().fold(0.0, f64::max), heights().fold(0.0, f64::min)];
        heights().next_back() == Some(lowest) && highest < -0.1 * lowest
    }
}

/// The value at r = 0 of the even polynomial through the points.
fn at_axis(points: &[(f64, f64)]) -> f64 {
    let weight = |r: f64| {
        let others = points.iter().filter(|(s, _)| *s != r);
        others.map(|(s, _)| 1.0 / (1.0 - (r / s).powi(2))).product::<f64>()
    };
    points.iter().map(|(r, f)| weight(*r) * f).sum()
}
