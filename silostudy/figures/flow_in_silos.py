"""Flow of silos of spheres: the rate beside Beverloo's law, the wall friction that acts, and how high dead grains reach."""

from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import row, settings, span, told
from silostudy.figures.findings_of_grains import height_not_sliding
from silostudy.figures.style import BLUE, REST, VERMILION, WIDTH, foot, headline, plt, save

LETTERS = 18  # in a line of a setting's name
RATE = "mass flow (kg/s)"
HEIGHT = "height (m)"
FRICTION = "wall shear over pressure (1)"
UNITS = {RATE: "_kg_s", FRICTION: "", HEIGHT: "_m"}
ENDS = ("mean", "low_95", "high_95")
WALLS: dict[str, tuple[str, float, dict[str, Any]]] = {  # variable -> name, place beside the setting's, look
    "mobilised_wall_friction": ("vertical wall", -0.14, {"marker": "o"}),
    "hopper_mobilised_friction": ("hopper", 0.14, {"marker": "s"}),
}
PHASES: dict[str, tuple[str, dict[str, Any]]] = {
    "filling": ("at rest", {"color": BLUE, "markerfacecolor": "white"}),
    "discharge": ("in flow", {"color": VERMILION}),
}
BARS: dict[str, Any] = {"linestyle": "none", "capsize": 3, "markersize": 6}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row a setting, and panels of the rate, the friction and the dead grains."""
    every = list(settings(cube))
    size = (WIDTH, 2.6 + 0.75 * len(every))
    figure, (rate, friction, height) = plt.subplots(1, 3, figsize=size, sharey=True, width_ratios=(1.0, 1.2, 0.9))
    numbers = pd.DataFrame([line for place, (setting, silo) in enumerate(every) for line in _lines(silo, setting, place)])
    _rates(rate, numbers)
    _frictions(friction, numbers)
    known = numbers[numbers["panel"] == HEIGHT]
    _points(height, known, color=VERMILION, marker="D")
    height.set(xlabel=HEIGHT, title="no sliding below", xlim=(0.0, None))
    rate.set_yticks(range(len(every)), [fill(told(setting, silo), LETTERS) for setting, silo in every])
    rate.set_ylim(len(every) - 0.5, -0.5)
    for panel in (rate, friction, height):
        panel.locator_params(axis="x", nbins=6)
    headline(figure, _message(numbers))
    handles = {text: line for panel in (rate, friction) for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    about = "Points: mean of the fillings and its interval, 95 %, of heights wider by half a level. Means in flow until a "
    about += (
        "tenth of the grains is out. Heights are above the transition: below them less than 0.8 of the largest friction acts."
    )
    foot(figure, f"{cube.attrs['title']}.", about, handles=handles.values())
    save(figure, _with_units(numbers), stem)


def _with_units(numbers: pd.DataFrame) -> pd.DataFrame:
    """The numbers with the unit of their panel in the names of their columns."""
    parts = [
        part.rename(columns={name: f"{name}{UNITS[panel]}" for name in ENDS})
        for panel, part in numbers.groupby("panel", sort=False)
    ]
    return pd.concat(parts, ignore_index=True)


def _lines(silo: xr.Dataset, setting: dict[str, Any], place: int) -> list[dict[str, Any]]:
    """Rows of the numbers of a setting."""
    about = {**setting, "place": place}
    lines = [row(silo["filling_mass_flow"], **about, panel=RATE, what="grains")]
    law = {end: float(silo[f"{name}_law_mass_flow"].mean()) for end, name in (("low_95", "least"), ("high_95", "largest"))}
    lines.append({**about, "panel": RATE, "what": "beverloo", **law})
    for name, (wall, aside, _) in WALLS.items():
        if name in silo:
            lines += [row(silo[name].sel(phase=phase), **about | {"place": place + aside}, panel=FRICTION,
                          what=f"{wall}, {PHASES[phase][0]}") for phase in PHASES]  # fmt: skip
    return [*lines, height_not_sliding(silo, about) | {"panel": HEIGHT, "what": "grains"}]


def _points(panel: Axes, table: pd.DataFrame, **look: Any) -> None:
    """Points with their intervals."""
    ends = np.abs(table[["low_95", "high_95"]].to_numpy().T - table["mean"].to_numpy())
    panel.errorbar(table["mean"], table["place"], xerr=ends, **BARS | look)


def _rates(panel: Axes, numbers: pd.DataFrame) -> None:
    law = numbers[(numbers["panel"] == RATE) & (numbers["what"] == "beverloo")]
    panel.hlines(law["place"], law["low_95"], law["high_95"], color=REST["color"], linewidth=14, zorder=1,
                 label="Beverloo's law: C 0.55 to 0.65, edge 2 to 1 grain")  # fmt: skip
    grains = numbers[(numbers["panel"] == RATE) & (numbers["what"] == "grains")]
    _points(panel, grains, color=VERMILION, marker="D", label="grains")
    panel.set(xlabel=RATE, title="rate", xlim=(0.0, None))


def _frictions(panel: Axes, numbers: pd.DataFrame) -> None:
    for wall, _, mark in WALLS.values():
        for when, colours in PHASES.values():
            table = numbers[numbers["what"] == f"{wall}, {when}"].dropna(subset=["mean"])
            if len(table):
                _points(panel, table, **mark | colours, label=f"{wall}, {when}")
    panel.set(xlabel=FRICTION, title="friction that acts", xlim=(min(0.0, numbers["low_95"].min()), None))


def _message(numbers: pd.DataFrame) -> str:
    """Range of the rate over the most that the law gives, and how many settings are within."""
    rate = numbers[numbers["panel"] == RATE].pivot(index="place", columns="what")
    over = (rate[("mean", "grains")] / rate[("high_95", "beverloo")]).dropna()
    if not len(over):
        return "No silo has a rate beside a law"
    faster = over[over > 1.0]
    within = int((over <= 1.0).sum())
    said = f"Grains flow at {span(over.min(), over.max())} times the most that Beverloo's law gives of a flat floor"
    return f"{said}: {within} of {len(over)} silos within it" if len(faster) else said
