//! Roughness: the scatter of the rows of a table, and its effect on the slope of g.

use super::Table;

/// The number of neighbours that predict a height, two on each side.
const NEIGHBOURS: usize = 4;
/// The number of rows in a window.
const WINDOW: usize = 11;
/// The least fraction of sign changes among neighbouring residuals that counts as scatter: 0.79 is expected for noise,
/// and 2/m for a wave with m rows per wavelength.
const ALTERNATION: f64 = 0.6;

/// The lower quartile of the magnitude of a normal deviate.
const QUARTILE: f64 = 0.3186;

/// The scatter of the rows of a table, by row.
#[derive(Clone, Debug)]
pub struct Scatter {
    radii: Vec<f64>,
    scatter: Vec<f64>,
}

impl Table {
    /// The scatter of heights about the cubics through two neighbours on each side, as a standard deviation of each
    /// height: within a factor of two of that of independent errors; for rounded heights 0.3 of the last digit, and up
    /// to 1.5 if they form a staircase.
    ///
    /// Residuals of a profile that the rows resolve keep their sign from row to row, and count as zero; those of noise
    /// nearly always change it. At a kink up to four are large and may change it: the lower quartile is that of the
    /// others.
    pub fn scatter(&self) -> Scatter {
        let points = self.points();
        let images = points.iter().skip(1).take(2).rev().map(|(r, f)| (-r, *f));
        let even: Vec<(f64, f64)> = match points.first() {
            Some((0.0, _)) => images.chain(points.iter().copied()).collect(),
            _ => points.clone(),
        };
        let missing = points.len() + 2 - even.len();
        let residuals: Vec<f64> = even.windows(NEIGHBOURS + 1).map(residual).collect();
        let of_row = |row: usize| {
            let centre = row.saturating_sub(missing);
            let first = centre.saturating_sub(WINDOW / 2).min(residuals.len().saturating_sub(WINDOW));
            alternating(&residuals[first..residuals.len().min(first + WINDOW)])
        };
        let scatter = (0..points.len()).map(of_row).collect();
        Scatter { radii: points.into_iter().map(|(r, _)| r).collect(), scatter }
    }
}

impl Scatter {
    /// The standard deviation at each row; 0 where the rows resolve the profile.
    pub fn of_rows(&self) -> &[f64] {
        &self.scatter
    }

    /// The row before the radius `x`.
    pub fn row_before(&self, x: f64) -> usize {
        self.radii.partition_point(|r| *r < x).saturating_sub(1)
    }

    /// The resulting standard deviation of g'(x), √12 σ√x/h^{3/2} for rows at a distance h: f'' of the interpolant
    /// scatters by √6 σ/h², and in g' = ∫ (f' + r f'') dθ the last piece has the angle √(2h/x).
    pub fn of_slope(&self, x: f64) -> f64 {
        let row = self.row_before(x);
        let last = self.radii.len() - 1;
        let (from, to) = (row.saturating_sub(1), (row + 2).min(last));
        let spacing = (self.radii[to] - self.radii[from]) / (to - from) as f64;
        let sigma = self.scatter[row].max(self.scatter[(row + 1).min(last)]);
        12f64.sqrt() * (sigma / spacing) * (x / spacing).sqrt()
    }
}

/// The height of the middle of five points minus that of the cubic through the others, over the root of the sum of the
/// squares of its weights.
fn residual(points: &[(f64, f64)]) -> f64 {
    let (x, height) = points[NEIGHBOURS / 2];
    let others = || points.iter().enumerate().filter(|(i, _)| *i != NEIGHBOURS / 2).map(|(_, point)| *point);
    let weight = |r: f64| others().filter(|(s, _)| *s != r).map(|(s, _)| (x - s) / (r - s)).product::<f64>();
    let (sum, squares) = others().fold((height, 1.0), |(sum, squares), (r, f)| {
        let weight = weight(r);
        (sum - weight * f, squares + weight * weight)
    });
    sum / f64::sqrt(squares)
}

/// The scatter of residuals, if they alternate.
fn alternating(residuals: &[f64]) -> f64 {
    let present: Vec<f64> = residuals.iter().copied().filter(|e| *e != 0.0).collect();
    let changes = present.windows(2).filter(|pair| (pair[0] < 0.0) != (pair[1] < 0.0)).count();
    if present.len() <= WINDOW / 2 || (changes as f64) < ALTERNATION * (present.len() - 1) as f64 {
        return 0.0;
    }
    let mut sizes: Vec<f64> = present.iter().map(|e| e.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes[sizes.len() / 4] / QUARTILE * (present.len() as f64 / residuals.len() as f64).sqrt()
}
