"""Method with the largest wall pressure, over depth and H/D, a panel for each solid."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch

from silostudy.cube.silence import silences
from silostudy.figures.style import WIDTH, foot, headline, name, save, title

TIES = "of methods that tie, the first in the catalogue"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the map and its numbers.

    Every method scales with the silo's size, so the map is the same for all diameters (checked here); of the other
    axes it takes the position with the fewest masked values and says which.
    """
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    unspoken = silences(cube, in_every_case=True, titles=True)
    cube, fixed = _one_position(cube, level)
    index, largest = _governing(cube)
    solids = list(map(str, cube["solid"].values)) if "solid" in cube.dims else [""]
    columns = min(4, len(solids))
    rows = -(-len(solids) // columns)
    size = (WIDTH, 2.7 * rows + 1.8)
    figure, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, sharex=True, sharey=True)
    methods = list(map(str, cube["pressure_method"].values))
    colours = ListedColormap([str(c) for c in cube["pressure_method_colour"].values])
    norm = BoundaryNorm(np.arange(len(methods) + 1) - 0.5, len(methods))
    for panel, solid in zip(axes.flat, solids, strict=False):
        here = index.sel({"solid": solid}) if solid else index
        field = here.transpose(level, "slenderness").where(here >= 0)
        panel.pcolormesh(field["slenderness"], field[level], field, cmap=colours, norm=norm, shading="nearest", alpha=0.75)
        panel.set(title=solid.replace("_", " "), ylim=(1, 0) if level == "relative_depth" else None)
        panel.grid(False)
        _write_numbers(panel, field, cube, level)
    for panel in axes[-1]:
        panel.set_xlabel("H/D")
    for panel in axes[:, 0]:
        panel.set_ylabel("depth over depth\nof the transition" if level == "relative_depth" else "depth (m)")
    present = sorted(set(index.values[index.values >= 0].astype(int).ravel()))
    handles = [Patch(color=colours(m), alpha=0.75, label=title(cube, methods[m])) for m in present]
    headline(figure, _message(cube, index))
    foot(figure, f"method with the largest wall pressure at each depth; {fixed}; {TIES}", *unspoken, handles=handles)
    save(figure, _numbers(index, largest, methods), stem)


def _governing(cube: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Place of the governing method on the method axis or -1, and its pressure (Pa), over either phase."""
    pressure = cube["wall_normal_pressure"].max("phase")
    place = pressure.fillna(-np.inf).argmax("pressure_method")
    largest = pressure.max("pressure_method")
    return place.where(largest.notnull(), -1), largest


def _message(cube: xr.Dataset, index: xr.DataArray) -> str:
    """Message of the figure, in numbers: the methods that ask for most over the largest shares of depths and silos."""
    places, counts = np.unique(index.values[index.values >= 0].astype(int), return_counts=True)
    shares = sorted(zip(counts / counts.sum(), places, strict=True), reverse=True)[:3]
    told = [f"{name(cube, str(cube['pressure_method'].values[place]))} on {100 * share:.0f} %" for share, place in shares]
    return f"Of all depths and silos the largest wall pressure is asked for by {', '.join(told)}"


def _one_position(cube: xr.Dataset, level: str) -> tuple[xr.Dataset, str]:
    others = [d for d in cube["case"].dims if d not in ("slenderness", "solid")]
    said = []
    for dim in others:
        masked = cube["wall_normal_pressure"].isnull().sum([d for d in cube["wall_normal_pressure"].dims if d != dim])
        if dim == "diameter":
            same = all(
                np.array_equal(_governing(cube.isel({dim: i}))[0], _governing(cube.isel({dim: 0}))[0])
                for i in range(cube.sizes[dim])
            )
            said.append("the same for all diameters of the study" if same else f"diameter {float(cube[dim][0]):g} m")
            cube = cube.isel({dim: 0})
        else:
            cube = cube.isel({dim: int(np.argmin(masked.values))})
            said.append(f"{dim} {str(cube[dim].values).replace('_', ' ')}")
    return cube, "; ".join(said)


def _write_numbers(panel, field: xr.DataArray, cube: xr.Dataset, level: str) -> None:
    """The handbook's number of the method on its largest patch, so that the map reads without colour."""
    for place in np.unique(field.values[np.isfinite(field.values)]).astype(int):
        where = np.argwhere(field.values == place)
        if len(where) >= 0.02 * field.size:
            row, column = where[np.argmin(np.abs((where - where.mean(axis=0)) / field.shape).sum(axis=1))]
            number = str(cube["pressure_method_number"].values[place]) or str(cube["pressure_method"].values[place])
            panel.text(float(field["slenderness"][column]), float(field[level][row]), number, ha="center", va="center")


def _numbers(index: xr.DataArray, largest: xr.DataArray, methods: list[str]) -> pd.DataFrame:
    table = xr.Dataset({"place": index, "wall_normal_pressure_Pa": largest}).to_dataframe().reset_index()
    table = table[table.place >= 0]
    table["pressure_method"] = [methods[int(place)] for place in table.place]
    columns = ("solid", "slenderness", "relative_depth", "depth", "pressure_method", "wall_normal_pressure_Pa")
    return table[[column for column in columns if column in table]]
