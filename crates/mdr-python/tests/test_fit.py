"""Fits, and whether the theory holds."""

import json
import pickle
from typing import Any

import numpy as np
import pytest

import mdr

RADIUS, E_STAR, WORK = 1e-5, 2e6, 0.05


@pytest.fixture
def curve() -> tuple[mdr.Floats, mdr.Floats]:
    """A retraction with noise of 1 % of the pull-off force."""
    ball = mdr.jkr(radius=RADIUS, e_star=E_STAR, work_of_adhesion=WORK)
    depth = np.linspace(2e-6, -1e-6, 150)
    force = ball.follow(indentation=depth).force
    noise = np.random.default_rng(1).normal(0, 0.01 * 1.5 * np.pi * WORK * RADIUS, len(depth))
    return depth, np.nan_to_num(force) + noise


def test_estimates_are_within_their_errors(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    found = mdr.fit(
        *curve, profile=mdr.Paraboloid(radius=RADIUS), observation="F(d)", free=["e_star", "work_of_adhesion", "baseline"]
    )
    assert found.status == "fitted"
    for name, truth in {"e_star": E_STAR, "work_of_adhesion": WORK, "baseline": 0.0}.items():
        each = found[name]
        assert each.value is not None and each.stderr is not None
        assert abs(each.value - truth) < 4 * each.stderr, name
        assert (found.parameters[name], found.stderr[name]) == (each.value, each.stderr)
    assert found.covariance.shape == found.correlation.shape == (3, 3)
    assert np.diag(found.covariance) == pytest.approx([each.stderr**2 for each in found.estimates if each.stderr])
    assert np.diag(found.correlation) == pytest.approx(1)
    assert found.residuals.shape == found.labels.shape == found.contact_radius.shape == curve[0].shape
    assert (found.labels == -1).any() and (np.isnan(found.contact_radius) == (found.labels == -1)).all()
    assert json.loads(found.to_json())["schema"] == "mdr.fit/1"
    assert "e_star" in repr(found) and "fitted, 150 rows" in repr(found)
    assert "<svg" in found.plot().svg and "<table" in found._repr_html_()
    assert found.validity is None


def test_what_data_cannot_tell_has_no_number(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    free = ["e_star", "work_of_adhesion", "radius"]
    found = mdr.fit(*curve, profile=mdr.Paraboloid(radius=RADIUS), observation="F(d)", free=free)
    assert found.status == "unidentifiable" and found.reason
    assert set(found.parameters.values()) == {None} and len(found.invariants) == 2
    assert found.covariance.shape == (0, 0)
    assert "determined: " in repr(found)


def test_a_fit_says_whether_the_theory_holds(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    profile = mdr.Paraboloid(radius=RADIUS)
    found = mdr.fit(*curve, profile=profile, observation="F(d)", range_of_adhesion="0.3 nm")
    assert found.validity is not None and found.validity["regime"] == "JKR"
    alone = mdr.jkr(radius=RADIUS, e_star=E_STAR, work_of_adhesion=WORK).validity(0.3e-9)
    assert found.validity["tabor"] == pytest.approx(alone["tabor"], rel=0.05)


def test_intervals_by_profile_likelihood(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    tip = mdr.Paraboloid(radius=RADIUS)
    found = mdr.fit(*curve, profile=tip, observation="F(d)", profile_likelihood=True)
    assert [(each.name, each.level) for each in found.intervals] == [
        (name, level) for name in ("e_star", "work_of_adhesion") for level in (0.68, 0.95)
    ]
    for each in found.intervals:
        estimate = found[each.name]
        assert estimate.value and estimate.stderr and each.lower and each.upper
        quantile = 0.998 if each.level == 0.68 else 1.976  # Student's t with 148 degrees of freedom
        # Nearly linear: the ends are those of the standard errors, to a few per cent.
        assert each.upper - estimate.value == pytest.approx(quantile * estimate.stderr, rel=0.05)
        assert estimate.value - each.lower == pytest.approx(quantile * estimate.stderr, rel=0.05)
    assert mdr.fit(*curve, profile=tip, observation="F(d)").intervals == ()


@pytest.mark.skipif(not mdr.CERTIFIED, reason="a build without certified digits")
def test_certified_digits_of_a_fit(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    tip = mdr.Paraboloid(radius=RADIUS)
    found = mdr.fit(*curve, profile=tip, observation="F(d)", sigma_x=0, digits=25)
    assert found.certified, found.warnings
    for each in found.certified:
        assert len(each.value.as_tuple().digits) == 25
        assert float(each.value) == pytest.approx(found[each.name].value, rel=1e-9)
        assert float(each.scaled_stderr) == pytest.approx(found[each.name].scaled_stderr, rel=1e-6)


def test_bad_data_are_refused(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    x, y = curve
    tip = mdr.Paraboloid(radius=RADIUS)
    with pytest.raises(ValueError, match="as many rows"):
        mdr.fit(x, y[:-1], profile=tip, observation="F(d)")
    with pytest.raises(ValueError, match="finite"):
        mdr.fit(x, np.full_like(y, np.nan), profile=tip, observation="F(d)")
    with pytest.raises(mdr.SceneError):
        mdr.fit(x[:1], y[:1], profile=tip, observation="F(d)")
    with pytest.raises(mdr.SceneError, match="e_star"):
        mdr.fit(x, y, profile=tip, observation="F(d)", free=["e_sta"])


def test_a_scene_and_a_contact_say_it() -> None:
    tip = mdr.jkr(radius="1e-8", e_star="5e9", work_of_adhesion="0.05")
    holds = tip.validity("0.3 nm", digits=20)
    assert str(holds["tabor"]) == "0.33333333333333333333" and holds["regime"] == "transition"
    scene = tip.scene("indentation", want=["folds"])
    scene["material"]["range_of_adhesion"] = 3e-10
    answer = mdr.solve(scene, f64=True)
    assert answer.validity == tip.validity(3e-10) and answer.promise["validity"] == "f64"
    assert mdr.solve(tip.scene("force", want=["folds"])).validity is None
    with pytest.raises(mdr.SceneError, match="range_of_adhesion"):
        tip.validity(0)


class _Axes:
    """What a plot needs of the axes of matplotlib."""

    def __init__(self) -> None:
        self.lines: list[tuple[str | None, int]] = []

    def plot(self, x: mdr.Floats, y: mdr.Floats, *_: str, **look: Any) -> None:
        assert len(x) == len(y) > 0
        self.lines.append((look["label"], look["zorder"]))

    def set_xlabel(self, text: str) -> None:
        assert "m" in text

    def set_ylabel(self, text: str) -> None:
        assert "N" in text

    def legend(self) -> None:
        pass


def test_rows_that_do_not_count_and_columns_of_a_fit(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    x, y = (column.copy() for column in curve)
    y[3] = np.nan
    given: dict[str, Any] = {"profile": mdr.Paraboloid(radius=1e-5), "observation": "F(d)"}
    with pytest.raises(ValueError, match="missing='skip'"):
        mdr.fit(x, y, **given)
    lowest = float(np.sort(x)[1])
    found = mdr.fit(x, y, missing="skip", rows={"x": (lowest, 1.0)}, time=np.arange(len(x)), **given)
    assert found.skipped == {"not a number": 1, "outside of x": 1}
    assert len(found.x) == len(x) - 2 == len(found.fitted)
    sigma = json.loads(found.to_json())["sigma"][1]
    np.testing.assert_allclose((found.fitted - found.y) / sigma, found.residuals, rtol=1e-6, atol=1e-9)
    assert found.quantities["adhesion_force"]["unit"] == "N"
    assert found.budget["work_of_adhesion", "radius"] < 0.0
    assert list(found._columns()) == ["x", "y", "leg", "label", "fitted", "residual", "contact_radius", "pinned"]
    axes = _Axes()
    assert found.plot(axes) is axes
    orders = dict(axes.lines)
    assert orders["fit"] > orders["in contact, retract"]


def test_two_works_of_adhesion_may_be_given(curve: tuple[mdr.Floats, mdr.Floats]) -> None:
    x, y = curve
    found = mdr.fit(
        x,
        y,
        profile=mdr.Paraboloid(radius=1e-5),
        observation="F(d)",
        free=["e_star", "receding"],
        work_of_adhesion={"advancing": 0},
        legs="retract",
    )
    assert found["receding"].name == "work_of_adhesion.receding"
    assert found.legs[0]["leg"] == "retract"
    with pytest.raises(mdr.SceneError, match="named twice"):
        mdr.fit(x, y, profile=mdr.Paraboloid(radius=1e-5), observation="F(d)", free=["e_star", "e_star"])


def test_a_fit_is_pickled() -> None:
    """Another process gets the whole answer, with its picture."""
    ball = mdr.jkr(radius=1e-5, e_star=2e6, work_of_adhesion=0.05)
    depth = np.linspace(2e-6, -2e-7, 12)
    found = mdr.fit(depth, ball.states(indentation=depth).force, profile=mdr.Paraboloid(radius=1e-5), observation="F(d)")
    again = pickle.loads(pickle.dumps(found))
    assert repr(again) == repr(found) and again.to_json() == found.to_json()
    assert again.plot()._repr_svg_() == found.plot()._repr_svg_()
    np.testing.assert_array_equal(again.residuals, found.residuals)
    answer = json.loads(found.to_json())
    assert [row["y"] for row in answer["rows"]] == found.y.tolist()
    assert [row["leg"] for row in answer["rows"]] == list(found.leg)


def test_rows_without_numbers_take_their_legs_with_them() -> None:
    ball = mdr.jkr(radius=1e-5, e_star=2e6, work_of_adhesion=0.05)
    depth = np.r_[np.linspace(0, 2e-6, 8), np.linspace(2e-6, -2e-7, 12)]
    force = ball.states(indentation=depth).force
    force[3] = np.nan
    leg = ["extend"] * 8 + ["withdraw"] * 12
    problem = {"profile": mdr.Paraboloid(radius=1e-5), "observation": "F(d)"}
    found = mdr.fit(depth, force, leg=leg, missing="skip", **problem)
    assert found.skipped == {"not a number": 1} and found.leg.count("approach") == 7
    with pytest.raises(ValueError, match=r"leg\[19\]"):
        mdr.fit(depth, force, leg=[*leg[:-1], "pause"], missing="skip", **problem)


def test_rows_may_begin_between_two_words() -> None:
    """As arrays do that come from another process."""

    def shifted(column: mdr.Floats) -> mdr.Floats:
        moved = np.frombuffer(b"." + column.tobytes(), dtype=np.float64, offset=1)
        assert not moved.flags.aligned
        return moved

    ball = mdr.jkr(radius=1e-5, e_star=2e6, work_of_adhesion=0.05)
    depth = np.linspace(2e-6, -2e-7, 12)
    force = ball.states(indentation=shifted(depth)).force
    np.testing.assert_array_equal(force, ball.states(indentation=depth).force)
    tip = mdr.Paraboloid(radius=1e-5)
    found = mdr.fit(shifted(depth), shifted(force), profile=tip, observation="F(d)")
    np.testing.assert_array_equal(found.x, depth)
    assert found.parameters == mdr.fit(depth, force, profile=tip, observation="F(d)").parameters
