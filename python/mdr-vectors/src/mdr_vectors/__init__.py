"""Certified test vectors of adhesive contact mechanics: questions with exact inputs, and fifty proved digits. CC0-1.0.

>>> import mdr_vectors
>>> pull_off = mdr_vectors.load(id="critical/jkr-unit/force/force")[0]
>>> pull_off.nearest, pull_off.value
(-4.71238898038469, Decimal('-4.7123889803846898576939650749192543262957540990627'))
"""

from __future__ import annotations

import functools
import json
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from importlib import resources
from types import MappingProxyType
from typing import Any

__all__ = ["RELEASE", "Vector", "load", "table"]

RELEASE = 4
_FILES = ("critical", "equilibria", "profiles", "edges", "worst", "fits", "graded", "line", "wave", "loop")


@dataclass(frozen=True)
class Vector:
    """A question and its certified answer; ``str(vector)`` is its id.

    ``inputs`` are exact decimals as text, in SI units: C is the coefficient of f = C·rⁿ, 1/2R of a sphere. ``value`` is None where
    there is none, and ``status`` says why; of an ``overflow`` or ``underflow`` it is beyond the range of doubles.
    """

    id: str
    profile: str
    formula: str
    quantity: str
    unit: str
    control: str | None
    status: str
    inputs: Mapping[str, str]
    value: Decimal | None
    condition: Mapping[str, float]
    difficulty: str
    flags: tuple[str, ...]

    @property
    def arguments(self) -> dict[str, float]:
        """The inputs as doubles."""
        return {name: float(text) for name, text in self.inputs.items()}

    @property
    def nearest(self) -> float:
        """The nearest double; NaN where there is no number."""
        return float("nan") if self.value is None else float(self.value)

    @property
    def tolerance(self) -> float:
        """The relative error that a good algorithm in doubles stays below: four roundings times the condition."""
        whole = "n" in self.inputs and Decimal(self.inputs["n"]) % 1 == 0  # no program rounds the 2 of a sphere
        condition = sum(value for name, value in self.condition.items() if not (whole and name == "n"))
        return 4 * 2.0**-53 * max(1.0, condition)

    def __str__(self) -> str:
        return self.id

    def __hash__(self) -> int:
        return hash(self.id)


@functools.lru_cache(maxsize=1)
def _all() -> tuple[Vector, ...]:
    folder = resources.files(__name__) / "data"
    lines = (line for name in _FILES for line in (folder / f"{name}.jsonl").read_text("utf-8").splitlines())
    return tuple(_vector(json.loads(line)) for line in lines)


def _vector(row: Mapping[str, Any]) -> Vector:
    plain = ("id", "profile", "formula", "quantity", "unit", "control", "status", "difficulty")
    return Vector(
        **{key: row[key] for key in plain},
        inputs=MappingProxyType(row["inputs"]),
        value=None if row["mid"] is None else Decimal(row["mid"]),
        condition=MappingProxyType(row["condition"]),
        flags=tuple(row["flags"]),
    )


def load(**where: str) -> list[Vector]:
    """The vectors that have these values: of their attributes, of one of their flags (``flag=``; ``physical`` are real contacts in SI
    units), or of their inputs, as text.

    Raises
    ------
    ValueError
        There is none: an empty list due to a typing error would pass every test.

    Examples
    --------
    >>> len(load()), len(load(formula="critical", control="force", n="2")) > 20
    (1994, True)
    """

    def has(vector: Vector, key: str, value: str) -> bool:
        if key == "flag":
            return value in vector.flags or (value == "physical" and "si" in vector.flags)
        return str(getattr(vector, key) if hasattr(vector, key) else vector.inputs.get(key)) == value

    chosen = [vector for vector in _all() if all(has(vector, key, value) for key, value in where.items())]
    if not chosen:
        raise ValueError(f"no vector has {where}")
    return chosen


def table(name: str = "jkr-sphere") -> list[dict[str, Any]]:
    """A small table to copy: each row a dict, numbers in SI units."""
    file = resources.files(__name__) / f"{name}.json"
    if not file.is_file():
        raise ValueError(f"no table {name!r}; there is 'jkr-sphere'")
    rows: list[dict[str, Any]] = json.loads(file.read_text("utf-8"))["rows"]
    return rows
