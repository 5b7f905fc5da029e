"""Mass flow of spheres out of a bin over the width of its outlet, beside Beverloo's law."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from scipy.stats import linregress
from scipy.stats import t as student

from silostudy.errors import BadInput
from silostudy.figures.style import BLUE, VERMILION, WIDTH, foot, headline, plt, save
from silostudy.tables.constants import ROUNDED_GRAVITY

POWER = 2.5  # Beverloo's
EDGES = (1.0, 2.0)  # diameters by which an outlet seems narrower: what is found for spheres
MM = 1e-3  # m


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a point for each filling, and the line through all of them."""
    table, diameter = flows(cube), float(cube["mean_grain_diameter"].mean())
    if table["outlet_width_m"].nunique() < 2:
        raise BadInput("outlet_width", len(table), "cases flowed, of fewer than two outlets: no line goes through them")
    slope, cut = line(table)
    (low, off_low), (high, off_high) = (power(table, edge * diameter) for edge in EDGES)
    figure, panel = plt.subplots(figsize=(WIDTH, 6.2))
    panel.plot(table["outlet_width_m"] / MM, table["root_of_flow"], "o", color=BLUE, markersize=6, label="a filling")
    ends = np.array([cut, table["outlet_width_m"].max()])
    law = pd.DataFrame({"outlet_width_m": ends, "root_of_flow": slope * (ends - cut)})
    told = f"Beverloo's law, $(D - k d)^{{5/2}}$ with k = {cut / diameter:.2f}"
    panel.plot(law["outlet_width_m"] / MM, law["root_of_flow"], color=VERMILION, linewidth=1.8, label=told, zorder=1)
    panel.set(xlabel="width of the outlet D (mm)", ylabel="mass flow to the power 2/5 (kg$^{2/5}$ s$^{-2/5}$)")
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    headline(
        figure,
        f"Mass flow grows with the power {high:.2f} to {low:.2f} of the free width, Beverloo's 2.5 {_between(low, high)}",
    )
    edges = f"{low:.2f} ± {off_low:.2f} of (D - k d) with k = {EDGES[0]:g} grain diameters d, "
    edges += f"{high:.2f} ± {off_high:.2f} with k = {EDGES[1]:g}{_constant(cube, slope)}."
    foot(figure, f"{cube.attrs['title']}.", f"Power {edges}", handles=panel.get_legend_handles_labels()[0])
    shown = pd.concat([table.assign(kind="filling"), law.assign(kind="law")], ignore_index=True)
    about = {"power_for_k_1": low, "off_for_k_1": off_low, "power_for_k_2": high, "off_for_k_2": off_high}
    save(figure, shown.assign(**about, constant=constant(cube, slope)), stem)


def _between(low: float, high: float) -> str:
    """Whether Beverloo's power lies between those of both edges."""
    return "between" if high <= POWER <= low else "outside"


def flows(cube: xr.Dataset) -> pd.DataFrame:
    """Outlet (m) and mass flow (kg/s) of every case that flowed, and the flow to the power 2/5."""
    flow, width = xr.broadcast(cube["mean_mass_flow"], cube["outlet_width"])
    table = pd.DataFrame({"outlet_width_m": width.values.ravel(), "mass_flow_kg_s": flow.values.ravel()}).dropna()
    return table.assign(root_of_flow=table["mass_flow_kg_s"] ** (1.0 / POWER))


def line(table: pd.DataFrame) -> tuple[float, float]:
    """Slope (kg^2/5 s^-2/5 m^-1) of the line through the flows to the power 2/5, and the width (m) at which it is 0.

    Source: mankoc_2007 (Beverloo's law).
    """
    fit = linregress(table["outlet_width_m"], table["root_of_flow"])
    return float(fit.slope), float(-fit.intercept / fit.slope)


def power(table: pd.DataFrame, edge: float) -> tuple[float, float]:
    """Power (1) of the outlet less an edge (m) that the flow grows with, and half of its 95 % interval.

    NaN where an outlet is no wider than the edge.
    """
    free = table["outlet_width_m"] - edge
    if not (free > 0.0).all():
        return np.nan, np.nan
    line = linregress(np.log(free), np.log(table["mass_flow_kg_s"]))
    return float(line.slope), float(student.ppf(0.975, len(table) - 2) * line.stderr) if len(table) > 2 else np.nan


def constant(cube: xr.Dataset, slope: float) -> float:
    """C (1) of W = C rho_b sqrt(g) (D - k d)^(5/2), from the line's slope (kg^2/5 s^-2/5 m^-1) and the contents at rest.

    NaN where the cube does not hold their unit weight.  Source: mankoc_2007 (Beverloo's law).
    """
    if "unit_weight_at_rest" not in cube:
        return np.nan
    return slope**POWER * np.sqrt(ROUNDED_GRAVITY) / float(cube["unit_weight_at_rest"].mean())


def _constant(cube: xr.Dataset, slope: float) -> str:
    """The constant in words, where it is known."""
    of_law = constant(cube, slope)
    return f"; C = {of_law:.2f}, 0.55 to 0.65 in print" if np.isfinite(of_law) else ""
