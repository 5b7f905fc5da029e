"""Prices of means over fillings by the error asked for: what each numerical setting of a scene of spheres costs, and its floor.

A setting is off by what its mean differs from that of the finest setting of its ladder, beyond chance; fillings do the rest.
"""

from math import ceil
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.artist import Artist

from silostudy.errors import BadInput
from silostudy.figures.intervals import changed
from silostudy.figures.ladder_rungs import LADDERS, rungs_of
from silostudy.figures.ladders import QUANTITIES, labels, quantities
from silostudy.figures.style import REST, WIDTH, foot, headline, save, series

MARKED = (0.1, 0.05, 0.02)
ASKED = np.unique([*np.geomspace(0.01, 0.2, 60), *MARKED])[::-1]
MOST = 1000  # fillings: an error that asks for more counts as out of reach
NORMAL = 1.96  # standard deviations within which 95 % of means lie
NUMERICAL = tuple(column for column, ladder in LADDERS.items() if ladder.end)  # whose finest rung is the best


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel for each quantity, a curve for each setting that is the cheapest somewhere."""
    table = prices(cube)
    shown = list(dict.fromkeys(table["quantity"]))
    figure, panels = plt.subplots(1, len(shown), sharey=True, squeeze=False, figsize=(WIDTH, 5.6))
    best = list(dict.fromkeys(table[table["cheapest"]]["setting"]))
    handles: dict[str, Artist] = {}
    for panel, quantity in zip(panels[0], shown, strict=True):
        handles |= _draw_panel(panel, table[table["quantity"] == quantity], best)
        panel.set(title=QUANTITIES[quantity], xlabel="error asked for (%)", xscale="log", yscale="log")
        panel.invert_xaxis()
        panel.set_xticks([100.0 * asked for asked in MARKED], [f"{100.0 * asked:g}" for asked in MARKED])
        panel.minorticks_off()
    panels[0, 0].set_ylabel("number of particle-steps of all fillings")
    headline(figure, _message(table))
    told = (
        f"95 % of means keep the error. A curve ends where its setting is off by as much; it is thin where "
        f"{cube.sizes['filling']} fillings cannot tell whether it is. Grey: settings that are the cheapest nowhere."
    )
    foot(figure, str(cube.attrs["title"]), told, handles=[handles[name] for name in best])
    save(figure, table, stem)


def prices(cube: xr.Dataset) -> pd.DataFrame:
    """A row a quantity, error asked for and setting: fillings and particle-steps, whether it is shown, and is the cheapest."""
    rows = []
    steps = steps_of(cube)
    for quantity, values in quantities(cube):
        for place, (off, doubt, name) in rungs(cube, values).items():
            seen = values[place][np.isfinite(values[place])]
            if not np.isfinite(doubt):  # it did not come to rest, or not flow
                continue
            scatter = float(seen.std(ddof=1) / abs(seen.mean()))
            for asked in ASKED:
                if asked <= off:
                    break
                fillings = max(1, ceil((NORMAL * scatter / (asked - off)) ** 2))
                if fillings > MOST:
                    break
                rows.append((quantity, asked, name, off, doubt, fillings, fillings * steps[place], asked >= doubt))
    if not rows:
        asked_for = ", ".join(name.removeprefix("setting_") for name in NUMERICAL)
        raise BadInput("outputs", "price_of_means", f"the axis `setting` varies none of {asked_for}, or no quantity was seen")
    columns = ["quantity", "asked", "setting", "surely_off", "doubt", "fillings", "particle_steps", "told"]
    table = pd.DataFrame(rows, columns=columns)
    least = table.groupby(["quantity", "asked"])["particle_steps"].transform("min")
    return table.assign(cheapest=table["particle_steps"] == least)


def steps_of(cube: xr.Dataset) -> np.ndarray:
    """Particle-steps of a filling of each setting, mean over the fillings."""
    steps = cube["grains_at_start"] * cube["end_time"] / cube["time_step"]
    return steps.mean("filling").values


def rungs(cube: xr.Dataset, values: np.ndarray) -> dict[int, tuple[float, float, str]]:
    """Errors of each rung of a ladder that are sure, and that may be by chance (1), and its title, by place.

    A rung stands on the first setting in all that its own ladder does not vary, so it is off by that one's errors there too.
    """
    ladders = {column: rungs_of(cube, column) for column in NUMERICAL if column in cube}
    off = {
        column: {place: _off(values[place], values[finest], place == finest) for place, finest in ladder}
        for column, ladder in ladders.items()
    }
    told = {}
    for column, ladder in ladders.items():
        for place, _ in ladder:
            errors = [off[column][place], *(off[other][0] for other in off if other != column)]
            told[place] = sum(sure for sure, _ in errors), max(doubt for _, doubt in errors), labels(cube)[place][0]
    return told


def _off(own: np.ndarray, finest: np.ndarray, alone: bool) -> tuple[float, float]:
    """Relative difference (1) of two means beyond chance, and half the interval of it; of the finest alone that of its mean."""
    change, half = changed(own, finest)
    return (0.0, half / 2**0.5) if alone else (max(0.0, abs(change) - half), half)


def _draw_panel(panel, part: pd.DataFrame, best: list[str]) -> dict[str, Artist]:
    """Draws one quantity; gives the lines of the settings that are the cheapest somewhere, by their titles."""
    handles: dict[str, Artist] = {}
    for name, rows in part.groupby("setting", sort=False):
        if name not in best:
            panel.plot(100.0 * rows["asked"], rows["particle_steps"], **REST)
            continue
        look = series(best.index(str(name))) | {"markersize": 4, "markevery": 12}
        panel.plot(100.0 * rows["asked"], rows["particle_steps"], **look | {"linewidth": 0.7, "marker": "none"})
        told = rows[rows["told"]]
        (handles[str(name)],) = panel.plot(
            100.0 * told["asked"], told["particle_steps"], label=name, **look | {"linewidth": 2.0}
        )
    for asked in MARKED:
        panel.axvline(100.0 * asked, color="0.85", linewidth=0.8, zorder=0)
    return handles


def _message(table: pd.DataFrame) -> str:
    """Sentence on what 10, 5 and 2 % cost of each quantity at the cheapest setting that is surely not off by more."""
    told = []
    for quantity, part in table.groupby("quantity", sort=False):
        costs = [part[np.isclose(part["asked"], asked)]["particle_steps"].min() for asked in MARKED]
        words = [f"{cost:.2g}" if np.isfinite(cost) else "out of reach" for cost in 1e-9 * np.array(costs)]
        told.append(f"{QUANTITIES[str(quantity)]} {', '.join(words)}")
    return f"Billions of particle-steps for errors of 10, 5 and 2 %: {'; '.join(told)}"
