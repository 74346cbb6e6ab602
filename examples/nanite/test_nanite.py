"""The models in nanite, and curves of afmformats in mdr.fit, on curves that are made here: `make nanite`."""

import json
import pathlib
import warnings

import numpy as np
import pytest

import mdr

nanite = pytest.importorskip("nanite", reason="nanite is not installed: make nanite")
afmformats = pytest.importorskip("afmformats")
from nanite.model import load_model_from_file  # noqa: E402

HERE = pathlib.Path(__file__).parent
YOUNG, NU, WORK, SPRING, BASE, CONTACT = 50e3, 0.5, 2e-4, 0.05, 3e-11, 4e-7
E_STAR = YOUNG / (1 - NU**2)
TIPS = {
    "model_mdr_jkr_sphere.py": ("mdr_jkr_sphere", mdr.Paraboloid(radius=5e-6), {"R": 5e-6}, 1e-6),
    "model_mdr_cone.py": ("mdr_cone", mdr.Cone(slope=1 / np.tan(np.radians(70))), {"alpha": 70.0}, 3e-6),
    "model_mdr_hyperboloid.py": (
        "mdr_hyperboloid",
        mdr.Hyperboloid(slope=1 / np.tan(np.radians(70)), lateral=2e-7 / np.tan(np.radians(70))),
        {"R": 2e-7, "alpha": 70.0},
        3e-6,
    ),
}


def columns(profile, depth, noise=2e-11, rows=600, seed=1, work=WORK):
    """Height, force and segment of an approach and a retraction on a cantilever."""
    contact = mdr.Contact(profile, e_star=E_STAR, work_of_adhesion=work)
    position = np.concatenate([np.linspace(-2 * depth, 2 * depth, rows), np.linspace(2 * depth, -2 * depth, rows)])
    trace = contact.follow(position=position, stiffness=SPRING, start="detached")
    force = np.nan_to_num(trace.force) + BASE + np.random.default_rng(seed).normal(0, noise, 2 * rows)
    # afmformats: height = -position + force offset/k, which is a shift of the contact point.
    return {
        "force": force,
        "height (measured)": CONTACT - position,
        "segment": np.repeat([0, 1], rows).astype(np.uint8),
        "time": np.arange(2.0 * rows),
    }


METADATA = {"enum": 0, "imaging mode": "force-distance", "spring constant": SPRING, "sensitivity": 6e-8}


def indentation(**given):
    return nanite.Indentation(data=columns(**given), metadata=METADATA | {"path": pathlib.Path("made")})


def write_tab(path, data):
    """A .tab file as afmformats reads it."""
    head = json.dumps(METADATA | {"point count": len(data["force"]), "software": "mdr"}, indent=2).split("\n")
    lines = ["# BEGIN METADATA", *(f"# {line}" for line in head), "# END METADATA", "#", "# " + "\t".join(data)]
    lines += ["\t".join(repr(cell) for cell in row) for row in zip(*(column.tolist() for column in data.values()))]
    path.write_text("\n".join(lines) + "\n")


def fitted(curve, file, **options):
    key, _, numbers, _ = TIPS[file]
    if key not in nanite.model.models_available:
        load_model_from_file(HERE / file, register=True)
    curve.apply_preprocessing(["compute_tip_position"])
    start = curve.get_initial_fit_parameters(model_key=key)
    for name, value in numbers.items():
        start[name].value = value
    curve.fit_model(model_key=key, params_initial=start, segment="retract", **options)
    return curve.fit_properties["params_fitted"]


# The errors of nanite are those of the residuals; a pull of 4.5 of them in any of nine numbers is one in 15 000 runs.
def pulls(found):
    return [(found[name].value - made) / found[name].stderr for name, made in (("E", YOUNG), ("w", WORK))]


@pytest.mark.parametrize("file", TIPS)
def test_the_models_recover_what_curves_are_made_of(file):
    _, profile, _, depth = TIPS[file]
    found = fitted(indentation(profile=profile, depth=depth), file)
    assert np.abs(pulls(found)).max() < 4.5, found
    assert found["E"].stderr < 0.02 * YOUNG and found["w"].stderr < 0.05 * WORK
    # mdr.fit and nanite agree within their errors, for the same segment.
    curve = indentation(profile=profile, depth=depth)
    with_mdr = mdr.fit(
        **mdr.from_afmformats(curve, legs=["retract"]), profile=profile,
        free=["e_star", "work_of_adhesion", "contact_point", "baseline"],
    )
    assert with_mdr.status == "fitted"
    assert abs(with_mdr["e_star"].value * (1 - NU**2) - found["E"].value) < 4.5 * found["E"].stderr


def test_weight_cp_does_not_fade_out_adhesion():
    file = "model_mdr_jkr_sphere.py"
    _, profile, _, depth = TIPS[file]
    ways = [fitted(indentation(profile=profile, depth=depth), file, weight_cp=weight) for weight in (0, 1e-6)]
    assert ways[0]["w"].value == ways[1]["w"].value


def test_a_pull_off_in_noise_is_said():
    file = "model_mdr_jkr_sphere.py"
    _, profile, _, depth = TIPS[file]
    noise = 1.5 * np.pi * WORK * 5e-6 / 2
    with pytest.warns(UserWarning, match="not told from the noise"):
        fitted(indentation(profile=profile, depth=depth, noise=noise), file)
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message=".*not told from the noise")
        fitted(indentation(profile=profile, depth=depth), file)


def test_files_of_afmformats_are_fitted(tmp_path):
    profile, depth = mdr.Paraboloid(radius=5e-6), 1e-6
    data, path = columns(profile, depth), tmp_path / "curve.tab"
    write_tab(path, data)
    curve = mdr.fit.from_afmformats(path)
    assert (curve.stiffness, curve.sensitivity, curve["observation"]) == (SPRING, 6e-8, "F(D)")
    assert np.array_equal(curve["y"], data["force"]) and np.array_equal(curve["x"], -data["height (measured)"])
    free = ["e_star", "work_of_adhesion", "contact_point", "baseline"]
    for observation in ("F(D)", "delta(D)", "F(d)"):
        given = mdr.from_afmformats(path, observation=observation)
        found = mdr.fit(**given, profile=profile, free=free)
        for name, made in (("e_star", E_STAR), ("work_of_adhesion", WORK)):
            # F(d) has the noise of the force in x as well, which its errors do not know.
            width = 4.5 * found[name].stderr if observation != "F(d)" else 0.02 * made
            assert abs(found[name].value - made) < width, (observation, found)
    assert set(mdr.from_afmformats(path, legs=["approach"])["leg"]) == {"approach"}
    assert set(mdr.from_afmformats(path, legs="retract")["leg"]) == {"retract"}
    # A .tab file has forces, which another spring constant would contradict.
    with pytest.raises(ValueError, match="no other spring constant"):
        mdr.from_afmformats(path, stiffness=0.9 * SPRING)
    with pytest.raises(ValueError, match="index must be below the 1 curves"):
        mdr.from_afmformats(path, index=1)
