"""The fronts of shell studies: depth levels for the axial force at the foot, and for the thickness that a wall must have.

References: Gauss-Legendre panels for the force; the rule's own thickness under that force.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from silostudy.accuracy.fronts_levels import PANELS, Curve, LevelQuantity, expansion_of, rows_of, spoken, studies, trials_of
from silostudy.accuracy.trial import Trial
from silostudy.buckling import BUCKLING
from silostudy.buckling.thickness import required_thickness
from silostudy.choice.pressure import jump_number, smooth_number
from silostudy.pressure.quadrature import from_surface
from silostudy.scene.expand import Expansion

MEASURED = 30  # silos with every method
UNSEEN = 60  # studies of up to three methods
STEEL = {"youngs_modulus_GPa": 210.0, "yield_stress_MPa": 235.0, "quality": "B", "manufacture": "fabricated"}


@dataclass(frozen=True, eq=False)
class Rubbed(Curve):
    """The friction (Pa) that is summed to the axial force: the method's own, or wall friction times its pressure."""

    pressure: Callable
    own: bool
    rule: str
    wall: dict[str, float]

    def __call__(self, z):
        rubbed = super().__call__(z)
        return rubbed if self.own else self.parameters["wall_friction"] * rubbed

    def thickness(self, z: np.ndarray, force: np.ndarray) -> float:
        """The largest thickness (m) that the rule asks for at these depths (m) under these forces (N/m)."""
        inside = np.broadcast_to(Curve(self.pressure, self.parameters, self.depth)(z), z.shape)
        given = {**self.wall, "lower_internal_pressure": inside, "upper_internal_pressure": inside}
        return float(np.nanmax(required_thickness(BUCKLING[self.rule], given, force, self.wall["safety_factor"])[0]))


def curves(expansion: Expansion) -> list[Rubbed]:
    """Curves that are summed, of every method that has no axial force of its own."""
    scene = expansion.cases[0].scene
    wall = {**scene.shell.steel, "inner_radius": scene.silo.diameter / 2, "ring_area": 0.0, "bay_length": scene.silo.wall_depth,
            "total_length": scene.silo.wall_depth,
            "safety_factor": scene.shell.safety_factor}  # fmt: skip
    curves = []
    for functions, parameters in spoken(expansion):
        if "axial_wall_force" in functions or not np.isfinite(parameters["wall_friction"]):
            continue
        own = "wall_friction_traction" in functions
        function = functions["wall_friction_traction" if own else "wall_normal_pressure"]
        for rule in expansion.study.rule_keys:
            pressure = functions["wall_normal_pressure"]
            curves.append(Rubbed(function, parameters, scene.silo.cylinder_depth, pressure, own, rule, wall))
    return [curve for curve in curves if curve.whole]


def thick(expansion: Expansion) -> list[Rubbed]:
    """The curves for which the rule gives a thickness at the foot."""
    with np.errstate(all="ignore"):
        return [curve for curve in curves(expansion) if np.isfinite(curve.thickness(*at_the_foot(curve)))]


def at_the_foot(curve: Rubbed) -> tuple[np.ndarray, np.ndarray]:
    """Depth (m) and axial force (N/m) there."""
    return np.array([curve.depth]), curve.integrals()[-1:]


def exact_thickness(curve: Rubbed) -> float:
    """Largest (m) over the ends of the panels, the foot among them."""
    return curve.thickness(curve.depth * (np.arange(PANELS) + 1.0) / PANELS, curve.integrals())


def force(curve: Rubbed, count: int) -> float:
    """Axial force (N/m) at the foot, by trapezoids."""
    return float(_summed(curve, count)[1][-1])


def thickness(curve: Rubbed, count: int) -> float:
    """The largest (m) over even levels."""
    return curve.thickness(*_summed(curve, count))


def _summed(curve: Rubbed, count: int) -> tuple[np.ndarray, np.ndarray]:
    z = np.linspace(0.0, curve.depth, count)
    return z, from_surface(curve(z), z)


NUMBERS = {"smooth_number": smooth_number, "jump_number": jump_number}
ASKED = (1.5e-3, 0.1)  # where friction jumps, an error goes with the step itself
FLAT = {"heap": (0.0, 0.0)}  # above the wall's contact the friction begins with a step
QUANTITIES = (
    LevelQuantity("shell", "axial_wall_force", curves, lambda curve: float(curve.integrals()[-1]), force, NUMBERS, FLAT, ASKED),
    LevelQuantity("shell", "required_thickness", thick, exact_thickness, thickness, NUMBERS, FLAT, ASKED),
)


def walled(contents: Iterator[dict], seed: int) -> Iterator[dict]:
    """The circular silos among them, each with a steel wall and a buckling rule."""
    random = np.random.default_rng(seed)
    for content in contents:
        if content["scene"]["silo"]["plan"] == "circular":
            shell = {**STEEL, "safety_factor": 1.65}
            scene = {**content["scene"], "shell": shell}
            yield {**content, "kind": "shell", "scene": scene, "rules": [str(random.choice(list(BUCKLING)))]}


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv."""
    silos = [expansion_of(content, relative_depth=[0.0, 1.0]) for content in walled(studies(10, 3 * MEASURED), 10)]
    return [row for quantity in QUANTITIES for row in rows_of(quantity, silos, tell)]


def trials(tell: Callable[[str], None]) -> list[Trial]:
    """Trials of the shipped fronts' choices on studies that they were not measured on."""
    return [trial for quantity in QUANTITIES for trial in trials_of(quantity, walled(studies(11, 3 * UNSEEN, 3), 11), tell)]
