"""Governing check of each part of a silo's steel: utilisation by combination of actions, and the load case behind it."""

from collections.abc import Iterator, Mapping

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE

BUCKLING = "buckling"
# flags of the checks' scope
NO_LOAD = "load_or_pressure_masked"
OUT_OF_RANGE = "out_of_range"
PATCHED = "_with_patch"
WALL_CASES = {"axial force": "axial_wall_force_load_case", "pressure": "wall_pressure_load_case"}
HOPPER_CASES = {"meridian": "hopper_meridional_force_load_case", "hoop": "hopper_hoop_force_load_case"}
SUPPORT_CASES = {"wall": "axial_wall_force_load_case", "hopper": "hopper_meridional_force_load_case"}


def parts(cube: xr.Dataset, method: str, rule: str) -> Iterator[dict]:
    """A record for every part and combination: part, combination, utilisation, governed_by, load_case, state.

    state: `checked`; `masked` where a rule or check is beyond its range on a part that is loaded; `not checked`.
    Strakes from the top, hopper, then each check of ring, beam and anchors; the worst of all cases of a sweep.
    """
    steel = cube.sel({"pressure_method": method, "rule": rule})
    for combination in map(str, cube["combination"].values):
        here = steel.sel(combination=combination)
        for strake in map(int, cube["strake"].values) if "strake" in cube.dims else ():
            yield {"part": f"strake {strake}", "combination": combination, **_strake(here, strake)}
        if "hopper_check" in cube.dims:
            yield {"part": "hopper", "combination": combination, **_hopper(here)}
        for check in map(str, cube["support_check"].values):
            support = _support(here.sel(support_check=check), check)
            yield {"part": check.replace("_", " "), "combination": combination, **support}


def _strake(here: xr.Dataset, strake: int) -> dict:
    inside = here["place_strake"] == strake
    names = [BUCKLING, *map(str, here["steel_check"].values)]
    arrays = [here["design_buckling_utilisation"], *here["design_check_utilisation"]]
    flags = here["design_buckling_utilisation" + SCOPE]
    beyond = inside & (flags != 0) & (flags != flags.attrs["flag_meanings"].split().index(NO_LOAD))
    scopes = here["design_check_utilisation" + SCOPE]
    unjudged = inside & (scopes == scopes.attrs["flag_meanings"].split().index(OUT_OF_RANGE))
    return _worst(names, [array.where(inside) for array in arrays], here, WALL_CASES, bool(beyond.any() or unjudged.any()))


def _hopper(here: xr.Dataset) -> dict:
    return _worst(list(map(str, here["hopper_check"].values)), list(here["hopper_check_utilisation"]), here, HOPPER_CASES)


def _support(here: xr.Dataset, check: str) -> dict:
    whose = str(here["support_check_loaded_by"].values).split()
    cases = {what: name for what, name in SUPPORT_CASES.items() if what in whose}
    return _worst([check], [here["support_check_utilisation"]], here, cases)


def _worst(
    names: list[str], uses: list[xr.DataArray], here: xr.Dataset, cases: Mapping[str, str], masked: bool = False
) -> dict:
    """The largest of some checks, each over places and cases, and what acts where it stands."""
    arrays = xr.broadcast(*uses)
    values = np.array([array.values for array in arrays])
    if np.isnan(values).all() or masked:
        return {"utilisation": np.nan, "governed_by": "", "load_case": "", "state": "masked" if masked else "not checked"}
    check, *place = np.unravel_index(np.nanargmax(values), values.shape)
    position = dict(zip(map(str, arrays[0].dims), map(int, place), strict=True))
    worst = {"utilisation": float(values[(check, *place)]), "governed_by": names[check]}
    return {**worst, "load_case": _load_case(here, cases, position), "state": "checked"}


def _load_case(here: xr.Dataset, cases: Mapping[str, str], position: Mapping[str, int]) -> str:
    """The load case of the contents at a place: of each action by its name, where they come from different ones."""
    contents = str(here["combination_contents"].values)
    if contents != "full":
        return contents
    told = {what: _flag(here[name], position) for what, name in cases.items() if name in here}
    phases = {case.removesuffix(PATCHED) for case in told.values()}
    if not told:
        return contents
    if len(phases) == 1:
        return max(told.values(), key=len).replace("_", " ")
    return "; ".join(f"{what}: {case}" for what, case in told.items()).replace("_", " ")


def _flag(values: xr.DataArray, position: Mapping[str, int]) -> str:
    """A flag in words at a place; at what lies below the cylinder: of the foot of the wall and the top of the hopper."""
    ends = {"place": -1, "hopper_position": 0}
    flag = values.isel({dim: position.get(str(dim), ends.get(str(dim), 0)) for dim in values.dims})
    return values.attrs["flag_meanings"].split()[int(flag)]
