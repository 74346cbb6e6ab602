//! Formulas that are sums of powers, which certified digits take from closed forms.

use std::borrow::Cow;

use mdr_core::contact::Shape;

use crate::scene::{Arithmetic, Formula, Profile, Scene, exactly};

/// The scene with each formula that is a sum of powers cᵢrⁿⁱ, cᵢ > 0, in closed form, if it asks for certified digits. Powers of r are
/// not periodic, so that a formula on a periodic medium stays as it is.
pub(super) fn in_closed_form(scene: &Scene) -> Cow<'_, Scene> {
    let is_of_powers = matches!(scene.arithmetic, Arithmetic::Certified { .. }) && !scene.medium.is_periodic();
    match is_of_powers.then(|| closed(&scene.profile)).flatten() {
        Some(profile) => Cow::Owned(scene.with_profile(profile)),
        None => Cow::Borrowed(scene),
    }
}

/// The profile in closed form as far as that is possible; `None` if nothing changes.
fn closed(profile: &Profile) -> Option<Profile> {
    match profile {
        Profile::Formula(formula) => powers(formula),
        Profile::Sum(terms) => {
            let closed: Vec<Option<Profile>> = terms.iter().map(closed).collect();
            let all = terms.iter().zip(&closed).map(|(term, closed)| closed.as_ref().unwrap_or(term).clone());
            closed.iter().any(Option::is_some).then(|| Profile::Sum(all.collect()))
        }
        Profile::Shape(_) | Profile::Table(_) | Profile::Function(_) | Profile::Wave(_) => None,
    }
}

/// A formula that is a sum of powers, each of which rises from 0.
fn powers(formula: &Formula) -> Option<Profile> {
    let power = |[n, c]: &[rug::Rational; 2]| {
        let rises = *n > 0 && *c > 0;
        rises.then(|| Some(Profile::Shape(Shape::Power { n: exactly(n)?, c: exactly(c)? }))).flatten()
    };
    let terms = formula.expression.powers(&formula.parameters)?;
    let mut terms = terms.iter().map(power).collect::<Option<Vec<_>>>()?;
    match terms.len() {
        0 => None,
        1 => terms.pop(),
        _ => Some(Profile::Sum(terms)),
    }
}
