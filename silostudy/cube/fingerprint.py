"""Whether a file of results is what was written: byte by byte, or a cube of other attributes that still holds its data."""

import hashlib
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

from silostudy.cube.trial import flaw
from silostudy.files import as_written, held_when_written

PIECE = 100_000  # values read at once


def damaged(paths: Iterable[Path]) -> list[Path]:
    """Files that are not what was written, with a word on each; a cube whose attributes alone changed is kept, with a word."""
    broken = []
    for path in paths:
        if as_written(path):
            continue
        if holds_its_data(path):
            print(f"silostudy: {path} was edited, and its data are what was written: kept", file=sys.stderr)
        else:
            print(f"silostudy: {path} is damaged: a run moves it to {path.name}.damaged and makes it again", file=sys.stderr)
            broken.append(path)
    return broken


def holds_its_data(path: Path) -> bool:
    """Whether a cube opens and every variable holds what was written, whatever its attributes say."""
    if flaw(path):
        return False
    try:
        return fingerprint(path) == held_when_written(path)
    except (OSError, RuntimeError, ValueError, AttributeError):  # what netCDF4 raises for broken files
        return False


def fingerprint(path: Path) -> str:
    """Digest of names, dimensions and values of all variables of a netCDF file, read in bounded pieces."""
    import netCDF4

    digest = hashlib.sha256()
    with netCDF4.Dataset(path.absolute()) as file:
        file.set_auto_maskandscale(False)
        for name in sorted(file.variables):
            variable = file[name]
            digest.update(f"{name}{variable.dimensions}{variable.shape}{variable.dtype}".encode())
            for place in _pieces(variable):
                values = np.asarray(variable[place])
                if values.dtype == object:
                    digest.update("\0".join(map(str, values.flat)).encode())
                else:
                    digest.update(np.ascontiguousarray(values).data)  # its bytes, not a copy of them
    return digest.hexdigest()


def _pieces(variable) -> Iterator[tuple]:
    """Places that make up a variable: slices of whole compressed chunks along the axis that has most of them."""
    shape, chunks = variable.shape, variable.chunking()
    if variable.size <= PIECE or chunks == "contiguous":
        yield (...,)
        return
    variable.set_var_chunk_cache(size=0)  # pieces are whole chunks: none is needed twice
    axis = max(range(len(shape)), key=lambda k: shape[k] / chunks[k])
    across = variable.size // shape[axis]
    step = max(1, PIECE // across // chunks[axis]) * chunks[axis]
    for start in range(0, shape[axis], step):
        yield (*[slice(None)] * axis, slice(start, start + step))
