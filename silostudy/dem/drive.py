"""Drives of walls: a speed along the axis, until a force or a height stops it, or a load on a mass.

A loaded wall is a rigid body of its own: its mass is inertia alone, and its load is all that presses, its weight included.  It
moves in a drag of load over speed, as a piston on a throttled line: at that speed where nothing resists, and at rest where what
it presses bears its load.  The drag is taken at the end of the step, so that it bounds no step.
"""

import numpy as np
from numba.extending import register_jitable

from silostudy.dem.cache import piece
from silostudy.dem.integrate import INTEGRATORS

# columns: velocity of the integrator's own (m/s), load (N), mass (kg; 0: moves at its speed), drag (N s/m), and where it stops
HELD, LOAD, MASS, DRAG, STOP_FORCE, STOP_HEIGHT = range(6)


def standing(count: int) -> np.ndarray:
    """Drives of walls that stand."""
    drive = np.zeros((count, STOP_HEIGHT + 1))
    drive[:, STOP_FORCE:] = np.inf
    return drive


@register_jitable
def pressing(cells, record, wall):
    """Force (N, in the plane N/m) that presses a wall in this step, on both its faces."""
    first, back = cells[wall, 0], cells[wall, cells.shape[1] - 1]
    force = record.whole_now[record.owner[first], 0]
    return force + record.whole_now[record.owner[first + back], 0] if back > 0 else force


def drive_pass(pieces):
    """Function that moves the walls by a step, after the bodies, and gives the longest way (m) of any: endless if one goes."""
    space, advance = pieces.space, INTEGRATORS[pieces.integrator].advance
    rise, lift, height_of, widen = space.rise, space.lift, space.height_of, space.widen

    @piece("drive", pieces)
    def way_of(walls, record, q, dt):
        shape, drive = walls.shape, walls.drive
        force, speed = pressing(walls.cells, record, q), shape[q, rise]
        if not drive[q, MASS] > 0.0:
            shape[q, rise] = 0.0 if force >= drive[q, STOP_FORCE] else speed
            return shape[q, rise] * dt
        pull = (force - drive[q, LOAD] - drive[q, DRAG] * speed) / (drive[q, MASS] + drive[q, DRAG] * dt)
        shape[q, rise], drive[q, HELD], way = advance(speed, drive[q, HELD], pull, dt, dt)
        return way

    @piece("drive", pieces)
    def drive_walls(walls, record, dt):
        most = 0.0
        for q in range(walls.live.size):
            if widen(walls.shape, q, dt):
                walls.live[q] = False
                most = np.inf
            if walls.drive[q, MASS] == 0.0 and walls.shape[q, rise] == 0.0:
                continue
            way, left = way_of(walls, record, q, dt), walls.drive[q, STOP_HEIGHT] - height_of(walls.shape, q)
            arrives = left * (left - way) <= 0.0
            way = left if arrives else way
            lift(walls.shape, q, way)
            if arrives:
                walls.shape[q, rise] = walls.drive[q, MASS] = 0.0
            most = max(most, abs(way))
        return most

    return drive_walls
