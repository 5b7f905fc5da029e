"""Evenness of the pressure of grains around a round wall, beside patch loads and the zones of an eccentric flow channel."""

import xarray as xr

from silostudy.compute.beside_codes import at_depths, by_phase
from silostudy.compute.beside_flow import in_full_flow

# variables of a pressure cube
CHANNEL = "channel_normal_pressure"
STATIC = "static_normal_pressure"
PATCH = "patch_load_factor"
# what EN 1991-4, 5.2.4, says of the three zones of the wall: in the cube of pressures -> in this one
ZONES = {CHANNEL: "code_channel_pressure", "adjacent_normal_pressure": "code_adjacent_pressure",
         "static_normal_pressure": "code_static_pressure"}  # fmt: skip


def around(grains: xr.Dataset, deep: xr.DataArray) -> dict[str, xr.DataArray]:
    """Pressure (Pa) over the angle, mean of the deep levels, and how far cells are from the mean around their level (1).

    Of each filling: the largest cell of any level and window over its ring's mean, less 1, and the root mean square.
    """
    rest = grains["wall_pressure_at_rest"].expand_dims("flow_window").where(deep)
    flow = in_full_flow(grains["wall_pressure_in_flow"].where(deep), grains)
    pressure = by_phase(*(cells.mean("flow_window").mean("wall_level") for cells in (rest, flow)))
    off = [_off_ring(cells) for cells in (rest, flow)]
    every = ("flow_window", "wall_level", "wall_turn")
    return {
        "pressure_around": pressure,
        "wall_turn": grains["wall_turn"],
        "largest_over_ring": by_phase(*(cells.max(every) for cells in off)),
        "deviation_around": by_phase(*((cells**2).mean(every) ** 0.5 for cells in off)),
    }


def _off_ring(cells: xr.DataArray) -> xr.DataArray:
    """Each cell's pressure over the mean around its level, less 1; missing where nothing presses."""
    ring = cells.mean("wall_turn")
    return cells / ring.where(ring > 0.0) - 1.0


def around_mean(codes: xr.Dataset) -> xr.DataArray:
    """Wall pressures (Pa) by theories and codes as means around a level.

    Of zones about a flow channel that is the static zone's: what the channel lacks, the zones beside it have more.
    Source: en1991_4_2006.
    """
    pressure = codes["wall_normal_pressure"]
    if STATIC not in codes:
        return pressure
    static = codes[STATIC].max("channel")
    return static.where(static.notnull(), pressure)


def zones(codes: xr.Dataset, depth: xr.DataArray, deep: xr.DataArray) -> dict[str, xr.DataArray]:
    """Loads around the wall by codes: patch pressure over wall pressure, and where a study has them, the pressures (Pa) of
    flow channel, zone beside it and the rest, mean of the deep levels, with the channel's half width (rad)."""
    settings = depth.isel(wall_level=0, drop=True)  # which codes need not sweep
    factors = {"code_patch_factor": codes[PATCH].broadcast_like(settings)} if PATCH in codes else {}
    if CHANNEL not in codes:
        return factors
    there = deep.any("filling")
    said = {own: at_depths(codes, name, depth).where(there).mean("wall_level") for name, own in ZONES.items()}
    width = {"code_channel_half_width": codes["channel_half_width"].broadcast_like(settings), "channel": codes["channel"]}
    return factors | said | width
