//! The keys of `[output]` that belong to one output: lists of radii or values, a range of radii, a number of samples.

use std::cmp::Ordering;

use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use super::OutputKind;
use crate::error::Result;
use crate::scene::Location;
use crate::scene::tree::{InputValue, Section};

/// How a number of a list is read in its unit.
pub(crate) type Reader = fn(&InputValue<'_>, SiUnit) -> Result<Literal>;

/// The key that one output has for its question.
#[derive(Clone, Copy)]
pub(crate) enum Key {
    /// `at` in the table of the output: radii, in m.
    Radii(Reader),
    /// `at` in the table of the output: values of the controlled quantity. Other outputs at states also have them.
    Values,
    /// `range` in the table of the output: two ascending contact radii.
    Range,
    /// A whole number in `[output]`.
    Count { name: &'static str, least: u32, most: u32 },
}

impl Key {
    /// Its place among the keys of `[output]`, which are read and complained about in this order.
    fn order(self) -> usize {
        match self {
            Key::Radii(_) | Key::Values => 0,
            Key::Range => 1,
            Key::Count { .. } => 2,
        }
    }

    /// The key with its table, for notes.
    pub(crate) fn label(self, kind: OutputKind) -> String {
        match self {
            Key::Radii(_) | Key::Values => format!("[output.{}]", kind.name()),
            Key::Range => format!("[output.{}] range", kind.name()),
            Key::Count { name, .. } => format!("[output] {name}"),
        }
    }
}

/// The outputs that have a key of their own, in the order in which the keys are read.
pub(crate) fn keyed() -> Vec<(OutputKind, Key)> {
    let mut keyed: Vec<_> = OutputKind::ALL.iter().filter_map(|kind| Some((*kind, kind.facts().key?))).collect();
    keyed.sort_by_key(|(_, key)| key.order());
    keyed
}

/// What a scene says below the keys of its outputs.
#[derive(Default)]
pub(crate) struct Keys {
    lists: Vec<(OutputKind, Vec<Literal>)>,
    /// Values of the controlled quantity.
    pub(crate) values: Vec<Literal>,
    /// Contact radii between which all folds are to be proved, and where they are given.
    pub(crate) range: Option<([Literal; 2], Location)>,
    counts: Vec<(OutputKind, u32)>,
    /// The keys that are given, as notes name them.
    pub(crate) given: Vec<String>,
}

impl Keys {
    /// Reads the keys of all outputs, wanted or not; `held` is the unit of the controlled quantity.
    ///
    /// # Errors
    /// A value out of its domain, with its place.
    pub(crate) fn read(section: &Section<'_>, held: SiUnit) -> Result<Self> {
        let mut keys = Keys::default();
        for (kind, key) in keyed() {
            let is_given = match key {
                Key::Radii(read) => {
                    let radii = at(section, kind.name(), SiUnit::Metre, read)?;
                    keys.lists.push((kind, radii.clone()));
                    !radii.is_empty()
                }
                Key::Values => {
                    keys.values = at(section, kind.name(), held, |value, unit| value.number(unit))?;
                    !keys.values.is_empty()
                }
                Key::Range => {
                    keys.range = range(section, kind.name())?;
                    keys.range.is_some()
                }
                Key::Count { name, least, most } => {
                    let count = section.optional(name).map(|count| count.whole(least, most)).transpose()?;
                    keys.counts.extend(count.map(|count| (kind, count)));
                    count.is_some()
                }
            };
            keys.given.extend(is_given.then(|| key.label(kind)));
        }
        Ok(keys)
    }

    /// The radii of an output; an empty list lets the program choose them.
    pub(crate) fn radii(&self, kind: OutputKind) -> Vec<Literal> {
        self.lists.iter().find(|(known, _)| *known == kind).map_or(Vec::new(), |(_, radii)| radii.clone())
    }

    /// The whole number of an output.
    pub(crate) fn count(&self, kind: OutputKind) -> Option<u32> {
        self.counts.iter().find(|(known, _)| *known == kind).map(|(_, count)| *count)
    }
}

/// The list `at` of a sub-table of `[output]`.
fn at(section: &Section<'_>, key: &'static str, unit: SiUnit, read: Reader) -> Result<Vec<Literal>> {
    let Some(value) = section.optional(key) else {
        return Ok(Vec::new());
    };
    let inner = value.section()?;
    let list = inner.required("at")?.numbers(unit, read);
    inner.finish()?;
    list
}

/// The key `range` of a sub-table of `[output]`, with its place.
fn range(section: &Section<'_>, key: &'static str) -> Result<Option<([Literal; 2], Location)>> {
    let Some(value) = section.optional(key) else {
        return Ok(None);
    };
    let inner = value.section()?;
    let list = inner.required("range")?;
    let ends = list.numbers(SiUnit::Metre, InputValue::positive)?;
    inner.finish()?;
    let [lower, upper] = <[Literal; 2]>::try_from(ends)
        .map_err(|ends| list.refuse(format!("expected two contact radii, got {}", ends.len())))?;
    if lower.compare(&upper) != Ordering::Less {
        return Err(list.refuse({
            let [lower, upper] = [lower, upper].map(|end| end.to_string());
            format!("the range must ascend, got {} to {}", excerpt(&lower), excerpt(&upper))
        }));
    }
    Ok(Some(([lower, upper], list.place())))
}
