//! The curve of a contact as it is observed, and its exact derivatives, in any arithmetic.

use std::sync::Arc;

use mdr::contact::ProfileReal;
use mdr_core::contact::{Control, Edge, Result, Transform};
use mdr_core::number::{Dual, Literal, Real, Special};
use mdr_numeric::contact::Input;
use mdr_numeric::medium::Adhesion;

use super::observation::Observation;
use super::problem::{DataRow, Kind, Problem};
use mdr::scene::ExactMedium;

/// The numbers of a problem in one arithmetic.
#[derive(Clone, Debug)]
pub(super) struct Numbers<R> {
    pub(super) e_star: R,
    /// The work of adhesion; of an edge, where each direction has its own.
    pub(super) work: R,
    /// Of an edge that advances, and that recedes.
    pub(super) works: Option<[R; 2]>,
    pub(super) stiffness: Option<R>,
    pub(super) sensitivity: Option<R>,
    pub(super) contact_point: R,
    pub(super) baseline: R,
    pub(super) profile: Vec<R>,
    /// The slope of the baseline, and the drifts of baseline and position.
    pub(super) trends: [R; 3],
}

impl<R> Numbers<R> {
    /// The numbers of a problem: `value` gets the index of a parameter; an offset that the problem lacks is `zero`.
    pub(super) fn of(problem: &Problem, value: impl Fn(usize) -> R, zero: impl Fn() -> R) -> Self {
        let parameters = &problem.parameters;
        let of = |kind: Kind| parameters.iter().position(|parameter| parameter.kind == kind).map(&value);
        let is_of_profile = |index: &usize| matches!(parameters[*index].kind, Kind::Profile(_));
        let or_zero = |kind: Kind| of(kind).unwrap_or_else(&zero);
        let works = [Edge::Advancing, Edge::Receding].map(|edge| or_zero(Kind::Work(edge)));
        Numbers {
            e_star: of(Kind::EffectiveModulus).unwrap_or_else(&zero),
            work: of(Kind::WorkOfAdhesion).unwrap_or_else(&zero),
            works: problem.has_two_works().then_some(works),
            stiffness: of(Kind::Stiffness),
            sensitivity: of(Kind::Sensitivity),
            contact_point: of(Kind::ContactPoint).unwrap_or_else(&zero),
            baseline: of(Kind::Baseline).unwrap_or_else(&zero),
            profile: (0..parameters.len()).filter(is_of_profile).map(&value).collect(),
            trends: [Kind::BaselineSlope, Kind::BaselineDrift, Kind::PositionDrift].map(or_zero),
        }
    }

    /// The number of a kind; `None` if the problem lacks it.
    #[cfg(feature = "mp")]
    pub(super) fn get(&self, kind: Kind) -> Option<&R> {
        match kind {
            Kind::EffectiveModulus => Some(&self.e_star),
            Kind::WorkOfAdhesion => Some(&self.work),
            Kind::Work(edge) => self.works.as_ref().map(|works| &works[edge as usize]),
            Kind::Stiffness => self.stiffness.as_ref(),
            Kind::Sensitivity => self.sensitivity.as_ref(),
            Kind::BaselineSlope => self.trends.first(),
            Kind::BaselineDrift => self.trends.get(1),
            Kind::PositionDrift => self.trends.get(2),
            Kind::ContactPoint => Some(&self.contact_point),
            Kind::Baseline => Some(&self.baseline),
            Kind::Profile(index) => self.profile.get(index),
        }
    }
}

/// The work of adhesion of a contact without any: next to nothing, so that it has the folds of one with adhesion.
const NOTHING: f64 = 1e-100;

impl Numbers<f64> {
    /// The numbers for an edge that has a work of adhesion of its own; zero becomes next to nothing.
    pub(super) fn of_edge(&self, edge: Option<Edge>) -> Self {
        let own = self.works.zip(edge).map_or(self.work, |(works, edge)| works[edge as usize]);
        Numbers { work: if own == 0.0 { NOTHING } else { own }, ..self.clone() }
    }

    /// The place of a row on the curve: without trends.
    pub(super) fn untrended(&self, row: &DataRow) -> [f64; 2] {
        self.without_trends([&row.x, &row.y, &row.time])
    }

    /// Depth and force of a place on the curve, by the sensitivity of a photodiode, the offsets and the stiffness.
    pub(super) fn state(&self, observation: Observation, [x, y]: [f64; 2]) -> [f64; 2] {
        let seen = self.baseline + self.sensitivity.unwrap_or(1.0) * (y - self.baseline);
        let stiffness = self.stiffness.unwrap_or(f64::INFINITY);
        observation.state([x, seen], [self.contact_point, self.baseline], stiffness)
    }

    /// How the place of the curve against that of a row moves with a number, by its trends.
    pub(super) fn trend_partial(&self, kind: Kind, row: &DataRow) -> [f64; 2] {
        self.partial_of_trends(kind, [&row.x, &row.time])
    }
}

impl<R: Real> Numbers<R> {
    /// X and Y at a time, without drift of the position and without slope and drift of the baseline.
    pub(super) fn without_trends(&self, [x, y, time]: [&R; 3]) -> [R; 2] {
        let [slope, drift, of_position] = &self.trends;
        let trend = slope.clone() * (x.clone() - &self.contact_point) + drift.clone() * time;
        [x.clone() - of_position.clone() * time, y.clone() - trend]
    }

    /// How the place of the curve against that of a row with this X and time moves with a number, by its trends.
    pub(super) fn partial_of_trends(&self, kind: Kind, [x, time]: [&R; 2]) -> [R; 2] {
        let zero = || x.lit(0);
        match kind {
            Kind::BaselineSlope => [zero(), x.clone() - &self.contact_point],
            Kind::BaselineDrift => [zero(), time.clone()],
            Kind::PositionDrift => [time.clone(), zero()],
            Kind::ContactPoint => [zero(), -self.trends[0].clone()],
            _ => [zero(), zero()],
        }
    }
}

/// g with its derivatives with respect to one number.
type DualTransform<R> = Arc<dyn Transform<Dual<R>>>;

/// A profile for one set of its numbers: its transform, and the data for derivatives.
pub(super) struct Tip<R: Real> {
    medium: ExactMedium,
    /// The medium with a modulus of one.
    unit: mdr_numeric::medium::Medium<R>,
    /// g and its relatives, for the medium.
    pub(super) transform: Arc<dyn Transform<R>>,
    /// With no number seeded: for g''.
    curvature: DualTransform<R>,
    /// With the logarithm of one number seeded, by its index.
    seeded: Vec<(usize, DualTransform<R>)>,
}

impl<R: ProfileReal> Tip<R> {
    /// With derivatives with respect to the numbers of these indices.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn new(problem: &Problem, ctx: R::Ctx, numbers: &[R], free: &[usize]) -> Result<Self>
    where
        Dual<R>: ProfileReal + Real<Ctx = R::Ctx>,
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
#[derive(Clone, Debug)]
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
    fn new(medium: &ExactMedium, numbers: &Numbers<R>, a: &R) -> Result<Self> {
        let Numbers { e_star, work, .. } = numbers;
        if medium.is_half_space() {
            // Exactly none, whose root has no derivative.
            if *work == work.lit(0) {
                let none = || a.lit(0);
                return Ok(Springs {
                    factor: e_star.clone().times(2),
                    stiffness: [a.clone(), a.lit(1), none()],
                    elongation: [none(), none(), none()],
                });
            }
            let elongation = (a.pi().times(2) * a * work / e_star).sqrt();
            let inverse = a.clone().times(2).inv();
            let slope = elongation.clone() * &inverse;
            let curvature = -(slope.clone() * &inverse);
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
    springs: Springs<R>,
    /// (X, Y), offsets included.
    pub(super) at: [R; 2],
    /// Derivatives of d, F and a with respect to the parameter of the curve.
    pub(super) slopes: [R; 3],
    /// Derivatives of X and Y with respect to the parameter of the curve.
    pub(super) tangent: [R; 2],
    pub(super) beyond_edge: bool,
}

/// A contact and how it is seen. The curve is parametrised by the contact radius; beyond a vertical edge the contact stays there,
/// and the parameter grows with the indentation.
pub(super) struct Contact<'t, R: Real> {
    pub(super) tip: &'t Tip<R>,
    pub(super) numbers: Numbers<R>,
    pub(super) observation: Observation,
    /// The radius beyond which the contact does not grow: a vertical edge of the tip, or where the edge of the contact is pinned.
    pub(super) edge: Option<R>,
    /// The edge of the contact whose work of adhesion is its own.
    pub(super) direction: Option<Edge>,
    /// Of a pinned edge: how its radius moves with each number.
    pub(super) pinned: Option<Vec<(Kind, R)>>,
}

impl<'t, R: ProfileReal> Contact<'t, R> {
    pub(super) fn new(tip: &'t Tip<R>, numbers: Numbers<R>, observation: Observation) -> Self {
        let edge = tip.transform.outer_radius().filter(|_| tip.transform.vertical_edge());
        Contact { tip, numbers, observation, edge, direction: None, pinned: None }
    }

    /// Whether the contact has this work of adhesion.
    fn has_work(&self, kind: Kind) -> bool {
        match kind {
            Kind::WorkOfAdhesion => self.direction.is_none(),
            Kind::Work(edge) => self.direction == Some(edge),
            _ => false,
        }
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
        let seen = |y: R| match &self.numbers.sensitivity {
            Some(sensitivity) => y / sensitivity,
            None => y,
        };
        match self.observation {
            Observation::ForceOfIndentation => [d, f],
            Observation::ForceOfPosition => [d + bent(&f), seen(f)],
            Observation::DeflectionOfPosition => [d + bent(&f), seen(bent(&f))],
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
        Ok(Point { a, d, f, springs, at: [x + x0, y + y0], slopes, tangent, beyond_edge })
    }

    /// ∂(X, Y) at a fixed parameter of the curve, with respect to an offset or to the logarithm of another number.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn partial(&self, kind: Kind, point: &Point<R>) -> Result<[R; 2]> {
        let zero = || point.a.lit(0);
        match kind {
            Kind::EffectiveModulus | Kind::WorkOfAdhesion | Kind::Work(_) | Kind::Profile(_) => {
                let [d, f, a] = self.state_partial(kind, point)?;
                Ok(self.observe(d, f, a))
            }
            Kind::Stiffness => {
                let [x, y] = self.observe(zero(), point.f.clone(), zero());
                // Only what is divided by k depends on it.
                let y = if self.observation == Observation::DeflectionOfPosition { -y } else { zero() };
                self.with_pinned(kind, point, [-x, y])
            }
            Kind::Sensitivity => {
                let [_, y] = self.observe(point.d.clone(), point.f.clone(), point.a.clone());
                self.with_pinned(kind, point, [zero(), -y])
            }
            Kind::ContactPoint | Kind::Baseline => {
                let one = |mine: Kind| if mine == kind { point.a.lit(1) } else { zero() };
                self.with_pinned(kind, point, self.offsets(one(Kind::ContactPoint), one(Kind::Baseline)))
            }
            Kind::BaselineSlope | Kind::BaselineDrift | Kind::PositionDrift => {
                self.with_pinned(kind, point, [zero(), zero()])
            }
        }
    }

    /// ∂(X, Y) with the motion of a pinned edge.
    fn with_pinned(&self, kind: Kind, point: &Point<R>, [x, y]: [R; 2]) -> Result<[R; 2]> {
        let [d, f, a] = self.pinned_partial(kind, point)?;
        let [more_x, more_y] = self.observe(d, f, a);
        Ok([x + more_x, y + more_y])
    }

    /// ∂(d, F, a) by the motion of a pinned edge, or of a vertical one.
    fn pinned_partial(&self, kind: Kind, point: &Point<R>) -> Result<[R; 3]> {
        let Point { a, d, springs, .. } = point;
        let speed = match &self.pinned {
            _ if !point.beyond_edge => None,
            Some(speeds) => speeds.iter().find(|(of, _)| *of == kind).map(|(_, speed)| speed.clone()),
            None => self.tip.seeded(kind).and_then(|dual| dual.outer_radius()).map(|edge| edge.slope),
        };
        let Some(speed) = speed.filter(|speed| *speed != a.lit(0)) else { return Ok([a.lit(0), a.lit(0), a.lit(0)]) };
        // Along F = S d − ∫S'g, from d = g(a) − Δl(a) on.
        let transform = &self.tip.transform;
        let Springs { factor, stiffness: [stiffness, slope, _], elongation: [_, change, _] } = springs;
        let d_slope = transform.slope(a)? - change;
        let f_slope = ((d.clone() - &transform.g(a)?) * slope + stiffness.clone() * &d_slope) * factor;
        Ok([d_slope * &speed, f_slope * &speed, speed])
    }

    /// Δl of a contact of this radius.
    ///
    /// # Errors
    /// A number out of its domain.
    pub(super) fn elongation(&self, a: &R) -> Result<R> {
        let Springs { elongation: [elongation, ..], .. } = self.springs(a)?;
        Ok(elongation)
    }

    /// ∂(d, F, a) at a fixed parameter of the curve.
    pub(super) fn state_partial(&self, kind: Kind, point: &Point<R>) -> Result<[R; 3]> {
        let Point { a, springs: Springs { factor, stiffness: [stiffness, ..], elongation: [elongation, ..] }, .. } =
            point;
        let input = match kind {
            Kind::EffectiveModulus => Some(Input::Modulus),
            kind if self.has_work(kind) => Some(Input::WorkOfAdhesion),
            kind => self.tip.seeded(kind).map(|dual| Input::Profile(dual.as_ref())),
        };
        let fixed = |input: Input<'_, R>| input.partials(a, &(factor.clone() * stiffness), elongation, &point.f);
        let [d, f] = input.map_or_else(|| Ok([a.lit(0), a.lit(0)]), fixed)?;
        let [more_d, more_f, moved] = self.pinned_partial(kind, point)?;
        Ok([d + more_d, f + more_f, moved])
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
        let Springs { factor, stiffness, elongation } = point.springs.clone();
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
        let Point { a, springs, slopes: [d_slope, f_slope, _], .. } = point;
        let [elongation, change, _] = &springs.elongation;
        let (quarter, half) = (change.clone().over(2), elongation.clone().over(2));
        let zero = || a.lit(0);
        // F' = S d' − S'Δl changes with d' and Δl, and with the modulus itself.
        let (d, lag, own) = match kind {
            Kind::EffectiveModulus => (quarter, -half, springs.slope_of_force(d_slope, elongation)),
            kind if self.has_work(kind) => (-quarter, half, zero()),
            Kind::Profile(_) => match self.tip.seeded(kind) {
                Some(dual) => (dual.slope(&Dual::constant(a.clone()))?.slope, zero(), zero()),
                None => return Ok(zero()),
            },
            Kind::Stiffness => {
                let [x, _] = self.observe(zero(), f_slope.clone(), zero());
                return Ok(-x);
            }
            _ => return Ok(zero()),
        };
        let [stiffness, slope, _] = &springs.stiffness;
        let f = (own + stiffness.clone() * &d - slope.clone() * &lag) * &springs.factor;
        let [x, _] = self.observe(d, f, zero());
        Ok(x)
    }

    /// How fast the radius of a vertical edge, or of a pinned one, grows with a number.
    pub(super) fn edge_partial(&self, kind: Kind) -> R {
        if let Some(speeds) = &self.pinned {
            let speed = speeds.iter().find(|(of, _)| *of == kind).map(|(_, speed)| speed.clone());
            return speed.unwrap_or_else(|| self.numbers.e_star.lit(0));
        }
        let edge = self.tip.seeded(kind).and_then(|dual| dual.outer_radius());
        edge.map_or_else(|| self.numbers.e_star.lit(0), |edge| edge.slope)
    }

    /// How fast a kink of the profile at this radius moves with a number of it.
    pub(super) fn kink_partial(&self, kind: Kind, radius: &R) -> R {
        let kinks = self.tip.seeded(kind).map(|dual| dual.kinks()).unwrap_or_default();
        kinks.into_iter().find(|kink| kink.value == *radius).map_or_else(|| radius.lit(0), |kink| kink.slope)
    }
}
