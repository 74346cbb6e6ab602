//! The contact of a scene in one arithmetic: the profile transformed for its medium, the medium, the adhesion at the edge, and the
//! control. Every state of a scene is computed from it.

#[cfg(feature = "mp")]
use std::borrow::Cow;
use std::sync::Arc;

use mdr_analytic::profiles::ClosedReal;
#[cfg(feature = "mp")]
use mdr_core::contact::EnclosedFormula;
use mdr_core::contact::{Control, Edge, Error, ExpressionError, ExpressionProfile, Quantity, Transform};
use mdr_core::number::{Dual, Literal, Real, Special};
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, Precision};
use mdr_numeric::contact::Contact;
use mdr_numeric::medium::{self, Adhesion};
#[cfg(feature = "mp")]
use mdr_numeric::table::Table;
use mdr_numeric::transform::Quadrature;
#[cfg(feature = "mp")]
use mdr_numeric::transform::{Enclosed, EnclosedWithSlopes};

use super::quadrature::by_quadrature;
use super::{ExactMedium, Formula, Profile, Scene};
use crate::solve::GradedReal;
use crate::solve::media;

type Result<T> = mdr_core::contact::Result<T>;

/// The transforms of formulas, and of shapes that are written as such on a medium, that an arithmetic has in place of quadratures.
pub(crate) type Formulas<'a, R> = &'a dyn Fn(&Profile) -> Option<Result<Box<dyn Transform<R>>>>;

/// An arithmetic in which profiles are transformed for every medium: `f64`, numbers of any precision, enclosures, and dual
/// numbers over them.
///
/// [`Profile::transform`] and [`Profile::transform_on`] take it. Transforms are generic, and are compiled in this crate for all of
/// these arithmetics but numbers of any precision: what calls them through this trait does not compile them again.
pub trait ProfileReal: ClosedReal + GradedReal {
    /// Whether its numbers are enclosures, over which a quadrature has no meaning.
    const ENCLOSES: bool;

    /// The transformed profile g for a medium, as [`Profile::transform_on`] has it; `formulas` has the transforms of formulas that
    /// are better than a quadrature.
    ///
    /// # Errors
    /// A parameter out of the domain of the profile; a profile that the medium has no transform of.
    #[doc(hidden)]
    fn transform(
        profile: &Profile,
        medium: &ExactMedium,
        ctx: Self::Ctx,
        number: &mut dyn FnMut(&Literal) -> Self,
        formulas: Formulas<'_, Self>,
    ) -> Result<Box<dyn Transform<Self>>> {
        media::transform(profile, medium, ctx, number, formulas)
    }
}

/// `ProfileReal` with a function that is not generic, which only this crate compiles.
macro_rules! compiled {
    (encloses $encloses:literal: $($arithmetic:ty),*) => {$(
        impl ProfileReal for $arithmetic {
            const ENCLOSES: bool = $encloses;

            fn transform(
                profile: &Profile,
                medium: &ExactMedium,
                ctx: Self::Ctx,
                number: &mut dyn FnMut(&Literal) -> Self,
                formulas: Formulas<'_, Self>,
            ) -> Result<Box<dyn Transform<Self>>> {
                media::transform(profile, medium, ctx, number, formulas)
            }
        }
    )*};
}

compiled!(encloses false: f64, Dual<f64>);
#[cfg(feature = "mp")]
compiled!(encloses true: Interval, Dual<Interval>, Dual<Dual<Interval>>);

#[cfg(feature = "mp")]
impl ProfileReal for rug::Float {
    const ENCLOSES: bool = false;
}

/// An arithmetic in which the contact of a scene is assembled: `f64`, intervals, and dual numbers over intervals.
///
/// The transform of a formula is a quadrature in the first and rigorous in the others.
pub trait SceneReal: ProfileReal {
    /// Its place among the [`ARITHMETICS`](crate::ARITHMETICS).
    const INDEX: usize;

    /// The transform of a formula on a medium, and of a shape that is written as one there, if the arithmetic has a better one than
    /// a quadrature.
    ///
    /// # Errors
    /// A name of the formula without a value.
    fn of_formula(_: &Profile, _: &ExactMedium, _: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        None
    }

    /// The number as an enclosure, for proofs about a state; `None` in doubles, of which nothing is proved.
    #[cfg(feature = "mp")]
    fn enclosing(&self) -> Option<Interval> {
        None
    }
}

impl SceneReal for f64 {
    const INDEX: usize = 0;
}

#[cfg(feature = "mp")]
impl SceneReal for Interval {
    const INDEX: usize = 1;

    fn enclosing(&self) -> Option<Interval> {
        Some(self.clone())
    }

    fn of_formula(profile: &Profile, medium: &ExactMedium, ctx: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        let boxed = |transform| Box::new(transform) as Box<dyn Transform<Self>>;
        Some(enclosed(profile, medium, ctx)?.map(boxed))
    }
}

#[cfg(feature = "mp")]
impl SceneReal for Dual<Interval> {
    const INDEX: usize = 2;

    fn of_formula(profile: &Profile, medium: &ExactMedium, ctx: Self::Ctx) -> Option<Result<Box<dyn Transform<Self>>>> {
        let with_slopes = |transform| Box::new(EnclosedWithSlopes::new(transform)) as Box<dyn Transform<Self>>;
        Some(enclosed(profile, medium, ctx)?.map(with_slopes))
    }
}

/// The transform by rigorous integrals, of a profile that is written as a formula on the medium; `None` of another.
#[cfg(feature = "mp")]
fn enclosed(profile: &Profile, medium: &ExactMedium, ctx: Precision) -> Option<Result<Enclosed>> {
    let formula = profile.written_on(medium)?;
    let bound = formula.expression.enclosed(&formula.parameters, &formula.breaks, ctx).map_err(unnamed);
    let is_capped = matches!(profile, Profile::Shape(shape) if shape.is_capped());
    let bound = if is_capped { bound.map(EnclosedFormula::without_corners) } else { bound };
    Some(bound.map(|bound| media::enclosed(bound, medium, ctx)))
}

#[cfg(feature = "mp")]
impl Profile {
    /// The formula whose transform on a medium is a rigorous integral: that of the profile, or of a shape that has no closed form
    /// there. `None` of a shape that ends in an edge, which no formula has, of a sum, and on a periodic medium.
    pub(crate) fn written_on(&self, medium: &ExactMedium) -> Option<Cow<'_, Formula>> {
        match self {
            _ if medium.is_periodic() => None,
            Profile::Formula(formula) => Some(Cow::Borrowed(formula)),
            Profile::Shape(shape) if !medium.is_half_space() && shape.is_all_of_its_formula() => {
                let (expression, parameters) = shape.formula().ok()?;
                let breaks = expression.breaks(&parameters).ok()?;
                Some(Cow::Owned(Formula {
                    #[cfg(feature = "serde")]
                    text: shape.text().to_owned(),
                    expression,
                    parameters,
                    breaks,
                    // Only its enclosures are used.
                    lost: [0.0; 4],
                }))
            }
            _ => None,
        }
    }
}

impl Scene {
    /// The contact in f64: profile, medium, adhesion and control, for questions that a scene does not have.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let ball = Scene::new(Shape::Paraboloid { radius: "0.01" }, Elasticity::effective("1e6")?, "0.05")?;
    /// let contact = ball.control(Control::Force).contact()?;
    /// let (depth, force) = contact.state(&5e-4)?;
    /// assert!(depth > 0.0 && force > 0.0);
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// A number that no double holds; a parameter out of its domain, with its place.
    pub fn contact(&self) -> crate::Result<Contact<f64>> {
        self.places.require_doubles("ask for certified digits")?;
        self.contact_in(())
    }

    /// The contact in any arithmetic: f64, numbers or enclosures of a precision, dual numbers over enclosures. Sizes of a
    /// contact on a periodic medium are not its half-widths: see [`contact_radius`](mdr_numeric::medium::Medium::contact_radius).
    ///
    /// ```
    /// # #[cfg(feature = "mp")] {
    /// use mdr::prelude::*;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let medium = ExactMedium::Graded { exponent: "0.3".parse()?, stiffness: Grading::Coefficient("1".parse()?) };
    /// let ball = Scene::new(Shape::Paraboloid { radius: "1" }, Elasticity::effective("1")?, "0.01")?.medium(medium)?;
    /// let precision = Precision::new(200);
    /// let contact = ball.contact_in::<Interval>(precision)?;
    /// // All of the enclosure of the depth lies below that without adhesion.
    /// let radius = Interval::from_f64(precision, 0.1);
    /// assert!(contact.indentation(&radius)? < contact.transform().g(&radius)?);
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A parameter out of its domain, with its place.
    pub fn contact_in<R: SceneReal>(&self, ctx: R::Ctx) -> crate::Result<Contact<R>> {
        self.check_profile_on_medium()?;
        self.assembled(ctx).map_err(|error| self.places.complaint_about_profile(error))
    }

    /// The contact, with an error that has no place yet.
    ///
    /// # Errors
    /// A parameter out of its domain.
    pub(crate) fn assembled<R: SceneReal>(&self, ctx: R::Ctx) -> Result<Contact<R>> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        self.assembled_with(ctx, media::medium(self, ctx)?, &|_, literal| Ok(number(literal)))
    }

    /// The contact on a medium whose modulus may be another, with forces and works in its units: `number` of each.
    ///
    /// # Errors
    /// A parameter out of its domain; errors of `number`.
    pub(crate) fn assembled_with<R: SceneReal>(
        &self,
        ctx: R::Ctx,
        medium: medium::Medium<R>,
        number: &dyn Fn(Quantity, &Literal) -> Result<R>,
    ) -> Result<Contact<R>> {
        let adhesion = self.adhesion(|literal| number(Quantity::WorkOfAdhesion, literal))?;
        let control: Control<R> = self.control.try_map(|stiffness| {
            Error::require_positive(Quantity::Stiffness, number(Quantity::Stiffness, stiffness)?)
        })?;
        let formulas = |profile: &Profile| R::of_formula(profile, &self.medium, ctx);
        let number = &mut |literal: &Literal| R::from_literal(ctx, literal);
        let transform = R::transform(&self.profile, &self.medium, ctx, number, &formulas)?;
        Ok(Contact::sharing(Arc::from(transform), medium, adhesion, control))
    }

    /// The table that is pressed into a half-space; `None` of another scene.
    #[cfg(feature = "mp")]
    pub(crate) fn table_on_half_space(&self) -> Option<&Table> {
        match &self.profile {
            Profile::Table(measured) if self.medium.is_half_space() => Some(&measured.table),
            _ => None,
        }
    }

    /// The contact of that table in an arithmetic without a context.
    ///
    /// # Errors
    /// A parameter out of its domain.
    #[cfg(feature = "mp")]
    pub(crate) fn contact_of_table<R: Special<Ctx = ()>>(&self, table: &Table) -> Result<Contact<R>> {
        let number = |literal: &Literal| R::from_literal((), literal);
        let adhesion = self.adhesion(|literal| Ok(number(literal)))?;
        let medium = medium::Medium::half_space(number(&self.effective_modulus))?;
        Ok(Contact::new(table.profile::<R>(())?, medium, adhesion, self.control.map(number)))
    }

    /// The adhesion: that of an edge, or of both, of which the receding one is considered.
    fn adhesion<R: Real>(&self, number: impl Fn(&Literal) -> Result<R>) -> Result<Adhesion<R>> {
        match &self.works {
            None => Adhesion::new(number(&self.work_of_adhesion)?),
            Some(works) => {
                let both = Adhesion::hysteretic(number(&works[0])?, number(&works[1])?)?;
                Ok(both.at(self.edge.unwrap_or(Edge::Receding)))
            }
        }
    }
}

/// A function of a program in another arithmetic than f64.
pub(crate) fn not_in_f64() -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the profile"),
        value: "a function of a program".to_owned(),
        requirement: "one that has more digits than f64: a shape, a formula or a table; or ask for f64",
    }
}

/// A name of a formula without a value.
fn unnamed(error: ExpressionError) -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the formula"),
        value: error.to_string(),
        requirement: "one whose names all have values",
    }
}

/// The transformed profile: a closed form where there is one, `formulas` of a formula where the arithmetic has it, else its
/// quadrature, and exact pieces of a table. `number` gets its numbers in the order of [`Profile::numbers`].
///
/// # Errors
/// A parameter out of the domain of the profile; a wave, which needs a periodic medium.
pub(crate) fn by_formulas<R: ProfileReal>(
    profile: &Profile,
    ctx: R::Ctx,
    number: &mut dyn FnMut(&Literal) -> R,
    formulas: Formulas<'_, R>,
) -> Result<Box<dyn Transform<R>>> {
    Ok(match profile {
        Profile::Shape(shape) => R::closed_form(shape.map(|_, literal| number(literal)))?,
        Profile::Sum(terms) => {
            let terms = terms.iter().map(|term| by_formulas(term, ctx, number, formulas));
            R::sum(terms.collect::<Result<_>>()?)
        }
        Profile::Formula(formula) => {
            if let Some(transform) = formulas(profile) {
                return transform;
            }
            by_quadrature(formula.bound(ctx, number)?, |bound| {
                let quadrature = Quadrature::new(bound);
                #[cfg(feature = "mp")]
                let quadrature = if R::from_int(ctx, 1).precision() <= f64::MANTISSA_DIGITS {
                    quadrature.lost_below(formula.lost.map(|radius| R::from_f64(ctx, radius)))
                } else {
                    quadrature
                };
                Ok(quadrature)
            })?
        }
        Profile::Table(measured) => Box::new(measured.table.profile::<R>(ctx)?),
        Profile::Function(function) => {
            let function = function.in_arithmetic::<R>(ctx).ok_or_else(not_in_f64)?;
            by_quadrature(function, |function| Ok(Quadrature::new(function)))?
        }
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
    pub(crate) fn bound<R: Special>(
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
    pub fn transform<R: ProfileReal>(
        &self,
        ctx: R::Ctx,
        number: &mut dyn FnMut(&Literal) -> R,
    ) -> Result<Box<dyn Transform<R>>> {
        self.transform_on(&ExactMedium::HalfSpace, ctx, number)
    }

    /// The transformed profile g for a medium: that of [`Profile::transform`] on a half-space, and with the weight of the medium
    /// on others. `number` turns the numbers of the profile into the arithmetic, in the order of [`Profile::numbers`]; those of
    /// the medium are constants.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// // g = f on a Winkler foundation.
    /// let (ball, springs) = (Profile::Shape(Shape::Paraboloid { radius: "2".parse()? }), "1".parse()?);
    /// let g = ball.transform_on::<f64>(&ExactMedium::Winkler { modulus: springs }, (), &mut |number| number.nearest_f64())?;
    /// assert!((g.g(&0.2)? - 0.01).abs() < 1e-17);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A parameter out of the domain of the profile; a profile that the medium has no transform of.
    pub fn transform_on<R: ProfileReal>(
        &self,
        medium: &ExactMedium,
        ctx: R::Ctx,
        number: &mut dyn FnMut(&Literal) -> R,
    ) -> Result<Box<dyn Transform<R>>> {
        R::transform(self, medium, ctx, number, &|_| None)
    }
}

/// The transform of a profile in f64.
///
/// # Errors
/// A parameter of the profile that is out of its domain.
pub(crate) fn transform_in_doubles(profile: &Profile) -> Result<Box<dyn Transform<f64>>> {
    profile.transform((), &mut Literal::nearest_f64)
}
