//! Smoothing: local regression of the heights, over a stated length.

use mdr_core::number::Literal;

use super::{Table, TableError, TableRow};

/// The least number of rows in reach at each radius, with their mirror images: two more than the coefficients of a
/// parabola.
const SEEN: usize = 5;
/// The reach of the weights, in lengths: half of the total weight lies within one length.
const REACH: f64 = 4.0;

impl Table {
    /// The profile by local regression of rows with noise (Cleveland 1979; related to the second order Gaussian
    /// regression of ISO 16610): at each radius the parabola of the least weighted squares, with the weights (1 −
    /// (Δr/4ℓ)²)³ for ℓ = `length`, which are one half at 1.8ℓ. Rows are mirrored to −r, since a profile is even.
    /// Parabolas are reproduced exactly, waves of 11ℓ to 2 %; waves of 4.2ℓ are halved, and independent errors are
    /// reduced to √(0.39 Δr/ℓ).
    ///
    /// Heights are measured from the tip of the result, whose height among the rows is returned as well. They are exact
    /// numbers: the shortest decimals of the computed doubles.
    ///
    /// # Errors
    /// [`TableError::Smoothing`]: a length beyond the last radius, or one that leaves fewer than five rows in reach
    /// somewhere; heights out of the range of `f64`.
    pub fn smoothed(&self, length: f64) -> Result<(Table, f64), TableError> {
        let points = self.points();
        let end = points.last().map_or(0.0, |(r, _)| *r);
        let refuse = |why: String| TableError::Smoothing { length, why };
        if !(length <= end) {
            return Err(refuse(format!("it must be shorter than the profile, which ends at {end:e}")));
        }
        let images = points.iter().rev().filter(|(r, _)| *r > 0.0).map(|(r, f)| (-r, *f));
        let even: Vec<(f64, f64)> = images.chain(points.iter().copied()).collect();
        let least = shortest(&even, &points) / REACH;
        if !(length > least) {
            return Err(refuse(format!(
                "it must be longer than {least:.3e}, so that {SEEN} rows are in reach everywhere"
            )));
        }
        let tip = regression(&even, 0.0, length);
        let mut rows = Vec::with_capacity(points.len() + 1);
        for (row, (r, _)) in self.rows.iter().zip(points) {
            let height = regression(&even, r, length) - tip;
            let height =
                Literal::try_from(height).map_err(|_| refuse("its heights are out of range of f64".to_owned()))?;
            rows.push(TableRow { height, ..row.clone() });
        }
        Ok((Table { rows, units: self.units.clone() }, tip))
    }
}

/// The smallest distance in which every point, and the tip, has enough others.
fn shortest(even: &[(f64, f64)], points: &[(f64, f64)]) -> f64 {
    let radii = std::iter::once(0.0).chain(points.iter().map(|(r, _)| *r));
    let needed = radii.map(|x| {
        // Of this number of neighbours in a row the farther end decides the distance.
        even.windows(SEEN).map(|seen| (x - seen[0].0).max(seen[SEEN - 1].0 - x)).fold(f64::MAX, f64::min)
    });
    needed.fold(0.0, f64::max)
}

/// The value at `x` of the weighted parabola, in polynomials that are orthogonal over the rows in reach.
fn regression(even: &[(f64, f64)], x: f64, length: f64) -> f64 {
    let reach = REACH * length;
    let first = even.partition_point(|(r, _)| *r <= x - reach);
    let last = even.partition_point(|(r, _)| *r < x + reach);
    let seen = even[first..last].iter().map(|(r, f)| {
        let u = (r - x) / reach;
        ((1.0 - u * u).powi(3), u, *f)
    });
    let sum = |term: &dyn Fn(f64, f64, f64) -> f64| seen.clone().map(|(w, u, f)| term(w, u, f)).sum::<f64>();
    let weight = sum(&|w, _, _| w);
    let mean = sum(&|w, u, _| w * u) / weight;
    let line = |u: f64| u - mean;
    let spread = sum(&|w, u, _| w * line(u).powi(2));
    let skew = sum(&|w, u, _| w * line(u).powi(3)) / spread;
    let parabola = |u: f64| line(u) * (line(u) - skew) - spread / weight;
    let bend = sum(&|w, u, _| w * parabola(u).powi(2));
    sum(&|w, _, f| w * f) / weight
        + sum(&|w, u, f| w * line(u) * f) / spread * line(0.0)
        + sum(&|w, u, f| w * parabola(u) * f) / bend * parabola(0.0)
}
