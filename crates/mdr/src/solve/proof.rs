//! The contact over enclosures, and all its folds on a range of radii, on which the proofs of other outputs rest.

use mdr_core::contact::{Control, Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::proof::{CurveInDoubles, EnclosedCurve, EnclosedGaps, ProvedFolds, rises_from};
use rug::Float;
use rug::float::Round;

use super::admissible::rises_up_to;
use super::certified::Certified;
use super::digits::start;
use super::model::{Model, SceneReal};
use super::sample::{self, Range};
use super::weight::weight_of_height;
use crate::answer::{Completeness, Number, Value};
use crate::scene::Scene;

/// Bits in which folds are isolated; they are sharpened afterwards.
const ISOLATION: u32 = 64;
/// The most bits by which it is finer where terms of a formula cancel.
const MOST_LOST: u32 = 4 * ISOLATION;
/// Bits up to which folds are sharpened at once to those of the answer: there an evaluation costs little more than in those of the isolation.
const FINEST: u32 = 128;
/// Evaluations that the isolation may spend between two kinks.
const BUDGET: usize = 4_000_000;
/// The budget between two rows of a table, where an evaluation is a sum over all rows and one fold the rule.
const BUDGET_OF_ROWS: usize = 10_000;

/// What is said where a range was chosen that ends before the last of the folds, or of the kinks, that are seen.
const BEYOND: &str =
    "; beyond this range a search in f64 sees more folds or kinks, and `folds.range` asks for the folds there";

/// The contact over enclosures, and over enclosures with derivatives.
pub(crate) struct Enclosed {
    pub(crate) value: Model<Interval>,
    dual: Model<Dual<Interval>>,
    in_doubles: Option<CurveInDoubles>,
}

impl Enclosed {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(certified: &Certified<'_>, precision: Precision) -> Result<Self> {
        let (value, dual) = (certified.model(precision)?, certified.model(precision)?);
        Ok(Enclosed { value, dual, in_doubles: certified.curve_in_doubles().cloned() })
    }

    pub(crate) fn curve(&self) -> EnclosedCurve {
        EnclosedCurve::new(self.value.contact(), self.dual.contact()).with_doubles(self.in_doubles.clone())
    }

    /// The curve under a controlled force, whose folds are those of F.
    pub(crate) fn curve_of_force(&self) -> EnclosedCurve {
        self.curve_under(&Control::Force)
    }

    /// The curve at fixed grips, whose folds are those of d.
    fn curve_at_fixed_grips(&self) -> EnclosedCurve {
        self.curve_under(&Control::Indentation)
    }

    /// The curve under another control, in every arithmetic.
    fn curve_under(&self, control: &Control<Literal>) -> EnclosedCurve {
        let (value, dual) = (self.value.under(control), self.dual.under(control));
        let in_doubles = self.in_doubles.as_ref().map(|curve| curve.under(control));
        EnclosedCurve::new(value, dual).with_doubles(in_doubles)
    }
}

/// All folds on a range of radii, in a precision that separates them.
pub(crate) struct FoldProof {
    pub(crate) proved: ProvedFolds,
    /// The completeness of the folds in the range.
    pub(crate) complete: Completeness,
    /// The range, if states beyond it are not looked for.
    pub(crate) limits: Option<[Literal; 2]>,
    /// Whether none is looked for, since the surfaces stay apart.
    pub(crate) is_apart: bool,
}

impl FoldProof {
    /// Without any, for a path of surfaces that stay apart.
    pub(crate) fn of_none() -> Self {
        let one = || Float::with_val(ISOLATION, 1);
        let proved = ProvedFolds::on((one(), one()));
        let complete = Completeness { proved: true, from: None, to: None, why: String::new(), undecided: false };
        FoldProof { proved, complete, limits: None, is_apart: true }
    }

    /// On the range that the scene names, else on a range with all folds that were found in f64.
    ///
    /// # Errors
    /// A range out of its domain; errors of the transform. See [`EnclosedCurve::folds`].
    pub(crate) fn new(certified: &Certified<'_>) -> Result<Self> {
        let Range { ends: range, is_limit } = range(certified)?;
        let mut enclosed = Enclosed::new(certified, Precision::new(ISOLATION))?;
        // Cells as close to an equator as folds may be.
        let bits = ISOLATION.max(3 * enclosed.curve().octaves_to_equator()? - ISOLATION);
        let bits = bits + lost_bits(certified, &enclosed, &range[0])?;
        let precision = Precision::new(bits);
        if bits > ISOLATION {
            enclosed = Enclosed::new(certified, precision)?;
        }
        let is_given = certified.scene.range.is_some();
        let size = |end| if is_given { enclosed.value.size(end) } else { Ok(Interval::from_literal(precision, end)) };
        let [lower, upper] = [size(&range[0])?, size(&range[1])?];
        let mut curve = enclosed.curve();
        if certified.scene.takes_integrals() {
            curve = curve.by_integrals();
        }
        let asked = start(certified.digits);
        if bits < asked.bits() && asked.bits() <= FINEST {
            curve = curve.with_fine(Enclosed::new(certified, asked)?.curve().by_integrals());
        }
        // What states need once the folds are known is kept.
        let folds = || curve.folds(lower.lower(), upper.upper(), budget_of_folds(certified.scene));
        let proved = certified.counts[0].budget().holding_back(folds)?;
        let limits = is_limit.then(|| range.clone());
        let [from, to] = range;
        let to = match enclosed.value.contact().vertical_edge() {
            Some(outer_edge) if *outer_edge.lower() < *upper.upper() => Number::F64(outer_edge.approx()).to_string(),
            _ if proved.range.1 < *upper.lower() => proved.range.1.to_string_radix_round(10, Some(10), Round::Down),
            _ => to.to_string(),
        };
        let (from, to) = if certified.scene.pressed_into().is_periodic() {
            let radius = |size| Number::F64(enclosed.value.contact_radius(size).approx()).to_string();
            (Some(radius(&lower)), Some(radius(&upper)))
        } else {
            (Some(from.to_string()), Some(to))
        };
        let why = reason(&proved) + if is_limit && !is_given { BEYOND } else { "" };
        let complete =
            Completeness { proved: proved.is_complete(), from, to, why, undecided: !proved.undecided.is_empty() };
        Ok(FoldProof { proved, complete, limits, is_apart: false })
    }
}

/// The bits by which the isolation is finer where the terms of a formula cancel towards the axis: such as x g' needs at the least radius.
fn lost_bits(certified: &Certified<'_>, coarse: &Enclosed, least: &Literal) -> Result<u32> {
    if !certified.scene.profile.has_formula() || certified.scene.pressed_into().is_periodic() {
        return Ok(0);
    }
    let is_accurate = |enclosed: &Enclosed| {
        let slope = enclosed.value.contact().transform().slope(&enclosed.value.size(least)?);
        Ok(decided(slope)?.is_none_or(|slope| slope.accuracy_bits() > i64::from(ISOLATION / 2)))
    };
    if is_accurate(coarse)? {
        return Ok(0);
    }
    for more in (ISOLATION..=MOST_LOST).step_by(ISOLATION as usize) {
        if is_accurate(&Enclosed::new(certified, Precision::new(ISOLATION + more))?)? {
            return Ok(more);
        }
    }
    Ok(0)
}

/// The evaluations that the isolation of folds may spend between two kinks.
pub(crate) fn budget_of_folds(scene: &Scene) -> usize {
    if scene.is_closed() { BUDGET } else { BUDGET_OF_ROWS }
}

/// The range that the scene names, else one with all folds that were found in f64.
fn range(certified: &Certified<'_>) -> Result<Range> {
    if let Some(ends) = certified.scene.range.clone() {
        return Ok(Range { ends, is_limit: true });
    }
    sample::range(certified.search()?)
}

/// Admissibility on a medium where g is an integral that is proved to fall nowhere: no extrema on the range of the folds, and a rise
/// below and beyond. `None` if that is not proved, as of a profile that ends: towards its end g is not enclosed.
///
/// # Errors
/// Errors of the search for folds; a parameter out of its domain.
pub(super) fn of_proved_rise(certified: &Certified<'_>) -> Result<Option<Admissibility>> {
    let range = range(certified)?.ends;
    let precision = Precision::new(ISOLATION);
    let curve = Enclosed::new(certified, precision)?.curve();
    let proved = curve.plain().transform();
    let [lower, upper] = range.each_ref().map(|end| Interval::from_literal(precision, end));
    let rises_elsewhere = proved.outer_radius().is_none()
        && rises_from(proved, upper.upper())
        && rises_up_to(&certified.scene.profile, lower.upper());
    if !rises_elsewhere {
        return Ok(None);
    }
    let extrema = decided(curve.extrema(lower.lower(), upper.upper(), BUDGET_OF_ROWS))?.flatten();
    Ok(extrema.is_some_and(|extrema| extrema.is_empty()).then(Admissibility::of_proved_rise))
}

/// Enclosures of the gap outside a contact on a half-space; `None` of a table of many rows, and of a function.
///
/// # Errors
/// Errors of the transform; a parameter out of its domain.
pub(super) fn gaps(certified: &Certified<'_>) -> Result<Option<EnclosedGaps>> {
    let scene = certified.scene;
    if !scene.pressed_into().is_half_space() || !scene.has_proofs() {
        return Ok(None);
    }
    let precision = Precision::new(ISOLATION);
    let profile = match certified.formulas()? {
        Some(formulas) => decided(formulas.continued(precision))?,
        None => None,
    };
    let enclosed = Enclosed::new(certified, precision)?;
    let contact = enclosed.value.contact();
    let weight = weight_of_height(&scene.profile, Interval::INDEX, ISOLATION);
    let gaps = EnclosedGaps::new(contact, profile)?.within(certified.counts[0].budget(), weight);
    if scene.is_short_table() {
        return Ok(Some(gaps.by_staircases(certified.curve_in_doubles())));
    }
    let [lower, upper] = range(certified)?.ends.map(|end| enclosed.value.size(&end));
    let range = (lower?.lower().clone(), upper?.upper().clone());
    Ok(Some(gaps.with_folds(enclosed.curve_at_fixed_grips().by_integrals(), range, budget_of_folds(scene))))
}

/// Why folds are all, or are not.
fn reason(ProvedFolds { undecided, is_spent, .. }: &ProvedFolds) -> String {
    if undecided.is_empty() {
        return "enclosures of the tangency condition leave no room for another fold".to_owned();
    }
    // As many digits as tell the two ends apart.
    let gap = |(lower, upper): &(Float, Float)| {
        let pair = |digits| [lower, upper].map(|end| format!("{:.digits$e}", end.to_f64()));
        let [from, to] = Some(pair(8)).filter(|[from, to]| from != to).unwrap_or_else(|| pair(16));
        format!("{from} to {to}")
    };
    let shown: Vec<_> = undecided.iter().take(3).map(gap).collect();
    let more = if undecided.len() > 3 { format!(" and {} more", undecided.len() - 3) } else { String::new() };
    let why =
        if *is_spent { ": the budget was spent before these were looked at; a larger one may decide it" } else { "" };
    format!("undecided at contact radii {}{more}{why}", shown.join(", "))
}

/// The number as it is written.
pub(crate) fn exactly(literal: &Literal) -> Value<Enclosure> {
    Value::Known(Enclosure::Exact(literal.to_rational()))
}

/// Of the two the one that is controlled, as it is written.
pub(crate) fn controlled_exactly(
    control: &Control<Literal>,
    literal: &Literal,
    indentation: &mut Value<Enclosure>,
    force: &mut Value<Enclosure>,
) {
    match control {
        Control::Indentation => *indentation = exactly(literal),
        Control::Force => *force = exactly(literal),
        Control::Machine { .. } => {}
    }
}

/// `None` if the question stays open, or an integral does not reach: the two estimates may.
pub(crate) fn reached<T>(result: Result<T>) -> Result<Option<T>> {
    match result {
        Err(Error::Domain { .. }) => Ok(None),
        result => decided(result),
    }
}

/// `None` if the question stays open.
pub(crate) fn decided<T>(result: Result<T>) -> Result<Option<T>> {
    match result {
        Err(error) if is_open(&error) => Ok(None),
        result => result.map(Some),
    }
}

/// Whether an error leaves the question open.
pub(crate) fn is_open(error: &Error) -> bool {
    matches!(error, Error::Undecided { .. } | Error::Unproved { .. })
}
