"""Command `silostudy note`: the calculation note of a silo, from a study file, as an HTML page that prints from any browser."""

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr


def add(sub) -> None:
    command = sub.add_parser(
        "note", help="write the calculation note of a silo: every formula with its numbers, loads, checks (HTML that prints)"
    )
    command.add_argument("study", type=Path, help="study file of kind shell with checks, or of kind pressure: loads alone")
    command.add_argument("--case", metavar="ID", help="the silo, where the study has several; see `silostudy cases`")
    command.add_argument("--output", type=Path, metavar="FILE", help="left out: note-STUDY-CASE.html here")
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.choice.expand import expand_file
    from silostudy.commands.studies import path_of
    from silostudy.files import replacing
    from silostudy.note.page import page

    expansion = expand_file(path_of(chosen.study))
    _check_kind(expansion, str(chosen.study))
    case = case_of(expansion, chosen.case)
    pressure, checks = _cubes(expansion)
    path = chosen.output or Path(f"note-{expansion.name}-{case}.html")
    with replacing(path) as temporary:
        temporary.write_text(page(pressure, checks, case), encoding="utf-8")
    told = "" if checks is not None else " (loads alone: the study has no section checks)"
    print(f"{expansion.name}, case {case}: {path}{told}")


def _check_kind(expansion, where: str) -> None:
    """BadInput for a study that computes no pressures."""
    from silostudy.errors import BadInput
    from silostudy.stages import KINDS
    from silostudy.stages.pressure import PRESSURES

    known = ", ".join(kind.key for kind in KINDS.values() if PRESSURES in kind.stages)
    if PRESSURES not in KINDS[expansion.study.kind].stages:
        raise BadInput("kind", expansion.study.kind, f"has no silo under pressure; a note is of a study of kind {known}", where)


def case_of(expansion, asked: str | None) -> str:
    """The case that names the silo asked for, either end of whose wall friction may be named; the only one by default."""
    import numpy as np

    from silostudy.cube.silos import named
    from silostudy.errors import BadInput

    axes = [axis.axis for axis in expansion.study.sweep]
    ids = np.array([case.id for case in expansion.cases]).reshape(expansion.shape)
    silos = named(ids, axes)
    if asked is None and len(silos) == 1:
        return silos[0]
    if asked in silos:
        return asked
    if asked is not None and asked in ids.ravel():
        return silos[silos.index(_first_end(ids, axes, asked))]
    told = ", ".join(silos[:8]) + (f" and {len(silos) - 8} more (`silostudy cases`)" if len(silos) > 8 else "")
    missing = f"is missing, and the study has {len(silos)} silos: " if asked is None else ""
    raise BadInput("--case", asked, f"{missing}must be one of {told}", expansion.name)


def _first_end(ids, axes: list[str], asked: str) -> str:
    """The first end of the wall friction of the silo that a case is an end of."""
    from silostudy.cube.silos import END

    place = [int(index[0]) for index in (ids == asked).nonzero()]
    place[axes.index(END)] = 0
    return str(ids[tuple(place)])


def _cubes(expansion) -> "tuple[xr.Dataset, xr.Dataset | None]":
    """The cubes of the pressures, and of the checks where the study asks for them."""
    from silostudy.compute.pressure import pressure_cube

    pressure = pressure_cube(expansion)
    if getattr(expansion.study, "checks", None) is None:
        return pressure, None
    from silostudy.commands.compare_steel import shaken_cube
    from silostudy.compute.checks import checks_cube

    return pressure, checks_cube(expansion, pressure, shaken_cube(expansion))
