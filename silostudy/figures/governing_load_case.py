"""Which load case gives the largest wall pressure in the hopper, over H/D and half angle, and the ring force's share."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch

from silostudy.figures.style import save, title

CASES = {
    "filling, lower half of the hopper": ("#4393C3", "fl"),
    "filling, upper half": ("#D1E5F0", "fu"),
    "discharge, lower half": ("#F4A582", "dl"),
    "discharge, upper half": ("#D6604D", "du"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the maps, one a method, and their numbers."""
    methods = [
        m for m in map(str, cube["pressure_method"].values) if cube["hopper_balance"].sel(pressure_method=m).notnull().any()
    ]
    methods = [m for m in methods if set(_phases(cube, m)) == {"filling", "discharge"}]
    figure, axes = plt.subplots(1, len(methods) + 1, figsize=(4.4 * (len(methods) + 1), 5.4), squeeze=False, sharey=True)
    colours = ListedColormap([colour for colour, _ in CASES.values()])
    tables = []
    for panel, method in zip(axes[0], methods, strict=False):
        case, largest = governing(cube.sel(pressure_method=method))
        panel.pcolormesh(
            cube["slenderness"], _angles(cube), case, cmap=colours, norm=BoundaryNorm(np.arange(5) - 0.5, 4), shading="nearest"
        )
        for number, (_, short) in enumerate(CASES.values()):
            _write(panel, cube, case.values == number, short)
        panel.set_title(title(cube, method))
        tables.append(_numbers(case, largest, method))
    _ring(axes[0, -1], cube, methods)
    for panel in axes[0]:
        panel.set_xlabel("cylinder depth over diameter H/D")
        panel.grid(False)
    axes[0, 0].set_ylabel("half angle of the cone (°)")
    handles = [Patch(color=colour, label=f"{short}  {name}") for name, (colour, short) in CASES.items()]
    handles.append(Patch(facecolor="white", edgecolor="0.6", label=_blank(cube, methods)))
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    figure.suptitle(f"{cube.attrs['title']}\nload case and place of the largest hopper wall pressure")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _blank(cube: xr.Dataset, methods: list[str]) -> str:
    """What a blank place means, with the limits that the methods shown keep; and how ties are told."""
    broken = np.unique(cube["limit_broken"].sel(pressure_method=methods))
    limits = [str(cube["limit"].values[number]).split(" (")[0] for number in broken if number > 0]
    outside = f", or outside the limit {' and '.join(limits)}" if limits else ""
    return f"blank: no initial field, or no mass flow{outside};\nequal pressures count as filling"


def governing(one: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """(number in CASES or NaN, largest pressure in Pa), (half_angle, slenderness); NaN where a phase is masked."""
    pressure = one["hopper_normal_pressure"].sel({"phase": ["filling", "discharge"]})
    pressure = pressure.transpose("half_angle", "slenderness", "phase", "hopper_position")
    whole = pressure.notnull().any("hopper_position").all("phase")
    flat = pressure.fillna(-np.inf).values.reshape(*pressure.shape[:2], -1)
    phase, place = np.divmod(flat.argmax(axis=-1), pressure.sizes["hopper_position"])
    upper = pressure["hopper_position"].values[place] < 0.5
    case = xr.DataArray(2 * phase + upper, dims=("half_angle", "slenderness"))
    return case.where(whole.values), pressure.max(["phase", "hopper_position"]).where(whole)


def _phases(cube: xr.Dataset, method: str) -> list[str]:
    pressure = cube["hopper_normal_pressure"].sel(pressure_method=method)
    return [p for p in ("filling", "discharge") if pressure.sel({"phase": p}).notnull().any()]


def _angles(cube: xr.Dataset) -> np.ndarray:
    return np.degrees(cube["half_angle"].values)


def _write(panel, cube: xr.Dataset, here: np.ndarray, short: str) -> None:
    """The case's letters in the middle of its patch, so that the map reads without colour."""
    where = np.argwhere(here)
    if len(where) > 0.005 * here.size:
        row, column = where[np.argmin(np.abs((where - where.mean(axis=0)) / here.shape).sum(axis=1))]
        panel.text(float(cube["slenderness"][column]), _angles(cube)[row], short, ha="center", va="center", fontsize=9)


def _ring(panel, cube: xr.Dataset, methods: list[str]) -> None:
    """Contours of the ring force in flow over the contents and load of the hopper."""
    with_ring = [m for m in methods if cube["ring_force"].sel(pressure_method=m, phase="discharge").notnull().any()]
    one = cube.sel(pressure_method=with_ring[0], phase="discharge").transpose("half_angle", "slenderness", ...)
    share = 100 * one["ring_force"] / (one["hopper_weight"] + one["transition_force"])
    lines = panel.contour(
        cube["slenderness"], _angles(cube), share, levels=[1, 10, 20, 30, 40, 50, 60, 70, 80], colors="black", linewidths=1
    )
    panel.clabel(lines, fmt="%.0f %%")
    panel.set_title(f"{title(cube, with_ring[0])}:\nring force in flow over contents and load")


def _numbers(case: xr.DataArray, largest: xr.DataArray, method: str) -> pd.DataFrame:
    names = list(CASES)
    table = largest.rename("largest_Pa").drop_vars(["phase", "pressure_method"], errors="ignore").to_dataframe().reset_index()
    table["case"] = [names[int(number)] if number == number else "" for number in case.values.ravel()]
    table["half_angle_deg"] = np.degrees(table["half_angle"])
    return table.assign(pressure_method=method)[
        ["pressure_method", "half_angle_deg", "slenderness", "case", "largest_Pa"]
    ].dropna()
