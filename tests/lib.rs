//! End to end tests of the workspace.
//!
//! * `additions.rs`: what an addition costs, in source files.
//! * `names.rs`: names of public types are unique.
//! * `readers.rs`: the fuzz targets over their corpus.
//! * `published.rs`: values from the literature, each with its source.
//! * `command_line/`: the program `mdr` as a user meets it. It is a test of the package `mdr-cli`, which builds the program.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
