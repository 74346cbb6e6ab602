//! Scenes: a contact, its control, and the requested outputs; built in Rust, or read from TOML or JSON.

#![cfg_attr(
    not(any(feature = "toml", feature = "serde")),
    allow(dead_code, unused_imports, reason = "what reads is not called")
)]

mod contact;
#[cfg(feature = "toml")]
mod depth;
mod inputs;
mod material;
mod measured;
mod medium;
pub(crate) mod parse;
pub(crate) mod place;
mod profile;
mod quadrature;
mod read;
mod tip;
pub(crate) mod tree;
mod want;

use mdr_core::contact::{Control, Edge, Elasticity};
use mdr_core::number::{Exact, Literal};

use crate::answer::{Answer, OutputKind};
use crate::error::{Error, Result};
use crate::run::{Run, Stop};
use crate::solve;
use crate::validity::{self, Validity};

pub(crate) use contact::{Formulas, by_formulas, not_in_f64, transform_in_doubles};
pub use contact::{ProfileReal, SceneReal};
pub use measured::Measured;
pub use medium::{ExactMedium, Grading};
pub(crate) use place::{Location, Places};
pub use profile::{Formula, IntoProfile, Profile};
pub(crate) use quadrature::by_quadrature;
use read::FEWER_WAY_POINTS;
pub use read::no_files;
pub use tree::Files;
pub use want::{Arithmetic, DEFAULT_DIGITS, MAX_DIGITS, MOST_ROWS, MOST_WAY_POINTS};

pub use mdr_numeric::path::Start;

pub use crate::outputs::{POINTS, Want};

#[cfg(feature = "mp")]
pub use material::decimal;
#[cfg(feature = "mp")]
pub(crate) use material::exactly;
#[cfg(feature = "mp")]
pub(crate) use place::double;

/// A contact and the requested outputs. All numbers are exact as written, in SI units.
///
/// ```
/// use mdr::prelude::*;
/// // Figure 4 of the paper: a wavy paraboloid is pulled off under fixed grips. It jumps once, then it breaks.
/// let tip = Shape::WavyParaboloid { radius: "1", amplitude: "5e-4", wavelength: "0.1" };
/// let scene = Scene::new(tip, Elasticity::effective("1")?, "1e-4")?
///     .path(["0", "-0.01"])?
///     .want(Want::Path)
///     .arithmetic(Arithmetic::F64);
/// let answer = scene.solve()?;
/// let path = answer.path().expect("wanted");
/// let jump = path.events.items.iter().find(|event| event.event == EventKind::Jump).expect("a jump");
/// let from = jump.contact_radius.as_ref().and_then(Value::to_f64).expect("a number");
/// let to = jump.to_contact_radius.as_ref().and_then(Value::to_f64).expect("a number");
/// assert!(to < from);
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    /// E*, exactly: as given, or of the two bodies. One if there is no material, and no requested output depends on it.
    pub(crate) effective_modulus: Literal,
    /// w, exactly as given. One if there is no material, and no requested output depends on it.
    pub(crate) work_of_adhesion: Literal,
    /// w₁ and w₂, if they differ.
    pub(crate) works: Option<Box<[Literal; 2]>>,
    /// The edge whose work of adhesion alone is considered, if there are two.
    pub(crate) edge: Option<Edge>,
    /// z₀, if the scene requests whether the theory holds.
    pub(crate) range_of_adhesion: Option<Literal>,
    has_material: bool,
    has_control: bool,
    pub(crate) medium: ExactMedium,
    pub(crate) profile: Profile,
    pub(crate) control: Control<Literal>,
    /// Way points of the controlled quantity; empty when there is no path.
    pub(crate) path: Vec<Literal>,
    pub(crate) start: Start,
    /// Each once, in the order of the scene.
    pub(crate) wants: Vec<Want>,
    /// Values of the controlled quantity that a drawing shows.
    pub(crate) values: Vec<Literal>,
    /// Contact radii between which all folds are to be proved; none when the program chooses.
    pub(crate) range: Option<[Literal; 2]>,
    /// Whether the energies of a path are wanted, where that is said.
    pub(crate) energies: Option<bool>,
    pub(crate) arithmetic: Arithmetic,
    /// How it was read, where that may surprise.
    pub(crate) notes: Vec<String>,
    /// The keys that were given, of those that may be of no use.
    given: Vec<String>,
    /// For complaints about the contact.
    pub(crate) places: Places,
}

impl Scene {
    /// A contact under fixed grips, without outputs yet.
    ///
    /// # Errors
    /// A number that is none; E* or w that is not positive; Poisson's ratio outside (−1, 1/2].
    pub fn new(profile: impl IntoProfile, elasticity: Elasticity, work_of_adhesion: impl Exact) -> Result<Scene> {
        let profile = profile.into_profile()?;
        let (at_modulus, at_work) = (Location::built("material.e_star"), Location::built("material.work_of_adhesion"));
        let work = at_work.require_positive(work_of_adhesion.exact()?)?;
        let modulus = material::effective_modulus(&elasticity)?;
        let mut numbers = profile.numbers();
        let parameters = 0..numbers.len();
        numbers.extend([(modulus.clone(), at_modulus), (work.clone(), at_work)]);
        let places = Places { read: Vec::new(), numbers, parameters };
        Ok(Scene { has_material: true, ..Scene::blank(profile, modulus, work, places) })
    }

    /// A contact under fixed grips, without outputs.
    fn blank(profile: Profile, effective_modulus: Literal, work_of_adhesion: Literal, places: Places) -> Self {
        Scene {
            effective_modulus,
            work_of_adhesion,
            works: None,
            edge: None,
            range_of_adhesion: None,
            has_material: false,
            has_control: false,
            medium: ExactMedium::default(),
            profile,
            control: Control::Indentation,
            path: Vec::new(),
            start: Start::Largest,
            wants: Vec::new(),
            values: Vec::new(),
            range: None,
            energies: None,
            arithmetic: Arithmetic::default(),
            notes: Vec::new(),
            given: Vec::new(),
            places,
        }
    }

    /// Sets the work of adhesion w₁ that an advancing edge gains, from 0 to w₂ = w, that of [`new`](Scene::new), which a receding
    /// edge needs. Between the two the edge of the contact is pinned, and paths have hysteresis.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let ball = Scene::new(Shape::Paraboloid { radius: 1 }, Elasticity::effective(1)?, "0.04")?;
    /// let path = ball
    ///     .advancing_work_of_adhesion("0.01")?
    ///     .path(["-0.2", "0.05", "-0.2"])?
    ///     .start(Start::Detached)
    ///     .want(Want::Path)
    ///     .arithmetic(Arithmetic::F64);
    /// let answer = path.solve()?;
    /// let kinds: Vec<&str> = answer.path().expect("wanted").events.items.iter().map(|event| event.event.name()).collect();
    /// assert_eq!(kinds, ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"]);
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// A number that is none, is negative, or larger than w₂.
    pub fn advancing_work_of_adhesion(mut self, work: impl Exact) -> Result<Self> {
        let place = Location::built("material.work_of_adhesion.advancing");
        let advancing = work.exact()?;
        self.works = material::works(advancing.clone(), self.work_of_adhesion.clone(), &place)?;
        self.places.numbers.push((advancing, place));
        Ok(self)
    }

    /// Whether an advancing and a receding edge have different works of adhesion.
    pub fn has_two_works(&self) -> bool {
        self.works.is_some() && self.edge.is_none()
    }

    /// The scene with the work of adhesion of one edge alone.
    pub(crate) fn at(&self, edge: Edge) -> Self {
        let mut scene = Scene { edge: Some(edge), ..self.clone() };
        // Without adhesion there is still a length of the material, which searches begin with.
        if let (Some(works), Edge::Advancing) = (&self.works, edge)
            && !works[0].is_zero()
        {
            scene.work_of_adhesion = works[0].clone();
        }
        scene
    }

    /// The scene with another profile.
    #[cfg(feature = "mp")]
    pub(crate) fn with_profile(&self, profile: Profile) -> Self {
        Scene { profile, ..self.clone() }
    }

    /// Sets the control; the stiffness of a machine in N/m.
    pub fn control(self, control: Control<Literal>) -> Self {
        Scene { control, has_control: true, ..self }
    }

    /// Sets the range z₀ of the attraction, in m: the answer then states whether the theory holds, as its [`Validity`].
    ///
    /// ```
    /// use mdr::prelude::*;
    /// // An AFM tip of 10 nm on a stiff solid is no JKR contact.
    /// let scene = Scene::new(Shape::Paraboloid { radius: "1e-8" }, Elasticity::effective("5e9")?, "0.05")?
    ///     .range_of_adhesion("0.3e-9")?
    ///     .want(Want::Folds { range: None })
    ///     .arithmetic(Arithmetic::F64);
    /// let validity = scene.solve()?.validity.expect("asked for");
    /// assert_eq!(validity.regime.name(), "transition");
    /// assert!((validity.tabor.to_f64().expect("a number") - 0.3333).abs() < 1e-4);
    /// assert!((validity.correction.and_then(|ratio| ratio.to_f64()).expect("a number") - 0.179).abs() < 1e-3);
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// A range that is no number, or not positive.
    pub fn range_of_adhesion(mut self, range: impl Exact) -> Result<Self> {
        let place = Location::built("material.range_of_adhesion");
        let range = place.require_positive(range.exact()?)?;
        self.places.numbers.push((range.clone(), place));
        Ok(Scene { range_of_adhesion: Some(range), ..self })
    }

    /// Whether the theory holds for the contact, without any other output.
    ///
    /// # Errors
    /// A scene without a range of adhesion; an input out of its domain, with its place; [`Error::NeedsMp`] for certified digits
    /// in a build without them.
    pub fn validity(&self) -> Result<Validity> {
        self.check_arithmetic()?;
        let found = validity::of(self, &Stop::default().counts());
        found
            .map_err(|error| self.places.complaint_about_profile(error))?
            .ok_or_else(|| Location::built("material.range_of_adhesion").refuse("missing: the range of adhesion in m"))
    }

    /// Sets the way points of the controlled quantity along which the contact moves.
    ///
    /// # Errors
    /// A way point that is no number.
    pub fn path<X: Exact>(self, points: impl IntoIterator<Item = X>) -> Result<Self> {
        let path = points.into_iter().map(Exact::exact).collect::<std::result::Result<_, _>>()?;
        Ok(Scene { path, ..self })
    }

    /// Sets the state at the first way point; the default is [`Start::Largest`].
    pub fn start(self, start: Start) -> Self {
        Scene { start, ..self }
    }

    /// Sets whether the energies of a path are computed: what its events dissipate, and its balance. By default they are up to
    /// 50 certified digits, beyond which they cost much more than the path; those of power laws, which are closed forms, always are.
    pub fn energies(self, wanted: bool) -> Self {
        Scene { energies: Some(wanted), ..self }
    }

    /// Adds an output, in place of an earlier one of its kind.
    pub fn want(mut self, want: Want) -> Self {
        if let Some(range) = want.request().range() {
            self.range = Some(range.clone());
        }
        self.values
            .extend(want.values().iter().filter(|value| !self.values.contains(value)).cloned().collect::<Vec<_>>());
        self.wants.retain(|other| other.kind() != want.kind());
        self.wants.push(want);
        self
    }

    /// Sets the arithmetic; the default is 20 certified digits.
    pub fn arithmetic(self, arithmetic: Arithmetic) -> Self {
        Scene { arithmetic, ..self }
    }

    /// The control.
    pub fn controlled(&self) -> &Control<Literal> {
        &self.control
    }

    /// The profile.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The requested outputs.
    pub fn wants(&self) -> &[Want] {
        &self.wants
    }

    /// Whether the scene has a material, without which there are no states.
    pub fn has_material(&self) -> bool {
        self.has_material
    }

    /// The arithmetic in which it is answered.
    pub fn answers_in(&self) -> Arithmetic {
        self.arithmetic
    }

    /// Whether one of the outputs is such.
    pub(crate) fn has(&self, which: impl Fn(OutputKind) -> bool) -> bool {
        self.wants.iter().any(|want| which(want.kind()))
    }

    /// Whether an answer names the controlled quantity.
    pub(crate) fn names_control(&self) -> bool {
        self.has_control || self.has(|kind| !kind.is_of_profile())
    }

    /// A note for each given key that nothing uses. A scene that is `drawn` uses its way points and values, requested or not.
    pub fn unused(&self, drawn: bool) -> Vec<String> {
        solve::unused(self, &self.given, drawn)
    }

    /// The answer, with all requested outputs and nothing else.
    ///
    /// # Errors
    /// An input out of its domain, with its place; no equilibrium to start a path from; [`Error::NeedsMp`] for certified digits
    /// in a build without them.
    pub fn solve(&self) -> Result<Answer> {
        self.solve_with(&mut Run::default())
    }

    /// Like [`Scene::solve`], but reports each output to an observer and can be stopped.
    ///
    /// # Errors
    /// An input out of its domain, with its place; no equilibrium to start a path from; [`Error::NeedsMp`] for certified digits
    /// in a build without them; [`Error::Stopped`].
    pub fn solve_with(&self, run: &mut Run<'_>) -> Result<Answer> {
        self.check()?;
        solve::solve(self, run)
    }

    /// Whether the scene says all that its outputs need.
    fn check(&self) -> Result<()> {
        if self.wants.is_empty() {
            return Err(self.places.of("output.want").refuse("nothing is wanted"));
        }
        self.check_needs()?;
        self.check_medium()?;
        self.check_arithmetic()
    }

    /// Whether no output lacks an input.
    fn check_needs(&self) -> Result<()> {
        if self.path.len() > MOST_WAY_POINTS {
            let given = self.path.len();
            let why = format!("{given} way points; at most {MOST_WAY_POINTS} are followed: {FEWER_WAY_POINTS}");
            return Err(self.places.of("control.path").refuse(why));
        }
        for want in &self.wants {
            if want.rows() > MOST_ROWS as usize {
                let (name, rows) = (want.name(), want.rows());
                let why = "ask for fewer values or radii, or in several scenes";
                let why = format!("`{name}` would have {rows} rows; at most {MOST_ROWS} are computed: {why}");
                return Err(self.places.of("output.want").refuse(why));
            }
            if let Some(missing) = want.missing(self.has_material, &self.path) {
                return Err(self.places.of("output.want").refuse(format!("`{}` needs {missing}", want.name())));
            }
        }
        Ok(())
    }

    /// Whether this build can answer in the requested arithmetic.
    fn check_arithmetic(&self) -> Result<()> {
        match self.arithmetic {
            Arithmetic::Certified { .. } if self.profile.has_function() => {
                let why = "a function of a program is computed in f64, and so is the answer: ask for Arithmetic::F64";
                Err(self.places.of("profile").refuse(why))
            }
            Arithmetic::Certified { digits } if !(1..=MAX_DIGITS).contains(&digits) => {
                Err(Location::built("output.digits")
                    .refuse(format!("must be a whole number from 1 to {MAX_DIGITS}, got {digits}")))
            }
            Arithmetic::Certified { .. } if cfg!(not(feature = "mp")) => {
                Err(Error::NeedsMp { what: "an answer in certified digits" })
            }
            Arithmetic::F64 => self.places.require_doubles("ask for certified digits"),
            Arithmetic::Certified { .. } => Ok(()),
        }
    }
}
