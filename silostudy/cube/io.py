"""Writes and reads cubes: checked, compressed, to a temporary name first, so a half-written file never looks like a result."""

from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.cube.contract import check
from silostudy.cube.fingerprint import fingerprint
from silostudy.cube.netcdf import opened
from silostudy.cube.provenance import CONTRACT, CONTRACTS, OF_STAGES
from silostudy.errors import BadInput
from silostudy.files import replacing

SAID = ("title", "source", "references", "study", "study_hash", "sweep_axes")  # in words, of every cube


def changed_since(contract: str, stage: str) -> str:
    """Changes in cubes of a stage since a contract, in words; none where it has the same names and dimensions now."""
    if not contract.isdecimal() or int(contract) not in CONTRACTS:
        return "which this version does not know"
    later = {number: what for number, what in CONTRACTS.items() if number > int(contract)}
    return "; ".join(f"since {number} {what}" for number, what in later.items() if stage in OF_STAGES.get(number, (stage,)))


def write(cube: xr.Dataset, path: Path) -> None:
    """Writes a checked cube as netCDF-4 (zlib, shuffle); BadInput where the folder cannot be written."""
    check(cube)
    with replacing(path, held=fingerprint) as temporary:
        axes = cube.attrs.get("sweep_axes", "").split()
        cube.to_netcdf(temporary, encoding={str(name): _encoding(cube[name], axes) for name in cube.variables})


def _encoding(variable: xr.DataArray, axes: list[str]) -> dict:
    """Compression, and chunks of one position of the sweep axes so that a case reads in one piece."""
    encoding: dict = {"_FillValue": np.nan if variable.dtype.kind == "f" and _may_be_masked(variable) else None}
    if variable.dtype.kind in "fib" and variable.size > 1:
        chunks = tuple(1 if dim in axes else size for dim, size in zip(variable.dims, variable.shape, strict=True))
        encoding |= {"zlib": True, "complevel": 4, "shuffle": True}
        if variable.size > 1_000_000 // 8 or np.prod(chunks) > 256:
            encoding["chunksizes"] = chunks
    return encoding


def _may_be_masked(variable: xr.DataArray) -> bool:
    """Whether values may be missing: in data, and in a label that has no value everywhere; CF forbids it in an axis' own."""
    return variable.name not in variable.coords or (variable.name not in variable.dims and bool(variable.isnull().any()))


def read(path: Path) -> xr.Dataset:
    """A checked cube, loaded into memory; BadInput where the file is no cube, or one of another contract."""
    cube = opened(path, "cube")
    lost = [name for name in SAID if not isinstance(cube.attrs.get(name), str)]
    if lost or not cube.attrs["source"].startswith("silostudy"):
        raise BadInput("cube", str(path), f"must be a file of this package: it does not say its {', '.join(lost) or 'source'}")
    contract = str(cube.attrs.get("cube_contract", 1))
    if changed := changed_since(contract, str(cube.attrs.get("stage"))):
        told = f"was written by {cube.attrs['source']} with names and dimensions of contract {contract}, and not {CONTRACT}"
        raise BadInput("cube", str(path), f"{told} ({changed}): compute it again")
    try:
        return check(cube)
    except BadInput as error:
        raise BadInput(error.field, error.value, error.allowed, str(path)) from None
