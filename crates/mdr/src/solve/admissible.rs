//! The admissible states of a profile: by its form, by enclosures of a formula, else by a search in f64.

use std::sync::Arc;

use mdr_core::contact::Transform;
use mdr_numeric::admissible::{Admissibility, FirstTouch, GapVerdict, HeightSource, NOT_SEARCHED, search_range};

use super::model::SceneReal;
use crate::scene::{ExactMedium, Profile, transform_in_doubles};

/// Whether a contact of radius a at the indentation d is admissible: with a proof where the gap is enclosed.
pub(crate) fn verdict<R: SceneReal>(admissibility: &Admissibility, a: &R, d: &R) -> GapVerdict {
    #[cfg(feature = "mp")]
    if let (Some(a), Some(d)) = (a.enclosing(), d.enclosing()) {
        return admissibility.decided(&a, &d);
    }
    admissibility.of(a.approx(), d.approx())
}

/// Facts about a profile with a formula or a function in it.
struct Known {
    /// Whether g falls nowhere.
    rises: bool,
    touch: FirstTouch,
}

/// The admissibility of states with folds at the given contact radii, for the length of the material. On another medium than a
/// half-space it is known where g rises, as it does there for every f with a nondecreasing r f'; where it does not, where the
/// surfaces first touch is still a matter of f alone.
pub(crate) fn on_medium(
    profile: &Profile,
    medium: &ExactMedium,
    transform: Arc<dyn Transform<f64>>,
    length: f64,
    folds: &[f64],
) -> Admissibility {
    if medium.is_half_space() {
        return admissibility(profile, transform, length, folds);
    }
    if transform.rises() || rises(profile) {
        return Admissibility::of_rising();
    }
    let unknown = Admissibility::unknown(NOT_SEARCHED);
    // A profile on a periodic medium rises from its tip to half of the wavelength.
    if medium.is_periodic() {
        return unknown.touching_as(Admissibility::rising());
    }
    match transform_in_doubles(profile) {
        Ok(transform) => unknown.touching_as(&admissibility(profile, transform.into(), length, folds)),
        Err(_) => unknown,
    }
}

/// The admissibility of states on a half-space with folds at the given contact radii, for the length w/E*.
fn admissibility(profile: &Profile, transform: Arc<dyn Transform<f64>>, length: f64, folds: &[f64]) -> Admissibility {
    let range = search_range(length, folds);
    if !profile.has_formula() && !profile.has_function() {
        let known = Admissibility::new(transform, range);
        return if let Profile::Shape(shape) = profile { known.with_shape(shape) } else { known };
    }
    let Known { rises, touch } = known(profile);
    if rises {
        return Admissibility::of_rising();
    }
    // A ring below any radius of the contact is the tip.
    let touch = match touch {
        #[cfg(feature = "mp")]
        FirstTouch::Ring(ring) if ring.at::<f64>(())[0] < range[0] => FirstTouch::Tip,
        touch => touch,
    };
    Admissibility::of_formula(transform, range, touch)
}

fn known(profile: &Profile) -> Known {
    let heights = if profile.has_function() { HeightSource::Function } else { HeightSource::Formula };
    let nothing = Known { rises: false, touch: FirstTouch::Open { at_least: f64::NEG_INFINITY, heights } };
    match profile {
        #[cfg(feature = "mp")]
        Profile::Formula(formula) => {
            use mdr_core::contact::Lowest;
            let shape = formula.expression.shape(&formula.parameters, &formula.breaks);
            shape.map_or(nothing, |shape| Known {
                rises: shape.rises,
                touch: match shape.lowest {
                    Lowest::Tip => FirstTouch::Tip,
                    Lowest::Ring(ring) => FirstTouch::Ring(Box::new(ring)),
                    Lowest::Open { at_least } => FirstTouch::Open { at_least, heights },
                },
            })
        }
        Profile::Sum(terms) if terms.iter().all(rises) => Known { rises: true, touch: FirstTouch::Tip },
        _ => nothing,
    }
}

/// Whether g of a profile is proved to fall nowhere up to a radius.
#[cfg(feature = "mp")]
pub(crate) fn rises_up_to(profile: &Profile, radius: &rug::Float) -> bool {
    match profile {
        Profile::Formula(formula) => formula.expression.rises_up_to(&formula.parameters, radius).unwrap_or(false),
        Profile::Sum(terms) => terms.iter().all(|term| rises_up_to(term, radius)),
        other => rises(other),
    }
}

/// Whether g of a profile is proved to fall nowhere.
fn rises(profile: &Profile) -> bool {
    if profile.has_formula() || profile.has_function() {
        return known(profile).rises;
    }
    transform_in_doubles(profile).is_ok_and(|transform| transform.rises())
}
