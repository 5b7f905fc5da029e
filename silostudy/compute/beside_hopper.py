"""Hoppers of silos of grains beside what theories and codes say of them: at rest, in flow, and while the switch passes."""

import numpy as np
import xarray as xr

from silostudy.compute.beside_codes import by_phase
from silostudy.compute.beside_flow import in_full_flow
from silostudy.cube.areas import step_of

HOPPER = "hopper"  # among what bears on the grains


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
        "hopper_ring_pressure": by_phase(rest, in_full_flow(flow, grains).mean("flow_window")),
        "hopper_ring_largest": flow.max("flow_window"),
        "hopper_switch_factor": (flow / usual.where(usual > 0.0)).max("flow_window"),
        "hopper_mobilised_friction": by_phase(*_friction(grains)),
        "hopper_switch_time": _time_of_largest(flow, grains["flow_window_end"]),
    }


def _friction(grains: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Shear over pressure (1) on the whole hopper at rest and in flow."""
    over = ("wall_level", "wall_turn")
    rest, flow = ([grains[f"hopper_{what}_{when}"] for what in ("shear", "pressure")] for when in ("at_rest", "in_flow"))
    shear, pressure = (in_full_flow(values, grains).sum((*over, "flow_window")) for values in flow)
    return rest[0].sum(over) / rest[1].sum(over), shear / pressure


def _time_of_largest(flow: xr.DataArray, end: xr.DataArray) -> xr.DataArray:
    """End (s after the first event) of the window in which each level feels most; missing where nothing was felt."""
    there = flow.notnull().any("flow_window")
    window = flow.fillna(-1.0).argmax("flow_window")
    return end.isel(flow_window=window).where(there)


def compared_in_hopper(data: dict[str, xr.DataArray]) -> dict[str, xr.DataArray]:
    """Ratios of what methods say of the hopper to what the grains did: its mean pressure, and that next to the transition."""
    if "code_hopper_profile" not in data:
        return {}
    ring, place = data["hopper_ring_pressure"], data["hopper_level_position"].mean("filling")
    code = at_places(data["code_hopper_profile"], place)
    both = code.notnull() & ring.notnull()
    mean, felt = (values.where(both).sum("wall_level", min_count=1) for values in (code, ring))
    top = {"wall_level": -1}
    most = by_phase(ring.sel(phase="filling", drop=True), data["hopper_ring_largest"]).isel(top)
    return {"code_over_grains_hopper": mean / felt, "code_over_grains_transition": code.isel(top) / most.where(most > 0.0)}


def at_places(profile: xr.DataArray, place: xr.DataArray) -> xr.DataArray:
    """Pressure (Pa) of a profile over the hopper at places (settings, wall_level) from 0, the transition, to 1, the outlet."""
    return xr.apply_ufunc(
        _interpolated, profile, profile["hopper_position"], place, vectorize=True,
        input_core_dims=[["hopper_position"], ["hopper_position"], ["wall_level"]], output_core_dims=[["wall_level"]],
    )  # fmt: skip


def _interpolated(values: np.ndarray, places: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    return np.interp(wanted, places, values, left=np.nan, right=np.nan)


def forces(codes: xr.Dataset, grains: xr.Dataset) -> dict[str, xr.DataArray]:
    """Downward force of methods on the hopper, with their ring force, over the grains': at rest, and at its largest in flow."""
    if "hopper_wall_force" not in codes or "largest_body_load" not in grains or HOPPER not in grains["body"]:
        return {}
    felt = by_phase(*(grains[name].sel(body=HOPPER, drop=True) for name in ("body_load_at_rest", "largest_body_load")))
    ring = codes["ring_force"].fillna(0.0) if "ring_force" in codes else 0.0
    said = codes["hopper_wall_force"] + ring
    return {"code_over_grains_hopper_force": said / felt.where(felt > 0.0)}
