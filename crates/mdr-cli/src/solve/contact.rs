//! The contact of a scene in one arithmetic, with its evaluations counted.

use std::sync::Arc;

use mdr_analytic::Kappa;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{self, Control, CountedTransform, Error, Evaluations, Material, Quantity, Result, Transform};
use mdr_core::number::{Dual, Interval, Literal};
use mdr_numeric::curve::Curve;
use rug::Float;

use super::digits::{GUARD, start};
use super::library;
use crate::flags;
use crate::scene::{HeldBy, Scene, double, exactly};

/// An arithmetic in which a scene can be computed.
pub(crate) trait Arithmetic: Struve + Kappa {
    /// Its place among the [`NAMES`].
    const INDEX: usize;
}

/// The arithmetics, as `--explain` names them.
pub(crate) const NAMES: [&str; 4] = ["f64", "mp", "interval", "interval with slope"];

impl Arithmetic for f64 {
    const INDEX: usize = 0;
}
impl Arithmetic for Float {
    const INDEX: usize = 1;
}
impl Arithmetic for Interval {
    const INDEX: usize = 2;
}
impl Arithmetic for Dual<Interval> {
    const INDEX: usize = 3;
}

/// The evaluations so far, by arithmetic.
#[derive(Debug, Default)]
pub(crate) struct Tally([Arc<contact::Tally>; NAMES.len()]);

impl Tally {
    pub(crate) fn read(&self) -> [Evaluations; NAMES.len()] {
        self.0.each_ref().map(|tally| tally.read())
    }
}

/// Profile, material and control in one arithmetic.
pub(crate) struct Contact<R: Arithmetic> {
    ctx: R::Ctx,
    transform: Arc<CountedTransform<R>>,
    material: Material<R>,
    control: Control<R>,
}

impl<R: Arithmetic> Contact<R> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(scene: &Scene, ctx: R::Ctx, tally: &Arc<Tally>) -> Result<Self> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        let material = Material::new(number(&scene.effective_modulus), number(&scene.work_of_adhesion))?;
        let control = match &scene.held.by {
            HeldBy::Indentation => Control::Indentation,
            HeldBy::Force => Control::Force,
            HeldBy::Machine { stiffness } => Control::machine(number(stiffness))?,
        };
        Self::with(scene, ctx, material, control, tally)
    }

    fn with(
        scene: &Scene,
        ctx: R::Ctx,
        material: Material<R>,
        control: Control<R>,
        tally: &Arc<Tally>,
    ) -> Result<Self> {
        let accepted = match scene.output.arithmetic {
            flags::Arithmetic::Certified { digits } if R::INDEX == Float::INDEX => {
                Some(R::from_int(ctx, 2).powi(-i64::from(start(digits).bits() - GUARD / 2)))
            }
            _ => None,
        };
        let transform = library::transform(&scene.profile, ctx, accepted.as_ref())?;
        let transform = CountedTransform::new(transform, &tally.0[R::INDEX]);
        Ok(Contact { ctx, transform: Arc::new(transform), material, control })
    }

    pub(crate) fn number(&self, literal: &Literal) -> R {
        R::from_literal(self.ctx, literal)
    }

    /// A double, exactly.
    pub(crate) fn double(&self, value: f64) -> R {
        R::from_f64(self.ctx, value)
    }

    pub(crate) fn transform(&self) -> &dyn Transform<R> {
        &*self.transform
    }

    /// The same, for as long as it is needed.
    pub(crate) fn shared(&self) -> Arc<CountedTransform<R>> {
        Arc::clone(&self.transform)
    }

    pub(crate) fn material(&self) -> &Material<R> {
        &self.material
    }

    pub(crate) fn control(&self) -> &Control<R> {
        &self.control
    }

    pub(crate) fn curve(&self) -> Curve<'_, R> {
        Curve::new(&*self.transform, &self.material, &self.control)
    }
}

impl Contact<f64> {
    /// The same contact with forces in units of E* times an area: all its lengths are the same, and the moduli may be out of
    /// the range of f64.
    ///
    /// # Errors
    /// [`Error::Domain`] with the input as it was written, where no double holds a number of the profile, w/E* or k/E*; as
    /// [`Contact::new`].
    pub(crate) fn in_units_of_modulus(scene: &Scene, tally: &Arc<Tally>) -> Result<Self> {
        if let Some(number) = scene.places.parameter_beyond_doubles() {
            let quantity = Quantity::Parameter("a number of the profile");
            let requirement = "within the range of f64, where the search for states begins";
            return Err(Error::Domain { quantity, value: number.to_string(), requirement });
        }
        let material = Material::new(1.0, over_modulus(scene, Quantity::WorkOfAdhesion, &scene.work_of_adhesion)?)?;
        let control = match &scene.held.by {
            HeldBy::Indentation => Control::Indentation,
            HeldBy::Force => Control::Force,
            HeldBy::Machine { stiffness } => Control::machine(over_modulus(scene, Quantity::Stiffness, stiffness)?)?,
        };
        Self::with(scene, (), material, control, tally)
    }
}

/// An input over E*, in f64.
fn over_modulus(scene: &Scene, quantity: Quantity, input: &Literal) -> Result<f64> {
    let modulus = &scene.effective_modulus;
    let ratio = exactly(&(input.to_rational() / modulus.to_rational())).as_ref().and_then(double);
    ratio.ok_or_else(|| Error::Domain {
        quantity,
        value: format!("{input} at E* = {modulus}"),
        requirement: "of a ratio to E* within the range of f64, where the search for states begins",
    })
}
