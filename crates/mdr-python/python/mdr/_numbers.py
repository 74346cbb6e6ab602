"""What users may give as a number, and what is refused."""

from __future__ import annotations

import decimal
import math
import operator
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeAlias, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import MAX_DIGITS, in_si
from ._errors import DomainError

Number: TypeAlias = Union[int, float, str, Decimal, Fraction]
Floats: TypeAlias = NDArray[np.float64]


def refuse_units(x: object, name: str) -> None:
    """Numbers with units lose them in an array, and that error is never seen."""
    if hasattr(x, "magnitude") or hasattr(x, "unit"):
        raise TypeError(f"{name} has units: give its magnitude in SI units, such as {name}.to_base_units().magnitude")


def plain(x: Number) -> Number:
    """An array of one number and no dimension as a number, which can be hashed; all else as it is."""
    value: Any = x
    if isinstance(value, np.ndarray) and value.ndim == 0 and not isinstance(value, np.ma.MaskedArray):
        x = value.item()
    return x


def exact(x: Number, name: str, key: str | None = None) -> str:
    """A number as it was typed: 0.05 is 1/20, whatever double is next to it. A text may have a unit of the dimension that belongs
    to the ``key``, or else to the ``name``: "5 um" is "5e-6"."""
    x = plain(x)
    if isinstance(x, str):
        return in_si(x.strip(), name if key is None else key, name)
    if isinstance(x, Fraction):
        return f"{x.numerator}/{x.denominator}"
    if isinstance(x, (float, np.floating)):
        return repr(float(x))
    if isinstance(x, (int, np.integer, Decimal)) and not isinstance(x, bool):
        return str(x)
    refuse_units(x, name)
    raise TypeError(f"{name}: expected a number in SI units, got {type(x).__name__}")


def double(x: Number, name: str, key: str | None = None) -> float:
    """The nearest double."""
    text = exact(x, name, key)
    try:
        return float(Fraction(text)) if "/" in text else float(text)
    except ValueError:
        raise ValueError(f"{name}: {text!r} is no number: expected one such as 0.25, '1e-9' or '1/3'") from None
    except OverflowError:
        return math.inf


def positive(x: Number, name: str, quantity: str, key: str | None = None) -> None:
    """Refuses what is not positive and finite, however small or large it is."""
    if type(x) in (float, int) and 0 < x < math.inf:  # type: ignore[operator]  # the usual case, without its text
        return
    if not _sign(exact(x, name, key), name) > 0:
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


def digits_of(digits: int) -> int:
    """The number of digits that is asked for: one limit, wherever digits are."""
    if isinstance(digits, (bool, np.bool_)) or not hasattr(digits, "__index__"):
        raise TypeError(f"digits: expected a whole number, got {type(digits).__name__}")
    count = operator.index(digits)
    if not 1 <= count <= MAX_DIGITS:
        requirement = f"a whole number from 1 to {MAX_DIGITS}"
        raise DomainError(f"digits must be {requirement}, got {count}", "digits", str(count), requirement)
    return count


def array(x: ArrayLike, name: str) -> tuple[Floats, tuple[int, ...]]:
    """Doubles in one row, and the shape that they had. What is masked or missing is NaN: the number below a mask counts for
    nothing."""
    refuse_units(x, name)
    try:
        values = np.asarray(_unmasked(x, name))
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{name}: {error}") from None
    if values.dtype.kind == "O":
        values = _of_objects(values, name)
    if values.dtype.kind not in "fiu":
        raise TypeError(f"{name}: expected real numbers, got dtype {values.dtype}")
    # What comes out of a buffer, such as that of another process, may begin between two words.
    return np.require(values, np.float64, ["C_CONTIGUOUS", "ALIGNED"]).reshape(-1), values.shape


def row(x: ArrayLike, name: str) -> Floats:
    """Doubles that came in one row."""
    values, shape = array(x, name)
    if len(shape) != 1:
        raise ValueError(f"{name} must have one dimension, got shape {shape}")
    return values


def _unmasked(x: Any, name: str) -> Any:
    """The same with NaN in the place of what is masked, in lists of arrays as well."""
    if isinstance(x, np.ma.MaskedArray):
        if x.dtype.kind not in "fiuO":
            raise TypeError(f"{name}: expected real numbers, got dtype {x.dtype}")
        return np.ma.filled(x.astype(x.dtype if x.dtype.kind in "fO" else np.float64), math.nan)
    if isinstance(x, (list, tuple)) and any(isinstance(item, (np.ma.MaskedArray, list, tuple)) for item in x):
        return [_unmasked(item, name) for item in x]
    return x


def _of_objects(values: NDArray[Any], name: str) -> Floats:
    """The nearest doubles of numbers of Python, such as ``Decimal`` and ``Fraction``; NaN where pandas has none."""
    found = np.empty(values.shape)
    for at, item in np.ndenumerate(values):
        if type(item).__name__ == "NAType":
            found[at] = math.nan
        elif isinstance(item, str):
            raise TypeError(f"{name}: expected real numbers, got a str at index {_place(at)}")
        else:
            try:
                found[at] = double(item, name)
            except TypeError as error:
                raise TypeError(f"{error} at index {_place(at)}") from None
    return found


def _place(at: tuple[int, ...]) -> str:
    return ", ".join(map(str, at))


def shaped(column: NDArray[Any], shape: tuple[int, ...]) -> Any:
    """A column in the shape of what was asked; a scalar for a scalar."""
    return column.reshape(shape)[()]
