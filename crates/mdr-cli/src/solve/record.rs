//! Records of an answer: named fields, in any arithmetic.
//!
//! An output is a list of records. The same record holds enclosures while its digits are being decided, and decimals or
//! doubles when it is printed.

use mdr_core::contact::{Error, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::Verdict;

/// One field.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Field<N> {
    /// A result.
    Number(N),
    /// A number of the scene, as it was written.
    Given(Literal),
    /// No number: its status, log10 of its magnitude where that is known, and the reason in words.
    Marked { status: Status, log10: Option<f64>, why: Option<String> },
    /// There is none, and none is expected.
    Absent,
    /// A word.
    Word(&'static str),
    /// Yes or no.
    Flag(bool),
    /// Records below this one.
    Records(Vec<Record<N>>),
}

impl<N> Field<N> {
    /// A result that may be out of range or out of its domain.
    ///
    /// # Errors
    /// What is wrong with the whole computation and not with this number.
    pub(crate) fn from_result(result: Result<N>) -> Result<Self> {
        Ok(match result {
            Ok(value) => Field::Number(value),
            Err(Error::OutOfRange { log10, .. }) => {
                let status = if log10 > 0.0 { Status::Overflow } else { Status::Underflow };
                Field::Marked { status, log10: Some(log10), why: None }
            }
            Err(error @ Error::Domain { .. }) => Field::unknown(Status::DomainError, &error),
            Err(error @ Error::NoConvergence { .. }) => Field::unknown(Status::Undecided, &error),
            Err(error) => return Err(error),
        })
    }

    /// No number, for the reason that the error gives.
    pub(crate) fn unknown(status: Status, error: &Error) -> Self {
        Field::Marked { status, log10: None, why: Some(error.to_string()) }
    }

    pub(crate) fn status(&self) -> Status {
        match self {
            Field::Marked { status, .. } => *status,
            _ => Status::Ok,
        }
    }

    /// The same with nothing in the place of a number.
    pub(crate) fn without_number<M>(self) -> Field<M> {
        self.map(&mut |_| Field::Absent)
    }

    fn map<M>(self, f: &mut impl FnMut(N) -> Field<M>) -> Field<M> {
        match self {
            Field::Number(number) => f(number),
            Field::Given(literal) => Field::Given(literal),
            Field::Marked { status, log10, why } => Field::Marked { status, log10, why },
            Field::Absent => Field::Absent,
            Field::Word(word) => Field::Word(word),
            Field::Flag(flag) => Field::Flag(flag),
            Field::Records(records) => Field::Records(records.into_iter().map(|record| record.map(f)).collect()),
        }
    }
}

/// Named fields in the order in which they are printed, and the status of the whole.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Record<N> {
    fields: Vec<(&'static str, Field<N>)>,
    status: Option<Status>,
    /// The reason of that status, in words.
    why: Option<String>,
    /// Of a state, whether it is admissible; none of another record.
    verdict: Option<Verdict>,
}

impl<N> Default for Record<N> {
    fn default() -> Self {
        Record { fields: Vec::new(), status: None, why: None, verdict: None }
    }
}

impl<N> Record<N> {
    pub(crate) fn new() -> Self {
        Record::default()
    }

    pub(crate) fn with(mut self, key: &'static str, field: Field<N>) -> Self {
        self.fields.push((key, field));
        self
    }

    /// The same with another number under a key that has one.
    pub(crate) fn replacing(mut self, key: &str, field: Field<N>) -> Self {
        let number =
            |(name, old): &&mut (&str, Field<N>)| *name == key && matches!(old, Field::Number(_) | Field::Absent);
        if let Some((_, old)) = self.fields.iter_mut().find(number) {
            *old = field;
        }
        self
    }

    /// What stands under a key.
    pub(crate) fn get(&self, key: &str) -> Option<&Field<N>> {
        self.fields.iter().find(|(name, _)| *name == key).map(|(_, field)| field)
    }

    /// A result; see [`Field::from_result`].
    ///
    /// # Errors
    /// As there.
    pub(crate) fn number(self, key: &'static str, result: Result<N>) -> Result<Self> {
        Ok(self.with(key, Field::from_result(result)?))
    }

    /// The same with a status that its numbers do not tell.
    pub(crate) fn marked(self, status: Status) -> Self {
        Record { status: Some(status), ..self }
    }

    /// The same where what belongs to it could not be found, for the reason that the error gives.
    pub(crate) fn open(self, error: &Error) -> Self {
        Record { status: Some(Status::Undecided), why: Some(error.to_string()), ..self }
    }

    /// Whether it is [open](Record::open), or a number in it is undecided.
    pub(crate) fn is_open(&self) -> bool {
        let open = |(_, field): &(&str, Field<N>)| match field {
            Field::Records(records) => records.iter().any(Record::is_open),
            field => field.status() == Status::Undecided,
        };
        self.why.is_some() && self.status == Some(Status::Undecided) || self.fields.iter().any(open)
    }

    /// The same with the reason of its status.
    pub(crate) fn because(self, why: String) -> Self {
        Record { why: Some(why), ..self }
    }

    /// A state and whether it is admissible. Where the surfaces would overlap, that is its status.
    pub(crate) fn judged(self, verdict: Verdict) -> Self {
        match verdict {
            Verdict::Interpenetrating { radius, gap } => self.overlapping(point(radius, gap)),
            verdict => Record { verdict: Some(verdict), ..self },
        }
    }

    /// A state in which the surfaces would overlap, with a point where they do.
    pub(crate) fn overlapping(self, point: Option<Self>) -> Self {
        let verdict = Some(Verdict::Interpenetrating { radius: f64::NAN, gap: f64::NAN });
        let record = self.with("interpenetration", Field::Records(point.into_iter().collect()));
        Record { verdict, ..record }.marked(Status::NotAdmissible)
    }

    /// Whether it is admissible, of a state.
    pub(crate) fn verdict(&self) -> Option<Verdict> {
        self.verdict
    }

    /// The records under a key.
    pub(crate) fn into_records(self, key: &str) -> Vec<Record<N>> {
        let found = self.fields.into_iter().find(|(name, _)| *name == key);
        if let Some((_, Field::Records(records))) = found { records } else { Vec::new() }
    }

    /// The same without the records under a key.
    pub(crate) fn emptied(mut self, key: &str) -> Self {
        self.fields
            .iter_mut()
            .filter(|(name, _)| *name == key)
            .for_each(|(_, field)| *field = Field::Records(Vec::new()));
        self
    }

    pub(crate) fn fields(&self) -> &[(&'static str, Field<N>)] {
        &self.fields
    }

    /// That of the record where it has one, else that of its first number in trouble, else ok.
    pub(crate) fn status(&self) -> Status {
        let of_fields = || self.fields.iter().map(|(_, field)| field.status()).find(|status| *status != Status::Ok);
        self.status.or_else(of_fields).unwrap_or(Status::Ok)
    }

    /// What is wrong, in words.
    pub(crate) fn why(&self) -> Option<String> {
        let of_field = |(_, field): &'_ (&str, Field<N>)| match field {
            Field::Marked { why: Some(why), .. } => Some(why.clone()),
            _ => None,
        };
        let undecided = || match self.verdict {
            Some(Verdict::Undecided(why)) => Some(format!("whether it is admissible is not known: {why}")),
            _ => None,
        };
        self.why.clone().or_else(|| self.fields.iter().find_map(of_field)).or_else(undecided)
    }

    pub(crate) fn map<M>(self, f: &mut impl FnMut(N) -> Field<M>) -> Record<M> {
        let fields = self.fields.into_iter().map(|(key, field)| (key, field.map(f))).collect();
        Record { fields, status: self.status, why: self.why, verdict: self.verdict }
    }

    /// The same with all numbers in another type.
    pub(crate) fn convert<M>(self, mut f: impl FnMut(N) -> M) -> Record<M> {
        self.map(&mut |number| Field::Number(f(number)))
    }
}

/// Records in which each field is made of those of two records of one form; none where the forms differ, and where `pair` is
/// none.
pub(crate) fn paired<N, M>(
    records: Vec<Record<N>>,
    others: &[Record<N>],
    pair: &mut impl FnMut(Field<N>, &Field<N>) -> Option<Field<M>>,
) -> Option<Vec<Record<M>>> {
    let mut of_record = |(record, other): (Record<N>, &Record<N>)| {
        if record.fields.len() != other.fields.len() {
            return None;
        }
        let fields = record.fields.into_iter().zip(&other.fields).map(|((key, field), (other_key, other))| {
            let field = match (field, other) {
                (Field::Records(records), Field::Records(others)) => Field::Records(paired(records, others, pair)?),
                (field, other) => pair(field, other)?,
            };
            (key == *other_key).then_some((key, field))
        });
        let fields = fields.collect::<Option<_>>()?;
        Some(Record { fields, status: record.status, why: record.why, verdict: record.verdict })
    };
    (records.len() == others.len()).then(|| records.into_iter().zip(others).map(&mut of_record).collect())?
}

/// Where surfaces touch or overlap, in short decimals.
pub(crate) fn point<N>(radius: f64, gap: f64) -> Option<Record<N>> {
    // Six digits, and none of them a zero at the end.
    let short = |x: f64| {
        let rounded = format!("{x:.5e}").parse::<f64>().ok()?;
        if rounded == 0.0 { "0".to_owned() } else { format!("{rounded:e}") }.parse::<Literal>().ok()
    };
    Some(Record::new().with("r", Field::Given(short(radius)?)).with("gap", Field::Given(short(gap)?)))
}

/// The numbers of records, in their order.
pub(crate) fn numbers<N>(records: &[Record<N>]) -> Vec<&N> {
    fn collect<'a, N>(records: &'a [Record<N>], found: &mut Vec<&'a N>) {
        for (_, field) in records.iter().flat_map(|record| &record.fields) {
            match field {
                Field::Number(number) => found.push(number),
                Field::Records(records) => collect(records, found),
                _ => {}
            }
        }
    }
    let mut found = Vec::new();
    collect(records, &mut found);
    found
}
