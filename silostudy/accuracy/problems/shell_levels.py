"""Number of depth levels that the axial force and the utilisation of a wall of strakes need."""

import numpy as np
from scipy.optimize import minimize_scalar

from silostudy.accuracy.problems.shell_strength import STEEL
from silostudy.buckling import en1993_4_1
from silostudy.buckling.thickness import with_thickness
from silostudy.pressure import jenike_mass_flow
from silostudy.pressure.calls import call
from silostudy.pressure.quadrature import from_surface

LEVELS = (5, 9, 17, 33, 65, 129, 257, 513, 1025)
LADDERS = {"even levels": LEVELS}
RULE = en1993_4_1.ROWS[-1]  # the latest edition
SAFETY = 1.65  # buckling stress over the allowable one
DEPTH = 20.0  # m
SILOS = 12  # from stubby to slender, in one call
RADIUS = np.geomspace(1.6, 8.0, SILOS)[:, None]  # m
SOLID: dict = {
    "unit_weight": 9e3, "hydraulic_radius": RADIUS / 2, "wall_friction": 0.44, "lateral_pressure_ratio": 0.54,
    "poisson_ratio": 0.4, "cylinder_depth": DEPTH, "slot": 0.0,
}  # fmt: skip
STRAKES = ((0.3, 0.4), (0.55, 0.6), (0.8, 0.8), (1.0, 1.0))  # lower edge over the depth, thickness over the last one's
SLENDER = 400.0  # R/t of the last strake
GAUSS = np.polynomial.legendre.leggauss(100)
WALL = {
    **STEEL, "shell_poisson_ratio": 0.3, "ring_area": 0.0, "fabricated": True, "safe_constants": False, "bay_length": DEPTH,
    "end_factor": 1.0, "inner_radius": RADIUS,
}  # fmt: skip


def prepare(ladder: str, setting: float):
    """Jenike's envelope in discharge at even levels from the surface to the foot, his traction summed by trapezoids."""

    def run():
        z = np.linspace(0.0, DEPTH, int(setting))
        traction = call(jenike_mass_flow.envelope_traction, z, SOLID)
        force = from_surface(traction, np.broadcast_to(z, traction.shape))
        edges = np.array([edge for edge, _ in STRAKES]) * (1 + 1e-9)  # an edge belongs to the strake above it
        share = np.array([share for _, share in STRAKES])[np.searchsorted(edges, z / DEPTH)]
        used = _utilisation(z, force, share, SOLID, WALL)
        return {"axial_wall_force": force[:, -1], "utilisation": used.max(axis=1)}

    return run


def _utilisation(z, force, share, solid, wall):
    """Stress over strength (1), with the safety factor; only the static pressure is sure to help."""
    upper = call(jenike_mass_flow.envelope_pressure, z, solid)
    lower = np.minimum(call(jenike_mass_flow.ROW.static, z, solid), upper)
    thickness = share * wall["inner_radius"] / SLENDER
    given = {**wall, "lower_internal_pressure": lower, "upper_internal_pressure": upper}
    return SAFETY * force / thickness / with_thickness(RULE, given, thickness)["buckling_stress"]


def reference():
    """The force by Gauss' rule; the largest utilisation by a bounded search in every strake."""
    shells = [({**SOLID, "hydraulic_radius": radius / 2}, {**WALL, "inner_radius": radius}) for radius in RADIUS[:, 0]]
    force = [_force(DEPTH, solid) for solid, _ in shells]
    return {"axial_wall_force": np.array(force), "utilisation": np.array([_largest(*shell) for shell in shells])}


def _force(z: float, solid: dict) -> float:
    nodes, weights = GAUSS
    return float(z / 2 * weights @ call(jenike_mass_flow.envelope_traction, z / 2 * (nodes + 1), solid))


def _largest(solid: dict, wall: dict) -> float:
    parts, top = [], 0.0
    for edge, share in STRAKES:
        ends = (top * DEPTH, edge * DEPTH)

        def used(z, share=share):
            return float(_utilisation(z, _force(z, solid), share, solid, wall))

        inside = minimize_scalar(lambda z, used=used: -used(z), bounds=ends, method="bounded", options={"xatol": 1e-10})
        parts += [used(edge * DEPTH), -inside.fun]
        top = edge
    return max(parts)
