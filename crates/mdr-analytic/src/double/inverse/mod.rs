//! Equilibria at a given indentation depth or force, or at many.

mod kernel;
mod many;
mod quadratic;
mod stable;

use std::sync::OnceLock;

use mdr_core::contact::{Control, Equilibrium, Error, Material, Quantity, Ranged, Regime, Result};
use mdr_core::number::Extended;

use self::kernel::Constants;
pub use self::many::{BranchSlices, InverseBatch};
use super::grid::{InstructionSet, Work};
use super::pair::Arithmetic;
use super::ziv::{Round, decide, settle, undecided};
use super::{contact, lifted_control};
use crate::contact::PowerLawContact;
use crate::inverse::{Branch, Count, Equilibria, FoldFrame, Held};

/// The equilibria at a given indentation depth or force, with their stability; see
/// [`PowerLawContact::equilibria`](crate::PowerLawContact::equilibria).
///
/// # Errors
/// See the [module](super).
pub fn equilibria(
    n: f64,
    c: f64,
    material: &Material<f64>,
    control: &Control<f64>,
    value: f64,
) -> Result<Equilibria<Ranged<f64>>> {
    Inverse::new(n, c, material, control)?.once(value)
}

/// The equilibria at x_fold(1 − τ); see
/// [`PowerLawContact::equilibria_at_distance`](crate::PowerLawContact::equilibria_at_distance).
///
/// # Errors
/// See the [module](super).
pub fn equilibria_at_distance(
    n: f64,
    c: f64,
    material: &Material<f64>,
    control: &Control<f64>,
    distance: f64,
) -> Result<Equilibria<Ranged<f64>>> {
    decide!(Quantity::ContactRadius, W => {
        contact::<W>(n, c, material)?.equilibria_at_distance(&lifted_control(control)?, &finite(distance)?.into())
    })
}

/// A contact under one control, prepared for its equilibria at many values.
///
/// ```
/// use mdr_analytic::double::Inverse;
/// use mdr_core::contact::{Control, Material, Ranged};
/// // r²/2R with R = 1: at d = 0 the radius is (2πwR²/E*)^(1/3).
/// let ball = Inverse::new(2.0, 0.5, &Material::new(1.0, 1.0)?, &Control::Indentation)?;
/// let touching = ball.equilibria(0.0)?;
/// assert_eq!(touching.as_slice()[0].contact_radius, Ranged::Value(1.8452701486440284)); // (2π)^(1/3)
/// assert_eq!(ball.equilibria(-1.0)?.as_slice().len(), 2);
/// assert_eq!(ball.equilibria(-2.0)?.as_slice().len(), 0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Inverse {
    n: f64,
    c: f64,
    material: Material<f64>,
    held: Held,
    path: InstructionSet,
    /// The contact and its fold in one word, unless n = 1/2 or one word is not precise enough.
    word: Option<(PowerLawContact<Extended<1>>, FoldFrame<Extended<1>>)>,
    /// The constants of the kernel from one word, and from two words once they are needed.
    constants: Option<Constants>,
    better: OnceLock<Option<Constants>>,
}

impl Inverse {
    /// The contact of f = C rⁿ under controlled indentation or force.
    ///
    /// # Errors
    /// See the [module](super); [`Error::Domain`] for a machine of finite stiffness.
    #[inline]
    pub fn new(n: f64, c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Self> {
        let held = Held::of(control)?;
        let contact = contact::<Extended<1>>(n, c, material)?;
        let word = if n == 0.5 { None } else { FoldFrame::new(&contact, held).ok().map(|fold| (contact, fold)) };
        let constants = word.as_ref().and_then(|(contact, fold)| Constants::new(contact, fold));
        let (material, path, better) = (material.clone(), InstructionSet::fastest(), OnceLock::new());
        Ok(Inverse { n, c, material, held, path, word, constants, better })
    }

    /// Selects the instruction set `path` for the evaluation.
    #[must_use]
    pub fn with_instructions(self, path: InstructionSet) -> Self {
        Inverse { path, ..self }
    }

    /// The equilibria at a value of the controlled quantity.
    ///
    /// # Errors
    /// See the [module](super).
    #[inline]
    pub fn equilibria(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        finite(value)?;
        let constants = self.better.get().unwrap_or(&self.constants);
        if let Some(found) = self.fast(constants, value) {
            return Ok(found);
        }
        // Two words take a few microseconds, once.
        let first_time = self.better.get().is_none();
        match first_time.then(|| self.fast(self.better(), value)).flatten() {
            Some(found) => Ok(found),
            None => self.with_words(value),
        }
    }

    /// The equilibria at a single value, without computing constants from two words.
    #[inline]
    fn once(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        finite(value)?;
        self.fast(&self.constants, value).map_or_else(|| self.with_words(value), Ok)
    }

    /// The constants from two words.
    #[inline]
    fn better(&self) -> &Option<Constants> {
        self.better.get_or_init(|| {
            let contact = contact::<Extended<2>>(self.n, self.c, &self.material).ok()?;
            let fold = if self.n == 0.5 { None } else { FoldFrame::new(&contact, self.held).ok() };
            Constants::new(&contact, &fold?)
        })
    }

    /// The equilibria in pairs of doubles, if that is accurate enough.
    #[inline]
    fn fast(&self, constants: &Option<Constants>, x: f64) -> Option<Equilibria<Ranged<f64>>> {
        let constants = constants.as_ref()?;
        let count = constants.count(x)?;
        if count == Count::None {
            return Some(Equilibria::None);
        }
        let [smaller, larger] = self.path.run(Both { constants, x, count });
        let state = |branch: Branch, (a, other): (f64, f64)| Equilibrium {
            contact_radius: Ranged::Value(a),
            indentation: Ranged::Value(self.held.pick(x, other)),
            force: Ranged::Value(self.held.pick(other, x)),
            stability: branch.stability(constants.regime),
        };
        let larger = state(Branch::Larger, larger?);
        Some(match count {
            Count::Two => Equilibria::Two([state(Branch::Smaller, smaller?), larger]),
            _ => Equilibria::One(larger),
        })
    }

    #[cold]
    fn with_words(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        if let Some((contact, fold)) = &self.word
            && let Some(settled) = settle(|| fold.at_value(contact, &value.into()))
        {
            return settled;
        }
        self.with_more_words(value)
    }

    fn with_more_words(&self, value: f64) -> Result<Equilibria<Ranged<f64>>> {
        decide!(Quantity::ContactRadius, W => {
            let contact = contact::<W>(self.n, self.c, &self.material)?;
            let value = value.into();
            let by_fold = match contact.regime()? {
                Regime::ScaleFree => None,
                _ => FoldFrame::new(&contact, self.held).and_then(|fold| fold.at_value(&contact, &value)).ok(),
            };
            // At n = 1/2 there is no fold, and close to 1/2 it is far out of range.
            match by_fold {
                Some(found) => Ok(found),
                None => contact.equilibria(&self.held.control(), &value),
            }
        })
    }
}

/// Both branches at one value; if only the larger one exists, it appears twice.
struct Both<'a> {
    constants: &'a Constants,
    x: f64,
    count: Count,
}

impl Work for Both<'_> {
    type Output = [Option<(f64, f64)>; 2];

    #[inline(always)]
    fn run<A: Arithmetic>(self, arithmetic: A) -> Self::Output {
        let Both { constants, x, count } = self;
        let first = if count == Count::Two { Branch::Smaller } else { Branch::Larger };
        let branches = [first, Branch::Larger];
        let lanes = match constants.held {
            Held::Indentation => constants.on_branches::<A, false, 2>(arithmetic, &[x; 2], |i| branches[i]),
            Held::Force => constants.on_branches::<A, true, 2>(arithmetic, &[x; 2], |i| branches[i]),
        };
        [0, 1].map(|i| lanes.trusted[i].then_some((lanes.radius[i], lanes.other[i])))
    }
}

#[inline]
fn finite(value: f64) -> Result<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(Error::domain(Quantity::Parameter("the given value"), &value, "finite"))
}

impl<const N: usize> Round for Equilibria<Extended<N>> {
    type Rounded = Equilibria<Ranged<f64>>;

    #[inline(always)]
    fn round(&self) -> Option<Self::Rounded> {
        self.transform(|state| {
            Some(Equilibrium {
                contact_radius: state.contact_radius.round()?,
                indentation: state.indentation.round()?,
                force: state.force.round()?,
                stability: state.stability,
            })
        })
    }
}
