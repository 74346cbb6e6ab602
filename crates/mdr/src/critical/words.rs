//! A critical state in words: the question in a line, the quantities by name, and the behaviour there.

use mdr_core::contact::{ControlKind, Regime};

use super::CriticalAnswer;
use crate::answer::{NumberStyle, Value};
use crate::scene::Arithmetic;

/// A quantity of an answer: its name for a reader, its value where there is one, and its unit.
pub type NamedQuantity<'a> = (String, Option<&'a Value>, &'static str);

impl CriticalAnswer {
    /// The question in one line.
    pub fn heading(&self) -> String {
        self.heading_with("")
    }

    /// The question in one line, with a note behind the controlled quantity.
    pub fn heading_with(&self, note_on_control: &str) -> String {
        let inputs = &self.inputs;
        let bodies = match &inputs.bodies {
            Some([[e1, nu1], [e2, nu2]]) => {
                format!(" from E1 = {e1} Pa, nu1 = {nu1}, E2 = {e2} Pa, nu2 = {nu2}")
            }
            None => String::new(),
        };
        let control = match &inputs.stiffness {
            Some(stiffness) => format!("a machine of stiffness {stiffness} N/m"),
            None => format!("controlled {}", self.law.control.kind().name()),
        };
        let promise = match self.arithmetic {
            Arithmetic::Certified { digits: 1 } => "1 certified digit".to_owned(),
            Arithmetic::Certified { digits } => format!("{digits} certified digits"),
            Arithmetic::F64 => "f64".to_owned(),
        };
        format!(
            "Profile f(r) = C r^n, n = {}, C = {}; E* = {} Pa{bodies}; w = {} J/m²; {control}{note_on_control}; {promise}",
            inputs.n, inputs.c, inputs.e_star, inputs.work
        )
    }

    /// The threshold at n = 1/2, then radius, depth and force of the critical state, or of each fold where there are several.
    pub fn quantities<'a>(&'a self) -> Vec<NamedQuantity<'a>> {
        const NAMES: [(&str, &str); 3] =
            [("contact radius a", "m"), ("indentation depth d", "m"), ("normal force F", "N")];
        let mut all: Vec<NamedQuantity<'a>> = Vec::new();
        if let Some(threshold) = &self.threshold {
            all.push(("threshold of C".to_owned(), Some(&threshold.c), "m^(1/2)"));
            all.push(("C / threshold".to_owned(), Some(&threshold.ratio), ""));
        }
        let mut add = |suffix: &str, values: [Option<&'a Value>; 3]| {
            all.extend(NAMES.iter().zip(values).map(|((name, unit), value)| (format!("{name}{suffix}"), value, *unit)));
        };
        match self.folds.as_deref() {
            Some(folds) if folds.len() > 1 => {
                for (index, fold) in folds.iter().enumerate() {
                    add(&format!(", fold {} ({})", index + 1, fold.kind.name()), fold.values().map(Some));
                }
            }
            _ if self.regime == Regime::ScaleFree && self.state.is_none() => {}
            _ => add("", self.state.as_ref().map_or([None; 3], |state| state.values().map(Some))),
        }
        all
    }

    /// The critical state at fixed grips or under a dead load in a sentence, where there is one.
    pub fn sentence(&self, style: &NumberStyle) -> Option<String> {
        let state = self.state.as_ref()?;
        let is_force = self.law.control.kind() == ControlKind::Force;
        let control = if is_force { "Under a dead load" } else { "At fixed grips" };
        let jkr = is_force && self.law.n.small_integer() == Some(2);
        let closed = if jkr { " = -3/2 pi w R" } else { "" };
        let of = |value: &Value, unit| format!("{} {}", style.value(value, unit), style.unit(unit));
        let [a, d, force] = [of(&state.contact_radius, "m"), of(&state.indentation, "m"), of(&state.force, "N")];
        Some(format!("{control}: F = {force}{closed} at d = {d}, a = {a}."))
    }

    /// The behaviour at the critical state, in a sentence or two.
    pub fn explanation(&self) -> String {
        let kind = self.law.control.kind();
        let controlled = match kind {
            ControlKind::Force => "force",
            ControlKind::Machine => "position d + F/k",
            ControlKind::Indentation => "indentation depth",
        };
        let folds = self.folds.as_ref().map_or(1, Vec::len);
        match self.regime {
            Regime::ScaleFree if kind == ControlKind::Machine => {
                "Scale-free (n = 1/2) on a machine: below the threshold of C no contact is stable; from there to three times \
                 the threshold a contact is stable up to the radius of a fold, beyond which it spreads over the whole \
                 surface; above, every contact is stable."
                    .to_owned()
            }
            Regime::ScaleFree => format!(
                "Scale-free (n = 1/2): no radius is singled out. At zero {} a contact of any radius shrinks to nothing \
                 when C is above the threshold, and spreads over the whole surface when C is below.",
                kind.name()
            ),
            Regime::PullOff if folds > 1 => format!(
                "Pull-off (n > 1/2), multistable with {folds} folds of the {controlled}: on unloading the one of the \
                 largest radius is met first; beyond it the contact jumps to a smaller radius or breaks."
            ),
            Regime::PullOff => format!(
                "Pull-off (n > 1/2): when the {controlled} falls below that of this state, no equilibrium is left and \
                 the contact breaks."
            ),
            Regime::CompleteContact => format!(
                "Complete contact (n < 1/2): when the {controlled} rises above that of this state, no equilibrium is \
                 left and the contact spreads over the whole surface."
            ),
        }
    }
}
