//! Whether a contact is simply connected, as the theory assumes: no gap outside it is negative.
//!
//! The gap at r > a is h(r) = (2/π) ∫ₐʳ (g(x) − d)/√(r² − x²) dx, an average of g − d with positive weights. So
//!
//! * no gap is negative if g ≥ d for all x > a: for a profile with nondecreasing g every state is admissible;
//! * if h is negative anywhere, it is negative somewhere on an interval of radii where g < d. For with h ≥ 0 up to ξ
//!   and g ≥ d from there to r, h(r) is at least (1/π) ∫ √((r² − ξ²)/(ξ² − s²)) · 2s/(r² − s²) h(s) ds ≥ 0 (Abel's
//!   equation, solved outwards);
//! * the greatest admissible d at radius a, the least average of g over r, does not increase with a where it is below
//!   g(a), and d increases with a on a stable branch. So admissibility is lost at most once on a stable branch, and for
//!   all larger radii; and a shrinking contact, continuous or in jumps, stays admissible;
//! * separated surfaces first touch at d = min f, the limit a → 0 of the same condition.
//!
//! If g decreases anywhere, its extrema are searched in double precision, once per contact, in the same way as folds;
//! the gap is then an integral on the few intervals where g < d.

mod extrema;
mod gap;
#[cfg(feature = "mp")]
mod proved;
mod refine;

use std::sync::{Arc, LazyLock};

#[cfg(feature = "mp")]
use mdr_core::contact::LowestRing;
use mdr_core::contact::{Fold, Result, Shape, Transform};
use mdr_core::number::{Literal, Real};

use crate::contact::Contact;

use extrema::Terrain;

pub(crate) use refine::first_touch_roughly;
pub use refine::{Ring, Touch, first_touch, last_admissible};
#[cfg(feature = "mp")]
pub(crate) use refine::{lost_roughly, proved_touch};

/// Decides whether states of a contact are admissible, in double precision and for any number of states.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Material, Shape};
/// use mdr_numeric::admissible::{Admissibility, GapVerdict};
/// use mdr_numeric::{contact::Contact, transform::Quadrature};
/// // Waves of 10 mm on a paraboloid of 1 m: the first crest alone cannot be pressed deep.
/// let wavy = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 1e-2, wavelength: 0.1 }])?);
/// let (material, control) = (Material::new(1.0, 1e-6)?, Control::Indentation);
/// let admissibility = Admissibility::new(wavy.clone(), [1e-6, 0.3]);
/// let curve = Contact::half_space(&wavy, &material, &control);
/// assert_eq!(admissibility.of(0.01, curve.indentation(&0.01)?), GapVerdict::Admissible);
/// let GapVerdict::Interpenetrating { radius, gap } = admissibility.of(0.03, curve.indentation(&0.03)?) else { panic!() };
/// assert!(gap < 0.0 && radius > 0.08 && radius < 0.12); // at the next crest
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Admissibility {
    terrain: Option<Arc<LazyTerrain>>,
    /// For a formula or a function, whose narrow dips the search may miss.
    touch: Option<FirstTouch>,
    /// The first touch of a shape that is not lowest at its tip.
    lowest: Option<FirstTouch>,
    /// Why nothing is known.
    unknown: Option<&'static str>,
    /// Whether enclosures prove that g falls nowhere.
    is_rising: bool,
    /// By which each verdict is proved.
    #[cfg(feature = "mp")]
    gaps: Option<Arc<crate::proof::EnclosedGaps>>,
}

/// The extrema of g, which are searched when something needs them, and once.
type LazyTerrain = LazyLock<Terrain, Box<dyn FnOnce() -> Terrain + Send + Sync>>;

/// The search of extrema between two radii, not made yet.
fn searched(transform: Arc<dyn Transform<f64>>, radii: [f64; 2]) -> Option<Arc<LazyTerrain>> {
    Some(Arc::new(LazyLock::new(Box::new(move || Terrain::new(transform, radii)))))
}

/// Where separated surfaces first touch: of a formula as far as enclosures of f decide it.
#[derive(Clone, Debug)]
pub enum FirstTouch {
    /// At the tip: f ≥ 0.
    Tip,
    /// On a ring, where f < 0.
    #[cfg(feature = "mp")]
    Ring(Box<LowestRing>),
    /// On the [ring](Shape::lowest_ring) on which this shape is lowest.
    OfShape(Box<Shape<Literal>>),
    /// Not decided.
    Open {
        /// The indentation, in m, at which they certainly do not touch yet; −∞ if there is none.
        at_least: f64,
        /// Where f comes from.
        heights: HeightSource,
    },
}

impl FirstTouch {
    fn heights(&self) -> HeightSource {
        match self {
            FirstTouch::Open { heights, .. } => *heights,
            _ => HeightSource::Formula,
        }
    }
}

/// Where the heights of a profile come from whose narrow dips a search may miss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeightSource {
    /// A formula, of which enclosures tell something.
    Formula,
    /// A function of a program, which is known at radii only.
    Function,
}

impl HeightSource {
    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            HeightSource::Formula => "formula",
            HeightSource::Function => "function",
        }
    }
}

/// The admissibility of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GapVerdict {
    /// No gap is negative, up to the end of the profile.
    Admissible,
    /// The surfaces would interpenetrate.
    Interpenetrating {
        /// A radius r > a of interpenetration, in m.
        radius: f64,
        /// The gap there, in m.
        gap: f64,
    },
    /// Not decided, with the reason.
    Undecided(&'static str),
}

/// The basis of the verdicts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Basis {
    /// The form of the profile: its g is nondecreasing.
    Bound,
    /// The gap was enclosed everywhere outside the contact, for each state that is decided.
    Proved,
    /// Enclosures prove that g falls nowhere.
    Rising,
    /// The extrema of g were searched in double precision, and g was resolved everywhere.
    Searched,
    /// The search did not resolve g everywhere: an interpenetration that is found is certain, but others may exist.
    Doubtful,
    /// Nothing is known of any state, for this reason.
    Unknown(&'static str),
    /// The profile is a formula or a function, and may have dips between the radii of the search: an interpenetration that is found is
    /// certain, and no state is called admissible.
    Unproved {
        /// The largest distance between two radii at which the search has seen g, over the smaller one.
        width: f64,
        /// Where f comes from.
        heights: HeightSource,
    },
}

/// Why nothing is known of states on another medium than a half-space, unless g rises.
pub const NOT_SEARCHED: &str = "on this medium the gap outside the contact is not searched";

impl Admissibility {
    /// For a transformed profile whose extrema are searched between two radii, and up to the last kink or the end of
    /// the profile; [`search_range`] gives radii for a contact. The search is made when a question needs it, and once.
    pub fn new(transform: Arc<dyn Transform<f64>>, radii: [f64; 2]) -> Self {
        if transform.rises() {
            return Self::of_rising();
        }
        Admissibility { terrain: searched(transform, radii), ..Self::of_rising() }
    }

    /// For a transformed formula or function of which nothing else is proved. The extrema are searched as by [`Admissibility::new`], but
    /// interpenetrations that the search does not find may exist.
    pub fn of_formula(transform: Arc<dyn Transform<f64>>, radii: [f64; 2], touch: FirstTouch) -> Self {
        Admissibility { terrain: searched(transform, radii), touch: Some(touch), ..Self::of_rising() }
    }

    /// For a profile with nondecreasing g: every state is admissible.
    pub const fn of_rising() -> Self {
        Admissibility {
            terrain: None,
            touch: None,
            lowest: None,
            unknown: None,
            is_rising: false,
            #[cfg(feature = "mp")]
            gaps: None,
        }
    }

    /// For a profile on a medium on which the gap outside a contact is not searched: nothing is known of any state.
    pub fn unknown(why: &'static str) -> Self {
        Admissibility { unknown: Some(why), ..Self::of_rising() }
    }

    /// With the first touch of the separated surfaces as on a half-space, where that is all that is known: it is a matter of f alone. A
    /// search in doubles tells whether it is at the tip, and an enclosed formula on which ring.
    #[must_use]
    pub fn touching_as(self, on_half_space: &Admissibility) -> Self {
        let touch = match on_half_space.first_touch_by_form() {
            _ if on_half_space.touches_at_tip() => FirstTouch::Tip,
            Some(touch) => touch.clone(),
            None => FirstTouch::Open { at_least: f64::NEG_INFINITY, heights: HeightSource::Formula },
        };
        Admissibility { touch: Some(touch), ..self }
    }

    /// With the ring on which a shape is lowest, where that is not its tip.
    #[must_use]
    pub fn with_shape(self, shape: &Shape<Literal>) -> Self {
        let is_low = shape.map(|_, length| length.nearest_f64()).lowest_ring().is_some();
        Admissibility { lowest: is_low.then(|| FirstTouch::OfShape(Box::new(shape.clone()))), ..self }
    }

    /// The first touch, where it is known without a search.
    fn first_touch_by_form(&self) -> Option<&FirstTouch> {
        self.touch.as_ref().or(self.lowest.as_ref())
    }

    /// Whether it is decided that the separated surfaces first touch at the tip.
    pub fn touches_at_tip(&self) -> bool {
        matches!(first_touch_roughly(self), Ok(None))
    }

    /// A shared [`Admissibility`] for profiles with nondecreasing g: every state is admissible.
    pub fn rising() -> &'static Admissibility {
        static RISING: Admissibility = Admissibility::of_rising();
        &RISING
    }

    /// For a transformed profile in any arithmetic, evaluated there and rounded.
    pub(crate) fn rounded<R: Real>(curve: &Contact<R>, folds: &[Fold<R>]) -> Self {
        let (transform, length) = (Arc::clone(curve.shared_transform()), curve.material_length());
        if !curve.medium().is_half_space() && !transform.rises() {
            return Self::unknown(NOT_SEARCHED);
        }
        let radii: Vec<f64> = folds.iter().map(|fold| fold.contact_radius.approx()).collect();
        Self::new(Arc::new(Rounded { transform, ctx: length.ctx() }), search_range(length.approx(), &radii))
    }

    /// The basis of the verdicts.
    pub fn basis(&self) -> Basis {
        #[cfg(feature = "mp")]
        if self.gaps.is_some() {
            return Basis::Proved;
        }
        if let Some(why) = self.unknown {
            return Basis::Unknown(why);
        }
        match &self.terrain {
            None if self.holds_by_form() => Basis::Bound,
            None if self.is_rising => Basis::Rising,
            None => Basis::Doubtful,
            Some(terrain) => match &self.touch {
                Some(touch) if terrain.width.is_finite() => {
                    Basis::Unproved { width: terrain.width, heights: touch.heights() }
                }
                _ if terrain.resolved => Basis::Searched,
                _ => Basis::Doubtful,
            },
        }
    }

    /// Whether every state is admissible by the form of the profile: the [basis](Admissibility::basis) is [`Basis::Bound`]. This
    /// needs no search.
    pub fn holds_by_form(&self) -> bool {
        self.terrain.is_none() && self.unknown.is_none() && !self.is_rising
    }

    /// Whether anything is known of a state.
    pub fn is_known(&self) -> bool {
        self.unknown.is_none()
    }

    /// Whether a contact of radius a at the indentation d is admissible, in equilibrium or not.
    pub fn of(&self, a: f64, d: f64) -> GapVerdict {
        if let Some(why) = self.unknown {
            return GapVerdict::Undecided(why);
        }
        let Some(terrain) = &self.terrain else { return GapVerdict::Admissible };
        if !(a > 0.0 && a.is_finite() && d.is_finite()) {
            return GapVerdict::Undecided("its contact radius or its indentation is no double");
        }
        let apart = if !terrain.knows(a) {
            GapVerdict::Undecided("g is not resolved everywhere outside the contact")
        } else {
            match self.touch.as_ref().map(FirstTouch::heights) {
                Some(HeightSource::Formula) => {
                    GapVerdict::Undecided("the formula may dip between the radii at which g was looked at")
                }
                Some(HeightSource::Function) => {
                    GapVerdict::Undecided("the function may dip between the radii at which g was looked at")
                }
                None => GapVerdict::Admissible,
            }
        };
        if let Some((radius, gap)) = self.at_lowest_ring(terrain, a, d) {
            return GapVerdict::Interpenetrating { radius, gap };
        }
        match terrain.narrowest(a, d, true) {
            Err(_) => GapVerdict::Undecided("g cannot be computed everywhere outside the contact"),
            Ok(Some((radius, _))) => match terrain.sign(a, d, radius) {
                Some(gap) if gap < 0.0 => GapVerdict::Interpenetrating { radius, gap },
                Some(_) => apart,
                None => GapVerdict::Undecided("the gap closes up to rounding"),
            },
            Ok(None) => apart,
        }
    }

    /// The ring on which a formula is lowest and the gap there, if the surfaces clearly interpenetrate on it. The search may have
    /// missed it, but h(r) = f(r) − d − (2/π) ∫₀ᵃ (g − d)/√(r² − x²) dx depends on f there and on g inside the contact only.
    #[cfg(feature = "mp")]
    fn at_lowest_ring(&self, terrain: &Terrain, a: f64, d: f64) -> Option<(f64, f64)> {
        let Some(FirstTouch::Ring(ring)) = &self.touch else { return None };
        let [radius, height] = ring.at::<f64>(());
        if a >= radius {
            return None;
        }
        let gap = terrain.gap_over(height, radius, a, d).ok()?;
        gap.filter(|gap| *gap < 0.0).map(|gap| (radius, gap))
    }

    #[cfg(not(feature = "mp"))]
    fn at_lowest_ring(&self, _: &Terrain, _: f64, _: f64) -> Option<(f64, f64)> {
        None
    }

    /// An indentation, in m, at which the separated surfaces of a formula do not touch yet, if the indentation at which they
    /// first touch is not decided.
    pub(crate) fn open_touch(&self) -> Option<f64> {
        match self.touch {
            Some(FirstTouch::Open { at_least, .. }) => Some(at_least),
            _ => None,
        }
    }

    /// The radius and the height, in double precision, at which f < 0 is smallest: separated surfaces first touch
    /// there. `None` if f ≥ 0, and if it cannot be computed.
    pub fn first_touch(&self) -> Option<[f64; 2]> {
        first_touch_roughly(self).unwrap_or_default()
    }

    /// Whether separated surfaces are proved to touch first on a ring.
    #[cfg(feature = "mp")]
    pub fn has_proved_ring(&self) -> bool {
        matches!(self.touch, Some(FirstTouch::Ring(_)))
    }

    /// The minima of g below `d` between two radii, where growth of the contact may require energy.
    pub(crate) fn dips(&self, from: f64, to: f64, d: f64) -> Vec<f64> {
        let edges = self.terrain.iter().flat_map(|terrain| &terrain.edges);
        edges.filter(|edge| edge.x > from && edge.x < to && edge.g < d).map(|edge| edge.x).collect()
    }
}

/// Radii between which g matters for the states of a contact with the length w/E* and folds at the given contact radii:
/// from 10^−14 times the smallest of these, below which no known profile oscillates, to 100 times the largest; without
/// folds to 10¹⁴ times w/E*.
pub fn search_range(length: f64, folds: &[f64]) -> [f64; 2] {
    let smallest = folds.iter().fold(length, |least, radius| least.min(*radius));
    let largest = folds.iter().fold(length, |most, radius| most.max(*radius));
    let [inwards, outwards] = [1e-14, if folds.is_empty() { 1e14 } else { 100.0 }];
    [(smallest * inwards).max(f64::MIN_POSITIVE), (largest * outwards).min(f64::MAX / 1024.0)]
}

/// A transform of another arithmetic, in doubles.
struct Rounded<R: Real> {
    transform: Arc<dyn Transform<R>>,
    ctx: R::Ctx,
}

impl<R: Real> Rounded<R> {
    fn at(&self, x: f64) -> R {
        R::from_f64(self.ctx, x)
    }
}

impl<R: Real> Transform<f64> for Rounded<R> {
    fn g(&self, x: &f64) -> Result<f64> {
        Ok(self.transform.g(&self.at(*x))?.approx())
    }
    fn slope(&self, x: &f64) -> Result<f64> {
        Ok(self.transform.slope(&self.at(*x))?.approx())
    }
    fn integral(&self, x: &f64) -> Result<f64> {
        Ok(self.transform.integral(&self.at(*x))?.approx())
    }
    fn outer_radius(&self) -> Option<f64> {
        Some(self.transform.outer_radius()?.approx())
    }
    fn kinks(&self) -> Vec<f64> {
        self.transform.kinks().iter().map(Real::approx).collect()
    }
    fn rises(&self) -> bool {
        self.transform.rises()
    }
}
