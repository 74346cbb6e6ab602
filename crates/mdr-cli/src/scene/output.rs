//! The table `[output]`: what is wanted, where, and in which arithmetic.

use mdr_core::number::Literal;

use super::Held;
use super::reader::{Place, Section, Value};
use crate::error::Result;
use crate::flags::{Arithmetic, DEFAULT_DIGITS, MAX_DIGITS};

/// One output of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Want {
    Transform,
    Equilibria,
    Folds,
    Path,
    Curve,
    Pressure,
    Gap,
    Displacement,
    Energy,
}

impl Want {
    const ALL: [(&'static str, Want); 9] = [
        ("transform", Want::Transform),
        ("equilibria", Want::Equilibria),
        ("folds", Want::Folds),
        ("path", Want::Path),
        ("curve", Want::Curve),
        ("pressure", Want::Pressure),
        ("gap", Want::Gap),
        ("displacement", Want::Displacement),
        ("energy", Want::Energy),
    ];

    /// The key of the output in a scene and in an answer.
    pub(crate) fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// Whether it is computed from the profile alone.
    pub(crate) fn is_of_profile(self) -> bool {
        self == Want::Transform
    }

    /// Whether it describes states, at the values of `equilibria` or at the start of the path.
    pub(crate) fn is_of_states(self) -> bool {
        matches!(self, Want::Pressure | Want::Gap | Want::Displacement | Want::Energy)
    }
}

/// Contact radii between which all folds are to be proved.
#[derive(Debug)]
pub(crate) struct Range {
    pub(crate) ends: [Literal; 2],
    /// For complaints about it.
    pub(crate) place: Place,
}

/// What is wanted, in which arithmetic.
#[derive(Debug)]
pub(crate) struct Wanted {
    /// Each once, in the order of the scene.
    pub(crate) want: Vec<Want>,
    pub(crate) arithmetic: Arithmetic,
    /// The arithmetic that the scene itself names.
    pub(super) stated: Option<Arithmetic>,
    /// Radii x for `transform`.
    pub(crate) transform: Vec<Literal>,
    /// Values of the controlled quantity for `equilibria` and for what describes states.
    pub(crate) values: Vec<Literal>,
    /// Contact radii for `curve`; empty when the program shall choose.
    pub(crate) curve: Vec<Literal>,
    /// Radii r for `pressure`; empty when the program shall choose.
    pub(crate) pressure: Vec<Literal>,
    /// Radii r for `gap`; empty when the program shall choose.
    pub(crate) gap: Vec<Literal>,
    /// Radii r for `displacement`; empty when the program shall choose.
    pub(crate) displacement: Vec<Literal>,
    /// Where all folds are to be proved; none when the program shall choose.
    pub(crate) range: Option<Range>,
}

impl Wanted {
    pub(super) fn read(section: &Section<'_>, held: &Held, has_material: bool) -> Result<Wanted> {
        let list = section.required("want")?;
        let want = wants(&list)?;
        let stated = arithmetic(section)?;
        let wanted = Wanted {
            arithmetic: stated.unwrap_or(Arithmetic::Certified { digits: DEFAULT_DIGITS }),
            stated,
            transform: at(section, "transform", Value::positive)?,
            values: at(section, "equilibria", Value::number)?,
            curve: at(section, "curve", Value::positive)?,
            pressure: at(section, "pressure", Value::not_negative)?,
            gap: at(section, "gap", Value::positive)?,
            displacement: at(section, "displacement", Value::positive)?,
            range: range(section)?,
            want,
        };
        wanted.check(&list, held, has_material)?;
        section.finish()?;
        Ok(wanted)
    }

    /// Whether the scene says all that its outputs need.
    fn check(&self, list: &Value<'_>, held: &Held, has_material: bool) -> Result<()> {
        for want in &self.want {
            let missing = match want {
                want if !want.is_of_profile() && !has_material => "a material: [material] e_star, work_of_adhesion",
                Want::Transform if self.transform.is_empty() => "radii: [output.transform] at = [\"…\"]",
                Want::Equilibria if self.values.is_empty() => "values: [output.equilibria] at = [\"…\"]",
                Want::Path if held.path.len() < 2 => "at least two way points: [control] path = [\"…\", \"…\"]",
                want if want.is_of_states() && self.values.is_empty() && held.path.is_empty() => {
                    "states: [output.equilibria] at = [\"…\"], or the start of a path"
                }
                _ => continue,
            };
            return Err(list.refuse(format!("`{}` needs {missing}", want.name())));
        }
        Ok(())
    }

    /// Whether one of the outputs is such.
    pub(crate) fn wants(&self, which: impl Fn(Want) -> bool) -> bool {
        self.want.iter().any(|want| which(*want))
    }
}

fn wants(list: &Value<'_>) -> Result<Vec<Want>> {
    let mut want = Vec::new();
    for value in list.list()? {
        let output = value.choice("output", &Want::ALL)?;
        if want.contains(&output) {
            return Err(value.refuse(format!("`{}` is wanted twice", output.name())));
        }
        want.push(output);
    }
    if want.is_empty() {
        let all: Vec<&str> = Want::ALL.iter().map(|(name, _)| *name).collect();
        return Err(list.refuse(format!("nothing is wanted; there are `{}`", all.join("`, `"))));
    }
    Ok(want)
}

fn arithmetic(section: &Section<'_>) -> Result<Option<Arithmetic>> {
    match (section.optional("digits"), section.optional("arithmetic")) {
        (Some(_), Some(arithmetic)) => Err(arithmetic.refuse("cannot be given together with `digits`")),
        (Some(digits), None) => Ok(Some(Arithmetic::Certified { digits: digits.whole(1, MAX_DIGITS)? })),
        (None, Some(arithmetic)) => {
            let certified = Arithmetic::Certified { digits: DEFAULT_DIGITS };
            arithmetic.choice("arithmetic", &[("f64", Arithmetic::Double), ("certified", certified)]).map(Some)
        }
        (None, None) => Ok(None),
    }
}

/// The list `at` of a sub-table of `[output]`.
fn at<'a>(section: &Section<'a>, key: &'static str, read: fn(&Value<'a>) -> Result<Literal>) -> Result<Vec<Literal>> {
    let Some(value) = section.optional(key) else {
        return Ok(Vec::new());
    };
    let inner = value.section()?;
    let list = inner.required("at")?.numbers(read);
    inner.finish()?;
    list
}

/// The key `range` of [output.folds].
fn range(section: &Section<'_>) -> Result<Option<Range>> {
    let Some(value) = section.optional("folds") else {
        return Ok(None);
    };
    let inner = value.section()?;
    let list = inner.required("range")?;
    let ends = list.numbers(Value::positive)?;
    inner.finish()?;
    let [lower, upper] = <[Literal; 2]>::try_from(ends)
        .map_err(|ends| list.refuse(format!("expected two contact radii, got {}", ends.len())))?;
    if lower.to_rational() >= upper.to_rational() {
        return Err(list.refuse(format!("the range must ascend, got {lower} to {upper}")));
    }
    Ok(Some(Range { ends: [lower, upper], place: list.place() }))
}
