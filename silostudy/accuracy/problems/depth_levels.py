"""Number of depth levels that a wall force and a largest pressure need."""

import numpy as np
from scipy.optimize import minimize_scalar

from silostudy.pressure import janssen, jenike_mass_flow
from silostudy.pressure.calls import call

LEVELS = (3, 5, 9, 17, 33, 65, 129, 257, 513, 1025)
LADDERS = {"even levels": LEVELS}
DEPTH = 18.0  # m
SILOS = 200  # from stubby to slender, in one call
SILO: dict = {
    "unit_weight": 8000.0, "hydraulic_radius": np.geomspace(0.5, 5.0, SILOS)[:, None], "wall_friction": 0.4,
    "lateral_pressure_ratio": 0.45, "poisson_ratio": 0.3, "cylinder_depth": DEPTH, "slot": 0.0,
}  # fmt: skip


def prepare(ladder: str, setting: float):
    """Both pressures at even levels from the surface to the foot; the force by the trapezoidal rule."""

    def run():
        z = np.linspace(0.0, DEPTH, int(setting))
        traction = call(janssen.friction_traction, z, SILO)
        return {
            "wall_force": np.trapezoid(traction, z),
            "peak_pressure": call(jenike_mass_flow.envelope_pressure, z, SILO).max(axis=1),
        }

    return run


def reference():
    """Wall force as the weight less what the vertical pressure passes on, and the peak by a bounded search."""
    radius = SILO["hydraulic_radius"]
    carried = (SILO["unit_weight"] * DEPTH - call(janssen.vertical_pressure, DEPTH, SILO)) * radius
    peaks = np.array([_peak({**SILO, "hydraulic_radius": size}) for size in radius[:, 0]])
    return {"wall_force": carried[:, 0], "peak_pressure": peaks}


def _peak(silo) -> float:
    """Largest pressure (Pa): between the neighbours of the largest of many, or at the foot."""
    z = np.linspace(0.0, DEPTH, 2049)
    k = int(np.argmax(call(jenike_mass_flow.envelope_pressure, z, silo)))
    near = (z[max(k - 1, 0)], z[min(k + 1, z.size - 1)])
    inside = minimize_scalar(
        lambda z: -float(call(jenike_mass_flow.envelope_pressure, z, silo)), bounds=near, method="bounded",
        options={"xatol": 1e-12},
    )  # fmt: skip
    return max(-inside.fun, float(call(jenike_mass_flow.envelope_pressure, DEPTH, silo)))
