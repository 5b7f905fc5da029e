"""The row of a buckling rule: a function from the shell to its strength under axial compression."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from inspect import signature

import numpy as np

from silostudy.catalogue import Row
from silostudy.errors import BadInput
from silostudy.limits import Limit
from silostudy.soundness import check_numbers, faults_of_function, faults_of_look, faults_of_trial

# Every parameter a rule may ask for: (unit, symbol and meaning, a usual value).
PARAMETERS = {
    "youngs_modulus": ("Pa", "E", 210000000000.0),
    "shell_poisson_ratio": ("1", "nu", 0.3),
    "yield_stress": ("Pa", "sigma_y, f_y", 235000000.0),
    "shell_radius": ("m", "R, r, of the middle surface", 5.0),
    "thickness": ("m", "t", 0.01),
    "bay_length": ("m", "L, ring spacing, or the whole length without rings", 2.0),
    "total_length": ("m", "l_0, whole length between the ends, for rings too small to end a bay; unknown: nan", 20.0),
    "ring_area": ("m2", "A_r, 0 without rings", 0.0),
    "fabricated": ("1", "kind of shell, 1 fabricated from plates, 0 manufactured as a tube", 1.0),
    "safe_constants": ("1", "choice, 1 constants in place of the formulas for fabricated shells, 0 formulas", 0.0),
    "fabrication_quality": ("1", "Q, 40, 25, 16 for classes A, B, C", 25.0),
    "end_factor": ("1", "C_xb, 6, 3 or 1", 1.0),
    "lower_internal_pressure": ("Pa", "p_s, smallest guaranteed, which steadies the wall", 20000.0),
    "upper_internal_pressure": ("Pa", "p_g, largest, with which the foot of the wall yields", 40000.0),
}
POSITIVE = ("youngs_modulus", "yield_stress", "shell_radius", "thickness", "bay_length", "fabrication_quality", "end_factor")
# The numbers behind a strength that a reader wants to follow: unit.  A rule or a check gives those that it has.
BEHIND = {
    "relative_length": "1",
    "length_factor": "1",
    "critical_stress": "Pa",
    "relative_imperfection": "1",
    "imperfection_factor": "1",
    "relative_lower_pressure": "1",
    "relative_upper_pressure": "1",
    "foot_shape": "1",
    "pressurised_factor": "1",
    "foot_factor": "1",
    "reduced_factor": "1",
    "slenderness": "1",
    "plastic_range": "1",
    "plastic_limit": "1",
    "interaction_exponent": "1",
    "reduction": "1",
    "wind_factor": "1",
    "even_pressure": "Pa",
    "axial_share": "1",
    "hoop_share": "1",
    "shear_share": "1",
    "axial_reduction": "1",
    "hoop_reduction": "1",
    "shear_reduction": "1",
    "axial_exponent": "1",
    "hoop_exponent": "1",
    "shear_exponent": "1",
}
MODES = (
    "local_elastic",
    "local_inelastic",
    "general_elastic",
    "general_inelastic",
    "yielding",
    "elephants_foot",
)
LOCAL_ELASTIC, LOCAL_INELASTIC, GENERAL_ELASTIC, GENERAL_INELASTIC, YIELDING, ELEPHANTS_FOOT = range(len(MODES))

# Why a value is masked: position = flag value in the cube.
REASONS = (
    "in_scope",
    "radius_over_thickness_out_of_range",
    "rings_not_covered",
    "rings_too_small_to_count",
    "suction_not_covered",
    "hoop_stress_at_yield",
    "load_or_pressure_masked",
    "length_out_of_range",
)
IN_SCOPE, OUT_OF_RANGE, NO_RINGS, SMALL_RINGS, SUCTION, HOOP_YIELD, NO_LOAD, LONG = range(len(REASONS))
QUANTITIES = (
    "elastic_local_stress",
    "elastic_general_stress",
    "elastic_buckling_stress",
    "buckling_stress",
    "elastic_knockdown_factor",
    "knockdown_factor",
    "supported_length",
    "length_factor",
)


@dataclass(frozen=True)
class Strength:
    """Axial stresses (Pa) at which a shell with its imperfections buckles, and how.

    elastic_local and elastic_general: without yielding, between the rings and with them (NaN where a rule has none);
    elastic: that of the two behind the strength; strength: with yielding; mode: position in MODES.
    length: between the edges (m) that the rule counts as held; length_factor: C_x (1); NaN where they play no part.
    """

    elastic_local: np.ndarray
    elastic_general: np.ndarray | float
    elastic: np.ndarray
    strength: np.ndarray
    mode: np.ndarray
    length: np.ndarray | float = np.nan
    length_factor: np.ndarray | float = np.nan


@dataclass(frozen=True, kw_only=True)
class ShellLimit(Limit):
    """A limit of a rule; reason: position in REASONS, what the mask says beyond it."""

    reason: int


@dataclass(frozen=True, kw_only=True)
class BucklingRule(Row):
    """A theory, a researcher's formula or a design code.

    strength: function(*, parameters) -> Strength; limits: the rule's range as data; beyond it values are masked.
    excludes: actions that the source leaves out and no number of the shell tells of.
    rival_of: the rule whose source the row reads otherwise than it is meant; empty for a rule in its own right.
    behind: function(*, parameters) -> numbers of BEHIND by name, for readers who follow the strength step by step.
    pressurised: the rule counts the internal pressure; the others leave out its help and do not see its harm.
    """

    strength: Callable[..., Strength]
    limits: tuple[ShellLimit, ...]
    formula: str
    validity: str
    colour: str
    marker: str
    line: str  # a name of matplotlib
    behind: Callable[..., Mapping[str, np.ndarray]] | None = None
    pressurised: bool = False
    excludes: str = ""
    rival_of: str = ""

    @property
    def needs(self) -> frozenset[str]:
        """Names of all parameters that its functions ask for."""
        functions = [self.strength, *(limit.measure.of for limit in self.limits)]
        return frozenset(name for function in functions for name in signature(function).parameters)

    @property
    def range(self) -> str:
        """The limits in words, then what else there is to say of the rule's range."""
        return "; ".join((*(limit.words() for limit in self.limits), self.validity))

    def faults(self) -> Iterator[str]:
        """Faults of the row, in words."""
        yield from super().faults()
        yield from faults_of_look(self)
        faults = list(faults_of_function("strength", self.strength, "Pa", self.needs, PARAMETERS))
        for limit in self.limits:
            if not isinstance(limit, ShellLimit):
                faults.append(f"limits: {limit!r} must be a ShellLimit (silostudy.buckling.limits has several)")
            elif limit.reason not in range(1, len(REASONS)):
                faults.append(f"limits: {limit.words()} masks for reason {limit.reason!r}, not one of 1 to {len(REASONS) - 1}")
        yield from faults or faults_of_trial("strength", lambda: self._tried())

    def _tried(self) -> None:
        """Evaluates two usual shells."""
        for name in ("buckling_stress", "elastic_buckling_stress"):
            check_numbers(lambda name=name: evaluate(self, _usual())[name])  # type: ignore[misc]


def _usual() -> dict[str, np.ndarray]:
    """Parameters of two usual shells at once."""
    return {name: np.full(2, value) for name, (_, _, value) in PARAMETERS.items()}


def call(function: Callable, available: Mapping):
    """The function, handed those of the available parameters that it asks for."""
    return function(**{name: available[name] for name in signature(function).parameters})


def classical_stress(*, youngs_modulus, shell_poisson_ratio, shell_radius, thickness):
    """Axial stress (Pa) at which a perfect elastic cylinder of medium length buckles: E t / (R sqrt(3 (1 - nu^2))).

    Source: classical_buckling, textbook result.
    """
    return youngs_modulus * thickness / shell_radius / np.sqrt(3 * (1 - shell_poisson_ratio**2))


def evaluate(row: BucklingRule, parameters: Mapping) -> dict[str, np.ndarray]:
    """Every quantity of QUANTITIES, its mode and its scope; outside the scope NaN, mode -1 and the reason.

    Raises BadInput for a parameter that no shell can have.
    """
    check_parameters(parameters)
    with np.errstate(invalid="ignore", divide="ignore"):  # outside a rule's scope its formula may break down
        strength = call(row.strength, parameters)
        outside = [(limit.broken(None, parameters), limit.reason) for limit in row.limits]
    shape = np.broadcast_shapes(*(np.shape(parameters[name]) for name in parameters))
    conditions = [np.broadcast_to(condition, shape) for condition, _ in outside]
    scope = np.select(conditions, [reason for _, reason in outside], IN_SCOPE).astype(np.int8)
    classical = call(classical_stress, parameters)
    values = {
        "elastic_local_stress": strength.elastic_local,
        "elastic_general_stress": strength.elastic_general,
        "elastic_buckling_stress": strength.elastic,
        "buckling_stress": strength.strength,
        "elastic_knockdown_factor": strength.elastic / classical,
        "knockdown_factor": strength.strength / classical,
        "supported_length": strength.length,
        "length_factor": strength.length_factor,
    }
    masked = {name: np.where(scope == IN_SCOPE, value, np.nan) for name, value in values.items()}
    mode = np.where(scope == IN_SCOPE, strength.mode, -1).astype(np.int8)
    return {**masked, "buckling_mode": mode, "buckling_stress_scope": scope}


def check_parameters(parameters: Mapping) -> None:
    """BadInput where a size or a property of the steel is not positive, or rings have a negative area."""
    for name in POSITIVE:
        if not np.all(np.asarray(parameters[name]) > 0):
            raise BadInput(name, float(np.min(parameters[name])), f"must be above 0 {PARAMETERS[name][0]}")
    if not np.all(np.asarray(parameters["ring_area"]) >= 0):
        raise BadInput("ring_area", float(np.min(parameters["ring_area"])), "must not be negative")
    if np.any(np.asarray(parameters["lower_internal_pressure"]) > np.asarray(parameters["upper_internal_pressure"])):
        raise BadInput("lower_internal_pressure", "above upper_internal_pressure", "must not exceed it")
