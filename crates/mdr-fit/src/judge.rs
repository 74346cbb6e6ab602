//! The assessment of a minimum: standard errors, combinations that the data do not determine, tests of the residuals.

use nalgebra::{DMatrix, DVector, Dyn, SVD};
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

use super::answer::{Autocorrelation, RunsTest};

/// The fewest residuals of which an order is judged.
const FEWEST: usize = 10;

/// Singular values below this share of the largest are zero: the data say nothing of their direction.
const NULL: f64 = 1e-8;

/// The most iterations of a decomposition: nalgebra sets no limit of its own, and some matrices never end there.
const ITERATIONS: usize = 10_000;

/// The singular values and vectors of a matrix; `None` if an entry is not finite or the iteration does not end.
fn decomposed(matrix: DMatrix<f64>) -> Option<SVD<f64, Dyn, Dyn>> {
    let is_finite = matrix.iter().all(|entry| entry.is_finite());
    is_finite.then(|| SVD::try_new(matrix, true, true, 5.0 * f64::EPSILON, ITERATIONS)).flatten()
}

/// The triangle R of a matrix QR, which has its singular values and its right singular vectors.
fn triangle(matrix: DMatrix<f64>) -> DMatrix<f64> {
    if matrix.nrows() > matrix.ncols() { matrix.qr().unpack_r() } else { matrix }
}

/// The least-squares solution of matrix · solution = right, without the directions whose singular values are at most `least`;
/// `None` if the matrix has no decomposition.
pub(super) fn least_squares(matrix: DMatrix<f64>, right: &DVector<f64>, least: f64) -> Option<DVector<f64>> {
    if matrix.nrows() <= matrix.ncols() {
        return decomposed(matrix)?.solve(right, least).ok();
    }
    let columns = matrix.ncols();
    let decomposition = matrix.qr();
    let mut turned = right.clone();
    decomposition.q_tr_mul(&mut turned);
    decomposed(decomposition.unpack_r())?.solve(&turned.rows(0, columns).into_owned(), least).ok()
}

/// The length of a vector, whose squares may leave the range of doubles.
fn length(vector: &DVector<f64>) -> f64 {
    let largest = vector.amax();
    if largest > 0.0 { largest * (vector / largest).norm() } else { largest }
}

/// The Jacobian by its singular values, with columns of unit length.
pub(super) struct Spectrum {
    /// Lengths of the columns.
    lengths: Vec<f64>,
    /// Descending.
    pub(super) values: Vec<f64>,
    /// The right singular vectors, one a column, in the same order.
    vectors: DMatrix<f64>,
}

impl Spectrum {
    /// Of a Jacobian, whose columns are brought to length one in place.
    pub(super) fn new(jacobian: DMatrix<f64>) -> Self {
        let lengths: Vec<f64> = jacobian.column_iter().map(|column| length(&column.into_owned())).collect();
        let mut scaled = jacobian;
        for (mut column, length) in scaled.column_iter_mut().zip(&lengths) {
            if *length > 0.0 {
                column /= *length;
            }
        }
        let triangle = triangle(scaled);
        let Some(rows) = decomposed(triangle.clone()).and_then(|found| found.v_t) else {
            return Spectrum::of_nothing(lengths.len());
        };
        // Where a column depends on others, the vectors of nalgebra are right, its values in the fifth digit only.
        let values: Vec<f64> = rows.row_iter().map(|vector| (&triangle * vector.transpose()).norm()).collect();
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|one, other| values[*other].total_cmp(&values[*one]));
        let vectors = DMatrix::from_fn(lengths.len(), order.len(), |row, column| rows[(order[column], row)]);
        Spectrum { lengths, values: order.iter().map(|index| values[*index]).collect(), vectors }
    }

    /// Where the Jacobian has no decomposition, the data say nothing of any number.
    fn of_nothing(numbers: usize) -> Self {
        Spectrum {
            lengths: vec![1.0; numbers],
            values: vec![0.0; numbers],
            vectors: DMatrix::identity(numbers, numbers),
        }
    }

    fn is_null(&self, index: usize) -> bool {
        !(self.values[index] > NULL * self.values[0])
    }

    /// How many directions the data say nothing of.
    pub(super) fn nullity(&self) -> usize {
        (0..self.values.len()).filter(|index| self.is_null(*index)).count()
    }

    /// The smallest singular value against the largest.
    pub(super) fn smallest(&self) -> f64 {
        self.values.last().copied().unwrap_or(0.0) / self.values[0]
    }

    /// The covariance of two linear combinations, in units of the variance of a residual; directions that the data do not
    /// determine do not count.
    pub(super) fn covariance(&self, one: &DVector<f64>, other: &DVector<f64>) -> f64 {
        let along = |index: usize, combination: &DVector<f64>| -> f64 {
            let vector = self.vectors.column(index);
            (0..self.lengths.len())
                .map(|place| {
                    let length = self.lengths[place];
                    if length > 0.0 { vector[place] * combination[place] / length } else { 0.0 }
                })
                .sum::<f64>()
                / self.values[index]
        };
        let known = (0..self.values.len()).filter(|index| !self.is_null(*index));
        known.map(|index| along(index, one) * along(index, other)).sum()
    }

    /// Directions of which the data say nothing, one a column of length one, in the fitted values.
    fn unit_directions(&self) -> DMatrix<f64> {
        let null: Vec<usize> = (0..self.values.len()).filter(|index| self.is_null(*index)).collect();
        let longest = self.lengths.iter().copied().fold(0.0, f64::max);
        let mut directions = DMatrix::from_fn(self.lengths.len(), null.len(), |place, column| {
            // A number without any effect is a direction by itself.
            let least = if longest > 0.0 { longest * f64::EPSILON } else { 1.0 };
            let length = if self.lengths[place] > 0.0 { self.lengths[place] } else { least };
            self.vectors[(place, null[column])] / length
        });
        directions.column_iter_mut().for_each(|mut column| column /= column.norm());
        directions
    }

    /// Which numbers the data do not determine: those with a share in a null direction.
    pub(super) fn undetermined(&self) -> Vec<bool> {
        let directions = self.unit_directions();
        (0..self.lengths.len()).map(|place| directions.row(place).iter().any(|share| share.abs() > 1e-5)).collect()
    }

    /// Whether the data determine a number that depends so on the fitted values: it hardly changes along null directions.
    pub(super) fn determines(&self, gradient: &DVector<f64>, value: f64) -> bool {
        self.unit_directions().column_iter().all(|direction| direction.dot(gradient).abs() <= 1e-5 * value.abs())
    }

    /// Exponents of products that the data determine, in reduced form: each of the numbers that stay carries one power of itself
    /// and powers of the last ones, as many as there are null directions. Also the places of those last ones.
    ///
    /// Null directions have noise, by as much as the least direction that the data determine is below the largest: the smallest
    /// share of a number in a direction that counts is raised until all exponents are simple fractions.
    pub(super) fn exponents(&self) -> (Vec<DVector<f64>>, Vec<usize>) {
        const SHARES: [f64; 4] = [1e-5, 1e-4, 1e-3, 1e-2];
        let is_simple = |exponents: &DVector<f64>| exponents.iter().all(|exponent| whole_multiple(*exponent).is_some());
        let found = SHARES.into_iter().map(|least| self.exponents_above(least));
        let simple = found.into_iter().find(|(exponents, _)| exponents.iter().all(is_simple));
        simple.unwrap_or_else(|| self.exponents_above(SHARES[0]))
    }

    /// The exponents where a share of a number in a null direction counts above `least`.
    fn exponents_above(&self, least: f64) -> (Vec<DVector<f64>>, Vec<usize>) {
        let directions = self.unit_directions();
        let (numbers, nullity) = (directions.nrows(), directions.ncols());
        // Eliminate from the last number on: each pivot is a number that would have to be given.
        let mut reduced = directions.clone();
        let mut pivots: Vec<usize> = Vec::new();
        for place in (0..numbers).rev() {
            let done = pivots.len();
            if done == nullity {
                break;
            }
            let column = (done..nullity)
                .max_by(|one, other| reduced[(place, *one)].abs().total_cmp(&reduced[(place, *other)].abs()));
            let Some(column) = column.filter(|column| reduced[(place, *column)].abs() > least) else { continue };
            reduced.swap_columns(done, column);
            let pivot = reduced[(place, done)];
            reduced.column_mut(done).scale_mut(1.0 / pivot);
            for other in (0..nullity).filter(|other| *other != done) {
                let share = reduced[(place, other)];
                let direction = reduced.column(done).clone_owned();
                reduced.column_mut(other).axpy(-share, &direction, 1.0);
            }
            pivots.push(place);
        }
        let stays = (0..numbers).filter(|place| !pivots.contains(place));
        let involved = stays.filter(|place| reduced.row(*place).iter().any(|share| share.abs() > least));
        let exponents = involved.map(|place| {
            let mut exponents = DVector::zeros(numbers);
            exponents[place] = 1.0;
            for (column, pivot) in pivots.iter().enumerate() {
                exponents[*pivot] = simple(-reduced[(place, column)]);
            }
            exponents
        });
        (exponents.collect(), pivots)
    }
}

/// The nearest fraction with a denominator up to four, if it is near.
fn simple(exponent: f64) -> f64 {
    let near = (1..=4).map(f64::from).map(|whole| (exponent * whole).round() / whole);
    near.into_iter().find(|simple| (simple - exponent).abs() < 1e-3).unwrap_or(exponent)
}

/// The smallest number up to four that makes an exponent whole.
fn whole_multiple(exponent: f64) -> Option<i32> {
    (1..=4).find(|whole| (exponent * f64::from(*whole)).fract() == 0.0)
}

/// A product of powers as it is printed.
pub(super) fn product(names: &[&str], exponents: &DVector<f64>) -> String {
    let factor = |(name, exponent): (&&str, &f64)| match *exponent {
        0.0 => None,
        1.0 => Some((*name).to_owned()),
        exponent if exponent.fract() == 0.0 && exponent > 0.0 => Some(format!("{name}^{exponent}")),
        exponent => Some(match whole_multiple(exponent) {
            Some(1) => format!("{name}^({exponent})"),
            Some(whole) => format!("{name}^({}/{whole})", exponent * f64::from(whole)),
            None => format!("{name}^({exponent:.4})"),
        }),
    };
    names.iter().zip(exponents.iter()).filter_map(factor).collect::<Vec<_>>().join(" * ")
}

/// The test of Wald and Wolfowitz; `None` if all residuals have one sign or there are fewer than ten.
pub(super) fn runs_test(residuals: &[f64]) -> Option<RunsTest> {
    let signs: Vec<bool> =
        residuals.iter().filter(|residual| **residual != 0.0).map(|residual| *residual > 0.0).collect();
    let count = signs.len() as f64;
    let above = signs.iter().filter(|sign| **sign).count() as f64;
    let product = 2.0 * above * (count - above);
    if signs.len() < FEWEST || product == 0.0 {
        return None;
    }
    let runs = 1 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let expected = product / count + 1.0;
    let variance = product * (product - count) / (count * count * (count - 1.0));
    let z = (runs as f64 - expected) / variance.sqrt();
    let p = 2.0 * Normal::standard().sf(z.abs());
    (variance > 0.0).then_some(RunsTest { runs, expected, z, p })
}

/// The correlation of residuals within each of these legs; `None` of fewer than ten rows, or of none that differ from the curve.
pub(super) fn autocorrelation(legs: &[&[f64]], dof: usize) -> Option<Autocorrelation> {
    let count: usize = legs.iter().map(|leg| leg.len()).sum();
    let power: f64 = legs.iter().copied().flatten().map(|residual| residual * residual).sum();
    if count < FEWEST || !(power > 0.0 && power.is_finite()) {
        return None;
    }
    let at = |lag: usize| {
        let products = |leg: &&[f64]| leg.iter().zip(leg.iter().skip(lag)).map(|(one, other)| one * other).sum::<f64>();
        legs.iter().map(products).sum::<f64>() / power
    };
    let lag_one = at(1);
    // Of white noise it has the variance 1/n, and a mean of about −1 per number that was fitted.
    let fitted = count.saturating_sub(dof) as f64;
    let z = (lag_one + fitted / count as f64) * (count as f64).sqrt();
    let correlations = (1..count / 4).map(at).take_while(|correlation| *correlation > 0.0);
    let widening = (1.0 + 2.0 * correlations.sum::<f64>()).sqrt();
    Some(Autocorrelation { lag_one, z, p: Normal::standard().sf(z), widening })
}

/// The probability of at least this χ².
pub(super) fn chi2_p(chi2: f64, dof: usize) -> Option<f64> {
    ChiSquared::new(dof as f64).ok().map(|distribution| if chi2.is_finite() { distribution.sf(chi2) } else { 0.0 })
}

/// The smallest and the largest of numbers; without numbers, infinities in the wrong order.
pub(super) fn extent(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// The median; NaN of nothing.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => f64::NAN,
        len if len % 2 == 1 => values[len / 2],
        len => 0.5 * (values[len / 2 - 1] + values[len / 2]),
    }
}

#[cfg(test)]
#[path = "../tests/private/judge.rs"]
mod tests;
