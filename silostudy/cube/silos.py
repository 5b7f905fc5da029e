"""The silos of a cube: cases that differ in the end of the wall friction alone are one silo in two states."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray as xr

END = "wall_friction_end"


def named(cases: np.ndarray, axes: Sequence[str]) -> list[str]:
    """The case that names each silo, of the cases' ids along some axes: the first of its ends."""
    first = np.take(cases, 0, axis=list(axes).index(END)) if END in axes else cases
    return [str(case) for case in np.ravel(first)]


def silos(cube: "xr.Dataset") -> list[str]:
    """The case that names each silo of a cube."""
    return named(cube["case"].values, [str(dim) for dim in cube["case"].dims])


def at_silo(cube: "xr.Dataset", case: str) -> "xr.Dataset":
    """The part of a cube of the silo that a case names, the ends of its wall friction still in it."""
    where = (cube["case"] == case).values.nonzero() if cube["case"].dims else ()
    return cube.isel({dim: int(index[0]) for dim, index in zip(cube["case"].dims, where, strict=True) if dim != END})
