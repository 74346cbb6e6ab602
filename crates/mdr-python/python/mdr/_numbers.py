"""What users may give as a number, and what is refused."""

from __future__ import annotations

import decimal
import math
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeAlias, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import DomainError

Number: TypeAlias = Union[int, float, str, Decimal, Fraction]
Floats: TypeAlias = NDArray[np.float64]


def refuse_units(x: object, name: str) -> None:
    """Numbers with units lose them in an array, and that error is never seen."""
    if hasattr(x, "magnitude") or hasattr(x, "unit"):
        raise TypeError(f"{name} has units: give its magnitude in SI units, such as {name}.to_base_units().magnitude")


def exact(x: Number, name: str) -> str:
    """A number as it was typed: 0.05 is 1/20, whatever double is next to it."""
    if isinstance(x, str):
        return x.strip()
    if isinstance(x, Fraction):
        return f"{x.numerator}/{x.denominator}"
    if isinstance(x, (float, np.floating)):
        return repr(float(x))
    if isinstance(x, (int, np.integer, Decimal)) and not isinstance(x, bool):
        return str(x)
    refuse_units(x, name)
    raise TypeError(f"{name}: expected a number in SI units, got {type(x).__name__}")


def double(x: Number, name: str) -> float:
    """The nearest double."""
    text = exact(x, name)
    try:
        return float(Fraction(text)) if "/" in text else float(text)
    except ValueError:
        raise ValueError(f"{name}: {text!r} is no number: expected one such as 0.25, '1e-9' or '1/3'") from None
    except OverflowError:
        return math.inf


def positive(x: Number, name: str, quantity: str) -> None:
    """Refuses what is not positive and finite, however small or large it is."""
    if type(x) in (float, int) and 0 < x < math.inf:  # type: ignore[operator]  # the usual case, without its text
        return
    if not _sign(exact(x, name), name) > 0:
        raise DomainError(
            f"{quantity} must be positive and finite, got {x}", quantity, str(x), "positive and finite"
        )


def _sign(text: str, name: str) -> float:
    """The sign of a number that may be beyond all doubles; NaN of what is not finite."""
    sign = 1.0
    for part in text.split("/"):
        try:
            number = Decimal(part)
        except decimal.InvalidOperation:
            message = f"{name}: {text!r} is no number: expected one such as 0.25, '1e-9' or '1/3'"
            raise ValueError(message) from None
        sign *= math.nan if not number.is_finite() else 0.0 if number.is_zero() else -1.0 if number < 0 else 1.0
    return sign


def array(x: ArrayLike, name: str) -> tuple[Floats, tuple[int, ...]]:
    """Doubles in one row, and the shape that they had."""
    refuse_units(x, name)
    values = np.asarray(x)
    if values.dtype.kind not in "fiu":
        raise TypeError(f"{name}: expected real numbers, got dtype {values.dtype}")
    return np.ascontiguousarray(values, dtype=np.float64).reshape(-1), values.shape


def shaped(column: NDArray[Any], shape: tuple[int, ...]) -> Any:
    """A column in the shape of what was asked; a scalar for a scalar."""
    return column.reshape(shape)[()]
