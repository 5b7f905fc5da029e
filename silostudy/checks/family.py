"""The row of a check of the steel beside axial buckling: an effect, what resists it, and a wall that just does."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from inspect import signature

import numpy as np

from silostudy.catalogue import Row
from silostudy.limits import Limit, Measure
from silostudy.soundness import faults_of_function, faults_of_trial

# parts of the silo that checks are made of, and where their numbers stand
WALL = "wall"
HOPPER = "hopper"
SUPPORT = "support"
PARTS = (WALL, HOPPER, SUPPORT)

# Every parameter that a check may ask for: (unit, symbol and meaning, a usual value).  Actions hold their partial factors.
PARAMETERS = {
    "yield_stress": ("Pa", "f_y", 235e6),
    "ultimate_stress": ("Pa", "f_u", 360e6),
    "youngs_modulus": ("Pa", "E", 210e9),
    "fabrication_quality": ("1", "Q, 40, 25, 16 for classes A, B, C", 25.0),
    "joint_efficiency": ("1", "j, strength of the vertical welds over that of the plate", 1.0),
    "partial_yield": ("1", "gamma_M0", 1.0),
    "partial_buckling": ("1", "gamma_M1", 1.1),
    "partial_joint": ("1", "gamma_M2", 1.25),
    "inner_radius": ("m", "R_i", 5.0),
    "thickness": ("m", "t", 0.01),
    "wall_height": ("m", "l, between the edges of the wall", 20.0),
    "lower_internal_pressure": ("Pa", "p, smallest guaranteed, without a partial factor", 20000.0),
    "upper_internal_pressure": ("Pa", "p, largest, with its safety factor", 40000.0),
    "axial_wall_force": ("N m-1", "n, largest, compression positive, without the wall above, with its safety factor", 200000.0),
    "wall_above": ("Pa", "axial stress under the own weight of the wall above, with its safety factor", 0.0),
    "shear_wall_force": ("N m-1", "n_xth, largest shear round the wall, V/(pi r)", 20000.0),
    "wind_pressure": ("Pa", "q, at the stagnation line", 1000.0),
    "suction": ("Pa", "q_s, inside below outside", 500.0),
    "edge_factor": ("1", "C_theta, how the edges are held", 1.0),
    "critical_external_pressure": ("Pa", "p_cr, of the perfect wall with its courses", 3000.0),
    "thinnest": ("m", "t_min, thinnest course", 0.01),
    "hopper_thickness": ("m", "t_h", 0.01),
    "hopper_half_angle": ("rad", "beta, from the vertical", 0.6),
    "hopper_joint_efficiency": ("1", "j of the hopper's welds", 1.0),
    "hopper_meridional_force": ("N m-1", "n_phi, tension positive", 200000.0),
    "hopper_hoop_force": ("N m-1", "n_th, tension positive", 200000.0),
    "ring_area": ("m2", "A_r, of the transition ring", 0.005),
    "ring_second_moment": ("m4", "I_z, of the ring about its vertical axis", 2e-5),
    "support_force": ("N m-1", "q, vertical load on the ring beam", 200000.0),
    "column_count": ("1", "n", 8.0),
    "section_modulus": ("m3", "W, of the ring beam against bending about its horizontal axis", 0.005),
    "anchor_resistance": ("N", "of one anchor in tension, design value", 100000.0),
    "anchor_tension": ("N", "of one anchor", 50000.0),
    "anchor_count": ("1", "n", 24.0),
}
THIN_WALL = Limit(
    measure=Measure("t/r", "1", lambda *, inner_radius, thickness: 1 / (inner_radius / thickness + 0.5)),
    most=1 / 20,
    why="membrane forces are those of thin shells; EN 1993-1-6's r/t of 20, from memory",
)
# parameter -> what a study must give for it, where it may be left out
GIVEN_BY = {
    "ultimate_stress": "scene.hopper_shell.ultimate_stress_MPa",
    "wind_pressure": "scene.wind",
    "edge_factor": "scene.wind",
    "critical_external_pressure": "scene.wind",
    "hopper_half_angle": "scene.silo.hopper",
    "hopper_thickness": "scene.hopper_shell",
    "hopper_joint_efficiency": "scene.hopper_shell",
    "hopper_meridional_force": "hopper_position",
    "thickness": "scene.shell.strakes",
    "support_force": "scene.shell.strakes_and_hopper_position_and_depths_to_the_foot",
    "ring_area": "scene.transition_ring",
    "ring_second_moment": "scene.transition_ring.second_moment_cm4",
    "column_count": "scene.columns",
    "section_modulus": "scene.columns",
    "anchor_resistance": "scene.anchors",
    "anchor_tension": "scene.anchors",
    "anchor_count": "scene.anchors",
}
# Why a utilisation is masked: position = flag value in the cube.
REASONS = (
    "in_scope",
    "out_of_range",
    "load_or_pressure_masked",
    "not_in_this_combination",
    "needs_earthquake_and_checks.earthquake",
    *(f"needs_{key}" for key in dict.fromkeys(GIVEN_BY.values())),
)
IN_SCOPE, OUT_OF_RANGE, NO_LOAD, OTHER_COMBINATION, NO_EARTHQUAKE = range(5)


@dataclass(frozen=True, kw_only=True)
class SteelCheck(Row):
    """A check of a part of the steel: what acts over what resists.

    effect, resistance: function(*, parameters), both in `unit`; needed: the thickness (m) at which a wall just carries, None
    where it has to be sought.
    behind: function(*, parameters) -> numbers of BEHIND by name, for readers who follow the check step by step.
    acts_in: actions of which a combination needs one to be checked here; idle_with: actions that, all together, make it idle.
    one_source: a single public source has it; such a check runs only where a study names it.
    """

    part: str = WALL
    effect: Callable
    resistance: Callable
    unit: str = "Pa"
    needed: Callable | None = None
    behind: Callable | None = None
    limits: tuple[Limit, ...] = ()
    acts_in: frozenset[str] = field(default_factory=frozenset)
    idle_with: frozenset[str] = field(default_factory=frozenset)
    formula: str
    validity: str
    one_source: bool = False

    @property
    def bounds(self) -> tuple[Limit, ...]:
        """The limits of the check: of the wall, that it is thin, and its own."""
        return (*((THIN_WALL,) if self.part == WALL else ()), *self.limits)

    @property
    def functions(self) -> tuple[Callable, ...]:
        """All functions of the row."""
        of_limits = (limit.measure.of for limit in self.bounds)
        return (self.effect, self.resistance, *((self.needed,) if self.needed else ()), *of_limits)

    @property
    def needs(self) -> frozenset[str]:
        """Names of all parameters that its functions ask for."""
        return frozenset(name for function in self.functions for name in signature(function).parameters)

    @property
    def range(self) -> str:
        """The limits in words, then what else there is to say of the check's range."""
        return "; ".join((*(limit.words() for limit in self.bounds), self.validity))

    def utilisation(self, available: Mapping) -> np.ndarray:
        """Effect over resistance (1): 1 where the part just carries."""
        return call(self.effect, available) / call(self.resistance, available)

    def faults(self) -> Iterator[str]:
        """Faults of the row, in words."""
        yield from super().faults()
        if self.part not in PARTS:
            yield f"part = {self.part!r}: must be one of {', '.join(PARTS)}"
        usual = {key: np.full(2, value) for key, (_, _, value) in PARAMETERS.items()}
        own = {"effect": (self.effect, self.unit), "resistance": (self.resistance, self.unit), "needed": (self.needed, "m")}
        for name, (function, unit) in own.items():
            if function:
                yield from faults_of_function(name, function, unit, signature(function).parameters, PARAMETERS)
                yield from faults_of_trial(name, partial(call, function, usual))


def call(function: Callable, available: Mapping):
    """The function, handed those of the available parameters that it asks for."""
    return function(**{name: available[name] for name in signature(function).parameters})
