//! An answer of another program.

use crate::decimal::{Decimal, DecimalError};
use crate::json::{Json, quoted, read};
use crate::record::Status;

/// What a program says to one question.
///
/// ```
/// use mdr_reference::Answer;
/// let measured = Answer::from(-4.71).with_error(0.01);
/// let none: Answer = mdr_reference::Status::NoEquilibrium.into();
/// assert_ne!(measured, none);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The number, if it gives one.
    pub(crate) value: Option<Number>,
    /// The absolute error it claims not to exceed.
    pub(crate) error: Option<Decimal>,
    /// How it marks its answer; a number without a mark is `ok`.
    pub(crate) status: Option<Status>,
}

/// A number as other programs have them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Number {
    Finite(Decimal),
    /// NaN or an infinity.
    NotFinite,
}

impl From<Decimal> for Answer {
    fn from(value: Decimal) -> Self {
        Answer { value: Some(Number::Finite(value)), error: None, status: None }
    }
}

/// The exact value of a double.
impl From<f64> for Answer {
    fn from(value: f64) -> Self {
        let number = if value.is_finite() { Number::Finite(Decimal::from_double(value)) } else { Number::NotFinite };
        Answer { value: Some(number), error: None, status: None }
    }
}

/// No number, for a reason.
impl From<Status> for Answer {
    fn from(status: Status) -> Self {
        Answer { value: None, error: None, status: Some(status) }
    }
}

impl Answer {
    /// The same with the absolute error that the program claims; a claim that is not finite claims nothing.
    pub fn with_error(self, error: f64) -> Self {
        Answer { error: error.is_finite().then(|| Decimal::from_double(error.abs())), ..self }
    }

    /// The same, marked: such as the 0 that is left of a number below the range of doubles.
    pub fn with_status(self, status: Status) -> Self {
        Answer { status: Some(status), ..self }
    }

    /// A line for `mdr judge`: the answer to the question of this identifier.
    ///
    /// ```
    /// use mdr_reference::Answer;
    /// let line = Answer::from(-4.71).with_error(0.01).to_json("critical/jkr-unit/force/force");
    /// assert!(line.starts_with("{\"id\":\"critical/jkr-unit/force/force\",\"value\":\"-4.7"));
    /// let (id, answer) = Answer::from_json(&line)?;
    /// assert_eq!((id.as_str(), answer), ("critical/jkr-unit/force/force", Answer::from(-4.71).with_error(0.01)));
    /// # Ok::<(), String>(())
    /// ```
    pub fn to_json(&self, id: &str) -> String {
        let value = self.value.as_ref().map(|value| match value {
            Number::Finite(value) => value.to_string(),
            Number::NotFinite => "nan".to_owned(),
        });
        let error = self.error.as_ref().map(Decimal::to_string);
        let status = self.status.map(|status| status.name().to_owned());
        let fields = [("id", Some(id.to_owned())), ("value", value), ("error", error), ("status", status)];
        let fields = fields.into_iter().filter_map(|(key, text)| Some(format!("\"{key}\":{}", quoted(&text?))));
        format!("{{{}}}", fields.collect::<Vec<_>>().join(","))
    }

    /// The identifier and the answer on a line `{"id":…, "value":…, "error":…, "status":…}`, numbers as JSON numbers or as
    /// texts, decimal or hexadecimal.
    ///
    /// # Errors
    /// What is wrong with the line.
    pub fn from_json(line: &str) -> Result<(String, Answer), String> {
        let json = read(line)?;
        if !matches!(json, Json::Object(_)) {
            return Err("expected an object {\"id\":…, \"value\":…}".to_owned());
        }
        let text = |key: &str| match json.get(key) {
            None | Some(Json::Null) => Ok(None),
            Some(value) => value.as_text().map(Some).ok_or_else(|| format!("{key} must be a number or a text")),
        };
        let id = text("id")?.ok_or("there is no id")?.to_owned();
        let value = match text("value")?.map(str::parse) {
            None => None,
            Some(Ok(value)) => Some(Number::Finite(value)),
            Some(Err(DecimalError::NotFinite)) => Some(Number::NotFinite),
            Some(Err(error)) => return Err(format!("value: {error}")),
        };
        let error = match text("error")?.map(str::parse::<Decimal>) {
            None => None,
            Some(Err(DecimalError::NotFinite)) => {
                return Err("error: must be finite; leave it out to claim nothing".to_owned());
            }
            Some(Ok(error)) if error >= Decimal::default() => Some(error),
            Some(Ok(_)) => return Err("error: must not be negative".to_owned()),
            Some(Err(error)) => return Err(format!("error: {error}")),
        };
        let status = text("status")?.map(str::parse).transpose()?;
        if value.is_none() && status.is_none() {
            return Err("there is neither a value nor a status".to_owned());
        }
        Ok((id, Answer { value, error, status }))
    }
}
