//! Closed forms against the independent route.
