//! The figures of the paper, computed, at the entries that they show.

/// A picture in `docs/figures`.
pub(super) struct Figure {
    pub(super) name: &'static str,
    pub(super) file: &'static str,
    pub(super) caption: &'static str,
}

/// The figures of an entry.
pub(super) fn of(id: &str) -> impl Iterator<Item = Figure> {
    include_str!("../../../data/figures.tsv").lines().filter_map(move |line| {
        let [entry, name, file, caption]: [&str; 4] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        (entry == id).then_some(Figure { name, file, caption })
    })
}
