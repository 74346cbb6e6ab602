//! Figures 1 to 4 of the theory, and one of the wave that its introduction names, computed: each the diagram {Δl, g − d} of a scene.

mod convex;
mod johnson;
mod sharp;
mod study;
mod wavy;

use mdr::Result;

use crate::Picture;

/// A figure: the stem of its files, and how it is computed.
pub type Figure = (&'static str, fn() -> Result<Picture>);

/// All figures.
///
/// 1a and 1b: equilibrium of a paraboloid, and the last one; 2: a stable and an unstable equilibrium; 3: the sharp tip r^(1/4)
/// that jumps to complete contact; 4: a wavy paraboloid that jumps from crest to crest; 5: Johnson's wave. Computed in f64.
pub const FIGURES: [Figure; 6] = [
    ("figure-1a", convex::figure_1a),
    ("figure-1b", convex::figure_1b),
    ("figure-2", convex::figure_2),
    ("figure-3", sharp::figure_3),
    ("figure-4", wavy::figure_4),
    ("figure-5", johnson::figure_5),
];
