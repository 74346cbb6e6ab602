//! Numbers, calculus and contact as a user calls them.
//! One program, which is compiled and linked once; `cargo test -p mdr-core NAME::` runs the tests of a file.

mod calculus_gauss_jacobi;
mod calculus_isolate;
mod calculus_quadrature;
mod calculus_roots;
mod contact_breaks;
mod contact_counted;
mod contact_expression;
mod contact_lowest;
mod number_algebra;
mod number_analytic;
mod number_certify;
mod number_containment;
mod number_counted;
mod number_double;
mod number_dual;
mod number_dual_f64;
mod number_edges;
mod number_interval;
mod number_literal;
mod number_support;
mod number_wide;
mod text;
mod units;
