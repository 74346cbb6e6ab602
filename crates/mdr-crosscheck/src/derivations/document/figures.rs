//! The figures of the paper, computed, at the entries that they show.

/// A picture in `docs/figures`.
pub(super) struct Figure {
    entry: &'static str,
    pub(super) name: &'static str,
    pub(super) file: &'static str,
    pub(super) caption: &'static str,
}

const FIGURES: [Figure; 5] = [
    Figure {
        entry: "1.9",
        name: "Figure 1a",
        file: "figure-1a.svg",
        caption: "a paraboloid at d = 0. A contact of radius a₁ grows (1.9), one of radius a₂ shrinks (1.8); O is stable.",
    },
    Figure {
        entry: "1.10",
        name: "Figure 1b",
        file: "figure-1b.svg",
        caption: "pressing moves the equilibrium to larger radii, pulling to smaller ones, up to P, where the curves touch.",
    },
    Figure {
        entry: "1.10",
        name: "Figure 2",
        file: "figure-2.svg",
        caption: "a contact that is pulled, but not yet to the critical depth: P₁ is unstable, P₂ is stable.",
    },
    Figure {
        entry: "1.11",
        name: "Figure 3",
        file: "figure-3.svg",
        caption: "a sharp tip with n = 1/4. (a) At d = 0 the only equilibrium O is unstable. (b) Pressed in, up to the critical \
                  depth, it has a stable and an unstable one.",
    },
    Figure {
        entry: "wavy",
        name: "Figure 4",
        file: "figure-4.svg",
        caption: "a paraboloid with waves, pulled from its equilibrium at d = 0: where the curves touch, the radius jumps.",
    },
];

/// The figures of an entry.
pub(super) fn of(entry: &str) -> impl Iterator<Item = &'static Figure> {
    FIGURES.iter().filter(move |figure| figure.entry == entry)
}
