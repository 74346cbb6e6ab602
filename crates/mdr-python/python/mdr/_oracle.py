"""Certified records, and the judge of other programs' answers."""

from __future__ import annotations

import functools
import html
import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from decimal import Decimal
from types import MappingProxyType
from typing import Any, Literal, TypeAlias, Union, final

from . import _core
from ._numbers import Number, exact

# Inputs of records by their names here.
_ARGUMENTS = {
    "E*": "e_star", "w": "work_of_adhesion", "C": "c", "F": "force", "d": "indentation", "D": "position",
    "k": "stiffness", "a": "contact_radius",
}


@final
class Answer:
    """An answer with what a plain number does not say.

    Parameters
    ----------
    value : Number, optional
        None where there is no number, or NaN beside a status that says so.
    error : Number, optional
        The error that the program claims.
    status : str, optional
        ``ok``, ``no-equilibrium``, ``overflow`` and the like.
    """

    __slots__ = ("value", "error", "status")

    def __init__(self, value: Number | None = None, *, error: Number | None = None, status: str | None = None) -> None:
        self.value, self.error, self.status = value, error, status

    def _line(self, id: str) -> str:
        nothing = self.status is not None and self.value != self.value
        numbers = {"value": None if nothing else self.value, "error": self.error}
        texts = {key: exact(number, key) for key, number in numbers.items() if number is not None}
        return json.dumps({"id": id, **texts} | ({} if self.status is None else {"status": self.status}))


AnswerLike: TypeAlias = Union[Number, Answer, tuple[Number, Number], None]


def _answer(given: AnswerLike) -> Answer | None:
    if given is None or isinstance(given, Answer):
        return given
    if isinstance(given, tuple):
        value, error = given
        return Answer(value, error=error)
    return Answer(given)


@dataclass(frozen=True)
class Mark:
    """What the judge says of one answer."""

    id: str
    verdict: Literal["right", "inaccurate", "wrong"]
    reason: str
    digits: tuple[float, float] | None
    excess_loss: tuple[float, float] | None
    claim: Literal["none", "holds", "too-small", "overstated"]


@dataclass(frozen=True, eq=False, repr=False)
class Record:
    """A certified value: a question with exact inputs, and fifty proved digits. ``str(record)`` is its id."""

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
    difficulty: Literal["lower", "average", "higher"]
    flags: tuple[str, ...]

    @property
    def arguments(self) -> dict[str, float]:
        """The inputs as doubles, named as everywhere here: ``e_star``, ``work_of_adhesion``."""
        return {_ARGUMENTS.get(name, name): float(text) for name, text in self.inputs.items()}

    @property
    def nearest(self) -> float:
        """The nearest double; 0 or infinity where the status is ``underflow`` or ``overflow``."""
        return self._numbers[0]

    @property
    def pair(self) -> tuple[float, float]:
        """The value as the sum of two doubles."""
        return self._numbers[1]

    @property
    def tolerance(self) -> float:
        """The relative error that a good algorithm in doubles stays below."""
        return self._numbers[2]

    @property
    def _numbers(self) -> tuple[float, tuple[float, float], float]:
        found = _core.numbers(self.id)
        if found is None:
            raise KeyError(self.id)
        return found

    @property
    def physical(self) -> bool:
        """Whether the contact is a real one in SI units, such as the tip of a force microscope: ``flag=physical`` in a filter."""
        return "si" in self.flags

    def mark(self, answer: AnswerLike) -> Mark:
        """Judges one answer."""
        return judge({self.id: answer}, f"id={self.id}").marks[0]

    def check(self, answer: AnswerLike) -> None:
        """Raises an ``AssertionError`` with the reason, unless the answer is right."""
        __tracebackhide__ = True
        mark = self.mark(answer)
        if mark.verdict != "right":
            raise AssertionError(f"{self.id}: {mark.verdict}: {mark.reason} (certified: {self.value})")

    def __reduce__(self) -> tuple[Any, ...]:
        return record, (self.id,)

    def __str__(self) -> str:
        return self.id

    def __repr__(self) -> str:
        return f"<Record {self.id}>"


@functools.lru_cache(maxsize=1)
def _catalogue() -> dict[str, Record]:
    rows = (json.loads(line) for line in _core.lines())
    return {row["id"]: _record(row) for row in rows}


def _record(row: Mapping[str, Any]) -> Record:
    plain = ("id", "profile", "formula", "quantity", "unit", "control", "status", "difficulty")
    return Record(
        **{key: row[key] for key in plain},
        inputs=MappingProxyType(row["inputs"]),
        value=None if row["mid"] is None else Decimal(row["mid"]),
        condition=MappingProxyType(row["condition"]),
        flags=tuple(row["flags"]),
    )


def records(filter: str = "") -> Sequence[Record]:
    """The certified records of a choice, all without one.

    Raises
    ------
    FilterError
        The choice cannot be read, or chooses nothing.

    Examples
    --------
    >>> import mdr
    >>> first = mdr.records("formula=critical control=force quantity=force id~jkr-unit")[0]
    >>> first, first.value
    (<Record critical/jkr-unit/force/force>, Decimal('-4.7123889803846898576939650749192543262957540990627'))
    """
    return tuple(_catalogue()[id] for id in _core.select(filter))


def record(id: str) -> Record:
    """The record of an id; ``KeyError`` where there is none."""
    try:
        return _catalogue()[id]
    except KeyError:
        raise KeyError(f"no record has the id {id!r}") from None


@dataclass(frozen=True, eq=False, repr=False)
class Report:
    """The judgement of many answers; ``str(report)`` is the table of ``mdr judge``."""

    passed: bool
    failures: tuple[str, ...]
    marks: tuple[Mark, ...]
    questions: int
    text: str = field(default="")

    def check(self) -> None:
        """Raises an ``AssertionError`` with the table, unless all is well."""
        __tracebackhide__ = True
        if not self.passed:
            raise AssertionError(self.text)

    def to_dict(self) -> dict[str, list[Any]]:
        """The marks by columns, the worst first, for ``pandas.DataFrame``."""
        return {field.name: [getattr(mark, field.name) for mark in self.marks] for field in fields(Mark)}

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        state = "passed" if self.passed else "; ".join(self.failures)
        return f"<Report of {len(self.marks)} answers to {self.questions} questions: {state}>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.text)}</pre>"


def judge(
    answers: Callable[[Record], AnswerLike] | Mapping[str, AnswerLike] | Iterable[str] | os.PathLike[str],
    filter: str = "",
    *,
    excess: float = 3.0,
    overstatement: float = 6.0,
    accept_inaccurate: bool = False,
    lenient: bool = False,
    complete: bool = False,
) -> Report:
    """Marks answers to the questions of certified records.

    Parameters
    ----------
    answers : callable, mapping, iterable of str, or path
        A function of a record; answers by id; or JSON lines, or a file of them, as for ``mdr judge``. An answer is a number,
        a pair of a number and the error that is claimed, an :class:`Answer`, or ``None`` for a question that is not taken.
    filter : str
        Which questions: as ``mdr reference`` takes it.
    excess : float
        Digits that may be lost beyond what the condition of the question explains.
    overstatement : float
        By how many times a claimed error may be too large.
    accept_inaccurate, lenient, complete : bool
        Inaccurate answers pass; lines pass that are no answers; every question must be answered.

    Examples
    --------
    >>> import math, mdr
    >>> def pull_off(question):
    ...     x = question.arguments
    ...     if x["n"] == 2:  # no answer to other profiles
    ...         return -0.75 * math.pi * x["work_of_adhesion"] / x["c"]
    >>> mdr.judge(pull_off, "formula=critical control=force quantity=force status=ok").passed
    True
    """
    rules = (excess, overstatement, accept_inaccurate, lenient, complete)
    passed, failures, text, marks, questions = _core.judge_lines(filter, _lines(answers, filter), rules)
    return Report(passed, tuple(failures), tuple(Mark(*mark) for mark in marks), questions, text)


def _lines(
    answers: Callable[[Record], AnswerLike] | Mapping[str, AnswerLike] | Iterable[str] | os.PathLike[str], filter: str
) -> list[str]:
    """Answers as lines of JSON."""
    if isinstance(answers, os.PathLike):
        with open(answers, encoding="utf-8") as file:
            return file.read().splitlines()
    if callable(answers):
        given: Iterable[tuple[str, AnswerLike]] = ((question.id, answers(question)) for question in records(filter))
    elif isinstance(answers, Mapping):
        given = answers.items()
    elif isinstance(answers, str):
        raise TypeError("a str is no list of answers: give a path as pathlib.Path, or lines as a list")
    else:
        return list(answers)
    found = ((id, _answer(answer)) for id, answer in given)
    return [answer._line(id) for id, answer in found if answer is not None]
