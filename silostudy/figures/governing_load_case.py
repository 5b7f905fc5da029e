"""Load case with the largest wall pressure in the hopper, over H/D and half angle, and the ring force's share."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch

from silostudy.figures.style import BLUE, ORANGE, SKY, VERMILION, WIDTH, foot, headline, name, save, title

CASES = {
    "filling, lower half of the hopper": (BLUE, "fl"),
    "filling, upper half": (SKY, "fu"),
    "discharge, lower half": (ORANGE, "dl"),
    "discharge, upper half": (VERMILION, "du"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the maps, one a method, and their numbers."""
    methods = [
        m for m in map(str, cube["pressure_method"].values) if cube["hopper_balance"].sel(pressure_method=m).notnull().any()
    ]
    methods = [m for m in methods if set(_phases(cube, m)) == {"filling", "discharge"}]
    figure, axes = plt.subplots(1, len(methods) + 1, figsize=(WIDTH, 5.6), squeeze=False, sharey=True)
    colours = ListedColormap([colour for colour, _ in CASES.values()])
    tables = []
    for panel, method in zip(axes[0], methods, strict=False):
        case, largest = governing(cube.sel(pressure_method=method))
        panel.pcolormesh(
            cube["slenderness"], _angles(cube), case, cmap=colours, norm=BoundaryNorm(np.arange(5) - 0.5, 4), shading="nearest"
        )
        for number, (_, short) in enumerate(CASES.values()):
            _write(panel, cube, case.values == number, short)
        panel.set_title(f"{title(cube, method)}:\nwhat governs")
        tables.append(_numbers(case, largest, method))
    _ring(axes[0, -1], cube, methods)
    for panel in axes[0]:
        panel.set_xlabel("cylinder depth over\ndiameter H/D")
        panel.grid(False)
    axes[0, 0].set_ylabel("half angle of the cone (°)")
    numbers = pd.concat(tables, ignore_index=True)
    handles = [
        Patch(color=colour, label=f"{short}  {case}") for case, (colour, short) in CASES.items() if (numbers.case == case).any()
    ]
    handles.append(Patch(facecolor="white", edgecolor="0.6", label=_blank(cube, methods)))
    headline(figure, _message(cube, numbers))
    foot(figure, f"{cube.attrs['title']}; load case and place of the largest hopper wall pressure", handles=handles)
    save(figure, numbers, stem)


def _message(cube: xr.Dataset, numbers: pd.DataFrame) -> str:
    """Message of the maps, in numbers: the load case that governs most often, method by method."""
    told = []
    for method, cases in numbers.groupby("pressure_method", sort=False).case:
        shares = cases.value_counts(normalize=True)
        told.append(f"{shares.index[0]}, by {name(cube, str(method))} ({100 * shares.iloc[0]:.0f} %)")
    return f"The hopper most often feels its largest pressure in {'; in '.join(told)}"


def _blank(cube: xr.Dataset, methods: list[str]) -> str:
    """Words on a blank place, with the limits that the methods shown keep; and how ties are told."""
    broken = np.unique(cube["limit_broken"].sel(pressure_method=methods))
    limits = [str(cube["limit"].values[number]).split(" (")[0] for number in broken if number > 0]
    outside = f", or outside the limit {' and '.join(limits)}" if limits else ""
    return f"blank: no initial field, or no mass flow{outside}; equal pressures count as filling"


def governing(here: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Number in CASES or NaN, and largest pressure (Pa), each (half_angle, slenderness); NaN where a phase is masked."""
    pressure = here["hopper_normal_pressure"].sel({"phase": ["filling", "discharge"]})
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
        panel.text(float(cube["slenderness"][column]), _angles(cube)[row], short, ha="center", va="center")


def _ring(panel, cube: xr.Dataset, methods: list[str]) -> None:
    """Contours of the ring force in flow over the contents and load of the hopper."""
    with_ring = [m for m in methods if cube["ring_force"].sel(pressure_method=m, phase="discharge").notnull().any()]
    ring = cube.sel(pressure_method=with_ring[0], phase="discharge").transpose("half_angle", "slenderness", ...)
    share = 100 * ring["ring_force"] / (ring["hopper_weight"] + ring["transition_force"])
    lines = panel.contour(
        cube["slenderness"], _angles(cube), share, levels=[1, 10, 20, 30, 40, 50, 60, 70, 80], colors="black", linewidths=1
    )
    panel.clabel(lines, fmt="%.0f %%", fontsize="small")
    panel.set_title(f"{title(cube, with_ring[0])}:\nring force over contents and load")


def _numbers(case: xr.DataArray, largest: xr.DataArray, method: str) -> pd.DataFrame:
    names = list(CASES)
    table = largest.rename("largest_Pa").drop_vars(["phase", "pressure_method"], errors="ignore").to_dataframe().reset_index()
    table["case"] = [names[int(number)] if number == number else "" for number in case.values.ravel()]
    table["half_angle_deg"] = np.degrees(table["half_angle"])
    return table.assign(pressure_method=method)[
        ["pressure_method", "half_angle_deg", "slenderness", "case", "largest_Pa"]
    ].dropna()
