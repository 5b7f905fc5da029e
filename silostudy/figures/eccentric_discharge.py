"""Wall pressure round a silo whose outlet lies off the axis: zones of each flow channel, and codes that move the pressure.

Left: round the wall from the outlet's side, at the transition; a code with a far and a near side in the middle of its far
side's band.  Right: what the pressures of a channel's zones come to, over the depth.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.silence import silences
from silostudy.figures.style import WIDTH, foot, headline, look, save, title
from silostudy.tables.outputs import output_of

(PHASE,) = output_of(__name__).phases
LINES = ((0, (1, 1)), (0, (4, 2)), "-")  # by the size of the channel
ZONES = ("channel", "adjacent", "static")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the curves that it shows."""
    unspoken, cube = silences(cube, in_every_case=True, titles=True), cube.sel({"phase": PHASE})
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 5.9), width_ratios=(1.5, 1))
    tables = []
    for method in _with(cube, "channel_half_width"):
        for size, line in zip(cube["channel"].values, LINES, strict=True):
            state = cube.sel(pressure_method=method, channel=size)
            curve, style = f"{title(cube, method)}, k_c = {size:.2f}", {**look(cube, method), "linestyle": line}
            tables += [_zones(state).assign(curve=curve), _resultant(state).assign(curve=curve)]
            left.plot(tables[-2].angle_deg, tables[-2].wall_normal_pressure_kPa, label=curve, **style)
            right.plot(tables[-1].resultant_kN_m, tables[-1].depth_m, markevery=max(1, len(tables[-1]) // 6), **style)
    for method in _with(cube, "far_side_pressure"):
        state = cube.sel(pressure_method=method)
        if float(state["far_side_increase"]) > 0:
            curve = f"{title(cube, method)}, {float(state['far_side_depth']):.1f} m deep"
            tables.append(_sides(state).assign(curve=curve))
            pressure = tables[-1].wall_normal_pressure_kPa
            left.plot(tables[-1].angle_deg, pressure, label=curve, markevery=15, **look(cube, method))
    left.set(xlabel="angle from the outlet's side (°)", ylabel="wall normal pressure (kPa)", xlim=(0, 180), ylim=(0, None))
    left.set(xticks=range(0, 181, 30), title=f"at the transition, {float(cube['cylinder_depth']):.1f} m deep")
    right.set(xlabel="resultant away from the channel (kN/m)", ylabel="depth z (m)", xlim=(0, None))
    right.set_ylim(float(cube["cylinder_depth"]), 0)
    headline(figure, _message(cube))
    foot(figure, f"{cube.attrs['title']}; k_c: radius of the channel over that of the silo", *unspoken,
         handles=left.get_legend_handles_labels()[0])  # fmt: skip
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _message(cube: xr.Dataset) -> str:
    """Message of the figure, in numbers: pressure beside the channel over that far from it, and the largest resultant."""
    ratio = cube["adjacent_normal_pressure"] / cube["static_normal_pressure"]
    beside = ratio.isel({str(ratio.dims[-1]): -1})
    largest = float(cube["channel_resultant"].max()) / 1e3
    return (
        f"Beside the channel the wall feels {float(beside.min()):.1f} to {float(beside.max()):.1f} times the pressure"
        f" far from it; over its height it is pushed away from the channel by up to {largest:.0f} kN/m"
    )


def _with(cube: xr.Dataset, name: str) -> list[str]:
    """The methods that give a quantity."""
    methods = map(str, cube["pressure_method"].values)
    return [method for method in methods if name in cube and cube[name].sel(pressure_method=method).notnull().any()]


def _zones(state: xr.Dataset) -> pd.DataFrame:
    """Pressure from the channel's axis to the far side: three steps."""
    edge = np.degrees(float(state["channel_half_width"]))
    pressures = [float(state[f"{zone}_normal_pressure"][-1]) / 1e3 for zone in ZONES]
    ends = np.array([0.0, edge, edge, 2 * edge, 2 * edge, 180.0])
    return pd.DataFrame({"angle_deg": ends, "wall_normal_pressure_kPa": np.repeat(pressures, 2)})


def _resultant(state: xr.Dataset) -> pd.DataFrame:
    return pd.DataFrame({"depth_m": state["depth"].values, "resultant_kN_m": state["channel_resultant"].values / 1e3})


def _sides(state: xr.Dataset) -> pd.DataFrame:
    """Pressure from the outlet's side to the far one: a relief over an arc, and a cosine added over the far half."""
    more, arc = float(state["far_side_increase"]), np.degrees(float(state["near_side_half_angle"]))
    angle = np.array([0.0, arc, np.nextafter(arc, 180.0), *np.linspace(90.0, 180.0, 91)])
    factor = np.where(
        angle <= arc, 1 - float(state["near_side_decrease"]), 1 + more * np.maximum(-np.cos(np.radians(angle)), 0)
    )
    in_flow = float(state["far_side_pressure"]) / (1 + more) / 1e3
    return pd.DataFrame({"angle_deg": angle, "wall_normal_pressure_kPa": in_flow * factor})
