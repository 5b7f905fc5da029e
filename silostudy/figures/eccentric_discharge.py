"""Wall pressure round a silo whose outlet lies off the axis: zones of each flow channel, and codes that move the pressure.

Left: round the wall from the outlet's side, at the transition; a code with a far and a near side in the middle of its far
side's band.  Right: what the pressures of a channel's zones come to, over the depth.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import look, save, silent, title
from silostudy.tables.outputs import output_of

(PHASE,) = output_of(__name__).phases
LINES = ((0, (1, 1)), (0, (4, 2)), "-")  # by the size of the channel
ZONES = ("channel", "adjacent", "static")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the curves that it shows."""
    unspoken, cube = silent(cube), cube.sel({"phase": PHASE})
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 6.6), width_ratios=(1.5, 1))
    tables = []
    for method in _with(cube, "channel_half_width"):
        for size, line in zip(cube["channel"].values, LINES, strict=True):
            one = cube.sel(pressure_method=method, channel=size)
            name, style = f"{title(cube, method)}, k_c = {size:.2f}", {**look(cube, method), "linestyle": line, "marker": ""}
            tables += [_zones(one).assign(curve=name), _resultant(one).assign(curve=name)]
            left.plot(tables[-2].angle_deg, tables[-2].wall_normal_pressure_kPa, label=name, **style)
            right.plot(tables[-1].resultant_kN_m, tables[-1].depth_m, **style)
    for method in _with(cube, "far_side_pressure"):
        one = cube.sel(pressure_method=method)
        if float(one["far_side_increase"]) > 0:
            name = f"{title(cube, method)}, {float(one['far_side_depth']):.1f} m deep"
            tables.append(_sides(one).assign(curve=name))
            left.plot(
                tables[-1].angle_deg, tables[-1].wall_normal_pressure_kPa, label=name, **look(cube, method) | {"marker": ""}
            )
    left.set(xlabel="angle from the outlet's side (°)", ylabel="wall normal pressure (kPa)", xlim=(0, 180), ylim=(0, None))
    left.set_xticks(range(0, 181, 30))
    right.set(xlabel="resultant away from the channel (kN/m)", ylabel="depth z (m)", xlim=(0, None))
    right.set_ylim(float(cube["cylinder_depth"]), 0)
    handles = [*left.get_legend_handles_labels()[0], *unspoken]
    figure.legend(handles=handles, loc="outside lower center", ncols=2, fontsize=8)
    figure.suptitle(f"{cube.attrs['title']}\nleft: at the transition, {float(cube['cylinder_depth']):.1f} m deep")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _with(cube: xr.Dataset, name: str) -> list[str]:
    """The methods that give a quantity."""
    methods = map(str, cube["pressure_method"].values)
    return [method for method in methods if name in cube and cube[name].sel(pressure_method=method).notnull().any()]


def _zones(one: xr.Dataset) -> pd.DataFrame:
    """Pressure from the channel's axis to the far side: three steps."""
    edge = np.degrees(float(one["channel_half_width"]))
    pressures = [float(one[f"{zone}_normal_pressure"][-1]) / 1e3 for zone in ZONES]
    ends = np.array([0.0, edge, edge, 2 * edge, 2 * edge, 180.0])
    return pd.DataFrame({"angle_deg": ends, "wall_normal_pressure_kPa": np.repeat(pressures, 2)})


def _resultant(one: xr.Dataset) -> pd.DataFrame:
    return pd.DataFrame({"depth_m": one["depth"].values, "resultant_kN_m": one["channel_resultant"].values / 1e3})


def _sides(one: xr.Dataset) -> pd.DataFrame:
    """Pressure from the outlet's side to the far one: a relief over an arc, and a cosine added over the far half."""
    more, arc = float(one["far_side_increase"]), np.degrees(float(one["near_side_half_angle"]))
    angle = np.array([0.0, arc, np.nextafter(arc, 180.0), *np.linspace(90.0, 180.0, 91)])
    factor = np.where(angle <= arc, 1 - float(one["near_side_decrease"]), 1 + more * np.maximum(-np.cos(np.radians(angle)), 0))
    in_flow = float(one["far_side_pressure"]) / (1 + more) / 1e3
    return pd.DataFrame({"angle_deg": angle, "wall_normal_pressure_kPa": in_flow * factor})
