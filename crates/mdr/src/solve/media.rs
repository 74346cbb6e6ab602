//! The medium of a scene in one arithmetic, and the transform of its profile there.

use mdr_analytic::profiles::Sum;
use mdr_core::contact::{Body, Error, ExpressionProfile, Quantity, Result, Transform};
#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::Literal;
use mdr_numeric::medium;
use mdr_numeric::path::EventKind;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::{LineLoad, Periodic, Powers, Wave, Weighted};

use super::model::{SceneReal, by_formulas};
use crate::answer::Output;
use crate::scene::{Formula, Grading, Medium, Profile, Scene};

/// c of a graded half-space: as given, or 1/c = z₀ᵏ Σ (1 − ν²)/(h_N E).
fn stiffness_of_grade<R: SceneReal>(ctx: R::Ctx, k: &R, stiffness: &Grading) -> R {
    let number = |literal: &Literal| R::from_literal(ctx, literal);
    match stiffness {
        Grading::Coefficient(c) => number(c),
        Grading::Moduli { depth, bodies } => {
            let mut compliance = k.lit(0);
            for Body { youngs_modulus, poissons_ratio } in bodies {
                let nu = number(poissons_ratio);
                let plane = (nu.lit(1) - &nu) * (nu.lit(1) + &nu);
                compliance += &(plane / (R::factor_of_grade(k, &nu) * number(youngs_modulus)));
            }
            (compliance * number(depth).pow(k)).inv()
        }
    }
}

/// The medium of a scene.
///
/// # Errors
/// A number out of its domain.
pub(crate) fn medium<R: SceneReal>(scene: &Scene, ctx: R::Ctx) -> Result<medium::Medium<R>> {
    medium_of(scene, ctx, None)
}

/// The medium with its modulus as in the scene, or with a given one.
pub(crate) fn medium_of<R: SceneReal>(scene: &Scene, ctx: R::Ctx, given: Option<R>) -> Result<medium::Medium<R>> {
    let number = |literal: &Literal| R::from_literal(ctx, literal);
    let modulus = || given.clone().unwrap_or_else(|| number(&scene.effective_modulus));
    match &scene.medium {
        Medium::Graded { exponent, stiffness } => {
            let exponent = number(exponent);
            let c = given.clone().unwrap_or_else(|| stiffness_of_grade(ctx, &exponent, stiffness));
            medium::Medium::graded(c, exponent)
        }
        Medium::Winkler { modulus } => medium::Medium::winkler(given.unwrap_or_else(|| number(modulus))),
        Medium::Plane { reference } => medium::Medium::plane(modulus(), reference.as_ref().map(number)),
        Medium::Periodic { wavelength, .. } => medium::Medium::periodic(modulus(), number(wavelength)),
        _ => medium::Medium::half_space(modulus()),
    }
}

impl Scene {
    /// The modulus that is the scale of all forces, exactly or, where it is no rational number, as the double nearest to it.
    #[cfg(feature = "mp")]
    pub(crate) fn scale_of_forces(&self) -> Literal {
        match &self.medium {
            Medium::Winkler { modulus } => modulus.clone(),
            Medium::Graded { stiffness: Grading::Coefficient(c), .. } => c.clone(),
            Medium::Graded { exponent, stiffness } => {
                use mdr_core::number::Real;
                let precision = mdr_core::number::Precision::new(64);
                let c = stiffness_of_grade(precision, &Interval::from_literal(precision, exponent), stiffness);
                Literal::try_from(c.approx()).unwrap_or_else(|_| 1.into())
            }
            _ => self.effective_modulus.clone(),
        }
    }

    /// Whether the transform of the profile on the medium is a closed form; otherwise it is a quadrature or measured.
    pub(crate) fn is_closed(&self) -> bool {
        match &self.medium {
            medium if medium.is_half_space() => self.profile.is_closed(),
            Medium::Periodic { .. } => matches!(self.profile, Profile::Wave(_)),
            _ => powers::<f64>(&self.profile, ()).is_some(),
        }
    }

    /// Whether the transform of the profile on the medium can be enclosed: a closed form, or rigorous integrals of formulas.
    pub(crate) fn is_enclosed(&self) -> bool {
        if self.medium.is_half_space() { self.profile.is_enclosed() } else { self.is_closed() }
    }

    /// Whether the fold under a dead load is at the depth 0, exactly: that of a power n = (3 + k)/2, such as a paraboloid on a
    /// Winkler foundation.
    #[cfg(feature = "mp")]
    pub(crate) fn breaks_at_zero_depth(&self) -> bool {
        let k = match &self.medium {
            Medium::Graded { exponent, .. } => exponent.to_rational(),
            Medium::Winkler { .. } => 1.into(),
            _ => return false,
        };
        let order = (k + 3u32) / 2u32;
        let law = self.profile.exact_power_law(Literal::to_rational);
        let has_order = law.is_some_and(|[n, _]| n.to_rational() == order);
        self.control == mdr_core::contact::Control::Force && has_order
    }

    /// The rows of a table, where its transform is measured exactly: on a half-space.
    pub(crate) fn exact_rows(&self) -> Option<usize> {
        self.profile.rows().filter(|_| self.medium.is_half_space())
    }
}

/// A profile as a sum of powers C rⁿ: n and C of each; `None` for another profile.
fn powers<R: SceneReal>(profile: &Profile, ctx: R::Ctx) -> Option<Vec<[R; 2]>> {
    match profile {
        Profile::Shape(shape) => shape.map(|_, literal| R::from_literal(ctx, literal)).powers(),
        Profile::Sum(terms) => {
            let terms: Option<Vec<_>> = terms.iter().map(|term| powers::<R>(term, ctx)).collect();
            Some(terms?.concat())
        }
        _ => None,
    }
}

/// The transform of the profile of a scene on its medium. A quadrature takes a relative error that is `accepted` where it cannot
/// have the digits of the arithmetic.
///
/// # Errors
/// A parameter out of the domain of the profile; a profile that the medium has no transform of.
pub(crate) fn transform<R: SceneReal>(scene: &Scene, ctx: R::Ctx) -> Result<Box<dyn Transform<R>>> {
    let accepted = R::accepted(scene, ctx);
    let number = |literal: &Literal| R::from_literal(ctx, literal);
    let of_medium = match &scene.medium {
        Medium::Periodic { wavelength, .. } => {
            return periodic(&scene.profile, ctx, number(wavelength), accepted);
        }
        Medium::Graded { exponent, .. } => OfMedium::Graded(number(exponent)),
        Medium::Winkler { .. } => OfMedium::Winkler,
        Medium::Plane { .. } => OfMedium::Line,
        _ => {
            let formulas = &|formula: &Formula| R::of_formula(formula, ctx);
            return by_formulas(&scene.profile, ctx, &mut |literal| number(literal), accepted.as_ref(), formulas);
        }
    };
    let reference = match &scene.medium {
        Medium::Plane { reference } => reference.as_ref().map(number),
        _ => None,
    };
    if let Some(terms) = powers::<R>(&scene.profile, ctx) {
        let sum = Powers::new(terms.into_iter().map(|[n, c]| of_medium.power(n, c)))?;
        return Ok(match of_medium {
            OfMedium::Line => Box::new(LineLoad::of_powers(sum, reference)),
            _ => Box::new(sum),
        });
    }
    let whole = quadrature(&scene.profile, ctx, &of_medium, accepted.as_ref())?;
    Ok(match of_medium {
        OfMedium::Line => Box::new(LineLoad::new(whole, reference)),
        _ => whole,
    })
}

/// The transform of a wave, or by quadrature of a periodic formula.
fn periodic<R: SceneReal>(
    profile: &Profile,
    ctx: R::Ctx,
    wavelength: R,
    accepted: Option<R>,
) -> Result<Box<dyn Transform<R>>> {
    match profile {
        Profile::Wave(amplitude) => Ok(Box::new(Wave::new(R::from_literal(ctx, amplitude), wavelength)?)),
        Profile::Formula(formula) => {
            let quadrature = Periodic::new(bound::<R>(formula, ctx)?, wavelength)?;
            Ok(Box::new(match accepted {
                Some(error) => quadrature.accepting(error),
                None => quadrature,
            }))
        }
        _ => Err(not_available("a periodic medium")),
    }
}

/// A formula with the numbers of the scene in one arithmetic.
fn bound<R: SceneReal>(formula: &Formula, ctx: R::Ctx) -> Result<ExpressionProfile<R>> {
    formula.bound(ctx, &mut |literal| R::from_literal(ctx, literal))
}

/// What decides the transform.
enum OfMedium<R> {
    Graded(R),
    Winkler,
    Line,
}

impl<R: SceneReal> OfMedium<R> {
    /// n, the factor of xⁿ in g, and the mean of g over g, of C rⁿ.
    fn power(&self, n: R, c: R) -> [R; 3] {
        match self {
            OfMedium::Graded(k) => {
                let order = k.lit(1) + k;
                let mean = order.clone() / (n.clone() + order);
                let factor = R::kappa_of_grade(&n, k) * c;
                [n, factor, mean]
            }
            OfMedium::Winkler => {
                let mean = n.lit(2) / (n.clone() + n.lit(2));
                [n, c, mean]
            }
            OfMedium::Line => {
                let factor = n.pi() * &n / R::kappa_of_grade(&n, &n.lit(0)).times(2) * c;
                let mean = n.lit(0);
                [n, factor, mean]
            }
        }
    }

    fn of(
        &self,
        profile: impl mdr_core::contact::Profile<R> + 'static,
        ctx: R::Ctx,
        accepted: Option<&R>,
    ) -> Box<dyn Transform<R>> {
        let like = R::from_int(ctx, 1);
        let weighted = match self {
            OfMedium::Graded(k) => Weighted::graded(profile, k.clone()),
            OfMedium::Winkler => Weighted::winkler(profile, like),
            OfMedium::Line => Weighted::line(profile, like),
        };
        Box::new(match accepted {
            Some(error) => weighted.accepting(error.clone()),
            None => weighted,
        })
    }
}

/// The transform by quadrature.
fn quadrature<R: SceneReal>(
    profile: &Profile,
    ctx: R::Ctx,
    medium: &OfMedium<R>,
    accepted: Option<&R>,
) -> Result<Box<dyn Transform<R>>> {
    Ok(match profile {
        Profile::Shape(shape) => {
            let heights = Heights::new([shape.map(|_, literal| R::from_literal(ctx, literal))])?;
            medium.of(heights, ctx, accepted)
        }
        Profile::Sum(terms) => {
            let terms = terms.iter().map(|term| quadrature(term, ctx, medium, accepted)).collect::<Result<_>>()?;
            Box::new(Sum::new(terms))
        }
        Profile::Formula(formula) => medium.of(bound::<R>(formula, ctx)?, ctx, accepted),
        Profile::Table(measured) => medium.of(measured.table.profile::<R>(ctx)?, ctx, accepted),
        Profile::Wave(_) => return Err(not_available("this medium")),
    })
}

/// What has to be said of the outputs on this medium.
pub(crate) fn note(scene: &Scene, outputs: &[Output]) -> Option<String> {
    let is_complete = |output: &Output| match output {
        Output::Path(path) => path.events.items.iter().any(|event| event.event == EventKind::CompleteContact),
        _ => false,
    };
    match scene.medium {
        Medium::Plane { reference: None } if scene.has(|kind| !kind.is_of_profile()) => Some(
            "a line contact has no depth without a reference, [medium] reference; forces are per length".to_owned(),
        ),
        Medium::Periodic { .. } if outputs.iter().any(is_complete) => Some(
            "a complete contact has no edge from which it could open: without a flaw it never detaches, at any tension"
                .to_owned(),
        ),
        _ => None,
    }
}

fn not_available(what: &str) -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the profile"),
        value: what.to_owned(),
        requirement: "one whose transform is available on the medium",
    }
}
