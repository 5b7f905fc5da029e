"""Observations of a scene of grains beside walls and snapshots: fields in cells, statistics of contacts."""

from math import prod
from typing import Annotated, Self, TypeAlias

from pydantic import Field, model_validator

from silostudy.config.fields import KeyMistake, Strict, described

Cells: TypeAlias = Annotated[int, Field(ge=1, le=1000)]
MOST = 100_000  # cells


class FieldsConfig(Strict):
    """Coarse-grained fields: density, velocity, stress of the grains and force of the walls, at instants."""

    cells: tuple[Cells, ...] = described(
        "cells of the inside of the silo: of spheres along x, y and z, or two in a circular silo, of distance from the axis "
        "and height (averages around the axis); of discs across and up; further ones of their size surround them, where the "
        "kernel reaches beyond the walls",
        min_length=2,
        max_length=3,
    )
    width_mm: float | None = described(
        "width of Lucy's kernel, by which grains and contacts are spread up to twice as far; null: mean diameter of the grains",
        "mm",
        gt=0,
        default=None,
    )
    every_s: float = described("time between readings", "s", gt=0)

    @model_validator(mode="after")
    def _few_enough(self) -> Self:
        if prod(self.cells) > MOST:
            raise KeyMistake("cells", f"must be {MOST} at most together, not {prod(self.cells)}")
        return self


class StatisticsConfig(Strict):
    """Statistics of the contacts at instants: coordination, fabric, share that slides, overlaps, the longest stable step."""

    every_s: float = described("time between readings", "s", gt=0)
