"""Actions on a wall in a combination: forces and pressures with their partial factors, at every place."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import xarray as xr

from silostudy.checks import tube
from silostudy.checks.family import GIVEN_BY, IN_SCOPE, NO_EARTHQUAKE, REASONS
from silostudy.choice.expand import Resolved
from silostudy.compute.checks_places import WallPlaces
from silostudy.compute.shell_places import of_cases
from silostudy.tables.combinations import Combination

FILLING = "filling"
NO_WIND = REASONS.index(f"needs_{GIVEN_BY['wind_pressure']}")


@dataclass(frozen=True)
class Characteristic:
    """Characteristic actions: places, the silo's numbers by name (axes..., 1), patch load and earthquake at the places."""

    expansion: Resolved
    places: WallPlaces
    numbers: Mapping[str, np.ndarray]
    patch: tuple[np.ndarray, np.ndarray]  # (axial force, shear (N/m)), shape (method, phase, axes..., place)
    shaken: Mapping[str, np.ndarray] | None  # force, shear (N/m), pressure (Pa), shape (axes..., place), without q


def given(expansion: Resolved, place: WallPlaces, pressure: xr.Dataset, seismic: xr.Dataset | None) -> Characteristic:
    """Everything that the combinations draw on."""
    scenes = [case.scene for case in expansion.cases]
    numbers = {name: of_cases(expansion, [scene.steelwork[name] for scene in scenes]) for name in scenes[0].steelwork}
    numbers |= {
        "inner_radius": of_cases(expansion, [scene.silo.diameter / 2 for scene in scenes]),
        "wall_height": of_cases(expansion, [scene.silo.wall_depth for scene in scenes]),
        "roof": of_cases(expansion, [scene.shell.roof_force for scene in scenes]),
        "snow": of_cases(expansion, [scene.shell.snow_force for scene in scenes]),
        "steel_weight": of_cases(expansion, [scene.shell.unit_weight for scene in scenes]),
    }
    return Characteristic(
        expansion, place, numbers, _patch(pressure, place, numbers["inner_radius"]), _shaken(place, seismic, numbers)
    )


def _patch(pressure: xr.Dataset, place: WallPlaces, radius: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Axial force and shear (N/m) by the patch load of a method and phase that has one, else 0."""
    nothing = np.zeros(place.force.shape)
    if "patch_resultant" not in pressure:
        return nothing, nothing
    names = ("patch_resultant", "patch_depth", "patch_height")
    resultant, middle, height = (pressure[name].values[..., None] for name in names)
    moment, shear = tube.patch_forces(place.z, resultant=resultant, middle=middle, height=height)
    axial, sheared = tube.ring_forces(moment, shear, radius)
    return np.nan_to_num(axial), np.nan_to_num(sheared)


def _shaken(place: WallPlaces, seismic: xr.Dataset | None, numbers: Mapping) -> dict[str, np.ndarray] | None:
    if seismic is None:
        return None
    names = {"force": "seismic_axial_wall_force", "shear": "wall_shear_force", "pressure": "seismic_wall_pressure"}
    forces = {key: np.interp(place.z, seismic["depth"], seismic[name]) for key, name in names.items()}
    return forces | {"shear": tube.ring_forces(0.0, forces["shear"], numbers["inner_radius"])[1]}


def lacking(combination: Combination, source: Characteristic) -> np.ndarray:
    """Reason why a combination cannot be checked, flag of REASONS (axes..., 1): the action that leads it is not given."""
    shape = (*source.expansion.shape, 1)
    if combination.earthquake:
        missing = source.shaken is None or source.expansion.study.checks.earthquake is None
        return np.full(shape, NO_EARTHQUAKE if missing else IN_SCOPE)
    if combination.leading in ("wind", "suction"):
        return np.where(np.isnan(source.numbers["wind_pressure"]), NO_WIND, IN_SCOPE)
    return np.full(shape, IN_SCOPE)


def of_contents(combination: Combination, source: Characteristic) -> dict[str, np.ndarray]:
    """Force, shear (N/m) and pressures (Pa) of the solid in a combination, shape (method, axes..., place)."""
    place, phases = source.places, list(source.expansion.study.phases)
    by_name = {"force": place.force, "pressure": place.pressure, "patch_force": source.patch[0], "patch_shear": source.patch[1]}
    nothing = np.zeros(place.guaranteed.shape)
    if combination.contents == "empty":
        return {**dict.fromkeys(by_name, nothing), "guaranteed": nothing}
    if combination.contents == FILLING:
        known = FILLING in phases
        chosen = {key: value[:, phases.index(FILLING)] if known else nothing * np.nan for key, value in by_name.items()}
    else:
        chosen = {key: np.fmax.reduce(value, axis=1) for key, value in by_name.items()}
    factor = combination.solids * _share_of_solids(combination, source)
    actions = {key: factor * value for key, value in chosen.items()}
    return actions | {"guaranteed": min(factor, 1.0) * place.guaranteed}


def _share_of_solids(combination: Combination, source: Characteristic) -> float:
    asked = source.expansion.study.checks.earthquake
    return asked.solids_factor if combination.earthquake and asked else 1.0


def of_wind(combination: Combination, source: Characteristic) -> dict[str, np.ndarray]:
    """Axial force and shear (N/m) of the wind, and where the silo is empty what presses from outside (Pa)."""
    number = source.numbers
    moment, shear = tube.wind_forces(
        source.places.below_top,
        pressure=np.nan_to_num(number["wind_pressure"]) * combination.wind,
        force_coefficient=np.nan_to_num(number["force_coefficient"]),
        diameter=2 * number["inner_radius"],
    )
    axial, sheared = tube.ring_forces(moment, shear, number["inner_radius"])
    outside = {
        name: getattr(combination, key) * number[name] for name, key in (("wind_pressure", "wind"), ("suction", "suction"))
    }
    if combination.contents != "empty":  # the solid presses outward, as hard as it stands there
        outside = {name: np.zeros_like(value) for name, value in outside.items()}
    return {"force": axial, "shear": sheared, **outside}


def of_earthquake(combination: Combination, source: Characteristic) -> dict[str, np.ndarray]:
    """Axial force and shear (N/m) and pressure (Pa) of the earthquake, divided by q; 0 without one."""
    asked = source.expansion.study.checks.earthquake
    if not combination.earthquake or source.shaken is None or asked is None:
        return dict.fromkeys(("force", "shear", "pressure"), np.zeros(source.places.z.shape))
    return {key: combination.earthquake / asked.behaviour_factor * value for key, value in source.shaken.items()}


def acting(combination: Combination, source: Characteristic) -> dict[str, np.ndarray]:
    """The checks' actions in a combination, shape (method, axes..., place); axial_wall_force without the wall's own weight.

    Pressed and lifted sides of an earthquake as in the shell's: what it adds to the pressure steadies nothing.
    """
    solid, wind, shaken = of_contents(combination, source), of_wind(combination, source), of_earthquake(combination, source)
    lifted = combination.side == "lifted"
    steady = solid["guaranteed"]
    imposed = combination.permanent * source.numbers["roof"] + combination.snow * source.numbers["snow"]
    pushed = -shaken["force"] if lifted else shaken["force"]
    forces = {
        "axial_wall_force": solid["force"] + solid["patch_force"] + imposed + wind["force"] + pushed,
        "shear_wall_force": solid["patch_shear"] + wind["shear"] + shaken["shear"],
        "upper_internal_pressure": solid["pressure"] + (0.0 if lifted else shaken["pressure"]),
        "lower_internal_pressure": np.maximum(steady - shaken["pressure"], 0.0) if lifted else steady,
        "wind_pressure": wind["wind_pressure"],
        "suction": wind["suction"],
    }
    forces["lower_internal_pressure"] = np.fmin(forces["lower_internal_pressure"], forces["upper_internal_pressure"])
    shape = solid["force"].shape
    return {name: np.broadcast_to(value, shape) for name, value in forces.items()}
