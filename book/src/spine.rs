//! The pages that are read first, one after the other, and figures that move where the explorer stands beside the book.

use maud::{Markup, html};

use crate::error::{Error, Result};

/// The pages of the spine: the name of the page and of its text, `book/text/spine-NAME.md`.
pub(crate) const SPINE: [&str; 8] =
    ["ball", "springs", "one-curve", "two-curves", "touching", "one-half", "controlled", "losses"];

/// A figure: its name, which is that of its still picture below `book/assets/live`, the state of the explorer that it shows, the
/// picture that is shown of it, and what it shows.
pub(crate) struct Live {
    pub(crate) name: &'static str,
    pub(crate) state: &'static str,
    pub(crate) only: &'static str,
    pub(crate) caption: &'static str,
}

const fn live(name: &'static str, state: &'static str, only: &'static str, caption: &'static str) -> Live {
    Live { name, state, only, caption }
}

/// All of them.
pub(crate) const FIGURES: [Live; 17] = [
    live("ball", "v=0.25", "body", "A ball on a soft surface, held at a depth. Pull it up until it lets go."),
    live(
        "springs",
        "view=springs&v=0.25",
        "body",
        "The ball as the method sees it: a rigid profile on springs. The outer ones are stretched by g − d, at most by Δl.",
    ),
    live(
        "one-curve",
        "v=0",
        "balance",
        "What adhesion can hold, Δl, grows with the root of the contact radius; what elasticity asks for is g − d.",
    ),
    live(
        "two-curves",
        "v=-0.3",
        "balance",
        "Where the curves meet, the contact rests. Take hold of its edge, and let it go.",
    ),
    live("touching", "v=-0.4", "balance", "Pulled, the curves part. Where they only touch, at P, the contact breaks."),
    live(
        "one-half",
        "n=0.8&axis=sqrt&v=0",
        "balance",
        "At n = 0.8 the contact comes off; below n = 1/2 it would spread.",
    ),
    live(
        "controlled",
        "control=D&k=0.891&n=0.65&rho=1.82&axis=sqrt&graph=fold&v=-0.02&a=0",
        "force",
        "On a machine of finite stiffness: the position over the contact radius, with three folds.",
    ),
    live(
        "losses",
        "v=0.25",
        "force",
        "Force over depth. Press and pull: the hatched areas are the energy lost in each jump.",
    ),
    live(
        "power-laws",
        "n=0.25&axis=sqrt&v=0.12&a=0.0016",
        "balance",
        "A sharp tip, n = 1/4. Pressed far enough, it comes into contact everywhere.",
    ),
    live("instability", "v=-0.45", "force", "Close to the instability of a ball that is held at a depth."),
    live("threshold", "n=0.51&axis=sqrt&v=0", "balance", "Just above n = 1/2 the two curves are nearly one."),
    live(
        "machine",
        "control=D&k=0.2&v=0.5&unit=afm",
        "force",
        "A tip of 20 nm on a cantilever of 1 N/m: the base is moved, the tip jumps in and off.",
    ),
    live(
        "wavy",
        "shape=wavy&v=0",
        "balance",
        "Figure 4 of the paper: pulled off, the contact jumps from crest to crest.",
    ),
    live(
        "short-waves",
        "shape=wavy&A=0.0273&L=0.35&v=0.2",
        "force",
        "Shorter waves: more jumps, and each costs energy.",
    ),
    live(
        "wave",
        "medium=wave&control=F&alpha=0.4&v=0.15",
        "balance",
        "Johnson's wave under a mean pressure. Press until it snaps into complete contact.",
    ),
    live(
        "two-works",
        "w1=0.25&v=0.1",
        "force",
        "Two works of adhesion: on the way in the smaller one, on the way out the larger one, and in between the edge is pinned.",
    ),
    live(
        "graded",
        "medium=graded&grade=0.5&v=0.25",
        "balance",
        "A ball on a half-space whose modulus grows with the root of the depth.",
    ),
];

/// Which figure stands on the page of which entry.
const PLACES: [(&str, &str); 17] = [
    ("1.1", "springs"),
    ("1.4", "springs"),
    ("1.7", "two-curves"),
    ("1.8", "two-curves"),
    ("1.9", "two-curves"),
    ("1.10", "touching"),
    ("1.11", "power-laws"),
    ("1.15", "instability"),
    ("1.19", "threshold"),
    ("machine-folds", "controlled"),
    ("critical-machine", "machine"),
    ("wavy", "wavy"),
    ("wave", "wave"),
    ("hysteresis", "two-works"),
    ("graded", "graded"),
    ("work-pull-off", "losses"),
    ("work-jump-in", "losses"),
];

/// The figure of an entry, if it has one.
pub(crate) fn of_entry(entry: &str) -> Result<Option<Markup>> {
    PLACES.iter().find(|(of, _)| *of == entry).map(|(_, name)| figure(name)).transpose()
}

/// A still picture, which becomes a frame of the explorer where that stands beside the book.
pub(crate) fn figure(name: &str) -> Result<Markup> {
    let found = FIGURES.iter().find(|figure| figure.name == name);
    let figure = found.ok_or_else(|| Error::page(name, "there is no such figure"))?;
    Ok(html! {
        figure.live data-state=(figure.state) data-only=(figure.only) {
            img src={ "live/" (figure.name) ".svg" } alt=(figure.caption) loading="lazy";
            figcaption { (figure.caption) }
        }
    })
}
