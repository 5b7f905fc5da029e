"""What each setting of a scene of spheres changes of its means over fillings, numerical settings beside contact laws.

The first point of the axis is the setting that all others are held against; each of them changes one thing.
"""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from scipy.stats import t as student

from silostudy.errors import BadInput
from silostudy.figures.style import plt, save

AXES = ("setting", "filling")
TITLE = "setting_title"
SURE = 0.95
QUANTITIES = {
    "body_normal_force_at_rest": "normal force on the walls at rest",
    "unit_weight_at_rest": "unit weight at rest",
    "mean_mass_flow": "mass flow",
}
NUMERICAL, MODEL = "#0072b2", "#d55e00"
ROW = 0.24  # inches


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row for each setting, a panel for each quantity."""
    table = ladders(cube)
    names, shown = list(dict.fromkeys(table["setting"])), list(dict.fromkeys(table["quantity"]))
    figure, panels = plt.subplots(
        1, len(shown), sharey=True, squeeze=False, figsize=(3.2 + 3.0 * len(shown), 1.9 + ROW * len(names))
    )
    for panel, quantity in zip(panels[0], shown, strict=True):
        part = table[table["quantity"] == quantity]
        _draw_panel(panel, part, names)
        panel.set(xlabel=f"{QUANTITIES[quantity]},\nchange (%)")
    panels[0, 0].set_yticks(range(len(names)), names)
    panels[0, 0].set_ylim(len(names) - 0.5, -0.5)
    figure.suptitle(
        f"{cube.attrs['title']}\nbars: 95 % of means of so many fillings; band: spread of the contact laws", fontsize=10
    )
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    save(figure, table, stem)


def _draw_panel(panel, part: pd.DataFrame, names: list[str]) -> None:
    laws = part[part["model"]]
    if len(laws):
        low, high = 100.0 * laws["change"].min(), 100.0 * laws["change"].max()
        panel.axvspan(min(0.0, low), max(0.0, high), color=MODEL, alpha=0.12, label="spread of the contact laws")
    for model, colour, label in ((False, NUMERICAL, "numerical setting"), (True, MODEL, "contact law")):
        rows = part[part["model"] == model]
        if len(rows):
            places = [names.index(name) for name in rows["setting"]]
            panel.hlines(places, 100.0 * rows["low"], 100.0 * rows["high"], color=colour, linewidth=1.5)
            panel.plot(100.0 * rows["change"], places, "o", markersize=4, color=colour, label=label)
    panel.axvline(0.0, color="black", linewidth=0.8)


def ladders(cube: xr.Dataset) -> pd.DataFrame:
    """Change of each quantity's mean over the fillings against the first setting, and half its interval, by setting."""
    rows = []
    for quantity in QUANTITIES:
        if quantity not in cube:
            continue
        of = cube[quantity].sel(body="walls") if "body" in cube[quantity].dims else cube[quantity]
        values = of.transpose(*AXES).values
        if not np.isfinite(values[0]).any():
            continue
        for place, (name, model) in enumerate(labels(cube)):
            change, half = changed(values[place], values[0]) if place else (0.0, _half(values[0]))
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
        raise BadInput("outputs", "ladders", f"none of {', '.join(QUANTITIES)} was seen in the first setting")
    return pd.DataFrame(rows)


def labels(cube: xr.Dataset) -> list[tuple[str, bool]]:
    """Title of each setting, and whether it changes a law of the first's."""
    columns = [cube[name].values for name in map(str, cube.coords) if name.startswith("setting_") and name != TITLE]
    laws = [values for values in columns if values.dtype.kind not in "iuf"]
    titles = map(str, cube[TITLE].values)
    return [(title, any(values[place] != values[0] for values in laws)) for place, title in enumerate(titles)]


def changed(values: np.ndarray, base: np.ndarray) -> tuple[float, float]:
    """Relative change (1) of a mean against another, and half its interval by Welch."""
    own, other = values[np.isfinite(values)], base[np.isfinite(base)]
    parts = [part.var(ddof=1) / len(part) for part in (own, other)]
    freedom = sum(parts) ** 2 / sum(part**2 / (len(of) - 1) for part, of in zip(parts, (own, other), strict=True))
    half = student.ppf(0.5 + SURE / 2, freedom) * np.sqrt(sum(parts))
    return float(own.mean() / other.mean() - 1.0), float(half / abs(other.mean()))


def _half(values: np.ndarray) -> float:
    """Half the relative interval (1) of a mean."""
    seen = values[np.isfinite(values)]
    return float(student.ppf(0.5 + SURE / 2, len(seen) - 1) * seen.std(ddof=1) / np.sqrt(len(seen)) / abs(seen.mean()))
