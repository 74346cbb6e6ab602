//! Records: structures of numbers in one arithmetic, declared once, from which all views of an answer are made.
//!
//! A record holds enclosures while digits are being decided, and [`Number`]s in an answer. Every view, JSON, tables, CSV and
//! other languages, walks its [`Row`].

use mdr_core::contact::{Edge, FoldKind, Stability, Status};
use mdr_core::number::Literal;
use mdr_numeric::path::EventKind;

use super::column::Column;
use super::types::{Admission, Overlap};
use super::value::{Number, Value};

/// The content below one key of a record.
#[derive(Debug)]
pub enum Cell<'a, N = Number> {
    /// A number, or why there is none.
    Value(&'a Value<N>),
    /// The reason why the stability of a state is not decided.
    UnknownStability(&'a Value<Stability>),
    /// An input, as it was written.
    Literal(&'a Literal),
    /// Yes or no.
    Flag(bool),
    /// A number of things.
    Count(usize),
    /// A word: the kind of a fold or of an event.
    Word(&'static str),
    /// Nothing, and nothing is expected.
    Absent,
    /// Records below this one.
    Rows(Vec<Row<'a, N>>),
}

impl<N> Cell<'_, N> {
    fn status(&self) -> Status {
        match self {
            Cell::Value(value) => value.status(),
            Cell::UnknownStability(value) => value.status(),
            _ => Status::Ok,
        }
    }

    fn why(&self) -> Option<&str> {
        match self {
            Cell::Value(value) => value.why(),
            Cell::UnknownStability(value) => value.why(),
            _ => None,
        }
    }
}

/// A record as a list of named cells in the order in which they are printed.
#[derive(Debug)]
pub struct Row<'a, N = Number> {
    /// The cells with their keys.
    pub cells: Vec<(&'static str, Cell<'a, N>)>,
    /// Whether the state of the record is admissible: `None` if the record has no state, `Some(None)` if that is not decided.
    pub admissible: Option<Option<bool>>,
    /// A status that its numbers do not show, and its reason.
    pub(crate) mark: Option<Status>,
    pub(crate) why: Option<&'a str>,
    doubt: Option<&'static str>,
}

impl<'a, N> Row<'a, N> {
    pub(crate) fn new() -> Self {
        Row { cells: Vec::new(), admissible: None, mark: None, why: None, doubt: None }
    }

    pub(crate) fn with(mut self, key: &'static str, part: &'a impl Part<N>) -> Self {
        part.put(key, &mut self);
        self
    }

    /// The status of the record itself, else that of its first number without a value, else `ok`.
    pub fn status(&self) -> Status {
        let of_cells = || self.cells.iter().map(|(_, cell)| cell.status()).find(|status| *status != Status::Ok);
        self.mark.or_else(of_cells).unwrap_or(Status::Ok)
    }

    /// The reason, in words, if the status is not `ok`.
    pub fn why(&self) -> Option<String> {
        let of_cell = || self.cells.iter().find_map(|(_, cell)| cell.why());
        let doubt = || self.doubt.map(|why| format!("whether it is admissible is not known: {why}"));
        self.why.or_else(of_cell).map(str::to_owned).or_else(doubt)
    }

    /// Whether a number in it is undecided, or the record as a whole.
    #[cfg(feature = "mp")]
    pub(crate) fn is_open(&self) -> bool {
        let open = |(_, cell): &(_, Cell<'_, N>)| match cell {
            Cell::Rows(rows) => rows.iter().any(Row::is_open),
            cell => cell.status() == Status::Undecided,
        };
        self.why.is_some() && self.mark == Some(Status::Undecided) || self.cells.iter().any(open)
    }
}

/// Numbers in a fixed structure: a record, or a list of records.
pub(crate) trait Numbers<N>: Sized {
    /// This structure with numbers of another arithmetic.
    type With<M>: Numbers<M>;

    /// The key of a list of such records at a value.
    const KEY: &'static str = "states";

    /// Every number changed by `f`, in the order of the rows.
    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M>;

    /// A row for each record.
    fn rows(&self) -> Vec<Row<'_, N>>;

    /// The columns that the rows may have.
    fn columns() -> Vec<Column>;

    /// Every result changed by `f`, which may find that it is none.
    fn resolve<M>(self, mut f: impl FnMut(N) -> Value<M>) -> Self::With<M> {
        self.map_values(&mut |value| value.and_then(&mut f))
    }

    /// Every result changed by `f`.
    fn convert<M>(self, mut f: impl FnMut(N) -> M) -> Self::With<M> {
        self.resolve(|number| Value::Known(f(number)))
    }
}

impl<N, T: Numbers<N>> Numbers<N> for Vec<T> {
    type With<M> = Vec<T::With<M>>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        self.into_iter().map(|record| record.map_values(f)).collect()
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        self.iter().flat_map(Numbers::rows).collect()
    }

    fn columns() -> Vec<Column> {
        T::columns()
    }
}

impl<N, T: Numbers<N>> Numbers<N> for Option<T> {
    type With<M> = Option<T::With<M>>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        self.map(|record| record.map_values(f))
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        self.iter().flat_map(Numbers::rows).collect()
    }

    fn columns() -> Vec<Column> {
        T::columns()
    }
}

/// All cells of rows and of those below them, in their order, with their keys.
#[cfg(feature = "mp")]
pub(crate) fn cells<'r, 'a, N>(rows: &'r [Row<'a, N>]) -> Vec<(&'static str, &'r Cell<'a, N>)> {
    let mut found = Vec::new();
    for (key, cell) in rows.iter().flat_map(|row| &row.cells) {
        found.push((*key, cell));
        if let Cell::Rows(rows) = cell {
            found.extend(cells(rows));
        }
    }
    found
}

/// A field of a record.
pub(crate) trait Part<N>: Sized {
    type With<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M>;

    /// Adds its cells to a row.
    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>);

    /// Adds to a row the cells of a field that a record lacks: nothing, unless the field is a number.
    fn put_absent(_key: &'static str, _row: &mut Row<'_, N>) {}

    /// The columns of its cells, of which `declared` is that of a field with one cell.
    fn columns(declared: Column) -> Vec<Column> {
        vec![declared]
    }
}

impl<N> Part<N> for Value<N> {
    type With<M> = Value<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Value<M> {
        f(self)
    }

    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>) {
        row.cells.push((key, Cell::Value(self)));
    }

    fn put_absent(key: &'static str, row: &mut Row<'_, N>) {
        row.cells.push((key, Cell::Absent));
    }
}

/// A field that a record may lack.
impl<N, T: Part<N>> Part<N> for Option<T> {
    type With<M> = Option<T::With<M>>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        self.map(|part| part.map_part(f))
    }

    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>) {
        match self {
            Some(part) => part.put(key, row),
            None => T::put_absent(key, row),
        }
    }

    fn columns(declared: Column) -> Vec<Column> {
        T::columns(declared)
    }
}

/// Fields without a number of the arithmetic, each with the cells that it adds to a row.
macro_rules! constant_parts {
    ($($(#[$doc:meta])* $type:ty $(as $column:literal)?: |$part:ident, $key:ident, $row:ident| $put:expr;)*) => {$(
        $(#[$doc])*
        impl<N> $crate::answer::record::Part<N> for $type {
            type With<M> = Self;

            fn map_part<M>(self, _: &mut dyn FnMut($crate::answer::Value<N>) -> $crate::answer::Value<M>) -> Self {
                self
            }

            fn put<'a>(&'a self, $key: &'static str, $row: &mut $crate::answer::Row<'a, N>) {
                let $part = self;
                $put;
            }

            $(fn columns(_: $crate::answer::Column) -> Vec<$crate::answer::Column> {
                vec![$crate::answer::Column::new($column)]
            })?
        }
    )*};
}

pub(crate) use constant_parts;

constant_parts! {
    /// A neutral state is a fold, which is its status.
    Stability as "stable": |stability, _key, row| {
        row.cells.push(("stable", Cell::Flag(*stability == Stability::Stable)));
        row.mark = (*stability == Stability::Neutral).then_some(Status::Fold).or(row.mark);
    };
    Literal: |literal, key, row| row.cells.push((key, Cell::Literal(literal)));
    FoldKind: |kind, key, row| row.cells.push((key, Cell::Word(kind.name())));
    Edge: |edge, key, row| row.cells.push((key, Cell::Word(edge.name())));
    EventKind: |kind, key, row| row.cells.push((key, Cell::Word(kind.name())));
    &'static str: |word, key, row| row.cells.push((key, Cell::Word(word)));
    usize: |count, key, row| row.cells.push((key, Cell::Count(*count)));
}

/// A state in which the surfaces would overlap has the place where they do, and that as its status.
impl<N> Part<N> for Admission<N> {
    type With<M> = Admission<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        match self {
            Admission::Admissible => Admission::Admissible,
            Admission::Unknown { why } => Admission::Unknown { why },
            Admission::Interpenetrating { at, why } => {
                Admission::Interpenetrating { at: at.map(|overlap| overlap.map_values(f)), why }
            }
        }
    }

    fn put<'a>(&'a self, _: &'static str, row: &mut Row<'a, N>) {
        row.admissible = Some(match self {
            Admission::Admissible => Some(true),
            Admission::Unknown { why } => {
                row.doubt = Some(why);
                None
            }
            Admission::Interpenetrating { at, why } => {
                row.cells.push(("interpenetration", Cell::Rows(at.rows())));
                (row.mark, row.why) = (Some(Status::NotAdmissible), why.as_deref().or(row.why));
                Some(false)
            }
        });
    }

    fn columns(_: Column) -> Vec<Column> {
        <Overlap<N> as Numbers<N>>::columns()
    }
}

/// Declares a record: a structure whose fields are [`Part`]s, with their names as keys, and for a column with another heading
/// or a unit `= "heading" in "unit"`.
macro_rules! record {
    ($($(#[$meta:meta])* $name:ident $(in $key:literal)? {
        $($(#[$doc:meta])* $field:ident: $type:ty $(= $title:literal in $unit:literal)?,)*
    })*) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name<N = $crate::answer::Number> {
            $($(#[$doc])* pub $field: $type,)*
        }

        /// Within another record its cells stand among those around it.
        impl<N> $crate::answer::record::Part<N> for $name<N> {
            type With<M> = $name<M>;

            fn map_part<M>(
                self,
                f: &mut dyn FnMut($crate::answer::Value<N>) -> $crate::answer::Value<M>,
            ) -> $name<M> {
                $name { $($field: $crate::answer::record::Part::map_part(self.$field, f),)* }
            }

            fn put<'a>(&'a self, _: &'static str, row: &mut $crate::answer::Row<'a, N>) {
                $($crate::answer::record::Part::put(&self.$field, stringify!($field), row);)*
            }

            fn columns(_: $crate::answer::Column) -> Vec<$crate::answer::Column> {
                <Self as $crate::answer::record::Numbers<N>>::columns()
            }
        }

        impl<N> $crate::answer::record::Numbers<N> for $name<N> {
            type With<M> = $name<M>;
            $(const KEY: &'static str = $key;)?

            fn map_values<M>(
                self,
                f: &mut dyn FnMut($crate::answer::Value<N>) -> $crate::answer::Value<M>,
            ) -> $name<M> {
                $crate::answer::record::Part::map_part(self, f)
            }

            fn rows(&self) -> Vec<$crate::answer::Row<'_, N>> {
                vec![$crate::answer::Row::new().with("", self)]
            }

            fn columns() -> Vec<$crate::answer::Column> {
                let mut columns = Vec::new();
                $(
                    let declared = $crate::answer::Column::new(stringify!($field))$(.titled($title, $unit))?;
                    columns.extend(<$type as $crate::answer::record::Part<N>>::columns(declared));
                )*
                columns
            }
        }
    )*};
}

pub(crate) use record;
