//! The closed forms as a user calls them.
//! One program, which is compiled and linked once; `cargo test -p mdr-analytic NAME::` runs the tests of a file.

mod certified;
mod common;
mod curve;
mod double_accuracy;
#[path = "double_grid/main.rs"]
mod double_grid;
mod double_outcomes;
#[path = "inverse/main.rs"]
mod inverse;
mod kappa;
#[cfg(feature = "mp")]
#[path = "media/main.rs"]
mod media;
#[path = "power_law/main.rs"]
mod power_law;
mod profiles;
mod ranges;
mod struve;
