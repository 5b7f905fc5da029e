"""Writes a cube too large for memory: a block of the sweep axes at a time, to a temporary name first."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import xarray as xr

from silostudy.cube.contract import check, variable
from silostudy.cube.fingerprint import fingerprint
from silostudy.files import replacing

TEXT = 100  # bytes of a short text in memory
CHUNK = 65_536  # values of a variable in one compressed piece of the file


@dataclass(frozen=True)
class Slab:
    """A variable to come: its type, its dimensions besides the sweep axes, and its attributes."""

    kind: Any
    dims: tuple[str, ...]
    attributes: dict[str, Any]


Fill = Callable[[int, int], dict[str, np.ndarray]]


def write_slabs(frame: xr.Dataset, slabs: dict[str, Slab], fill: Fill, path: Path, *, memory: float) -> None:
    """Writes `frame` (coordinates, attributes) with the slabs' variables over its sweep axes.

    fill(first, last) gives each variable for the cases first ... last - 1, counted with the last axis fastest; it is asked
    for as many cases at once as `memory` (bytes) allows.  BadInput where the contract is not kept.
    """
    axes = frame.attrs["sweep_axes"].split()
    shape = tuple(frame.sizes[axis] for axis in axes)
    labels = _labels(frame, slabs)
    own = {name: tuple(frame.sizes[dim] for dim in slab.dims) for name, slab in slabs.items()}
    chunk = extents(shape, max(1, CHUNK // max(map(prod, own.values()))))
    whole = sum(TEXT if slabs[name].kind is str else 8 * prod(sizes) for name, sizes in own.items())
    with replacing(path, held=fingerprint) as temporary:
        frame.to_netcdf(temporary, encoding={str(name): {"_FillValue": None} for name in frame.variables})
        with netCDF4.Dataset(temporary.absolute(), "a") as file:
            for name, slab in slabs.items():
                _add(file, name, slab, (*axes, *slab.dims), (*chunk, *own[name]))
                if labels and name not in labels:
                    file[name].coordinates = " ".join(labels)
            for first, last, place in blocks(shape, chunk, max(1, int(memory // whole))):
                for name, values in fill(first, last).items():
                    extent = tuple(len(range(*part.indices(size))) for part, size in zip(place, shape, strict=True))
                    file[name][(*place, ...)] = values.reshape(*extent, *own[name])
        with xr.open_dataset(temporary) as written:
            check(written)


def _labels(frame: xr.Dataset, slabs: dict[str, Slab]) -> list[str]:
    """Names of the coordinates over sweep axes that are no axis' own: every slab holds for them."""
    hanging = [str(name) for name in frame.coords if name not in frame.dims]
    return hanging + [name for name in slabs if variable(name).role == "coordinate"]


def _add(file: netCDF4.Dataset, name: str, slab: Slab, dims: tuple[str, ...], chunk: tuple[int, ...]) -> None:
    packed: dict[str, Any] = {"compression": "zlib", "complevel": 4, "shuffle": True, "chunksizes": chunk}
    if slab.kind is str or not dims:
        packed = {}
    variable = file.createVariable(name, slab.kind, dims, fill_value=np.nan if slab.kind == "f8" else None, **packed)
    if packed:
        variable.set_var_chunk_cache(size=4 * 8 * CHUNK)  # blocks are whole pieces: none is needed twice
    variable.setncatts(slab.attributes)


def extents(shape: Sequence[int], count: int) -> tuple[int, ...]:
    """Lengths along each axis of a piece of at most `count` cases: whole trailing axes, then a part of the one before."""
    sizes: list[int] = []
    for size in reversed(shape):
        sizes.append(max(1, min(size, count)))
        count = count // size if count >= size else 1
    return tuple(reversed(sizes))


def blocks(shape: Sequence[int], chunk: Sequence[int], count: int) -> Iterator[tuple[int, int, tuple[slice, ...]]]:
    """First case, the one past the last, and slices of blocks of about `count` cases, each of whole chunks."""
    if not shape:
        yield 0, 1, ()
        return
    reach = extents(shape, max(count, prod(chunk)))
    axis = next((k for k, size in enumerate(reach) if size > 1), len(shape) - 1)
    step, below = max(chunk[axis], reach[axis] // chunk[axis] * chunk[axis]), prod(shape[axis + 1 :])
    for lead in np.ndindex(*shape[:axis]):
        base = int(np.ravel_multi_index(lead, shape[:axis])) * shape[axis] if lead else 0
        for start in range(0, shape[axis], step):
            stop = min(start + step, shape[axis])
            place = (*(slice(k, k + 1) for k in lead), slice(start, stop), *(slice(0, size) for size in shape[axis + 1 :]))
            yield (base + start) * below, (base + stop) * below, place
