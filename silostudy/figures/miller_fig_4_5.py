"""Miller's Figs. 4 and 5 again: general buckling with rings, C_3 M_e^2 against M_e^2 and C_3 against A_r / (L t)."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.miller_points import points, reached, scatter
from silostudy.figures.style import WIDTH, foot, headline, save

SLENDER = (250, 375, 500)
SHADES = ("0.0", "0.35", "0.6")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 5.8))
    tests = points(cube)
    ring = cube["chart_ring_coefficient"].sel({"chart_making": "manufactured"})
    curves = _over_length(left, ring, tests) + _over_ring_area(right, ring, tests)
    headline(figure, _message(ring, tests))
    foot(figure, "General buckling of the shell with its rings (source's Figs. 4 and 5), Miller's own tests")
    save(figure, pd.concat([*curves, tests.assign(curve="test")], ignore_index=True), stem)


def _message(ring: xr.DataArray, tests: pd.DataFrame) -> str:
    """Message of the figure, in numbers: how many general collapses reach the design coefficient at their own R/t and ring."""
    general = tests[tests.collapse == "G"]
    largest = float(ring["chart_ring_area_ratio"].max())
    places = {"chart_slenderness": general.R_over_t, "chart_ring_area_ratio": general.ring_area_ratio.clip(upper=largest)}
    designed = ring.interp({dim: ("test", values) for dim, values in places.items()})
    return f"General collapses that reach the design's $C_3$ of their own R/t and ring area: {reached(general.C3, designed)}"


def _over_length(panel, ring: xr.DataArray, tests: pd.DataFrame) -> list[pd.DataFrame]:
    """C_3 M_e^2 against M_e^2 at R/t = 500."""
    me2, curves = np.geomspace(50, 5000, 60), []
    for ratio, line in ((0.0, "solid"), (0.06, "dashed"), (0.1, "dashdot"), (0.2, "dotted")):
        value = float(ring.interp({"chart_slenderness": 500, "chart_ring_area_ratio": ratio}))
        label = f"$C_3$ = {value:.3f}, $A_r/(L t)$ = {ratio:g}{' and more' if ratio == 0.2 else ''}"
        panel.plot(me2, value * me2, color="black", linestyle=line, linewidth=1.2, label=label)
        curves.append(pd.DataFrame({"curve": label, "Me2": me2, "C3Me2": value * me2}))
    scatter(panel, tests.dropna(subset="Me2"), "Me2", "C3Me2")
    panel.set(
        xscale="log",
        yscale="log",
        xlabel=r"$M_e^2 = L_T^2 / (R t) \cdot t_e / t$",
        ylabel=r"$C_3 M_e^2 = \sigma R / (E t_e) \cdot M_e^2$",
    )
    panel.set_title("R/t = 500; tests whose total length $L_T$ is printed")
    panel.legend(loc="upper left")
    return curves


def _over_ring_area(panel, ring: xr.DataArray, tests: pd.DataFrame) -> list[pd.DataFrame]:
    """C_3 against the ring area ratio; a local collapse only says that C_3 is not smaller."""
    curves = []
    for slender, shade in zip(SLENDER, SHADES, strict=True):
        value = ring.interp({"chart_slenderness": slender})
        panel.plot(value["chart_ring_area_ratio"], value, color=shade, label=f"design, R/t {slender}")
        ratio = value["chart_ring_area_ratio"].values
        curves.append(pd.DataFrame({"curve": f"R/t {slender}", "ring_area_ratio": ratio, "C3": value.values}))
    panel.axvline(0.06, color="black", linestyle=":", linewidth=1, label="rings count from 0.06")
    scatter(panel, tests[tests.collapse == "G"], "ring_area_ratio", "C3")
    others = tests[(tests.collapse != "G") & (tests.ring_area_ratio <= 0.6)]
    panel.plot(
        others.ring_area_ratio,
        others.C3,
        linestyle="none",
        marker=6,
        color="0.55",
        label="collapsed locally (or not said): C₃ lies higher",
    )
    panel.set(xlabel=r"$A_r / (L t)$", ylabel=r"$C_3 = \sigma R / (E t_e)$", xlim=(-0.01, 0.6), ylim=(0, None))
    panel.set_title("general collapse (to $A_r/(L t)$ = 0.6)")
    panel.legend(loc="lower right")
    return curves
