"""Hoppers of silos of grains beside what theories and codes say of them: at rest, in flow, and while the switch passes."""

import numpy as np
import xarray as xr

from silostudy.compute.beside_codes import by_phase
from silostudy.cube.areas import step_of


def in_cone(grains: xr.Dataset) -> dict[str, xr.DataArray]:
    """Loads on the hopper: place on it, mean pressure around (Pa) at rest and in flow, the largest, its rise, and when.

    The rise is over the mean of the fillings at rest: single levels of a filling may hang free.
    """
    height = grains["hopper_level_height"]
    top = height.isel(wall_level=-1) + step_of(height) / 2
    rest = grains["hopper_pressure_at_rest"].mean("wall_turn")
    flow, usual = grains["hopper_pressure_in_flow"].mean("wall_turn"), rest.mean("filling")
    return {
        "hopper_level_position": 1.0 - height / top,
        "hopper_ring_pressure": by_phase(rest, flow.mean("flow_window")),
        "hopper_ring_largest": flow.max("flow_window"),
        "hopper_switch_factor": (flow / usual.where(usual > 0.0)).max("flow_window"),
        "hopper_switch_time": _time_of_largest(flow, grains["flow_window_end"]),
    }


def _time_of_largest(flow: xr.DataArray, end: xr.DataArray) -> xr.DataArray:
    """End (s after the first event) of the window in which each level feels most; missing where nothing was felt."""
    there = flow.notnull().any("flow_window")
    window = flow.fillna(-1.0).argmax("flow_window")
    return end.isel(flow_window=window).where(there)


def compared_in_hopper(data: dict[str, xr.DataArray]) -> dict[str, xr.DataArray]:
    """Ratios of what methods say of the hopper to what the grains did: of its mean pressure, and next to the transition to the
    largest window."""
    if "code_hopper_profile" not in data:
        return {}
    ring, place = data["hopper_ring_pressure"], data["hopper_level_position"].mean("filling")
    code = at_places(data["code_hopper_profile"], place)
    both = code.notnull() & ring.notnull()
    mean, felt = (values.where(both).sum("wall_level", min_count=1) for values in (code, ring))
    top = {"wall_level": -1}
    peak = data["hopper_ring_largest"].isel(top)
    return {"code_over_grains_hopper": mean / felt, "code_over_grains_transition": code.isel(top) / peak.where(peak > 0.0)}


def at_places(profile: xr.DataArray, place: xr.DataArray) -> xr.DataArray:
    """Pressure (Pa) of a profile over the hopper at places (settings, wall_level) from 0, the transition, to 1, the outlet."""
    return xr.apply_ufunc(
        _interpolated, profile, profile["hopper_position"], place, vectorize=True,
        input_core_dims=[["hopper_position"], ["hopper_position"], ["wall_level"]], output_core_dims=[["wall_level"]],
    )  # fmt: skip


def _interpolated(values: np.ndarray, places: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    return np.interp(wanted, places, values, left=np.nan, right=np.nan)
