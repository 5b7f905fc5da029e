"""Files that a discrete-element scene names: the discs of an earlier run or another program, and the shaking of the box."""

from pathlib import Path

import numpy as np

from silostudy.cube.netcdf import opened
from silostudy.errors import BadInput
from silostudy.packing.given import place
from silostudy.tables.columns import equal_steps, read_columns

QUAKE = ("time_s", "x_m_s2", "y_m_s2")
STRONGEST = 1e6  # m s-2: beyond, no acceleration
GIVEN = ("disc_x", "disc_y", "disc_radius")


def given_discs(file: str, folder: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """x, y and radius (m) of the discs in a netCDF file, those of its last snapshot; BadInput names the file and what is wrong.

    Discs that have left an earlier run have no place (NaN in all they have) and are left out.
    """
    held = opened(folder / file, "packing.file")
    missing = [name for name in GIVEN if name not in held]
    if missing:
        raise BadInput("packing.file", file, f"must hold {', '.join(GIVEN)}; {', '.join(missing)} is missing")
    x, y, radius = (_metres(held[name], file) for name in GIVEN)
    radius = np.full_like(x, radius) if radius.ndim == 0 else radius
    if not x.shape == y.shape == radius.shape or x.ndim != 1:
        raise BadInput("packing.file", file, f"must have an x, y and radius a disc, not {x.shape}, {y.shape}, {radius.shape}")
    left = ~(np.isnan(x) & np.isnan(y))
    x, y, radius = x[left], y[left], radius[left]
    wrong = np.flatnonzero(~(np.isfinite(x) & np.isfinite(y) & np.isfinite(radius) & (radius > 0)))
    if len(wrong) or not len(x):
        first = np.flatnonzero(left)[wrong[0]] if len(wrong) else None
        told = "holds no disc" if first is None else f"disc {first} must have finite places and a positive finite radius"
        raise BadInput("packing.file", file, told)
    return place(x=x, y=y, radius=radius)


def _metres(variable, file: str) -> np.ndarray:
    """The values of a length, of the last snapshot where there are several."""
    unit = variable.attrs.get("units", "m")
    if unit not in ("m", "metre", "meter", "metres", "meters"):
        raise BadInput("packing.file", file, f"{variable.name} must be in m, and the file says {unit}")
    last = {"snapshot": -1} if variable.sizes.get("snapshot") else {}
    if variable.dtype.kind not in "fiu":
        raise BadInput("packing.file", file, f"{variable.name} must hold numbers, not {variable.dtype}")
    return variable.isel(last).to_numpy().astype(float)


def quake_steps(file: str, folder: Path, *, dt: float, limit: float) -> np.ndarray:
    """Acceleration (m s-2) of the box at every step, across and up, between the points of its record; none beyond its ends."""
    path = folder / file
    columns = read_columns(path, QUAKE)
    if sorted(columns.head) != sorted(QUAKE):
        raise BadInput("quake.file", file, f"must begin with the names of its columns, {', '.join(QUAKE)}", str(path))
    places = [columns.head.index(name) for name in QUAKE]
    start, step = equal_steps(columns, places[0])
    ways = [columns.column(name, place) for name, place in zip(QUAKE[1:], places[1:], strict=True)]
    strongest = float(max(np.abs(way).max() for way in ways))
    if strongest > STRONGEST:
        raise BadInput("quake.file", strongest, f"must be at most {STRONGEST:g} m/s2", str(path))
    if start > limit:
        raise BadInput("quake.file", start, f"must begin before the run ends, at {limit:g} s", str(path))
    time = start + step * np.arange(len(columns.cells))
    steps = np.arange(int(max(min(time[-1], limit), 0.0) / dt) + 2) * dt
    return np.column_stack([np.interp(steps, time, way, left=0.0, right=0.0) for way in ways])
