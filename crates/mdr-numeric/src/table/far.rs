//! What lies far below x, cluster by cluster.
//!
//! Seen from a distance of at least its own width, a cluster of pieces acts like m point charges at Chebyshev nodes: the
//! kernels 1/√(x²−r²) and √(x²−r²) are analytic there, and their interpolants converge like (3+√8)^−m, to rounding. The
//! charges are ∫ ρ(r) ℓⱼ(r) dr for the density ρ, computed exactly for each piece and passed up a binary tree; so g(x)
//! costs O(log rows). As the fast multipole method does (Greengard & Rokhlin 1987), in one dimension.

use mdr_core::number::Special;

use super::hermite::{Piece, Quadratic};
use super::transform::Part;

/// Pieces in a cluster of the lowest level.
const LEAF: usize = 16;
/// Beyond this precision so many charges are needed that all pieces are summed one by one instead.
const WIDEST: u32 = 64;

/// Pieces from `start` to `start + width`, as charges at the nodes of the grid.
#[derive(Clone, Debug)]
pub(super) struct Cluster<R> {
    start: R,
    width: R,
    /// For the density f'.
    slope: Vec<R>,
    /// For the density (r f')'.
    bend: Vec<R>,
}

/// The tree: clusters of 16, 32, 64, … pieces.
#[derive(Clone, Debug)]
pub(super) struct FarField<R> {
    /// The nodes in [0, 1].
    nodes: Vec<R>,
    levels: Vec<Vec<Cluster<R>>>,
}

impl<R: Special> FarField<R> {
    /// None where it would not pay: for small tables and high precision.
    pub(super) fn new(pieces: &[Piece<R>]) -> Option<Self> {
        let like = &pieces[0].width;
        if like.precision() > WIDEST || pieces.len() < 2 * LEAF {
            return None;
        }
        let grid = Grid::new(like);
        let leaf = |chunk: &[Piece<R>]| grid.merge(&chunk.iter().map(|piece| grid.single(piece)).collect::<Vec<_>>());
        let mut levels = vec![pieces.chunks_exact(LEAF).map(leaf).collect::<Vec<_>>()];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            levels.push(level.chunks_exact(2).map(|pair| grid.merge(pair)).collect());
        }
        let nodes = grid.nodes.iter().map(|t| (t.lit(1) + t).over(2)).collect();
        Some(FarField { nodes, levels })
    }

    /// The largest cluster that begins with piece `first`, does not reach piece `whole`, and is far from x, with the
    /// index of the first piece after it.
    pub(super) fn cluster(&self, first: usize, whole: usize, x: &R) -> Option<(&Cluster<R>, usize)> {
        self.levels.iter().enumerate().rev().find_map(|(level, clusters)| {
            let size = LEAF << level;
            let cluster = clusters.get(first / size)?;
            let far = first.is_multiple_of(size) && first + size <= whole && cluster.is_far_from(x);
            far.then_some((cluster, first + size))
        })
    }

    /// The share of a cluster in ∫ ρ dθ, or in ∫ ρ cos²θ dθ.
    pub(super) fn share(&self, cluster: &Cluster<R>, part: Part, x: &R) -> R {
        let charges = if part == Part::Slope { &cluster.bend } else { &cluster.slope };
        let (first, span) = ((x.clone() - &cluster.start) / x, cluster.width.clone() / x);
        let two = x.lit(2);
        let mut sum = x.lit(0);
        for (node, charge) in self.nodes.iter().zip(charges) {
            // cos²θ = (1 − r/x)(1 + r/x)
            let distance = first.clone() - span.clone() * node;
            let cos = ((two.clone() - &distance) * distance).sqrt();
            sum += &if part == Part::Integral { cos * charge } else { charge.clone() / cos };
        }
        sum / x
    }
}

impl<R: Special> Cluster<R> {
    fn is_far_from(&self, x: &R) -> bool {
        x.clone() - &self.start >= self.width.clone().times(2)
    }
}

/// The nodes tⱼ = cos(π(2j+1)/2m) and what belongs to them.
struct Grid<R> {
    nodes: Vec<R>,
    /// T₀ … T_{m−1} at each node.
    polynomials: Vec<Vec<R>>,
    /// ∫₀¹ sᵏ ℓⱼ ds for k = 0, 1, 2, s = (1+t)/2.
    weights: Vec<[R; 3]>,
}

impl<R: Special> Grid<R> {
    fn new(like: &R) -> Self {
        // log₂(3+√8) = 2.543 bits a node.
        let count = 2 + i64::from(like.precision()) * 1000 / 2543;
        let node = |j: i64| (like.pi() * like.ratio(2 * j + 1, 2 * count)).cos();
        let nodes: Vec<R> = (0..count).map(node).collect();
        let polynomials: Vec<Vec<R>> = nodes.iter().map(|t| chebyshev(t, nodes.len())).collect();
        let moments: Vec<[R; 3]> = (0..count).map(|n| moments(like, n)).collect();
        let weight = |values: &Vec<R>| {
            [0, 1, 2].map(|k| lagrange(values, &moments.iter().map(|moment| moment[k].clone()).collect::<Vec<_>>()))
        };
        let weights = polynomials.iter().map(weight).collect();
        Grid { nodes, polynomials, weights }
    }

    /// One piece.
    fn single(&self, piece: &Piece<R>) -> Cluster<R> {
        let charges = |Quadratic([c0, c1, c2]): &Quadratic<R>| {
            let charge = |[w0, w1, w2]: &[R; 3]| (c0.clone() * w0 + c1.clone() * w1 + c2.clone() * w2) * &piece.width;
            self.weights.iter().map(charge).collect()
        };
        let (slope, bend) = (charges(&piece.slope), charges(&piece.bend));
        Cluster { start: piece.start.clone(), width: piece.width.clone(), slope, bend }
    }

    /// Neighbours in one: their charges are passed on so that every polynomial of degree below m is integrated the same.
    fn merge(&self, parts: &[Cluster<R>]) -> Cluster<R> {
        let (first, last) = (&parts[0], &parts[parts.len() - 1]);
        let start = first.start.clone();
        let width = last.start.clone() - &start + &last.width;
        let zero = start.lit(0);
        let mut moments = [vec![zero.clone(); self.nodes.len()], vec![zero; self.nodes.len()]];
        for part in parts {
            let middle = (part.start.clone() - &start).times(2) + &part.width - &width;
            for ((node, slope), bend) in self.nodes.iter().zip(&part.slope).zip(&part.bend) {
                let t = (part.width.clone() * node + &middle) / &width;
                for (k, value) in chebyshev(&t, self.nodes.len()).into_iter().enumerate() {
                    moments[0][k] += &(value.clone() * slope);
                    moments[1][k] += &(value * bend);
                }
            }
        }
        let [slope, bend] =
            moments.map(|moments| self.polynomials.iter().map(|values| lagrange(values, &moments)).collect());
        Cluster { start, width, slope, bend }
    }
}

/// T₀(t), T₁(t), …: `count` of them.
fn chebyshev<R: Special>(t: &R, count: usize) -> Vec<R> {
    let mut values = Vec::with_capacity(count);
    values.extend([t.lit(1), t.clone()]);
    while values.len() < count {
        let [.., before, last] = values.as_slice() else { break };
        let next = (last.clone() * t).times(2) - before;
        values.push(next);
    }
    values
}

/// A functional of ℓⱼ = (T₀(tⱼ)T₀ + 2 Σ Tₖ(tⱼ)Tₖ)/m, from the Tₖ(tⱼ) and its values on the Tₖ.
fn lagrange<R: Special>(values: &[R], moments: &[R]) -> R {
    let terms = values.iter().zip(moments);
    let sum = terms.skip(1).fold(values[0].lit(0), |sum, (value, moment)| sum + value.clone() * moment);
    (sum.times(2) + &moments[0]).over(values.len() as i64)
}

/// ∫₀¹ sᵏ Tₙ(2s − 1) ds for k = 0, 1, 2, from s = (1+T₁)/2, s² = (3 + 4T₁ + T₂)/8 and ∫₋₁¹ Tₙ = 2/(1−n²) for even n.
fn moments<R: Special>(like: &R, n: i64) -> [R; 3] {
    // ∫₀¹ Tₙ(2s−1) ds and with a factor T_k.
    let plain = |n: i64| if n % 2 == 0 { like.ratio(1, 1 - n * n) } else { like.lit(0) };
    let with = |k: i64| (plain(n + k) + plain(n - k)).over(2);
    let [t0, t1, t2] = [with(0), with(1), with(2)];
    let square = (t0.clone().times(3) + t1.clone().times(4) + t2).over(8);
    [t0.clone(), (t0 + t1).over(2), square]
}
