"""Writes and reads cubes: checked, compressed, to a temporary name first, so a half-written file never looks like a result."""

import os
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.cube.contract import check
from silostudy.errors import BadInput


def write(cube: xr.Dataset, path: Path) -> None:
    """Writes a checked cube as netCDF-4 (zlib, shuffle); BadInput where the folder cannot be written."""
    check(cube)
    with replacing(path) as temporary:
        cube.to_netcdf(temporary, encoding={str(name): _encoding(cube[name]) for name in cube.variables})


def _encoding(variable: xr.DataArray) -> dict:
    """Compression, and chunks of one position of the sweep axes so that a case reads in one piece."""
    encoding: dict = {"_FillValue": np.nan if variable.dtype.kind == "f" and _may_be_masked(variable) else None}
    if variable.dtype.kind in "fib" and variable.size > 1:
        own = ("method", "phase", "depth", "relative_depth")
        chunks = tuple(size if dim in own else 1 for dim, size in zip(variable.dims, variable.shape, strict=True))
        encoding |= {"zlib": True, "complevel": 4, "shuffle": True}
        if variable.size > 1_000_000 // 8 or np.prod(chunks) > 256:
            encoding["chunksizes"] = chunks
    return encoding


def _may_be_masked(variable: xr.DataArray) -> bool:
    return variable.name not in variable.coords  # CF: coordinates must not hold missing values


class replacing:
    """A temporary file beside `path` that takes its name only when the block ends without an error."""

    def __init__(self, path: Path):
        self.path = path

    def __enter__(self) -> Path:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            handle, name = tempfile.mkstemp(prefix=f".{self.path.name}.", suffix=self.path.suffix, dir=self.path.parent)
        except OSError as error:
            raise BadInput("results folder", str(self.path.parent), f"cannot be written ({error.strerror})") from None
        os.close(handle)
        self.temporary = Path(name)
        return self.temporary

    def __exit__(self, kind, error, trace) -> None:
        if kind is None:
            os.chmod(self.temporary, 0o666 & ~_umask())
            self.temporary.replace(self.path)
        else:
            self.temporary.unlink(missing_ok=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def read(path: Path) -> xr.Dataset:
    """A checked cube, loaded into memory; BadInput where the file is no cube."""
    try:
        with xr.open_dataset(path) as cube:
            return check(cube.load())
    except (OSError, ValueError) as error:
        if isinstance(error, BadInput):
            raise
        raise BadInput("cube", str(path), f"must be a netCDF file of this package ({error})") from None
