"""A scene of grains in time: forces on its surfaces, the panels of its figure, and a sentence on all of it."""

from collections.abc import Sequence

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from silostudy.errors import BadInput
from silostudy.figures import moments
from silostudy.figures.bin import REST as AT_REST
from silostudy.figures.bin import before, began, open_before, opened_at, windows
from silostudy.figures.flow_in_time import Flow
from silostudy.figures.style import AID, REST, WIDTH, plt, series

FELT = 0.05  # of the largest force at rest: surfaces with less are not said to carry anything
SHOWN = 11  # surfaces with a look of their own, the most loaded ones; further ones are grey
ROOM = 1.3  # of the largest force: words of events stand above it
# inches
MARGIN = 0.7  # beside a panel
TALL = 4.9  # a snapshot at most
SHORT = 1.1  # all below the snapshots where nothing is drawn there
LOW = 4.3  # else
LOWER = ("force", "mass")  # panels below the snapshots, where there is anything to show


def check_recorded(cube: xr.Dataset) -> None:
    """Refuses a cube without forces on whole surfaces, or without snapshots."""
    asked = {"surface_normal_force_mean": "record.wall_force_window_s", "snapshot_time": "record.snapshots_s"}
    for name, key in asked.items():
        if name not in cube:
            raise BadInput(key, "nothing", "must be given: the figure of a scene shows what it records")


def forces(cube: xr.Dataset, force: np.ndarray, column: str) -> pd.DataFrame:
    """Force on each surface that is ever touched, mean of each window (by its end), as a long table.

    Facets of a curved sheet count as one surface; a last window that is much shorter than the others is left out.
    """
    long = windows(cube)[1]
    names = cube["surface_sheet" if "surface_sheet" in cube else "surface"].values.astype(str)
    tables = [pd.DataFrame({"surface": name, "time_s": cube["window_time"].values[long], column: values})
              for name in dict.fromkeys(names) if (values := force[long][:, names == name].sum(axis=1)).any()]  # fmt: skip
    return pd.concat(tables, ignore_index=True) if tables else pd.DataFrame(columns=["surface", "time_s", column])


def left_out(cube: xr.Dataset) -> str:
    """Words on a last window that is left out; none where there is none."""
    begun, long = windows(cube)
    lasts = float(cube["window_time"].values[-1] - begun[-1])
    return "" if long.all() else f"; the last, of {lasts:.2g} s only, is left out"


def draw_forces(panels: dict[str, Axes], table: pd.DataFrame, column: str, unit: str, cube: xr.Dataset) -> list[Line2D]:
    """A step a window and a line a surface, thick where the force rises most; nothing while a surface is not touched."""
    if "force" not in panels:
        return []
    panel = panels["force"]
    ranked = list(table.groupby("surface")[column].max().sort_values(ascending=False).index)
    most, lines = subject(cube, table, column), []
    for name, group in table.groupby("surface", sort=False):
        number, touched = ranked.index(name), group[column].where(group[column] != 0.0)
        style = series(number) | {"markersize": 4, "markevery": max(1, len(group) // 8)} if number < SHOWN else REST
        style |= {"linestyle": "-", "linewidth": 2.0 if name == most else 0.9}
        label = name.replace("_", " ") if number < SHOWN else f"{len(ranked) - SHOWN} more" if number == SHOWN else "_"
        lines += panel.plot(group["time_s"], touched, drawstyle="steps-pre", label=label, **style)
        level = style | {"marker": "", "gid": AID}
        panel.plot([began(cube), group["time_s"].iloc[0]], [touched.iloc[0]] * 2, **level)  # steps begin where a window ends
    panel.set(title="forces on the surfaces", ylabel=f"normal force ({unit})", ylim=(0, ROOM * table[column].max()))
    named = [line for line in lines if line.get_label() != "_"]
    return sorted(named, key=lambda line: line.get_color() == REST["color"])


def _lasts(cube: xr.Dataset) -> tuple[float, float]:
    """Start and end (s) of the axis of time, which begins late where the run goes on from another's end."""
    last, start = max(float(cube[name].max()) for name in ("window_time", "event_time")), began(cube)
    return start, last + 0.02 * (last - start)


def lay_out(
    cube: xr.Dataset, shots: Sequence[int], force: pd.DataFrame, flow: Flow, box: tuple[float, float, float, float]
) -> tuple[Figure, dict[str, Axes], float]:
    """Figure and panels (a number a snapshot, and those of LOWER that have data), and the width (inches) of a lower one.

    box: left, right, low and high edge of the snapshots, of one unit.
    """
    names = [str(number) for number in range(len(shots))]
    below = [name for name, table in zip(LOWER, (force, flow.table), strict=True) if len(table)]
    rows: list = [own * (2 // len(own)) for own in (names, below) if own]
    wide = WIDTH - MARGIN if len(names) == 1 else WIDTH / 2 - MARGIN
    tall = min(TALL, wide * (box[3] - box[2]) / (box[1] - box[0]))
    size = (WIDTH, tall + (LOW if below else SHORT))
    figure, panels = plt.subplot_mosaic(rows, figsize=size, height_ratios=(tall + 0.7, 3.2)[: len(rows)])
    for name in names:
        panels[name].set(xlabel="across (cm)", ylabel="height (cm)", aspect="equal", xlim=box[:2], ylim=box[2:])
        panels[name].grid(False)
    for name in below:
        panels[name].set(xlabel="time (s)", xlim=_lasts(cube))
    return figure, panels, WIDTH / max(1, len(below)) - MARGIN


def message(cube: xr.Dataset, table: pd.DataFrame, column: str, unit: str, flow: Flow) -> str:
    """Message: what leaves, and the surface whose force rises most over that at rest; or that with the largest force."""
    opened, (since, begins), flows = opened_at(cube), moments.begins(cube), open_before(cube).any()
    if np.isfinite(opened) and not flows:
        when = AT_REST if before(cube) == AT_REST else "before"  # the sentence begins with the opening
        return f"{begins} {flow.told()}{_rises(*pushed(table, column, opened), when)}"
    surface = subject(cube, table, column)
    if np.isinf(since):
        return (
            f"{before(cube).capitalize()} the largest force is that on {_quoted(surface)}"
            if surface
            else "Nothing touches a surface"
        )
    if flows:
        leaves, begins = f"{begins} {flow.told()}; ", "meanwhile"
    else:
        leaves, begins = (f"{flow.told()}; ", begins[0].lower() + begins[1:]) if len(flow.table) else ("", begins)
    if not surface:
        return f"{leaves}{begins} nothing touches a surface"
    own = _later(cube, table, since)
    time, most = own.loc[own[own["surface"] == surface][column].idxmax(), ["time_s", column]]
    return f"{leaves}{begins} the largest force is {most:.3g} {unit}, on {_quoted(surface)} at {time:.2g} s"


def _later(cube: xr.Dataset, table: pd.DataFrame, since: float) -> pd.DataFrame:
    """The forces of the windows that begin after a time (s)."""
    return table[table["time_s"].isin(cube["window_time"].values[windows(cube)[0] >= since])]


def subject(cube: xr.Dataset, table: pd.DataFrame, column: str) -> str:
    """The surface that the message is on; none where nothing touches one."""
    opened, (since, _) = opened_at(cube), moments.begins(cube)
    if np.isinf(since) or (np.isfinite(opened) and not open_before(cube).any()):
        return pushed(table, column, opened)[0]
    later = _later(cube, table, since)
    return str(later.loc[later[column].idxmax(), "surface"]) if (later[column] > 0.0).any() else ""


def _rises(surface: str, rise: float, when: str) -> str:
    """Words on the surface whose force rises most over that before (when: at rest, or before); none where there is none."""
    if not surface or np.isnan(rise):
        return ""
    if not float(f"{rise:.2g}") > 1.0:
        return f"; no surface is pressed more than {when}"
    return f"; the force on {_quoted(surface)} comes to {rise:.2g} times that {when}, more than on any other"


def pushed(table: pd.DataFrame, column: str, opened: float) -> tuple[str, float]:
    """The surface with the largest force over that at rest, and this ratio; without a flow that with the largest at rest."""
    rest = table[table["time_s"] <= opened].groupby("surface")[column].last()
    peak = table[table["time_s"] > opened].groupby("surface")[column].max()
    carrying = rest[(rest > 0.0) & (rest >= FELT * rest.max())]
    if carrying.empty:
        return "", np.nan
    rises = (peak / carrying).dropna()
    return (str(carrying.idxmax()), np.nan) if rises.empty else (str(rises.idxmax()), float(rises.max()))


def _quoted(surface: str) -> str:
    """The name of a surface in quotes."""
    return f"\N{LEFT DOUBLE QUOTATION MARK}{surface.replace('_', ' ')}\N{RIGHT DOUBLE QUOTATION MARK}"
