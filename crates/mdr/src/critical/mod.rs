//! The critical state of a power-law contact, f = C rⁿ.

mod double;
#[cfg(feature = "serde")]
mod json;
mod rows;
mod words;

use mdr_core::contact::{Control, Elasticity, Error, Quantity, Regime, Shape, Status};
use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use crate::answer::{Fold, Number, Value};
use crate::error::Result;
#[cfg(feature = "mp")]
use crate::outputs::folds;
use crate::scene::{Arithmetic, Location, Profile, Scene};
use crate::validity::Validity;

pub use rows::{CriticalRow, overview, spreadsheet};
pub use words::NamedQuantity;

/// A power law f = C rⁿ in contact, exactly as given.
#[derive(Clone, Debug, PartialEq)]
pub struct PowerLaw {
    /// n > 0.
    pub n: Literal,
    /// C > 0, in m^(1−n).
    pub c: Literal,
    /// E*, or two bodies.
    pub elasticity: Elasticity,
    /// w > 0, in J/m².
    pub work_of_adhesion: Literal,
    /// The control, with the stiffness of a machine in N/m.
    pub control: Control<Literal>,
}

/// The threshold that decides at n = 1/2.
#[derive(Clone, Debug, PartialEq)]
pub struct Threshold {
    /// The C of (1.19) under this control.
    pub c: Value,
    /// C over the threshold.
    pub ratio: Value,
}

/// The inputs in the arithmetic of the answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// n.
    pub n: Value,
    /// C.
    pub c: Value,
    /// E and ν of each body, where two were given.
    pub bodies: Option<[[Value; 2]; 2]>,
    /// E*, as given or of the two bodies.
    pub e_star: Value,
    /// w.
    pub work: Value,
    /// k of a machine.
    pub stiffness: Option<Value>,
}

/// The critical state of a power law, or the threshold in its place at n = 1/2.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalAnswer {
    /// The requested arithmetic.
    pub arithmetic: Arithmetic,
    /// The power law and its control.
    pub law: PowerLaw,
    /// Pull-off above n = 1/2, complete contact below.
    pub regime: Regime,
    /// The inputs as numbers.
    pub inputs: Inputs,
    /// κ_n of (1.12).
    pub kappa: Number,
    /// `Ok`, or the status of the first quantity out of range.
    pub status: Status,
    /// The critical state, which is a fold of the controlled quantity; `None` if there is none.
    pub state: Option<Fold>,
    /// The threshold at n = 1/2.
    pub threshold: Option<Threshold>,
    /// On a machine: all folds, by increasing radius.
    pub folds: Option<Vec<Fold>>,
    /// Whether the theory holds, where a [range of adhesion](CriticalAnswer::with_range) was given.
    pub validity: Option<Box<Validity>>,
}

impl CriticalAnswer {
    /// From all folds of a law; that which is met first on the stable branch is the critical state.
    fn new(
        law: &PowerLaw,
        arithmetic: Arithmetic,
        regime: Regime,
        inputs: Inputs,
        kappa: Number,
        folds: Vec<Fold>,
        threshold: Option<Threshold>,
    ) -> Self {
        let state = if regime == Regime::PullOff { folds.last() } else { folds.first() }.cloned();
        let of_threshold = threshold.iter().flat_map(|threshold| [&threshold.c, &threshold.ratio]);
        CriticalAnswer {
            arithmetic,
            law: law.clone(),
            regime,
            inputs,
            kappa,
            status: first_trouble(state.iter().flat_map(Fold::values).chain(of_threshold)),
            state,
            threshold,
            folds: matches!(law.control, Control::Machine { .. }).then_some(folds),
            validity: None,
        }
    }

    /// The critical state of the same contact under the other of the two controls of a test by hand, fixed grips and a dead load;
    /// `None` on a machine, and if there is no critical state.
    ///
    /// # Errors
    /// [`Error::Domain`] for an input out of its domain, and in f64 out of its range.
    pub fn sibling(&self) -> Result<Option<CriticalAnswer>> {
        let control = match self.law.control {
            Control::Indentation => Control::Force,
            Control::Force => Control::Indentation,
            Control::Machine { .. } => return Ok(None),
        };
        let law = PowerLaw { control, ..self.law.clone() };
        self.state.as_ref().map(|_| critical(&law, self.arithmetic)).transpose()
    }

    /// Adds whether the theory holds, by the range z₀ of adhesion, in m, for the contact under a dead load.
    ///
    /// # Errors
    /// A range that is no number, or not positive; an input out of its domain. See [`Scene::validity`].
    pub fn with_range(self, range: &Literal) -> Result<Self> {
        let scene = self.law.scene()?.range_of_adhesion(range.clone())?;
        let validity = scene.arithmetic(self.arithmetic).validity()?;
        Ok(CriticalAnswer { validity: Some(Box::new(validity)), ..self })
    }
}

fn first_trouble<'a>(values: impl IntoIterator<Item = &'a Value>) -> Status {
    values.into_iter().map(Value::status).find(|status| *status != Status::Ok).unwrap_or(Status::Ok)
}

/// The critical state of a power law: (1.15), (1.17) and their kin under a dead load and on a machine.
///
/// ```
/// use mdr::critical::{PowerLaw, critical};
/// use mdr::prelude::*;
/// // n = 1/2: nothing but C decides, against the threshold 0.7628 √(w/E*) of the paper.
/// let [n, c, work] = ["1/2", "1e-3", "0.05"].map(|text| text.parse().unwrap());
/// let elasticity = Elasticity::effective("1e6")?;
/// let law = PowerLaw { n, c, elasticity, work_of_adhesion: work, control: Control::Indentation };
/// let answer = critical(&law, Arithmetic::F64)?;
/// assert!(answer.state.is_none() && answer.threshold.is_some());
/// # Ok::<(), mdr::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] for an input out of its domain, and in f64 out of its range.
pub fn critical(law: &PowerLaw, arithmetic: Arithmetic) -> Result<CriticalAnswer> {
    match arithmetic {
        Arithmetic::F64 => Ok(double::answer(law)?),
        #[cfg(feature = "mp")]
        Arithmetic::Certified { digits } => Ok(certified(law, digits)?),
        #[cfg(not(feature = "mp"))]
        Arithmetic::Certified { .. } => Err(crate::Error::NeedsMp { what: "an answer in certified digits" }),
    }
}

impl PowerLaw {
    /// The contact of a scene, where its profile is a power law with rational constants: a power, a cone by its slope, a
    /// paraboloid. `None` with two works of adhesion.
    pub fn of(scene: &Scene) -> Option<PowerLaw> {
        let plain = scene.pressed_into().is_half_space() && !scene.has_two_works();
        let [n, c] = rational_constants(&scene.profile).filter(|_| plain)?;
        Some(PowerLaw {
            n,
            c,
            elasticity: Elasticity::Effective(scene.effective_modulus.clone()),
            work_of_adhesion: scene.work_of_adhesion.clone(),
            control: scene.control.clone(),
        })
    }

    /// The power law as a scene, without outputs yet. Its `folds` are those of [`critical`] in certified digits, and in f64 the
    /// doubles nearest to them.
    ///
    /// ```
    /// use mdr::critical::{PowerLaw, critical};
    /// use mdr::prelude::*;
    /// let law = PowerLaw::from_keys(|key| match key {
    ///     "n" => Some("2"),
    ///     "c" | "e_star" | "work" => Some("1"),
    ///     _ => None,
    /// })?;
    /// # #[cfg(feature = "mp")] {
    /// let answer = law.scene()?.want(Want::Folds { range: None }).solve()?;
    /// assert_eq!(answer.folds().expect("wanted").items, [critical(&law, Arithmetic::default())?.state.expect("one")]);
    /// # }
    /// # Ok::<(), mdr::Error>(())
    /// ```
    ///
    /// # Errors
    /// A number out of its domain.
    pub fn scene(&self) -> Result<Scene> {
        let PowerLaw { n, c, elasticity, work_of_adhesion, control } = self.clone();
        Ok(Scene::new(Profile::Shape(Shape::Power { n, c }), elasticity, work_of_adhesion)?.control(control))
    }

    /// The keys of a question, as in a scene or in the header of a table.
    pub const KEYS: [&str; 6] = ["n", "c", "e_star", "work", "control", "stiffness"];

    /// A question by its [`KEYS`](PowerLaw::KEYS): numbers as text, in SI or with a unit such as `1 GPa`, and the control by its name, by default the
    /// indentation depth; the stiffness is that of a machine.
    ///
    /// # Errors
    /// [`Error::Scene`](crate::Error::Scene) with the key of an input that is missing, no number, or not positive.
    pub fn from_keys<'a>(text: impl Fn(&str) -> Option<&'a str>) -> Result<PowerLaw> {
        let refuse = |key: &str, why: String| Location::built(key).refuse(why);
        let number = |key: &str, unit: SiUnit| -> Result<Literal> {
            let (text, place) = (text(key).ok_or_else(|| refuse(key, "missing".to_owned()))?, Location::built(key));
            place.require_positive(unit.read(text).map_err(|error| place.no_number(text, &error))?)
        };
        let control = match text("control").unwrap_or("indentation") {
            "indentation" => Control::Indentation,
            "force" => Control::Force,
            "machine" => Control::Machine { stiffness: number("stiffness", SiUnit::NewtonPerMetre)? },
            other => {
                return Err(refuse(
                    "control",
                    format!("expected indentation, force or machine, got `{}`", excerpt(other)),
                ));
            }
        };
        Ok(PowerLaw {
            n: number("n", SiUnit::One)?,
            c: number("c", SiUnit::Coefficient)?,
            elasticity: Elasticity::Effective(number("e_star", SiUnit::Pascal)?),
            work_of_adhesion: number("work", SiUnit::JoulePerSquareMetre)?,
            control,
        })
    }

    /// n and C of a paraboloid of radius of curvature R, f = r²/2R, exactly; `None` for a number of absurd length.
    #[cfg(feature = "mp")]
    pub fn paraboloid(radius: &Literal) -> Option<[Literal; 2]> {
        Some([2.into(), crate::scene::exactly(&(radius.to_rational() * 2u32).recip())?])
    }

    /// n and C of a cone by the half angle at its apex, f = r cot α, to some digits more than requested; `None` if they cannot be
    /// decided.
    #[cfg(feature = "mp")]
    pub fn cone(degrees: &Literal, arithmetic: Arithmetic) -> Option<[Literal; 2]> {
        use mdr_core::contact::Flank;
        use mdr_core::number::certify::Enclosure;
        use mdr_core::number::{Interval, Precision, Real};
        const MORE: u32 = 10;
        let digits = match arithmetic {
            Arithmetic::Certified { digits } => digits + MORE,
            Arithmetic::F64 => 17,
        };
        let slope = (1..=8).find_map(|attempt| {
            let angle = Interval::from_literal(Precision::from_digits(attempt * (digits + MORE)), degrees);
            Enclosure::from(Flank::HalfAngleDegrees(angle).slope()).round(digits)
        })?;
        Some([1.into(), slope.to_string().parse().ok()?])
    }

    /// The exact question.
    #[cfg(feature = "mp")]
    fn question(&self) -> mdr_core::contact::Result<mdr_analytic::certified::Question> {
        mdr_analytic::certified::Question::new(
            &self.n,
            &self.c,
            &self.elasticity,
            &self.work_of_adhesion,
            &self.control,
        )
    }

    fn inputs(&self, number: impl Fn(&Literal) -> Value, derived: impl FnOnce() -> Value) -> Inputs {
        let (bodies, e_star) = match &self.elasticity {
            Elasticity::Effective(e_star) => (None, number(e_star)),
            Elasticity::Bodies(bodies) => {
                let of = |body: &mdr_core::contact::Body<Literal>| {
                    [number(&body.youngs_modulus), number(&body.poissons_ratio)]
                };
                (Some(bodies.as_ref().each_ref().map(of)), derived())
            }
        };
        let stiffness = match &self.control {
            Control::Machine { stiffness } => Some(number(stiffness)),
            _ => None,
        };
        Inputs {
            n: number(&self.n),
            c: number(&self.c),
            bodies,
            e_star,
            work: number(&self.work_of_adhesion),
            stiffness,
        }
    }
}

#[cfg(feature = "mp")]
fn certified(law: &PowerLaw, digits: u32) -> mdr_core::contact::Result<CriticalAnswer> {
    use mdr_core::number::certify::Enclosure;
    let question = law.question()?;
    let answer = question.answer(digits)?;
    let known = |decimal| Value::Known(Number::Certified(decimal));
    let e_star = || match Enclosure::Exact(question.effective_modulus().clone()).round(digits) {
        Some(decimal) => known(decimal),
        None => Value::unknown(Status::Undecided, "E* of the two bodies"),
    };
    let threshold = answer.threshold.clone().zip(answer.ratio.clone());
    let threshold = threshold.map(|(threshold, ratio)| Threshold { c: known(threshold), ratio: known(ratio) });
    let inputs = law.inputs(|literal| Value::Given(literal.clone()), e_star);
    let (arithmetic, regime) = (Arithmetic::Certified { digits }, answer.regime);
    let kappa = Number::Certified(answer.kappa.clone());
    Ok(CriticalAnswer::new(law, arithmetic, regime, inputs, kappa, folds::of_answer(answer), threshold))
}

/// n and C of a power law, exactly.
#[cfg(feature = "mp")]
fn rational_constants(profile: &Profile) -> Option<[Literal; 2]> {
    profile.exact_power_law(Literal::to_rational)
}

/// n and C of a profile that is a power law, with C = 1/2R in hardware arithmetic.
#[cfg(not(feature = "mp"))]
fn rational_constants(profile: &Profile) -> Option<[Literal; 2]> {
    let halved = |radius: Literal| Literal::try_from(0.5 / radius.nearest_f64()).unwrap_or(radius);
    profile.power_law(Literal::clone, halved)
}

/// An input that no double holds.
fn out_of_doubles(quantity: Quantity, value: impl ToString) -> Error {
    let requirement = "within the range of f64, or asked for in certified digits";
    Error::Domain { quantity, value: value.to_string(), requirement }
}
