//! The program `mdr`.

fn main() {}
