//! The curve of a contact as it is observed, and its exact derivatives, in any arithmetic.

use std::sync::Arc;

use mdr::contact::GradedReal;
use mdr_analytic::Kappa;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Control, Result, Transform};
use mdr_core::number::{Dual, Literal, Real, Special};
use mdr_numeric::medium::Adhesion;

use super::observation::Observation;
use super::problem::{Kind, Problem};
use mdr::scene::Medium;

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
    medium: Medium,
    /// The medium with a modulus of one.
    unit: mdr_numeric::medium::Medium<R>,
    /// g and its relatives, for the medium.
    pub(super) transform: Arc<dyn Transform<R>>,
    /// With no number seeded: for g''.
    curvature: DualTransform<R>,
    /// With the logarithm of one number seeded, by its index.
    seeded: Vec<(usize, DualTransform<R>)>,
}

impl<R: Struve + Kappa + GradedReal> Tip<R> {
    /// With derivatives with respect to the numbers of these indices.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn new(problem: &Problem, ctx: R::Ctx, numbers: &[R], free: &[usize]) -> Result<Self>
    where
        Dual<R>: Struve + Kappa + GradedReal + Real<Ctx = R::Ctx>,
    {
        let (profile, medium) = (&problem.profile, &problem.medium);
        let dual = |index: Option<usize>| {
            let mut places = numbers.iter().enumerate();
            let mut number = |literal: &Literal| match places.next() {
                Some((place, number)) if Some(place) == index => Dual { value: number.clone(), slope: number.clone() },
                Some((_, number)) => Dual::constant(number.clone()),
                None => Dual::from_literal(ctx, literal),
            };
            profile.transform_on::<Dual<R>>(medium, ctx, &mut number).map(Arc::from)
        };
        let seeded = free.iter().map(|index| Ok((*index, dual(Some(*index))?))).collect::<Result<_>>()?;
        let mut places = numbers.iter();
        let mut number = |literal: &Literal| places.next().cloned().unwrap_or_else(|| R::from_literal(ctx, literal));
        let transform = profile.transform_on::<R>(medium, ctx, &mut number)?;
        let unit = medium.of_modulus(ctx, R::from_int(ctx, 1))?;
        let medium = medium.clone();
        Ok(Tip { medium, unit, transform: Arc::from(transform), curvature: dual(None)?, seeded })
    }

    /// The contact of the tip on its medium, by the modulus of the medium and the work of adhesion, under a control.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn on(&self, [modulus, work]: [R; 2], control: Control<R>) -> Result<mdr_numeric::contact::Contact<R>> {
        let (medium, adhesion) = (self.medium.of_modulus(modulus.ctx(), modulus)?, Adhesion::new(work)?);
        Ok(mdr_numeric::contact::Contact::sharing(Arc::clone(&self.transform), medium, adhesion, control))
    }

    /// The transform with the logarithm of a number of the profile seeded.
    fn seeded(&self, kind: Kind) -> Option<&DualTransform<R>> {
        let Kind::Profile(index) = kind else { return None };
        self.seeded.iter().find(|(seed, _)| *seed == index).map(|(_, dual)| dual)
    }
}

impl Tip<f64> {
    /// The work of adhesion over the modulus at which contacts are about as large as this length: the length itself where w/E* is
    /// one, on a half-space and a half-plane.
    pub(super) fn work_of_length(&self, length: f64) -> f64 {
        self.unit.work_of_length(&length)
    }

    /// The length of a work of adhesion over the modulus.
    pub(super) fn length_of_work(&self, work: f64) -> f64 {
        self.unit.length(&work)
    }

    /// S and SΔl of a contact of this radius, for a modulus and a work of adhesion of one.
    pub(super) fn unit_forces(&self, a: f64) -> [f64; 2] {
        if self.medium.is_half_space() {
            return [2.0 * a, (8.0 * std::f64::consts::PI * a.powi(3)).sqrt()];
        }
        let stiffness = self.unit.stiffness(&a);
        [stiffness, stiffness * self.unit.elongation(&1.0, &a)]
    }

    /// S and Δl of a contact of this radius, for a modulus of one and this work of adhesion over the modulus.
    pub(super) fn unit_springs(&self, work: f64, a: f64) -> [f64; 2] {
        if self.medium.is_half_space() {
            return [2.0 * a, (2.0 * std::f64::consts::PI * a * work).sqrt()];
        }
        [self.unit.stiffness(&a), self.unit.elongation(&work, &a)]
    }
}

/// How a contact of radius a answers to its radius: S and Δl with their derivatives.
struct Springs<R> {
    /// The modulus M of the medium; 2E* of a half-space.
    factor: R,
    /// S/M with its two derivatives; a, 1 and 0 of a half-space.
    stiffness: [R; 3],
    /// Δl with its two derivatives.
    elongation: [R; 3],
}

impl<R: Special> Springs<R> {
    /// # Errors
    /// A number out of its domain.
    fn new(medium: &Medium, numbers: &Numbers<R>, a: &R) -> Result<Self> {
        let Numbers { e_star, work, .. } = numbers;
        if medium.is_half_space() {
            let elongation = (a.pi().times(2) * a * work / e_star).sqrt();
            let slope = elongation.clone() / &a.clone().times(2);
            let curvature = -(elongation.clone() / &a.square().times(4));
            return Ok(Springs {
                factor: e_star.clone().times(2),
                stiffness: [a.clone(), a.lit(1), a.lit(0)],
                elongation: [elongation, slope, curvature],
            });
        }
        let constant = |x: R| Dual::constant(Dual::constant(x));
        let radius = Dual { value: Dual::variable(a.clone()), slope: Dual::constant(a.lit(1)) };
        let unit = medium.of_modulus(a.ctx(), constant(a.lit(1)))?;
        let of = |whole: Dual<Dual<R>>| [whole.value.value, whole.value.slope, whole.slope.slope];
        let elongation = of(unit.elongation(&constant(work.clone() / e_star), &radius));
        Ok(Springs { factor: e_star.clone(), stiffness: of(unit.stiffness(&radius)), elongation })
    }

    /// F' over the factor, (S d' − S'Δl)/M.
    fn slope_of_force(&self, d_slope: &R, lag: &R) -> R {
        let [stiffness, slope, _] = &self.stiffness;
        stiffness.clone() * d_slope - slope.clone() * lag
    }
}

/// A state of the curve with its observed place and its tangent.
#[derive(Clone, Debug)]
pub(super) struct Point<R> {
    /// The contact radius, or the outer radius of a vertical edge, where the contact stays.
    pub(super) a: R,
    pub(super) d: R,
    pub(super) f: R,
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

impl<'t, R: Struve + Kappa + GradedReal> Contact<'t, R> {
    pub(super) fn new(tip: &'t Tip<R>, numbers: Numbers<R>, observation: Observation) -> Self {
        let edge = tip.transform.outer_radius().filter(|_| tip.transform.vertical_edge());
        Contact { tip, numbers, observation, edge }
    }

    fn springs(&self, a: &R) -> Result<Springs<R>> {
        Springs::new(&self.tip.medium, &self.numbers, a)
    }

    /// S, the stiffness of a contact of this radius.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn stiffness(&self, a: &R) -> Result<R> {
        let Springs { factor, stiffness: [stiffness, ..], .. } = self.springs(a)?;
        Ok(factor * &stiffness)
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
        let springs = self.springs(&a)?;
        let [elongation, change, _] = &springs.elongation;
        let mut d = transform.g(&a)? - elongation;
        // d' = g' − Δl', and F' = S d' − S'Δl along the curve; at an edge d' = 1 and F' = S.
        let (d_slope, a_slope, lag) = match edge {
            None => (transform.slope(&a)? - change, a.lit(1), elongation.clone()),
            Some(edge) => {
                d += &(s.clone() - edge);
                (a.lit(1), a.lit(0), a.lit(0))
            }
        };
        let above_mean = d.clone() - transform.mean(&a)?;
        let f = springs.factor.clone() * &springs.stiffness[0] * &above_mean;
        let f_slope = springs.slope_of_force(&d_slope, &lag) * &springs.factor;
        let [x, y] = self.observe(d.clone(), f.clone(), a.clone());
        let [x0, y0] = self.offsets(self.numbers.contact_point.clone(), self.numbers.baseline.clone());
        let slopes = [d_slope.clone(), f_slope.clone(), a_slope.clone()];
        let tangent = self.observe(d_slope, f_slope, a_slope);
        let beyond_edge = edge.is_some();
        Ok(Point { a, d, f, above_mean, at: [x + x0, y + y0], slopes, tangent, beyond_edge })
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
        let Point { a, above_mean, .. } = point;
        let Springs { factor, stiffness: [stiffness, slope, _], elongation: [elongation, change, _] } =
            self.springs(a)?;
        let half = elongation.over(2);
        // Both Δl and the force of the springs at the edge change with a factor of the modulus.
        let lever = factor.clone() * &stiffness * &half;
        Ok(match kind {
            Kind::EffectiveModulus => [half, lever + &point.f, a.lit(0)],
            Kind::WorkOfAdhesion => [-half, -lever, a.lit(0)],
            Kind::Profile(_) => {
                let Some(dual) = self.tip.seeded(kind) else { return Ok([a.lit(0), a.lit(0), a.lit(0)]) };
                // At a vertical edge the contact radius is a number of the profile.
                let at_edge = if point.beyond_edge { dual.outer_radius() } else { None };
                let radius = at_edge.unwrap_or_else(|| Dual::constant(a.clone()));
                let moved = radius.slope.clone();
                let d = dual.g(&radius)?.slope - change * &moved;
                let shift = d.clone() - &dual.mean(&radius)?.slope;
                let f = (moved.clone() * &slope * above_mean + stiffness * &shift) * &factor;
                [d, f, moved]
            }
            Kind::Stiffness | Kind::ContactPoint | Kind::Baseline => [a.lit(0), a.lit(0), a.lit(0)],
        })
    }

    /// The second derivatives of X and Y with respect to the parameter of the curve.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn curvature(&self, point: &Point<R>) -> Result<[R; 2]> {
        let Point { a, .. } = point;
        if point.beyond_edge {
            // There force is linear in depth.
            return Ok([a.lit(0), a.lit(0)]);
        }
        let slope = self.tip.curvature.slope(&Dual::variable(a.clone()))?;
        let Springs { factor, stiffness, elongation } = self.springs(a)?;
        let ([stiffness, growth, more], [elongation, change, bend]) = (stiffness, elongation);
        let d_slope = slope.value - &change;
        let d_curvature = slope.slope - bend;
        // (S d' − S'Δl)' = S'd' + S d'' − S'Δl' − S''Δl.
        let f_curvature = growth.clone() * &d_slope + stiffness * &d_curvature - growth * &change - more * &elongation;
        let f_curvature = f_curvature * &factor;
        Ok(self.observe(d_curvature, f_curvature, a.lit(0)))
    }

    /// ∂X' at a fixed contact radius, before a vertical edge.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn x_slope_partial(&self, kind: Kind, point: &Point<R>) -> Result<R> {
        let Point { a, slopes: [d_slope, f_slope, _], .. } = point;
        let springs = self.springs(a)?;
        let [elongation, change, _] = &springs.elongation;
        let (quarter, half) = (change.clone().over(2), elongation.clone().over(2));
        let zero = || a.lit(0);
        // F' = S d' − S'Δl changes with d' and Δl, and with the modulus itself.
        let (d, lag, own) = match kind {
            Kind::EffectiveModulus => (quarter, -half, springs.slope_of_force(d_slope, elongation)),
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
        let [stiffness, slope, _] = &springs.stiffness;
        let f = (own + stiffness.clone() * &d - slope.clone() * &lag) * &springs.factor;
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
