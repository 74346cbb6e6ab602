//! The rows of a long record, in pieces on all cores.

use mdr_core::contact::Result;
use rayon::prelude::*;

/// How many rows a piece has. Of one piece no other core is asked.
pub(super) const PIECE: usize = 1024;

/// Works on all pieces; what is done does not depend on how many cores do it.
///
/// # Errors
/// That of the first piece that has one.
pub(super) fn in_pieces<T: Send>(
    pieces: impl IntoIterator<Item = T>,
    work: impl Fn((usize, T)) -> Result<()> + Sync,
) -> Result<()> {
    let pieces: Vec<(usize, T)> = pieces.into_iter().enumerate().collect();
    if pieces.len() <= 1 {
        return pieces.into_iter().try_for_each(work);
    }
    pieces.into_par_iter().map(&work).collect::<Vec<_>>().into_iter().collect()
}

/// The first rows of all columns of a matrix, cut into pieces: of each piece the part of every column.
pub(super) fn columns(matrix: &mut [f64], length: usize, rows: usize) -> Vec<Vec<&mut [f64]>> {
    let mut pieces: Vec<Vec<&mut [f64]>> = Vec::new();
    pieces.resize_with(rows.div_ceil(PIECE), Vec::new);
    for column in matrix.chunks_mut(length.max(1)) {
        for (piece, part) in pieces.iter_mut().zip(column[..rows].chunks_mut(PIECE)) {
            piece.push(part);
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::contact::Error;

    #[test]
    fn pieces_are_those_of_all_rows() {
        let (rows, length) = (2 * PIECE + 3, 2 * PIECE + 5);
        let mut matrix = vec![0.0; 3 * length];
        in_pieces(columns(&mut matrix, length, rows), |(index, piece)| {
            for (column, part) in piece.into_iter().enumerate() {
                part.iter_mut().enumerate().for_each(|(row, at)| *at = (column * length + index * PIECE + row) as f64);
            }
            Ok(())
        })
        .unwrap();
        let expected = |place: usize| if place % length < rows { place as f64 } else { 0.0 };
        assert!(matrix.iter().enumerate().all(|(place, at)| *at == expected(place)));
    }

    #[test]
    fn the_first_error_is_told() {
        let failed = |(index, ()): (usize, ())| match index {
            0 | 3 => Ok(()),
            _ => Err(Error::BudgetSpent { evaluations: index as u64 }),
        };
        let error = in_pieces((0..9).map(|_| ()), failed).unwrap_err();
        assert!(matches!(error, Error::BudgetSpent { evaluations: 1 }), "{error}");
    }
}
