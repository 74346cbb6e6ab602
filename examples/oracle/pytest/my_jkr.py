"""A small code to be tested; put yours in its place."""

import math


def pull_off_force(n: float, c: float, work_of_adhesion: float) -> float | None:
    """The pull-off force of a sphere, r²/2R = c r², under a dead load: -(3/2) π w R. None for another profile."""
    return -0.75 * math.pi * work_of_adhesion / c if n == 2 else None


def contact_radius(n: float, c: float, e_star: float, work_of_adhesion: float, force: float) -> float | None:
    """The stable contact radius of a sphere under a dead load, NaN below the pull-off force."""
    if n != 2:
        return None
    radius = 0.5 / c
    load = 2 * math.pi * work_of_adhesion * radius
    root = 1 + 4 / 3 * force / load
    if root < 0:
        return math.nan
    length = math.cbrt(2 * math.pi * work_of_adhesion / e_star) * math.cbrt(radius) ** 2
    return length * (0.75 * (1 + math.sqrt(root))) ** (2 / 3)
