"""The plane: what of contacts and of motions belongs to two dimensions."""

from collections.abc import Callable

import numpy as np
from numba.extending import register_jitable

from silostudy.dem.arrays import Discs
from silostudy.dem.cache import piece
from silostudy.dem.columns import to_lanes, to_rows_of_discs
from silostudy.dem.dimension import Dimension
from silostudy.dem.lanes import (
    DISTANCE,
    DU,
    DV,
    FIRST_TORQUE,
    FORCE_X,
    FORCE_Y,
    FX,
    FY,
    NORMAL_X,
    NORMAL_Y,
    SECOND_TORQUE,
    SPIN_DIFFERENCE,
    SPIN_SUM,
    STRETCH,
    TORQUE,
    U,
    V,
    W,
    X,
    Y,
    gather,
    gather_rolling,
    scatter,
    scatter_rolling,
)  # fmt: skip
from silostudy.dem.network import all_from_wall, densest
from silostudy.dem.outlets import handed_on
from silostudy.dem.pieces import Laws
from silostudy.dem.walls import (
    RISE,
    beside,
    cell_count,
    extents,
    gather_moving_walls,
    gather_walls,
    height_of,
    lift,
    motion_of,
    nearest,
    note_walls,
    run,
    scatter_walls,
    wall_power,
    walls_of,
    widen,
)


@register_jitable
def force_of(out, k):
    """Force (N/m) of a contact on its first body."""
    return out[FORCE_X, k], out[FORCE_Y, k]


@register_jitable
def facing(lanes, k):
    """Normal (unit vector from the second body to the first) and distance (m) of the centres."""
    return (lanes[NORMAL_X, k], lanes[NORMAL_Y, k]), lanes[DISTANCE, k]


def reduced(flat: bool):
    """Function that gives a contact's reduced radius (m): at a wall the disc's own."""

    @piece("plane", flat)
    def radius(lanes, k, a, b):
        return a if flat else a * b / (a + b)

    return radius


@register_jitable
def carry(history, normal):
    """A history as it is: in the plane there is one direction along a contact."""
    return history


@register_jitable
def twisting(lanes, k, normal):
    """Difference of spins about the normal (1/s): none, the normal lies in the plane."""
    return 0.0


@register_jitable
def about(moment, twist, normal):
    """A moment (N m/m) with that about the normal: none."""
    return moment


def rates(unequal: bool):
    """Function that gives a contact's closing speed, sliding speed (m/s) of surfaces, and difference of spins (1/s)."""

    @piece("plane", unequal)
    def speeds(lanes, k, normal, a, b, depth, flat):
        nx, ny = normal
        du, dv = lanes[DU, k], lanes[DV, k]
        summed, apart = lanes[SPIN_SUM, k], lanes[SPIN_DIFFERENCE, k]
        spin = 0.5 * (summed * (a + b) + apart * (a - b)) if unequal else summed * a
        return -(du * nx + dv * ny), dv * nx - du * ny - spin, apart

    return speeds


@register_jitable
def whole(push, drag, normal):
    """Force (N/m) of a contact on its first body."""
    return push * normal[0] - drag * normal[1], push * normal[1] + drag * normal[0]


def put(drags: bool, brakes: bool, apart: bool):
    """Function that writes a contact's force (N/m) and its moments (N m/m) on both bodies into lanes.

    Unless apart, the same moment is added to both and stands there once.
    """

    @piece("plane", drags, brakes, apart)
    def force(out, k, normal, push, drag, moment, a, b, depth, flat):
        nx, ny = normal
        out[FORCE_X, k] = push * nx - drag * ny if drags else push * nx  # zero times a number is not left out by itself
        out[FORCE_Y, k] = push * ny + drag * nx if drags else push * ny
        out[FIRST_TORQUE, k] = moment - drag * a if brakes else -drag * a
        if apart:
            out[SECOND_TORQUE, k] = moment + drag * b  # taken from the second

    return force


@register_jitable
def where(touching, value):
    """A value where bodies touch, nothing where they do not."""
    return value if touching else 0.0


def walk(gathered: Callable, contact: Callable, unequal: bool, laws: Laws, key: tuple):
    """Function that takes a stretch of a list contact by contact: the loop that the compiler vectorises."""

    slides, rolls = laws.slides, laws.rolls

    @piece("plane", unequal, *key)
    def forces(rows, contacts, shape, start, count, lanes, out, stored, rolled, dt, c):
        gathered(rows, contacts, shape, start, count, lanes)
        stored = stored[start:] if slides else stored
        rolled = rolled[start:] if rolls else rolled
        arm = contacts.arm[start:] if unequal else contacts.arm
        other = contacts.other[start:] if unequal else contacts.other
        mass = contacts.mass[start:] if unequal else contacts.mass
        a, b, m = arm[0], other[0], mass[0]
        for k in range(count):
            if unequal:
                a, b, m = arm[k], other[k], mass[k]
            old, turned = stored[k] if slides else 0.0, rolled[k] if rolls else 0.0
            held, rolling, _, _ = contact(lanes, out, k, a, b, m, old, turned, 0.0, 0.0, dt, c)
            if slides:
                stored[k] = held
            if rolls:
                rolled[k] = rolling

    return forces


def move(advance: Callable, holds: bool, turns: bool, unequal: bool, key: str):
    """Function that moves a block of discs a step, clears their forces, and writes the square of each one's way (m2)."""

    @piece("plane", key, turns, unequal)
    def moved(bodies, begin, end, pull, kick, dt, scratch):
        lanes, motion, held = scratch.lanes.reshape(-1), scratch.motion, bodies.held[begin:]
        im, ii = bodies.inverse_mass[begin if unequal else 0 :], bodies.inverse_inertia[begin if unequal else 0 :]
        hu = hv = hw = 0.0
        to_lanes(bodies.rows, begin, end, lanes, STRETCH)
        for k in range(end - begin):
            n = k if unequal else 0
            if holds:
                hu, hv, hw = held[k, 0], held[k, 1], held[k, 2]
            u, hu, du = advance(lanes[U * STRETCH + k], hu, lanes[FX * STRETCH + k] * im[n] + pull[0], kick, dt)
            v, hv, dv = advance(lanes[V * STRETCH + k], hv, lanes[FY * STRETCH + k] * im[n] + pull[1], kick, dt)
            lanes[X * STRETCH + k] += du
            lanes[Y * STRETCH + k] += dv
            lanes[U * STRETCH + k], lanes[V * STRETCH + k] = u, v
            if turns:
                w, hw, _ = advance(lanes[W * STRETCH + k], hw, lanes[TORQUE * STRETCH + k] * ii[n], kick, dt)
                lanes[W * STRETCH + k] = w
            if holds:
                held[k, 0], held[k, 1], held[k, 2] = hu, hv, hw
            motion[k] = du * du + dv * dv
        to_rows_of_discs(lanes, STRETCH, bodies.rows, begin, end)

    return moved


@register_jitable
def pushed(gravity, quake, step):
    """Acceleration (m/s2) of discs in a box that is accelerated."""
    return gravity[0] - quake[step, 0], gravity[1] - quake[step, 1]


def bent(shape: np.ndarray, wall: int, *place: float) -> float:
    """Curvature (1/m) of a wall: none."""
    return 0.0


PLANE = Dimension(
    key="plane",
    body="disc",
    bodies=Discs,
    place=(X, Y),
    velocity=(U, V),
    spin=(W,),
    force=(FX, FY),
    torque=(TORQUE,),
    row=8,
    inverse_inertia=2.0,
    stretch=STRETCH,
    ahead=28.0,
    lanes=(8, STRETCH),
    forces=(4, STRETCH),
    components=1,
    felt=lambda model: 2,
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
    passed=(),
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
