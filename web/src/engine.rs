//! A contact, the control that is held, and the heights of its profile.

use std::cell::RefCell;
use std::f64::consts::PI;
use std::sync::Arc;

use mdr::columns::ContactColumns;
use mdr::prelude::*;
use mdr::{ContactError, Error, scene};
use mdr_core::contact::{Edge, Profile as Heights, Quantity, Transform};
use mdr_numeric::profiles;
use mdr_numeric::table::{MeasuredProfile, Table};
use mdr_numeric::transform::Quadrature;

use crate::edges::BothEdges;
use crate::picture::{self, Sampled, Surface};

/// Rows of results.
type Rows<const N: usize> = Result<Vec<[f64; N]>, Error>;

/// The contact that the page shows.
pub(crate) struct Engine {
    /// With two works of adhesion, that of the receding edge.
    contact: ContactColumns,
    both: Option<BothEdges>,
    surface: Surface,
    control: Control<f64>,
    profile: Profile,
    /// For the gap, which needs g at more radii than can be computed for every frame.
    sampled: RefCell<Option<Sampled>>,
}

/// The heights f(r), for the picture of the body and for the independent route.
enum Profile {
    Shape(profiles::Heights<f64>),
    Table(MeasuredProfile<f64>),
    /// A wave h₀(1 − cos 2πr/λ), of h₀ and λ.
    Wave(f64, f64),
}

impl Engine {
    /// Reads a scene; `table` is the file that it names, if it names one.
    pub(crate) fn open(text: &str, table: &[u8]) -> Result<Engine, Error> {
        let scene = Scene::from_toml(text, "scene.toml", &|_| Ok(table.to_vec()))?;
        let profile = match scene.profile() {
            scene::Profile::Shape(shape) => {
                let shape = shape.clone().map(|_, literal| literal.nearest_f64());
                Profile::Shape(profiles::Heights::new([shape])?)
            }
            scene::Profile::Table(measured) => {
                let rows = Table::from_csv(table).map_err(refused)?;
                let smooth = measured.length().map(|length| rows.smoothed(length)).transpose().map_err(refused)?;
                Profile::Table(smooth.map_or(rows, |(smooth, _)| smooth).profile(())?)
            }
            scene::Profile::Wave(amplitude) => {
                let ExactMedium::Periodic { wavelength, .. } = scene.pressed_into() else { return Err(unshown()) };
                Profile::Wave(amplitude.nearest_f64(), wavelength.nearest_f64())
            }
            _ => return Err(unshown()),
        };
        let control = scene.controlled().try_map(|stiffness| Ok::<_, Error>(stiffness.nearest_f64()))?;
        let surface = match scene.pressed_into() {
            ExactMedium::Graded { exponent, .. } => Surface::HalfSpace(exponent.nearest_f64()),
            ExactMedium::Winkler { .. } => Surface::Springs,
            ExactMedium::Periodic { wavelength, .. } => Surface::Strips(wavelength.nearest_f64()),
            _ => Surface::HalfSpace(0.0),
        };
        let (contact, both) = if scene.has_two_works() {
            let contact = scene.contact()?;
            let [modulus, work] = [*contact.modulus(), *contact.adhesion().of(Edge::Receding)];
            let one = Scene::new(scene.profile().clone(), Elasticity::effective(modulus)?, work)?;
            let one = one.medium(scene.pressed_into().clone())?;
            (ContactColumns::new(&one)?, Some(BothEdges::new(contact, profile.transform().as_ref())?))
        } else {
            (ContactColumns::new(&scene)?, None)
        };
        Ok(Engine { contact, both, surface, control, profile, sampled: RefCell::default() })
    }

    /// Those of the advancing edge, if it is another one, have a kind that is larger by 2.
    pub(crate) fn folds(&self) -> Rows<4> {
        let row = |fold: mdr_core::contact::Fold<f64>| {
            let kind = f64::from(u8::from(fold.kind == FoldKind::Maximum));
            [fold.contact_radius, fold.indentation, fold.force, kind]
        };
        let advancing = self.both.iter().flat_map(BothEdges::advancing_folds);
        let advancing = advancing.map(|[a, d, force, kind]| [a, d, force, kind + 2.0]);
        Ok(self.contact.folds(&self.control)?.into_iter().map(row).chain(advancing).collect())
    }

    pub(crate) fn advancing_curve(&self, radii: &[f64]) -> Rows<6> {
        let rows = self.both.as_ref().map(|both| both.advancing_curve(radii)).transpose()?.unwrap_or_default();
        Ok(rows.into_iter().filter(known).collect())
    }

    pub(crate) fn advancing_at(&self, value: f64) -> Rows<4> {
        let found = self.both.as_ref().map(|both| both.advancing_at(value)).transpose()?.unwrap_or_default();
        Ok(found.into_iter().filter(|row| self.is_partial(row)).collect())
    }

    /// Whether the edge is within the period of a wave: at its end the contact is complete, a state of its own.
    fn is_partial(&self, row: &[f64; 4]) -> bool {
        !matches!(self.profile, Profile::Wave(..)) || row[0] < self.outer_radius() * (1.0 - 1e-9)
    }

    pub(crate) fn pinned(&self, a: f64, value: f64) -> Rows<2> {
        let row = self.both.as_ref().map(|both| both.pinned(a, value)).transpose()?;
        Ok(row.into_iter().filter(known).collect())
    }

    pub(crate) fn outer_radius(&self) -> f64 {
        let outer = match &self.profile {
            Profile::Shape(shape) => shape.outer_radius(),
            Profile::Table(table) => Heights::outer_radius(table),
            Profile::Wave(_, wavelength) => Some(wavelength / 2.0),
        };
        outer.unwrap_or(f64::INFINITY)
    }

    pub(crate) fn curve(&self, radii: &[f64]) -> Rows<6> {
        let [g, ..] = self.contact.transform(radii)?;
        let states = self.contact.curve(radii)?;
        let stability = self.contact.stability(&self.control, radii)?;
        let row = |i: usize| {
            let [d, force] = [states.indentation[i], states.force[i]];
            let stable = f64::from(u8::from(stability[i] == Some(Stability::Stable)));
            [radii[i], g[i], g[i] - d, d, force, stable]
        };
        Ok((0..radii.len()).map(row).filter(known).collect())
    }

    pub(crate) fn balance(&self, value: f64, radii: &[f64]) -> Rows<4> {
        let balance = self.contact.balance(&self.control, value, radii)?;
        let row = |i: usize| [radii[i], balance.excess[i], balance.elongation[i], balance.indentation[i]];
        Ok((0..radii.len()).map(row).filter(known).collect())
    }

    pub(crate) fn equilibria(&self, value: f64) -> Rows<4> {
        let row = |state: mdr_core::contact::Equilibrium<f64>| {
            let sign = match state.stability {
                Stability::Stable => 1.0,
                Stability::Neutral => 0.0,
                Stability::Unstable => -1.0,
            };
            // The controlled quantity has the value, to the last bit.
            let (d, force) = match self.control {
                Control::Indentation => (value, state.force),
                Control::Force => (state.indentation, value),
                Control::Machine { .. } => (state.indentation, state.force),
            };
            [state.contact_radius, d, force, sign]
        };
        Ok(self
            .contact
            .equilibria_at(&self.control, value)?
            .into_iter()
            .map(row)
            .filter(|row| self.is_partial(row))
            .collect())
    }

    pub(crate) fn advance(&self, a: f64, from: f64, to: f64) -> Rows<10> {
        let start = if a < 0.0 { Start::Detached } else { Start::Nearest(a) };
        if let Some(both) = &self.both {
            return Ok(both.advance(&start, [from, to])?);
        }
        let history = self.contact.follow(&self.control, &[from, to], &start)?;
        let mut rows: Vec<[f64; 10]> = Vec::new();
        for event in &history.jumps {
            let [before, after] = [event.before, event.after].map(|s| [s.contact_radius, s.indentation, s.force]);
            let [[a, d, force], [to_a, to_d, to_force]] = [before, after];
            rows.push([number(event.kind), event.value, a, d, force, to_a, to_d, to_force, event.dissipated, 0.0]);
        }
        let states = &history.states;
        if states.status.get(1) == Some(&Status::Ok) {
            let [a, d, force] = [states.contact_radius[1], states.indentation[1], states.force[1]];
            rows.push([number(EventKind::End), to, a, d, force, a, d, force, 0.0, 0.0]);
        }
        Ok(rows)
    }

    pub(crate) fn surface(&self, a: f64, d: f64, high: f64, count: u32) -> Rows<3> {
        ContactError::require_finite(Quantity::ContactRadius, &a)?;
        ContactError::require_finite(Quantity::Indentation, &d)?;
        let high = ContactError::require_positive(Quantity::Radius, high)?.min(self.outer_radius());
        let edge = a.max(0.0).min(high);
        let outside = count / 2;
        let inside = picture::radii(0.0, edge, count - outside, 2.0)?.into_iter().map(|r| (r, 0.0));
        // Closest to the edge, where the neck is steep.
        let beyond: Vec<f64> = picture::radii(0.0, high - edge, outside, 2.0)?.iter().map(|from| edge + from).collect();
        let gaps = if a > 0.0 { self.gaps(a, d, high, &beyond)? } else { vec![0.0; beyond.len()] };
        let all = inside.chain(beyond.into_iter().zip(gaps));
        Ok(all.map(|(r, gap)| [r, self.height(r), gap]).filter(known).collect())
    }

    fn gaps(&self, a: f64, d: f64, high: f64, radii: &[f64]) -> Result<Vec<f64>, Error> {
        if a >= high {
            return Ok(vec![0.0; radii.len()]);
        }
        let mut sampled = self.sampled.borrow_mut();
        if sampled.as_ref().is_none_or(|sampled| sampled.high() != high) {
            let [g, ..] = self.contact.transform(&Sampled::radii(high)?)?;
            *sampled = Some(Sampled::new(high, g));
        }
        let Some(sampled) = sampled.as_ref() else { return Ok(Vec::new()) };
        let g = |x| sampled.at(x);
        // At the edge itself there is none yet.
        let at = |r: &f64| if *r > a { self.surface.gap([a, d, *r], self.height(*r), &g) } else { 0.0 };
        Ok(radii.iter().map(at).collect())
    }

    fn height(&self, r: f64) -> f64 {
        match &self.profile {
            _ if r == 0.0 => 0.0,
            Profile::Shape(shape) => shape.height(&r),
            Profile::Table(table) => table.height(&r),
            Profile::Wave(amplitude, wavelength) => 2.0 * amplitude * (PI * r / wavelength).sin().powi(2),
        }
    }

    pub(crate) fn verify(&self, a: f64) -> Result<[f64; 3], Error> {
        let Some(quadrature) = self.profile.transform().filter(|_| matches!(self.surface, Surface::HalfSpace(0.0)))
        else {
            let why = "(1.1) is that of a half-space".to_owned();
            return Err(Error::Scene { place: None, key: "medium.kind".to_owned(), why });
        };
        let [g, ..] = self.contact.transform(&[a])?;
        let quadrature = quadrature.g(&a)?;
        let g = g.first().copied().unwrap_or(f64::NAN);
        let difference = if g == quadrature { 0.0 } else { (g - quadrature).abs() / g.abs() };
        Ok([g, quadrature, difference])
    }
}

impl Profile {
    /// g on a half-space, by quadrature of (1.1); a wave without end has none.
    fn transform(&self) -> Option<Arc<dyn Transform<f64>>> {
        match self {
            Profile::Shape(shape) => Some(Arc::new(Quadrature::new(shape.clone()))),
            Profile::Table(table) => Some(Arc::new(Quadrature::new(table.clone()))),
            Profile::Wave(..) => None,
        }
    }
}

/// κ_n, as the transform of xⁿ at 1.
pub(crate) fn kappa(n: f64) -> Result<f64, Error> {
    let law = Scene::new(Shape::Power { n, c: 1.0 }, Elasticity::effective(1)?, 1)?;
    let [g, ..] = ContactColumns::new(&law)?.transform(&[1.0])?;
    Ok(g.first().copied().unwrap_or(f64::NAN))
}

/// A row of numbers that all are known.
fn known<const N: usize>(row: &[f64; N]) -> bool {
    !row.iter().any(|x| x.is_nan())
}

fn refused(error: impl std::fmt::Display) -> Error {
    Error::Scene { place: None, key: "profile.file".to_owned(), why: error.to_string() }
}

fn unshown() -> Error {
    let why = "the page shows one shape of the library, a table, or a wave on a periodic medium".to_owned();
    Error::Scene { place: None, key: "profile.kind".to_owned(), why }
}

/// Whether the contact changes in an event, and may lose energy.
pub(crate) fn changes(kind: EventKind) -> bool {
    matches!(kind, EventKind::JumpIn | EventKind::Jump | EventKind::Detached | EventKind::CompleteContact)
}

/// The number of an event in a row of the engine.
pub(crate) fn number(kind: EventKind) -> f64 {
    f64::from(match kind {
        EventKind::Start => 0u8,
        EventKind::Touch => 1,
        EventKind::JumpIn => 2,
        EventKind::Jump => 3,
        EventKind::Detached => 4,
        EventKind::CompleteContact => 5,
        EventKind::EndOfProfile => 6,
        EventKind::Undecided => 7,
        EventKind::NotAdmissible => 8,
        EventKind::WayPoint => 9,
        EventKind::End => 10,
        EventKind::Pinned => 11,
        EventKind::Depinned => 12,
    })
}
