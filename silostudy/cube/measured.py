"""Deviations of the methods of a pressure cube from a measurement, and which of them bracket it."""

from collections.abc import Sequence

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.errors import BadInput
from silostudy.tables.measured import Measurement, measured_pressures

PRESSURE = "wall_normal_pressure"
COLUMNS = ["measurement", "pressure_method", "phase", "measured", "computed", "off"]
FORMULAS = {"1 - sin(phi)": lambda here: 1 - np.sin(float(here["internal_friction_angle"].isel(pressure_method=0)))}


def pressures_measured_in(here: xr.Dataset) -> list[Measurement]:
    """The measured wall pressures of a silo of these very dimensions."""
    return [measurement for measurement in measured_pressures() if _of_this_size(here, measurement)]


def cases_of(cube: xr.Dataset, measurement: Measurement) -> list[int]:
    """Places on the cube's axis `silo` with the solid, the wall and the size that a measurement is answered with.

    What the measurement leaves open (the size, the wall) any case has.  BadInput where the cube holds no such case.
    """
    cases = []
    if not {"silo_solid", "silo_wall"} <= set(cube.coords):
        raise BadInput("sweep", "silo", "the points of this axis must set solid and wall, which the measurements are known by")
    for place in range(cube.sizes["silo"]):
        here = cube.isel(silo=place)
        on_wall = measurement.taken_wall in ("", str(here["silo_wall"].values))
        sized = np.isnan(measurement.diameter) or _of_this_size(here, measurement)
        if str(here["silo_solid"].values) == measurement.taken_solid and on_wall and sized:
            cases.append(place)
    if not cases:
        size = "" if np.isnan(measurement.diameter) else f" of {measurement.diameter:g} m x {measurement.height:g} m"
        wall = f" on {measurement.taken_wall}" if measurement.taken_wall else ""
        raise BadInput(
            "sweep", "silo", f"no point is the silo{size} with {measurement.taken_solid}{wall} of {measurement.measurement}"
        )
    return cases


def _of_this_size(here: xr.Dataset, measurement: Measurement) -> bool:
    sizes = 4 * float(here["hydraulic_radius"]), float(here["cylinder_depth"])
    return bool(np.allclose((measurement.diameter, measurement.height), sizes, rtol=1e-6, atol=0))


def measured_value(here: xr.Dataset, measurement: Measurement) -> float:
    """The measured value (SI): as it stands, or as its formula makes it of the solid that the methods were handed."""
    return FORMULAS[measurement.formula](here) if measurement.formula else measurement.value


def deviations(here: xr.Dataset, measurement: Measurement, methods: Sequence[str]) -> pd.DataFrame:
    """Each method's value in every phase, by how much it is off (1), and which of the measured phase bracket it."""
    rows, measured = [], measured_value(here, measurement)
    for method in methods:
        for phase in map(str, here["phase"].values):
            computed = _computed(here.sel(pressure_method=method, phase=phase), measurement)
            if np.isfinite(computed):
                row = {"measurement": measurement.measurement, "pressure_method": method, "phase": phase}
                rows.append(row | {"measured": measured, "computed": computed, "off": computed / measured - 1})
    table = pd.DataFrame(rows, columns=COLUMNS).sort_values("off", kind="stable", ignore_index=True)
    same = table[table.phase == measurement.phase]
    below, above = same[same.off < 0].off.max(), same[same.off >= 0].off.min()
    bracket = np.where(table.off == below, "next below", np.where(table.off == above, "next above", ""))
    return table.assign(bracket=np.where(table.phase == measurement.phase, bracket, ""))


def neighbour(table: pd.DataFrame, where: str) -> tuple[list[str], float]:
    """Methods, and by how much they are off, next `below` or `above` a measurement; none and NaN where none is."""
    rows = table[table.bracket == f"next {where}"]
    return list(rows.pressure_method), float(rows.off.iloc[0]) if len(rows) else np.nan


def _computed(state: xr.Dataset, measurement: Measurement) -> float:
    """Computed answer to a measurement in one state: a value behind the wall pressure, or a quantity at the measured depth.

    NaN at a depth that the cube does not reach.
    """
    values = state[measurement.answer]
    if "used_for" in values.dims:
        return float(values.sel(used_for=PRESSURE))
    return float(np.interp(measurement.depth, state["depth"].values, values.values, left=np.nan, right=np.nan))


def swelling_over_filling(here: xr.Dataset, swollen: str, filled: str) -> tuple[np.ndarray, np.ndarray]:
    """Depth z/z_o and pressure of the swelling over that of the filled solid (1) of two methods in a case."""
    pressure = here[PRESSURE].sel(phase="filling")
    depth_constant = here["depth_constant"].sel(pressure_method=swollen, phase="filling", used_for=PRESSURE)
    ratio = pressure.sel(pressure_method=swollen) / pressure.sel(pressure_method=filled)
    return here["depth"].values / float(depth_constant), ratio.values


def crossing(depth: np.ndarray, ratio: np.ndarray, value: float) -> float:
    """The depth (as given) at which a ratio that grows with it comes to a value; NaN where it does not."""
    return float(np.interp(value, ratio, depth, left=np.nan, right=np.nan))
