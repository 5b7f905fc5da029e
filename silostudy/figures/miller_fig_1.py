"""Miller's Fig. 1 again: C M^2 against M^2, design curves and his own tests."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.miller_points import points, reached, scatter
from silostudy.figures.style import BLUE, WIDTH, foot, headline, save

SLENDER = (250, 375, 500)
READ = (
    "Elastic local buckling (source's Fig. 1), Miller's own tests. "
    "Filled: elastic (σ ≤ 0.55 $\\sigma_y$); open: beyond, so that yielding holds the point down"
)
LINES = {"manufactured": "solid", "fabricated": "dashed"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, panel = plt.subplots(figsize=(WIDTH, 6.4))
    length = cube["chart_relative_length"].values
    curves = []
    for making, line in LINES.items():
        for shade, slender in zip(("0.0", "0.35", "0.6"), SLENDER, strict=True):
            near = cube["chart_local_coefficient"].sel({"chart_making": making})
            value = near.interp({"chart_slenderness": slender}).values * length**2
            panel.plot(length**2, value, color=shade, linestyle=line, linewidth=1.2, label=f"{making}, R/t {slender}")
            curves.append(pd.DataFrame({"curve": f"{making}, R/t {slender}", "M2": length**2, "CM2": value}))
    perfect = pd.DataFrame({"curve": "perfect long shell, C = 0.605", "M2": length**2, "CM2": 0.605 * length**2})
    panel.plot(perfect.M2, perfect.CM2, color=BLUE, linestyle=":", linewidth=1.5, label=perfect.curve[0])
    curves.append(perfect)
    tests = points(cube)
    scatter(panel, tests, "M2", "CM2")
    panel.set(xscale="log", yscale="log", xlabel="M² = L² / (R t)", ylabel="C M² = (σ R / (E t)) M²")
    panel.set(xlim=(0.5, 5000), ylim=(0.2, 3000))
    panel.legend(loc="upper left")
    headline(figure, _message(cube, tests))
    foot(figure, READ)
    save(figure, pd.concat([*curves, tests.assign(curve="test")], ignore_index=True), stem)


def _message(cube: xr.Dataset, tests: pd.DataFrame) -> str:
    """Message of the figure, in numbers: how many elastic tests reach the design curves at their own R/t and M."""
    elastic = tests[tests.elastic]
    places = {"chart_slenderness": elastic.R_over_t, "chart_relative_length": elastic.M2**0.5}
    here = cube["chart_local_coefficient"].interp({dim: ("test", values) for dim, values in places.items()})
    told = [f"{reached(elastic.C, here.sel(chart_making=making))} if {making}" for making in LINES]
    return f"Tests that stayed elastic and reach the design curve of their own R/t: {', '.join(told)}"
