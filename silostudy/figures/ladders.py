"""Changes of means over fillings with each setting of a scene of spheres: numerical settings beside what models leave open.

The first point of the axis is the setting that all others are held against; each of them changes one thing.  Beside them
stand contact laws, another code from the same starts where it was measured, and what one filling alone may be off.
"""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.errors import BadInput
from silostudy.figures.intervals import changed, half_interval, reach_of_one
from silostudy.figures.ladder_rungs import setting_label
from silostudy.figures.style import BLUE, GREEN, PURPLE, TALLEST, VERMILION, WIDTH, foot, headline, plt, save
from silostudy.tables.code_differences import CODE_DIFFERENCES, CodeDifference

AXES = ("setting", "filling")
TITLE = "setting_title"
ONE = "filling: one of them alone"
FIRST = "as the others are held against"  # setting, where settings have no titles
QUANTITIES = {
    "body_normal_force_at_rest": "wall force at rest",
    "unit_weight_at_rest": "unit weight at rest",
    "mean_mass_flow": "mass flow",
}
PEAK = {"largest_wall_force_in_flow": "largest wall force in flow"}
# sorts of rows
SETTING = "setting"
LAW = "contact law"
CODE = "code"
FILLING = "filling"
LOOKS = {
    SETTING: (BLUE, "o", "numerical setting"),
    LAW: (VERMILION, "s", "contact law"),
    CODE: (GREEN, "^", "another code, same law, step and starts"),
    FILLING: (PURPLE, "_", "one filling"),
}
SAID = {SETTING: "settings", LAW: "contact laws", CODE: "another code", FILLING: "one filling"}
ROW = 0.26  # inches


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    titles = QUANTITIES | PEAK
    values = dict(quantities(cube)) | dict.fromkeys(PEAK, largest_in_flow(cube))
    values = {name: of for name, of in values.items() if np.isfinite(of[0]).any()}
    _draw(cube, stem, pd.concat([ladders(cube, values), beside_settings(cube, values)], ignore_index=True), titles)


def draw_ladders(
    cube: xr.Dataset, stem: Path, values: Mapping[str, np.ndarray], titles: Mapping[str, str], further: Sequence[str] = ()
) -> None:
    """Writes a figure of quantities (setting, filling) under their titles, a panel each, a row a setting; its numbers too.

    further: titles of what else was changed, whose values come after those of the settings.
    """
    _draw(cube, stem, ladders(cube, values, further), titles)


def _draw(cube: xr.Dataset, stem: Path, table: pd.DataFrame, titles: Mapping[str, str]) -> None:
    names, shown = list(dict.fromkeys(table["setting"])), list(dict.fromkeys(table["quantity"]))
    size = WIDTH, min(TALLEST, 2.2 + ROW * len(names))
    figure, panels = plt.subplots(1, len(shown), sharey=True, squeeze=False, figsize=size)
    for panel, quantity in zip(panels[0], shown, strict=True):
        handles = _draw_panel(panel, table[table["quantity"] == quantity], names)
        panel.set(xlabel=f"{titles[quantity]}:\nchange (%)")
    panels[0, 0].set_yticks(range(len(names)), names)
    panels[0, 0].set_ylim(len(names) - 0.5, -0.5)
    headline(figure, _message(table, titles))
    band = " Band: how far contact laws are apart." if (table["sort"] == LAW).any() else ""
    told = f"Bars: 95 % intervals of means of {cube.sizes['filling']} fillings{_further(cube, table)}.{band}"
    first = "" if TITLE in cube else f" Held against: {setting_label(cube, 0)}."
    foot(figure, str(cube.attrs["title"]), told + first, *_unseen(table, titles), handles=handles)
    save(figure, table, stem)


def _message(table: pd.DataFrame, titles: Mapping[str, str]) -> str:
    """Sentence on how much settings, laws, another code and one filling change each quantity at most."""
    told = [
        f"{SAID[sort]} {', '.join(_most(sort, of) for _, of in rows.groupby('quantity', sort=False))} %"
        for sort, rows in table.groupby("sort", sort=False)
    ]
    *others, last = (titles[name] for name in dict.fromkeys(table["quantity"]))
    what = " and ".join([", ".join(others), last] if others else [last])
    return f"Off in {what} by at most: {'; '.join(told)}"


def _most(sort: str, rows: pd.DataFrame) -> str:
    """Largest change of a quantity in %, of another code with half its interval; of one filling how far it may lie off."""
    if sort == FILLING:
        return f"{100.0 * rows['high'].max():.2g}"
    half = f" ± {50.0 * (rows['high'] - rows['low']).max():.2g}" if sort == CODE else ""
    return f"{100.0 * rows['change'].abs().max():.2g}{half}"


def _further(cube: xr.Dataset, table: pd.DataFrame) -> str:
    """Words on the bars of what is no setting and no law."""
    if not (table["sort"] == FILLING).any():
        return ""
    codes = f", of the other code of {codes[0].fillings}" if (codes := of_codes(cube)) else ""
    return f"{codes}; of one filling where it lies"


def _unseen(table: pd.DataFrame, titles: Mapping[str, str]) -> list[str]:
    """Line that names the settings whose fillings do not show every quantity; none where all do."""
    missing = table[table["change"].isna()].groupby("setting", sort=False)["quantity"].agg(list)
    told = [f"{name} ({', '.join(titles[quantity] for quantity in of)})" for name, of in missing.items()]
    return [f"Not come to rest, or not flowing in time: {'; '.join(told)}."] if told else []


def _draw_panel(panel, part: pd.DataFrame, names: list[str]) -> list:
    """Draws one quantity; what the legend shows."""
    laws, handles = part[part["sort"] == LAW], []
    if len(laws):
        low, high = 100.0 * laws["change"].min(), 100.0 * laws["change"].max()
        band = panel.axvspan(min(0.0, low), max(0.0, high), color="0.92", zorder=0, label="spread of the contact laws")
        handles.append(band)
    for sort, (colour, marker, label) in LOOKS.items():
        rows = part[part["sort"] == sort]
        if len(rows):
            places = [names.index(name) for name in rows["setting"]]
            panel.hlines(places, 100.0 * rows["low"], 100.0 * rows["high"], color=colour, linewidth=1.5)
            handles += panel.plot(100.0 * rows["change"], places, marker, markersize=4, color=colour, label=label)
    panel.axvline(0.0, color="black", linewidth=0.8)
    return handles


def ladders(cube: xr.Dataset, values: Mapping[str, np.ndarray], further: Sequence[str] = ()) -> pd.DataFrame:
    """Change of each quantity's mean over the fillings against the first setting, and half its interval, by setting."""
    named = [*((title, LAW if law else SETTING) for title, law in labels(cube)), *((title, SETTING) for title in further)]
    rows = []
    for quantity, of in values.items():
        for place, (name, sort) in enumerate(named):
            change, half = changed(of[place], of[0]) if place else (0.0, half_interval(of[0]))
            rows.append(_row(name, sort, quantity, change, half))
    if not rows:
        raise BadInput("outputs", "ladders", "no quantity was seen in the first setting")
    return pd.DataFrame(rows)


def beside_settings(cube: xr.Dataset, values: Mapping[str, np.ndarray]) -> pd.DataFrame:
    """The same of another code from the same starts, where it was measured of this study, and of one filling alone."""
    rows = [
        _row(f"code: LAMMPS {told.lammps_version}", CODE, told.quantity, told.change, told.half_interval)
        for told in of_codes(cube)
        if told.quantity in values
    ]
    rows += [_row(ONE, FILLING, quantity, 0.0, reach_of_one(of[0])) for quantity, of in values.items()]
    return pd.DataFrame(rows)


def of_codes(cube: xr.Dataset) -> list[CodeDifference]:
    """Differences of another code that were measured in the first setting of the cube's study."""
    return [told for told in CODE_DIFFERENCES if told.study == cube.attrs["title"]]


def _row(name: str, sort: str, quantity: str, change: float, half: float) -> dict:
    ends = {"low": change - half, "high": change + half}
    return {"setting": name, "sort": sort, "quantity": quantity, "change": change} | ends


def largest_in_flow(cube: xr.Dataset) -> np.ndarray:
    """Largest mean of the pressure (Pa; setting, filling) on all of the wall over a window in flow; NaN where none is kept."""
    if "wall_pressure_in_flow" not in cube:
        return np.full([cube.sizes[axis] for axis in AXES], np.nan)
    return cube["wall_pressure_in_flow"].mean(("wall_level", "wall_turn")).max("flow_window").transpose(*AXES).values


def quantities(cube: xr.Dataset) -> Iterator[tuple[str, np.ndarray]]:
    """Yields each quantity that the first setting shows, and its values (setting, filling)."""
    for quantity in QUANTITIES:
        if quantity in cube:
            of = cube[quantity].sel(body="walls") if "body" in cube[quantity].dims else cube[quantity]
            values = of.transpose(*AXES).values
            if np.isfinite(values[0]).any():
                yield quantity, values


def labels(cube: xr.Dataset) -> list[tuple[str, bool]]:
    """Title of each setting, or what it changes, and whether that is a law of the first's."""
    columns = [cube[name].values for name in map(str, cube.coords) if name.startswith("setting_") and name != TITLE]
    laws = [values for values in columns if values.dtype.kind not in "iuf"]
    own = [FIRST, *(setting_label(cube, place) for place in range(1, cube.sizes["setting"]))]
    titles = map(str, cube[TITLE].values) if TITLE in cube else own
    return [(title, any(values[place] != values[0] for values in laws)) for place, title in enumerate(titles)]
