"""Merges the journals of a sweep into its cube, with a bounded memory: failed cases are masked and carry their error."""

import json
from collections.abc import Iterable, Iterator
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from silostudy.choice.expand import expand_file
from silostudy.choice.promise import promises
from silostudy.compute.axes import axis_coordinates, axis_names
from silostudy.config.own import OwnMethods
from silostudy.cube.assemble import Sweep, assemble
from silostudy.cube.contract import variable
from silostudy.cube.variables import attributes, flags
from silostudy.errors import BadInput
from silostudy.files import replacing, seal
from silostudy.sweep.journal import ENDING, failed, sound
from silostudy.sweep.plan import DONE, parts_of, read_plan
from silostudy.sweep.slabs import Slab, write_slabs

PIECE = 1000  # cases that are expanded at once
MEMORY = 256e6  # bytes of cases held at once
OUTCOMES = ("computed", "failed")


class Records:
    """The records of a sweep in the order of its cases, read from the journals part by part."""

    def __init__(self, folder: Path):
        self.folder, plan = folder, read_plan(folder)
        self.parts = list(plan)
        rows = sorted((position, key, number) for number, part in enumerate(plan) for position, key in plan[part])
        self.keys = np.array([key for _, key, _ in rows], "S20")
        self.part = np.array([number for _, _, number in rows], np.int32)

    def of_cases(self, first: int, last: int) -> Iterator[tuple[int, dict[str, Any]]]:
        """Place and record of the cases first ... last - 1, one by one; BadInput in the end where one is missing or damaged."""
        places = {key: k for k, key in enumerate(self.keys[first:last])}
        there = np.zeros(last - first, bool)
        for number in np.unique(self.part[first:last]):
            for key, record in sound(self.folder / f"{self.parts[number]}{ENDING}"):
                place = places.get(key.encode())
                if place is not None:
                    there[place] = True
                    yield place, json.loads(record)
        if missing := int((~there).sum()):
            raise BadInput("parts", str(self.folder), f"{missing} case(s) have no sound record: run the same command again")

    def pattern(self) -> dict[str, tuple[int, ...]]:
        """Names and shapes of a case's numbers, from the first that has any; none where all failed."""
        for part in self.parts:
            for _, record in sound(self.folder / f"{part}{ENDING}"):
                if not failed(record):
                    return {name: np.shape(value) for name, value in json.loads(record)["numbers"].items()}
        return {}


def merge(path: Path, folder: Path, output: Path, memory: float = MEMORY) -> tuple[int, int]:
    """Writes the cube of a sweep; (cases, failed cases).  BadInput where records do not agree in names, shapes or number."""
    expansion = expand_file(path, [])
    study, records = expansion.study, Records(folder)
    if len(records.keys) != prod(expansion.shape):
        raise BadInput("plan", str(folder), f"has {len(records.keys)} case(s) in place of {prod(expansion.shape)}")
    parts = parts_of(study)
    sweep = Sweep(axis_names(study), axis_coordinates(study))
    notes = _promise(path, len(records.keys)) if expansion.asks else {}
    if isinstance(study.scene, OwnMethods):  # a published case names a scene file, which may join rows itself
        notes |= study.scene.own_methods
    coordinates, sources = parts.call("coordinates", study), parts.call("sources", study)
    frame = assemble(study, study.kind, coordinates, sources=sources, notes=notes, sweep=sweep)
    slabs = _slabs(records.pattern(), frame)
    lost: list[tuple[str, str]] = []

    def fill(first: int, last: int) -> dict[str, np.ndarray]:
        arrays = {name: _empty(last - first, slab, frame) for name, slab in slabs.items()}
        for place, record in records.of_cases(first, last):
            _put(arrays, place, record)
            if "error" in record:
                lost.append((record["case"], record["error"]))
        return arrays

    write_slabs(frame, slabs, fill, output, memory=memory)
    _clear(folder, records.parts, parts.stamp)
    _list(lost, output.with_name(f"{output.stem}-failed.csv"))
    return len(records.keys), len(lost)


def _promise(path: Path, count: int) -> dict[str, str]:
    """Accuracies asked for, settings and expected errors of a sweep whose scenes ask for one; read in bounded pieces."""
    pieces = (range(first, min(first + PIECE, count)) for first in range(0, count, PIECE))
    return promises(choice for piece in pieces for choice in expand_file(path, piece).choices)


def _slabs(pattern: dict[str, tuple[int, ...]], frame: xr.Dataset) -> dict[str, Slab]:
    slabs = {"case": Slab(str, (), attributes("case")), "case_error": Slab(str, (), attributes("case_error"))}
    slabs["case_outcome"] = Slab("i1", (), flags(variable("case_outcome").long_name, OUTCOMES))
    for name, shape in pattern.items():
        dims = variable(name).dims[1:]
        if shape != tuple(frame.sizes[dim] for dim in dims):
            raise BadInput(f"shape of {name}", shape, f"must be that of {dims}")
        slabs[name] = Slab("f8", dims, attributes(name))
    return slabs


def _empty(count: int, slab: Slab, frame: xr.Dataset) -> np.ndarray:
    """Room for a variable of some cases: NaN, no text, computed."""
    shape = (count, *(frame.sizes[dim] for dim in slab.dims))
    return np.full(shape, "", object) if slab.kind is str else np.full(shape, np.nan if slab.kind == "f8" else 0, slab.kind)


def _put(columns: dict[str, np.ndarray], place: int, record: dict[str, Any]) -> None:
    """Puts a case into its place; BadInput where it has other numbers than the first."""
    columns["case"][place] = record["case"]
    if "error" in record:
        columns["case_error"][place], columns["case_outcome"][place] = record["error"], OUTCOMES.index("failed")
        return
    numbers, known = record["numbers"], {"case", "case_error", "case_outcome"}
    for name in columns.keys() - known | numbers.keys():
        if name not in numbers or name not in columns or np.shape(numbers[name]) != columns[name].shape[1:]:
            raise BadInput("records", name, "its cases do not all have it in the same shape")
        columns[name][place] = numbers[name]


def _clear(folder: Path, parts: list[str], code: str) -> None:
    """Removes journals that other code wrote: nothing will ever ask for them."""
    for path in folder.glob(f"*{ENDING}"):
        if path.stem not in parts and not path.stem.startswith(code):
            path.unlink()
            path.with_suffix(DONE).unlink(missing_ok=True)


def _list(lost: Iterable[tuple[str, str]], path: Path) -> None:
    """Writes the list of failed cases, empty but for its heading where there are none."""
    import csv

    with replacing(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream).writerows([("case", "error"), *lost])
    seal(path)
