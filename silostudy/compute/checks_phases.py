"""The worst load case of the contents, where a combination takes that: a phase, with or without its patch."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from silostudy.checks import hopper
from silostudy.compute.checks_actions import Characteristic
from silostudy.compute.checks_supports import heights, pressures_in_hopper
from silostudy.cube.variables import flags

# load cases of the contents besides phases
NONE = "no_load"
ALIKE = "every_phase_alike"
TOLERANCE = 1e-9  # relative, within which two phases count as alike


def contents_load_cases(source: Characteristic, pressure: xr.Dataset) -> dict[str, tuple]:
    """The worst load case of axial force and pressure at every place, and of both forces in the hopper's wall."""
    phases, place = list(source.expansion.study.phases), source.places
    cases = {
        "axial_wall_force_load_case": (place.force, source.patch[0]),
        "wall_pressure_load_case": (place.pressure, np.zeros_like(place.pressure)),
    }
    cases |= {name: (force, np.zeros_like(force)) for name, force in _of_hopper(pressure).items()}
    told = flags(
        "load case of the contents that is the worst", [NONE, *phases, *(f"{phase}_with_patch" for phase in phases), ALIKE]
    )
    return {name: (_worst(*parts), told) for name, parts in cases.items()}


def _of_hopper(pressure: xr.Dataset) -> Mapping[str, np.ndarray]:
    if "hopper_position" not in pressure:
        return {}
    normal, traction = pressures_in_hopper(pressure)
    height, half_angle = heights(pressure)
    shape = {"height": height, "half_angle": half_angle}
    along, around = hopper.meridional_force(normal, traction, **shape), hopper.hoop_force(normal, **shape)
    return {"hopper_meridional_force_load_case": along, "hopper_hoop_force_load_case": around}


def _worst(symmetric: np.ndarray, patch: np.ndarray) -> np.ndarray:
    """Flag of the worst load case, from (method, phase, axes..., place) to the same without the phase."""
    whole = symmetric + patch
    count, known = whole.shape[1], np.isfinite(whole)
    filled = np.where(known, whole, -np.inf)
    phase = filled.argmax(axis=1)
    patched = np.take_along_axis(patch, phase[:, None], axis=1)[:, 0] > 0
    most, least = filled.max(axis=1), np.where(known, whole, np.inf).min(axis=1)
    with np.errstate(invalid="ignore"):
        alike = (known.sum(axis=1) > 1) & (most - least <= TOLERANCE * np.abs(most))
    case = np.where(alike & ~patched, 2 * count + 1, 1 + phase + count * patched)
    return np.where(known.any(axis=1) & (most > 0), case, 0).astype(np.int8)
