"""Contacts of spheres with surfaces: the spheres' motion beside them, the forces on the spheres, and where those act."""

from math import atan2, pi, sqrt

from numba import njit
from numba.extending import register_jitable

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.eccentric import eccentric_frame, eccentric_normal
from silostudy.dem.space.flat import piece_of
from silostudy.dem.space.lanes import (
    APART_P,
    CURVED,
    DISTANCE,
    DU,
    FIRST_X,
    FORCE_X,
    FX,
    NX,
    STRETCH,
    SUM_P,
    TX,
    P,
    U,
    X,
    Y,
    Z,
)
from silostudy.dem.space.motion import across, away_of, dot, three
from silostudy.dem.space.rows import (
    ACROSS,
    ALONG_R,
    ALONG_Z,
    AXIS_X,
    AXIS_Y,
    BELT,
    ECCENTRIC,
    FLAT,
    LENGTH,
    NORMAL,
    RISE,
    START_R,
    START_Z,
    TURN,
    TURNED,
    UPWARD,
)
from silostudy.dem.space.surfaces import nearest

STRAIGHT = 1.0 - 1e-9  # cosine between a contact's normal and its surface's: below it an edge pushes

force_of = three(FORCE_X)  # N, on the sphere
# of what a wall feels, besides forces across and along it
TORQUE = 3  # where walls move: about the axis x = y = 0 (N m)
LOAD = 4  # in silos with an eccentric cone, whose normal leans differently all around: downward (N)


def components(model) -> int:
    """Number of components of what the walls of a model feel."""
    eccentric = any(surface.shape[0] == ECCENTRIC for surface in model.walls)
    return LOAD + 1 if eccentric else TORQUE + int(model.moving)


@register_jitable
def gather_walls(rows, shape, sphere, wall, start, count, lanes):
    """Lanes of spheres near walls: a wall is at rest and does not turn."""
    for k in range(count):
        i = sphere[start + k]
        dx, dy, dz, curved = nearest(shape, wall[start + k], rows[i, X], rows[i, Y], rows[i, Z])
        distance = sqrt(dx * dx + dy * dy + dz * dz)
        inverse = 1.0 / distance
        normal = dx * inverse, dy * inverse, dz * inverse
        for n in range(3):
            lanes[0, (NX + n) * STRETCH + k] = normal[n]
            lanes[0, (DU + n) * STRETCH + k] = rows[i, U + n]
            lanes[0, (SUM_P + n) * STRETCH + k] = lanes[0, (APART_P + n) * STRETCH + k] = rows[i, P + n]
        lanes[0, CURVED * STRETCH + k], lanes[0, DISTANCE * STRETCH + k] = curved, distance


@register_jitable
def belt_at(shape, wall, normal):
    """Velocity (m/s) of a surface's face along itself at a contact of this normal: a rim that faces along stands still."""
    return across((shape[wall, BELT], shape[wall, BELT + 1], shape[wall, BELT + 2]), normal)


@register_jitable
def gather_moving_walls(rows, shape, sphere, wall, start, count, lanes):
    """Lanes of spheres near walls, of which some rise, turn or run along themselves: velocities against the nearest point."""
    gather_walls(rows, shape, sphere, wall, start, count, lanes)
    for k in range(count):
        i, q = sphere[start + k], wall[start + k]
        distance = lanes[0, DISTANCE * STRETCH + k]
        normal = away_of(lanes, k)
        x, y = rows[i, X] - distance * normal[0], rows[i, Y] - distance * normal[1]
        u, v, w = belt_at(shape, q, normal)
        lanes[0, DU * STRETCH + k] += shape[q, TURN] * y - u
        lanes[0, (DU + 1) * STRETCH + k] -= shape[q, TURN] * x + v
        lanes[0, (DU + 2) * STRETCH + k] -= shape[q, RISE] + w
        lanes[0, (APART_P + 2) * STRETCH + k] -= shape[q, TURN]


@register_jitable
def wall_power(rows, shape, i, wall, force, moment):
    """Power (W) that a wall which moves gives a sphere that it pushes with a force (N) and turns with a moment (N m)."""
    x, y, z = rows[i, X], rows[i, Y], rows[i, Z]
    dx, dy, dz, _ = nearest(shape, wall, x, y, z)
    turning = (x - dx) * force[1] - (y - dy) * force[0] + moment[2]
    distance = sqrt(dx * dx + dy * dy + dz * dz)
    along = dot(belt_at(shape, wall, (dx / distance, dy / distance, dz / distance)), force)
    return shape[wall, RISE] * force[2] + shape[wall, TURN] * turning + along


@register_jitable
def scatter_walls(rows, sphere, start, count, force):
    """Add the walls' forces to their spheres, before the forces of all other spheres."""
    for k in range(count):
        i = sphere[start + k]
        for n in range(3):
            rows[i, FX + n] += force[0, (FORCE_X + n) * STRETCH + k]
            rows[i, TX + n] += force[0, (FIRST_X + n) * STRETCH + k]


@njit(**OPTIONS)
def turned_frame(shape, wall, x, y, z):
    """Place on a turned line: share of its length, share of a turn from the x axis, and the unit vector along it, upward.

    On a level one the vector points outward.
    """
    ax, ay = x - shape[wall, AXIS_X], y - shape[wall, AXIS_Y]
    off = sqrt(ax * ax + ay * ay)
    along_r, along_z = shape[wall, ALONG_R], shape[wall, ALONG_Z]
    along = (off - shape[wall, START_R]) * along_r + (z - shape[wall, START_Z]) * along_z
    turn = atan2(ay, ax) / (2.0 * pi)
    ax, ay = (ax / off, ay / off) if off > 0.0 else (1.0, 0.0)
    sign = -1.0 if along_z < 0.0 or (along_z == 0.0 and along_r < 0.0) else 1.0
    up = sign * along_r * ax, sign * along_r * ay, sign * along_z
    return along / shape[wall, LENGTH], turn if turn >= 0.0 else turn + 1.0, up


@njit(**OPTIONS)
def flat_frame(shape, wall, x, y, z):
    """Place on a flat piece: shares of its two extents, upward and across, and the unit vector upward in it."""
    up = shape[wall, UPWARD], shape[wall, UPWARD + 1], shape[wall, UPWARD + 2]
    height = x * up[0] + y * up[1] + z * up[2] - shape[wall, UPWARD + 3]
    across = x * shape[wall, ACROSS] + y * shape[wall, ACROSS + 1] + z * shape[wall, ACROSS + 2] - shape[wall, ACROSS + 3]
    return height / shape[wall, UPWARD + 4], across / shape[wall, ACROSS + 4], up


@njit(**OPTIONS)
def turned_normal(shape, wall, x, y):
    """Unit normal of a turned line's front, on the left of its way, at a place on it."""
    ax, ay = x - shape[wall, AXIS_X], y - shape[wall, AXIS_Y]
    off = sqrt(ax * ax + ay * ay)
    ax, ay = (ax / off, ay / off) if off > 0.0 else (1.0, 0.0)
    return -shape[wall, ALONG_Z] * ax, -shape[wall, ALONG_Z] * ay, shape[wall, ALONG_R]


@njit(**OPTIONS)
def flat_normal(shape, wall):
    """Unit normal of a flat or level piece's front."""
    if shape[wall, 0] == FLAT:
        return shape[wall, NORMAL], shape[wall, NORMAL + 1], shape[wall, NORMAL + 2]
    return 0.0, 0.0, 1.0


@njit(**OPTIONS)
def cell_of_share(share, count):
    """Number of the equal part that a share lies in, the outer parts taking whatever lies beyond."""
    return min(max(int(share * count), 0), count - 1)


@register_jitable
def note_walls(rows, walls, near, start, count, force, record, part):
    """Note each wall contact's force: pressing, along the wall upward (carrying positive), and across both.

    An edge's force is taken apart as the surface stands there, so that a surface's three tell its load.  Where walls move, also
    its torque about the axis on the wall; beside an eccentric cone that and its load.
    """
    for k in range(count):
        i, q, slot = near.first[start + k], near.second[start + k], start + k
        x, y, z = rows[i, X], rows[i, Y], rows[i, Z]
        dx, dy, dz, _ = nearest(walls.shape, q, x, y, z)
        distance = sqrt(dx * dx + dy * dy + dz * dz)
        nx, ny, nz = dx / distance, dy / distance, dz / distance
        px, py, pz = x - dx, y - dy, z - dz
        if walls.shape[q, 0] == TURNED:
            mx, my, mz = turned_normal(walls.shape, q, px, py)
            share, turn, (ux, uy, uz) = turned_frame(walls.shape, q, px, py, pz)
        elif walls.shape[q, 0] == ECCENTRIC:
            mx, my, mz = eccentric_normal(walls.shape, q, px, py, pz)
            share, turn, (ux, uy, uz) = eccentric_frame(walls.shape, q, px, py, pz)
        else:
            q = piece_of(walls.shape, q, x, y, z) if walls.shape[q, 0] == FLAT else q
            mx, my, mz = flat_normal(walls.shape, q)
            share, turn, (ux, uy, uz) = flat_frame(walls.shape, q, px, py, pz)
        front = nx * mx + ny * my + nz * mz
        sign, edge = 1.0 if front >= 0.0 else -1.0, abs(front) < STRAIGHT
        mx, my, mz = (sign * mx, sign * my, sign * mz) if edge else (nx, ny, nz)
        fx, fy, fz = (
            force[0, FORCE_X * STRETCH + k],
            force[0, (FORCE_X + 1) * STRETCH + k],
            force[0, (FORCE_X + 2) * STRETCH + k],
        )
        cx, cy, cz = my * uz - mz * uy, mz * ux - mx * uz, mx * uy - my * ux
        record.force[part, slot, 0] = fx * mx + fy * my + fz * mz
        record.force[part, slot, 1] = fx * ux + fy * uy + fz * uz
        record.force[part, slot, 2] = fx * cx + fy * cy + fz * cz
        if record.force.shape[2] > TORQUE:
            lever = near.arm[slot if near.arm.size > 1 else 0]
            spin = force[0, (FIRST_X + 2) * STRETCH + k] - lever * (fx * ny - fy * nx)
            record.force[part, slot, TORQUE] = py * fx - px * fy - spin
        if record.force.shape[2] > LOAD:
            record.force[part, slot, LOAD] = fz
        along, around = walls.cells[q, 1], walls.cells[q, 2]
        first = walls.cells[q, 0] + (walls.cells[q, 3] if sign < 0.0 else 0)
        record.cell[part, slot] = first + cell_of_share(share, along) * around + cell_of_share(turn, around)
