"""The silo where the plane of a figure cuts it: walls, inserts, what shuts outlets, and the lid, as they stand at a time."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from silostudy.figures.bin import began, opened_at
from silostudy.figures.style import AID

CM = 100.0  # of a metre
FLOOR = "floor"  # one piece that goes as the outlet opens, where outlets have no names
LID = "lid"
AWAY = ": take_away "  # of an event: what follows are names of inserts
BELOW = 0.12  # of the width: what is shown below the lowest part
UPRIGHT = ("left", "right")  # walls of discs that stand above what is filled
MARGIN = 0.02  # of a view's width: beside the end of a line that it is to hold
ROOM = 1.1  # of the height of the highest grain: what is shown of a silo that is less filled


class CutLine(NamedTuple):
    """A line (n, 2; m) across and up in which the plane cuts a part, and the times (s) from which a gap grows in its middle,
    and from which it is gone; endless: it stays."""

    name: str
    line: np.ndarray
    opens: float = np.inf
    goes: float = np.inf

    def left(self, time: float) -> list[np.ndarray]:
        """Lines that are left at a time (s)."""
        if not time > self.opens:
            return [self.line]
        if time > self.goes:
            return []
        half = 0.5 * (time - self.opens) / (self.goes - self.opens)
        (start, end), middle = self.line, self.line.mean(axis=0)
        return [np.array([start, middle + half * (start - end)]), np.array([middle + half * (end - start), end])]


def standing(cube: xr.Dataset, time: float) -> list[np.ndarray]:
    """Lines (n, 2; cm) of all that stands at a time (s)."""
    away = taken_away(cube, time)
    lines = [line for part in parts(cube) if part.name not in away for line in part.left(time)]
    return [CM * line for line in (*lines, *lid(cube, time))]


def draw(panel: Axes, cube: xr.Dataset, time: float, *, folded: bool = False) -> LineCollection:
    """Draws all that stands at a time (s); folded: inserts on both sides of the axis, as means around it see them."""
    mirrored = [CM * part.line * (-1.0, 1.0) for part in _inserts(cube)] if folded else []
    lines = LineCollection(
        [*standing(cube, time), *mirrored], colors="black", linewidths=1.2, capstyle="projecting", zorder=3, gid=AID
    )
    panel.add_collection(lines)
    return lines


def parts(cube: xr.Dataset) -> Iterator[CutLine]:
    """All parts of the silo but its lid."""
    if "disc" in cube.dims:
        yield from (CutLine(name, line, *(_opens(cube) if name == FLOOR else ())) for name, line in _walls(cube))
    else:
        yield from _sides(cube)
        yield from _inserts(cube)
    if "outlet" in cube:
        holes = np.column_stack([cube["outlet_left"], cube["outlet_right"]])
        opened = cube["outlet_opened"]
        times = [np.where(np.isnan(of), np.inf, of) for of in (opened, cube.get("outlet_whole", opened))]
        yield from (
            CutLine("", _level(*hole), *when) for hole, *when in zip(holes, *times, strict=True) if np.isfinite(hole).all()
        )


def _opens(cube: xr.Dataset) -> tuple[float, float]:
    """Times (s) at which an outlet without a name begins to open, and is open."""
    opened = float(cube.attrs.get("outlet_opened_s", opened_at(cube)))
    return opened, float(cube.attrs.get("outlet_whole_s", opened))


def lid(cube: xr.Dataset, time: float) -> list[np.ndarray]:
    """The line (2, 2; m) of the lid at a time (s): where it began, and from then on where the ends of windows saw it."""
    own = cube["wall_name"].values == LID if "wall_name" in cube else np.zeros(0, bool)
    if not own.any():
        return []
    up = "wall_cell_y" if "disc" in cube.dims else "wall_cell_z"
    low, left, right = float(cube[up].values[own].mean()), *edges(cube)
    seen: list = [] if began(cube) and "lid_height" in cube else [(0.0, low)]  # another run had moved it by then
    seen += zip(cube["window_time"].values, cube["lid_height"].values, strict=True) if "lid_height" in cube else []
    return [_level(left, right, float(np.interp(time, *np.transpose(seen))))]


def edges(cube: xr.Dataset) -> tuple[float, float]:
    """Places (m) of the inner sides of the silo."""
    if "disc" in cube.dims:
        sides = cube["wall_cell_x"].values[np.isin(cube["wall_name"].values, ["left", "right"])]
        return float(sides.min()), float(sides.max())
    half = float(cube.attrs["half_width_m"])
    return -half, half


def view(cube: xr.Dataset, tops: float) -> tuple[float, float, float, float]:
    """Left, right, low and high edge (cm) of a picture of the silo; tops: height (m) of the highest grain that it shows.

    What is empty of a high silo is cut off, but for a picture about as high as it is wide, and nothing of what stands in it or
    beside it.
    """
    lines, within = np.vstack([part.line for part in parts(cube)]), inside(cube)
    (left, right), (low, high) = edges(cube), (lines[:, 1].min(), lines[:, 1].max())
    shown = max(min(high, max(ROOM * tops, low + right - left)), within[:, 1].max(initial=low))
    left, right = within[:, 0].min(initial=left), within[:, 0].max(initial=right)
    aside = 0.05 * (right - left)
    return CM * (left - aside), CM * (right + aside), CM * (low - BELOW * (right - left)), CM * (shown + 0.2 * aside)


def inside(cube: xr.Dataset) -> np.ndarray:
    """Ends and corners (n, 2; m) of all that no picture cuts off: inserts, and of discs all but the upright walls."""
    if "disc" in cube.dims:
        lines = [line for name, line in _walls(cube) if name not in UPRIGHT]
    else:
        lines = [part.line for part in _inserts(cube)]
    return np.vstack([np.empty((0, 2)), *lines])


def reaching(box: tuple[float, float, float, float], ends: np.ndarray) -> tuple[float, float, float, float]:
    """A view (cm; left, right, low, high) that holds all lines (n, 4; from across, height, to) whose middle it shows."""
    middle = (ends[:, :2] + ends[:, 2:]) / 2.0
    left, right, low, high = box
    whole = ends[((middle >= (left, low)) & (middle <= (right, high))).all(axis=1)].reshape(-1, 2)
    aside = MARGIN * (right - left)
    least, most = whole.min(axis=0, initial=np.inf) - aside, whole.max(axis=0, initial=-np.inf) + aside
    return min(left, least[0]), max(right, most[0]), min(low, least[1]), max(high, most[1])


def off_the_slice(cube: xr.Dataset) -> set[str]:
    """Names of outlets that the plane does not cut."""
    if "outlet_left" not in cube:
        return set()
    return set(cube["outlet"].values[np.isnan(cube["outlet_left"].values)].astype(str))


def outlet_words(cube: xr.Dataset, time: float) -> str:
    """Whether the outlet is shut, opening or open at a time (s), in words, or how many are; none of a silo without one."""
    if (count := cube.sizes.get("outlet", 1)) > 1:
        begun, whole = (
            int((cube.get(name, cube["outlet_opened"]).values < time).sum()) for name in ("outlet_opened", "outlet_whole")
        )
        return f"{whole} of {count} outlets open" + (f", {begun - whole} opening" if begun > whole else "")
    if "outlet" not in cube and not cube.attrs["outlet_half_width_m"] > 0.0:
        return ""
    if any(part.opens < time <= part.goes for part in parts(cube)):
        return "outlet opening"
    return "outlet open" if any(part.goes < time for part in parts(cube)) else "outlet shut"


def taken_away(cube: xr.Dataset, time: float) -> set[str]:
    """Names of inserts that are gone at a time (s)."""
    done = [str(action).partition(AWAY) for action in cube["event_action"].values[cube["event_time"].values < time]]
    return {name for _, took, names in done if took for name in names.split(", ")}


def outline_of(cube: xr.Dataset) -> np.ndarray:
    """Corners (n, 2; m) of a silo of spheres where a plane through the axis cuts it: the right side down, the left side up."""
    half, outlet, aside, low, top = (
        float(cube.attrs[name])
        for name in ("half_width_m", "outlet_half_width_m", "outlet_middle_m", "transition_height_m", "top_height_m")
    )
    return np.array([(half, top), (half, low), (aside + outlet, 0.0), (aside - outlet, 0.0), (-half, low), (-half, top)])


def _sides(cube: xr.Dataset) -> Iterator[CutLine]:
    """Walls and bottom of a silo of spheres."""
    corners = outline_of(cube)
    if "outlet" not in cube:
        yield from (CutLine("", corners[:3]), CutLine("", corners[3:]), CutLine("", corners[2:4], *_opens(cube)))
        return
    yield from (CutLine("", corners[:2]), CutLine("", corners[4:]))
    holes = np.column_stack([cube["outlet_left"], cube["outlet_right"]])
    ends = [corners[4, 0], *np.sort(holes[np.isfinite(holes[:, 0])].ravel()), corners[1, 0]]
    yield from (CutLine("", _level(*piece)) for piece in np.reshape(ends, (-1, 2)))


def _inserts(cube: xr.Dataset) -> Iterator[CutLine]:
    """Lines of the inserts of a silo of spheres, which a gap ends each."""
    if "insert_x" not in cube:
        return
    line = np.column_stack([cube["insert_x"], cube["insert_z"]])
    names = cube["insert_name"].values.astype(str) if "insert_name" in cube else np.full(len(line), "")
    gaps = np.flatnonzero(np.isnan(line[:, 0]))
    for start, end in zip(np.r_[0, gaps[:-1] + 1], gaps, strict=True):
        yield CutLine(names[start], line[start:end])


def _walls(cube: xr.Dataset) -> Iterator[tuple[str, np.ndarray]]:
    """Name and line of each wall of a silo of discs but its lid: from its first cell to its last, which are its ends."""
    places, names = np.column_stack([cube["wall_cell_x"], cube["wall_cell_y"]]), cube["wall_name"].values.astype(str)
    for name in dict.fromkeys(names):
        if name != LID:
            yield name, places[names == name][[0, -1]]


def _level(left: float, right: float, height: float = 0.0) -> np.ndarray:
    """A level line (2, 2)."""
    return np.array([(left, height), (right, height)])
