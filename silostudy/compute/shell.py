"""The shell stage: what the pressures of a cube ask of the silo's steel wall, by every buckling rule of the study."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING
from silostudy.buckling.family import IN_SCOPE, MODES, NO_LOAD, REASONS
from silostudy.buckling.thickness import required_thickness, with_thickness
from silostudy.choice.expand import Resolved
from silostudy.compute.axes import sweep_of
from silostudy.compute.buckling import rule_coordinates
from silostudy.compute.evaluate import methods_of
from silostudy.compute.shell_earthquake import SIDES, beside, earthquake_loads, earthquake_told, of_this_study, sides
from silostudy.compute.shell_load import SOURCES, axial_wall_force, carried_share, depths, internal_pressures
from silostudy.cube.assemble import assemble
from silostudy.cube.variables import flags
from silostudy.errors import BadInput


def shell_cube(expansion: Resolved, pressure: xr.Dataset, seismic: xr.Dataset | None = None) -> xr.Dataset:
    """The cube of a shell study: loads, required thickness, and with strakes the utilisation over depth.

    seismic: the cube of the seismic study that it names, for all of this once more with the earthquake.
    """
    study = expansion.study
    if pressure.attrs["study"] != study.model_dump_json(exclude_defaults=True):
        raise BadInput("pressure cube", pressure.attrs["title"], f"is of another study than {expansion.name}")
    rules = [study.family(BUCKLING)[key] for key in study.rule_keys]
    force, source = axial_wall_force(pressure)
    pressures = internal_pressures(pressure)
    parameters = wall_parameters(expansion, *pressures)
    safety = _of_cases(expansion, [case.scene.shell.safety_factor for case in expansion.cases])
    thickness = strakes(expansion, pressure) if all(case.scene.shell.edges for case in expansion.cases) else None
    data = load_variables(pressure, force, source, pressures) | rule_coordinates(rules)
    data |= strengths(rules, parameters, force, safety, thickness)
    sweep = sweep_of(expansion)
    data |= {str(name): pressure[name].values for name in pressure.coords.keys() - sweep.coordinates.keys()}
    sources = [rule.source for rule in rules] + [method.row.source for method in methods_of(expansion)]
    notes: dict = {**expansion.promise, **study.own_methods}
    if study.earthquake:
        one = of_this_study(expansion, seismic).sel(mass_choice=study.earthquake.mass_choice)
        data |= shaken(rules, parameters, force, earthquake_loads(pressure, one), safety, thickness)
        data["side"] = list(SIDES)
        notes |= earthquake_told(one)
        sources.append("en1998_4_2006")
    return assemble(study, "shell", data, sources=sources, notes=notes, sweep=sweep)


def shaken(rules, parameters: Mapping, force, added, safety, thickness) -> dict:
    """Loads, thickness and utilisation on both sides of a wall that an earthquake bends, all under `earthquake_` names."""
    found = []
    static = (force, parameters["lower_internal_pressure"], parameters["upper_internal_pressure"])
    for own, lower, upper in sides(*static, seismic_force=added[0], seismic_pressure=added[1]).values():
        here = {**parameters, "lower_internal_pressure": lower, "upper_internal_pressure": upper}
        loads = {"axial_wall_force": own, "lower_internal_pressure": lower, "upper_internal_pressure": upper}
        found.append(loads | strengths(rules, here, own, safety, thickness))
    return beside(found)


def strengths(rules, parameters: Mapping, force, safety, thickness) -> dict:
    """The thickness that a force (N/m) asks for, and where the wall's thickness (m) is given its utilisation."""
    found = required_thicknesses(rules, parameters, np.fmax.reduce(force, axis=1), safety)
    return found if thickness is None else found | utilisations(rules, parameters, force, safety, thickness)


def load_variables(pressure: xr.Dataset, force, source, pressures) -> dict:
    """What loads the wall, and what the figures need of the pressure cube."""
    return {
        "axial_wall_force": force,
        "carried_share": carried_share(force, pressure),
        "lower_internal_pressure": pressures[0],
        "upper_internal_pressure": pressures[1],
        "axial_force_source": (source, flags("what the axial wall force follows from", SOURCES)),
        **{name: pressure[name].values for name in ("cylinder_depth", "hydraulic_radius", "wall_friction")},
    }


def _of_cases(expansion: Resolved, values: list) -> np.ndarray:
    """One value a case, shape (axes..., 1)."""
    return np.array(values, dtype=float).reshape(*expansion.shape, 1)


def wall_parameters(expansion: Resolved, lower: np.ndarray, upper: np.ndarray) -> dict[str, np.ndarray]:
    """The buckling rules' parameters but thickness and shell_radius; `inner_radius` (m) in their place."""
    walls, silos = ([getattr(case.scene, name) for case in expansion.cases] for name in ("shell", "silo"))
    bays = [wall.bay_length or silo.wall_depth for wall, silo in zip(walls, silos, strict=True)]
    return {
        **{name: _of_cases(expansion, [wall.steel[name] for wall in walls]) for name in walls[0].steel},
        "bay_length": _of_cases(expansion, bays),
        "total_length": _of_cases(expansion, [silo.wall_depth for silo in silos]),
        "ring_area": _of_cases(expansion, [wall.ring_area for wall in walls]),
        "inner_radius": _of_cases(expansion, [silo.diameter / 2 for silo in silos]),
        "lower_internal_pressure": lower,
        "upper_internal_pressure": upper,
    }


def required_thicknesses(rules, parameters: Mapping, force: np.ndarray, safety) -> dict:
    """`required_thickness` by rule, and as its scope what masks the rule for a wall a hair thinner."""
    found = [required_thickness(rule, parameters, force, safety) for rule in rules]
    meaning = "why required_thickness is masked, or what but the strength keeps the wall from being thinner"
    return {
        "required_thickness": np.array([one[0] for one in found]),
        "required_thickness_scope": (np.array([one[1] for one in found]), flags(meaning, REASONS)),
    }


def strakes(expansion: Resolved, pressure: xr.Dataset) -> np.ndarray:
    """Thickness (m) of the strake at every depth, shape (axes..., depth); an edge belongs to the strake above it."""
    z = depths(pressure).reshape(len(expansion.cases), -1)
    found = []
    for levels, case in zip(z, expansion.cases, strict=True):
        wall, silo = case.scene.shell, case.scene.silo
        share = (levels - (silo.cylinder_depth - silo.wall_depth)) / silo.wall_depth  # the heap stands above the wall
        place = np.searchsorted(np.array(wall.edges) * (1 + 1e-9), share)
        found.append(np.array(wall.thicknesses)[place])
    return np.array(found).reshape(*expansion.shape, -1)


def utilisations(rules, parameters: Mapping, force, safety, thickness) -> dict:
    """Stress, strength, mode and utilisation of a wall of given strakes."""
    stress = force / thickness
    found = [with_thickness(rule, parameters, thickness) for rule in rules]
    strength = np.array([one["buckling_stress"] for one in found])
    scope = np.array([one["buckling_stress_scope"] for one in found])
    shape = (len(rules), force.shape[0], *force.shape[2:])
    mode = np.broadcast_to(np.array([one["buckling_mode"] for one in found]), strength.shape)
    used = safety * stress / strength[:, :, None]
    masked = np.where(np.isnan(stress), NO_LOAD, np.broadcast_to(scope[:, :, None], used.shape)).astype(np.int8)
    return {
        "wall_thickness": thickness,
        "axial_wall_stress": stress,
        "wall_buckling_stress": np.broadcast_to(strength, shape),
        "wall_buckling_stress_scope": (np.broadcast_to(scope, shape), flags("why it is masked", REASONS)),
        "wall_buckling_mode": (np.broadcast_to(mode, shape), flags("how the wall buckles (-1: masked)", MODES)),
        "utilisation": np.where(masked == IN_SCOPE, used, np.nan),
        "utilisation_scope": (masked, flags("why utilisation is masked", REASONS)),
    }
