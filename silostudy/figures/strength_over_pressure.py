"""Buckling stress over internal pressure by every rule: the pressure first steadies the wall, then makes its foot yield."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.rules import look, name
from silostudy.figures.style import save


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel for each R/t, over hoop stress p r / t as a share of the yield stress."""
    count = cube.sizes["radius_over_thickness"]
    figure, axes = plt.subplots(1, count, figsize=(3.9 * count, 5.4), sharey=True, squeeze=False)
    tables = []
    for place, panel in enumerate(axes.flat):
        here = cube.isel(radius_over_thickness=place)
        pressure = here["internal_pressure_lower_internal_pressure"]
        hoop = pressure * here["shell_radius"] / (here["thickness"] * here["yield_stress"])
        inside = hoop.values < 1
        for rule in map(str, cube["rule"].values):
            share = (here["buckling_stress"] / here["yield_stress"]).sel({"rule": rule})
            marks = {"marker": str(cube.sel({"rule": rule}).rule_marker.values), "markevery": 0.12, "markersize": 5}
            panel.plot(hoop[inside], share[inside], label=name(cube, rule) if place == 0 else None, **marks, **look(cube, rule))
            table = {
                "hoop_over_yield": hoop[inside],
                "pressure_kPa": pressure[inside] / 1e3,
                "strength_over_yield": share[inside],
            }
            slender = float(here["radius_over_thickness"])
            tables.append(
                pd.DataFrame({key: values.values for key, values in table.items()}).assign(rule=rule, R_over_t=slender)
            )
        panel.set(xlabel="hoop stress over yield stress, $p r / (t f_y)$", xlim=(0, 1), ylim=(0, None))
        panel.set_title(f"R/t {float(here['radius_over_thickness']):g}")
    axes[0, 0].set_ylabel("buckling stress over yield stress")
    figure.legend(loc="outside lower center", ncols=5)
    figure.suptitle(
        f"{cube.attrs['title']}\nrules without pressure stay level: they forgo its help and do not see the elephant's foot"
    )
    save(figure, pd.concat(tables, ignore_index=True), stem)
