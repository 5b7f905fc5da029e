"""How every figure looks and is saved: PNG, SVG that is the same each time, and the numbers shown as CSV."""

from pathlib import Path
from textwrap import fill

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from silostudy.cube.silence import silences
from silostudy.files import replacing

plt.rcParams.update(
    {
        "svg.hashsalt": "silostudy",
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.alpha": 0.25,
        "legend.frameon": False,
        "figure.constrained_layout.use": True,
    }
)
AID = "aid"  # gid of what helps the eye and shows no number of the table: the outline of a silo, a bar of scale
PHASE_LINES = {"switch": (0, (1, 1)), "filling": (0, (4, 2)), "discharge": "-"}


def save(figure: Figure, numbers: pd.DataFrame, stem: Path) -> None:
    """Writes stem.png, stem.svg and stem.csv, each under a temporary name first."""
    for suffix, options in ((".png", {"dpi": 160}), (".svg", {"metadata": {"Date": None}})):
        with replacing(stem.with_suffix(suffix)) as temporary:
            figure.savefig(temporary, **options)
    plt.close(figure)
    save_table(numbers, stem.with_suffix(".csv"))


def save_table(numbers: pd.DataFrame, path: Path) -> None:
    """Writes a table as CSV, seven significant digits."""
    with replacing(path) as temporary:
        numbers.to_csv(temporary, index=False, float_format="%.7g")


def look(cube: xr.Dataset, method: str) -> dict:
    """Colour and marker of a method, as line properties."""
    one = cube.sel(pressure_method=method)
    return {"color": str(one.pressure_method_colour.values), "marker": str(one.pressure_method_marker.values)}


def title(cube: xr.Dataset, method: str) -> str:
    """Number and name of a method for a legend."""
    one = cube.sel(pressure_method=method)
    number = str(one.pressure_method_number.values)
    return f"{number}  {one.pressure_method_title.values}" if number else str(one.pressure_method_title.values)


def drawn(cube: xr.Dataset, method: str) -> str:
    """How a figure that compares many methods shows one, as its row says."""
    return str(cube["pressure_method_drawn"].sel(pressure_method=method).values)


def phases_of_its_own(cube: xr.Dataset, method: str, static: str) -> list[str]:
    """Phases with a curve of their own: Jenike's filling, and all of 1969, are the static method's."""
    pressure = cube["wall_normal_pressure"]
    filling = pressure.sel(pressure_method=static, phase="filling")
    shown = []
    for phase in map(str, cube["phase"].values):
        one = pressure.sel(pressure_method=method, phase=phase)
        same = method != static and np.allclose(one, filling, rtol=1e-12, atol=0)
        if one.notnull().any() and not same:
            shown.append(phase)
    return shown


def silent(cube: xr.Dataset, *, in_every_case: bool = True) -> list[Patch]:
    """Entries of a legend, without a mark, for the methods that give nothing in every case, or in some: why not."""
    lines = silences(cube, in_every_case=in_every_case, titles=True)
    return [Patch(alpha=0.0, label=fill(line, 60)) for line in lines]
