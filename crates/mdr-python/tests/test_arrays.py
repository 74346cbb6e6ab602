"""Arrays: shapes, scalars, statuses, and agreement between the ways to ask."""

import numpy as np
import pytest

import mdr

CONTACTS = [
    mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05),
    mdr.Contact(mdr.PowerLaw(n=0.25, c=1e-6), e_star=1e9, work_of_adhesion=0.05),
    mdr.Contact(mdr.WavyParaboloid(1, 5e-4, 0.1), e_star=1, work_of_adhesion=1e-4),
    mdr.Contact(mdr.Sphere(1e-6), e_star=1e6, work_of_adhesion=0.05),
]


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.profile.kind)
@pytest.mark.parametrize("held", ["indentation", "force", "position"])
def test_scalars_rows_and_matrices_agree(contact: mdr.Contact, held: str) -> None:
    fold = contact.folds("force" if held == "force" else "indentation")[0]
    scale = abs(fold.force if held == "force" else fold.indentation)
    values = np.linspace(-3, 3, 12) * scale
    keywords = {"stiffness": abs(fold.force / fold.indentation)} if held == "position" else {}
    row, matrix = (contact.states(**{held: v}, **keywords) for v in (values, values.reshape(3, 4)))
    both = contact.equilibria(**{held: values.reshape(3, 4)}, **keywords)
    assert matrix.force.shape == (3, 4) and both.force.shape == (3, 4, len(both.stable))
    assert np.array_equal(row.force, matrix.force.reshape(-1), equal_nan=True)
    for i, value in enumerate(values):
        one = contact.states(**{held: value}, **keywords)
        assert isinstance(one.force, float)
        for name in ("contact_radius", "indentation", "force"):
            assert np.array_equal(getattr(one, name), getattr(row, name)[i], equal_nan=True)
        assert one.status == row.status[i]
    # The stable state of the largest radius, taken from all equilibria.
    stable = both.contact_radius[..., both.stable].reshape(12, -1)
    largest = np.where(np.isnan(stable).all(axis=1), np.nan, np.nanmax(np.nan_to_num(stable, nan=-1), axis=1))
    assert np.array_equal(largest, row.contact_radius, equal_nan=True)
    # What is held is held.
    known = ~np.isnan(row.force)
    assert known.any()
    if held == "position":
        reached = row.indentation + row.force / keywords["stiffness"]
        assert np.allclose(reached[known], values[known], rtol=1e-9, atol=1e-12 * scale)
    else:
        assert (getattr(row, held)[known] == values[known]).all()


def test_where_nothing_is_in_equilibrium_is_nan(ball: mdr.Contact) -> None:
    lost = ball.states(force=-1.0)
    assert np.isnan([lost.contact_radius, lost.indentation, lost.force]).all()
    assert lost.status == mdr.Status.NO_EQUILIBRIUM
    strange = ball.states(force=[np.nan, np.inf, 0])
    assert strange.status.tolist() == [mdr.Status.DOMAIN_ERROR, mdr.Status.DOMAIN_ERROR, mdr.Status.OK]
    both = ball.equilibria(force=[-1.0, -2e-7])
    assert both.count.tolist() == [0, 2] and np.isnan(both.force[0]).all()
    outside = mdr.Contact(mdr.Sphere(1), e_star=1, work_of_adhesion=1e-3).curve([0.5, 2, -1])
    assert outside.status.tolist() == [mdr.Status.OK, mdr.Status.DOMAIN_ERROR, mdr.Status.DOMAIN_ERROR]


def test_a_state_with_overlap_is_marked() -> None:
    deep = mdr.Contact(mdr.WavyParaboloid(1, 1e-2, 0.1), e_star=1, work_of_adhesion=1e-6)
    states = deep.equilibria(indentation=np.linspace(0, 0.02, 40))
    assert not states.admissible[np.isfinite(states.force)].all()
    assert mdr.Status.NOT_ADMISSIBLE in deep.states(indentation=np.linspace(0, 0.02, 40), branch="smallest").status


def test_empty_and_integer_arrays(ball: mdr.Contact) -> None:
    assert ball.states(force=[]).force.shape == (0,)
    assert ball.equilibria(force=np.zeros((0, 3))).force.shape == (0, 3, 2)
    assert ball.states(force=np.array([0, 1], dtype=np.int32)).force.tolist() == [0.0, 1.0]
    strided = np.linspace(0, 1e-6, 10)[::2]
    assert ball.states(force=strided).force.tolist() == strided.tolist()


def test_columns_for_pandas(ball: mdr.Contact) -> None:
    columns = ball.states(force=np.zeros((2, 3))).to_dict()
    assert {name: column.shape for name, column in columns.items()} == dict.fromkeys(
        ("contact_radius", "indentation", "force", "status"), (6,)
    )


@pytest.mark.parametrize("control", ["force", "indentation", mdr.Machine(0.1)])
def test_critical_states_are_those_of_contacts(control: mdr.Control) -> None:
    n, radius = np.array([[2.0], [0.25], [-1.0]]), np.array([1e-6, 1e-3])
    many = mdr.critical_states(n=n, c=0.5 / radius, e_star=1e6, work_of_adhesion=0.05, control=control)
    assert many.force.shape == (3, 2) and (many.status[2] == mdr.Status.DOMAIN_ERROR).all()
    for i, j in np.ndindex(2, 2):
        contact = mdr.Contact(mdr.PowerLaw(n[i, 0], 0.5 / radius[j]), e_star=1e6, work_of_adhesion=0.05)
        try:
            one = contact.critical(control)
        except mdr.NoEquilibriumError:
            assert np.isnan(many.force[i, j])
        else:
            assert many.force[i, j] == pytest.approx(one.force, rel=1e-15)
            assert many.contact_radius[i, j] == pytest.approx(one.contact_radius, rel=1e-15)
