"""Media: builders, contacts on them, and what they lack."""

import math
import pickle
from decimal import Decimal

import numpy as np
import pytest

import mdr

BALL = mdr.Paraboloid(radius=1)
# π²·0.09/2: with E* = λ = h = 1 it is α = 0.3.
WORK = "0.44413219804902113784755209499442680108911647332584"


def wave() -> mdr.Contact:
    return mdr.Contact(mdr.Wave(amplitude=1), medium=mdr.Periodic(wavelength=1), e_star=1, work_of_adhesion=WORK)


def test_pull_off_of_a_ball() -> None:
    for medium, factor in ((mdr.Graded("0.3", coefficient=1), 1.65), (mdr.Winkler(modulus=7), 2)):
        contact = mdr.Contact(BALL, medium=medium, work_of_adhesion="1/100")
        assert contact.pull_off("force").force == pytest.approx(-factor * math.pi * 0.01, rel=1e-11)
        assert contact.critical("force").force == pytest.approx(-factor * math.pi * 0.01, rel=1e-11)
        assert contact.states(force=0.0).force == 0
        assert contact.e_star is None and contact.medium == medium


def test_johnson() -> None:
    off, into = wave().folds("force", digits=20)
    assert off.force == Decimal("-0.30141704831205587646")
    assert into.force == Decimal("1.2180826846725044215")
    assert wave().folds("force")[1].contact_radius == pytest.approx(float(into.contact_radius), rel=1e-9)
    states = wave().states(force=np.array([-0.4, 0.0, 1.0]))
    assert states.status.tolist() == [mdr.Status.NO_EQUILIBRIUM, mdr.Status.OK, mdr.Status.OK]
    assert states.contact_radius[1] == pytest.approx(0.485766904263314938515561698278 / math.pi, rel=1e-12)
    answer = mdr.solve(wave().scene("force", path=["-1", "2"], start="detached", want=["path"]), digits=10)
    assert answer.columns("path")["event"] == ["start", "jump-in", "complete-contact"]
    assert "<svg" in answer.picture().svg


def test_a_line_contact() -> None:
    line = mdr.Contact(BALL, medium=mdr.Plane(), e_star=1, work_of_adhesion="1/100")
    assert line.pull_off("force").force == pytest.approx(-0.0809340396964474671233119722858, rel=1e-11)
    assert math.isnan(line.states(force=0.0).indentation)
    with pytest.raises(mdr.DomainError, match="reference"):
        line.states(indentation=0.0)
    against = mdr.Contact(BALL, medium=mdr.Plane(reference="10 m"), e_star=1, work_of_adhesion="1/100")
    assert against.states(indentation=0.0).status == mdr.Status.OK


def test_media_are_values() -> None:
    for medium in (mdr.Graded("0.3", coefficient=1), mdr.Winkler("5 GPa/m"), mdr.Plane(), mdr.Periodic("1 mm")):
        assert pickle.loads(pickle.dumps(medium)) == medium and hash(medium) == hash(medium)
        profile = mdr.Wave(1) if isinstance(medium, mdr.Periodic) else BALL
        contact = mdr.Contact(profile, medium=medium, e_star=1, work_of_adhesion=1)
        assert pickle.loads(pickle.dumps(contact)) == contact
        assert contact != mdr.Contact(BALL, e_star=1, work_of_adhesion=1)
        assert repr(medium) in repr(contact)


def test_by_moduli() -> None:
    soil = mdr.Graded("0.5", modulus="2 MPa", nu="0.3", depth="1 mm")
    assert mdr.Contact(BALL, medium=soil, work_of_adhesion=1).pull_off("force").force == pytest.approx(-1.75 * math.pi, rel=1e-11)
    thousand = mdr.Graded("0.5", modulus="2 GPa", nu="0.3", depth="1 mm")
    radius = mdr.Contact(BALL, medium=thousand, work_of_adhesion=1000).pull_off("force").contact_radius
    assert radius == pytest.approx(mdr.Contact(BALL, medium=soil, work_of_adhesion=1).pull_off("force").contact_radius)


def test_sensitivity() -> None:
    contact = mdr.Contact(BALL, medium=mdr.Graded("0.3", coefficient="2"), work_of_adhesion="1/100")
    found = contact.sensitivity("force")
    assert set(found) == {"radius", "work_of_adhesion", "medium.coefficient"}
    assert found["work_of_adhesion"].force == pytest.approx(1, abs=1e-9)
    assert found["medium.coefficient"].force == pytest.approx(0, abs=1e-9)


def test_a_fit() -> None:
    contact = mdr.Contact(BALL, medium=mdr.Winkler(modulus=5), work_of_adhesion="1/100")
    depth = np.linspace(0.3, -0.05, 30)
    force = contact.states(indentation=depth).force
    found = mdr.fit(
        depth, force, profile=BALL, observation="F(d)", medium=mdr.Winkler(modulus=1), free=["modulus", "work_of_adhesion"]
    )
    assert found.parameters["modulus"] == pytest.approx(5, rel=1e-6)


def test_what_is_wrong_is_said() -> None:
    for k in (-1, 1, "1.5", math.nan):
        with pytest.raises(mdr.DomainError, match="within \\(-1, 1\\)"):
            mdr.Graded(k, coefficient=1)
    with pytest.raises(mdr.DomainError, match="positive"):
        mdr.Winkler(modulus=0)
    with pytest.raises(mdr.DomainError, match="positive"):
        mdr.Wave(amplitude=-1)
    with pytest.raises(TypeError, match="modulus, nu and depth"):
        mdr.Graded("0.3")
    with pytest.raises(TypeError, match="modulus, nu and depth"):
        mdr.Graded("0.3", coefficient=1, modulus=1)
    with pytest.raises(TypeError, match="e_star is missing"):
        mdr.Contact(BALL, medium=mdr.Plane(), work_of_adhesion=1)  # its modulus is E*
    with pytest.raises(TypeError, match="expected a Medium"):
        mdr.Contact(BALL, medium="winkler", e_star=1, work_of_adhesion=1)  # type: ignore[call-overload]
    with pytest.raises(mdr.SceneError, match="not periodic"):
        mdr.Contact(BALL, medium=mdr.Periodic(1), e_star=1, work_of_adhesion=1)
    with pytest.raises(mdr.SceneError, match="periodic"):
        mdr.Contact(mdr.Wave(1), e_star=1, work_of_adhesion=1)
    with pytest.raises(mdr.SceneError, match="finite range"):
        mdr.Contact(BALL, medium=mdr.Winkler(1), work_of_adhesion=1).validity("1e-9")
