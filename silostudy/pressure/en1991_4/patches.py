"""EN 1991-4:2006, patch loads as totals of a method: depth, height, pressure, resultant, and the band of other plans."""

from functools import reduce

import numpy as np

from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import patch
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic
from silostudy.pressure.en1991_4.on_wall import CYLINDER, SEEN, on_cylinder, take
from silostudy.pressure.family import CIRCULAR

SIZES = ("diameter", "cylinder_depth")
# the thin-walled patch leans on a circle; a band goes round any other plan
PLANS = {
    **dict.fromkeys(("patch_depth", "patch_pressure", "patch_resultant"), CIRCULAR),
    "band_pressure": frozenset({"square", "rectangular"}),
    **dict.fromkeys(("patch_height", "patch_load_factor"), CIRCULAR | {"square", "rectangular"}),
}
ECCENTRICITIES = {"filling": ("filling_eccentricity",), "discharge": ("filling_eccentricity", "outlet_eccentricity")}


def totals(phase):
    """The patch load of a phase; e is that of the heap in filling, the larger of heap and outlet in discharge."""
    factor = patch.patch_factor_filling if phase == "filling" else patch.patch_factor_discharge
    names = (*CYLINDER, "patch_factor", *ECCENTRICITIES[phase])
    normal = on_cylinder("wall_normal_pressure", "wall_normal", phase)

    def load_factor(**given):
        largest = reduce(np.maximum, (given[name] for name in ECCENTRICITIES[phase]))
        return factor(eccentricity=largest, **take(given, ("patch_factor", *SIZES)))

    def depth(**given):
        mu, k, _ = characteristic("wall_normal", **take(given, PROPERTIES))
        return patch.patch_depth(mu=mu, k=k, **take(given, ("hydraulic_radius", "cylinder_depth")))

    def value(z, given):
        return load_factor(**given) * normal(z, **take(given, CYLINDER))

    def pressure(**given):
        return value(depth(**given), given)

    def resultant(**given):
        return patch.patch_resultant(pressure(**given), diameter=given["diameter"])

    def band(**given):
        return patch.band_pressure(value(given["cylinder_depth"] / 2, given))

    return {
        "patch_load_factor": asking(
            load_factor, ("patch_factor", *SIZES, *ECCENTRICITIES[phase]), f"C_pf or C_pe (1). {SEEN}", None
        ),
        "patch_depth": asking(depth, CYLINDER, f"Depth (m) of the patch's middle. {SEEN}", None),
        "patch_height": patch.patch_height,
        "patch_pressure": asking(pressure, names, f"Patch pressure (Pa). {SEEN}", None),
        "patch_resultant": asking(resultant, names, f"Resultant (N) of the patch on a thin steel wall. {SEEN}", None),
        "band_pressure": asking(
            band, names, f"Pressure (Pa) all round a plan that is no circle, over the patch's height, at h_c/2. {SEEN}", None
        ),
    }
