"""Pressure on the hopper at rest, on average in flow and at its largest, beside the codes: the switch at the transition."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.beside import settings, told
from silostudy.figures.grains_beside_codes import INK, KPA
from silostudy.figures.style import look, plt, save, title

LOOKS = {"at rest": ("o:", 1.5), "mean in flow": ("s--", 1.5), "largest window in flow": ("^-", 2.0)}
DASHES = {"filling": ":", "discharge": "-"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel a setting, the hopper from its outlet to the transition."""
    every = list(settings(cube))
    figure, panels = plt.subplots(1, len(every), figsize=(2.6 + 4.0 * len(every), 5.4), squeeze=False, sharey=True)
    numbers = []
    for panel, (setting, one) in zip(panels.flat, every, strict=True):
        numbers += [table.assign(**setting) for table in (*_codes(panel, one), *_grains(panel, one))]
        factor = one["hopper_switch_factor"].mean("filling")
        told_factor = f"largest over rest: {float(factor.max()):.2g}" if factor.notnull().any() else "nothing felt"
        panel.set(title=f"{told(setting)}\n{told_factor}", xlabel="pressure on the hopper (kPa)", xlim=(0.0, None))
    panels[0, 0].set(ylabel="height above the outlet over that of the transition")
    handles = {text: line for panel in panels.flat for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    figure.legend(handles.values(), handles.keys(), loc="outside right center", fontsize=8)
    figure.suptitle(cube.attrs["title"])
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _grains(panel, one: xr.Dataset) -> list[pd.DataFrame]:
    place = 1.0 - one["hopper_level_position"].mean("filling")
    felt = {
        "at rest": one["hopper_ring_pressure"].sel(phase="filling"),
        "mean in flow": one["hopper_ring_pressure"].sel(phase="discharge"),
        "largest window in flow": one["hopper_ring_largest"],
    }
    tables = []
    for name, pressure in felt.items():
        form, width = LOOKS[name]
        mean, low, high = (getattr(pressure, what)("filling") for what in ("mean", "min", "max"))
        panel.plot(mean / KPA, place, form, color=INK, linewidth=width, markersize=4, label=f"grains, {name}")
        panel.fill_betweenx(place, low / KPA, high / KPA, color=INK, alpha=0.12, linewidth=0)
        tables.append(pd.DataFrame({"of": f"grains, {name}", "place": place, "pressure_Pa": mean, "least_Pa": low,
                                    "largest_Pa": high}))  # fmt: skip
    return tables


def _codes(panel, one: xr.Dataset) -> list[pd.DataFrame]:
    if "code_hopper_pressure" not in one:
        return []
    place, tables = 1.0 - one["hopper_level_position"].mean("filling"), []
    for method in map(str, one["pressure_method"].values):
        for phase, dashes in DASHES.items():
            said = one["code_hopper_pressure"].sel(pressure_method=method, phase=phase)
            if said.notnull().any():
                panel.plot(said / KPA, place, color=look(one, method)["color"], linestyle=dashes, linewidth=1.1,
                           label=f"{title(one, method)}, {phase}")  # fmt: skip
                tables.append(pd.DataFrame({"of": method, "phase": phase, "place": place, "pressure_Pa": said}))
    return tables
