"""The surfaces of a silo in space, built in one place: walls of its plan, a hopper or a flat floor, outlets, a lid.

The outlet, or a flat floor, lies at a height of zero, the axis at x = y = 0; a hopper's eccentric outlet lies towards x, a
longer side along y.  Every surface has a name; of a plan with corners one for each side, numbered counter-clockwise from the
side that faces x: wall_1, wall_2, ...
"""

from dataclasses import dataclass, replace

import numpy as np

from silostudy.dem.model import FLOOR
from silostudy.dem.space.cones import EccentricCone
from silostudy.dem.space.level import Hole, LevelPiece, Outline, gate_of
from silostudy.dem.space.network import all_from_wall
from silostudy.dem.space.rows import CIRCLE, RECTANGLE
from silostudy.dem.space.walls import FlatPiece, Surface, TurnedLine, walls_of
from silostudy.scene.outflow import OUTLET
from silostudy.scene.silo import Silo
from silostudy.scene.space_checks import require_surfaces

# names of surfaces besides the floor, which is the plug in a hopper's outlet too
LID = "lid"
WALL = "wall"
HOPPER = "hopper"


@dataclass(frozen=True, kw_only=True)
class Outlet:
    """Outlet of a flat floor: its diameter (m), or where it has a length its width along x and its length along y (m).

    middle: its x and y (m); None: as far off the axis as the silo says.
    """

    width: float
    length: float | None = None
    middle: tuple[float, float] | None = None
    name: str = OUTLET

    def outline(self, aside: float) -> Outline:
        """Outline of the outlet; aside: x (m) of one that does not say where it is."""
        halves = (self.width / 2, (self.width if self.length is None else self.length) / 2)
        sides = int(CIRCLE if self.length is None else RECTANGLE)
        return Outline(sides=sides, half=halves, middle=self.middle or (aside, 0.0))


@dataclass(frozen=True, kw_only=True)
class SpaceSilo:
    """A silo as the codes know it, and what only grains need.

    outlets: of a flat floor, none: a closed one; inserts: surfaces of names of their own inside; wedge: the hopper of a square
    or rectangular plan slopes on two sides only, else on all four, which meet in one apex; freeboard: height (m) of the
    walls above the highest contact with the solid; gated: whether outlets open at a speed, when the plug of a hopper is a level
    piece whose hole grows.
    """

    silo: Silo
    outlets: tuple[Outlet, ...] = ()
    inserts: tuple[Surface, ...] = ()
    wedge: bool = False
    freeboard: float = 0.0
    lid: bool = False
    gated: bool = False

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
            tuple(p + share * (q - p) for p, q in zip(below, above, strict=True))
            for below, above in ((low.half, high.half), (low.middle, high.middle))
        )
        return Outline(sides=high.sides, half=(a, b), middle=(x, y))

    def volume_below(self, height: float) -> float:
        """Volume (m3) of the inside below a height (m); exact, since areas are squares of the height by pieces."""
        parts = [(0.0, min(height, self.bottom)), (self.bottom, max(height, self.bottom))]
        return sum((z1 - z0) / 6 * sum(w * self.outline(z).area for w, z in ((1, z0), (4, (z0 + z1) / 2), (1, z1)))
                   for z0, z1 in parts)  # fmt: skip

    def room_at(self, places: np.ndarray, radius: np.ndarray | float) -> np.ndarray:
        """Mask of places (n, 3; m) inside and at least a radius (m; one, or one a place) from every surface that stands."""
        radius = np.broadcast_to(radius, len(places))
        inside = np.array([self.outline(z).inset(x, y) > 0.0 for x, y, z in places], bool)
        inside &= (places[:, 2] > 0.0) & (places[:, 2] < self.top)
        walls = walls_of(self.walls())
        for wall in np.flatnonzero(walls.live):
            inside[inside] = np.linalg.norm(all_from_wall(walls.shape, wall, places[inside]), axis=1) >= radius[inside]
        return inside

    @property
    def opening(self) -> Outline | None:
        """Outline of a hopper's outlet; None: the bottom is flat."""
        plan, hopper = self.plan, self.silo.hopper
        if hopper is None:
            return None
        half, longer = hopper.outlet_width / 2, plan.half[1] / plan.half[0]
        halves = (half, plan.half[1] if self.wedge else longer * half)
        return Outline(sides=plan.sides, half=halves, middle=(self.silo.outlet_eccentricity, 0.0))

    @property
    def openings(self) -> dict[str, Outline]:
        """Outlines of all outlets by their names; none: the bottom is closed."""
        if (opening := self.opening) is not None:
            return {OUTLET: opening} if min(opening.half) > 0.0 else {}
        return {outlet.name: outlet.outline(self.silo.outlet_eccentricity) for outlet in self.outlets}

    @property
    def outlet_widths(self) -> dict[str, float]:
        """Least width (m) of each outlet by its name."""
        return {name: 2.0 * min(opening.half) for name, opening in self.openings.items()}

    def outlet_at(self, places: np.ndarray) -> np.ndarray:
        """Number of the outlet that each place (n, 3; m) is in, or nearest to being in."""
        return np.argmax([opening.inset(*places.T[:2]) for opening in self.openings.values()], axis=0)

    def over_outlets(self, places: np.ndarray) -> np.ndarray:
        """Mask of places (n, 3; m) that stand over an outlet."""
        return np.max([opening.inset(*places.T[:2]) for opening in self.openings.values()], axis=0) > 0.0

    def walls(self, cells: tuple[int, int] = (1, 1)) -> tuple[Surface, ...]:
        """Surfaces of the silo: the bottom, closed, then the walls, the lid and the inserts.

        cells: equal parts along and around of each whose force is recorded; a facet of a curved sheet is one.
        """
        flat, plan = self.silo.hopper is None, self.plan
        walls = sides_between(WALL, plan, self.bottom, plan, self.top, cells, not self.slotted, self.lid)
        lid = (level(LID, plan, self.top, cells),) if self.lid else ()
        inserts = (replace(insert, cells=(1, 1) if insert.sheet else cells) for insert in self.inserts)
        return (*((self._floor(cells),) if flat else self._hopper(cells)), *walls, *lid, *inserts)

    @property
    def slotted(self) -> bool:
        """Whether an outlet of a flat floor runs from wall to wall, so that the walls end in edges there."""
        return self.silo.hopper is None and any(any(self.plan.crossed_by(hole)) for hole in self.openings.values())

    def _floor(self, cells: tuple[int, int]) -> Surface:
        holes = tuple(Hole(name=name, outline=outline) for name, outline in self.openings.items())
        return level(FLOOR, self.plan, 0.0, cells, holes)

    def _hopper(self, cells: tuple[int, int]) -> tuple[Surface, ...]:
        opening = self.opening
        assert opening is not None
        opens = bool(self.openings)
        faces = sides_between(HOPPER, opening, 0.0, self.plan, self.bottom, cells, not opens, True)
        if not opens:
            return faces
        plug = level(FLOOR, opening, 0.0, cells)
        return (gate_of(plug, OUTLET) if self.gated else plug, *faces)


def level(name: str, outline: Outline, height: float, cells: tuple[int, int], holes: tuple[Hole, ...] = ()) -> Surface:
    """A level surface joined to others all around, its holes shut."""
    if outline.sides == CIRCLE and not holes:
        start, end = (0.0, height), (outline.half[0], height)
        return TurnedLine(name=name, start=start, end=end, axis=outline.middle, joined=(True, True), cells=cells)
    return LevelPiece(name=name, height=height, outline=outline, holes=holes, cells=cells)


def sides_between(
    name: str, low: Outline, z: float, high: Outline, top: float, cells: tuple[int, int], below: bool, above: bool
) -> tuple[Surface, ...]:
    """The surfaces from one outline to another above it; below, above: whether others are joined to them there."""
    if low.sides == CIRCLE:
        start, end = (low.half[0], z), (high.half[0], top)
        if low.middle != high.middle:
            off = EccentricCone(
                name=name, start=start, end=end, foot=low.middle, head=high.middle, joined=(below, above), cells=cells
            )
            return (off,)
        return (TurnedLine(name=name, start=start, end=end, joined=(below, above), cells=cells),)
    faces = []
    for k in range(low.sides):
        (right, left), (high_right, high_left) = ((of.corners[k], of.corners[(k + 1) % of.sides]) for of in (low, high))
        foot = ((*left, z), (*right, z)) if left != right else ((*left, z),)
        joined = (below, True, above, True) if left != right else (True, above, True)
        corners = (*foot, (*high_right, top), (*high_left, top))
        faces.append(FlatPiece(name=f"{name}_{k + 1}", corners=corners, joined=joined, cells=cells))
    return tuple(faces)
