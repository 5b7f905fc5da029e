"""Pressure on the hopper at rest, on average in flow and at its largest, beside the codes: the switch at the transition."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import columns_of, hopper_rise, settings, span, told
from silostudy.figures.grains_beside_codes import KPA
from silostudy.figures.steps import over_depth
from silostudy.figures.style import BLACK, PHASE_LINES, WIDTH, foot, headline, look, plt, save, title

LOOKS: dict[str, dict[str, Any]] = {
    "at rest": {"linewidth": 1.6, "linestyle": (0, (1, 1)), "marker": "o", "markerfacecolor": "white"},
    "mean in flow": {"linewidth": 1.2, "linestyle": (0, (4, 2)), "marker": "none"},
    "largest window in flow": {"linewidth": 2.4, "linestyle": "-", "marker": "o"},
}
BANDS: dict[str, dict[str, Any]] = {
    "at rest": {"hatch": "....", "facecolor": "none", "edgecolor": "0.5", "zorder": 1.0},
    "mean in flow": {"hatch": "////", "facecolor": "none", "edgecolor": "0.5", "zorder": 1.0},
    "largest window in flow": {"facecolor": "0.88", "edgecolor": "none", "zorder": 0.5},  # behind the other two
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel a setting, the hopper from its outlet to the transition."""
    every = list(settings(cube))
    columns = columns_of(len(every))
    rows = -(-len(every) // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(WIDTH, 2.0 + 3.4 * rows), squeeze=False, sharey=True)
    numbers = []
    for panel, (setting, silo) in zip(panels.flat, every, strict=False):
        numbers += [table.assign(**setting) for table in (*_codes(panel, silo), *_grains(panel, silo))]
        most = hopper_rise(silo)[0]
        rise = f"largest over rest: {float(most.mean()):.1f}" if most.notnull().any() else "nothing felt"
        panel.set(
            title=f"{told(setting, silo)}\n{rise}", xlabel="pressure on the hopper (kPa)", xlim=(0.0, None), ylim=(0.0, 1.0)
        )
    for panel in panels.flat[len(every) :]:
        panel.set_visible(False)
    for panel in panels[:, 0]:
        panel.set_ylabel("height above the outlet\nover that of the transition")
    headline(figure, _message(cube))
    handles = {text: line for panel in panels.flat for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    about = "Grains: means around the hopper, in flow until a tenth is out; bands: least to largest of fillings. Largest "
    about += "over rest: mean of the fillings'."
    foot(figure, f"{cube.attrs['title']}.", about, handles=handles.values())
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _message(cube: xr.Dataset) -> str:
    """Message: how far the pressure around the hopper rises over rest at most, and how high above the outlet."""
    felt = [(most.mean().item(), height.mean().item()) for most, height in (hopper_rise(silo) for _, silo in settings(cube))]
    largest = [most for most, _ in felt if np.isfinite(most)]
    if not largest:
        return "The grains were not felt on the hopper"
    height = max((most, height) for most, height in felt if np.isfinite(most))[1]
    low, high = min(largest), max(largest)
    where = f"the largest at {height:.2f} of the transition's height"
    return f"In flow the pressure around the hopper rises to {span(low, high)} times that at rest, {where}"


def _grains(panel: Axes, silo: xr.Dataset) -> list[pd.DataFrame]:
    """Draws what the grains did; the tables that it shows."""
    height = 1.0 - silo["hopper_level_position"].mean("filling")
    felt = {
        "at rest": silo["hopper_ring_pressure"].sel(phase="filling"),
        "mean in flow": silo["hopper_ring_pressure"].sel(phase="discharge"),
        "largest window in flow": silo["hopper_ring_largest"],
    }
    tables = []
    for name, pressure in felt.items():
        mean, low, high = (getattr(pressure, what)("filling") for what in ("mean", "min", "max"))
        panel.plot(mean / KPA, height, color=BLACK, markersize=4, label=f"grains, {name}", **LOOKS[name])
        panel.fill_betweenx(height, low / KPA, high / KPA, label=f"fillings, {name}", linewidth=0, **BANDS[name])
        tables.append(pd.DataFrame({
            "of": f"grains, {name}", "height_over_transition": height, "pressure_Pa": mean, "least_Pa": low, "largest_Pa": high,
        }))  # fmt: skip
    return tables


def _codes(panel: Axes, silo: xr.Dataset) -> list[pd.DataFrame]:
    """Draws what theories and codes say, hollow and dashed after filling; the tables that it shows."""
    if "code_hopper_profile" not in silo:
        return []
    height, tables = 1.0 - silo["hopper_position"].values, []
    for method in map(str, silo["pressure_method"].values):
        for phase in map(str, silo["phase"].values):
            said = silo["code_hopper_profile"].sel(pressure_method=method, phase=phase).values
            known = np.isfinite(said)
            if known.any():
                style = look(silo, method) | {
                    "linestyle": PHASE_LINES[phase],
                    "linewidth": 1.2,
                    "markersize": 5,
                    "markevery": 12,
                }
                style |= {"markerfacecolor": "white"} if phase == "filling" else {}
                over_depth(panel, said[known] / KPA, height[known], label=f"{title(silo, method)}, {phase}", **style)
                tables.append(
                    pd.DataFrame(
                        {"of": method, "phase": phase, "height_over_transition": height[known], "pressure_Pa": said[known]}
                    )
                )
    return tables
