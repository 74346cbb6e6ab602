"""nanite model: hyperboloid with adhesion, a rounded cone: any profile of the library goes this way."""
import math

import mdr
import mdr.nanite

globals().update(mdr.nanite.model(
    lambda R, alpha: mdr.Hyperboloid(slope=(t := 1 / math.tan(math.radians(alpha))), lateral=t * R),
    {"R": ("Tip Radius", "m", 50e-9), "alpha": ("Half Cone Angle", "°", 25.0)},
    key="mdr_hyperboloid", name="hyperboloid with adhesion (mdr)"))
