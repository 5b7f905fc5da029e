"""The earthquake's load case on a silo's shell: base motion's axial force and EN 1998-4's pressure beside the static loads.

Where the wall bends, one side is pressed and the other lifted, and the motion turns them about.  On the pressed side the
inertia of the contents also leans on the wall, on the lifted side it hangs back.  Peaks are added to the static loads as
if they came at once, at their characteristic values: no combination rule and no partial factor was verified.
"""

import numpy as np
import xarray as xr

from silostudy.choice.expand import resolved
from silostudy.cube.contract import SCOPE, VARIABLES
from silostudy.errors import BadInput
from silostudy.scene.expand import Expansion

SIDES = ("pressed", "lifted")
PREFIX = "earthquake_"
UNCHECKED = (
    "with the earthquake: horizontal motion; characteristic values, no combination or partial factors; no friction by the "
    "added pressure; no check of the wall's shear"
)


def of_this_study(expansion: Expansion, seismic: xr.Dataset | None) -> xr.Dataset:
    """The seismic cube itself; BadInput unless it is that of the study that the shell study names."""
    name = expansion.study.earthquake.study
    if seismic is None:
        raise BadInput("earthquake", name, "needs the seismic cube of that study")
    asked = resolved(expansion.cases[0].scene.earthquake, name).study  # the same for all cases
    if asked.model_dump_json(exclude_defaults=True) != seismic.attrs["study"]:
        raise BadInput("seismic cube", seismic.attrs["title"], f"is of another study than {name}")
    return seismic


def earthquake_loads(z: np.ndarray, seismic: xr.Dataset) -> list[np.ndarray]:
    """Axial wall force (N/m) by the overturning moment, and additional wall pressure (Pa), at depths z (m)."""
    return [np.interp(z, seismic["depth"], seismic[name]) for name in ("seismic_axial_wall_force", "seismic_wall_pressure")]


def earthquake_told(of_choice: xr.Dataset) -> dict[str, str | float]:
    """Attributes of the shell's cube on its earthquake."""
    return {
        "earthquake": of_choice.attrs["title"],
        "earthquake_base_motion": str(of_choice["base_motion"].values),
        "earthquake_mass_coefficient": float(of_choice["mass_choice_coefficient"]),
        "earthquake_mass_coefficient_end": int(of_choice["candidate_end"][0])
        if str(of_choice["mass_choice"].values) == "identified"
        else 0,
        "earthquake_base_shear_N": float(of_choice["base_shear"]),
        "earthquake_base_moment_N_m": float(of_choice["base_moment"]),
    }


def sides(force, lower, upper, *, seismic_force, seismic_pressure) -> dict[str, tuple]:
    """Axial wall force (N/m), lower and upper internal pressure (Pa) by side: static loads and the earthquake's peaks.

    Pressed: more axial force, and more pressure to yield under, none of it counted on to steady the wall.  Lifted: less of
    either; the solid cannot pull on the wall.
    """
    return {
        "pressed": (force + seismic_force, lower, upper + seismic_pressure),
        "lifted": (force - seismic_force, np.maximum(lower - seismic_pressure, 0.0), upper),
    }


def beside(sides: list[dict]) -> dict:
    """Variables of every side in one, under names of their own: dimension `side` first."""
    stacked: dict = {}
    for name in sides[0]:
        own = PREFIX + name
        if own.removesuffix(SCOPE) not in VARIABLES:  # the wall's own thickness has no sides
            continue
        values_by_side = [side[name] for side in sides]
        if isinstance(values_by_side[0], tuple):
            told = {**values_by_side[0][1], **({"long_name": VARIABLES[own].long_name} if own in VARIABLES else {})}
            stacked[own] = np.array([values for values, _ in values_by_side]), told
        else:
            stacked[own] = np.array(values_by_side)
    return stacked
