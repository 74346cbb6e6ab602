//! An answer of another program.

use std::fmt;

use crate::decimal::{Decimal, DecimalError};
use crate::json::{Json, object, read_tolerant, text};
use crate::number::Number;
use crate::record::Status;
use crate::text::excerpt;

/// A claimed error that is negative or not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClaimError(f64);

impl fmt::Display for ClaimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the claimed error must be finite and not negative, got {}; leave it out to claim nothing", self.0)
    }
}

impl std::error::Error for ClaimError {}

/// The answer of a program to one question.
///
/// ```
/// use mdr_reference::Answer;
/// let measured = Answer::from(-4.71).with_error(0.01)?;
/// let none: Answer = mdr_reference::Status::NoEquilibrium.into();
/// assert_ne!(measured, none);
/// # Ok::<(), mdr_reference::ClaimError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The number, if it gives one.
    pub(crate) value: Option<Number>,
    /// The claimed bound of the absolute error.
    pub(crate) error: Option<Decimal>,
    /// The status of the answer; a number without a status is `ok`.
    pub(crate) status: Option<Status>,
}

impl From<Decimal> for Answer {
    fn from(value: Decimal) -> Self {
        Answer { value: Some(Number::Finite(value)), error: None, status: None }
    }
}

/// The exact value of a double, an infinity, or NaN.
impl From<f64> for Answer {
    fn from(value: f64) -> Self {
        Answer { value: Some(value.into()), error: None, status: None }
    }
}

/// No number, for a reason.
impl From<Status> for Answer {
    fn from(status: Status) -> Self {
        Answer { value: None, error: None, status: Some(status) }
    }
}

impl Answer {
    /// Adds a claimed bound of the absolute error.
    ///
    /// # Errors
    /// [`ClaimError`] if it is negative or not finite.
    pub fn with_error(self, error: f64) -> Result<Self, ClaimError> {
        match Decimal::from_double(error) {
            Some(claim) if error >= 0.0 => Ok(Answer { error: Some(claim), ..self }),
            _ => Err(ClaimError(error)),
        }
    }

    /// Adds a status, for example for the 0 that results from a number below the range of doubles.
    pub fn with_status(self, status: Status) -> Self {
        Answer { status: Some(status), ..self }
    }

    /// A line for `mdr judge`: the answer to the question with this identifier.
    ///
    /// ```
    /// use mdr_reference::Answer;
    /// let line = Answer::from(-4.71).with_error(0.01)?.to_json("critical/jkr-unit/force/force");
    /// assert!(line.starts_with("{\"id\":\"critical/jkr-unit/force/force\",\"value\":\"-4.7"));
    /// let (id, answer) = Answer::from_json(&line)?;
    /// assert_eq!((id.as_str(), answer), ("critical/jkr-unit/force/force", Answer::from(-4.71).with_error(0.01)?));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_json(&self, id: &str) -> String {
        let value = self.value.as_ref().map(Number::to_string);
        let error = self.error.as_ref().map(Decimal::to_string);
        let fields = [
            ("id", Some(id)),
            ("value", value.as_deref()),
            ("error", error.as_deref()),
            ("status", self.status.map(Status::name)),
        ];
        object(fields.into_iter().filter_map(|(key, field)| Some((key, text(field?))))).to_string()
    }

    /// The identifier and the answer on a line `{"id":…, "value":…, "error":…, "status":…}`, numbers as JSON numbers or as
    /// texts, decimal or hexadecimal; also as C prints them, `-nan` or `0x1.8p-3` without quotation marks. No key may be given twice.
    ///
    /// # Errors
    /// A message about the fault of the line.
    pub fn from_json(line: &str) -> Result<(String, Answer), String> {
        let json = read_tolerant(line)?;
        let Json::Object(entries) = &json else {
            return Err("expected an object {\"id\":…, \"value\":…}".to_owned());
        };
        let mut keys: Vec<&str> = entries.iter().map(|(key, _)| key.as_ref()).collect();
        keys.sort_unstable();
        if let Some(twice) = keys.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(format!("{} is given more than once", excerpt(twice[0])));
        }
        let text = |key: &str| match json.get(key) {
            None | Some(Json::Null) => Ok(None),
            Some(value) => value.as_text().map(Some).ok_or_else(|| format!("{key} must be a number or a text")),
        };
        let id = text("id")?.ok_or("there is no id")?.to_owned();
        let answer = Answer::of_texts(text("value")?, text("error")?, text("status")?)?;
        if answer.value.is_none() && answer.status.is_none() {
            return Err(match json.get("value") {
                Some(_) => "the value is null, as some programs write NaN, and there is no status".to_owned(),
                None => "there is neither a value nor a status".to_owned(),
            });
        }
        Ok((id, answer))
    }

    /// The answer of these texts.
    ///
    /// # Errors
    /// A message about the text that is no number, no bound, or no status.
    pub(crate) fn of_texts(value: Option<&str>, error: Option<&str>, status: Option<&str>) -> Result<Answer, String> {
        let refused =
            |key: &str, error: &dyn fmt::Display, text: &str| format!("{key}: {error}, got {}", excerpt(text));
        let value = value.map(|text| text.parse().map_err(|error: DecimalError| refused("value", &error, text)));
        let error = error.map(|text| match text.parse::<Decimal>() {
            Ok(error) if error.is_negative() => Err(refused("error", &"must not be negative", text)),
            Ok(error) => Ok(error),
            Err(DecimalError::NotFinite) => {
                Err(refused("error", &"must be finite; leave it out to claim nothing", text))
            }
            Err(error) => Err(refused("error", &error, text)),
        });
        let (value, error) = (value.transpose()?, error.transpose()?);
        Ok(Answer { value, error, status: status.map(str::parse).transpose()? })
    }
}
