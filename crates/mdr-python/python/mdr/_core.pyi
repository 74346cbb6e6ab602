"""The extension module: numbers in and out of Rust. Not for use by others."""

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Final, Literal, TypeAlias, final, overload

import numpy as np
from numpy.typing import NDArray

from ._numbers import Floats

__all__ = [
    "CERTIFIED",
    "MAX_DIGITS",
    "PROGRAM",
    "VERSION",
    "Contact",
    "Fitted",
    "critical_states",
    "draw",
    "fit",
    "in_si",
    "judge_lines",
    "kappa",
    "lines",
    "numbers",
    "select",
    "solve",
]

CERTIFIED: Final[bool]
MAX_DIGITS: Final[int]
PROGRAM: Final[str]
VERSION: Final[str]

_Codes: TypeAlias = NDArray[np.int8]
_Flags: TypeAlias = NDArray[np.bool_]
_Row: TypeAlias = tuple[float, float, float]
_Columns: TypeAlias = tuple[Floats, Floats, Floats]
_Event: TypeAlias = tuple[str, float, _Row, _Row, float, float, str | None]
_Range: TypeAlias = tuple[float, float] | None
_Mark: TypeAlias = tuple[
    str,
    Literal["right", "inaccurate", "wrong"],
    str,
    _Range,
    _Range,
    Literal["none", "holds", "too-small", "overstated"],
]

@final
class Contact:
    def __new__(cls, scene: str, files: Mapping[str, bytes]) -> Contact: ...
    def transform(self, x: Floats) -> _Columns: ...
    def critical(self, held: str, stiffness: str | None = None) -> _Row: ...
    def certified(self, held: str, digits: int, stiffness: str | None = None) -> list[Decimal]: ...
    def pull_off(self, held: str, stiffness: float | None = None) -> _Row: ...
    def folds(
        self, held: str, stiffness: float | None = None
    ) -> list[tuple[float, float, float, Literal["minimum", "maximum"]]]: ...
    def curve(self, radii: Floats) -> tuple[_Columns, _Codes]: ...
    def field(self, name: str, contact_radius: float, radii: Floats) -> Floats: ...
    def states(
        self, values: Floats, held: str, stiffness: float | None, largest: bool
    ) -> tuple[_Columns, _Codes]: ...
    def state(
        self, value: float, held: str, stiffness: float | None, largest: bool
    ) -> tuple[_Row, int]: ...
    def equilibria(
        self, values: Floats, held: str, stiffness: float | None = None
    ) -> tuple[_Columns, _Flags, _Flags, _Codes]: ...
    def follow(
        self, values: Floats, held: str, stiffness: float | None, start: str
    ) -> tuple[_Columns, _Codes, list[_Event]]: ...
    def path(
        self, way: Floats, held: str, stiffness: float | None, start: str, samples: int
    ) -> tuple[list[_Event], _Columns, list[float] | None]: ...

@overload
def kappa(n: str, digits: None = None) -> float: ...
@overload
def kappa(n: str, digits: int) -> Decimal: ...
@overload
def kappa(n: str, digits: int | None) -> float | Decimal: ...
def critical_states(
    n: Floats, c: Floats, e_star: Floats, work_of_adhesion: Floats, held: str, stiffness: float | None = None
) -> tuple[Floats, _Columns, _Codes]: ...
def solve(form: str, text: str, files: Mapping[str, bytes], digits: int | None, f64: bool) -> str: ...
def draw(form: str, text: str, files: Mapping[str, bytes]) -> str: ...
@final
class Fitted:
    def head(self) -> str: ...
    def json(self) -> str: ...
    def svg(self) -> str: ...
    def columns(self) -> tuple[list[Floats], NDArray[np.int64], list[_Flags]]: ...

def fit(
    problem: str, files: Mapping[str, bytes], x: Floats, y: Floats, legs: Sequence[str] | None
) -> Fitted: ...
def in_si(text: str, key: str, name: str) -> str: ...
def select(choice: str) -> list[str]: ...
def lines() -> list[str]: ...
def numbers(id: str) -> tuple[float, tuple[float, float], float] | None: ...
def judge_lines(
    choice: str, answers: Sequence[str], rules: tuple[float, float, bool, bool, bool]
) -> tuple[bool, list[str], str, list[_Mark], int]: ...
