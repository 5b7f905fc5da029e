"""What a drawn figure holds, for tests: its data against the CSV beside it."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection, QuadMesh
from matplotlib.colors import BoundaryNorm
from matplotlib.container import BarContainer, ErrorbarContainer
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.image import AxesImage

from silostudy.figures.style import AID
from tests.test_figures.labels import is_categorical, label_of, unit_of, unit_of_column

PRINTED = 1e-6  # relative: a CSV has seven significant digits


def data(axes: Axes) -> Iterator[tuple[str, np.ndarray, bool]]:
    """(what, points, whether all of them belong to one pair of columns) of every artist that shows data.

    No data are what stands at a place of the axes instead (axhline, axvspan, a text), and aids to the eye: what carries
    style.AID.
    """
    for line in axes.lines:
        if shows(line, axes) and line not in caps(axes):
            points = np.asarray(line.get_xydata(), dtype=float)
            closed = len(points) > 2 and np.array_equal(points[0], points[-1])  # an outline has its two edges in two columns
            yield f"line {line.get_label()!r}", points, not closed
    for found in axes.collections:
        if found.get_offset_transform() is axes.transData and found.get_gid() != AID:
            yield f"points {found.get_label()!r}", np.ma.filled(found.get_offsets().astype(float), np.nan), True
        elif isinstance(found, LineCollection) and shows(found, axes) and found.get_segments():
            yield f"bars {found.get_label()!r}", np.array(found.get_segments()), False
        elif isinstance(found, PolyCollection) and shows(found, axes) and found.get_paths():
            points = np.concatenate([path.vertices[:-1] for path in found.get_paths()])
            yield f"band {found.get_label()!r}", points[(points != 0.0).all(axis=1)], False  # an area may stand on an axis
    for bars in axes.containers:
        if isinstance(bars, BarContainer):
            upright = bars.orientation == "vertical"
            middles = [b.get_x() + b.get_width() / 2 if upright else b.get_y() + b.get_height() / 2 for b in bars]
            yield f"bars {bars.get_label()!r}", np.column_stack((middles, bars.datavalues)[:: 1 if upright else -1]), True


def caps(axes: Axes) -> list:
    """The caps of error bars, which end where the bars do."""
    return [cap for bars in axes.containers if isinstance(bars, ErrorbarContainer) for cap in bars.lines[1]]


def shows(artist: Any, axes: Axes) -> bool:
    return (
        artist.get_gid() != AID
        and artist.get_visible()
        and all(artist.get_transform().contains_branch_seperately(axes.transData))
    )


def values(axes: Axes) -> Iterator[tuple[str, np.ndarray, str]]:
    """(what, values, label) of every coloured map; of contours the least and the largest."""
    for found in (*axes.collections, *axes.images):
        bar = getattr(found, "colorbar", None)
        bar = bar or next((one._colorbar for one in axes.get_figure().axes if hasattr(one, "_colorbar")), None)
        label = (bar.ax.get_ylabel() or bar.ax.get_xlabel()) if bar else axes.get_title()
        if isinstance(found, ContourSet) and found.filled:
            hatched = found.colors is not None  # a region, which a quotient bounds
            yield "contours", np.array([found.zmin, found.zmax]), "(1)" if hatched else label
        elif (
            isinstance(found, QuadMesh | AxesImage) and not isinstance(found.norm, BoundaryNorm) and found not in _bars_of(axes)
        ):
            yield "map", np.ma.filled(found.get_array().astype(float), np.nan).ravel(), label


def _bars_of(axes: Axes) -> list:
    return list(axes.collections) if hasattr(axes, "_colorbar") else []


def _scaled(table: pd.DataFrame, units: dict[str, str], unit: tuple[str, float] | None) -> dict[str, np.ndarray]:
    """The columns that can hold a quantity, in the unit of its axis."""
    found = {}
    for name in table.select_dtypes("number"):
        own = unit_of_column(str(name), units)
        if own and unit and own[0] == unit[0]:
            found[str(name)] = table[name].to_numpy(dtype=float) * own[1] / unit[1]
    return found


def _places(wanted: np.ndarray, column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Number of each wanted value among the column's (-1: not there), and of the column's own."""
    known = np.unique(column[np.isfinite(column)])
    if not len(known):
        return np.full(len(wanted), -1), np.full(len(column), -2)
    after = np.clip(np.searchsorted(known, wanted), 1, max(1, len(known) - 1))
    before = after - 1
    after = np.minimum(after, len(known) - 1)
    nearest = np.where(np.abs(known[before] - wanted) <= np.abs(known[after] - wanted), before, after)
    close = np.abs(known[nearest] - wanted) <= PRINTED * np.abs(wanted) + 1e-12 * np.abs(known).max()
    return np.where(close, nearest, -1), np.where(np.isfinite(column), np.searchsorted(known, column), -2)


def _both(points: np.ndarray, x: np.ndarray | None, y: np.ndarray | None) -> np.ndarray:
    """Which points are rows of two columns; None: a categorical axis, which any row has."""
    found = [_places(points[:, way], column) for way, column in enumerate((x, y)) if column is not None]
    size = 1 + max(own.max(initial=0) for _, own in found)
    here = np.all([wanted >= 0 for wanted, _ in found], axis=0)
    there = np.all([own >= 0 for _, own in found], axis=0)
    keys = [sum(part * size**power for power, part in enumerate(side)) for side in zip(*found, strict=True)]
    return here & np.isin(keys[0], np.asarray(keys[1])[there])


def _halves(bars: np.ndarray, x: np.ndarray | None, y: np.ndarray | None) -> np.ndarray:
    """Which upright bars have their half-length, the error, in a row of two columns."""
    half = np.column_stack([bars[:, 0, 0], (bars[:, 1, 1] - bars[:, 0, 1]) / 2])
    return _both(half, x, y) & (bars[:, 0, 0] == bars[:, 1, 0])


def lost(figure: Figure, table: pd.DataFrame, units: dict[str, str]) -> Iterator[str]:
    """Data that a figure shows and its table does not hold; units: of the variables of the cube it is drawn from."""
    for axes in figure.axes:
        if not axes.get_visible() or not axes.axison:
            continue
        columns: list = []
        for way in "xy":
            columns.append(
                [None] if is_categorical(axes, way) else list(_scaled(table, units, unit_of(label_of(axes, way))).values())
            )
        pairs = [pair for pair in product(*columns) if any(side is not None for side in pair) and pair[0] is not pair[1]]
        for what, points, whole in data(axes):
            points = points[np.isfinite(points).all(axis=tuple(range(1, points.ndim)))]
            if not len(points):
                continue
            ends = points.reshape(-1, 2)
            hits = [_both(ends, x, y) for x, y in pairs] or [np.zeros(len(ends), dtype=bool)]
            share = max(hit.mean() for hit in hits) if whole else np.any(hits, axis=0).mean()
            if share < 1.0 and points.ndim == 3:
                share = max([share, *(_halves(points, x, y).mean() for x, y in pairs)])
            if share < 1.0:
                where = f"{axes.get_title()!r} ({label_of(axes, 'x')!r}, {label_of(axes, 'y')!r})"
                yield f"{what} of {where}: {share:.0%} is in the CSV"
        for what, shown, label in values(axes):
            shown = shown[np.isfinite(shown)]
            hits = [(_places(shown, column)[0] >= 0).all() for column in _scaled(table, units, unit_of(label)).values()]
            if not any(hits):
                yield f"{what} of {axes.get_title()!r} ({label!r}) is not in the CSV"


def bare(figure: Figure) -> Iterator[str]:
    """Axes that show nothing."""
    for axes in figure.axes:
        if axes.get_visible() and axes.axison and not any((axes.lines, axes.collections, axes.patches, axes.images)):
            yield f"nothing on {axes.get_title()!r}"
