"""The errors: one base, and beside it the class of the standard library that fits."""

from __future__ import annotations


class Error(Exception):
    """Base of all errors of this package."""

    _names: tuple[str, ...] = ()

    def __init__(self, message: str, *values: object) -> None:
        super().__init__(message, *values)  # all in args: by them errors are pickled and copied
        for name, value in zip(self._names, values):
            setattr(self, name, value)

    def __str__(self) -> str:
        return str(self.args[0])


class DomainError(Error, ValueError):
    """An input is outside its domain.

    Examples
    --------
    >>> import mdr
    >>> try:
    ...     mdr.jkr(radius=-1, e_star=1e6, work_of_adhesion=0.05)
    ... except mdr.DomainError as error:
    ...     print(error.quantity, error.value, error.requirement, sep=" | ")
    the radius R | -1 | positive and finite
    """

    _names = ("quantity", "value", "requirement")
    quantity: str
    value: str
    requirement: str


class OutOfRangeError(Error, OverflowError):
    """The result is a number, but no double holds it; ``log10`` is that of its magnitude. Ask for digits instead."""

    _names = ("quantity", "log10")
    quantity: str
    log10: float


class NoEquilibriumError(Error, ValueError):
    """No state satisfies the equations, where one is needed to go on."""


class NoConvergenceError(Error, ArithmeticError):
    """An iteration ended before its tolerance was met."""


class UndecidedError(Error, ArithmeticError):
    """No precision that may be used decides between two answers; ``bits`` is the largest that was tried."""

    _names = ("bits",)
    bits: int


class SceneError(Error, ValueError):
    """An invalid scene: ``key`` is the place, with ``file`` and ``line`` where it was read from a file."""

    _names = ("file", "line", "key")
    file: str | None
    line: int | None
    key: str


class FilterError(Error, ValueError):
    """A choice of records that is none, or chooses nothing."""


class InternalError(Error, RuntimeError):
    """A defect of this package: please report it."""
