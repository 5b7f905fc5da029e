"""A virtual laboratory as a user writes it: grains and wall, stresses, cells and fillings."""

from itertools import pairwise
from typing import Annotated, Any, Literal, Self

from pydantic import Field, field_validator, model_validator

from silostudy.config.fields import Strict, described
from silostudy.config.laboratory_scenes import LEAST_CELL, AnyLaboratory
from silostudy.config.study import FILLING, SweepStudy
from silostudy.tables.solids import GRAINS

CELL = "cell"  # axis that every laboratory has, beside that of fillings

Stress = Annotated[float, Field(gt=0, le=1e4)]
Width = Annotated[float, Field(ge=LEAST_CELL, le=400)]


class SolidConfig(Strict):
    """The row of the solid: what a study of pressures names it by."""

    key: str = described("key of the row", "", pattern=r"^[a-z][a-z0-9_]*$")
    grain: Literal[GRAINS] = described("what the solid counts as", "")  # type: ignore[valid-type]


class LaboratoryStudy(SweepStudy):
    """Tests of grains in virtual cells: unit weight, lateral pressure ratio, internal friction and wall friction."""

    kind: Literal["laboratory"] = described("laboratory: a bulk solid's properties by tests on its grains", "")
    scene: AnyLaboratory = described("grains and wall", "")
    solid: SolidConfig = described("row of the solid that the tests give", "")
    stresses_kPa: tuple[Stress, ...] = described(
        "normal stresses of all tests, rising: cells are pressed from one to the next, and sheared at each", "kPa", min_length=1
    )
    vertical_kPa: float | None = described(
        "one of the stresses: at which unit weight, K and internal friction enter the row; null: the largest",
        "kPa",
        default=None,
    )
    horizontal_kPa: float | None = described(
        "one of the stresses: at which wall friction enters the row; null: the one that is nearest to half of vertical_kPa",
        "kPa",
        default=None,
    )
    shear_strain: float = described(
        "way of the turning plate, at its mean radius, over the height; of discs, of the lid past the floor",
        gt=0,
        le=10,
        default=0.6,
    )
    cells: tuple[Width, ...] = described("widths of the cells over the mean diameter, rising; the row is the last one's",
                                         min_length=1)  # fmt: skip
    fillings: int = described("fillings of each cell: seeds 0, 1, ...; two at least, for a scatter", ge=2, le=1000)

    @model_validator(mode="before")
    @classmethod
    def _axes_of_its_own(cls, content: Any) -> Any:
        """Cells and fillings are the last axes of the sweep."""
        if not isinstance(content, dict):
            return content
        given, cells, fillings = content.get("sweep", ()), content.get("cells", ()), content.get("fillings")
        if not (_rise(cells) and isinstance(fillings, int) and 0 < fillings <= 1000):
            return content  # the fields themselves say what is wrong
        if not isinstance(given, list | tuple) or any(_named(axis) in (CELL, FILLING) for axis in given):
            return content
        own = [{"axis": CELL, "values": {"cell_grains": list(cells)}},
               {"axis": FILLING, "values": {"seed": list(range(fillings))}}]  # fmt: skip
        return content | {"sweep": [*given, *own]}

    @field_validator("stresses_kPa", "cells")
    @classmethod
    def _rising(cls, values: tuple[float, ...]) -> tuple[float, ...]:
        if not _rise(values):
            raise ValueError("must rise, none twice")
        return values

    @model_validator(mode="after")
    def _sound_stresses(self) -> Self:
        for name in ("vertical_kPa", "horizontal_kPa"):
            value = getattr(self, name)
            if value is not None and value not in self.stresses_kPa:
                raise ValueError(f"{name} = {value:g} must be one of stresses_kPa")
        if [axis.axis for axis in self.sweep[-2:]] != [CELL, FILLING]:
            raise ValueError(f"the axes {CELL} and {FILLING} are the laboratory's own: name others otherwise")
        return self

    @property
    def vertical(self) -> float:
        """Vertical stress (kPa) at which unit weight, lateral pressure ratio and internal friction enter the row."""
        return self.vertical_kPa or self.stresses_kPa[-1]

    @property
    def horizontal(self) -> float:
        """Stress (kPa) on the wall at which wall friction enters the row."""
        return self.horizontal_kPa or min(self.stresses_kPa, key=lambda stress: abs(stress - self.vertical / 2))

    @property
    def settings(self) -> str:
        """Settings that a case's numbers depend on besides its scene: stresses, and how far the shear goes (canonical JSON)."""
        return self.model_dump_json(include={"kind", "stresses_kPa", "shear_strain"})


def _named(axis: Any) -> Any:
    return axis.get("axis") if isinstance(axis, dict) else getattr(axis, "axis", None)


def _rise(values: Any) -> bool:
    """Whether something is a list of numbers, each above the one before."""
    listed = isinstance(values, list | tuple) and values and all(isinstance(value, int | float) for value in values)
    return bool(listed) and all(low < high for low, high in pairwise(values))
