//! The transform that enclosures lack: by quadrature, whose estimated error bounds nothing.

use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::Real;

/// A transform of which only the end of the profile is known; all else is refused.
#[derive(Clone, Debug)]
pub(super) struct Unenclosed<R> {
    pub(super) outer_radius: Option<R>,
    pub(super) vertical_edge: bool,
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
