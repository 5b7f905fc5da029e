"""Lines of `silostudy compare` on loads beside the symmetric ones: bottom, patch, eccentric discharge."""

from collections.abc import Iterator
from itertools import product
from math import degrees, isfinite
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr


def told(cube: "xr.Dataset") -> list[str]:
    """The lines of every load case that the cube holds."""
    return [*_bottom(cube), *_floor(cube), *_patches(cube), *_bands(cube), *_sides(cube), *_channels(cube), *_class(cube)]


def _states(cube: "xr.Dataset", name: str) -> Iterator[tuple[str, "xr.Dataset"]]:
    """Name for people and values of every method and phase that gives a number; none where the cube does not hold it."""
    if name in cube:
        for method, phase in product(map(str, cube["pressure_method"].values), map(str, cube["phase"].values)):
            state = cube.sel(pressure_method=method, phase=phase)
            if isfinite(float(state[name])):
                yield f"{method}, {phase}", state


def _headed(head: str, lines: list[str]) -> list[str]:
    return [head, *lines] if lines else []


def _bottom(cube: "xr.Dataset") -> list[str]:
    lines = []
    for name, state in _states(cube, "bottom_pressure"):
        magnifier = float(state["bottom_load_magnifier"]) if "bottom_load_magnifier" in state else float("nan")
        lines.append(f"{name:44}{float(state['bottom_pressure']) / 1e3:10.2f}" + f"  C_b {magnifier:.2f}" * isfinite(magnifier))
    return _headed("mean vertical pressure on the bottom (kPa)", lines)


def _floor(cube: "xr.Dataset") -> list[str]:
    lines = []
    for place in cube["floor_position"].values if "floor_position" in cube else ():
        for name, state in _states(cube.sel(floor_position=place), "floor_normal_pressure"):
            pressure, shear = (float(state[f"floor_{what}"]) / 1e3 for what in ("normal_pressure", "shear_traction"))
            lines.append(f"{name:44}{pressure:10.2f}{shear:9.2f}  {place:.2f} of the radius")
    return _headed("flat floor (kPa): pressure and outward shear from the middle to the wall", lines)


def _patches(cube: "xr.Dataset") -> list[str]:
    lines = []
    for name, state in _states(cube, "patch_pressure"):
        pressure, depth, height, force = (
            float(state[f"patch_{what}"]) for what in ("pressure", "depth", "height", "resultant")
        )
        lines.append(f"{name:44}{pressure / 1e3:10.2f}{depth:9.2f}m{height:9.2f}m{force / 1e3:9.1f} kN")
    return _headed(f"patch load p_p cos(angle) (kPa){'':18}p_p    middle    height resultant", lines)


def _bands(cube: "xr.Dataset") -> list[str]:
    lines = [
        f"{name:44}{float(state['band_pressure']) / 1e3:10.2f}{float(state['patch_height']):19.2f}m"
        for name, state in _states(cube, "band_pressure")
    ]
    return _headed("band of pressure all round a plan that is no circle, at half the depth (kPa), and its height", lines)


def _sides(cube: "xr.Dataset") -> list[str]:
    lines = []
    for name, state in _states(cube, "far_side_increase"):
        if float(state["far_side_increase"]) > 0:
            more, less, middle = (float(state[what]) for what in ("far_side_increase", "near_side_decrease", "far_side_depth"))
            height, arc = float(state["eccentric_band_height"]), degrees(float(state["near_side_half_angle"]))
            far = f"far side up to +{more:.1%} (cosine), {height:.2f} m about {middle:.2f} m"
            lines.append(f"{name}: {far}; near side -{less:.1%} within {arc:.0f} deg, {height:.2f} m up from the outlet")
    return lines


def _channels(cube: "xr.Dataset") -> list[str]:
    """The zones of wall in large eccentric discharge at the transition, a line for each size of the flow channel."""
    zones, lines = ("channel", "adjacent", "static"), []
    for size in cube["channel"].values if "channel" in cube else ():
        for name, state in _states(cube.sel(channel=size), "channel_half_width"):
            edge = degrees(float(state["channel_half_width"]))
            pressures = "".join(f"{float(state[f'{zone}_normal_pressure'][-1]) / 1e3:9.2f}" for zone in zones)
            forces = "".join(f"{float(state[f'channel_{force}']) / 1e3:12.1f}" for force in ("shear", "moment"))
            lines.append(f"{name}, k_c {size:.2f}, within {edge:.1f}, to {2 * edge:.1f} deg{pressures}{forces}")
    head = "flow channel: (kPa at the transition) in it, beside it, at rest; shear (kN) and moment (kN m) at the transition"
    return _headed(head, lines)


def _class(cube: "xr.Dataset") -> list[str]:
    """The least action assessment class by capacity and outlet, where a method judges it."""
    least = {f"{float(state['least_assessment_class']):.0f}" for _, state in _states(cube, "least_assessment_class")}
    return [f"action assessment class of EN 1991-4: {', '.join(sorted(least))} or higher"] if least else []
