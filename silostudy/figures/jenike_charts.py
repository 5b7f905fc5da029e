"""Jenike's charts, computed: place of the initial peak i_1 (no load) and force of the flow field q_2 over the half angle."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import save
from silostudy.tables.outputs import OUTPUTS

(METHOD,) = OUTPUTS["jenike_charts"].methods
MARKERS = "osD^v<>P"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes both charts and their numbers; a line for each wall friction angle."""
    one = cube.sel(pressure_method=METHOD).transpose("half_angle", "hopper_friction", ...)
    panels = {
        "i_1": one["unloaded_peak_position"].sel({"phase": "filling"}),
        "q_2": one["radial_force_coefficient"].sel({"phase": "discharge"}),
    }
    figure, axes = plt.subplots(1, 2, figsize=(12, 6))
    angles, tables = np.degrees(one["half_angle"].values), []
    for panel, (name, values) in zip(axes, panels.items(), strict=True):
        for line, friction in enumerate(one["hopper_friction"].values):
            degrees = np.degrees(np.arctan(friction))
            curve = values.isel({"hopper_friction": line}).values
            shade = plt.get_cmap("viridis")(0.85 * line / max(1, one.sizes["hopper_friction"] - 1))
            style = {"marker": MARKERS[line % len(MARKERS)], "markevery": 6, "color": shade, "markersize": 5}
            panel.plot(angles, curve, label=f"wall friction {degrees:.0f}°", **style)
            last = np.flatnonzero(np.isfinite(curve))[-1] if np.isfinite(curve).any() else len(angles)
            if last < len(angles) - 1:
                panel.plot(angles[last], curve[last], marker="|", color=shade, markersize=14, markeredgewidth=2)
            tables.append(
                pd.DataFrame({"chart": name, "wall_friction_angle_deg": degrees, "half_angle_deg": angles, "value": curve})
            )
    delta = np.degrees(float(one["effective_friction_angle"].max()))
    axes[0].set(
        ylabel="height of the peak above the vertex over the hopper's, i₁",
        title="initial, no load on the hopper, K = 0.8 (0: the peak lies at the vertex)",
        ylim=(-0.02, 1),
    )
    axes[1].set(ylabel="q₂ = Q₂ / (γ D³)", title=f"flow, effective friction angle {delta:.0f}°")
    for panel in axes:
        panel.set(xlabel="half angle of the cone θ (°)", xlim=(0, None))
    figure.suptitle(f"{cube.attrs['title']} (upright stroke: no field beyond this angle)")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    save(figure, pd.concat(tables, ignore_index=True).dropna(), stem)
