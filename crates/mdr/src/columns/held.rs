//! The balance at the edge of a contact of any radius, in equilibrium or not, and the stability of equilibria.

use mdr_core::contact::{Control, Error, Result, Stability};

use super::{ContactColumns, within};

/// The elongations at the edge of a contact at each radius, at a fixed controlled quantity, as columns in m.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct EnergyBalance {
    /// g(a) − d: the elongation of the spring at the edge that elasticity requires.
    pub excess: Vec<f64>,
    /// Δl(a) = √(2πaw/E*): the elongation that adhesion can hold.
    pub elongation: Vec<f64>,
    /// d: the controlled quantity under fixed grips; under a dead load and on a machine it depends on a.
    pub indentation: Vec<f64>,
}

impl ContactColumns {
    /// Both sides of the condition of equilibrium g(a) − d = Δl(a) (1.5) at contact radii, while the controlled quantity is
    /// held at a value: the contact shrinks where the excess is the larger (1.8), and grows where it is the smaller (1.9). NaN
    /// outside of the profile.
    ///
    /// # Errors
    /// A value or a stiffness out of its domain; a quadrature that does not converge; [`Stopped`](crate::ContactError::Stopped).
    pub fn balance(&self, control: &Control<f64>, value: f64, radii: &[f64]) -> Result<EnergyBalance> {
        self.check(control)?;
        control.check_value(&value)?;
        let curve = self.counted(control);
        let mut balance = EnergyBalance::default();
        for a in radii {
            let sides = self.size_of_contact(*a).and_then(|a| {
                let elongation = curve.detachment_elongation(&a)?;
                let excess = curve.direction(&a, &value)? + elongation;
                Ok([excess, elongation, self.depth(curve.transform().g(&a)? - excess)])
            });
            let [excess, elongation, indentation] = match sides {
                Err(Error::Domain { .. }) => [f64::NAN; 3],
                sides => sides?,
            };
            balance.excess.push(excess);
            balance.elongation.push(elongation);
            balance.indentation.push(indentation);
        }
        Ok(balance)
    }

    /// Whether the equilibrium with each contact radius is stable under a control: g'/Δl' above its value at a fold (1.10), which
    /// is neutral. `None` outside of the profile.
    ///
    /// # Errors
    /// A stiffness that is not positive; a quadrature that does not converge; [`Stopped`](crate::ContactError::Stopped).
    pub fn stability(&self, control: &Control<f64>, radii: &[f64]) -> Result<Vec<Option<Stability>>> {
        self.check(control)?;
        let curve = self.counted(control);
        let at = |a: &f64| {
            let margin =
                within(self.size_of_contact(*a).and_then(|a| Ok(curve.tangency(&a)? - curve.critical_ratio(&a)?)))?;
            Ok(margin.partial_cmp(&0.0).map(|order| match order {
                std::cmp::Ordering::Greater => Stability::Stable,
                std::cmp::Ordering::Equal => Stability::Neutral,
                std::cmp::Ordering::Less => Stability::Unstable,
            }))
        };
        radii.iter().map(at).collect()
    }
}
