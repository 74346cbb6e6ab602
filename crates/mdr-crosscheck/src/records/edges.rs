//! Questions without a number: outside of their domain, and states that would interpenetrate.

use mdr_analytic::profiles::DisplacedParaboloid;
use mdr_core::contact::{Control, Error, Material, Result, Transform};
use mdr_core::number::{Interval, Precision, Real, Special};
use mdr_numeric::curve::Curve;
use mdr_numeric::fields::Fields;
use mdr_numeric::transform::Quadrature;
use mdr_reference::{Record, Status};

use super::RecordError;
use super::draft::{Draft, literal};
use super::library::Profile;
use super::power::{Held, Power};
use super::shapes;
use crate::library::Height;

/// A critical state that is asked for with inputs for which there is none.
pub(super) fn no_question(law: &Power) -> std::result::Result<Vec<Record>, RecordError> {
    let [n, c, e_star, work] = law.texts().map(|text| literal(text));
    let positive = [&n, &c, &e_star, &work].iter().all(|x| !x.is_zero() && !x.is_negative());
    let half = n.to_rational() == 0.5;
    if positive && !half {
        return Err(RecordError::missing(&law.name, "input outside of its domain"));
    }
    let draft = Draft {
        formula: "critical",
        control: Some(Held::Force.name()),
        methods: ["definition", ""],
        refs: vec!["Popov (1.11)", "Popov (1.18)"],
        ..law.draft("domain")
    };
    Ok(vec![draft.without_number("force", "N", Status::DomainError)])
}

/// A transformed profile where it is not defined.
pub(super) fn beyond(profile: &Profile<'_>, x: &str) -> std::result::Result<Vec<Record>, RecordError> {
    let ctx = Precision::new(128);
    let at = Interval::from_literal(ctx, &literal(x));
    let found = profile.closed(&profile.numbers::<Interval>(ctx)).and_then(|transform| transform.g(&at));
    if !matches!(found, Err(Error::Domain { .. })) {
        return Err(RecordError::missing(profile.shape.name(), "radius outside of the domain"));
    }
    let parameters = profile.parameters.iter().map(|(name, value)| (*name, (*value).to_owned()));
    let draft = Draft {
        id: format!("transform/{}/x={x}", profile.shape.name()),
        profile: profile.shape.name(),
        formula: "transform",
        inputs: parameters.chain([("x", x.to_owned())]).collect(),
        methods: ["definition", ""],
        refs: vec!["Popov (1.1)"],
        ..Draft::default()
    };
    Ok(vec![draft.without_number("g", "m", Status::DomainError)])
}

/// The equilibrium of a displaced paraboloid with a contact radius inside of its ridge: the ridge would lie in the
/// half-space. The gap there is (2/π)∫(g(r cos φ) − d) dφ over 0 < φ < Φ = arccos(a/r), which is
/// (2/π)[r²(Φ + sin Φ cos Φ)/2R − πbr sin Φ/2R − dΦ], and certainly negative.
pub(super) fn interpenetrating(a: &str) -> std::result::Result<Vec<Record>, RecordError> {
    let profile = shapes::RIDGE;
    let wrong = |error| RecordError::of(profile.shape.name(), error);
    let [gap, again] = [enclosed_gap(&profile, a), integrated_gap(&profile, a)];
    if !(gap.map_err(wrong)? && again.map_err(wrong)?) {
        return Err(RecordError::missing(profile.shape.name(), "interpenetration"));
    }
    let parameters = profile.parameters.iter().chain(&shapes::RIDGE_MATERIAL);
    let inputs = parameters.map(|(name, value)| (*name, (*value).to_owned()));
    let draft = Draft {
        id: format!("state/{}/a={a}", profile.shape.name()),
        profile: profile.shape.name(),
        formula: "state",
        inputs: inputs.chain([("a", a.to_owned())]).collect(),
        methods: ["closed-form/interval", "gap-quadrature/f64"],
        refs: vec!["Popov (1.5)", "Argatov, Li, Pohrt & Popov 2016"],
        ..Draft::default()
    };
    Ok(vec![
        draft.without_number("indentation", "m", Status::NotAdmissible),
        draft.without_number("force", "N", Status::NotAdmissible),
    ])
}

fn material<R: Real>(ctx: R::Ctx) -> Result<Material<R>> {
    let [(_, e_star), (_, work)] = shapes::RIDGE_MATERIAL;
    Material::new(R::from_literal(ctx, &literal(e_star)), R::from_literal(ctx, &literal(work)))
}

/// Whether the gap at the ridge is certainly negative.
fn enclosed_gap(profile: &Profile<'_>, a: &str) -> Result<bool> {
    let ctx = Precision::new(128);
    let numbers = profile.numbers::<Interval>(ctx);
    let [radius, ridge] = [&numbers[0], &numbers[1]];
    let transform = DisplacedParaboloid::new(radius.clone(), ridge.clone())?;
    let a = Interval::from_literal(ctx, &literal(a));
    let material = material::<Interval>(ctx)?;
    let d = transform.g(&a)? - mdr_analytic::detachment_elongation(&material, &a)?;
    let cosine = a / ridge;
    let angle = cosine.acos();
    let sine = angle.sin();
    let bowl = (angle.clone() + sine.clone() * &cosine) * ridge.square() / radius.clone().times(2);
    let cone = sine * ridge.pi() * ridge.square() / radius.clone().times(2);
    let gap = bowl - cone - d * angle;
    Ok(gap < gap.lit(0))
}

/// The same by quadrature of the transform by quadrature.
fn integrated_gap(profile: &Profile<'_>, a: &str) -> Result<bool> {
    let parameters = profile.numbers::<f64>(());
    let ridge = parameters[1];
    let transform = Quadrature::new(Height { shape: profile.shape, parameters });
    let (material, control) = (material::<f64>(())?, Control::Indentation);
    let fields = Fields::new(Curve::new(&transform, &material, &control), literal(a).nearest_f64())?;
    Ok(fields.gap(&ridge)? < 0.0)
}
