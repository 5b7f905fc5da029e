"""Effect of moisture on the wall pressure, over depth: where a quotient of two methods comes to the measured ratio."""

from collections.abc import Sequence
from textwrap import fill
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.measured import cases_of, crossing, swelling_over_filling
from silostudy.figures.style import COLOURS, LINES, series
from silostudy.tables.measured import Measurement

DEEPEST = 0.9  # z/z_o down to which the quotient is drawn


def curves(cube: xr.Dataset, swollen: Sequence[Measurement], swelling: str, filled: tuple[str, str]) -> pd.DataFrame:
    """Pressure of the swelling solid over that of filling by its own code (the first of `filled`) and by Janssen.

    With a lateral pressure ratio that no wall changes, as Janssen's, the quotient is the same on every wall of a solid: the
    first wall stands for all.
    """
    tables: list[pd.DataFrame] = []
    seen: set[str] = set()
    for place in sorted({place for point in swollen for place in cases_of(cube, point)}):
        here = cube.isel(silo=place)
        solid, wall = str(here["silo_solid"].values), str(here["silo_wall"].values)
        for method in filled[: 1 if solid in seen else 2]:
            depth, ratio = swelling_over_filling(here, swelling, method)
            names = {"shown": "curve", "swelling": swelling, "pressure_method": method}
            names |= {"title": str(here["pressure_method_title"].sel(pressure_method=method).values)}
            names |= {"taken_solid": solid, "taken_wall": wall if method == filled[0] else "any"}
            tables.append(pd.DataFrame({"relative_depth": depth, "ratio": ratio}).assign(**names))
        seen.add(solid)
    return pd.concat(tables, ignore_index=True)


def crossings(drawn: pd.DataFrame, swollen: Sequence[Measurement]) -> pd.DataFrame:
    """Depths where the curves of a measurement's solid come to its value; NaN, and the least value, where they do not."""
    rows = []
    for point in swollen:
        own = drawn[drawn.taken_solid == point.taken_solid].groupby(["swelling", "pressure_method", "taken_wall"], sort=False)
        for names, curve in own:
            depth = crossing(curve.relative_depth.to_numpy(), curve.ratio.to_numpy(), point.value)
            row = dict(zip(("swelling", "pressure_method", "taken_wall"), names, strict=True))
            row |= {"shown": "crossing", "measurement": point.measurement, "taken_solid": point.taken_solid}
            rows.append(row | {"relative_depth": depth, "ratio": point.value, "least_ratio": curve.ratio.min()})
    return pd.DataFrame(rows)


def words(met: pd.DataFrame, point: Measurement) -> str:
    """Depths where the curves come to the measured value, in words."""
    told = []
    for row in met[met.measurement == point.measurement].itertuples():
        meet = np.isfinite(row.relative_depth)
        where = f"at z/z_o = {row.relative_depth:.2f}" if meet else f"nowhere, at least {row.least_ratio:.2f}"
        told.append(f"{row.swelling} over {row.pressure_method} on {row.taken_wall} wall: {where}")
    return "; ".join(told)


def draw_on(panel: Axes, drawn: pd.DataFrame, met: pd.DataFrame, swollen: Sequence[Measurement]) -> None:
    """Draws the curves, the measured ratios and where they meet."""
    solids, walls = list(dict.fromkeys(drawn.taken_solid)), list(dict.fromkeys(drawn.taken_wall))
    walls = [*(wall for wall in walls if wall != "any"), "any"]
    for number, ((solid, method, wall), curve) in enumerate(drawn.groupby(["taken_solid", "title", "taken_wall"], sort=False)):
        shown, dotted = curve[curve.relative_depth <= DEEPEST], wall == "any"
        look: dict[str, Any] = series(number) | {"color": COLOURS[solids.index(solid)]}  # a solid has one colour
        look |= {"linestyle": ":" if dotted else LINES[walls.index(wall)]}
        label = f"{_plain(solid)} on {'any' if dotted else wall.upper()} wall, over {method.partition(' (')[0]}"
        panel.plot(shown.ratio, shown.relative_depth, markevery=0.2, label=label, **look)
    points = met.dropna(subset="relative_depth")
    panel.plot(points.ratio, points.relative_depth, "k*", markersize=9, label="a curve comes to a measured ratio")
    _ratios(panel, sorted(swollen, key=lambda point: point.value))
    panel.set(xlabel="pressure of the swelling\nover that of the filled solid", ylabel="relative depth z/z_o, z_o = R/mu")
    panel.set(xlim=(1.6, 5.2), ylim=(DEEPEST, 0))
    others = [point for point in swollen if _plain(point.taken_solid) != point.solid]
    taken = dict.fromkeys(f"{_plain(point.taken_solid)} for {point.solid}" for point in others)
    panel.set_title(fill(f"Ratios: moist grain swells (AS 3774-1996, one source); stand-ins: {', '.join(taken)}", 44))


def _plain(solid: str) -> str:
    return solid.partition("_")[0]


def _ratios(panel: Axes, rising: Sequence[Measurement]) -> None:
    """A line for each measured ratio, its name on the side where no other stands close."""
    for place, point in enumerate(rising):
        panel.axvline(point.value, color="0.35", linewidth=0.9, zorder=1)
        side, gap = ("right", -3) if place % 2 else ("left", 3)
        name = f"{point.solid} {point.told}" + (" (index)" if "index" in point.quantity else "")
        panel.annotate(name, (point.value, 0.02), (gap, 0), panel.get_xaxis_transform(), "offset points", ha=side, va="bottom",
                       rotation=90, fontsize="small")  # fmt: skip
