"""Space: the table that the passes of a kernel of spheres close over."""

from silostudy.dem.arrays import Spheres
from silostudy.dem.dimension import Dimension
from silostudy.dem.space.felt import (
    components,
    force_of,
    gather_moving_walls,
    gather_walls,
    note_walls,
    scatter_walls,
    wall_power,
)
from silostudy.dem.space.gate import widen
from silostudy.dem.space.lanes import (
    FORCE,
    HISTORIES,
    NEW,
    OLD,
    PASSED,
    PLACE,
    SPIN,
    STRETCH,
    TORQUE,
    VELOCITY,
    gather,
    gather_rolling,
    scatter,
    scatter_rolling,
)
from silostudy.dem.space.motion import (
    about,
    carry,
    facing,
    move,
    pushed,
    put,
    rates,
    reduced,
    twisting,
    where,
    whole,
)
from silostudy.dem.space.network import all_from_wall, bent, densest
from silostudy.dem.space.outlets import handed_on
from silostudy.dem.space.rows import RISE
from silostudy.dem.space.surfaces import height_of, lift, motion_of, nearest, run
from silostudy.dem.space.walk import walk
from silostudy.dem.space.walls import beside, cell_count, extents, walls_of

SPACE = Dimension(
    key="space",
    body="sphere",
    bodies=Spheres,
    place=PLACE,
    velocity=VELOCITY,
    spin=SPIN,
    force=FORCE,
    torque=TORQUE,
    row=PASSED + 1,
    inverse_inertia=2.5,
    stretch=STRETCH,
    ahead=16.0,  # less than in the plane: a longer way takes in more neighbours
    lanes=(1, (OLD + HISTORIES) * STRETCH),
    forces=(1, (NEW + HISTORIES) * STRETCH),
    components=3,
    felt=components,
    gather=lambda apart: gather if apart else gather_rolling,
    gather_walls=lambda moving: gather_moving_walls if moving else gather_walls,
    scatter=lambda apart: scatter if apart else scatter_rolling,
    scatter_walls=scatter_walls,
    note_walls=note_walls,
    wall_power=wall_power,
    rise=RISE,
    height_of=height_of,
    motion_of=motion_of,
    handed_on=handed_on,
    widen=widen,
    lift=lift,
    run=run,
    walls_of=walls_of,
    cell_count=cell_count,
    extents=extents,
    beside=beside,
    densest=densest,
    all_from_wall=all_from_wall,
    passed=(PASSED,),
    nearest=nearest,
    bent=bent,
    force_of=force_of,
    facing=facing,
    reduced=reduced,
    rates=rates,
    carry=carry,
    twisting=twisting,
    about=about,
    whole=whole,
    put=put,
    where=where,
    walk=walk,
    move=move,
    pushed=pushed,
)
