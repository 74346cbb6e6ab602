"""What is refused, and how."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import mdr


@pytest.mark.parametrize("bad", [-1, 0, -0.0, float("nan"), float("inf"), "-1e-400000", Fraction(-1, 3), Decimal(0)])
def test_a_parameter_out_of_its_domain_raises(bad: mdr.Number) -> None:
    for make, quantity in [
        (lambda: mdr.Contact(mdr.PowerLaw(n=bad, c=1), e_star=1, work_of_adhesion=1), "the exponent n"),
        (lambda: mdr.jkr(bad, 1, 1), "the radius R"),
        (lambda: mdr.jkr(1, bad, 1), "the effective modulus E*"),
        (lambda: mdr.jkr(1, 1, bad), "the work of adhesion w"),
        (lambda: mdr.Machine(bad), "the machine stiffness k"),
        (lambda: mdr.kappa(bad), "the exponent n"),
    ]:
        with pytest.raises(mdr.DomainError) as caught:
            make()
        error = caught.value
        assert (error.quantity, error.value, error.requirement) == (quantity, str(bad), "positive and finite")
        assert str(error) == f"{quantity} must be positive and finite, got {bad}"
        assert isinstance(error, ValueError) and isinstance(error, mdr.Error)


class Quantity:
    """As pint has it."""

    magnitude = 1.0
    units = "N"

    def __array__(self, *_: object) -> np.ndarray:
        return np.array(1.0)


def test_units_are_refused(ball: mdr.Contact) -> None:
    for ask in (
        lambda: mdr.jkr(Quantity(), 1e6, 0.05),
        lambda: mdr.jkr(1e-6, Quantity(), 0.05),
        lambda: ball.states(force=Quantity()),
        lambda: mdr.Machine(Quantity()),
    ):
        with pytest.raises(TypeError, match="units"):
            ask()


@pytest.mark.parametrize("bad", [True, None, 1j, [1.0]])
def test_what_is_no_number_is_refused(bad: object) -> None:
    with pytest.raises(TypeError):
        mdr.jkr(bad, 1, 1)
    with pytest.raises((TypeError, ValueError)):
        mdr.jkr(1, 1, 1).states(force=np.array([bad, "a"], dtype=object))


@pytest.mark.parametrize("text", ["", "one", "1e", "1/0x", "1 N"])
def test_a_text_that_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="is no number|is not a number in a known unit|radius is in m"):
        mdr.jkr(text, 1, 1)


def test_what_is_held_is_said_once(ball: mdr.Contact) -> None:
    for keywords in ({}, {"force": 0, "indentation": 0}, {"position": 0}, {"force": 0, "stiffness": 1}):
        with pytest.raises(TypeError):
            ball.states(**keywords)
    for control in ("load", None, 1):
        with pytest.raises(ValueError, match="control must be"):
            ball.critical(control)
    with pytest.raises(ValueError, match="branch"):
        ball.states(force=0, branch="middle")
    with pytest.raises(ValueError, match="start"):
        ball.follow(force=[0], start="anywhere")


def test_a_path_from_nowhere(ball: mdr.Contact) -> None:
    with pytest.raises(mdr.NoEquilibriumError):
        ball.path(force=[-1, 0])
    with pytest.raises(mdr.DomainError):
        ball.follow(force=[])
    with pytest.raises(mdr.DomainError):
        ball.follow(force=[0, np.nan])


def test_a_scene_without_a_question_says_where() -> None:
    scene = {
        "profile": mdr.Paraboloid(1), "material": {"e_star": 1, "work_of_adhesion": 1},
        "control": {"kind": "machine"}, "output": {"want": ["folds"]},
    }
    with pytest.raises(mdr.SceneError) as caught:
        mdr.solve(scene)
    assert (caught.value.key, caught.value.file, caught.value.line) == ("control", None, None)
    assert "stiffness" in str(caught.value)


def test_a_file_without_a_question_says_on_which_line(tmp_path) -> None:
    file = tmp_path / "tip.toml"
    file.write_text('[profile]\nkind = "sphere"\nradius = -1\n[output]\nwant = ["transform"]\ntransform.at = [1]')
    with pytest.raises(mdr.SceneError) as caught:
        mdr.solve(file)
    error = caught.value
    assert (error.file, error.line, error.key) == (str(file), 3, "profile.radius")
    with pytest.raises(FileNotFoundError, match="nowhere.toml"):
        mdr.solve(tmp_path / "nowhere.toml")


def test_a_filter_that_is_none() -> None:
    with pytest.raises(mdr.FilterError):
        mdr.records("colour=red")
    with pytest.raises(KeyError):
        mdr.record("nothing")
