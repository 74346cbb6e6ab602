//! The contact of a scene in one arithmetic, with its evaluations counted.

use std::sync::Arc;

use mdr_core::contact::{self, Control, CountingTransform, Edge, EvaluationCounter, Result, Status, Transform};
#[cfg(feature = "mp")]
use mdr_core::contact::{Error, Quantity};
use mdr_core::number::{Literal, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::path;

#[cfg(feature = "mp")]
use super::media;
use super::weight::weight_on;
use crate::answer::{PlainState, Value};
use crate::run::Counts;
pub(crate) use crate::scene::SceneReal;
use crate::scene::{Scene, Start};
#[cfg(feature = "mp")]
use crate::scene::{double, exactly};

/// The contact, with its evaluations counted and weighed.
pub(super) fn counted<R: Real>(contact: &Contact<R>, tally: &Arc<EvaluationCounter>, weight: u64) -> Contact<R> {
    let transform = CountingTransform::sharing(Arc::clone(contact.shared_transform()), tally).weighing(weight);
    contact.with_transform(Arc::new(transform))
}

/// Profile, material and control in one arithmetic.
pub(crate) struct Model<R: SceneReal> {
    ctx: R::Ctx,
    contact: Contact<R>,
}

impl<R: SceneReal> Model<R> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(scene: &Scene, ctx: R::Ctx, counts: &Counts) -> Result<Self> {
        Ok(Self::counted(scene, ctx, scene.assembled(ctx)?, counts))
    }

    /// The contact at the work of adhesion of one edge.
    pub(crate) fn at(&self, edge: Edge) -> Self {
        Model { ctx: self.ctx, contact: self.contact.at(edge) }
    }

    fn counted(scene: &Scene, ctx: R::Ctx, contact: Contact<R>, counts: &Counts) -> Self {
        let bits = R::from_int(ctx, 1).precision();
        let weight = weight_on(&scene.profile, &scene.medium, R::INDEX, bits);
        Model { ctx, contact: counted(&contact, &counts[R::INDEX], weight) }
    }

    pub(crate) fn number(&self, literal: &Literal) -> R {
        R::from_literal(self.ctx, literal)
    }

    /// A double, exactly.
    #[cfg(feature = "mp")]
    pub(crate) fn double(&self, value: f64) -> R {
        R::from_f64(self.ctx, value)
    }

    /// The contact radius or half-width of a contact of this size.
    pub(crate) fn contact_radius(&self, size: &R) -> R {
        self.contact.medium().contact_radius(size)
    }

    /// The size of a contact with a contact radius of the scene.
    ///
    /// # Errors
    /// [`Error::Domain`] for half of a period and more.
    pub(crate) fn size(&self, contact_radius: &Literal) -> Result<R> {
        self.contact.medium().size_within(&self.number(contact_radius))
    }

    /// An indentation; on a medium without depths nothing, and nothing is amiss.
    pub(crate) fn depth<N>(&self, indentation: Value<N>) -> Value<N> {
        if self.contact.medium().has_depth() {
            indentation
        } else {
            Value::Unknown { status: Status::Ok, log10: None, why: None }
        }
    }

    /// The record of a state, by its contact radius.
    pub(crate) fn plain(&self, state: contact::Equilibrium<R>) -> PlainState<R> {
        let state = PlainState::from(self.shown(state));
        PlainState { indentation: self.depth(state.indentation), ..state }
    }

    /// The start of a path, by its size.
    ///
    /// # Errors
    /// [`Error::Domain`] for half of a period and more.
    pub(crate) fn start(&self, start: &Start) -> Result<path::Start<R>> {
        Ok(match start {
            Start::Nearest(radius) => path::Start::Nearest(self.size(radius)?),
            start => start.map(|radius| self.number(radius)),
        })
    }

    /// A state with its contact radius for its size.
    pub(crate) fn shown(&self, state: contact::Equilibrium<R>) -> contact::Equilibrium<R> {
        contact::Equilibrium { contact_radius: self.contact_radius(&state.contact_radius), ..state }
    }

    pub(crate) fn transform(&self) -> &dyn Transform<R> {
        self.contact.transform()
    }

    pub(crate) fn control(&self) -> &Control<R> {
        self.contact.control()
    }

    pub(crate) fn contact(&self) -> Contact<R> {
        self.contact.clone()
    }

    /// The contact under another control.
    #[cfg(feature = "mp")]
    pub(crate) fn under(&self, control: &Control<Literal>) -> Contact<R> {
        self.contact.with_control(control.map(|stiffness| self.number(stiffness)))
    }
}

impl Model<f64> {
    /// The contact with forces in units of E* times an area: all its lengths are unchanged, and the moduli may be out of the
    /// range of f64.
    ///
    /// # Errors
    /// [`Error::Domain`] with the input as it was written, if no double holds a number of the profile, w/E* or k/E*; a parameter
    /// of the profile or the material that is out of its domain.
    #[cfg(feature = "mp")]
    pub(crate) fn in_units_of_modulus(scene: &Scene, counts: &Counts) -> Result<Self> {
        if let Some(number) = scene.places.parameter_beyond_doubles() {
            let quantity = Quantity::Parameter("a number of the profile");
            let requirement = "within the range of f64, where the search for states begins";
            return Err(Error::Domain { quantity, value: number.to_string(), requirement });
        }
        let medium = media::medium_of(&scene.medium, (), || 1.0)?;
        let over_modulus = |quantity, literal: &Literal| over_modulus(scene, quantity, literal);
        Ok(Self::counted(scene, (), scene.assembled_with((), medium, &over_modulus)?, counts))
    }
}

/// An input over E*, in f64.
#[cfg(feature = "mp")]
fn over_modulus(scene: &Scene, quantity: Quantity, input: &Literal) -> Result<f64> {
    let modulus = &scene.scale_of_forces();
    let ratio = exactly(&(input.to_rational() / modulus.to_rational())).as_ref().and_then(double);
    ratio.ok_or_else(|| Error::Domain {
        quantity,
        value: format!("{input} at E* = {modulus}"),
        requirement: "of a ratio to E* within the range of f64, where the search for states begins",
    })
}
