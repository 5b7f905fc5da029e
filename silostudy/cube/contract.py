"""One table of every variable a cube may hold (variables.csv), and the check that a dataset keeps to it.

Of scenes of spheres some have another unit and long name under the same name (in_space.csv).
"""

import csv
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import xarray as xr

from silostudy.errors import BadInput

SPHERES = "grain"  # dimension of cubes of scenes of spheres
SCOPE = "_scope"  # ending of the flags that say why values of a variable are masked


@dataclass(frozen=True)
class Variable:
    """Name, unit, what it is, its dimensions ('...' are the sweep axes, 'depth' also a relative depth), and its role.

    role: a `coordinate` labels dimensions, `data` are everything else.
    """

    name: str
    units: str
    long_name: str
    dims: tuple[str, ...]
    role: str

    def dims_in(self, axes: Sequence[str], *, relative: bool) -> tuple[str, ...]:
        """Dimensions in a cube of these sweep axes, over relative depths or over depths; of an own dimension only that."""
        filled: list[str] = []
        for dim in self.dims:
            filled += axes if dim == "..." else ["relative_depth" if dim == "depth" and relative else dim]
        return (self.name,) if self.name in filled else tuple(filled)


def _rows(table: str) -> list[dict[str, str]]:
    with (Path(__file__).parent / table).open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def _variables() -> dict[str, Variable]:
    rows = _rows("variables.csv")
    return {row["name"]: Variable(**{**row, "dims": tuple(row["dims"].split())}) for row in rows}  # type: ignore[arg-type]


def _in_space() -> dict[str, Variable]:
    """Variables with what is other of them in space; an empty long name is that of the plane."""
    return {
        row["name"]: replace(known := VARIABLES[row["name"]], units=row["units"], long_name=row["long_name"] or known.long_name)
        for row in _rows("in_space.csv")
    }


VARIABLES = _variables()
IN_SPACE = _in_space()


def variable(name: str, beside: Iterable = ()) -> Variable:
    """The row of a variable, or of the one that it is the scope of; BadInput where there is none.

    beside: names of what stands in the cube, which tell whether it is of spheres.
    """
    own = name.removesuffix(SCOPE)
    known = IN_SPACE.get(own) if SPHERES in beside else None
    known = known or VARIABLES.get(own)
    if known is None:
        raise BadInput("variable", name, f"not in the cube's contract; known: {', '.join(VARIABLES)}")
    return known


def check(cube: xr.Dataset) -> xr.Dataset:
    """The cube itself, if every variable has its unit, dimensions and role and every dimension is labelled; else BadInput."""
    axes = cube.attrs.get("sweep_axes", "").split()
    for name in map(str, cube.variables):
        if not _of_an_axis(cube[name], axes):  # coordinates of the sweep axes carry the study's own names
            _check_variable(cube, name, axes)
    for dim in map(str, cube.dims):
        if not any(_labels(coordinate, dim, axes) for coordinate in cube.coords.values()):
            raise BadInput("dimension", dim, "has no coordinate that labels it")
    return cube


def _of_an_axis(array: xr.DataArray, axes: list[str]) -> bool:
    """Whether a variable is an axis' own coordinate, or one that hangs beside it where several keys change together."""
    name, along = str(array.name), [str(dim) for dim in array.dims]
    return name in axes or (len(along) == 1 and along[0] in axes and name.startswith(f"{along[0]}_") and name in array.coords)


def _labels(coordinate: xr.DataArray, dim: str, axes: list[str]) -> bool:
    return coordinate.dims == (dim,) or set(coordinate.dims) - set(axes) == {dim}


def _check_variable(cube: xr.Dataset, name: str, axes: list[str]) -> None:
    known, array = variable(name, cube.dims), cube[name]
    expected = known.dims_in(axes, relative="relative_depth" in cube.dims)
    role = "coordinate" if name in cube.coords else "data"
    if array.dims != expected:
        raise BadInput(f"dimensions of {name}", array.dims, f"must be {expected}")
    if name.endswith(SCOPE):
        return
    if array.attrs.get("units", "1") != known.units:
        raise BadInput(f"units of {name}", array.attrs["units"], f"must be {known.units}")
    if role != known.role:
        raise BadInput(f"role of {name}", role, f"must be {known.role}")
