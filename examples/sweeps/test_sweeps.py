"""The sweeps, on two processes."""

import pathlib
import subprocess
import sys

import numpy as np
import pytest

HERE = pathlib.Path(__file__).parent


def run(name, *arguments):
    done = subprocess.run([sys.executable, HERE / name, *arguments], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_pool():
    lines = run("pool.py").splitlines()
    forces = [float(line.split()[-2]) for line in lines[:7]]
    np.testing.assert_allclose(forces, -1.5 * np.pi * 0.05 * np.geomspace(1e-8, 1e-5, 7), rtol=1e-6)
    assert [line.split(": ")[1] for line in lines[7:]] == [f"fitted, {w:.6f}" for w in (0.03, 0.05, 0.1)]


def test_dask():
    pytest.importorskip("distributed", reason="Dask is not installed: make nanite")
    check(run("dask_cluster.py").split())


def test_dask_elsewhere():
    """A scheduler with an address, as on a real cluster: it is there for the next sweep."""
    distributed = pytest.importorskip("distributed", reason="Dask is not installed: make nanite")
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
        for _ in range(2):
            check(run("dask_cluster.py", cluster.scheduler_address).split())


def check(words):
    # Of a cone under a dead load F = −54 w²/(π E* tan³θ) (Maugis & Barquins).
    made = [-54 * 0.05**2 / (np.pi * 1e6 * slope**3) for slope in (0.1, 0.2, 0.4)]
    np.testing.assert_allclose([float(word) for word in words[0:6:2]], made, rtol=1e-6)
    assert words[6:] == ["fitted", "fitted"]
