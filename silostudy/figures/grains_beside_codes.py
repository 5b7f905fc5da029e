"""Wall pressure over depth: what the grains did, at rest and in flow, and what theories and codes say of the same silo.

In colour stand the methods that cover what the grains do in flow all around, or may, by the verdict of the table of findings;
the third panel of a row names and ranks all.
"""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import (
    COVERS,
    MAY_COVER,
    NO_INTERVAL,
    SHORT,
    interval,
    methods_of,
    profile,
    settings,
    told,
    verdict,
)
from silostudy.figures.steps import over_depth
from silostudy.figures.style import BLACK, WIDTH, foot, headline, look, plt, save, title

MOST = 2  # rows of panels: of more settings the first and the last are shown that are deep enough for ratios
KPA = 1e3
PANELS = {"filling": "at rest", "discharge": "in flow"}
LINES: dict[str, tuple[str, str, dict[str, Any]]] = {  # area, or mean of all windows -> phase, name, look
    "": ("filling discharge", "grains, mean around the wall", {"linewidth": 2.2, "marker": "o", "markersize": 4}),
    "ring": ("discharge", "grains, largest mean around in a window", {"linewidth": 1.6, "linestyle": (0, (4, 2))}),
    "1x1": ("filling discharge", "grains, largest on one cell in a window", {"linewidth": 1.6, "linestyle": (0, (1, 1))}),
}
VERDICTS: dict[str, dict[str, Any]] = {  # verdict on the largest mean around -> look in place of the method's own
    COVERS: {"linestyle": "-"},
    MAY_COVER: {"linestyle": (0, (5, 2))},
    NO_INTERVAL: {"linestyle": (0, (1, 1))},
    SHORT: {"color": "0.65", "linestyle": "-", "zorder": 1},
}
UNRANKED = VERDICTS[SHORT] | {"markerfacecolor": "white"}  # look of a method that says nothing of flow
FEW = "no level is half a\ndiameter deep: no ratios"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row of panels a setting, at rest, in flow, and the methods ranked."""
    shown = _shown(list(settings(cube)))
    size = (WIDTH, 1.7 + 3.6 * len(shown))
    figure, panels = plt.subplots(len(shown), 3, figsize=size, squeeze=False, width_ratios=(1, 1.2, 0.8))
    numbers, ranked = [], []
    for (rest, flow, rank), (setting, silo) in zip(panels, shown, strict=True):
        ranks = _ranks(silo)
        for panel, (phase, words) in zip((rest, flow), PANELS.items(), strict=True):
            numbers += [table.assign(**setting, phase=phase) for table in _panel(panel, silo, phase, ranks)]
            panel.set(title=f"{told(setting, silo)}\n{words}", xlabel="pressure on the wall (kPa)", xlim=(0.0, None))
        flow.sharey(rest)
        flow.tick_params(labelleft=False)
        rest.set(ylabel="depth below the level surface (m)", ylim=(float(silo["code_profile_depth"].max()), 0.0))
        _draw_ranks(rank, silo, ranks)
        ranked.append(ranks.assign(**setting, phase="discharge"))
    headline(figure, _message(ranked))
    handles = {
        text: line for panel in panels[:, :2].flat for line, text in zip(*panel.get_legend_handles_labels(), strict=True)
    }
    about = (
        "Methods, named by their marks on the right: solid where they cover the grains' largest mean around, half a diameter "
    )
    about += (
        "deep and deeper, by its interval; dashed where they may; grey where they do not; dotted where fillings are too few to "
    )
    about += "tell. Right: filled over that mean, hollow, with patch loads, over the grains' largest on one cell."
    fillings = (
        f"Bands: least and largest of {cube.sizes['filling']} fillings; bars: interval of their mean, 95 %. Mean in flow: "
    )
    fillings += "until a tenth of the grains is out."
    foot(figure, f"{cube.attrs['title']}.", about, fillings, handles=handles.values())
    save(figure, pd.concat([*numbers, *ranked], ignore_index=True), stem)


def _shown(every: list[tuple[dict, xr.Dataset]]) -> list[tuple[dict, xr.Dataset]]:
    """The settings that are shown."""
    deep = [(setting, silo) for setting, silo in every if silo["code_over_grains_peak"].notnull().any()]
    chosen = every if len(every) <= MOST else (deep or every)
    return chosen if len(chosen) <= MOST else [chosen[0], chosen[-1]]


def _ranks(silo: xr.Dataset) -> pd.DataFrame:
    """Methods of the discharge, least first: least pressure over the grains' largest on a ring and on one cell."""
    rows = []
    for method in methods_of(silo, "discharge"):
        ratios = silo["code_over_grains_peak"].sel(pressure_method=method, phase="discharge")
        ring, *ends = interval(ratios.sel(averaging="ring").values)
        cell, *cell_ends = interval(ratios.sel(averaging="1x1").values)
        rows.append((method, ring, *ends, verdict(*ends), cell, verdict(*cell_ends)))
    names = ["of", "over_ring_peak", "low_95", "high_95", "verdict", "over_cell_peak", "verdict_on_cell"]
    return pd.DataFrame(rows, columns=names).sort_values("over_ring_peak", ignore_index=True)


def _look(silo: xr.Dataset, method: str, ranks: pd.DataFrame) -> dict[str, Any]:
    """Look of a method: its own marker, and colour and line by the verdict on it; a name where it has no rank."""
    told_of = dict(zip(ranks["of"], ranks["verdict"], strict=True))
    own = look(silo, method) | {"linewidth": 1.3}
    if method in told_of:
        return own | VERDICTS[told_of[method]]
    return own | UNRANKED | {"label": f"{title(silo, method)}, at rest alone"}


def _panel(panel: Axes, silo: xr.Dataset, phase: str, ranks: pd.DataFrame) -> list[pd.DataFrame]:
    """Draws a phase of a setting; the tables that it shows."""
    tables = []
    for method in methods_of(silo, phase):
        said = silo["code_wall_profile"].sel(pressure_method=method, phase=phase).values
        table = pd.DataFrame({"of": method, "depth_m": silo["code_profile_depth"].values, "pressure_Pa": said}).dropna()
        style = _look(silo, method, ranks) | {"markersize": 5, "markevery": 20}
        over_depth(panel, table["pressure_Pa"].to_numpy() / KPA, table["depth_m"].to_numpy(), **style)
        tables.append(table)
    for area, (phases, name, style) in LINES.items():
        if phase in phases.split():
            felt = silo["largest_area_pressure"].sel(averaging=area) if area else silo["ring_pressure"]
            table = profile(felt.sel(phase=phase), silo["level_depth"], of=name)
            across, depth = table["pressure_Pa"] / KPA, table["depth_m"]
            panel.plot(across, depth, color=BLACK, label=name, **style)
            if not area:
                panel.fill_betweenx(
                    depth, table["least_Pa"] / KPA, table["largest_Pa"] / KPA, color="0.3", alpha=0.2, linewidth=0
                )
            tables.append(table)
    return tables


def _draw_ranks(panel: Axes, silo: xr.Dataset, ranks: pd.DataFrame) -> None:
    """A row a method: over the grains' largest mean around (filled), and over their largest on one cell (hollow)."""
    panel.set(title="over the grains' largest,\nin flow", xlabel="least pressure over theirs")
    panel.set_yticks(range(len(ranks)), [title(silo, method) for method in ranks["of"]])
    panel.set_ylim(-0.7, len(ranks) - 0.3)
    panel.yaxis.tick_right()
    panel.spines["left"].set_visible(False)
    if ranks["over_ring_peak"].isna().all():
        panel.set(title=FEW, xlabel="", xticks=[])
        for place, method in enumerate(ranks["of"]):
            panel.plot(0.9, place, **look(silo, method), markersize=6, transform=panel.get_yaxis_transform())
        return
    for place, row in ranks.iterrows():
        style = _look(silo, row["of"], ranks) | {"markersize": 6, "linestyle": "none"}
        panel.hlines(place, row["low_95"], row["high_95"], color="0.7", linewidth=2.5, zorder=1)
        panel.plot(row["over_ring_peak"], place, **style)
        panel.plot(row["over_cell_peak"], place, **style, markerfacecolor="white")
    panel.axvline(1.0, color=BLACK, linewidth=1.0)
    panel.set_xlim(0.0, 1.05 * float(np.nanmax([1.0, *ranks.select_dtypes("number").to_numpy().ravel()])))


def _message(ranked: list[pd.DataFrame]) -> str:
    """Message: how many methods cover the grains, as a range over the settings that are shown."""
    known = [ranks for ranks in ranked if ranks["over_ring_peak"].notna().any()]
    if not known:
        return "No silo is deep enough for ratios of codes to grains"
    methods = _range([len(ranks) for ranks in known])
    (covers, and_may), (on_cell, may_on_cell) = (
        _verdicts([ranks[of] for ranks in known]) for of in ("verdict", "verdict_on_cell")
    )
    around = f"In flow {covers} of {methods} methods cover the grains' largest mean around the wall{and_may}"
    return f"{around}, {on_cell} that on one cell{may_on_cell}"


def _verdicts(told_of: list[pd.Series]) -> tuple[str, str]:
    """Number of methods that cover something, and in brackets of those that may and of those of which nobody can tell."""
    counts = {word: [int((verdicts == word).sum()) for verdicts in told_of] for word in VERDICTS}
    words = {MAY_COVER: "{} more may", NO_INTERVAL: "of {} fillings are too few to tell"}
    said = [words[word].format(_range(counts[word])) for word in words if any(counts[word])]
    return _range(counts[COVERS]), f" ({', '.join(said)})" if said else ""


def _range(counts: list[int]) -> str:
    low, high = min(counts), max(counts)
    return f"{low}" if low == high else f"{low} to {high}"
