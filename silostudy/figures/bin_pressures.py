"""Pressure on the walls of a bin of spheres: maps over height and angle before and in discharge, and means over depth."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from silostudy.figures import bin as bins
from silostudy.figures.style import AID, BLACK, BLUE, PURPLE, VERMILION, WIDTH, foot, headline, plt, save

KPA = 1e3  # Pa
APART = 0.06  # of a panel's width: the last number under one and the first under the next
MAPS = {bins.REST: "pressure_rest_Pa", "in discharge, mean": "pressure_discharge_Pa"}
LINES: dict[str, tuple[str, dict]] = {
    bins.REST: ("pressure_rest_Pa", {"color": BLACK, "marker": "o"}),
    "in discharge, mean": ("pressure_discharge_Pa", {"color": VERMILION, "marker": "s", "linestyle": (0, (4, 2))}),
    "in discharge, mean of the cells' peaks": ("peak_discharge_Pa", {"color": PURPLE, "marker": "^", "linestyle": (0, (1, 1))}),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the pressures of every cell as CSV."""
    cells, before = bins.phases(cube), bins.before(cube)
    drawn = cells[_loaded(cube, cells)]
    shown = {name: column for name, column in MAPS.items() if cells[column].notna().any()}
    apart = {"wspace": APART}
    figure, panels = plt.subplots(1, len(shown) + 1, figsize=(WIDTH, 5.8), sharey=True, squeeze=False, gridspec_kw=apart)
    most = max(float(cells[column].max()) for column in shown.values()) / KPA or 1.0
    for panel, (name, column) in zip(panels[0], shown.items(), strict=False):
        mesh = _map(panel, drawn, cube, column, most)
        panel.set(
            title=before if name == bins.REST else name,
            xlabel="angle from the x axis (°)",
            xlim=(0, 360),
            xticks=range(0, 361, 90),
        )
        _transition(panel, cube)
    panels[0, 0].set_ylabel("height (m)")
    figure.colorbar(mesh, ax=panels[0, : len(shown)], location="bottom", shrink=0.7, label="normal pressure (kPa)")
    of = bins.column(cube, cells)
    why = bins.doubt(of, cube, cells) if of else ""
    table = _profiles(panels[0, -1], cube, drawn, None if why else of)
    tops = drawn["height_m"] + _high(cube, drawn) / 2.0
    panels[0, 0].set_ylim(0.0, max(tops.max(), table["height_m"].max()))
    headline(figure, _message(table, before))
    left_out = f"Janssen's curve is left out: {why}." if why else ""
    early = f"; {bins.EARLY_WORDS}" if len(shown) > 1 else ""
    foot(figure, f"{cube.attrs['title']}{early}.", left_out, handles=panels[0, -1].get_legend_handles_labels()[0])
    save(figure, pd.concat([cells.assign(kind="cell"), table], ignore_index=True), stem)


def _message(table: pd.DataFrame, before: str) -> str:
    """Largest pressures in discharge over the largest before, as curves show them: means over the angle of means and peaks."""
    means = table[table["kind"] == "mean"]
    rest, flow = (float(means[column].max()) for column in MAPS.values())
    if not rest > 0.0:
        return f"Nothing presses on the walls {before}"
    if np.isnan(flow):
        return f"{before.capitalize()} the largest mean around the walls is {rest / KPA:.3g} kPa"
    peak = float(means["peak_discharge_Pa"].max() / rest)
    mean = f"In discharge the largest mean around the walls is {flow / rest:.2g} times that {before}"
    return f"{mean}, the mean of the cells' peaks {peak:.2g} times"


def _high(cube: xr.Dataset, cells: pd.DataFrame) -> pd.Series:
    """Height (m) of each cell, from the bottom of its surface, where the lowest one of its kind begins."""
    lowest = cells.groupby(cells["surface"].str.split("_").str[0])["height_m"].transform("min")
    bottom = np.where(cells["surface"].str.startswith("wall"), float(cube.attrs["transition_height_m"]), 0.0)
    return 2.0 * (lowest - bottom)


def _loaded(cube: xr.Dataset, cells: pd.DataFrame) -> pd.Series:
    """Whether each cell is drawn: up to the first level over the highest cell that is ever pressed, all where none is."""
    pressed, half = cells[[*MAPS.values()]].max(axis=1) > 0.0, _high(cube, cells) / 2.0
    top = (cells["height_m"] + half)[pressed].max() if pressed.any() else np.inf
    return cells["height_m"] - half < top * (1.0 + 1e-6)


def _map(panel: Axes, cells: pd.DataFrame, cube: xr.Dataset, column: str, most: float) -> QuadMesh:
    """Cells as rectangles of angle and height, coloured by pressure (kPa); all walls of a kind go round together."""
    for _, kind in cells.assign(high=_high(cube, cells)).groupby(cells["surface"].str.split("_").str[0], sort=False):
        for height, row in kind.groupby("height_m"):
            angles, ring = around(row)
            edges = [height - row["high"].iloc[0] / 2, height + row["high"].iloc[0] / 2]
            mesh = panel.pcolormesh(angles, edges, ring[column].to_numpy()[None] / KPA, cmap="viridis", vmin=0.0, vmax=most)
    panel.grid(False)
    return mesh


def around(row: pd.DataFrame) -> tuple[np.ndarray, pd.DataFrame]:
    """Edges (degrees) of a level's cells from one turn before the first to one after it, and those cells.

    Wall after wall, edges midway between cells.  Those that are no part of their wall, which narrows in a hopper, are left out.
    """
    there = row[row["area_m2"].notna()]
    walls = there.groupby("surface", sort=False)["angle_deg"]
    middle = walls.transform(lambda own: np.degrees(np.angle(np.exp(1j * np.radians(own)).sum())) % 360.0)
    if walls.ngroups == 1:
        middle = middle * 0.0 + 180.0
    angle = middle + (there["angle_deg"] - middle + 180.0) % 360.0 - 180.0
    ring = there.assign(angle_deg=angle, middle=middle).sort_values(["middle", "angle_deg"])
    places = np.add.outer(
        (-360.0, 0.0, 360.0), ring["angle_deg"].to_numpy()
    ).ravel()  # three times around: the middle one, and its ends
    edges = np.maximum.accumulate((places[:-1] + places[1:]) / 2.0)
    return edges, ring.iloc[np.tile(np.arange(len(ring)), 3)[1:-1]]


def _transition(panel: Axes, cube: xr.Dataset) -> None:
    """A line where the hopper begins."""
    if height := float(cube.attrs["transition_height_m"]):
        panel.axhline(height, color="white", linewidth=1, gid=AID)


def _profiles(panel: Axes, cube: xr.Dataset, drawn: pd.DataFrame, of: bins.Column | None) -> pd.DataFrame:
    """Means over the angle, and Janssen's curve for a column where there is one; gives the numbers."""
    means = bins.profile(drawn)
    for label, (column, style) in LINES.items():
        told = bins.before(cube) if label == bins.REST else label
        for number, (_, surface) in enumerate(means.groupby("surface")):
            if surface[column].notna().any():
                panel.plot(surface[column] / KPA, surface["height_m"], markersize=4,
                           label=told if number == 0 else "_", **style)  # fmt: skip
    tables = [means.assign(kind="mean")]
    if of:
        heights = np.linspace(float(cube.attrs["transition_height_m"]), of.surface, 40)
        pressure = bins.janssen(of.surface - heights, of, float(cube.attrs["hydraulic_radius_m"]))
        label = f"Janssen, with friction {of.wall_friction:.2f} and K {of.lateral_pressure_ratio:.2f} as they act "
        label += bins.before(cube)
        panel.plot(pressure / KPA, heights, color=BLUE, linewidth=2.2, alpha=0.8, label=label)
        tables.append(pd.DataFrame({"kind": "janssen", "height_m": heights, "pressure_rest_Pa": pressure}))
    panel.axhline(float(cube.attrs["transition_height_m"]), color="#888888", linewidth=0.8, gid=AID)
    panel.set(title="mean over the angle", xlabel="normal pressure (kPa)")
    panel.set_xlim(left=0.0)
    return pd.concat(tables, ignore_index=True)
