"""Two works of adhesion: what an advancing edge gains, and what a receding one needs."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, TypeAlias, Union

from ._errors import DomainError
from ._numbers import Number, exact, plain, positive

Works: TypeAlias = Union[Number, tuple[Number, Number], Mapping[str, Number]]

_W = "the work of adhesion w"
_EDGES = ("advancing", "receding")
# Events between two works of adhesion in which nothing is lost.
QUIET = ("pinned", "depinned", "touch")


def works_of(work: Works) -> Number | tuple[Number, Number]:
    """One work of adhesion, or that of an advancing and of a receding edge if they differ."""
    if isinstance(work, Mapping):
        if set(work) != set(_EDGES):
            names = ", ".join(map(repr, work)) or "nothing"
            raise ValueError(f"work_of_adhesion: expected the keys 'advancing' and 'receding', got {names}")
        pair = [work[edge] for edge in _EDGES]
    elif isinstance(work, (tuple, list)):
        if len(work) != 2:
            raise ValueError(f"work_of_adhesion: expected one number, or (advancing, receding), got {len(work)} numbers")
        pair = list(work)
    else:
        positive(work, "work_of_adhesion", _W)
        return plain(work)
    advancing, receding = (plain(number) for number in pair)
    positive(receding, "work_of_adhesion", f"{_W} of a receding edge")
    gained, needed = (_fraction(number) for number in (advancing, receding))
    if not 0 <= gained <= needed:
        requirement = "at least 0 and at most that of a receding edge; exchange the two if they are the other way round"
        quantity = f"{_W} of an advancing edge"
        raise DomainError(f"{quantity} must be {requirement}, got {advancing} and {receding}", quantity, str(advancing), requirement)
    return receding if gained == needed else (advancing, receding)


def _fraction(work: Number) -> Fraction:
    text = exact(work, "work_of_adhesion")
    try:
        return Fraction(text)
    except ValueError:
        raise ValueError(f"work_of_adhesion: {text!r} is no number: expected one such as 0.25, '1e-9' or '1/3'") from None


def in_scene(work: Number | tuple[Number, Number], *, exactly: bool = False) -> Any:
    """The key of a scene; ``exactly`` as text, which Rust reads."""
    written = (lambda number: exact(number, "work_of_adhesion")) if exactly else (lambda number: number)
    return dict(zip(_EDGES, map(written, work))) if isinstance(work, tuple) else written(work)
