"""Wall pressure around silos of spheres, at rest and in flow, beside the zones of an eccentric flow channel by the codes."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import interval, settings, span, told
from silostudy.figures.findings_of_channel import near_over_far
from silostudy.figures.style import BLUE, LINES, TALLEST, VERMILION, WIDTH, foot, headline, look, plt, save, title

KPA = 1e3
PANELS = {"filling": ("at rest", BLUE, "o-"), "discharge": ("in flow", VERMILION, "s-")}
BESIDE = 3  # settings from which on two panels stand beside each other
PHASE = "discharge"  # in which a channel flows


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel a setting that has deep levels, angles across, their pressure up."""
    every = [(setting, case) for setting, case in settings(cube) if case["pressure_around"].notnull().any()]
    columns = 1 if len(every) < BESIDE else 2
    rows = -(-len(every) // columns)
    size = (WIDTH, min(TALLEST, 1.6 + 3.2 * rows))
    figure, panels = plt.subplots(rows, columns, figsize=size, squeeze=False)
    numbers, across = [], "angle from the outlet's side (°)" if _off_axis(cube) else "angle around the wall (°)"
    for panel, (setting, case) in zip(panels.flat, every, strict=False):
        numbers += [table.assign(**setting) for table in (*_grains(panel, case), *_codes(panel, case))]
        off = 100.0 * float(case["deviation_around"].sel(phase=PHASE).mean())
        panel.set(title=f"{told(setting, case)}: {off:.0f} % off the mean in flow", ylim=(0.0, None))
        panel.set(xlim=(-180, 180), xticks=range(-180, 181, 90), xlabel=across, ylabel="wall pressure (kPa)")
    for panel in panels.flat[len(every) :]:
        panel.set_axis_off()
    handles = {text: line for panel in panels.flat for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    headline(figure, _message(cube))
    about = "Levels half a diameter deep and deeper, in flow until a tenth of the grains is out. Band: 95 % interval of the "
    about += "mean of fillings; percentages: root mean square of single cells."
    foot(figure, f"{cube.attrs['title']}.", about, *_patches(cube), handles=handles.values())
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _off_axis(cube: xr.Dataset) -> bool:
    """Whether codes know an outlet off the axis: a channel of theirs flows at one side."""
    return "code_channel_pressure" in cube and bool(cube["code_channel_pressure"].notnull().any())


def _message(cube: xr.Dataset) -> str:
    """Sentence on how much less the outlet's side feels, or on how far single cells are from the mean around."""
    if _off_axis(cube):
        sides = [(near_over_far(silo).sel(phase=PHASE).mean().item(), told(setting, silo)) for setting, silo in settings(cube)]
        least, where = min(side for side in sides if np.isfinite(side[0]))
        return f"In flow the wall on the outlet's side is pressed {least:.2f} times as much as opposite: {where}"
    rest, flow = (_more(cube, phase) for phase in PANELS)
    return f"The largest cell presses {rest} % more than the mean around its level at rest, {flow} % more in flow"


def _more(cube: xr.Dataset, phase: str) -> str:
    """Range over the settings of what the largest cell presses more than its level's mean (%), as means of fillings."""
    means = [100.0 * silo["largest_over_ring"].sel(phase=phase).mean().item() for _, silo in settings(cube)]
    known = [round(mean) for mean in means if np.isfinite(mean)]
    return span(min(known), max(known), digits=3) if known else "no known"


def _patches(cube: xr.Dataset) -> list[str]:
    """A line on what codes add on a patch in discharge."""
    if "code_patch_factor" not in cube:
        return []
    factor = cube["code_patch_factor"].sel(phase=PHASE)
    most = factor.max([dim for dim in factor.dims if dim != "pressure_method"]).dropna("pressure_method")
    names = [
        f"{title(cube, method)}, {100.0 * float(most.sel(pressure_method=method)):.0f} %"
        for method in most["pressure_method"].values
    ]
    return [f"Patch loads add at most, on a patch: {'; '.join(names)}."] if names and most.max() > 0.0 else []


def _grains(panel: Axes, case: xr.Dataset) -> list[pd.DataFrame]:
    """Draws the mean of the fillings with its interval at every angle; the tables shown."""
    turn = np.degrees((case["wall_turn"].values + np.pi) % (2.0 * np.pi) - np.pi)
    order, tables = np.argsort(turn), []
    for phase, (name, colour, form) in PANELS.items():
        felt = case["pressure_around"].sel(phase=phase).transpose("wall_turn", "filling").values[order] / KPA
        table = pd.DataFrame([interval(values) for values in felt], columns=["pressure_kPa", "low_95_kPa", "high_95_kPa"])
        table = table.assign(of=f"grains, {name}", angle_deg=turn[order])
        panel.fill_between(table["angle_deg"], table["low_95_kPa"], table["high_95_kPa"], color=colour, alpha=0.15, linewidth=0)
        panel.plot(table["angle_deg"], table["pressure_kPa"], form, color=colour, markersize=4, label=f"grains, {name}")
        tables.append(table)
    return tables


def _codes(panel: Axes, case: xr.Dataset) -> list[pd.DataFrame]:
    """Draws the zones of every method that knows an eccentric channel, by its size; the tables shown."""
    if "code_channel_pressure" not in case:
        return []
    tables, half = [], case["code_channel_half_width"].sel(phase=PHASE)
    for method in map(str, case["pressure_method"].values[half.notnull().any("channel").values]):
        for size, dashes in zip(case["channel"].values, LINES, strict=False):
            name = f"{title(case, method)}, k_c = {size:.2f}"
            table = _zones(case.sel(pressure_method=method, channel=size, phase=PHASE))
            panel.plot(
                table["angle_deg"], table["pressure_kPa"], color=look(case, method)["color"], linestyle=dashes, label=name
            )
            tables.append(table.assign(of=name))
    return tables


def _zones(case: xr.Dataset) -> pd.DataFrame:
    """Pressure around the wall in steps: the channel up to its edge, what is beside it up to twice that angle, then static."""
    edge = np.degrees(float(case["code_channel_half_width"]))
    channel, adjacent, static = (float(case[f"code_{zone}_pressure"]) / KPA for zone in ("channel", "adjacent", "static"))
    half = pd.DataFrame({
        "angle_deg": [0.0, edge, edge, 2.0 * edge, 2.0 * edge, 180.0],
        "pressure_kPa": [channel, channel, adjacent, adjacent, static, static],
    })  # fmt: skip
    return pd.concat([half[::-1].assign(angle_deg=lambda table: -table["angle_deg"]), half], ignore_index=True)
