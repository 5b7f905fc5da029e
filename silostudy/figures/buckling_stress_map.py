"""A designer's map: buckling stress over R/t and bay length by every rule, one yield stress and making."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.rules import demand, making, name
from silostudy.figures.style import AID, WIDTH, foot, headline, point_out, save

DOT = {"radius_over_thickness": 500.0, "relative_bay_length": 10.0}  # the wall that the headline speaks of
LEVELS = [5, 10, 20, 30, 50, 75, 100, 150, 200, 250]
MAKING = 1  # the middle one: fabricated, class B


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the map and its numbers for shells without rings."""
    demand(cube, "ring_area_ratio", (0.0,))
    cube = cube.sel(ring_area_ratio=0.0).isel(steel=0, making=min(MAKING, cube.sizes["making"] - 1))
    rules = list(map(str, cube["rule"].values))
    figure, axes = plt.subplots(1, len(rules), figsize=(WIDTH, 5.6), sharey=True, squeeze=False)
    for panel, rule in zip(axes.flat, rules, strict=True):
        stress = cube["buckling_stress"].sel({"rule": rule}).transpose("relative_bay_length", "radius_over_thickness") / 1e6
        x, y = stress["radius_over_thickness"], stress["relative_bay_length"]
        filled = panel.contourf(x, y, stress, levels=LEVELS, cmap="viridis", extend="both", alpha=0.8)
        lines = panel.contour(x, y, stress, levels=LEVELS, colors="black", linewidths=0.7)
        panel.clabel(lines, levels=[20, 50, 100, 200], fontsize="small", fmt="%g")
        panel.set(xscale="log", yscale="log", xlabel="R/t", title=fill(name(cube, rule), 14, break_on_hyphens=False))
        panel.set_xticks([100, 300, 1000, 3000], labels=["100", "300", "1000", "3000"])
        _point_out(panel, stress)
        panel.set_yticks([0.5, 1, 2, 5, 10, 20, 50, 100], labels=["0.5", "1", "2", "5", "10", "20", "50", "100"])
        panel.minorticks_off()
    axes[0, 0].set_ylabel("L / sqrt(R t)")
    figure.colorbar(filled, ax=axes, label="buckling stress (MPa)", location="bottom", shrink=0.6, aspect=40)
    headline(figure, _message(cube))
    steel = float(cube["steel"]) / 1e6
    told = f"no rings or pressure, yield stress {steel:g} MPa, {making(cube)}; white: outside the rule's scope"
    foot(figure, f"Buckling stress, {told}; the dot: the wall of the headline")
    numbers = cube["buckling_stress"].to_dataframe().reset_index()
    save(figure, numbers[["rule", "radius_over_thickness", "relative_bay_length", "buckling_stress"]], stem)


def _point_out(panel: Axes, stress: xr.DataArray) -> None:
    """A dot on the wall that the headline speaks of, with its stress."""
    here = stress.sel(DOT, method="nearest")
    point = float(here.radius_over_thickness), float(here.relative_bay_length)
    panel.plot(*point, "o", color="white", markeredgecolor="black", gid=AID)
    point_out(panel, f"{float(here):.0f} MPa" if here.notnull() else "no value", point, (4, 12), arrowprops=None)


def _message(cube: xr.Dataset) -> str:
    """Message of the map, in numbers: the least and the largest stress that rules give a wall that is not perfect."""
    wall = cube.sel(DOT, method="nearest")
    here = wall["buckling_stress"].where(wall["elastic_knockdown_factor"] < 1.0).dropna("rule")
    here = here.sortby(here)
    size = f"R/t {float(here.radius_over_thickness):.0f}, L = {float(here.relative_bay_length):.0f} sqrt(R t)"
    ends = (f"{float(end) / 1e6:.0f} MPa by {name(cube, str(end.rule.values))}" for end in (here[0], here[-1]))
    return f"A wall of {size} buckles at {' to '.join(ends)}"
