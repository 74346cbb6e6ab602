//! Small tables to copy into the tests of another program.

mod jkr_sphere;
mod write;

pub use write::TableFormat;

/// A table of a few dozen rows, in doubles, made from the records: a file to copy, with no library to link.
///
/// ```
/// use mdr_reference::{Table, TableFormat};
/// let table = Table::named("jkr-sphere").ok_or("no such table")?;
/// let header = table.write(TableFormat::C);
/// assert!(header.contains("#ifndef MDR_JKR_SPHERE_H"));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its name: small letters and hyphens.
    pub name: &'static str,
    /// The content of the table, on one line.
    pub title: &'static str,
    /// The columns.
    columns: &'static [Column],
    /// The rows, a cell a column.
    rows: Vec<Vec<Cell>>,
}

/// A column: its name, its unit (empty for none), and whether it holds numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Column {
    name: &'static str,
    unit: &'static str,
    is_number: bool,
}

#[derive(Clone, Debug, PartialEq)]
enum Cell {
    Text(String),
    /// A finite double; `None` if there is no number.
    Number(Option<f64>),
}

impl Table {
    /// The names of all tables.
    pub const NAMES: [&'static str; 1] = ["jkr-sphere"];

    /// The table of this name.
    pub fn named(name: &str) -> Option<Table> {
        (name == Table::NAMES[0]).then(jkr_sphere::table)
    }

    /// The names of the columns.
    pub fn header(&self) -> Vec<&'static str> {
        self.columns.iter().map(|column| column.name).collect()
    }

    /// The rows as texts, numbers as the shortest decimal of their double, empty where there is no number.
    pub fn rows(&self) -> impl Iterator<Item = Vec<String>> {
        self.rows.iter().map(|row| row.iter().map(Cell::text).collect())
    }
}

impl Cell {
    fn text(&self) -> String {
        match self {
            Cell::Text(text) => text.clone(),
            Cell::Number(number) => number.map_or(String::new(), shortest),
        }
    }
}

/// The shortest decimal of a double, as every language reads it.
fn shortest(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-4..1e16).contains(&size) { format!("{number:?}") } else { format!("{number:e}") }
}
