"""Space: the table that the passes of a kernel of spheres close over."""

from silostudy.dem.arrays import Spheres
from silostudy.dem.dimension import Dimension
from silostudy.dem.space.booking import book_bodies
from silostudy.dem.space.felt import force_of, gather_walls, note_walls, scatter_walls
from silostudy.dem.space.lanes import (
    HISTORIES,
    NEW,
    OLD,
    PASSED,
    PLACE,
    SPIN,
    STRETCH,
    VELOCITY,
    gather,
    gather_rolling,
    scatter,
)
from silostudy.dem.space.motion import (
    about,
    carry,
    facing,
    move,
    passed_for,
    pushed,
    put,
    rates,
    reduced,
    twisting,
    walk,
    where,
)
from silostudy.dem.space.network import all_from_wall, bent, densest, tangents
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import beside, cell_count, extents, walls_of

SPACE = Dimension(
    key="space",
    body="sphere",
    bodies=Spheres,
    place=PLACE,
    velocity=VELOCITY,
    spin=SPIN,
    row=PASSED + 1,
    inverse_inertia=2.5,
    stretch=STRETCH,
    lanes=(1, (OLD + HISTORIES) * STRETCH),
    forces=(1, (NEW + HISTORIES) * STRETCH),
    components=3,
    felt=3,
    gather=lambda apart: gather if apart else gather_rolling,
    gather_walls=gather_walls,
    scatter=scatter,
    scatter_walls=scatter_walls,
    note_walls=note_walls,
    walls_of=walls_of,
    cell_count=cell_count,
    extents=extents,
    beside=beside,
    densest=densest,
    all_from_wall=all_from_wall,
    tangents=tangents,
    passed_for=passed_for,
    nearest=nearest,
    bent=bent,
    force_of=force_of,
    facing=facing,
    reduced=reduced,
    rates=rates,
    carry=carry,
    twisting=twisting,
    about=about,
    put=put,
    where=where,
    walk=walk,
    move=move,
    book_bodies=book_bodies,
    pushed=pushed,
)
