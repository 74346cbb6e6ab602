//! The contribution of pieces far below x as a power series: over enclosures, and with more bits than a double.
//!
//! In squares of radii u = r², with v = (u − u₀)/(x² − u₀) and aₖ = C(2k, k)/4ᵏ, the kernels are
//! 1/√(x² − u) = Σ aₖ vᵏ/√(x² − u₀) and √(x² − u) = √(x² − u₀) Σ aₖ vᵏ/(1 − 2k). For pieces from r₀ to r₁ the terms fall like
//! qᵏ, q = (r₁² − r₀²)/(x² − r₀²), and what is left after K of them is at most qᴷ/(1 − q) of the variation of f, by which an
//! enclosure is widened. The moments of vᵏ are those of wᵏ, w = (u − u₀)/(u₁ − u₀), times qᵏ. They are sums of positive products
//! for each piece, and pass up a binary tree, so that g(x) costs O(log rows) as [in doubles](super::far).

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use mdr_core::number::Real;

use super::hermite::{Piece, Quadratic};
use super::transform::Part;

/// Pieces in a cluster of the lowest level.
const LEAF: usize = 8;
/// The least distance of x from the start of a cluster, in its widths: q is below its inverse.
const FAR: i64 = 3;
/// log₂ of it, rounded down.
const BITS_PER_TERM: f64 = 1.58;
/// Above this precision the moments, whose number squared is the cost of a cluster, do not pay.
const WIDEST: u32 = 512;
/// Operations for the share of one piece, about.
const COST_OF_PIECE: usize = 130;

/// Pieces from `start` to `start + width`.
#[derive(Clone, Debug)]
struct Cluster<R> {
    start: R,
    width: R,
    /// r₁² − r₀².
    span: R,
    /// aₖ ∫ ρ wᵏ dr for the density ρ = f', and all between −∫ |ρ| dr and ∫ |ρ| dr.
    slope: (Vec<R>, R),
    /// For the density (r f')'.
    bend: (Vec<R>, R),
}

/// The tree: clusters of 8, 16, 32, … pieces.
#[derive(Clone, Debug)]
pub(super) struct Tree<R> {
    levels: Vec<Vec<Cluster<R>>>,
}

/// A tree that is built when as much work was done without it.
#[derive(Debug)]
pub(super) struct Series<R> {
    tree: OnceLock<Tree<R>>,
    evaluations: AtomicUsize,
}

impl<R> Default for Series<R> {
    fn default() -> Self {
        Series { tree: OnceLock::new(), evaluations: AtomicUsize::new(0) }
    }
}

impl<R: Clone> Clone for Series<R> {
    fn clone(&self) -> Self {
        Series { tree: self.tree.clone(), evaluations: AtomicUsize::new(self.evaluations.load(Ordering::Relaxed)) }
    }
}

impl<R: Real> Series<R> {
    /// The tree, once there have been so many evaluations that it pays.
    pub(super) fn tree(&self, pieces: &[Piece<R>]) -> Option<&Tree<R>> {
        if let Some(tree) = self.tree.get() {
            return Some(tree);
        }
        let bits = pieces[0].width.precision();
        if bits > WIDEST || pieces.len() < (FAR as usize + 1) * LEAF {
            return None;
        }
        let terms = terms(bits, BITS_PER_TERM);
        let before = self.evaluations.fetch_add(1, Ordering::Relaxed);
        (before * COST_OF_PIECE > terms * terms).then(|| self.tree.get_or_init(|| Tree::new(pieces, terms)))
    }
}

/// The number of terms to a relative accuracy of 2^−bits, with some bits to spare, if each adds `per_term`.
fn terms(bits: u32, per_term: f64) -> usize {
    (f64::from(bits + 6) / per_term).ceil() as usize
}

/// The relative accuracy, in bits, that a result for an enclosure x can have: that of its width, with some bits to spare.
pub(super) fn bits_of<R: Real>(x: &R) -> u32 {
    let spread = (x.clone() - x.midpoint()).abs().approx() / x.approx();
    let wide = 12.0 - spread.log2();
    if wide < f64::from(x.precision()) { wide.max(4.0) as u32 } else { x.precision() }
}

impl<R: Real> Tree<R> {
    fn new(pieces: &[Piece<R>], terms: usize) -> Self {
        let mut levels = vec![pieces.chunks_exact(LEAF).map(|chunk| leaf(chunk, terms)).collect::<Vec<_>>()];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            let (pairs, _) = level.as_chunks::<2>();
            levels.push(pairs.iter().map(pair).collect());
        }
        for cluster in levels.iter_mut().flatten() {
            weight(&mut cluster.slope.0);
            weight(&mut cluster.bend.0);
        }
        Tree { levels }
    }

    /// The share of the largest cluster that begins with piece `first`, does not reach piece `whole`, and is far from x, with the
    /// index of the first piece after it; to `bits` of relative accuracy.
    pub(super) fn share(&self, part: Part, x: &R, bits: u32, first: usize, whole: usize) -> Option<(R, usize)> {
        self.levels.iter().enumerate().rev().find_map(|(level, clusters)| {
            let size = LEAF << level;
            let cluster = clusters.get(first / size)?;
            let far = first.is_multiple_of(size) && first + size <= whole && cluster.is_far_from(x);
            far.then(|| (cluster.share(part, x, bits), first + size))
        })
    }
}

impl<R: Real> Cluster<R> {
    fn is_far_from(&self, x: &R) -> bool {
        x.clone() - &self.start >= self.width.clone().times(FAR)
    }

    /// The contribution to ∫ ρ dθ, or to ∫ ρ cos²θ dθ.
    fn share(&self, part: Part, x: &R, bits: u32) -> R {
        let (moments, size) = if part == Part::Slope { &self.bend } else { &self.slope };
        let squared = (x.clone() - &self.start) * (x.clone() + &self.start);
        let q = self.span.clone() / &squared;
        let terms = terms(bits, BITS_PER_TERM.max(-q.approx().log2())).clamp(1, moments.len());
        let mut sum = x.lit(0);
        for (k, moment) in moments.iter().enumerate().take(terms).rev() {
            sum *= &q;
            if part == Part::Integral {
                sum += &moment.clone().over(1 - 2 * k as i64);
            } else {
                sum += moment;
            }
        }
        let rest = q.powi(terms as i64) * size / (q.lit(1) - &q);
        let sum = sum.inflate_with_slope(&rest);
        let root = squared.sqrt();
        if part == Part::Integral { sum * root / x.square() } else { sum / root }
    }
}

/// r₁² − r₀².
fn span<R: Real>(start: &R, width: &R) -> R {
    (start.clone().times(2) + width) * width
}

/// The moments ∫ ρ wᵏ dr of neighbouring pieces.
fn leaf<R: Real>(pieces: &[Piece<R>], terms: usize) -> Cluster<R> {
    let (start, last) = (pieces[0].start.clone(), &pieces[pieces.len() - 1]);
    let width = last.start.clone() - &start + &last.width;
    let none = || (vec![start.lit(0); 2 * terms - 1], start.lit(0));
    let (mut slope, mut bend) = (none(), none());
    for piece in pieces {
        let from = (piece.start.clone() - &start) / &width;
        let to = (piece.start.clone() - &start + &piece.width) / &width;
        let [slopes, bends] = [&piece.slope, &piece.bend].map(|density| ends(density, &piece.width));
        for (total, values) in [(&mut slope.1, &slopes), (&mut bend.1, &bends)] {
            // On both sides of zero, with slopes on both sides as well, also where the value is zero.
            values.iter().for_each(|value| *total += &start.lit(0).inflate_with_slope(value).over(3));
        }
        let targets = slope.0.iter_mut().zip(&mut bend.0);
        for ((k, products), (slope, bend)) in (0..).zip(symmetric(from, to)).zip(targets) {
            for (target, values) in [(slope, &slopes), (bend, &bends)] {
                let terms = values.iter().zip(&products).map(|(value, product)| product.clone() * value);
                let sum = terms.reduce(|sum, term| sum + term).unwrap_or_else(|| start.lit(0));
                *target += &sum.times(2).over((k + 1) * (k + 2) * (k + 3));
            }
        }
    }
    let whole = start.clone().times(2) + &width;
    let shares = [width.clone() / &whole, start.clone().times(2) / whole];
    let [slope, bend] = [slope, bend].map(|(moments, size)| (of_squares(moments, &shares), size));
    Cluster { span: span(&start, &width), start, width, slope, bend }
}

/// Coefficients of (1 − s)², 2 s (1 − s) and s² of a density, times the width of its piece.
fn ends<R: Real>(Quadratic([c0, c1, c2]): &Quadratic<R>, width: &R) -> [R; 3] {
    [c0.clone(), c1.clone().over(2) + c0, c0.clone() + c1 + c2].map(|value| value * width)
}

/// The complete homogeneous symmetric polynomials hₖ(α, α, α, β), hₖ(α, α, β, β), hₖ(α, β, β, β) for k = 0, 1, …: with
/// y = α + (β − α) s, ∫₀¹ sⁱ (1 − s)ʲ yᵏ ds = i! j! k!/(k + i + j + 1)! hₖ(α, …, β, …), where α occurs j + 1 times and β i + 1
/// times (Hermite–Genocchi). Recurrences in positive terms.
fn symmetric<R: Real>(alpha: R, beta: R) -> impl Iterator<Item = [R; 3]> {
    let one = alpha.lit(1);
    let none = || one.lit(0);
    // αᵏ, h(α, β), h(α, α, β), h(α, β, β).
    let [mut power, mut pair, mut more_alpha, mut more_beta] = [one.clone(), none(), none(), none()];
    let mut last = [none(), none(), none()];
    let mut begun = false;
    std::iter::from_fn(move || {
        if std::mem::replace(&mut begun, true) {
            power *= &alpha;
        }
        let raise = |number: &mut R, by: &R, with: &R| {
            *number *= by;
            *number += with;
        };
        raise(&mut pair, &beta, &power);
        raise(&mut more_alpha, &alpha, &pair);
        raise(&mut more_beta, &beta, &pair);
        raise(&mut last[0], &alpha, &more_alpha);
        raise(&mut last[1], &beta, &more_alpha);
        raise(&mut last[2], &beta, &more_beta);
        Some(last.clone())
    })
}

/// The moments of w = y (σ y + 1 − σ) from those of y = (r − r₀)/(r₁ − r₀), with σ and 1 − σ given.
fn of_squares<R: Real>(mut moments: Vec<R>, [square, line]: &[R; 2]) -> Vec<R> {
    let mut found = Vec::with_capacity(moments.len() / 2 + 1);
    loop {
        found.push(moments[0].clone());
        let Some(left) = moments.len().checked_sub(2).filter(|left| *left > 0) else { return found };
        for i in 0..left {
            let (here, above) = moments.split_at_mut(i + 1);
            here[i] = above[1].clone() * square;
            here[i] += &(above[0].clone() * line);
        }
        moments.truncate(left);
    }
}

/// The moments of α w + β from those of w.
fn shifted<R: Real>(mut moments: Vec<R>, alpha: &R, beta: &R) -> Vec<R> {
    let mut found = Vec::with_capacity(moments.len());
    while !moments.is_empty() {
        found.push(moments[0].clone());
        for i in 1..moments.len() {
            let (here, above) = moments.split_at_mut(i);
            here[i - 1] *= beta;
            here[i - 1] += &(above[0].clone() * alpha);
        }
        moments.pop();
    }
    found
}

/// The union of two neighbouring clusters.
fn pair<R: Real>([left, right]: &[Cluster<R>; 2]) -> Cluster<R> {
    let width = right.start.clone() - &left.start + &right.width;
    let span = span(&left.start, &width);
    let [inner, outer] = [left, right].map(|part| part.span.clone() / &span);
    let offset = (right.start.clone() - &left.start) * (right.start.clone() + &left.start) / &span;
    let joined = |(left, left_size): &(Vec<R>, R), (right, right_size): &(Vec<R>, R)| {
        let mut moments = shifted(right.clone(), &outer, &offset);
        let mut power = span.lit(1);
        for (moment, left) in moments.iter_mut().zip(left) {
            *moment += &(left.clone() * &power);
            power *= &inner;
        }
        (moments, left_size.clone() + right_size)
    };
    let (slope, bend) = (joined(&left.slope, &right.slope), joined(&left.bend, &right.bend));
    Cluster { start: left.start.clone(), width, span, slope, bend }
}

/// Times aₖ = C(2k, k)/4ᵏ.
fn weight<R: Real>(moments: &mut [R]) {
    let mut factor = moments[0].lit(1);
    for (k, moment) in (1..).zip(moments) {
        *moment *= &factor;
        factor = factor.times(2 * k - 1).over(2 * k);
    }
}

#[cfg(all(test, feature = "mp"))]
#[path = "../../tests/private/series.rs"]
mod tests;
