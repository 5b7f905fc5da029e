"""The checks of the cylinder's wall: how far it is used as built, and how thick it must be, in every combination."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from silostudy.buckling.family import IN_SCOPE, NO_LOAD
from silostudy.buckling.thickness import SLENDEREST, STOCKIEST, required_thickness, with_thickness
from silostudy.checks import external_pressure
from silostudy.checks.family import OUT_OF_RANGE, SteelCheck, call
from silostudy.checks.stepped_wall import critical_pressure
from silostudy.compute.checks_actions import Characteristic, acting, lacking
from silostudy.compute.checks_scope import judged, scope
from silostudy.compute.shell_places import of_cases, wall_parameters
from silostudy.tables.combinations import Combination

HALVINGS = 30  # of log R/t: the thickness comes to 1e-8 of itself


@dataclass(frozen=True)
class WallActions:
    """The actions of all combinations, each (combination, method, axes..., place), with the wall's own parameters beside them.

    lacks: why a combination cannot be checked, (combination, 1, axes..., 1).
    """

    source: Characteristic
    combinations: Sequence[Combination]
    parameters: Mapping[str, np.ndarray]
    lacks: np.ndarray

    @property
    def shape(self) -> tuple[int, ...]:
        return self.parameters["axial_wall_force"].shape

    def factor(self, name: str) -> np.ndarray:
        """A factor of every combination, (combination, 1, 1..., 1)."""
        values = np.array([combination.factors[name] for combination in self.combinations])
        return values.reshape(-1, *[1] * (len(self.shape) - 1))

    @property
    def unloaded(self) -> np.ndarray:
        """Mask of places where a method gives no load in any combination with contents, (method, axes..., place)."""
        full = [bool(combination.solids) for combination in self.combinations]
        if not any(full):
            return np.zeros(self.shape[1:], dtype=bool)
        silent = np.isnan(self.parameters["axial_wall_force"]) | np.isnan(self.parameters["upper_internal_pressure"])
        return silent[full].all(axis=0) & (self.source.places.below_top > 0)


def load(source: Characteristic, combinations: Sequence[Combination]) -> WallActions:
    """Everything that the checks of the wall ask for but its thickness."""
    acting_by = [acting(combination, source) for combination in combinations]
    actions = {name: np.array([forces[name] for forces in acting_by]) for name in acting_by[0]}
    steel = wall_parameters(source.expansion, actions["lower_internal_pressure"], actions["upper_internal_pressure"])
    asked, number = source.expansion.study.checks, source.numbers
    empty = np.array([combination.contents == "empty" for combination in combinations]).reshape(
        -1, *[1] * (actions["suction"].ndim - 1)
    )
    beside = {
        "wall_height": number["wall_height"],
        "edge_factor": np.where(empty, number["edge_factor"], np.nan_to_num(number["edge_factor"], nan=1.0)),
        "partial_yield": asked.gamma_M0,
        "partial_buckling": asked.gamma_M1,
        "partial_joint": asked.gamma_M2,
    }
    lacks = np.array([lacking(combination, source) for combination in combinations])[:, None]
    return WallActions(source, combinations, {**steel, **actions, **beside}, lacks)


def as_built(loads: WallActions) -> dict[str, np.ndarray]:
    """The parameters of a wall of strakes, its own weight in the axial force, its courses in the critical pressure."""
    place = loads.source.places
    own = loads.factor("permanent") * place.own_weight
    walls = [case.scene.shell for case in loads.source.expansion.cases]
    return {
        **loads.parameters,
        "thickness": place.thickness,
        "thinnest": of_cases(loads.source.expansion, [min(wall.thicknesses) for wall in walls]),
        "critical_external_pressure": _outside(loads, courses_critical(loads.source)[0]),
        "axial_wall_force": loads.parameters["axial_wall_force"] + own,
        "wall_above": np.float64(0.0),
    }


def of_one_thickness(loads: WallActions) -> Callable[[np.ndarray], dict[str, np.ndarray]]:
    """Function that gives the parameters of a wall of one thickness (m), which weighs on itself."""
    source, own = loads.source, {**loads.parameters}
    above = loads.factor("permanent") * source.numbers["steel_weight"] * source.places.below_top

    def given_wall(thickness):
        wall = {**own, "thickness": thickness, "thinnest": thickness, "wall_above": above}
        return {**wall, "critical_external_pressure": _outside(loads, call(external_pressure.critical_pressure, wall))}

    return given_wall


def _outside(loads: WallActions, critical) -> np.ndarray:
    """Critical external pressure (Pa); without bound where the solid stands, so that nothing is asked of the edges there."""
    full = np.isin([combination.contents for combination in loads.combinations], ["empty"], invert=True)
    return np.where(full.reshape(-1, *[1] * (len(loads.shape) - 1)), np.inf, critical)


def courses_critical(source: Characteristic) -> tuple[np.ndarray, np.ndarray]:
    """External pressure (Pa) at which the wall with its courses buckles, and waves round it, (axes..., 1); NaN without wind."""
    results = np.array([_of_case(case.scene) for case in source.expansion.cases])
    return of_cases(source.expansion, results[:, 0].tolist()), of_cases(source.expansion, results[:, 1].tolist())


def _of_case(scene) -> tuple[float, float]:
    wall, height = scene.shell, scene.silo.wall_depth
    if scene.edges is None or not wall.edges:
        return np.nan, np.nan
    steel = (wall.steel["youngs_modulus"], wall.steel["shell_poisson_ratio"])
    return _critical(wall.thicknesses, wall.edges, height, scene.silo.diameter, steel, scene.edges)


@lru_cache(maxsize=256)
def _critical(thicknesses, shares, height: float, diameter: float, steel, edges) -> tuple[float, float]:
    """The same of courses that end at shares of the height (m): cases often differ in what stands in the silo alone."""
    heights = np.diff([0.0, *shares]) * height
    mean = float(np.dot(thicknesses, heights)) / height
    return critical_pressure(
        thicknesses, heights, radius=(diameter + mean) / 2, youngs_modulus=steel[0], shell_poisson_ratio=steel[1], edges=edges
    )


def checked(rows: Sequence[SteelCheck], loads: WallActions, parameters: Mapping) -> dict[str, np.ndarray]:
    """Utilisation, its scope, and effect and resistance where they are stresses (Pa): (check, combination, method, ...)."""
    lists: dict[str, list] = {"utilisation": [], "scope": [], "effect": [], "resistance": []}
    for row in rows:
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            effect, resistance = (
                np.broadcast_to(call(function, parameters), loads.shape) for function in (row.effect, row.resistance)
            )
            flags = scope(row, parameters, loads.combinations, loads.lacks, loads.shape)
            used, flags = judged(effect / resistance, flags)
        of_stress = (flags == 0) & (row.unit == "Pa")
        lists["utilisation"].append(used)
        lists["scope"].append(flags)
        lists["effect"].append(np.where(of_stress, effect, np.nan))
        lists["resistance"].append(np.where(of_stress, resistance, np.nan))
    return {name: np.array(values).reshape(len(rows), *loads.shape) for name, values in lists.items()}


def needed(rows: Sequence[SteelCheck], loads: WallActions) -> np.ndarray:
    """Thickness (m) at which each check just holds in a wall of one thickness, (check, combination, method, axes..., place)."""
    wall_of = of_one_thickness(loads)
    return np.array([_needed(row, loads, wall_of) for row in rows]).reshape(len(rows), *loads.shape)


def beyond(rows: Sequence[SteelCheck], loads: WallActions, thickness: np.ndarray) -> np.ndarray:
    """Mask of places where some check is beyond its range on a wall of one thickness (m), both (method, axes..., place)."""
    thinnest = np.broadcast_to(loads.source.numbers["inner_radius"], loads.shape) / SLENDEREST
    wall = of_one_thickness(loads)(np.where(thickness > 0, thickness, thinnest))
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        scopes = [scope(row, wall, loads.combinations, loads.lacks, loads.shape) for row in rows]
    return (np.array(scopes).reshape(len(rows), *loads.shape) == OUT_OF_RANGE).any(axis=(0, 1))


def _needed(row: SteelCheck, loads: WallActions, wall_of: Callable) -> np.ndarray:
    radius = np.broadcast_to(loads.source.numbers["inner_radius"], loads.shape)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        thickness = call(row.needed, wall_of(radius)) if row.needed else _sought(row, wall_of, radius)
        thickness = np.broadcast_to(thickness, loads.shape)
        wall = wall_of(np.where(thickness > 0, thickness, radius / SLENDEREST))
        flags = scope(row, wall, loads.combinations, loads.lacks, loads.shape)
    return judged(thickness, flags)[0]


def _sought(row: SteelCheck, wall_of: Callable, radius: np.ndarray) -> np.ndarray:
    """The thickness (m) by halving the range of log R/t; NaN where the stockiest does not do, 0 where the slenderest does."""
    thin, thick = radius / SLENDEREST, radius / STOCKIEST
    enough, idle = (row.utilisation(wall_of(end)) <= 1 for end in (thick, thin))
    for _ in range(HALVINGS):
        middle = np.sqrt(thin * thick)
        carries = row.utilisation(wall_of(middle)) <= 1
        thin, thick = np.where(carries, thin, middle), np.where(carries, middle, thick)
    return np.where(idle, 0.0, np.where(enough, thick, np.nan))


def buckled(rules, loads: WallActions, parameters: Mapping) -> dict[str, np.ndarray]:
    """Axial stress over design strength by rule, its scope, and the strength (Pa), each (rule, combination, method, ...)."""
    lists: dict[str, list] = {"utilisation": [], "scope": [], "strength": []}
    stress = parameters["axial_wall_force"] / parameters["thickness"]
    silent = (loads.lacks > 0) | np.isnan(stress)
    for rule in rules:
        shell = with_thickness(rule, parameters, parameters["thickness"])
        strength = np.broadcast_to(shell["buckling_stress"], loads.shape) / parameters["partial_buckling"]
        flags = np.where(silent, NO_LOAD, np.broadcast_to(shell["buckling_stress_scope"], loads.shape)).astype(np.int8)
        lists["utilisation"].append(np.where(flags == IN_SCOPE, stress / strength, np.nan))
        lists["scope"].append(flags)
        lists["strength"].append(np.where(flags == IN_SCOPE, strength, np.nan))
    return {name: np.array(values) for name, values in lists.items()}


def needed_by_rules(rules, loads: WallActions) -> tuple[np.ndarray, np.ndarray]:
    """Thickness (m) that axial buckling asks for, and scope, each (rule, combination, method, axes..., place)."""
    source, own = loads.source, loads.parameters
    above = loads.factor("permanent") * source.numbers["steel_weight"] * source.places.below_top
    force = np.where(loads.lacks > 0, np.nan, own["axial_wall_force"])
    pairs = [required_thickness(rule, own, force, own["partial_buckling"], own_weight=above) for rule in rules]
    return np.array([pair[0] for pair in pairs]), np.array([pair[1] for pair in pairs])
