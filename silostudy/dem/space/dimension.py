"""Space: the table that the passes of a kernel of spheres close over."""

from silostudy.dem.arrays import Spheres
from silostudy.dem.dimension import Dimension
from silostudy.dem.space.felt import gather_walls, note_walls, scatter_walls
from silostudy.dem.space.lanes import (
    FORCE,
    HISTORIES,
    NEW,
    OLD,
    PLACE,
    SPARE,
    SPIN,
    STRETCH,
    TORQUE,
    VELOCITY,
    gather,
    gather_rolling,
    scatter,
)
from silostudy.dem.space.motion import about, carry, facing, move, pushed, put, rates, reduced, twisting, walk, where
from silostudy.dem.space.walls import cell_count, walls_of

SPACE = Dimension(
    key="space",
    body="sphere",
    bodies=Spheres,
    place=PLACE,
    velocity=VELOCITY,
    spin=SPIN,
    force=FORCE,
    torque=TORQUE,
    row=SPARE + 1,
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
    pushed=pushed,
)
