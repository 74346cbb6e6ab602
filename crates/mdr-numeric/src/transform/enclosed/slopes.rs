//! The transform of a formula with derivatives in the radius.

use mdr_core::contact::{Result, Transform};
use mdr_core::number::{Dual, Interval, Real};

use super::super::weight::Weight;
use super::{Enclosed, Order};

/// The transform of a formula over enclosures with derivatives in the radius.
#[derive(Clone)]
pub struct EnclosedWithSlopes(Enclosed);

impl EnclosedWithSlopes {
    /// From the transform over enclosures.
    pub fn new(transform: Enclosed) -> Self {
        EnclosedWithSlopes(transform)
    }
}

impl Transform<Dual<Interval>> for EnclosedWithSlopes {
    fn g(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        Ok(x.chain(self.0.g(&x.value)?, self.0.slope(&x.value)?))
    }

    fn slope(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        let mut values = self.0.integrals(&x.value, Order::Curvature)?;
        let curvature = values.swap_remove(1) / x.value.square();
        let slope = values.swap_remove(0) / &x.value;
        let slope = if slope.is_finite() { slope } else { self.0.slope(&x.value).unwrap_or(slope) };
        Ok(x.chain(slope, curvature))
    }

    fn integral(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        Ok(self.mean(x)? * x)
    }

    /// Its slope is S'/S times what g is above it.
    fn mean(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        let values = self.0.integrals(&x.value, Order::Value)?;
        let slope = match &self.0.weight {
            Weight::Line(None) => x.value.lit(0),
            Weight::Line(Some(reference)) => {
                let share = x.value.clone() / reference;
                let room = Real::sqrt(&((share.lit(1) - &share) * (share.lit(1) + &share)));
                values[1].clone().times(2) / (x.value.pi() * &x.value * room)
            }
            weight => values[2].clone() * weight.order(&x.value) / &x.value,
        };
        Ok(x.chain(values[0].clone(), slope))
    }

    fn outer_radius(&self) -> Option<Dual<Interval>> {
        Transform::outer_radius(&self.0).map(Dual::constant)
    }

    fn kinks(&self) -> Vec<Dual<Interval>> {
        Transform::kinks(&self.0).into_iter().map(Dual::constant).collect()
    }

    fn work(&self) -> u64 {
        self.0.work()
    }
}
