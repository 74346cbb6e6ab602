//! End to end tests of the workspace.
//!
//! * `published.rs`: values from the literature, each with its source.
//! * `command_line/`: the program `mdr` as a user meets it. It is a test of the package `mdr-cli`, which builds the program.
