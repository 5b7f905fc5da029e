"""One table of every variable a cube may hold (variables.csv), and the check that a dataset keeps to it."""

import csv
from dataclasses import dataclass
from pathlib import Path

import xarray as xr

from silostudy.errors import BadInput


@dataclass(frozen=True)
class Variable:
    """Name, unit, what it is, and its dimensions; '...' are the sweep axes, 'depth' also a relative depth."""

    name: str
    units: str
    long_name: str
    dims: tuple[str, ...]


def _variables() -> dict[str, Variable]:
    with (Path(__file__).parent / "variables.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {row["name"]: Variable(row["name"], row["units"], row["long_name"], tuple(row["dims"].split())) for row in rows}


VARIABLES = _variables()
# depth is an axis in one study and a field over the axes in another, so its dimensions are free
DEPTH = Variable("depth", "m", "depth below the equivalent flat surface of the stored solid", ())


def check(cube: xr.Dataset) -> xr.Dataset:
    """The cube itself, if every variable is known with its unit and dimensions; BadInput otherwise."""
    axes = cube.attrs.get("sweep_axes", "").split()
    for name in map(str, cube.variables):
        dims, units = tuple(map(str, cube[name].dims)), cube[name].attrs.get("units", "1")
        known = DEPTH if name == "depth" else VARIABLES.get(name.removesuffix("_scope"))
        if known is None or name in axes:
            if not set(dims) <= set(axes):  # coordinates of the sweep axes carry the study's own names
                raise BadInput("variable", name, f"not in the cube's contract; known: {', '.join(VARIABLES)}, depth")
        elif known is not DEPTH and dims != expected_dims(known, cube):
            raise BadInput(f"dimensions of {name}", dims, f"must be {expected_dims(known, cube)}")
        elif units != known.units and not name.endswith("_scope"):
            raise BadInput(f"units of {name}", units, f"must be {known.units}")
    return cube


def expected_dims(variable: Variable, cube: xr.Dataset) -> tuple[str, ...]:
    """The variable's dimensions with '...' replaced by the cube's sweep axes and depth by the cube's kind of depth."""
    filled: list[str] = []
    for dim in variable.dims:
        if dim == "...":
            filled += cube.attrs.get("sweep_axes", "").split()
        else:
            filled.append("relative_depth" if dim == "depth" and "relative_depth" in cube.dims else dim)
    return tuple(filled)
