//! The medium of a scene: the table `[medium]`.

use std::cmp::Ordering;

use mdr_core::contact::{Body, Control, ControlKind};
use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use super::place::Location;
use super::profile::Profile;
use super::tree::Section;
use super::{Scene, material};
use crate::error::Result;

/// The elastic medium below the profile of a scene, with numbers as exact as they are written. Computations turn it into a
/// [`Medium`](mdr_numeric::medium::Medium) of one arithmetic.
///
/// ```
/// use mdr::prelude::*;
/// // A ball on a Winkler foundation breaks under a dead load at −2πwR.
/// let scene = Scene::new(Shape::Paraboloid { radius: "1" }, Elasticity::effective("1")?, "1e-3")?
///     .medium(ExactMedium::Winkler { modulus: "5".parse()? })?
///     .control(Control::Force)
///     .want(Want::Folds { range: None })
///     .arithmetic(Arithmetic::F64);
/// let force = scene.solve()?.folds().expect("wanted").items[0].force.to_f64().expect("a number");
/// assert!((force / (-2e-3 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum ExactMedium {
    /// A homogeneous half-space, of the modulus E* of the material.
    #[default]
    HalfSpace,
    /// A half-space whose modulus is a power of the depth, E ∝ zᵏ.
    Graded {
        /// k, within (−1, 1).
        exponent: Literal,
        /// How stiff it is.
        stiffness: Grading,
    },
    /// A Winkler foundation.
    Winkler {
        /// K_w, in Pa/m.
        modulus: Literal,
    },
    /// A half-plane of the modulus E* in line contact; the profile is read as f(|x|), and forces are per length.
    Plane {
        /// The distance L of the point of the surface from which depths are measured, in m.
        reference: Option<Literal>,
    },
    /// A half-plane of the modulus E* in contact along one strip in each period; forces are per area.
    Periodic {
        /// The period λ, in m.
        wavelength: Literal,
        /// c, half of the width of a flaw in the troughs, from which a complete contact opens, in m.
        flaw: Option<Literal>,
    },
}

/// How stiff a graded half-space is.
#[derive(Clone, Debug, PartialEq)]
pub enum Grading {
    /// By c, in N/m^(2+k): a contact of radius a has the stiffness 2c a^(1+k)/(1+k).
    Coefficient(Literal),
    /// By Young's moduli at a depth and Poisson's ratios: of one body, or of two with the same exponent.
    Moduli {
        /// z₀, in m.
        depth: Literal,
        /// The bodies, with their moduli at that depth.
        bodies: Vec<Body<Literal>>,
    },
}

impl ExactMedium {
    /// The exponent n of the power laws whose g grows as Δl does; `None` where neither is a power of the contact radius.
    #[cfg(feature = "mp")]
    pub(crate) fn threshold(&self) -> Option<rug::Rational> {
        Some(match self {
            ExactMedium::HalfSpace | ExactMedium::Plane { reference: None } => (1, 2).into(),
            ExactMedium::Graded { exponent, .. } => (1 - exponent.to_rational()) / 2u32,
            ExactMedium::Winkler { .. } => rug::Rational::new(),
            ExactMedium::Plane { .. } | ExactMedium::Periodic { .. } => return None,
        })
    }

    /// λ of a periodic medium.
    #[cfg(all(feature = "mp", feature = "serde"))]
    pub(crate) fn period(&self) -> Option<&Literal> {
        if let ExactMedium::Periodic { wavelength, .. } = self { Some(wavelength) } else { None }
    }

    /// The name of the kind in a scene.
    pub fn name(&self) -> &'static str {
        match self {
            ExactMedium::HalfSpace => "half-space",
            ExactMedium::Graded { .. } => "graded",
            ExactMedium::Winkler { .. } => "winkler",
            ExactMedium::Plane { .. } => "plane",
            ExactMedium::Periodic { .. } => "periodic",
        }
    }

    /// The unit of forces: N, or per length N/m, or per area Pa.
    pub fn force_unit(&self) -> &'static str {
        match self {
            ExactMedium::Plane { .. } => "N/m",
            ExactMedium::Periodic { .. } => "Pa",
            _ => "N",
        }
    }

    /// The key and the unit of its modulus: `e_star`, or `coefficient` of a graded half-space and `modulus` of a foundation.
    pub fn modulus_key(&self) -> (&'static str, SiUnit) {
        match self {
            ExactMedium::Graded { .. } => ("coefficient", SiUnit::Coefficient),
            ExactMedium::Winkler { .. } => ("modulus", SiUnit::PascalPerMetre),
            _ => ("e_star", SiUnit::Pascal),
        }
    }

    /// The unit of the controlled quantity.
    pub(crate) fn unit_of(&self, control: ControlKind) -> SiUnit {
        match (control, self) {
            (ControlKind::Force, ExactMedium::Plane { .. }) => SiUnit::NewtonPerMetre,
            (ControlKind::Force, ExactMedium::Periodic { .. }) => SiUnit::Pascal,
            _ => control.unit(),
        }
    }

    /// The unit of the stiffness of a machine.
    pub(crate) fn unit_of_stiffness(&self) -> SiUnit {
        match self {
            ExactMedium::Plane { .. } => SiUnit::Pascal,
            ExactMedium::Periodic { .. } => SiUnit::PascalPerMetre,
            _ => SiUnit::NewtonPerMetre,
        }
    }

    /// Whether it is the homogeneous half-space, of which closed forms and fits are.
    pub fn is_half_space(&self) -> bool {
        *self == ExactMedium::HalfSpace
    }

    /// Whether a contact is a disc: on a half-space, which may be graded, and on a Winkler foundation.
    #[cfg(feature = "mp")]
    pub(crate) fn has_discs(&self) -> bool {
        matches!(self, ExactMedium::HalfSpace | ExactMedium::Graded { .. } | ExactMedium::Winkler { .. })
    }

    /// The medium, or the half-space where its grading is none, k = 0.
    #[must_use]
    pub fn without_grading(self) -> Self {
        match self {
            ExactMedium::Graded { exponent, .. } if exponent.is_zero() => ExactMedium::HalfSpace,
            medium => medium,
        }
    }

    /// Whether a contact has a depth: that of a line contact is only against a reference.
    pub fn has_depth(&self) -> bool {
        !matches!(self, ExactMedium::Plane { reference: None })
    }

    /// k of a graded half-space, in f64.
    pub(crate) fn exponent_of_grade(&self) -> Option<f64> {
        match self {
            ExactMedium::Graded { exponent, .. } => Some(exponent.nearest_f64()),
            _ => None,
        }
    }

    /// Whether it is in contact along a strip in each period.
    pub fn is_periodic(&self) -> bool {
        matches!(self, ExactMedium::Periodic { .. })
    }

    /// Whether E* of the material is of use.
    pub(crate) fn needs_modulus(&self) -> bool {
        !matches!(self, ExactMedium::Graded { .. } | ExactMedium::Winkler { .. })
    }

    /// Reads a table `[medium]`.
    ///
    /// # Errors
    /// A key or a number that is refused, with its place.
    pub fn read(section: &Section<'_>) -> Result<Self> {
        let kind = section.required("kind")?;
        let names = ["half-space", "graded", "winkler", "plane", "periodic"];
        let kinds: Vec<(&'static str, usize)> = names.into_iter().zip(0..).collect();
        let length = |key| section.optional(key).map(|value| value.positive(SiUnit::Metre)).transpose();
        let medium = match kind.choice("medium", &kinds)? {
            0 => ExactMedium::HalfSpace,
            1 => graded(section)?,
            2 => ExactMedium::Winkler { modulus: section.required("modulus")?.positive(SiUnit::PascalPerMetre)? },
            3 => ExactMedium::Plane { reference: length("reference")? },
            _ => {
                let wavelength = section.required("wavelength")?.positive(SiUnit::Metre)?;
                ExactMedium::Periodic { wavelength, flaw: length("flaw")? }
            }
        };
        section.finish()?;
        medium.check(&|key| section.place_of(&[key]))
    }

    /// The medium, if its numbers are in their domains; a grading of k = 0 is the half-space, but for its stiffness.
    pub(crate) fn check(self, place: &dyn Fn(&'static str) -> Location) -> Result<Self> {
        match &self {
            ExactMedium::HalfSpace => {}
            ExactMedium::Graded { exponent, stiffness } => {
                let within = |bound: i64| exponent.compare(&Literal::from(bound));
                if within(-1) != Ordering::Greater || within(1) != Ordering::Less {
                    let given = exponent.to_string();
                    let remedy = "for k = 1 take kind = \"winkler\" with modulus = c/pi";
                    let why = format!("k must be within (-1, 1), got {}; {remedy}", excerpt(&given));
                    return Err(place("exponent").refuse(why));
                }
                match stiffness {
                    Grading::Coefficient(c) => drop(place("coefficient").require_positive(c.clone())?),
                    Grading::Moduli { depth, bodies } => {
                        place("depth").require_positive(depth.clone())?;
                        for body in bodies {
                            place("modulus").require_positive(body.youngs_modulus.clone())?;
                            if let Some(why) = material::refused_ratio(&body.poissons_ratio) {
                                return Err(place("nu").refuse(why));
                            }
                        }
                        if bodies.is_empty() {
                            return Err(place("modulus").refuse("missing: Young's modulus at the depth"));
                        }
                    }
                }
            }
            ExactMedium::Winkler { modulus } => drop(place("modulus").require_positive(modulus.clone())?),
            ExactMedium::Plane { reference } => {
                if let Some(reference) = reference {
                    place("reference").require_positive(reference.clone())?;
                }
            }
            ExactMedium::Periodic { wavelength, flaw } => {
                place("wavelength").require_positive(wavelength.clone())?;
                if let Some(flaw) = flaw {
                    let flaw = place("flaw").require_positive(flaw.clone())?;
                    if 2.0 * flaw.nearest_f64() >= wavelength.nearest_f64() {
                        let why = "half of the width of a flaw must be less than half of the wavelength: at that there is no contact";
                        return Err(place("flaw").refuse(why));
                    }
                }
            }
        }
        Ok(self)
    }

    /// Its numbers with the keys they have in a scene.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, &Literal)> {
        match self {
            ExactMedium::HalfSpace => Vec::new(),
            ExactMedium::Graded { exponent, stiffness } => {
                let mut numbers = vec![("medium.exponent", exponent)];
                match stiffness {
                    Grading::Coefficient(c) => numbers.push(("medium.coefficient", c)),
                    Grading::Moduli { depth, bodies } => {
                        numbers.push(("medium.depth", depth));
                        for Body { youngs_modulus, poissons_ratio } in bodies {
                            numbers.extend([("medium.modulus", youngs_modulus), ("medium.nu", poissons_ratio)]);
                        }
                    }
                }
                numbers
            }
            ExactMedium::Winkler { modulus } => vec![("medium.modulus", modulus)],
            ExactMedium::Plane { reference } => reference.iter().map(|number| ("medium.reference", number)).collect(),
            ExactMedium::Periodic { wavelength, flaw } => {
                let flaw = flaw.iter().map(|number| ("medium.flaw", number));
                [("medium.wavelength", wavelength)].into_iter().chain(flaw).collect()
            }
        }
    }

    /// The units of its numbers, in their order.
    pub(super) fn unit_symbol(&self, key: &str) -> &'static str {
        match (self, key) {
            (_, "medium.exponent" | "medium.nu") => "",
            (_, "medium.coefficient") => "N/m^(2+k)",
            (ExactMedium::Winkler { .. }, _) => "Pa/m",
            (_, "medium.modulus") => "Pa",
            _ => "m",
        }
    }
}

/// By its coefficient, or by the modulus at a depth.
fn graded(section: &Section<'_>) -> Result<ExactMedium> {
    let exponent = section.required("exponent")?.number(SiUnit::One)?;
    let stiffness = match section.one_of(&["coefficient", "modulus", "body"])? {
        (0, coefficient) => Grading::Coefficient(coefficient.positive(SiUnit::Coefficient)?),
        (which, given) => {
            let bodies = if which == 1 {
                let youngs_modulus = given.positive(SiUnit::Pascal)?;
                let poissons_ratio = section.required("nu")?.number(SiUnit::One)?;
                vec![Body { youngs_modulus, poissons_ratio }]
            } else {
                given.list()?.iter().map(super::read::body).collect::<Result<Vec<_>>>()?
            };
            if bodies.is_empty() || bodies.len() > 2 {
                return Err(given.refuse(format!("expected one body or two, got {}", bodies.len())));
            }
            Grading::Moduli { depth: section.required("depth")?.positive(SiUnit::Metre)?, bodies }
        }
    };
    Ok(ExactMedium::Graded { exponent, stiffness })
}

impl Scene {
    /// Sets the medium; the default is a homogeneous half-space. On a graded half-space and on a Winkler foundation E* of the
    /// scene is not used. On a half-plane the stiffness of a machine is per length, in Pa, and on a periodic one per area, in
    /// Pa/m.
    ///
    /// # Errors
    /// A number of the medium that is out of its domain.
    pub fn medium(mut self, medium: ExactMedium) -> Result<Self> {
        let medium = medium.check(&|key| Location::built(&format!("medium.{key}")))?;
        let numbers = medium.numbers();
        self.places.numbers.extend(numbers.into_iter().map(|(key, number)| (number.clone(), Location::built(key))));
        Ok(self.on(medium))
    }

    /// On a medium that has been checked: with k = 0 it is the half-space of E* = c.
    pub(super) fn on(mut self, medium: ExactMedium) -> Self {
        match medium {
            ExactMedium::Graded { exponent, stiffness } if exponent.is_zero() => {
                if let Some(modulus) = homogeneous(&stiffness) {
                    self.effective_modulus = modulus;
                    return self;
                }
                self.medium = ExactMedium::Graded { exponent, stiffness };
            }
            medium => self.medium = medium,
        }
        self
    }

    /// The medium.
    pub fn pressed_into(&self) -> &ExactMedium {
        &self.medium
    }

    /// Whether profile, control and outputs are such as the medium has.
    pub(super) fn check_medium(&self) -> Result<()> {
        self.check_profile_on_medium()?;
        if let ExactMedium::Plane { reference: None } = self.medium
            && (self.names_control() && self.control != Control::Force)
        {
            let why = "a line contact has no depth of its own; measure it against a point of the surface, [medium] reference = \
                       its distance, or control the force per length, kind = \"force\"";
            return Err(self.places.of("control").refuse(why));
        }
        if self.range_of_adhesion.is_some() && !self.medium.is_half_space() {
            let why = format!(
                "the theory of a finite range of adhesion is not available on kind = \"{}\"",
                self.medium.name()
            );
            return Err(self.places.of("material.range_of_adhesion").refuse(why));
        }
        Ok(())
    }

    pub(crate) fn check_profile_on_medium(&self) -> Result<()> {
        match (&self.profile, &self.medium) {
            (Profile::Wave(_), ExactMedium::Periodic { .. }) => Ok(()),
            (Profile::Wave(_), other) => {
                let why = format!(
                    "a wave is periodic and needs [medium] kind = \"periodic\" with its wavelength; here the medium is \"{}\", \
                     on which kind = \"wavy-paraboloid\" has waves",
                    other.name()
                );
                Err(self.places.of("profile").refuse(why))
            }
            (Profile::Sum(_), ExactMedium::Periodic { .. }) => {
                let why = "a sum is not periodic; on a periodic medium take kind = \"wave\", or write the sum as a periodic formula";
                Err(self.places.of("profile").refuse(why))
            }
            (Profile::Shape(shape), ExactMedium::Periodic { .. }) => {
                let why = format!(
                    "\"{}\" is not periodic; on a periodic medium take kind = \"wave\" or a periodic formula",
                    shape.name()
                );
                Err(self.places.of("profile").refuse(why))
            }
            _ => Ok(()),
        }
    }
}

/// E* of a half-space graded with k = 0.
fn homogeneous(stiffness: &Grading) -> Option<Literal> {
    match stiffness {
        Grading::Coefficient(c) => Some(c.clone()),
        Grading::Moduli { bodies, .. } => material::series(bodies),
    }
}
