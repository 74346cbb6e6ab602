//! The rows of docs/conformance.md, which list function, checks and tests of an entry.

use mdr_symbolic::derivations::Entry;

/// A row of one of its tables, in Markdown.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    about: String,
    verdict: String,
    pub(crate) what: String,
    pub(crate) function: String,
    pub(crate) checks: String,
    pub(crate) tests: String,
}

impl Row {
    /// Whether the row names the entry, by the number of its equation or by its id.
    pub(crate) fn is_about(&self, entry: &Entry) -> bool {
        let printed = self.about.contains("printed");
        (!printed && self.about.contains(&format!("({})", entry.id)))
            || self.verdict.contains(&format!("`{}`", entry.id))
    }
}

/// All rows.
pub(crate) fn rows(document: &str) -> Vec<Row> {
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let rows = document.lines().filter(|line| line.starts_with('|')).map(cells);
    rows.filter_map(|mut cells| {
        // Rows of the paper begin with an equation; others with what they are about.
        let about = if cells[0].starts_with("(1.") { cells.remove(0) } else { String::new() };
        let mut cells = cells.into_iter();
        let [what, verdict, function, checks, tests] = std::array::from_fn(|_| cells.next());
        Some(Row { about, what: what?, verdict: verdict?, function: function?, checks: checks?, tests: tests? })
    })
    .collect()
}
