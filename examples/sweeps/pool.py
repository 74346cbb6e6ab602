"""A sweep on all cores: contacts go to other processes, and states come back."""

from concurrent.futures import ProcessPoolExecutor

import numpy as np

import mdr


def pull_off(tip: mdr.Contact) -> float:
    """The pull-off force under a dead load, in N."""
    return tip.critical("force").force


def fitted(curve: tuple[np.ndarray, np.ndarray]) -> mdr.Fit:
    """E* and w of a curve, force against depth."""
    return mdr.fit(*curve, profile=mdr.Paraboloid(radius=1e-6), observation="F(d)", free=["e_star", "work_of_adhesion"])


def curve(w: float) -> tuple[np.ndarray, np.ndarray]:
    """A retraction in contact."""
    depth = np.linspace(1e-7, -5e-8, 50)
    return depth, mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=w).states(indentation=depth).force


def main() -> None:
    radii = np.geomspace(1e-8, 1e-5, 7)
    tips = [mdr.jkr(radius=radius, e_star=1e6, work_of_adhesion=0.05) for radius in radii]
    works = [0.03, 0.05, 0.1]
    # A contact goes to a process in microseconds; a chunk of them makes up for the way where an answer takes no longer.
    with ProcessPoolExecutor(max_workers=2) as pool:
        forces = list(pool.map(pull_off, tips, chunksize=4))
        fits = list(pool.map(fitted, map(curve, works)))
    for radius, force in zip(radii, forces):
        print(f"R = {radius:.2e} m: {force:.6e} N")
    for w, fit in zip(works, fits):
        print(f"w = {w} J/m²: {fit.status}, {fit['work_of_adhesion'].value:.6f}")


if __name__ == "__main__":
    main()
