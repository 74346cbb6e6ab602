//! The transforms of the interpolant on graded half-spaces, Winkler foundations and in line contact, piece by piece.
//!
//! With y = 1 − (r/x)², and α = (k − 1)/2 on a half-space graded as zᵏ, J\[φ\] = ∫₀ˣ φ(r) (r/x) y^α dr/x; in line contact the integrals
//! are ∫₀ˣ φ(r) y^(−1/2) dr/x. On a Winkler foundation g = f, and its mean is that of a graded half-space with k = 1. Each
//! [φ](Density) is a polynomial between two rows, whose integral over the piece is a sum over one Gauss rule:
//!
//! * over r, where x is at least a third of the width of the piece beyond its end;
//! * over y with the weight y^α, from r to x, where r is at least x/2 and φ is continued beyond its piece: the integral over a piece
//!   that ends nearer to x is a difference of two such;
//! * up to x/2 again over r, if the piece begins below it.
//!
//! In each the integrand is analytic inside an ellipse whose sum of half-axes is three times the half-length, but for a reference of the
//! depth that is nearer than that, where the integral is [that of any profile](Weighted). Pieces that are far from x act [as
//! clusters](super::far).

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::gauss_jacobi::{self, GaussRule};
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::Special;

use super::MeasuredProfile;
use super::far::FarField;
use super::hermite::Piece;
use crate::transform::Weighted;
use crate::transform::weight::{Density, Weight, factor_of_mean};

/// log₂ of what a node adds to the accuracy of a rule, 3², in thousandths.
const BITS_PER_NODE: i64 = 3169;

/// The degree of each φ on a piece: (r f')' is of the second in r, times r² at most.
const DEGREE: usize = 4;

/// A measured profile on a half-space graded as zᵏ or a Winkler foundation, or the N of a [`LineLoad`](crate::transform::LineLoad),
/// with an error of some roundings. In f64 the cost of a radius grows with the logarithm of the rows.
///
/// ```
/// use mdr_core::contact::Transform;
/// use mdr_numeric::table::Table;
/// let table = Table::from_csv("r,f\n0,0\n1,0.5\n2,2\n3,4.5\n".as_bytes())?;
/// let graded = table.profile::<f64>(())?.graded(0.3)?;
/// // The rows are those of r²/2, and so is the profile between them: x²/(1 + k).
/// assert!((graded.g(&1.5)? / (2.25 / 1.3) - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct MeasuredOnMedium<R: Special> {
    pieces: Vec<Piece<R>>,
    alpha: R,
    /// Over r, and over y.
    rules: [Arc<GaussRule<R>>; 2],
    far: Option<FarField<R, 4>>,
    /// The transform of any profile, which knows the medium.
    any: Weighted<R, MeasuredProfile<R>>,
    /// Nodes of rules and clusters so far.
    nodes: Arc<AtomicU64>,
}

/// So many nodes take about the time of a height of a quadrature, by which work is counted.
const NODES_PER_HEIGHT: u64 = 8;

impl<R: Special> MeasuredProfile<R> {
    /// On a half-space graded as zᵏ, with k within (−1, 1).
    ///
    /// # Errors
    /// k out of its domain.
    pub fn graded(self, k: R) -> Result<MeasuredOnMedium<R>> {
        MeasuredOnMedium::new(self.pieces.clone(), Weighted::graded(self, k))
    }

    /// On a Winkler foundation.
    ///
    /// # Errors
    /// [`Error::NoConvergence`] where a rule cannot be computed, which is not met.
    pub fn winkler(self) -> Result<MeasuredOnMedium<R>> {
        let like = self.end.clone();
        MeasuredOnMedium::new(self.pieces.clone(), Weighted::winkler(self, like))
    }

    /// In line contact, as the N of a [`LineLoad`](crate::transform::LineLoad), with its mean against a reference at this distance.
    ///
    /// # Errors
    /// [`Error::NoConvergence`] where a rule cannot be computed, which is not met.
    pub fn line(self, reference: Option<R>) -> Result<MeasuredOnMedium<R>> {
        let like = self.end.clone();
        MeasuredOnMedium::new(self.pieces.clone(), Weighted::line(self, reference, like))
    }
}

impl<R: Special> MeasuredOnMedium<R> {
    fn new(pieces: Vec<Piece<R>>, any: Weighted<R, MeasuredProfile<R>>) -> Result<Self> {
        let one = any.order().lit(1);
        let alpha = match any.weight() {
            Weight::Graded(k) => (k.clone() - &one).over(2),
            Weight::Winkler => one.lit(0),
            Weight::HalfSpace | Weight::Line(_) => one.ratio(-1, 2),
        };
        let (zero, bits) = (one.lit(0), i64::from(one.precision()));
        let nodes = (bits * 1000 / BITS_PER_NODE) as usize + 4;
        let rules = [gauss_jacobi::rule(nodes, &zero, &zero)?, gauss_jacobi::rule(nodes, &zero, &alpha)?];
        let all = [Density::Height, Density::Rise, Density::Transform, Density::Slope];
        let far = FarField::of(&pieces, DEGREE, |piece, t| all.map(|density| value(density, piece, t, &any)))?;
        Ok(MeasuredOnMedium { pieces, alpha, rules, far, any, nodes: Arc::default() })
    }

    /// J\[φ\], or the integral of a line contact.
    fn integral(&self, density: Density, x: &R) -> Result<R> {
        self.any.check(x)?;
        let whole = self.pieces.partition_point(|piece| piece.start < *x) - 1;
        let kernel = Kernel { medium: self, density, x };
        let (mut sum, mut next) = (x.lit(0), 0);
        while next < whole {
            match self.far.as_ref().and_then(|far| Some((far, far.cluster(next, whole, x)?))) {
                Some((far, (cluster, after))) => {
                    self.count(far.nodes());
                    sum += &far.weighted(cluster, density as usize, x, |distance| kernel.at(distance));
                    next = after;
                }
                None => {
                    sum += &kernel.piece(&self.pieces[next]);
                    next += 1;
                }
            }
        }
        let last = &self.pieces[whole];
        let sum = sum + kernel.up_to_x(last, &last.start);
        if sum.is_finite() {
            return Ok(sum);
        }
        let log10 = sum.approx().abs().log10();
        Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 })
    }

    fn count(&self, nodes: usize) {
        self.nodes.fetch_add(nodes as u64, Ordering::Relaxed);
    }

    /// Whether the reference is so near to a radius that its pole may be within an ellipse of a rule over y, (L/x)² − 1 below a quarter.
    fn is_near_reference(&self, x: &R) -> bool {
        matches!(self.any.weight(), Weight::Line(Some(reference)) if reference.clone().times(8) < x.clone().times(9))
    }
}

/// φ at t within a piece.
fn value<R: Special, P: Profile<R>>(density: Density, piece: &Piece<R>, t: &R, medium: &Weighted<R, P>) -> R {
    let r = || piece.start.clone() + piece.width.clone() * t;
    match (density, medium.weight()) {
        (Density::Height, _) => piece.height_at(t),
        (Density::Rise, _) | (Density::Transform, Weight::Line(_)) => piece.slope.at(t) * r(),
        (Density::Transform, _) => piece.height_at(t) * medium.order() + piece.slope.at(t) * r(),
        (Density::Slope, Weight::Line(_)) => piece.bend.at(t) * r(),
        (Density::Slope, _) => (piece.slope.at(t) * medium.order() + piece.bend.at(t)) * r(),
    }
}

/// What φ is integrated with up to a radius.
struct Kernel<'a, R: Special> {
    medium: &'a MeasuredOnMedium<R>,
    density: Density,
    x: &'a R,
}

impl<R: Special> Kernel<'_, R> {
    /// The kernel at 1 − r/x.
    fn at(&self, distance: R) -> R {
        let y = (distance.lit(2) - &distance) * &distance;
        let share = || distance.lit(1) - &distance;
        // Away from x logarithms are small, and with them what is lost of their exponential; a power takes five times as long.
        match self.medium.any.weight() {
            Weight::Winkler => share(),
            Weight::Line(_) => (y.sqrt() * self.room(&y)).inv(),
            _ => (y.ln() * &self.medium.alpha).exp() * share(),
        }
    }

    /// 1 − (r/L)² of the mean against a reference, else 1.
    fn room(&self, y: &R) -> R {
        match self.medium.any.weight() {
            Weight::Line(Some(reference)) if self.density == Density::Height => {
                let share = (self.x.clone() / reference).square();
                y.lit(1) - share * (y.lit(1) - y)
            }
            _ => y.lit(1),
        }
    }

    fn value(&self, piece: &Piece<R>, t: &R) -> R {
        value(self.density, piece, t, &self.medium.any)
    }

    /// Over a piece that ends before x.
    fn piece(&self, piece: &Piece<R>) -> R {
        let end = piece.start.clone() + &piece.width;
        let room = self.x.clone() - &end;
        if room.times(3) >= piece.width {
            return self.over_radii(piece, &piece.width);
        }
        self.up_to_x(piece, &piece.start) - self.up_to_x(piece, &end)
    }

    /// From the start of a piece over such a length, over r.
    fn over_radii(&self, piece: &Piece<R>, length: &R) -> R {
        let [rule, _] = &self.medium.rules;
        self.medium.count(rule.nodes().len());
        let (first, span) = ((self.x.clone() - &piece.start) / self.x, length.clone() / self.x);
        let part = length.clone() / &piece.width;
        let mut sum = self.x.lit(0);
        for node in rule.nodes() {
            let kernel = self.at(first.clone() - span.clone() * &node.t);
            sum += &(self.value(piece, &(part.clone() * &node.t)) * kernel * &node.weight);
        }
        sum * span
    }

    /// From a radius to x, with the polynomial of a piece.
    fn up_to_x(&self, piece: &Piece<R>, from: &R) -> R {
        let half = self.x.clone().over(2);
        if *from < half {
            return self.over_radii(piece, &(half.clone() - from)) + self.up_to_x(piece, &half);
        }
        let [_, rule] = &self.medium.rules;
        self.medium.count(rule.nodes().len());
        let distance = (self.x.clone() - from) / self.x;
        let most = (distance.lit(2) - &distance) * &distance;
        let beyond = self.x.clone() - &piece.start;
        let is_line = matches!(self.medium.any.weight(), Weight::Line(_));
        let mut sum = self.x.lit(0);
        for node in rule.nodes() {
            let y = most.clone() * &node.t;
            let share = (y.lit(1) - &y).sqrt();
            // x − r = x y/(1 + r/x)
            let t = (beyond.clone() - y.clone() / (share.lit(1) + &share) * self.x) / &piece.width;
            let value = self.value(piece, &t) / self.room(&y) * &node.weight;
            sum += &(if is_line { value / share } else { value });
        }
        let power = if is_line { most.sqrt() } else { most.pow(&self.medium.alpha) * most };
        (sum * power).over(2)
    }
}

/// Exact up to rounding.
impl<R: Special> Transform<R> for MeasuredOnMedium<R> {
    fn g(&self, x: &R) -> Result<R> {
        if let Weight::Winkler = self.any.weight() {
            return self.any.g(x);
        }
        self.integral(Density::Transform, x)
    }

    fn slope(&self, x: &R) -> Result<R> {
        if let Weight::Winkler = self.any.weight() {
            return self.any.slope(x);
        }
        Ok(self.integral(Density::Slope, x)? / x)
    }

    fn integral(&self, x: &R) -> Result<R> {
        Ok(self.mean(x)? * x)
    }

    fn mean(&self, x: &R) -> Result<R> {
        if self.is_near_reference(x) {
            return self.any.mean(x);
        }
        match self.any.weight() {
            Weight::Line(None) => Ok(x.lit(0)),
            Weight::Line(Some(reference)) => Ok(self.integral(Density::Height, x)? * factor_of_mean(x, reference)),
            _ => Ok(self.integral(Density::Height, x)? * self.any.order()),
        }
    }

    fn above_mean(&self, x: &R) -> Result<R> {
        self.integral(Density::Rise, x)
    }

    fn outer_radius(&self) -> Option<R> {
        self.any.outer_radius()
    }

    fn kinks(&self) -> Vec<R> {
        self.any.kinks()
    }

    fn work(&self) -> u64 {
        self.any.work() + self.nodes.load(Ordering::Relaxed) / NODES_PER_HEIGHT
    }
}
