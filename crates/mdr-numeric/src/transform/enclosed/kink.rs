//! The terms of kinks, and what g is beside one.

use std::sync::Arc;

use mdr_core::contact::{Kink, Result, Slopes};
use mdr_core::number::{Interval, Real};

use super::super::weight::Weight;
use super::{Enclosed, Order};

impl Enclosed {
    /// Adds the terms of the kinks inside x.
    pub(super) fn add_kinks(&self, x: &Interval, order: Order, values: &mut [Interval]) {
        if order == Order::Value || matches!(self.weight, Weight::Winkler) {
            return;
        }
        for (index, b) in self.formula.breaks().iter().enumerate() {
            if b.lower() >= x.upper() {
                break;
            }
            let unknown = || Interval::entire(x.ctx());
            let Some([_, first, second]) = self.formula.jump(index) else {
                values.iter_mut().for_each(|value| *value = unknown());
                return;
            };
            let zero = first.lit(0);
            let vanishes = [*first == zero, *first == zero && *second == zero];
            let b = b.rounded(x.ctx());
            let factor = self.weight.share_of_kink(x, &b);
            let terms = [factor.clone() * first, {
                let slope = self.weight.bend_of_kink(x, &b) * &factor;
                factor * second + slope * first
            }];
            for ((value, term), vanishes) in values.iter_mut().zip(terms).zip(vanishes) {
                if !vanishes {
                    *value += &term;
                }
            }
        }
    }

    /// g beside the break with this index, of a formula in which no power begins at a radius.
    pub(super) fn kink_of_breaks(&self, index: usize, margin: &Interval) -> Result<Option<Kink<Interval>>> {
        let breaks = self.formula.breaks();
        let (Some(b), Some(jump)) = (breaks.get(index), self.formula.jump(index)) else { return Ok(None) };
        let before = |x: &Interval, order| self.between_breaks(x, order, &breaks[..index]);
        let Ok(value) = before(b, Order::Value) else { return Ok(None) };
        let [inner, outer] = [b.lit(1) - margin, margin.clone() + b.lit(1)].map(|factor| factor * b);
        if index > 0 && breaks[index - 1].upper() >= inner.lower()
            || breaks.get(index + 1).is_some_and(|next| next.lower() <= outer.upper())
        {
            return Ok(None);
        }
        let (inside, outside) = (inner.hull(b), b.hull(&outer));
        let value = Some((value[1].clone(), value[0].clone()));
        if let Weight::Winkler = self.weight {
            let slope = |part: usize, radii: &Interval| Some(self.formula.part(part)?.slopes(radii)?[1].clone());
            let slopes = |part, radii| slope(part, radii).map_or_else(Slopes::unknown, Slopes::within);
            return Ok(Some(Kink { value, inside: slopes(index, &inside), outside: slopes(index + 1, &outside) }));
        }
        let mut below = before(&inside, Order::Slope)?;
        let mut above = self.between_breaks(&outside, Order::Slope, &breaks[..=index])?;
        for (x, values) in [(&inside, &mut below), (&outside, &mut above)] {
            let others = Enclosed { formula: Arc::new(self.formula.up_to(index)), ..self.clone() };
            others.add_kinks(x, Order::Slope, values);
        }
        let (below, above) = (below.swap_remove(0), above.swap_remove(0));
        // T falls to its value at the outer end.
        let least = self.weight.share_of_kink(&outer, b);
        let with_jump = (least * &jump[1] + &above) / &outside;
        let zero = b.lit(0);
        let outside = match &jump[1] {
            jump if *jump == zero => Slopes::within(above / &outside),
            jump if *jump > zero => Slopes::at_least(with_jump),
            jump if *jump < zero => Slopes::at_most(with_jump),
            _ => Slopes::unknown(),
        };
        Ok(Some(Kink { value, inside: Slopes::within(below / inside), outside }))
    }
}
