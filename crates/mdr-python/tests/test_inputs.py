"""What comes in is taken as it is meant, or refused by the name of the argument: JSON, masks, dimensions, rows, digits."""

import json
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import mdr

SCENE = {
    "profile": {"kind": "paraboloid", "radius": 0.01},
    "material": {"e_star": 1e6, "work_of_adhesion": 0.05},
    "control": {"kind": "force"},
    "output": {"want": ["folds"]},
}


@pytest.mark.parametrize("indent", [None, 1])
@pytest.mark.parametrize("before", ["", "  \n\t", "\ufeff"])
def test_json_is_read_as_json(indent: int | None, before: str) -> None:
    answer = mdr.solve(before + json.dumps(SCENE, indent=indent))
    assert dict(answer) == dict(mdr.solve(SCENE))
    assert answer.picture().svg == mdr.solve(SCENE).picture().svg


def test_json_at_fault_says_what_and_names_no_file() -> None:
    for text in ("[1,2]", "  [", "{", "[1,\n2]", '["figure-4.toml"]'):
        with pytest.raises(mdr.SceneError, match="JSON"):  # never the name of a file
            mdr.solve(text)
    with pytest.raises(mdr.SceneError, match="radius"):
        mdr.solve('{"profile": {"kind": "sphere", "radius": -1}, "output": {"want": ["transform"], "transform": {"at": [1]}}}')
    with pytest.raises(mdr.SceneError):
        mdr.solve('{"profile": ')


def lists(depth: int) -> list[Any]:
    inner: list[Any] = []
    for _ in range(depth):
        inner = [inner]
    return inner


@pytest.mark.parametrize("depth", [100, 100_000])
def test_a_scene_of_deep_lists_is_refused(depth: int) -> None:
    with pytest.raises(mdr.SceneError, match="nested deeper than 64 levels"):
        mdr.solve({**SCENE, "profile": lists(depth)})
    cycle: dict[str, Any] = {}
    cycle["profile"] = cycle
    with pytest.raises(mdr.SceneError, match="nested deeper than 64 levels"):
        mdr.solve(cycle)


HIDDEN = np.ma.masked_invalid([1e-8, np.nan, 2e-7])
HIDDEN.data[1] = 1e-7  # a number below the mask


@pytest.mark.parametrize(
    "masked",
    [HIDDEN, list(HIDDEN), [HIDDEN[0], np.ma.masked, HIDDEN[2]], tuple(HIDDEN)],
    ids=["array", "list", "constant", "tuple"],
)
def test_what_is_masked_is_nan(ball: mdr.Contact, masked: Any) -> None:
    for states in (ball.states(force=masked), ball.states(indentation=masked), ball.curve(masked)):
        assert states.status[1] == mdr.Status.DOMAIN_ERROR and np.isnan(states.force[1])
    assert np.isnan(ball.profile.g(masked)).tolist() == [False, True, False]
    assert np.isnan(ball.pressure(masked, contact_radius=1e-6)).tolist() == [False, True, False]
    assert np.isnan(ball.energy(force=masked))[1]
    assert ball.equilibria(force=masked).count.tolist()[1] == 0
    many = mdr.critical_states(n=2, c=masked, e_star=1e6, work_of_adhesion=0.05, control="force")
    assert np.isnan(many.force[1]) and many.status[1] == mdr.Status.DOMAIN_ERROR
    with pytest.raises(mdr.DomainError):
        ball.follow(force=masked)
    with pytest.raises(ValueError, match=r"x\[1\]"):
        mdr.fit(masked, [1, 2, 3], profile=mdr.Paraboloid(1), observation="F(d)")
    with pytest.raises(ValueError, match=r"y\[1\]"):
        mdr.fit([1, 2, 3], masked, profile=mdr.Paraboloid(1), observation="F(d)")


def test_masks_in_other_places(ball: mdr.Contact) -> None:
    rows = ball.states(force=[HIDDEN, HIDDEN])
    assert rows.force.shape == (2, 3) and np.isnan(rows.force[:, 1]).all() and not np.isnan(rows.force[:, 0]).any()
    whole = np.ma.array([0, 1], mask=[False, True])
    assert np.isnan(ball.states(force=whole).force).tolist() == [False, True]
    assert np.isnan(ball.states(force=np.ma.masked).force)
    with pytest.raises(TypeError, match="force"):
        ball.states(force=np.ma.array(["a", "b"], mask=[0, 1]))
    for make in (lambda: mdr.Paraboloid(np.ma.masked), lambda: mdr.jkr(1, np.ma.masked, 1)):
        with pytest.raises(TypeError):
            make()
    with pytest.raises(TypeError, match="path"):
        mdr.solve(ball.scene("force", want=["path"], path=HIDDEN))
    with pytest.raises(mdr.DomainError, match=r"r\[2\] must be finite"):
        mdr.Table(np.ma.array([0, 1, 2, 3, 4], mask=[0, 0, 1, 0, 0]), [0, 1, 4, 9, 16])


def test_numbers_of_python_in_arrays(ball: mdr.Contact) -> None:
    expected = ball.states(force=[0.0, 2.5e-7]).force.tolist()
    for values in ([Decimal(0), Decimal("2.5e-7")], [Fraction(0), Fraction(1, 4_000_000)], [0, Decimal("2.5e-7")]):
        assert ball.states(force=values).force.tolist() == expected
    assert ball.states(force=Decimal("2.5e-7")).force == expected[1] and ball.states(force=Fraction(1, 4_000_000)).force == expected[1]
    assert ball.states(force=10**30).status == ball.states(force=1e30).status
    for bad in ("1", ["0", "1"], [Decimal(0), "1"], [None, 1.0], [True, Decimal(1)], [1j], np.array([True]), [[1], object()]):
        with pytest.raises((TypeError, ValueError), match="^force"):
            ball.states(force=bad)
    with pytest.raises(ValueError, match="^force"):
        ball.states(force=[[1.0], [1.0, 2.0]])
    with pytest.raises(TypeError, match="index 1"):
        ball.states(force=[Decimal(0), "1"])


def test_scalars_of_no_dimension(ball: mdr.Contact) -> None:
    zero = np.array(0.0)
    assert ball.states(force=zero).force == 0 and np.shape(ball.states(force=zero).force) == ()
    assert mdr.jkr(np.array(1e-6), np.float64(1e6), np.array(0.05)).critical("force") == ball.critical("force")
    one = mdr.Contact(mdr.Paraboloid(np.array(1e-6)), e_star=np.array(1e6), work_of_adhesion=np.array(0.05))
    assert one == ball and hash(one) == hash(ball) and hash(mdr.Machine(np.array(1.0))) == hash(mdr.Machine(1.0))
    with pytest.raises(TypeError):
        mdr.jkr(np.array([1e-6]), 1e6, 0.05)


def test_series_of_pandas(ball: mdr.Contact) -> None:
    pandas = pytest.importorskip("pandas")
    expected = ball.states(force=[0.0, np.nan, 2e-7]).force
    for series in (
        pandas.Series([0.0, np.nan, 2e-7]), pandas.Series([0.0, None, 2e-7]),
        pandas.Series([0.0, pandas.NA, 2e-7], dtype="Float64"), pandas.Series([0.0, pandas.NA, 2e-7], dtype=object),
    ):
        assert np.array_equal(ball.states(force=series).force, expected, equal_nan=True)


@pytest.mark.parametrize("shape", [(3, 4), (12, 1), (1, 12), ()])
def test_data_of_a_fit_have_one_dimension(shape: tuple[int, ...]) -> None:
    flat = np.linspace(1, 2, 12)
    other = flat.reshape(shape) if shape else np.array(1.0)
    for name, data in (("x", (other, flat)), ("y", (flat, other))):
        with pytest.raises(ValueError, match=f"^{name} must have one dimension") as caught:
            mdr.fit(*data, profile=mdr.Paraboloid(1), observation="F(d)")
        assert str(shape) in str(caught.value)


GOOD = ([0, 1, 2, 3, 4], [0, 1, 4, 9, 16])


@pytest.mark.parametrize(
    ("r", "f", "words"),
    [
        ([0, 1, 2], [0, 1, 4], "4 or more, got 3"),
        ([], [], "4 or more, got 0"),
        (GOOD[0], GOOD[1][:-1], "differ in length: 5 and 4"),
        ([0, 1, np.nan, 3, 4], GOOD[1], r"^r\[2\] must be finite, got nan"),
        (GOOD[0], [0, 1, 4, np.inf, 16], r"^f\[3\] must be finite, got inf"),
        ([0, 1, 1, 3, 4], GOOD[1], r"^r\[2\] must be larger than r\[1\] = 1.0, got 1.0"),
        ([0, 1, 2, 3, 2.5], GOOD[1], r"^r\[4\] must be larger than r\[3\] = 3.0, got 2.5"),
        ([-1, 1, 2, 3, 4], GOOD[1], r"^r\[0\] must be zero or positive, got -1.0"),
        ([[0, 1], [2, 3]], [0, 1, 4, 9], r"^r must have one dimension, got shape \(2, 2\)"),
        ([0, 1, 2, 3], [[0, 1], [4, 9]], r"^f must have one dimension, got shape \(2, 2\)"),
        (1.0, 1.0, r"^r must have one dimension, got shape \(\)"),
        (GOOD[0], [1, 2, 5, 10, 17], r"^f\[0\] must be zero at the tip, r\[0\] = 0, unless there is an offset, got 1.0"),
    ],
)
def test_a_table_names_the_row_at_fault(r: Any, f: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        mdr.Table(r, f)


def test_a_table_that_is_one() -> None:
    assert repr(mdr.Table(*GOOD)) == "<Table of 5 rows>"
    assert mdr.Table(GOOD[0], [1, 2, 5, 10, 17], offset=1).g(1) == mdr.Table(*GOOD).g(1)
    assert mdr.Table([Fraction(i, 3) for i in range(5)], [Decimal(i * i) for i in range(5)]).g(1) > 0


DIGITS: list[Callable[[int], Any]] = [
    lambda digits: mdr.kappa(1, digits=digits),
    lambda digits: mdr.jkr(1, 1, 1).critical("force", digits=digits),
    lambda digits: mdr.Contact(mdr.Sphere(1), e_star=1, work_of_adhesion="1e-3").critical("force", digits=digits),
    lambda digits: mdr.jkr(1, 1, 1).folds("force", digits=digits),
    lambda digits: mdr.jkr(1, 1, 1).validity("0.3 nm", digits=digits),
    lambda digits: mdr.solve(SCENE, digits=digits),
    lambda digits: mdr.context(digits),
    lambda digits: mdr.fit(range(6), range(6), profile=mdr.Paraboloid(1), observation="F(d)", digits=digits),
]


@pytest.mark.parametrize("ask", DIGITS)
@pytest.mark.parametrize("digits", [0, -1, 100_001, 2**31, 2**32 + 20, 10**30])
def test_digits_have_one_limit(ask: Callable[[int], Any], digits: int) -> None:
    with pytest.raises(mdr.DomainError) as caught:
        ask(digits)
    assert str(caught.value) == f"digits must be a whole number from 1 to 100000, got {digits}"


def test_a_scene_says_the_limit_in_the_same_words() -> None:
    with pytest.raises(mdr.SceneError, match="must be a whole number from 1 to 100000, got 100001"):
        mdr.solve(SCENE | {"output": {"want": ["folds"], "digits": 100_001}})


@pytest.mark.parametrize("ask", DIGITS)
@pytest.mark.parametrize("digits", [20.0, "20", True, Decimal(20)])
def test_digits_are_whole_numbers(ask: Callable[[Any], Any], digits: Any) -> None:
    with pytest.raises(TypeError, match="digits: expected a whole number"):
        ask(digits)


def test_integers_of_numpy_are_digits() -> None:
    assert mdr.kappa(1, digits=np.int32(5)) == Decimal("1.5708") == mdr.kappa(1, digits=np.array(5))


def test_a_text_may_have_a_unit_and_is_exact() -> None:
    plain = mdr.jkr(radius="5e-6", e_star="1e9", work_of_adhesion="0.05").critical(mdr.Machine("0.3"), digits=30)
    ball = mdr.jkr(radius="5 um", e_star="1 GPa", work_of_adhesion="50 mJ/m^2")
    assert ball.critical(mdr.Machine("300 mN/m"), digits=30) == plain
    assert ball.critical(mdr.Machine("0.3 nN/nm")).force == float(plain.force)
    bowl = mdr.Expression("r^2/(2*c)", c="5 um")
    assert np.array_equal(bowl.g([1e-6]), mdr.Expression("r^2/(2*c)", c="5e-6").g([1e-6]))
    assert mdr.effective_modulus("0.75 MPa", "1/2") == 1e6
    with pytest.raises(ValueError, match="stiffness is in N/m; got"):
        mdr.Machine("0.3 nm")
    with pytest.raises(ValueError, match="did you mean `um`"):
        mdr.Paraboloid("5 uM")
