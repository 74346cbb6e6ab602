"""nanite model: sphere (paraboloid) with adhesion, JKR."""
import mdr
import mdr.nanite

globals().update(mdr.nanite.model(
    lambda R: mdr.Paraboloid(radius=R), {"R": ("Tip Radius", "m", 5e-6)},
    key="mdr_jkr_sphere", name="sphere with adhesion (JKR, mdr)"))
