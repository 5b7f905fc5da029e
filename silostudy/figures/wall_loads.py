"""Every load case of the contents as a field: pressure and friction on wall and hopper over depth and angle."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.load import Load, given_cases, load_case, of_case
from silostudy.figures.style import WIDTH, foot, headline, save

# of the table
STEP = np.radians(10.0)  # rad, where a load waves round the wall
LEVELS = 51  # on wall and hopper
SHOWN = {"normal_kPa": "normal pressure (kPa)", "friction_kPa": "friction (kPa)"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the maps of the first silo, with the set of the wall pressure, and the table of all silos and sets."""
    silos = [None] if not cube.attrs["sweep_axes"] else list(map(str, cube["case"].values.ravel()))
    save(_figure(cube, silos[0]), pd.concat([table(cube, silo) for silo in silos], ignore_index=True), stem)


def table(cube: xr.Dataset, silo: str | None) -> pd.DataFrame:
    """Pressure and friction (kPa) over depth and angle of every load case and set of a silo; an edge stands on both sides."""
    given = given_cases(of_case(cube, silo))
    tables = [
        pd.DataFrame({"case": silo or "", "load_case": key, "values": values} | _numbers(load_case(cube, key, values, silo)))
        for key, sets in given.items()
        for values in sets
    ]
    return pd.concat(tables, ignore_index=True)


def _numbers(load: Load) -> dict[str, np.ndarray]:
    return load.columns(levels=LEVELS, step=STEP)


def _figure(cube: xr.Dataset, silo: str | None):
    """A column for each load case: normal pressure above, friction below."""
    loads = of_case(cube, silo)
    given = {key: sets[0] for key, sets in given_cases(loads).items()}
    figure, axes = plt.subplots(2, len(given), figsize=(WIDTH, 7.6), sharex=True, sharey=True, squeeze=False)
    peaks: dict[str, float] = {}
    for row, (name, label) in zip(axes, SHOWN.items(), strict=True):
        fields = {key: _field(load_case(cube, key, values, silo), name) for key, values in given.items()}
        largest = max(float(values.max()) for _, _, values in fields.values())
        peaks = peaks or {key: float(values.max()) for key, (_, _, values) in fields.items()}  # of the first row, the pressure
        least = min(0.0, *(float(values.min()) for _, _, values in fields.values()))
        for panel, (angles, depths, values) in zip(row, fields.values(), strict=True):
            mesh = panel.pcolormesh(
                angles, depths, values, shading="gouraud", cmap="viridis", vmin=least, vmax=largest, rasterized=True
            )
            panel.axhline(float(loads["load_transition_depth"]), color="white", linewidth=0.8)
        figure.colorbar(mesh, ax=row, label=label)
        row[0].set_ylabel("depth z (m)")
    for panel, key in zip(axes[0], given, strict=True):
        panel.set_title(fill(_title(loads, key), 14), fontsize="small")
    for panel in axes[1]:
        panel.set(xlabel="angle (°)", xticks=(0, 180))
    axes[0, 0].set_ylim(float(loads["load_depth"].max()), 0)
    headline(figure, _message(loads, peaks))
    foot(figure, f"{cube.attrs['title']}; {_said(given, silo)}")
    return figure


def _title(loads: xr.Dataset, key: str) -> str:
    return str(loads["load_case_title"].sel(load_case=key).values)


def _message(loads: xr.Dataset, peaks: dict[str, float]) -> str:
    """Message of the maps, in numbers: the load case with the largest normal pressure (kPa), over the least of their peaks."""
    most, least = max(peaks, key=peaks.__getitem__), min(peaks, key=peaks.__getitem__)
    if peaks[most] < 1.005 * peaks[least]:
        return f"The largest normal pressure is {peaks[most]:.0f} kPa in every load case"
    return (
        f"The largest normal pressure is {peaks[most]:.0f} kPa in {_title(loads, most)}:"
        f" {peaks[most] / peaks[least]:.1f} times the largest in {_title(loads, least)}"
    )


def _said(given: dict[str, str], silo: str | None) -> str:
    told = f"characteristic values of the set {', '.join(dict.fromkeys(given.values()))}; white line: transition"
    return told + (f"; case {silo}" if silo else "")


def _field(load: Load, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Angles (deg), depths (m) and values on the load's grid."""
    depths, angles = load.grid(levels=LEVELS, step=STEP)
    return np.degrees(angles), depths, _numbers(load)[name].reshape(depths.size, angles.size)
