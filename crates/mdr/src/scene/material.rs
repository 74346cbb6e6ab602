//! E* from the given elastic constants.

use std::cmp::Ordering;

use mdr_core::contact::{Body, Elasticity};
use mdr_core::number::Literal;
use mdr_core::text::excerpt;

use super::place::Location;
use crate::error::Result;

/// E* as given, or of two bodies (1.3), with every input checked.
pub(super) fn effective_modulus(elasticity: &Elasticity) -> Result<Literal> {
    match elasticity {
        Elasticity::Effective(modulus) => Location::built("material.e_star").require_positive(modulus.clone()),
        Elasticity::Bodies(bodies) => {
            for body in bodies.iter() {
                Location::built("material.body.e").require_positive(body.youngs_modulus.clone())?;
                if let Some(why) = refused_ratio(&body.poissons_ratio) {
                    return Err(Location::built("material.body.nu").refuse(why));
                }
            }
            combined(bodies)
                .ok_or_else(|| Location::built("material.body").refuse("E* has more digits than can be meant"))
        }
    }
}

/// w₁ and w₂ if they differ, with w₁ checked; `place` is where w₁ stands.
pub(super) fn works(advancing: Literal, receding: Literal, place: &Location) -> Result<Option<Box<[Literal; 2]>>> {
    if advancing.is_negative() {
        return Err(place.refuse(format!("must not be negative, got {}", excerpt(&advancing.to_string()))));
    }
    match advancing.compare(&receding) {
        Ordering::Less => Ok(Some(Box::new([advancing, receding]))),
        Ordering::Equal => Ok(None),
        Ordering::Greater => Err(place.refuse(format!(
            "an advancing edge gains at most what a receding one needs, {}, got {}: exchange the two if they are the other way \
             round",
            excerpt(&receding.to_string()),
            excerpt(&advancing.to_string())
        ))),
    }
}

/// Why a Poisson's ratio cannot be one.
pub(super) fn refused_ratio(ratio: &Literal) -> Option<String> {
    let above = ratio.compare(&Literal::from(-1)) == Ordering::Greater;
    let within = above && "1/2".parse().is_ok_and(|half: Literal| ratio.compare(&half) != Ordering::Greater);
    (!within).then(|| format!("Poisson's ratio must be within (-1, 1/2], got {}", excerpt(&ratio.to_string())))
}

/// E* of two bodies, exactly.
pub(super) fn combined(bodies: &[Body<Literal>; 2]) -> Option<Literal> {
    series(bodies)
}

/// E* of one body or more, exactly.
#[cfg(feature = "mp")]
pub(super) fn series(bodies: &[Body<Literal>]) -> Option<Literal> {
    let compliance = |body: &Body<Literal>| {
        (rug::Rational::from(1) - body.poissons_ratio.to_rational().square()) / body.youngs_modulus.to_rational()
    };
    let sum: rug::Rational = bodies.iter().map(compliance).sum();
    exactly(&sum.recip())
}

/// E* of one body or more, rounded to a double.
#[cfg(not(feature = "mp"))]
pub(super) fn series(bodies: &[Body<Literal>]) -> Option<Literal> {
    let compliance = |body: &Body<Literal>| {
        let ratio = body.poissons_ratio.nearest_f64();
        (1.0 - ratio) * (1.0 + ratio) / body.youngs_modulus.nearest_f64()
    };
    Literal::try_from(bodies.iter().map(compliance).sum::<f64>().recip()).ok()
}

/// A rational number as a literal; `None` for one of absurd length.
#[cfg(feature = "mp")]
pub(crate) fn exactly(value: &rug::Rational) -> Option<Literal> {
    value.to_string().parse().ok()
}

/// A rational as a short decimal where it is one, else as a fraction; `None` for one of absurd length.
#[cfg(feature = "mp")]
pub fn decimal(value: &rug::Rational) -> Option<Literal> {
    let short: Option<Literal> =
        mdr_core::number::certify::Enclosure::Exact(value.clone()).round(17).and_then(|decimal| {
            let text = decimal.to_string();
            let text = if text.contains('.') && !text.contains('e') {
                text.trim_end_matches('0').trim_end_matches('.')
            } else {
                &text
            };
            text.parse().ok()
        });
    short.filter(|literal| literal.to_rational() == *value).or_else(|| exactly(value))
}
