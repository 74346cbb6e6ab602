"""Scenes: a profile, a control and the wanted outputs, as on the command line."""

from __future__ import annotations

import decimal
import json
import os
from collections.abc import Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, TypeAlias, Union, final

from . import _core
from ._numbers import digits_of
from ._profiles import Files, scene_text
from ._states import html_table

File: TypeAlias = Union[str, "os.PathLike[str]"]
Promise: TypeAlias = Literal["certified", "f64"]

# Lists of an answer that are no output.
_NO_OUTPUTS = ("notes",)
# What is text, though it may look like a number.
_TEXTS = ("why", "event", "kind", "status", "stability", "regime")


@final
class Picture:
    """A drawing as SVG, which shows itself in a notebook."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def save(self, path: File) -> None:
        """Writes the SVG to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)

    def __repr__(self) -> str:
        return "<Picture, SVG>"

    def _repr_svg_(self) -> str:
        return self.svg


class Solution(Mapping[str, list[dict[str, Any]]]):
    """The answer to a scene: each output by its name, as a list of records.

    Numbers are ``Decimal`` with every digit that is known, and ``float`` in f64; what has no number is ``None``, and the
    ``status`` of its record says why. :meth:`to_json` is the answer as published.
    """

    def __init__(self, text: str, scene: tuple[str, str, Files]) -> None:
        self._text, self._scene = text, scene
        answer = json.loads(text)
        number = _double if answer["arithmetic"] == "f64" else _digits
        outputs = ((key, rows) for key, rows in answer.items() if isinstance(rows, list) and key not in _NO_OUTPUTS)
        self._outputs: dict[str, list[dict[str, Any]]] = {key: _numbers(rows, number) for key, rows in outputs}
        self.promise: dict[str, Promise] = answer["promise"]
        """How far the numbers of each output can be trusted."""
        self.complete: dict[str, dict[str, Any]] = answer["complete"]
        """Whether each list is proved to hold everything, and on which range of contact radii."""
        self.notes: tuple[str, ...] = tuple(answer.get("notes", ()))
        """How the scene was read, where that may surprise."""
        self.balance: dict[str, Any] | None = _numbers(answer.get("balance"), number)
        """The energy balance of a path: ``work``, ``dissipated`` and ``stored``, where it is finite."""
        self.force_curve_summary: dict[str, Any] | None = _numbers(answer.get("force-curve-summary"), number)
        """What is read off a force curve: pull-off force, minimum force, hysteresis."""
        self.validity: dict[str, Any] | None = _numbers(answer.get("validity"), number)
        """Whether the theory holds, where ``material`` has a ``range_of_adhesion``: Tabor's number ``tabor``, ``regime``, the
        pull-off force by Maugis and Dugdale and its ``correction``."""

    def __getitem__(self, output: str) -> list[dict[str, Any]]:
        return self._outputs[output]

    def __iter__(self) -> Iterator[str]:
        return iter(self._outputs)

    def __len__(self) -> int:
        return len(self._outputs)

    def columns(self, output: str) -> dict[str, list[Any]]:
        """An output by columns, for ``pandas.DataFrame``; ``None`` where a record has no such key."""
        rows = self._outputs[output]
        names = dict.fromkeys(key for row in rows for key in row)
        return {name: [row.get(name) for row in rows] for name in names}

    def to_json(self) -> str:
        """The answer as one line of JSON, schema ``mdr.solve/1``, as the command line prints it."""
        return self._text

    def picture(self) -> Picture:
        """The drawing of ``mdr solve --plot``: the balance at the edge of the contact, and force against indentation and
        contact radius. A scene that was read from a file is read again."""
        return Picture(_core.draw(*self._scene))

    def _standing(self, output: str) -> str:
        """The promise of an output, and "undecided" where it is not decided whether anything is missing."""
        if not self.complete.get(output, {}).get("undecided"):
            return self.promise[output]
        is_open = all(row.get("status") == "undecided" for row in self._outputs[output])
        return "undecided" if is_open else f"{self.promise[output]}; undecided whether all"

    def __repr__(self) -> str:
        inside = ", ".join(f"{key} ({len(rows)}, {self._standing(key)})" for key, rows in self._outputs.items())
        return f"<Solution: {inside}>"

    def _repr_html_(self) -> str:
        tables = []
        for name in self._outputs:
            columns = self.columns(name)
            rows = list(zip(*([str(cell) for cell in column] for column in columns.values())))
            tables.append(f"<h4>{name} ({self._standing(name)})</h4>" + html_table(tuple(columns), rows))
        return "".join(tables)


def _numbers(value: Any, number: Any) -> Any:
    """Numbers as numbers: in JSON their digits are text."""
    if isinstance(value, dict):
        return {key: item if key in _TEXTS else _numbers(item, number) for key, item in value.items()}
    if isinstance(value, list):
        return [_numbers(item, number) for item in value]
    if isinstance(value, str) and value[-1:].isdigit():
        try:
            return number(value)
        except (decimal.InvalidOperation, ValueError):
            return value  # words that end in a digit, or an exponent that no Decimal has
    return value


def _is_json(text: str) -> bool:
    """Whether a text is JSON, and neither TOML nor the name of a file: it begins with a brace or a bracket. A table of TOML begins
    with a bracket too, and has more lines."""
    text = text.lstrip()
    if not text.startswith("[") or "\n" not in text:
        return text.startswith(("{", "["))
    try:
        json.loads(text)
    except ValueError:
        return False
    return True


def _double(text: str) -> float:
    return float(Fraction(text)) if "/" in text else float(text)


def _digits(text: str) -> Decimal | Fraction:
    return Fraction(text) if "/" in text else Decimal(text)


def solve(scene: Mapping[str, Any] | File, *, digits: int | None = None, f64: bool = False) -> Solution:
    """The answer to a scene, with every output that it wants and nothing else.

    Ctrl-C stops it.

    Parameters
    ----------
    scene : mapping or str or path
        A mapping with the keys of a scene, whose profile may be a :class:`Profile`; the name of a ``.toml`` or ``.json``
        file; JSON itself, a ``str`` that begins with ``{`` or ``[``; or TOML itself, a ``str`` with a line break. Numbers are exact as
        typed, also floats.
    digits : int, optional
        So many significant digits, from 1 to 100 000; what the scene says without, else 20. Takes precedence over the scene.
    f64 : bool
        Answer in doubles.

    Raises
    ------
    SceneError
        With file, line and key.
    OSError
        A file cannot be read.

    Examples
    --------
    >>> import mdr
    >>> answer = mdr.solve({
    ...     "profile": {"kind": "paraboloid", "radius": 0.01},
    ...     "material": {"e_star": 1e6, "work_of_adhesion": 0.05},
    ...     "control": {"kind": "force"},
    ...     "output": {"want": ["folds"]},
    ... })
    >>> answer
    <Solution: folds (1, certified)>
    >>> answer["folds"][0]["force"]
    Decimal('-0.0023561944901923449288')
    """
    files: Files = {}
    if digits is not None:
        digits = digits_of(digits)
    if isinstance(scene, str):
        scene = scene.removeprefix("\ufeff")
    if isinstance(scene, Mapping):
        form, text = "json", scene_text(scene, files)
    elif isinstance(scene, str) and _is_json(scene):
        form, text = "json", scene
    elif isinstance(scene, str) and "\n" in scene:
        form, text = "toml", scene
    else:
        form, text = "file", os.fspath(scene)
    return Solution(_core.solve(form, text, files, digits, f64), (form, text, files))
