//! Integrals of a formula up to a radius c, from heights that are [kept](super::store): of h = f − α − βr² with the kernels of the mean of g, of
//! g and of its derivatives, in doubles or in many bits.
//!
//! Cells are halved until they are as far from x as they are long, and until the remainder of their rule is small.

use mdr_core::calculus::enclose::{BOUND_BITS, DOUBLE_BITS};
use mdr_core::calculus::panel::LegendrePanel;
use mdr_core::number::{Analytic, DoubleInterval, Ends, Interval, Precision, Real};
use rug::Float;

use super::Order;
use super::span::relative_width;
use super::store::{Cell, DEEPEST, Place, Rule, Store, panel};

/// Cells that an integral may look at in doubles,
const MOST: usize = 600;
/// and in many bits.
const MOST_FINE: usize = 300;

/// The remainder of a cell is below this share of the relative width of x,
const BELOW_WIDTH: f64 = 1.0 / 64.0;
/// and need not be below this share of the sum, in doubles,
const LEAST: f64 = 1e-15;
/// or below so many units in the last of its bits.
const UNITS: i32 = 4;

/// The parabola α + βr² that is taken from f.
pub(super) struct Parabola {
    pub(super) height: Interval,
    pub(super) bend: Interval,
}

/// What is integrated beside h, with s = x² − r²: r/(x√s) in the mean of g, −x r s^(−3/2) in g, x r (2s + 3r²) s^(−5/2) in x g', and
/// −x³ r (6s + 15r²) s^(−7/2) in x²g''.
struct Kernel<'a> {
    x: &'a Interval,
    order: Order,
}

impl Kernel<'_> {
    fn times<T: Analytic>(&self, height: &T, r: &T) -> Option<Vec<T>> {
        self.at(height, r, &r.constant(self.x))
    }

    fn at<T: Analytic>(&self, height: &T, r: &T, x: &T) -> Option<Vec<T>> {
        let s = x.minus(r).product(&x.plus(r));
        let root = s.sqrt()?;
        if self.order == Order::Value {
            let mean = height.product(r).quotient(&x.product(&root))?;
            let g = mean.product(&x.squared()).quotient(&s)?.negated();
            let above = g.minus(&mean);
            return Some(vec![mean, g, above]);
        }
        let square = r.squared();
        let share = height.product(r).product(x).quotient(&s.squared().product(&root))?;
        let with = |of_s: i64, of_square: i64| s.multiplied(of_s).plus(&square.multiplied(of_square));
        let mut values = vec![share.product(&with(2, 3))];
        if self.order == Order::Curvature {
            values.push(share.product(&x.squared()).quotient(&s)?.product(&with(-6, -15)));
        }
        Some(values)
    }
}

/// The integrals over the radii up to c of f − α − βr², and those of the parabola, in so many bits: in doubles if they reach. `None` where they
/// take too many cells.
pub(super) fn integrals(
    store: &Store,
    x: &Interval,
    order: Order,
    c: &Float,
    parabola: &Parabola,
    bits: u32,
) -> Option<Vec<Interval>> {
    let of_width = BELOW_WIDTH * relative_width(x).to_f64();
    let kernel = Kernel { x, order };
    if bits <= DOUBLE_BITS {
        let aim = of_width.max(LEAST);
        let sums = Inside::<DoubleInterval>::up_to(c, store, kernel, parabola, ((), aim))?;
        return Some(sums.iter().map(|sum| wide(sum).rounded(x.ctx())).collect());
    }
    let aim = of_width.max(2_f64.powi(UNITS - bits as i32));
    Inside::<Interval>::up_to(c, store, kernel, parabola, (Precision::new(bits), aim))
}

/// An integral up to c that is being added up.
struct Inside<'a, I: Ends> {
    store: &'a Store,
    c: &'a Float,
    kernel: Kernel<'a>,
    parabola: &'a Parabola,
    /// x, in doubles and as the sums have it.
    in_doubles: DoubleInterval,
    x: I,
    /// The remainder that a cell may have, as a share of the sum.
    aim: f64,
    sums: Vec<I>,
    deepest: i32,
    looked_at: usize,
}

impl<'a, I: Ends> Inside<'a, I> {
    /// The sums over [0, c].
    fn up_to(
        c: &'a Float,
        store: &'a Store,
        kernel: Kernel<'a>,
        parabola: &'a Parabola,
        (ctx, aim): (I::Ctx, f64),
    ) -> Option<Vec<I>> {
        let all = Place { exponent: kernel.x.lower().get_exp()?, index: 0 };
        let x = I::around(ctx, kernel.x);
        let sums = parabola.integrals(&x, kernel.order);
        let (in_doubles, deepest) = (DoubleInterval::around(kernel.x), all.exponent - DEEPEST);
        let mut inside = Inside { store, c, kernel, parabola, in_doubles, x, aim, sums, deepest, looked_at: 0 };
        inside.add(all)?;
        Some(inside.sums)
    }

    /// Adds the cell at a place, or what of it lies below c.
    fn add(&mut self, place: Place) -> Option<()> {
        let [lower, upper] = place.ends();
        if lower >= *self.c {
            return Some(());
        }
        self.looked_at += 1;
        let most = if self.x.precision() <= DOUBLE_BITS { MOST } else { MOST_FINE };
        if self.looked_at > most || place.exponent < self.deepest {
            return None;
        }
        let apart = Float::with_val(BOUND_BITS, self.kernel.x.lower() - &upper);
        if upper <= *self.c && apart >= Float::with_val(BOUND_BITS, &upper - &lower) {
            let cell = self.store.cell(place)?;
            let panel = panel(place, self.x.precision())?;
            if let Some(shares) = self.by_rule(place, &cell, &panel).or_else(|| self.by_range(&cell, &panel)) {
                self.sums.iter_mut().zip(shares).for_each(|(sum, share)| *sum += &share);
                return Some(());
            }
        }
        // What is largest comes first.
        place.halves().into_iter().rev().try_for_each(|half| self.add(half))
    }

    /// By the rule of the cell, where its remainder is small.
    fn by_rule(&self, place: Place, cell: &Cell, panel: &LegendrePanel) -> Option<Vec<I>> {
        let image = cell.image.as_ref()?;
        let r = panel.ellipse();
        let images = self.kernel.times(&image.minus(&self.parabola.at(&r)), &r)?;
        let remainders = images.iter().map(|image| panel.remainder(image)).collect::<Option<Vec<_>>>()?;
        let within = |shares: &[I]| {
            let all = remainders.iter().zip(shares).zip(&self.sums);
            all.into_iter().all(|((remainder, share), sum)| {
                remainder.upper() <= self.allowed(sum).max(self.allowed(share)).max(radius(share))
            })
        };
        let shares = self.shares(&*self.store.rule(place, panel, self.x.precision())?)?;
        within(&shares).then(|| {
            let with_remainder =
                |(share, remainder): (I, &DoubleInterval)| share.inflate(&I::around(self.x.ctx(), &wide(remainder)));
            shares.into_iter().zip(&remainders).map(with_remainder).collect()
        })
    }

    /// The sums of a rule.
    fn shares(&self, rule: &Rule) -> Option<Vec<I>> {
        self.store.count(rule.len() as u64 * <I as Ends>::WORK.div_ceil(4));
        let ctx = self.x.ctx();
        let mut shares = vec![self.x.lit(0); self.sums.len()];
        for (node, height) in rule {
            let above = height.minus(&self.parabola.at(&node.place));
            let [above, r, weight] = [&above, &node.place, &node.weight].map(|value| I::around(ctx, value));
            let values = self.kernel.at(&above, &r, &self.x)?;
            shares.iter_mut().zip(values).for_each(|(share, value)| *share += &(value * &weight));
        }
        Some(shares)
    }

    /// By ranges on all of a cell on which f is not shown to be analytic, where that is enough.
    fn by_range(&self, cell: &Cell, panel: &LegendrePanel) -> Option<Vec<I>> {
        if cell.image.is_some() {
            return None;
        }
        let r = panel.range();
        let length = DoubleInterval::point(r.upper()) - DoubleInterval::point(r.lower());
        let height = self.store.height(&r)?.minus(&self.parabola.at(&r));
        let ranges = self.kernel.at(&height, &r, &self.in_doubles)?;
        let narrow = |(range, sum): (DoubleInterval, &I)| {
            let area = range * length;
            (radius(&area) <= self.allowed(sum)).then(|| I::around(self.x.ctx(), &wide(&area)))
        };
        ranges.into_iter().zip(&self.sums).map(narrow).collect()
    }

    fn allowed(&self, sum: &I) -> f64 {
        (self.aim * Real::abs(sum).approx()).max(radius(sum) / MOST as f64)
    }
}

impl Parabola {
    /// α + 2βx²/3, α + 2βx² and their difference; or 4βx² once or twice.
    fn integrals<I: Ends>(&self, x: &I, order: Order) -> Vec<I> {
        let [height, bend] = [&self.height, &self.bend].map(|value| I::around(x.ctx(), value));
        let square = bend * Real::square(x);
        let with_height = |square: I| square + &height;
        let times = |count: i64| square.clone().times(count);
        match order {
            Order::Value => vec![with_height(times(2).over(3)), with_height(times(2)), times(4).over(3)],
            order => vec![times(4); order.count()],
        }
    }

    fn at<T: Analytic>(&self, r: &T) -> T {
        r.squared().scaled(&self.bend).plus(&r.constant(&self.height))
    }
}

/// Half of the length, or the infinity.
fn radius<I: Ends>(interval: &I) -> f64 {
    let [lower, upper] = interval.ends();
    (upper - lower).approx() / 2.0
}

/// An interval of doubles in the precision of bounds.
fn wide(interval: &DoubleInterval) -> Interval {
    interval.widened(Precision::new(BOUND_BITS))
}

#[cfg(test)]
#[path = "../../../tests/private/inside.rs"]
mod tests;
