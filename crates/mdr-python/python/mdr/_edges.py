"""Two works of adhesion: what an advancing edge gains, and what a receding one needs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, TypeAlias, Union

import numpy as np

from ._errors import DomainError
from ._numbers import Floats, Number, exact, plain, positive, shaped
from ._states import Event, LoadingPath, State, Status, Trace

Works: TypeAlias = Union[Number, tuple[Number, Number], Mapping[str, Number]]

_W = "the work of adhesion w"
_EDGES = ("advancing", "receding")
# Events in which nothing is lost.
_QUIET = ("start", "way-point", "end", "pinned", "depinned", "touch")


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


def in_scene(work: Number | tuple[Number, Number]) -> Any:
    """The key of a scene."""
    return dict(zip(_EDGES, work)) if isinstance(work, tuple) else work


def path_of(scene: dict[str, Any], samples: int) -> LoadingPath:
    """The path of a scene with two works of adhesion, in f64."""
    points = max(2, samples) * max(1, len(scene["control"]["path"]) - 1)
    answer = _solved(scene, want=["path", "force-curve"], points=points)
    events = tuple(_event(row, scene) for row in answer["path"])
    _finished(answer["path"])
    names = ("contact_radius", "indentation", "force", "position")
    curve: dict[str, Floats] = {name: np.array([_or_zero(row.get(name)) for row in answer["force-curve"]]) for name in names}
    balance = answer.balance or {}
    lost = sum(event.dissipated for event in events)
    work, dissipated, stored = (
        tuple(_or_nan(balance.get(name)) for name in ("work", "dissipated", "stored")) if balance else (lost, lost, math.nan)
    )
    held = "position" if scene["control"]["kind"] == "machine" else scene["control"]["kind"]
    return LoadingPath(
        events,
        curve["contact_radius"],
        curve["indentation"],
        curve["force"],
        curve["position"] if held == "position" else None,
        work,
        dissipated,
        stored,
        held,
    )


def trace_of(scene: dict[str, Any], shape: tuple[int, ...]) -> Trace:
    """The states at the way points of such a scene."""
    rows = _solved(scene, want=["path"])["path"]
    _finished(rows)
    arrivals = [row for row in rows if row["event"] in ("start", "way-point", "end")]
    count = math.prod(shape)
    columns = np.full((3, count), math.nan)
    status = np.full(count, Status.NOT_ADMISSIBLE, dtype=np.int8)
    # Beyond the end of the path there are no states.
    for index, row in enumerate(arrivals[:count]):
        state = _event(row, scene).after
        columns[:, index] = state.contact_radius, state.indentation, state.force
        status[index] = Status.OK
    jumps = tuple(_event(row, scene) for row in rows if row["event"] not in _QUIET)
    at = np.array(scene["control"]["path"][:count], dtype=float).reshape(shape)
    a, d, f = (shaped(column, shape) for column in columns)
    return Trace(a, d, f, shaped(status, shape), at if scene["control"]["kind"] == "machine" else None, jumps)


def _solved(scene: dict[str, Any], want: Sequence[str], **output: Any) -> Any:
    from ._scene import solve

    return solve(scene | {"output": {"want": list(want)} | output}, f64=True)


def _finished(rows: Sequence[Mapping[str, Any]]) -> None:
    last = rows[-1]
    if last["event"] == "undecided":
        raise ValueError(f"the path cannot be followed: {last.get('why') or last['status']}")


def _event(row: Mapping[str, Any], scene: Mapping[str, Any]) -> Event:
    before = State(*(_or_zero(row.get(name)) for name in ("contact_radius", "indentation", "force")))
    changed = any(row.get(f"to_{name}") is not None for name in ("contact_radius", "indentation", "force"))
    after = before
    if changed:
        after = State(*(_or_zero(row.get(f"to_{name}")) for name in ("contact_radius", "indentation", "force")))
    kind = scene["control"]["kind"]
    value = row.get("position" if kind == "machine" else kind)
    jump = row.get("dissipated")
    lost = math.inf if jump == "unbounded" else _or_zero(jump)
    hysteresis = _or_zero(row.get("hysteresis"))
    return Event(row["event"], _or_nan(value), before, after, lost + hysteresis, hysteresis, row.get("edge"))


def _or_zero(value: Any) -> float:
    return 0.0 if value is None else float(value)


def _or_nan(value: Any) -> float:
    return math.nan if value is None else float(value)
