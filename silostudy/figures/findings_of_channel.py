"""Findings of silos of grains whose outlet is off the axis: pressures on its side, beside the zones that methods give."""

from typing import Any

import numpy as np
import xarray as xr

from silostudy.figures.beside import judged, row

SIDE = np.pi / 4  # rad to both sides of a direction
LEAST = 1e-6  # rad by which cells are equally near
RELIEVED = "takes more off the wall than the grains do"
NOT_RELIEVED = "takes no more off the wall than the grains do, or nobody can tell"
ZONES = {"channel": 0.0, "adjacent": 1.0}  # zone -> where it begins, in half widths of the channel


def of_channel(silo: xr.Dataset, about: dict[str, Any]) -> list[dict[str, Any]]:
    """Rows of the outlet's side over the far one, and of each method's channel and adjacent zone over the grains there."""
    if "code_channel_pressure" not in silo:
        return []
    ratio = near_over_far(silo)
    quantity = "wall pressure within 45 degrees of the outlet's side over that opposite"
    lines = [row(ratio.sel(phase=phase), **about, phase=phase, quantity=quantity) for phase in silo["phase"].values]
    flow = silo.sel(phase="discharge")
    for method in map(str, silo["pressure_method"].values):
        for size in silo["channel"].values:
            said = flow.sel(pressure_method=method, channel=size)
            if said["code_channel_half_width"].notnull():
                lines += [_zone(said, zone, size, about | {"of": method, "phase": "discharge"}) for zone in ZONES]
    return lines


def near_over_far(silo: xr.Dataset) -> xr.DataArray:
    """Wall pressure within 45 degrees of the outlet's side over that opposite (1)."""
    felt, angle = silo["pressure_around"], off_outlet(silo["wall_turn"])
    near, far = (felt.where(side).mean("wall_turn") for side in (angle <= SIDE, angle >= np.pi - SIDE))
    return near / far


def _zone(said: xr.Dataset, zone: str, size: float, about: dict[str, Any]) -> dict[str, Any]:
    """A method's pressure in a zone over the grains' there: the nearest cell where it is narrower.

    Channels take pressure off the wall, what is beside them adds some.
    """
    wide = float(said["code_channel_half_width"])
    begin = ZONES[zone] * wide
    off = abs(off_outlet(said["wall_turn"]) - begin - wide / 2)
    there = off <= max(wide / 2, float(off.min()) + LEAST)
    felt = said["pressure_around"].where(there).mean("wall_turn")
    ratio, quantity = (
        said[f"code_{zone}_pressure"] / felt,
        f"pressure in the {zone} zone (k_c = {size:.2f}) over the grains' there",
    )
    if zone == "adjacent":
        return judged(ratio, **about, quantity=quantity)
    line = row(ratio, **about, quantity=quantity)
    return line | {"verdict": RELIEVED if line["high_95"] < 1.0 else NOT_RELIEVED}


def off_outlet(turn: xr.DataArray) -> xr.DataArray:
    """Angle (rad) from the outlet's side, 0 to pi, of the middle of cells about the axis."""
    return abs((turn + np.pi) % (2.0 * np.pi) - np.pi)
