//! The medium of a scene in one arithmetic, and the transform of its profile there.

use mdr_core::contact::{Body, Error, Quantity, Result, Transform};
#[cfg(feature = "mp")]
use mdr_core::contact::{Control, EnclosedFormula};
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, Precision};
use mdr_core::number::{Literal, Special};
use mdr_numeric::medium;
use mdr_numeric::path::EventKind;
use mdr_numeric::profiles::Heights;
use mdr_numeric::table::MeasuredProfile;
#[cfg(feature = "mp")]
use mdr_numeric::transform::Enclosed;
use mdr_numeric::transform::{LineLoad, Periodic, Powers, Wave, Weighted};

use super::graded::GradedReal;
use crate::answer::Output;
use crate::scene::{
    ExactMedium, Formulas, Grading, Profile, ProfileReal, Scene, by_formulas, by_quadrature, not_in_f64,
};

/// c of a graded half-space: as given, or 1/c = z₀ᵏ Σ (1 − ν²)/(h_N E).
fn stiffness_of_grade<R: GradedReal>(ctx: R::Ctx, k: &R, stiffness: &Grading) -> R {
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
pub(crate) fn medium<R: GradedReal>(scene: &Scene, ctx: R::Ctx) -> Result<medium::Medium<R>> {
    let number = |literal: &Literal| R::from_literal(ctx, literal);
    medium_of(&scene.medium, ctx, || match &scene.medium {
        ExactMedium::Graded { exponent, stiffness } => stiffness_of_grade(ctx, &number(exponent), stiffness),
        ExactMedium::Winkler { modulus } => number(modulus),
        _ => number(&scene.effective_modulus),
    })
}

/// The medium with a given modulus.
///
/// # Errors
/// A number out of its domain.
pub(crate) fn medium_of<R: Special>(
    medium: &ExactMedium,
    ctx: R::Ctx,
    modulus: impl FnOnce() -> R,
) -> Result<medium::Medium<R>> {
    let number = |literal: &Literal| R::from_literal(ctx, literal);
    match medium {
        ExactMedium::Graded { exponent, .. } => medium::Medium::graded(modulus(), number(exponent)),
        ExactMedium::Winkler { .. } => medium::Medium::winkler(modulus()),
        ExactMedium::Plane { reference } => medium::Medium::plane(modulus(), reference.as_ref().map(number)),
        ExactMedium::Periodic { wavelength, .. } => medium::Medium::periodic(modulus(), number(wavelength)),
        ExactMedium::HalfSpace => medium::Medium::half_space(modulus()),
    }
}

impl ExactMedium {
    /// The modulus that the medium has itself, in one arithmetic: c of a graded half-space, K_w of a Winkler foundation. `None`
    /// where E* of the material is the modulus.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// assert_eq!(ExactMedium::Winkler { modulus: "5".parse()? }.own_modulus::<f64>(())?, Some(5.0));
    /// assert_eq!(ExactMedium::HalfSpace.own_modulus::<f64>(())?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A number out of its domain, with its place.
    pub fn own_modulus<R: GradedReal>(&self, ctx: R::Ctx) -> crate::Result<Option<R>> {
        let number = |literal: &Literal| R::from_literal(ctx, literal);
        let medium = self.clone().check(&|key| crate::scene::Location::built(&format!("medium.{key}")))?;
        Ok(match &medium {
            ExactMedium::Graded { exponent, stiffness } => Some(stiffness_of_grade(ctx, &number(exponent), stiffness)),
            ExactMedium::Winkler { modulus } => Some(number(modulus)),
            _ => None,
        })
    }

    /// The medium with its modulus in one arithmetic: E*, c of a graded half-space, K_w of a Winkler foundation, in place of the
    /// one it was given.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let springs = ExactMedium::Winkler { modulus: "1".parse()? }.of_modulus((), 5.0)?;
    /// assert!((springs.stiffness(&1.0) / (5.0 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A number out of its domain.
    pub fn of_modulus<R: Special>(&self, ctx: R::Ctx, modulus: R) -> Result<medium::Medium<R>> {
        medium_of(self, ctx, || modulus)
    }
}

impl Scene {
    /// The modulus that is the scale of all forces, exactly or, where it is no rational number, as the double nearest to it.
    #[cfg(feature = "mp")]
    pub(crate) fn scale_of_forces(&self) -> Literal {
        match &self.medium {
            ExactMedium::Winkler { modulus } => modulus.clone(),
            ExactMedium::Graded { stiffness: Grading::Coefficient(c), .. } => c.clone(),
            ExactMedium::Graded { exponent, stiffness } => {
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
            ExactMedium::Periodic { .. } => matches!(self.profile, Profile::Wave(_)),
            _ => is_of_powers(&self.profile) || is_flat(&self.profile),
        }
    }

    /// Whether the transform of the profile on the medium can be enclosed: a closed form, or rigorous integrals of formulas.
    pub(crate) fn is_enclosed(&self) -> bool {
        if self.medium.is_half_space() {
            return self.profile.is_enclosed();
        }
        #[cfg(feature = "mp")]
        let written = self.profile.terms().iter().all(|term| is_flat(term) || term.written_on(&self.medium).is_some());
        #[cfg(not(feature = "mp"))]
        let written = false;
        self.is_closed() || written
    }

    /// Whether what is enclosed are rigorous integrals, or sums with one.
    #[cfg(feature = "mp")]
    pub(crate) fn is_by_integrals(&self) -> bool {
        !self.is_closed() && self.is_enclosed()
    }

    /// Whether g takes integrals over the profile, whose cost grows with the waves inside a radius.
    #[cfg(feature = "mp")]
    pub(crate) fn takes_integrals(&self) -> bool {
        self.profile.has_formula() || self.is_by_integrals()
    }

    /// Whether the fold at this contact radius under a dead load is at the depth 0, exactly: that of a power n = (3 + k)/2, 3/2 on a
    /// half-space, such as a paraboloid, or the parabolic cap of a cone, on a Winkler foundation.
    #[cfg(feature = "mp")]
    pub(crate) fn breaks_at_zero_depth(&self, radius: &Interval) -> bool {
        if !self.medium.has_depth() || self.control != Control::Force {
            return false;
        }
        // (3 + k)/2 is 2 less the threshold (1 − k)/2.
        let Some(order) = self.medium.threshold().map(|threshold| 2 - threshold) else { return false };
        let law = self.profile.exact_power_law(Literal::to_rational);
        match &self.profile {
            Profile::Shape(shape) if law.is_none() => {
                shape.law_at_tip().is_some_and(|(n, end)| order == n && *radius.upper() < end.to_rational())
            }
            _ => law.is_some_and(|[n, _]| n.to_rational() == order),
        }
    }

    /// Whether the energies of states are closed forms of their depth and size: on another medium than a half-space, of powers and of a wave.
    #[cfg(feature = "mp")]
    pub(crate) fn has_closed_energies(&self) -> bool {
        match &self.medium {
            ExactMedium::Graded { .. } | ExactMedium::Winkler { .. } => is_of_powers(&self.profile),
            ExactMedium::Periodic { .. } => matches!(self.profile, Profile::Wave(_)) && self.works.is_none(),
            _ => false,
        }
    }
}

/// A profile as a sum of powers C rⁿ: n and C of each; `None` for another profile.
fn powers<R: Special>(profile: &Profile, number: &mut dyn FnMut(&Literal) -> R) -> Option<Vec<[R; 2]>> {
    match profile {
        Profile::Shape(shape) => shape.map(|_, literal| number(literal)).powers(),
        Profile::Sum(terms) => {
            let terms: Option<Vec<_>> = terms.iter().map(|term| powers::<R>(term, number)).collect();
            Some(terms?.concat())
        }
        _ => None,
    }
}

/// Whether a profile is a sum of powers.
fn is_of_powers(profile: &Profile) -> bool {
    powers(profile, &mut Literal::nearest_f64).is_some()
}

/// The transform of a formula by rigorous integrals with the weight of a medium that is not periodic.
#[cfg(feature = "mp")]
pub(crate) fn enclosed(formula: EnclosedFormula, medium: &ExactMedium, ctx: Precision) -> Enclosed {
    use mdr_core::number::Real;
    let number = |literal: &Literal| Interval::from_literal(ctx, literal);
    match medium {
        ExactMedium::Graded { exponent, .. } => Enclosed::graded(formula, ctx, number(exponent)),
        ExactMedium::Winkler { .. } => Enclosed::winkler(formula, ctx),
        ExactMedium::Plane { reference } => Enclosed::line(formula, ctx, reference.as_ref().map(number)),
        _ => Enclosed::new(formula, ctx),
    }
}

/// Whether a profile is a flat face: g = 0 on every medium.
fn is_flat(profile: &Profile) -> bool {
    matches!(profile, Profile::Shape(shape) if shape.is_flat())
}

/// The transform of a profile on a medium. `number` gets the numbers of the profile in the order of [`Profile::numbers`]; `formulas` has
/// the transforms of formulas on a half-space that are better than a quadrature.
///
/// # Errors
/// A parameter out of the domain of the profile; a profile that the medium has no transform of.
pub(crate) fn transform<R: ProfileReal>(
    profile: &Profile,
    medium: &ExactMedium,
    ctx: R::Ctx,
    number: &mut dyn FnMut(&Literal) -> R,
    formulas: Formulas<'_, R>,
) -> Result<Box<dyn Transform<R>>> {
    let of_medium = |literal: &Literal| R::from_literal(ctx, literal);
    let (weight, reference) = match medium {
        ExactMedium::HalfSpace => return by_formulas(profile, ctx, number, formulas),
        ExactMedium::Periodic { wavelength, .. } => {
            return periodic(profile, ctx, number, of_medium(wavelength));
        }
        ExactMedium::Graded { exponent, .. } => (OfMedium::Graded(of_medium(exponent)), None),
        ExactMedium::Winkler { .. } => (OfMedium::Winkler, None),
        ExactMedium::Plane { reference } => {
            let reference = reference.as_ref().map(of_medium);
            (OfMedium::Line(reference.clone()), reference)
        }
    };
    if is_of_powers(profile)
        && let Some(terms) = powers(profile, number)
    {
        let sum = Powers::new(terms.into_iter().map(|[n, c]| weight.power(n, c)))?;
        return Ok(match weight {
            OfMedium::Line(_) => Box::new(LineLoad::of_powers(sum, reference)),
            _ => Box::new(sum),
        });
    }
    let whole = quadrature(profile, ctx, number, &weight, formulas)?;
    Ok(match weight {
        OfMedium::Line(_) => Box::new(LineLoad::new(whole, reference)),
        _ => whole,
    })
}

/// The transform of a wave, or by quadrature of another periodic profile.
fn periodic<R: ProfileReal>(
    profile: &Profile,
    ctx: R::Ctx,
    number: &mut dyn FnMut(&Literal) -> R,
    wavelength: R,
) -> Result<Box<dyn Transform<R>>> {
    Ok(match profile {
        Profile::Wave(amplitude) => Box::new(Wave::new(number(amplitude), wavelength)?),
        Profile::Formula(formula) => repeating(formula.bound::<R>(ctx, number)?, wavelength)?,
        Profile::Table(measured) => {
            let rows = measured.table.periodic_profile::<R>(ctx, &wavelength)?;
            repeating(rows, wavelength)?
        }
        Profile::Function(function) => repeating(function.in_arithmetic::<R>(ctx).ok_or_else(not_in_f64)?, wavelength)?,
        _ => return Err(not_available("a periodic medium")),
    })
}

/// The transform of a periodic profile by quadrature.
fn repeating<R: ProfileReal>(
    profile: impl mdr_core::contact::Profile<R> + 'static,
    wavelength: R,
) -> Result<Box<dyn Transform<R>>> {
    by_quadrature(profile, |profile| Periodic::new(profile, wavelength))
}

/// What decides the transform.
enum OfMedium<R> {
    Graded(R),
    Winkler,
    /// With the distance of its reference.
    Line(Option<R>),
}

impl<R: ProfileReal> OfMedium<R> {
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
            OfMedium::Line(_) => {
                let factor = n.pi() * &n / R::kappa_of_grade(&n, &n.lit(0)).times(2) * c;
                let mean = n.lit(0);
                [n, factor, mean]
            }
        }
    }

    fn of(&self, profile: impl mdr_core::contact::Profile<R> + 'static, ctx: R::Ctx) -> Result<Box<dyn Transform<R>>> {
        let like = R::from_int(ctx, 1);
        by_quadrature(profile, |profile| {
            Ok(match self {
                OfMedium::Graded(k) => Weighted::graded(profile, k.clone()),
                OfMedium::Winkler => Weighted::winkler(profile, like),
                OfMedium::Line(reference) => Weighted::line(profile, reference.clone(), like),
            })
        })
    }

    fn of_rows(&self, rows: MeasuredProfile<R>) -> Result<Box<dyn Transform<R>>> {
        by_quadrature(rows, |rows| match self {
            OfMedium::Graded(k) => rows.graded(k.clone()),
            OfMedium::Winkler => rows.winkler(),
            OfMedium::Line(reference) => rows.line(reference.clone()),
        })
    }
}

/// The transform by quadrature, or as `formulas` has it.
fn quadrature<R: ProfileReal>(
    profile: &Profile,
    ctx: R::Ctx,
    number: &mut dyn FnMut(&Literal) -> R,
    weight: &OfMedium<R>,
    formulas: Formulas<'_, R>,
) -> Result<Box<dyn Transform<R>>> {
    if let Some(transform) = formulas(profile) {
        return transform;
    }
    Ok(match profile {
        Profile::Shape(shape) if is_flat(profile) => R::closed_form(shape.map(|_, literal| number(literal)))?,
        Profile::Shape(shape) => {
            let heights = Heights::new([shape.map(|_, literal| number(literal))])?;
            weight.of(heights, ctx)?
        }
        Profile::Sum(terms) => {
            let terms =
                terms.iter().map(|term| quadrature(term, ctx, number, weight, formulas)).collect::<Result<_>>()?;
            R::sum(terms)
        }
        Profile::Formula(formula) => weight.of(formula.bound::<R>(ctx, number)?, ctx)?,
        Profile::Table(measured) => weight.of_rows(measured.table.profile::<R>(ctx)?)?,
        Profile::Function(function) => weight.of(function.in_arithmetic::<R>(ctx).ok_or_else(not_in_f64)?, ctx)?,
        Profile::Wave(_) => return Err(not_available("this medium")),
    })
}

/// The mean pressure at which a complete contact opens from its flaw, in Pa: that of the equilibrium with a = λ/2 − c.
fn opening(scene: &Scene) -> Option<f64> {
    let ExactMedium::Periodic { wavelength, flaw: Some(flaw) } = &scene.medium else { return None };
    let contact = scene.contact().ok()?;
    let half_width = wavelength.nearest_f64() / 2.0 - flaw.nearest_f64();
    contact.force(&contact.medium().size_within(&half_width).ok()?).ok()
}

/// What has to be said of the outputs on this medium.
pub(crate) fn note(scene: &Scene, outputs: &[Output]) -> Option<String> {
    let is_complete = |output: &Output| match output {
        Output::Path(path) => path.events.items.iter().any(|event| event.event == EventKind::CompleteContact),
        _ => false,
    };
    match &scene.medium {
        ExactMedium::Plane { reference: None } if scene.has(|kind| !kind.is_of_profile()) => Some(
            "a line contact has no depth without a reference, [medium] reference; forces are per length".to_owned(),
        ),
        ExactMedium::Periodic { .. } if outputs.iter().any(is_complete) => Some(match opening(scene) {
            Some(pressure) => format!(
                "the complete contact opens at the flaw in its troughs when the mean pressure falls to {pressure:.6e} Pa; `curve` at \
                 the contact radius λ/2 − c has its digits"
            ),
            None => "a complete contact has no edge from which it could open: without a flaw it never detaches, at any tension"
                .to_owned(),
        }),
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
