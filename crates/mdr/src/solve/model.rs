//! The contact of a scene in one arithmetic, with its evaluations counted.

use std::sync::Arc;

use mdr_analytic::Kappa;
use mdr_analytic::profiles::{Sum, closed_form};
use mdr_analytic::struve::Struve;
use mdr_core::contact::{
    self, Control, CountingTransform, Edge, Error, ExpressionError, ExpressionProfile, Quantity, Result, Status,
    Transform,
};
#[cfg(feature = "mp")]
use mdr_core::number::{Dual, Interval, Precision};
use mdr_core::number::{Literal, Special};
use mdr_numeric::contact::Contact;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::path;
use mdr_numeric::transform::Quadrature;
#[cfg(feature = "mp")]
use mdr_numeric::transform::{Enclosed, EnclosedWithSlopes};

use super::graded::GradedReal;
use super::media;
use super::weight::weight;
use crate::answer::{PlainState, Value};
use crate::run::Counts;
use crate::scene::{Formula, Profile, Scene, Start};
#[cfg(feature = "mp")]
use crate::scene::{double, exactly};

/// An arithmetic in which a scene can be computed.
pub(crate) trait SceneReal: Struve + Kappa + GradedReal {
    /// Its place among the [`ARITHMETICS`](crate::run::ARITHMETICS).
    const INDEX: usize;

    /// The error of a quadrature that a scene accepts, if the arithmetic has more digits than requested.
    fn accepted(_: &Scene, _: Self::Ctx) -> Option<Self> {
        None
    }

    /// The transform of a formula, if the arithmetic has a better one than a quadrature.
    ///
    /// # Errors
    /// A name of the formula without a value.
    fn of_formula(_: &Formula, _: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        None
    }
}

impl SceneReal for f64 {
    const INDEX: usize = 0;
}

#[cfg(feature = "mp")]
impl SceneReal for rug::Float {
    const INDEX: usize = 1;

    fn accepted(scene: &Scene, ctx: Self::Ctx) -> Option<Self> {
        use mdr_core::number::Real;
        match scene.arithmetic {
            crate::scene::Arithmetic::Certified { digits } => {
                Some(Self::from_int(ctx, 2).powi(-super::digits::bits_of_quadratures(digits)))
            }
            crate::scene::Arithmetic::Double => None,
        }
    }
}

#[cfg(feature = "mp")]
impl SceneReal for Interval {
    const INDEX: usize = 2;

    fn of_formula(formula: &Formula, ctx: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        Some(enclosed(formula, ctx).map(|transform| Box::new(transform) as Box<dyn Transform<Self>>))
    }
}

#[cfg(feature = "mp")]
impl SceneReal for Dual<Interval> {
    const INDEX: usize = 3;

    fn of_formula(formula: &Formula, ctx: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        let with_slopes = |transform| Box::new(EnclosedWithSlopes::new(transform)) as Box<dyn Transform<Self>>;
        Some(enclosed(formula, ctx).map(with_slopes))
    }
}

/// The transform of a formula by rigorous integrals.
#[cfg(feature = "mp")]
fn enclosed(formula: &Formula, ctx: Precision) -> Result<Enclosed> {
    let enclosed = formula.expression.enclosed(&formula.parameters, &formula.breaks, ctx);
    Ok(Enclosed::new(enclosed.map_err(unnamed)?, ctx))
}

/// Profile, material and control in one arithmetic.
pub(crate) struct Model<R: SceneReal> {
    ctx: R::Ctx,
    contact: Contact<R>,
}

impl<R: SceneReal> Model<R> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(scene: &Scene, ctx: R::Ctx, counts: &Counts) -> Result<Self> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        let medium = media::medium(scene, ctx)?;
        let adhesion = adhesion(scene, |literal| Ok(number(literal)))?;
        let control =
            scene.control.try_map(|stiffness| Error::require_positive(Quantity::Stiffness, number(stiffness)))?;
        Self::with(scene, ctx, (medium, adhesion), control, counts)
    }

    /// The contact at the work of adhesion of one edge.
    pub(crate) fn at(&self, edge: Edge) -> Self {
        Model { ctx: self.ctx, contact: self.contact.at(edge) }
    }

    fn with(
        scene: &Scene,
        ctx: R::Ctx,
        (medium, adhesion): (Medium<R>, Adhesion<R>),
        control: Control<R>,
        counts: &Counts,
    ) -> Result<Self> {
        let transform = media::transform(scene, ctx)?;
        let transform = CountingTransform::new(transform, &counts[R::INDEX]);
        let transform = Arc::new(transform.weighing(weight(&scene.profile, R::INDEX, R::from_int(ctx, 1).precision())));
        Ok(Model { ctx, contact: Contact::sharing(transform, medium, adhesion, control) })
    }

    pub(crate) fn number(&self, literal: &Literal) -> R {
        R::from_literal(self.ctx, literal)
    }

    /// A double, exactly.
    #[cfg(feature = "mp")]
    pub(crate) fn double(&self, value: f64) -> R {
        R::from_f64(self.ctx, value)
    }

    /// The contact radius or half-width of a contact of this size.
    pub(crate) fn contact_radius(&self, size: &R) -> R {
        self.contact.medium().contact_radius(size)
    }

    /// The size of a contact with a contact radius of the scene.
    ///
    /// # Errors
    /// [`Error::Domain`] for half of a period and more.
    pub(crate) fn size(&self, contact_radius: &Literal) -> Result<R> {
        let a = self.number(contact_radius);
        match self.contact.medium() {
            Medium::Periodic { wavelength, .. } if !(a.clone().times(2) < *wavelength) => {
                Err(Error::domain(Quantity::ContactRadius, &a, "smaller than half of the wavelength"))
            }
            medium => Ok(medium.size(&a)),
        }
    }

    /// An indentation; on a medium without depths nothing, and nothing is amiss.
    pub(crate) fn depth<N>(&self, indentation: Value<N>) -> Value<N> {
        if self.contact.medium().has_depth() {
            indentation
        } else {
            Value::Unknown { status: Status::Ok, log10: None, why: None }
        }
    }

    /// The record of a state, by its contact radius.
    pub(crate) fn plain(&self, state: contact::Equilibrium<R>) -> PlainState<R> {
        let state = PlainState::from(self.shown(state));
        PlainState { indentation: self.depth(state.indentation), ..state }
    }

    /// The start of a path, by its size.
    ///
    /// # Errors
    /// [`Error::Domain`] for half of a period and more.
    pub(crate) fn start(&self, start: &Start) -> Result<path::Start<R>> {
        Ok(match start {
            Start::Nearest(radius) => path::Start::Nearest(self.size(radius)?),
            start => start.map(|radius| self.number(radius)),
        })
    }

    /// A state with its contact radius for its size.
    pub(crate) fn shown(&self, state: contact::Equilibrium<R>) -> contact::Equilibrium<R> {
        contact::Equilibrium { contact_radius: self.contact_radius(&state.contact_radius), ..state }
    }

    pub(crate) fn transform(&self) -> &dyn Transform<R> {
        self.contact.transform()
    }

    pub(crate) fn control(&self) -> &Control<R> {
        self.contact.control()
    }

    pub(crate) fn contact(&self) -> Contact<R> {
        self.contact.clone()
    }
}

impl Model<f64> {
    /// The contact with forces in units of E* times an area: all its lengths are unchanged, and the moduli may be out of the
    /// range of f64.
    ///
    /// # Errors
    /// [`Error::Domain`] with the input as it was written, if no double holds a number of the profile, w/E* or k/E*; a parameter
    /// of the profile or the material that is out of its domain.
    #[cfg(feature = "mp")]
    pub(crate) fn in_units_of_modulus(scene: &Scene, counts: &Counts) -> Result<Self> {
        if let Some(number) = scene.places.parameter_beyond_doubles() {
            let quantity = Quantity::Parameter("a number of the profile");
            let requirement = "within the range of f64, where the search for states begins";
            return Err(Error::Domain { quantity, value: number.to_string(), requirement });
        }
        let medium = media::medium_of(scene, (), Some(1.0))?;
        let adhesion = adhesion(scene, |literal| over_modulus(scene, Quantity::WorkOfAdhesion, literal))?;
        let control = scene.control.try_map(|stiffness| {
            let ratio = over_modulus(scene, Quantity::Stiffness, stiffness)?;
            Error::require_positive(Quantity::Stiffness, ratio)
        })?;
        Self::with(scene, (), (medium, adhesion), control, counts)
    }
}

/// The adhesion of a scene: that of an edge, or of both, of which the receding one is considered.
fn adhesion<R: SceneReal>(scene: &Scene, number: impl Fn(&Literal) -> Result<R>) -> Result<Adhesion<R>> {
    match &scene.works {
        None => Adhesion::new(number(&scene.work_of_adhesion)?),
        Some(works) => {
            let both = Adhesion::hysteretic(number(&works[0])?, number(&works[1])?)?;
            Ok(both.at(scene.edge.unwrap_or(Edge::Receding)))
        }
    }
}

/// An input over E*, in f64.
#[cfg(feature = "mp")]
fn over_modulus(scene: &Scene, quantity: Quantity, input: &Literal) -> Result<f64> {
    let modulus = &scene.scale_of_forces();
    let ratio = exactly(&(input.to_rational() / modulus.to_rational())).as_ref().and_then(double);
    ratio.ok_or_else(|| Error::Domain {
        quantity,
        value: format!("{input} at E* = {modulus}"),
        requirement: "of a ratio to E* within the range of f64, where the search for states begins",
    })
}

/// A name of a formula without a value.
fn unnamed(error: ExpressionError) -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the formula"),
        value: error.to_string(),
        requirement: "one whose names all have values",
    }
}

/// The transforms of formulas that an arithmetic has in place of quadratures.
type Formulas<'a, R> = &'a dyn Fn(&Formula) -> Option<Result<Box<dyn Transform<R>>>>;

/// The transformed profile: a closed form where there is one, `formulas` of a formula where the arithmetic has it, else its
/// quadrature, and exact pieces of a table. `number` gets its numbers in the order of [`Profile::numbers`].
///
/// Over intervals a quadrature has no meaning. It takes a relative error that is `accepted` where it cannot have the digits of the
/// arithmetic.
///
/// # Errors
/// A parameter out of the domain of the profile; a wave, which needs a periodic medium.
pub(super) fn by_formulas<R: Struve + Kappa>(
    profile: &Profile,
    ctx: R::Ctx,
    number: &mut dyn FnMut(&Literal) -> R,
    accepted: Option<&R>,
    formulas: Formulas<'_, R>,
) -> Result<Box<dyn Transform<R>>> {
    Ok(match profile {
        Profile::Shape(shape) => closed_form(shape.map(|_, literal| number(literal)))?,
        Profile::Sum(terms) => {
            let terms = terms.iter().map(|term| by_formulas(term, ctx, number, accepted, formulas));
            Box::new(Sum::new(terms.collect::<Result<_>>()?))
        }
        Profile::Formula(formula) => {
            if let Some(transform) = formulas(formula) {
                return transform;
            }
            let quadrature = Quadrature::new(formula.bound(ctx, number)?);
            Box::new(match accepted {
                Some(error) => quadrature.accepting(error.clone())?,
                None => quadrature,
            })
        }
        Profile::Table(measured) => Box::new(measured.table.profile::<R>(ctx)?),
        Profile::Wave(_) => {
            return Err(Error::Domain {
                quantity: Quantity::Parameter("the profile"),
                value: "a wave".to_owned(),
                requirement: "one that is not periodic: a wave needs [medium] kind = \"periodic\"",
            });
        }
    })
}

impl Formula {
    /// f with its numbers, which `number` takes to one arithmetic.
    ///
    /// # Errors
    /// A name without a value.
    pub(super) fn bound<R: Special>(
        &self,
        ctx: R::Ctx,
        number: &mut dyn FnMut(&Literal) -> R,
    ) -> Result<ExpressionProfile<R>> {
        let values = self.parameters.iter().map(|(name, literal)| (name.clone(), number(literal))).collect();
        let bound = self.expression.bind_numbers::<R>(ctx, &values).map_err(unnamed)?;
        #[cfg(feature = "mp")]
        let bound = bound.broken_at(ctx, &self.breaks);
        Ok(bound)
    }
}

impl Profile {
    /// The transformed profile g in one arithmetic: a closed form where there is one, quadrature for a formula, exact pieces for a
    /// table. `number` turns its numbers into that arithmetic, in the order of [`Profile::numbers`].
    ///
    /// # Errors
    /// A parameter out of the domain of the profile.
    pub fn transform<R: Struve + Kappa>(
        &self,
        ctx: R::Ctx,
        number: &mut dyn FnMut(&Literal) -> R,
    ) -> Result<Box<dyn Transform<R>>> {
        by_formulas(self, ctx, number, None, &|_| None)
    }
}

/// The transform of a profile in f64.
///
/// # Errors
/// A parameter of the profile that is out of its domain.
pub(crate) fn transform_in_doubles(profile: &Profile) -> Result<Box<dyn Transform<f64>>> {
    profile.transform((), &mut Literal::nearest_f64)
}
