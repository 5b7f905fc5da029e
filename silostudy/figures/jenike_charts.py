"""Jenike's charts, computed: place of the initial peak i_1 (no load) and force of the flow field q_2 over the half angle."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import MARKERS, WIDTH, foot, headline, save
from silostudy.tables.outputs import output_of

(METHOD,) = output_of(__name__).methods


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes both charts and their numbers; a line for each wall friction angle."""
    method = cube.sel(pressure_method=METHOD).transpose("half_angle", "hopper_friction", ...)
    panels = {
        "i_1": method["unloaded_peak_position"].sel({"phase": "filling"}),
        "q_2": method["radial_force_coefficient"].sel({"phase": "discharge"}),
    }
    figure, axes = plt.subplots(1, 2, figsize=(WIDTH, 5.8))
    angles, tables = np.degrees(method["half_angle"].values), []
    for panel, (name, values) in zip(axes, panels.items(), strict=True):
        for line, friction in enumerate(method["hopper_friction"].values):
            degrees = np.degrees(np.arctan(friction))
            curve = values.isel({"hopper_friction": line}).values
            shade = plt.get_cmap("viridis")(0.85 * line / max(1, method.sizes["hopper_friction"] - 1))
            style = {"marker": MARKERS[line % len(MARKERS)], "markevery": 6, "color": shade, "markersize": 5}
            panel.plot(angles, curve, label=f"wall friction {degrees:.0f}°", **style)
            last = np.flatnonzero(np.isfinite(curve))[-1] if np.isfinite(curve).any() else len(angles)
            if last < len(angles) - 1:
                panel.plot(angles[last], curve[last], "|", color="black", markersize=14, markeredgewidth=2)
            tables.append(
                pd.DataFrame({"chart": name, "wall_friction_angle_deg": degrees, "half_angle_deg": angles, "value": curve})
            )
    delta = np.degrees(float(method["effective_friction_angle"].max()))
    axes[0].set(
        ylabel="height of the peak above the vertex\nover the hopper's, i₁",
        title="initial, no load on the hopper, K = 0.8\n(0: the peak lies at the vertex)",
        ylim=(-0.02, 1),
    )
    axes[1].set(ylabel="q₂ = Q₂ / (γ D³)", title=f"flow, effective friction angle {delta:.0f}°")
    for panel in axes:
        panel.set(xlabel="half angle of the cone θ (°)", xlim=(0, None))
    numbers = pd.concat(tables, ignore_index=True).dropna()
    headline(figure, _message(numbers))
    handles = axes[0].get_legend_handles_labels()[0]
    foot(figure, f"{cube.attrs['title']}; upright stroke: no field beyond this angle", handles=handles)
    save(figure, numbers, stem)


def _message(numbers: pd.DataFrame) -> str:
    """Message of the charts, in numbers: the flattest cones in which the solid flows along the wall, by wall friction."""
    ends = numbers[numbers.chart == "q_2"].groupby("wall_friction_angle_deg").half_angle_deg.max()
    told = (f"{ends.loc[angle]:.0f}° at a wall friction of {angle:.0f}°" for angle in (ends.index.min(), ends.index.max()))
    return f"The flow field reaches to half angles of {' and '.join(told)}"
