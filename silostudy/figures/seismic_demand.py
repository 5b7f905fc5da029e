"""Demand of the earthquake on the wall over depth: shear, moment, axial wall force, and EN 1998-4's additional pressure."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.beside import span
from silostudy.figures.shaken import LINES, answer, cases, head, name
from silostudy.figures.style import BLUE, GREEN, TALLEST, VERMILION, WIDTH, save
from silostudy.tables.mass_choices import MASS_CHOICES

PANELS = {
    "wall_shear_force": ("shear force in the wall (kN)", 1e-3),
    "wall_bending_moment": ("bending moment in the wall (kN m)", 1e-3),
    "seismic_axial_wall_force": ("axial wall force from it (kN/m)", 1e-3),
    "wall_acceleration": ("largest wall acceleration (m/s²)", 1.0),
    "seismic_wall_pressure": ("added pressure, EN 1998-4 (kPa)", 1e-3),
}
CASES = ((BLUE, "o"), (VERMILION, "s"), (GREEN, "^"))


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: five quantities over depth, and the moment at the base by the share that counts."""
    figure, grid = plt.subplots(2, 3, figsize=(WIDTH, TALLEST))
    panels, base, tables = grid.flat[: len(PANELS)], grid[1, 2], []
    columns = cases(cube)
    for look, case in zip(CASES, columns, strict=False):
        _draw_case(panels, case, look)
        tables += [_numbers(case), _draw_base(base, case, look)]
    for panel, (text, _) in zip(panels, PANELS.values(), strict=True):
        panel.set(xlabel=text, xlim=(0, None), ylim=(float(cube["depth"].max()), 0))
    for panel in grid[:, 0]:
        panel.set_ylabel("depth below the top (m)")
    for panel in (*grid[0, 1:], grid[1, 1]):
        panel.sharey(grid[0, 0])
        panel.tick_params(labelleft=False)
    base.set(ylabel="moment at the base (kN m)", xlabel="C_eff that counts", ylim=(0, None))
    about = (
        "True peaks over time (between samples too) below the top of the contents; pressure in the direction of motion, at the "
    )
    about += "wall's own peaks."
    handles = panels[0].get_legend_handles_labels()[0]
    head(figure, cube, _message(columns), about, handles=handles)
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _draw_case(panels, case: xr.Dataset, look: tuple[str, str]) -> None:
    """Every quantity over depth, a line a share of the contents."""
    for dash, choice in zip(LINES, map(str, case["mass_choice"].values), strict=False):
        here = case.sel(mass_choice=choice)
        label = f"{name(case)}: {MASS_CHOICES[choice][1]}, C_eff = {_share(case, choice)}"
        style: dict = {
            "color": look[0],
            "marker": look[1],
            "markevery": 6,
            "markersize": 4,
            "linestyle": dash,
            "linewidth": 1.3,
        }
        for panel, (variable, (_, factor)) in zip(panels, PANELS.items(), strict=True):
            panel.plot(here[variable] * factor, case["depth"], label=label, **style)


def _share(case: xr.Dataset, choice: str) -> str:
    """The share of the contents that counts, in words."""
    if choice == "identified":
        return answer(case, "amplitude_error")
    return f"{float(case['mass_choice_coefficient'].sel(mass_choice=choice)):.3g}"


def _draw_base(panel, case: xr.Dataset, look: tuple[str, str]) -> pd.DataFrame:
    """Moment at the base over the share that counts; as a table with the shear there (SI)."""
    numbers = {"C_eff": "mass_choice_coefficient", "base_moment": "base_moment", "base_shear": "base_shear"}
    table = pd.DataFrame({column: case[variable].values for column, variable in numbers.items()}).sort_values("C_eff")
    panel.plot(table["C_eff"], table["base_moment"] / 1e3, color=look[0], marker=look[1], linewidth=1.3)
    return table.assign(case=str(case["case"].values))


def _message(columns: list[xr.Dataset]) -> str:
    """Message: what all of the contents would ask of the base more than the least share does."""
    ratios, least = [], []
    for case in columns:
        moments, shares = case["base_moment"].values, case["mass_choice_coefficient"].values
        ratios.append(moments[shares.argmax()] / moments[shares.argmin()])
        least.append(shares.min())
    counted = f"all of the contents {span(min(ratios), max(ratios), 3)} times that of a share of {span(min(least), max(least))}"
    moment = max(float(case["base_moment"].max()) for case in columns)
    return f"The base takes a moment of at most {moment / 1e3:.3g} kN m: {counted}"


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    table = case[list(PANELS)].to_dataframe().reset_index()
    return table[["mass_choice", "relative_depth", "depth", *PANELS]].assign(case=str(case["case"].values))
