//! Measured rows: whether what is computed of them is proved.

#[cfg(feature = "mp")]
use mdr_core::number::Literal;

use crate::scene::Scene;

/// Up to this many rows what is computed of a table is proved, and within the budget also the folds of rough ones: the cost grows with the
/// rows and with the folds.
#[cfg(feature = "mp")]
pub(crate) const PROVED_ROWS: usize = 1000;
/// The relative distance of two radii that are taken for one.
#[cfg(feature = "mp")]
const AT_ROW: f64 = 1e-12;

impl Scene {
    /// The rows of a table, or of those in a sum, where their transform is measured exactly: on a half-space.
    pub(crate) fn exact_rows(&self) -> Option<usize> {
        self.profile.rows().filter(|_| self.medium.is_half_space())
    }

    /// Whether it has so few rows of a table that what is printed of them is proved.
    #[cfg(feature = "mp")]
    pub(crate) fn is_short_table(&self) -> bool {
        self.exact_rows().is_some_and(|rows| rows <= PROVED_ROWS)
    }

    /// Whether the transform of the profile on the medium is enclosed, also that of tables of not too many rows.
    #[cfg(feature = "mp")]
    pub(crate) fn has_proofs(&self) -> bool {
        self.is_closed() || self.is_enclosed() || self.is_short_table()
    }

    /// Whether g at these radii is enclosed: it is not where a radius cannot be told from that of a row of a table.
    #[cfg(feature = "mp")]
    pub(crate) fn encloses_at(&self, radii: &[Literal]) -> bool {
        let rows = self.profile.tables().into_iter().flat_map(|measured| measured.table.rows());
        let rows: Vec<f64> = rows.map(|row| row.radius.nearest_f64()).collect();
        let is_at_row = |radius: f64| rows.iter().any(|row| (row - radius).abs() <= AT_ROW * radius);
        self.has_proofs() && !radii.iter().any(|radius| is_at_row(radius.nearest_f64()))
    }
}
