"""Elastic knock-down factor against R/t by every rule, for long shells without rings, with Miller's tests as points."""

from math import sqrt
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.rules import demand, limits, look, making, name
from silostudy.figures.style import WIDTH, foot, headline, save
from silostudy.tables.miller1977 import TESTS

LENGTH = 20  # L / sqrt(R t), near that of the tests without rings (17.5 to 23.9)


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel for each making, at the first yield stress of the study."""
    demand(cube, "ring_area_ratio", (0.0,))
    cube = cube.sel(ring_area_ratio=0.0).sel(relative_bay_length=LENGTH, method="nearest").isel(steel=0)
    tests = _tests()
    figure, axes = plt.subplots(1, cube.sizes["making"], figsize=(WIDTH, 5.6), sharey=True, squeeze=False)
    curves = []
    for place, panel in enumerate(axes.flat):
        here = cube.isel(making=place)
        made = making(here)
        for rule in map(str, cube["rule"].values):
            factor = here["elastic_knockdown_factor"].sel({"rule": rule})
            label = "; ends: ".join([name(cube, rule), *limits(cube, rule)]) if place == 0 else None
            panel.plot(factor["radius_over_thickness"], factor, linewidth=1.6, label=label, markevery=0.15, **look(cube, rule))
            table = factor.to_dataframe().reset_index()[["radius_over_thickness", "elastic_knockdown_factor"]]
            curves.append(table.assign(curve=rule, making=made))
        for elastic, fill in ((True, "black"), (False, "none")):
            part = tests[tests.elastic == elastic]
            label = f"tests without rings, {'elastic' if elastic else 'beyond 0.55 of yield'}" if place == 0 else None
            style = {"linestyle": "none", "marker": "o", "color": "black", "markerfacecolor": fill}
            panel.plot(part.radius_over_thickness, part.elastic_knockdown_factor, label=label, **style)
        panel.set(xscale="log", xlabel="R/t", title=made, ylim=(0, 1.05))
        panel.set_xticks([100, 200, 500, 1000, 3000], labels=["100", "200", "500", "1000", "3000"])
        panel.minorticks_off()
    axes[0, 0].set_ylabel("elastic buckling stress over classical stress")
    table, length = pd.concat([*curves, tests.assign(curve="test")], ignore_index=True), float(cube["relative_bay_length"])
    headline(figure, _message(cube, table))
    told = f"Knock-down factor of cylinders without rings, L / sqrt(R t) = {length:g}; Miller's tests are manufactured shells"
    foot(figure, told, handles=axes[0, 0].get_legend_handles_labels()[0])
    save(figure, table, stem)


def _message(cube: xr.Dataset, table: pd.DataFrame) -> str:
    """Message of the figure, in numbers, at the slenderness of the grid that lies next to the thinnest test."""
    tests = table[table.curve == "test"]
    slender = float(
        cube["radius_over_thickness"].sel(radius_over_thickness=tests.radius_over_thickness.max(), method="nearest")
    )
    here = table[(table.radius_over_thickness == slender) & (table.elastic_knockdown_factor < 1.0)]
    rules, elastic = here.elastic_knockdown_factor, tests[tests.elastic].elastic_knockdown_factor
    return (
        f"At R/t = {slender:.0f} the rules let a wall carry {rules.min():.2f} to {rules.max():.2f} of the perfect shell's"
        f" stress; tests that stayed elastic carried {elastic.min():.2f} to {elastic.max():.2f}"
    )


def _tests() -> pd.DataFrame:
    """Miller's tests without rings: measured collapse stress over the classical stress with nu = 0.3."""
    long = [test for test in TESTS.values() if test.ring_area == 0]
    classical = [t.youngs_modulus * t.thickness / t.shell_radius / sqrt(3 * (1 - 0.3**2)) for t in long]
    stress = np.array([test.lower_buckling_stress for test in long])
    return pd.DataFrame(
        {
            "test": [test.key for test in long],
            "radius_over_thickness": [test.shell_radius / test.thickness for test in long],
            "elastic_knockdown_factor": stress / np.array(classical),
            "elastic": stress <= 0.55 * np.array([test.yield_stress for test in long]),
        }
    )
