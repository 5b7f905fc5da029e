"""The shell stage: what the pressures of a cube ask of the silo's steel wall, by every buckling rule of the study."""

from dataclasses import replace

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING
from silostudy.checks import SOLID_CHECKS
from silostudy.choice.expand import Resolved
from silostudy.compute.axes import sweep_of
from silostudy.compute.buckling import rule_coordinates
from silostudy.compute.evaluate import methods_of
from silostudy.compute.shell_earthquake import SIDES, beside, earthquake_loads, earthquake_told, of_this_study, sides
from silostudy.compute.shell_ends import worst_of_ends
from silostudy.compute.shell_load import SOURCES, axial_wall_force, carried_share, internal_pressures
from silostudy.compute.shell_places import Places, at_levels, at_strake_ends, of_cases
from silostudy.compute.shell_strakes import ENDS
from silostudy.compute.shell_strength import required_thicknesses, utilisations
from silostudy.cube.assemble import assemble
from silostudy.cube.variables import flags
from silostudy.errors import BadInput
from silostudy.scene.shell import SteelWall


def shell_cube(expansion: Resolved, pressure: xr.Dataset, seismic: xr.Dataset | None = None) -> xr.Dataset:
    """The cube of a shell study: loads, required thickness, and with strakes the utilisation over depth and at their ends.

    seismic: the cube of the seismic study that it names, for all of this once more with the earthquake.
    """
    study = expansion.study
    if pressure.attrs["study"] != study.model_dump_json(exclude_defaults=True):
        raise BadInput("pressure cube", pressure.attrs["title"], f"is of another study than {expansion.name}")
    rules = [study.family(BUCKLING)[key] for key in study.rule_keys]
    force, source = axial_wall_force(pressure)
    pressures = internal_pressures(pressure)
    levels = at_levels(expansion, pressure, force, pressures)
    at_ends = at_strake_ends(expansion, pressure, levels) if levels.thickness is not None else None
    dead, safety = (of_cases(expansion, [get(case.scene.shell) for case in expansion.cases]) for get in (_dead, _safety))
    data = load_variables(pressure, force, source, pressures) | rule_coordinates(rules)
    data |= {"imposed_axial_force": dead[..., 0], "safety_factor": safety[..., 0]}
    data |= strengths(expansion, rules, levels, at_ends, safety, dead)
    data |= worst_of_ends(expansion, data)
    sweep = sweep_of(expansion)
    data |= {str(name): pressure[name].values for name in pressure.coords.keys() - sweep.coordinates.keys()}
    sources = [rule.source for rule in rules] + [method.row.source for method in methods_of(expansion)]
    sources += [check.source for check in SOLID_CHECKS.values()]
    notes: dict = {**expansion.promise, **study.own_methods}
    if study.earthquake:
        of_choice = of_this_study(expansion, seismic).sel(mass_choice=study.earthquake.mass_choice)
        data |= shaken(expansion, rules, levels, at_ends, of_choice, safety, dead)
        data["side"] = list(SIDES)
        notes |= earthquake_told(of_choice) | excluded(rules)
        sources.append("en1998_4_2006")
    return assemble(study, "shell", data, sources=sources, notes=notes, sweep=sweep)


def _safety(wall: SteelWall) -> float:
    return wall.safety_factor


def _dead(wall: SteelWall) -> float:
    return wall.imposed_force


def shaken(expansion, rules, levels: Places, at_ends: Places | None, seismic, safety, dead) -> dict:
    """Loads, thickness and utilisation on both sides of a wall that an earthquake bends, all under `earthquake_` names."""
    looked = [sides_of(place, seismic) for place in (levels, at_ends) if place]
    sides = []
    for side in SIDES:
        here, *rest = (looked_at[side] for looked_at in looked)
        pressures = {name: here.parameters[name] for name in ("lower_internal_pressure", "upper_internal_pressure")}
        loads = {"axial_wall_force": here.force, **pressures}
        sides.append(loads | strengths(expansion, rules, here, rest[0] if rest else None, safety, dead))
    return beside(sides)


def sides_of(place: Places, seismic: xr.Dataset) -> dict[str, Places]:
    """The same places on each side of a wall that an earthquake bends."""
    force, pressure = earthquake_loads(place.z, seismic)
    static = (place.force, place.parameters["lower_internal_pressure"], place.parameters["upper_internal_pressure"])
    loads = sides(*static, seismic_force=force, seismic_pressure=pressure)
    return {
        side: replace(
            place,
            force=own,
            parameters={**place.parameters, "lower_internal_pressure": lower, "upper_internal_pressure": upper},
        )
        for side, (own, lower, upper) in loads.items()
    }


def strengths(expansion, rules, levels: Places, at_ends: Places | None, safety, dead) -> dict:
    """The thickness that the loads ask for, and where the wall's thickness is given its utilisation."""
    weight = of_cases(expansion, [case.scene.shell.unit_weight for case in expansion.cases]) * levels.height
    largest = np.fmax.reduce(levels.force, axis=1) + dead
    arrays = required_thicknesses(rules, levels.parameters, largest, safety, weight)
    if levels.thickness is None or at_ends is None:
        return arrays
    arrays |= utilisations(rules, levels.parameters, levels.force, safety, levels.thickness, levels.own_weight + dead)
    arrays |= {"wall_thickness": levels.thickness, "own_weight_axial_force": levels.own_weight}
    return arrays | strake_variables(expansion, rules, at_ends, safety, dead)


def strake_variables(expansion, rules, at_ends: Places, safety, dead) -> dict:
    """Loads and utilisation at top and foot of every strake, whether a depth of the study lies there or not."""
    used = utilisations(rules, at_ends.parameters, at_ends.force, safety, at_ends.thickness, at_ends.own_weight + dead)
    count = at_ends.z.shape[-1] // len(ENDS)

    def parted(values):
        return values.reshape(*values.shape[:-1], count, len(ENDS))

    arrays = {"strake_depth": parted(at_ends.z), "strake_axial_wall_force": parted(at_ends.force)}
    arrays |= {"strake_thickness": parted(at_ends.thickness)[..., 0]}
    for name, given in used.items():
        values, *told = given if isinstance(given, tuple) else (given,)
        arrays[f"strake_{name}"] = (parted(values), *told) if told else parted(values)
    return arrays | {"strake": np.arange(1, count + 1), "strake_end": list(ENDS)}


def load_variables(pressure: xr.Dataset, force, source, pressures) -> dict:
    """Loads on the wall, and variables of the pressure cube that figures need."""
    return {
        "axial_wall_force": force,
        "carried_share": carried_share(force, pressure),
        "lower_internal_pressure": pressures[0],
        "upper_internal_pressure": pressures[1],
        "axial_force_source": (source, flags("what the axial wall force follows from", SOURCES)),
        **{name: pressure[name].values for name in ("cylinder_depth", "hydraulic_radius", "wall_friction")},
    }


def excluded(rules) -> dict[str, str]:
    """Rules of an earthquake study that their source does not give for earthquakes."""
    told = "; ".join(f"{rule.key} excludes {rule.excludes}" for rule in rules if rule.excludes)
    return {"rules_exclude": told} if told else {}
