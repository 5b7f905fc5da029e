"""A scene of discs: force chains before and in discharge, and the force on each wall in time."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection

from silostudy.figures.style import AID, save

CM = 100.0
LONGEST = 3.0  # diameters: the line of the largest contact force
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
LINES = ("-", "--", "-.", ":")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure with the chains of two snapshots and the forces on the walls that it shows."""
    figure, (first, second, walls) = plt.subplots(1, 3, figsize=(12.5, 5.6), width_ratios=(1, 1, 1.5))
    largest = float(np.hypot(cube["contact_force_x"], cube["contact_force_y"]).max())
    tables = []
    for panel, snapshot in zip((first, second), _snapshots(cube), strict=True):
        tables.append(_chains(cube, snapshot, largest))
        _draw_chains(panel, cube, snapshot, tables[-1])
    tables += _draw_walls(walls, cube)
    figure.suptitle(f"{cube.attrs['title']}\nline of a contact: as long and wide as its force, at most {largest:.3g} N/m")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _snapshots(cube: xr.Dataset) -> tuple[int, int]:
    """The last snapshot before anything has left, and the last of all."""
    time, left = cube["snapshot_time"].values, cube["discharge_time"].values
    before = np.flatnonzero(time < left[0]) if left.size else np.arange(len(time))
    return (int(before[-1]) if before.size else 0), len(time) - 1


def _chains(cube: xr.Dataset, snapshot: int, largest: float) -> pd.DataFrame:
    """Contact forces (N/m) of a snapshot, and the ends (cm) of the lines that they are drawn as."""
    here = cube["contact_snapshot"].values == snapshot
    place, force = (np.stack([cube[f"contact_{kind}{way}"].values[here] for way in "xy"], axis=1) for kind in ("", "force_"))
    half = force / largest * LONGEST * float(cube["disc_radius"].mean())
    ends = np.hstack([place - half, place + half]) * CM
    table = pd.DataFrame(ends, columns=["from_across_cm", "from_height_cm", "to_across_cm", "to_height_cm"])
    return table.assign(force_N_m=np.hypot(*force.T), snapshot_s=float(cube["snapshot_time"][snapshot]))


def _draw_chains(panel: Axes, cube: xr.Dataset, snapshot: int, table: pd.DataFrame) -> None:
    x, y = (cube[f"disc_{way}"].isel(snapshot=snapshot).values * CM for way in "xy")
    there, size = np.isfinite(x), 2 * cube["disc_radius"].values * CM
    style: dict[str, Any] = {
        "units": "xy",
        "transOffset": panel.transData,
        "facecolors": "0.92",
        "edgecolors": "0.7",
        "linewidths": 0.5,
    }
    offsets = np.column_stack([x[there], y[there]])
    panel.add_collection(EllipseCollection(size[there], size[there], 0.0, offsets=offsets, gid=AID, **style))
    widths = np.clip(4.0 * table.force_N_m / max(table.force_N_m.max(), 1e-300), 0.3, 4.0)
    panel.add_collection(
        LineCollection(list(table.filter(like="_cm").to_numpy().reshape(-1, 2, 2)), linewidths=widths, colors="k")
    )
    across, up = cube["wall_cell_x"].values * CM, cube["wall_cell_y"].values * CM
    panel.set(xlabel="across (cm)", ylabel="height (cm)", aspect="equal")
    panel.set(xlim=(across.min() - 1, across.max() + 1), ylim=(min(0.0, np.nanmin(up)) - 3, np.nanmax(y) + 3))
    panel.set_title(f"{float(cube['snapshot_time'][snapshot]):.3g} s: {there.sum()} discs")
    panel.grid(False)


def _draw_walls(panel: Axes, cube: xr.Dataset) -> list[pd.DataFrame]:
    """Normal force on each wall over the windows, with what happened."""
    force, time = cube["wall_normal_force_mean"] / 1e3, cube["window_time"].values
    tables = []
    for k, name in enumerate(dict.fromkeys(map(str, cube["wall_name"].values))):
        table = pd.DataFrame(
            {"wall": name, "time_s": time, "wall_force_kN_m": force[:, cube["wall_name"].values == name].sum("wall_cell")}
        )
        if table.wall_force_kN_m.any():
            look: dict[str, Any] = {
                "color": COLOURS[k % len(COLOURS)],
                "linestyle": LINES[k % len(LINES)],
                "label": name.replace("_", " "),
            }
            panel.plot(table.time_s, table.wall_force_kN_m, **look)
            tables.append(table)
    for when, what in zip(cube["event_time"].values, cube["event_action"].values, strict=True):
        panel.axvline(when, color="0.6", linewidth=0.8)
        panel.annotate(
            str(what).replace("_", " "), (when, 1.0), xycoords=("data", "axes fraction"), rotation=90, va="top", ha="right"
        )
    panel.set(xlabel="time (s)", ylabel="normal force on a wall, mean of each window (kN/m)", ylim=(0, None))
    panel.set_title("forces on the walls")
    panel.legend(loc="center right")
    return tables
