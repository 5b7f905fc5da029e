"""Cautions on scenes of grains: values that are possible, and beyond what is known of grains and walls."""

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import BaseModel

from silostudy.scene.laboratory_cell_discs import DiscCase

HIGH_FRICTION = 1.5  # beyond any row of this package's tables, whose largest is below 1
FRICTIONS = ("sliding_friction", "wall_friction", "disc_friction", "sphere_friction")  # keys of sliding friction
# what a plane cell is to be wide at least, for the belts at floor and lid: heights of its filling, mean diameters
HEIGHTS = 4.0
LEAST_WIDTH = 64.0


def high_frictions(config: Any, above: str = "") -> Iterator[str]:
    """A caution for each sliding friction of a section, and further in, above HIGH_FRICTION."""
    for name, value in _parts(config):
        key = f"{above}{name}"
        if name in FRICTIONS and isinstance(value, float) and value > HIGH_FRICTION:
            yield f"{key} = {value:g} is unusual: grains and walls mostly have less than {HIGH_FRICTION:g}"
        yield from high_frictions(value, f"{key}.")


def _parts(config: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(config, list | tuple):
        return ((str(number), part) for number, part in enumerate(config))
    return iter(config.items() if isinstance(config, Mapping) else config if isinstance(config, BaseModel) else ())


def narrow_cell(case: Any) -> Iterator[str]:
    """A caution where a plane cell of a laboratory is too narrow for its test of internal friction."""
    if isinstance(case, DiscCase) and case.config.cell_grains < max(LEAST_WIDTH, HEIGHTS * case.config.height_grains):
        yield (
            f"a cell of {case.config.cell_grains:g} grains by {case.config.height_grains:g}: narrower than {LEAST_WIDTH:g} "
            f"grains or {HEIGHTS:g} heights, its internal friction comes out too high"
        )
