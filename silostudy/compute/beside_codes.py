"""Theories and codes for the walls of a sweep of silos of grains, at the levels where the grains' forces were recorded."""

import numpy as np
import xarray as xr

from silostudy.errors import BadInput
from silostudy.scene.beside import PHASES
from silostudy.scene.expand import Expansion

AS_FULL = 0.15  # share by which the depths of the solid may


def matched(expansion: Expansion, codes: xr.Dataset | None, scenes: xr.Dataset) -> xr.Dataset:
    """The cube of pressures for every setting of the scenes; BadInput where its silos are not as full.

    Axes of one name belong together position by position: the scenes' walls stand higher than the solid.
    """
    name = expansion.study.codes.study
    if codes is None:
        raise BadInput("codes", name, "needs the pressure cube of that study")
    shared = [axis for axis in codes.attrs["sweep_axes"].split() if axis in codes.coords]
    return _as_full(codes.sel(phase=list(PHASES)).drop_vars(shared), scenes)


def _as_full(codes: xr.Dataset, scenes: xr.Dataset) -> xr.Dataset:
    """The cube itself; BadInput where its silos are not as full as those of the grains."""
    said, felt = xr.broadcast(codes["cylinder_depth"], scenes["filled_height_at_rest"].mean("filling"))
    far = np.abs((felt / said).values - 1.0)
    if np.isfinite(far).any() and np.nanmax(far) > AS_FULL:
        worst = np.unravel_index(np.nanargmax(far), far.shape)
        told = f"m deep, where the grains fill {float(felt.values[worst]):.3g} m: these must agree within {100 * AS_FULL:.0f} %"
        raise BadInput("codes", float(said.values[worst]), told)
    return codes


def by_phase(rest: xr.DataArray, flow: xr.DataArray) -> xr.DataArray:
    """Values at rest and in flow, as the phases that codes know."""
    return xr.concat([rest, flow], xr.IndexVariable("phase", list(PHASES)))


def depths_of(codes: xr.Dataset) -> xr.DataArray:
    """Depth (m) below the level surface of every place of the profiles."""
    return codes["depth"] if "relative_depth" not in codes.dims else codes["relative_depth"] * codes["cylinder_depth"]


def profiles(codes: xr.Dataset, settings: xr.DataArray) -> dict[str, xr.DataArray]:
    """Pressures (Pa) by theories and codes at their own depths (m) and places on the hopper: no level of cells blurs a jump."""
    along = "relative_depth" if "relative_depth" in codes.dims else "depth"
    own = {"code_profile_depth": depths_of(codes), "code_wall_profile": codes["wall_normal_pressure"]}
    data = {name: values.drop_vars(along).rename({along: "code_level"}) for name, values in own.items()}
    if "hopper_normal_pressure" in codes:
        data["code_hopper_profile"] = codes["hopper_normal_pressure"]
    return {name: values.broadcast_like(settings) for name, values in data.items()}


def at_depths(codes: xr.Dataset, name: str, depth: xr.DataArray) -> xr.DataArray:
    """Values of a profile at depths (m; settings, wall_level); NaN below the deepest place, and above the surface."""
    along = "relative_depth" if "relative_depth" in codes.dims else "depth"
    return xr.apply_ufunc(
        _interpolated, codes[name], depths_of(codes), depth, vectorize=True,
        input_core_dims=[[along], [along], ["wall_level"]], output_core_dims=[["wall_level"]],
    )  # fmt: skip


def _interpolated(values: np.ndarray, places: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    return np.interp(wanted, places, values, left=np.nan, right=np.nan)
