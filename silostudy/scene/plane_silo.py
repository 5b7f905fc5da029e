"""The walls of a plane silo, built in one place: a box on a flat floor or a hopper, a slit in the middle of its bottom.

Every wall has a name, and whoever wants one asks the model for it by that name, never by its place.
"""

from dataclasses import dataclass, replace
from math import tan
from typing import NamedTuple

import numpy as np

from silostudy.dem.model import FLOOR, FloorPiece, Model, Wall
from silostudy.scene.outflow import OUTLET
from silostudy.scene.plane_checks import require_lines, require_slits

# names of walls besides the floor
LID = "lid"
SIDES = ("left", "right")
HALVES = ("floor_left", "floor_right")  # of a flat floor beside its slit: they wait for it to open
HOPPER = ("hopper_left", "hopper_right")


class Slit(NamedTuple):
    """A slit of a flat floor by its name: its middle, off the left wall, and its width, m."""

    name: str
    middle: float
    width: float

    @property
    def edges(self) -> tuple[float, float]:
        """Places x (m) of both edges."""
        return self.middle - self.width / 2.0, self.middle + self.width / 2.0


@dataclass(frozen=True)
class PlaneSilo:
    """Inner dimensions: width, height of the vertical walls and width of the slit in m; half angle from the vertical in rad.

    slit 0: a closed box; hopper_half_angle None: a flat floor; inserts: lines of names of their own, inside or outside;
    slits: of a flat floor, by names, in place of the one in its middle.
    """

    width: float
    height: float
    slit: float = 0.0
    hopper_half_angle: float | None = None
    lid: bool = False
    inserts: tuple[Wall, ...] = ()
    slits: tuple[Slit, ...] = ()

    def __post_init__(self):
        require_slits(self)
        require_lines(self)

    @property
    def bottom(self) -> float:
        """Height (m) at which the vertical walls begin, above the slit: that of the hopper."""
        if self.hopper_half_angle is None:
            return 0.0
        return 0.5 * (self.width - self.slit) / tan(self.hopper_half_angle)

    @property
    def outlet_widths(self) -> dict[str, float]:
        """Width (m) of each outlet by its name."""
        return {slit.name: slit.width for slit in self.slits} or ({OUTLET: self.slit} if self.slit else {})

    def walls(self, cells: int = 1, half_cells: int | None = None) -> tuple[Wall, ...]:
        """Walls of the silo with the solid on their left: the bottom, closed, then the sides, the lid and the inserts.

        cells: equal parts of each whose force is recorded; half_cells: those of the floor's halves, None: as many.
        """
        flat = self.hopper_half_angle is None
        bottom = self._floor(cells, half_cells or cells) if flat else self._hopper(cells)
        return (*bottom, *self._upper(cells), *(replace(insert, cells=cells) for insert in self.inserts))

    def _between_slits(self, cells: int) -> tuple[Wall, ...]:
        """The parts of the floor, from the left: each reaches to the middle of the shut slits beside it."""
        slits = sorted(self.slits, key=lambda slit: slit.middle)
        starts, ends = [0.0, *(slit.edges[1] for slit in slits)], [*(slit.edges[0] for slit in slits), self.width]
        names, seams = ["", *(slit.name for slit in slits), ""], [0.0, *(slit.middle for slit in slits), self.width]
        return tuple(
            Wall(f"{FLOOR}_{n + 1}", (start, 0.0), (end, 0.0), cells,
                 floor=FloorPiece((0.0, 0.0), (seams[n], seams[n + 1]), (names[n], names[n + 1])))
            for n, (start, end) in enumerate(zip(starts, ends, strict=True))
        )  # fmt: skip

    def _floor(self, cells: int, half_cells: int) -> tuple[Wall, ...]:
        if self.slits:
            return self._between_slits(cells)
        whole = Wall(FLOOR, (0.0, 0.0), (self.width, 0.0), cells, stays=not self.slit)
        if not self.slit:
            return (whole,)
        (left, right), (near, far) = HALVES, self._edges
        return (
            whole,
            Wall(left, (0.0, 0.0), (near, 0.0), half_cells, live=False),
            Wall(right, (far, 0.0), (self.width, 0.0), half_cells, live=False),
        )

    def _hopper(self, cells: int) -> tuple[Wall, ...]:
        (left, right), (near, far) = HOPPER, self._edges
        return (
            Wall(FLOOR, (near, 0.0), (far, 0.0), cells, joined=(True, True), stays=False),
            Wall(left, (0.0, self.bottom), (near, 0.0), cells, joined=(True, False)),
            Wall(right, (far, 0.0), (self.width, self.bottom), cells, joined=(False, True)),
        )

    def _upper(self, cells: int) -> tuple[Wall, ...]:
        (left, right), base, top = SIDES, self.bottom, self.bottom + self.height
        sides = (
            Wall(left, (0.0, top), (0.0, base), cells, joined=(self.lid, True)),
            Wall(right, (self.width, base), (self.width, top), cells, joined=(True, self.lid)),
        )
        lid = Wall(LID, (self.width, top), (0.0, top), cells, joined=(True, True))
        return (*sides, lid) if self.lid else sides

    @property
    def openings(self) -> tuple[Slit, ...]:
        """Slits of the silo, the one in the middle among them."""
        return self.slits or ((Slit("slit", self.width / 2.0, self.slit),) if self.slit else ())

    def over_slit(self, places: np.ndarray) -> np.ndarray:
        """Mask of places (n, 2; m) that stand over a slit."""
        return np.any([np.abs(places[:, 0] - slit.middle) < slit.width / 2.0 for slit in self.openings], axis=0)

    def slit_at(self, places: np.ndarray) -> np.ndarray:
        """Number of the slit that each place (n, 2; m) is over, or nearest to being over."""
        return np.argmin([np.abs(places[:, 0] - slit.middle) - slit.width / 2.0 for slit in self.openings], axis=0)

    @property
    def _edges(self) -> tuple[float, float]:
        """Places x (m) of the slit's edges."""
        return self.width / 2.0 - self.slit / 2.0, self.width / 2.0 + self.slit / 2.0


def inner_width(model: Model) -> float:
    """Inner width (m) between the side walls of a model."""
    left, right = (model.wall_named(name) for name in SIDES)
    return right.start[0] - left.start[0]
