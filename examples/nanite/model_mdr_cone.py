"""nanite model: cone with adhesion; alpha is the angle between axis and flank, as in nanite's own cone."""
import math

import mdr
import mdr.nanite

globals().update(mdr.nanite.model(
    lambda alpha: mdr.Cone(slope=1 / math.tan(math.radians(alpha))), {"alpha": ("Half Cone Angle", "°", 25.0)},
    key="mdr_cone", name="cone with adhesion (mdr)"))
