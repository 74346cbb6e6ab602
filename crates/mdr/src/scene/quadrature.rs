//! Transforms by quadrature, and what stands for them over enclosures, where an estimated error bounds nothing.

use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::Real;

use super::ProfileReal;

/// The transform by quadrature, or in place of it over enclosures one that refuses, so that it is not even compiled for them.
///
/// # Errors
/// What `transform` returns.
pub(crate) fn by_quadrature<R: ProfileReal, P: Profile<R>, T: Transform<R> + 'static>(
    profile: P,
    transform: impl FnOnce(P) -> Result<T>,
) -> Result<Box<dyn Transform<R>>> {
    if R::ENCLOSES {
        let (outer_radius, vertical_edge) = (profile.outer_radius(), profile.vertical_edge());
        return Ok(Box::new(Unenclosed { outer_radius, vertical_edge }));
    }
    Ok(Box::new(transform(profile)?))
}

/// A transform of which only the end of the profile is known; all else is refused.
#[derive(Clone, Debug)]
struct Unenclosed<R> {
    outer_radius: Option<R>,
    vertical_edge: bool,
}

impl<R: Real> Transform<R> for Unenclosed<R> {
    fn g(&self, _: &R) -> Result<R> {
        Err(refused())
    }

    fn slope(&self, _: &R) -> Result<R> {
        Err(refused())
    }

    fn integral(&self, _: &R) -> Result<R> {
        Err(refused())
    }

    fn outer_radius(&self) -> Option<R> {
        self.outer_radius.clone()
    }

    fn vertical_edge(&self) -> bool {
        self.vertical_edge
    }
}

fn refused() -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the transform of the profile"),
        value: "a quadrature".to_owned(),
        requirement: "one that can be enclosed, a closed form or rigorous integrals; or ask for f64",
    }
}
