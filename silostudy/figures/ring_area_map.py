"""Gain by rings: Miller's buckling stress over R/t and ring area, and where general buckling takes over."""

from pathlib import Path

import matplotlib.pyplot as plt
import xarray as xr

from silostudy.figures.rules import making
from silostudy.figures.style import WIDTH, foot, headline, save
from silostudy.tables.outputs import output_of

(RULE,) = output_of(__name__).rules
LEVELS = [20, 30, 50, 75, 100, 125, 150, 175, 200]
LENGTHS = (2.0, 4.0, 8.0)
SLENDER = 1000.0  # the R/t that the headline speaks of
MAKING = 1  # the middle one: fabricated


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the map and its numbers; ring areas below 0.06 do not count and are left out."""
    cube = cube.sel({"rule": RULE}).isel(steel=0, making=min(MAKING, cube.sizes["making"] - 1))
    cube = cube.sel(ring_area_ratio=cube["ring_area_ratio"] >= 0.06)
    figure, axes = plt.subplots(1, len(LENGTHS), figsize=(WIDTH, 5.4), sharey=True)
    helpful = []
    for panel, length in zip(axes, LENGTHS, strict=True):
        here = cube.sel(relative_bay_length=length, method="nearest")
        order = ("ring_area_ratio", "radius_over_thickness")
        stress, x, y = here["buckling_stress"].transpose(*order) / 1e6, here["radius_over_thickness"], here["ring_area_ratio"]
        filled = panel.contourf(x, y, stress, levels=LEVELS, cmap="viridis", extend="both", alpha=0.8)
        panel.clabel(panel.contour(x, y, stress, levels=LEVELS, colors="black", linewidths=0.7), fontsize="small", fmt="%g")
        excess = (here["elastic_local_stress"] / here["elastic_general_stress"]).transpose(*order)
        helpful.append(_helpful(here, excess))
        panel.contourf(x, y, excess, levels=[1, 1e9], colors="none", hatches=["//"])
        panel.set(xscale="log", xlabel="R/t", title=f"ring spacing {float(here['relative_bay_length']):g} sqrt(R t)")
        panel.set_xticks([100, 300, 1000, 3000], labels=["100", "300", "1000", "3000"])
        panel.minorticks_off()
    axes[0].set_ylabel("ring area over bay area $A_r / (L t)$")
    figure.colorbar(filled, ax=axes, label="buckling stress (MPa)", location="bottom", shrink=0.6, aspect=40)
    steel = float(cube["steel"]) / 1e6
    headline(figure, f"At R/t = {_slender(cube):.0f} larger rings help {', '.join(helpful)}")
    read = "hatched: the shell buckles with its rings, so that larger ones help; elsewhere the bay buckles between them"
    foot(figure, f"Miller's buckling stress with rings, {making(cube)}, yield stress {steel:g} MPa; {read}")
    stresses = ["buckling_stress", "elastic_local_stress", "elastic_general_stress"]
    numbers = (
        cube[stresses]
        .to_dataframe()
        .reset_index()[["radius_over_thickness", "relative_bay_length", "ring_area_ratio", *stresses]]
    )
    save(figure, numbers.assign(local_over_general=numbers.elastic_local_stress / numbers.elastic_general_stress), stem)


def _slender(cube: xr.Dataset) -> float:
    """The R/t of the study next to that of the headline."""
    return float(cube["radius_over_thickness"].sel(radius_over_thickness=SLENDER, method="nearest"))


def _helpful(here: xr.Dataset, excess: xr.DataArray) -> str:
    """Ring area up to which larger rings help a wall of the headline's R/t at one spacing, in words."""
    spacing = f"where they stand {float(here['relative_bay_length']):g} √(R\u00a0t) apart"
    areas = excess["ring_area_ratio"].values[(excess.sel(radius_over_thickness=SLENDER, method="nearest") > 1).values]
    return f"up to {areas.max():.2f} of the bay's area {spacing}" if len(areas) else f"not at all {spacing}"
