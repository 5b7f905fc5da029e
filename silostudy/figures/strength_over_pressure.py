"""Buckling stress over internal pressure by every rule: the pressure first steadies the wall, then makes its foot yield."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.figures.rules import look, name
from silostudy.figures.style import WIDTH, foot, headline, save


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a panel for each R/t, over hoop stress p r / t as a share of the yield stress."""
    count = cube.sizes["radius_over_thickness"]
    figure, axes = plt.subplots(1, count, figsize=(WIDTH, 5.2), sharey=True, squeeze=False)
    tables = []
    for place, panel in enumerate(axes.flat):
        here = cube.isel(radius_over_thickness=place)
        pressure = here["internal_pressure_lower_internal_pressure"]
        hoop = pressure * here["shell_radius"] / (here["thickness"] * here["yield_stress"])
        inside = hoop.values < 1
        for rule in map(str, cube["rule"].values):
            share = (here["buckling_stress"] / here["yield_stress"]).sel({"rule": rule})
            style = look(cube, rule) | {"markevery": 0.15, "markersize": 5}
            panel.plot(hoop[inside], share[inside], label=name(cube, rule) if place == 0 else None, **style)
            table = {
                "hoop_over_yield": hoop[inside],
                "pressure_kPa": pressure[inside] / 1e3,
                "strength_over_yield": share[inside],
            }
            slender = float(here["radius_over_thickness"])
            tables.append(
                pd.DataFrame({key: values.values for key, values in table.items()}).assign(rule=rule, R_over_t=slender)
            )
        panel.set(xlabel="$p r / (t f_y)$", xlim=(0, 1), ylim=(0, None), xticks=(0, 0.5, 1))
        panel.set_title(f"R/t {float(here['radius_over_thickness']):g}")
    axes[0, 0].set_ylabel("buckling stress over yield stress")
    numbers = pd.concat(tables, ignore_index=True)
    headline(figure, _message(numbers))
    told = "$p r / (t f_y)$: hoop stress over yield stress; rules without pressure stay level: they forgo its help"
    foot(
        figure, f"{cube.attrs['title']}; {told} and miss the elephant's foot", handles=axes[0, 0].get_legend_handles_labels()[0]
    )
    save(figure, numbers, stem)


def _message(numbers: pd.DataFrame) -> str:
    """Message of the figure, in numbers: by how much pressure lifts the strength of the stoutest and of the thinnest wall."""
    strength = numbers.groupby(["R_over_t", "rule"]).strength_over_yield
    gain = (strength.max() / strength.first()).groupby("R_over_t").max()
    return (
        f"Internal pressure lifts the buckling stress up to {gain.iloc[0]:.1f} times at R/t {gain.index[0]:g} and"
        f" {gain.iloc[-1]:.1f} times at R/t {gain.index[-1]:g}, until the foot of the wall yields"
    )
