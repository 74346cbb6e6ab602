"""Functions beside the contacts."""

from __future__ import annotations

import decimal
from decimal import Decimal
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._contact import Contact, Control, held_by, stiffness_of
from ._errors import DomainError
from ._numbers import Number, array, digits_of, double, exact, positive, shaped
from ._profiles import Paraboloid
from ._states import States


def jkr(radius: Number, e_star: Number, work_of_adhesion: Number) -> Contact:
    """The contact of Johnson, Kendall and Roberts: a paraboloid of this radius of curvature, which they call a sphere.

    Parameters
    ----------
    radius : Number
        R in m.
    e_star : Number
        E* in Pa; their K is 4E*/3.
    work_of_adhesion : Number
        w in J/m².

    Examples
    --------
    >>> import mdr
    >>> mdr.jkr(1e-6, 1e6, 0.05).critical("indentation").force  # at fixed grips −5/6 πwR
    -1.3089969389957473e-07
    """
    return Contact(Paraboloid(radius), e_star=e_star, work_of_adhesion=work_of_adhesion)


def critical_states(
    *, n: ArrayLike, c: ArrayLike, e_star: ArrayLike, work_of_adhesion: ArrayLike, control: Control
) -> States:
    """The critical states of many power laws f = c·rⁿ at once, each number within 2 units in the last place.

    Parameters
    ----------
    n, c, e_star, work_of_adhesion : array_like
        Of shapes that broadcast, as doubles.
    control : {"indentation", "force"} or Machine
        The controlled quantity.

    Examples
    --------
    >>> import mdr, numpy as np
    >>> radius = np.array([1e-6, 2e-6])
    >>> many = mdr.critical_states(n=2, c=0.5 / radius, e_star=1e6, work_of_adhesion=0.05, control="force")
    >>> np.allclose(many.force, -1.5 * np.pi * 0.05 * radius, rtol=1e-15)
    True
    """
    held, stiffness = held_by(control)
    named = {"n": n, "c": c, "e_star": e_star, "work_of_adhesion": work_of_adhesion}
    checked = [flat.reshape(shape) for flat, shape in (array(values, name) for name, values in named.items())]
    whole = np.broadcast_arrays(*checked)
    shape = whole[0].shape
    flat = [np.ascontiguousarray(values).reshape(-1) for values in whole]
    _, columns, status = _core.critical_states(flat[0], flat[1], flat[2], flat[3], held, stiffness_of(stiffness))
    return States(*(shaped(column, shape) for column in (*columns, status)))


@overload
def kappa(n: Number, *, digits: None = None) -> float: ...
@overload
def kappa(n: Number, *, digits: int) -> Decimal: ...
def kappa(n: Number, *, digits: int | None = None) -> float | Decimal:
    """The factor κ of the theory for the exponent n, as a double or in certified digits: g = κ·c·xⁿ.

    Examples
    --------
    >>> import mdr
    >>> mdr.kappa(1, digits=20)  # π/2
    Decimal('1.5707963267948966192')
    """
    positive(n, "n", "the exponent n")
    return _core.kappa(exact(n, "n"), None if digits is None else digits_of(digits))


def context(digits: int) -> decimal.Context:
    """For arithmetic with certified digits: as many digits, all exponents, and no underflow in silence.

    The default context of ``decimal`` makes 0 of numbers below 1e-999999. Arithmetic with certified digits is not certified.
    """
    traps = [decimal.InvalidOperation, decimal.DivisionByZero, decimal.Overflow, decimal.Underflow]
    return decimal.Context(prec=digits_of(digits), Emin=decimal.MIN_EMIN, Emax=decimal.MAX_EMAX, traps=traps)


def effective_modulus(e1: Number, nu1: Number, e2: Number | None = None, nu2: Number | None = None) -> float:
    """E* of two bodies by their Young's moduli and Poisson's ratios, 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂; the second one is
    rigid where it is not given.

    Examples
    --------
    >>> import mdr
    >>> mdr.effective_modulus(0.75e6, 0.5)
    1000000.0
    """
    if (e2 is None) != (nu2 is None):
        raise TypeError("e2 and nu2 go together")
    bodies = [(e1, nu1)] if e2 is None or nu2 is None else [(e1, nu1), (e2, nu2)]
    compliance = 0.0
    for of_body, number in bodies:
        positive(of_body, "e", "Young's modulus E")
        modulus, ratio = double(of_body, "e"), double(number, "nu")
        if not -1 < ratio <= 0.5:
            quantity, requirement = "Poisson's ratio ν", "greater than -1 and not above 1/2"
            raise DomainError(f"{quantity} must be {requirement}, got {ratio}", quantity, str(ratio), requirement)
        compliance += (1 - ratio**2) / modulus
    return 1 / compliance
