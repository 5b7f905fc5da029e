"""Lines of `silostudy compare` on the checks of a shell study: strakes, hopper, supports, and what was not checked."""

from math import isnan
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr

SECTION = "not checked without the section checks: combinations of actions, and"


MASKED = "   masked: beyond the rule or a check, or no load"


def lines_of(expansion, pressure: "xr.Dataset", seismic: "xr.Dataset | None") -> list[str]:
    """The lines on the checks, or which of them the study does not ask for."""
    from silostudy.checks import CHECKS, SOLID_CHECKS

    if expansion.study.checks is None:
        return [f"{SECTION} {', '.join(key for key in CHECKS if key not in SOLID_CHECKS)}"]
    from silostudy.compute.checks import checks_cube
    from silostudy.cube.unchecked import unchecked

    cube = checks_cube(expansion, pressure, seismic)
    return ["", *strakes(cube), *parts(cube), *(f"note: {line}" for line in [*unchecked(cube), *ranges(cube)])]


def ranges(cube: "xr.Dataset") -> list[str]:
    """A line for every check that is silent somewhere because the steel is out of its range: its limits."""
    from silostudy.checks import CHECKS
    from silostudy.checks.family import OUT_OF_RANGE
    from silostudy.cube.contract import SCOPE
    from silostudy.cube.unchecked import PARTS

    silent = [
        check
        for axis, name in PARTS.items()
        if name in cube
        for check in map(str, cube[axis].values)
        if (cube[name + SCOPE].sel({axis: check}) == OUT_OF_RANGE).any()
    ]
    return [f"{check}: out of range where not {'; '.join(limit.words() for limit in CHECKS[check].bounds)}" for check in silent]


def strakes(cube: "xr.Dataset") -> list[str]:
    """A line for every method, rule and strake: thickness needed and utilisation, each with check and combination."""
    if "design_strake_thickness" not in cube:
        return _whole_wall(cube)
    head = f"{'under combinations: method, rule, strake':56}as built    needed   governed by{'':22}utilised   governed by"
    lines = [head]
    for method, rule, strake in _places(cube):
        of_strake = cube.sel({"pressure_method": method, "rule": rule, "strake": strake})
        built = cube["place_thickness"].values[cube["place_strake"].values == strake][0]
        name = f"{method}, {rule}, {strake}"
        needed, used = (_worst(of_strake, f"design_strake_{what}") for what in ("thickness", "utilisation"))
        text = MASKED if isnan(needed[0]) else f"{needed[0] * 1e3:7.2f} mm   {needed[1]}"
        lines.append(f"{name:56}{built * 1e3:7.2f} mm{text:43} {MASKED if isnan(used[0]) else f'{used[0]:8.3f}   {used[1]}'}")
    return [*lines, "needed: if the whole wall were so thick; as built, thick courses steady thin ones against wind"]


def _places(cube: "xr.Dataset"):
    for method in map(str, cube["pressure_method"].values):
        for rule in map(str, cube["rule"].values):
            for strake in cube["strake"].values:
                yield method, rule, int(strake)


def _whole_wall(cube: "xr.Dataset") -> list[str]:
    lines = [f"{'under combinations: method, rule':56}needed   governed by"]
    for method in map(str, cube["pressure_method"].values):
        for rule in map(str, cube["rule"].values):
            value, by = _worst(cube.sel({"pressure_method": method, "rule": rule}), "design_thickness")
            lines.append(f"{f'{method}, {rule}':56}{value * 1e3:6.2f} mm   {by}" if not isnan(value) else f"{method}: masked")
    return lines


def _worst(of_strake: "xr.Dataset", name: str) -> tuple[float, str]:
    """Largest number over cases and places, with the check and combination behind it."""
    import numpy as np

    values = of_strake[name].values.ravel()
    if np.isnan(values).all():
        return float("nan"), ""
    place = int(np.nanargmax(values))
    words = []
    for what in ("check", "combination"):
        flags = of_strake[f"{name}_{what}"]
        words.append(flags.attrs["flag_meanings"].split()[int(flags.values.ravel()[place])])
    return float(values[place]), f"{words[0]} in {words[1]}"


def parts(cube: "xr.Dataset") -> list[str]:
    """A line for every check of hopper and supports: the largest utilisation by method."""
    from silostudy.cube.unchecked import PARTS

    lines = []
    for axis, name in PARTS.items():
        if axis in cube.dims and axis != "steel_check":
            for check in map(str, cube[axis].values):
                for method in map(str, cube["pressure_method"].values):
                    lines += _part(cube.sel({axis: check, "pressure_method": method}), name, f"{method}, {check}")
    return lines


def _part(part: "xr.Dataset", name: str, label: str) -> list[str]:
    """The largest utilisation, or that the method gives no load for it; nothing where no combination checks it."""
    from silostudy.cube.contract import SCOPE
    from silostudy.cube.unchecked import worst_combination

    used, where = worst_combination(part[name], part[name + SCOPE])
    if not where:
        return []
    return [f"{label:56}{'':53}{'-' if isnan(used) else f'{used:.3f}':>8}   {where if isnan(used) else f'in {where}'}"]
