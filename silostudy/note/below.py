"""The chapters of the note on hopper and supports: a table of all checks, and of each part the one that governs in full."""

from collections.abc import Iterator

import numpy as np
import xarray as xr

from silostudy.note.lines import Scope, Written, every_line, write
from silostudy.note.loads import Block
from silostudy.note.uses import Use, at_end, told_of, uses_of_part, why_of_part


def blocks(cube: xr.Dataset, pressure: xr.Dataset, scope: Scope, part: str) -> Iterator[Block]:
    """A table of all checks of hopper or support, then of each part the one by which it is used most, in full."""
    uses = uses_of_part(cube, part)
    known = [use for use in uses if np.isfinite(use.utilisation)]
    names = (use.key.replace("_", " ") for use in uses)
    rows = tuple(
        (name, use.told, use.combination or why_of_part(cube, part, use.key)) for name, use in zip(names, uses, strict=True)
    )
    strong = tuple(uses.index(use) for use in leading(known))
    head = ("check", "utilisation", "combination")
    yield Block("All checks; in bold what governs a part", head=head, rows=rows, strong=strong, wordy=True)
    for use in leading(known):
        heading = f"{use.key.replace('_', ' ').capitalize()}, combination {use.combination}"
        yield Block(heading, tuple(part_in_full(cube, pressure, scope, part, use)), texts=told_of(use.key))


def part_in_full(cube: xr.Dataset, pressure: xr.Dataset, scope: Scope, part: str, use: Use) -> list[Written]:
    """The lines of a check of hopper or support where it is used most."""
    here = at_end(cube, use.where["end"]).sel({f"{part}_check": use.key, "combination": use.combination})
    if part != "hopper":
        return write("support", scope.reading(here), use.key)
    place = {"hopper_position": use.where["place"]}
    normal = at_end(pressure, use.where["end"]).isel(place)
    phase = int(normal["hopper_normal_pressure"].argmax("phase"))
    return write("hopper check", scope.reading(here.isel(place), normal.isel(phase=phase)), use.key)


def leading(uses: list[Use]) -> list[Use]:
    """The checks by which a part is used most, of those that share lines."""
    first_uses: list[Use] = []
    for use in sorted(uses, key=lambda use: -use.utilisation):
        if not any(_share(use.key, other.key) for other in first_uses):
            first_uses.append(use)
    return first_uses


def _share(first: str, second: str) -> bool:
    """Whether two checks have a line together, or lines in a section whose other lines are of every check."""
    owners = [(line.section, set(line.owner)) for line in every_line()]
    sections = [{section for section, owner in owners if key in owner} for key in (first, second)]
    common = {section for section, owner in owners if not owner}
    return any({first, second} <= owner for _, owner in owners) or bool(sections[0] & sections[1] & common)
