//! Linear equations over intervals.

use mdr_core::number::{Interval, Real};

/// The midpoints of the entries.
pub(super) fn points(values: &[Interval]) -> Vec<Interval> {
    values.iter().map(|value| Interval::point(value.mid())).collect()
}

pub(super) fn midpoints(matrix: &[Vec<Interval>]) -> Vec<Vec<Interval>> {
    matrix.iter().map(|row| points(row)).collect()
}

/// The inverse by columns; `None` if a pivot may vanish.
pub(super) fn inverse(matrix: Vec<Vec<Interval>>) -> Option<Vec<Vec<Interval>>> {
    let entry = |row, column| matrix[0][0].lit(i64::from(row == column));
    let unit = (0..matrix.len()).map(|row| (0..matrix.len()).map(|column| entry(row, column)).collect()).collect();
    solve(matrix, unit)
}

/// Solves matrix · z = right for each right-hand side, by elimination with pivots; `None` if a pivot may vanish.
pub(super) fn solve(mut matrix: Vec<Vec<Interval>>, mut right: Vec<Vec<Interval>>) -> Option<Vec<Vec<Interval>>> {
    let count = matrix.len();
    for place in 0..count {
        let size = |row: &usize| matrix[*row][place].abs().approx();
        let pivot = (place..count).max_by(|one, other| size(one).total_cmp(&size(other)))?;
        matrix.swap(place, pivot);
        right.iter_mut().for_each(|right| right.swap(place, pivot));
        if matrix[place][place].contains_zero() || !matrix[place][place].is_finite() {
            return None;
        }
        for row in (0..count).filter(|row| *row != place) {
            let factor = matrix[row][place].clone() / &matrix[place][place];
            let pivot = matrix[place].clone();
            for (entry, pivot) in matrix[row].iter_mut().zip(&pivot).skip(place) {
                *entry -= &(factor.clone() * pivot);
            }
            for right in &mut right {
                let change = factor.clone() * &right[place];
                right[row] -= &change;
            }
        }
    }
    for right in &mut right {
        for place in 0..count {
            right[place] = right[place].clone() / &matrix[place][place];
        }
    }
    Some(right)
}

/// Whether every symmetric matrix within these entries is positive definite: the pivots of its elimination are all positive. `false` proves
/// nothing.
pub(super) fn is_positive_definite(mut matrix: Vec<Vec<Interval>>) -> bool {
    for place in 0..matrix.len() {
        let pivot = matrix[place].clone();
        let is_positive = pivot[place].is_finite() && *pivot[place].lower() > 0;
        if !is_positive {
            return false;
        }
        for row in &mut matrix[place + 1..] {
            let factor = row[place].clone() / &pivot[place];
            for (entry, pivot) in row.iter_mut().zip(&pivot).skip(place) {
                *entry -= &(factor.clone() * pivot);
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::number::Precision;

    #[test]
    fn positive_definite_or_not_proved() {
        let matrix = |entries: [[f64; 2]; 2]| {
            let entry = |value: &f64| Interval::from_f64(Precision::new(80), *value);
            entries.iter().map(|row| row.iter().map(entry).collect()).collect::<Vec<Vec<_>>>()
        };
        assert!(is_positive_definite(matrix([[2.0, 1.0], [1.0, 2.0]])));
        // A saddle, a maximum, and a valley.
        for other in [[[1.0, 2.0], [2.0, 1.0]], [[-2.0, 1.0], [1.0, -2.0]], [[1.0, 1.0], [1.0, 1.0]]] {
            assert!(!is_positive_definite(matrix(other)));
        }
    }
}
