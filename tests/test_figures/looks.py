"""How curves, points and bars of a figure look, and whether more than their colour tells them apart."""

from collections.abc import Iterator
from typing import Any

from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.container import BarContainer
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from silostudy.figures.style import AID, NAMED
from tests.test_figures.content import caps, shows
from tests.test_figures.labels import panels


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
        if shows(line, axes) and line.get_gid() != NAMED and line not in caps(axes) and not _is_grey(line.get_color()):
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
