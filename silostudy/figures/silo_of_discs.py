"""A scene of discs: force chains before and in discharge, the force on each wall in time, and the mass that leaves."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection

from silostudy.figures import in_time
from silostudy.figures.bin import opened_at
from silostudy.figures.style import AID, WIDTH, foot, headline, save

CM = 100.0
LONGEST = 3.0  # diameters: the line of the largest contact force
FORCE = "force_kN_m"  # column of the forces
MASS = "mass_kg_m"  # column of the mass


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure: the chains of two snapshots, the forces on the walls, and the mass through the outlets."""
    in_time.check_recorded(cube, "whole_normal_force_mean")
    figure, panels = plt.subplot_mosaic([["rest", "flow"], ["force", "mass"]], figsize=(WIDTH, 9.2), height_ratios=(1.7, 1))
    largest = float(np.hypot(cube["contact_force_x"], cube["contact_force_y"]).max())
    tables = []
    for panel, snapshot in zip((panels["rest"], panels["flow"]), in_time.snapshots(cube, "discharge_time"), strict=True):
        tables.append(_chains(cube, snapshot, largest))
        _draw_chains(panel, cube, snapshot, tables[-1])
    push = cube["whole_normal_force_mean"].values / 1e3
    force = in_time.forces(cube["window_time"].values, push, cube["surface"].values, FORCE)
    flow = in_time.flow_of(cube, "discharge_time", "discharged_mass", "disc_mass", MASS, "kg/m")
    lines = in_time.draw_forces(panels["force"], force, FORCE, opened_at(cube))
    in_time.draw_flow(panels["mass"], flow)
    panels["force"].set(ylabel="normal force (kN/m)")
    panels["mass"].set(ylabel="mass that has left (kg/m)")
    panels["mass"].sharex(panels["force"])
    in_time.mark_events((panels["force"], panels["mass"]), cube)
    headline(figure, in_time.message(cube, force, FORCE, flow))
    chains = (
        f"Line of a contact: as long and wide as its force, at most {largest:.3g} N/m. Forces: normal, mean of each window."
    )
    foot(figure, f"{cube.attrs['title']}.", chains, handles=lines)
    save(figure, pd.concat([*tables, force, flow.table], ignore_index=True), stem)


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
    panel.set(
        xlim=(across.min() - 1, across.max() + 1), ylim=(min(0.0, np.nanmin(up)) - 3, float(cube["disc_y"].max()) * CM + 3)
    )
    panel.set_title(f"{float(cube['snapshot_time'][snapshot]):.3g} s: {there.sum()} discs")
    panel.grid(False)
