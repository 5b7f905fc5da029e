"""Miller's Figs. 6 and 7 again: inelastic buckling, the formula against his tests with and without rings."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.miller_points import points, reached, scatter
from silostudy.figures.style import WIDTH, foot, headline, save
from silostudy.tables.outputs import output_of

(RULE,) = output_of(__name__).rules


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    rule = cube.sel({"rule": RULE})
    tests = points(cube).assign(elastic_ratio=(rule["elastic_buckling_stress"] / rule["yield_stress"]).values)
    x, y = cube["chart_elastic_ratio"].values, cube["chart_strength_ratio"].values
    figure, axes = plt.subplots(1, 2, figsize=(WIDTH, 5.4), sharey=True)
    for panel, kinds, title in (
        (axes[0], ("ringed", "large"), "with rings (source's Fig. 6)"),
        (axes[1], ("unstiffened",), "without rings (source's Fig. 7)"),
    ):
        panel.plot(x, y, color="black", label="formula (15)")
        panel.plot(x[x <= 1], x[x <= 1], color="black", linestyle=":", label="no yielding")
        scatter(panel, tests[tests.group.isin(kinds)], "elastic_ratio", "strength_ratio")
        panel.set(
            xlabel=r"elastic stress over yield stress, $\sigma_{ec} / \sigma_y$", title=title, xlim=(0, 2), ylim=(0, 1.05)
        )
        panel.legend(loc="lower right")
    axes[0].set_ylabel(r"buckling stress over yield stress, $\sigma_{cr} / \sigma_y$")
    formula = np.interp(tests.elastic_ratio, x, y, right=np.nan)
    headline(figure, f"Tests that were at least as strong as formula (15) says: {reached(tests.strength_ratio, formula)}")
    foot(figure, "Inelastic buckling; the source does not print its fabricated shells without rings")
    save(
        figure,
        pd.concat([pd.DataFrame({"curve": "formula", "elastic_ratio": x, "strength_ratio": y}), tests.assign(curve="test")]),
        stem,
    )
