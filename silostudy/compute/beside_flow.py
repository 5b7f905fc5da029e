"""Flow of silos of grains: the windows in which they are still full, and the rate at which they empty."""

import numpy as np
import xarray as xr

from silostudy.scene.expand import Expansion
from silostudy.scene.outflow import beverloo
from silostudy.tables.constants import ROUNDED_GRAVITY

FULL = 0.9  # share of the grains that are left at the end of the windows whose mean is that of the flow
COUNTED = ("grains", "discs")
# least and largest of Beverloo's law: its constant in print, and the edge (grain diameters) found for spheres
LAW = {"least_law_mass_flow": (0.55, 2.0), "largest_law_mass_flow": (0.65, 1.0)}


def in_full_flow(values: xr.DataArray, grains: xr.Dataset) -> xr.DataArray:
    """Values in the windows that end while nearly all grains are left: of a silo that has sunk no mean is one of its depth."""
    return values.where(full_windows(grains))


def full_windows(grains: xr.Dataset) -> xr.DataArray:
    """Windows that end while nearly all grains are left, at an even rate of flow; the first in any case."""
    windows, end = grains["flow_window"], grains["flow_window_end"]
    named = [name for name in COUNTED if f"{name}_left" in grains]
    if not named:
        return xr.ones_like(end, dtype=bool)
    gone = 1.0 - grains[f"{named[0]}_left"] / grains[f"{named[0]}_at_start"]
    left = 1.0 - gone * end / (grains["end_time"] - grains["first_event_time"])
    return (left >= FULL) | (windows == windows[0])


def outflow(grains: xr.Dataset, expansion: Expansion) -> dict[str, xr.DataArray]:
    """Mass flow (kg/s) out of the silo, and the least and largest that Beverloo's law gives; none where it is not known."""
    if "mean_mass_flow" not in grains or "mean_grain_diameter" not in grains:
        return {}
    flow, grain = grains["mean_mass_flow"], grains["mean_grain_diameter"]
    widths = np.array([_outlet(case.scene.config) for case in expansion.cases]).reshape(expansion.shape)
    wide = xr.DataArray(widths, dims=grains.attrs["sweep_axes"].split()).rename(dict(zip(
        grains.attrs["sweep_axes"].split(), flow.dims, strict=True)))  # fmt: skip
    density = grains["unit_weight_at_rest"] / ROUNDED_GRAVITY
    return {"filling_mass_flow": flow} | {name: beverloo(wide, grain, density, *of_law) for name, of_law in LAW.items()}


def _outlet(scene) -> float:
    """Width (m) of the one round outlet of a scene; NaN where there is none, or several."""
    if scene.silo.hopper:
        return scene.silo.hopper.outlet_width_m
    round_ones = [outlet.width_m for outlet in scene.outlets if outlet.length_m is None]
    return round_ones[0] if len(round_ones) == len(scene.outlets) == 1 else np.nan
