//! Quadrature and root finding over any [`Real`](crate::number::Real).
