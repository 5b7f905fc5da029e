"""The thickness that an axial force asks for over the halvings of its search."""

from decimal import Decimal, localcontext

import numpy as np

from silostudy.accuracy.problems.shell_strength import HOOP, RULE, STEEL, exact
from silostudy.buckling.thickness import STOCKIEST, required_thickness, with_thickness

LADDERS = {"halvings of log R/t": (5, 8, 11, 14, 18, 22, 27, 33, 40)}
SHELLS = 24  # walls that are compared
MANY = 50  # times that they stand in the call that is timed
SAFETY = 1.65  # buckling stress over the allowable one
DIGITS = 30  # of the exact answer
UNUSED: dict = {
    "shell_poisson_ratio": 0.3, "ring_area": 0.0, "bay_length": 1.0, "end_factor": 1.0, "fabricated": True,
    "safe_constants": False,
}  # by this rule  # fmt: skip


def walls() -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Parameters of walls to be, and axial forces (N/m): those of silos of 3 to 30 m, from 3 to 30 m deep."""
    random = np.random.default_rng(1)
    radius = np.geomspace(1.5, 15.0, SHELLS)
    upper = random.uniform(1.0, 2.0, SHELLS) * 7e3 * radius
    given = {name: np.full(SHELLS, value) for name, value in STEEL.items()}
    given |= {"inner_radius": radius}
    given |= {"lower_internal_pressure": HOOP[1] * upper, "upper_internal_pressure": upper}
    return given, random.uniform(2.0, 8.0, SHELLS) * 9e3 * radius**1.5


def prepare(ladder: str, setting: float):
    """All walls in one search, and the strength of the walls that it finds."""
    given, force = walls()
    given, force = {name: np.tile(values, MANY) for name, values in given.items()}, np.tile(force, MANY)

    def run():
        thickness = required_thickness(RULE, given | UNUSED, force, SAFETY, int(setting))[0]
        strength = with_thickness(RULE, given | UNUSED, thickness)["buckling_stress"]
        return {"required_thickness": thickness[:SHELLS], "strength": strength[:SHELLS]}

    return run


def reference():
    """Regula falsi (Illinois) on the strength by decimals of 30 digits, from the stockiest wall downward."""
    given, force = walls()
    thickness, strength = np.empty((2, SHELLS))
    with localcontext() as context:
        context.prec = DIGITS
        for k in range(SHELLS):
            numbers = {name: Decimal(float(values[k])) for name, values in given.items()}
            load = Decimal(float(force[k])) * Decimal(SAFETY)
            root = _root(lambda t, numbers=numbers, load=load: _strength(t, numbers) * t / load - 1, numbers["inner_radius"])
            thickness[k], strength[k] = root, _strength(root, numbers)
    return {"required_thickness": thickness, "strength": strength}


def _strength(thickness: Decimal, wall: dict[str, Decimal]) -> Decimal:
    own = {name: value for name, value in wall.items() if name != "inner_radius"}
    return exact(**own, thickness=thickness, shell_radius=wall["inner_radius"] + thickness / 2)


def _root(spare, radius: Decimal) -> Decimal:
    """Thickness (m) where the spare strength vanishes."""
    thick = radius / STOCKIEST
    thin = thick / 2
    while spare(thin) > 0:
        thick, thin = thin, thin * Decimal("0.8")
    low, high = spare(thin), spare(thick)
    while abs(thick / thin - 1) > Decimal("1e-20"):
        middle = thin - low * (thick - thin) / (high - low)
        value = spare(middle)
        if value * high <= 0:
            thin, low = thick, high
        else:
            low /= 2
        thick, high = middle, value
        if value == 0:
            break
    return thick
