"""A designer's map: buckling stress over R/t and bay length by every rule, one yield stress and making."""

from pathlib import Path

import matplotlib.pyplot as plt
import xarray as xr

from silostudy.figures.rules import demand, making, name
from silostudy.figures.style import save

LEVELS = [5, 10, 20, 30, 50, 75, 100, 150, 200, 250]
MAKING = 1  # the middle one: fabricated, class B


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the map and its numbers for shells without rings."""
    demand(cube, "ring_area_ratio", (0.0,))
    cube = cube.sel(ring_area_ratio=0.0).isel(steel=0, making=min(MAKING, cube.sizes["making"] - 1))
    rules = list(map(str, cube["rule"].values))
    columns = min(3, len(rules))
    rows = -(-len(rules) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4.4 * columns, 4.0 * rows), sharex=True, sharey=True, squeeze=False)
    for panel, rule in zip(axes.flat, rules, strict=False):
        stress = cube["buckling_stress"].sel({"rule": rule}).transpose("relative_bay_length", "radius_over_thickness") / 1e6
        x, y = stress["radius_over_thickness"], stress["relative_bay_length"]
        filled = panel.contourf(x, y, stress, levels=LEVELS, cmap="viridis", extend="both", alpha=0.8)
        lines = panel.contour(x, y, stress, levels=LEVELS, colors="black", linewidths=0.7)
        panel.clabel(lines, fontsize=8, fmt="%g")
        panel.set(xscale="log", yscale="log", title=name(cube, rule))
        panel.set_xticks([100, 200, 500, 1000, 2000, 3000], labels=["100", "200", "500", "1000", "2000", "3000"])
        panel.set_yticks([0.5, 1, 2, 5, 10, 20, 50, 100], labels=["0.5", "1", "2", "5", "10", "20", "50", "100"])
        panel.minorticks_off()
    for panel in axes.flat[len(rules) :]:
        panel.set_visible(False)
    for panel in axes.flat[max(0, len(rules) - columns) : len(rules)]:
        panel.tick_params(labelbottom=True)
        panel.set_xlabel("R/t")
    for panel in axes[:, 0]:
        panel.set_ylabel("L / sqrt(R t)")
    figure.colorbar(filled, ax=axes, label="buckling stress (MPa)", shrink=0.8)
    steel = float(cube["steel"]) / 1e6
    figure.suptitle(
        f"Buckling stress, no rings or pressure, yield stress {steel:g} MPa, {making(cube)}; white: outside the rule's scope"
    )
    numbers = cube["buckling_stress"].to_dataframe().reset_index()
    save(figure, numbers[["rule", "radius_over_thickness", "relative_bay_length", "buckling_stress"]], stem)
