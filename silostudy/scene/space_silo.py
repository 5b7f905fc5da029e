"""The surfaces of a silo in space, built in one place: walls of its plan, a hopper or a flat floor, an outlet, a lid.

The outlet, or a flat floor, lies at a height of zero, the axis at x = y = 0; an eccentric outlet lies towards x, a longer side
along y.  Every surface has a name; of a plan with corners one for each side, numbered counter-clockwise from the side that
faces x: wall_1, wall_2, ...
"""

from dataclasses import dataclass

import numpy as np

from silostudy.dem.space.level import LevelPiece, Outline, Rim
from silostudy.dem.space.network import all_from_wall
from silostudy.dem.space.surfaces import CIRCLE, RECTANGLE
from silostudy.dem.space.walls import FlatPiece, Surface, TurnedLine, walls_of
from silostudy.scene.silo import Silo
from silostudy.scene.space_checks import require_surfaces

FLOOR, LID = "floor", "lid"  # the floor is the whole of a flat one, or the plug in a hopper's outlet
AROUND, RIM = "floor_around", "rim"  # of a flat floor about its outlet: they wait for it to open
WALL, HOPPER = "wall", "hopper"


@dataclass(frozen=True, kw_only=True)
class Outlet:
    """Outlet of a flat floor: its diameter (m), or where it has a length its width along x and its length along y (m)."""

    width: float
    length: float | None = None


@dataclass(frozen=True, kw_only=True)
class SpaceSilo:
    """A silo as the codes know it, and what only grains need.

    outlet: of a flat floor, None: a closed one; wedge: the hopper of a square or rectangular plan slopes on two sides only,
    else on all four, equally steep; freeboard: height (m) of the walls above the highest contact with the solid.
    """

    silo: Silo
    outlet: Outlet | None = None
    wedge: bool = False
    freeboard: float = 0.0
    lid: bool = False

    def __post_init__(self):
        require_surfaces(self)

    @property
    def bottom(self) -> float:
        """Height (m) at which the vertical walls begin, above the outlet: that of the hopper."""
        return self.silo.hopper_height

    @property
    def top(self) -> float:
        """Height (m) at which the vertical walls end."""
        return self.bottom + self.silo.wall_depth + self.freeboard

    @property
    def plan(self) -> Outline:
        """Outline of the vertical walls."""
        half = self.silo.diameter / 2
        if self.silo.plan == "circular":
            return Outline(sides=int(CIRCLE), half=(half, half))
        if self.silo.plan == "polygonal":
            return Outline(sides=self.silo.sides, half=(half, half))
        return Outline(sides=int(RECTANGLE), half=(half, self.silo.length / 2 or half))

    def outline(self, height: float) -> Outline:
        """Outline of the inside at a height (m) above the outlet."""
        low, high = self.opening, self.plan
        if self.silo.hopper is None or low is None or height >= self.bottom:
            return high
        share = max(height, 0.0) / self.bottom
        (a, b), (x, y) = (
            tuple(p + share * (q - p) for p, q in zip(one, other, strict=True))
            for one, other in ((low.half, high.half), (low.middle, high.middle))
        )
        return Outline(sides=high.sides, half=(a, b), middle=(x, y))

    def volume_below(self, height: float) -> float:
        """Volume (m3) of the inside below a height (m); exact, since areas are squares of the height by pieces."""
        parts = [(0.0, min(height, self.bottom)), (self.bottom, max(height, self.bottom))]
        return sum((z1 - z0) / 6 * sum(w * self.outline(z).area for w, z in ((1, z0), (4, (z0 + z1) / 2), (1, z1)))
                   for z0, z1 in parts)  # fmt: skip

    def room_at(self, places: np.ndarray, radius: np.ndarray | float) -> np.ndarray:
        """Which places (n, 3; m) are inside and at least a radius (m; one, or each its own) from every surface that stands."""
        radius = np.broadcast_to(radius, len(places))
        inside = np.array([self.outline(z).inset(x, y) > 0.0 for x, y, z in places], bool)
        inside &= (places[:, 2] > 0.0) & (places[:, 2] < self.top)
        walls = walls_of(self.walls())
        for wall in np.flatnonzero(walls.live):
            inside[inside] = np.linalg.norm(all_from_wall(walls.shape, wall, places[inside]), axis=1) >= radius[inside]
        return inside

    @property
    def opening(self) -> Outline | None:
        """Outline of the outlet; None: the bottom is closed."""
        plan, middle = self.plan, (self.silo.outlet_eccentricity, 0.0)
        if hopper := self.silo.hopper:
            half, longer = hopper.outlet_width / 2, plan.half[1] - plan.half[0]
            return Outline(sides=plan.sides, half=(half, plan.half[1] if self.wedge else longer + half), middle=middle)
        if self.outlet is None:
            return None
        width, length = self.outlet.width, self.outlet.length
        halves = (width / 2, (width if length is None else length) / 2)
        return Outline(sides=int(CIRCLE if length is None else RECTANGLE), half=halves, middle=middle)

    def over_outlet(self, places: np.ndarray) -> np.ndarray:
        """Which places (n, 3; m) stand over the outlet."""
        opening = self.opening
        return np.zeros(len(places), bool) if opening is None else opening.inset(places[:, 0], places[:, 1]) > 0.0

    def walls(self, cells: tuple[int, int] = (1, 1)) -> tuple[Surface, ...]:
        """Its surfaces: the bottom, closed, then the walls and the lid.

        cells: equal parts along and around of each whose force is recorded.
        """
        flat, plan = self.silo.hopper is None, self.plan
        walls = sides_between(WALL, plan, self.bottom, plan, self.top, cells, not self.slotted, self.lid)
        lid = (level(LID, plan, self.top, cells),) if self.lid else ()
        return (*(self._floor(cells) if flat else self._hopper(cells)), *walls, *lid)

    @property
    def waiting(self) -> tuple[str, ...]:
        """Names of the surfaces that stand where the floor was, once the outlet is open."""
        return tuple(surface.name for surface in self.walls() if not surface.live)

    @property
    def slotted(self) -> bool:
        """Whether the outlet of a flat floor runs from wall to wall, so that the walls end in edges there."""
        plan, opening = self.plan, self.opening
        return self.silo.hopper is None and opening is not None and opening.half[1] == plan.half[1]

    def _floor(self, cells: tuple[int, int]) -> tuple[Surface, ...]:
        whole, hole = level(FLOOR, self.plan, 0.0, cells), self.opening
        if hole is None:
            return (whole,)
        sides = () if hole.sides == CIRCLE else (0, 2) if self.slotted else range(4)
        rims = (Rim(name=f"{RIM}_{k + 1}", height=0.0, hole=hole, side=k, cells=(1, cells[1]), live=False) for k in sides)
        return (whole, level(AROUND, self.plan, 0.0, cells, hole), *rims)

    def _hopper(self, cells: tuple[int, int]) -> tuple[Surface, ...]:
        opening = self.opening
        assert opening is not None
        opens = min(opening.half) > 0.0
        faces = sides_between(HOPPER, opening, 0.0, self.plan, self.bottom, cells, not opens, True)
        return (level(FLOOR, opening, 0.0, cells), *faces) if opens else faces


def level(name: str, outline: Outline, height: float, cells: tuple[int, int], hole: Outline | None = None) -> Surface:
    """A level surface joined to others all around; with a hole it waits for an outlet to open."""
    live = hole is None
    about_axis = hole is None or (hole.sides == CIRCLE and hole.middle == outline.middle)
    if outline.sides == CIRCLE and about_axis:
        inner = hole.half[0] if hole else 0.0
        return TurnedLine(
            name=name, start=(inner, height), end=(outline.half[0], height), axis=outline.middle, joined=(live, True),
            cells=cells, live=live,
        )  # fmt: skip
    return LevelPiece(name=name, height=height, outline=outline, hole=hole, cells=cells, live=live)


def sides_between(
    name: str, low: Outline, z: float, high: Outline, top: float, cells: tuple[int, int], below: bool, above: bool
) -> tuple[Surface, ...]:
    """The surfaces from one outline to another above it; below, above: whether others are joined to them there."""
    if low.sides == CIRCLE:
        start, end = (low.half[0], z), (high.half[0], top)
        return (TurnedLine(name=name, start=start, end=end, joined=(below, above), cells=cells),)
    faces = []
    for k in range(low.sides):
        (right, left), (high_right, high_left) = ((of.corners[k], of.corners[(k + 1) % of.sides]) for of in (low, high))
        foot = ((*left, z), (*right, z)) if left != right else ((*left, z),)
        joined = (below, True, above, True) if left != right else (True, above, True)
        corners = (*foot, (*high_right, top), (*high_left, top))
        faces.append(FlatPiece(name=f"{name}_{k + 1}", corners=corners, joined=joined, cells=cells))
    return tuple(faces)
