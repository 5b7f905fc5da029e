"""A laboratory's tests at a glance: compression, shear over its way, loci of yield and wall friction, width of the cell."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.laboratory import CELL, FILLING, Found, Solid, checks
from silostudy.figures.style import plt, save

KPA = 1e3  # Pa
INSIDE, WALL, PATH = "#0072b2", "#d55e00", "#009e73"
SHADES = (0.35, 0.65, 1.0)  # from the least stress to the largest
QUANTITIES = {
    "unit weight, pressed": ("tested_unit_weight", "row_vertical_stress"),
    "K": ("tested_lateral_pressure_ratio", "row_vertical_stress"),
    "internal friction, peak": ("internal_peak_shear_ratio", "row_vertical_stress"),
    "internal friction, steady": ("internal_steady_shear_ratio", "row_vertical_stress"),
    "wall friction, steady": ("wall_steady_shear_ratio", "row_horizontal_stress"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers; single fillings thin, means thick."""
    solid, wide = Solid.of(cube), cube.isel({CELL: -1})
    figure, ((path, shear), (locus, width)) = plt.subplots(2, 2, figsize=(11.5, 8.2))
    numbers = [_path(path, wide, solid), _shear(shear, wide), _locus(locus, wide, solid), _width(width, cube)]
    failed = [f"does not hold: {one}".removesuffix(": does not hold") for one in checks(cube) if not one.holds]
    about = f"cell {float(wide[CELL]):g} grains wide, {int(wide['tested_grains'][0])} grains, {solid.loose.count} fillings"
    figure.suptitle("\n".join([cube.attrs["title"], about, *failed]), fontsize=10)
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _path(panel: Axes, wide: xr.Dataset, solid: Solid) -> pd.DataFrame:
    """Horizontal over vertical stress at first loading."""
    table = wide["path_horizontal_stress"].to_dataframe().reset_index()
    for _, one in table.groupby(FILLING):
        panel.plot(one["path_stress"] / KPA, one["path_horizontal_stress"] / KPA, color=PATH, linewidth=0.6, alpha=0.6)
    mean = table.groupby("path_stress")["path_horizontal_stress"].mean()
    panel.plot(mean.index / KPA, mean / KPA, color=PATH, linewidth=2.0, label="mean of fillings")
    ratio, end = solid.lateral_pressure_ratio, float(wide["row_vertical_stress"])
    top = float(np.interp(end, mean.index, mean))
    ends = np.array([0.5 * end, end])
    panel.plot(ends / KPA, (top + ratio.mean * (ends - end)) / KPA, "k--", linewidth=1.2,
               label=f"slope K = {ratio.mean:.3f} ± {ratio.deviation:.3f}")  # fmt: skip
    panel.set(xlabel="vertical stress (kPa)", ylabel="horizontal stress (kPa)", title="uniaxial compression, first loading")
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    panel.legend(loc="upper left")
    return _numbers(table, "path", "path_stress", "path_horizontal_stress")


def _shear(panel: Axes, wide: xr.Dataset) -> pd.DataFrame:
    """Shear stress over the way, inside the solid and on the wall's plate, for each normal stress."""
    tables, stresses = [], wide["normal_stress"].values
    for name, colour, told in (("internal", INSIDE, "in the solid"), ("wall", WALL, "on the wall")):
        ratio = wide[f"{name}_shear_ratio"]
        for number, stress in enumerate(stresses):
            each = (ratio.sel(normal_stress=stress) * stress / KPA).transpose(FILLING, "shear_strain")
            alpha = np.interp(number, np.linspace(0, max(len(stresses) - 1, 1), len(SHADES)), SHADES)
            mean, spread = each.mean(FILLING), each.std(FILLING, ddof=1)
            label = told if number == len(stresses) - 1 else None
            way = each["shear_strain"]
            panel.fill_between(way, mean - spread, mean + spread, color=colour, alpha=0.15, linewidth=0)
            panel.plot(way, mean, color=colour, alpha=alpha, linewidth=1.6, label=label)
            panel.annotate(f"{stress / KPA:g} kPa", (float(way[-1]), float(mean[-1])), xytext=(4, -3), fontsize=8,
                           textcoords="offset points", color=colour)  # fmt: skip
        table = ratio.to_dataframe().reset_index()
        tables.append(_numbers(table, f"{name} shear", "shear_strain", f"{name}_shear_ratio"))
    panel.set(xlabel="way of the lid at its mean radius over the height", ylabel="shear stress (kPa)", ylim=(0.0, None))
    panel.set(title="shear: mean and standard deviation of fillings")
    panel.margins(x=0.1)
    panel.legend(loc="upper left")
    return pd.concat(tables, ignore_index=True)


def _locus(panel: Axes, wide: xr.Dataset, solid: Solid) -> pd.DataFrame:
    """Shear over normal stress: peak and steady inside the solid, steady on the wall, with the row's lines."""
    stress = wide["normal_stress"].values
    lines = {
        "internal_peak_shear_ratio": ("o", INSIDE, "in the solid, peak"),
        "internal_steady_shear_ratio": ("s", PATH, "in the solid, steady"),
        "wall_steady_shear_ratio": ("^", WALL, "on the wall, steady"),
    }
    tables, ends = [], np.array([0.0, 1.08 * stress[-1]])
    for name, (marker, colour, told) in lines.items():
        shear = wide[name] * stress / KPA
        panel.errorbar(stress / KPA, shear.mean(FILLING), shear.std(FILLING, ddof=1), fmt=marker, color=colour, capsize=3,
                       markersize=5, label=told)  # fmt: skip
        tables.append(_numbers(wide[name].to_dataframe().reset_index(), told, "normal_stress", name))
    angle, friction = solid.friction_angle, solid.wall_friction
    panel.plot(ends / KPA, np.tan(angle.mean) * ends / KPA, color=INSIDE, linewidth=1.0,
               label=f"phi = {np.degrees(angle.mean):.1f} ± {np.degrees(angle.deviation):.1f} deg")  # fmt: skip
    panel.plot(ends / KPA, friction.mean * ends / KPA, color=WALL, linewidth=1.0,
               label=f"mu = {friction.mean:.3f} ± {friction.deviation:.3f}")  # fmt: skip
    panel.set(xlabel="normal stress (kPa)", ylabel="shear stress (kPa)", title="yield locus and wall friction")
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    panel.legend(loc="upper left")
    return pd.concat(tables, ignore_index=True)


def _width(panel: Axes, cube: xr.Dataset) -> pd.DataFrame:
    """Every quantity of every cell over that of the widest one: what the width of the cell does."""
    rows, shown = [], list(QUANTITIES)
    cells = cube[CELL].values
    for place, (name, (variable, at)) in enumerate(QUANTITIES.items()):
        values = cube[variable].sel(normal_stress=float(cube[at]))
        base = Found.of(values.isel({CELL: -1})).mean
        for number, cell in enumerate(cells):
            found = Found.of(values.isel({CELL: number}))
            y = place + 0.22 * (number - 0.5 * (len(cells) - 1))
            panel.errorbar(found.mean / base, y, xerr=found.deviation / base, fmt="o", capsize=3, markersize=5,
                           color=plt.cm.viridis(0.15 + 0.6 * number / max(len(cells) - 1, 1)),
                           label=f"{cell:g} grains wide" if place == 0 else None)  # fmt: skip
            rows.append({"panel": f"width: {name}", "x": cell, "value": found.mean, "deviation": found.deviation})
    panel.axvline(1.0, color="black", linewidth=0.8)
    panel.set_yticks(range(len(shown)), shown)
    panel.invert_yaxis()
    panel.set(xlabel="mean and standard deviation of fillings over the widest cell's mean", title="width of the cell")
    panel.legend(loc="best")
    return pd.DataFrame(rows)


def _numbers(table: pd.DataFrame, panel: str, x: str, value: str) -> pd.DataFrame:
    """Rows of the figure's table: the panel, filling and normal stress, and what is drawn over what, SI."""
    kept = [name for name in (FILLING, "normal_stress") if name in table.columns]
    return table[kept].assign(panel=panel, x=table[x], value=table[value])
