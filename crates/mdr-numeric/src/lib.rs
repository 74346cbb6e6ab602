//! The independent numerical route.
