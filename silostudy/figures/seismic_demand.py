"""What the earthquake asks of the wall over depth: shear, moment, axial wall force, and EN 1998-4's additional pressure."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import LINES, answer, cases, head, name
from silostudy.figures.style import save
from silostudy.tables.mass_choices import MASS_CHOICES

PANELS = {
    "wall_shear_force": ("shear force in the wall (kN)", 1e-3),
    "wall_bending_moment": ("bending moment in the wall (kN m)", 1e-3),
    "seismic_axial_wall_force": ("axial wall force from it (kN/m)", 1e-3),
    "wall_acceleration": ("largest acceleration of the wall (m/s²)", 1.0),
    "seismic_wall_pressure": ("additional wall pressure, EN 1998-4 (kPa)", 1e-3),
}
CASES = (("#0072b2", "o"), ("#d55e00", "s"), ("#009e73", "^"))


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, grid = plt.subplots(2, 3, figsize=(12, 9.5), sharey=True)
    panels, tables = grid.flat[: len(PANELS)], []
    for (colour, marker), one in zip(CASES, cases(cube), strict=False):
        for dash, choice in zip(LINES, map(str, one["mass_choice"].values), strict=False):
            here = one.sel(mass_choice=choice)
            share = float(here["mass_choice_coefficient"])
            told = answer(one, "amplitude_error") if choice == "identified" else f"{share:.3g}"
            label = f"{name(one)}: {MASS_CHOICES[choice][1]}, C_eff = {told},\n"
            label += f"base {float(here['base_shear']) / 1e3:.4g} kN, {float(here['base_moment']) / 1e3:.5g} kN m"
            for panel, (variable, (_, factor)) in zip(panels, PANELS.items(), strict=True):
                panel.plot(here[variable] * factor, one["depth"], color=colour, marker=marker, markevery=6, markersize=4,
                           linestyle=dash, linewidth=1.2, label=label if panel is grid[0, 0] else None)  # fmt: skip
        tables.append(_numbers(one))
    for panel, (text, _) in zip(panels, PANELS.values(), strict=True):
        panel.set(xlabel=text, xlim=(0, None), ylim=(float(cube["depth"].max()), 0))
    for panel in grid[:, 0]:
        panel.set_ylabel("depth below the top of the contents (m)")
    grid[1, 2].axis("off")
    grid[1, 2].legend(*grid[0, 0].get_legend_handles_labels(), loc="center left", fontsize=8, labelspacing=1.2, handlelength=4)
    head(
        figure, cube, "true peaks over time (between samples too); pressure in the direction of motion, at the wall's own peaks"
    )
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    table = one[list(PANELS)].to_dataframe().reset_index()
    return table[["mass_choice", "relative_depth", "depth", *PANELS]].assign(case=str(one["case"].values))
