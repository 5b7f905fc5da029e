"""Motion of spheres: what of a contact the laws see, what its forces do to both spheres, and how a sphere is moved."""

from collections.abc import Callable
from math import sqrt

from numba.extending import register_jitable

from silostudy.dem.cache import piece
from silostudy.dem.columns import to_lanes, to_rows_of_spheres
from silostudy.dem.space.lanes import (
    APART_P,
    CURVED,
    DISTANCE,
    DU,
    FIRST_X,
    FIRST_Y,
    FIRST_Z,
    FORCE_X,
    FORCE_Y,
    FORCE_Z,
    FX,
    FY,
    FZ,
    NEW,
    NX,
    OLD,
    PASSED,
    SECOND_X,
    SECOND_Y,
    SECOND_Z,
    STRETCH,
    SUM_P,
    TX,
    TY,
    TZ,
    P,
    Q,
    R,
    U,
    V,
    W,
    X,
    Y,
    Z,
)  # fmt: skip

OUTLET = 0.0  # m: level of the outlet, at which a sphere is counted
UPRIGHT = 1e-12  # square of the sine below which a history counts as along the normal: the rest is rounding


def three(lane: int) -> Callable:
    """Function that gives the three numbers of contact k that stand in lanes after each other.

    The places are constants: with a lane as argument the compiler fetches eight contacts one by one.
    """
    first, second, third = lane * STRETCH, (lane + 1) * STRETCH, (lane + 2) * STRETCH

    @piece("space", lane)
    def numbers(lanes, k):
        return lanes[0, first + k], lanes[0, second + k], lanes[0, third + k]

    return numbers


away_of, velocity_of, summed_of, apart_of, held_of, turned_of = map(three, (NX, DU, SUM_P, APART_P, OLD, OLD + 3))
BETWEEN = DISTANCE * STRETCH
APART = 136  # how far lanes stand apart in which a block is moved: no power of two, as these would share cache sets
TWISTED, TOUCHED, NEW_TWISTED, NEW_TOUCHED = ((lane + n) * STRETCH for lane in (OLD, NEW) for n in (6, 7))


@register_jitable(forceinline=True)
def dot(a, b):
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@register_jitable(forceinline=True)
def cross(a, b):
    """Vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@register_jitable(forceinline=True)
def across(vector, normal):
    """Component of a vector in the plane across a unit normal."""
    along = dot(vector, normal)
    return vector[0] - along * normal[0], vector[1] - along * normal[1], vector[2] - along * normal[2]


@register_jitable(forceinline=True)
def facing(lanes, k):
    """Normal (unit vector from the second body to the first) and distance (m) of the centres."""
    return away_of(lanes, k), lanes[0, BETWEEN + k]


def reduced(flat: bool):
    """Function that gives a contact's reduced radius (m): at a wall that of both mean curvatures."""

    @piece("space", flat)
    def radius(lanes, k, a, b):
        return a / (1.0 - a * lanes[0, CURVED * STRETCH + k]) if flat else a * b / (a + b)

    return radius


def rates(unequal: bool):
    """Function that gives a contact's closing speed, sliding velocity (m/s) of surfaces, and difference of spins (1/s).

    The surfaces meet half an overlap below each.
    """

    @piece("space", unequal)
    def speeds(lanes, k, normal, a, b, depth, flat):
        d, summed, apart = velocity_of(lanes, k), summed_of(lanes, k), apart_of(lanes, k)
        closing = -dot(d, normal)
        if flat:
            spin = a * summed[0], a * summed[1], a * summed[2]
        elif unequal:
            half, rest = 0.5 * (a + b - depth), 0.5 * (a - b)
            spin = (
                half * summed[0] + rest * apart[0],
                half * summed[1] + rest * apart[1],
                half * summed[2] + rest * apart[2],
            )
        else:
            arm = a - 0.5 * depth
            spin = arm * summed[0], arm * summed[1], arm * summed[2]
        turning = cross(spin, normal)
        sliding = (
            d[0] + closing * normal[0] - turning[0],
            d[1] + closing * normal[1] - turning[1],
            d[2] + closing * normal[2] - turning[2],
        )
        return closing, sliding, across(apart, normal)

    return speeds


@register_jitable(forceinline=True)
def carry(old, normal):
    """A history turned into the plane across the normal, as long as before; of one along the normal nothing is left."""
    new = across(old, normal)
    before, after = dot(old, old), dot(new, new)
    stands = after > UPRIGHT * before
    factor = sqrt((before if stands else 0.0) / (after if stands else 1.0))
    return factor * new[0], factor * new[1], factor * new[2]


@register_jitable(forceinline=True)
def twisting(lanes, k, normal):
    """Difference of spins about the normal (1/s)."""
    return dot(apart_of(lanes, k), normal)


@register_jitable(forceinline=True)
def about(moment, twist, normal):
    """A moment (N m) with another about the normal."""
    return moment[0] + twist * normal[0], moment[1] + twist * normal[1], moment[2] + twist * normal[2]


@register_jitable(forceinline=True)
def whole(push, drag, normal):
    """Force (N) of a contact on its first body."""
    return push * normal[0] + drag[0], push * normal[1] + drag[1], push * normal[2] + drag[2]


def put(drags: bool, brakes: bool, apart: bool):
    """Function that writes a contact's force (N) and its moments (N m) on both bodies into lanes.

    Unless apart, both moments are the same and stand there once.
    """

    @piece("space", drags, brakes, apart)
    def force(out, k, normal, push, drag, moment, a, b, depth, flat):
        fx, fy, fz = push * normal[0], push * normal[1], push * normal[2]
        own = others = 0.0, 0.0, 0.0
        if drags:
            fx, fy, fz = fx + drag[0], fy + drag[1], fz + drag[2]
            twist, shrink = cross(drag, normal), 0.0 if flat else 0.5 * depth
            first, second = a - shrink, b - shrink
            own = first * twist[0], first * twist[1], first * twist[2]
            others = second * twist[0], second * twist[1], second * twist[2]
        if brakes:
            own = own[0] + moment[0], own[1] + moment[1], own[2] + moment[2]
            others = others[0] - moment[0], others[1] - moment[1], others[2] - moment[2]
        out[0, FORCE_X * STRETCH + k], out[0, FORCE_Y * STRETCH + k], out[0, FORCE_Z * STRETCH + k] = fx, fy, fz
        out[0, FIRST_X * STRETCH + k], out[0, FIRST_Y * STRETCH + k], out[0, FIRST_Z * STRETCH + k] = own
        if apart:
            out[0, SECOND_X * STRETCH + k], out[0, SECOND_Y * STRETCH + k], out[0, SECOND_Z * STRETCH + k] = others

    return force


@register_jitable(forceinline=True)
def where(touching, value):
    """A vector where bodies touch, nothing where they do not."""
    return value[0] if touching else 0.0, value[1] if touching else 0.0, value[2] if touching else 0.0


def move(advance: Callable, holds: bool, turns: bool, unequal: bool, key: str):
    """Function that moves a block of spheres a step, clears their forces, and writes the square of each one's way (m2)."""

    @piece("space", key, turns, unequal)
    def moved(bodies, begin, end, pull, kick, dt, scratch):
        lanes, motion, held = scratch.lanes.reshape(-1), scratch.motion, bodies.held[begin:]
        im, ii = bodies.inverse_mass[begin if unequal else 0 :], bodies.inverse_inertia[begin if unequal else 0 :]
        hu = hv = hw = hp = hq = hr = 0.0
        to_lanes(bodies.rows, begin, end, lanes, APART)
        for k in range(end - begin):
            n = k if unequal else 0
            if holds:
                hu, hv, hw, hp, hq, hr = held[k, 0], held[k, 1], held[k, 2], held[k, 3], held[k, 4], held[k, 5]
            u, hu, dx = advance(lanes[U * APART + k], hu, lanes[FX * APART + k] * im[n] + pull[0], kick, dt)
            v, hv, dy = advance(lanes[V * APART + k], hv, lanes[FY * APART + k] * im[n] + pull[1], kick, dt)
            w, hw, dz = advance(lanes[W * APART + k], hw, lanes[FZ * APART + k] * im[n] + pull[2], kick, dt)
            lanes[X * APART + k] += dx
            lanes[Y * APART + k] += dy
            z = lanes[Z * APART + k] + dz
            lanes[Z * APART + k] = z
            lanes[U * APART + k], lanes[V * APART + k], lanes[W * APART + k] = u, v, w
            if turns:
                p, hp, _ = advance(lanes[P * APART + k], hp, lanes[TX * APART + k] * ii[n], kick, dt)
                q, hq, _ = advance(lanes[Q * APART + k], hq, lanes[TY * APART + k] * ii[n], kick, dt)
                r, hr, _ = advance(lanes[R * APART + k], hr, lanes[TZ * APART + k] * ii[n], kick, dt)
                lanes[P * APART + k], lanes[Q * APART + k], lanes[R * APART + k] = p, q, r
            if holds:
                held[k, 0], held[k, 1], held[k, 2], held[k, 3], held[k, 4], held[k, 5] = hu, hv, hw, hp, hq, hr
            lanes[PASSED * APART + k] += 1.0 if z < OUTLET else 0.0
            motion[k] = dx * dx + dy * dy + dz * dz
        to_rows_of_spheres(lanes, APART, bodies.rows, begin, end)

    return moved


@register_jitable
def pushed(gravity, quake, step):
    """Acceleration (m/s2) of spheres in a box that is accelerated."""
    return gravity[0] - quake[step, 0], gravity[1] - quake[step, 1], gravity[2] - quake[step, 2]
