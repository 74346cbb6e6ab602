//! The numerical route as a user calls it.
//! One program, which is compiled and linked once; `cargo test -p mdr-numeric NAME::` runs the tests of a file.

mod admissible;
mod claims;
mod contact;
mod dugdale;
mod enclosed;
mod fields;
mod interruption;
mod media;
mod onsets;
mod path;
mod path_energy;
mod pinned;
mod printed;
#[cfg(feature = "mp")]
mod pull_off;
#[cfg(feature = "mp")]
mod range;
#[cfg(feature = "mp")]
mod rigorous;
mod routes;
mod scales;
mod states;
#[path = "table/main.rs"]
mod table;
mod tabulated;
mod transform;
mod vertical_edge;
