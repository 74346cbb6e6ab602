//! The closed forms under test, reached through one type so that a test can put a fault into any of them.

/// The closed forms of mdr-analytic, as they are or with one deliberate fault.
#[derive(Clone, Debug, Default)]
pub struct Theory {}
