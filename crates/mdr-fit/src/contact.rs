//! The curve of a contact as it is observed, and its exact derivatives, in any arithmetic.

use std::sync::Arc;

use mdr_analytic::Kappa;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Control, Material, Result, Transform};
use mdr_core::number::{Dual, Literal, Real};

use super::observation::Observation;
use super::problem::{Kind, Problem};
use mdr::scene::Profile;

/// The numbers of a problem in one arithmetic.
#[derive(Clone, Debug)]
pub(super) struct Numbers<R> {
    pub(super) e_star: R,
    pub(super) work: R,
    pub(super) stiffness: Option<R>,
    pub(super) contact_point: R,
    pub(super) baseline: R,
    pub(super) profile: Vec<R>,
}

impl<R> Numbers<R> {
    /// The numbers of a problem: `value` gets the index of a parameter; an offset that the problem lacks is `zero`.
    pub(super) fn of(problem: &Problem, value: impl Fn(usize) -> R, zero: impl Fn() -> R) -> Self {
        let parameters = &problem.parameters;
        let of = |kind: Kind| parameters.iter().position(|parameter| parameter.kind == kind).map(&value);
        let is_of_profile = |index: &usize| matches!(parameters[*index].kind, Kind::Profile(_));
        Numbers {
            e_star: of(Kind::EffectiveModulus).unwrap_or_else(&zero),
            work: of(Kind::WorkOfAdhesion).unwrap_or_else(&zero),
            stiffness: of(Kind::Stiffness),
            contact_point: of(Kind::ContactPoint).unwrap_or_else(&zero),
            baseline: of(Kind::Baseline).unwrap_or_else(&zero),
            profile: (0..parameters.len()).filter(is_of_profile).map(&value).collect(),
        }
    }

    /// The number of a kind; `None` if the problem lacks it.
    #[cfg(feature = "mp")]
    pub(super) fn get(&self, kind: Kind) -> Option<&R> {
        match kind {
            Kind::EffectiveModulus => Some(&self.e_star),
            Kind::WorkOfAdhesion => Some(&self.work),
            Kind::Stiffness => self.stiffness.as_ref(),
            Kind::ContactPoint => Some(&self.contact_point),
            Kind::Baseline => Some(&self.baseline),
            Kind::Profile(index) => self.profile.get(index),
        }
    }
}

/// g with its derivatives with respect to one number.
type DualTransform<R> = Arc<dyn Transform<Dual<R>>>;

/// A profile for one set of its numbers: its transform, and the data for derivatives.
pub(super) struct Tip<R: Real> {
    /// g and its relatives.
    pub(super) transform: Arc<dyn Transform<R>>,
    /// With no number seeded: for g''.
    curvature: DualTransform<R>,
    /// With the logarithm of one number seeded, by its index.
    seeded: Vec<(usize, DualTransform<R>)>,
}

impl<R: Struve + Kappa> Tip<R> {
    /// With derivatives with respect to the numbers of these indices.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn new(profile: &Profile, ctx: R::Ctx, numbers: &[R], free: &[usize]) -> Result<Self>
    where
        Dual<R>: Struve + Kappa + Real<Ctx = R::Ctx>,
    {
        let dual = |index: Option<usize>| {
            let mut places = numbers.iter().enumerate();
            let mut number = |literal: &Literal| match places.next() {
                Some((place, number)) if Some(place) == index => Dual { value: number.clone(), slope: number.clone() },
                Some((_, number)) => Dual::constant(number.clone()),
                None => Dual::from_literal(ctx, literal),
            };
            profile.transform::<Dual<R>>(ctx, &mut number).map(Arc::from)
        };
        let seeded = free.iter().map(|index| Ok((*index, dual(Some(*index))?))).collect::<Result<_>>()?;
        let mut places = numbers.iter();
        let mut number = |literal: &Literal| places.next().cloned().unwrap_or_else(|| R::from_literal(ctx, literal));
        let transform = profile.transform::<R>(ctx, &mut number)?;
        Ok(Tip { transform: Arc::from(transform), curvature: dual(None)?, seeded })
    }

    /// The tip on a half-space, under a control.
    pub(super) fn on(&self, material: &Material<R>, control: Control<R>) -> mdr_numeric::contact::Contact<R> {
        let (medium, adhesion) = (material.into(), material.into());
        mdr_numeric::contact::Contact::sharing(Arc::clone(&self.transform), medium, adhesion, control)
    }

    /// The transform with the logarithm of a number of the profile seeded.
    fn seeded(&self, kind: Kind) -> Option<&DualTransform<R>> {
        let Kind::Profile(index) = kind else { return None };
        self.seeded.iter().find(|(seed, _)| *seed == index).map(|(_, dual)| dual)
    }
}

/// A state of the curve with its observed place and its tangent.
#[derive(Clone, Debug)]
pub(super) struct Point<R> {
    /// The contact radius, or the outer radius of a vertical edge, where the contact stays.
    pub(super) a: R,
    pub(super) d: R,
    pub(super) f: R,
    /// Δl(a).
    elongation: R,
    /// d less the mean of g.
    above_mean: R,
    /// (X, Y), offsets included.
    pub(super) at: [R; 2],
    /// Derivatives of d, F and a with respect to the parameter of the curve.
    pub(super) slopes: [R; 3],
    /// Derivatives of X and Y with respect to the parameter of the curve.
    pub(super) tangent: [R; 2],
    beyond_edge: bool,
}

/// A contact and how it is seen. The curve is parametrised by the contact radius; beyond a vertical edge the contact stays there,
/// and the parameter grows with the indentation.
pub(super) struct Contact<'t, R: Real> {
    pub(super) tip: &'t Tip<R>,
    pub(super) numbers: Numbers<R>,
    pub(super) observation: Observation,
    pub(super) edge: Option<R>,
}

impl<'t, R: Struve + Kappa> Contact<'t, R> {
    pub(super) fn new(tip: &'t Tip<R>, numbers: Numbers<R>, observation: Observation) -> Self {
        let edge = tip.transform.outer_radius().filter(|_| tip.transform.vertical_edge());
        Contact { tip, numbers, observation, edge }
    }

    /// The observed quantities as a linear map of (d, F, a), without offsets.
    fn observe(&self, d: R, f: R, a: R) -> [R; 2] {
        let bent = |f: &R| self.numbers.stiffness.as_ref().map_or_else(|| f.lit(0), |k| f.clone() / k);
        match self.observation {
            Observation::ForceOfIndentation => [d, f],
            Observation::ForceOfPosition => [d + bent(&f), f],
            Observation::DeflectionOfPosition => [d + bent(&f), bent(&f)],
            Observation::IndentationOfForce => [f, d],
            Observation::ForceOfRadius => [a, f],
            Observation::RadiusOfForce => [f, a],
        }
    }

    /// The terms that offsets of the contact point and of the baseline add to X and Y.
    fn offsets(&self, point: R, line: R) -> [R; 2] {
        match self.observation {
            Observation::IndentationOfForce => [line, point],
            Observation::ForceOfRadius => [point.lit(0), line],
            Observation::RadiusOfForce => [line, point.lit(0)],
            _ => [point, line],
        }
    }

    /// The state at a parameter of the curve.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn point(&self, s: &R) -> Result<Point<R>> {
        let edge = self.edge.as_ref().filter(|edge| s > *edge);
        let a = edge.unwrap_or(s).clone();
        let transform = &self.tip.transform;
        let Numbers { e_star, work, .. } = &self.numbers;
        let elongation = (a.pi().times(2) * &a * work / e_star).sqrt();
        let mut d = transform.g(&a)? - &elongation;
        // d' = g' − Δl/2a, and F' = 2E*(a d' − Δl) along the curve; at an edge d' = 1 and F' = 2E*a.
        let (d_slope, a_slope, lag) = match edge {
            None => (transform.slope(&a)? - elongation.clone() / &a.clone().times(2), a.lit(1), elongation.clone()),
            Some(edge) => {
                d += &(s.clone() - edge);
                (a.lit(1), a.lit(0), a.lit(0))
            }
        };
        let above_mean = d.clone() - transform.mean(&a)?;
        let double = e_star.clone().times(2);
        let f = double.clone() * &a * &above_mean;
        let f_slope = double * &(a.clone() * &d_slope - lag);
        let [x, y] = self.observe(d.clone(), f.clone(), a.clone());
        let [x0, y0] = self.offsets(self.numbers.contact_point.clone(), self.numbers.baseline.clone());
        let slopes = [d_slope.clone(), f_slope.clone(), a_slope.clone()];
        let tangent = self.observe(d_slope, f_slope, a_slope);
        let beyond_edge = edge.is_some();
        Ok(Point { a, d, f, elongation, above_mean, at: [x + x0, y + y0], slopes, tangent, beyond_edge })
    }

    /// ∂(X, Y) at a fixed parameter of the curve, with respect to an offset or to the logarithm of another number.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn partial(&self, kind: Kind, point: &Point<R>) -> Result<[R; 2]> {
        let zero = || point.a.lit(0);
        match kind {
            Kind::EffectiveModulus | Kind::WorkOfAdhesion | Kind::Profile(_) => {
                let [d, f, a] = self.state_partial(kind, point)?;
                Ok(self.observe(d, f, a))
            }
            Kind::Stiffness => {
                let [x, y] = self.observe(zero(), point.f.clone(), zero());
                // Only what is divided by k depends on it.
                let y = if self.observation == Observation::DeflectionOfPosition { -y } else { zero() };
                Ok([-x, y])
            }
            Kind::ContactPoint | Kind::Baseline => {
                let one = |mine: Kind| if mine == kind { point.a.lit(1) } else { zero() };
                Ok(self.offsets(one(Kind::ContactPoint), one(Kind::Baseline)))
            }
        }
    }

    /// ∂(d, F, a) at a fixed parameter of the curve.
    pub(super) fn state_partial(&self, kind: Kind, point: &Point<R>) -> Result<[R; 3]> {
        let Point { a, elongation, above_mean, .. } = point;
        let half = elongation.clone().over(2);
        let e_star = &self.numbers.e_star;
        let lever = e_star.clone() * a * elongation;
        Ok(match kind {
            Kind::EffectiveModulus => [half, lever + &point.f, a.lit(0)],
            Kind::WorkOfAdhesion => [-half, -lever, a.lit(0)],
            Kind::Profile(_) => {
                let Some(dual) = self.tip.seeded(kind) else { return Ok([a.lit(0), a.lit(0), a.lit(0)]) };
                // At a vertical edge the contact radius is a number of the profile.
                let at_edge = if point.beyond_edge { dual.outer_radius() } else { None };
                let radius = at_edge.unwrap_or_else(|| Dual::constant(a.clone()));
                let moved = radius.slope.clone();
                let d = dual.g(&radius)?.slope - half / a * &moved;
                let f = (moved.clone() * above_mean + a.clone() * &(d.clone() - &dual.mean(&radius)?.slope)) * e_star;
                [d, f.times(2), moved]
            }
            Kind::Stiffness | Kind::ContactPoint | Kind::Baseline => [a.lit(0), a.lit(0), a.lit(0)],
        })
    }

    /// The second derivatives of X and Y with respect to the parameter of the curve.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn curvature(&self, point: &Point<R>) -> Result<[R; 2]> {
        let Point { a, elongation, .. } = point;
        if point.beyond_edge {
            // There force is linear in depth.
            return Ok([a.lit(0), a.lit(0)]);
        }
        let slope = self.tip.curvature.slope(&Dual::variable(a.clone()))?;
        let d_slope = slope.value - elongation.clone() / &a.clone().times(2);
        let d_curvature = slope.slope + elongation.clone() / &a.square().times(4);
        let f_curvature = (d_slope + a.clone() * &d_curvature - elongation.clone() / &a.clone().times(2))
            * &self.numbers.e_star.clone().times(2);
        Ok(self.observe(d_curvature, f_curvature, a.lit(0)))
    }

    /// ∂X' at a fixed contact radius, before a vertical edge.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn x_slope_partial(&self, kind: Kind, point: &Point<R>) -> Result<R> {
        let Point { a, elongation, slopes: [d_slope, f_slope, _], .. } = point;
        let (quarter, half) = (elongation.clone() / &a.clone().times(4), elongation.clone().over(2));
        let zero = || a.lit(0);
        // F' = 2E*(a d' − Δl) changes with d' and Δl, and with E* itself.
        let (d, lag, own) = match kind {
            Kind::EffectiveModulus => (quarter, -half, a.clone() * d_slope - elongation),
            Kind::WorkOfAdhesion => (-quarter, half, zero()),
            Kind::Profile(_) => match self.tip.seeded(kind) {
                Some(dual) => (dual.slope(&Dual::constant(a.clone()))?.slope, zero(), zero()),
                None => return Ok(zero()),
            },
            Kind::Stiffness => {
                let [x, _] = self.observe(zero(), f_slope.clone(), zero());
                return Ok(-x);
            }
            Kind::ContactPoint | Kind::Baseline => return Ok(zero()),
        };
        let f = (own + a.clone() * &d - lag) * &self.numbers.e_star.clone().times(2);
        let [x, _] = self.observe(d, f, zero());
        Ok(x)
    }

    /// How fast the radius of a vertical edge grows with a number of the profile.
    pub(super) fn edge_partial(&self, kind: Kind) -> R {
        let edge = self.tip.seeded(kind).and_then(|dual| dual.outer_radius());
        edge.map_or_else(|| self.numbers.e_star.lit(0), |edge| edge.slope)
    }

    /// How fast a kink of the profile at this radius moves with a number of it.
    pub(super) fn kink_partial(&self, kind: Kind, radius: &R) -> R {
        let kinks = self.tip.seeded(kind).map(|dual| dual.kinks()).unwrap_or_default();
        kinks.into_iter().find(|kink| kink.value == *radius).map_or_else(|| radius.lit(0), |kink| kink.slope)
    }
}
