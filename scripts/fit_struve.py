#!/usr/bin/env python3
"""Chebyshev tables of K0 = H0 - Y0 and K1 = H1 - Y1 for z >= 3 (f64).

With v = 3/z in (0, 1]:  z K0(z) pi/2  and  (K1(z) - 2/pi) z^2 pi/2  are smooth and tend to 1 as v -> 0.

Usage: python3 scripts/fit_struve.py > crates/mdr-analytic/data/struve.rs (needs mpmath)
"""
from mpmath import mp, mpf, cos, pi, struveh, bessely, quad, exp, sinh, inf

mp.dps = 40
NODES = 64
TARGET = mpf(2) ** -57


def k0_scaled(v):
    """z K0 pi/2 = int_0^inf exp(-s)/sqrt(1 + (s/z)^2) ds, which is 1 at v = 0."""
    if v == 0:
        return mpf(1)
    z = 3 / v
    return z * (struveh(0, z) - bessely(0, z)) * pi / 2 if z < 60 else laplace(lambda s: (1 + (s / z) ** 2) ** mpf("-0.5"))


def k1_scaled(v):
    """(K1 - 2/pi) z^2 pi/2."""
    if v == 0:
        return mpf(1)
    z = 3 / v
    if z < 60:
        return (struveh(1, z) - bessely(1, z) - 2 / pi) * z * z * pi / 2
    return laplace(lambda s: ((1 + (s / z) ** 2).sqrt() - 1) * z * z)


def laplace(f):
    return quad(lambda s: exp(-s) * f(mpf(s)), [0, 1, 5, 20, 60, 120])


def chebyshev(f):
    nodes = [cos(pi * (k + mpf(1) / 2) / NODES) for k in range(NODES)]
    values = [f((1 + t) / 2) for t in nodes]
    out = []
    for j in range(NODES):
        c = 2 * sum(v * cos(pi * j * (k + mpf(1) / 2) / NODES) for k, v in enumerate(values)) / NODES
        out.append(c)
    out[0] /= 2
    last = max(j for j, c in enumerate(out) if abs(c) > TARGET)
    return out[: last + 1]


def main():
    print("//! Chebyshev coefficients on v = 3/z in (0, 1], in the variable 2v − 1. Written by scripts/fit_struve.py.")
    for name, doc, f in (
        ("K0", "z K₀(z) π/2, where K₀ = H₀ − Y₀.", k0_scaled),
        ("K1", "(K₁(z) − 2/π) z² π/2, where K₁ = H₁ − Y₁.", k1_scaled),
    ):
        c = chebyshev(f)
        print(f"\n/// {doc}")
        print(f"pub(super) const {name}: [f64; {len(c)}] = [")
        for x in c:
            print(f"    {float(x)!r},")
        print("];")


if __name__ == "__main__":
    main()
