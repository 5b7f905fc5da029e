"""A laboratory's tests at a glance: compression, shear over its way, loci of yield and wall friction, width of the cell."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.laboratory import CELL, FILLING, MeasuredSolid, Scatter, checks
from silostudy.figures.apart import apart
from silostudy.figures.style import BLUE, GREEN, MARKERS, VERMILION, WIDTH, foot, headline, plt, save

KPA = 1e3  # Pa
INSIDE = BLUE  # shear in the solid
WALL = VERMILION  # shear on the wall
STEADY = GREEN  # steady shear in the solid
CLOSEST = 0.045  # of the height of the panel, between the stresses at the ends of curves
PALE = 0.35  # opacity of the least stress
# what the width of the cell is looked at by: variable, and the stress at which it enters the row
QUANTITIES = {
    "unit weight, pressed": ("tested_unit_weight", "row_vertical_stress"),
    "K": ("tested_lateral_pressure_ratio", "row_vertical_stress"),
    "internal friction, peak": ("internal_peak_shear_ratio", "row_vertical_stress"),
    "internal friction, steady": ("internal_steady_shear_ratio", "row_vertical_stress"),
    "wall friction, steady": ("wall_steady_shear_ratio", "row_horizontal_stress"),
}
LOCI = {
    "internal_peak_shear_ratio": ("o", INSIDE, "in the solid, peak"),
    "internal_steady_shear_ratio": ("s", STEADY, "in the solid, steady"),
    "wall_steady_shear_ratio": ("^", WALL, "on the wall, steady"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: of the widest cell, and what the width does."""
    solid, wide = MeasuredSolid.of(cube), cube.isel({CELL: -1})
    figure, ((path, shear), (locus, width)) = plt.subplots(2, 2, figsize=(WIDTH, 9.4))
    numbers = [*_path(path, wide, solid), *_shear(shear, wide), *_locus(locus, wide, solid), *_width(width, cube)]
    looked_at = list(checks(cube))
    failed = [f"{check}." for check in looked_at if not check.holds]
    about = f"Cell {float(wide[CELL]):g} grains wide, {int(wide['tested_grains'][0])} grains, {solid.loose.count} fillings; "
    about += f"poured heap {np.degrees(solid.repose_angle.mean):.1f} ± {np.degrees(solid.repose_angle.deviation):.1f} degrees."
    drawn, back = Scatter.of(wide["tested_drawn_angle"]), float(wide["tested_restitution"].mean())
    about = about.replace(
        " degrees.", f", drawn down {np.degrees(drawn.mean):.1f} ± {np.degrees(drawn.deviation):.1f} degrees; "
    )
    about += f"a dropped grain comes back with {back:.3f} of its speed."
    headline(figure, _message(solid, len(failed), len(looked_at)))
    foot(figure, f"{cube.attrs['title']}.", about, *failed)
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _message(solid: MeasuredSolid, failed: int, looked_at: int) -> str:
    """The row of the solid that the tests give, and how many checks it fails."""
    row = f"K = {solid.lateral_pressure_ratio.mean:.2f}, phi = {np.degrees(solid.friction_angle.mean):.1f}°"
    checked = f"{looked_at - failed} of {looked_at} checks hold"
    return f"The tests give {row}, wall friction {solid.wall_friction.mean:.2f}; {checked}"


def _path(panel: Axes, wide: xr.Dataset, solid: MeasuredSolid) -> list[pd.DataFrame]:
    """Horizontal over vertical stress at first loading."""
    vertical, horizontal = (
        wide["path_stress"].values / KPA,
        wide["path_horizontal_stress"].transpose(FILLING, "path_stress") / KPA,
    )
    mean = horizontal.mean(FILLING).values
    curves = [*(("a filling", filling.values, 0.6) for filling in horizontal), ("mean of fillings", mean, 2.0)]
    tables = []
    for number, (label, values, width) in enumerate(curves):
        told = label if number in (0, len(curves) - 1) else None
        panel.plot(vertical, values, label=told, color=STEADY, linewidth=width, alpha=0.6 if width < 1.0 else 1.0)
        tables.append(pd.DataFrame({"vertical_stress_kPa": vertical, "horizontal_stress_kPa": values}).assign(curve=label))
    ratio, end = solid.lateral_pressure_ratio, float(wide["row_vertical_stress"]) / KPA
    ends = np.array([0.5 * end, end])
    slope = np.interp(end, vertical, mean) + ratio.mean * (ends - end)
    told = f"slope K = {ratio.mean:.3f} ± {ratio.deviation:.3f}"
    panel.plot(ends, slope, "k--", linewidth=1.2, label=told)
    tables.append(pd.DataFrame({"vertical_stress_kPa": ends, "horizontal_stress_kPa": slope}).assign(curve=told))
    panel.set(xlabel="vertical stress (kPa)", ylabel="horizontal stress (kPa)", title="uniaxial compression, first loading")
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    panel.legend(loc="upper left")
    return [table.assign(panel="compression") for table in tables]


def _shear(panel: Axes, wide: xr.Dataset) -> list[pd.DataFrame]:
    """Shear stress over the way, inside the solid and on the wall's plate, for each normal stress."""
    tables, ends, stresses, way = [], [], wide["normal_stress"].values, wide["shear_strain"].values
    for name, colour, told, dashes in (("internal", INSIDE, "in the solid", "-"), ("wall", WALL, "on the wall", (0, (4, 2)))):
        for stress, opacity in zip(stresses, np.linspace(PALE if len(stresses) > 1 else 1.0, 1.0, len(stresses)), strict=True):
            shear = wide[f"{name}_shear_ratio"].sel(normal_stress=stress) * stress / KPA
            mean, spread = shear.mean(FILLING).values, shear.std(FILLING, ddof=1).values
            panel.fill_between(way, mean - spread, mean + spread, color=colour, alpha=0.15, linewidth=0)
            label = told if stress == stresses[-1] else None
            panel.plot(way, mean, color=colour, linestyle=dashes, alpha=opacity, label=label)
            ends.append((mean[-1], f"{stress / KPA:g} kPa", colour))
            columns = {"shear_strain": way, "shear_stress_kPa": mean, "low_kPa": mean - spread, "high_kPa": mean + spread}
            tables.append(pd.DataFrame(columns).assign(curve=told, normal_stress_kPa=stress / KPA))
    panel.set(xlabel="way of the lid over the height", ylabel="shear stress (kPa)")
    high = 1.25 * panel.get_ylim()[1]  # room for the legend above the curves
    panel.set(title="shear: mean and deviation of fillings", xlim=(0.0, 1.2 * way[-1]), ylim=(0.0, high))
    panel.legend(loc="upper left", ncols=2)
    ends.sort()
    for place, (_, words, colour) in zip(apart([end for end, *_ in ends], CLOSEST * high), ends, strict=True):
        panel.text(1.02 * way[-1], place, words, fontsize="small", va="center", color=colour)
    return [table.assign(panel="shear") for table in tables]


def _locus(panel: Axes, wide: xr.Dataset, solid: MeasuredSolid) -> list[pd.DataFrame]:
    """Shear over normal stress: peak and steady inside the solid, steady on the wall, with the row's lines."""
    stress, tables = wide["normal_stress"].values / KPA, []
    for name, (marker, colour, told) in LOCI.items():
        shear = wide[name].transpose(FILLING, "normal_stress").values * stress
        mean, spread = np.nanmean(shear, axis=0), np.nanstd(shear, axis=0, ddof=1)
        panel.errorbar(stress, mean, spread, fmt=marker, color=colour, capsize=3, markersize=5, label=told)
        columns = {"normal_stress_kPa": stress, "shear_stress_kPa": mean, "low_kPa": mean - spread, "high_kPa": mean + spread}
        tables.append(pd.DataFrame(columns).assign(curve=told))
    angle, friction, ends = solid.friction_angle, solid.wall_friction, np.array([0.0, 1.08 * stress[-1]])
    lines = {
        f"phi = {np.degrees(angle.mean):.1f} ± {np.degrees(angle.deviation):.1f} degrees": (np.tan(angle.mean), INSIDE),
        f"mu = {friction.mean:.3f} ± {friction.deviation:.3f}": (friction.mean, WALL),
    }
    for told, (slope, colour) in lines.items():
        dashes = "-" if colour == INSIDE else (0, (4, 2))
        panel.plot(ends, slope * ends, color=colour, linestyle=dashes, linewidth=1.0, label=told)
        tables.append(pd.DataFrame({"normal_stress_kPa": ends, "shear_stress_kPa": slope * ends}).assign(curve=told))
    panel.set(xlabel="normal stress (kPa)", ylabel="shear stress (kPa)", title="yield locus and wall friction")
    panel.set(xlim=(0.0, None), ylim=(0.0, None))
    panel.legend(loc="upper left")
    return [table.assign(panel="loci") for table in tables]


def _width(panel: Axes, cube: xr.Dataset) -> list[pd.DataFrame]:
    """Every quantity of every cell over that of the widest one."""
    rows, cells = [], cube[CELL].values
    for place, (name, (variable, stress)) in enumerate(QUANTITIES.items()):
        tests = cube[variable].sel(normal_stress=float(cube[stress])).transpose(CELL, FILLING)
        results = [Scatter.of(fillings) for fillings in tests]
        for number, (cell, result) in enumerate(zip(cells, results, strict=True)):
            value, spread = result.mean / results[-1].mean, result.deviation / results[-1].mean
            rows.append({"curve": f"{cell:g} grains wide", "quantity": name, "over_widest": value, "low": value - spread,
                         "high": value + spread, "place": place + 0.2 * (number - 0.5 * (len(cells) - 1))})  # fmt: skip
    table = pd.DataFrame(rows)
    for number, (told, cell) in enumerate(table.groupby("curve", sort=False)):
        bars = [cell["over_widest"] - cell["low"], cell["high"] - cell["over_widest"]]
        colour = plt.get_cmap("viridis")(0.1 + 0.7 * number / max(len(cells) - 1, 1))
        panel.errorbar(cell["over_widest"], cell["place"], xerr=bars, fmt=MARKERS[number % len(MARKERS)], capsize=3,
                       markersize=5, color=colour, label=told)  # fmt: skip
    panel.axvline(1.0, color="black", linewidth=0.8)
    panel.set_yticks(range(len(QUANTITIES)), list(QUANTITIES))
    panel.set_ylim(len(QUANTITIES) - 0.5, -1.1)
    panel.set(xlabel="mean and standard deviation of fillings\nover the widest cell's mean", title="width of the cell")
    panel.legend(loc="upper right", ncols=len(cells))
    return [table.assign(panel="width")]
