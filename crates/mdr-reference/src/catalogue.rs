//! All records, and their selection by filters.

use std::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

use crate::fraction::Fraction;
use crate::record::Record;
use crate::text::excerpt;

/// The files of the release, in order.
const FILES: [&str; 10] = [
    include_str!("../data/critical.jsonl"),
    include_str!("../data/equilibria.jsonl"),
    include_str!("../data/profiles.jsonl"),
    include_str!("../data/edges.jsonl"),
    include_str!("../data/worst.jsonl"),
    include_str!("../data/fits.jsonl"),
    include_str!("../data/graded.jsonl"),
    include_str!("../data/line.jsonl"),
    include_str!("../data/wave.jsonl"),
    include_str!("../data/loop.jsonl"),
];

/// All records of this release, parsed once.
///
/// # Panics
/// If a line of the release is not a record, which a test of every line excludes.
///
/// ```
/// use mdr_reference::{Difficulty, records};
/// let hard = records().iter().filter(|record| record.difficulty == Difficulty::Higher);
/// assert!(hard.count() > 0);
/// ```
pub fn records() -> &'static [Record] {
    static RECORDS: OnceLock<Vec<Record>> = OnceLock::new();
    let read = |line| Record::from_json(line).unwrap_or_else(|error| panic!("{error}: {line}"));
    RECORDS.get_or_init(|| lines().map(read).collect())
}

/// The records as published, one JSON object per line.
pub fn lines() -> impl Iterator<Item = &'static str> {
    FILES.iter().flat_map(|file| file.lines())
}

/// Records whose ids begin alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Family<'a> {
    /// The beginning of their ids, up to the first slash.
    pub name: &'a str,
    /// The first of them.
    pub example: &'a Record,
    /// How many there are of each [difficulty](crate::Difficulty::ALL).
    pub counts: [usize; 3],
}

/// The families of these records, in the order of their first records.
pub fn families<'a>(records: &[&'a Record]) -> Vec<Family<'a>> {
    let mut families: Vec<Family<'_>> = Vec::new();
    for &example in records {
        let name = example.id.split('/').next().unwrap_or_default();
        let known = families.iter().position(|family| family.name == name);
        let place = known.unwrap_or_else(|| {
            families.push(Family { name, example, counts: [0; 3] });
            families.len() - 1
        });
        families[place].counts[example.difficulty as usize] += 1;
    }
    families
}

/// The record with this identifier.
pub fn record(id: &str) -> Option<&'static Record> {
    records().iter().find(|record| record.id == id)
}

/// A selection of records: terms separated by blanks or commas, all of which must be satisfied.
///
/// A term is `key=value`, `key!=value` or `key~part` (contains). Keys: `id`, `profile`, `formula`, `quantity`, `unit`,
/// `control` (`none` if there is none), `status`, `difficulty`, `flag` (also `physical`: [`Record::is_physical`]), and the inputs
/// by their names, such as `n` or `radius`, whose values are compared as numbers: `n=1.5`, `n=3/2`. A value or a part that no record has is an
/// error, and so are terms that no record satisfies together: an empty selection due to a typing error would pass every
/// test.
///
/// ```
/// use mdr_reference::{Filter, records};
/// let filter: Filter = "profile=power control=force difficulty!=higher".parse()?;
/// assert!(records().iter().any(|record| filter.accepts(record)));
/// let spheres: Filter = "n=2 formula=critical".parse()?;
/// assert!(spheres.select().all(|record| record.input("n") == Some("2")));
/// assert!("colour=red".parse::<Filter>().is_err());
/// assert!("profile=sfere".parse::<Filter>().is_err());
/// assert!("control=force control=machine".parse::<Filter>().is_err());
/// # Ok::<(), mdr_reference::FilterError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Filter(Vec<Term>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Term {
    key: Key,
    relation: Relation,
    value: String,
}

/// Reads a value from a record.
type Value = fn(&Record) -> Option<&str>;

/// The keys of terms, each with the value of a record; a record has any number of flags.
const KEYS: [(&str, Value); 9] = [
    ("id", |record| Some(&record.id)),
    ("profile", |record| Some(&record.profile)),
    ("formula", |record| Some(&record.formula)),
    ("quantity", |record| Some(&record.quantity)),
    ("unit", |record| Some(&record.unit)),
    ("control", |record| record.control.as_deref().or(Some("none"))),
    ("status", |record| Some(record.status.name())),
    ("difficulty", |record| Some(record.difficulty.name())),
    ("flag", |record| record.is_physical().then_some("physical")),
];

/// What a term is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Key {
    Field(&'static str),
    /// An input by its name.
    Input(&'static str),
}

/// The names of all inputs, sorted.
fn inputs() -> Vec<&'static str> {
    let names = records().iter().flat_map(|record| record.inputs.iter().map(|(name, _)| name.as_str()));
    names.collect::<std::collections::BTreeSet<_>>().into_iter().collect()
}

/// The values of a record under this key.
fn values(key: Key, record: &Record) -> impl Iterator<Item = &str> {
    let flags = if key == Key::Field("flag") { record.flags.as_slice() } else { &[] };
    let own = KEYS.iter().filter(move |(name, _)| Key::Field(name) == key).filter_map(|(_, value)| value(record));
    let input = if let Key::Input(name) = key { record.input(name) } else { None };
    flags.iter().map(String::as_str).chain(own).chain(input)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Is,
    IsNot,
    Contains,
}

/// A text that is not a filter, or selects nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilterError {
    /// The term, or all of them.
    text: String,
    wrong: Wrong,
}

/// The fault of a filter.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Wrong {
    /// A term of another form.
    Form,
    /// A value that no record has under this key.
    Value(Key),
    /// Terms that no record satisfies together.
    Empty,
}

impl fmt::Display for FilterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = excerpt(&self.text);
        match self.wrong {
            Wrong::Form => {
                let keys = KEYS.map(|(name, _)| name).join(", ");
                let inputs = inputs().join(", ");
                write!(
                    f,
                    "{text} is no condition: expected key=value, key!=value or key~part with one of {keys}, or an input: {inputs}"
                )
            }
            Wrong::Empty => write!(f, "no record meets all terms of {text}: leave one out"),
            Wrong::Value(Key::Field("id")) => write!(f, "{text} fits no record: there is no such id"),
            Wrong::Value(Key::Input(name)) => write!(f, "{text} fits no record: none has this value of {name}"),
            Wrong::Value(key @ Key::Field(name)) => {
                let mut values: Vec<&str> = records().iter().flat_map(|record| values(key, record)).collect();
                values.sort_unstable();
                values.dedup();
                write!(f, "{text} fits no record: {name} is one of {}", values.join(", "))
            }
        }
    }
}

impl std::error::Error for FilterError {}

impl FromStr for Filter {
    type Err = FilterError;

    fn from_str(text: &str) -> Result<Self, FilterError> {
        let terms = text.split([' ', ',', '\t', '\n']).filter(|term| !term.is_empty());
        let filter = Filter(terms.map(term).collect::<Result<_, _>>()?);
        let chosen = filter.select().next().is_some();
        if chosen { Ok(filter) } else { Err(FilterError { text: text.to_owned(), wrong: Wrong::Empty }) }
    }
}

fn term(text: &str) -> Result<Term, FilterError> {
    let error = || FilterError { text: text.to_owned(), wrong: Wrong::Form };
    let at = text.find(['=', '!', '~']).ok_or_else(error)?;
    let (name, rest) = text.split_at(at);
    let (relation, value) = [("!=", Relation::IsNot), ("=", Relation::Is), ("~", Relation::Contains)]
        .into_iter()
        .find_map(|(sign, relation)| rest.strip_prefix(sign).map(|value| (relation, value)))
        .ok_or_else(error)?;
    let field = KEYS.into_iter().find(|(key, _)| *key == name).map(|(key, _)| Key::Field(key));
    let input = || inputs().into_iter().find(|input| *input == name).map(Key::Input);
    let key = field.or_else(input).ok_or_else(error)?;
    if value.is_empty() {
        return Err(error());
    }
    let term = Term { key, relation, value: value.to_owned() };
    if records().iter().any(|record| term.fits(record)) {
        Ok(term)
    } else {
        Err(FilterError { text: text.to_owned(), wrong: Wrong::Value(key) })
    }
}

impl Filter {
    /// Whether the record is selected. The filter of an empty text selects all.
    pub fn accepts(&self, record: &Record) -> bool {
        self.0.iter().all(|term| term.holds(record))
    }

    /// The selected records, at least one.
    pub fn select(&self) -> impl Iterator<Item = &'static Record> {
        records().iter().filter(|record| self.accepts(record))
    }
}

impl Term {
    /// Whether the record has the value or the part, negated or not.
    fn fits(&self, record: &Record) -> bool {
        values(self.key, record).any(|text| match self.relation {
            Relation::Contains => text.contains(&self.value),
            Relation::Is | Relation::IsNot => text == self.value || self.is_number(text),
        })
    }

    /// Whether an input has this value in another notation.
    fn is_number(&self, text: &str) -> bool {
        matches!(self.key, Key::Input(_))
            && Fraction::of(text).is_some_and(|own| Fraction::of(&self.value) == Some(own))
    }

    fn holds(&self, record: &Record) -> bool {
        // A record without the input is none of another value of it.
        if let Key::Input(name) = self.key
            && record.input(name).is_none()
        {
            return false;
        }
        self.fits(record) != (self.relation == Relation::IsNot)
    }
}
