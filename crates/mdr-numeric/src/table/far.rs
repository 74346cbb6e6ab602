//! The contribution of pieces far below x, cluster by cluster.
//!
//! At a distance of at least its own width, a cluster of pieces acts like m point charges at Chebyshev nodes: the
//! kernels 1/√(x²−r²) and √(x²−r²) are analytic there, and their interpolants converge like (3+√8)^−m, to rounding. The
//! charges are ∫ ρ(r) ℓⱼ(r) dr for the density ρ, computed exactly for each piece and passed up a binary tree; so g(x)
//! costs O(log rows). On other media the kernels are other powers of x² − r². This is the fast multipole method
//! (Greengard & Rokhlin 1987) in one dimension.

use std::array::from_fn;
use std::sync::Arc;

use mdr_core::calculus::gauss_jacobi::{self, GaussRule};
use mdr_core::contact::Result;
use mdr_core::number::Special;

use super::hermite::Piece;
use super::transform::Part;

/// Pieces in a cluster of the lowest level.
const LEAF: usize = 8;
/// Above this precision the number of charges is so large that all pieces are summed one by one instead.
const WIDEST: u32 = 64;

/// Pieces from `start` to `start + width`, as charges at the nodes of the grid.
#[derive(Clone, Debug)]
pub(super) struct Cluster<R, const D: usize = 2> {
    start: R,
    width: R,
    /// For each density.
    charges: [Vec<R>; D],
}

/// The tree of some densities: clusters of 8, 16, 32, … pieces.
#[derive(Clone, Debug)]
pub(super) struct FarField<R, const D: usize = 2> {
    /// The nodes in [0, 1].
    nodes: Vec<R>,
    levels: Vec<Vec<Cluster<R, D>>>,
}

impl<R: Special> FarField<R> {
    /// Of the densities f' and (r f')' on a half-space: see [`FarField::of`].
    pub(super) fn new(pieces: &[Piece<R>]) -> Result<Option<Self>> {
        FarField::of(pieces, 2, |piece, t| [piece.slope.at(t), piece.bend.at(t)])
    }

    /// The contribution of a cluster to ∫ ρ dθ, or to ∫ ρ cos²θ dθ.
    pub(super) fn share(&self, cluster: &Cluster<R>, part: Part, x: &R) -> R {
        let two = x.lit(2);
        // cos²θ = (1 − r/x)(1 + r/x)
        self.weighted(cluster, usize::from(part == Part::Slope), x, |distance| {
            let cos = ((two.clone() - &distance) * distance).sqrt();
            if part == Part::Integral { cos } else { cos.inv() }
        })
    }
}

impl<R: Special, const D: usize> FarField<R, D> {
    /// Of densities that are polynomials of such a degree on each piece. `None` if it does not pay, for small tables and high precision,
    /// and over enclosures, which would have to include the interpolation error.
    pub(super) fn of(
        pieces: &[Piece<R>],
        degree: usize,
        densities: impl Fn(&Piece<R>, &R) -> [R; D],
    ) -> Result<Option<Self>> {
        let like = &pieces[0].width;
        let encloses = like.clone().inflate(like) != *like;
        if encloses || like.precision() > WIDEST || pieces.len() < 2 * LEAF {
            return Ok(None);
        }
        let grid = Grid::new(like, degree)?;
        let mut levels = vec![pieces.chunks_exact(LEAF).map(|chunk| grid.leaf(chunk, &densities)).collect::<Vec<_>>()];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let (pairs, _) = level.as_chunks::<2>();
            levels.push(pairs.iter().map(|pair| grid.pair(pair)).collect());
        }
        let nodes = grid.nodes.iter().map(|t| (t.lit(1) + t).over(2)).collect();
        Ok(Some(FarField { nodes, levels }))
    }

    /// The largest cluster that begins with piece `first`, does not reach piece `whole`, and is far from x, with the
    /// index of the first piece after it.
    pub(super) fn cluster(&self, first: usize, whole: usize, x: &R) -> Option<(&Cluster<R, D>, usize)> {
        self.levels.iter().enumerate().rev().find_map(|(level, clusters)| {
            let size = LEAF << level;
            let cluster = clusters.get(first / size)?;
            let far = first.is_multiple_of(size) && first + size <= whole && cluster.is_far_from(x);
            far.then_some((cluster, first + size))
        })
    }

    /// How many nodes a cluster has.
    pub(super) fn nodes(&self) -> usize {
        self.nodes.len()
    }

    /// The contribution of a cluster to ∫ ρ K dr/x for one of the densities and a kernel of 1 − r/x.
    pub(super) fn weighted(&self, cluster: &Cluster<R, D>, density: usize, x: &R, kernel: impl Fn(R) -> R) -> R {
        let (first, span) = ((x.clone() - &cluster.start) / x, cluster.width.clone() / x);
        let mut sum = x.lit(0);
        for (node, charge) in self.nodes.iter().zip(&cluster.charges[density]) {
            sum += &(kernel(first.clone() - span.clone() * node) * charge);
        }
        sum / x
    }
}

impl<R: Special, const D: usize> Cluster<R, D> {
    fn is_far_from(&self, x: &R) -> bool {
        x.clone() - &self.start >= self.width.clone().times(2)
    }
}

/// The nodes and weights of clusters.
struct Grid<R> {
    /// The Chebyshev nodes tⱼ = cos(π(2j+1)/2m).
    nodes: Vec<R>,
    /// Their barycentric weights, (−1)ʲ sin(π(2j+1)/2m).
    weights: Vec<R>,
    /// Exact for the density of a piece times ℓⱼ.
    gauss: Arc<GaussRule<R>>,
}

impl<R: Special> Grid<R> {
    fn new(like: &R, degree: usize) -> Result<Self> {
        // log₂(3+√8) = 2.543 bits per node.
        let count = 3 + i64::from(like.precision()) * 1000 / 2543;
        let angles = (0..count).map(|j| like.pi() * like.ratio(2 * j + 1, 2 * count));
        let nodes: Vec<R> = angles.clone().map(|angle| angle.cos()).collect();
        let weights = angles.zip([1, -1].into_iter().cycle()).map(|(angle, sign)| angle.sin().times(sign)).collect();
        let gauss = gauss_jacobi::rule((nodes.len() + degree).div_ceil(2), &like.lit(0), &like.lit(0))?;
        Ok(Grid { nodes, weights, gauss })
    }

    /// The cluster of neighbouring pieces.
    fn leaf<const D: usize>(&self, pieces: &[Piece<R>], densities: impl Fn(&Piece<R>, &R) -> [R; D]) -> Cluster<R, D> {
        let last = &pieces[pieces.len() - 1];
        let mut cluster = self.empty(&pieces[0].start, &last.start, &last.width);
        for piece in pieces {
            for node in self.gauss.nodes() {
                let charges = densities(piece, &node.t).map(|density| density * &node.weight * &piece.width);
                let offset = piece.width.clone() * &node.t;
                self.add(&mut cluster, &piece.start, offset, charges);
            }
        }
        cluster
    }

    /// The union of two neighbouring clusters, from their charges.
    fn pair<const D: usize>(&self, [left, right]: &[Cluster<R, D>; 2]) -> Cluster<R, D> {
        let mut cluster = self.empty(&left.start, &right.start, &right.width);
        for part in [left, right] {
            for (index, node) in self.nodes.iter().enumerate() {
                let offset = (node.lit(1) + node).over(2) * &part.width;
                let charges = from_fn(|density| part.charges[density][index].clone());
                self.add(&mut cluster, &part.start, offset, charges);
            }
        }
        cluster
    }

    /// A cluster without charges up to `last + last_width`.
    fn empty<const D: usize>(&self, start: &R, last: &R, last_width: &R) -> Cluster<R, D> {
        let width = last.clone() - start + last_width;
        Cluster { start: start.clone(), width, charges: from_fn(|_| vec![start.lit(0); self.nodes.len()]) }
    }

    /// Replaces charges at `origin + offset` by their shares ℓⱼ at the nodes, by the barycentric formula.
    fn add<const D: usize>(&self, cluster: &mut Cluster<R, D>, origin: &R, offset: R, charges: [R; D]) {
        let t = (origin.clone() - &cluster.start + offset).times(2) / &cluster.width - origin.lit(1);
        let mut shares: Vec<R> =
            self.nodes.iter().zip(&self.weights).map(|(node, weight)| weight.clone() / (t.clone() - node)).collect();
        let mut total = shares.iter().fold(t.lit(0), |sum, share| sum + share);
        if let Some(hit) = self.nodes.iter().position(|node| *node == t) {
            shares.iter_mut().for_each(|share| *share = t.lit(0));
            shares[hit] = t.lit(1);
            total = t.lit(1);
        }
        for (charge, targets) in charges.into_iter().zip(&mut cluster.charges) {
            let charge = charge / &total;
            for (share, target) in shares.iter().zip(targets) {
                *target += &(charge.clone() * share);
            }
        }
    }
}

#[cfg(test)]
#[path = "../../tests/private/far.rs"]
mod tests;
