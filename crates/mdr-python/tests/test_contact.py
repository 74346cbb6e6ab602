"""Critical states, folds, histories and paths."""

import math
from decimal import Decimal, localcontext

import numpy as np
import pytest

import mdr

R, E, W = 1e-6, 1e6, 0.05


def test_pull_off_of_jkr(ball: mdr.Contact) -> None:
    assert ball.critical("force").force == pytest.approx(-1.5 * math.pi * W * R, rel=4e-16)
    assert ball.critical("indentation").force == pytest.approx(-5 / 6 * math.pi * W * R, rel=4e-16)
    stiff, soft = (ball.critical(mdr.Machine(stiffness)).force for stiffness in (1e9, 1e-9))
    assert stiff == pytest.approx(ball.critical("indentation").force, rel=1e-6)
    assert soft == pytest.approx(ball.critical("force").force, rel=1e-6)


def test_the_critical_state_is_a_fold(ball: mdr.Contact) -> None:
    for control in ("force", "indentation", mdr.Machine(0.1)):
        (fold,) = ball.folds(control)
        critical, pulled = ball.critical(control), ball.pull_off(control)
        assert fold.kind == "minimum"
        for state in (critical, pulled):
            assert state.force == pytest.approx(fold.force, rel=1e-9)
            # The radius of a double root is known to half the digits.
            assert state.contact_radius == pytest.approx(fold.contact_radius, rel=1e-6)


def test_an_equilibrium_obeys_jkr(ball: mdr.Contact) -> None:
    force = np.linspace(-2e-7, 1e-5, 50)
    a = ball.states(force=force).contact_radius
    # Johnson's formula, with the sign of the stable branch.
    p = force + 3 * math.pi * W * R + np.sqrt(6 * math.pi * W * R * force + (3 * math.pi * W * R) ** 2)
    assert np.allclose(a**3, 3 * R / (4 * E) * p, rtol=1e-13)
    assert np.allclose(ball.states(force=force).indentation, a**2 / R - np.sqrt(2 * math.pi * a * W / E), rtol=1e-12)


def test_digits() -> None:
    exact = mdr.jkr(radius="1e-6", e_star="1e6", work_of_adhesion="1/20").critical("force", digits=50)
    assert exact.force == Decimal("-2.3561944901923449288469825374596271631478770495313e-7")
    # A float is what was typed, not the double next to it.
    assert mdr.jkr(1e-6, 1e6, 0.05).critical("force", digits=50) == exact


def test_digits_beyond_doubles() -> None:
    tiny = mdr.Contact(mdr.PowerLaw(n="0.5001", c=1), e_star=10_000, work_of_adhesion="0.05")
    assert tiny.critical("force", digits=5).contact_radius == Decimal("6.0921e-18921")
    with pytest.raises(mdr.OutOfRangeError) as caught:
        tiny.critical("force")
    assert round(caught.value.log10) == -18921 + 1
    assert isinstance(caught.value, OverflowError)
    with localcontext(mdr.context(30)):
        ratio = tiny.critical("force", digits=40).force / tiny.critical("indentation", digits=40).force
    assert ratio > 0


def test_digits_of_any_profile_are_those_of_a_fold(wavy: mdr.Contact) -> None:
    assert wavy.critical("indentation", digits=30).force == Decimal("-0.000106943495831304675418439773734")
    assert wavy.critical("indentation").force == pytest.approx(-0.000106943495831304675, rel=1e-9)


def test_at_one_half_there_is_no_critical_state() -> None:
    with pytest.raises(mdr.NoEquilibriumError, match="1/2"):
        mdr.Contact(mdr.PowerLaw(n="1/2", c="1e-3"), e_star=1e6, work_of_adhesion=0.05).critical("force")


def test_fields_of_jkr(ball: mdr.Contact) -> None:
    state = ball.states(force=1e-6)
    a = state.contact_radius
    r = np.linspace(0, 0.95, 20).reshape(4, 5) * a
    root = np.sqrt(a**2 - r**2)
    jkr = 2 * E / (math.pi * R) * root - np.sqrt(2 * W * E / (math.pi * a)) * a / root
    assert np.allclose(ball.pressure(r, contact_radius=a), jkr, rtol=1e-10)
    outside = np.array([1.5, 2, 4]) * a
    gap, risen = (field(outside, contact_radius=a) for field in (ball.gap, ball.displacement))
    assert (gap > 0).all() and np.allclose(gap, outside**2 / (2 * R) - state.indentation + risen, rtol=1e-10)
    assert np.isnan(ball.pressure(2 * a, contact_radius=a)) and np.isnan(ball.gap(a / 2, contact_radius=a))
    with pytest.raises(mdr.DomainError):
        ball.pressure(0, contact_radius=-1)


def test_a_loop_of_a_wavy_tip(wavy: mdr.Contact) -> None:
    loop = wavy.path(position=[-4e-3, 5e-3, -2e-2], stiffness=5, start="detached")
    assert [event.kind for event in loop.events] == ["start", "jump-in", "way-point", "jump", "detached", "end"]
    assert loop.work == pytest.approx(loop.dissipated, rel=1e-9) and loop.stored == pytest.approx(0, abs=1e-12)
    assert loop.position is not None and loop.position.shape == loop.force.shape
    assert wavy.pull_off("indentation").force > wavy.path(indentation=[0, -0.01]).force.min()


def test_following_is_the_path_at_samples(ball: mdr.Contact) -> None:
    drive = np.concatenate([np.linspace(1e-6, -3e-6, 200), np.linspace(-3e-6, 1e-6, 200)])
    trace = ball.follow(position=drive, stiffness=0.2)
    assert [event.kind for event in trace.jumps] == ["detached", "jump-in"]
    assert trace.force.shape == drive.shape and (trace.status == mdr.Status.OK).all()
    off = drive < trace.jumps[0].value
    assert (trace.force[:200][off[:200]] == 0).all()
    alone = ball.states(position=drive[:200][~off[:200]], stiffness=0.2)
    assert np.allclose(trace.force[:200][~off[:200]], alone.force, rtol=1e-9, atol=1e-20)
    assert np.allclose(drive, trace.indentation + trace.force / 0.2, rtol=1e-9, atol=1e-18)


def test_one_value_is_followed(ball: mdr.Contact) -> None:
    trace = ball.follow(force=0.0)
    assert np.shape(trace.force) == () and trace.status == mdr.Status.OK


def test_a_dead_load_falls_without_end(ball: mdr.Contact) -> None:
    pulled = ball.path(force=[0, -1e-6])
    assert [event.kind for event in pulled.events] == ["start", "detached", "end"]
    assert math.isinf(pulled.dissipated) and math.isnan(pulled.stored)


def test_a_measured_tip() -> None:
    r = np.linspace(0, 200e-9, 101)
    smooth = mdr.Contact(mdr.Table(r, r**2 / 200e-9), e_star=2e9, work_of_adhesion=0.05)
    paraboloid = mdr.jkr(100e-9, 2e9, 0.05)
    assert smooth.critical("force").force == pytest.approx(paraboloid.critical("force").force, rel=1e-3)
    assert np.allclose(smooth.profile.g([1e-8, 1e-7]), paraboloid.profile.g([1e-8, 1e-7]), rtol=1e-2)
    assert np.isnan(smooth.profile.g(1e-6))


def test_every_profile_answers() -> None:
    profiles = [
        mdr.PowerLaw(n=3, c=1), mdr.Paraboloid(1), mdr.Cone("0.1"), mdr.Sphere(1), mdr.Ellipsoid(1, 2), mdr.FlatPunch(1),
        mdr.TruncatedCone(0.1, 1), mdr.TruncatedParaboloid(1, 0.1), mdr.ConeParabolicCap(0.1, 1),
        mdr.ConeSphericalCap(0.1, 1), mdr.Hyperboloid(1, 1), mdr.RoundedPunch(1, 0.1), mdr.DisplacedParaboloid(1, 0.1),
        mdr.ParabolicDimple(1e-4, 1), mdr.EllipticalDimple(1e-4, 1), mdr.WavyParaboloid(1, -1e-5, 0.1),
        mdr.Paraboloid(1) + mdr.Cone(0.1) + mdr.PowerLaw(4, 1), mdr.Expression("r^2/(2*R)", R=1),
    ]
    for profile in profiles:
        contact = mdr.Contact(profile, e_star=1, work_of_adhesion="1e-3")
        assert repr(contact).startswith(f"Contact({type(profile).__name__}(")
        assert np.isfinite(profile.g(0.01)), profile
        assert contact.folds("force"), profile
        state = contact.curve(0.01)
        assert state.force == pytest.approx(2 * (0.01 * state.indentation - profile.integral(0.01)), abs=1e-12)


def test_effective_modulus() -> None:
    assert mdr.effective_modulus(1, 0) == 1
    assert mdr.effective_modulus(2, 0.5, 2, 0.5) == pytest.approx(4 / 3)
    for bad in ((0, 0.3), (1, 0.6), (1, -1)):
        with pytest.raises(mdr.DomainError):
            mdr.effective_modulus(*bad)
