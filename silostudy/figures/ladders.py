"""Changes of means over fillings with each setting of a scene of spheres, numerical settings beside contact laws.

The first point of the axis is the setting that all others are held against; each of them changes one thing.
"""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from scipy.stats import t as student

from silostudy.errors import BadInput
from silostudy.figures.ladder_rungs import setting_label
from silostudy.figures.style import BLUE, TALLEST, VERMILION, WIDTH, foot, headline, plt, save

AXES = ("setting", "filling")
TITLE = "setting_title"
FIRST = "as the others are held against"  # setting, where settings have no titles
SURE = 0.95
QUANTITIES = {
    "body_normal_force_at_rest": "wall force at rest",
    "unit_weight_at_rest": "unit weight at rest",
    "mean_mass_flow": "mass flow",
}
LOOKS = {False: (BLUE, "o", "numerical setting"), True: (VERMILION, "s", "contact law")}
ROW = 0.26  # inches


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    draw_ladders(cube, stem, dict(quantities(cube)), QUANTITIES)


def draw_ladders(
    cube: xr.Dataset, stem: Path, values: Mapping[str, np.ndarray], titles: Mapping[str, str], further: Sequence[str] = ()
) -> None:
    """Writes a figure of quantities (setting, filling) under their titles, a panel each, a row a setting; its numbers too.

    further: titles of what else was changed, whose values come after those of the settings.
    """
    table = ladders(cube, values, further)
    names, shown = list(dict.fromkeys(table["setting"])), list(dict.fromkeys(table["quantity"]))
    size = WIDTH, min(TALLEST, 2.2 + ROW * len(names))
    figure, panels = plt.subplots(1, len(shown), sharey=True, squeeze=False, figsize=size)
    for panel, quantity in zip(panels[0], shown, strict=True):
        handles = _draw_panel(panel, table[table["quantity"] == quantity], names)
        panel.set(xlabel=f"{titles[quantity]}:\nchange (%)")
    panels[0, 0].set_yticks(range(len(names)), names)
    panels[0, 0].set_ylim(len(names) - 0.5, -0.5)
    headline(figure, _message(table, titles))
    band = " Band: how far contact laws are apart." if table["model"].any() else ""
    told = f"Bars: 95 % intervals of means of {cube.sizes['filling']} fillings.{band}"
    first = "" if TITLE in cube else f" Held against: {setting_label(cube, 0)}."
    foot(figure, str(cube.attrs["title"]), told + first, *_unseen(table, titles), handles=handles)
    save(figure, table, stem)


def _message(table: pd.DataFrame, titles: Mapping[str, str]) -> str:
    """Sentence on how much settings and laws change each quantity at most."""
    most = 100.0 * table["change"].abs().groupby([table["model"], table["quantity"]], sort=False).max()
    told = [
        ", ".join(f"the {titles[name]} by {value:.2g} %" for name, value in most[model].items())
        for model in most.index.unique(0)
    ]
    return "; ".join(f"{what} at most {text}" for what, text in zip(("Settings change", "contact laws"), told, strict=False))


def _unseen(table: pd.DataFrame, titles: Mapping[str, str]) -> list[str]:
    """Line that names the settings whose fillings do not show every quantity; none where all do."""
    missing = table[table["change"].isna()].groupby("setting", sort=False)["quantity"].agg(list)
    told = [f"{name} ({', '.join(titles[quantity] for quantity in of)})" for name, of in missing.items()]
    return [f"Not come to rest, or not flowing in time: {'; '.join(told)}."] if told else []


def _draw_panel(panel, part: pd.DataFrame, names: list[str]) -> list:
    """Draws one quantity; what the legend shows."""
    laws, handles = part[part["model"]], []
    if len(laws):
        low, high = 100.0 * laws["change"].min(), 100.0 * laws["change"].max()
        band = panel.axvspan(min(0.0, low), max(0.0, high), color="0.92", zorder=0, label="spread of the contact laws")
        handles.append(band)
    for model, (colour, marker, label) in LOOKS.items():
        rows = part[part["model"] == model]
        if len(rows):
            places = [names.index(name) for name in rows["setting"]]
            panel.hlines(places, 100.0 * rows["low"], 100.0 * rows["high"], color=colour, linewidth=1.5)
            handles += panel.plot(100.0 * rows["change"], places, marker, markersize=4, color=colour, label=label)
    panel.axvline(0.0, color="black", linewidth=0.8)
    return handles


def ladders(cube: xr.Dataset, values: Mapping[str, np.ndarray], further: Sequence[str] = ()) -> pd.DataFrame:
    """Change of each quantity's mean over the fillings against the first setting, and half its interval, by setting."""
    named = [*labels(cube), *((title, False) for title in further)]
    rows = []
    for quantity, of in values.items():
        for place, (name, model) in enumerate(named):
            change, half = changed(of[place], of[0]) if place else (0.0, half_interval(of[0]))
            rows.append(
                {
                    "setting": name,
                    "model": model,
                    "quantity": quantity,
                    "change": change,
                    "low": change - half,
                    "high": change + half,
                }
            )
    if not rows:
        raise BadInput("outputs", "ladders", "no quantity was seen in the first setting")
    return pd.DataFrame(rows)


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


def changed(values: np.ndarray, base: np.ndarray) -> tuple[float, float]:
    """Relative change (1) of a mean against another, and half its interval by Welch; NaN where fewer than two values are."""
    own, other = values[np.isfinite(values)], base[np.isfinite(base)]
    if min(len(own), len(other)) < 2:
        return np.nan, np.nan
    parts = [part.var(ddof=1) / len(part) for part in (own, other)]
    freedom = sum(parts) ** 2 / sum(part**2 / (len(of) - 1) for part, of in zip(parts, (own, other), strict=True))
    half = student.ppf(0.5 + SURE / 2, freedom) * np.sqrt(sum(parts))
    return float(own.mean() / other.mean() - 1.0), float(half / abs(other.mean()))


def half_interval(values: np.ndarray) -> float:
    """Half the relative interval (1) of a mean."""
    seen = values[np.isfinite(values)]
    return float(student.ppf(0.5 + SURE / 2, len(seen) - 1) * seen.std(ddof=1) / np.sqrt(len(seen)) / abs(seen.mean()))
