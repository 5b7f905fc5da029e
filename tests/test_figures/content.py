"""What a drawn figure holds, for tests: its data against the CSV beside it, the units of its axes, where its words stand."""

import re
from collections.abc import Iterator
from itertools import combinations, product
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.category import StrCategoryFormatter
from matplotlib.collections import LineCollection, PathCollection, PolyCollection, QuadMesh
from matplotlib.colors import BoundaryNorm, to_hex, to_rgb
from matplotlib.container import BarContainer, ErrorbarContainer
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.text import Text
from matplotlib.ticker import FuncFormatter
from matplotlib.transforms import Bbox

from silostudy.figures.style import AID, NAMED
from silostudy.tables.constants import STANDARD_GRAVITY

PRINTED = 1e-6  # relative: a CSV has seven significant digits
# unit as an axis writes it -> (dimension, size in SI)
UNITS = {
    "m": ("m", 1.0), "cm": ("m", 1e-2), "mm": ("m", 1e-3), "s": ("s", 1.0), "ms": ("s", 1e-3), "Hz": ("Hz", 1.0),
    "Pa": ("Pa", 1.0), "kPa": ("Pa", 1e3), "MPa": ("Pa", 1e6), "t/m²": ("Pa", 9806.65), "kN": ("N", 1e3), "N": ("N", 1.0),
    "N/m": ("N/m", 1.0), "kN/m": ("N/m", 1e3), "kN m": ("N m", 1e3), "N m": ("N m", 1.0), "disc weights": ("disc", 1.0),
    "m/s": ("m/s", 1.0), "cm/s": ("m/s", 1e-2), "m/s²": ("m/s²", 1.0), "gal": ("m/s²", 1e-2),
    "g": ("m/s²", STANDARD_GRAVITY), "°": ("rad", np.pi / 180),
    "kg": ("kg", 1.0), "kg/m": ("kg/m", 1.0), "rad": ("rad", 1.0), "%": ("1", 1e-2), "1": ("1", 1.0),
    "kg m⁻¹ s⁻¹": ("kg/m/s", 1.0), "kg/s": ("kg/s", 1.0),
}  # fmt: skip
IN_NAMES = {"t_m2": "t/m²", "m_s2": "m/s²", "m_s": "m/s", "deg": "°", "percent": "%", "disc_weights": "disc weights",
            "kN_m": "kN/m", "N_m": "N/m", "cm_s": "cm/s", "kg_m_s": "kg m⁻¹ s⁻¹", "kg_s": "kg/s", "kg_m": "kg/m"}  # fmt: skip
IN_CUBES = {"m s-2": "m/s²", "m s-1": "m/s", "N m-1": "N/m", "kg m-1 s-1": "kg m⁻¹ s⁻¹", "kg s-1": "kg/s"}
QUOTIENT = re.compile(
    r"\b(over|ratio|relative|factor|coefficient|share|chance|index|number|utilisation|C_eff)\b|/|=|²"
)  # has no unit
DEPTH = re.compile(r"^(relative )?depth\b")


def unit_of(label: str) -> tuple[str, float] | None:
    """(dimension, size in SI) of the unit that a label names; of a quotient, one; None where it says neither."""
    named = [UNITS[text] for text in re.findall(r"\(([^()]*)\)", label) if text in UNITS]
    named += [UNITS[label]] if label in UNITS else []
    return named[0] if named else ("1", 1.0) if QUOTIENT.search(label) else None


def unit_of_column(name: str, units: dict[str, str]) -> tuple[str, float] | None:
    """(dimension, size in SI) of the unit at the end of a column's name, or of the cube's variable of that name; else one."""
    parts = name.split("_")
    for length in (3, 2, 1):
        end = "_".join(parts[-length:])
        text = IN_NAMES.get(end, end)
        if len(parts) > length and text in UNITS:
            return UNITS[text]
    text = units.get(name, "1")
    return UNITS.get(IN_CUBES.get(text, text))


def is_categorical(axes: Axes, way: str) -> bool:
    """Whether an axis counts names instead of a quantity: its ticks, or those of an axis that it is shared with, are words."""
    axis = getattr(axes, f"{way}axis")
    if not isinstance(axis.get_major_formatter(), FuncFormatter | StrCategoryFormatter):  # what set_xticks with labels makes
        return False
    texts = [text.get_text() for one in _sharing(axes, way) for text in getattr(one, f"get_{way}ticklabels")()]
    return any(text and not _is_number(text) for text in texts)


def _sharing(axes: Axes, way: str) -> list[Axes]:
    """Axes, and those that they share an axis with."""
    others = getattr(axes, f"get_shared_{way}_axes")().get_siblings(axes) if axes.name == "rectilinear" else []
    return [axes, *(one for one in others if one is not axes)]


def _is_number(text: str) -> bool:
    try:
        float(text.replace("\N{MINUS SIGN}", "-"))
    except ValueError:
        return False
    return True


def label_of(axes: Axes, way: str) -> str:
    """The label that an axis carries, or another that it is shared with, or the figure."""
    labels = [getattr(one, f"get_{way}label")() for one in _sharing(axes, way)]
    labels.append(getattr(axes.get_figure(), f"get_sup{way}label")())
    return next((label for label in labels if label), "")


def panels(figure: Figure) -> list[Axes]:
    """The axes that are seen, with the further scales on their edges."""
    seen = [axes for axes in figure.axes if axes.get_visible() and axes.axison]
    return [one for axes in seen for one in (axes, *axes.child_axes)]


def unlabelled(figure: Figure, drawn: set[str]) -> Iterator[str]:
    """Axes with tick labels whose label names no unit and no quotient."""
    for axes in panels(figure):
        for way in "xy":
            axis = getattr(axes, f"{way}axis")
            shown = [text for text in (*axis.get_ticklabels(), *axis.get_ticklabels(minor=True)) if id(text) in drawn]
            label = label_of(axes, way)
            if shown and not is_categorical(axes, way) and unit_of(label) is None:
                yield f"{way} axis of {axes.get_title()!r} says {label!r}: no unit"


def rising_depths(figure: Figure) -> Iterator[str]:
    """Axes of depth that do not run down."""
    for axes in panels(figure):
        if DEPTH.match(axes.get_xlabel()):
            yield f"{axes.get_xlabel()!r} runs across"
        if DEPTH.match(label_of(axes, "y")) and not axes.yaxis_inverted():
            yield f"{label_of(axes, 'y')!r} runs up"


# ---- data ----
def data(axes: Axes) -> Iterator[tuple[str, np.ndarray, bool]]:
    """(what, points, whether all of them belong to one pair of columns) of every artist that shows data.

    No data are what stands at a place of the axes instead (axhline, axvspan, a text), and aids to the eye: what carries
    style.AID.
    """
    for line in axes.lines:
        if _shows(line, axes) and line not in _caps(axes):
            points = np.asarray(line.get_xydata(), dtype=float)
            closed = len(points) > 2 and np.array_equal(points[0], points[-1])  # an outline has its two edges in two columns
            yield f"line {line.get_label()!r}", points, not closed
    for found in axes.collections:
        if found.get_offset_transform() is axes.transData and found.get_gid() != AID:
            yield f"points {found.get_label()!r}", np.ma.filled(found.get_offsets().astype(float), np.nan), True
        elif isinstance(found, LineCollection) and _shows(found, axes) and found.get_segments():
            yield f"bars {found.get_label()!r}", np.array(found.get_segments()), False
        elif isinstance(found, PolyCollection) and _shows(found, axes) and found.get_paths():
            points = np.concatenate([path.vertices[:-1] for path in found.get_paths()])
            yield f"band {found.get_label()!r}", points[(points != 0.0).all(axis=1)], False  # an area may stand on an axis
    for bars in axes.containers:
        if isinstance(bars, BarContainer):
            upright = bars.orientation == "vertical"
            middles = [b.get_x() + b.get_width() / 2 if upright else b.get_y() + b.get_height() / 2 for b in bars]
            yield f"bars {bars.get_label()!r}", np.column_stack((middles, bars.datavalues)[:: 1 if upright else -1]), True


def _caps(axes: Axes) -> list:
    """The caps of error bars, which end where the bars do."""
    return [cap for bars in axes.containers if isinstance(bars, ErrorbarContainer) for cap in bars.lines[1]]


def _shows(artist: Any, axes: Axes) -> bool:
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


# ---- look ----
def colour_alone(figure: Figure) -> Iterator[str]:
    """Curves, points and bars of one axes that nothing but their colour tells apart.

    Greys are background, and a curve with its name at its end (style.NAMED) needs no look of its own.  Bands are not asked:
    they lie round curves.
    """
    for axes in panels(figure):
        first: dict = {}
        for what, colour, shape in _looks(axes):
            other, its = first.setdefault(shape, (what, colour))
            if its != colour:
                yield f"{what} and {other} of {axes.get_title()!r} differ by colour alone"


def _looks(axes: Axes) -> Iterator[tuple[str, str, tuple]]:
    """(what, colour, all else of its look) of every curve, cloud of points and set of bars that is no background."""
    for line in axes.lines:
        if _shows(line, axes) and line.get_gid() != NAMED and line not in _caps(axes) and not _is_grey(line.get_color()):
            drawn = line.get_linestyle() not in ("None", "none", "", " ")
            shape = str(line._unscaled_dash_pattern) if drawn else "points", str(line.get_marker()), is_hollow(line)
            yield f"line {line.get_label()!r}", to_hex(line.get_color()), shape
    for points in axes.collections:
        if isinstance(points, PathCollection) and points.get_array() is None and points.get_gid() != AID:
            face, edge = points.get_facecolor(), points.get_edgecolor()
            colours = {to_hex(colour) for colour in (face if len(face) else edge)}
            if len(colours) == 1 and not _is_grey(next(iter(colours))):
                shape = points.get_paths()[0].vertices.tobytes()
                yield f"points {points.get_label()!r}", next(iter(colours)), (shape, len(face) > 0)
    for bars in (bars for bars in axes.containers if isinstance(bars, BarContainer)):
        colours = {to_hex(bar.get_facecolor()) for bar in bars}
        if len(colours) == 1 and not _is_grey(next(iter(colours))):
            yield f"bars {bars.get_label()!r}", next(iter(colours)), ("bars", bars[0].get_hatch() or "")


def is_hollow(line: Line2D) -> bool:
    """Whether a line's markers are not filled with its colour."""
    return to_hex(line.get_markerfacecolor(), keep_alpha=True) != to_hex(line.get_color(), keep_alpha=True)


def _is_grey(colour: Any) -> bool:
    red, green, blue = to_rgb(colour)
    return red == green == blue != 0.0


# ---- words ----
def told(figure: Figure) -> str:
    """All words of a figure's headline, of its legends and of what stands over them, in a row."""
    texts = [figure.get_suptitle()]
    for legend in figure.legends:
        texts += [legend.get_title().get_text(), *(text.get_text() for text in legend.get_texts())]
    return " ".join(" ".join(texts).split())


def outside(words: list[tuple[str, Bbox]], figure: Figure) -> Iterator[str]:
    """Words that the canvas cuts."""
    canvas = figure.bbox.padded(1.0)
    for text, box in words:
        if not (canvas.contains(box.x0, box.y0) and canvas.contains(box.x1, box.y1)):
            yield f"{text!r} leaves the canvas"


def overlapping(texts: list[tuple[Text, Bbox]]) -> Iterator[str]:
    """Words that lie over one another."""
    shapes = [(text.get_text(), box, _corners(text, box)) for text, box in texts]
    for (one, box, shape), (other, its, its_shape) in combinations(shapes, 2):
        if box.overlaps(its) and _overlap(shape, its_shape):
            yield f"{one!r} lies over {other!r}"


def _corners(text: Text, box: Bbox) -> np.ndarray:
    """Corners of a word as it is turned, a little inside its ink's box: letters that just touch are read."""
    turn = np.radians(text.get_rotation())
    middle = np.array([box.x0 + box.x1, box.y0 + box.y1]) / 2
    if abs(np.sin(2 * turn)) < 1e-6:
        width, height, turn = box.width, box.height, 0.0
    else:  # the upright box of a turned one: its height is known from the size of the letters
        height = text.get_fontsize() * text.get_figure(root=True).dpi / 72 * (1 + text.get_text().count("\n"))
        width = (box.width - height * abs(np.sin(turn))) / abs(np.cos(turn))
    inner = np.array([width - 2.0, 0.7 * height]) / 2
    along, up = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    return np.array([middle + i * inner[0] * along + j * inner[1] * up for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])


def _overlap(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two rectangles overlap: no side of either parts them."""
    for side in (one[1] - one[0], one[3] - one[0], other[1] - other[0], other[3] - other[0]):
        mine, its = one @ side, other @ side
        if mine.max() <= its.min() or its.max() <= mine.min():
            return False
    return True
