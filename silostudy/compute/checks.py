"""The stage of the checks: every check of a silo's steel in every combination of actions, and the thickness they ask for."""

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING as RULES
from silostudy.buckling.family import IN_SCOPE, NO_LOAD
from silostudy.buckling.family import REASONS as RULE_REASONS
from silostudy.checks import BUCKLING, CHECKS
from silostudy.checks.family import OUT_OF_RANGE, PARTS, REASONS, WALL
from silostudy.choice.expand import Resolved
from silostudy.compute.axes import sweep_of
from silostudy.compute.buckling import rule_coordinates
from silostudy.compute.checks_actions import given
from silostudy.compute.checks_behind import strakes_behind
from silostudy.compute.checks_numbers import given_numbers
from silostudy.compute.checks_phases import contents_load_cases
from silostudy.compute.checks_places import places, uneven
from silostudy.compute.checks_scope import combined, rows_of
from silostudy.compute.checks_supports import below
from silostudy.compute.checks_wall import (
    WallActions,
    as_built,
    beyond,
    buckled,
    checked,
    courses_critical,
    load,
    needed,
    needed_by_rules,
)
from silostudy.compute.evaluate import methods_of
from silostudy.compute.listed_cases import listed_variables
from silostudy.compute.shell import excluded
from silostudy.compute.shell_earthquake import earthquake_told, of_this_study
from silostudy.cube.assemble import assemble
from silostudy.cube.variables import flags
from silostudy.errors import BadInput
from silostudy.scene.steelwork import combinations
from silostudy.tables.combinations import ACTIONS


def checks_cube(expansion: Resolved, pressure: xr.Dataset, seismic: xr.Dataset | None = None) -> xr.Dataset:
    """The cube of the checks: the actions of each combination, utilisation by each check, and the thickness needed.

    seismic: the cube of the seismic study that the study names.
    """
    study = expansion.study
    if pressure.attrs["study"] != study.model_dump_json(exclude_defaults=True):
        raise BadInput("pressure cube", pressure.attrs["title"], f"is of another study than {expansion.name}")
    shaken = of_this_study(expansion, seismic).sel(mass_choice=study.earthquake.mass_choice) if study.earthquake else None
    rules = [study.family(RULES)[key] for key in study.rule_keys]
    loads = load(given(expansion, places(expansion, pressure), pressure, shaken), combinations(study))
    built = as_built(loads) if np.isfinite(loads.source.places.thickness).any() else {}
    rows = rows_of(study, WALL)
    data = rule_coordinates(rules) | actions(loads) | thicknesses(rules, rows, loads)
    data |= given_numbers(loads) | below(pressure, loads, built) | contents_load_cases(loads.source, pressure)
    if built:
        data |= utilisations(rules, rows, loads, built)
    data |= listed_variables(expansion)
    sweep = sweep_of(expansion)
    data |= {str(name): pressure[name].values for name in pressure.coords.keys() - sweep.coordinates.keys()}
    silent = [row.key for row in CHECKS.values() if row.one_source and row.key not in study.checks.one_source]
    notes: dict = {**expansion.promise, **study.own_methods}
    notes |= {"not_given": ", ".join(not_given(expansion)), "one_source_left_out": ", ".join(silent)}
    notes["uneven_methods"] = ", ".join(np.array([method.label for method in methods_of(expansion)])[uneven(expansion)])
    notes |= {**earthquake_told(shaken), **excluded(rules)} if shaken is not None else {}
    sources = [rule.source for rule in rules] + [method.row.source for method in methods_of(expansion)]
    made = [row for part in PARTS for row in rows_of(study, part)]
    sources += [row.source for row in made] + [combination.source for combination in loads.combinations if combination.source]
    return assemble(study, "checks", data, sources=sources, notes=notes, sweep=sweep)


def not_given(expansion: Resolved) -> list[str]:
    """Actions that no case gives, so that no combination counts them."""
    scenes = [case.scene for case in expansion.cases]
    absent = {
        "roof": all(scene.shell.roof_force == 0 for scene in scenes),
        "snow": all(scene.shell.snow_force == 0 for scene in scenes),
        "wind": all(np.isnan(scene.steelwork["wind_pressure"]) for scene in scenes),
        "suction": not any(scene.steelwork["suction"] > 0 for scene in scenes),
        "earthquake": expansion.study.earthquake is None or expansion.study.checks.earthquake is None,
        "own weight": all(scene.shell.unit_weight == 0 for scene in scenes),
    }
    return [name for name, missing in absent.items() if missing]


def actions(loads: WallActions) -> dict:
    """Places at which the wall is looked at, and the actions there in each combination."""
    place, source = loads.source.places, loads.source
    critical, waves = courses_critical(source)
    own = loads.factor("permanent") * place.own_weight
    return {
        "combination": [combination.key for combination in loads.combinations],
        "combination_title": [combination.title or combination.key for combination in loads.combinations],
        "combination_contents": [combination.contents for combination in loads.combinations],
        "action": ["permanent", "permanent_favourable", *ACTIONS],
        "combination_factor": np.array([list(combination.factors.values()) for combination in loads.combinations]),
        "place": np.arange(1, place.z.shape[-1] + 1),
        "place_depth": place.z,
        "place_strake": place.strake + 1,
        "place_thickness": place.thickness,
        "place_radius": source.numbers["inner_radius"] + place.thickness / 2,
        "thinnest_course": np.min(place.thickness, axis=-1),
        "design_axial_wall_force": loads.parameters["axial_wall_force"] + own,
        "design_shear_wall_force": loads.parameters["shear_wall_force"],
        "design_lower_pressure": loads.parameters["lower_internal_pressure"],
        "design_upper_pressure": loads.parameters["upper_internal_pressure"],
        "critical_external_pressure": critical[..., 0],
        "critical_external_waves": waves[..., 0],
    }


def utilisations(rules, rows, loads: WallActions, built) -> dict:
    """Utilisation (1) of the wall of strakes: by axial buckling, by each check, and the largest with what governs."""
    by_rule, by_check = buckled(rules, loads, built), checked(rows, loads, built)
    unjudged = ((by_rule["scope"] != IN_SCOPE) & (by_rule["scope"] != NO_LOAD)).any(axis=1) | loads.unloaded
    unjudged |= (by_check["scope"] == OUT_OF_RANGE).any(axis=(0, 1))
    used, check, combination = combined(by_rule["utilisation"], by_check["utilisation"], unjudged)
    told = flags("check by which the wall is used most", _names(rows)), flags("in which combination", _keys(loads))
    data = {
        "design_utilisation": used,
        "design_utilisation_check": (check, told[0]),
        "design_utilisation_combination": (combination, told[1]),
        "design_buckling_utilisation": by_rule["utilisation"],
        "design_buckling_utilisation_scope": (by_rule["scope"], flags("why it is masked", RULE_REASONS)),
        "design_buckling_stress": by_rule["strength"],
        "design_check_utilisation": by_check["utilisation"],
        "design_check_utilisation_scope": (by_check["scope"], flags("why it is masked", REASONS)),
        "design_check_effect": by_check["effect"],
        "design_check_resistance": by_check["resistance"],
    }
    data |= strakes_behind(rules, rows, loads, built, by_rule["utilisation"], by_check["utilisation"])
    return data | _by_strake(loads, "design_strake_utilisation", (used, check, combination), unjudged, told)


def thicknesses(rules, rows, loads: WallActions) -> dict:
    """Thickness that each depth asks for in a wall of one thickness: the largest of all checks, with what governs."""
    (by_rule, scope), by_check = needed_by_rules(rules, loads), needed(rows, loads)
    unjudged = (np.isnan(by_rule) & (scope != NO_LOAD)).any(axis=1) | loads.unloaded
    most, check, combination = combined(by_rule, by_check, unjudged)
    unjudged |= np.array([beyond(rows, loads, most_of_rule) for most_of_rule in most])
    most = np.where(unjudged, np.nan, most)
    told = flags("check that asks for the most", _names(rows)), flags("in which combination", _keys(loads))
    data = {
        "design_thickness": most,
        "design_thickness_check": (check, told[0]),
        "design_thickness_combination": (combination, told[1]),
        "design_buckling_thickness": np.fmax.reduce(by_rule, axis=1),
        "steel_check": [row.key for row in rows],
        "design_check_thickness": np.fmax.reduce(by_check, axis=1),
    }
    return data | _by_strake(loads, "design_strake_thickness", (most, check, combination), unjudged, told)


def _by_strake(loads: WallActions, name: str, values_with_causes: tuple, unjudged: np.ndarray, told: tuple) -> dict:
    """The largest number of every strake, over all its depths and both its ends, with what governs it.

    NaN where any part of it is beyond the rule: the largest of the rest would speak for a strake not judged.
    """
    strake = loads.source.places.strake
    if strake.max() < 0:
        return {}
    strakes = [_of_strake(strake == number, values_with_causes, unjudged) for number in range(int(strake.max()) + 1)]
    values, check, combination = (np.stack(parts, axis=-1) for parts in zip(*strakes, strict=True))
    return {
        "strake": np.arange(1, len(strakes) + 1),
        name: values,
        f"{name}_check": (check, told[0]),
        f"{name}_combination": (combination, told[1]),
    }


def _of_strake(here: np.ndarray, values_with_causes: tuple, unjudged: np.ndarray) -> tuple:
    values, *governing = values_with_causes
    place = np.argmax(np.where(here & ~np.isnan(values), values, -np.inf), axis=-1)[..., None]
    largest, *governing = (np.take_along_axis(array, place, axis=-1)[..., 0] for array in (values, *governing))
    return np.where((unjudged & here).any(axis=-1), np.nan, largest), *governing


def _names(rows) -> list[str]:
    return [BUCKLING, *(row.key for row in rows)]


def _keys(loads: WallActions) -> list[str]:
    return [combination.key for combination in loads.combinations]
