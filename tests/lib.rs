//! End to end tests of the workspace; the tests themselves are in `tests/`.
