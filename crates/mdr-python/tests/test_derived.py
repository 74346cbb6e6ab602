"""Energies, sensitivities and certified folds against closed forms and against one another."""

from decimal import Decimal

import numpy as np
import pytest

import mdr

BALL = mdr.jkr(radius="1e-6", e_star="1e6", work_of_adhesion="0.05")


def test_energy_has_the_force_as_its_slope() -> None:
    d = np.linspace(-1e-8, 1e-6, 5)
    step = 1e-11
    slope = (BALL.energy(indentation=d + step) - BALL.energy(indentation=d - step)) / (2 * step)
    # Central differences: their truncation, and the rounding of energies of 1e-13 J over the step.
    np.testing.assert_allclose(slope, BALL.states(indentation=d).force, rtol=1e-4)


def test_energy_of_a_sphere() -> None:
    """With (8) and (10) of JKR's theory: Π = (8E*a⁵/15R² of Hertz, relieved of a flat punch) − πwa²."""
    e, w, r = 1e6, 0.05, 1e-6
    a = BALL.states(force=[0.0, 1e-6]).contact_radius
    opening = np.sqrt(2 * np.pi * a * w / e)
    elastic = 8 * e * a**5 / (15 * r**2) - 4 / 3 * e * a**3 / r * opening + e * a * opening**2
    np.testing.assert_allclose(BALL.energy(force=[0.0, 1e-6]), elastic - np.pi * w * a**2, rtol=1e-12)
    assert np.isnan(BALL.energy(force=[-1.0, np.nan])).all()
    assert isinstance(BALL.energy(force=0.0), float)


def test_folds_with_digits() -> None:
    for control in ("force", "indentation", mdr.Machine("0.1")):
        (rough,), (fine,) = BALL.folds(control), BALL.folds(control, digits=30)
        assert isinstance(fine.force, Decimal) and fine.kind == rough.kind
        for name, value in fine.to_dict().items():
            assert getattr(rough, name) == pytest.approx(float(value), rel=1e-14)
    assert BALL.folds("force", digits=30)[0].force == BALL.critical("force", digits=30).force


def test_sensitivities_of_a_power_law() -> None:
    """a ∝ (w/(E* c²))^(1/(2n−1)) and so on: exponents of the closed form, for n = 3."""
    found = mdr.Contact(mdr.PowerLaw(3, "1e9"), e_star="1e6", work_of_adhesion="0.05").sensitivity("indentation")
    assert list(found) == ["c", "e_star", "work_of_adhesion"]
    for name, exponent in {"c": -2, "e_star": -1, "work_of_adhesion": 1}.items():
        state = found[name]
        radius = exponent / 5  # d ∝ c aⁿ and F ∝ E* a d at the fold
        indentation = (name == "c") + 3 * radius
        force = (name == "e_star") + radius + indentation
        assert state.contact_radius == pytest.approx(radius, abs=1e-11)
        assert state.indentation == pytest.approx(indentation, abs=1e-11)
        assert state.force == pytest.approx(force, abs=1e-11)


def test_sensitivity_to_a_machine_and_of_waves() -> None:
    """Results keep their units: sums over inputs with their dimensions are the dimension of the result."""
    stiff = BALL.sensitivity(mdr.Machine("0.1"))
    assert 0 < stiff["stiffness"].contact_radius * -1 < 1
    for name in ("contact_radius", "indentation", "force"):
        by = {key: getattr(state, name) for key, state in stiff.items()}
        # In newtons: E* and w and k are linear in force, a and d have none.
        newtons = by["e_star"] + by["work_of_adhesion"] + by["stiffness"]
        assert newtons == pytest.approx(float(name == "force"), abs=1e-11)
    waves = mdr.Contact(mdr.WavyParaboloid("1", "5e-4", "0.1"), e_star="1", work_of_adhesion="1e-4")
    by_force = {key: state.force for key, state in waves.sensitivity("indentation").items()}
    assert by_force["e_star"] + by_force["work_of_adhesion"] == pytest.approx(1, abs=1e-10)
    with pytest.raises(TypeError, match="no sensitivity"):
        mdr.Contact(mdr.Cone("0.1") + mdr.Paraboloid("1"), e_star=1, work_of_adhesion=1).sensitivity("force")


def test_cases_by_their_inputs() -> None:
    from mdr import testing

    chosen = testing.records("formula=critical control=force quantity=force status=ok", n=2)
    assert len(chosen) > 5 and all(case.values[0].arguments["n"] == 2 for case in chosen)
    with pytest.raises(ValueError, match="no record"):
        testing.records("formula=critical", n=2.0625)
    assert mdr.record("critical/afm-tip/force/force").physical
    assert not mdr.record("critical/jkr-unit/force/force").physical


def test_one_value_is_answered_as_an_array_of_one() -> None:
    waves = mdr.Contact(mdr.WavyParaboloid("1", "5e-4", "0.1"), e_star="1", work_of_adhesion="1e-4")
    for contact, unit in ((BALL, 1e-7), (waves, 1e-3)):
        for held in ("force", "indentation"):
            for value in (0.0, unit, -0.5 * unit, -1e3 * unit, float("nan")):
                for branch in ("largest", "smallest"):
                    one = contact.states(**{held: value}, branch=branch)
                    row = contact.states(**{held: [value]}, branch=branch)
                    for name, column in row.to_dict().items():
                        found = getattr(one, name)
                        assert type(found) is column.dtype.type
                        np.testing.assert_array_equal(found, column[0], err_msg=f"{held}={value} {branch}")
