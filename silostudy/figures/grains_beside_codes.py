"""Wall pressure over depth: what the grains did, at rest and in flow, and what theories and codes say of the same silo."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import methods_of, profile, settings, told
from silostudy.figures.style import look, plt, save, title

MOST = 4  # rows of panels: more settings than that are shown by the first, the last and those evenly between
KPA = 1e3
PANELS = {"filling": "at rest", "discharge": "in flow"}
INK = "black"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row of panels a setting, at rest on the left and in flow on the right."""
    every = list(settings(cube))
    shown = [every[k] for k in np.unique(np.linspace(0, len(every) - 1, min(MOST, len(every))).round().astype(int))]
    figure, panels = plt.subplots(len(shown), 2, figsize=(11.0, 0.8 + 4.4 * len(shown)), squeeze=False, sharey="row")
    numbers = []
    for row, (setting, one) in zip(panels, shown, strict=True):
        for panel, (phase, name) in zip(row, PANELS.items(), strict=True):
            numbers += [table.assign(**setting, phase=phase) for table in _panel(panel, one, phase)]
            panel.set(title=f"{told(setting)}: {name}", xlabel="pressure on the wall (kPa)", xlim=(0.0, None))
        row[0].set(ylabel="depth below the level surface (m)")
        row[0].invert_yaxis()
    handles = {text: line for panel in panels.flat for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    figure.legend(handles.values(), handles.keys(), loc="outside right center", fontsize=8)
    figure.suptitle(cube.attrs["title"])
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _panel(panel: Axes, one: xr.Dataset, phase: str) -> list[pd.DataFrame]:
    """Draws a phase of a setting; the tables that it shows."""
    depth, tables = one["level_depth"], []
    for method in methods_of(one, phase):
        said = one["code_wall_pressure"].sel(pressure_method=method, phase=phase)
        table = pd.DataFrame({"of": method, "depth_m": depth.mean("filling").values, "pressure_Pa": said.values}).dropna()
        panel.plot(table["pressure_Pa"] / KPA, table["depth_m"], color=look(one, method)["color"], linewidth=1.0, alpha=0.8,
                   label=title(one, method))  # fmt: skip
        tables.append(table)
    ring = profile(one["ring_pressure"].sel(phase=phase), depth, of="grains, mean around")
    panel.fill_betweenx(ring["depth_m"], ring["least_Pa"] / KPA, ring["largest_Pa"] / KPA, color=INK, alpha=0.15, linewidth=0,
                        label="least and largest of the fillings")  # fmt: skip
    panel.plot(
        ring["pressure_Pa"] / KPA, ring["depth_m"], "o-", color=INK, markersize=4, linewidth=2, label="grains, mean around"
    )
    for area, look_of in {"ring": "--", "1x1": ":"}.items():
        if phase == "filling" and area == "ring":
            continue
        name = "grains, largest window around" if area == "ring" else "grains, largest on one cell"
        table = profile(one["largest_area_pressure"].sel(phase=phase, averaging=area), depth, of=name)
        panel.plot(table["pressure_Pa"] / KPA, table["depth_m"], look_of, color=INK, linewidth=1.4, label=name)
        tables.append(table)
    return [ring, *tables]
